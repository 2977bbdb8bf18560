"""Sounds that a codec keeps, as games ship them: Ogg Vorbis, Opus and MP3, decoded into a WAV that is read like others.

Decoding is libsndfile's, in a disposable child with limits (see `sandbox`), which writes samples as 32-bit float and
exits. Two decoders differ in the last bits, so a hash of these samples holds on one machine.
"""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, field
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from audio_checks import wav
from audio_checks.audio.sandbox import Sandbox, is_inside
from audio_checks.audio.self_deleting_file import SelfDeletingFile
from audio_checks.errors import Unreadable
from audio_checks.system.plural import verb

ENCODINGS = ("vorbis", "opus", "mp3")
CONTAINERS = {"OGG": "ogg", "MP3": "mp3"}
OF_SUBTYPE = {"VORBIS": "vorbis", "OPUS": "opus", "MPEG_LAYER_III": "mp3"}
MOST_DECODED_BYTES = 2 << 30  # of samples; a few bytes can announce hours
MOST_CHANNELS = 8
DECODE_S = 120.0
BLOCK_FRAMES = 65_536
MOST_SHORT_FRAMES = 2 * 1_152  # two frames of MP3; what lacks more was cut off
MOST_COMMENT_CHARACTERS = 65_536
EXPORT_AGAIN = "encode it again from its WAV"


@dataclass(frozen=True)
class Coded:
    """The facts of a coded file.

    Attributes
    ----------
    container, encoding : str
        "ogg" or "mp3"; "vorbis", "opus" or "mp3".
    bit_rate_kbps : float
        Of the whole file over its length: bytes of tags count, as they do in a build.
    comments : dict of str
        What the file says of itself in the tags that libsndfile reads, by their names in capitals.
    """

    container: str
    encoding: str
    bit_rate_kbps: float
    comments: dict[str, str] = field(default_factory=dict, hash=False)

    @property
    def comment_fields(self) -> dict[str, str]:
        """The comments by the names that specs and reports use, as in `Vorbis.TITLE`."""
        return {f"Vorbis.{name}": text for name, text in self.comments.items()}


def opened_as_wav(path: str | os.PathLike[str]) -> tuple[SelfDeletingFile, Coded]:
    """Return a WAV file of the decoded sound, which is deleted when it is closed, and what the coded file is.

    Raises
    ------
    Unreadable
        The sound does not decode, or is not Vorbis, Opus or MP3.
    SandboxFailed
        The child could not do its work, for want of time, memory or disk, or because the decoder broke.
    """
    descriptor, decoded = tempfile.mkstemp(prefix="audio-checks-", suffix=".wav")
    os.close(descriptor)
    where = os.path.abspath(os.fspath(path))
    try:
        if is_inside():
            coded_fields = decode(where, decoded)
        else:
            with _sandbox().child(reads=[where], writes=[decoded]) as child:
                coded_fields = child.call(decode, where, decoded)
        return SelfDeletingFile(decoded), Coded(*coded_fields)
    except BaseException:
        with suppress(FileNotFoundError):
            os.unlink(decoded)
        raise


@cache
def _sandbox() -> Sandbox:
    return Sandbox(
        timeout_s=DECODE_S,
        file_bytes=MOST_DECODED_BYTES + (16 << 20),
        preload=("numpy", "soundfile", "audio_checks.audio.coded"),
    )


def decode(path: str, out: str) -> tuple[str, str, float, dict[str, str]]:
    """Write a coded sound as WAV; return its container, encoding, bit rate and comments. Runs in a sandbox's child.

    Raises
    ------
    Unreadable
        The sound does not decode, or is not Vorbis, Opus or MP3.
    """
    import soundfile  # slow to import, and no WAV needs it

    wav.open_regular(path).close()
    try:
        with soundfile.SoundFile(path) as sound:
            container, encoding = CONTAINERS.get(sound.format, ""), OF_SUBTYPE.get(sound.subtype, "")
            rate, channels, frames = sound.samplerate, sound.channels, sound.frames
            if not container or not encoding:
                raise _damaged("it holds neither Vorbis, Opus nor MP3")
            if container == "mp3":
                frames = whole_frames(path, frames)
            if not (1_000 <= rate <= 768_000 and 1 <= channels <= MOST_CHANNELS and frames > 0):
                raise _damaged(f"it says {rate} Hz, {channels} channels and {frames} frames")
            if frames * channels * 4 > MOST_DECODED_BYTES:
                raise _damaged(f"it announces {frames * channels * 4 >> 20} MiB of samples")
            with open(out, "wb") as target:
                wav.write_wav(
                    target,
                    _blocks(sound, frames),
                    sample_rate_hz=rate,
                    bit_depth=32,
                    encoding="float",
                    channels=channels,
                    frames=frames,
                )
            bit_rate_kbps = round(os.path.getsize(path) * 8 / 1_000 * rate / frames, 1)
            return container, encoding, bit_rate_kbps, comments_in(sound)
    except soundfile.SoundFileError as error:
        reason = "".join(character if character.isprintable() else "?" for character in str(error))[:200]
        raise _damaged(f"it does not decode ({reason})") from None


def whole_frames(path: str, announced: int) -> int:
    """Return an MP3's number of decoded frames: often a few less than announced, where its encoder said no delay."""
    import soundfile

    with soundfile.SoundFile(path) as sound:
        decoded_frames = 0
        while block := len(sound.read(BLOCK_FRAMES, dtype="float32")):
            decoded_frames += block
    return decoded_frames if announced - MOST_SHORT_FRAMES <= decoded_frames < announced else announced


def comments_in(sound: Any) -> dict[str, str]:
    """Return the tags that libsndfile finds in an open sound, by their names in capitals, each cut to what is read."""
    comments: dict[str, str] = sound.copy_metadata()
    return {name.upper(): text[:MOST_COMMENT_CHARACTERS] for name, text in comments.items() if text}


def _blocks(sound: object, frames: int) -> Iterator[NDArray[np.float32]]:
    left = frames
    while left:
        block: NDArray[np.float32] = sound.read(  # type: ignore[attr-defined]
            min(BLOCK_FRAMES, left), dtype="float32", always_2d=True
        )
        if not len(block):
            raise _damaged(f"{left} of its {frames} frames {verb(left, 'is', 'are')} missing")
        left -= len(block)
        yield block


def _damaged(why: str) -> Unreadable:
    return Unreadable(f"the coded file is damaged: {why}", "R1", "structure:coded-damaged", EXPORT_AGAIN)
