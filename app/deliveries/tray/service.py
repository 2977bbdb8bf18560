"""Many takes at once: matched where their names are sure, moved, discarded, restored; each action can be undone."""

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.core import clock
from app.deliveries import queries, take_states
from app.deliveries.cue_counts.service import update_take_counts
from app.deliveries.errors import AlreadyUndone, TakeNotFound, TrayActionNotFound
from app.deliveries.models import Take, TrayAction
from app.deliveries.rules import (
    CHECKABLE,
    OpenTake,
    TakeState,
    TrayActionKind,
    ensure_kept,
    ensure_no_verdict,
    named_for,
    stem_of,
    undecided_groups,
)
from app.deliveries.schemas import TrayActionRead
from app.deliveries.service import Origin, add_take
from app.deliveries.slots import Slot, matching_for, slot_given, stems_of_slots
from app.deliveries.source_banks.service import copy_bank
from app.projects.errors import ProjectNotFound
from app.projects.service import ProjectAccess, project_access
from app.sound_lists.models import Cue

MAX_TAKES = 2_000  # in one action


@dataclass(frozen=True)
class Move:
    """The place given for a take; without a variation the one in its name, else the first empty one."""

    take_id: UUID
    cue_id: UUID
    variation: int | None
    as_alternate: bool = False


def undecided_places(session: Session, actor: Actor, project_id: UUID) -> list[list[Take]]:
    """Return the takes between which nobody chose, by their place in the list; a designer's own."""
    access = project_access(session, actor, project_id)
    competing = queries.competing_takes(session, project_id, access.only_designer_id)
    by_id = {take.id: take for take in competing}
    return [[by_id[take.id] for take in group] for group in undecided_groups(map(open_take_of, competing))]


def open_take_of(take: Take) -> OpenTake:
    """Return the facts of a matched take by which it competes with others."""
    if take.cue_id is None:
        raise AssertionError("only matched takes have a place")
    return OpenTake(
        take.id,
        take.delivery_id,
        take.cue_id,
        take.variation,
        take.alternate,
        take.number or 0,
        take.file_name,
        take.fix_of_id,
    )


def accept_sure(session: Session, actor: Actor, project_id: UUID, take_ids: Collection[UUID] | None) -> TrayAction:
    """Match every take of the tray, or those named, whose name is sure; the others stay where they are."""
    access = _who_sorts(session, actor, project_id)
    takes = queries.tray(session, project_id, access.only_designer_id, limit=MAX_TAKES)
    matching = matching_for(session, project_id, access.only_designer_id)
    wanted = None if take_ids is None else set(take_ids)
    before = []
    for take in takes:
        if wanted is not None and take.id not in wanted:
            continue
        sure = matching.sure(take)
        if sure is None or sure.variation is None:
            continue
        before.append(_place_of(take))
        cue = session.get_one(Cue, sure.cue_id)
        take_states.place_take(session, take, Slot(cue, sure.variation, sure.alternate), by=actor.person)
    return _record(session, access, TrayActionKind.MATCHED, takes, before)


def move_takes(session: Session, actor: Actor, project_id: UUID, moves: Sequence[Move]) -> TrayAction:
    """Move takes to the cues named, all or none; raise WrongState where one is decided upon."""
    access, takes = _takes_named(session, actor, project_id, [move.take_id for move in moves])
    before = []
    for take, move in zip(takes, moves, strict=True):
        slot = slot_given(session, access, move.cue_id, move.variation, take.file_name)
        is_there = (take.cue_id, take.variation) == (slot.cue.id, slot.variation)
        if is_there and not move.as_alternate:
            continue
        ensure_no_verdict(take.state)
        ensure_kept(take.discarded_at)
        before.append(_place_of(take))
        if move.as_alternate:
            slot = replace(slot, alternate=queries.next_alternate(session, slot.cue.id, slot.variation))
        if is_there:
            take.alternate = slot.alternate
            take.edition += 1
            update_take_counts(session, take.cue_id)
            session.flush()
        else:
            take_states.place_take(session, take, slot, by=actor.person)
    return _record(session, access, TrayActionKind.MOVED, takes, before)


