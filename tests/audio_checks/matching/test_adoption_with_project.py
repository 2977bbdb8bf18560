"""What a folder becomes where the game's project says how its files are played."""

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from audio_checks import AdoptionPlan, PlayedSound, Project, ShippedFile, plan_adoption, stems_of


def planned(engine: Any, sounds: list[PlayedSound], *paths: str) -> AdoptionPlan:
    files = [ShippedFile(path, f"{place:064x}") for place, path in enumerate(paths)]
    return plan_adoption(files, project=Project(engine, "", "", tuple(sounds)))


def wwise(file: str, place: str, **more: Any) -> PlayedSound:
    return PlayedSound(f"Originals/SFX/{file}", f"\\Containers\\Default Work Unit\\{place}", **more)


def test_a_random_container_is_a_set_in_the_order_of_its_numbers() -> None:
    held: dict[str, Any] = {"random_set": "\\Containers\\Default Work Unit\\Steps\\Grass", "events": ("Play_Step",)}
    sounds = [wwise(f"grass_{number}.wav", f"Steps\\Grass\\g{number}", **held) for number in (2, 4, 10)]
    plan = planned("wwise", [*sounds, wwise("click.wav", "UI\\click", is_looped=True)], "grass_10.wav", "grass_2.wav",
                   "grass_4.wav", "click.wav")  # fmt: skip
    assert [(cue.file_name, cue.category, cue.paths, cue.loop, cue.events) for cue in plan.cues] == [
        ("click", "ui", ("click.wav",), True, ()),
        ("grass", "steps", ("grass_2.wav", "grass_4.wav", "grass_10.wav"), False, ("Play_Step",)),
    ]
    assert [oddity.path for oddity in plan.oddities if oddity.code == "renamed"] == [
        "grass_10.wav",
        "grass_2.wav",
        "grass_4.wav",
    ]


def test_files_of_other_names_take_the_name_of_their_container() -> None:
    held: dict[str, Any] = {"random_set": "event:/World/Sneeze", "events": ("event:/World/Sneeze",)}
    sounds = [
        PlayedSound(f"Assets/{name}.wav", f"event:/World/Sneeze/{name}", **held) for name in ("hatschu", "a choo")
    ]
    other = PlayedSound("Assets/boom.wav", "event:/Weapons/Boom/boom", events=("event:/Weapons/Boom",))
    plan = planned("fmod", [*sounds, other], "hatschu.wav", "a choo.wav", "boom.wav")
    assert [(cue.file_name, cue.category, cue.paths) for cue in plan.cues] == [
        ("Sneeze", "world", ("a choo.wav", "hatschu.wav")),
        ("boom", "weapons", ("boom.wav",)),
    ]


def test_scenes_say_no_category_and_a_loop_counts_only_where_all_play_it_so() -> None:
    sounds = [
        PlayedSound("audio/ui/click.wav", "menu.tscn: Click", is_looped=True),
        PlayedSound("audio/ui/click.wav", "game.tscn: Click", is_looped=False),
        PlayedSound("audio/ambience/wind.wav", "game.tscn: Wind", is_looped=True),
    ]
    plan = planned("godot", sounds, "audio/ui/click.wav", "audio/ambience/wind.wav")
    assert [(cue.category, cue.loop) for cue in plan.cues] == [("ambience", True), ("ui", False)]


def test_what_nothing_plays_is_named_and_adopted() -> None:
    sounds = [
        wwise("silent.wav", "silent", is_used=False),
        wwise("played.wav", "played", events=("Play",)),
        wwise("scripted.wav", "scripted", is_used=None),
    ]
    plan = planned("wwise", sounds, "silent.wav", "played.wav", "scripted.wav", "left.wav")
    assert len(plan.cues) == 4
    assert [(oddity.path, oddity.message) for oddity in plan.oddities] == [
        ("left.wav", "no event plays it in the project"),
        ("silent.wav", "no event plays it in the project"),
    ]


PLACES = st.sampled_from(["", "event:/a", "\\X\\b", "a.wav", "con", "..", "steps_01", "///", "\x07:* ?"])


@pytest.mark.slow
@given(
    st.lists(st.tuples(st.sampled_from("abc"), st.integers(0, 3), PLACES), max_size=12),
    st.sampled_from(["wwise", "godot"]),
)
def test_no_tree_leads_to_a_file_twice_or_to_a_name_twice(found: list[tuple[str, int, str]], engine: str) -> None:
    paths = sorted({f"{name}_{number}.wav" for name, number, _ in found})
    sounds = [PlayedSound(f"{name}_{number}.wav", place, random_set=place) for name, number, place in found]
    plan = planned(engine, sounds, *paths)
    assert sorted(path for cue in plan.cues for path in cue.paths) == paths
    stems = [stem for cue in plan.cues for stem in stems_of(cue.name, cue.file_name, len(cue.paths))]
    assert len(stems) == len(set(stems))
