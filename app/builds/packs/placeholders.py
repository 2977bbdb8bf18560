"""Placeholders: what the game has no accepted sound for, and the marked placeholder files that are made for it."""

import hashlib
import json
from collections import Counter
from collections.abc import Iterator
from dataclasses import asdict, dataclass, replace
from typing import Literal
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.builds import queries
from app.builds.models import PlaceholderFile
from app.builds.packs.service import Pack, PackedPlaceholder, pack_of, visible_pack
from app.builds.schemas import CategoryCountdown, PlaceholderCountdown, PlaceholderRead, PlaceholderRegister
from app.core.events import publish
from app.core.jobs.queue import BULK
from app.core.storage import StoredBlob
from app.projects.models import Project
from app.projects.queries import current_spec
from app.projects.service import project_access
from app.renders.queries import parsed_spec
from app.sound_lists.models import Cue
from app.sound_lists.queries import cues_of, spoken_placeholder, spoken_sha256s
from app.sound_lists.rules import CueState, label
from app.sound_lists.service import cue_facts
from app.voice_lines.queries import languages_by_cue
from audio_checks import TOOL_VERSION, CueFacts, DeliverySpec

SETTLED_FIRST = {CueState.LOCKED: 0, CueState.PROTOTYPE: 1, CueState.CONCEPT: 2}


@dataclass(frozen=True)
class Slot:
    """One file that the game wants and has no accepted sound for."""

    cue: Cue
    variation: int
    path: str
    facts: CueFacts
    view: DeliverySpec
    key: str  # of everything that its placeholder file is made from
    said_sha256: str | None = None  # what a person said for the cue


def open_slots(session: Session, pack: Pack) -> Iterator[Slot]:
    """Yield the open slots of a pack, in list order."""
    spec = parsed_spec(current_spec(session, pack.project.id).toml)
    there = {(sound.cue.id, sound.variation) for sound in pack.sounds if sound.made}
    languages = languages_by_cue(session, pack.project.id)
    spoken_by_cue = spoken_sha256s(session, pack.project.id)
    views: dict[str, DeliverySpec] = {}
    for cue in cues_of(session, pack.project.id):
        if cue.state is CueState.CUT:
            continue
        if cue.category not in views:
            views[cue.category] = spec.for_target(pack.target, cue.category or None)
        view = views[cue.category]
        facts = replace(cue_facts(cue), number=label(pack.project.cue_prefix, cue.number))
        for stem in sorted(cue.stems, key=lambda slot_stem: slot_stem.variation):
            if (cue.id, stem.variation) not in there and view.target is not None:
                path = view.target.path_of(stem.stem + view.ending, cue.category, languages.get(cue.id))
                key = _key(facts, stem.variation, view, spoken_by_cue.get(cue.id))
                yield Slot(cue, stem.variation, path, facts, view, key, spoken_by_cue.get(cue.id))


def _key(facts: CueFacts, variation: int, view: DeliverySpec, said_sha256: str | None) -> str:
    inputs = {name: value for name, value in asdict(facts).items() if name != "more"}
    made_of = [TOOL_VERSION, inputs, variation, view.sha256, view.category, view.target and view.target.name]
    if said_sha256 is not None:
        made_of.append(said_sha256)
    return hashlib.sha256(json.dumps(made_of, sort_keys=True, default=str).encode()).hexdigest()


def register(session: Session, actor: Actor, project_id: UUID, target: str | None) -> PlaceholderRegister:
    """Return the remaining placeholders for a target."""
    pack = visible_pack(session, actor, project_id, target)
    made = queries.placeholder_files_of(session, project_id, pack.target)
    prefix = pack.project.cue_prefix
    items = [_item(prefix, slot, made.get((slot.cue.id, slot.variation))) for slot in open_slots(session, pack)]
    replaced = sum(sound.made is not None for sound in pack.sounds)
    return PlaceholderRegister(
        target=pack.target,
        targets=pack.targets,
        files=replaced + len(items),
        replaced=replaced,
        left=len(items),
        made=sum(item.state == "made" for item in items),
        items=items,
    )


def countdown(session: Session, actor: Actor, project_id: UUID, target: str | None) -> PlaceholderCountdown:
    """Return the number of placeholders left for a target, by category, and the next one to record."""
    pack = visible_pack(session, actor, project_id, target)
    left = list(open_slots(session, pack))
    there = [sound for sound in pack.sounds if sound.made]
    files = Counter(sound.cue.category for sound in there) + Counter(slot.cue.category for slot in left)
    lacking = Counter(slot.cue.category for slot in left)
    cues_left = {slot.cue.id for slot in left}
    return PlaceholderCountdown(
        target=pack.target,
        cues=len(cues_left | {sound.cue.id for sound in there}),
        cues_left=len(cues_left),
        files=files.total(),
        left=len(left),
        categories=[
            CategoryCountdown(category=category, files=count, left=lacking[category])
            for category, count in sorted(files.items())
        ],
        next=_next_to_record(session, pack, left),
    )


