"""`silence`: a file, or a channel, without a sound."""

import numpy as np
import pytest

from audio_checks.audio.audio_file import AudioFile
from tests.support.waves import click, noise, silence, sine

LIMIT = "limits.silence_below_dbfs = -90.0"


@pytest.mark.parametrize(("dbfs", "codes"), [(-90.2, ["silence:file"]), (-89.8, []), (-6.0, [])])
def test_a_file_that_never_exceeds_the_limit(codes_of, dbfs, codes):
    assert codes_of("silence", click(dbfs=dbfs), LIMIT) == codes


@pytest.mark.parametrize("samples", [silence(), silence(channels=2), silence(seconds=1 / 48_000)])
def test_digital_silence_is_named(found_by, samples):
    (finding,) = found_by("silence", samples, LIMIT)
    assert finding.code == "silence:file"
    assert finding.message.startswith("digital silence")
    assert finding.to_dict()["measured"] is None


def test_one_dead_channel_warns(found_by):
    samples = np.hstack([sine(hz=440), silence()])
    (finding,) = found_by("silence", samples, LIMIT)
    assert (finding.code, finding.severity) == ("silence:channel", "warning")
    assert "channel 2 of 2" in finding.message


@pytest.mark.parametrize(("dbfs", "codes"), [(-90.2, ["silence:channel"]), (-89.8, [])])
def test_a_channel_of_hiss_below_the_limit_is_dead_too(codes_of, dbfs, codes):
    assert codes_of("silence", np.hstack([click(dbfs=dbfs), sine(hz=440)]), LIMIT) == codes


def test_one_frame(codes_of):
    assert codes_of("silence", np.array([[0.5, 0.0]]), LIMIT) == ["silence:channel"]
    assert codes_of("silence", np.array([[0.5]]), LIMIT) == []


def test_real_recordings_sound_in_every_channel(recordings):
    for path in recordings[::6]:
        with AudioFile(path) as file:
            file.prepare(["channel_peaks_dbfs"])
            assert min(file.measurements.channel_peaks_dbfs) > -90


def test_two_live_channels_pass(codes_of):
    assert codes_of("silence", noise(channels=2), LIMIT) == []
