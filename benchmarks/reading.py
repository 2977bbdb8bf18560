"""Reading and decoding compared with soundfile, and the memory that a large file takes."""

import subprocess
import sys
from pathlib import Path

import numpy as np

from benchmarks import sounds
from benchmarks.checking import read_by_soundfile, read_by_us
from benchmarks.rows import Row
from benchmarks.timing import in_turns, own_cpu
from tests.support.waves import write_large

MAX_MIB = 256
LARGE_BYTES = 2 << 30
MEASURE = """
import sys, time
import audio_checks
audio_checks.measure_file(sys.argv[1])
print(int(open("/proc/self/status").read().partition("VmHWM:")[2].split()[0]) / 1024, time.process_time())
"""


def rows(folder: Path, quick: bool) -> list[Row]:
    """Read 10 s at three depths, and a file of 2 GiB."""
    found = []
    samples = np.clip(sounds.coloured(np.random.default_rng(3), 10 * 96_000, 2, 0.1) * 0.1, -1, 0.999)
    for bits in (16, 24, 32):
        path = sounds.write(folder / f"depth_{bits}.wav", samples, 96_000, bits)
        works = {"ours": own_cpu(read_by_us(path)), "soundfile": own_cpu(read_by_soundfile(path))}
        took = in_turns(works, 3 if quick else 15)
        ours, theirs = (f"{path.stat().st_size / 1e6 / took[name]:,.0f} MB/s" for name in works)
        ratio = took["soundfile"] / took["ours"]
        found.append(Row(f"reading and decoding {bits} bit", ratio, ours=ours, peer=f"soundfile: {theirs}"))
    path = write_large(folder / "large.wav", LARGE_BYTES // (8 if quick else 1))
    command = [sys.executable, "-c", MEASURE, str(path)]
    said = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    mib, seconds = (float(one) for one in said.split())
    what = f"every figure of a file of {path.stat().st_size / (1 << 30):g} GiB: memory at most"
    return [*found, Row(what, mib, "MiB", MAX_MIB, None, "less", f"{seconds:.1f} s CPU")]
