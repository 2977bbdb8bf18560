"""Places in sounds that emails lead to, each by a picture with a play button, stated without a database."""

from collections.abc import Mapping
from dataclasses import dataclass
from html import escape
from typing import Any
from uuid import UUID

WIDTH_PX, HEIGHT_PX = 320, 48  # of a picture as it is shown

_STYLE = "font-family:system-ui,sans-serif;font-size:15px;line-height:1.5"


@dataclass(frozen=True)
class Spot:
    """A place in a version: its page, what a picture of it says to who cannot see it, and the second."""

    take_id: UUID
    path: str
    alt: str
    at_s: float | None

    def stored(self) -> dict[str, Any]:
        """Return the outbox's record of it."""
        return {"take_id": str(self.take_id), "alt": self.alt, "at_s": self.at_s}


@dataclass(frozen=True)
class SpotLine:
    """A line of news with the place that it is about."""

    text: str
    spot: Spot


@dataclass(frozen=True)
class SpotPicture:
    """A drawn picture of a place, its name within the email, and its words."""

    png: bytes
    cid: str
    alt: str


def spot_of(
    take_id: UUID, label: str, at_s: float | None, *, project_id: UUID, reviewed_cue_id: UUID | None = None
) -> Spot:
    """Return the place as its reader opens it: in Review where a cue is named, otherwise on the version's page."""
    at = "" if at_s is None else f"{at_s:g}"
    alt = f"Play {label}" + ("" if at_s is None else f" from {at_s:.3f} s")
    if reviewed_cue_id is None:
        return Spot(take_id, f"/takes/{take_id}" + (at and f"?at={at}"), alt, at_s)
    path = f"/projects/{project_id}/review/{reviewed_cue_id}?take={take_id}" + (at and f"&at={at}")
    return Spot(take_id, path, alt, at_s)


def html_of(text: str, pictures: Mapping[str, SpotPicture]) -> str:
    """Return an email's text as HTML, in which a picture takes the place of each address that has one."""
    lines = (_html_line(line, pictures) for line in text.split("\n"))
    return f'<!doctype html><html lang="en"><body style="{_STYLE}">{"<br>".join(lines)}</body></html>'


def _html_line(line: str, pictures: Mapping[str, SpotPicture]) -> str:
    address = escape(line.strip(), quote=True)
    if picture := pictures.get(line.strip()):
        size = f'width="{WIDTH_PX}" height="{HEIGHT_PX}"'
        shown = f'<img src="cid:{picture.cid}" alt="{escape(picture.alt)}" {size} style="border:0">'
        return f'<a href="{address}">{shown}</a>'
    if line.startswith(("https://", "http://")) and " " not in line:
        return f'<a href="{address}">{address}</a>'
    return escape(line).replace("  ", "&nbsp; ")
