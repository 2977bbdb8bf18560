"""Adoptions: opened with a list of files, planned, and sent the files; reviews make them cues and approved takes."""

import dataclasses
from collections import Counter
from collections.abc import Sequence
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

import audio_checks
from app.accounts.rules import Actor
from app.accounts.schemas import PersonBrief
from app.deliveries.adoptions import queries
from app.deliveries.adoptions.game_projects import plays_by_path, project_of
from app.deliveries.adoptions.schemas import (
    AdoptionOpened,
    AdoptionPlanRead,
    AdoptionRead,
    PlannedCue,
    ReadProject,
    ShippedFileIn,
)
from app.deliveries.errors import AdoptionClosed, AdoptionNotFound, PathTwice
from app.deliveries.models import Adoption
from app.projects.errors import ApproverNeeded, ProjectNotFound
from app.projects.models import Project
from app.projects.queries import current_spec
from app.projects.service import ProjectAccess, project_access
from app.sound_lists.rules import label

Game = dict[str, Any]  # a game's project as game_projects.plain_project has it
SCOPE = "adoption:"  # of uploads, before the id of their adoption


def plan_folder(
    session: Session, actor: Actor, project_id: UUID, files: Sequence[ShippedFileIn], game: Game | None
) -> AdoptionPlanRead:
    """Return the effects of adopting a folder; nothing is written."""
    access = project_access(session, actor, project_id)
    ensure_may_send(access)
    _ensure_paths_differ(files)
    return plan_read(plan_for(session, access.project, [file.model_dump() for file in files], game), game)


def plan_for(
    session: Session, project: Project, files: Sequence[dict[str, Any]], game: Game | None
) -> audio_checks.AdoptionPlan:
    """Return the effects of adopting files on a list as it is now."""
    owned = {stem: label(project.cue_prefix, number) for stem, number in queries.owned_stems(session, project.id)}
    spec = audio_checks.parse_spec(current_spec(session, project.id).toml)
    shipped = [
        audio_checks.ShippedFile(file["path"], file["sha256"], file["sample_rate_hz"], file["bit_depth"])
        for file in files
    ]
    return audio_checks.plan_adoption(
        shipped, owned=owned, categories=spec.categories, project=project_of(game) if game else None
    )


def open_adoption(
    session: Session,
    actor: Actor,
    project_id: UUID,
    *,
    folder: str,
    files: Sequence[ShippedFileIn],
    game: Game | None = None,
) -> AdoptionOpened:
    """Open an adoption, to which its files are uploaded; the list stays as it is until it is adopted."""
    access = project_access(session, actor, project_id)
    ensure_may_send(access)
    _ensure_paths_differ(files)
    adoption = Adoption(
        studio_id=access.project.studio_id,
        project_id=project_id,
        folder=folder,
        files=[file.model_dump() for file in files],
        game=game,
        opened_by=actor.person_id,
    )
    session.add(adoption)
    session.flush()
    session.refresh(adoption, ["adopter"])
    return opened_adoption(session, access, adoption)


def opened_adoption(session: Session, access: ProjectAccess, adoption: Adoption) -> AdoptionOpened:
    """Return an adoption with its plan against the list as it is now, and what is still to be uploaded."""
    plan = plan_for(session, access.project, adoption.files, adoption.game)
    missing = missing_files(plan, adoption, queries.finished_uploads(session, adoption.studio_id, scope_of(adoption)))
    return AdoptionOpened(**adoption_read(adoption).model_dump(), plan=plan_read(plan, adoption.game), missing=missing)


def missing_files(
    plan: audio_checks.AdoptionPlan, adoption: Adoption, uploaded: dict[str, tuple[UUID, int]]
) -> list[str]:
    """Return one path of each content that a plan adopts and that is not uploaded."""
    hashes = {file["path"]: file["sha256"] for file in adoption.files}
    wanted = {hashes[path]: path for cue in reversed(plan.cues) for path in reversed(cue.paths)}
    return sorted(path for sha256, path in wanted.items() if sha256 not in uploaded)


