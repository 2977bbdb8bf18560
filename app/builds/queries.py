"""Builds and what packs are made of, read from the database; callers have checked access."""

from collections import defaultdict
from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from datetime import datetime
from typing import Any, NamedTuple
from uuid import UUID

from sqlalchemy import ColumnElement, func, literal, select
from sqlalchemy.orm import Session, defer, joinedload, undefer

from app.accounts.models import Person
from app.agreements.models import Contract, ContractCue
from app.builds.models import Build, Fingerprint, PackedFile, PlaceholderFile, SealedPack
from app.builds.rules import FileKind, PackState
from app.conformance.models import CheckRun
from app.core.in_array import in_array
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.projects.models import Engagement, Project
from app.projects.rules import EngagementKind
from app.renders.models import Render
from app.reviews.models import ChangeRequest, Comment, GameLevel, Verdict
from app.sound_lists.models import Cue, Stem
from app.sound_lists.rules import CueState
from audio_checks import FINGERPRINT_VERSION

IDS_AT_ONCE = 500
UNDER_WAY = (TakeState.RECEIVED, TakeState.CONFORMING, TakeState.UNJUDGED, TakeState.APPROVED)


def builds_of(session: Session, project_id: UUID, *, before: UUID | None, limit: int) -> Sequence[Build]:
    """Return builds without their reports, the newest first."""
    query = select(Build).where(Build.project_id == project_id)
    if before is not None:
        query = query.where(Build.id < before)
    return session.scalars(query.options(defer(Build.report)).order_by(Build.id.desc()).limit(limit)).all()


def build_by_id(session: Session, build_id: UUID) -> Build | None:
    """Return a build with its report."""
    return session.scalar(select(Build).where(Build.id == build_id).options(undefer(Build.report)))


def stems_of_project(session: Session, project_id: UUID) -> dict[tuple[UUID, int], str]:
    """Return the stem of each cue and variation."""
    rows = session.execute(select(Stem.cue_id, Stem.variation, Stem.stem).where(Stem.project_id == project_id))
    return {(cue_id, variation): stem for cue_id, variation, stem in rows}


@dataclass(frozen=True)
class AdoptedMaster:
    """The file that was adopted for a variation of a cue."""

    sha256: str
    pcm_sha256s: frozenset[str]  # of its samples, as its checks read them


def adopted_masters(session: Session, project_id: UUID) -> dict[tuple[UUID, int], AdoptedMaster]:
    """Return the file that was adopted for each cue and variation, whether or not another was approved since."""
    query = (
        select(Take.cue_id, Take.variation, Take.master_sha256, CheckRun.pcm_sha256)
        .join(Verdict, Verdict.take_id == Take.id)
        .outerjoin(CheckRun, CheckRun.take_id == Take.id)
        .where(Verdict.project_id == project_id, Verdict.adoption_id.is_not(None), Take.discarded_at.is_(None))
    )
    masters: dict[tuple[UUID, int], AdoptedMaster] = {}
    for cue_id, variation, sha256, pcm_sha256 in session.execute(query):
        if cue_id is None:
            continue
        adopted = masters.setdefault((cue_id, variation), AdoptedMaster(sha256, frozenset()))
        if pcm_sha256:
            masters[cue_id, variation] = replace(adopted, pcm_sha256s=adopted.pcm_sha256s | {pcm_sha256})
    return masters


def wanted_cues(session: Session, project_id: UUID) -> int:
    """Return the number of cues of the list that are not cut."""
    query = select(func.count()).where(Cue.project_id == project_id, Cue.state != CueState.CUT)
    return session.scalar(query) or 0


def render_hashes(session: Session, take_ids: Collection[UUID]) -> dict[UUID, list[str]]:
    """Return the sample hashes of every game file ever made of takes."""
    hashes_by_take: dict[UUID, list[str]] = defaultdict(list)
    ids = list(take_ids)
    for start in range(0, len(ids), IDS_AT_ONCE):
        rows = session.execute(
            select(Render.take_id, Render.pcm_sha256)
            .where(Render.take_id.in_(ids[start : start + IDS_AT_ONCE]), Render.pcm_sha256.is_not(None))
            .order_by(Render.id)
        )
        for take_id, pcm_sha256 in rows:
            hashes_by_take[take_id].append(str(pcm_sha256))
    return hashes_by_take


