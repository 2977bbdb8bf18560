"""Sounds with what the server says of them, to which the check in the browser is held.

python -m tests.support.browser_vectors FILE
"""

import base64
import json
import struct
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

import audio_checks
from app.conformance.rules import JUDGED_IN_BROWSER, fix_offers, levels_in_browser
from app.conformance.schemas import CueLength, SpecView
from tests.support import waves
from tests.support.browser_flacs import Case, damaged_flac_cases, flac_cases, other_containers

Facts = dict[str, Any]
STRICT = """
format = 1
[accept]
containers = ["wav"]
encodings = ["pcm"]
sample_rates_hz = [48000, 96000]
bit_depths = [16, 24]
channels = [1, 2]
duration_s = { min = 0.001, max = 0.1 }
[limits]
sample_peak_dbfs = -1.0
silence_below_dbfs = -60
"""
FREE = "format = 1\n"
LAYOUTS = 'format = 1\n[accept]\nlayouts = ["stereo", "quad", "5.1", "ambisonic-1"]\n'
AMBISONIC = bytes.fromhex("010000002107d3118644c8c1ca000000")


def tone(dbfs: float = -6.0, *, frames: int = 96, channels: int = 1) -> waves.Samples:
    """Square steps whose largest sample is at `dbfs` after rounding; too short for tops that are cut off."""
    steps = np.where(np.arange(frames) % 4 < 2, 1.0, -1.0) * 10 ** (dbfs / 20)
    return np.repeat(steps[:, np.newaxis], channels, axis=1)


def pcm(samples: waves.Samples, bits: int = 16, rate: int = 48_000, **head: Any) -> bytes:
    """A plain WAV file; `head` lies in its `fmt ` chunk."""
    fmt = waves.fmt(channels=samples.shape[1], rate=rate, bits=bits, **head)
    return waves.riff(waves.chunk(b"fmt ", fmt), waves.chunk(b"data", waves.pcm_bytes(samples, bits)))


def floats(samples: waves.Samples, bits: int = 32) -> bytes:
    """A WAV file of floating-point samples."""
    fmt = waves.fmt(tag=3, channels=samples.shape[1], bits=bits)
    return waves.riff(waves.chunk(b"fmt ", fmt), waves.chunk(b"data", waves.float_bytes(samples, bits)))


def masked(samples: waves.Samples, mask: int, guid: bytes = waves.PCM_GUID) -> bytes:
    """A WAV file that says where its channels stand."""
    head = {"channels": samples.shape[1], "container_bits": 16, "valid_bits": 16, "mask": mask, "guid": guid}
    fmt = waves.extensible(**head)
    return waves.riff(waves.chunk(b"fmt ", fmt), waves.chunk(b"data", waves.pcm_bytes(samples, 16)))


def cut_off(over_db: float, at_dbfs: float, frames: int = 480) -> waves.Samples:
    """A tone of 1 kHz with its tops cut off, and then brought to a level."""
    swing = np.sin(2 * np.pi * np.arange(frames) / 48 + 0.1) * 10 ** (over_db / 20)
    return (np.clip(swing, -1.0, 1.0) * 10 ** (at_dbfs / 20))[:, np.newaxis]


def rf64(samples: waves.Samples) -> bytes:
    """An RF64 file."""
    data = waves.pcm_bytes(samples, 16)
    fmt = waves.chunk(b"fmt ", waves.fmt(bits=16))
    riff_size = 4 + 8 + 28 + len(fmt) + 8 + len(data)
    ds64 = waves.chunk(b"ds64", struct.pack("<QQQI", riff_size, len(data), len(samples), 0))
    return waves.riff(ds64, fmt, waves.chunk(b"data", data, size=0xFFFFFFFF), size=0xFFFFFFFF, magic=b"RF64")


def formats() -> Iterator[tuple[str, bytes, str, Facts]]:
    """Yield sounds that differ in what their header says."""
    yield "conforms", pcm(tone()), STRICT, {}
    for bits in (8, 16, 24, 32):
        yield f"{bits} bit", pcm(tone(-3.3), bits), STRICT, {}
    for rate in (1_000, 8_000, 44_100, 48_000, 72_000, 96_000, 192_000):
        yield f"{rate} Hz", pcm(tone(), rate=rate), STRICT, {}
    yield "float", floats(tone()), STRICT, {}
    yield "float of 64 bit over full scale", floats(tone(1.234), 64), STRICT, {}
    yield "integers where floats are wanted", pcm(tone()), 'format = 1\n[accept]\nencodings = ["float"]\n', {}
    yield "a codec is wanted", pcm(tone()), 'format = 1\n[accept]\nencodings = ["vorbis", "opus"]\n', {}
    yield "RF64", rf64(tone()), STRICT, {}
    yield "RF64 accepted", rf64(tone()), FREE, {}
    yield (
        "20 of 24 bits",
        waves.riff(
            waves.chunk(b"fmt ", waves.extensible(container_bits=24, valid_bits=20)),
            waves.chunk(b"data", waves.pcm_bytes(tone(), 24)),
        ),
        "format = 1\n[accept]\nbit_depths = [16, 24]\n",
        {},
    )
    yield "three channels", pcm(tone(channels=3)), STRICT, {}
    for count, mask in ((1, 0), (2, 0), (2, 3), (2, 0x600), (3, 0), (4, 0), (4, 0x33), (4, 0x107), (6, 0x3F), (6, 0)):
        yield f"{count} channels, mask {mask:#x}", masked(tone(channels=count), mask), LAYOUTS, {}
    yield "ambisonic", masked(tone(channels=4), 0, AMBISONIC), LAYOUTS, {}
    yield "ambisonic of order 2", masked(tone(channels=9), 0, AMBISONIC), LAYOUTS, {}


