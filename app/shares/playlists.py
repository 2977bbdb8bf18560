"""Playlists: made of a filter or by hand, put in order, played through, and left where one stopped."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.accounts.schemas import PersonBrief
from app.core import clock
from app.core.errors import FieldProblem
from app.core.plural import verb
from app.projects.approval.service import approval_scope
from app.projects.errors import ProjectNotFound
from app.projects.service import ProjectAccess, project_access
from app.renders.service import sound_places
from app.renders.thumb_queries import thumbs
from app.reviews.listened.queries import heard_among
from app.shares import queries
from app.shares.errors import NothingToShare, PlaylistChanged, PlaylistInvalid, PlaylistNotFound
from app.shares.models import Playlist, PlaylistEntry, PlaylistPosition
from app.shares.playlist_schemas import (
    PlaylistAdd,
    PlaylistBrief,
    PlaylistChange,
    PlaylistRead,
    PlaylistTake,
    PositionSet,
)
from app.shares.rules import MAX_SOUNDS, heard_takes
from app.sound_lists.rules import label


def playlists_of(session: Session, actor: Actor, project_id: UUID) -> list[PlaylistBrief]:
    """Return the playlists of a project, newest first; designers see those that hold sounds of theirs."""
    access = project_access(session, actor, project_id)
    if access.only_designer_id is None:
        playlists = queries.playlists_in(session, project_id)
    else:
        has_own_sound, heard = queries.has_sound_of(access.only_designer_id), queries.heard_by(actor)
        playlists = queries.playlists_in(session, project_id, has_own_sound, heard=[heard])
    return [
        PlaylistBrief(
            id=playlist.id,
            name=playlist.name,
            takes=takes,
            made_by=PersonBrief.model_validate(playlist.maker),
            created_at=playlist.created_at,
        )
        for playlist, takes in playlists
    ]


def make_playlist(session: Session, actor: Actor, project_id: UUID, body: PlaylistAdd) -> PlaylistRead:
    """Keep takes, or the takes that are heard of cues, under a name."""
    access = project_access(session, actor, project_id)
    access.ensure_may_speak()
    take_ids = list(dict.fromkeys(body.take_ids))
    if body.cue_ids:
        heard = heard_takes(queries.candidates(session, project_id, *queries.of_cues(body.cue_ids)))
        take_ids = list(dict.fromkeys([*take_ids, *heard]))
    if not take_ids:
        raise NothingToShare(
            "none of what you chose has a version that can be played",
            fix="wait until a version was delivered and checked, or choose other cues",
        )
    playlist = Playlist(studio_id=access.project.studio_id, project_id=project_id, name=body.name, made_by=actor.person)
    session.add(playlist)
    session.flush()
    _put_entries(session, playlist, take_ids)
    return read_playlist(session, access, playlist)


def playlist_read(session: Session, actor: Actor, playlist_id: UUID) -> PlaylistRead:
    """Return a playlist with its takes and where the caller stopped."""
    access, playlist = playlist_for(session, actor, playlist_id)
    return read_playlist(session, access, playlist)


def change_playlist(session: Session, actor: Actor, playlist_id: UUID, body: PlaylistChange) -> PlaylistRead:
    """Rename a playlist, or put other takes in it, or the same in another order."""
    access, playlist = playlist_of_team(session, actor, playlist_id, locked=True)
    access.ensure_may_speak()
    if body.edition != playlist.edition:
        raise PlaylistChanged(
            "another person changed this playlist since you opened it", fix="reload the page and change it again"
        )
    if "name" in body.model_fields_set:
        playlist.name = body.name
    if "take_ids" in body.model_fields_set:
        for entry in queries.entries_of(session, playlist.id):
            session.delete(entry)
        session.flush()
        _put_entries(session, playlist, body.take_ids)
    playlist.edition += 1
    session.flush()
    return read_playlist(session, access, playlist)


def remove_playlist(session: Session, actor: Actor, playlist_id: UUID) -> None:
    """Remove a playlist; guest links made of it stay."""
    access, playlist = playlist_of_team(session, actor, playlist_id, locked=True)
    access.ensure_may_speak()
    playlist.removed_at = clock.now()
    session.flush()


def save_position(session: Session, actor: Actor, playlist_id: UUID, body: PositionSet) -> None:
    """Keep the caller's stopping place."""
    access, playlist = playlist_for(session, actor, playlist_id)
    if body.take_id not in {take_heard.take.id for take_heard in _takes_heard(session, access, playlist)}:
        raise _invalid("take_id", "this version is not in the playlist")
    position = queries.position_of(session, playlist.id, actor.person)
    if position is None:
        position = PlaylistPosition(
            playlist_id=playlist.id,
            person_id=actor.person,
            studio_id=access.project.studio_id,
            project_id=access.project.id,
        )
        session.add(position)
    position.take_id, position.at_s = body.take_id, body.at_s
    session.flush()


