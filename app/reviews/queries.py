"""Verdicts, change requests and comments on takes, read from the database; callers have checked access."""

from collections import defaultdict
from collections.abc import Collection, Sequence
from uuid import UUID

from sqlalchemy import ColumnElement, Select, and_, exists, func, or_, select
from sqlalchemy.orm import Session, aliased, joinedload, selectinload
from sqlalchemy.sql.base import ExecutableOption

from app.accounts.models import Membership, Person
from app.conformance.models import CheckRun, Waiver
from app.core.in_array import in_array
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.projects.models import Engagement, Project
from app.projects.visibility import engaged_with_nda_accepted
from app.renders.models import Picture
from app.reviews.models import (
    Acknowledgement,
    ChangeRequest,
    Comment,
    Feedback,
    NoteAnswer,
    Round,
    Verdict,
)
from app.reviews.rules import VerdictKind, missing_variations
from app.sound_lists.models import Cue, Question
from app.sound_lists.rules import CueState


def answers_nothing() -> ColumnElement[bool]:
    """Admit comments that are no replies; as one value, since by the index on replies SQLite reads most comments."""
    return func.coalesce(Comment.reply_to_id, Comment.change_request_id).is_(None)


def questions_on(session: Session, cue_ids: Collection[UUID]) -> Sequence[Question]:
    """Return the questions on cues, answered or not."""
    return session.scalars(select(Question).where(in_array(Question.cue_id, cue_ids)).order_by(Question.id)).all()


def round_counts(session: Session, cue_ids: Collection[UUID]) -> dict[UUID, int]:
    """Return the number of rounds that count for cues."""
    query = select(Round.cue_id, func.count(Round.number)).where(in_array(Round.cue_id, cue_ids)).group_by(Round.cue_id)
    return dict(session.execute(query).all())


def unanswered_rounds(session: Session, cue_ids: Collection[UUID]) -> dict[UUID, int]:
    """Return the last counted round of cues for which nothing was delivered since it was sent, by cue."""
    last = (
        select(Round.cue_id, func.max(Round.number).label("number"))
        .where(in_array(Round.cue_id, cue_ids))
        .group_by(Round.cue_id)
        .subquery()
    )
    query = (
        select(Round.cue_id, Round.number)
        .join(last, (last.c.cue_id == Round.cue_id) & (last.c.number == Round.number))
        .join(Feedback, Feedback.id == Round.feedback_id)
        .where(~exists().where(Take.cue_id == Round.cue_id, Take.received_at > Feedback.created_at))
    )
    return {cue_id: number for cue_id, number in session.execute(query).all() if number is not None}


def rounds_of(session: Session, cue_id: UUID) -> Sequence[Round]:
    """Return every sending that named a cue, counted or not, in order."""
    return session.scalars(select(Round).where(Round.cue_id == cue_id).order_by(Round.id)).all()


def approved_variations(session: Session, cue_ids: Collection[UUID]) -> dict[UUID, list[int]]:
    """Return the variations of cues that have their approved take."""
    variations: dict[UUID, list[int]] = defaultdict(list)
    query = (
        select(Take.cue_id, Take.variation)
        .where(in_array(Take.cue_id, cue_ids), Take.state == TakeState.APPROVED)
        .order_by(Take.variation)
    )
    for cue_id, variation in session.execute(query):
        if cue_id is not None:
            variations[cue_id].append(variation)
    return variations


def approved_takes(session: Session, cue_id: UUID) -> Sequence[Take]:
    """Return the approved takes of a cue, one of each variation that has one."""
    return session.scalars(
        select(Take).where(Take.cue_id == cue_id, Take.state == TakeState.APPROVED).order_by(Take.variation)
    ).all()


def variation_states(
    session: Session, cue_ids: Collection[UUID], designer_id: UUID
) -> dict[UUID, dict[int, set[TakeState]]]:
    """Return the states of a designer's takes of cues, by cue and variation; set aside ones count as work too."""
    states: dict[UUID, dict[int, set[TakeState]]] = defaultdict(lambda: defaultdict(set))
    query = select(Take.cue_id, Take.variation, Take.state).where(
        in_array(Take.cue_id, cue_ids), Take.designer_id == designer_id
    )
    for cue_id, variation, state in session.execute(query):
        if cue_id is not None:
            states[cue_id][variation].add(state)
    return states


