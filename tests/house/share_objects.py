"""A guest link with a visit, a playlist with a session, and a view, as part of one of everything."""

from typing import TYPE_CHECKING
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.authentication import new_secret, sha256_of
from app.core import clock
from app.shares.models import (
    GuestLink,
    GuestPlay,
    GuestSound,
    GuestVisit,
    LiveListener,
    LiveSession,
    Playlist,
    PlaylistEntry,
    PlaylistPosition,
    SavedView,
)
from app.shares.rules import SharedKind, ViewedPage, link_secret

if TYPE_CHECKING:
    from tests.house.objects import House


def add_shares(session: Session, of: dict[str, UUID], take_id: UUID, house: "House") -> dict[str, UUID | int]:
    """Add what is shared of a take; note the secrets in the house's links, and return ids by path names."""
    made_by, links = house.producer_id, house.links
    server_key = house.server.runtime.settings.secret_key.get_secret_value()
    link = GuestLink(
        **of, kind=SharedKind.CUES, title="Shield", secret_sha256="", may_comment=True, has_beeps=False, openings=1,
        made_by=made_by,
    )  # fmt: skip
    playlist = Playlist(**of, name="Shields", made_by=made_by)
    session.add_all([link, playlist])
    session.flush()
    links["guest-access"], links["guest-visits"] = link_secret(server_key, link.id), new_secret()
    link.secret_sha256 = sha256_of(links["guest-access"])
    visit = GuestVisit(**of, link_id=link.id, secret_sha256=sha256_of(links["guest-visits"]), guest_name="the composer")
    view = SavedView(**of, person_id=house.designer_id, page=ViewedPage.SOUND_LIST, name="Must", query="need=must")
    session.add_all([visit, view])
    session.flush()
    of_list = {**of, "playlist_id": playlist.id}
    session.add_all(
        [
            GuestSound(**of, link_id=link.id, place=1, take_id=take_id),
            GuestPlay(**of, visit_id=visit.id, place=1, plays=1),
            PlaylistEntry(**of_list, place=1, take_id=take_id),
            PlaylistPosition(**of_list, person_id=made_by, take_id=take_id, at_s=0.5),
            LiveSession(**of_list, sequence=1, holder_id=made_by),
            LiveListener(**of_list, person_id=made_by, seen_at=clock.now()),
        ]
    )
    return {"guest_link_id": link.id, "playlist_id": playlist.id, "saved_view_id": view.id, "place": 1}
