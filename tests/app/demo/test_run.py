"""`soundlist demo`: one process tree that makes its project by requests, keeps it, and stops cleanly."""

import fcntl
import os
import signal
import socket
import sqlite3
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from pathlib import Path

import httpx
import pytest
from click.testing import Result
from typer.testing import CliRunner

from app.accounts.authentication import DEMO_COOKIE
from app.cli import cli
from tests.support.waiting import until

ROOT = Path(__file__).resolve().parents[3]
FIRST_START_S, SECOND_START_S, STOP_S = 300.0, 120.0, 25.0
HEARD = "baked-reverb:heard"
STATES = {
    "ui_confirm.wav": "approved",
    "laser_fire_04.wav": "approved",
    "amb_bridge_loop.wav": "approved",
    "hull_impact_03.wav": "approved",
    "shield_hit.wav": "conforming",
    "shield_hit_altB.wav": "conforming",
    "shield_hit_altC.wav": "conforming",
    "foot_deck_walk_06.wav": "approved",
    "airlock_cycle.wav": "returned",
    "thruster_burst_03.wav": "conforming",
}


def free_port() -> int:
    with socket.create_server(("127.0.0.1", 0)) as probe:
        return int(probe.getsockname()[1])


def children_of(pid: int) -> set[int]:
    found: set[int] = set()
    for task in Path(f"/proc/{pid}/task").glob("*/children"):
        for child in task.read_text().split():
            found |= {int(child)} | children_of(int(child))
    return found


def started(data: Path, port: int) -> tuple[subprocess.Popen[bytes], Path]:
    """Start the demo; return its process and its log."""
    environment = os.environ | {"SOUNDLIST_DATA_DIR": str(data), "PYTHONPATH": str(ROOT), "PYTHONUNBUFFERED": "1"}
    log = data.with_suffix(".log")
    with log.open("a") as out:
        command = [sys.executable, "-m", "app", "demo", "--port", str(port)]
        return subprocess.Popen(command, cwd=ROOT, env=environment, stdout=out, stderr=out), log


def kill_while_project_is_made(data: Path, port: int) -> None:
    """Start the demo, and kill its first process alone while the project is made; the others end with it."""
    process, log = started(data, port)
    until(lambda: "Agreeing on the contract" in log.read_text() or process.poll() is not None, FIRST_START_S)
    assert process.poll() is None, log.read_text()
    tree = children_of(process.pid)
    assert len(tree) >= 2
    process.kill()
    process.wait(STOP_S)
    until(lambda: not any(Path(f"/proc/{pid}/cmdline").exists() for pid in tree))


@contextmanager
def demo(data: Path, port: int, started_within_s: float) -> Iterator[httpx.Client]:
    process, log = started(data, port)
    before = log.read_text().count("Soundlist is at")

    try:
        with httpx.Client(base_url=f"http://127.0.0.1:{port}", timeout=300) as client:
            until(
                lambda: log.read_text().count("Soundlist is at") > before or process.poll() is not None,
                started_within_s,
            )
            assert process.poll() is None, log.read_text()
            yield client
    finally:
        tree = children_of(process.pid)
        process.send_signal(signal.SIGTERM)
        assert process.wait(STOP_S) == 0, log.read_text()
        until(lambda: not any(Path(f"/proc/{pid}/cmdline").exists() for pid in tree))