def accepted_takes(session: Session, project_id: UUID) -> list[tuple[Cue, int, Take]]:
    """Return the picked take of every variation of every accepted cue, in list order, each take with its cue."""
    takes = session.scalars(
        select(Take)
        .join(Cue, Cue.id == Take.cue_id)
        .where(Take.project_id == project_id, Take.state == TakeState.APPROVED, Cue.state != CueState.CUT)
        .options(joinedload(Take.cue), joinedload(Take.designer))
        .order_by(Cue.position, Cue.number, Take.variation)
    )
    by_cue: dict[Cue, dict[int, Take]] = defaultdict(dict)
    for take in takes:
        if take.cue is not None:
            by_cue[take.cue][take.variation] = take
    return [
        (cue, variation, takes_of_it[variation])
        for cue, takes_of_it in by_cue.items()
        if not missing_variations(cue.variations, takes_of_it)
        for variation in range(1, cue.variations + 1)
    ]


def lock_cue(session: Session, cue_id: UUID) -> None:
    """Let verdicts on one cue come one after the other."""
    session.execute(select(Cue.id).where(Cue.id == cue_id).with_for_update(key_share=True))


def open_takes(session: Session, cue_id: UUID, *, variation: int | None = None) -> Sequence[Take]:
    """Return a cue's takes that wait or are approved, newest first."""
    query = (
        select(Take)
        .where(Take.cue_id == cue_id, Take.state.in_((TakeState.CONFORMING, TakeState.APPROVED)))
        .order_by(Take.variation, Take.number.desc())
        .execution_options(populate_existing=True)
    )
    if variation is not None:
        query = query.where(Take.variation == variation)
    return session.scalars(query).all()


def takes_by_id(session: Session, take_ids: Collection[UUID]) -> dict[UUID, Take]:
    """Return takes by id, refreshed."""
    query = select(Take).where(in_array(Take.id, take_ids)).execution_options(populate_existing=True)
    return {take.id: take for take in session.scalars(query)}


def effective_verdicts(session: Session, take_ids: Collection[UUID]) -> Sequence[Verdict]:
    """Return the verdicts on takes that were not taken back, oldest first."""
    back = aliased(Verdict)
    return session.scalars(
        select(Verdict)
        .where(
            in_array(Verdict.take_id, take_ids),
            Verdict.kind != VerdictKind.WITHDRAW,
            ~exists().where(back.withdraws_id == Verdict.id),
        )
        .order_by(Verdict.id)
    ).all()


def action_verdicts(session: Session, action_id: UUID) -> Sequence[Verdict]:
    """Return everything that one click decided, in its order."""
    return session.scalars(
        select(Verdict).where(Verdict.action_id == action_id, Verdict.kind != VerdictKind.WITHDRAW).order_by(Verdict.id)
    ).all()


def approvals_of(session: Session, cue_ids: Collection[UUID]) -> Sequence[tuple[Take, Verdict]]:
    """Return the approved takes of cues with the verdict of a person that approved each, and who gave it."""
    back = aliased(Verdict)
    return session.execute(
        select(Take, Verdict)
        .join(Verdict, Verdict.take_id == Take.id)
        .where(
            in_array(Take.cue_id, cue_ids),
            Take.state == TakeState.APPROVED,
            Verdict.kind == VerdictKind.APPROVE,
            Verdict.given_by.is_not(None),
            ~exists().where(back.withdraws_id == Verdict.id),
        )
        .options(joinedload(Verdict.author))
        .order_by(Verdict.id)
    ).all()


def verdicts_on(session: Session, *where: ColumnElement[bool]) -> Sequence[Verdict]:
    """Return verdicts with who gave them and for whom, oldest first, those taken back included."""
    with_people = (joinedload(Verdict.author), joinedload(Verdict.represented))
    return session.scalars(select(Verdict).where(*where).options(*with_people).order_by(Verdict.id)).all()


def _change_requests() -> Select[ChangeRequest]:
    return select(ChangeRequest).options(
        joinedload(ChangeRequest.cue),
        joinedload(ChangeRequest.take),
        joinedload(ChangeRequest.author),
        joinedload(ChangeRequest.sending),
    )


def open_drafts(session: Session, take_ids: Collection[UUID]) -> Sequence[ChangeRequest]:
    """Return the drafts on takes."""
    return session.scalars(
        _change_requests().where(in_array(ChangeRequest.take_id, take_ids), ChangeRequest.feedback_id.is_(None))
    ).all()


def draft_of(session: Session, take_id: UUID) -> ChangeRequest | None:
    """Return the draft on a take."""
    return session.scalar(
        _change_requests().where(ChangeRequest.take_id == take_id, ChangeRequest.feedback_id.is_(None))
    )


