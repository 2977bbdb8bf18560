"""The response between a dry sound and a delivered one: what was put between them is found again."""

import numpy as np
import pytest

from audio_checks.measure.response import response_between
from tests.support.rooms import hits, in_a_room
from tests.support.waves import join, noise, silence

RATE = 48_000


@pytest.mark.parametrize("rt60_s", [0.5, 1.5, 3.0])
@pytest.mark.parametrize("wet_db", [0.0, -12.0, -24.0])
def test_reverb_comes_back_with_its_time_and_its_level(rt60_s, wet_db):
    dry = hits()
    found = response_between(dry, in_a_room(dry, rt60_s=rt60_s, wet_db=wet_db), RATE)
    assert found.rt60_s == pytest.approx(rt60_s, rel=0.15)
    assert found.wet_db == pytest.approx(wet_db, abs=1)
    assert found.before_db < wet_db - 15
    assert list(found.curve_db) == sorted(found.curve_db, reverse=True)


@pytest.mark.slow
@pytest.mark.parametrize("delivered", [hits() * 0.5, join(silence(seconds=0.1), hits())], ids=["quieter", "later"])
def test_nothing_was_added(delivered):
    found = response_between(hits(), delivered, RATE)
    assert found.wet_db == -np.inf or found.wet_db < -80
    assert found.delay_s == pytest.approx((len(delivered) - len(hits())) / RATE)


def test_another_sound_has_as_much_before_as_behind():
    other = noise(seconds=2.0) * np.exp(-np.arange(96_000) / 20_000)[:, np.newaxis]
    assert response_between(hits(), other, RATE).before_db > 0


@pytest.mark.parametrize(("dry", "delivered"), [(silence(), hits()), (hits(), silence()), (silence(seconds=0), hits())])
def test_silence_has_no_response(dry, delivered):
    assert response_between(dry, delivered, RATE) is None
