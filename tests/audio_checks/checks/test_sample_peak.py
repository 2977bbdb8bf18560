"""`sample-peak`: the loudest sample of any channel."""

import numpy as np
import pytest

from tests.support.waves import click, silence

LIMIT = "limits.sample_peak_dbfs = -0.1"


@pytest.mark.parametrize(("dbfs", "codes"), [(-0.04, ["sample-peak:over"]), (-0.06, []), (-0.1, []), (-20.0, [])])
def test_a_level_fails_more_than_the_tolerance_beyond_its_limit(codes_of, dbfs, codes):
    assert codes_of("sample-peak", click(dbfs=dbfs), LIMIT) == codes


def test_the_peak_is_found_in_any_channel_and_at_the_last_sample(found_by):
    samples = silence(seconds=0.5, channels=2)
    samples[-1, 1] = -1.0
    (finding,) = found_by("sample-peak", samples, LIMIT)
    assert finding.measured == pytest.approx(0.0, abs=1e-6)
    assert finding.start_s == pytest.approx(0.5 - 1 / 48_000)
    assert "0.10 dB" in finding.fix


@pytest.mark.parametrize("samples", [silence(), np.full((1, 1), 0.5)])
def test_quiet_things_pass(codes_of, samples):
    assert codes_of("sample-peak", samples, LIMIT) == []
