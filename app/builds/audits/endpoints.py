"""The endpoints of audits of game builds: posted by CI, shown on the builds page, drift accepted or sent back."""

from typing import Annotated
from uuid import UUID

from fastapi import APIRouter, Query

from app.accounts.rules import Actor, Audience, Scope
from app.accounts.web.policies import allows
from app.builds.audits import game_states
from app.builds.audits import service as audits
from app.builds.audits.schemas import (
    MAX_PATH_CHARS,
    AcceptedDriftRead,
    AuditAdd,
    AuditedSoundRead,
    AuditRead,
    AuditSummary,
    CueMarking,
    DriftAccept,
    GameStates,
    SoundInBuild,
    SoundSendBack,
)
from app.builds.errors import (
    AcceptedDriftNotFound,
    AuditedSoundNotFound,
    AuditNotFound,
    ImplementerNeeded,
    NothingDrifted,
)
from app.builds.listening import tasks as game_tasks
from app.builds.listening.schemas import GameTaskRead
from app.core.web.bodies import REPORT_BODY_BYTES, accepts_body
from app.core.web.http import BadCursor, DbSession, Page, cursor_of, number_cursor, problems, uuid_cursor
from app.projects.errors import ProjectNotFound, TeamNeeded
from app.sound_lists.errors import CueNotFound

router = APIRouter(prefix="/v1", tags=["audits"])
TEAM: Actor = allows(Audience.TEAM)
PAGE = 50
SOUNDS_PAGE = 200


@router.post(
    "/projects/{project_id}/audits",
    status_code=201,
    response_model=AuditSummary,
    responses=problems(ProjectNotFound, TeamNeeded),
)
@accepts_body(REPORT_BODY_BYTES)
def post_audit(
    project_id: UUID,
    body: AuditAdd,
    session: DbSession,
    actor: Actor = allows(Audience.TEAM, build=Scope.CHECKS_WRITE),
) -> AuditSummary:
    """Store the results of `audio-checks audit` on each sound of a build."""
    return AuditSummary.model_validate(audits.save_audit(session, actor, project_id, body))


@router.get("/projects/{project_id}/audits", responses=problems(ProjectNotFound, TeamNeeded, BadCursor))
def list_audits(
    project_id: UUID, session: DbSession, cursor: str | None = None, actor: Actor = TEAM
) -> Page[AuditSummary]:
    """Return the audits of a project, the newest first."""
    page_rows = audits.audits_in(session, actor, project_id, before=uuid_cursor(cursor), limit=PAGE + 1)
    return Page(
        items=[AuditSummary.model_validate(audit) for audit in page_rows[:PAGE]],
        next=cursor_of(page_rows[PAGE - 1].id) if len(page_rows) > PAGE else None,
    )


@router.get("/audits/{audit_id}", responses=problems(AuditNotFound, TeamNeeded))
def get_audit(audit_id: UUID, session: DbSession, actor: Actor = TEAM) -> AuditRead:
    """Return one audit, counted, with the files of the game's project that could not be read."""
    _, audit = audits.visible_audit(session, actor, audit_id)
    return audits.read_audit(session, audit)


@router.get("/audits/{audit_id}/sounds", responses=problems(AuditNotFound, TeamNeeded, BadCursor))
def list_audited_sounds(
    audit_id: UUID,
    session: DbSession,
    drifted: Annotated[bool, Query(description="Only those that are not as approved.")] = False,
    cursor: str | None = None,
    actor: Actor = TEAM,
) -> Page[AuditedSoundRead]:
    """Return an audit's results on its sounds, in its order."""
    access, audit = audits.visible_audit(session, actor, audit_id)
    after = number_cursor(cursor)
    rows = audits.sounds_in(session, audit, drifted_only=drifted, after=after, limit=SOUNDS_PAGE + 1)
    shown = rows[:SOUNDS_PAGE]
    return Page(
        items=audits.read_sounds(session, access, audit, shown),
        next=cursor_of(shown[-1].place) if len(rows) > SOUNDS_PAGE else None,
    )


@router.get("/projects/{project_id}/sound-history", responses=problems(ProjectNotFound, TeamNeeded))
def list_sound_history(
    project_id: UUID,
    session: DbSession,
    path: Annotated[str, Query(max_length=MAX_PATH_CHARS, description="Of the sound in the build.")] = "",
    actor: Actor = TEAM,
) -> list[SoundInBuild]:
    """Return the results of the last 40 builds on one sound, the newest first."""
    return audits.history_of(session, actor, project_id, path)


@router.post(
    "/audits/{audit_id}/accepted-drifts",
    status_code=201,
    responses=problems(AuditNotFound, TeamNeeded, AuditedSoundNotFound, NothingDrifted),
)
def accept_drift(audit_id: UUID, body: DriftAccept, session: DbSession, actor: Actor = TEAM) -> AcceptedDriftRead:
    """Accept the drift of a sound, with a reason, until it drifts otherwise."""
    return audits.accept_drift(session, actor, audit_id, path=body.path, reason=body.reason)


@router.get("/projects/{project_id}/accepted-drifts", responses=problems(ProjectNotFound, TeamNeeded))
def list_accepted_drifts(project_id: UUID, session: DbSession, actor: Actor = TEAM) -> list[AcceptedDriftRead]:
    """Return the accepted drifts of a project with their reasons, the newest first."""
    return audits.acceptances_in(session, actor, project_id)


@router.delete(
    "/accepted-drifts/{accepted_drift_id}", status_code=204, responses=problems(AcceptedDriftNotFound, TeamNeeded)
)
def withdraw_accepted_drift(accepted_drift_id: UUID, session: DbSession, actor: Actor = TEAM) -> None:
    """Accept a drift no longer; the record of it stays."""
    audits.withdraw_acceptance(session, actor, accepted_drift_id)


@router.post(
    "/audits/{audit_id}/tasks",
    status_code=201,
    responses=problems(AuditNotFound, TeamNeeded, AuditedSoundNotFound, NothingDrifted),
)
def send_sound_back(audit_id: UUID, body: SoundSendBack, session: DbSession, actor: Actor = TEAM) -> GameTaskRead:
    """Ask the implementers to bring a sound back to what was approved."""
    access, task = audits.send_back(session, actor, audit_id, path=body.path, text=body.text)
    (read,) = game_tasks.read_tasks(session, access, [task])
    return read


@router.get("/projects/{project_id}/game-states", responses=problems(ProjectNotFound, TeamNeeded))
def get_game_states(project_id: UUID, session: DbSession, actor: Actor = TEAM) -> GameStates:
    """Return the number of cues in the build and of those heard in the game, and the cues never heard."""
    return game_states.game_states(session, actor, project_id)


@router.put("/cues/{cue_id}/game-state", responses=problems(CueNotFound, TeamNeeded, ImplementerNeeded))
def mark_cue_in_game(cue_id: UUID, body: CueMarking, session: DbSession, actor: Actor = TEAM) -> GameStates:
    """Set by hand that a cue is in the build or was heard in the game, or take that back."""
    return game_states.mark_cue(session, actor, cue_id, mark=body.mark, is_set=body.is_set)
