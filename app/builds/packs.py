"""The approved pack: game files of a target under the names the game expects, masters beside them, the key on top."""

import hashlib
import io
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import PurePosixPath
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.builds import queries
from app.builds.documentation_key import KeyRow, key_csv, key_xlsx
from app.builds.errors import BlobDamaged, NothingAccepted, PackIncomplete
from app.builds.schemas import MissingFile, PackRead
from app.builds.zip_stream import Entry
from app.deliveries.models import Take
from app.kit.storage import Store
from app.projects.models import Project
from app.projects.queries import current_spec
from app.projects.service import Standing, standing_in
from app.renders.errors import TargetUnknown
from app.renders.models import Render
from app.renders.queries import current_renders, parsed_spec
from app.renders.rules import RenderState
from app.reviews.queries import accepted_takes
from app.sound_lists.models import Cue
from app.sound_lists.rules import label

KEY_CSV, KEY_XLSX = "documentation-key.csv", "documentation-key.xlsx"
NAMES_SHOWN = 3


@dataclass(frozen=True)
class PackedSound:
    """One variation of an accepted cue, its take, and its game file for the target, if there is one."""

    cue: Cue
    variation: int
    take: Take
    file_name: str
    render: Render | None

    @property
    def made(self) -> Render | None:
        """The game file, None where it was refused or is not made yet."""
        return self.render if self.render and self.render.state is RenderState.MADE else None

    @property
    def why_missing(self) -> str:
        """Why there is no game file."""
        if self.render is None:
            return "its game file is not made yet"
        return self.render.refusal or "its game file was refused"

    @property
    def master_name(self) -> str:
        """Where the master stands in the pack, under the name that the game file has."""
        return f"masters/{PurePosixPath(self.file_name).stem}{PurePosixPath(self.take.file_name).suffix.lower()}"


@dataclass(frozen=True)
class Pack:
    """What a pack of a target holds."""

    project: Project
    target: str
    targets: list[str]
    sounds: list[PackedSound]
    cues_wanted: int


def pack_in_sight(session: Session, actor: Actor, project_id: UUID, target: str | None) -> Pack:
    """Return what the pack of a target holds; without a target, of the spec's first."""
    standing = standing_in(session, actor, project_id)
    ensure_team_or_build(standing)
    spec = current_spec(session, project_id)
    view = parsed_spec(spec.toml)
    targets = list(view.targets)
    chosen = target or (targets[0] if targets else "")
    if chosen not in targets:
        raise TargetUnknown(f'the spec has no target "{chosen}"; it has {", ".join(targets) or "none"}')
    accepted = accepted_takes(session, project_id)
    renders = current_renders(session, {project_id: spec}, [take for _, _, take in accepted])
    stems = queries.stems_of_project(session, project_id)
    extensions: dict[str, str] = {}
    sounds = []
    for cue, variation, take in accepted:
        if cue.category not in extensions:
            extensions[cue.category] = view.for_category(cue.category or None).naming.extension or ".wav"
        sounds.append(
            PackedSound(
                cue=cue,
                variation=variation,
                take=take,
                file_name=stems[cue.id, variation] + extensions[cue.category],
                render=renders[take.id].get(chosen),
            )
        )
    return Pack(standing.project, chosen, targets, sounds, queries.wanted_cues(session, project_id))


def ensure_team_or_build(standing: Standing) -> None:
    """Raise TeamNeeded for a designer; a build's token was let in by its scope."""
    if not standing.actor.is_build:
        standing.ensure_team()


def pack_read(pack: Pack) -> PackRead:
    """Return what a pack holds, in figures."""
    made = [sound.made for sound in pack.sounds if sound.made]
    return PackRead(
        target=pack.target,
        targets=pack.targets,
        files=len(made),
        bytes=sum(render.file_bytes or 0 for render in made),
        masters_bytes=sum(sound.take.master_bytes for sound in pack.sounds),
        cues_accepted=len({sound.cue.id for sound in pack.sounds}),
        cues_wanted=pack.cues_wanted,
        missing=[
            MissingFile(
                cue_id=sound.cue.id,
                label=label(pack.project.cue_prefix, sound.cue.number),
                name=sound.cue.name,
                file_name=sound.file_name,
                reason=sound.why_missing,
            )
            for sound in pack.sounds
            if not sound.made
        ],
    )


