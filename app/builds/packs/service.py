"""The approved pack: game files of a target under the names the game expects, masters beside them, the key on top."""

import hashlib
import io
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from pathlib import PurePosixPath
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.builds import queries
from app.builds.engine_export.cues import Handoff
from app.builds.errors import BlobDamaged, NothingAccepted, PackIncomplete, PlaceholderAccepted
from app.builds.packs.documentation_key import KeyRow, key_csv, key_xlsx
from app.builds.packs.key_pdf import key_pdf
from app.builds.packs.zip_stream import Entry
from app.builds.rules import FileKind, changes_between, sums
from app.builds.schemas import ChangedPath, MissingFile, PackChanges, PackRead
from app.conformance.queries import takes_with_finding
from app.conformance.rules import PLACEHOLDER_CODE
from app.core.storage import READ_AGAIN_FIX, BlobAltered, BlobMissing, Store
from app.deliveries.models import Take
from app.deliveries.rules import TakeState, ensure_master_kept, work_state
from app.deliveries.schemas import Sources
from app.deliveries.sources.service import sources_of
from app.deliveries.sources.statements import words_of
from app.money.covering import contract_references
from app.money.downloads import closed_downloads
from app.projects.models import Project
from app.projects.queries import current_spec
from app.projects.service import ProjectAccess, project_access
from app.renders.errors import TargetUnknown
from app.renders.models import Render
from app.renders.queries import current_renders, parsed_spec
from app.renders.rules import RenderState, game_ending
from app.reviews.queries import accepted_takes
from app.sound_lists.models import Cue
from app.sound_lists.rules import label
from app.voice_lines.queries import languages_by_cue
from audio_checks import Target, is_lossy

KEY_CSV, KEY_XLSX, KEY_PDF = (f"documentation-key.{ending}" for ending in ("csv", "xlsx", "pdf"))
SUMS = "SHA256SUMS"
SAME_SOUND = ("sample_rate_hz", "bit_depth", "encoding", "channels", "loop_points")
NAMES_SHOWN = 3
VERIFIED_AHEAD_BYTES = 1 << 30
PATHS_SHOWN = 200


@dataclass(frozen=True)
class PackedSound:
    """One variation of an accepted cue, its take, and its game file for the target, if there is one."""

    cue: Cue
    variation: int
    take: Take
    path: str  # in the pack: the target's folder and the name that the cue owns
    render: Render | None
    language: str | None = None  # of a voice line
    closed: str | None = None  # why its files cannot be downloaded, where its contract opens them by payment

    @property
    def file_name(self) -> str:
        """The name that the game expects."""
        return PurePosixPath(self.path).name

    @property
    def made(self) -> Render | None:
        """The game file, None where it was refused or is not made yet."""
        return self.render if self.render and self.render.state is RenderState.MADE else None

    @property
    def packed(self) -> Render | None:
        """The game file that goes into the pack, None where there is none or it is not paid yet."""
        return None if self.closed else self.made

    @property
    def why_missing(self) -> str:
        """Return the reason for no game file in the pack."""
        if self.closed and self.made:
            return self.closed
        if self.render is None:
            return "its game file is not rendered yet"
        return self.render.refusal or "its game file was refused"

    @property
    def master_name(self) -> str:
        """The master's path in the pack, under the name of its game file."""
        folder = f"masters/{self.language}" if self.language else "masters"
        return f"{folder}/{PurePosixPath(self.file_name).stem}{PurePosixPath(self.take.file_name).suffix.lower()}"


@dataclass(frozen=True)
class PackedPlaceholder:
    """A marked placeholder in the place of a sound that is not accepted yet."""

    cue: Cue
    variation: int
    path: str
    sha256: str
    file_bytes: int


@dataclass(frozen=True)
class Pack:
    """The content of a target's pack."""

    project: Project
    target: str
    targets: list[str]
    sounds: list[PackedSound]
    cues_wanted: int
    last_number: int | None  # of the target's newest sealed pack
    last_handoff: Handoff
    last_marks: dict[str, str]  # fingerprints of its game files, by path
    marked: set[UUID]  # takes whose files are marked as placeholder files
    sources: dict[UUID, Sources] = field(default_factory=dict)  # what takes were made from, where that is stated
    contracts: dict[UUID, str] = field(default_factory=dict)  # that ordered takes, by the takes
    placeholder_files: list[PackedPlaceholder] = field(default_factory=list)  # only if requested

    @property
    def marks(self) -> dict[str, str]:
        """The fingerprint of each game file, by path."""
        return {sound.path: mark_of(render) for sound in self.sounds if (render := sound.packed)}


