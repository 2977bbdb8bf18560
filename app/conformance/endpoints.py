"""The endpoints of this room."""

from typing import Any
from uuid import UUID

from fastapi import APIRouter, Response

import audio_checks
from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.conformance import fixes, previews, service, splits
from app.conformance.errors import (
    CheckNotFound,
    FixNotReady,
    NothingToFix,
    NothingToSplit,
    NothingToWaive,
    PartsMisplaced,
    SplitNotReady,
)
from app.conformance.schemas import (
    CheckDescription,
    CheckPreview,
    CheckPreviewed,
    CheckRead,
    FixOffer,
    FixRead,
    SplitAsk,
    SplitOffer,
    SplitRead,
    SplitUse,
    WaiverAdd,
)
from app.core.web.http import DbSession, problems
from app.deliveries.errors import MasterDeleted, OwnDesignerNeeded, TakeNotFound, VariationUnknown, WrongState
from app.deliveries.schemas import TakeRead, TrayActionRead
from app.deliveries.service import read_take, take_for
from app.deliveries.tray.service import tray_action_read
from app.projects.errors import ApproverNeeded, ProjectNotFound, TeamNeeded
from app.sound_lists.errors import CueNotFound

router = APIRouter(prefix="/v1", tags=["conformance"])
SAME_TAKE: dict[int | str, dict[str, Any]] = {
    200: {"model": TakeRead, "description": "The fix was used before; this is its take."}
}


@router.get("/checks")
def list_checks(_actor: Actor = allows(Audience.ANYONE)) -> list[CheckDescription]:
    """List the checks of this server in the order of reports: how forms show them, and what a spec may state."""
    return [CheckDescription.model_validate(check) for check in audio_checks.all_checks().values()]


@router.post(
    "/projects/{project_id}/check-preview",
    response_model=CheckPreviewed,
    responses=problems(ProjectNotFound, TeamNeeded, CueNotFound, VariationUnknown),
)
def preview_checks(
    project_id: UUID, body: CheckPreview, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> CheckPreviewed:
    """State the rules for files before they are sent, and the faults of their names; nothing is kept."""
    return previews.preview_checks(session, actor, project_id, body)


@router.get("/takes/{take_id}/check", response_model=CheckRead, responses=problems(TakeNotFound, CheckNotFound))
def see_check(take_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> CheckRead:
    """Return the newest check of a take."""
    return service.check_for(session, actor, take_id)


@router.post(
    "/takes/{take_id}/waiver",
    status_code=201,
    response_model=CheckRead,
    responses=problems(TakeNotFound, ApproverNeeded, NothingToWaive),
)
def waive_findings(
    take_id: UUID, body: WaiverAdd, session: DbSession, actor: Actor = allows(Audience.APPROVER)
) -> CheckRead:
    """Let a returned take through with its findings, for a reason."""
    return service.waive(session, actor, take_id, body.reason)


@router.post(
    "/takes/{take_id}/recheck",
    status_code=202,
    response_model=TakeRead,
    responses=problems(TakeNotFound, WrongState),
)
def recheck_take(take_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> TakeRead:
    """Have a take that is not decided upon checked again."""
    take = service.recheck(session, actor, take_id)
    _, access = take_for(session, actor, take_id)
    return read_take(session, access.project, take)


@router.get("/projects/{project_id}/fixes", response_model=list[FixOffer], responses=problems(ProjectNotFound))
def list_fixes(project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> list[FixOffer]:
    """List the takes of which a fix would be enough, longest waiting first; a designer's own."""
    return fixes.fixes_offered(session, actor, project_id)


@router.get("/takes/{take_id}/fix", response_model=FixRead, responses=problems(TakeNotFound))
def see_fix(take_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> FixRead:
    """Show a fix's possible or past effect on a take."""
    return fixes.fix_for(session, actor, take_id)


@router.post(
    "/takes/{take_id}/fix",
    status_code=202,
    response_model=FixRead,
    responses=problems(TakeNotFound, OwnDesignerNeeded, MasterDeleted, NothingToFix),
)
def request_fix(take_id: UUID, session: DbSession, actor: Actor = allows(Audience.DESIGNER)) -> FixRead:
    """Request a fixed copy, to see and play before it is used."""
    return fixes.request_fix(session, actor, take_id)


@router.post(
    "/takes/{take_id}/fix/use",
    status_code=201,
    response_model=TakeRead,
    responses=SAME_TAKE | problems(TakeNotFound, OwnDesignerNeeded, NothingToFix, FixNotReady),
)
def use_fix(
    take_id: UUID, response: Response, session: DbSession, actor: Actor = allows(Audience.DESIGNER)
) -> TakeRead:
    """Make the fixed copy a new version, with the consent of its designer; no round counts."""
    made, already_here, access = fixes.use_fix(session, actor, take_id)
    response.status_code = 200 if already_here else 201
    return read_take(session, access.project, made).model_copy(update={"already_here": already_here})


@router.get("/projects/{project_id}/splits", response_model=list[SplitOffer], responses=problems(ProjectNotFound))
def list_splits(project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> list[SplitOffer]:
    """List the files that hold several sounds, longest waiting first; a designer's own."""
    return splits.splits_offered(session, actor, project_id)


@router.get("/takes/{take_id}/split", response_model=SplitRead, responses=problems(TakeNotFound))
def see_split(take_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> SplitRead:
    """Show the parts of a file, and the file that a take was itself cut from."""
    return splits.split_for(session, actor, take_id)


@router.post(
    "/takes/{take_id}/split",
    status_code=202,
    response_model=SplitRead,
    responses=problems(TakeNotFound, OwnDesignerNeeded, MasterDeleted, NothingToSplit),
)
def request_split(
    take_id: UUID, body: SplitAsk, session: DbSession, actor: Actor = allows(Audience.DESIGNER)
) -> SplitRead:
    """Have the parts of a file found, to see before they become variations."""
    return splits.request_split(session, actor, take_id, body)


@router.post(
    "/takes/{take_id}/split/use",
    status_code=201,
    response_model=TrayActionRead,
    responses=problems(
        *(TakeNotFound, OwnDesignerNeeded, MasterDeleted, NothingToSplit, SplitNotReady),
        *(PartsMisplaced, CueNotFound, VariationUnknown),
    ),
)
def use_split(
    take_id: UUID, body: SplitUse, session: DbSession, actor: Actor = allows(Audience.DESIGNER)
) -> TrayActionRead:
    """Make the parts of a file versions of a cue's variations; the file is discarded and kept, and it can be undone."""
    return tray_action_read(splits.use_split(session, actor, take_id, body))
