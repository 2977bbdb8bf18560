"""`lossy`: a question, only where the spec names it."""

import numpy as np
import pytest

from audio_checks.measure.codec_lines import mp3_lines
from tests.support.waves import noise, silence

ASKED = "checks.lossy = 'warning'"
FRAMES = ["lossy:frames"]
CLEAN = noise()


def _on_mp3_frames():
    """A sound of MP3's lines, two of five silent in each frame."""
    lines, draws = mp3_lines(range(6, 29)), np.random.default_rng(5)
    sound = np.zeros((20_000, 1))
    for start in range(100, 18_000, 576):
        levels = 0.02 * draws.standard_normal(len(lines)) * (draws.random(len(lines)) < 0.6)
        sound[start : start + lines.shape[1], 0] += levels @ lines
    return sound


CODED = _on_mp3_frames()


@pytest.mark.parametrize(
    ("samples", "codes"),
    [(CODED, FRAMES), (np.repeat(CODED, 2, axis=1), FRAMES), (CLEAN, []), (silence(), []), (CODED[:1] + 0.5, [])],
    ids=["coded", "stereo", "never coded", "silence", "one frame"],
)
def test_only_what_stands_on_a_codec_s_frames(codes_of, samples, codes):
    assert codes_of("lossy", samples, ASKED) == codes


@pytest.mark.parametrize(("tables", "codes"), [("", []), (ASKED, FRAMES)])
def test_only_where_the_spec_asks(codes_of, tables, codes):
    assert codes_of("lossy", CODED, tables) == codes


def test_it_asks_with_its_figures(found_by):
    (finding,) = found_by("lossy", CODED, ASKED)
    assert finding.message.startswith("on the frames of MP3 ")
    assert finding.message.endswith("was it MP3 before?")
    assert finding.unit == "%"
    assert finding.measured > 2 * finding.limit