def pack_by_id(session: Session, pack_id: UUID) -> SealedPack | None:
    """Return a pack with the person who sealed it, without a check of the caller."""
    return session.scalar(select(SealedPack).where(SealedPack.id == pack_id).options(joinedload(SealedPack.sealer)))


def packs_of(
    session: Session, project_id: UUID, *, target: str | None, before: UUID | None, limit: int
) -> Sequence[SealedPack]:
    """Return packs with the people who sealed them, the newest first."""
    query = select(SealedPack).where(SealedPack.project_id == project_id)
    if target is not None:
        query = query.where(SealedPack.target == target)
    if before is not None:
        query = query.where(SealedPack.id < before)
    return session.scalars(
        query.options(joinedload(SealedPack.sealer)).order_by(SealedPack.id.desc()).limit(limit)
    ).all()


def last_sealed(session: Session, project_id: UUID, target: str, *, below: int | None = None) -> SealedPack | None:
    """Return the newest sealed pack of a target; the newest below a number where one is given."""
    query = select(SealedPack).where(
        SealedPack.project_id == project_id, SealedPack.target == target, SealedPack.state == PackState.SEALED
    )
    if below is not None:
        query = query.where(SealedPack.number < below)
    return session.scalar(query.order_by(SealedPack.number.desc()).limit(1))


def last_pack_number(session: Session, project_id: UUID, target: str) -> int:
    """Return the number of the newest pack of a target; 0 where there is none."""
    query = select(func.max(SealedPack.number)).where(SealedPack.project_id == project_id, SealedPack.target == target)
    return session.scalar(query) or 0


def files_of(session: Session, pack_id: UUID) -> Sequence[PackedFile]:
    """Return the files of a pack in their order."""
    return session.scalars(select(PackedFile).where(PackedFile.pack_id == pack_id).order_by(PackedFile.place)).all()


class PackSums(NamedTuple):
    """The size of a pack."""

    files: int = 0  # game files
    placeholder_files: int = 0
    size_bytes: int = 0  # of all files, masters and key included


def pack_sums(session: Session, pack_ids: Collection[UUID]) -> dict[UUID, PackSums]:
    """Return the sums of each pack; nothing of one that is not put together yet."""
    rows = session.execute(
        select(
            PackedFile.pack_id,
            func.count().filter(PackedFile.kind == FileKind.GAME),
            func.count().filter(PackedFile.kind == FileKind.PLACEHOLDER),
            func.coalesce(func.sum(PackedFile.size_bytes), 0),
        )
        .where(PackedFile.pack_id.in_(pack_ids))
        .group_by(PackedFile.pack_id)
    )
    return {
        pack_id: PackSums(files, placeholder_files, int(size_bytes))
        for pack_id, files, placeholder_files, size_bytes in rows
    }


def render_of_project(session: Session, project_id: UUID, render_id: UUID) -> tuple[Render, Take] | None:
    """Return a project's render and its take, with its cue; the caller has checked access to the project."""
    row = session.execute(
        select(Render, Take)
        .join(Take, Take.id == Render.take_id)
        .where(Render.id == render_id, Take.project_id == project_id)
        .options(joinedload(Take.cue))
    ).one_or_none()
    return (row[0], row[1]) if row else None


def is_in_sealed_pack(session: Session, project_id: UUID, render_id: UUID) -> bool:
    """Whether a render is a game file of a project's pack that was sealed."""
    query = (
        select(PackedFile.pack_id)
        .join(SealedPack, SealedPack.id == PackedFile.pack_id)
        .where(
            SealedPack.project_id == project_id,
            SealedPack.state == PackState.SEALED,
            PackedFile.render_id == render_id,
        )
    )
    return session.scalar(query.limit(1)) is not None


