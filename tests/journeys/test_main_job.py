"""The main job from posting to pack: a producer, an audio director who decides, a sound designer, and the game's CI."""

import csv
import io
import json
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import audio_checks
from audio_checks.cli import main as audio_checks_command
from tests.journeys.people import Designer, Team
from tests.support.server import RunningServer
from tests.support.waves import noise, sine, wav_bytes

pytestmark = pytest.mark.both_databases

LIST = """Filename;Category;What it is;Length (s);Loop;Variations
laser_fire;weapon;The player's turret;0,3;no;2
engine_idle_loop;vehicle;Own ship at rest;1,0;yes;1
door_close;foley;The inner door;0,5;no;1
"""
SHIELD = "shield_hit"


def fading(hz: float, seconds: float, seed: int = 1) -> np.ndarray:
    """A short sound that begins at once and dies away."""
    samples = sine(hz=hz, dbfs=-6, seconds=seconds, rate=96_000) + noise(
        dbfs=-30, seconds=seconds, rate=96_000, seed=seed
    )
    frames = len(samples)
    return (
        samples * np.exp(-4 * np.arange(frames) / frames)[:, None] * np.cos(np.linspace(0, np.pi / 2, frames))[:, None]
    )


def loop(hz: float, seconds: float) -> np.ndarray:
    """A tone that meets its own beginning."""
    return sine(hz=hz, dbfs=-12, seconds=seconds, rate=48_000)


class Studio:
    """The people of one journey and the project they make."""

    def __init__(self, server: RunningServer, preset: str = "44k1") -> None:
        self.server = server
        self.producer, self.director, self.designer = Team(server), Team(server), Designer(server)
        self.id = self.producer.sign_up("Journey studio")
        invitation = {"email": self.director.address, "roles": ["liaison"]}
        self.producer.ask("POST", f"/studios/{self.id}/invitations", json=invitation)
        director_id = self.director.join("Audio director")
        project = {"studio_id": self.id, "name": "Shield Wing", "cue_prefix": "SW", "preset": preset}
        self.project = self.producer.ask("POST", "/projects", json=project)["id"]
        self.path = f"/projects/{self.project}"
        self.producer.ask("PUT", f"{self.path}/liaisons/{director_id}")
        why = {"person_id": director_id, "reason": "hears best"}
        self.producer.ask("PUT", f"{self.path}/approver", json=why)

    def invite_designer(self) -> dict[str, Any]:
        """Invite the designer and return what the link shows."""
        body = {"email": self.designer.address, "kind": "contract", "note": ""}
        self.producer.ask("POST", f"{self.path}/invitations", json=body)
        return self.designer.look()

    def queue(self) -> dict[str, list[dict[str, Any]]]:
        """Return what waits for the approver, by cue, once the worker is done."""
        self.server.wait_for_jobs(120)
        items = self.director.ask("GET", "/review-queue", params={"project_id": self.project, "limit": 200})["items"]
        return {item["cue"]["name"]: item["takes"] for item in items}

    def states(self) -> dict[str, str]:
        """Return the state of every take by its file name."""
        self.server.wait_for_jobs(120)
        takes = self.producer.ask("GET", f"{self.path}/takes", params={"limit": 200})["items"]
        return {take["file_name"]: take["state"] for take in reversed(takes)}

    def cue_id(self, name: str) -> str:
        """Return a cue's id."""
        cues = self.producer.ask("GET", f"{self.path}/sound-list")["cues"]
        return str(next(cue["id"] for cue in cues if cue["name"] == name))

    def pack(self, target: str, folder: Path, *, masters: bool = False) -> Path:
        """Download and unpack the approved pack of a target."""
        params = {"target": target, "masters": masters}
        content = self.producer.ask("GET", f"{self.path}/pack.zip", params=params)
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            assert archive.testzip() is None
            archive.extractall(folder)
        return folder


