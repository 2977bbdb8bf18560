"""The open points of takes, which block their approval where a project wants them closed."""

from collections import defaultdict
from collections.abc import Mapping, Sequence
from typing import Protocol
from uuid import UUID

from sqlalchemy.orm import Session

from app.core.errors import FieldProblem
from app.reviews.checklists import queries
from app.reviews.checklists.schemas import BlockedTake
from app.reviews.errors import ApprovalBlocked
from app.reviews.rules import ApprovalBlockers, what_is_open
from app.reviews.schemas import CarriedNote
from app.reviews.verdicts.carried_notes import notes_by_cue
from app.sound_lists.models import Cue

HOW_TO_CLOSE = "resolve the comments, mark the notes as done and check the items in Review, then approve again"


class OfCue(Protocol):
    """A version of a cue: a take, or what is shown of one."""

    @property
    def id(self) -> UUID:
        """The take's."""

    @property
    def variation(self) -> int:
        """Of its cue."""

    @property
    def number(self) -> int | None:
        """Of the version."""


def blocked_takes(session: Session, takes: Mapping[Cue, Sequence[OfCue]]) -> dict[UUID, list[BlockedTake]]:
    """Return the takes of each cue that cannot be approved yet, in as many statements for one cue as for many."""
    set_to = queries.blockers_in(session, {cue.project_id for cue in takes})
    by_cue = {cue: set_to.get(cue.project_id, ApprovalBlockers.NONE) for cue in takes}
    with_notes = [cue for cue, blockers in by_cue.items() if blockers.are_notes]
    with_items = [cue for cue, blockers in by_cue.items() if blockers.are_items]
    notes = _open_notes(session, {cue: takes[cue] for cue in with_notes}) if with_notes else {}
    items = _open_items(session, {cue: takes[cue] for cue in with_items}) if with_items else {}
    blocked: defaultdict[UUID, list[BlockedTake]] = defaultdict(list)
    for cue, of_cue in takes.items():
        for take in of_cue:
            comments, earlier = notes.get(take.id, (0, 0))
            if why := what_is_open(comments, earlier, items.get(take.id, [])):
                blocked[cue.id].append(BlockedTake(take_id=take.id, why=why))
    return blocked


def ensure_nothing_open(session: Session, cue: Cue, takes: Sequence[OfCue]) -> None:
    """Raise ApprovalBlocked, with every take that is, where something is open that the project wants closed."""
    blocked = blocked_takes(session, {cue: takes}).get(cue.id, [])
    if not blocked:
        return
    by_id = {take.id: take for take in takes}
    errors: list[FieldProblem] = []
    for block in blocked:
        take = by_id[block.take_id]
        of_set = f" of variation {take.variation}" if cue.variations > 1 else ""
        errors.append({"where": str(take.id), "message": f"version {take.number}{of_set}: {block.why}"})
    message = "; ".join(error["message"] for error in errors)
    raise ApprovalBlocked(f"nothing was approved of {cue.name}. {message}", errors=errors, fix=HOW_TO_CLOSE)


def _open_notes(session: Session, takes: Mapping[Cue, Sequence[OfCue]]) -> dict[UUID, tuple[int, int]]:
    """Count by take the comments that are not resolved, and the notes on earlier versions that are not done."""
    comments = queries.open_comments(session, [take.id for of_cue in takes.values() for take in of_cue])
    notes = notes_by_cue(session, [cue.id for cue in takes])
    return {
        take.id: (comments.get(take.id, 0), sum(_is_open(note, take) for note in notes.get(cue.id, [])))
        for cue, of_cue in takes.items()
        for take in of_cue
    }


def _is_open(note: CarriedNote, take: OfCue) -> bool:
    is_earlier = note.variation == take.variation and note.number < (take.number or 0)
    return is_earlier and (note.answer is None or not note.answer.is_done)


def _open_items(session: Session, takes: Mapping[Cue, Sequence[OfCue]]) -> dict[UUID, list[str]]:
    """Return by take the items of its checklist that are not checked."""
    items = queries.items_in(session, {cue.project_id for cue in takes})
    if not items:
        return {}
    checks = queries.checks_of(session, [take.id for of_cue in takes.values() for take in of_cue])
    checked = {(check.take_id, check.item_id) for check in checks}
    return {
        take.id: [
            item.text
            for item in items
            if (item.project_id, item.category) in ((cue.project_id, ""), (cue.project_id, cue.category))
            and (take.id, item.id) not in checked
        ]
        for cue, of_cue in takes.items()
        for take in of_cue
    }
