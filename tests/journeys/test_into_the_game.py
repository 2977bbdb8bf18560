"""A shipped game's sounds become a list, one of them is replaced, pulled, audited, listened to, and put right."""

import io
import json
import os
import re
import shutil
import subprocess
import sys
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from uuid import uuid4

import pytest
from fastapi.testclient import TestClient

import audio_checks
from app.client.lock import read_lock
from app.demo.wwise_game import write_game
from tests.app.builds.approved import RATE, sound
from tests.app.client.served import Client, Line, files_in, states_of
from tests.app.client.test_why import rows
from tests.journeys.people import Designer, Team
from tests.support.listening import listening
from tests.support.server import RunningServer
from tests.support.waves import noise, wav_bytes

pytestmark = pytest.mark.both_databases

SCOPES = ["deliveries:write", "manifest:read", "rights:read", "list:read", "checks:write"]
SOUNDS = {name: sound(seed) for seed, name in enumerate(["laser_fire_01.wav", "laser_fire_02.wav", "ui_confirm.wav"])}


@dataclass
class Game:
    """A project of Wwise in a programmer's working copy, and the sound of it that is to change."""

    project: Path
    changed: str  # the sound's file
    holder: str  # the object whose volume counts for it
    volume_db: float
    unplayed: int = 0  # sounds that lie in the folder, and nothing plays

    @property
    def sounds(self) -> Path:
        """The folder of its sounds."""
        return self.project.parent / "Originals" / "SFX"

    def set_volume(self, volume_db: float) -> None:
        """Change the volume of the object, as a person does in Wwise."""
        volume = re.compile(
            rf'(Name="{self.holder}" [^>]*>\s*<PropertyList>(?:(?!</PropertyList>).)*?<Property Name="Volume" [^>]*>\s*'
            rf"<ValueList>\s*<Value>){self.volume_db:g}(</Value>)",
            re.DOTALL,
        )
        (unit,) = [path for path in self.project.parent.rglob("*.wwu") if volume.search(path.read_text())]
        unit.write_text(volume.sub(rf"\g<1>{volume_db:g}\g<2>", unit.read_text(), count=1))
        self.volume_db = volume_db


def audio_checks_command(*arguments: str | Path, code: int = 0) -> str:
    """Run `audio-checks` as the game's CI does, and return what it printed."""
    program = Path(sys.executable).parent / "audio-checks"
    done = subprocess.run([program, *arguments], capture_output=True, text=True, timeout=300)
    assert done.returncode == code, f"exit code {done.returncode}\n{done.stdout}{done.stderr}"
    return done.stdout


