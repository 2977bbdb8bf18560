"""Feeds the readers, the measures and the checks damaged files by the million: `make fuzz`."""

import argparse
import io
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

import audio_checks
from audio_checks.audio import flac
from audio_checks.metadata import read_metadata
from audio_checks.metadata.gather import Gathering
from audio_checks.spec.delivery_spec import parse_spec
from audio_checks.wav import blocks, read_layout
from tests.support.flacs import flac_mutant
from tests.support.mutants import mutant

CHECKED_EVERY, DECODED_EVERY = 50, 500  # reading is quick; a full check is not, and a FLAC decodes in a child
EVERYTHING = parse_spec(
    audio_checks.new_spec().replace('["wav"]', '["wav", "rf64", "flac"]').replace("# loudness_lufs", "loudness_lufs")
    + '[metadata]\nrequired = ["bext.Originator", "iXML.ASWG.catId", "INFO.ICMT"]\n'
)


def main() -> int:
    """Run, and return 1 with the seed of the first mutant that did anything but be read or refused."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--mutants", type=int, default=1_000_000)
    parser.add_argument("--seed", type=int, default=0)
    arguments = parser.parse_args()
    refused, begun = 0, time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        for number in range(arguments.seed, arguments.seed + arguments.mutants):
            try:
                refused += not survived(number, Path(folder))
            except Exception as error:
                sys.stdout.write(f"mutant {number}: {type(error).__name__}: {error}\n")
                return 1
    seconds = time.monotonic() - begun
    sys.stdout.write(f"{arguments.mutants} mutants in {seconds:.0f} s, {refused} refused in words, 0 failed\n")
    return 0


def survived(number: int, folder: Path) -> bool:
    """Read one damaged file, every so often whole; return whether it could be read."""
    rng = np.random.default_rng(number)
    is_flac = number % 5 == 0
    content = flac_mutant(rng) if is_flac else mutant(rng)
    if number % (DECODED_EVERY if is_flac else CHECKED_EVERY) == (0 if is_flac else 1):
        path = folder / ("mutant.flac" if is_flac else "mutant.wav")
        path.write_bytes(content)
        entry = audio_checks.check_file(path, EVERYTHING)
        if entry.verdict == "unjudged":
            raise AssertionError(f"the check broke: {entry.findings[0].message}")
        return entry.verdict != "unreadable"
    try:
        read_flac(content) if is_flac else read_wav(content)
    except audio_checks.Unreadable as refusal:
        if not (str(refusal).isprintable() and refusal.fix):
            raise AssertionError(f"refused without words: {refusal!r}") from None
        return False
    return True


def read_wav(content: bytes) -> None:
    """Read header, metadata and samples."""
    file = io.BytesIO(content)
    layout = read_layout(file)
    gathering = Gathering(layout.chunks)
    gathering.pass_by(0, content)
    gathering.read().to_dict()
    for _block in blocks(file, layout):
        pass


def read_flac(content: bytes) -> None:
    """Read the header and what it keeps."""
    layout = flac.read_layout(io.BytesIO(content))
    read_metadata(layout.riff_chunks).to_dict()


if __name__ == "__main__":
    sys.exit(main())
