"""The kind of a file by its bytes, how each kind is sent, addresses of links, and ranges: without a database."""

import codecs
import re
from dataclasses import dataclass
from enum import StrEnum
from urllib.parse import urlsplit

from app.core.errors import FieldProblem
from app.references.errors import ReferenceInvalid

HEAD_BYTES = 1 << 16  # of a file, by which its kind is known
EXCERPT_CHARS = 4_000
MAX_URL_CHARS = 2_000
MAX_RANGE_S = 24 * 3600.0


class ReferenceKind(StrEnum):
    """The kinds of a reference: all but the last two are known by their bytes."""

    PICTURE = "picture"
    PDF = "pdf"
    TEXT = "text"
    VIDEO = "video"
    AUDIO = "audio"
    FILE = "file"  # any other: for download only
    LINK = "link"


class PreviewState(StrEnum):
    """The states of the preview of a version."""

    NONE = "none"  # of what is not a picture
    PENDING = "pending"
    MADE = "made"
    REFUSED = "refused"


@dataclass(frozen=True)
class FoundType:
    """The kind and the media type of a file."""

    kind: ReferenceKind
    media_type: str

    @property
    def plays(self) -> bool:
        """Whether it has a length, of which a range can be named."""
        return self.kind in (ReferenceKind.VIDEO, ReferenceKind.AUDIO)


UNKNOWN = FoundType(ReferenceKind.FILE, "application/octet-stream")
TEXT = FoundType(ReferenceKind.TEXT, "text/plain; charset=utf-8")
_BEGINNINGS = (
    (b"\x89PNG\r\n\x1a\n", FoundType(ReferenceKind.PICTURE, "image/png")),
    (b"\xff\xd8\xff", FoundType(ReferenceKind.PICTURE, "image/jpeg")),
    (b"GIF87a", FoundType(ReferenceKind.PICTURE, "image/gif")),
    (b"GIF89a", FoundType(ReferenceKind.PICTURE, "image/gif")),
    (b"%PDF-", FoundType(ReferenceKind.PDF, "application/pdf")),
    (b"fLaC", FoundType(ReferenceKind.AUDIO, "audio/flac")),
    (b"ID3", FoundType(ReferenceKind.AUDIO, "audio/mpeg")),
)
_RIFF = {
    b"WAVE": FoundType(ReferenceKind.AUDIO, "audio/wav"),
    b"WEBP": FoundType(ReferenceKind.PICTURE, "image/webp"),
}
_MP4 = FoundType(ReferenceKind.VIDEO, "video/mp4")
_BRANDS = {
    **dict.fromkeys((b"M4A ", b"M4B "), FoundType(ReferenceKind.AUDIO, "audio/mp4")),
    b"qt  ": FoundType(ReferenceKind.VIDEO, "video/quicktime"),
    **dict.fromkeys(
        (b"isom", b"iso2", b"iso4", b"iso5", b"iso6", b"mp41", b"mp42", b"avc1", b"M4V ", b"dash", b"MSNV", b"3gp4",
         b"3gp5"),
        _MP4,
    ),
}  # fmt: skip
_MARKUP = re.compile(rb"<(?:!doctype|\?xml|html|svg|script|head|body|iframe)", re.IGNORECASE)
_CONTROL = re.compile(r"[\x00-\x08\x0b\x0e-\x1f\x7f]")


def type_of(head: bytes) -> FoundType:
    """Return the type of a file by its first HEAD_BYTES bytes; its name says nothing that counts.

    What a browser might run (HTML, SVG, XML) is a file for download, as is all that is not known.
    """
    for beginning, file_type in _BEGINNINGS:
        if head.startswith(beginning):
            return file_type
    if head[:4] in (b"RIFF", b"RF64"):
        return _RIFF.get(head[8:12], UNKNOWN)
    if head[4:8] == b"ftyp":
        return _BRANDS.get(head[8:12], UNKNOWN)
    if head.startswith(b"OggS"):
        return UNKNOWN if b"theora" in head[:512] else FoundType(ReferenceKind.AUDIO, "audio/ogg")
    if head.startswith(b"\x1a\x45\xdf\xa3"):
        return FoundType(ReferenceKind.VIDEO, "video/webm") if b"webm" in head[:64] else UNKNOWN
    if _is_mpeg_layer_3(head):
        return FoundType(ReferenceKind.AUDIO, "audio/mpeg")
    return TEXT if text_in(head) is not None else UNKNOWN


def _is_mpeg_layer_3(head: bytes) -> bool:
    """Whether a file begins with the header of a frame of MPEG audio, layer III, of a valid rate."""
    if len(head) < 4 or head[0] != 0xFF or head[1] & 0xE6 != 0xE2:
        return False
    is_version, bitrate, rate = head[1] & 0x18 != 0x08, head[2] >> 4, head[2] >> 2 & 3
    return is_version and bitrate not in (0, 15) and rate != 3


def text_in(head: bytes) -> str | None:
    """Return the plain text that a file begins with; None where it is not UTF-8, is markup, or has control characters.

    A character that the end of `head` cuts in two is left out.
    """
    try:
        text = codecs.getincrementaldecoder("utf-8-sig")().decode(head, final=len(head) < HEAD_BYTES)
    except UnicodeDecodeError:
        return None
    if not text.strip() or _CONTROL.search(text) or _MARKUP.search(head):
        return None
    return text


def host_of(url: str) -> str:
    """Return the host of a link as it is shown; raise ReferenceInvalid for what is not a plain https address."""
    try:
        parts = urlsplit(url)
        host, port = parts.hostname, parts.port
    except ValueError:
        raise _bad("url", "this is not an address; copy it from the browser's address bar") from None
    if len(url) > MAX_URL_CHARS or re.search(r"[\s\x00-\x1f\x7f\\]", url):
        raise _bad("url", f"an address has at most {MAX_URL_CHARS:,} characters, and no spaces or backslashes")
    if parts.scheme != "https" or not host:
        raise _bad("url", "only addresses that begin with https:// can be added")
    if "@" in parts.netloc:
        raise _bad("url", "an address with a name or password in it cannot be shared; remove what stands before the @")
    try:
        shown = host.encode("ascii").decode() if host.isascii() else host.encode("idna").decode()
    except UnicodeError:
        raise _bad("url", "the address names no host") from None
    return shown if port in (None, 443) else f"{shown}:{port}"


def ensure_range(kind: ReferenceKind, start_s: float | None, end_s: float | None) -> None:
    """Raise ReferenceInvalid unless a range is of a sound, a clip or a link, and ends after it begins."""
    if start_s is None and end_s is None:
        return
    if kind not in (ReferenceKind.VIDEO, ReferenceKind.AUDIO, ReferenceKind.LINK):
        raise _bad("start_s", "only a sound, a clip or a link has a part to point at")
    if start_s is None:
        raise _bad("start_s", "say where the part begins")
    if end_s is not None and end_s <= start_s:
        raise _bad("end_s", "the part ends before it begins")


def _bad(where: str, message: str) -> ReferenceInvalid:
    return ReferenceInvalid(message, errors=[FieldProblem(where=where, message=message)])


def tidy_words(text: str) -> str:
    """Return words that are separated by commas in lower case, none twice, in their order: "warm, crunchy"."""
    words = (" ".join(word.split()).lower() for word in text.split(","))
    return ", ".join(dict.fromkeys(word for word in words if word))
