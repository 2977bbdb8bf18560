"""The joining screens, read only."""

from typing import Annotated
from uuid import UUID

from fastapi import APIRouter, Query, Response

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.web.downloads import downloads, file_response
from app.core.web.http import BadCursor, CurrentRuntime, DbSession, Page, problems
from app.dashboards import schemas, service
from app.dashboards.desk.own_desk import own_desk
from app.dashboards.desk.own_desk_schemas import OwnDesk
from app.dashboards.desk.reaper_project import reaper_project_of
from app.dashboards.desk.service import Desk
from app.dashboards.own_projects.schemas import OwnProject
from app.dashboards.own_projects.service import own_projects
from app.dashboards.phases import service as phases_service
from app.dashboards.phases.schemas import PhasesRead
from app.dashboards.progress import service as progress
from app.dashboards.search import schemas as finding_schemas
from app.dashboards.search import service as finding
from app.dashboards.steps import service as next_steps
from app.dashboards.steps.schemas import NextSteps
from app.dashboards.track_record.schemas import WorkFigures
from app.dashboards.track_record.service import own_work
from app.dashboards.velocity.schemas import Pace
from app.dashboards.velocity.service import pace
from app.projects.errors import DesignerNeeded, ProjectNotFound, TeamNeeded
from app.sound_lists.endpoints import PageLength
from app.sound_lists.rules import PAGE

REAPER = "application/x-reaper"
router = APIRouter(prefix="/v1", tags=["dashboards"])


@router.get("/me")
def read_me(session: DbSession, runtime: CurrentRuntime, actor: Actor = allows(Audience.PERSON)) -> schemas.Me:
    """Return the person signed in, and everything they can open."""
    return service.me(session, actor, has_contracts=runtime.settings.commercial)


@router.get("/projects/{project_id}/sound-list/progress", responses=problems(ProjectNotFound, BadCursor))
def read_list_progress(
    project_id: UUID,
    session: DbSession,
    cursor: str | None = None,
    limit: PageLength = PAGE,
    actor: Actor = allows(Audience.PROJECT),
) -> schemas.ListProgress:
    """Return the state of the cues of one page of the list; a designer sees their own takes only.

    Pages and cursors are those of the sound list itself.
    """
    return progress.list_progress(session, actor, project_id, cursor=cursor, limit=limit)


