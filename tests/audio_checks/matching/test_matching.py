"""Which cue a messy name is for, and when that is sure."""

import random

import pytest

from audio_checks import ListedCue, NameIndex, variation_in
from tests.audio_checks.matching import messy
from tests.support.steps import at_most

CUES = [
    ListedCue("bell", "Bell", "perc_bell", label="SW-001"),
    ListedCue("bell2", "Second bell", "perc_bell2", label="SW-002"),
    ListedCue("twang", "Twang", "elec_twang", label="SW-003"),
    ListedCue("snare", "Snare", "elec_hi_snare", label="SW-004"),
    ListedCue("glitch1", "Glitch 1", "glitch_perc1", label="SW-005"),
    ListedCue("glitch2", "Glitch 2", "glitch_perc2", label="SW-006"),
    ListedCue("steps", "Steps on grass", "step_grass", variations=4, label="SW-007"),
    ListedCue("click", "Click", "ui_click", category="ui", label="SW-008"),
    ListedCue("fire", "Laser fire", "laser_fire.wav", category="weapon", label="SW-009"),
    ListedCue("door", "Tür auf", "", label="SW-010"),
    ListedCue("level", "Level up", "level_up", label="SW-011"),
    ListedCue("level2", "Level up again", "level_up_2", label="SW-012"),
]
INDEX = NameIndex(CUES, ["Star Whale", "SW"])


@pytest.mark.parametrize(
    ("name", "cue", "variation"),
    [
        ("elec twang.wav", "twang", 1),
        ("ELEC-TWANG.WAV", "twang", 1),
        ("ElecTwang", "twang", 1),
        ("elec.twang.wav.wav", "twang", 1),
        ("PERC_BELL.wav", "bell", 1),
        ("perc-bell2.wav", "bell2", 1),
        ("PercBell2_FINAL.wav", "bell2", 1),
        ("perc_bell_FINAL2.wav", "bell", 1),
        ("perc bell copy 2.wav", "bell", 1),
        ("perc_bell2_v2.wav", "bell2", 1),
        ("glitch_perc1_final_FINAL2.wav", "glitch1", 1),
        ("Glitch-Perc-02 (1).aif", "glitch2", 1),
        ("step_grass_3.wav", "steps", 3),
        ("StepGrass3FINAL2.wav", "steps", 3),
        ("step grass 004_v03 (2).wav", "steps", 4),
        ("step_grass/02.wav", "steps", 2),
        ("STEPS ON GRASS 1.wav", "steps", 1),
        ("UI/click.wav", "click", 1),
        ("C:\\Users\\me\\UI\\Click v2.wav", "click", 1),
        ("2026-11-23_laser_fire.wav", "fire", 1),
        ("231126 Laser Fire.wav", "fire", 1),
        ("laser_fire_20261123-1430.wav", "fire", 1),
        ("laser_fire_48kHz_24bit.wav", "fire", 1),
        ("laser_fire-6dB.wav", "fire", 1),
        ("weapon_laser_fire.wav", "fire", 1),
        ("SW_laser_fire.wav", "fire", 1),
        ("StarWhale_laser_fire.wav", "fire", 1),
        ("jd_laser_fire_v2.wav", "fire", 1),
        ("Jane Doe - laser fire.wav", "fire", 1),
        ("GUNAuto_Laser Fire_JDOE_SRC.wav", "fire", 1),
        ("laser_fire_altB.wav", "fire", 1),
        ("SW-009.wav", "fire", 1),
        ("SW-009 laser fire NEW.wav", "fire", 1),
        ("Tur_auf.wav", "door", 1),
        ("tu\u0308r auf.wav", "door", 1),
    ],
)
def test_sure(name: str, cue: str, variation: int) -> None:
    found = INDEX.sure(name, ["Jane Doe"])
    assert found is not None
    assert (found.cue, found.variation) == (cue, variation)


@pytest.mark.parametrize(
    "name",
    [
        "perc bell 2.wav",  # the second bell, or a bell's second file
        "perc_bell_02.wav",
        "perc_bell_FINAL_2.wav",
        "perc_bell (2).wav",
        "level_up (2).wav",  # a second download of the first
        "glitch_perc3.wav",  # no cue
        "glitch_perc.wav",
        "step_grass.wav",  # which of four?
        "step_grass_v2.wav",
        "step_grass_5.wav",
        "step_grass (3).wav",
        "step_grass_2_3.wav",
        "hi_snare.wav",
        "elec_snare.wav",
        "click.wav.txt",
        "big_laser_fire.wav",
        "laser_fire_left.wav",
        "laser_fire_02.wav",
        "laser_fire_new.wav",  # may be another sound
        "laser_fire_elec_twang.wav",
        "fire_laser.wav",
        "lazer_fire.wav",
        "perc_bell/elec_twang.wav",  # the folder is another cue
        "SW-003 laser fire.wav",  # the number is another cue's
        "NPC_laser_fire.wav",
        "",
        "...",
        "01.wav",
        "FINAL.wav",
    ],
)
def test_in_doubt_nothing_is_sure(name: str) -> None:
    assert INDEX.sure(name, ["Jane Doe"]) is None


