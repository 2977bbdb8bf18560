"""The endpoints of playlists and of their sessions."""

from uuid import UUID

from fastapi import APIRouter

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.web.http import DbSession, problems
from app.projects.errors import ProjectNotFound, TeamNeeded
from app.shares import live_sessions, playlists
from app.shares.errors import (
    ControlTaken,
    ListenerNotFound,
    NothingToShare,
    PlayheadMoved,
    PlaylistChanged,
    PlaylistInvalid,
    PlaylistNotFound,
)
from app.shares.playlist_schemas import (
    LiveKeys,
    LiveMove,
    LiveRead,
    LiveReport,
    PlaylistAdd,
    PlaylistBrief,
    PlaylistChange,
    PlaylistRead,
    PositionSet,
)

router = APIRouter(prefix="/v1", tags=["playlists"])
TEAM: Actor = allows(Audience.TEAM)
PROJECT: Actor = allows(Audience.PROJECT)


@router.get("/projects/{project_id}/playlists", responses=problems(ProjectNotFound))
def list_playlists(project_id: UUID, session: DbSession, actor: Actor = PROJECT) -> list[PlaylistBrief]:
    """Return the playlists of a project, newest first; to designers those that hold sounds of theirs."""
    return playlists.playlists_of(session, actor, project_id)


@router.post(
    "/projects/{project_id}/playlists",
    status_code=201,
    responses=problems(ProjectNotFound, TeamNeeded, NothingToShare, PlaylistInvalid),
)
def add_playlist(project_id: UUID, body: PlaylistAdd, session: DbSession, actor: Actor = TEAM) -> PlaylistRead:
    """Keep versions, or those that are heard of some cues, under a name."""
    return playlists.make_playlist(session, actor, project_id, body)


@router.get("/playlists/{playlist_id}", responses=problems(PlaylistNotFound))
def get_playlist(playlist_id: UUID, session: DbSession, actor: Actor = PROJECT) -> PlaylistRead:
    """Return a playlist with the versions in order that the caller hears, and where the caller stopped."""
    return playlists.playlist_read(session, actor, playlist_id)


@router.patch(
    "/playlists/{playlist_id}", responses=problems(PlaylistNotFound, TeamNeeded, PlaylistChanged, PlaylistInvalid)
)
def change_playlist(playlist_id: UUID, body: PlaylistChange, session: DbSession, actor: Actor = TEAM) -> PlaylistRead:
    """Rename a playlist, or replace its versions or their order."""
    return playlists.change_playlist(session, actor, playlist_id, body)


@router.delete("/playlists/{playlist_id}", status_code=204, responses=problems(PlaylistNotFound, TeamNeeded))
def remove_playlist(playlist_id: UUID, session: DbSession, actor: Actor = TEAM) -> None:
    """Remove a playlist; guest links made of it stay."""
    playlists.remove_playlist(session, actor, playlist_id)


@router.put(
    "/playlists/{playlist_id}/position",
    status_code=204,
    responses=problems(PlaylistNotFound, PlaylistInvalid),
)
def save_playlist_position(playlist_id: UUID, body: PositionSet, session: DbSession, actor: Actor = PROJECT) -> None:
    """Keep the caller's stopping place."""
    playlists.save_position(session, actor, playlist_id, body)


@router.get("/playlists/{playlist_id}/live", responses=problems(PlaylistNotFound, TeamNeeded))
def get_live_session(
    playlist_id: UUID, session: DbSession, page_id: UUID | None = None, actor: Actor = TEAM
) -> LiveRead:
    """Return the playback in the session of a playlist now, the people in it, and the one in control."""
    return live_sessions.live_read(session, actor, playlist_id, page_id)


@router.put("/playlists/{playlist_id}/live/presence", responses=problems(PlaylistNotFound, TeamNeeded))
def report_presence(playlist_id: UUID, body: LiveReport, session: DbSession, actor: Actor = TEAM) -> LiveRead:
    """Join a session, stay in it for ten seconds more, go on with it on this page, or leave it."""
    return live_sessions.report(session, actor, playlist_id, body)


@router.put(
    "/playlists/{playlist_id}/live/playhead",
    responses=problems(PlaylistNotFound, TeamNeeded, ControlTaken, PlayheadMoved, PlaylistInvalid),
)
def move_playhead(playlist_id: UUID, body: LiveMove, session: DbSession, actor: Actor = TEAM) -> LiveRead:
    """Play, pause, seek or go to another version, for everyone in the session."""
    return live_sessions.move(session, actor, playlist_id, body)


@router.put(
    "/playlists/{playlist_id}/live/keys",
    responses=problems(PlaylistNotFound, TeamNeeded, ControlTaken, ListenerNotFound),
)
def pass_keys(playlist_id: UUID, body: LiveKeys, session: DbSession, actor: Actor = TEAM) -> LiveRead:
    """Take control while it is free or on another page of one's own, hand it to another, or release it."""
    return live_sessions.pass_keys(session, actor, playlist_id, body)
