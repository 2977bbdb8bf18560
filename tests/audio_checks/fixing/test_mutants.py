"""Whatever a file does, a fix makes a whole copy, or none, and says why; the file is only read."""

from contextlib import suppress

import numpy as np
import pytest

from audio_checks import FixRefused, fix_master, parse_spec, repair_spots, wav
from tests.support.mutants import mutant

pytestmark = pytest.mark.slow

SPEC = parse_spec("""
format = 1
[accept]
bit_depths = [16]
encodings = ["pcm"]
[limits]
sample_peak_dbfs = -20.0
head_silence_ms = 0
tail_silence_ms = 0
""")
MUTANTS = 80


@pytest.mark.parametrize("seed", [1, 2])
def test_mutants(tmp_path, seed):
    rng, made = np.random.default_rng(seed), 0
    out = tmp_path / "out"
    out.mkdir()
    for _ in range(MUTANTS // 2):
        content = mutant(rng)
        file = tmp_path / "mutant.wav"
        file.write_bytes(content)
        fixed = None
        with suppress(FixRefused):
            fixed = fix_master(file, SPEC, out)
        assert file.read_bytes() == content
        if fixed is None:
            continue
        assert fixed.path is not None or all(one.why for one in fixed.left)
        repair_spots(file, fixed)
        if fixed.path is not None:
            made += 1
            with wav.open_regular(fixed.path) as copy:
                wav.read_layout(copy)
            fixed.path.unlink()
        assert list(out.iterdir()) == []
    assert made
