"""Guest links, their visits, playlists, sessions and views, read from the database; callers have checked access."""

from collections.abc import Collection, Sequence
from typing import NamedTuple
from uuid import UUID

from sqlalchemy import ColumnElement, Row, Select, and_, func, or_, select
from sqlalchemy.orm import Session, contains_eager, joinedload

from app.accounts.models import Person
from app.accounts.rules import Actor
from app.core.in_array import in_array
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.renders.models import Picture
from app.renders.other_sounds.queries import opened_takes
from app.shares.models import (
    GuestCopy,
    GuestLink,
    GuestPlay,
    GuestSound,
    GuestVisit,
    Playlist,
    PlaylistEntry,
    PlaylistPosition,
    SavedView,
)
from app.shares.rules import Candidate, ViewedPage
from app.sound_lists.models import Cue
from app.sound_lists.rules import CueState


def candidates(session: Session, project_id: UUID, *where: ColumnElement[bool]) -> list[Candidate]:
    """Return the takes of a project that can be played and were approved or wait, in list order."""
    rows = session.execute(
        select(Take.id, Cue.id, Take.variation, func.coalesce(Take.number, 0), Take.state)
        .join(Cue, Cue.id == Take.cue_id)
        .join(Picture, and_(Picture.studio_id == Take.studio_id, Picture.sound_sha256 == Take.master_sha256))
        .where(Take.project_id == project_id, Cue.state != CueState.CUT, Picture.preview_sha256.is_not(None), *where)
        .order_by(Cue.position, Cue.number, Take.variation, Take.number)
    )
    return [Candidate(*row) for row in rows]


def of_cues(cue_ids: Collection[UUID]) -> tuple[ColumnElement[bool], ...]:
    """Admit the takes of some cues that were approved or wait."""
    return in_array(Cue.id, cue_ids), Take.state.in_((TakeState.APPROVED, TakeState.CONFORMING))


def approved(*, palette: bool) -> tuple[ColumnElement[bool], ...]:
    """Admit approved takes: all, or those of the palette."""
    is_approved = Take.state == TakeState.APPROVED
    return (is_approved, Cue.palette.is_(True)) if palette else (is_approved,)


def links_in(session: Session, project_id: UUID, *, before: UUID | None, limit: int) -> Sequence[GuestLink]:
    """Return the guest links of a project, newest first."""
    query = _links().where(GuestLink.project_id == project_id)
    if before is not None:
        query = query.where(GuestLink.id < before)
    return session.scalars(query.order_by(GuestLink.id.desc()).limit(limit)).all()


def link_by_id(session: Session, link_id: UUID) -> GuestLink | None:
    """Return a guest link with who made it."""
    return session.scalar(_links().where(GuestLink.id == link_id))


def link_by_secret(session: Session, secret_sha256: str, *, locked: bool = False) -> GuestLink | None:
    """Return the guest link of an address, in whatever state it is."""
    query = select(GuestLink).where(GuestLink.secret_sha256 == secret_sha256)
    if locked:  # two who open at once are counted one after the other
        query = query.with_for_update().execution_options(populate_existing=True)
    return session.scalar(query)


def _links() -> Select[GuestLink]:
    return select(GuestLink).options(joinedload(GuestLink.maker))


def sound_counts(session: Session, link_ids: Collection[UUID]) -> dict[UUID, int]:
    """Return the numbers of sounds that links share."""
    query = select(GuestSound.link_id, func.count()).where(in_array(GuestSound.link_id, link_ids))
    return dict(session.execute(query.group_by(GuestSound.link_id)).all())


def play_counts(session: Session, link_ids: Collection[UUID]) -> dict[UUID, int]:
    """Return the numbers of plays of sounds of links."""
    query = (
        select(GuestVisit.link_id, func.sum(GuestPlay.plays))
        .join(GuestPlay, GuestPlay.visit_id == GuestVisit.id)
        .where(in_array(GuestVisit.link_id, link_ids))
        .group_by(GuestVisit.link_id)
    )
    return {link_id: int(plays) for link_id, plays in session.execute(query)}


class SharedTake(NamedTuple):
    """A take in its place, with its cue and what plays it."""

    place: int
    take: Take
    cue: Cue
    picture: Picture | None


def shared_takes(session: Session, link_id: UUID, *, place: int | None = None) -> list[SharedTake]:
    """Return the takes of a link in order, or the one in a place."""
    query = _with_picture(select(GuestSound.place, Take, Cue, Picture).join(Take, Take.id == GuestSound.take_id))
    query = query.where(GuestSound.link_id == link_id).order_by(GuestSound.place)
    if place is not None:
        query = query.where(GuestSound.place == place)
    return [SharedTake(*row) for row in session.execute(query)]


def playlist_takes(session: Session, playlist_id: UUID, *where: ColumnElement[bool]) -> list[SharedTake]:
    """Return the takes of a playlist in order."""
    query = _with_picture(select(PlaylistEntry.place, Take, Cue, Picture).join(Take, Take.id == PlaylistEntry.take_id))
    query = query.where(PlaylistEntry.playlist_id == playlist_id, *where)
    rows = session.execute(query.order_by(PlaylistEntry.place))
    return [SharedTake(*row) for row in rows]


def _with_picture(query: Select[int, Take, Cue, Picture]) -> Select[int, Take, Cue, Picture]:
    return query.join(Cue, Cue.id == Take.cue_id).outerjoin(
        Picture, and_(Picture.studio_id == Take.studio_id, Picture.sound_sha256 == Take.master_sha256)
    )