def names_after(session: Session, actor: Actor, project_id: UUID, moves: Sequence[Move]) -> list[tuple[Take, str]]:
    """Return the name of each take after a move; nothing is changed."""
    access, takes = _takes_named(session, actor, project_id, [move.take_id for move in moves])
    slots = [
        slot_given(session, access, move.cue_id, move.variation, take.file_name)
        for take, move in zip(takes, moves, strict=True)
    ]
    stems = stems_of_slots(session, slots)
    return [
        (take, named_for(take.file_name, stem) if stem is not None else take.file_name)
        for take, stem in zip(takes, stems, strict=True)
    ]


def discard_takes(session: Session, actor: Actor, project_id: UUID, take_ids: Sequence[UUID]) -> TrayAction:
    """Take files out of the list and the tray, all or none; their masters are kept, and they can be restored."""
    access, takes = _takes_named(session, actor, project_id, take_ids)
    before = []
    for take in takes:
        ensure_no_verdict(take.state)
        if take.discarded_at is None:
            before.append(_place_of(take))
            _leave_cue(session, take, by=actor.person)
            take.discarded_at = clock.now()
    session.flush()
    return _record(session, access, TrayActionKind.DISCARDED, takes, before)


def restore_takes(session: Session, actor: Actor, project_id: UUID, take_ids: Sequence[UUID]) -> TrayAction:
    """Put discarded takes back into the tray."""
    access, takes = _takes_named(session, actor, project_id, take_ids)
    before = []
    for take in takes:
        if take.discarded_at is not None:
            before.append(_place_of(take))
            take.discarded_at = None
            take_states.start_recheck(session, take, by=actor.person)
    return _record(session, access, TrayActionKind.RESTORED, takes, before)


@dataclass(frozen=True)
class PartGiven:
    """A part of a take's master, and the variation that it becomes."""

    sha256: str
    size_bytes: int
    first_frame: int
    end_frame: int
    variation: int


def split_take(
    session: Session, access: ProjectAccess, take: Take, cue_id: UUID, parts: Sequence[PartGiven]
) -> TrayAction:
    """Make parts of a take's master versions of a cue's variations, and discard the take; its master is kept."""
    ensure_no_verdict(take.state)
    ensure_kept(take.discarded_at)
    delivery = queries.delivery_by_id(session, take.delivery_id)
    if delivery is None:
        raise LookupError(f"take {take.id} has no delivery")
    slots = [slot_given(session, access, cue_id, part.variation, "") for part in parts]
    stems = stems_of_slots(session, slots)
    takes, before = [take], [_place_of(take)]
    for part, slot, stem in zip(parts, slots, stems, strict=True):
        name = named_for(take.file_name, stem or f"{stem_of(take.file_name)}_{part.variation:02}")
        made, already_here = add_take(
            session,
            delivery,
            part.sha256,
            part.size_bytes,
            name,
            Origin(split_of_id=take.id, split_first_frame=part.first_frame, split_end_frame=part.end_frame),
            slot=slot,
            note=take.note,
            late=take.late,
            sender_id=access.actor.person,
        )
        if not already_here:
            copy_bank(session, take, made)
            takes.append(made)
            before.append({**_place_of(made), "cue_id": None, "variation": 1, "is_discarded": True})
    _leave_cue(session, take, by=access.actor.person)
    take.discarded_at = clock.now()
    session.flush()
    return _record(session, access, TrayActionKind.SPLIT, takes, before)