def _next_to_record(session: Session, pack: Pack, left: list[Slot]) -> PlaceholderRead | None:
    under_way = queries.slots_under_way(session, pack.project.id)
    to_record = [slot for slot in left if (slot.cue.id, slot.variation) not in under_way]
    if not to_record:
        return None
    first = min(to_record, key=lambda slot: SETTLED_FIRST[slot.cue.state])
    made = queries.placeholder_file(session, first.cue.id, first.variation, pack.target)
    return _item(pack.project.cue_prefix, first, made)


def _item(prefix: str, slot: Slot, made: PlaceholderFile | None) -> PlaceholderRead:
    return PlaceholderRead(
        cue_id=slot.cue.id,
        cue=label(prefix, slot.cue.number),
        name=slot.cue.name,
        trigger=slot.cue.trigger,
        variation=slot.variation,
        path=slot.path,
        category=slot.cue.category,
        state=_state(slot, made),
        spoken=made.is_spoken if made else False,
        refusal=made.refusal if made else None,
    )


def _state(slot: Slot, made: PlaceholderFile | None) -> Literal["missing", "made", "outdated", "refused"]:
    if made is None:
        return "missing"
    if made.key != slot.key:
        return "outdated"
    return "refused" if made.sha256 is None else "made"


def request_placeholder_files(session: Session, actor: Actor, project_id: UUID, target: str) -> None:
    """Have a placeholder file made for everything that the pack of a target lacks."""
    access = project_access(session, actor, project_id)
    access.ensure_team()
    pack = pack_of(session, access.project, target)
    studio_id = pack.project.studio_id
    publish(
        session, "placeholders.asked", studio_id=studio_id, priority=BULK, project_id=project_id, target=pack.target
    )


def slots_to_make(
    session: Session, project_id: UUID, target: str, cue_id: UUID | None = None
) -> tuple[Project, list[Slot]]:
    """Return the slots, or those of one cue, whose placeholder file is not there, or is not what it should be."""
    pack = pack_of(session, session.get_one(Project, project_id), target)
    made = queries.placeholder_files_of(session, project_id, target)
    return pack.project, [
        slot
        for slot in open_slots(session, pack)
        if cue_id is None or slot.cue.id == cue_id
        if (placeholder_file := made.get((slot.cue.id, slot.variation))) is None or placeholder_file.key != slot.key
    ]


def targets_of_project(session: Session, project_id: UUID) -> list[str]:
    """Return the names of the targets that a project's spec has."""
    return list(parsed_spec(current_spec(session, project_id).toml).targets)


def keep(
    session: Session,
    project: Project,
    target: str,
    slot: Slot,
    blob: StoredBlob | None,
    *,
    is_spoken: bool,
    refusal: str,
) -> None:
    """Put a placeholder file on record, or why there is none; not where something else has been said meanwhile."""
    spoken = spoken_placeholder(session, slot.cue.id)
    if (spoken.sha256 if spoken else None) != slot.said_sha256:
        return  # the job of what is said now makes the file
    row = queries.placeholder_file(session, slot.cue.id, slot.variation, target)
    if row is None:
        row = PlaceholderFile(
            studio_id=project.studio_id,
            project_id=project.id,
            cue_id=slot.cue.id,
            variation=slot.variation,
            target=target,
        )
        session.add(row)
    row.key, row.is_spoken = slot.key, is_spoken
    row.sha256, row.file_bytes = (blob.sha256, blob.size_bytes) if blob else (None, None)
    row.refusal = None if blob else refusal


def with_placeholder_files(session: Session, pack: Pack) -> Pack:
    """Return a pack with placeholder files for what it lacks, those that were made for cue and spec as they are now."""
    made = queries.placeholder_files_of(session, pack.project.id, pack.target)
    filled = [
        PackedPlaceholder(
            slot.cue, slot.variation, slot.path, placeholder_file.sha256, placeholder_file.file_bytes or 0
        )
        for slot in open_slots(session, pack)
        if (placeholder_file := made.get((slot.cue.id, slot.variation)))
        and placeholder_file.key == slot.key
        and placeholder_file.sha256
    ]
    return replace(pack, placeholder_files=filled)
