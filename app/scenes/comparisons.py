"""Versions against other sounds: what differs, as figures and as a track to hear."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.core.events import publish
from app.core.storage import StoredBlob
from app.deliveries.service import take_for
from app.projects.errors import ProjectNotFound
from app.projects.service import project_access
from app.renders.service import take_sounds
from app.scenes import queries
from app.scenes.errors import ComparisonNotFound, ComparisonNotMade, NothingToCompare
from app.scenes.listening import Compared
from app.scenes.models import Comparison
from app.scenes.schemas import SoundComparisonRead, SpectraRead

NO_PREVIEW = "one of the two has no preview yet"


def request_comparison(
    session: Session, actor: Actor, take_id: UUID, *, against_take_id: UUID | None, target: str | None
) -> Comparison:
    """Have a version compared with another of its project, or with its own file for a target.

    A designer compares their own version with what they may hear.
    """
    take, _ = take_for(session, actor, take_id)
    if (against_take_id is None) == (target is None):
        raise NothingToCompare("name another version or a target, one of the two")
    sound = queries.preview_of_master(session, take)
    if against_take_id is not None:
        other = queries.opened_take(session, actor, against_take_id) or take_for(session, actor, against_take_id)[0]
        if other.project_id != take.project_id:
            raise NothingToCompare("the two versions are of different projects")
        against = queries.preview_of_master(session, other)
    else:
        against = _preview_of_file(session, actor, take_id, target or "")
    if sound is None or against is None:
        raise NothingToCompare(NO_PREVIEW, fix="wait until both are drawn, then ask again")
    if sound == against:
        raise NothingToCompare("both are the same file, so nothing differs")
    same_comparison = queries.comparison_of(session, take.project_id, sound, against)
    if same_comparison is not None:
        return same_comparison
    comparison = Comparison(
        studio_id=take.studio_id, project_id=take.project_id, sound_sha256=sound, against_sha256=against
    )
    session.add(comparison)
    session.flush()
    publish(session, "comparison.asked", studio_id=take.studio_id, comparison_id=comparison.id)
    return comparison


def _preview_of_file(session: Session, actor: Actor, take_id: UUID, target: str) -> str | None:
    for render in take_sounds(session, actor, take_id).renders:
        if render.target == target and render.picture_id is not None:
            return queries.preview_of_picture(session, render.picture_id)
    return None


def visible_comparison(session: Session, actor: Actor, comparison_id: UUID) -> Comparison:
    """Return a comparison of sounds that the caller hears; raise ComparisonNotFound without sight of it."""
    comparison = queries.comparison_by_id(session, comparison_id)
    if comparison is None:
        raise ComparisonNotFound(f"no comparison {comparison_id}")
    try:
        access = project_access(session, actor, comparison.project_id)
    except ProjectNotFound:
        raise ComparisonNotFound(f"no comparison {comparison_id}") from None
    sounds = {comparison.sound_sha256, comparison.against_sha256}
    is_designer = access.only_designer_id is not None
    if is_designer and not queries.hears_previews(session, actor, comparison.project_id, sounds):
        raise ComparisonNotFound(f"no comparison {comparison_id}")
    return comparison


def file_of(comparison: Comparison) -> str:
    """Return the hash of a difference track; raise ComparisonNotMade where there is none."""
    if comparison.sha256 is None:
        raise ComparisonNotMade(comparison.refusal or "the difference track is still being made; ask again in a moment")
    return comparison.sha256


def keep(session: Session, comparison_id: UUID, blob: StoredBlob, made: Compared) -> None:
    """Put the differences on record."""
    comparison = session.get_one(Comparison, comparison_id)
    comparison.sha256, comparison.file_bytes = blob.sha256, blob.size_bytes
    comparison.lag_s, comparison.gain_db = made["lag_s"], made["gain_db"]
    comparison.residue_db = made["residue_db"]
    comparison.spectra = {
        "hz": made["hz"],
        "sound_dbfs": made["sound_dbfs"],
        "against_dbfs": made["against_dbfs"],
        "difference_dbfs": made["difference_dbfs"],
    }


def refuse(session: Session, comparison_id: UUID, reason: str) -> None:
    """Record the reason two sounds are not compared."""
    session.get_one(Comparison, comparison_id).refusal = reason


def comparison_read(comparison: Comparison) -> SoundComparisonRead:
    """Return a comparison as it is shown."""
    is_made = comparison.sha256 is not None
    return SoundComparisonRead(
        id=comparison.id,
        is_made=is_made,
        lag_s=comparison.lag_s,
        gain_db=comparison.gain_db,
        residue_db=comparison.residue_db,
        spectra=SpectraRead.model_validate(comparison.spectra) if is_made else None,
        file_url=f"/v1/comparisons/{comparison.id}/file" if is_made else None,
        refusal=comparison.refusal,
    )
