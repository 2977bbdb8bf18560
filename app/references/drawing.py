"""What runs in the sandbox's child: a stranger's picture, decoded and drawn again at two sizes."""

import warnings
from pathlib import Path
from typing import TypedDict

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
    from PIL import Image, ImageOps, UnidentifiedImageError  # only the child's server loads it

    warnings.simplefilter("ignore")
    Image.MAX_IMAGE_PIXELS = None  # the size is looked at here, and refused in our words
    try:
        with Image.open(path, formats=FORMATS) as opened:
            width, height = opened.size
            if width * height > MAX_PIXELS or max(width, height) > MAX_SIDE:
                problem = (
                    f"this picture has {width:,} × {height:,} pixels; at most {MAX_PIXELS:,} are drawn, "
                    f"and {MAX_SIDE:,} on a side"
                )
                return {"width": width, "height": height, "problem": problem}
            opened.draft("RGB", (VIEW_PX, VIEW_PX))
            picture = ImageOps.exif_transpose(opened)
            if picture.mode.startswith("I"):  # 16 bits of grey, which a plain conversion would clip to white
                picture = picture.convert("I").point(lambda grey: grey * (1 / 256)).convert("L")
            drawn = picture.convert("RGBA" if picture.has_transparency_data else "RGB")
            drawn.thumbnail((VIEW_PX, VIEW_PX), reducing_gap=2.0)
    except (UnidentifiedImageError, OSError, SyntaxError, ValueError, EOFError):
        return {"width": 0, "height": 0, "problem": "this picture is damaged: its pixels cannot be read"}
    drawn.save(Path(folder, VIEW), "WEBP", quality=82)
    drawn.thumbnail((THUMB_PX, THUMB_PX))
    drawn.save(Path(folder, THUMB), "WEBP", quality=80)
    return {"width": width, "height": height, "problem": ""}


def rehearse() -> None:
    """Load what decodes and writes pictures, for all the children to come."""
    from PIL import Image

    Image.init()
