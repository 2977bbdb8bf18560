"""Names of a list that files are matched by: each file's name is read once for a revision."""

from uuid import uuid4

import pytest

import audio_checks
from app.sound_lists.names.matching import ListNames


@pytest.fixture
def names() -> ListNames:
    cues = [
        audio_checks.ListedCue(
            key=uuid4(), name=name, file_name=name, category="ui", variations=1, label=f"UI-{number}"
        )
        for number, name in enumerate(("laser_fire", "door_open"), start=1)
    ]
    return ListNames(audio_checks.NameIndex(cues, ["Deep Field"]), {cue.key: cue for cue in cues})


def test_a_name_is_read_once_and_answered_the_same_way_again(names: ListNames, monkeypatch: pytest.MonkeyPatch) -> None:
    sure, none = names.sure("Laser Fire FINAL.wav", ["Tones"]), names.sure("whoosh.wav", ["Tones"])
    guesses = names.guesses("laser.wav", ["Tones"])
    assert sure is not None
    assert (sure.name, none, [guess.name for guess in guesses][:1]) == ("laser_fire", None, ["laser_fire"])
    monkeypatch.setattr(audio_checks.NameIndex, "sure", None)  # nobody may ask it again
    monkeypatch.setattr(audio_checks.NameIndex, "guesses", None)
    assert names.sure("Laser Fire FINAL.wav", ["Tones"]) == sure
    assert names.sure("whoosh.wav", ["Tones"]) is None
    assert names.guesses("laser.wav", ["Tones"]) == guesses


def test_other_people_and_other_prefixes_are_another_question(names: ListNames) -> None:
    name = "tones_laser_fire.wav"
    assert names.guesses(name, []) is not names.guesses(name, ["Tones"])
    assert names.guesses(name, ["Tones"]) is not names.guesses(name, ["Tones"], ["tones"])
    assert names.guesses(name, ["Tones"], ["tones"]) is names.guesses(name, ["Tones"], ["tones"])
