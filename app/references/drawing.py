"""Work of the sandbox's child: a stranger's picture, decoded and drawn again at two sizes."""

from pathlib import Path
from typing import TypedDict

from app.core.pictures import PictureLimits, PictureProblem, decode

FORMATS = ("PNG", "JPEG", "GIF", "WEBP")
MAX_PIXELS = 64_000_000
MAX_SIDE = 30_000
THUMB_PX = 480
VIEW_PX = 1_600
THUMB, VIEW = "thumb.webp", "view.webp"
MEDIA_TYPE = "image/webp"


class Previewed(TypedDict):
    """The size of a picture, and why it could not be drawn; empty where both previews are written."""

    width: int
    height: int
    problem: str


def draw_previews(path: str, folder: str) -> Previewed:
    """Write a picture again as WebP at two sizes, the way up that its camera noted, without what else it carries."""
    try:
        picture = decode(Path(path), PictureLimits(FORMATS, MAX_PIXELS, MAX_SIDE), within_px=VIEW_PX)
    except PictureProblem as problem:
        return {"width": problem.width, "height": problem.height, "problem": problem.message}
    drawn = picture.image
    drawn.thumbnail((VIEW_PX, VIEW_PX), reducing_gap=2.0)
    drawn.save(Path(folder, VIEW), "WEBP", quality=82)
    drawn.thumbnail((THUMB_PX, THUMB_PX))
    drawn.save(Path(folder, THUMB), "WEBP", quality=80)
    return {"width": picture.width, "height": picture.height, "problem": ""}
