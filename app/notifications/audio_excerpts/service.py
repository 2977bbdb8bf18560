"""The pictures of the places that an email leads to."""

from collections.abc import Mapping
from dataclasses import dataclass
from email.utils import make_msgid
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.notifications import queries
from app.notifications.audio_excerpts.drawing import draw
from app.notifications.audio_excerpts.rules import SpotPicture
from app.notifications.models import Mail

MAX_PICTURES = 8  # of one email, some 2 kB each; further places are addresses alone


@dataclass(frozen=True)
class ShownSpot:
    """The drawing of a place: the shape of its sound, and the position in it."""

    alt: str
    thumb: Mapping[str, Any]
    duration_s: float
    at_s: float | None


def shown_spots(session: Session, mail: Mail) -> dict[str, ShownSpot]:
    """Return the places of an email whose sounds are drawn, by their addresses."""
    first = dict(list(mail.spots.items())[:MAX_PICTURES])
    pictures = queries.pictures_of_takes(session, {UUID(spot["take_id"]) for spot in first.values()})
    return {
        address: ShownSpot(spot["alt"], picture.thumb, picture.duration_s or 0.0, spot["at_s"])
        for address, spot in first.items()
        if (picture := pictures.get(UUID(spot["take_id"]))) and picture.thumb
    }


def pictures_of(spots: Mapping[str, ShownSpot]) -> dict[str, SpotPicture]:
    """Draw places, by their addresses."""
    return {
        address: SpotPicture(
            png=draw(spot.thumb, duration_s=spot.duration_s, at_s=spot.at_s),
            cid=make_msgid(domain="soundlist").strip("<>"),
            alt=spot.alt,
        )
        for address, spot in spots.items()
    }
