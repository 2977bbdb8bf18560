"""Children of a sandbox find what they need: loading it again took longer than the checks."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from audio_checks import Sandbox, measure_file, rehearse_check, write_rehearsal_sound
from tests.support.loading import modules_loaded
from tests.support.waves import sine, write_wav


@pytest.fixture(scope="module")
def rehearsed() -> Iterator[Sandbox]:
    sandbox = Sandbox(rehearsal=rehearse_check)
    yield sandbox
    sandbox.close()


@pytest.mark.slow
@pytest.mark.parametrize(("rate", "bits", "channels"), [(48_000, 24, 2), (44_100, 16, 1)])
def test_a_child_loads_nothing(rehearsed: Sandbox, tmp_path: Path, rate: int, bits: int, channels: int) -> None:
    path = str(write_wav(tmp_path / "a.wav", sine(hz=440, dbfs=0, rate=rate, channels=channels), rate=rate, bits=bits))
    assert modules_loaded(rehearsed, "audio_checks", "check_file", path, all_figures=True) == []


@pytest.mark.slow
def test_without_a_rehearsal_it_loads_much(tmp_path: Path) -> None:
    path = str(write_wav(tmp_path / "a.wav", sine(hz=440, dbfs=0)))
    sandbox = Sandbox()
    assert len(modules_loaded(sandbox, "audio_checks", "check_file", path, all_figures=True)) > 20
    sandbox.close()


@pytest.mark.slow
def test_a_rehearsal_that_fails_stops_nobody() -> None:
    sandbox = Sandbox(rehearsal=len)  # wants an argument
    assert sandbox.call(len, "four") == 4
    sandbox.close()


def test_its_sound_is_one_that_judgements_are_computed_of(tmp_path: Path) -> None:
    write_rehearsal_sound(tmp_path / "sound.wav")
    report = measure_file(tmp_path / "sound.wav")
    assert (report.facts["bit_depth"], report.facts["channels"], report.facts["duration_s"]) == (24, 2, 1.0)
    assert report.judgements["reverb"]["score"] is not None
