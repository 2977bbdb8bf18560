"""Feeds the reader and the measures damaged files by the million: `make fuzz`."""

import argparse
import io
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

import audio_checks
from audio_checks.wav import blocks, read_layout
from tests.support.mutants import mutant

MEASURED_EVERY = 50  # reading is quick, a full check is not


def main() -> int:
    """Run, and return 1 with the seed of the first mutant that did anything but be read or refused."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--mutants", type=int, default=1_000_000)
    parser.add_argument("--seed", type=int, default=0)
    arguments = parser.parse_args()
    refused, begun = 0, time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "mutant.wav")
        for number in range(arguments.seed, arguments.seed + arguments.mutants):
            content = mutant(np.random.default_rng(number))
            try:
                file = io.BytesIO(content)
                for _block in blocks(file, read_layout(file)):
                    pass
            except audio_checks.Unreadable:
                refused += 1
            except Exception as error:
                sys.stdout.write(f"mutant {number}: {type(error).__name__}: {error}\n")
                return 1
            if number % MEASURED_EVERY == 0:
                path.write_bytes(content)
                if audio_checks.check_file(path).verdict == "unjudged":
                    sys.stdout.write(f"mutant {number}: the check broke\n")
                    return 1
    seconds = time.monotonic() - begun
    sys.stdout.write(f"{arguments.mutants} mutants in {seconds:.0f} s, {refused} refused in words, 0 failed\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