@router.get("/projects/{project_id}/sound-list/counts", responses=problems(ProjectNotFound))
def read_list_counts(
    project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> schemas.ListCounts:
    """Return the numbers of cues by state, of the whole list; a designer's view is of their own takes."""
    return progress.list_counts(session, actor, project_id)


@router.get("/projects/{project_id}/judged-lately", responses=problems(ProjectNotFound, TeamNeeded))
def read_recent_verdicts(
    project_id: UUID, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> list[schemas.RecentVerdict]:
    """Return the cues that were decided upon within a week, the newest first."""
    return progress.recent_verdicts(session, actor, project_id)


@router.get("/projects/{project_id}/today", responses=problems(ProjectNotFound, TeamNeeded))
def read_today(project_id: UUID, session: DbSession, actor: Actor = allows(Audience.TEAM)) -> schemas.Today:
    """Return the team's waiting matters today, besides the review queue."""
    return service.today(session, actor, project_id)


@router.get("/projects/{project_id}/next-steps", responses=problems(ProjectNotFound))
def read_next_steps(
    project_id: UUID, session: DbSession, runtime: CurrentRuntime, actor: Actor = allows(Audience.PROJECT)
) -> NextSteps:
    """Return the caller's next steps in a project, the first thing first, and the people they wait for."""
    return next_steps.next_steps(session, actor, project_id, has_contracts=runtime.settings.commercial)


@router.get("/projects/{project_id}/phases", responses=problems(ProjectNotFound))
def read_phases(project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> PhasesRead:
    """Return the phases of the production: their cues, the gate before each, what is missing and who must act."""
    return phases_service.phases(session, actor, project_id)


@router.get("/projects/{project_id}/pace", responses=problems(ProjectNotFound, TeamNeeded))
def read_pace(project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> Pace:
    """Return the pace of a project: the work's beside the studio's own, for both parties."""
    return pace(session, actor, project_id)


@router.get("/me/own-projects")
def read_own_projects(session: DbSession, actor: Actor = allows(Audience.PERSON)) -> list[OwnProject]:
    """Return the projects that the caller is engaged on as a designer: credit, people, playlists with their sounds."""
    return own_projects(session, actor)


@router.get("/me/work")
def read_own_work(session: DbSession, actor: Actor = allows(Audience.PERSON)) -> list[WorkFigures]:
    """Return the facts that each studio that the caller works or worked for knows from that work."""
    return own_work(session, actor)


@router.get("/me/desk", responses=problems(BadCursor))
def read_own_desk(
    session: DbSession, cursor: str | None = None, actor: Actor = allows(Audience.PERSON, desk_token=True)
) -> OwnDesk:
    """Return the cues that wait for a file from the caller in all projects, what is due soonest first."""
    return own_desk(session, actor, cursor)


@router.get("/projects/{project_id}/desk", responses=problems(ProjectNotFound, DesignerNeeded))
def read_desk(project_id: UUID, session: DbSession, actor: Actor = allows(Audience.DESIGNER)) -> schemas.Desk:
    """Return a designer's work in one project: how much of everything, and the first page of each list."""
    return Desk(session, actor, project_id).read()


@router.get(
    "/projects/{project_id}/desk/sounds.rpp",
    **downloads(REAPER, ProjectNotFound, DesignerNeeded),
)
def download_reaper_project(project_id: UUID, session: DbSession, actor: Actor = allows(Audience.DESIGNER)) -> Response:
    """Return a project for REAPER with a region for each file that the caller owes, and change requests as markers."""
    return file_response(reaper_project_of(session, actor, project_id), REAPER, "sounds.rpp")


DESK_PROBLEMS = problems(ProjectNotFound, DesignerNeeded, BadCursor)


@router.get("/projects/{project_id}/desk/came-back", response_model=Page[schemas.CameBack], responses=DESK_PROBLEMS)
def list_came_back(
    project_id: UUID, session: DbSession, cursor: str | None = None, actor: Actor = allows(Audience.DESIGNER)
) -> Page[schemas.CameBack]:
    """Return the takes that are with the designer again, by cue, those that wait longest first."""
    return Desk(session, actor, project_id).came_back(cursor)


@router.get("/projects/{project_id}/desk/to-make", response_model=Page[schemas.ToMake], responses=DESK_PROBLEMS)
def list_to_make(
    project_id: UUID, session: DbSession, cursor: str | None = None, actor: Actor = allows(Audience.DESIGNER)
) -> Page[schemas.ToMake]:
    """Return the cues that wait for a file from the designer, in list order."""
    return Desk(session, actor, project_id).to_make(cursor)


@router.get(
    "/projects/{project_id}/desk/with-approver", response_model=Page[schemas.WithApprover], responses=DESK_PROBLEMS
)
def list_with_approver(
    project_id: UUID, session: DbSession, cursor: str | None = None, actor: Actor = allows(Audience.DESIGNER)
) -> Page[schemas.WithApprover]:
    """Return the designer's cues that wait for their verdict, in list order."""
    return Desk(session, actor, project_id).with_approver(cursor)


@router.get("/projects/{project_id}/overview", responses=problems(ProjectNotFound))
def read_overview(project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> schemas.Overview:
    """Return a project at one glance."""
    return service.overview(session, actor, project_id)


@router.get("/projects/{project_id}/find", responses=problems(ProjectNotFound))
def find(
    project_id: UUID,
    q: Annotated[str, Query(min_length=1, max_length=100)],
    session: DbSession,
    actor: Actor = allows(Audience.PROJECT),
) -> finding_schemas.FindResult:
    """Return matches of the typed words: cues, files, people, contracts, reasons, labels, comments and questions.

    A designer finds reasons and labels of their own versions.
    """
    return finding.search(session, actor, project_id, q)


@router.get("/find")
def find_elsewhere(
    q: Annotated[str, Query(min_length=1, max_length=100)],
    session: DbSession,
    except_in: Annotated[UUID | None, Query(description="A project to leave out: the one that is open.")] = None,
    actor: Actor = allows(Audience.PERSON),
) -> finding_schemas.FindElsewhereResult:
    """Return cues, files, reasons and labels that hold the typed words in all projects that the caller sees."""
    return finding.find_elsewhere(session, actor, q, except_in=except_in)
