"""Speed and quality beside peers, in one run: `make bench` prints a table and writes benchmarks/results.json.

Ratios are what counts: machines are shared and noisy. Every figure is the median of its runs.
"""

import json
import shutil
import statistics
import subprocess
import tempfile
import time
from collections.abc import Callable
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np
import soxr
from pydub import AudioSegment

import audio_checks
from audio_checks.render.resample import resample
from tests.support.waves import noise, sine, wav_bytes

RUNS = 5
RESULTS = Path(__file__).with_name("results.json")


@dataclass
class Row:
    """One line of the table: ours against a peer, in seconds of CPU or wall, or in decibels."""

    what: str
    unit: str
    ours: float
    peer_name: str
    peer: float

    @property
    def ratio(self) -> float:
        """How many times the peer's figure is of ours; over 1 is better than the peer for seconds."""
        return self.peer / self.ours if self.ours else float("inf")


def cpu_s(work: Callable[[], object]) -> float:
    """Return the median CPU seconds of some work in this process, after one run that does not count."""
    work()
    times = []
    for _ in range(RUNS):
        begun = time.process_time()
        work()
        times.append(time.process_time() - begun)
    return statistics.median(times)


def wall_s(command: list[str]) -> float:
    """Return the median wall seconds of a command, after one run that does not count."""
    times = []
    for run in range(RUNS + 1):
        begun = time.perf_counter()
        subprocess.run(command, check=True, capture_output=True)
        if run:
            times.append(time.perf_counter() - begun)
    return statistics.median(times)


def checking(folder: Path) -> list[Row]:
    """Time whole checks against what peers measure on the same files."""
    rows = []
    spec = audio_checks.parse_spec(audio_checks.new_spec("44k1", name="bench"))
    effect, minute = folder / "effect.wav", folder / "minute.wav"
    effect.write_bytes(wav_bytes(noise(seconds=1, dbfs=-12), rate=48_000, bits=24))
    minute.write_bytes(wav_bytes(noise(seconds=60, dbfs=-12, channels=2, rate=96_000), rate=96_000, bits=24))

    def peer() -> object:
        sound = AudioSegment.from_wav(str(effect))
        return sound.max_dBFS, sound.dBFS

    ours = cpu_s(lambda: audio_checks.check_file(effect, spec))
    rows.append(Row("check of a 1 s effect, structure and limits", "s CPU", ours, "pydub peak and level", cpu_s(peer)))
    if shutil.which("ffmpeg"):
        measure = ["ffmpeg", "-nostats", "-i", str(minute), "-af", "ebur128=peak=true,astats", "-f", "null", "-"]
        ours = cpu_s(lambda: audio_checks.measure_file(minute))
        rows.append(
            Row("every figure of 60 s, 96 kHz/24 bit stereo", "s", ours, "ffmpeg ebur128+astats", wall_s(measure))
        )
    return rows


def rendering() -> list[Row]:
    """Time and judge 96 → 44.1 kHz beside soxr's best."""
    samples = noise(seconds=20, dbfs=-12, rate=96_000)
    ours = cpu_s(lambda: resample(samples, 96_000, 44_100))
    peer = cpu_s(lambda: soxr.resample(samples, 96_000, 44_100, quality="VHQ"))
    edge = sine(hz=0.95 * 22_050, dbfs=-6, seconds=2, rate=96_000)
    rows = [Row("96 → 44.1 kHz, 20 s mono in float64", "s CPU", ours, "soxr VHQ", peer)]
    losses = [_level_db(resample(edge, 96_000, 44_100)), _level_db(soxr.resample(edge, 96_000, 44_100, quality="VHQ"))]
    rows.append(Row("gain at 0.95 of the new Nyquist", "dB", losses[0] + 6.0, "soxr VHQ", losses[1] + 6.0))
    return rows


def _level_db(samples: np.ndarray) -> float:
    middle = samples[len(samples) // 4 : 3 * len(samples) // 4]
    return float(20 * np.log10(np.sqrt(2 * np.mean(middle**2))))


def main() -> None:
    """Print the table as Markdown and write it as JSON."""
    with tempfile.TemporaryDirectory() as folder:
        rows = checking(Path(folder)) + rendering()
    print("| what | ours | peer | | peer / ours |\n|---|---|---|---|---|")
    for row in rows:
        ratio = f"{row.ratio:.2f}" if row.unit != "dB" else ""
        print(f"| {row.what} | {row.ours:.4f} {row.unit} | {row.peer_name} | {row.peer:.4f} {row.unit} | {ratio} |")
    RESULTS.write_text(json.dumps([asdict(row) | {"ratio": row.ratio} for row in rows], indent=1) + "\n")


if __name__ == "__main__":
    main()
