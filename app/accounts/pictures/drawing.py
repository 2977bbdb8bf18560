"""The work of the sandbox's child: a person's picture, decoded and drawn again as a small square."""

import re
from io import BytesIO

from app.accounts.errors import PictureRefused
from app.core.pictures import PictureLimits, PictureProblem, decode

MAX_BYTES = 10 << 20
MAX_PIXELS = 25_000_000
MAX_SIDE = 12_000
SQUARE_PX = 128
MEDIA_TYPE = "image/webp"
WANTED = "a PNG, JPEG or WebP picture is wanted"
AGAIN = "save it as a PNG or JPEG, then choose it again"
SMALLER = "make it smaller, then choose it again; 256 × 256 pixels are plenty"

_FORMATS = ("PNG", "JPEG", "WEBP")
_OTHER_KINDS = (
    (rb"$", "an empty file"),
    (rb"GIF8", "a GIF"),
    (rb"BM", "a BMP picture"),
    (rb"II\*\0|MM\0\*", "a TIFF picture"),
    (rb"....ftyp(?:heic|heix|mif1|msf1|hevc)", "a HEIC picture"),
    (rb"....ftypavi[fs]", "an AVIF picture"),
    (rb"....ftyp", "a video"),
    (rb"%PDF-", "a PDF"),
    (rb"RIFF....WAVE", "a sound"),
    (rb"(?s:\s*(?:<\?xml.{0,500})?<svg)", "an SVG drawing"),
    (rb"\s*<", "a page of markup"),
)
_PICTURE = re.compile(rb"\x89PNG\r\n\x1a\n|\xff\xd8\xff|RIFF....WEBP", re.DOTALL)


def draw_square(content: bytes) -> bytes:
    """Return the middle of a picture as a small square WebP that carries nothing else; raise PictureRefused."""
    from PIL import ImageOps  # only the child's server loads it

    if not _PICTURE.match(content):
        raise PictureRefused(f"this is {_kind_of(content)}; {WANTED}", fix=AGAIN)
    try:
        picture = decode(BytesIO(content), PictureLimits(_FORMATS, MAX_PIXELS, MAX_SIDE), within_px=2 * SQUARE_PX)
    except PictureProblem as problem:
        raise PictureRefused(problem.message, fix=SMALLER if problem.width else AGAIN) from None
    if picture.frames > 1:
        raise PictureRefused(f"this picture moves: it has {picture.frames:,} frames; one is wanted", fix=AGAIN)
    out = BytesIO()
    square = ImageOps.fit(picture.image, (SQUARE_PX, SQUARE_PX))
    square.save(out, "WEBP", quality=85, icc_profile=b"", exif=b"", xmp=b"")
    return out.getvalue()


def _kind_of(content: bytes) -> str:
    return next((name for begins, name in _OTHER_KINDS if re.match(begins, content[:1_000])), "a file of another kind")