def mark_of(render: Render) -> str:
    """Return a mark that is equal for two game files with the same sound and loop, whatever their metadata."""
    return "|".join([render.pcm_sha256 or "", *(str(render.facts.get(fact)) for fact in SAME_SOUND)])


def visible_pack(session: Session, actor: Actor, project_id: UUID, target: str | None) -> Pack:
    """Return the contents of a target's pack; without a target, of the spec's first."""
    access = project_access(session, actor, project_id)
    ensure_team_or_build(access)
    return pack_of(session, access.project, target, actor)


def pack_of(session: Session, project: Project, target: str | None, actor: Actor | None = None) -> Pack:
    """Return the contents of a target's pack, without a check of the caller.

    `actor` is who reads why a sound is not paid: an invoice is named to those who see its contract.

    A file that sounds as it did in the last pack is that very file, so that the game's depot sees no change.
    """
    spec = current_spec(session, project.id)
    view = parsed_spec(spec.toml)
    targets = list(view.targets)
    chosen = target or (targets[0] if targets else "")
    if chosen not in targets:
        raise TargetUnknown(f'the spec has no target "{chosen}"; it has {", ".join(targets) or "none"}')
    last = queries.last_sealed(session, project.id, chosen)
    last_renders = queries.game_renders_of(session, last.id) if last else {}
    accepted = accepted_takes(session, project.id)
    renders = current_renders(session, {project.id: spec}, [take for _, _, take in accepted])
    stems, languages = queries.stems_of_project(session, project.id), languages_by_cue(session, project.id)
    categories: dict[str, tuple[str, Target]] = {}
    work = {(cue.id, take.designer_id) for cue, _, take in accepted}
    closed = closed_downloads(session, actor, work)
    sounds = []
    for cue, variation, take in accepted:
        if cue.category not in categories:
            asked = view.for_category(cue.category or None)
            categories[cue.category] = asked.targets[chosen].ending(asked.naming.extension), asked.targets[chosen]
        ending, made_to = categories[cue.category]
        language = languages.get(cue.id)
        render = renders[take.id].get(chosen)
        file_ending = game_ending(render.facts if render else {}, made_to, ending)
        path = made_to.path_of(stems[cue.id, variation] + file_ending, cue.category, language)
        before = last_renders.get(path)
        if before and render and render.state is RenderState.MADE and mark_of(before) == mark_of(render):
            render = before
        reason = closed.get((cue.id, take.designer_id))
        sounds.append(PackedSound(cue, variation, take, path, render, language, reason))
    return Pack(
        project=project,
        target=chosen,
        targets=targets,
        sounds=sounds,
        cues_wanted=queries.wanted_cues(session, project.id),
        last_number=last.number if last else None,
        last_handoff=last.handoff if last else Handoff.NONE,
        last_marks={path: mark_of(render) for path, render in last_renders.items()},
        marked=takes_with_finding(session, [take.id for _, _, take in accepted], PLACEHOLDER_CODE),
        sources=sources_of(session, [take for _, _, take in accepted]),
        contracts=contract_references(
            session,
            project.cue_prefix,
            {take.id: (take.cue_id, take.designer_id) for _, _, take in accepted if take.cue_id is not None},
        ),
    )


def ensure_team_or_build(access: ProjectAccess) -> None:
    """Raise TeamNeeded for a designer; a build's token was let in by its scope."""
    if not access.actor.is_build:
        access.ensure_team()


def pack_read(pack: Pack) -> PackRead:
    """Return the contents of a pack, in figures."""
    made = [render for sound in pack.sounds if (render := sound.packed)]
    return PackRead(
        target=pack.target,
        targets=pack.targets,
        files=len(made),
        bytes=sum(render.file_bytes or 0 for render in made),
        masters_bytes=sum(sound.take.master_bytes for sound in pack.sounds if not sound.closed),
        cues_accepted=len({sound.cue.id for sound in pack.sounds}),
        cues_wanted=pack.cues_wanted,
        handoff=pack.last_handoff,
        changes=changes_read(pack.last_number, pack.last_marks, pack.marks),
        missing=[
            MissingFile(
                cue_id=sound.cue.id,
                label=label(pack.project.cue_prefix, sound.cue.number),
                name=sound.cue.name,
                file_name=sound.path,
                reason=sound.why_missing,
            )
            for sound in pack.sounds
            if not sound.packed
        ],
    )