def playlist_for(session: Session, actor: Actor, playlist_id: UUID) -> tuple[ProjectAccess, Playlist]:
    """Return a playlist within the caller's sight, and what the caller is in its project."""
    playlist = queries.playlist_by_id(session, playlist_id)
    if playlist is None:
        raise PlaylistNotFound(f"no playlist {playlist_id}")
    try:
        access = project_access(session, actor, playlist.project_id)
    except ProjectNotFound:
        raise PlaylistNotFound(f"no playlist {playlist_id}") from None
    designer_id = access.only_designer_id
    if (
        designer_id is not None
        and queries.playlist_by_id(session, playlist_id, queries.has_sound_of(designer_id)) is None
    ):
        raise PlaylistNotFound(f"no playlist {playlist_id}")
    return access, playlist


def playlist_of_team(
    session: Session, actor: Actor, playlist_id: UUID, *, locked: bool = False
) -> tuple[ProjectAccess, Playlist]:
    """Return a playlist and what the caller is in its project; raise TeamNeeded for designers who only hear it."""
    access, _ = playlist_for(session, actor, playlist_id)
    access.ensure_team()
    playlist = queries.playlist_by_id(session, playlist_id, locked=locked)
    if playlist is None:
        raise PlaylistNotFound(f"no playlist {playlist_id}")
    return access, playlist


def playlist_in(session: Session, access: ProjectAccess, playlist_id: UUID) -> Playlist:
    """Return a playlist of a project; raise PlaylistNotFound for one of another."""
    playlist = queries.playlist_by_id(session, playlist_id)
    if playlist is None or playlist.project_id != access.project.id:
        raise PlaylistNotFound(f"no playlist {playlist_id} in this project")
    return playlist


def read_playlist(session: Session, access: ProjectAccess, playlist: Playlist) -> PlaylistRead:
    """Return a playlist as it is shown."""
    takes = _takes_heard(session, access, playlist)
    drawn = thumbs(session, [take.picture.id for take in takes if take.picture])
    scope = approval_scope(session, access)
    position = queries.position_of(session, playlist.id, access.actor.person)
    take_ids = {take.take.id for take in takes}
    is_here = position is not None and position.take_id in take_ids
    heard = heard_among(session, access.actor.person, take_ids) if access.is_team else None
    return PlaylistRead(
        id=playlist.id,
        project_id=playlist.project_id,
        name=playlist.name,
        edition=playlist.edition,
        made_by=PersonBrief.model_validate(queries.maker_of(session, playlist)),
        takes=[
            PlaylistTake(
                **sound_places(take.picture, drawn.get(take.picture.id) if take.picture else None),
                take_id=take.take.id,
                cue_id=take.cue.id,
                cue_label=label(access.project.cue_prefix, take.cue.number),
                cue_name=take.cue.name,
                category=take.cue.category,
                variation=take.take.variation if take.cue.variations > 1 else None,
                number=take.take.number or 0,
                label=take.take.label if access.only_designer_id in (None, take.take.designer_id) else None,
                state=take.take.state,
                may_approve=scope.covers(take.cue.category),
                is_heard=None if heard is None else take.take.id in heard,
            )
            for take in takes
        ],
        position=PositionSet(take_id=position.take_id, at_s=position.at_s) if position and is_here else None,
        may_share=access.is_producer or access.is_liaison or access.is_approver,
        may_join=access.is_team,
    )


def _takes_heard(session: Session, access: ProjectAccess, playlist: Playlist) -> list[queries.SharedTake]:
    """Return the takes of a playlist that the caller hears, in order."""
    heard = [] if access.only_designer_id is None else [queries.heard_by(access.actor)]
    return queries.playlist_takes(session, playlist.id, *heard)


def _put_entries(session: Session, playlist: Playlist, take_ids: Sequence[UUID]) -> None:
    if len(take_ids) > MAX_SOUNDS:
        raise _invalid("take_ids", f"these are {len(take_ids)} versions; a playlist has at most {MAX_SOUNDS}")
    if len(set(take_ids)) < len(take_ids):
        raise _invalid("take_ids", "a version stands here twice; each can be in the playlist once")
    unknown = set(take_ids) - queries.playable(session, playlist.project_id, take_ids)
    if unknown:
        raise _invalid(
            "take_ids",
            f"{len(unknown)} of these {verb(len(unknown), 'is no version', 'are not versions')} "
            "of a cue of this project",
        )
    session.add_all(
        PlaylistEntry(
            playlist_id=playlist.id,
            place=position,
            studio_id=playlist.studio_id,
            project_id=playlist.project_id,
            take_id=take_id,
        )
        for position, take_id in enumerate(take_ids, 1)
    )
    session.flush()


def _invalid(where: str, message: str) -> PlaylistInvalid:
    return PlaylistInvalid(message, errors=[FieldProblem(where=where, message=message)])
