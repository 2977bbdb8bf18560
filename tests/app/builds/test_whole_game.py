"""Every kind of cue, packed, pulled and checked by the lines for CI: what we hand out passes our own checks."""

import io
import json
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any
from zlib import crc32

import numpy as np
import pytest

from audio_checks.cli import main
from tests.app.builds.approved import RATE, sound
from tests.app.builds.test_packs import download
from tests.app.client.served import client_of
from tests.support.deliver import add_cues, deliver, open_delivery
from tests.support.server import World
from tests.support.voice import imported
from tests.support.waves import noise, sine, wav_bytes

Check = Callable[..., tuple[int, dict[str, list[str]]]]
FOLDERS = '\n[targets.pc]\nsample_rate_hz = 44100\nbit_depth = 16\nchannels = 1\nfolder = "Content/Audio/{category}"\n'


@pytest.fixture
def checked(world: World, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> Check:
    """Check a folder as CI does, and return the exit code and the findings that count by path."""

    def checked(folder: Path, target: str) -> tuple[int, dict[str, list[str]]]:
        for path, name in (("spec.toml", "spec.toml"), ("sound-list.csv", "sounds.csv"), ("baseline.json", "b.json")):
            answer = world.producer.get(f"/v1/projects/{world.project_id}/{path}")
            assert answer.status_code == 200, answer.text
            (tmp_path / name).write_bytes(answer.content)
        rules = ["--spec", "spec.toml", "--list", "sounds.csv", "--baseline", "b.json"]
        named = [part if part.startswith("--") else str(tmp_path / part) for part in rules]
        capsys.readouterr()
        given = ["--target", target, "--fail-level", "warning", "--format", "json", "--no-cache", "-j", "1"]
        code = main(["check", *named, *given, str(folder)])
        report = json.loads(capsys.readouterr().out)
        return code, {
            Path(file["path"]).relative_to(folder).as_posix(): [
                finding["code"] for finding in file["findings"] if not finding.get("waived")
            ]
            for file in report["files"]
        }

    return checked


def loop_sound(seed: int) -> bytes:
    """Noise that goes on where it began, without a `smpl` chunk."""
    seconds, fade = 1.0, RATE // 10
    longer = noise(dbfs=-24, seconds=seconds + 0.1, rate=RATE, seed=seed)
    rising = np.sqrt(np.linspace(0, 1, fade))[:, np.newaxis]
    joined = longer[:-fade].copy()
    joined[:fade] = longer[:fade] * rising + longer[-fade:] * rising[::-1]
    return wav_bytes(joined, rate=RATE, bits=24)


def cut_sound(seed: int) -> bytes:
    """A tone that stops in the middle of its wave: a warning that the approver may accept."""
    return wav_bytes(sine(hz=200 + seed % 7, dbfs=-12, seconds=0.3013, rate=RATE), rate=RATE, bits=24)


def approve_whole_game(world: World) -> list[str]:
    """Approve a sound for every kind of cue; return the stems."""
    add_cues(
        world,
        {"name": "UI confirm", "file_name": "ui_confirm", "category": "ui"},
        {"name": "Laser fire", "variations": 3, "category": "weapon"},
        {"name": "Engine idle", "loop": True, "category": "ambience"},
        {"name": "Rain", "loop": True, "variations": 2, "category": "ambience"},
        {"name": "Cave drip", "reverb": "separate-tail"},
        {"name": "Cave drip tail", "reverb": "designed-tail"},
        {"name": "Stinger", "category": "music"},
        {"name": "Radio off"},
    )
    imported(world)
    cues = world.producer.get(f"/v1/projects/{world.project_id}/sound-list").json()["cues"]
    delivery_id, takes = open_delivery(world), []
    for cue in cues:
        for stem in cue["stems"]:
            seed = crc32(stem.encode()) % 1000
            make = loop_sound if cue["loop"] else cut_sound if cue["name"] == "Radio off" else sound
            takes.append(deliver(world, f"{stem}.wav", make(seed), delivery_id=delivery_id))
    world.server.wait_for_jobs()
    for take in takes:
        given = world.approver.post(f"/v1/takes/{take['id']}/verdict", json={"kind": "approve", "note": ""})
        assert given.status_code == 200, given.text
    world.server.wait_for_jobs()
    return [stem for cue in cues for stem in cue["stems"]]


def add_target(world: World) -> None:
    url = f"/v1/projects/{world.project_id}/spec"
    spec = world.producer.get(url).json()
    body = {"toml": spec["toml"] + FOLDERS, "based_on_version": spec["version"]}
    answer = world.producer.put(url, json=body)
    assert answer.status_code in (200, 201), answer.text


@pytest.mark.slow
def test_what_we_hand_out_passes_our_own_checks(
    world: World,
    tmp_path: Path,
    checked: Check,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    add_target(world)
    stems = approve_whole_game(world)
    for target, line in (("game", "de/captain_010.wav"), ("pc", "Content/Audio/vo/de/captain_010.wav")):
        packed = tmp_path / f"packed-{target}"
        with zipfile.ZipFile(io.BytesIO(download(world, target=target))) as archive:
            archive.extractall(packed)
        code, found = checked(packed, target)
        assert (code, {path: codes for path, codes in found.items() if codes}) == (0, {})
        assert (len(found), line in found) == (len(stems), True)
        pulled = tmp_path / f"pulled-{target}"
        pulled.mkdir()
        with client_of(world, monkeypatch, capsys) as client:
            assert client.pull(pulled, "--target", target) == 0, client.out
        assert checked(pulled, target) == (0, found)


@pytest.mark.slow
def test_a_warning_that_nobody_accepted_counts(world: World, tmp_path: Path, checked: Check) -> None:
    approve_whole_game(world)
    with zipfile.ZipFile(io.BytesIO(download(world))) as archive:
        archive.extractall(tmp_path / "game")
    (tmp_path / "game" / "radio_off.wav").write_bytes(
        wav_bytes(sine(hz=333, dbfs=-12, seconds=0.3013, rate=RATE), rate=RATE, bits=16)
    )
    code, found = checked(tmp_path / "game", "game")
    assert (code, {path: codes for path, codes in found.items() if codes}) == (
        1,
        {"radio_off.wav": ["cut-tail:mid-wave"]},
    )
    baseline: dict[str, Any] = json.loads((tmp_path / "b.json").read_text())
    (accepted,) = {one["reason"] for one in baseline["waived"] if one["file_name"] == "radio_off.wav"}
    assert accepted == "it was approved with this warning"


@pytest.mark.slow
def test_placeholders_of_a_pack_and_of_the_command_stand_in_one_place(
    world: World, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    add_target(world)
    imported(world)
    for path, name in (("spec.toml", "spec.toml"), ("sound-list.csv", "sounds.csv")):
        (tmp_path / name).write_bytes(world.producer.get(f"/v1/projects/{world.project_id}/{path}").content)
    rules = ["--list", str(tmp_path / "sounds.csv"), "--spec", str(tmp_path / "spec.toml")]
    assert main(["placeholders", *rules, "--target", "pc", "--no-voice", "--out", str(tmp_path / "out")]) == 0
    made = {path.relative_to(tmp_path / "out" / "pc").as_posix() for path in (tmp_path / "out").rglob("*.wav")}
    listed = world.producer.get(f"/v1/projects/{world.project_id}/placeholders", params={"target": "pc"}).json()
    assert made == {item["path"] for item in listed["items"]}
