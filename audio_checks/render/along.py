"""What goes along with the sound into a game file: all chunks, or those that tell of the sound alone."""

import os
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from audio_checks import wav
from audio_checks.errors import RenderRefused
from audio_checks.metadata import CHUNKS, MOST_CHUNKS, read_metadata
from audio_checks.metadata import MOST_BYTES as MOST_READ_BYTES
from audio_checks.metadata.bext import LEVELS_AT, levels_anew
from audio_checks.metadata.carrying import MOST_BYTES, Chunk, Move, Points, bytes_beside, carried, sampler
from audio_checks.metadata.mark import comment_chunk, cue_marked
from audio_checks.sound_files import OpenSound

TELL_OF_THE_SOUND = frozenset({"cue ", "smpl", "inst", "acid", "plst"})  # and LIST/adtl, the labels of cue points


def chunks_along(
    sound: OpenSound, move: Move, *, all_chunks: bool, new_loops: Sequence[Points] | None
) -> tuple[list[Chunk], list[Chunk]]:
    """Return the chunks of a game file, those before the sound and those after it.

    Parameters
    ----------
    sound : OpenSound
        The master.
    move : Move
        What becomes of its sound.
    all_chunks : bool
        Everything that the master carries, or only what tells of the sound: names of projects and
        people stay behind. The mark of a stand-in always goes along.
    new_loops : sequence of (int, int), optional
        First and last frames of loops in the game file, in place of those of the master's own `smpl` chunk.

    Raises
    ------
    RenderRefused
        `render:large-chunks`.
    """
    beside = bytes_beside(sound.layout)
    if beside > MOST_BYTES:
        raise RenderRefused(
            f"the master carries {beside >> 20} MiB beside its sound, and a render {MOST_BYTES >> 20} MiB at most",
            code="render:large-chunks",
            fix="leave out what the file need not carry, such as pictures, and deliver it again",
        )
    before, after = carried(sound.file, sound.layout, move, keep=None if all_chunks else _tells_of_the_sound)
    if new_loops is not None:
        samplers = [payload for name, payload in (*before, *after) if name == "smpl"]
        new = sampler(move.to_hz, [(0, *one) for one in new_loops], *samplers[:1])
        before = [chunk for chunk in before if chunk[0] != "smpl"] + [("smpl", new)]
        after = [chunk for chunk in after if chunk[0] != "smpl"]
    number = _stand_in_for(sound)
    if number is not None and not all_chunks:
        after.append(comment_chunk(number))
    return before, after


def tell_loudness_anew(sound: OpenSound, path: Path, figures: Mapping[str, float | None]) -> None:
    """Write into the bext of a game file what was measured of it, in those fields in which its master told the same.

    Only now is it known: the chunk stands before the sound.
    """
    found = next((chunk for chunk in sound.layout.chunks if chunk.id == "bext"), None)
    levels = levels_anew(wav.chunk_payload(sound.file, found), figures) if found is not None else None
    if levels is None:
        return
    with path.open("r+b") as file:
        bext = next(chunk for chunk in wav.read_layout(file).chunks if chunk.id == "bext")
        file.seek(bext.offset + LEVELS_AT)
        file.write(levels)
        file.flush()
        os.fsync(file.fileno())


def _tells_of_the_sound(name: str, payload: bytes) -> bool:
    return name in TELL_OF_THE_SOUND or (name == "LIST" and payload[:4] == b"adtl")


def _stand_in_for(sound: OpenSound) -> str | None:
    """Return the cue that a master is a stand-in for; None for a real sound."""
    chunks = [chunk for chunk in sound.layout.chunks if chunk.id in CHUNKS][:MOST_CHUNKS]
    told = read_metadata(
        (chunk.id, wav.chunk_payload(sound.file, replace(chunk, size=min(chunk.size, MOST_READ_BYTES))))
        for chunk in chunks
    )
    comments = sound.flac.comment_fields if sound.flac is not None else {}
    return cue_marked(told.fields | comments)
