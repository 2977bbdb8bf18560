"""Rewrites an Ogg file of ours: another stream number, so that the same sound has the same bytes, and other comments.

Encoders number a stream by chance. Source: RFC 3533 (pages), Vorbis I chapter 5 and RFC 7845 (comments).
"""

import zlib
from collections.abc import Iterator, Sequence
from typing import BinaryIO, NamedTuple

CAPTURE = b"OggS"
HEAD_BYTES = 27
CONTINUED, FIRST, LAST = 1, 2, 4  # flags of a page
MOST_SEGMENTS = 255
SEGMENT_BYTES = 255
NO_PACKET_ENDS = (1 << 64) - 1
COMMENTS_BEGIN = {"vorbis": b"\x03vorbis", "opus": b"OpusTags"}
PACKETS_BEFORE_SOUND = {"vorbis": 3, "opus": 2}  # with the one that names the codec, alone on the first page
_REVERSED = bytes(int(f"{value:08b}"[::-1], 2) for value in range(256))

Comments = Sequence[tuple[str, str]]


class Page(NamedTuple):
    """One page: its flags, the position at its end, its packets' segments and bytes."""

    flags: int
    position: int
    segments: bytes
    payload: bytes


def rewrite_ogg(source: BinaryIO, out: BinaryIO, *, encoding: str, serial: int, comments: Comments) -> None:
    """Copy an Ogg file of one stream with another stream number and other comments.

    Parameters
    ----------
    source, out : binary file
        What the encoder wrote, and where the copy goes.
    encoding : {"vorbis", "opus"}
        What it holds.
    serial : int
        Of the stream, below 2 ** 32.
    comments : sequence of (name, text)
        In place of the encoder's; the name of the encoder itself stays.
    """
    pages = _pages(source)
    out.write(_packed(next(pages), serial, 0))
    packets: list[bytes] = []
    rest = b""
    while len(packets) < PACKETS_BEFORE_SOUND[encoding] - 1:
        page = next(pages)
        at = 0
        for segment in page.segments:
            rest += page.payload[at : at + segment]
            at += segment
            if segment < SEGMENT_BYTES:
                packets.append(rest)
                rest = b""
    packets[0] = _with_comments(packets[0], COMMENTS_BEGIN[encoding], comments)
    number = 1
    for page in _paged(packets):
        out.write(_packed(page, serial, number))
        number += 1
    for page in pages:
        out.write(_packed(page, serial, number))
        number += 1


def _pages(source: BinaryIO) -> Iterator[Page]:
    while head := source.read(HEAD_BYTES):
        segments = source.read(head[26])
        yield Page(head[5], int.from_bytes(head[6:14], "little"), segments, source.read(sum(segments)))


def _paged(packets: Sequence[bytes]) -> Iterator[Page]:
    """Yield the pages of header packets, as many segments on each as it can have."""
    segments, payload = b"", b"".join(packets)
    for packet in packets:
        segments += bytes([SEGMENT_BYTES]) * (len(packet) // SEGMENT_BYTES) + bytes([len(packet) % SEGMENT_BYTES])
    at, goes_on = 0, False
    for begin in range(0, len(segments), MOST_SEGMENTS):
        page_segments = segments[begin : begin + MOST_SEGMENTS]
        ends = any(segment < SEGMENT_BYTES for segment in page_segments)
        yield Page(
            CONTINUED if goes_on else 0,
            0 if ends else NO_PACKET_ENDS,
            page_segments,
            payload[at : at + sum(page_segments)],
        )
        at += sum(page_segments)
        goes_on = page_segments[-1] == SEGMENT_BYTES


def _packed(page: Page, serial: int, number: int) -> bytes:
    head = CAPTURE + bytes([0, page.flags]) + page.position.to_bytes(8, "little") + serial.to_bytes(4, "little")
    head += number.to_bytes(4, "little")
    tail = bytes([len(page.segments)]) + page.segments + page.payload
    checksum = _checksum(head + bytes(4) + tail)
    return head + checksum.to_bytes(4, "little") + tail


def _checksum(page: bytes) -> int:
    """Return Ogg's CRC: that of zlib with every bit the other way round, from 0 and without a last inversion."""
    crc = zlib.crc32(page.translate(_REVERSED), 0xFFFFFFFF) ^ 0xFFFFFFFF
    return int(f"{crc:032b}"[::-1], 2)


def _with_comments(packet: bytes, begins: bytes, comments: Comments) -> bytes:
    """Return a comment packet that says something else, by the same encoder."""
    at = len(begins)
    vendor = packet[at : at + 4 + int.from_bytes(packet[at : at + 4], "little")]
    framing = b"\x01" if begins == COMMENTS_BEGIN["vorbis"] else b""
    return begins + vendor + comment_list(comments) + framing


def comment_list(comments: Comments) -> bytes:
    """Return a list of Vorbis comments: how many, then each with its length."""
    entries = [f"{name}={text}".encode() for name, text in comments]
    return len(entries).to_bytes(4, "little") + b"".join(len(entry).to_bytes(4, "little") + entry for entry in entries)