def levels() -> Iterator[tuple[str, bytes, str, Facts]]:
    """Yield sounds that differ in level and length."""
    for dbfs in (0.0, -0.9, -0.94, -0.96, -1.0, -1.05, -3.0):
        yield f"peak at {dbfs} dBFS", pcm(tone(dbfs), 24), STRICT, {}
    late = tone(-20, frames=96, channels=2)
    late[50, 1] = -0.99
    for at_dbfs in (0.0, -0.3):
        yield f"tops cut off at {at_dbfs} dBFS", pcm(cut_off(7.0, at_dbfs), 24), STRICT, {}
        yield f"the same in 16 bit at {at_dbfs} dBFS", pcm(cut_off(3.0, at_dbfs)), STRICT, {}
        yield f"the same in float at {at_dbfs} dBFS", floats(cut_off(3.0, at_dbfs)), STRICT, {}
        yield f"round tops at {at_dbfs} dBFS", pcm(cut_off(-0.001, at_dbfs), 24), STRICT, {}
    yield "float over full scale, round", floats(cut_off(-0.001, 1.6)), STRICT, {}
    yield "a square wave", pcm(np.sign(cut_off(0.0, 0.0)) * 0.95, 24), STRICT, {}
    yield "peak late in the second channel", pcm(late), STRICT, {}
    yield "a limit of many digits", pcm(tone()), "format = 1\n[limits]\nsample_peak_dbfs = -12.345678\n", {}
    yield "a limit far away", pcm(tone()), "format = 1\n[limits]\nsample_peak_dbfs = -100\ntolerance_db = 0\n", {}
    yield "silence", pcm(np.zeros((96, 2))), STRICT, {}
    yield "nearly silence", pcm(tone(-70), 24), STRICT, {}
    dead = tone(channels=3)
    dead[:, 1:] = 0
    yield "dead channels", pcm(dead), "format = 1\n[limits]\nsilence_below_dbfs = -60.5\n", {}
    yield "short", pcm(tone(frames=24)), STRICT, {}
    yield "as long as may be", pcm(tone(frames=4_800), 8), STRICT, {}
    yield "a frame too long", pcm(tone(frames=4_801), 8), STRICT, {}
    for seconds in (0.1, 0.09, 0.05, 0.3):
        yield f"the cue asks for {seconds} s", pcm(tone(frames=80), 8, 1_000), FREE, {"duration_s": seconds}
    for fps in (None, 60.0, 29.97, 23.976):
        locked = {"duration_s": 0.05, "length_locked": True, "frame_rate_fps": fps}
        yield f"locked at {fps} fps", pcm(tone(frames=100), 8, 1_000), FREE, locked
    for bounds in ({"duration_min_s": 0.2}, {"duration_max_s": 0.05}, {"duration_min_s": 0.01, "duration_max_s": 0.09}):
        yield (
            f"the cue bounds its length: {bounds}",
            pcm(tone(frames=100), 8, 1_000),
            FREE,
            {"duration_s": 0.1} | bounds,
        )
    exact = {"duration_min_s": 0.1, "duration_max_s": 0.1, "length_locked": True}
    yield "the cue bounds its length to what it has", pcm(tone(frames=100), 8, 1_000), FREE, exact
    yield "the cue locks its bounds", pcm(tone(frames=101), 8, 1_000), FREE, exact
    within = {"duration_s": 0.1, "length_locked": True, "frame_rate_fps": 60.0}
    yield "locked, within a frame", pcm(tone(frames=110), 8, 1_000), FREE, within
    for asked in ("mono", "stereo"):
        yield f"the cue is {asked}", pcm(tone(frames=80, channels=2), 8, 1_000), FREE, {"channels": asked}


def severities() -> Iterator[tuple[str, bytes, str, Facts]]:
    """Yield sounds judged by specs that say how serious checks are."""
    bad = pcm(tone(0.0, frames=96, channels=3), 8, 44_100)
    yield "much at once", bad, STRICT, {"duration_s": 1.0}
    graded = '\n[checks]\nsample-rate = "warning"\nbit-depth = "off"\nduration = "error"\nsample-peak = "warning"\n'
    yield "much at once, graded", bad, STRICT + graded, {"duration_s": 1.0}
    yield "a dead channel is an error", pcm(np.c_[tone(), np.zeros(96)]), STRICT + '\n[checks]\nsilence = "error"\n', {}


