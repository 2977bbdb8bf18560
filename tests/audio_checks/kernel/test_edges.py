"""Records from the head and from the tail, held to a plain search."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from audio_checks import kernel
from tests.audio_checks.kernel.signals import Samples, signals

CEILING, GRAIN = 0.016, 1 + 1e-4


def records(samples: Samples, loudest: float, *, backward: bool) -> list[tuple[float, int]]:
    levels, places = np.empty(len(samples)), np.empty(len(samples), np.int64)
    count = kernel.records(kernel.by_channel(samples), loudest, CEILING, GRAIN, backward, levels, places)
    return list(zip(levels[:count].tolist(), places[:count].tolist(), strict=True))


@pytest.mark.slow
@given(signals(), st.booleans(), st.sampled_from([0.0, 1e-6, 0.01, 0.016, 1.0]))
def test_the_first_frame_to_reach_a_level_is_among_them(samples: Samples, backward: bool, loudest: float):
    sizes = np.minimum(np.abs(samples).max(axis=1, initial=0), CEILING)
    frames = np.arange(len(samples))
    if backward:
        sizes, frames = sizes[::-1], frames[::-1]
    found = records(samples, loudest, backward=backward)
    louder = sizes[sizes > loudest]
    assert bool(found) == bool(len(louder) and loudest < CEILING)
    assert [level for level, _ in found] == sorted({level for level, _ in found})
    if found:
        assert found[-1][0] == louder.max()
    for level in np.concatenate((louder, louder * 0.9999)):
        if level <= loudest or not found:
            continue
        place = next(place for kept, place in found if kept >= level)
        reached = frames[int(np.argmax(sizes >= level))]
        later = frames[int(np.argmax(sizes >= min(level * GRAIN, louder.max())))]
        assert place in (range(reached, later + 1) if not backward else range(later, reached + 1))


def test_few_records_are_kept_of_a_long_rise():
    rise = np.geomspace(1e-6, 0.015, 100_000)[:, np.newaxis]
    assert 2_000 < len(records(rise, 0.0, backward=False)) < 2 * np.log(15_000) / 1e-4
    assert records(rise[::-1].copy(), 0.0, backward=True)[-1] == (0.015, 0)


def test_the_search_ends_where_it_is_loud():
    sound = np.full((1_000, 1), 0.5)
    assert records(sound, 0.0, backward=False) == [(CEILING, 0)]
    assert records(sound, 0.0, backward=True) == [(CEILING, 999)]


def test_room_for_every_frame_is_wanted():
    with pytest.raises(ValueError, match="wanted"):
        kernel.records(np.zeros((1, 5)), 0.0, CEILING, GRAIN, False, np.empty(4), np.empty(5, np.int64))
