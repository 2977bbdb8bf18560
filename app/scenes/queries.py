"""The parts of a scene, read from the database; callers have checked access."""

from collections.abc import Collection, Sequence
from typing import Any, NamedTuple
from uuid import UUID

from sqlalchemy import ColumnElement, Select, and_, case, func, or_, select, union
from sqlalchemy.orm import Session, contains_eager, undefer

from app.accounts.rules import Actor
from app.builds.audits.models import AuditedSound, BuildAudit
from app.conformance.models import CheckRun
from app.core.in_array import in_array
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.references.models import Reference, ReferenceVersion
from app.references.rules import ReferenceKind
from app.renders.models import Picture, Render
from app.renders.other_sounds.queries import opened_takes
from app.scenes.models import Bed, Comparison, SceneSound
from app.scenes.rules import BedRole
from app.sound_lists.models import Cue
from app.sound_lists.rules import CueState

MOST_CANDIDATES = 300  # of which the neighbours are chosen
MOST_CLIPS = 12
MOST_SOURCES = 200


class PlayableTake(NamedTuple):
    """A take that can be played, with its cue and loudness."""

    take: Take
    cue: Cue
    picture: Picture
    loudness_lufs: float | None


def _playable(*conditions: ColumnElement[bool]) -> Select[Any]:
    measurements = CheckRun.report["measurements"]
    whole, shortest = (measurements[name].as_float() for name in ("integrated_lufs", "short_loudness_lufs"))
    drawn = and_(Picture.studio_id == Take.studio_id, Picture.sound_sha256 == Take.master_sha256)
    return (
        select(Take, Cue, Picture, func.coalesce(whole, shortest))
        .join(Cue, Cue.id == Take.cue_id)
        .join(Picture, drawn)
        .outerjoin(CheckRun, and_(CheckRun.take_id == Take.id, CheckRun.is_current))
        .where(Picture.preview_sha256.is_not(None), *conditions)
    )


def playable_take(session: Session, take_id: UUID) -> PlayableTake | None:
    """Return a take whose cue is known and that is drawn."""
    row = session.execute(_playable(Take.id == take_id)).first()
    return None if row is None else PlayableTake._make(row)


def approved_takes(session: Session, take_ids: Collection[UUID]) -> dict[UUID, PlayableTake]:
    """Return those of some takes that are approved and can be played."""
    rows = session.execute(_playable(in_array(Take.id, take_ids), Take.state == TakeState.APPROVED))
    return {row[0].id: PlayableTake._make(row) for row in rows}


def possible_neighbours(session: Session, of: Cue, scene: tuple[str, str] | None) -> list[PlayableTake]:
    """Return approved sounds near a cue, one for each other cue: those of its scene and category first."""
    close = Cue.category == of.category
    if scene is not None:
        column, value = scene
        close = or_(Cue.extra[column].as_string() == value, close)
    rows = session.execute(
        _playable(Cue.project_id == of.project_id, Cue.id != of.id, Cue.state != CueState.CUT)
        .where(Take.state == TakeState.APPROVED)
        .order_by(case((close, 0), else_=1), func.abs(Cue.position - of.position), Cue.id, Take.variation)
        .limit(MOST_CANDIDATES)
    )
    first: dict[UUID, PlayableTake] = {}
    for row in rows:
        first.setdefault(row[1].id, PlayableTake._make(row))
    return list(first.values())


def newest_audit(session: Session, project_id: UUID) -> BuildAudit | None:
    """Return the newest audit of a project's builds."""
    query = select(BuildAudit).where(BuildAudit.project_id == project_id)
    return session.scalar(query.order_by(BuildAudit.id.desc()).limit(1))


def gains_in_game(session: Session, audit_id: UUID, cue_ids: Collection[UUID]) -> dict[UUID, float]:
    """Return the gain at which an audited build plays cues against what was approved; of several the loudest."""
    rows = session.execute(
        select(AuditedSound.cue_id, func.max(AuditedSound.gain_db))
        .where(
            AuditedSound.audit_id == audit_id,
            AuditedSound.gain_db.is_not(None),
            in_array(AuditedSound.cue_id, cue_ids),
        )
        .group_by(AuditedSound.cue_id)
    )
    return {cue_id: gain_db for cue_id, gain_db in rows if cue_id is not None and gain_db is not None}


def beds(session: Session, project_id: UUID, category: str) -> dict[BedRole, Bed]:
    """Return the beds under the sounds of a category: its own, and for other roles those of the project."""
    takes = session.scalars(
        select(Bed).where(Bed.project_id == project_id, Bed.category.in_(("", category))).order_by(Bed.category)
    )
    return {bed.role: bed for bed in takes}  # the project's come first, and a category's replace them


def bed_of(session: Session, project_id: UUID, category: str, role: BedRole) -> Bed | None:
    """Return one bed."""
    return session.scalar(
        select(Bed).where(Bed.project_id == project_id, Bed.category == category, Bed.role == role).with_for_update()
    )


def bed_by_id(session: Session, bed_id: UUID) -> Bed | None:
    """Return a bed without a check of the caller."""
    return session.get(Bed, bed_id)


def lock_beds(session: Session, project_id: UUID) -> None:
    """Let changes of a project's beds come one after the other."""
    session.execute(select(Cue.id).where(Cue.project_id == project_id).order_by(Cue.id).limit(1).with_for_update())


def _references(kind: ReferenceKind, project_id: UUID) -> Select[ReferenceVersion]:
    newest = and_(Reference.id == ReferenceVersion.reference_id, Reference.newest_number == ReferenceVersion.number)
    return (
        select(ReferenceVersion)
        .join(Reference, newest)
        .options(contains_eager(ReferenceVersion.reference))
        .where(Reference.project_id == project_id, Reference.removed_at.is_(None), ReferenceVersion.kind == kind.value)
    )


