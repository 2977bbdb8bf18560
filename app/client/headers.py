"""Rate and depth of a sound by its first bytes; the server's checks read the whole file."""

from typing import NamedTuple

OGG_HEADER_BYTES = 128  # the first page has the codec's header alone
FLAC_BYTES = 26  # up to the end of what STREAMINFO says of the format
HEAD_BYTES = 64 << 10  # chunks before `fmt ` are seldom longer


class Format(NamedTuple):
    """A header's content; None where it is not read."""

    sample_rate_hz: int | None
    bit_depth: int | None


UNREAD = Format(None, None)


def format_of(head: bytes) -> Format:
    """Return rate and depth of a WAV or FLAC file by its first bytes, and the rate of an Ogg file."""
    if head[:4] == b"fLaC" and len(head) >= FLAC_BYTES:
        packed = int.from_bytes(head[18:26], "big")  # 20 bits rate, 3 channels, 5 depth, 36 length
        return _plausible(packed >> 44, (packed >> 36 & 31) + 1)
    if head[:4] == b"OggS":
        return _of_ogg(head)
    if head[:4] not in (b"RIFF", b"RF64") or head[8:12] != b"WAVE":
        return UNREAD
    at = 12
    while at + 24 <= len(head):
        size = int.from_bytes(head[at + 4 : at + 8], "little")
        if head[at : at + 4] == b"fmt ":
            rate = int.from_bytes(head[at + 12 : at + 16], "little")
            return _plausible(rate, int.from_bytes(head[at + 22 : at + 24], "little"))
        at += 8 + size + size % 2
    return UNREAD


def _of_ogg(head: bytes) -> Format:
    if (at := head.find(b"\x01vorbis", 0, OGG_HEADER_BYTES)) >= 0:
        return Format(_plausible(int.from_bytes(head[at + 12 : at + 16], "little"), 0).sample_rate_hz, None)
    return Format(48_000, None) if b"OpusHead" in head[:OGG_HEADER_BYTES] else UNREAD


def _plausible(rate_hz: int, depth: int) -> Format:
    return Format(rate_hz if 1 <= rate_hz <= 10_000_000 else None, depth if 1 <= depth <= 64 else None)