def adoption_for(
    session: Session, actor: Actor, adoption_id: UUID, *, locked: bool = False
) -> tuple[Adoption, ProjectAccess]:
    """Return an adoption within the caller's sight, and what the caller is in its project."""
    adoption = queries.adoption_by_id(session, adoption_id, locked=locked)
    if adoption is None:
        raise AdoptionNotFound(f"no adoption {adoption_id}")
    try:
        access = project_access(session, actor, adoption.project_id)
    except ProjectNotFound:
        raise AdoptionNotFound(f"no adoption {adoption_id}") from None
    return adoption, access


def adoptions_of(session: Session, actor: Actor, project_id: UUID) -> Sequence[Adoption]:
    """Return the adoptions of a project, the newest first."""
    project_access(session, actor, project_id).ensure_team()
    return queries.adoptions_of(session, project_id)


def ensure_may_adopt(access: ProjectAccess) -> None:
    """Raise ApproverNeeded unless the caller may approve a whole folder: a producer, or the project's approver."""
    if not (access.is_producer or access.is_approver):
        raise ApproverNeeded("only a producer or the project's approver can adopt a folder")


def ensure_may_send(access: ProjectAccess) -> None:
    """Raise ApproverNeeded unless the caller may send a folder to adopt: those who may adopt it, or a build."""
    if not access.actor.is_build:
        ensure_may_adopt(access)


def ensure_may_send_to(session: Session, actor: Actor, project_id: UUID) -> None:
    """Raise unless the caller may send a folder to this project."""
    ensure_may_send(project_access(session, actor, project_id))


def scope_of(adoption: Adoption) -> str:
    """Return the scope of the uploads of an adoption."""
    return f"{SCOPE}{adoption.id}"


def ensure_may_upload(session: Session, actor: Actor, adoption_id: UUID) -> UUID:
    """Return the studio of an open adoption; raise unless the caller may send files to it."""
    adoption, access = adoption_for(session, actor, adoption_id)
    ensure_may_send(access)
    if adoption.adopted_at is not None:
        raise AdoptionClosed("this folder is adopted already", fix="open another adoption for more files")
    return adoption.studio_id


def ensure_may_continue(session: Session, actor: Actor, scope: str) -> None:
    """Raise unless the caller may still send files to the adoption of a scope."""
    ensure_may_upload(session, actor, UUID(scope.removeprefix(SCOPE)))


def adoption_read(adoption: Adoption) -> AdoptionRead:
    """Return an adoption as it is shown."""
    return AdoptionRead(
        id=adoption.id,
        project_id=adoption.project_id,
        folder=adoption.folder,
        created_at=adoption.created_at,
        adopted_by=PersonBrief.model_validate(adoption.adopter) if adoption.adopter else None,
        adopted_at=adoption.adopted_at,
        undone_at=adoption.undone_at,
    )


def plan_read(plan: audio_checks.AdoptionPlan, game: Game | None) -> AdoptionPlanRead:
    """Return a plan as it is shown."""
    played = plays_by_path(game, [path for cue in plan.cues for path in cue.paths]) if game else {}
    return AdoptionPlanRead(
        cues=[PlannedCue(**dataclasses.asdict(cue)) for cue in plan.cues],
        files=sum(len(cue.paths) for cue in plan.cues),
        sets=sum(len(cue.paths) > 1 for cue in plan.cues),
        categories=dict(sorted(Counter(cue.category for cue in plan.cues).items())),
        duplicates=[list(paths) for paths in plan.duplicates],
        oddities=[oddity._asdict() for oddity in plan.oddities],
        skipped=[skipped_file._asdict() for skipped_file in plan.skipped],
        project=ReadProject(**{key: game[key] for key in game if key != "sounds"}, played=len(played))
        if game
        else None,
    )


def _ensure_paths_differ(files: Sequence[ShippedFileIn]) -> None:
    [(path, count)] = Counter(file.path for file in files).most_common(1)
    if count > 1:
        raise PathTwice(f"{path} is in the list of files {count} times; name each file once")
