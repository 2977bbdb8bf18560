"""Advice on takes, and replies to it and to change requests."""

from collections.abc import Sequence
from typing import NamedTuple
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.accounts.schemas import PersonBrief
from app.core import clock
from app.core.db import insert_if_absent, new_id
from app.core.events import publish, send
from app.deliveries.errors import TakeNotFound
from app.deliveries.models import Take
from app.deliveries.service import take_for
from app.projects.approval.service import approval_rights
from app.reviews import queries
from app.reviews.errors import AcknowledgementNotDue, ChangeRequestNotFound, CommentNotFound
from app.reviews.models import Acknowledgement, Comment
from app.reviews.queue.service import comment_read
from app.reviews.rounds.mentions import mentions_in, people_to_mention, publish_mentions
from app.reviews.rules import ensure_range
from app.reviews.schemas import CommentRead
from app.reviews.signals import CommentWritten


class Answered(NamedTuple):
    """The note that a comment replies to: another comment, or a change request; neither for what stands alone."""

    comment_id: UUID | None = None
    change_request_id: UUID | None = None


ALONE = Answered()


def take_comments(session: Session, actor: Actor, take_id: UUID) -> list[CommentRead]:
    """Return the advice on a take."""
    take, _ = take_for(session, actor, take_id)
    return [comment_read(comment) for comment in queries.comments_on(session, Comment.take_id == take.id)]


def add_comment(
    session: Session,
    actor: Actor,
    take_id: UUID,
    *,
    text: str,
    start_s: float | None,
    end_s: float | None,
    answers: Answered = ALONE,
    mentions: Sequence[UUID] = (),
) -> CommentRead:
    """Write advice on a take, at a time in the sound or on the whole of it, or a reply to what was said of it.

    A reply to a reply answers what that one answers, so that a conversation stands below one note.
    """
    take, access = take_for(session, actor, take_id)
    ensure_range(start_s, end_s, queries.duration_of(session, take))
    answers, asker_id = _note_answered(session, take.id, answers)
    rights = approval_rights(session, access.project)
    comment = Comment(
        studio_id=take.studio_id,
        project_id=take.project_id,
        take_id=take.id,
        reply_to_id=answers.comment_id,
        change_request_id=answers.change_request_id,
        text=text,
        mentions=mentions_in(session, take, text, mentions),
        start_s=start_s,
        end_s=end_s,
        written_by=actor.person,
        decides=access.is_team and actor.person in rights.people_for(take.cue.category if take.cue else ""),
    )
    session.add(comment)
    session.flush()
    session.refresh(comment, ["author", "acknowledgements"])
    send(session, CommentWritten(comment, take))
    publish_mentions(session, comment)
    if asker_id is not None and asker_id != actor.person and str(asker_id) not in comment.mentions:
        publish(session, "note.answered", studio_id=take.studio_id, comment_id=comment.id, person_id=asker_id)
    return comment_read(comment)


def add_guest_comment(
    session: Session, take: Take, guest_name: str, *, text: str, start_s: float | None, end_s: float | None
) -> Comment:
    """Write the advice of a guest without an account on a take; the caller has checked that their link allows it."""
    ensure_range(start_s, end_s, queries.duration_of(session, take))
    comment = Comment(
        studio_id=take.studio_id,
        project_id=take.project_id,
        take_id=take.id,
        text=text,
        start_s=start_s,
        end_s=end_s,
        guest_name=guest_name,
        decides=False,
    )
    session.add(comment)
    session.flush()
    send(session, CommentWritten(comment, take))
    return comment


def _note_answered(session: Session, take_id: UUID, answers: Answered) -> tuple[Answered, UUID | None]:
    """Return the first note of the conversation, and who wrote what is answered."""
    if answers.comment_id is not None:
        answered = queries.comment_by_id(session, answers.comment_id)
        if answered is None or answered.take_id != take_id:
            raise CommentNotFound(f"no comment {answers.comment_id} on this version")
        if answered.reply_to_id or answered.change_request_id:
            return Answered(answered.reply_to_id, answered.change_request_id), answered.written_by
        return Answered(answered.id), answered.written_by
    if answers.change_request_id is not None:
        request = queries.change_request_by_id(session, answers.change_request_id)
        if request is None or request.take_id != take_id or request.feedback_id is None:
            raise ChangeRequestNotFound(f"no change request {answers.change_request_id} was sent for this version")
        return Answered(change_request_id=request.id), request.written_by
    return answers, None


def people_for(session: Session, actor: Actor, take_id: UUID) -> list[PersonBrief]:
    """Return the people the caller can mention on a take."""
    take, _ = take_for(session, actor, take_id)
    people = people_to_mention(session, take)
    return [PersonBrief.model_validate(person) for person in people if person.id != actor.person]


def resolve_comment(session: Session, actor: Actor, comment_id: UUID) -> CommentRead:
    """Mark advice as seen to; anyone who sees the take may."""
    comment, _ = _comment_for(session, actor, comment_id)
    if comment.resolved_at is None:
        comment.resolved_at, comment.resolved_by = clock.now(), actor.person
    return comment_read(comment)


def reopen_comment(session: Session, actor: Actor, comment_id: UUID) -> CommentRead:
    """Open advice again that was marked as seen to; anyone who sees the take may."""
    comment, _ = _comment_for(session, actor, comment_id)
    comment.resolved_at = comment.resolved_by = None
    return comment_read(comment)


def acknowledge_comment(session: Session, actor: Actor, comment_id: UUID) -> CommentRead:
    """Record that the caller has seen a comment; raise AcknowledgementNotDue unless it is meant for them."""
    comment, take = _comment_for(session, actor, comment_id)
    is_own_sounds = actor.person == take.designer_id and actor.person != comment.written_by
    if not is_own_sounds and str(actor.person) not in comment.mentions:
        raise AcknowledgementNotDue(
            "this comment is not for you to acknowledge", fix="reply to it, or resolve it once it is done"
        )
    row = {
        "id": new_id(),
        "studio_id": comment.studio_id,
        "project_id": comment.project_id,
        "comment_id": comment.id,
        "person_id": actor.person,
        "created_at": clock.now(),
    }
    insert_if_absent(session, Acknowledgement, row, unique=("comment_id", "person_id"))
    comment, _ = _comment_for(session, actor, comment_id)
    return comment_read(comment)


def _comment_for(session: Session, actor: Actor, comment_id: UUID) -> tuple[Comment, Take]:
    comment = queries.comment_by_id(session, comment_id)
    if comment is None:
        raise CommentNotFound(f"no comment {comment_id}")
    try:
        take, _ = take_for(session, actor, comment.take_id)
    except TakeNotFound:
        raise CommentNotFound(f"no comment {comment_id}") from None
    return comment, take
