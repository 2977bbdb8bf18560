"""FLAC and other containers for the check in the browser: what encoders write, every valid kind of frame, damages.

python -m tests.support.browser_flacs writes the files in `flac_files` again. They are kept, as libFLAC packs a
sound in other bytes on another processor.
"""

import io
from collections.abc import Iterator, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np
import soundfile

from audio_checks.wav.other_containers import OTHER_CONTAINERS
from tests.support import flacs, waves
from tests.support.flac_frames import all_kinds

KEPT = Path(__file__).with_name("flac_files")
FLAC = """
format = 1
[accept]
containers = ["wav", "flac"]
sample_rates_hz = [48000]
bit_depths = [16, 24]
duration_s = { min = 0.001, max = 1000 }
[limits]
sample_peak_dbfs = -100
silence_below_dbfs = -60
"""
LAYOUTS = 'format = 1\n[accept]\nlayouts = ["stereo", "quad", "5.1"]\n'
WAV_ONLY = 'format = 1\n[accept]\ncontainers = ["wav"]\n'


class Case(NamedTuple):
    """One file, and the spec and length it is judged by."""

    name: str
    content: bytes
    spec: str = FLAC
    asked: Mapping[str, Any] = MappingProxyType({})
    file_name: str = "sound.flac"


def sound(frames: int, channels: int, *, seed: int = 0) -> waves.Samples:
    """A tone in each channel under some noise, the loudest sample late and in the last channel."""
    rng = np.random.default_rng(seed)
    at = np.arange(frames)[:, np.newaxis] / 48_000
    samples = 0.3 * np.sin(2 * np.pi * (300 + 40 * np.arange(channels)) * at) + rng.normal(0, 2e-4, (frames, channels))
    samples[frames * 3 // 4, -1] = -0.81
    return samples


def kept_files() -> Iterator[tuple[str, bytes]]:
    """Yield what is kept, as libFLAC packs it here."""
    for level in range(9):
        yield f"24_bit_stereo_level_{level}", _packed(sound(700, 2, seed=level), "PCM_24", level)
    for bits in (8, 16, 24):
        for channels in (1, 2, 6):
            content = _packed(sound(600, channels), flacs.SUBTYPES[bits], 8 if bits == 16 else 5)
            yield f"{bits}_bit_{channels}_channels", content
    yield "of_several_frames", _packed(sound(4_000, 1) * 0.05, "PCM_16", 0)
    yield "silence", _packed(np.zeros((5_000, 2)), "PCM_24", 5)
    yield "16_in_24_bit", _packed(np.round(sound(500, 2) * 2**15) / 2**15, "PCM_24", 8)
    dead = sound(500, 2)
    dead[:, 0] = 0
    yield "a_dead_channel", _packed(dead, "PCM_16", 5)
    yield "noise", _packed(np.random.default_rng(1).uniform(-1, 1, (300, 2)), "PCM_16", 8)


def _packed(samples: waves.Samples, subtype: str, level: int) -> bytes:
    file = io.BytesIO()
    soundfile.write(file, samples, 48_000, format="FLAC", subtype=subtype, compression_level=level / 8)
    return file.getvalue()


def kept(name: str) -> bytes:
    """Return one of the kept files."""
    return (KEPT / f"{name}.flac").read_bytes()


def flac_cases() -> Iterator[Case]:
    """Yield FLAC files that can be read."""
    for path in sorted(KEPT.iterdir()):
        yield Case(f"FLAC: {path.stem.replace('_', ' ')}", path.read_bytes())
    for bits in (8, 16, 24):
        yield Case(f"FLAC: every kind of frame of {bits} bit", all_kinds(bits))
    stereo = kept("16_bit_2_channels")
    yield Case("FLAC: as the spec wants it", stereo, 'format = 1\n[accept]\ncontainers = ["flac"]\n')
    yield Case("FLAC: its container is warned of", stereo, WAV_ONLY + '[checks]\ncontainer = "warning"\n')
    yield Case("FLAC: its container is not checked", stereo, WAV_ONLY + '[checks]\ncontainer = "off"\n')
    yield Case("FLAC: not accepted", stereo, WAV_ONLY)
    yield Case("FLAC: under the name of a WAV", stereo, file_name="sound.wav")
    yield Case("FLAC: its ending in capitals", stereo, file_name="SOUND.FLAC")
    yield Case("FLAC: a WAV under its name", waves.wav_bytes(sound(96, 1)))
    yield Case("FLAC: too long for its cue", stereo, FLAC, {"duration_s": 0.001, "length_locked": True})
    comment = flacs.comments({"WAVEFORMATEXTENSIBLE_CHANNEL_MASK": "0x0603", "TITLE": "Laser"})
    quad = flacs.flac_bytes(np.zeros((16, 4)), bits=16)  # silence is packed the same everywhere
    yield Case("FLAC: four channels", quad, LAYOUTS)
    yield Case("FLAC: four channels with a mask", flacs.with_blocks(quad, [comment]), LAYOUTS)
    other = flacs.comments({"WAVEFORMATEXTENSIBLE_CHANNEL_MASK": "0x0107"})
    yield Case("FLAC: four channels with a mask of no layout", flacs.with_blocks(quad, [other]), LAYOUTS)
    wrong = flacs.comments({"WAVEFORMATEXTENSIBLE_CHANNEL_MASK": "0x3"})
    yield Case("FLAC: a mask of another count", flacs.with_blocks(quad, [wrong]), LAYOUTS)
    for channels in (3, 7):
        content = flacs.flac_bytes(np.zeros((16, channels)), bits=16)
        yield Case(f"FLAC: {channels} channels", content, LAYOUTS)
    picture = b"\0\0\0\3\0\0\0\x09image/png" + bytes(20) + b"\0\0\0\5abcde"
    blocks = [flacs.block(6, picture), flacs.block(9, b"new"), flacs.riff(b"smpl\x04\0\0\0abcd")]
    yield Case("FLAC: further blocks", flacs.with_blocks(stereo, blocks))
    yield Case("FLAC: bytes after its sound", stereo + b"TAG" + bytes(125))


def damaged_flac_cases() -> Iterator[Case]:
    """Yield FLAC files that cannot be read."""
    good = kept("of_several_frames")
    info, frames = flacs.split(good)
    head = len(good) - len(frames)
    second = head + frames.index(b"\xff\xf8", 9)
    unsigned = flacs.with_info(good, md5=bytes(16))
    yield Case("FLAC: cut", good[:-300])
    yield Case("FLAC: cut between frames", good[:second])
    yield Case("FLAC: cut in its checksum", good[:-1])
    yield Case("FLAC: cut in its first block", good[:30])
    yield Case("FLAC: cut in a block's head", good[:6])
    yield Case("FLAC: cut before its sound", good[:head])
    for name, place in (("a sample", head + 60), ("the head of a frame", second + 2), ("a checksum", len(good) - 1)):
        for whole, kind in ((good, ""), (unsigned, ", without MD5")):
            place_here = place - len(good) + len(whole)
            changed = bytes([whole[place_here] ^ 0x10])
            yield Case(f"FLAC: {name} changed{kind}", whole[:place_here] + changed + whole[place_here + 1 :])
    yield Case("FLAC: bytes between frames", good[:second] + bytes(9) + good[second:])
    yield Case("FLAC: a frame twice", good[:second] + good[head:])
    yield Case("FLAC: no frame at all", good[:head] + bytes(400))
    yield Case("FLAC: another MD5", flacs.with_info(good, md5=b"\1" * 16))
    yield Case("FLAC: without MD5", unsigned)
    for frames_said in (3_999, 4_001, 9_000, 1_000):
        yield Case(f"FLAC: says {frames_said} frames", flacs.with_info(good, frames=frames_said))
    yield Case("FLAC: fewer frames, without MD5", flacs.with_info(unsigned, frames=2_000))
    yield Case("FLAC: says an open length", flacs.with_info(good, frames=0))
    yield Case("FLAC: announces hours", flacs.with_info(good, frames=2**35 + 1))
    yield Case("FLAC: says no rate", flacs.with_info(good, rate=0))
    yield Case("FLAC: says a rate too high", flacs.with_info(good, rate=800_000))
    yield Case("FLAC: 20 bits", flacs.with_info(good, bits=20))
    for size in (33, 35, 90):
        content = b"fLaC" + flacs.block(0, (info + bytes(90))[:size], last=True) + frames
        yield Case(f"FLAC: STREAMINFO of {size} bytes", content)
    first = flacs.block(0, info)
    yield Case("FLAC: STREAMINFO twice", b"fLaC" + first + first + flacs.block(1, b"", last=True) + frames)
    yield Case("FLAC: STREAMINFO second", b"fLaC" + flacs.block(1, b"ab") + flacs.block(0, info, last=True) + frames)
    yield Case("FLAC: a block of kind 127", flacs.with_blocks(good, [flacs.block(127, b"ab")]))
    yield Case("FLAC: a block beyond the end", b"fLaC" + first + b"\x81\xff\xff\xff" + frames)


def other_containers() -> Iterator[Case]:
    """Yield files that are no WAV, whatever their names end in."""
    for offset, mark, code, _ in OTHER_CONTAINERS:
        yield Case(f"other: {code}", bytes(offset) + mark + bytes(40), file_name="sound.wav")
    yield Case("other: MP3 without a tag", b"\xff\xfb\x90\x44" + bytes(60), file_name="sound.wav")
    yield Case("other: unknown", b"\x7fELF" + bytes(60), file_name="sound.wav")
    for kind in (b"AIFF", b"AIFC"):
        for name in ("sound.aiff", "sound.aif", "sound.wav"):
            yield Case(f"{kind.decode()} as {name}", aiff(kind), file_name=name)


def aiff(kind: bytes) -> bytes:
    """An AIFF or AIFF-C file of 16-bit samples at 48 kHz, its rate as a float of 80 bits."""
    compression = b"NONE\x00\x00" if kind == b"AIFC" else b""
    common = b"\0\1\0\0\0\x60\0\x10" + bytes.fromhex("400ebb80000000000000") + compression
    sound_data = bytes(8) + bytes(192)
    body = kind + b"COMM" + len(common).to_bytes(4, "big") + common
    body += b"SSND" + len(sound_data).to_bytes(4, "big") + sound_data
    return b"FORM" + len(body).to_bytes(4, "big") + body


if __name__ == "__main__":
    KEPT.mkdir(exist_ok=True)
    for stem, packed in kept_files():
        (KEPT / f"{stem}.flac").write_bytes(packed)
