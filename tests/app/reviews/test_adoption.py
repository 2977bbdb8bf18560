"""A folder of shipped files becomes cues with approved takes, and goes again while nothing was built on it."""

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
import sqlalchemy as sa

from app.conformance.models import CheckRun
from app.deliveries.models import Adoption, Take, TakeCounts
from app.notifications.models import Mail
from app.reviews.models import Verdict
from tests.support.adoptions import adopt, adopted, folder, opened, plan, send, sent, undo
from tests.support.deliver import add_cues, deliver
from tests.support.server import World
from tests.support.waves import noise, sine, wav_bytes

pytestmark = pytest.mark.both_databases
RATE = 44_100


def sound(seed: int, **more: Any) -> bytes:
    """A short sound as a game ships it: 16 bit, and of the target's rate."""
    return wav_bytes(noise(dbfs=-24, seconds=0.3, rate=RATE, seed=seed), rate=RATE, bits=16, **more)


FILES = {
    "ui/click.wav": sound(1),
    "ui/Menu Open.wav": sound(2),
    "steps/grass_01.wav": sound(3),
    "steps/grass_02.wav": sound(4),
    "steps/grass_03.wav": sound(5),
}


def cues_of(world: World) -> list[dict[str, Any]]:
    answer = world.producer.get(f"/v1/projects/{world.project_id}/sound-list")
    assert answer.status_code == 200, answer.text
    return list(answer.json()["cues"])


def rows(world: World, model: type[Any]) -> list[Any]:
    found = sa.select(model).where(model.project_id == world.project_id)
    return list(world.server.in_database(lambda session: session.scalars(found).all()))


def review(world: World, cue_id: str) -> dict[str, Any]:
    answer = world.producer.get(f"/v1/cues/{cue_id}/review")
    assert answer.status_code == 200, answer.text
    return dict(answer.json())


@pytest.mark.slow
def test_a_folder_becomes_cues_with_approved_takes_and_their_checks(world: World) -> None:
    answer = adopted(world, FILES)
    assert (answer["cues"], answer["takes"], answer["adopted_by"]["name"]) == (3, 5, "Producer")
    found = {cue["name"]: (cue["file_name"], cue["category"], cue["variations"]) for cue in cues_of(world)}
    assert found == {
        "click": ("click", "ui", 1), "Menu Open": ("Menu Open", "ui", 1), "grass": ("grass", "steps", 3),
    }  # fmt: skip
    grass = next(cue for cue in cues_of(world) if cue["name"] == "grass")
    shown = review(world, grass["id"])
    assert (shown["accepted"], shown["approved_variations"], shown["rounds"]) == (True, [1, 2, 3], [])
    assert [one["state"] for one in shown["takes"]] == ["approved"] * 3
    assert {(one["kind"], one["by_adoption"], one["given_by"]["name"]) for one in shown["verdicts"]} == {
        ("approve", True, "Producer")
    }
    history = world.producer.get(f"/v1/takes/{shown['takes'][0]['id']}/history").json()
    assert sorted((one["kind"], one["by_adoption"]) for one in history) == [
        ("approve", True), ("checked", False), ("received", False),
    ]  # fmt: skip
    assert {row.verdict for row in rows(world, CheckRun)} <= {"conforming", "rejected"}
    assert len(rows(world, CheckRun)) == 5
    masters = {row.file_name: row.master_sha256 for row in rows(world, Take)}
    assert masters == {one["path"].rpartition("/")[2]: one["sha256"] for one in folder(FILES)["files"]}


@pytest.mark.slow
def test_a_file_that_breaks_the_spec_is_adopted_with_its_verdict_beside_it(world: World) -> None:
    files = {**FILES, "ui/thump.wav": wav_bytes(sine(hz=200, dbfs=0, seconds=0.3, rate=RATE), rate=RATE, bits=16)}
    adoption = adopted(world, files)
    answer = world.producer.get(f"/v1/adoptions/{adoption['id']}").json()
    assert (answer["takes"], answer["checked"], answer["rendered"]) == (6, 6, 6)
    [thump] = [one for one in answer["odd"] if one["file_name"] == "thump.wav"]
    assert thump["verdict"] == "rejected"
    assert any("dBFS" in message for message in thump["messages"])
    take = next(row for row in rows(world, Take) if row.file_name == "thump.wav")
    check = world.producer.get(f"/v1/takes/{take.id}/check").json()
    assert (check["state"], check["verdict"]) == ("approved", "rejected")


