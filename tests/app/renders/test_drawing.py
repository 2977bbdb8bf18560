from pathlib import Path

from app.renders import drawing
from audio_checks import Sandbox
from tests.support.loading import modules_loaded
from tests.support.waves import sine, write_wav


def test_a_child_of_a_rehearsed_server_loads_nothing_to_draw(tmp_path: Path) -> None:
    path = str(write_wav(tmp_path / "a.wav", sine(hz=440, dbfs=-6, rate=96_000, channels=2), rate=96_000, bits=24))
    sandbox = Sandbox(rehearsal=drawing.rehearse)
    assert modules_loaded(sandbox, drawing.__name__, "draw", path, str(tmp_path), loop=False) == []
    sandbox.close()
