"""Guest links as the team makes, changes and revokes them, and who heard what by them."""

from collections.abc import Mapping, Sequence
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts import passwords
from app.accounts.authentication import sha256_of
from app.accounts.rules import AccessKind, Actor, MemberChange, ensure_strong_password
from app.accounts.schemas import PersonBrief
from app.accounts.security_log.rules import SecurityEventKind
from app.accounts.security_log.service import record
from app.core import clock
from app.core.db import new_id
from app.core.errors import FieldProblem
from app.projects.errors import ProjectNotFound
from app.projects.service import ProjectAccess, project_access
from app.shares import queries
from app.shares.errors import GuestLinkInvalid, GuestLinkNotFound, NothingToShare
from app.shares.guest_copies import request_copies
from app.shares.models import GuestLink, GuestSound
from app.shares.playlists import playlist_in
from app.shares.rules import MAX_SOUNDS, SharedKind, heard_takes, link_secret, link_state
from app.shares.schemas import GuestLinkAdd, GuestLinkRead, GuestVisitRead, SoundPlayed


def make_link(
    session: Session, actor: Actor, project_id: UUID, body: GuestLinkAdd, *, server_key: str
) -> tuple[GuestLinkRead, str]:
    """Share the body's sounds as they are now; return the link and the secret of its address."""
    access = project_access(session, actor, project_id)
    access.ensure_may_speak()
    if body.expires_at is not None and body.expires_at <= clock.now():
        raise _invalid("expires_at", "this is over already; choose a later day")
    if body.password is not None:
        ensure_strong_password(body.password, "", body.title)
    take_ids = _chosen(session, access, body)
    link_id = new_id()
    secret = link_secret(server_key, link_id)
    of = {"studio_id": access.project.studio_id, "project_id": project_id}
    link = GuestLink(
        **of,
        id=link_id,
        kind=body.kind,
        title=body.title,
        secret_sha256=sha256_of(secret),
        password_hash=None if body.password is None else passwords.hash_of(body.password),
        may_comment=body.may_comment,
        has_beeps=body.has_beeps,
        expires_at=body.expires_at,
        max_openings=body.max_openings,
        made_by=actor.person,
    )
    session.add(link)
    session.flush()
    session.add_all(
        GuestSound(**of, link_id=link_id, place=position, take_id=take_id)
        for position, take_id in enumerate(take_ids, 1)
    )
    session.flush()
    request_copies(session, link.studio_id, queries.shared_takes(session, link_id), has_beeps=link.has_beeps)
    _record(session, actor, link, "made")
    return _read_one(session, actor, link_id), secret


def _chosen(session: Session, access: ProjectAccess, body: GuestLinkAdd) -> list[UUID]:
    """Return the takes that a link shares: of each variation the approved one, else the newest that waits."""
    project_id = access.project.id
    match body.kind:
        case SharedKind.CUES:
            if not body.cue_ids:
                raise _invalid("cue_ids", "name one cue or more")
            takes = heard_takes(queries.candidates(session, project_id, *queries.of_cues(body.cue_ids)))
        case SharedKind.PLAYLIST:
            if body.playlist_id is None:
                raise _invalid("playlist_id", "name the playlist")
            playlist = playlist_in(session, access, body.playlist_id)
            takes = [playlist_take.take.id for playlist_take in queries.playlist_takes(session, playlist.id)]
        case kind:
            is_palette = kind is SharedKind.PALETTE
            takes = heard_takes(queries.candidates(session, project_id, *queries.approved(palette=is_palette)))
    if not takes:
        raise NothingToShare(
            "none of what you chose has a version that can be played",
            fix="wait until a version was delivered and checked, or choose other cues",
        )
    if len(takes) > MAX_SOUNDS:
        raise _invalid("kind", f"these are {len(takes)} sounds; a link has at most {MAX_SOUNDS}")
    return takes


def links_of(
    session: Session, actor: Actor, project_id: UUID, *, before: UUID | None, limit: int
) -> list[GuestLinkRead]:
    """Return the guest links of a project, newest first."""
    project_access(session, actor, project_id).ensure_may_speak()
    return read_links(session, actor, queries.links_in(session, project_id, before=before, limit=limit))


def change_link(session: Session, actor: Actor, link_id: UUID, changes: Mapping[str, Any]) -> GuestLinkRead:
    """Change until when and how often a link opens, and whether guests may comment."""
    link = _link_for(session, actor, link_id)
    for name, value in changes.items():
        setattr(link, name, value)
    session.flush()
    return _read_one(session, actor, link_id)


