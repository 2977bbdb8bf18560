"""The chunks of a master that a game file carries: all, or those that describe the sound."""

import os
import struct
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import BinaryIO

from audio_checks import wav
from audio_checks.audio.flac import MASK_COMMENT
from audio_checks.audio.sound_files import OpenSound
from audio_checks.errors import RenderRefused
from audio_checks.metadata import CHUNKS, MOST_CHUNKS, Metadata, read_metadata
from audio_checks.metadata import MOST_BYTES as MOST_READ_BYTES
from audio_checks.metadata.bext import LEVELS_AT, updated_levels
from audio_checks.metadata.mark import comment_chunk, cue_marked, marked_comment
from audio_checks.metadata.moving import MOST_BYTES, Chunk, Move, Points, bytes_outside_data, carried, sampler
from audio_checks.render.ogg_pages import Comments

OF_THE_SOUND = frozenset({"fmt ", "fact", "ds64", "data"})
# What Vorbis comments call the fields of a WAV file.
COMMENT_NAMES = {
    "INFO.INAM": "TITLE",
    "INFO.IART": "ARTIST",
    "INFO.ICOP": "COPYRIGHT",
    "INFO.ICMT": "COMMENT",
    "bext.Description": "DESCRIPTION",
    "bext.Originator": "ORGANIZATION",
}
SAMPLER_HEADER_BYTES = 36
UNSTATED_NOTES = (0, 60)  # as editors write them that have nothing to say of it
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
        First and last frames of loops in the game file, in place of those of the master's own `smpl` chunk;
        with none, the chunk goes unless it says more.

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
        before = [chunk for chunk in before if chunk[0] != "smpl"]
        after = [chunk for chunk in after if chunk[0] != "smpl"]
        if new_loops or any(_says_more_than_loops(payload) for payload in samplers[:1]):
            before.append(("smpl", sampler(move.to_hz, [(0, *loop) for loop in new_loops], *samplers[:1])))
    number = _placeholder_number(sound)
    if number is not None and not all_chunks:
        after.append(comment_chunk(number))
    return before, after


def comments_of(file: BinaryIO, layout: wav.WavLayout, master: OpenSound, *, all_chunks: bool) -> Comments:
    """Return the Vorbis comments of a coded game file on itself, from the WAV file of its sound.

    The mark of a placeholder and the first loop (`LOOPSTART` and `LOOPLENGTH`, in frames) always; who and what
    the master names only where everything goes along.
    """
    comments: list[tuple[str, str]] = []
    number = _placeholder_number(master)
    if number is not None:
        comments.append(marked_comment(number))
    if layout.loops:
        first, last = layout.loops[0].start, layout.loops[0].end
        comments += [("LOOPSTART", str(first)), ("LOOPLENGTH", str(last - first + 1))]
    if layout.channel_mask and layout.channels > 2:
        comments.append((MASK_COMMENT, f"0x{layout.channel_mask:04X}"))
    if all_chunks:
        fields = metadata_of(file, layout).fields
        comment_texts = {COMMENT_NAMES[name]: text for name, text in fields.items() if name in COMMENT_NAMES}
        comments += [(name, text) for name, text in sorted(comment_texts.items()) if name not in dict(comments)]
    return comments


def kept_chunks(file: BinaryIO, layout: wav.WavLayout) -> list[Chunk]:
    """Return the chunks of a WAV file that a FLAC file of the same sound keeps: all but those of the sound itself."""
    return [(chunk.id, wav.chunk_payload(file, chunk)) for chunk in layout.chunks if chunk.id not in OF_THE_SOUND]


def update_loudness(sound: OpenSound, path: Path, figures: Mapping[str, float | None]) -> None:
    """Write the measured loudness into the bext chunk of a game file, in the fields that its master has set.

    Only now is it known: the chunk stands before the sound.
    """
    bext_chunk = next((chunk for chunk in sound.layout.chunks if chunk.id == "bext"), None)
    levels = updated_levels(wav.chunk_payload(sound.file, bext_chunk), figures) if bext_chunk is not None else None
    if levels is None:
        return
    with path.open("r+b") as file:
        bext = next(chunk for chunk in wav.read_layout(file).chunks if chunk.id == "bext")
        file.seek(bext.offset + LEVELS_AT)
        file.write(levels)
        file.flush()
        os.fsync(file.fileno())


def metadata_of(file: BinaryIO, layout: wav.WavLayout) -> Metadata:
    """Return a WAV file's statements on itself."""
    chunks = [chunk for chunk in layout.chunks if chunk.id in CHUNKS][:MOST_CHUNKS]
    return read_metadata(
        (chunk.id, wav.chunk_payload(file, replace(chunk, size=min(chunk.size, MOST_READ_BYTES)))) for chunk in chunks
    )


def _says_more_than_loops(sampler_chunk: bytes) -> bool:
    """Return whether a `smpl` chunk says at which note the sound plays at its own pitch, or has data of a sampler."""
    if len(sampler_chunk) < SAMPLER_HEADER_BYTES:
        return False
    note, fraction = struct.unpack_from("<2I", sampler_chunk, 12)
    (data_bytes,) = struct.unpack_from("<I", sampler_chunk, 32)
    return note not in UNSTATED_NOTES or fraction > 0 or data_bytes > 0


def _describes_sound(name: str, payload: bytes) -> bool:
    return name in DESCRIBES_SOUND or (name == "LIST" and payload[:4] == b"adtl")


def _placeholder_number(sound: OpenSound) -> str | None:
    """Return the cue that a master is a placeholder for; None for a real sound."""
    metadata = metadata_of(sound.file, sound.layout)
    comments = sound.flac.comment_fields if sound.flac is not None else {}
    return cue_marked(metadata.fields | comments)
