"""Fingerprints one file: its facts, its levels, and the fingerprint of its sound."""

from __future__ import annotations

import hashlib
import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache

from audio_checks import wav
from audio_checks.audio.audio_file import AudioFile
from audio_checks.audio.coded import comments_in, whole_frames
from audio_checks.audio.sandbox import Sandbox, is_inside
from audio_checks.audit.fingerprint import FINGERPRINTED_S, fingerprint
from audio_checks.audit.plays import ApprovedPlayback
from audio_checks.errors import SandboxFailed, Unreadable
from audio_checks.metadata.mark import cue_marked

CODED = ("container:", "encoding:codec")  # what our own reader does not read, and another may
DECODE_S = 60.0
MOST_DECODED_BYTES = 2 << 30
MOST_CHANNELS = 64
BLOCK_FRAMES = 65_536


@dataclass(frozen=True)
class FingerprintedFile:
    """The facts, levels and fingerprint of one file.

    Attributes
    ----------
    path : str
        Relative to the folder that was read, with slashes.
    pcm_sha256 : str or None
        Of the samples; of what a codec keeps that of the whole file, since decoders differ in the last bit.
    bit_depth : int or None
        None where a codec kept the samples.
    codec : str or None
        What kept them, such as "VORBIS"; None for PCM and float.
    sample_peak_dbfs, rms_dbfs : float or None
        None for silence. Of a codec's sound, those of its first minute.
    fingerprint : bytes or None
        See `fingerprint`.
    is_placeholder : bool
        The file carries the mark of a placeholder.
    trouble : str
        Why it could not be read; empty where it could.
    cue, take : str or None
        Of an approved sound, where its manifest says so.
    plays : tuple of ApprovedPlayback or None
        How the game played it when it was approved, where its manifest says so.
    """

    path: str
    pcm_sha256: str | None = None
    sample_rate_hz: int = 0
    bit_depth: int | None = None
    channels: int = 0
    frames: int = 0
    codec: str | None = None
    sample_peak_dbfs: float | None = None
    rms_dbfs: float | None = None
    fingerprint: bytes | None = None
    is_placeholder: bool = False
    trouble: str = ""
    cue: str | None = None
    take: str | None = None
    plays: tuple[ApprovedPlayback, ...] | None = None

    @property
    def duration_s(self) -> float:
        """Return its length."""
        return self.frames / self.sample_rate_hz if self.sample_rate_hz else 0.0


def fingerprint_file(path: str, shown: str) -> FingerprintedFile:
    """Return the facts, levels and fingerprint of a file; never raises for what is in it.

    Parameters
    ----------
    path : str
        WAV and FLAC are read as everywhere; what else soundfile knows (Ogg Vorbis, Opus, MP3, AIFF, ADPCM in WAV)
        is decoded in a throw-away child.
    shown : str
        What the file is called.
    """
    try:
        try:
            return _fingerprinted(path, shown)
        except Unreadable as refusal:
            if not refusal.code.startswith(CODED):
                raise
            with _decoded(path, refusal) as (unpacked, codec, frames, comments):
                fingerprinted = _fingerprinted(unpacked, shown)
        return _by_codec(fingerprinted, path, codec, frames, comments)
    except Unreadable as error:
        return FingerprintedFile(shown, trouble=str(error))
    except SandboxFailed as error:
        return FingerprintedFile(shown, trouble=f"it could not be decoded: {error}")


def _by_codec(
    fingerprinted: FingerprintedFile, path: str, codec: str, frames: int, comments: dict[str, str]
) -> FingerprintedFile:
    fields = {f"Vorbis.{name}": text for name, text in comments.items()}
    return FingerprintedFile(
        fingerprinted.path,
        _sha256_of(path),
        fingerprinted.sample_rate_hz,
        None,
        fingerprinted.channels,
        frames,
        codec,
        fingerprinted.sample_peak_dbfs,
        fingerprinted.rms_dbfs,
        fingerprinted.fingerprint,
        cue_marked(fields) is not None,
    )


def _sha256_of(path: str) -> str:
    with wav.open_regular(path) as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def _fingerprinted(path: str, shown: str) -> FingerprintedFile:
    with AudioFile(path) as file:
        file.prepare(("sample_peak_dbfs", "rms_dbfs"))
        layout, levels = file.layout, file.measured()
        return FingerprintedFile(
            shown,
            file.pcm_sha256,
            layout.sample_rate_hz,
            layout.bit_depth,
            layout.channels,
            layout.frames,
            None,
            _finite(levels["sample_peak_dbfs"]),
            _finite(levels["rms_dbfs"]),
            fingerprint(file.blocks(), layout.sample_rate_hz),
            cue_marked(file.metadata.fields) is not None,
        )


def _finite(level: float) -> float | None:
    return round(level, 2) if abs(level) < 1_000 else None


@contextmanager
def _decoded(path: str, refusal: Unreadable) -> Iterator[tuple[str, str, int, dict[str, str]]]:
    """Give a WAV file of the first minute of a sound that a codec keeps, the codec's name, frames and comments."""
    with tempfile.TemporaryDirectory(prefix="audio-checks-") as folder:
        where, unpacked = os.path.abspath(path), os.path.join(folder, "decoded.wav")
        if is_inside():
            decoded = decode(where, unpacked)
        else:
            with _sandbox().child(reads=[where], writes=[folder]) as child:
                decoded = child.call(decode, where, unpacked)
        if decoded is None:
            raise refusal
        yield unpacked, *decoded


@cache
def _sandbox() -> Sandbox:
    return Sandbox(
        timeout_s=DECODE_S,
        file_bytes=MOST_DECODED_BYTES,
        preload=("numpy", "soundfile", "audio_checks.audit.fingerprinted"),
    )


def decode(path: str, out: str) -> tuple[str, int, dict[str, str]] | None:
    """Write the first minute of a sound as WAV; return its codec, frames and comments. Runs in a sandbox's child.

    Returns
    -------
    (str, int, dict of str) or None
        None for what soundfile does not read either.
    """
    import soundfile  # slow to import, and no WAV needs it

    wav.open_regular(path).close()
    try:
        with soundfile.SoundFile(path) as sound:
            rate, channels, frames = sound.samplerate, sound.channels, sound.frames
            if sound.format == "MP3":
                frames = whole_frames(path, frames)
            listened = min(frames, FINGERPRINTED_S * rate)
            if not (1_000 <= rate <= 768_000 and 1 <= channels <= MOST_CHANNELS and listened > 0):
                return None
            wav.write_wav(
                out,
                (
                    sound.read(min(BLOCK_FRAMES, listened - at), dtype="float32", always_2d=True)
                    for at in range(0, listened, BLOCK_FRAMES)
                ),
                sample_rate_hz=rate,
                bit_depth=32,
                encoding="float",
                channels=channels,
                frames=listened,
                durable=False,
            )
            return str(sound.subtype), int(frames), comments_in(sound)
    except (soundfile.SoundFileError, ValueError):
        return None
