"""Advice on takes."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.deliveries.service import take_for
from app.kit import clock
from app.reviews import queries
from app.reviews.errors import CommentNotFound
from app.reviews.models import Comment
from app.reviews.review_room import comment_read
from app.reviews.rules import ensure_range
from app.reviews.schemas import CommentRead


def take_comments(session: Session, actor: Actor, take_id: UUID) -> list[CommentRead]:
    """Return the advice on a take."""
    take, _ = take_for(session, actor, take_id)
    return [comment_read(one) for one in queries.comments_on(session, Comment.take_id == take.id)]


def add_comment(
    session: Session, actor: Actor, take_id: UUID, *, text: str, start_s: float | None, end_s: float | None
) -> CommentRead:
    """Write advice on a take, at a time in the sound or on the whole of it."""
    take, access = take_for(session, actor, take_id)
    ensure_range(start_s, end_s, queries.duration_of(session, take))
    comment = Comment(
        studio_id=take.studio_id,
        project_id=take.project_id,
        take_id=take.id,
        text=text,
        start_s=start_s,
        end_s=end_s,
        written_by=actor.person,
        decides=access.is_approver,
    )
    session.add(comment)
    session.flush()
    session.refresh(comment, ["author"])
    return comment_read(comment)


def resolve_comment(session: Session, actor: Actor, comment_id: UUID) -> CommentRead:
    """Mark advice as seen to; anyone who sees the take may."""
    comment = queries.comment_by_id(session, comment_id)
    if comment is None:
        raise CommentNotFound(f"no comment {comment_id}")
    take_for(session, actor, comment.take_id)
    if comment.resolved_at is None:
        comment.resolved_at, comment.resolved_by = clock.now(), actor.person
    return comment_read(comment)
