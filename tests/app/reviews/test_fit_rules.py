"""How far a sound stands from others, by hand-made figures."""

from statistics import median

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.reviews.palette_fit.rules import (
    Likeness,
    Measure,
    Stands,
    distance_db,
    fit_of,
    in_words,
    middle_of,
    shift,
    timbre_distance_db,
)


def at(loudness_lufs: float | None, reverb_score: float | None = None) -> Likeness:
    return Likeness(loudness_lufs, reverb_score)


OTHERS = [at(-20.0, 0.1), at(-18.0, 0.2), at(-17.0, 0.0)]


@pytest.mark.parametrize(
    ("loudness_lufs", "stands"),
    [(-15.0, Stands.WITHIN), (-14.9, Stands.ABOVE), (-22.0, Stands.WITHIN), (-22.1, Stands.BELOW)],
)
def test_two_lu_beyond_the_others_are_still_among_them(loudness_lufs: float, stands: Stands) -> None:
    fit = fit_of(at(loudness_lufs), OTHERS)[Measure.LOUDNESS]
    assert (fit.stands, fit.middle, fit.lowest, fit.highest) == (stands, -18.0, -20.0, -17.0)


def test_dryness_is_compared_by_the_score_of_reverb() -> None:
    fits = fit_of(at(-18.0, 0.36), OTHERS)
    assert fits[Measure.DRYNESS].stands is Stands.ABOVE
    assert in_words(fits) == "Stands apart: more reverberant than all of them."
    assert in_words(fit_of(at(-13.5, 0.3), OTHERS)) == "Stands apart: louder than all of them, by 3.5 LU."
    assert in_words(fit_of(at(-19.0, 0.1), OTHERS)) == "Within their range in everything measured."


def test_two_others_have_no_middle_and_what_is_not_measured_is_not_compared() -> None:
    assert fit_of(at(-18.0), OTHERS[:2]) == {}
    assert list(fit_of(at(None, 0.1), OTHERS)) == [Measure.DRYNESS]
    fit = fit_of(at(-18.0), [*OTHERS, at(None)])[Measure.LOUDNESS]
    assert fit.others == [-20.0, -18.0, -17.0, None]


def test_spectra_are_compared_by_their_distance_from_the_middle_of_the_rest() -> None:
    others = [Likeness(bands_db=[0.0, level, -40.0]) for level in (-10.0, -12.0, -14.0)]
    near = fit_of(Likeness(bands_db=[0.0, -12.0, -40.0]), others)[Measure.SPECTRUM]
    assert near.value == 0.0
    # The middle of the other two is 3 dB off in one of three bands for the outer ones; -12 lies in their middle.
    assert near.others == pytest.approx([3 / 3**0.5, 0.0, 3 / 3**0.5])
    assert near.stands is Stands.WITHIN
    far = fit_of(Likeness(bands_db=[-20.0, 0.0, -20.0]), others)[Measure.SPECTRUM]
    assert far.value == pytest.approx(((20**2 + 12**2 + 20**2) / 3) ** 0.5)
    assert far.stands is Stands.ABOVE


def test_timbres_are_compared_alike() -> None:
    others = [Likeness(timbre=[place, 0.0]) for place in (0.0, 1.0, 2.0)]
    assert fit_of(Likeness(timbre=[1.0, 2.0]), others)[Measure.TIMBRE].stands is Stands.WITHIN  # 2 dB; theirs 1.5
    assert fit_of(Likeness(timbre=[1.0, 2.6]), others)[Measure.TIMBRE].stands is Stands.ABOVE


@pytest.mark.slow
@given(st.lists(st.lists(st.integers(-9, 0), min_size=2, max_size=2), min_size=3, max_size=9))
def test_each_other_has_its_distance_from_the_middle_of_all_but_itself(spectra: list[list[int]]) -> None:
    others = [Likeness(bands_db=bands) for bands in spectra]
    found = fit_of(Likeness(bands_db=[0.0, 0.0]), others)[Measure.SPECTRUM].others
    wanted = []
    for place, bands in enumerate(spectra):
        rest = [one for at, one in enumerate(spectra) if at != place]
        wanted.append(distance_db(bands, [median(values) for values in zip(*rest, strict=True)]))
    assert found == pytest.approx(wanted)


def test_distances() -> None:
    assert distance_db([0.0, -6.0], [0.0, 0.0, -99.0]) == pytest.approx(6 / 2**0.5)  # of the bands that both have
    assert timbre_distance_db([3.0, 0.0], [0.0, 4.0]) == 5.0


def test_the_variations_of_a_cue_count_as_the_one_in_their_middle() -> None:
    variations = [Likeness(-20.0, 0.1, [0.0, -9.0], [1.0]), Likeness(-18.0, None, [0.0, -3.0], None), Likeness(-17.0)]
    assert middle_of(variations) == Likeness(-18.0, 0.1, [0.0, -6.0], [1.0])
    assert middle_of([Likeness()]) == Likeness()


def test_a_delivery_is_off_by_what_its_middle_sound_is() -> None:
    placed = [(-14.0, -18.0, Stands.ABOVE), (-17.0, -18.0, Stands.WITHIN), (-12.0, -18.0, Stands.ABOVE)]
    assert shift(placed) == (2, 4.0)
