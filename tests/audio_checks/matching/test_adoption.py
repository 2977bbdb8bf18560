"""What a folder of shipped files becomes, by its names alone."""

import random

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.sound_lists.rules import validation_errors
from app.sound_lists.save_edits import whole_facts
from audio_checks import AdoptionPlan, ShippedFile, folded_stem, plan_adoption, stems_of

PARTS = st.text(
    st.sampled_from("aAbB1209_-. =+'~é\u202e\u200b\x07<>:|?*üß東") | st.characters(exclude_categories=("Cs",)),
    max_size=12,
)
PATHS = st.lists(
    st.tuples(PARTS, PARTS, st.sampled_from([".wav", ".WAV", ".flac", ".ogg", "", ".txt", "_01.wav", "_02.wav"])),
    max_size=30,
).map(lambda found: sorted({f"{folder}/{name}{ending}" for folder, name, ending in found}))


def planned(*paths: str, **more: object) -> AdoptionPlan:
    files = [ShippedFile(path, f"{place:064x}") for place, path in enumerate(paths)]
    return plan_adoption(files, **more)  # type: ignore[arg-type]


def cues(plan: AdoptionPlan) -> dict[str, tuple[str, tuple[str, ...]]]:
    return {cue.file_name: (cue.category, cue.paths) for cue in plan.cues}


@pytest.mark.slow
@given(PATHS, st.randoms())
def test_every_file_is_in_one_cue_or_skipped_and_a_list_can_hold_the_cues(
    paths: list[str], shuffled: random.Random
) -> None:
    owned = {folded_stem("a_01"): "SW-001"}
    plan = planned(*paths, owned=owned)
    placed = [path for cue in plan.cues for path in cue.paths] + [one.path for one in plan.skipped]
    assert sorted(placed) == paths
    stems = [folded_stem(stem) for cue in plan.cues for stem in stems_of(cue.name, cue.file_name, len(cue.paths))]
    assert len({*stems, *owned}) == len(stems) + 1
    for cue in plan.cues:
        facts = whole_facts(
            {"name": cue.name, "file_name": cue.file_name, "category": cue.category, "variations": len(cue.paths)}
        )
        assert list(validation_errors(facts)) == []
        assert (facts["file_name"], facts["category"]) == (cue.file_name, cue.category)
    files = [ShippedFile(path, f"{place:064x}") for place, path in enumerate(paths)]
    shuffled.shuffle(files)
    assert plan_adoption(files, owned=owned) == plan


def test_names_stay_and_numbered_files_are_sets() -> None:
    plan = planned("Audio/UI/Click.wav", "Audio/Steps/grass_01.wav", "Audio/Steps/grass_02.wav")
    assert cues(plan) == {
        "Click": ("ui", ("Audio/UI/Click.wav",)),
        "grass": ("steps", ("Audio/Steps/grass_01.wav", "Audio/Steps/grass_02.wav")),
    }
    assert (plan.oddities, plan.skipped, plan.duplicates) == ((), (), ())


@pytest.mark.parametrize(
    "names",
    [
        ["grass_01", "grass_03"],  # a gap
        ["grass_00", "grass_01"],  # from 0
        ["grass_1", "grass_01", "grass_2"],  # a number twice
    ],
)
def test_numbers_that_do_not_count_from_one_make_no_set(names: list[str]) -> None:
    plan = planned(*(f"{name}.wav" for name in names))
    assert sorted(cues(plan)) == sorted(names)
    assert {oddity.code for oddity in plan.oddities} == {"numbering"}


def test_digits_that_are_part_of_a_name_make_no_set() -> None:
    assert sorted(cues(planned("bell1.wav", "bell2.wav", "theme_2.wav"))) == ["bell1", "bell2", "theme_2"]


def test_a_set_that_the_list_numbers_otherwise_is_named() -> None:
    plan = planned("hit_1.wav", "hit_2.wav")
    assert [(oddity.path, oddity.code, oddity.message) for oddity in plan.oddities] == [
        ("hit_1.wav", "renamed", "its name in the list is hit_01"),
        ("hit_2.wav", "renamed", "its name in the list is hit_02"),
    ]


def test_the_same_name_in_two_folders_gets_the_folder_before_it() -> None:
    plan = planned("menu/click.wav", "ui/Click.wav", "ui/sub/click.wav")
    assert sorted(cues(plan)) == ["click", "sub_click", "ui_Click"]
    assert [oddity.path for oddity in plan.oddities] == ["ui/Click.wav", "ui/sub/click.wav"]


def test_a_folder_named_like_a_category_of_the_spec_comes_first() -> None:
    plan = planned("Game/Assets/Music/theme.wav", "Game/Assets/UI/click.wav", categories=["music"])
    assert {name: category for name, (category, _) in cues(plan).items()} == {"theme": "music", "click": "ui"}


def test_without_folders_a_word_that_many_names_begin_with_is_the_category() -> None:
    plan = planned("amb_cave.wav", "amb_lake.wav", "amb_wind.wav", "boom_a.wav")
    assert [category for category, _ in cues(plan).values()] == ["amb", "amb", "amb", ""]


def test_files_that_are_no_masters_are_skipped_with_a_reason() -> None:
    plan = planned("a.m4a", "b.txt", "c__dry.wav", "---.wav", "listed.wav", owned={"listed": "SW-009"})
    assert [(one.path, one.code) for one in plan.skipped] == [
        ("---.wav", "name"), ("a.m4a", "coded"), ("b.txt", "no-sound"), ("c__dry.wav", "dry-stem"),
        ("listed.wav", "listed"),
    ]  # fmt: skip
    assert "SW-009" in plan.skipped[-1].message
    assert plan.cues == ()


def test_a_rare_rate_is_odd_and_the_same_bytes_are_named() -> None:
    files = [ShippedFile(f"{place}.wav", f"{ord(place):064x}", 44_100, 16) for place in "abcdefghijklmno"]
    files += [ShippedFile("odd.wav", f"{1:064x}", 22_050, 16), ShippedFile("twin.wav", f"{1:064x}", 44_100, 16)]
    plan = plan_adoption(files)
    assert [tuple(oddity) for oddity in plan.oddities] == [("odd.wav", "format", "22050 Hz, most files have 44100 Hz")]
    assert plan.duplicates == (("odd.wav", "twin.wav"),)