def key_rows(pack: Pack, *, masters: bool) -> list[KeyRow]:
    """Return the rows of the documentation key."""
    return [_key_row(pack, sound, masters=masters) for sound in pack.sounds]


def _key_row(pack: Pack, sound: PackedSound, *, masters: bool) -> KeyRow:
    cue, take, render = sound.cue, sound.take, sound.made
    facts = render.facts if render else {}
    return KeyRow(
        file=sound.file_name if render else "",
        cue=label(pack.project.cue_prefix, cue.number),
        name=cue.name,
        category=cue.category,
        variation=sound.variation,
        variations=cue.variations,
        description=cue.description,
        use=cue.use,
        trigger=cue.trigger,
        loop="yes" if cue.loop else "no",
        duration_s=facts.get("duration_s"),
        sample_rate_hz=facts.get("sample_rate_hz"),
        bit_depth=facts.get("bit_depth"),
        channels=facts.get("channels"),
        attenuation_db=render.attenuation_db if render else None,
        version=take.number,
        note=take.note if render else sound.why_missing,
        master=sound.master_name if masters else take.file_name,
        file_sha256=(render.sha256 if render else None) or "",
        master_sha256=take.master_sha256,
    )


def pack_entries(store: Store, pack: Pack, *, masters: bool, allow_missing: bool) -> list[Entry]:
    """Return the files of the ZIP in their order: the game files in list order, the masters, the key.

    The key's workbook is a ZIP itself: before the sounds, a pack that broke off could be taken for it.


    Raises NothingAccepted, PackIncomplete where an accepted sound has no file and that is not allowed,
    BlobDamaged where the store does not hold what the database names.
    """
    if not pack.sounds:
        raise NothingAccepted("no cue is accepted yet; approve every variation of one first")
    missing = [sound for sound in pack.sounds if not sound.made]
    if missing and not allow_missing:
        named = ", ".join(sound.file_name for sound in missing[:NAMES_SHOWN])
        more = f" and {len(missing) - NAMES_SHOWN} more" if len(missing) > NAMES_SHOWN else ""
        raise PackIncomplete(
            f"{named}{more} cannot be packed for {pack.target}: {missing[0].why_missing}",
            errors=[{"where": sound.file_name, "message": sound.why_missing} for sound in missing],
            fix="take the pack without them (allow_missing=true), or have them made first",
        )
    studio_id = pack.project.studio_id
    entries = [
        _stored(store, studio_id, sound.file_name, render.sha256 or "", render.file_bytes or 0)
        for sound in pack.sounds
        if (render := sound.made)
    ]
    if masters:
        entries += [
            _stored(store, studio_id, sound.master_name, sound.take.master_sha256, sound.take.master_bytes)
            for sound in pack.sounds
        ]
    _ensure_stored(store, studio_id, entries)
    rows = key_rows(pack, masters=masters)
    return [*entries, _in_memory(KEY_CSV, key_csv(rows)), _in_memory(KEY_XLSX, key_xlsx(rows))]


def _in_memory(path: str, content: bytes) -> Entry:
    return Entry(path, len(content), hashlib.sha256(content).hexdigest(), partial(io.BytesIO, content))


def _stored(store: Store, studio_id: UUID, path: str, sha256: str, size_bytes: int) -> Entry:
    return Entry(path, size_bytes, sha256, partial(store.open, studio_id, sha256))


def _ensure_stored(store: Store, studio_id: UUID, entries: Sequence[Entry]) -> None:
    sizes_bytes = store.sizes_bytes(studio_id, {entry.sha256 for entry in entries})
    for entry in entries:
        if sizes_bytes.get(entry.sha256) != entry.size_bytes:
            message = f"{entry.path} is lost or damaged in the store; restore {entry.sha256} from a backup"
            raise BlobDamaged(message, errors=[{"where": entry.path, "message": "lost or damaged in the store"}])