def revoke_link(session: Session, actor: Actor, link_id: UUID) -> GuestLinkRead:
    """Let a link open nothing any more, at once and for good; the record of who heard what stays."""
    link = _link_for(session, actor, link_id)
    if link.revoked_at is None:
        link.revoked_at, link.revoked_by = clock.now(), actor.person
        _record(session, actor, link, "revoked")
    return _read_one(session, actor, link_id)


def end_links_of_member(session: Session, payload: Mapping[str, Any]) -> None:
    """Revoke the links of who left the studio, or keep them in another name: a handler of `member.changed`."""
    change = MemberChange.of(payload)
    if not change.has_left:
        return
    for link in queries.open_links_by(session, change.studio_id, change.person_id):
        if AccessKind.GUEST_LINKS in change.kept:
            link.made_by = change.changed_by
        else:
            link.revoked_at, link.revoked_by = clock.now(), change.changed_by
    session.flush()


def secret_of(session: Session, actor: Actor, link_id: UUID, *, server_key: str) -> str:
    """Return the secret of a link's address to who made the link."""
    link = _link_for(session, actor, link_id)
    secret = link_secret(server_key, link_id)
    if link.made_by != actor.person or sha256_of(secret) != link.secret_sha256:
        raise GuestLinkNotFound(
            "the address is shown to the person who made the link, and only while the server has the key it had then",
            fix="ask that person, or make another link",
        )
    return secret


def visits_of(
    session: Session, actor: Actor, link_id: UUID, *, before: UUID | None, limit: int
) -> list[GuestVisitRead]:
    """Return the visits by a link: person, time, and plays of each sound, newest first."""
    _link_for(session, actor, link_id)
    visits = queries.visits_of(session, link_id, before=before, limit=limit)
    played: dict[UUID, list[SoundPlayed]] = {visit.id: [] for visit in visits}
    for play, cue_name, variation in queries.plays_of_visits(session, link_id, played):
        played[play.visit_id].append(
            SoundPlayed(
                place=play.place, cue_name=cue_name, variation=variation, plays=play.plays, last_at=play.last_at
            )
        )
    return [
        GuestVisitRead(id=visit.id, guest_name=visit.guest_name, opened_at=visit.opened_at, played=played[visit.id])
        for visit in visits
    ]


def read_links(session: Session, actor: Actor, links: Sequence[GuestLink]) -> list[GuestLinkRead]:
    """Return links as the team sees them; who made each is loaded."""
    ids = [link.id for link in links]
    sounds, plays = queries.sound_counts(session, ids), queries.play_counts(session, ids)
    now = clock.now()
    return [
        GuestLinkRead(
            id=link.id,
            kind=link.kind,
            title=link.title,
            state=link_state(
                now,
                revoked_at=link.revoked_at,
                expires_at=link.expires_at,
                max_openings=link.max_openings,
                openings=link.openings,
            ),
            sounds=sounds.get(link.id, 0),
            has_password=link.password_hash is not None,
            may_comment=link.may_comment,
            has_beeps=link.has_beeps,
            expires_at=link.expires_at,
            max_openings=link.max_openings,
            openings=link.openings,
            plays=plays.get(link.id, 0),
            made_by=PersonBrief.model_validate(link.maker),
            created_at=link.created_at,
            revoked_at=link.revoked_at,
            is_own=link.made_by == actor.person,
        )
        for link in links
    ]


def _read_one(session: Session, actor: Actor, link_id: UUID) -> GuestLinkRead:
    link = queries.link_by_id(session, link_id)
    (read,) = read_links(session, actor, [link] if link else [])
    return read


def _link_for(session: Session, actor: Actor, link_id: UUID) -> GuestLink:
    link = queries.link_by_id(session, link_id)
    if link is None:
        raise GuestLinkNotFound(f"no guest link {link_id}")
    try:
        access = project_access(session, actor, link.project_id)
    except ProjectNotFound:
        raise GuestLinkNotFound(f"no guest link {link_id}") from None
    if not access.is_team:
        raise GuestLinkNotFound(f"no guest link {link_id}")
    access.ensure_may_speak()
    return link


def _record(session: Session, actor: Actor, link: GuestLink, act: str) -> None:
    summary = f"{act} the guest link {link.title}"
    record(
        session,
        SecurityEventKind.GUEST_LINK,
        summary,
        studio_ids=[link.studio_id],
        project_id=link.project_id,
        person_id=actor.person,
    )


def _invalid(where: str, message: str) -> GuestLinkInvalid:
    return GuestLinkInvalid(message, errors=[FieldProblem(where=where, message=message)])
