"""Actions of guests by a link, without an account: open it, hear its sounds, comment on them."""

import unicodedata
from typing import NamedTuple
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts import passwords
from app.accounts.authentication import new_secret, sha256_of
from app.core import clock
from app.core.db import Database, bypass_row_policies
from app.renders.thumb_queries import thumbs
from app.reviews.rounds.comments import add_guest_comment
from app.shares import queries
from app.shares.errors import (
    CommentsClosed,
    GuestLinkNotFound,
    GuestPasswordWrong,
    GuestSoundNotFound,
    GuestSoundNotMade,
    GuestSoundUnplayed,
    GuestVisitOver,
)
from app.shares.guest_copies import playable, request_copies
from app.shares.models import GuestLink, GuestPlay, GuestVisit
from app.shares.queries import SharedTake
from app.shares.rules import LinkState, link_state, visit_is_over
from app.shares.schemas import GuestCommentRead, GuestRoom, GuestSoundRead

# One sentence for every reason, so that nobody learns which links there were.
OPENS_NOTHING = "This link does not open anything any more."
ASK_AGAIN = "ask the person who sent it for a new one"


class Opened(NamedTuple):
    """A visit that began, by its secret."""

    secret: str
    room: GuestRoom


def access_password(session: Session, secret: str) -> str | None:
    """Return the hash of a link's password, None where it asks for none; raise unless the link opens."""
    with bypass_row_policies(session):  # only the secret identifies the link
        return _open_link(session, secret).password_hash


def ensure_password(password_hash: str | None, password: str | None) -> None:
    """Raise GuestPasswordWrong unless a link asks for no password or this is it; outside of any transaction."""
    if password_hash is not None and not passwords.matches(password or "", password_hash):
        raise GuestPasswordWrong("this is not the link's password", fix="ask the person who sent you the link")


def password_hash_of(database: Database, secret: str) -> str | None:
    """Return the hash of a link's password in a transaction of its own, so that no hashing holds one."""
    with database.reading() as session:
        return access_password(session, secret)


def open_link(session: Session, secret: str, guest_name: str) -> Opened:
    """Count one opening of a link whose password was checked, and begin a visit."""
    with bypass_row_policies(session):  # nobody is signed in
        link = _open_link(session, secret, locked=True)
        link.openings += 1
        visit_secret = new_secret()
        visit = GuestVisit(
            studio_id=link.studio_id,
            project_id=link.project_id,
            link_id=link.id,
            secret_sha256=sha256_of(visit_secret),
            guest_name=plain_name(guest_name),
        )
        session.add(visit)
        session.flush()
        return Opened(visit_secret, _room(session, link, visit))


def room_of(session: Session, visit_secret: str) -> GuestRoom:
    """Return the content of a visit; raise GuestVisitOver when it is over."""
    with bypass_row_policies(session):  # nobody is signed in
        visit = _visit(session, visit_secret)
        return _room(session, visit.link, visit)


def record_play(session: Session, visit_secret: str, position: int) -> None:
    """Count one playing of a sound."""
    with bypass_row_policies(session):  # nobody is signed in
        visit = _visit(session, visit_secret)
        shared_take = _sound(session, visit, position)
        request_copies(
            session, visit.studio_id, [shared_take], has_beeps=visit.link.has_beeps
        )  # a preview drawn again has none
        play = queries.play_in(session, visit.id, position)
        if play is None:
            play = GuestPlay(
                visit_id=visit.id, place=position, studio_id=visit.studio_id, project_id=visit.project_id, plays=0
            )
            session.add(play)
        play.plays += 1
        play.last_at = clock.now()
        session.flush()


