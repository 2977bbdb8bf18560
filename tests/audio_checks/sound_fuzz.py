"""Sends sounds of every shape through every figure, check, judgement, fix, render, drawing and audit.

`make fuzz` does so 200,000 times; the suite with as many as fit into it, with new seeds each week. It can go on
where it was stopped: `python -m tests.audio_checks.sound_fuzz --first 120000 --count 80000`.
"""

from __future__ import annotations

import argparse
import math
import sys
import tempfile
import time
import traceback
import warnings
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import audio_checks
from app.renders.drawing import prepare
from audio_checks.report.findings import dumps
from tests.support.any_sound import any_sound

EVERYTHING = audio_checks.parse_spec("""
format = 1
name = "everything"
[accept]
containers = ["wav", "rf64", "flac"]
encodings = ["pcm"]
sample_rates_hz = [44100, 48000, 96000]
bit_depths = [16, 24]
channels = [1, 2]
duration_s = { min = 0.01, max = 15.0 }
[limits]
sample_peak_dbfs = -0.1
true_peak_dbtp = -1.0
dc_offset_percent = 1.0
silence_below_dbfs = -90.0
head_silence_ms = 5
tail_silence_ms = 100
mono_loss_db = 6.0
loudness_lufs = { min = -40.0, max = -10.0 }
noise_floor_dbfs = -60.0
[engine]
adds = ["reverb"]
[checks]
reversed = "warning"
upsampled = "warning"
lossy = "warning"
[targets.game]
sample_rate_hz = 44100
bit_depth = 16
[targets.handheld]
sample_rate_hz = 22050
bit_depth = 8
channels = 1
[targets.float]
sample_rate_hz = 11025
bit_depth = 32
encoding = "float"
over_peak = "refuse"
[targets.vorbis]
sample_rate_hz = 8000
encoding = "vorbis"
quality = 0.2
[targets.opus]
sample_rate_hz = 48000
encoding = "opus"
channels = 1
[targets.flac]
sample_rate_hz = 22050
bit_depth = 16
encoding = "flac"
""")
TOGETHER = 100  # in one child, which decodes and encodes in itself as the server's do; a crash costs these alone
TOGETHER_S, MEMORY_BYTES = 3_600.0, 4 << 30
TWICE_EVERY = 4  # are also judged by what the checks read alone, as the command line does


class Failed(AssertionError):
    """A sound that something could not be made of."""