def game_renders_of(session: Session, pack_id: UUID) -> dict[str, Render]:
    """Return the render behind each game file of a pack, by path."""
    rows = session.execute(
        select(PackedFile.path, Render)
        .join(Render, Render.id == PackedFile.render_id)
        .where(PackedFile.pack_id == pack_id, PackedFile.kind == FileKind.GAME)
        .order_by(PackedFile.place)
    )
    return {row[0]: row[1] for row in rows}


class PackedSoundRow(NamedTuple):
    """A game file of a sealed pack, and whose it is; its cue is None where its take was taken off it since."""

    path: str
    sha256: str
    size_bytes: int
    take_id: UUID
    cue_number: int | None


def packed_sounds_of(session: Session, pack_id: UUID) -> list[PackedSoundRow]:
    """Return the game files of a pack in their order."""
    rows = session.execute(
        select(PackedFile.path, PackedFile.sha256, PackedFile.size_bytes, Render.take_id, Cue.number)
        .join(Render, Render.id == PackedFile.render_id)
        .join(Take, Take.id == Render.take_id)
        .outerjoin(Cue, Cue.id == Take.cue_id)
        .where(PackedFile.pack_id == pack_id, PackedFile.kind == FileKind.GAME)
        .order_by(PackedFile.place)
    )
    return [PackedSoundRow._make(row) for row in rows]


def game_levels(session: Session, take_ids: Collection[UUID]) -> dict[str, list[dict[str, Any]]]:
    """Return the game's play levels of takes' sounds when their folder was adopted, by the take's id."""
    query = (
        select(Take.id, GameLevel.plays)
        .join(GameLevel, (GameLevel.cue_id == Take.cue_id) & (GameLevel.variation == Take.variation))
        .where(in_array(Take.id, take_ids))
    )
    return {str(take_id): plays for take_id, plays in session.execute(query)}


def fingerprinted_sounds(session: Session, studio_id: UUID, sha256s: Collection[str]) -> set[str]:
    """Return the stored sounds that have been listened to as this version does."""
    return set(session.scalars(select(Fingerprint.sound_sha256).where(*_fingerprinted(studio_id, sha256s))))


def manifest_entries(session: Session, studio_id: UUID, sha256s: Collection[str]) -> dict[str, dict[str, Any]]:
    """Return the identifying data of stored sounds, by their hashes."""
    rows = session.execute(
        select(Fingerprint.sound_sha256, Fingerprint.entry).where(*_fingerprinted(studio_id, sha256s))
    )
    return dict(rows.all())


def _fingerprinted(studio_id: UUID, sha256s: Collection[str]) -> tuple[ColumnElement[bool], ...]:
    return (
        Fingerprint.studio_id == studio_id,
        in_array(Fingerprint.sound_sha256, sha256s),
        Fingerprint.fingerprint_version == FINGERPRINT_VERSION,
    )


def slots_under_way(session: Session, project_id: UUID) -> set[tuple[UUID, int]]:
    """Return cue and variation of each file of which a take is checked now, waits for its verdict, or is approved."""
    rows = session.execute(
        select(Take.cue_id, Take.variation).where(Take.project_id == project_id, Take.state.in_(UNDER_WAY)).distinct()
    )
    return {(cue_id, variation) for cue_id, variation in rows if cue_id is not None}


def placeholder_files_of(session: Session, project_id: UUID, target: str) -> dict[tuple[UUID, int], PlaceholderFile]:
    """Return the placeholders that were made for a target, by cue and variation."""
    placeholder_files = session.scalars(
        select(PlaceholderFile).where(PlaceholderFile.project_id == project_id, PlaceholderFile.target == target)
    )
    return {
        (placeholder_file.cue_id, placeholder_file.variation): placeholder_file
        for placeholder_file in placeholder_files
    }


