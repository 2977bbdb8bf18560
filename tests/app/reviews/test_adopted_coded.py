"""A tree of encoded files is adopted, heard, packed, pulled and audited, and its bytes stay what they were."""

import io
import json
import subprocess
import sys
import wave
import zipfile
from pathlib import Path
from typing import Any

import pytest

from tests.app.builds.test_packs import KEY, download
from tests.support.adoptions import adopted, plan
from tests.support.coded import coded_bytes
from tests.support.deliver import deliver
from tests.support.server import World
from tests.support.waves import noise, wav_bytes

pytestmark = pytest.mark.both_databases
TREE = {
    "music/theme.ogg": coded_bytes("ogg", seed=1, channels=2),
    "music/stinger.mp3": coded_bytes("mp3", seed=2),
    "steps/grass_01.ogg": coded_bytes("ogg", seed=3),
    "steps/grass_02.ogg": coded_bytes("ogg", seed=4),
    "amb/wind.opus": coded_bytes("opus", seed=5, rate=48_000, channels=2),
    "ui/click.flac": coded_bytes("flac", seed=6),
    "ui/back.wav": wav_bytes(noise(dbfs=-24, seconds=0.3, rate=44_100, seed=7), rate=44_100, bits=16),
}
CODED = [path for path in TREE if not path.endswith((".wav", ".flac"))]
SHIP = '[targets.ship]\nsample_rate_hz = 44100\nbit_depth = 16\nkeep_coded = true\nfolder = "{category}"\n'
STRICT = "[targets.strict]\nsample_rate_hz = 44100\nbit_depth = 16\n"
VORBIS = '[targets.ogg]\nsample_rate_hz = 44100\nencoding = "vorbis"\n'


def measured_spec(world: World, folder: Path) -> None:
    """Store the spec that is measured from the tree, with three targets."""
    for path, content in TREE.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_bytes(content)
    command = [sys.executable, "-m", "audio_checks.cli", "new-spec", "--from", str(folder)]
    measured = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    spec = world.producer.get(f"/v1/projects/{world.project_id}/spec").json()
    body = {"toml": "\n".join([measured, SHIP, STRICT, VORBIS]), "based_on_version": spec["version"]}
    saved = world.producer.put(f"/v1/projects/{world.project_id}/spec", json=body)
    assert saved.status_code == 200, saved.text


@pytest.fixture
def tree(world: World, tmp_path: Path) -> tuple[Path, dict[str, Any]]:
    """The tree on disk, and its adoption by the spec that is measured from it."""
    measured_spec(world, tmp_path / "game")
    return tmp_path / "game", adopted(world, TREE)


def takes(world: World) -> dict[str, dict[str, Any]]:
    """The sounds of each take, by its file name."""
    found = {}
    for cue in world.producer.get(f"/v1/projects/{world.project_id}/sound-list").json()["cues"]:
        for take in world.producer.get(f"/v1/cues/{cue['id']}/review").json()["takes"]:
            found[take["file_name"]] = world.producer.get(f"/v1/takes/{take['id']}/sounds").json()
    return found


@pytest.mark.slow
def test_on_the_first_day_nothing_has_an_error(world: World, tree: tuple[Path, dict[str, Any]]) -> None:
    _, adoption = tree
    assert (adoption["cues"], adoption["takes"], adoption["skipped"]) == (6, 7, [])
    progress = world.producer.get(f"/v1/adoptions/{adoption['id']}").json()
    assert (progress["takes"], progress["checked"], progress["conforming"]) == (7, 7, 7)
    assert [one for one in progress["odd"] if one["verdict"] != "conforming"] == []


@pytest.mark.slow
def test_each_is_heard_in_the_browser_and_its_master_is_what_was_sent(
    world: World, tree: tuple[Path, dict[str, Any]]
) -> None:
    for path, content in TREE.items():
        sounds = takes(world)[path.rpartition("/")[2]]
        master = sounds["master"]
        assert (path, master["state"]) == (path, "drawn")
        preview = world.approver.get(master["preview_url"])
        with wave.open(io.BytesIO(preview.content)) as sound:
            assert sound.getnframes() > 10_000
        sent = world.approver.get(f"/v1/takes/{sounds['take_id']}/master")
        assert sent.content == content


