"""The kernel's shaped rounding against the same in plain Python."""

import math

import numpy as np
import pytest

from audio_checks.kernel import shaped_steps
from audio_checks.render.dither import SHAPE


def rounded(wanted, noise, silent, errors):
    result = []
    for value, extra, quiet in zip(wanted, noise, silent, strict=True):
        if quiet:
            errors[:] = [0.0] * len(SHAPE)
            result.append(0)
            continue
        aim = value - sum(weight * error for weight, error in zip(SHAPE, errors, strict=True))
        step = math.floor(aim + extra + 0.5)
        errors[:] = [step - aim, *errors[:-1]]
        result.append(step)
    return result


@pytest.mark.parametrize("channels", [1, 2, 3])
def test_every_step_is_the_same_and_errors_go_on_from_block_to_block(channels):
    rng = np.random.default_rng(3)
    errors, known = np.zeros((channels, len(SHAPE))), [[0.0] * len(SHAPE) for _ in range(channels)]
    for frames in (1, 700, 0, 1_300):
        wanted, noise = rng.normal(0, 200, (channels, frames)), rng.uniform(-1, 1, (channels, frames))
        silent = (rng.uniform(0, 1, (channels, frames)) < 0.05).astype(np.uint8)
        plain = [rounded(*one) for one in zip(wanted.tolist(), noise.tolist(), silent.tolist(), known, strict=True)]
        shaped_steps(wanted, noise, silent, np.array(SHAPE), errors)
        assert wanted.tolist() == plain
        assert errors.tolist() == known


@pytest.mark.parametrize(
    ("noise", "silent", "weights", "errors"),
    [
        ((1, 9), (1, 10), 5, (1, 5)),
        ((1, 10), (1, 9), 5, (1, 5)),
        ((1, 10), (1, 10), 4, (1, 5)),
        ((1, 10), (1, 10), 5, 4),
    ],
)
def test_what_does_not_fit_is_refused(noise, silent, weights, errors):
    with pytest.raises(ValueError, match="wanted"):
        shaped_steps(
            np.zeros((1, 10)), np.zeros(noise), np.zeros(silent, np.uint8), np.zeros(weights), np.zeros(errors)
        )