def test_from_posting_to_pack(server: RunningServer, tmp_path: Path):
    studio = Studio(server)
    producer, director, designer = studio.producer, studio.director, studio.designer

    # The list comes from a spreadsheet, tried dry first; one cue is typed.
    ask = {"format": "csv", "text": LIST, "match": "name"}
    dry = producer.ask("POST", f"{studio.path}/sound-list/import", json=ask | {"dry_run": True})
    assert (dry["added"], dry["errors"], dry["imported"]) == (3, [], False)
    mapping = {column["name"]: column["field"] for column in dry["columns"]}
    mapping |= {"What it is": "description"}
    done = producer.ask("POST", f"{studio.path}/sound-list/import", json=ask | {"dry_run": False, "mapping": mapping})
    assert done["imported"]
    typed = {"cues": [{"name": SHIELD, "duration_s": 0.8, "category": "weapon", "reverb": "dry"}]}
    producer.ask("POST", f"{studio.path}/cues", json=typed)

    # The link shows the list before any account; the first upload asks for one.
    shown = studio.invite_designer()
    assert [cue["name"] for cue in shown["cues"]] == ["laser_fire", "engine_idle_loop", "door_close", SHIELD]
    assert designer.refused("POST", f"{studio.path}/deliveries", json={"note": ""})["status"] == 401
    designer.accept()

    # Files arrive; the name says which cue they are for.
    delivery = designer.open_delivery(studio.project, "first batch")
    too_loud = np.concatenate([np.zeros((20_000, 1)), fading(200, 0.4) * 3]).clip(-1, 1)
    files = {
        "laser_fire_01.wav": wav_bytes(fading(900, 0.3), rate=96_000, bits=24),
        "laser_fire_02.wav": wav_bytes(fading(950, 0.3, seed=2), rate=96_000, bits=24),
        "engine_idle_loop.wav": wav_bytes(loop(120, 1.0), rate=48_000, bits=24),
        "door_close.wav": wav_bytes(too_loud, rate=96_000, bits=24),
        "shield_hit.wav": wav_bytes(fading(500, 0.8), rate=96_000, bits=24),
        "shield_hit_altB.wav": wav_bytes(fading(450, 0.8, seed=3), rate=96_000, bits=24),
        "My final sting.wav": wav_bytes(fading(700, 0.5), rate=96_000, bits=24),
    }
    takes = {name: designer.deliver(delivery, name, content) for name, content in files.items()}
    stray = takes["My final sting.wav"]
    assert stray["cue"] is None
    assert len(designer.ask("GET", f"/takes/{stray['id']}")["guesses"]) <= 3
    states = studio.states()
    assert states["door_close.wav"] == "returned"
    assert {name for name, state in states.items() if state == "conforming"} >= {"laser_fire_01.wav", "shield_hit.wav"}

    # What came back says what was found, what was wanted, where, and how to fix it.
    check = designer.ask("GET", f"/takes/{takes['door_close.wav']['id']}/check")
    found = {finding["code"]: finding for finding in check["findings"]}
    peak = found["sample-peak:over"]
    assert (peak["severity"], peak["measured"], peak["limit"], peak["unit"]) == ("error", 0.0, -0.1, "dBFS")
    assert peak["fix"]
    head = found["head-silence:long"] if "head-silence:long" in found else found["head-silence:over"]
    assert abs(head["measured"] - 20_000 / 96) < 1  # 20,000 frames at 96 kHz

    # The approver hears the rest: picks an alternate, accepts a set, asks for a change.
    queue = studio.queue()
    assert set(queue) == {"laser_fire", "engine_idle_loop", SHIELD}
    assert [take["alternate"] for take in queue[SHIELD]] in ([None, 2], [2, None])
    director.ask("POST", f"/cues/{studio.cue_id('laser_fire')}/accept-set", json={"note": "good"})
    second = next(take for take in queue[SHIELD] if take["alternate"] == 2)
    director.ask("POST", f"/takes/{second['id']}/verdict", json={"kind": "approve", "note": ""})
    engine = queue["engine_idle_loop"][0]["id"]
    change = {"kind": "request_change", "note": "Less of the whine", "start_s": 0.4, "end_s": 0.6}
    director.ask("POST", f"/takes/{engine}/verdict", json=change)
    assert studio.states()["engine_idle_loop.wav"] == "conforming"  # a draft changes nothing yet
    director.ask("POST", f"{studio.path}/feedback", json={"note": ""})
    states = studio.states()
    assert states["engine_idle_loop.wav"] == "change_requested"
    assert (states["shield_hit.wav"], states["shield_hit_altB.wav"]) == ("set_aside", "approved")

    # The designer sees it and sends the next takes.
    came_back = designer.ask("GET", f"{studio.path}/desk")["came_back"]
    by_file = {take["file_name"]: take for take in came_back}
    assert by_file["engine_idle_loop.wav"]["changes"][0]["text"] == "Less of the whine"
    assert by_file["engine_idle_loop.wav"]["round"] == 1
    again = designer.open_delivery(studio.project, "second batch")
    designer.deliver(again, "engine_idle_loop.wav", wav_bytes(loop(100, 1.0), rate=48_000, bits=24))
    designer.deliver(again, "door_close.wav", wav_bytes(fading(200, 0.5), rate=96_000, bits=24))
    for takes_of_cue in studio.queue().values():
        for take in takes_of_cue:
            director.ask("POST", f"/takes/{take['id']}/verdict", json={"kind": "approve", "note": ""})

    # A question joins its cue; a cue is cut with its reason; a placeholder is counted.
    door = studio.cue_id("door_close")
    question = designer.ask("POST", f"/cues/{door}/questions", json={"text": "Steel or wood?"})
    director.ask("POST", f"/questions/{question['id']}/answer", json={"text": "Steel.", "joins": True})
    assert "Steel." in producer.ask("GET", f"/cues/{door}")["description"]

    # The pack holds the renders under the names that the game expects.
    pack = studio.pack("handheld", tmp_path / "handheld", masters=True)
    names = sorted(path.name for path in pack.rglob("*.wav") if "masters" not in path.parts)
    expected = ["door_close.wav", "engine_idle_loop.wav", "laser_fire_01.wav", "laser_fire_02.wav", "shield_hit.wav"]
    assert names == expected
    for path in pack.rglob("*.wav"):
        if "masters" not in path.parts:
            facts = audio_checks.measure_file(path).facts
            assert (facts["sample_rate_hz"], facts["bit_depth"], facts["channels"]) == (22_050, 16, 1)
    masters = {path.name: path.read_bytes() for path in pack.rglob("*.wav") if "masters" in path.parts}
    assert files["laser_fire_01.wav"] in masters.values()  # as delivered, to the byte
    key = list(csv.DictReader(io.StringIO(producer.ask("GET", f"{studio.path}/documentation-key.csv").decode())))
    assert len(key) >= 5

    # The game's CI gives the same verdict with the same spec and list, and posts its report.
    game = studio.pack("game", tmp_path / "game")
    token = producer.ask("POST", f"{studio.path}/tokens", json={
        "name": "CI", "scopes": ["spec:read", "list:read", "checks:write"]})["secret"]  # fmt: skip
    build = server.browser()
    build.headers["Authorization"] = f"Bearer {token}"
    (tmp_path / "spec.toml").write_bytes(build.get(f"/v1{studio.path}/spec.toml").content)
    (tmp_path / "sounds.csv").write_bytes(build.get(f"/v1{studio.path}/sound-list.csv").content)
    command = ["check", "--spec", str(tmp_path / "spec.toml"), "--list", str(tmp_path / "sounds.csv"),
               "--target", "game", "--no-progress", "--format", f"json:{tmp_path / 'report.json'}"]  # fmt: skip
    assert audio_checks_command([*command, str(game)]) == 0
    (game / "laser_fire_02.wav").write_bytes(files["laser_fire_02.wav"])  # a master put straight into the game
    assert audio_checks_command([*command, str(game)]) == 1
    report = json.loads((tmp_path / "report.json").read_text())
    posted = build.post(f"/v1{studio.path}/builds", json={"label": "483", "target": "game", "report": report})
    assert posted.status_code == 201, posted.text
    builds = producer.ask("GET", f"{studio.path}/overview")["builds"]
    assert (builds[0]["label"], builds[0]["rejected"]) == ("483", 1)


