from dataclasses import replace

import pytest

from app.renders.rules import game_ending, recipes
from audio_checks import new_spec, parse_spec

MASTER = "a" * 64
BASE = parse_spec(new_spec("44k1", name="Shield Wing"))


def keys(toml_end: str = "", *, category: str | None = None, loop: bool = False, master: str = MASTER) -> set[str]:
    spec = parse_spec(BASE.to_toml() + toml_end)
    return {recipe.key(master) for recipe in recipes(spec, category=category, loop=loop).values()}


def test_each_target_has_a_key_of_its_own() -> None:
    assert len(keys()) == len(BASE.targets) == 2


def test_what_changes_the_bytes_changes_every_key() -> None:
    assert keys().isdisjoint(keys(loop=True))
    assert keys().isdisjoint(keys(master="b" * 64))
    assert keys().isdisjoint(keys("[categories.quiet]\nlimits.sample_peak_dbfs = -6.0\n", category="quiet"))
    shaped = '[categories.plain]\ntargets.game.dither = "none"\n'
    assert len(keys(shaped, category="plain") - keys()) == 1


@pytest.mark.parametrize(
    "toml_end",
    ["[categories.slow]\nlimits.head_silence_ms = 50\n", '[categories.slow]\nchecks.true-peak = "error"\n'],
)
def test_what_leaves_the_bytes_alone_leaves_the_keys(toml_end: str) -> None:
    assert keys(toml_end, category="slow") == keys()


@pytest.mark.parametrize(
    ("encoding", "made_to", "ending"),
    [
        ("pcm", "pcm", ".usual"),
        ("vorbis", "pcm", ".ogg"),
        ("mp3", "vorbis", ".mp3"),
        ("vorbis", "vorbis", ".usual"),
        ("flac", "pcm", ".usual"),
    ],
)
def test_a_lossy_file_that_was_kept_as_it_came_keeps_its_ending(encoding: str, made_to: str, ending: str) -> None:
    target = replace(next(iter(BASE.targets.values())), encoding=made_to)
    assert game_ending({"encoding": encoding}, target, ".usual") == ending
