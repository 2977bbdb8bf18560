"""Channels of a master to channels of a target, at stated gains.

Stereo to mono is half of each side (−6.02 dB): what both sides hold alike keeps its level, nothing
can clip, and what they hold against each other cancels, as it would in any mono player.
Mono to stereo gives each side the whole (0 dB). Anything else has no gains that fit every game.
"""

from typing import Literal

import numpy as np
from numpy.typing import NDArray

from audio_checks.errors import RenderRefused

STEREO_TO_MONO = np.array([[0.5], [0.5]])
MONO_TO_STEREO = np.array([[1.0, 1.0]])


def mixing_gains(channels: int, wanted: Literal["master"] | int) -> NDArray[np.float64] | None:
    """Return the gains from master to target, shape (channels, channels of the target); None where nothing is mixed.

    Raises
    ------
    RenderRefused
        `render:channels`, for layouts without stated gains.
    """
    if wanted in ("master", channels):
        return None
    if (channels, wanted) == (2, 1):
        return STEREO_TO_MONO
    if (channels, wanted) == (1, 2):
        return MONO_TO_STEREO
    raise RenderRefused(
        f"the target asks for {wanted} channels and the master has {channels}: only mono and stereo are mixed",
        code="render:channels",
        fix='deliver a master with the channels of the target, or set the target\'s channels to "master"',
    )
