"""Sessions of playlists: all present hear the same playhead, and one person at a time holds its keys."""

from datetime import datetime
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.accounts.schemas import PersonBrief
from app.kit import clock
from app.kit.db import insert_if_absent
from app.projects.service import ProjectAccess
from app.shares import live_queries, queries
from app.shares.errors import KeysHeld, ListenerNotFound, PlayheadMoved, PlaylistInvalid
from app.shares.models import LiveListener, LiveSession, Playlist
from app.shares.playlist_schemas import LiveKeys, LiveMove, LiveRead
from app.shares.playlists import playlist_for
from app.shares.rules import holder_now, playhead_s, present_now


def live_read(session: Session, actor: Actor, playlist_id: UUID) -> LiveRead:
    """Return what everyone in a session hears now."""
    playlist_for(session, actor, playlist_id)
    return _read(session, actor, playlist_id, clock.now())


def report(session: Session, actor: Actor, playlist_id: UUID, *, leaves: bool) -> LiveRead:
    """Note that the caller's page is open, or leaves; the first report joins the session."""
    access, playlist = playlist_for(session, actor, playlist_id)
    now = clock.now()
    if live_queries.live_session(session, playlist_id) is None:
        _begin_session(session, access, playlist)
    if leaves:
        live_queries.leave(session, playlist_id, actor.person)
        live = live_queries.live_session(session, playlist_id, locked=True)
        if live is not None:  # so that all pages are notified
            live.sequence += 1
            live.holder_id = None if live.holder_id == actor.person else live.holder_id
    elif not live_queries.report(session, playlist_id, actor.person, now):
        session.add(
            LiveListener(
                playlist_id=playlist_id,
                person_id=actor.person,
                studio_id=playlist.studio_id,
                project_id=playlist.project_id,
                seen_at=now,
            )
        )
    session.flush()
    return _read(session, actor, playlist_id, now)


def move(session: Session, actor: Actor, playlist_id: UUID, body: LiveMove) -> LiveRead:
    """Play, pause, seek or go to another take, for everyone; only who holds the keys does."""
    playlist_for(session, actor, playlist_id)
    now = clock.now()
    live = _locked(session, playlist_id)
    if _holder(session, live, now) != actor.person:
        raise KeysHeld("you do not hold the keys of this session", fix="take them while they are free, or ask for them")
    if body.sequence != live.sequence:
        raise PlayheadMoved("the playhead was moved since", fix="read the session again")
    if body.take_id not in {entry.take_id for entry in queries.entries_of(session, playlist_id)}:
        raise PlaylistInvalid("this version is not in the playlist")
    live.sequence += 1
    live.take_id, live.is_playing = body.take_id, body.is_playing
    live.position_s, live.set_at = body.position_s, now
    session.flush()
    return _read(session, actor, playlist_id, now)


def pass_keys(session: Session, actor: Actor, playlist_id: UUID, body: LiveKeys) -> LiveRead:
    """Take the keys while they are free, hand them to another person present, or put them down."""
    playlist_for(session, actor, playlist_id)
    now = clock.now()
    live = _locked(session, playlist_id)
    holder_id = _holder(session, live, now)
    if holder_id not in (None, actor.person) or (holder_id is None and body.act != "take"):
        raise KeysHeld(
            "another person holds the keys" if holder_id else "you do not hold the keys", fix="ask who holds them"
        )
    match body.act:
        case "take":
            live.holder_id = actor.person
        case "drop":
            live.holder_id = None
        case "give":
            if body.person_id not in _present(session, playlist_id, now):
                raise ListenerNotFound("this person is not in the session")
            live.holder_id = body.person_id
    live.sequence += 1
    session.flush()
    return _read(session, actor, playlist_id, now)


def _begin_session(session: Session, access: ProjectAccess, playlist: Playlist) -> None:
    row = {
        "playlist_id": playlist.id,
        "studio_id": playlist.studio_id,
        "project_id": access.project.id,
        "sequence": 0,
        "is_playing": False,
        "position_s": 0.0,
        "set_at": clock.now(),
    }
    insert_if_absent(session, LiveSession, row, unique=("playlist_id",))


def _locked(session: Session, playlist_id: UUID) -> LiveSession:
    live = live_queries.live_session(session, playlist_id, locked=True)
    if live is None:
        raise KeysHeld("nobody is in this session yet", fix="join it first")
    return live


def _present(session: Session, playlist_id: UUID, now: datetime) -> set[UUID]:
    listeners = live_queries.listeners_of(session, playlist_id)
    return set(present_now(now, [(one.person_id, one.seen_at) for one in listeners]))


def _holder(session: Session, live: LiveSession, now: datetime) -> UUID | None:
    listeners = live_queries.listeners_of(session, live.playlist_id)
    return holder_now(now, live.holder_id, [(one.person_id, one.seen_at) for one in listeners])


def _read(session: Session, actor: Actor, playlist_id: UUID, now: datetime) -> LiveRead:
    live = live_queries.live_session(session, playlist_id)
    listeners = live_queries.listeners_of(session, playlist_id)
    seen = [(one.person_id, one.seen_at) for one in listeners]
    present = present_now(now, seen)
    people = {one.person_id: PersonBrief.model_validate(one.person) for one in listeners if one.person_id in present}
    holder_id = holder_now(now, live.holder_id, seen) if live else None
    position_s = playhead_s(now, live.position_s, live.set_at, is_playing=live.is_playing) if live else 0.0
    return LiveRead(
        sequence=live.sequence if live else 0,
        holder=people[holder_id] if holder_id else None,
        is_holder=holder_id == actor.person and holder_id is not None,
        take_id=live.take_id if live else None,
        is_playing=live.is_playing if live else False,
        position_s=max(0.0, position_s),
        server_ms=round(now.timestamp() * 1000),
        present=list(people.values()),
    )
