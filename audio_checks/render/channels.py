"""Channels of a master to channels of a target, at stated gains.

Stereo to mono is half of each side (−6.02 dB) unless the target says otherwise: what both sides hold
alike keeps its level, nothing can clip, and what they hold against each other cancels, as it would in
any mono player.
Mono to stereo gives each side the whole (0 dB). Anything else has no gains that fit every game.
"""

from typing import Literal

import numpy as np
from numpy.typing import NDArray

from audio_checks.errors import RenderRefused
from audio_checks.spec.delivery_spec import Target

MONO_TO_STEREO = np.array([[1.0, 1.0]])


def mixing_gains(
    channels: int, wanted: Literal["master"] | int, mono_gains: tuple[float, float] = (0.5, 0.5)
) -> NDArray[np.float64] | None:
    """Return the gains from master to target, shape (channels, channels of the target); None where nothing is mixed.

    Raises
    ------
    RenderRefused
        `render:channels`, for layouts without stated gains.
    """
    if wanted in ("master", channels):
        return None
    if (channels, wanted) == (2, 1):
        return np.array([[mono_gains[0]], [mono_gains[1]]])
    if (channels, wanted) == (1, 2):
        return MONO_TO_STEREO
    raise RenderRefused(
        f"the target asks for {wanted} channels and the master has {channels}: only mono and stereo are mixed",
        code="render:channels",
        fix='deliver a master with the channels of the target, or set the target\'s channels to "master"',
    )


def ensure_codable(channels: int, target: Target) -> None:
    """Raise RenderRefused (`render:codec-channels`) for more channels than files of the target's encoding hold."""
    coding = target.coding
    if coding is not None and channels > coding.most_channels:
        raise RenderRefused(
            f"{coding.label} holds {coding.most_channels} channels here, and the file would have {channels}",
            code="render:codec-channels",
            fix='give the sound\'s category a target with encoding = "pcm" or "flac", or fewer channels',
        )


def mixed(block: NDArray[np.float64], gains: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return a block with its channels mixed, shape (frames, channels of the target).

    Products are added one after the other: a matrix product would round as the machine's library likes.
    """
    columns = []
    for channel in range(gains.shape[1]):
        column = block[:, 0] * gains[0, channel]
        for source_channel in range(1, len(gains)):
            column = column + block[:, source_channel] * gains[source_channel, channel]
        columns.append(column)
    return np.stack(columns, axis=1)