def undo(session: Session, actor: Actor, action_id: UUID) -> tuple[TrayAction, int, int]:
    """Put takes back where they were before an action; those changed or decided since stay.

    Return the action, how many went back, and how many stay.
    """
    action = queries.tray_action_by_id(session, action_id)
    if action is None:
        raise TrayActionNotFound(f"no action {action_id}")
    try:
        access = _who_sorts(session, actor, action.project_id)
    except ProjectNotFound:
        raise TrayActionNotFound(f"no action {action_id}") from None
    if access.only_designer_id not in (None, action.done_by):
        raise TrayActionNotFound(f"no action {action_id}")
    if action.undone_at is not None:
        raise AlreadyUndone("this was undone before")
    places = {UUID(take_before["take_id"]): take_before for take_before in action.takes}
    takes = queries.takes_by_id(session, action.project_id, list(places), access.only_designer_id)
    back = 0
    for take in takes:
        previous = places[take.id]
        if take.edition == previous["edition_after"]:
            back += _put_back(session, take, previous, by=actor.person)
    action.undone_at = clock.now()
    session.flush()
    return action, back, len(places) - back


def _put_back(session: Session, take: Take, previous: dict[str, Any], *, by: UUID) -> bool:
    if take.state not in CHECKABLE:
        return False
    cue = session.get(Cue, UUID(previous["cue_id"])) if previous["cue_id"] else None
    take.discarded_at = None
    if cue is not None:
        take_states.place_take(session, take, Slot(cue, previous["variation"], previous["alternate"]), by=by)
        return True
    _leave_cue(session, take, by=by)
    take.alternate = previous["alternate"]
    if previous["is_discarded"]:
        take.discarded_at = clock.now()
    else:
        take_states.start_recheck(session, take, by=by)
    return True


def _who_sorts(session: Session, actor: Actor, project_id: UUID) -> ProjectAccess:
    """Return the caller's access to a project whose takes they may sort: their own, or all if they act for the team."""
    access = project_access(session, actor, project_id)
    access.ensure_party()
    return access


def _takes_named(
    session: Session, actor: Actor, project_id: UUID, take_ids: Sequence[UUID]
) -> tuple[ProjectAccess, list[Take]]:
    """Return takes within the caller's reach, locked, in the order named; raise TakeNotFound unless all are."""
    access = _who_sorts(session, actor, project_id)
    takes_by_id = {
        take.id: take for take in queries.takes_by_id(session, project_id, set(take_ids), access.only_designer_id)
    }
    for take_id in take_ids:
        if take_id not in takes_by_id:
            raise TakeNotFound(f"no take {take_id}")
    return access, [takes_by_id[take_id] for take_id in take_ids]


def _leave_cue(session: Session, take: Take, *, by: UUID) -> None:
    """Remove a take from its cue; the result of a running check no longer counts."""
    if take.cue_id is not None:
        take_states.note_moved_away(session, take, by=by)
        take.cue = take.cue_id = take.number = None
        take.variation = 1
        take.conforming_since = take.returned_since = None
    take.edition += 1
    if take.state is not TakeState.RECEIVED:
        take_states.restore_state(session, take, TakeState.RECEIVED, clock.now())
    session.flush()


def _place_of(take: Take) -> dict[str, Any]:
    return {
        "take_id": str(take.id),
        "cue_id": str(take.cue_id) if take.cue_id else None,
        "variation": take.variation,
        "alternate": take.alternate,
        "is_discarded": take.discarded_at is not None,
    }


def _record(
    session: Session,
    access: ProjectAccess,
    kind: TrayActionKind,
    takes: Sequence[Take],
    before: Sequence[dict[str, Any]],
) -> TrayAction:
    editions = {str(take.id): take.edition for take in takes}
    action = TrayAction(
        studio_id=access.project.studio_id,
        project_id=access.project.id,
        kind=kind,
        done_by=access.actor.person,
        takes=[{**previous, "edition_after": editions[previous["take_id"]]} for previous in before],
    )
    session.add(action)
    session.flush()
    return action


def tray_action_read(action: TrayAction) -> TrayActionRead:
    """Return an action as it is shown."""
    return TrayActionRead(
        id=action.id,
        kind=action.kind,
        done_at=action.done_at,
        undone_at=action.undone_at,
        take_ids=[UUID(previous["take_id"]) for previous in action.takes],
    )