@pytest.mark.slow
def test_a_target_that_keeps_coded_files_ships_the_very_bytes_and_the_audit_finds_them_the_same(
    world: World, tree: tuple[Path, dict[str, Any]], tmp_path: Path
) -> None:
    game, _ = tree
    with zipfile.ZipFile(io.BytesIO(download(world, target="ship", masters=False))) as archive:
        packed = {name: archive.read(name) for name in archive.namelist() if name not in KEY}
    assert sorted(packed) == sorted({**TREE, "ui/click.wav": b""}.keys() - {"ui/click.flac"})
    assert {path: packed[path] for path in CODED} == {path: TREE[path] for path in CODED}
    listed = world.producer.get(f"/v1/projects/{world.project_id}/game-files", params={"target": "ship"}).json()
    assert (sorted(one["path"] for one in listed["files"]), listed["missing"]) == (sorted(packed), [])
    kinds = {}
    for one in listed["files"]:
        pulled = world.producer.get(one["url"])
        assert pulled.content == packed[one["path"]]
        kinds[one["path"].rpartition(".")[2]] = pulled.headers["content-type"]
    assert kinds == {"ogg": "audio/ogg", "opus": "audio/ogg", "mp3": "audio/mpeg", "wav": "audio/wav"}
    url = f"/v1/projects/{world.project_id}/manifest.json"
    world.producer.get(url, params={"target": "ship"})
    world.server.wait_for_jobs()
    answer = world.producer.get(url, params={"target": "ship"})
    assert answer.status_code == 200, answer.text
    (tmp_path / "approved.json").write_text(answer.text)
    command = [sys.executable, "-m", "audio_checks.cli", "audit", "--manifest", str(tmp_path / "approved.json")]
    ran = subprocess.run([*command, "--format", "json", str(game)], check=False, capture_output=True, text=True)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    assert [load["status"] for load in json.loads(ran.stdout)["files"]] == ["same"] * 7


@pytest.mark.slow
def test_a_target_of_the_same_codec_takes_the_file_and_others_say_why_not(
    world: World, tree: tuple[Path, dict[str, Any]]
) -> None:
    found = takes(world)
    states = {
        name: {sound["target"]: (sound["state"], sound["refusal"]) for sound in sounds["renders"]}
        for name, sounds in found.items()
    }
    assert states["theme.ogg"]["ogg"] == ("made", None)
    for name, target in (("theme.ogg", "strict"), ("stinger.mp3", "ogg"), ("wind.opus", "ogg")):
        state, refusal = states[name][target]
        assert state == "refused"
        assert "a coded file is not a master" in refusal
        assert "deliver the WAV that it was made from" in refusal
    assert {states[name]["strict"][0] for name in ("click.flac", "back.wav")} == {"made"}
    refused = world.producer.get(f"/v1/projects/{world.project_id}/pack.zip", params={"target": "strict"})
    assert (refused.status_code, refused.json()["code"]) == (409, "pack-incomplete")
    assert "is not a master" in refused.text


@pytest.mark.slow
def test_a_coded_file_that_is_delivered_is_returned_though_the_same_one_was_adopted(
    world: World, tree: tuple[Path, dict[str, Any]]
) -> None:
    take = deliver(world, "theme.ogg", TREE["music/theme.ogg"])
    world.server.wait_for_jobs()
    check = world.producer.get(f"/v1/takes/{take['id']}/check").json()
    assert (check["state"], [one["code"] for one in check["findings"]]) == ("returned", ["container:ogg"])


def test_what_is_not_read_is_skipped_with_its_reason(world: World) -> None:
    answer = plan(world, {"other/theme2.m4a": b"x", "other/x.ogg": TREE["music/theme.ogg"]})
    assert [(one["path"], one["code"]) for one in answer["skipped"]] == [("other/theme2.m4a", "coded")]
    assert "WAV, FLAC, Ogg, Opus and MP3 are adopted, found m4a" in answer["skipped"][0]["message"]