def main() -> int:
    """Run, and return 1 when anything raised; each failure is printed with its seed as it is met."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--first", type=int, default=0, help="the first seed")
    parser.add_argument("--count", type=int, default=200_000, help="how many sounds")
    arguments = parser.parse_args()
    from tests.audio_checks.sound_fuzz import failures_of  # by the name by which the child imports it

    failed, begun = 0, time.monotonic()
    end = arguments.first + arguments.count
    loaded = ("numpy", "soundfile", "audio_checks", "tests.audio_checks.sound_fuzz")
    box = audio_checks.Sandbox(timeout_s=TOGETHER_S, memory_bytes=MEMORY_BYTES, preload=loaded)
    for first in range(arguments.first, end, TOGETHER):
        last = min(first + TOGETHER, end) - 1
        try:
            failures = box.call(failures_of, first, last)
        except audio_checks.SandboxFailed as error:
            failures = [f"a seed from {first} to {last}: {error}"]
        for failure in failures:
            say(failure)
        failed += len(failures)
        done, seconds = last - arguments.first + 1, time.monotonic() - begun
        say(f"{done} sounds, the last of seed {last}, in {seconds:.0f} s: {failed} failed")
    box.close()
    return 1 if failed else 0


def failures_of(first: int, last: int) -> list[str]:
    """Return what was raised by the sounds of some seeds, with the seed and what the sound is."""
    failures = []
    for seed in range(first, last + 1):
        try:
            survive(seed)
        except Exception:
            failures.append(f"seed {seed}: {any_sound(seed).words}\n{traceback.format_exc()}")
    return failures


def say(line: str) -> None:
    """Print at once, so that a log shows how far a run is."""
    sys.stdout.write(f"{line}\n")
    sys.stdout.flush()


def survive(seed: int, *, longest_s: float = 20.0) -> None:
    """Make everything of the sound of one seed; Failed, or whatever was raised, where that is not possible."""
    with tempfile.TemporaryDirectory(prefix="sound-fuzz-") as name, warnings.catch_warnings():
        warnings.simplefilter("error", RuntimeWarning)  # an overflow or a division by zero makes figures that are none
        folder = Path(name)
        path = folder / "any_sound.wav"
        content = any_sound(seed, longest_s=longest_s).content
        path.write_bytes(content)
        _judge(path, twice=seed % TWICE_EVERY == 0)
        _fix(path, folder)
        games = _render_and_draw(path, folder)
        _audit([path, *games])
        if path.read_bytes() != content:
            raise Failed("the master was changed")


def _judge(path: Path, *, twice: bool) -> None:
    entry = audio_checks.check_file(path, EVERYTHING, all_figures=True)
    if entry.verdict in ("unjudged", "unreadable") or entry.unjudged:
        raise Failed(f"{entry.verdict}: {entry.unjudged or entry.findings}")
    dumps(entry.to_dict())
    _ensure_numbers("measurements", entry.measurements)
    _ensure_numbers("judgements", entry.judgements)
    if twice:
        quick = audio_checks.check_file(path, EVERYTHING)
        if (quick.verdict, quick.findings) != (entry.verdict, entry.findings):
            raise Failed(f"measuring everything changes the verdict: {quick.findings} and {entry.findings}")
    for finding in entry.findings:
        if not (finding.message and finding.fix and finding.severity):
            raise Failed(f"a finding without words: {finding}")
        _ensure_numbers(finding.code, {"measured": finding.measured, "limit": finding.limit})


def _ensure_numbers(where: str, value: Any) -> None:
    """Raise Failed where a figure is not a number, or endless: -inf alone is valid, for silence."""
    if isinstance(value, Mapping):
        for name, one in value.items():
            _ensure_numbers(f"{where}.{name}", one)
    elif isinstance(value, list | tuple):
        for one in value:
            _ensure_numbers(where, one)
    elif isinstance(value, float) and (math.isnan(value) or value == math.inf):
        raise Failed(f"{where} is {value}")


def _fix(path: Path, folder: Path) -> None:
    out = folder / "fixed"
    out.mkdir()
    try:
        fixed = audio_checks.fix_master(path, EVERYTHING, out)
    except audio_checks.FixRefused:
        return
    dumps(fixed.to_dict())
    if fixed.path is not None:
        audio_checks.repair_spots(path, fixed)
        if fixed.after is None or fixed.after.verdict in ("unjudged", "unreadable"):
            raise Failed(f"the fixed copy is {fixed.after and fixed.after.verdict}")


def _render_and_draw(path: Path, folder: Path) -> list[Path]:
    """Render to every target and draw, as the server does; return the game files."""
    recipes = {
        name: {
            "target": target,
            "loop": False,
            "sample_peak_limit_dbfs": -0.1,
            "true_peak_limit_dbtp": -1.0,
            "tolerance_db": 0.05,
        }
        for name, target in EVERYTHING.targets.items()
    }
    made = folder / "made"
    made.mkdir()
    for error in prepare(str(path), str(made), recipes, loop=False, draws_master=True).values():
        if isinstance(error, Exception) and not isinstance(error, audio_checks.RenderRefused):
            raise error
    return [one for number in range(len(recipes)) for one in (made / str(number)).glob("render.*")]


def _audit(paths: list[Path]) -> None:
    approved = audio_checks.fingerprint_files([(str(paths[0]), "a.wav")])
    built = audio_checks.fingerprint_files([(str(path), f"{number}.wav") for number, path in enumerate(paths)])
    if any(one.trouble for one in (*approved, *built)):
        raise Failed(f"not heard: {[one.trouble for one in (*approved, *built)]}")
    audit = audio_checks.audit_build(approved, built)
    dumps(audit.to_dict())
    as_it_is = audit.to_dict()["files"][0]
    if as_it_is["status"] not in ("same", "duplicate", "unknown", "placeholder"):
        raise Failed(f"the same file is {as_it_is['status']}")


if __name__ == "__main__":
    sys.exit(main())