def test_a_guess_says_why() -> None:
    first, second = INDEX.guesses("perc bell 2.wav")[:2]
    assert (first.cue, second.cue) == ("bell2", "bell")
    assert first.why == 'the name fits, and the number may be one of "Bell"'
    assert second.why == 'it has the name, and "2" in addition'
    assert INDEX.guesses("step_grass_v2.wav")[0] == ("steps", None, "the name does not say which variation")
    assert INDEX.guesses("lazer_fire.wav")[0].cue == "fire"
    assert INDEX.guesses("hi_snare.wav")[0].cue == "snare"
    assert INDEX.guesses("zzz.wav") == []
    assert len(INDEX.guesses("perc elec laser glitch.wav")) == 3


def test_the_alternate_is_read() -> None:
    for name, alternate in (
        ("laser_fire_altB", 2),
        ("Laser Fire ALT-3", 3),
        ("laser_fire__alt2", 2),
        ("laser_fire", None),
    ):
        found = INDEX.sure(name)
        assert found is not None
        assert found.alternate == alternate


def test_a_folder_that_may_be_meant_or_not_leaves_a_guess() -> None:
    index = NameIndex([ListedCue("ui", "UI click", "ui_click"), ListedCue("any", "Click", "click")])
    assert index.sure("UI/click.wav") is None
    assert {guess.cue for guess in index.guesses("UI/click.wav")} == {"ui", "any"}
    assert index.sure("click.wav") is not None


def test_a_set_and_a_single_file_of_like_names() -> None:
    index = NameIndex([ListedCue("set", "Robot", "robot", variations=4), ListedCue("two", "Robot 2", "robot2")])
    found = {name: index.sure(name) for name in ("robot_02.wav", "robot2.wav", "robot_2.wav", "robot_03.wav")}
    assert [found[name] and found[name].cue for name in found] == ["set", "two", None, "set"]  # type: ignore[union-attr]


def test_a_prefix_counts_once_many_files_share_it() -> None:
    paths = [
        f"Nordlicht_{name}.wav" for name in ("elec_twang", "perc_bell", "perc_bell2", "glitch_perc1", "laser_fire")
    ]
    assert INDEX.shared_prefixes(paths[:4]) == frozenset()
    prefixes = INDEX.shared_prefixes(paths)
    assert prefixes == {"nordlicht"}
    assert INDEX.sure(paths[0]) is None
    assert INDEX.sure(paths[0], prefixes=prefixes) == ("twang", 1, None)
    assert INDEX.shared_prefixes(path.replace("Nordlicht", "heavy") for path in paths) == frozenset()


@pytest.mark.parametrize("list_name", ["sonic_pi", "hypersomnia", "redeclipse", "megaglest", "openclonk"])
def test_no_sure_match_of_real_lists_is_wrong(list_name: str) -> None:
    right = on_list = 0
    for seed in (11, 12):
        cues, names = messy.make(messy.names_of(list_name), seed, each=1)
        listed = [ListedCue(cue.stem, cue.stem, cue.stem, variations=cue.variations) for cue in cues]
        index = NameIndex(listed, [messy.PROJECT, messy.PREFIX, messy.STUDIO])
        for name in names:
            found = index.sure(name.path, [messy.DESIGNER])
            on_list += name.cue is not None
            if found is not None:
                assert (found.cue, found.variation) == (name.cue, name.variation), name.path
                right += 1
    assert right >= 0.8 * on_list


@pytest.mark.slow
def test_reading_10_000_cues_grows_with_their_number_and_a_name_does_not() -> None:
    dice = random.Random(1)
    words = [word for name in messy.names_of("hypersomnia") for word in name.split("_") if len(word) > 2]
    listed = [ListedCue(place, f"{'_'.join(dice.sample(words, 3))}_{place % 9}") for place in range(10_000)]
    with at_most(1_000 * len(listed)):  # 504 lines a cue, of 1,000 cues and of 10,000
        index = NameIndex(listed)
    with at_most(5_000 * 200):  # 2,300 lines a name, which is less than one for each cue
        for cue in listed[:100]:
            index.sure(f"weapons/{cue.name.upper()}_FINAL2 (1).wav")
            index.guesses(f"weapons/{cue.name}x_v2.wav")