@pytest.mark.slow
def test_a_build_of_the_adopted_folder_is_the_same(world: World, tmp_path: Path) -> None:
    adopted(world, FILES)
    build = tmp_path / "build"
    for path, content in FILES.items():
        (build / path).parent.mkdir(parents=True, exist_ok=True)
        (build / path).write_bytes(content)
    url = f"/v1/projects/{world.project_id}/manifest.json"
    world.producer.get(url, params={"target": "game"})  # asks for what the sounds are known by
    world.server.wait_for_jobs()
    answer = world.producer.get(url, params={"target": "game"})
    assert answer.status_code == 200, answer.text
    (tmp_path / "approved.json").write_text(answer.text)
    command = [sys.executable, "-m", "audio_checks.cli", "audit", "--manifest", str(tmp_path / "approved.json")]
    ran = subprocess.run([*command, "--format", "json", str(build)], check=False, capture_output=True, text=True)
    assert ran.returncode == 0, ran.stderr
    assert [load["status"] for load in json.loads(ran.stdout)["files"]] == ["same"] * 5


def test_the_dry_run_says_what_happens_to_each_file_and_writes_nothing(world: World) -> None:
    add_cues(world, {"name": "Click"})
    files = {**FILES, "music/theme.wma": b"0&", "ui/again.wav": FILES["ui/Menu Open.wav"], "read me.txt": b"x"}
    answer = plan(world, files)
    assert (answer["files"], answer["sets"], answer["categories"]) == (5, 1, {"steps": 1, "ui": 2})
    assert answer["duplicates"] == [["ui/Menu Open.wav", "ui/again.wav"]]
    assert [(one["path"], one["code"]) for one in answer["skipped"]] == [
        ("music/theme.wma", "coded"), ("read me.txt", "no-sound"), ("ui/click.wav", "listed"),
    ]  # fmt: skip
    assert "SW-001" in answer["skipped"][2]["message"]
    assert len(cues_of(world)) == 1
    assert rows(world, Adoption) == []


@pytest.mark.slow
def test_a_cue_of_the_list_keeps_what_it_has(world: World) -> None:
    [cue] = add_cues(world, {"name": "Click"})
    adoption = adopted(world, FILES)
    assert (adoption["cues"], [one["path"] for one in adoption["skipped"]]) == (2, ["ui/click.wav"])
    assert review(world, cue["id"])["takes"] == []


@pytest.mark.slow
def test_only_a_producer_or_the_approver_adopts(world: World) -> None:
    for client, status in ((world.designer, 403), (world.reviewer, 403), (world.stranger, 404)):
        url = f"/v1/projects/{world.project_id}"
        assert client.post(f"{url}/adoption-plan", json=folder(FILES)).status_code == status
        assert client.post(f"{url}/adoptions", json=folder(FILES)).status_code == status
    adoption_id = sent(world, FILES, world.approver)
    for client, status in ((world.designer, 403), (world.reviewer, 403), (world.stranger, 404)):
        assert adopt(world, adoption_id, client).status_code == status
        assert undo(world, adoption_id, client).status_code == status
        assert send(world, adoption_id, "a.wav", FILES["ui/click.wav"], client).status_code == status
    assert adopt(world, adoption_id, world.approver).json()["adopted_by"]["name"] == "Audio director"


def test_nothing_is_adopted_before_every_file_is_there(world: World) -> None:
    adoption = opened(world, FILES)
    assert sorted(adoption["missing"]) == sorted(FILES)
    send(world, adoption["id"], "click.wav", FILES["ui/click.wav"])
    refused = adopt(world, adoption["id"])
    assert (refused.status_code, refused.json()["code"]) == (409, "files-missing")
    assert "4 files" in refused.json()["detail"]
    assert cues_of(world) == []


@pytest.mark.slow
def test_the_same_bytes_are_sent_once_and_count_for_every_file(world: World) -> None:
    content = FILES["ui/click.wav"]
    files = {"ui/click.wav": content, "menu/click.wav": content}
    assert opened(world, files)["missing"] == ["menu/click.wav"]
    assert adopted(world, files)["takes"] == 2
    assert {cue["file_name"] for cue in cues_of(world)} == {"click", "ui_click"}