def visit_by_secret(session: Session, secret_sha256: str) -> GuestVisit | None:
    """Return a visit with its link."""
    query = select(GuestVisit).join(GuestLink, GuestLink.id == GuestVisit.link_id)
    return session.scalar(
        query.options(contains_eager(GuestVisit.link)).where(GuestVisit.secret_sha256 == secret_sha256)
    )


def visits_of(session: Session, link_id: UUID, *, before: UUID | None, limit: int) -> Sequence[GuestVisit]:
    """Return the visits of a link, newest first."""
    query = select(GuestVisit).where(GuestVisit.link_id == link_id)
    if before is not None:
        query = query.where(GuestVisit.id < before)
    return session.scalars(query.order_by(GuestVisit.id.desc()).limit(limit)).all()


def plays_of_visits(session: Session, link_id: UUID, visit_ids: Collection[UUID]) -> Sequence[Row[GuestPlay, str, int]]:
    """Return the plays of visits, with the cue's name and the variation."""
    return session.execute(
        select(GuestPlay, Cue.name, Take.variation)
        .join(GuestSound, and_(GuestSound.link_id == link_id, GuestSound.place == GuestPlay.place))
        .join(Take, Take.id == GuestSound.take_id)
        .join(Cue, Cue.id == Take.cue_id)
        .where(in_array(GuestPlay.visit_id, visit_ids))
        .order_by(GuestPlay.visit_id, GuestPlay.place)
    ).all()


def play_in(session: Session, visit_id: UUID, position: int) -> GuestPlay | None:
    """Return the count of a sound's plays in a visit."""
    return session.get(GuestPlay, (visit_id, position))


def copies_of(session: Session, studio_ids: Collection[UUID], keys: Collection[str]) -> dict[str, GuestCopy]:
    """Return the copies of previews that guests get, by their keys."""
    query = select(GuestCopy).where(in_array(GuestCopy.studio_id, studio_ids), in_array(GuestCopy.key, keys))
    return {copy.key: copy for copy in session.scalars(query)}


def heard_by(actor: Actor) -> ColumnElement[bool]:
    """Admit the takes that a designer hears: their own, and those that the project opens to its designers."""
    return or_(Take.designer_id == actor.person_id, opened_takes(actor))


def has_sound_of(designer_id: UUID) -> ColumnElement[bool]:
    """Admit playlists that hold a take of a designer."""
    entry = select(PlaylistEntry.place).join(Take, Take.id == PlaylistEntry.take_id)
    return entry.where(PlaylistEntry.playlist_id == Playlist.id, Take.designer_id == designer_id).exists()


def playlists_in(
    session: Session,
    project_id: UUID,
    *where: ColumnElement[bool],
    heard: Sequence[ColumnElement[bool]] = (),
) -> Sequence[Row[Playlist, int]]:
    """Return the playlists of a project with how many takes each has, newest first; those `heard` count."""
    entries = select(func.count(PlaylistEntry.place)).join(Take, Take.id == PlaylistEntry.take_id)
    counted = entries.where(PlaylistEntry.playlist_id == Playlist.id, *heard).correlate(Playlist).scalar_subquery()
    return session.execute(
        select(Playlist, counted)
        .where(Playlist.project_id == project_id, Playlist.removed_at.is_(None), *where)
        .options(joinedload(Playlist.maker))
        .order_by(Playlist.id.desc())
    ).all()


def playlist_by_id(
    session: Session, playlist_id: UUID, *where: ColumnElement[bool], locked: bool = False
) -> Playlist | None:
    """Return a playlist that was not removed."""
    query = select(Playlist).where(Playlist.id == playlist_id, Playlist.removed_at.is_(None), *where)
    if locked:
        query = query.with_for_update().execution_options(populate_existing=True)
    return session.scalar(query)


def open_links_by(session: Session, studio_id: UUID, person_id: UUID) -> Sequence[GuestLink]:
    """Return the guest links that a person made in a studio and that were not revoked, the oldest first."""
    return session.scalars(
        select(GuestLink)
        .where(GuestLink.studio_id == studio_id, GuestLink.made_by == person_id, GuestLink.revoked_at.is_(None))
        .order_by(GuestLink.id)
    ).all()


def maker_of(session: Session, playlist: Playlist) -> Person:
    """Return the maker of a playlist."""
    return session.get_one(Person, playlist.made_by)


def entries_of(session: Session, playlist_id: UUID) -> Sequence[PlaylistEntry]:
    """Return the entries of a playlist in order."""
    query = select(PlaylistEntry).where(PlaylistEntry.playlist_id == playlist_id)
    return session.scalars(query.order_by(PlaylistEntry.place)).all()


def playable(session: Session, project_id: UUID, take_ids: Collection[UUID]) -> set[UUID]:
    """Return those of some takes that belong to a cue of a project."""
    query = select(Take.id).where(in_array(Take.id, take_ids), Take.project_id == project_id, Take.cue_id.is_not(None))
    return set(session.scalars(query))


def position_of(session: Session, playlist_id: UUID, person_id: UUID) -> PlaylistPosition | None:
    """Return a person's stopping place in a playlist."""
    return session.get(PlaylistPosition, (playlist_id, person_id))


def views_of(session: Session, project_id: UUID, person_id: UUID, *, with_shared: bool) -> Sequence[SavedView]:
    """Return a person's views of a project by name; with the team's, those of the review queue by anyone."""
    is_own, is_shared = SavedView.person_id == person_id, SavedView.page == ViewedPage.REVIEW_QUEUE
    seen = or_(is_own, is_shared) if with_shared else is_own
    query = select(SavedView).where(SavedView.project_id == project_id, seen)
    return session.scalars(query.order_by(SavedView.name, SavedView.id)).all()


def view_by_id(session: Session, view_id: UUID) -> SavedView | None:
    """Return a saved view of anyone."""
    return session.get(SavedView, view_id)
