"""Sessions of playlists: all present hear the same playhead, one person holds its keys, each hears it on one page."""

from datetime import datetime
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.accounts.schemas import PersonBrief
from app.core import clock
from app.core.db import insert_if_absent
from app.projects.service import ProjectAccess
from app.shares import live_queries, queries
from app.shares.errors import ControlTaken, ListenerNotFound, PlayheadMoved, PlaylistInvalid
from app.shares.models import LiveListener, LiveSession, Playlist
from app.shares.playlist_schemas import LiveKeys, LiveMove, LiveRead, LiveReport
from app.shares.playlists import playlist_of_team
from app.shares.rules import holder_now, is_elsewhere, playhead_s, present_now


def live_read(session: Session, actor: Actor, playlist_id: UUID, page_id: UUID | None) -> LiveRead:
    """Return the common playback of a session now, to one of the caller's pages."""
    playlist_of_team(session, actor, playlist_id)
    return _read(session, actor, playlist_id, page_id, clock.now())


def report(session: Session, actor: Actor, playlist_id: UUID, body: LiveReport) -> LiveRead:
    """Note that the caller's page is open, or leaves; the first report joins the session.

    Whoever joins a session in which nobody is starts it, and holds its keys.
    Of several pages of one person the first one plays, until it is gone or another takes over.
    """
    access, playlist = playlist_of_team(session, actor, playlist_id)
    now = clock.now()
    if live_queries.live_session(session, playlist_id) is None:
        _begin_session(session, access, playlist)
    listener = live_queries.listener(session, playlist_id, actor.person)
    is_new = listener is None or listener.page_id != body.page_id
    starts = is_new and not body.leaves and not _present(session, playlist_id, now)
    if listener is None:
        if not body.leaves:
            _join(session, actor, playlist, body.page_id, now)
    elif not is_elsewhere(now, body.page_id, listener.page_id, listener.seen_at):
        if body.leaves:
            _leave(session, actor, playlist_id)
        else:
            live_queries.report(session, playlist_id, actor.person, body.page_id, now)
    elif body.takes_over and not body.leaves:
        _take_over(session, actor, _locked(session, playlist_id), body.page_id, now)
    session.flush()
    if starts:
        _start(session, actor, playlist_id, now)
    return _read(session, actor, playlist_id, body.page_id, now)


def move(session: Session, actor: Actor, playlist_id: UUID, body: LiveMove) -> LiveRead:
    """Play, pause, seek or go to another take, for everyone; only who has control does."""
    playlist_of_team(session, actor, playlist_id)
    now = clock.now()
    live = _locked(session, playlist_id)
    if _holder(session, live, now) != actor.person:
        raise ControlTaken(
            "you do not have control of this session", fix="take control while it is free, or ask for it"
        )
    _ensure_on_this_page(session, actor, playlist_id, body.page_id, now)
    if body.sequence != live.sequence:
        raise PlayheadMoved("the playhead was moved since", fix="read the session again")
    if body.take_id not in {entry.take_id for entry in queries.entries_of(session, playlist_id)}:
        raise PlaylistInvalid("this version is not in the playlist")
    live.sequence += 1
    live.take_id, live.is_playing = body.take_id, body.is_playing
    live.position_s, live.set_at = body.position_s, now
    session.flush()
    return _read(session, actor, playlist_id, body.page_id, now)


def pass_keys(session: Session, actor: Actor, playlist_id: UUID, body: LiveKeys) -> LiveRead:
    """Take control while it is free or on another page of one's own, hand it to another, or release it."""
    playlist_of_team(session, actor, playlist_id)
    now = clock.now()
    live = _locked(session, playlist_id)
    holder_id = _holder(session, live, now)
    if holder_id not in (None, actor.person) or (holder_id is None and body.act != "take"):
        raise ControlTaken(
            "another person has control" if holder_id else "you do not have control", fix="ask who has it"
        )
    if body.act != "take":
        _ensure_on_this_page(session, actor, playlist_id, body.page_id, now)
    match body.act:
        case "take":
            live.holder_id = actor.person
            _take_over(session, actor, live, body.page_id, now)
        case "drop":
            live.holder_id = None
        case "give":
            if body.person_id not in _present(session, playlist_id, now):
                raise ListenerNotFound("this person is not in the session")
            live.holder_id = body.person_id
    live.sequence += 1
    session.flush()
    return _read(session, actor, playlist_id, body.page_id, now)


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