@pytest.mark.slow
@pytest.mark.timeout(780)  # all starts and stops, each with its own bound
def test_the_demo_is_made_kept_and_stopped(tmp_path: Path):
    data, port = tmp_path / "data", free_port()
    data.mkdir()
    with closing(sqlite3.connect(data / "soundlist.sqlite")) as old:  # of a version before the release
        old.executescript("create table alembic_version (version_num); insert into alembic_version values ('0078')")
    kill_while_project_is_made(data, port)
    with demo(data, port, FIRST_START_S) as client:
        (project,) = client.get("/v1/projects").json()["items"]
        path = f"/v1/projects/{project['id']}"
        takes = client.get(f"{path}/takes", params={"limit": 200}).json()["items"]
        states = {take["file_name"]: take["state"] for take in takes}
        assert STATES.items() <= states.items()
        suit = sorted((take["number"], take["state"]) for take in takes if take["file_name"] == "suit_hit.wav")
        assert suit == [(1, "change_requested"), (2, "conforming")]
        (stray,) = [take for take in takes if take["cue"] is None]
        assert stray["file_name"] == "final_FINAL_sting2.wav"
        assert next(guess["name"] for guess in stray["guesses"]) == "victory_sting"
        counts = client.get(f"{path}/sound-list/counts").json()["counts"]
        assert counts == {
            "accepted": 12, "to_review": 7, "returned": 1, "question": 1, "placeholder": 1, "cut": 1, "to_make": 12,
            "change_requested": 1,
        }  # fmt: skip
        references = client.get(f"{path}/references").json()["items"]
        kinds = {row["cue"]["name"]: (row["version"]["kind"], row["version"]["preview"]) for row in references}
        assert kinds == {
            "vo_oath": ("text", "none"), "shield_hit": ("audio", "none"), "coolant_splash": ("picture", "made"),
            "warp_in": ("video", "none"),
        }  # fmt: skip
        lines = client.get(f"{path}/voice-lines", params={"language": "de"}).json()["lines"]
        assert (len(lines), [line["key"] for line in lines if line["length_is_off"]]) == (6, ["captain_020"])
        pick_ups = client.get(f"{path}/pick-ups", params={"language": "en"}).json()["lines"]
        assert {line["key"]: line["state"] for line in pick_ups} == {
            "captain_010": "stale", "mate_010": "no_take", "mate_020": "no_take", "captain_030": "no_take",
            "mate_030": "no_take",
        }  # fmt: skip
        part = next(take["id"] for take in takes if take["file_name"] == "thruster_burst_03.wav")
        split_from = client.get(f"/v1/takes/{part}/split").json()["split_from"]
        assert (split_from["file_name"], split_from["start_s"] > 3) == ("thruster_burst.wav", True)
        thruster = next(take["cue"]["id"] for take in takes if take["file_name"] == "thruster_burst_03.wav")
        standing = client.get(f"{path}/sound-list/progress").json()
        (row,) = [row for row in standing["cues"] if row["cue_id"] == thruster]
        assert row["worst_finding"]["message"] == "_03 is 4.0 LU louder than the rest of its set, limit 2 LU"
        (row,) = [row for row in standing["cues"] if row["worst_finding"] and row["worst_finding"]["code"] == HEARD]
        assert row["worst_finding"]["message"].startswith("reverb of about 1.")
        asked = {row["worst_finding"]["code"] for row in standing["cues"] if row["worst_finding"]}
        assert {"upsampled:cliff", "reversed:heard"} <= asked
        queue = client.get("/v1/review-queue", params={"project_id": project["id"]}).json()["items"]
        assert {item["cue"]["name"]: item["last_change"] for item in queue}["suit_hit"] == "Add a dull metallic clank"
        ensure_money(client, path, next(item["cue"]["id"] for item in queue if item["cue"]["name"] == "shield_hit"))
        ensure_hired(client, path)
        ensure_no_empty_page(client, path, project["studio"]["id"])
        with closing(sqlite3.connect(data / "soundlist.sqlite")) as database:
            assert database.execute("select role, is_on from scenes_beds").fetchall() == [("ambience", 1)]
        builds = client.get(f"{path}/builds").json()["items"]
        assert [(build["label"], build["rejected"]) for build in builds] == [("482", 1), ("481", 0)]
        audits = client.get(f"{path}/audits").json()["items"]
        assert [(audit["label"], audit["drifted"], audit["new_drifts"]) for audit in audits] == [
            ("482", 6, 6),
            ("481", 0, 0),
        ]
        drifted = client.get(f"/v1/audits/{audits[0]['id']}/sounds", params={"drifted": True}).json()["items"]
        steps = {(one["cue"]["name"], one["moves"][0]["property"], round(one["gain_db"], 1)) for one in drifted}
        assert steps == {("foot_deck_walk", "Volume", 6.0)}
        # The check knows the list, as the printed CI lines do: no approved loop is called cut off.
        assert builds[1]["warnings"] == 0
        # Nobody enters the demo but from this machine, directly.
        for header in ({"Host": "soundlist.example"}, {"X-Forwarded-For": "203.0.113.9"}):
            assert client.get("/v1/me", headers=header).status_code == 401
        assert (data / "secret_key").stat().st_mode & 0o777 == 0o600
    with demo(data, port, SECOND_START_S) as client:  # what was done is kept, and made only once
        assert len(client.get("/v1/projects").json()["items"]) == 1
        assert client.get(f"{path}/sound-list/counts").json()["counts"] == counts


def ensure_money(client: httpx.Client, path: str, shield_id: str) -> None:
    """Hold the demo's contract to the figures that its screens were drawn with."""
    as_producer = {"Cookie": f"{DEMO_COOKIE}=producer"}  # who comes in without choosing decides, and sees no slip
    (contract,) = client.get(f"{path}/money", headers=as_producer).json()["contracts"]
    assert contract["figures"] == {
        "agreed_minor": 720_000, "accepted_minor": 375_750, "paid_minor": 288_000,
        "due_minor": 87_750, "open_minor": 328_500, "saved_minor": 15_750,
    }  # fmt: skip
    milestones = [(one["name"], one["accepted"], one["wanted"], one["left_minor"]) for one in contract["milestones"]]
    assert milestones == [
        ("Deposit", 0, 0, 144_000),
        ("Palette", 6, 6, 144_000),
        ("Alpha", 4, 10, 180_000),
        ("Beta", 0, 7, 236_250),
    ]
    assert [(slip["name"], slip["days"]) for slip in contract["slips"]] == [("Palette", 0)]  # in time
    assert contract["last_days_to_pay"] == 0
    (extra,) = contract["proposed_rounds"]
    assert (extra["cue"]["name"], extra["number"], extra["included"], extra["amount_minor"]) == (
        "missile_launch", 3, 2, 7_875,
    )  # fmt: skip
    mine = next(cue for one in contract["milestones"] for cue in one["cues"] if cue["cue"]["name"] == "mine_arm")
    assert (mine["cut_in"], mine["owed_minor"]) == ("in_work", 15_750)
    shield = client.get(f"/v1/cues/{shield_id}/money").json()
    assert (shield["accepted_then"], shield["wanted"], shield["would_owe_minor"]) == (5, 10, 18_000)


