"""What every accumulator keeps to: blocks of any length give the same, and none keeps hold of a block."""

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from audio_checks import wav
from audio_checks.audio import FIGURES, accumulators_of
from tests.support.waves import join, noise, silence, sine, write_wav

SOUND = join(
    silence(seconds=0.1, channels=2),
    noise(seconds=1.2, channels=2, dbfs=-15),
    sine(hz=3_000, seconds=0.7, channels=2, dbfs=-3),
    silence(seconds=0.3, channels=2),
    noise(seconds=0.6, channels=2, dbfs=-40, seed=4),
)


@pytest.fixture(scope="module")
def layout(tmp_path_factory: pytest.TempPathFactory) -> wav.WavLayout:
    with wav.open_regular(write_wav(tmp_path_factory.mktemp("sound") / "sound.wav", SOUND)) as file:
        return wav.read_layout(file)


def figures_of(layout: wav.WavLayout, family: str, lengths: list[int]) -> dict[str, Any]:
    """The figures of one family, its blocks all in the same memory, which is spoilt after each."""
    (accumulator,) = accumulators_of(layout, [family])
    at, turn = 0, 0
    memory = np.empty((layout.channels, max(lengths)))
    while at < len(SOUND):
        count = min(lengths[turn % len(lengths)], len(SOUND) - at)
        block: NDArray[np.float64] = memory[:, :count].T
        block[:] = SOUND[at : at + count]
        accumulator.add(block)
        memory.fill(np.nan)
        at, turn = at + count, turn + 1
    return {name: value for name, value in accumulator.result().items() if not callable(value)}


@pytest.mark.parametrize("family", FIGURES)
def test_blocks_of_any_length_in_memory_that_is_used_again(layout: wav.WavLayout, family: str):
    whole = figures_of(layout, family, [len(SOUND)])
    for lengths in ([65_536], [997, 4_801, 31], [20_000, 1]):
        parts = figures_of(layout, family, lengths)
        assert parts.keys() == whole.keys()
        for name, value in whole.items():
            if isinstance(value, float) and math.isfinite(value):
                assert parts[name] == pytest.approx(value, abs=1e-6), name
            elif not hasattr(value, "ndim"):
                assert parts[name] == value, name


def test_room_that_faults_lend_saves_a_copy_and_changes_nothing(layout: wav.WavLayout):
    (copying,), (lending,) = (
        accumulators_of(layout, ["clicks", "repeats"]),
        accumulators_of(layout, ["clicks", "repeats"]),
    )
    copying.add(SOUND)
    at = 0
    while at < len(SOUND):
        room = lending.lend(len(SOUND) - at, 30_000)
        assert 0 < len(room) <= 30_000
        room[:] = SOUND[at : at + len(room)]
        at += len(room)
        lending.add(room)
    assert lending.result() == copying.result()


def test_a_short_sound_is_lent_room_for_all_of_it_at_once(layout: wav.WavLayout):
    # A stretch is whole cells, so it is a little longer than the sound: what is left of it must not be halved for ever.
    for frames in (4_000, 47_999, 48_001, 65_001):
        (lending,) = accumulators_of(replace(layout, frames=frames), ["clicks"])
        assert len(lending.lend(frames, 65_536)) == frames