def _join(session: Session, actor: Actor, playlist: Playlist, page_id: UUID | None, now: datetime) -> None:
    session.add(
        LiveListener(
            playlist_id=playlist.id,
            person_id=actor.person,
            studio_id=playlist.studio_id,
            project_id=playlist.project_id,
            seen_at=now,
            page_id=page_id,
        )
    )


def _start(session: Session, actor: Actor, playlist_id: UUID, now: datetime) -> None:
    """Give control to who joins an empty session; what an earlier one played there is over."""
    live = _locked(session, playlist_id)
    if _holder(session, live, now) is None:  # of two who start at the same moment the first one
        live.holder_id = actor.person
        live.take_id, live.is_playing, live.position_s, live.set_at = None, False, 0.0, now
        live.sequence += 1
        session.flush()


def _leave(session: Session, actor: Actor, playlist_id: UUID) -> None:
    live_queries.leave(session, playlist_id, actor.person)
    live = _locked(session, playlist_id)
    live.sequence += 1  # so that all pages are notified
    live.holder_id = None if live.holder_id == actor.person else live.holder_id


def _take_over(session: Session, actor: Actor, live: LiveSession, page_id: UUID | None, now: datetime) -> None:
    live_queries.report(session, live.playlist_id, actor.person, page_id, now)
    live.sequence += 1  # so that the other page is notified, and falls silent


def _ensure_on_this_page(
    session: Session, actor: Actor, playlist_id: UUID, page_id: UUID | None, now: datetime
) -> None:
    listener = live_queries.listener(session, playlist_id, actor.person)
    if listener is not None and is_elsewhere(now, page_id, listener.page_id, listener.seen_at):
        raise ControlTaken("you have control on another page of yours", fix="take control here first")


def _locked(session: Session, playlist_id: UUID) -> LiveSession:
    live = live_queries.live_session(session, playlist_id, locked=True)
    if live is None:
        raise ControlTaken("nobody is in this session yet", fix="join it first")
    return live


def _present(session: Session, playlist_id: UUID, now: datetime) -> set[UUID]:
    listeners = live_queries.listeners_of(session, playlist_id)
    return set(present_now(now, [(listener.person_id, listener.seen_at) for listener in listeners]))


def _holder(session: Session, live: LiveSession, now: datetime) -> UUID | None:
    listeners = live_queries.listeners_of(session, live.playlist_id)
    return holder_now(now, live.holder_id, [(listener.person_id, listener.seen_at) for listener in listeners])


def _read(session: Session, actor: Actor, playlist_id: UUID, page_id: UUID | None, now: datetime) -> LiveRead:
    live = live_queries.live_session(session, playlist_id)
    listeners = live_queries.listeners_of(session, playlist_id)
    seen = [(listener.person_id, listener.seen_at) for listener in listeners]
    present = present_now(now, seen)
    people = {
        listener.person_id: PersonBrief.model_validate(listener.person)
        for listener in listeners
        if listener.person_id in present
    }
    holder_id = holder_now(now, live.holder_id, seen) if live else None
    own_listener = next((listener for listener in listeners if listener.person_id == actor.person), None)
    elsewhere = own_listener is not None and is_elsewhere(now, page_id, own_listener.page_id, own_listener.seen_at)
    position_s = playhead_s(now, live.position_s, live.set_at, is_playing=live.is_playing) if live else 0.0
    return LiveRead(
        sequence=live.sequence if live else 0,
        holder=people[holder_id] if holder_id else None,
        is_holder=holder_id == actor.person and not elsewhere,
        is_elsewhere=elsewhere,
        take_id=live.take_id if live else None,
        is_playing=live.is_playing if live else False,
        position_s=max(0.0, position_s),
        server_ms=round(now.timestamp() * 1000),
        present=list(people.values()),
    )