def ensure_hired(client: httpx.Client, path: str) -> None:
    """Hold the demo to a posting with two bids, whose award opened its contract, and to a draft that is divided."""
    as_producer = {"Cookie": f"{DEMO_COOKIE}=producer"}
    (posting,) = client.get(f"{path}/postings", headers=as_producer).json()
    assert (posting["title"], posting["state"], posting["bids"]) == ("Effects", "awarded", 2)
    compared = client.get(f"/v1/postings/{posting['id']}/bids", headers=as_producer).json()
    chosen, other = compared["bids"]
    assert (chosen["designer"]["name"], other["designer"]["name"]) == ("Sound designer", "Second designer")
    assert compared["awarded_bid_id"] == chosen["id"]
    assert (chosen["is_shortlisted"], chosen["missing"], other["missing"]) == (True, [], [])
    assert chosen["over_budget_minor"] <= 0 < other["over_budget_minor"]
    assert [chosen["scored_by"], other["scored_by"]] == [2, 2]
    contracts = client.get(f"{path}/contracts", headers=as_producer).json()
    assert {contract["title"]: contract["state"] for contract in contracts} == {
        "Effects": "agreed", "Voice lines": "draft", "Voice lines, Second designer": "draft",
    }  # fmt: skip
    ids = {contract["title"]: contract["id"] for contract in contracts}
    assert ids["Effects"] == compared["contract_id"]
    shared = client.get(f"/v1/contracts/{ids['Voice lines']}", headers=as_producer).json()["joint"]
    assert {part["designer"]["name"]: part["amount_minor"] for part in shared} == {
        "Sound designer": 18_000, "Second designer": 27_000,
    }  # fmt: skip


@pytest.fixture
def say(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., Result]:
    """Run a command in this process; what it is set to comes by environment alone."""
    monkeypatch.setenv("SOUNDLIST_DATA_DIR", str(tmp_path))

    monkeypatch.setattr("app.logs.configure", lambda _: None)  # of this whole process

    def run(*command: str, **environment: str) -> Result:
        for name, value in environment.items():
            monkeypatch.setenv(name, value)
        return CliRunner().invoke(cli, command)

    return run


def test_two_demos_do_not_share_a_folder(tmp_path: Path, say: Callable[..., Result]):
    with (tmp_path / "soundlist.lock").open("a") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        second = say("demo", "--port", str(free_port()))
    assert second.exit_code == 2
    assert "is in use by another soundlist demo" in second.output
    assert "DATA=another-folder" in second.output


@pytest.mark.parametrize(
    ("command", "environment", "said"),
    [
        (["serve"], {}, "SOUNDLIST_SECRET_KEY is not set"),
        (["worker"], {}, "SOUNDLIST_SECRET_KEY is not set"),
        (["migrate"], {"SOUNDLIST_BASE_URL": "sounds.example"}, "give the address people open"),
        (["migrate"], {"SOUNDLIST_STORE_URL": "ftp://x"}, "s3://"),
        (["serve", "--host", "0.0.0.0"], {"SOUNDLIST_DEMO": "1", "SOUNDLIST_SECRET_KEY": "x" * 16}, "127.0.0.1 only"),  # noqa: S104
    ],
)
def test_wrong_settings_are_refused_with_a_reason(
    say: Callable[..., Result], command: list[str], environment: dict, said: str
):
    result = say(*command, **environment)
    assert result.exit_code == 2
    assert said in result.output
    assert "Traceback" not in result.output


def ensure_no_empty_page(client: httpx.Client, path: str, studio_id: str) -> None:
    """Hold the demo to one of each thing that a visitor would otherwise meet an empty page for."""
    client.cookies.set(DEMO_COOKIE, "producer")
    roster = client.get(f"/v1/studios/{studio_id}/roster").json()["items"]
    assert {entry["name"] for entry in roster} == {"Sound designer", "Second designer"}
    (playlist,) = client.get(f"{path}/playlists").json()
    assert playlist["name"] == "Palette, for the kick-off"
    (webhook,) = client.get(f"/v1/studios/{studio_id}/webhooks").json()["items"]
    assert webhook["disabled_at"] is not None
    contract = next(each for each in client.get(f"{path}/contracts").json() if each["title"] == "Effects")
    redlines = client.get(f"/v1/contracts/{contract['id']}").json()["redlines"]
    assert (redlines["rounds"], redlines["count"], redlines["unanswered"]) == (1, 1, 0)
    listening = client.get(f"{path}/listening-pass").json()["listening_pass"]
    assert {note["cue"]["name"]: note["said"] for note in listening["notes"]} == {
        "foot_deck_walk": "too-loud", "radar_ping": "good",
    }  # fmt: skip
    client.cookies.clear()
