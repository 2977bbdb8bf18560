"""What the server packs is what CI accepts: every kind of cue is pulled and checked without a finding."""

from pathlib import Path
from typing import Any

import pytest

from app.client import ci
from tests.app.builds.approved import approve
from tests.app.client.served import client_of
from tests.app.client.test_ci import SCOPES, run
from tests.support.deliver import add_cues
from tests.support.server import RunningServer, World
from tests.support.voice import imported

pytestmark = pytest.mark.slow

KINDS: list[dict[str, Any]] = [
    {"name": "Laser fire", "variations": 3, "category": "weapon"},
    {"name": "UI confirm", "file_name": "ui_confirm", "category": "ui"},
    {"name": "Engine idle", "loop": True, "category": "vehicle"},
    {"name": "Bridge room", "loop": True, "category": "ambience"},
    {"name": "Victory sting", "category": "music"},
    {"name": "Hull impact", "need": "should", "category": "impact"},
]


def test_every_kind_of_cue_is_pulled_and_checked_without_a_finding(
    server: RunningServer, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], game: Path
) -> None:
    world = World(server)
    add_cues(world, *KINDS)
    imported(world)
    cues = world.producer.get(f"/v1/projects/{world.project_id}/sound-list").json()["cues"]
    masters = approve(world, cues)
    for variable in (*ci.LABELS, *ci.COMMITS):
        monkeypatch.delenv(variable, raising=False)
    monkeypatch.chdir(game)
    (game / "assets").mkdir()
    with client_of(world, monkeypatch, capsys, *SCOPES) as client:
        assert client.pull(game / "assets") == 0, client.out
        pulled = {str(path.relative_to(game / "assets")) for path in (game / "assets").rglob("*.wav")}
        assert len(pulled) == len(masters)
        assert {"laser_fire_03.wav", "engine_idle.wav", "en/captain_010.wav", "de/maya_010.wav"} <= pulled
        code, out, err = run(client, "--target", "game", "--fail-level", "warning", "--label", "1")
    assert code == 0, out + err
    assert f"{len(masters)} files: {len(masters)} conforming" in out
