"""Which cue a badly named file may be for."""

from uuid import uuid4

import pytest

from app.sound_lists.guesses import Candidate, likeliest, words_of


def candidate(name: str, **facts: object) -> Candidate:
    known = {"category": "", "duration_s": None, "variations": 1, "waits": False} | facts
    return Candidate(key=uuid4(), name=name, stem=name.lower().replace(" ", "_"), **known)


LIST = [
    candidate("UI confirm", category="ui", duration_s=0.2),
    candidate("Laser fire", category="weapon", duration_s=0.8, variations=4),
    candidate("Victory sting", category="music", duration_s=6.0, waits=True),
    candidate("Warp in", duration_s=3.0, waits=True),
    candidate("Hull impact", category="impact", duration_s=1.2, variations=3),
    candidate("Shield hit", duration_s=1.0),
]


def best(file_name: str, duration_s: float | None = None) -> tuple[str, int]:
    first = likeliest(file_name, duration_s, LIST)[0]
    return next(one.name for one in LIST if one.key == first.key), first.variation


@pytest.mark.parametrize(
    ("file_name", "expected"),
    [
        ("final_FINAL_sting2.wav", ("Victory sting", 1)),
        ("LaserFire-3 (master).wav", ("Laser fire", 3)),
        ("lazer_fire.wav", ("Laser fire", 1)),
        ("ShieldHitNEW_v04.wav", ("Shield hit", 1)),
        ("hul_inpact_02.wav", ("Hull impact", 2)),
        ("UIConfirm.wav", ("UI confirm", 1)),
        ("ui_confrm.wav", ("UI confirm", 1)),
    ],
)
def test_the_right_cue_comes_first(file_name: str, expected: tuple[str, int]) -> None:
    assert best(file_name) == expected


def test_reasons_are_words() -> None:
    first = likeliest("final_FINAL_sting2.wav", 5.8, LIST)[0]
    assert first.reason == 'the name has "sting"; 5.8 s long, 6.0 s asked; nothing delivered yet'
    assert 'reads like "laser_fire"' in likeliest("lasrfir.wav", None, LIST)[0].reason


def test_length_decides_between_like_names() -> None:
    short, long = candidate("Door open", duration_s=0.5), candidate("Door slide", duration_s=4.0)
    assert likeliest("door.wav", 3.9, [short, long])[0].key == long.key
    assert likeliest("door.wav", 0.5, [short, long])[0].key == short.key


def test_what_waits_comes_before_its_equal() -> None:
    done, waiting = candidate("Door open"), candidate("Door shut", waits=True)
    assert likeliest("door.wav", None, [done, waiting])[0].key == waiting.key


def test_a_name_that_says_nothing_falls_back_on_what_waits() -> None:
    named = {one.key: one.name for one in LIST}
    assert {named[like.key] for like in likeliest("01.wav", None, LIST)[:2]} == {"Victory sting", "Warp in"}


def test_without_any_likeness_there_are_three_still_and_they_say_so() -> None:
    guesses = likeliest("zzzz.wav", None, LIST)
    assert len({like.key for like in guesses}) == 3
    assert [like.score for like in guesses] == [0, 0, 0]
    assert all(like.reason.startswith("not alike") for like in guesses)
    waiting = {one.key for one in LIST if one.waits}
    assert {like.key for like in guesses[: len(waiting)]} <= waiting


def test_never_more_than_three() -> None:
    assert len(likeliest("door.wav", None, [candidate(f"Door {letter}") for letter in "abcdefgh"])) == 3


@pytest.mark.parametrize("name", ["../../etc/passwd", "\n\u202e.wav", "x" * 10_000, "", ".wav", "日本語の音.wav"])
def test_strange_names_do_no_harm(name: str) -> None:
    assert len(likeliest(name, None, LIST)) <= 3


def test_words() -> None:
    assert words_of("SFX_LaserFire_FINAL-v2 (48k)") == ("laser", "fire")
    assert words_of("Tür zu") == ("tur", "zu")
