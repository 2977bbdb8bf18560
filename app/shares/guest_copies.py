"""Copies of previews for guests: of what has beeps, and of what would else be the master's own file."""

import hashlib
from collections.abc import Collection, Iterable
from typing import NamedTuple
from uuid import UUID

from sqlalchemy.orm import Session

from app.core.db import insert_if_absent
from app.core.events import publish
from app.deliveries.models import Take
from app.renders.models import Picture
from app.shares import queries
from app.shares.beeps import BEEPS_VERSION
from app.shares.models import GuestCopy
from app.shares.queries import SharedTake


def copy_key(take: Take, picture: Picture, *, has_beeps: bool) -> str | None:
    """Return the key of the copy that guests get; None where they get the preview itself.

    A master of at most 48 kHz and 16 bit is its own preview: its metadata may name people, so guests get its frames.
    """
    if not has_beeps and picture.preview_sha256 != take.master_sha256:
        return None
    made_of = f"{picture.preview_sha256} beeps {BEEPS_VERSION if has_beeps else 'none'}"
    return hashlib.sha256(made_of.encode()).hexdigest()


def request_copies(session: Session, studio_id: UUID, shared: Iterable[SharedTake], *, has_beeps: bool) -> None:
    """Have the copies made that guests of a link need and that nobody asked for yet."""
    for shared_take in shared:
        if shared_take.picture is None or shared_take.picture.preview_sha256 is None:
            continue
        key = copy_key(shared_take.take, shared_take.picture, has_beeps=has_beeps)
        if key is None:
            continue
        row = {
            "studio_id": studio_id,
            "key": key,
            "preview_sha256": shared_take.picture.preview_sha256,
            "has_beeps": has_beeps,
        }
        if insert_if_absent(session, GuestCopy, row, unique=("studio_id", "key")):
            publish(session, "guest_copy.asked", studio_id=studio_id, key=key)


class Playable(NamedTuple):
    """A guest's playable file, and the reason for none; neither while it is being made."""

    sha256: str | None
    refusal: str | None


def playable(session: Session, shared: Collection[SharedTake], *, has_beeps: bool) -> dict[int, Playable]:
    """Return the guests' file of each sound, by its place."""
    keys = {
        shared_sound.place: copy_key(shared_sound.take, shared_sound.picture, has_beeps=has_beeps)
        for shared_sound in shared
        if shared_sound.picture
    }
    copies = queries.copies_of(
        session, {shared_sound.take.studio_id for shared_sound in shared}, [key for key in keys.values() if key]
    )
    by_place = {}
    for shared_take in shared:
        key = keys.get(shared_take.place)
        if shared_take.picture is None or shared_take.picture.preview_sha256 is None:
            by_place[shared_take.place] = Playable(None, None)
        elif key is None:
            by_place[shared_take.place] = Playable(shared_take.picture.preview_sha256, None)
        else:
            copy = copies.get(key)
            by_place[shared_take.place] = Playable(copy.sha256, copy.refusal) if copy else Playable(None, None)
    return by_place
