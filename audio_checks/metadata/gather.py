"""Keeps the payloads of metadata chunks while a file's bytes pass by, so that none is read twice."""

from __future__ import annotations

from collections.abc import Iterable

from audio_checks.metadata import CHUNKS, MOST_BYTES, MOST_CHUNKS, Metadata, read_metadata
from audio_checks.wav import Chunk

MOST_TOGETHER = 4 * MOST_BYTES


class Gathering:
    """Watches the bytes around the sound.

    Parameters
    ----------
    chunks : iterable of Chunk
        Of the whole file. What does not fit the bounds is kept in part or not at all.
    """

    def __init__(self, chunks: Iterable[Chunk]) -> None:
        self._kept: list[tuple[str, int, int, bytearray]] = []  # id, where its payload starts and ends, what came by
        left = MOST_TOGETHER
        for chunk in chunks:
            if chunk.id in CHUNKS and left and len(self._kept) < MOST_CHUNKS:
                size = min(chunk.size, MOST_BYTES, left)
                self._kept.append((chunk.id, chunk.offset, chunk.offset + size, bytearray()))
                left -= size

    def pass_by(self, position: int, piece: bytes) -> None:
        """Take the bytes that stand at a position of the file."""
        end = position + len(piece)
        for _, start, stop, kept in self._kept:
            if start < end and position < stop:
                kept.extend(piece[max(start - position, 0) : stop - position])

    def read(self) -> Metadata:
        """Return the metadata of the kept payloads."""
        return read_metadata([(name, bytes(kept)) for name, _, _, kept in self._kept])