def sound_references(
    session: Session, project_id: UUID, reference_ids: Collection[UUID]
) -> dict[UUID, ReferenceVersion]:
    """Return the newest versions of references that are sounds and on the board, by reference."""
    query = _references(ReferenceKind.AUDIO, project_id).where(in_array(Reference.id, reference_ids))
    return {version.reference_id: version for version in session.scalars(query)}


def clips(session: Session, cue: Cue) -> Sequence[ReferenceVersion]:
    """Return the clips of a cue, then those of its category, then those of the whole project, the newest first."""
    nearness = case((Reference.cue_id == cue.id, 0), (Reference.category.is_not(None), 1), else_=2)
    whole = and_(Reference.cue_id.is_(None), Reference.category.is_(None))
    return session.scalars(
        _references(ReferenceKind.VIDEO, cue.project_id)
        .where(or_(Reference.cue_id == cue.id, Reference.category == cue.category, whole))
        .order_by(nearness, Reference.id.desc())
        .limit(MOST_CLIPS)
    ).all()


def bed_takes(session: Session, project_id: UUID) -> list[tuple[Take, Cue]]:
    """Return the approved takes of a project, loops first, one for each cue."""
    rows = session.execute(
        select(Take, Cue)
        .join(Cue, Cue.id == Take.cue_id)
        .where(Take.project_id == project_id, Take.state == TakeState.APPROVED, Cue.state != CueState.CUT)
        .order_by(Cue.loop.desc(), Cue.position, Cue.number, Take.variation)
        .limit(MOST_SOURCES)
    )
    first: dict[UUID, tuple[Take, Cue]] = {}
    for take, cue in rows:
        first.setdefault(cue.id, (take, cue))
    return list(first.values())


def bed_references(session: Session, project_id: UUID) -> Sequence[ReferenceVersion]:
    """Return the sounds on the references board, the newest first."""
    query = _references(ReferenceKind.AUDIO, project_id).order_by(Reference.id.desc()).limit(MOST_SOURCES)
    return session.scalars(query).all()


def scene_sounds(
    session: Session, studio_id: UUID, sha256s: Collection[str], *, measured: bool = False
) -> dict[tuple[str, str], SceneSound]:
    """Return the measurements of stored sounds, by hash and part; with their excitations where asked."""
    query = select(SceneSound).where(SceneSound.studio_id == studio_id, in_array(SceneSound.sound_sha256, sha256s))
    if measured:
        query = query.options(undefer(SceneSound.excitation))
    return {(sound.sound_sha256, sound.part): sound for sound in session.scalars(query)}


def scene_sound_by_id(session: Session, scene_sound_id: UUID) -> SceneSound | None:
    """Return a sound of scenes without a check of the caller."""
    return session.get(SceneSound, scene_sound_id)


def version_of_sound(session: Session, sound: SceneSound) -> Sequence[ReferenceVersion]:
    """Return the versions of references on the board whose file a sound was made of."""
    return session.scalars(
        select(ReferenceVersion)
        .join(Reference, Reference.id == ReferenceVersion.reference_id)
        .options(contains_eager(ReferenceVersion.reference))
        .where(
            ReferenceVersion.studio_id == sound.studio_id,
            ReferenceVersion.sha256 == sound.sound_sha256,
            Reference.removed_at.is_(None),
        )
        .order_by(ReferenceVersion.id.desc())
    ).all()


def comparison_by_id(session: Session, comparison_id: UUID) -> Comparison | None:
    """Return a comparison without a check of the caller."""
    return session.get(Comparison, comparison_id)


def comparison_of(session: Session, project_id: UUID, sound_sha256: str, against_sha256: str) -> Comparison | None:
    """Return the comparison of two sounds."""
    return session.scalar(
        select(Comparison).where(
            Comparison.project_id == project_id,
            Comparison.sound_sha256 == sound_sha256,
            Comparison.against_sha256 == against_sha256,
        )
    )


def preview_of_master(session: Session, take: Take) -> str | None:
    """Return the hash of what plays a take's master; None while it is not drawn."""
    return session.scalar(
        select(Picture.preview_sha256).where(
            Picture.studio_id == take.studio_id, Picture.sound_sha256 == take.master_sha256
        )
    )


def opened_take(session: Session, actor: Actor, take_id: UUID) -> Take | None:
    """Return a take of another designer that its project lets the caller hear."""
    return session.scalar(select(Take).where(Take.id == take_id, opened_takes(actor)))


def hears_previews(session: Session, actor: Actor, project_id: UUID, sha256s: Collection[str]) -> bool:
    """Whether a designer may hear all of some previews: of their own takes and game files, and of opened takes."""
    heard = or_(Take.designer_id == actor.person_id, opened_takes(actor))
    same_studio = Picture.studio_id == Take.studio_id
    of_takes = (
        select(Picture.preview_sha256)
        .join(Take, and_(same_studio, Picture.sound_sha256 == Take.master_sha256))
        .where(Take.project_id == project_id, heard)
    )
    of_files = (
        select(Picture.preview_sha256)
        .join(Render, and_(Picture.studio_id == Render.studio_id, Picture.sound_sha256 == Render.sha256))
        .join(Take, Take.id == Render.take_id)
        .where(Take.project_id == project_id, Take.designer_id == actor.person_id)
    )
    listed = [query.where(in_array(Picture.preview_sha256, sha256s)) for query in (of_takes, of_files)]
    return set(session.scalars(union(*listed))) >= set(sha256s)


def preview_of_picture(session: Session, picture_id: UUID) -> str | None:
    """Return the hash of what plays a drawn sound."""
    return session.scalar(select(Picture.preview_sha256).where(Picture.id == picture_id))
