"""Channels at stated gains, and refusals where there are none."""

import numpy as np
import pytest

from audio_checks.errors import RenderRefused
from audio_checks.render.channels import mixing_gains


def test_stereo_to_mono_is_the_mean_of_both_sides():
    assert (np.array([[0.5, 0.25], [1.0, -1.0], [1.0, 1.0]]) @ mixing_gains(2, 1)).tolist() == [[0.375], [0.0], [1.0]]


def test_mono_to_stereo_keeps_the_level_on_each_side():
    assert (np.array([[0.5]]) @ mixing_gains(1, 2)).tolist() == [[0.5, 0.5]]


@pytest.mark.parametrize(("channels", "wanted"), [(1, "master"), (6, "master"), (1, 1), (2, 2)])
def test_nothing_to_mix(channels, wanted):
    assert mixing_gains(channels, wanted) is None


@pytest.mark.parametrize(("channels", "wanted"), [(6, 2), (4, 1), (3, 2)])
def test_no_gains_fit_every_game(channels, wanted):
    with pytest.raises(RenderRefused) as refused:
        mixing_gains(channels, wanted)
    assert refused.value.code == "render:channels"
