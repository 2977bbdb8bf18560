"""`padded-bits`: depth that is only said."""

import numpy as np
import pytest

from audio_checks.audio.audio_file import AudioFile
from audio_checks.measure.steps import Steps
from audio_checks.run.runner import check_file
from audio_checks.spec.delivery_spec import parse_spec
from tests.support.waves import noise, silence, write_wav

ANY_SPEC = parse_spec("format = 1")


def quantised(samples, bits):
    return np.rint(samples * 2 ** (bits - 1)) / 2 ** (bits - 1)


@pytest.mark.parametrize("channels", [1, 2])
@pytest.mark.parametrize(
    ("was", "bits", "codes"), [(16, 24, ["zeros"]), (20, 24, ["zeros"]), (21, 24, []), (24, 24, [])]
)
def test_empty_lower_bits(found_by, channels, was, bits, codes):
    found = found_by("padded-bits", quantised(noise(seconds=0.2, channels=channels), was), bits=bits)
    assert [finding.code for finding in found] == [f"padded-bits:{code}" for code in codes]
    for finding in found:
        assert (finding.measured, finding.limit, finding.unit) == (float(was), 24.0, "bit")


@pytest.mark.parametrize("gain_db", [-9.0, -1.3, 4.2])
def test_a_change_of_level_hides_them_and_is_seen_through(found_by, gain_db):
    gain = 10 ** (gain_db / 20)
    (finding,) = found_by("padded-bits", quantised(noise(seconds=0.2), 16) * gain, bits=24)
    assert finding.code == "padded-bits:steps"
    assert finding.measured == pytest.approx(16 - np.log2(gain), abs=0.01)


@pytest.mark.parametrize(
    "samples", [silence(), silence(channels=2), np.array([[0.5]]), np.sign(noise()) * 0.5], ids=["mono", "2", "1", "sq"]
)
def test_what_says_nothing(codes_of, samples):
    assert codes_of("padded-bits", samples) == []


def test_float_samples_are_not_asked(codes_of):
    assert codes_of("padded-bits", quantised(noise(seconds=0.1), 16), bits=32, encoding="float") == []


def test_a_quiet_recording_raised_by_30_db_has_lost_as_much(codes_of):
    assert codes_of("padded-bits", quantised(noise(seconds=0.2, dbfs=-50), 16) * 31.6, bits=16) == ["padded-bits:steps"]


def test_real_recordings_pass_and_are_found_when_padded(recordings, tmp_path):
    for path in recordings[::9]:
        with AudioFile(path) as file:
            blocks = [block.copy() for block in _blocks(file)]
            rate, bits = file.facts.sample_rate_hz, file.facts.bit_depth
        assert bits == 16
        assert check_file(path, ANY_SPEC, checks=["padded-bits"]).findings == ()
        samples = np.concatenate(blocks)
        padded = write_wav(tmp_path / "padded.wav", samples * 0.7, rate=rate, bits=24)
        (finding,) = check_file(padded, ANY_SPEC, checks=["padded-bits"]).findings
        assert finding.measured == pytest.approx(16 - np.log2(0.7), abs=0.05)


def _blocks(file):
    from audio_checks import wav

    with wav.open_regular(file.path) as stream:
        yield from wav.blocks(stream, file.layout)


def test_padding_is_found_in_every_real_recording_and_real_depth_passes(recordings):
    rng = np.random.default_rng(4)
    found, alarms = [], []
    for path in recordings:
        with AudioFile(path) as file:
            samples = np.concatenate([block.copy() for block in _blocks(file)])[:50_000]
        gains_db = (0.0, *rng.uniform(-12, 0, 3))
        found += [step_at_24_bits(samples * 10 ** (gain_db / 20)) for gain_db in gains_db]
        # Processed by five taps of no common measure. Two taps in a ratio of whole numbers would keep a quiet
        # 16-bit sound on steps, and it would rightly be named.
        taps = rng.standard_normal((14, 5)) * 0.1 + np.array([0, 0, 1, 0, 0])
        mixed = (sum(tap * samples[place : len(samples) - 4 + place] for place, tap in enumerate(row)) for row in taps)
        alarms += [step_at_24_bits(one / 1.5) for one in mixed]
    assert sum(one is not None and one > 1 for one in found) >= 0.99 * len(found)
    assert len(alarms) >= 1_000
    assert not [alarm for alarm in alarms if alarm is not None and alarm > 1]


def step_at_24_bits(samples):
    steps = Steps(48_000, samples.shape[1], len(samples), step=2.0**-23)
    steps.add(np.rint(samples * 2**23) / 2**23)
    return steps.result()["sample_step"]