def test_the_server_and_the_command_line_say_the_same(server: RunningServer, tmp_path: Path):
    studio = Studio(server)
    studio.producer.ask("POST", f"{studio.path}/cues", json={"cues": [{"name": "door_close", "duration_s": 0.5}]})
    studio.invite_designer()
    studio.designer.accept()
    delivery = studio.designer.open_delivery(studio.project)
    loud = wav_bytes((fading(200, 0.5) * 3).clip(-1, 1), rate=96_000, bits=24)
    take = studio.designer.deliver(delivery, "door_close.wav", loud)
    server.wait_for_jobs()
    on_server = studio.designer.ask("GET", f"/takes/{take['id']}/check")
    (tmp_path / "door_close.wav").write_bytes(loud)
    (tmp_path / "spec.toml").write_bytes(studio.producer.ask("GET", f"{studio.path}/spec.toml"))
    (tmp_path / "sounds.csv").write_bytes(studio.producer.ask("GET", f"{studio.path}/sound-list.csv"))
    out = tmp_path / "report.json"
    command = ["check", "--spec", str(tmp_path / "spec.toml"), "--list", str(tmp_path / "sounds.csv"), "--no-progress"]
    code = audio_checks_command([*command, "--format", f"json:{out}", str(tmp_path / "door_close.wav")])
    file = json.loads(out.read_text())["files"][0]
    assert code == 1
    assert file["verdict"] == on_server["verdict"] == "rejected"
    said = [(finding["code"], finding["severity"], finding["measured"]) for finding in file["findings"]]
    assert said == [(finding["code"], finding["severity"], finding["measured"]) for finding in on_server["findings"]]