def changes_read(since: int | None, before: Mapping[str, str], after: Mapping[str, str]) -> PackChanges:
    """Return the changes of the game files since a pack; everything is new where there was none."""
    changes = changes_between(before, after)
    return PackChanges(
        since=since,
        new=len(changes.new),
        changed=len(changes.changed),
        gone=len(changes.gone),
        same=changes.same,
        paths=[
            ChangedPath(path=path, kind=kind)
            for kind, paths in (("changed", changes.changed), ("new", changes.new), ("gone", changes.gone))
            for path in paths[:PATHS_SHOWN]
        ],
    )


def key_rows(pack: Pack, *, masters: bool) -> list[KeyRow]:
    """Return the rows of the documentation key."""
    rows = [_key_row(pack, sound, masters=masters) for sound in pack.sounds]
    return rows + [_placeholder_file_row(pack, placeholder_file) for placeholder_file in pack.placeholder_files]


def _placeholder_file_row(pack: Pack, placeholder: PackedPlaceholder) -> KeyRow:
    return KeyRow(
        file=placeholder.path,
        cue=label(pack.project.cue_prefix, placeholder.cue.number),
        name=placeholder.cue.name,
        category=placeholder.cue.category,
        variation=placeholder.variation,
        variations=placeholder.cue.variations,
        description=placeholder.cue.description,
        use=placeholder.cue.use,
        trigger=placeholder.cue.trigger,
        loop="yes" if placeholder.cue.loop else "no",
        duration_s=placeholder.cue.duration_s,
        sample_rate_hz=None,
        bit_depth=None,
        channels=None,
        attenuation_db=None,
        version=None,
        note="PLACEHOLDER: not the final sound; it must not ship",
        sources="",
        originator="",
        contract="",
        state=work_state(TakeState.RECEIVED, is_placeholder=True),
        master="",
        file_sha256=placeholder.sha256,
        master_sha256="",
    )


def _key_row(pack: Pack, sound: PackedSound, *, masters: bool) -> KeyRow:
    cue, take, render = sound.cue, sound.take, sound.packed
    facts = render.facts if render else {}
    return KeyRow(
        file=sound.path if render else "",
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
        bit_depth=None if is_lossy(facts.get("encoding", "")) else facts.get("bit_depth"),
        channels=facts.get("channels"),
        attenuation_db=render.attenuation_db if render else None,
        version=take.number,
        note=take.note if render else sound.why_missing,
        sources=words_of(pack.sources[take.id]) if take.id in pack.sources else "",
        originator=take.designer.name,
        contract=pack.contracts.get(take.id, ""),
        state=work_state(take.state, is_placeholder=take.id in pack.marked),
        master=sound.master_name if masters and not sound.closed else take.file_name,
        file_sha256=(render.sha256 if render else None) or "",
        master_sha256=take.master_sha256,
    )


@dataclass(frozen=True)
class Packed:
    """One file of a pack, and what it is."""

    entry: Entry
    kind: FileKind
    render: Render | None = None


def pack_files(
    store: Store,
    pack: Pack,
    *,
    masters: bool,
    allow_missing: bool,
    placeholders: bool = False,
    handoff: Sequence[Entry] = (),
) -> list[Packed]:
    """Return the files of the ZIP in their order: the game files in list order, masters, engine export, key, sums.

    The key's workbook is a ZIP itself: before the sounds, a pack that broke off could be taken for it.

    Raises NothingAccepted, PackIncomplete where an accepted sound has no file and that is not allowed,
    BlobDamaged where the store does not hold what the database names.
    """
    ensure_packable(pack, allow_missing=allow_missing, placeholders=placeholders)
    studio_id = pack.project.studio_id
    files = [
        Packed(
            stored_entry(store, studio_id, sound.path, render.sha256 or "", render.file_bytes or 0),
            FileKind.GAME,
            render,
        )
        for sound in pack.sounds
        if (render := sound.packed)
    ]
    files += [
        Packed(
            stored_entry(store, studio_id, placeholder_file.path, placeholder_file.sha256, placeholder_file.file_bytes),
            FileKind.PLACEHOLDER,
        )
        for placeholder_file in pack.placeholder_files
    ]
    if masters:
        for sound in pack.sounds:
            ensure_master_kept(sound.take.master_deleted_at)
        files += [
            Packed(
                stored_entry(store, studio_id, sound.master_name, sound.take.master_sha256, sound.take.master_bytes),
                FileKind.MASTER,
            )
            for sound in pack.sounds
            if not sound.closed
        ]
    ensure_stored(store, studio_id, [file.entry for file in files])
    rows = key_rows(pack, masters=masters)
    keys = {KEY_CSV: key_csv(rows), KEY_XLSX: key_xlsx(rows), KEY_PDF: key_pdf(rows, title=title_of(pack))}
    entries = [*(file.entry for file in files), *handoff]
    entries += [memory_entry(path, content) for path, content in keys.items()]
    entries.append(memory_entry(SUMS, sums({entry.path: entry.sha256 for entry in entries})))
    return [*files, *(Packed(entry, FileKind.KEY) for entry in entries[len(files) :])]