@pytest.mark.slow
def test_undo_takes_away_what_was_made_and_keeps_the_masters(world: World) -> None:
    add_cues(world, {"name": "Laser"})
    adoption = adopted(world, FILES)
    undone = undo(world, adoption["id"])
    assert undone.status_code == 200, undone.text
    assert undone.json()["undone_at"] is not None
    assert [cue["name"] for cue in cues_of(world)] == ["Laser"]
    assert rows(world, TakeCounts) == []
    takes = rows(world, Take)
    assert len(takes) == 5
    assert all(take.discarded_at is not None and take.cue_id is None for take in takes)
    [record] = rows(world, Adoption)
    assert (record.adopted_by, record.undone_by, len(record.files)) == (world.producer_id, world.producer_id, 5)
    assert undo(world, adoption["id"]).json()["code"] == "already-undone"
    assert adopt(world, adoption["id"]).json()["code"] == "adoption-closed"
    assert adopted(world, FILES)["takes"] == 5  # the same folder again


@pytest.mark.slow
def test_undo_withdraws_each_verdict_and_keeps_it_on_record(world: World) -> None:
    adoption = adopted(world, FILES)
    given = {row.id: (row.cue_id, row.take_id, row.note, row.created_at) for row in rows(world, Verdict)}
    assert undo(world, adoption["id"]).status_code == 200
    verdicts = rows(world, Verdict)
    kept = {
        verdict.id: (verdict.cue_id, verdict.take_id, verdict.note, verdict.created_at)
        for verdict in verdicts
        if verdict.kind == "approve"
    }
    assert kept == given
    withdrawals = [verdict for verdict in verdicts if verdict.kind == "withdraw"]
    assert {withdrawal.withdraws_id for withdrawal in withdrawals} == set(given)
    assert {withdrawal.given_by for withdrawal in withdrawals} == {world.producer_id}
    for take in rows(world, Take):
        history = world.producer.get(f"/v1/takes/{take.id}/history")
        assert history.status_code == 200, history.text
        assert {"approve", "withdraw"} <= {one["kind"] for one in history.json()}
    assert world.producer.get(f"/v1/projects/{world.project_id}/overview").status_code == 200


@pytest.mark.slow
@pytest.mark.parametrize("built", ["a verdict", "a delivery", "a cue"])
def test_undo_is_refused_once_something_was_built_on_it(world: World, built: str) -> None:
    adoption = adopted(world, FILES)
    if built == "a verdict":
        take = rows(world, Take)[0]
        body = {"kind": "request_change", "note": "softer", "seen_state": "approved"}
        assert world.approver.post(f"/v1/takes/{take.id}/verdict", json=body).status_code == 200
    elif built == "a delivery":
        deliver(world, "click.wav", sound(9))
    else:
        add_cues(world, {"name": "Laser"})
    refused = undo(world, adoption["id"])
    assert (refused.status_code, refused.json()["code"]) in [(409, "adoption-in-use"), (409, "addition-in-use")]
    assert len([row for row in rows(world, Take) if row.state == "approved"]) == 5


@pytest.mark.slow
def test_one_adopted_sound_is_not_undone_as_a_click_is(world: World) -> None:
    adopted(world, FILES)
    take = rows(world, Take)[0]
    refused = world.approver.delete(f"/v1/takes/{take.id}/verdict")
    assert (refused.status_code, refused.json()["code"]) == (409, "nothing-to-undo")


@pytest.mark.slow
def test_nobody_is_mailed_for_each_adopted_sound(world: World) -> None:
    adopted(world, FILES)
    mails = world.server.in_database(
        lambda session: session.scalars(sa.select(Mail).where(Mail.studio_id == world.studio_id)).all()
    )
    assert not [mail for mail in mails if "approved" in mail.subject.lower()]


@pytest.mark.slow
@pytest.mark.parametrize(
    "path",
    ["../../etc/passwd.wav", "C:\\game\\con.wav", "=cmd().wav", "a" * 400 + ".wav", "\u202egnp.wav", "x.wav.wav"],
)
def test_hostile_names_become_names_that_a_list_holds(world: World, path: str) -> None:
    files = {path: sound(7), "ui/click.wav": sound(8)}
    assert adopted(world, files)["takes"] == 2
    assert all("/" not in row.file_name for row in rows(world, Take))


def test_a_path_twice_and_a_path_with_a_line_break_are_refused(world: World) -> None:
    body = folder(FILES)
    for files in ([body["files"][0]] * 2, [{**body["files"][0], "path": "a\nb.wav"}]):
        refused = world.producer.post(
            f"/v1/projects/{world.project_id}/adoptions", json={"folder": "Sounds", "files": files}
        )
        assert refused.status_code == 422, refused.text
