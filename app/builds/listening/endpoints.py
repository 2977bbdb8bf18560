"""The endpoints of listening passes and of the tasks that come from their notes."""

from uuid import UUID

from fastapi import APIRouter

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.builds.errors import (
    GameTaskNotFound,
    ImplementerNeeded,
    ListeningNoteInvalid,
    ListeningNoteNotFound,
    ListeningNoteTaken,
    ListeningPassClosed,
    ListeningPassNotFound,
    NothingToHear,
)
from app.builds.listening import service as listening
from app.builds.listening import tasks as game_tasks
from app.builds.listening.schemas import (
    GameTaskChange,
    GameTaskRead,
    ListeningNoteAdd,
    ListeningNoteRead,
    ListeningNow,
)
from app.core.web.http import BadCursor, DbSession, Page, cursor_of, problems, uuid_cursor
from app.projects.errors import ProjectNotFound, TeamNeeded
from app.references.errors import ReferenceNotFound
from app.sound_lists.errors import CueNotFound

router = APIRouter(prefix="/v1", tags=["listening-passes"])
PROJECT: Actor = allows(Audience.PROJECT)
PAGE = 100


@router.get("/projects/{project_id}/listening-pass", responses=problems(ProjectNotFound))
def get_listening_pass(project_id: UUID, session: DbSession, actor: Actor = PROJECT) -> ListeningNow:
    """Return the open listening pass with its cues and notes: all of them to the team, their own to designers."""
    return listening.listening_now(session, actor, project_id)


@router.post(
    "/projects/{project_id}/listening-passes", status_code=201, responses=problems(ProjectNotFound, NothingToHear)
)
def start_listening_pass(project_id: UUID, session: DbSession, actor: Actor = PROJECT) -> ListeningNow:
    """Begin a listening pass over the newest audited build; the one that is open is continued."""
    return listening.start(session, actor, project_id)


@router.post(
    "/listening-passes/{listening_pass_id}/close",
    status_code=204,
    responses=problems(ListeningPassNotFound, TeamNeeded),
)
def close_listening_pass(listening_pass_id: UUID, session: DbSession, actor: Actor = allows(Audience.TEAM)) -> None:
    """Close a listening pass; its notes and tasks stay."""
    listening.close(session, actor, listening_pass_id)


@router.post(
    "/listening-passes/{listening_pass_id}/notes",
    status_code=201,
    responses=problems(
        *(ListeningPassNotFound, CueNotFound, ReferenceNotFound, ListeningPassClosed),
        *(ListeningNoteInvalid, ListeningNoteTaken),
    ),
)
def add_listening_note(
    listening_pass_id: UUID, body: ListeningNoteAdd, session: DbSession, actor: Actor = PROJECT
) -> ListeningNoteRead:
    """Write a note on a cue in the game; sent again with the same id, it counts once."""
    return listening.add_note(session, actor, listening_pass_id, body)


@router.delete("/listening-notes/{listening_note_id}", status_code=204, responses=problems(ListeningNoteNotFound))
def undo_listening_note(listening_note_id: UUID, session: DbSession, actor: Actor = PROJECT) -> None:
    """Take a note of one's own back, and its task unless that is done."""
    listening.undo_note(session, actor, listening_note_id)


@router.get("/projects/{project_id}/game-tasks", responses=problems(ProjectNotFound, BadCursor))
def list_game_tasks(
    project_id: UUID, session: DbSession, done: bool = False, cursor: str | None = None, actor: Actor = PROJECT
) -> Page[GameTaskRead]:
    """Return the tasks for the game to play its sounds as it should, the newest first."""
    access, tasks = game_tasks.tasks_in(
        session, actor, project_id, done=done, before=uuid_cursor(cursor), limit=PAGE + 1
    )
    shown = tasks[:PAGE]
    return Page(
        items=game_tasks.read_tasks(session, access, shown),
        next=cursor_of(shown[-1].id) if len(tasks) > PAGE else None,
    )


@router.put("/game-tasks/{game_task_id}", responses=problems(GameTaskNotFound, TeamNeeded, ImplementerNeeded))
def change_game_task(
    game_task_id: UUID, body: GameTaskChange, session: DbSession, actor: Actor = PROJECT
) -> GameTaskRead:
    """Mark a task as done, or as open again."""
    access, task = game_tasks.change_task(session, actor, game_task_id, is_done=body.is_done)
    (read,) = game_tasks.read_tasks(session, access, [task])
    return read
