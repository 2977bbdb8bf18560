from pathlib import Path

import pytest

from app.renders import drawing
from app.renders.rules import Recipe
from audio_checks import Sandbox, Target
from tests.support.loading import modules_loaded
from tests.support.waves import sine, write_wav


@pytest.mark.slow
def test_a_child_of_a_rehearsed_server_loads_nothing_to_draw_and_compare(tmp_path: Path) -> None:
    path = str(write_wav(tmp_path / "a.wav", sine(hz=440, dbfs=-6, rate=96_000, channels=2), rate=96_000, bits=24))
    sandbox = Sandbox(rehearsal=drawing.preload)
    assert modules_loaded(sandbox, drawing.__name__, "draw", path, str(tmp_path), loop=False) == []
    assert modules_loaded(sandbox, "audio_checks", "sound_signature", path) == []
    sandbox.close()


def test_a_game_file_that_plays_as_the_preview_is_taken_for_it(tmp_path: Path) -> None:
    path = str(write_wav(tmp_path / "a.wav", sine(hz=440, dbfs=-6, seconds=0.2), bits=24))
    small, game = Target("small", 22_050, 16), Target("game", 48_000, 16)
    recipes = {one.name: Recipe(one, False, None, None, 0.05)._asdict() for one in (small, game)}
    out = tmp_path / "out"
    out.mkdir()
    found = drawing.prepare(path, str(out), recipes, loop=False, draws_master=True)
    assert found[drawing.MASTER]["preview_of"] == "game"
    assert sorted(one.name for one in out.iterdir() if one.is_file()) == [drawing.PEAKS, drawing.SPECTRUM]
    places = drawing.places(str(out), recipes)
    pictures = {name: (place / drawing.SPECTRUM).read_bytes() for name, place in places.items()}
    assert pictures[drawing.MASTER] == pictures["game"] != pictures["small"]