def drafts_of_project(session: Session, project_id: UUID) -> Sequence[ChangeRequest]:
    """Return every draft of a project, in list order."""
    return session.scalars(
        _change_requests()
        .join(Cue, Cue.id == ChangeRequest.cue_id)
        .where(ChangeRequest.project_id == project_id, ChangeRequest.feedback_id.is_(None))
        .order_by(Cue.number, ChangeRequest.id)
        .execution_options(populate_existing=True)
    ).all()


def change_request_by_id(session: Session, change_request_id: UUID) -> ChangeRequest | None:
    """Return a change request with its take."""
    return session.scalar(_change_requests().where(ChangeRequest.id == change_request_id))


def change_requests_of(
    session: Session, *where: ColumnElement[bool], after: UUID | None = None, limit: int | None = None
) -> Sequence[ChangeRequest]:
    """Return change requests with their takes, newest first."""
    query = _change_requests().where(*where).order_by(ChangeRequest.id.desc())
    if after is not None:
        query = query.where(ChangeRequest.id < after)
    return session.scalars(query if limit is None else query.limit(limit)).all()


def _with_people() -> tuple[ExecutableOption, ...]:
    seen_by = selectinload(Comment.acknowledgements).joinedload(Acknowledgement.person)
    return joinedload(Comment.author), seen_by


def comments_on(session: Session, *where: ColumnElement[bool]) -> Sequence[Comment]:
    """Return comments with their authors and who has seen them, oldest first."""
    return session.scalars(select(Comment).where(*where).options(*_with_people()).order_by(Comment.id)).all()


def comment_by_id(session: Session, comment_id: UUID) -> Comment | None:
    """Return a comment with its author and who has seen it, as the database has it now."""
    fresh = select(Comment).where(Comment.id == comment_id).options(*_with_people())
    return session.scalar(fresh.execution_options(populate_existing=True))


def people_who_see(session: Session, take: Take) -> Sequence[Person]:
    """Return the people who may see a take, by name: the members of its studio, and its designer while engaged."""
    member = exists().where(Membership.person_id == Person.id, Membership.studio_id == take.studio_id)
    engaged = exists().where(
        Engagement.project_id == take.project_id,
        Engagement.designer_id == Person.id,
        Project.id == take.project_id,
        engaged_with_nda_accepted(),
    )
    seen = select(Person).where(or_(member, and_(Person.id == take.designer_id, engaged)))
    return session.scalars(seen.order_by(Person.name, Person.id)).all()


def notes_to_carry(
    session: Session, cue_ids: Collection[UUID]
) -> tuple[Sequence[ChangeRequest], Sequence[tuple[Comment, Take]]]:
    """Return the requests and comments of versions for which a change was requested; no reply, nor by its designer."""
    asked_of = (in_array(Take.cue_id, cue_ids), Take.state == TakeState.CHANGE_REQUESTED)
    asked = change_requests_of(session, ChangeRequest.take.has(and_(*asked_of)), ChangeRequest.feedback_id.is_not(None))
    comments = session.execute(
        select(Comment, Take)
        .join(Take, Take.id == Comment.take_id)
        .where(*asked_of, answers_nothing())
        .where(Comment.written_by != Take.designer_id)  # who made the version asks nothing of it
        .options(joinedload(Comment.author))
        .order_by(Comment.id)
    )
    return asked, comments.all()


def newest_answers(session: Session, note_ids: Collection[UUID]) -> dict[UUID, NoteAnswer]:
    """Return the last answers to notes that were carried over, by note."""
    answers = session.scalars(
        select(NoteAnswer)
        .where(or_(in_array(NoteAnswer.comment_id, note_ids), in_array(NoteAnswer.change_request_id, note_ids)))
        .options(joinedload(NoteAnswer.take), joinedload(NoteAnswer.author))
        .order_by(NoteAnswer.id)
    )
    return {note_id: answer for answer in answers if (note_id := answer.comment_id or answer.change_request_id)}


def check_runs_of(session: Session, take_id: UUID) -> Sequence[CheckRun]:
    """Return every check of a take, oldest first."""
    return session.scalars(select(CheckRun).where(CheckRun.take_id == take_id).order_by(CheckRun.id)).all()


def waivers_of(session: Session, take_id: UUID) -> Sequence[tuple[Waiver, Person]]:
    """Return the waivers of a take, with who gave them."""
    query = (
        select(Waiver, Person).join(Person, Person.id == Waiver.waived_by).where(Waiver.take_id == take_id)
    ).order_by(Waiver.id)
    return session.execute(query).all()


def duration_of(session: Session, take: Take) -> float | None:
    """Return the length of a take's master; None while it is not drawn yet."""
    return session.scalar(
        select(Picture.duration_s).where(
            Picture.studio_id == take.studio_id, Picture.sound_sha256 == take.master_sha256
        )
    )