FORMAT_SUFFIXES = [
    "48k24",
    "44k16",
    "96k_24b",
    "44.1k16",
    "441k16",
    "44_1k",
    "44.1_16",
    "48_24",
    "48-24",
    "4824",
    "4416",
    "24-96",
    "48000",
    "48000_24",
    "44100Hz-16bit",
    "24bit_48k",
    "24b48k",
    "48k_24bit_stereo",
    "48K-24B-ST",
    "32f",
    "32bit_float",
    "48k32float",
    "pcm24",
    "PCM_S24LE",
    "5.1",
    "7.1.4",
    "48khz",
    "24bit",
    "24-bit",
    "mono",
    "Stereo",
    "48k24_mono",
]


@pytest.mark.parametrize("suffix", FORMAT_SUFFIXES)
def test_a_format_behind_a_name_says_nothing_about_the_sound(suffix: str) -> None:
    assert INDEX.sure(f"laser_fire_{suffix}.wav") == ("fire", 1, None)
    assert INDEX.sure(f"step_grass_03_{suffix}.wav") == ("steps", 3, None)
    assert INDEX.sure(f"step_grass_{suffix}_03.wav") == ("steps", 3, None)


@pytest.mark.parametrize(
    "name", ["laser_fire_24", "laser_fire_float", "laser_fire_4823", "laser_fire_st", "laser_fire_1_2"]
)
def test_what_only_resembles_a_format_leaves_doubt(name: str) -> None:
    assert INDEX.sure(f"{name}.wav") is None


def test_a_number_that_another_cue_has_is_no_format() -> None:
    index = NameIndex([ListedCue("gun", "Gun", "gun"), ListedCue("rifle", "Rifle", "gun_48000")])
    assert index.sure("gun_48000.wav") == ("rifle", 1, None)
    assert index.sure("weapons/gun_48k24.wav") == ("gun", 1, None)
    longer = NameIndex([ListedCue("gun", "Gun", "gun"), ListedCue("long", "Long", "gun_48")])
    assert longer.sure("gun_48_24.wav") is None
    assert longer.sure("gun_48k.wav") is None


SETS = NameIndex(
    [
        ListedCue("grass", "Footstep grass", "footstep_grass", category="footsteps", variations=6),
        ListedCue("concrete", "Footstep concrete", "footstep_concrete", category="footsteps", variations=6),
        ListedCue("open", "Door wood open", "door_wood_open", variations=4),
        ListedCue("close", "Door wood close", "door_wood_close"),
        ListedCue("metal", "Impacts metal heavy", "impacts_metal_heavy", variations=3),
        ListedCue("fly", "Flies buzz", "flies_buzz", variations=2),
    ]
)


@pytest.mark.parametrize(
    ("path", "cue", "variation"),
    [
        ("Footsteps/grass/01.wav", "grass", 1),
        ("Footsteps/grass/06.wav", "grass", 6),
        ("Grass/3.wav", "grass", 3),
        ("footsteps_grass/take 2.wav", "grass", None),
        ("footsteps_grass_04.wav", "grass", 4),
        ("Foley/Footsteps/Concrete/02_48k24.wav", "concrete", 2),
        ("Doors/Wood/Open/1.wav", "open", 1),
        ("doors/wood/close.wav", "close", 1),
        ("impact/heavy metal/2.wav", "metal", 2),
        ("fly buzzes/2.wav", "fly", 2),
    ],
)
def test_folders_plurals_and_mere_numbers_are_guessed(path: str, cue: str, variation: int | None) -> None:
    assert SETS.sure(path) is None
    assert SETS.guesses(path)[0][:2] == (cue, variation)


def test_a_guess_by_folders_says_so_in_the_words_of_the_list() -> None:
    assert SETS.guesses("Footsteps/grass/01.wav")[0].why == 'the folders have "footstep" and "grass"'
    assert SETS.guesses("footsteps_grass_04.wav")[0].why == 'the name has "footstep" and "grass"'
    assert SETS.guesses("Doors/Wood/Open/1.wav")[0].why == 'the folders have "door", "wood" and "open"'
    assert SETS.guesses("Ambience/01.wav") == []
    assert SETS.guesses("01.wav") == []


@pytest.mark.parametrize(
    ("path", "variation"),
    [
        ("step_grass_03.wav", 3),
        ("door_wood_open_01_48k24.wav", 1),
        ("Footstep Concrete 03 FINAL (2).wav", 3),
        ("grass/4.wav", 4),
        ("02 grass.wav", 2),
        ("grass take 2.wav", None),
        ("grass_v2.wav", None),
        ("grass_9.wav", None),
        ("4/grass.wav", None),
    ],
)
def test_the_variation_that_a_name_says(path: str, variation: int | None) -> None:
    assert variation_in(path, 6) == variation
