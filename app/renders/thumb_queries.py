"""The shapes of sounds in rows of lists. What was drawn of a sound never changes, and pages show the same again."""

from collections.abc import Iterable
from functools import cache
from typing import Any
from uuid import UUID

from sqlalchemy import Select, select
from sqlalchemy.orm import Session

from app.core.in_array import in_array
from app.core.lru_cache import LRUCache
from app.renders.models import Picture

Thumb = dict[str, Any]  # points, min, max, rms
_remembered: LRUCache[UUID, Thumb] = LRUCache(2_000)  # some 7 kB each


def thumbs(session: Session, picture_ids: Iterable[UUID]) -> dict[UUID, Thumb]:
    """Return the thumbs of pictures that the caller was found to see; read are those that are not remembered."""
    thumbs = {id_: _remembered.get(id_) for id_ in picture_ids}
    if unknown := [id_ for id_, thumb in thumbs.items() if thumb is None]:
        for id_, thumb in session.execute(_thumbs(), {"ids": unknown}):
            thumbs[id_] = _remembered.keep(id_, thumb)
    return {id_: thumb for id_, thumb in thumbs.items() if thumb is not None}


@cache  # built once: that takes longer than to send it
def _thumbs() -> Select[UUID, Thumb]:
    return select(Picture.id, Picture.thumb).where(in_array(Picture.id, "ids"))