def placeholder_file(session: Session, cue_id: UUID, variation: int, target: str) -> PlaceholderFile | None:
    """Return the placeholder of one variation of a cue for a target."""
    return session.scalar(
        select(PlaceholderFile).where(
            PlaceholderFile.cue_id == cue_id, PlaceholderFile.variation == variation, PlaceholderFile.target == target
        )
    )


def packed_takes_of(session: Session, pack_id: UUID) -> list[tuple[str, Take]]:
    """Return the game files of a sealed pack in their order, each with its take, cue and designer."""
    rows = session.execute(
        select(PackedFile.path, Take)
        .join(Render, Render.id == PackedFile.render_id)
        .join(Take, Take.id == Render.take_id)
        .where(PackedFile.pack_id == pack_id, PackedFile.kind == FileKind.GAME)
        .options(joinedload(Take.cue), joinedload(Take.designer))
        .order_by(PackedFile.place)
    )
    return [(path, take) for path, take in rows]


def contracts_of_cues(session: Session, cue_ids: Collection[UUID]) -> Sequence[tuple[ContractCue, Contract]]:
    """Return the contracts under which cues were accepted, the newest last."""
    rows = session.execute(
        select(ContractCue, Contract)
        .join(Contract, Contract.id == ContractCue.contract_id)
        .where(in_array(ContractCue.cue_id, cue_ids), ContractCue.accepted_at.is_not(None))
        .order_by(Contract.number)
    )
    return [(covered, contract) for covered, contract in rows]


class RemarkRow(NamedTuple):
    """A change request that was sent, or a comment that is not resolved, with the file it is on."""

    cue_id: UUID | None
    file_name: str
    start_s: float | None
    author: str
    created_at: datetime
    text: str
    is_request: bool


def open_remarks(session: Session, cue_ids: Collection[UUID], designer_id: UUID) -> list[RemarkRow]:
    """Return the requests and remarks on a designer's takes of cues, change requests first, in order."""
    of_takes = (in_array(Take.cue_id, cue_ids), Take.designer_id == designer_id)
    requests = session.execute(
        select(
            Take.cue_id,
            Take.file_name,
            ChangeRequest.start_s,
            Person.name,
            ChangeRequest.created_at,
            ChangeRequest.text,
        )
        .join(ChangeRequest, ChangeRequest.take_id == Take.id)
        .join(Person, Person.id == ChangeRequest.written_by)
        .where(*of_takes, ChangeRequest.feedback_id.is_not(None))
        .order_by(ChangeRequest.id)
    ).all()
    author = func.coalesce(Person.name, literal("guest ").concat(Comment.guest_name))
    comments = session.execute(
        select(Take.cue_id, Take.file_name, Comment.start_s, author, Comment.created_at, Comment.text)
        .join(Comment, Comment.take_id == Take.id)
        .outerjoin(Person, Person.id == Comment.written_by)
        .where(*of_takes, Comment.resolved_at.is_(None))
        .order_by(Comment.id)
    ).all()
    return [RemarkRow(*row, True) for row in requests] + [RemarkRow(*row, False) for row in comments]


def in_house_designers(session: Session, project_id: UUID) -> set[UUID]:
    """Return the designers of a project who belong to the studio."""
    query = select(Engagement.designer_id).where(
        Engagement.project_id == project_id, Engagement.kind == EngagementKind.IN_HOUSE
    )
    return set(session.scalars(query))


def same_masters_elsewhere(
    session: Session, studio_id: UUID, project_id: UUID, sha256s: Collection[str]
) -> dict[str, list[str]]:
    """Return by master the names of the studio's other projects that the very same file was delivered for."""
    rows = session.execute(
        select(Take.master_sha256, Project.name)
        .join(Project, Project.id == Take.project_id)
        .where(
            Take.studio_id == studio_id,
            Take.project_id != project_id,
            in_array(Take.master_sha256, sha256s),
            Take.discarded_at.is_(None),
        )
        .distinct()
        .order_by(Project.name)
    )
    names_by_hash: dict[str, list[str]] = defaultdict(list)
    for sha256, name in rows:
        names_by_hash[sha256].append(name)
    return dict(names_by_hash)
