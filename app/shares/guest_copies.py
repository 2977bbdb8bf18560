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
    for one in shared:
        if one.picture is None or one.picture.preview_sha256 is None:
            continue
        key = copy_key(one.take, one.picture, has_beeps=has_beeps)
        if key is None:
            continue
        row = {"studio_id": studio_id, "key": key, "preview_sha256": one.picture.preview_sha256, "has_beeps": has_beeps}
        if insert_if_absent(session, GuestCopy, row, unique=("studio_id", "key")):
            publish(session, "guest_copy.asked", studio_id=studio_id, key=key)


class Playable(NamedTuple):
    """A guest's playable file, and the reason for none; neither while it is being made."""

    sha256: str | None
    refusal: str | None


def playable(session: Session, shared: Collection[SharedTake], *, has_beeps: bool) -> dict[int, Playable]:
    """Return the guests' file of each sound, by its place."""
    keys = {one.place: copy_key(one.take, one.picture, has_beeps=has_beeps) for one in shared if one.picture}
    copies = queries.copies_of(session, {one.take.studio_id for one in shared}, [key for key in keys.values() if key])
    found = {}
    for one in shared:
        key = keys.get(one.place)
        if one.picture is None or one.picture.preview_sha256 is None:
            found[one.place] = Playable(None, None)
        elif key is None:
            found[one.place] = Playable(one.picture.preview_sha256, None)
        else:
            copy = copies.get(key)
            found[one.place] = Playable(copy.sha256, copy.refusal) if copy else Playable(None, None)
    return found
