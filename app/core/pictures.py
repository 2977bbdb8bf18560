"""Strangers' pictures, decoded within limits of size; runs in a child of the sandbox."""

import warnings
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from PIL.Image import Image


class PictureProblem(Exception):
    """A picture that is not decoded, with the reason in words and its size where that is known."""

    def __init__(self, message: str, *, width: int = 0, height: int = 0) -> None:
        super().__init__(message)
        self.message, self.width, self.height = message, width, height


@dataclass(frozen=True)
class PictureLimits:
    """The formats that are decoded, and the largest size."""

    formats: tuple[str, ...]
    max_pixels: int
    max_side: int


@dataclass(frozen=True)
class Picture:
    """A decoded picture in RGB or RGBA, the size that its file has, and how many frames that holds."""

    image: "Image"
    width: int
    height: int
    frames: int


def decode(source: Path | BytesIO, limits: PictureLimits, *, within_px: int) -> Picture:
    """Decode a picture, the way up that its camera noted; raise PictureProblem.

    A JPEG is decoded at the smallest of its sizes that holds a square of `within_px`.
    """
    from PIL import Image, ImageOps, UnidentifiedImageError  # only the child's server loads it

    warnings.simplefilter("ignore")
    Image.MAX_IMAGE_PIXELS = None  # the size is looked at here, and refused in our words
    try:
        with Image.open(source, formats=limits.formats) as opened:
            width, height = opened.size
            if width * height > limits.max_pixels or max(width, height) > limits.max_side:
                raise PictureProblem(
                    f"this picture has {width:,} × {height:,} pixels; at most {limits.max_pixels:,} are drawn, "
                    f"and {limits.max_side:,} on a side",
                    width=width,
                    height=height,
                )
            frames = int(getattr(opened, "n_frames", 1))
            opened.draft("RGB", (within_px, within_px))
            picture = ImageOps.exif_transpose(opened)
            if picture.mode.startswith("I"):  # 16 bits of grey, which a plain conversion would clip to white
                picture = picture.convert("I").point(lambda grey: grey * (1 / 256)).convert("L")
            drawn = picture.convert("RGBA" if picture.has_transparency_data else "RGB")
    except (UnidentifiedImageError, OSError, SyntaxError, ValueError, EOFError):
        raise PictureProblem("this picture is damaged: its pixels cannot be read") from None
    return Picture(drawn, width, height, frames)


def preload() -> None:
    """Load the code that decodes and writes pictures, for all the children to come."""
    from PIL import Image

    Image.init()
