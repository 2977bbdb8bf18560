"""Splits: one file of several sounds, whose parts its own designer makes variations of a cue."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

import audio_checks
from app.accounts.rules import Actor
from app.conformance import queries
from app.conformance.errors import NothingToSplit, PartsMisplaced, SplitNotReady
from app.conformance.models import CheckRun, Split, SplitPart
from app.conformance.rules import FixState, Report, several_sounds
from app.conformance.schemas import (
    PartPlace,
    SplitAsk,
    SplitFrom,
    SplitOffer,
    SplitPartRead,
    SplitRead,
    SplitUse,
)
from app.core import clock
from app.core.events import publish
from app.core.plural import counted
from app.deliveries.models import Take, TrayAction
from app.deliveries.rules import CHECKABLE, ensure_master_kept
from app.deliveries.schemas import CueBrief
from app.deliveries.service import ensure_own_designer, take_for
from app.deliveries.tray.service import PartGiven, split_take
from app.projects.service import project_access
from app.sound_lists.rules import label

MAX_OFFERED = 200
OUR_FAULT = "The split failed three times. That is our fault; ask again later, or split it in the session."
FOUND_IN_WORDS = {
    "regions": "by its regions",
    "markers": "by its markers",
    "silence": "by silence of {pause:g} s or more",
}


@dataclass(frozen=True)
class SplitOrder:
    """The inputs of a split, read at one moment."""

    split_id: UUID
    studio_id: UUID
    master_sha256: str
    master_bytes: int
    shortest_pause_s: float


def request_split(session: Session, actor: Actor, take_id: UUID, asked: SplitAsk) -> SplitRead:
    """Have the parts of a take's file found; those of one shortest pause are found once."""
    take, access = take_for(session, actor, take_id, locked=True)
    ensure_own_designer(access, take)
    ensure_master_kept(take.master_deleted_at)
    _ensure_may_split(take)
    split = queries.split_with_pause(session, take.id, asked.shortest_pause_s)
    if split is None:
        split = Split(
            studio_id=take.studio_id,
            project_id=take.project_id,
            take_id=take.id,
            shortest_pause_s=asked.shortest_pause_s,
        )
        session.add(split)
    is_new = split.state is None or split.refusal == OUR_FAULT
    split.asked_by, split.asked_at = actor.person, clock.now()
    if is_new:
        split.state, split.refusal = FixState.MAKING, None
    session.flush()
    if is_new:
        publish(session, "split.asked", studio_id=take.studio_id, split_id=split.id)
    return _read(session, take)


def use_split(session: Session, actor: Actor, take_id: UUID, given: SplitUse) -> TrayAction:
    """Make the parts of a take's file versions of variations; the file is discarded, and its master kept."""
    take, access = take_for(session, actor, take_id, locked=True)
    ensure_own_designer(access, take)
    ensure_master_kept(take.master_deleted_at)
    _ensure_may_split(take)
    split = queries.newest_split(session, take.id)
    if split is None or split.state is not FixState.MADE:
        raise SplitNotReady(
            split.refusal if split and split.refusal else "the parts of this file are not found yet",
            fix="ask for them first, and look at them once they are found",
        )
    cue_id = given.cue_id or take.cue_id
    if cue_id is None:
        raise PartsMisplaced("this file has no cue yet, so its parts have no variations", fix="choose a cue")
    action = split_take(session, access, take, cue_id, _parts_given(split.parts, given.places))
    split.tray_action_id = action.id
    session.flush()
    return action


def _parts_given(parts: Sequence[SplitPart], places: Sequence[PartPlace] | None) -> list[PartGiven]:
    if places is None:
        places = [PartPlace(part=part.number, variation=part.number) for part in parts]
    by_number = {part.number: part for part in parts}
    for named, known in (("part", by_number), ("variation", None)):
        numbers = [getattr(place, named) for place in places]
        if twice := {number for number in numbers if numbers.count(number) > 1}:
            raise PartsMisplaced(
                f"{named} {min(twice)} is named {numbers.count(min(twice))} times", fix=f"name each {named} once"
            )
        if known is not None and (unknown := set(numbers) - known.keys()):
            raise PartsMisplaced(
                f"there is no part {min(unknown)}: the file has {counted(len(parts), 'part')}",
                fix=f"name parts from 1 to {len(parts)}",
            )
    return [
        PartGiven(part.sha256, part.part_bytes, part.first_frame, part.end_frame, place.variation)
        for place in places
        for part in [by_number[place.part]]
    ]


def split_for(session: Session, actor: Actor, take_id: UUID) -> SplitRead:
    """Return the parts of a take within the caller's sight, and the file that it was itself cut from."""
    take, _ = take_for(session, actor, take_id)
    return _read(session, take)


