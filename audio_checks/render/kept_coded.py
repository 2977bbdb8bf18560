"""Game files that a codec keeps and that ship already: handed on byte for byte, since a coded file is not a master."""

import os
import re
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Literal, cast

from audio_checks import wav
from audio_checks.audio.audio_file import AudioFile, Facts
from audio_checks.errors import RenderRefused
from audio_checks.render.attempt import Attempt
from audio_checks.render.rendered import Rendered
from audio_checks.render.work import RENDERER_VERSION
from audio_checks.spec.codings import label_of
from audio_checks.spec.delivery_spec import Target
from audio_checks.spec.parts import Encoding

HEAD_BYTES = 65_536  # comments stand at the start; a page holds no more
MOST_DIGITS = 15
_LOOP = re.compile(rb"(LOOPSTART|LOOPLENGTH)=")


def keep_coded(
    path: str | os.PathLike[str], target: Target, out_path: str | os.PathLike[str], *, loop: bool = False
) -> Rendered:
    """Copy a coded file as the game file of a target, and return what is known of it.

    Parameters
    ----------
    path, out_path : path
        An Ogg Vorbis, Opus or MP3 file, and the file to write.
    target : Target
        It takes the file where its encoding, rate and channels are those of the file, or where it keeps coded files.
    loop : bool
        The whole file loops.

    Returns
    -------
    Rendered
        Without a loss: nothing was made.

    Raises
    ------
    RenderRefused
        `render:coded-master`: the target would have another file made of it.
    Unreadable
        When the file does not decode.
    """
    with AudioFile(path, coded=True) as file:
        facts = file.facts
        ensure_kept(facts, target)
        file.prepare(Attempt.FIGURES)
        figures = file.measured()
        rendered = Rendered(
            path=Path(out_path),
            sample_rate_hz=facts.sample_rate_hz,
            bit_depth=facts.bit_depth,
            encoding=cast("Encoding | Literal['mp3']", facts.encoding),  # what is read as coded is one of these
            channels=facts.channels,
            frames=facts.frames,
            measurements={name: figures[name] for name in Attempt.FIGURES},
            attenuation_db=0.0,
            recalculated=False,
            dither="none",
            loop=loop,
            loop_points=_loop_points(path, facts.frames),
            loop_fit_frames=0.0,
            seam_before=None,
            seam_after=None,
            master_sha256=file.sha256,
            sha256=file.sha256,
            pcm_sha256=file.pcm_sha256,
            renderer_version=RENDERER_VERSION,
        )
    shutil.copyfile(path, out_path)
    return rendered


def ensure_kept(facts: Facts, target: Target) -> None:
    """Raise RenderRefused (`render:coded-master`) unless a target takes a coded file as it is."""
    fits_format = facts.encoding == target.encoding and facts.sample_rate_hz <= target.sample_rate_hz
    if target.keep_coded or (fits_format and target.channels in ("master", facts.channels)):
        return
    description = f"{label_of(facts.encoding)} at {facts.sample_rate_hz} Hz"
    raise RenderRefused(
        f"it was adopted as {description}, and a coded file is not a master: no other file is made of it",
        code="render:coded-master",
        fix="deliver the WAV that it was made from, or say keep_coded = true in the target to ship it as it is",
    )


def _loop_points(path: str | os.PathLike[str], frames: int) -> tuple[tuple[int, int], ...]:
    """Return the loop that Ogg comments state in frames, as `LOOPSTART` and `LOOPLENGTH`; none beyond the file."""
    with wav.open_regular(path) as file:
        head = file.read(HEAD_BYTES)
    points = dict(_numbers(head)) if head.startswith(b"OggS") else {}
    if points.keys() != {b"LOOPSTART", b"LOOPLENGTH"}:
        return ()
    first, last = points[b"LOOPSTART"], points[b"LOOPSTART"] + points[b"LOOPLENGTH"] - 1
    return ((first, last),) if first <= last < frames else ()


def _numbers(head: bytes) -> Iterator[tuple[bytes, int]]:
    """Yield the comments of a loop; the length of each stands before it, in four bytes."""
    for match in _LOOP.finditer(head):
        length = int.from_bytes(head[max(match.start() - 4, 0) : match.start()], "little")
        digits = head[match.end() : match.start() + length]
        if digits.isdigit() and len(digits) <= MOST_DIGITS:
            yield match[1], int(digits)