def played_sha256(session: Session, visit_secret: str, position: int) -> tuple[UUID, str]:
    """Return studio and hash of what a guest plays, whose playing is on record."""
    with bypass_row_policies(session):  # nobody is signed in
        visit = _visit(session, visit_secret)
        shared_take = _sound(session, visit, position)
        if queries.play_in(session, visit.id, position) is None:
            raise GuestSoundUnplayed(
                "each playing is recorded first, and this was not",
                fix=f"send POST /v1/guest-visits/…/sounds/{position}/plays, then ask again",
            )
        sha256, refusal = playable(session, [shared_take], has_beeps=visit.link.has_beeps)[position]
        if sha256 is None:
            raise GuestSoundNotMade(refusal or "this sound is still being made ready", fix="try again in a moment")
        return visit.studio_id, sha256


def comment(
    session: Session, visit_secret: str, position: int, *, text: str, start_s: float | None, end_s: float | None
) -> GuestCommentRead:
    """Write a guest's advice on a sound, for those who see its take."""
    with bypass_row_policies(session):  # nobody is signed in
        visit = _visit(session, visit_secret)
        shared_take = _sound(session, visit, position)
        if not visit.link.may_comment:
            raise CommentsClosed("this link is for listening only", fix="write to the person who sent it")
        comment_added = add_guest_comment(
            session, shared_take.take, visit.guest_name, text=text, start_s=start_s, end_s=end_s
        )
        return GuestCommentRead(
            text=comment_added.text,
            start_s=comment_added.start_s,
            end_s=comment_added.end_s,
            created_at=comment_added.created_at,
        )


def plain_name(typed: str) -> str:
    """Return a typed name on one line, without signs that do not print; some words where nothing is left."""
    printed = "".join(
        " " if character.isspace() else character for character in typed if character.isspace() or _prints(character)
    )
    return " ".join(printed.split()) or "without a name"


def _prints(sign: str) -> bool:
    return not unicodedata.category(sign).startswith("C")


def _open_link(session: Session, secret: str, *, locked: bool = False) -> GuestLink:
    link = queries.link_by_secret(session, sha256_of(secret), locked=locked)
    state = None
    if link is not None:
        state = link_state(
            clock.now(),
            revoked_at=link.revoked_at,
            expires_at=link.expires_at,
            max_openings=link.max_openings,
            openings=link.openings,
        )
    if link is None or state is not LinkState.OPEN:
        raise GuestLinkNotFound(OPENS_NOTHING, fix=ASK_AGAIN)
    return link


def _visit(session: Session, visit_secret: str) -> GuestVisit:
    visit = queries.visit_by_secret(session, sha256_of(visit_secret))
    if visit is None or visit_is_over(
        clock.now(), visit.opened_at, revoked_at=visit.link.revoked_at, expires_at=visit.link.expires_at
    ):
        raise GuestVisitOver(OPENS_NOTHING, fix=ASK_AGAIN)
    return visit


def _sound(session: Session, visit: GuestVisit, position: int) -> SharedTake:
    shared = queries.shared_takes(session, visit.link_id, place=position)
    if not shared:
        raise GuestSoundNotFound(f"this link has no sound {position}")
    return shared[0]


def _room(session: Session, link: GuestLink, visit: GuestVisit) -> GuestRoom:
    shared = queries.shared_takes(session, link.id)
    drawn = thumbs(session, [shared_take.picture.id for shared_take in shared if shared_take.picture])
    ready = playable(session, shared, has_beeps=link.has_beeps)
    return GuestRoom(
        title=link.title,
        guest_name=visit.guest_name,
        may_comment=link.may_comment,
        has_beeps=link.has_beeps,
        sounds=[
            GuestSoundRead(
                place=shared_take.place,
                name=shared_take.cue.name,
                variation=shared_take.take.variation if shared_take.cue.variations > 1 else None,
                duration_s=shared_take.picture.duration_s if shared_take.picture else None,
                thumb=(drawn.get(shared_take.picture.id) or None) if shared_take.picture else None,
                is_ready=ready[shared_take.place].sha256 is not None,
            )
            for shared_take in shared
        ],
    )