def damaged() -> Iterator[tuple[str, bytes, str, Facts]]:
    """Yield files that cannot be read, each with what the server says; what is odd is the server's to judge."""
    whole = pcm(tone())
    data = waves.chunk(b"data", waves.pcm_bytes(tone(), 16))
    fmt = waves.chunk(b"fmt ", waves.fmt())
    yield "cut short", whole[:-40], STRICT, {}
    yield "cut in its header", whole[:10], STRICT, {}
    yield "zeros", bytes(200), STRICT, {}
    yield "not WAVE", waves.riff(fmt, data, form=b"AVI "), STRICT, {}
    yield "a codec", waves.riff(waves.chunk(b"fmt ", waves.fmt(tag=2)), data), STRICT, {}
    yield "an unknown codec", waves.riff(waves.chunk(b"fmt ", waves.fmt(tag=0x1234)), data), STRICT, {}
    yield "no sound", waves.riff(fmt, waves.chunk(b"data", b"")), STRICT, {}
    yield "no data chunk", waves.riff(fmt), STRICT, {}
    yield "two data chunks", waves.riff(fmt, data, data), STRICT, {}
    yield "no fmt chunk", waves.riff(data), STRICT, {}
    yield "fmt after data", waves.riff(data, fmt), STRICT, {}
    yield "part of a frame", waves.riff(fmt, waves.chunk(b"data", bytes(95))), STRICT, {}
    yield "sizes left open", waves.riff(fmt, data, size=0xFFFFFFFF), STRICT, {}
    yield "RIFF size of zero", waves.riff(fmt, data, size=0), STRICT, {}
    yield "too large a RIFF size", waves.riff(fmt, data, size=5_000), STRICT, {}
    yield "a chunk beyond the end", waves.riff(fmt, data, waves.chunk(b"LIST", b"abcd", size=900)), STRICT, {}
    for lie in ({"channels": 0}, {"rate": 900}, {"bits": 12, "byte_rate": 1}, {"byte_rate": 7}, {"block_align": 9}):
        yield f"fmt says {lie}", waves.riff(waves.chunk(b"fmt ", waves.fmt(**lie)), data), STRICT, {}
    yield "float of 16 bit", waves.riff(waves.chunk(b"fmt ", waves.fmt(tag=3)), data), STRICT, {}
    yield "bytes after the end", whole + b"\1\2\3\4", STRICT, {}
    yield "not a number", floats(np.array([[0.5], [np.nan], [0.1]])), STRICT, {}


def cases() -> Iterator[Case]:
    """Yield every file."""
    for name, content, toml, asked in (*formats(), *levels(), *severities(), *damaged()):
        yield Case(name, content, toml, asked, "sound.wav")
    yield from (*flac_cases(), *damaged_flac_cases(), *other_containers())


def expected(case: Case, spec: audio_checks.DeliverySpec, cue: audio_checks.CueFacts, folder: Path) -> Facts:
    """Return what the server finds, of the checks that are made in the browser; all where it looks no further."""
    path = folder / "stored"
    path.write_bytes(case.content)
    report = audio_checks.check_file(path, spec, cue=cue, name=case.file_name).to_dict()
    is_unreadable = not report.get("facts")
    kept = ("code", "severity", "message", "fix", "measured", "limit", "unit", "start_s", "end_s")
    offers = fix_offers(report, spec)
    findings = [
        {key: one[key] for key in kept} | {"auto_fix": offer.words if offer else None}
        for one, offer in zip(report["findings"], offers, strict=True)
        if is_unreadable or one["check"] in JUDGED_IN_BROWSER
    ]
    return {"isUnreadable": is_unreadable, "findings": findings}


def vectors() -> str:
    """Return every sound with the view of the spec it is judged by and what is found, as JSON."""
    made = []
    with tempfile.TemporaryDirectory() as folder:
        for case in cases():
            spec = audio_checks.parse_spec(case.spec).for_category("")
            cue = audio_checks.CueFacts(number="1", **case.asked)
            facts = {"category": spec.category, "accept": spec.accept, "limits": spec.limits}
            view = SpecView.model_validate(facts | {"levels": levels_in_browser(spec)})
            made.append(
                {
                    "name": case.name,
                    "fileName": case.file_name,
                    "bytes": base64.b64encode(case.content).decode(),
                    "spec": view.model_dump(mode="json"),
                    "length": CueLength.model_validate(cue).model_dump(mode="json"),
                    "expected": expected(case, spec, cue, Path(folder)),
                }
            )
    lines = ",\n".join(json.dumps(one, ensure_ascii=False) for one in made)
    return f"[\n{lines}\n]\n"


if __name__ == "__main__":
    Path(sys.argv[1]).write_text(vectors(), encoding="utf-8")