def splits_offered(session: Session, actor: Actor, project_id: UUID) -> list[SplitOffer]:
    """Return the files of a project that hold several sounds, longest waiting first; a designer's own."""
    access = project_access(session, actor, project_id)
    takes = queries.takes_of_several_sounds(session, project_id, designer_id=access.only_designer_id, limit=MAX_OFFERED)
    offers = []
    for take, run in takes:
        says = several_sounds(run.report, one_sound_expected=take.cue is not None and take.cue.variations == 1)
        if says is not None:
            cue = take.cue and CueBrief(
                id=take.cue.id, label=label(access.project.cue_prefix, take.cue.number), name=take.cue.name
            )
            variations = take.cue.variations if take.cue else None
            offers.append(
                SplitOffer(take_id=take.id, file_name=take.file_name, cue=cue, variations=variations, says=says)
            )
    return offers


def order_split(session: Session, split_id: UUID) -> SplitOrder | None:
    """Return the order for a split; None where its parts are found."""
    split = queries.split_by_id(session, split_id)
    if split is None or split.state is not FixState.MAKING:
        return None
    take = session.get_one(Take, split.take_id)
    return SplitOrder(split.id, split.studio_id, take.master_sha256, take.master_bytes, split.shortest_pause_s)


def record_split(
    session: Session, split_id: UUID, made: audio_checks.SplitMaster, blobs: Sequence[tuple[str, int]]
) -> None:
    """Record the parts of a split, once; `blobs` are the stored files in their order."""
    split = queries.split_by_id(session, split_id, locked=True)
    if split is None or split.state is not FixState.MAKING:
        return
    split.state, split.found_by, split.sample_rate_hz = FixState.MADE, made.found_by, made.sample_rate_hz
    owner: dict[str, Any] = {"studio_id": split.studio_id, "project_id": split.project_id, "split_id": split.id}
    for number, (part, (sha256, part_bytes)) in enumerate(zip(made.parts, blobs, strict=True), 1):
        cut = {"first_frame": part.first, "end_frame": part.end, "label": part.label}
        session.add(SplitPart(**owner, number=number, **cut, sha256=sha256, part_bytes=part_bytes))
    session.flush()


def refuse_split(session: Session, split_id: UUID, refusal: str) -> None:
    """Record why a file was not split."""
    split = queries.split_by_id(session, split_id, locked=True)
    if split is not None and split.state is FixState.MAKING:
        split.state, split.refusal = FixState.REFUSED, refusal
        session.flush()


def _ensure_may_split(take: Take) -> None:
    if take.discarded_at is not None:
        raise NothingToSplit("this file was discarded", fix="restore it first")
    if not _may_split(take):
        state = take.state.replace("_", " ")
        raise NothingToSplit(f"this version is {state}", fix="deliver its parts as files of their own")


def _may_split(take: Take) -> bool:
    return take.discarded_at is None and take.state in CHECKABLE


def _read(session: Session, take: Take) -> SplitRead:
    split = queries.newest_split(session, take.id)
    run = queries.current_run(session, take.id)
    action = session.get(TrayAction, split.tray_action_id) if split and split.tray_action_id else None
    is_used = action is not None and action.undone_at is None
    offer = several_sounds(run.report, one_sound_expected=False) if run else None
    rate = split.sample_rate_hz if split else None
    return SplitRead(
        take_id=take.id,
        state=_state(split, is_used=is_used, is_offered=offer is not None and _may_split(take)),
        says=_says(split, offer),
        may_split=_may_split(take),
        is_our_fault=split is not None and split.refusal == OUR_FAULT,
        shortest_pause_s=split.shortest_pause_s if split else audio_checks.SHORTEST_PAUSE_S,
        found_by=split.found_by if split else None,
        parts=[_read_part(part, rate) for part in split.parts] if split and rate else [],
        tray_action_id=action.id if action and is_used else None,
        split_from=_split_from(session, take, run),
    )


def _state(split: Split | None, *, is_used: bool, is_offered: bool) -> Any:
    if is_used:
        return "used"
    if split is not None:
        return split.state.value
    return "offered" if is_offered else "none"


def _says(split: Split | None, offer: str | None) -> str:
    if split is None or split.state is FixState.MAKING:
        return offer or "One sound, as far as the check can tell."
    if split.found_by is None:
        return split.refusal or ""
    way = FOUND_IN_WORDS[split.found_by].format(pause=split.shortest_pause_s)
    return f"{counted(len(split.parts), 'part')}, found {way}."


def _read_part(part: SplitPart, rate_hz: int) -> SplitPartRead:
    return SplitPartRead(
        number=part.number,
        start_s=part.first_frame / rate_hz,
        duration_s=(part.end_frame - part.first_frame) / rate_hz,
        label=part.label,
    )


def _split_from(session: Session, take: Take, run: CheckRun | None) -> SplitFrom | None:
    if take.split_of_id is None or take.split_first_frame is None or take.split_end_frame is None:
        return None
    whole = session.get_one(Take, take.split_of_id)
    facts: Report = (run.report["facts"] if run else None) or {}
    rate_hz = facts.get("sample_rate_hz")
    return SplitFrom(
        take_id=whole.id,
        file_name=whole.file_name,
        first_frame=take.split_first_frame,
        end_frame=take.split_end_frame,
        start_s=take.split_first_frame / rate_hz if rate_hz else None,
        end_s=take.split_end_frame / rate_hz if rate_hz else None,
    )