def title_of(pack: Pack) -> str:
    """Return the heading of the documentation key."""
    return f"{pack.project.name}, {pack.target}"


def ensure_packable(pack: Pack, *, allow_missing: bool, placeholders: bool) -> None:
    """Raise NothingAccepted, PackIncomplete, or PlaceholderAccepted where a placeholder file would ship unnoticed."""
    if not pack.sounds and not pack.placeholder_files:
        raise NothingAccepted("no cue is accepted yet; approve every variation of at least one cue first")
    if disguised := [sound for sound in pack.sounds if sound.take.id in pack.marked and not placeholders]:
        named = ", ".join(sound.path for sound in disguised[:NAMES_SHOWN])
        raise PlaceholderAccepted(
            f"{named}: the accepted version is marked as a placeholder, not the final sound; {len(disguised)} in all",
            errors=[{"where": sound.path, "message": "its master is marked as a placeholder"} for sound in disguised],
            fix="have the final sound delivered, or ask for a pack with placeholders (placeholders=true)",
        )
    missing = [sound for sound in pack.sounds if not sound.packed]
    if missing and not allow_missing:
        named = ", ".join(sound.path for sound in missing[:NAMES_SHOWN])
        more = f" and {len(missing) - NAMES_SHOWN} more" if len(missing) > NAMES_SHOWN else ""
        raise PackIncomplete(
            f"{named}{more} cannot be packed for {pack.target}: {missing[0].why_missing}",
            errors=[{"where": sound.path, "message": sound.why_missing} for sound in missing],
            fix="seal the pack without them (allow_missing=true), or have them rendered and paid first",
        )


def memory_entry(path: str, content: bytes) -> Entry:
    """Return a small file as a ZIP takes it."""
    return Entry(path, len(content), hashlib.sha256(content).hexdigest(), partial(io.BytesIO, content))


def stored_entry(store: Store, studio_id: UUID, path: str, sha256: str, size_bytes: int) -> Entry:
    """Return one stored file as a ZIP takes it."""
    return Entry(path, size_bytes, sha256, partial(store.open, studio_id, sha256))


def ensure_stored(store: Store, studio_id: UUID, entries: Sequence[Entry]) -> None:
    """Raise BlobDamaged unless the store holds every file, as long as it should be and, in the first GiB, whole.

    What comes after that is hashed when its turn comes in the ZIP, which breaks off before a damaged file.
    """
    sizes_bytes = store.sizes_bytes(studio_id, {entry.sha256 for entry in entries})
    ahead_bytes = 0
    for entry in entries:
        is_whole = sizes_bytes.get(entry.sha256) == entry.size_bytes
        ahead_bytes += entry.size_bytes
        if is_whole and ahead_bytes <= VERIFIED_AHEAD_BYTES:
            is_whole = _is_intact(store, studio_id, entry.sha256)
        if not is_whole:
            raise BlobDamaged(
                f"{entry.path} (SHA-256 {entry.sha256}) is lost or damaged in the store",
                errors=[{"where": entry.path, "message": "lost or damaged in the store"}],
                fix=READ_AGAIN_FIX,
            )


def _is_intact(store: Store, studio_id: UUID, sha256: str) -> bool:
    try:
        store.ensure_intact(studio_id, sha256)
    except (BlobAltered, BlobMissing):
        return False
    return True
