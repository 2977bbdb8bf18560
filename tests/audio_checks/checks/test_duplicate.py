"""`duplicate`: the same samples under two names."""

import numpy as np
import pytest

from audio_checks import check_files
from audio_checks.spec.delivery_spec import parse_spec
from tests.support.chunks import bext
from tests.support.waves import noise, placeholder_mark, silence, sine, write_wav

SPEC = parse_spec("format = 1")


def found_in(*paths, spec=SPEC):
    report = check_files(paths, spec)
    return [[finding for finding in entry.findings if finding.check == "duplicate"] for entry in report.files]


@pytest.mark.parametrize(
    "samples",
    [sine(hz=997), noise(channels=2), silence(), np.array([[0.5]])],
    ids=["mono", "stereo", "silence", "frame"],
)
def test_every_file_but_the_first_is_named(tmp_path, samples):
    paths = [write_wav(tmp_path / f"{name}.wav", samples) for name in ("a", "b", "c")]
    first, second, third = found_in(*paths)
    assert first == []
    assert [one.code for one in (*second, *third)] == ["duplicate:same-sound"] * 2
    assert second[0].message == "the same samples as a.wav"


def test_one_sample_is_a_difference(tmp_path):
    samples = sine(hz=997)
    other = samples.copy()
    other[17] += 2.0**-23
    assert found_in(write_wav(tmp_path / "a.wav", samples), write_wav(tmp_path / "b.wav", other)) == [[], []]


def test_metadata_makes_no_difference_and_another_rate_is_reported(tmp_path):
    samples = noise(seconds=0.1)
    plain = write_wav(tmp_path / "plain.wav", samples)
    tagged = write_wav(tmp_path / "tagged.wav", samples, before=[bext(originator="Mara Lind")])
    slower = write_wav(tmp_path / "slower.wav", samples, rate=44_100)
    _, (same,), (other,) = found_in(plain, tagged, slower)
    assert same.message == "the same samples as plain.wav"
    assert other.message == "the same samples as plain.wav, under another sample rate"


def test_a_file_elsewhere_is_named_with_its_folder(tmp_path):
    (tmp_path / "b").mkdir()
    first = write_wav(tmp_path / "a.wav", sine(hz=997))
    _, (found,) = found_in(first, write_wav(tmp_path / "b" / "a.wav", sine(hz=997)))
    assert str(first) in found.message


def test_placeholders_are_left_alone(tmp_path):
    paths = [write_wav(tmp_path / f"{name}.wav", sine(hz=997), after=[placeholder_mark(name)]) for name in "ab"]
    assert found_in(*paths) == [[], []]


def test_where_the_spec_turns_it_off(tmp_path):
    paths = [write_wav(tmp_path / f"{name}.wav", sine(hz=997)) for name in "ab"]
    assert found_in(*paths, spec=parse_spec("format = 1\nchecks.duplicate = 'off'")) == [[], []]
    report = check_files(paths, parse_spec("format = 1\nchecks.duplicate = 'warning'"))
    assert [entry.verdict for entry in report.files] == ["conforming", "conforming"]


def test_real_recordings_are_all_different(recordings):
    assert not any(found_in(*recordings[::6]))
