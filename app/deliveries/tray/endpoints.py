"""The endpoints for many takes at once."""

from collections.abc import Sequence
from uuid import UUID

from fastapi import APIRouter

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.web.http import DbSession, problems
from app.deliveries.errors import AlreadyUndone, TakeNotFound, TrayActionNotFound, VariationUnknown, WrongState
from app.deliveries.models import Take
from app.deliveries.schemas import (
    CueBrief,
    SureAccept,
    TakeRename,
    TakesMove,
    TakesNamed,
    TrayActionRead,
    TrayActionUndone,
    UndecidedPlace,
    UndecidedTake,
)
from app.deliveries.tray import service as tray
from app.deliveries.tray.service import Move, tray_action_read
from app.projects.errors import ProjectNotFound, TeamNeeded
from app.projects.models import Project
from app.projects.service import project_access
from app.sound_lists.errors import CueNotFound
from app.sound_lists.rules import label

router = APIRouter()


@router.post(
    "/projects/{project_id}/takes/accept-sure",
    response_model=TrayActionRead,
    responses=problems(ProjectNotFound, TeamNeeded),
)
def accept_sure_matches(
    project_id: UUID, body: SureAccept, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> TrayActionRead:
    """Match the files of the tray whose names are sure; a designer's own. Guesses stay where they are."""
    return tray_action_read(tray.accept_sure(session, actor, project_id, body.take_ids))


@router.post(
    "/projects/{project_id}/takes/move",
    response_model=TrayActionRead,
    responses=problems(ProjectNotFound, TakeNotFound, CueNotFound, TeamNeeded, WrongState, VariationUnknown),
)
def move_takes(
    project_id: UUID, body: TakesMove, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> TrayActionRead:
    """Move takes to other cues or variations, all or none, before any verdict; each is checked again there."""
    return tray_action_read(tray.move_takes(session, actor, project_id, _moves(body)))


@router.get(
    "/projects/{project_id}/takes/undecided",
    response_model=list[UndecidedPlace],
    responses=problems(ProjectNotFound),
)
def list_undecided_places(
    project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> list[UndecidedPlace]:
    """List sounds for which one delivery has several files between which nobody chose; a designer's own.

    To decide, discard all but one, move one to its own cue, or move it with `as_alternate`.
    """
    project = project_access(session, actor, project_id).project
    return [_undecided_read(project, takes) for takes in tray.undecided_places(session, actor, project_id)]


@router.post(
    "/projects/{project_id}/takes/rename-preview",
    response_model=list[TakeRename],
    responses=problems(ProjectNotFound, TakeNotFound, CueNotFound, TeamNeeded, VariationUnknown),
)
def preview_renames(
    project_id: UUID, body: TakesMove, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> list[TakeRename]:
    """Show the names of takes after a move; nothing is changed."""
    named = tray.names_after(session, actor, project_id, _moves(body))
    return [TakeRename(take_id=take.id, file_name=take.file_name, becomes=becomes) for take, becomes in named]


@router.post(
    "/projects/{project_id}/takes/discard",
    response_model=TrayActionRead,
    responses=problems(ProjectNotFound, TakeNotFound, TeamNeeded, WrongState),
)
def discard_takes(
    project_id: UUID, body: TakesNamed, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> TrayActionRead:
    """Take files out of the list and the tray, all or none, before any verdict; their masters are kept."""
    return tray_action_read(tray.discard_takes(session, actor, project_id, body.take_ids))


@router.post(
    "/projects/{project_id}/takes/restore",
    response_model=TrayActionRead,
    responses=problems(ProjectNotFound, TakeNotFound, TeamNeeded),
)
def restore_takes(
    project_id: UUID, body: TakesNamed, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> TrayActionRead:
    """Put discarded takes back into the tray."""
    return tray_action_read(tray.restore_takes(session, actor, project_id, body.take_ids))


@router.post(
    "/tray-actions/{tray_action_id}/undo",
    response_model=TrayActionUndone,
    responses=problems(TrayActionNotFound, AlreadyUndone, TeamNeeded),
)
def undo_tray_action(
    tray_action_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> TrayActionUndone:
    """Put takes back where they were before an action; those that were touched since stay."""
    action, moved_back, left = tray.undo(session, actor, tray_action_id)
    return TrayActionUndone(**tray_action_read(action).model_dump(), moved_back=moved_back, left=left)


def _moves(body: TakesMove) -> list[Move]:
    return [Move(move.take_id, move.cue_id, move.variation, bool(move.as_alternate)) for move in body.moves]


def _undecided_read(project: Project, takes: Sequence[Take]) -> UndecidedPlace:
    first = takes[0]
    if first.cue is None:
        raise AssertionError("only matched takes have a place")
    return UndecidedPlace(
        delivery_id=first.delivery_id,
        cue=CueBrief(id=first.cue.id, label=label(project.cue_prefix, first.cue.number), name=first.cue.name),
        variation=first.variation,
        alternate=first.alternate,
        takes=[UndecidedTake.model_validate(take) for take in takes],
    )
