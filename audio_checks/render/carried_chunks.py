"""The chunks of a master that a game file carries: all, or those that describe the sound."""

import os
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from audio_checks import wav
from audio_checks.audio.sound_files import OpenSound
from audio_checks.errors import RenderRefused
from audio_checks.metadata import CHUNKS, MOST_CHUNKS, read_metadata
from audio_checks.metadata import MOST_BYTES as MOST_READ_BYTES
from audio_checks.metadata.bext import LEVELS_AT, updated_levels
from audio_checks.metadata.mark import comment_chunk, cue_marked
from audio_checks.metadata.moving import MOST_BYTES, Chunk, Move, Points, bytes_outside_data, carried, sampler

DESCRIBES_SOUND = frozenset({"cue ", "smpl", "inst", "acid", "plst"})  # and LIST/adtl, the labels of cue points


def carried_chunks(
    sound: OpenSound, move: Move, *, all_chunks: bool, new_loops: Sequence[Points] | None
) -> tuple[list[Chunk], list[Chunk]]:
    """Return the chunks of a game file, those before the sound and those after it.

    Parameters
    ----------
    sound : OpenSound
        The master.
    move : Move
        How its frames are moved.
    all_chunks : bool
        Everything that the master carries, or only what describes the sound: names of projects and
        people stay behind. The mark of a placeholder is always kept.
    new_loops : sequence of (int, int), optional
        First and last frames of loops in the game file, in place of those of the master's own `smpl` chunk.

    Raises
    ------
    RenderRefused
        `render:large-chunks`.
    """
    other_bytes = bytes_outside_data(sound.layout)
    if other_bytes > MOST_BYTES:
        raise RenderRefused(
            f"the master carries {other_bytes >> 20} MiB beside its sound, and a render {MOST_BYTES >> 20} MiB at most",
            code="render:large-chunks",
            fix="leave out what the file need not carry, such as pictures, and deliver it again",
        )
    before, after = carried(sound.file, sound.layout, move, keep=None if all_chunks else _describes_sound)
    if new_loops is not None:
        samplers = [payload for name, payload in (*before, *after) if name == "smpl"]
        new = sampler(move.to_hz, [(0, *one) for one in new_loops], *samplers[:1])
        before = [chunk for chunk in before if chunk[0] != "smpl"] + [("smpl", new)]
        after = [chunk for chunk in after if chunk[0] != "smpl"]
    number = _placeholder_number(sound)
    if number is not None and not all_chunks:
        after.append(comment_chunk(number))
    return before, after


def update_loudness(sound: OpenSound, path: Path, figures: Mapping[str, float | None]) -> None:
    """Write the measured loudness into the bext chunk of a game file, in the fields that its master has set.

    Only now is it known: the chunk stands before the sound.
    """
    found = next((chunk for chunk in sound.layout.chunks if chunk.id == "bext"), None)
    levels = updated_levels(wav.chunk_payload(sound.file, found), figures) if found is not None else None
    if levels is None:
        return
    with path.open("r+b") as file:
        bext = next(chunk for chunk in wav.read_layout(file).chunks if chunk.id == "bext")
        file.seek(bext.offset + LEVELS_AT)
        file.write(levels)
        file.flush()
        os.fsync(file.fileno())


def _describes_sound(name: str, payload: bytes) -> bool:
    return name in DESCRIBES_SOUND or (name == "LIST" and payload[:4] == b"adtl")


def _placeholder_number(sound: OpenSound) -> str | None:
    """Return the cue that a master is a placeholder for; None for a real sound."""
    chunks = [chunk for chunk in sound.layout.chunks if chunk.id in CHUNKS][:MOST_CHUNKS]
    metadata = read_metadata(
        (chunk.id, wav.chunk_payload(sound.file, replace(chunk, size=min(chunk.size, MOST_READ_BYTES))))
        for chunk in chunks
    )
    comments = sound.flac.comment_fields if sound.flac is not None else {}
    return cue_marked(metadata.fields | comments)
