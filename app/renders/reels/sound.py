"""Code of the sandbox's child: takes joined into a reel with pydub, for listening only."""

import warnings
import wave
from collections.abc import Sequence
from typing import Any, NamedTuple, TypedDict

import numpy as np
from numpy.typing import NDArray

SAMPLE_BYTES = 2
BEEP_MS, BETWEEN_BEEPS_MS, PAUSE_MS = 120, 120, 300
BEEP_DBFS, SPEECH_DBFS = -20.0, -12.0
VERSION_HZ, VARIATION_HZ = 1_000, 500
EDGE_MS = 5
SPEECH_RATE_HZ = 22_050


class Slate(NamedTuple):
    """The announcement of a take: spoken if speech is available, beeps otherwise."""

    variation: int  # low beeps; 0 where the cue has but one
    version: int  # high beeps
    speech: bytes | None  # 16-bit mono at SPEECH_RATE_HZ


class Reel(TypedDict):
    """The length of a reel, and the start of each sound in it."""

    duration_s: float
    starts_s: list[float]


def make_reel(
    paths: Sequence[str], slates: Sequence[Slate] | None, out: str, *, gap_ms: int, crossfade_ms: int
) -> Reel:
    """Write previews in a row, each behind its slate; return the length and where each sound begins.

    The reel has the highest rate and the most channels among them. A crossfade takes the place of the gap, and is
    no longer than what it joins.
    """
    sounds = [_read(path) for path in paths]
    rate_hz = max(sound.frame_rate for sound in sounds)
    channels = max(sound.channels for sound in sounds)

    def fitted(sound: Any) -> Any:
        return sound.set_frame_rate(rate_hz).set_channels(channels)

    reel: Any = None
    starts: list[float] = []
    room = 0  # frames of the sound before, for a crossfade to take
    for index, sound in enumerate(map(fitted, sounds)):
        head = fitted(_silence(0, rate_hz) if slates is None else _slate(slates[index], rate_hz))
        piece = head.append(sound, crossfade=0)
        if reel is None:
            reel = piece
        elif crossfade_ms:
            reel = _crossfaded(reel, piece, min(crossfade_ms * rate_hz // 1000, room, _frames(piece)))
        else:
            reel = reel.append(fitted(_silence(gap_ms, rate_hz)), crossfade=0).append(piece, crossfade=0)
        starts.append((_frames(reel) - _frames(sound)) / rate_hz)
        room = _frames(sound)
    if reel is None:
        raise ValueError("a reel of no takes")
    reel.export(out, format="wav")
    return {"duration_s": _frames(reel) / rate_hz, "starts_s": starts}


def _pydub() -> Any:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # it misses ffmpeg, which nothing here is to be read with
        import pydub
        import pydub.generators
    return pydub


def _read(path: str) -> Any:
    """Return a preview: 16-bit WAV, whose frames are taken as they are."""
    with wave.open(path) as file:
        if file.getsampwidth() != SAMPLE_BYTES:
            raise ValueError(f"a preview of {8 * file.getsampwidth()} bits; 16 were wanted")
        return _segment(file.readframes(file.getnframes()), file.getframerate(), file.getnchannels())


def _segment(data: bytes, rate_hz: int, channels: int) -> Any:
    whole = len(data) - len(data) % (SAMPLE_BYTES * channels)
    return _pydub().AudioSegment(data=data[:whole], sample_width=SAMPLE_BYTES, frame_rate=rate_hz, channels=channels)


def _frames(sound: Any) -> int:
    return int(len(sound.raw_data) // sound.frame_width)


def _silence(duration_ms: int, rate_hz: int) -> Any:
    return _segment(bytes(SAMPLE_BYTES * (duration_ms * rate_hz // 1000)), rate_hz, 1)


def _slate(slate: Slate, rate_hz: int) -> Any:
    pause = _silence(PAUSE_MS, rate_hz)
    if slate.speech is not None:
        spoken = _segment(slate.speech, SPEECH_RATE_HZ, 1).apply_gain(SPEECH_DBFS).set_frame_rate(rate_hz)
        return spoken.append(pause, crossfade=0)
    whole = _silence(0, rate_hz)
    for count, hz in ((slate.variation, VARIATION_HZ), (slate.version, VERSION_HZ)):
        beep = _beep(hz, rate_hz)
        for nth in range(count):
            if nth:
                whole = whole.append(_silence(BETWEEN_BEEPS_MS, rate_hz), crossfade=0)
            whole = whole.append(beep, crossfade=0)
        if count:
            whole = whole.append(pause, crossfade=0)
    return whole


def _beep(hz: int, rate_hz: int) -> Any:
    tone = _pydub().generators.Sine(hz, sample_rate=rate_hz).to_audio_segment(BEEP_MS, volume=BEEP_DBFS)
    faded = tone.fade_in(EDGE_MS).fade_out(EDGE_MS)
    lost = _frames(tone) - _frames(faded)  # it fades in whole milliseconds
    return _segment(faded.raw_data + bytes(SAMPLE_BYTES * lost), rate_hz, 1)


def _crossfaded(first: Any, second: Any, frames: int) -> Any:
    """Join two sounds that overlap by some frames, at equal power; pydub's own counts in whole milliseconds."""
    turn = np.linspace(0, np.pi / 2, frames + 2)[1:-1, np.newaxis]
    start = _frames(first) - frames
    leaving, coming = _samples(first)[start:], _samples(second)[:frames]
    both = np.clip(np.round(leaving * np.cos(turn) + coming * np.sin(turn)), -32_768, 32_767).astype("<i2")
    joined = first.raw_data[: start * first.frame_width] + both.tobytes()
    return _segment(joined + second.raw_data[frames * second.frame_width :], first.frame_rate, first.channels)


def _samples(sound: Any) -> NDArray[np.int16]:
    return np.frombuffer(sound.raw_data, "<i2").reshape(-1, sound.channels)
