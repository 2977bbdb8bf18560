"""Notes on earlier versions, carried over to the next one until they are said to be done."""

from collections import defaultdict
from collections.abc import Collection, Iterable
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.accounts.schemas import PersonBrief
from app.core import clock
from app.deliveries.models import Take
from app.deliveries.service import take_for
from app.reviews import queries
from app.reviews.errors import NoteNotFound
from app.reviews.models import ChangeRequest, Comment, NoteAnswer, Verdict
from app.reviews.schemas import CarriedNote, NoteAnswerRead


def carried_notes(session: Session, cue_id: UUID) -> list[CarriedNote]:
    """Return the notes of a cue that were or are carried over, in the order in which they were written."""
    return notes_by_cue(session, [cue_id]).get(cue_id, [])


def notes_by_cue(session: Session, cue_ids: Collection[UUID]) -> dict[UUID | None, list[CarriedNote]]:
    """Return the notes of cues that were or are carried over, by cue, in the order in which they were written."""
    asked, commented = queries.notes_to_carry(session, cue_ids)
    answers = queries.newest_answers(
        session, [request.id for request in asked] + [comment.id for comment, _ in commented]
    )
    written: list[tuple[ChangeRequest | Comment, Take]] = [
        *((request, request.take) for request in asked),
        *((comment, take) for comment, take in commented if comment.resolved_at is None or comment.id in answers),
    ]
    approved = queries.approvals_of(session, cue_ids) if written else []
    approvals = {(take.cue_id, take.variation): (take, verdict) for take, verdict in approved}
    by_cue: defaultdict[UUID | None, list[CarriedNote]] = defaultdict(list)
    for note, take in sorted(written, key=lambda note: note[0].created_at):
        approval = approvals.get((take.cue_id, take.variation), (None, None))
        by_cue[take.cue_id].append(_with_approval(_note(note, take, answers.get(note.id)), *approval))
    return by_cue


def _with_approval(note: CarriedNote, approved: Take | None, verdict: Verdict | None) -> CarriedNote:
    """Return a note as done in the version that was approved, unless it was answered of that version, or is later."""
    if approved is None or verdict is None or verdict.author is None:
        return note
    answered_in = note.answer.number if note.answer else 0
    if (note.answer and note.answer.is_done) or max(note.number, answered_in) >= (approved.number or 0):
        return note
    by_approval = NoteAnswerRead(
        is_done=True,
        number=approved.number or 0,
        given_by=PersonBrief.model_validate(verdict.author),
        created_at=verdict.created_at,
    )
    return note.model_copy(update={"answer": by_approval})


def _note(note: ChangeRequest | Comment, take: Take, answer: NoteAnswer | None) -> CarriedNote:
    is_change = isinstance(note, ChangeRequest)
    return CarriedNote(
        id=note.id,
        kind="change" if is_change else "comment",
        take_id=take.id,
        variation=take.variation,
        number=take.number or 0,
        text=note.text,
        start_s=note.start_s,
        end_s=note.end_s,
        author=PersonBrief.model_validate(note.author),
        decides=True if isinstance(note, ChangeRequest) else note.decides,
        created_at=note.created_at,
        answer=None if answer is None else _answer(answer),
    )


def _answer(answer: NoteAnswer) -> NoteAnswerRead:
    return NoteAnswerRead(
        is_done=answer.is_done,
        number=answer.take.number or 0,
        given_by=PersonBrief.model_validate(answer.author),
        created_at=answer.created_at,
    )


def answer_note(session: Session, actor: Actor, take_id: UUID, note_id: UUID, *, is_done: bool) -> CarriedNote:
    """Record whether a version does what a note on an earlier one asked, by anyone of the team."""
    take, access = take_for(session, actor, take_id)
    access.ensure_team()
    note = _carried_to(take, carried_notes(session, take.cue_id) if take.cue_id else [], note_id)
    if note.answer and (note.answer.is_done, note.answer.number) == (is_done, take.number):
        return note
    is_comment = note.kind == "comment"
    answer = NoteAnswer(
        studio_id=take.studio_id,
        project_id=take.project_id,
        take_id=take.id,
        comment_id=note_id if is_comment else None,
        change_request_id=None if is_comment else note_id,
        is_done=is_done,
        given_by=actor.person,
    )
    session.add(answer)
    session.flush()
    session.refresh(answer, ["author", "take"])
    comment = queries.comment_by_id(session, note_id) if is_comment else None
    if comment is not None:  # advice that is done is seen to, on its own version too
        comment.resolved_at, comment.resolved_by = (clock.now(), actor.person) if is_done else (None, None)
    return note.model_copy(update={"answer": _answer(answer)})


def _carried_to(take: Take, notes: Collection[CarriedNote], note_id: UUID) -> CarriedNote:
    earlier: Iterable[CarriedNote] = (
        note for note in notes if note.variation == take.variation and note.number < (take.number or 0)
    )
    for note in earlier:
        if note.id == note_id:
            return note
    raise NoteNotFound(f"no note {note_id} was carried over to this version")