@pytest.mark.slow
def test_real_recordings_go_all_the_way(server: RunningServer, real_masters: list[Path], tmp_path: Path):
    studio = Studio(server)
    producer, director, designer = studio.producer, studio.director, studio.designer
    spec = producer.ask("GET", f"{studio.path}/spec")
    toml = spec["toml"] + "\n[targets.trailer]\nsample_rate_hz = 48000\nbit_depth = 24\n"
    change = {"toml": toml, "note": "a trailer at 48 kHz", "based_on_version": spec["version"]}
    warned = producer.ask("PUT", f"{studio.path}/spec", json=change)["warnings"]
    assert any("trailer" in warning for warning in warned)
    masters = real_masters[::6]  # a dozen of the seventy-two
    cues = [{"name": path.stem, "duration_s": round(audio_checks.measure_file(path).facts["duration_s"], 3)}
            for path in masters]  # fmt: skip
    producer.ask("POST", f"{studio.path}/cues", json={"cues": cues})
    studio.invite_designer()
    designer.accept()
    delivery = designer.open_delivery(studio.project)
    for path in masters:
        designer.deliver(delivery, path.name, path.read_bytes())
    queue = studio.queue()
    assert queue, "not one real recording conforms to the field's defaults"
    for takes in queue.values():
        refused = {
            render["target"]: render["refusal"] for render in takes[0]["renders"] if render["state"] == "refused"
        }
        assert set(refused) == {"trailer"}
        assert "44100" in refused["trailer"].replace(",", "").replace(" ", "")
        director.ask("POST", f"/takes/{takes[0]['id']}/verdict", json={"kind": "approve", "note": ""})
    pack = studio.pack("game", tmp_path / "game")
    assert {path.stem for path in pack.rglob("*.wav")} == set(queue)
    returned = [name for name, state in studio.states().items() if state == "returned"]
    assert len(returned) + len(queue) == len(masters)
