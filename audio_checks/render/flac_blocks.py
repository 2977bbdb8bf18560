"""Rewrites the metadata blocks of a FLAC file of ours: what its WAV file carries beside the sound goes along.

Source: RFC 9639, section 8; chunks of a WAV file are kept as `flac --keep-foreign-metadata` keeps them.
"""

import shutil
from collections.abc import Sequence
from typing import BinaryIO

from audio_checks.render.ogg_pages import Comments, comment_list

MAGIC = b"fLaC"
STREAMINFO, APPLICATION, VORBIS_COMMENT = 0, 2, 4
LAST = 0x80
VENDOR = b"libFLAC"
MOST_BLOCK_BYTES = (1 << 24) - 1


def rewrite_flac(source: BinaryIO, out: BinaryIO, *, comments: Comments, chunks: Sequence[tuple[str, bytes]]) -> None:
    """Copy a FLAC file with other comments, and with chunks of a WAV file; chunks of 16 MiB and more stay behind."""
    source.seek(len(MAGIC))
    info, is_last = b"", False
    while not is_last:
        head = source.read(4)
        payload = source.read(int.from_bytes(head[1:], "big"))
        is_last = bool(head[0] & LAST)
        if head[0] & ~LAST == STREAMINFO:
            info = payload
    blocks = [(STREAMINFO, info), (VORBIS_COMMENT, _sized(VENDOR) + comment_list(comments))]
    for name, payload in chunks:
        kept = b"riff" + name.encode("latin-1") + _sized(payload)
        if len(kept) <= MOST_BLOCK_BYTES:
            blocks.append((APPLICATION, kept))
    out.write(MAGIC)
    for index, (kind, payload) in enumerate(blocks):
        last = LAST if index == len(blocks) - 1 else 0
        out.write(bytes([kind | last]) + len(payload).to_bytes(3, "big") + payload)
    shutil.copyfileobj(source, out)


def _sized(payload: bytes) -> bytes:
    return len(payload).to_bytes(4, "little") + payload