class Studio:
    """A studio whose game has shipped: a producer, an approver, an implementer, a designer and the game's CI."""

    def __init__(self, server: RunningServer, game: Game) -> None:
        self.server, self.game = server, game
        self.producer, self.director, self.implementer = Team(server), Team(server), Team(server)
        self.designer = Designer(server)
        self.id = self.producer.sign_up("Journey studio")
        invited = ((self.director, ["liaison"], "Audio director"), (self.implementer, ["implementer"], "Implementer"))
        for person, roles, name in invited:
            body = {"email": person.address, "roles": roles}
            self.producer.ask("POST", f"/studios/{self.id}/invitations", json=body)
            person.person_id = person.join(name)
        project = {"studio_id": self.id, "name": "Shield Wing", "cue_prefix": "SW", "preset": "44k1"}
        self.project_id = self.producer.ask("POST", "/projects", json=project)["id"]
        self.path = f"/projects/{self.project_id}"
        self.producer.ask("PUT", f"{self.path}/liaisons/{self.director.person_id}")
        why = {"person_id": self.director.person_id, "reason": "hears best"}
        self.producer.ask("PUT", f"{self.path}/approver", json=why)

    def use_spec_of_the_game(self, rate_hz: int, bit_depth: int) -> None:
        """Measure a spec from the shipped sounds, with a target that has their format, and store it."""
        toml = audio_checks_command("new-spec", "--from", self.game.sounds, "--no-progress")
        assert "[targets" not in toml
        toml += f"\n[targets.game]\nsample_rate_hz = {rate_hz}\nbit_depth = {bit_depth}\n"
        version = self.producer.ask("GET", f"{self.path}/spec")["version"]
        body = {"toml": toml, "note": "measured from the game", "based_on_version": version}
        self.producer.ask("PUT", f"{self.path}/spec", json=body)

    @contextmanager
    def game_team(self, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Iterator[Client]:
        """Give the project's token to the game team's machine and to its CI, behind a real socket."""
        body = {"name": "Game", "scopes": SCOPES}
        secret = self.producer.ask("POST", f"{self.path}/tokens", json=body)["secret"]
        self.ci: TestClient = self.server.browser()
        self.ci.headers["Authorization"] = f"Bearer {secret}"
        monkeypatch.setenv("SOUNDLIST_TOKEN", secret)
        line = Line(self.server.application)
        with listening(line, lifespan="off", log_level="critical") as port:
            yield Client(self, line, port, capsys)

    def cues(self) -> dict[str, dict[str, Any]]:
        """Return the cues of the list by name."""
        return {cue["name"]: cue for cue in self.producer.ask("GET", f"{self.path}/sound-list")["cues"]}

    def takes(self) -> list[dict[str, Any]]:
        """Return the takes, newest first, once nothing is left to be done."""
        self.server.wait_for_jobs()
        takes: list[dict[str, Any]] = self.producer.ask("GET", f"{self.path}/takes", params={"limit": 200})["items"]
        return takes

    def pack(self) -> dict[str, bytes]:
        """Return the files of the pack with import files for Wwise."""
        content = self.producer.ask("GET", f"{self.path}/pack.zip", params={"target": "game", "handoff": "wwise"})
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            return {name: archive.read(name) for name in archive.namelist()}

    def manifest(self) -> bytes:
        """Fetch the manifest as the game's CI does, which asks again while sounds are listened to."""
        url, params = f"/v1{self.path}/manifest.json", {"target": "game"}
        answer = self.ci.get(url, params=params)
        if answer.status_code == 409:
            assert answer.json()["code"] == "manifest-not-ready", answer.text
            assert int(answer.headers["Retry-After"]) > 0
            self.server.wait_for_jobs()
            answer = self.ci.get(url, params=params)
        assert answer.status_code == 200, answer.text
        return answer.content

    def audit(self, label: str, *, code: int) -> tuple[str, dict[str, Any]]:
        """Audit the game as its CI does and post the report; return what was printed, and the audit as it is listed."""
        folder = self.game.project.parent.parent
        (folder / "manifest.json").write_bytes(self.manifest())
        baseline = self.ci.get(f"/v1{self.path}/baseline.json")
        assert baseline.status_code == 200, baseline.text
        (folder / "baseline.json").write_bytes(baseline.content)
        printed = audio_checks_command(
            "audit", "--manifest", folder / "manifest.json", "--project", self.game.project, "--no-progress",
            "--baseline", folder / "baseline.json", "--format", "text", "--format", f"json:{folder / 'audit.json'}",
            self.game.sounds, code=code,
        )  # fmt: skip
        body = {"label": label, "target": "game", "report": json.loads((folder / "audit.json").read_text())}
        posted = self.ci.post(f"/v1{self.path}/audits", json=body)
        assert posted.status_code == 201, posted.text
        newest = self.producer.ask("GET", f"{self.path}/audits")["items"][0]
        assert newest == posted.json()
        return printed, newest

    def sounds_of(self, audit: dict[str, Any], **query: Any) -> dict[str, dict[str, Any]]:
        """Return the rows of the builds page by file."""
        rows = self.producer.ask("GET", f"/audits/{audit['id']}/sounds", params={"limit": 200, **query})["items"]
        return {row["path"].rpartition("/")[2]: row for row in rows}

    def tasks(self, person: Team) -> list[dict[str, Any]]:
        """Return the sounds to correct that a person sees."""
        items: list[dict[str, Any]] = person.ask("GET", f"{self.path}/game-tasks")["items"]
        return items

    def states(self) -> dict[str, Any]:
        """Return how much of the list is in the build, and was heard in the game."""
        states: dict[str, Any] = self.producer.ask("GET", f"{self.path}/game-states")
        return states


def adopt(studio: Studio, team: Client) -> None:
    """Send the game's folder with its project, and adopt it as the approver."""
    assert team.adopt(studio.game.sounds, "--game-project", str(studio.game.project)) == 0, team.err
    files = len(files_in(studio.game.sounds))
    assert f"{studio.game.project.name} plays {files - studio.game.unplayed} of them" in team.out.splitlines()
    adoption = re.search(r"adoption=([0-9a-f-]{36})", team.out)
    assert adoption, team.out
    studio.director.ask("POST", f"/adoptions/{adoption[1]}/adopt")
    takes = studio.takes()
    assert len(takes) == files
    assert {take["state"] for take in takes} == {"approved"}
    (changed,) = [take for take in takes if take["file_name"] == studio.game.changed]
    assert changed["note"] == f"In the game as {studio.game.changed}, played at {studio.game.volume_db:+.1f} dB"


def replace_the_sound(studio: Studio, content: bytes) -> dict[str, Any]:
    """Deliver another sound for the cue, approve it, and return its take."""
    designer = studio.designer
    body = {"email": designer.address, "kind": "contract", "note": ""}
    studio.producer.ask("POST", f"{studio.path}/invitations", json=body)
    designer.look()
    designer.accept()
    take = designer.deliver(designer.open_delivery(studio.project_id), studio.game.changed, content)
    server_says = next(one for one in studio.takes() if one["id"] == take["id"])
    assert (server_says["state"], server_says["number"]) == ("conforming", 2)
    studio.director.ask("POST", f"/takes/{take['id']}/verdict", json={"kind": "approve", "note": ""})
    states = [one["state"] for one in studio.takes() if one["file_name"] == studio.game.changed]
    assert states == ["approved", "set_aside"]
    return take


def pull_the_sound(studio: Studio, team: Client) -> None:
    """Pull into the game: the file that was replaced is written, and no other."""
    folder, name = studio.game.sounds, studio.game.changed
    before = states_of(folder)
    assert team.pull(folder) == 0, team.out + team.err
    changed = {Path(path).name for path, state in states_of(folder).items() if before.get(path) != state}
    assert changed == {name, "soundlist.lock"}
    lock = read_lock(folder)
    assert lock is not None
    assert set(lock.entries) == files_in(folder).keys()
    assert f"changed  {name}  {lock.entries[name].cue}" in team.out
    assert (folder / name).read_bytes() == studio.pack()[name]
    assert team.why(name, "--folder", str(folder)) == 0, team.err
    said = rows(team.out)
    assert said["cue"].startswith(f"{lock.entries[name].cue} ")
    assert (said["approved by"], said["designer"]) == ("Audio director", "Sound designer")
    assert (said["version of the sound"], said["accepted now"]) == ("2", "yes")


def put_right(studio: Studio, louder: dict[str, Any]) -> None:
    """Say in a listening pass that the sound is too loud; the implementer puts the volume back."""
    game, approver = studio.game, studio.director
    listening_pass = approver.ask("POST", f"{studio.path}/listening-passes")["listening_pass"]
    assert listening_pass["audit"]["id"] == louder["id"]
    (cue,) = [one for one in listening_pass["cues"] if one["move"]]
    assert (cue["gain_db"], cue["suggested_db"]) == pytest.approx((6.0, -6.0), abs=0.02)
    cues = studio.states()["cues"]
    assert studio.states()["never_heard"] == cues
    note = {"note_id": str(uuid4()), "cue_id": cue["cue"]["id"], "said": "too-loud", "amount_db": cue["suggested_db"]}
    approver.ask("POST", f"/listening-passes/{listening_pass['id']}/notes", json=note | {"text": "jumps out"})

    (task,) = studio.tasks(studio.implementer)
    assert (task["kind"], task["role"], task["text"]) == ("too-loud", "implementer", "jumps out")
    assert task["cue"] == cue["cue"]
    assert task["gain_db"] == pytest.approx(-6.0, abs=0.02)
    assert task["where"].endswith(f"\\{game.holder}, Volume")
    game.set_volume(game.volume_db + round(task["gain_db"], 1))
    studio.implementer.ask("PUT", f"/game-tasks/{task['id']}", json={"is_done": True})
    assert studio.tasks(studio.implementer) == []
    now = approver.ask("GET", f"{studio.path}/listening-pass")["listening_pass"]
    assert (now["heard"], now["people"], [one["is_done"] for one in now["notes"]]) == (1, 1, [True])
    states = studio.states()
    assert (states["in_build"], states["heard"], states["never_heard"]) == (cues - game.unplayed, 1, cues - 1)
    assert cue["cue"]["id"] not in [state["cue"]["id"] for state in states["unheard"]]
    assert len(states["unheard"]) == cues - 1


def play_it_through(studio: Studio, team: Client, content: bytes) -> None:
    """Take a game from its adoption to a build in which a raised volume was put back."""
    game = studio.game
    adopt(studio, team)
    assert team.pull(game.sounds) == 0, team.out + team.err
    files = len(files_in(game.sounds))
    assert team.out.splitlines() == [f"Shield Wing, game: {files} approved files, {files} unchanged"]
    _, first = studio.audit("480", code=1 if game.unplayed else 0)
    assert (first["sounds"], first["drifted"], first["engine"]) == (files, game.unplayed, "wwise")
    for path, row in studio.sounds_of(first, drifted=True).items():
        assert row["status"] == "unused"
        body = {"path": path, "reason": "comes with the next level"}
        studio.director.ask("POST", f"/audits/{first['id']}/accepted-drifts", json=body)

    replace_the_sound(studio, content)
    pull_the_sound(studio, team)
    pack = studio.pack()
    assert f"..\\{game.changed}" in [line.split("\t")[0] for line in pack["wwise/sounds.tsv"].decode().splitlines()]
    events = pack.get("wwise/events.tsv", b"\r\n").decode().splitlines()[1:]
    assert len(events) == game.unplayed, "what the game plays has its events already"
    _, second = studio.audit("481", code=0)
    assert (second["drifted"], second["new_drifts"]) == (game.unplayed, 0), "the adopted level stays approved"

    before_db = game.volume_db
    game.set_volume(before_db + 6)
    printed, louder = studio.audit("482", code=1)
    assert f"{game.changed}  gain (+6.0 dB)" in printed
    assert f"\\{game.holder} Volume {before_db:+.1f} to {before_db + 6:+.1f} dB" in printed
    assert (louder["drifted"], louder["new_drifts"]) == (game.unplayed + 1, 1)
    shown = studio.producer.ask("GET", f"/audits/{louder['id']}")
    assert (shown["before"], shown["accepted"]) == ("481", game.unplayed)
    (found,) = [row for row in studio.sounds_of(louder, drifted=True).values() if row["is_new"]]
    assert (found["path"], found["status"]) == (game.changed, "gain")
    assert (found["gain_db"], found["file_db"], found["property_db"]) == pytest.approx((6.0, 0.0, 6.0), abs=0.02)
    (move,) = found["moves"]
    assert move["object"].endswith(f"\\{game.holder}")
    assert (move["property"], move["approved_db"], move["gain_db"]) == ("Volume", before_db, before_db + 6)
    assert found["sound"]["preview_url"]

    put_right(studio, louder)
    assert game.volume_db == before_db
    printed, last = studio.audit("483", code=0)
    assert "gain" not in printed
    assert (last["sounds"], last["drifted"], last["new_drifts"]) == (files, game.unplayed, 0)
    params = {"path": game.changed}
    history = studio.producer.ask("GET", f"{studio.path}/sound-history", params=params)
    assert [(one["label"], one["status"] == "gain") for one in history] == [
        ("483", False), ("482", True), ("481", False), ("480", False),
    ]  # fmt: skip
    assert studio.states()["heard"] == 1


@pytest.mark.slow
def test_into_the_game_and_back(
    server: RunningServer, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    project = write_game(tmp_path / "game", SOUNDS, {"ui_confirm": -4.0})
    studio = Studio(server, Game(project, "ui_confirm.wav", "ui_confirm", -4.0))
    studio.use_spec_of_the_game(RATE, 24)
    with studio.game_team(monkeypatch, capsys) as team:
        play_it_through(studio, team, sound(77))
    cues = studio.cues()
    assert {name: cue["stems"] for name, cue in cues.items()} == {
        "laser fire": ["laser_fire_01", "laser_fire_02"],
        "ui confirm": ["ui_confirm"],
    }
    assert [cue["trigger"] for cue in cues.values()] == ["Play_laser_fire", "Play_ui_confirm"]


@pytest.fixture
def real_game(tmp_path: Path) -> Game:
    """A copy of a real project of Wwise whose sounds are there, from the folder that MIDDLEWARE_DIR names."""
    folder = os.environ.get("MIDDLEWARE_DIR", "")
    for place in sorted(Path(folder).rglob("*.wproj")) if folder else []:
        there = {path.name for path in (place.parent / "Originals" / "SFX").glob("*.wav")}
        played = [one for one in audio_checks.read_project(place).played if one.file.rpartition("/")[2] in there]
        for one in played:
            if len(one.parts) == 1 and one.parts[0].property == "Volume":
                shutil.copytree(place.parent, tmp_path / "game", copy_function=shutil.copyfile)
                name, holder = one.file.rpartition("/")[2], one.parts[0].object_path.rpartition("\\")[2]
                unplayed = len(there) - len({other.file for other in played if other.is_used is not False})
                return Game(tmp_path / "game" / place.name, name, holder, one.parts[0].gain_db, unplayed)
    pytest.skip("MIDDLEWARE_DIR does not name a folder with a project of Wwise, its sounds and a volume")


@pytest.mark.slow
def test_a_real_project_of_wwise(
    server: RunningServer, real_game: Game, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    studio = Studio(server, real_game)
    studio.use_spec_of_the_game(RATE, 16)
    with studio.game_team(monkeypatch, capsys) as team:
        play_it_through(studio, team, wav_bytes(noise(dbfs=-24, seconds=0.5, rate=RATE, seed=7), rate=RATE, bits=16))
