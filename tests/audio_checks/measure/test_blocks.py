"""What every accumulator keeps to: blocks of any length give the same, and none keeps hold of a block."""

import math
from collections.abc import Iterable
from dataclasses import fields, is_dataclass, replace
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from audio_checks import wav
from audio_checks.audio.figures import FIGURES, Accumulator, _makers
from audio_checks.measure import faults
from audio_checks.measure.cells import cell_frames
from audio_checks.measure.faults import Faults
from audio_checks.measure.maxima import ROW_FRAMES
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


def accumulators_of(layout: wav.WavLayout, families: Iterable[str]) -> list[Accumulator]:
    return [make() for _, make in _makers(layout, families)]


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


def holds_arrays(value: Any) -> bool:
    return is_dataclass(value) or (isinstance(value, tuple) and any(map(is_dataclass, value)))


def ensure_same_arrays(mine: Any, other: Any) -> None:
    if isinstance(other, tuple):
        for one, two in zip(mine, other, strict=True):
            ensure_same_arrays(one, two)
        return
    for part in fields(other):
        one, two = getattr(mine, part.name), getattr(other, part.name)
        if isinstance(two, str):
            assert one == two, part.name
        else:
            np.testing.assert_allclose(one, two, rtol=1e-6, atol=1e-9)


@pytest.mark.parametrize("family", FIGURES)
def test_blocks_of_any_length_in_memory_that_is_used_again(layout: wav.WavLayout, family: str):
    whole = figures_of(layout, family, [len(SOUND)])
    for lengths in ([65_536], [997, 4_801, 31], [20_000, 1]):
        parts = figures_of(layout, family, lengths)
        assert parts.keys() == whole.keys()
        for name, value in whole.items():
            if isinstance(value, float) and math.isfinite(value):
                assert parts[name] == pytest.approx(value, abs=1e-6), name
            elif holds_arrays(value):
                ensure_same_arrays(parts[name], value)
            elif not hasattr(value, "ndim"):
                assert parts[name] == value, name


@pytest.mark.slow
@pytest.mark.parametrize("frames", [len(SOUND), 4_321, 131_072, 389])
def test_what_is_decoded_in_place_gives_the_same(layout: wav.WavLayout, frames: int, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(faults, "STRETCH_FRAMES", 1 << 17)
    monkeypatch.setattr(faults, "PIECE_SAMPLES", 1 << 15)
    sound = np.tile(SOUND, (3, 1))  # longer than what is looked at together
    sound[10_000:10_010] += 0.3
    raw = np.ascontiguousarray(sound.astype("<f4")).tobytes()
    families = [family for family in FIGURES if family != "seam"]
    longer = replace(layout, frames=len(sound), encoding="float", container_bits=32, bit_depth=32)
    copied, decoded = accumulators_of(longer, families), accumulators_of(longer, families)
    decoder = next(one for one in decoded if isinstance(one, Faults))
    at = 0
    while at < len(sound):
        count = min(frames, decoder.room(), len(sound) - at)
        ends = [*range(at, at + count, decoder.piece_frames()), at + count]
        pieces = (raw[one * 8 : other * 8] for one, other in pairwise(ends))
        block, _, broken = decoder.decode(pieces, count, 32, floats=True)
        assert not broken
        np.testing.assert_array_equal(block, sound[at : at + count].astype("<f4"))
        own = block.T.copy().T
        for accumulator in decoded:
            accumulator.add(block)
        for accumulator in copied:
            accumulator.add(own)
        at += count
    for one, other in zip(decoded, copied, strict=True):
        mine, plain = one.result(), other.result()
        for name, value in plain.items():
            if isinstance(value, float):
                assert mine[name] == pytest.approx(value, abs=1e-9), name  # sums add up in another order
            elif holds_arrays(value):
                ensure_same_arrays(mine[name], value)
            elif not callable(value):
                assert mine[name] == value, name


@pytest.mark.slow
def test_pieces_are_whole_rows_and_cells_and_never_more_than_is_looked_at_together(layout: wav.WavLayout):
    for rate in (8_000, 44_100, 62_000, 758_000):
        for channels in (1, 2, 8, 64):
            wide = replace(layout, frames=1 << 22, sample_rate_hz=rate, channels=channels)
            (decoder,) = accumulators_of(wide, ["clicks"])
            assert isinstance(decoder, Faults)
            count, cell = decoder.piece_frames(), cell_frames(rate)
            assert count % cell == count % ROW_FRAMES == 0
            assert 0 < count <= decoder.room()


def test_a_short_sound_has_room_for_all_of_it_at_once(layout: wav.WavLayout):
    for frames in (4_000, 47_999, 48_001, 65_001):
        (faults,) = accumulators_of(replace(layout, frames=frames), ["clicks"])
        assert faults.room() >= frames
