"""Voice lines in a pack: one folder for each language, one name for the line."""

import io
import zipfile

import pytest

from tests.app.builds.approved import approve
from tests.app.builds.test_packs import download
from tests.support.server import World
from tests.support.voice import imported

pytestmark = pytest.mark.slow


def test_approved_lines_lie_in_the_folder_of_their_language(world: World) -> None:
    imported(world)
    cues = world.producer.get(f"/v1/projects/{world.project_id}/sound-list").json()["cues"]
    lines = [cue for cue in cues if cue["name"] in ("de_captain_010", "en_captain_010")]
    assert len(lines) == 2
    approve(world, lines)
    with zipfile.ZipFile(io.BytesIO(download(world))) as archive:
        sounds = {name for name in archive.namelist() if name.endswith(".wav")}
        key = archive.read("documentation-key.csv").decode("utf-8-sig")
        masters = set(zipfile.ZipFile(io.BytesIO(download(world, masters=True))).namelist())
    assert {"masters/de/captain_010.wav", "masters/en/captain_010.wav"} <= masters
    assert sounds == {"de/captain_010.wav", "en/captain_010.wav"}
    assert "de/captain_010.wav" in key
