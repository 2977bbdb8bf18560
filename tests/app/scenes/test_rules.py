"""Neighbours, times and words of a scene, stated without a database."""

import math
from typing import Any
from uuid import UUID

import pytest

from app.scenes.rules import (
    MOST_NEIGHBOURS,
    SCENE_COLUMNS,
    Candidate,
    CoveredBand,
    column_value,
    likeliest_neighbours,
    masking_words,
    missing_words,
    part_bounds,
    part_name,
    scene_length_s,
    spots_in,
)


def candidate(number: int, **facts: Any) -> Candidate:
    known: dict[str, Any] = {
        "scene": "", "category": "", "loops": False, "variations": 1, "level_lufs": -20.0, "position": number,
    } | facts  # fmt: skip
    return Candidate(UUID(int=number), **known)


def chosen(of: Candidate, *others: Candidate) -> list[int]:
    return [likeliest_neighbour.cue_id.int for likeliest_neighbour in likeliest_neighbours(of, others)]


def test_its_scene_comes_before_its_category_and_that_before_the_rest():
    of = candidate(1, scene="Boarding", category="weapons")
    same_category = candidate(2, category="weapons")
    same_scene = candidate(9, scene="Boarding", category="ships")
    another = candidate(3, category="music")
    assert chosen(of, another, same_category, same_scene) == [9, 2, 3]


def test_a_scene_that_is_empty_is_no_scene():
    assert chosen(candidate(1), candidate(5, scene=""), candidate(2, category="other")) == [5, 2]


def test_loops_come_first_the_louder_one_before_the_softer():
    shot, soft, loud = candidate(2), candidate(3, loops=True, level_lufs=-40.0), candidate(4, loops=True)
    assert chosen(candidate(1), shot, soft, loud) == [4, 3, 2]


def test_of_single_sounds_those_with_more_variations_come_first():
    once, often = candidate(2, level_lufs=-10.0), candidate(9, variations=6, level_lufs=-30.0)
    assert chosen(candidate(1), once, often) == [9, 2]


def test_what_is_left_goes_by_level_and_then_by_place():
    far, near, loud, unmeasured = (
        candidate(20),
        candidate(12),
        candidate(30, level_lufs=-6.0),
        candidate(11, level_lufs=None),
    )
    assert chosen(candidate(10), unmeasured, far, near, loud) == [30, 12, 20, 11]


def test_there_are_eight_at_most_and_never_the_sound_itself():
    of = candidate(1)
    found = chosen(of, of, *(candidate(number) for number in range(2, 20)))
    assert len(found) == MOST_NEIGHBOURS
    assert 1 not in found


@pytest.mark.parametrize(
    ("text", "seconds"),
    [
        ("", []),
        ("1.5", [1.5]),
        ("1.5, 3.05; 4.7", [1.5, 3.05, 4.7]),
        ("0:01.5 1:02", [1.5, 62.0]),
        ("4.7 1.5 1.5", [1.5, 4.7]),
        ("at 3 seconds", [3.0]),
        ("soon", []),
        ("-1", []),
        ("1e9", []),
        ("\0", []),
        (" ".join(str(number) for number in range(99)), [float(number) for number in range(32)]),
    ],
)
def test_times_in_a_cell(text: str, seconds: list[float]):
    assert spots_in(text) == seconds


def test_a_column_is_found_whatever_its_case():
    assert column_value({"Priority": 3, "SCENE": " Boarding "}, SCENE_COLUMNS) == "Boarding"
    assert column_value({"Scene": None}, SCENE_COLUMNS) == ""
    assert column_value({}, SCENE_COLUMNS) == ""


@pytest.mark.parametrize(
    ("duration_s", "spots", "clip_s", "length_s"),
    [
        (0.6, [0.5], None, 8.0),
        (9.0, [0.5], None, 10.5),
        (120.0, [0.5], None, 30.0),
        (0.6, [0.5], 5.5, 5.5),
        (0.6, [0.5], 300.0, 30.0),
        (0.6, [0.5], 0.01, 1.0),
    ],
)
def test_how_long_a_scene_is(duration_s: float, spots: list[float], clip_s: float | None, length_s: float):
    assert scene_length_s(duration_s=duration_s, spots=spots, clip_s=clip_s) == length_s


@pytest.mark.parametrize(("start_s", "end_s"), [(None, None), (1.5, 9.0), (0.0, 0.25), (86_399.5, None), (1e-05, 1.0)])
def test_a_part_says_where_it_begins_and_ends(start_s: float | None, end_s: float | None):
    start, end = part_bounds(part_name(start_s, end_s))
    assert start == pytest.approx(start_s or 0.0, abs=0.001)
    assert end == (math.inf if end_s is None else end_s)


def band(hz: float, margin_db: float, covered_by: str = "", *, is_part: bool = True) -> CoveredBand:
    return CoveredBand(hz, is_part, is_part and margin_db >= 0, margin_db, covered_by)


def test_words_say_where_it_is_clearest_and_what_covers_where():
    bands = [
        band(55, -9, "engine"),
        band(150, -3, "engine"),
        band(300, 4, "engine"),
        band(1_000, -1, "laser"),
        band(1_200, -2, "laser"),
        band(2_200, 11, "laser"),
        band(9_000, -1, "engine"),
        band(12_000, -9, "engine", is_part=False),
    ]
    assert masking_words(bands) == (
        "Heard in 2 of 7 bands. Clearest at 2.2 kHz, +11 dB. "
        "Covered by engine: 60 Hz–150 Hz, 9.0 kHz. Covered by laser: 1.0 kHz–1.2 kHz."
    )


@pytest.mark.parametrize(
    ("bands", "words"),
    [
        ([], "The sound is silent."),
        ([band(100, -math.inf, is_part=False)], "The sound is silent."),
        ([band(100, math.inf), band(200, math.inf)], "Heard in 2 of 2 bands. Nothing covers it."),
        ([band(100, math.inf)], "Heard in 1 of 1 band. Nothing covers it."),
        ([band(100, -1, "engine")], "Covered in all bands. Covered by engine: 100 Hz."),
    ],
)
def test_words_at_the_ends(bands: list[CoveredBand], words: str):
    assert masking_words(bands) == words


@pytest.mark.parametrize(
    ("neighbours", "bed", "any_on", "words"),
    [
        (False, False, False, "no bed and no neighbours"),
        (True, True, False, "are off"),
        (True, False, True, "no bed:"),
        (False, True, True, "no neighbours:"),
        (True, True, True, ""),
    ],
)
def test_what_a_scene_lacks_is_named(*, neighbours: bool, bed: bool, any_on: bool, words: str):
    assert words in missing_words(neighbours=neighbours, bed=bed, any_on=any_on)
    assert bool(missing_words(neighbours=neighbours, bed=bed, any_on=any_on)) == bool(words)
