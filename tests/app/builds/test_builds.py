"""Reports of the game's CI, the baseline, and the lines that CI runs."""

import json
import os
import subprocess
import sys
import zipfile
from pathlib import Path
from typing import Any
from uuid import uuid4

import pytest
from httpx2 import Client

from tests.app.builds.approved import accepted_list, sound
from tests.app.builds.test_packs import listening
from tests.support.deliver import add_cues, deliver
from tests.support.server import World
from tests.support.waves import join, silence, sine, wav_bytes


def finding(severity: str, **more: Any) -> dict[str, Any]:
    return {"code": "true-peak:over", "severity": severity, "message": "too loud", "fix": "lower it"} | more


def report(*files: dict[str, Any]) -> dict[str, Any]:
    return {
        "schema_version": 1,
        "tool": {"name": "audio-checks", "version": "0.1.0"},
        "spec": {"name": "Shield Wing", "sha256": "0" * 64},
        "files": list(files),
        "summary": {"files": len(files)},
        "not_run": [],
    }


def entry(verdict: str, *findings: dict[str, Any]) -> dict[str, Any]:
    return {"path": "a.wav", "verdict": verdict, "findings": list(findings), "facts": None}


def token(world: World, *scopes: str) -> Client:
    made = world.producer.post(f"/v1/projects/{world.project_id}/tokens", json={"name": "CI", "scopes": list(scopes)})
    assert made.status_code == 201, made.text
    client = world.server.browser()
    client.headers["Authorization"] = f"Bearer {made.json()['secret']}"
    return client


def post(world: World, client: Client, sent: dict[str, Any], label: str = "1") -> Any:
    body = {"label": label, "commit": "abc123", "target": "game", "report": sent}
    return client.post(f"/v1/projects/{world.project_id}/builds", json=body)


@pytest.mark.slow
def test_a_report_is_kept_as_it_came_and_counted_by_us(world: World) -> None:
    sent = report(
        entry("conforming", finding("warning")),
        entry("rejected", finding("error"), finding("warning")),
        entry("rejected", finding("error", waived=True)),
        entry("unreadable", finding("error")),
        entry("unjudged"),
    )
    answer = post(world, token(world, "checks:write"), sent)
    assert answer.status_code == 201, answer.text
    brief = answer.json()
    assert (brief["files"], brief["rejected"], brief["warnings"]) == (5, 3, 2)
    (listed,) = world.reviewer.get(f"/v1/projects/{world.project_id}/builds").json()["items"]
    assert listed == brief
    whole = world.reviewer.get(f"/v1/builds/{brief['id']}").json()
    assert whole["report"] == sent


def broken(path: list[Any], value: Any) -> dict[str, Any]:
    sent: Any = report(entry("rejected", finding("error")))
    place = sent
    for key in path[:-1]:
        place = place[key]
    place[path[-1]] = value
    whole: dict[str, Any] = sent
    return whole


@pytest.mark.parametrize(
    "sent",
    [
        {},
        broken(["schema_version"], 2),
        broken(["tool"], None),
        broken(["files"], "all"),
        broken(["files", 0, "verdict"], "fine"),
        broken(["files", 0, "findings", 0, "severity"], "fatal"),
        broken(["files", 0, "path"], 7),
        broken(["summary"], [1]),
        broken(["files", 0, "facts"], {"note": "zero \0"}),
    ],
)
def test_a_body_that_is_not_a_report_is_refused(world: World, sent: dict[str, Any]) -> None:
    assert post(world, world.producer, sent).status_code == 422
    assert world.producer.get(f"/v1/projects/{world.project_id}/builds").json()["items"] == []


def test_a_number_that_is_none_is_refused(world: World) -> None:
    sent = report(entry("rejected", finding("error", measured=float("nan"))))
    body = json.dumps({"label": "1", "report": sent})
    headers = {"Content-Type": "application/json"}
    url = f"/v1/projects/{world.project_id}/builds"
    assert world.producer.post(url, content=body, headers=headers).status_code == 422


@pytest.mark.slow
def test_builds_are_paged_newest_first(world: World) -> None:
    for number in range(52):
        assert post(world, world.producer, report(), label=str(number)).status_code == 201
    url = f"/v1/projects/{world.project_id}/builds"
    first = world.producer.get(url).json()
    assert [one["label"] for one in first["items"]] == [str(number) for number in range(51, 1, -1)]
    rest = world.producer.get(url, params={"cursor": first["next"]}).json()
    assert ([one["label"] for one in rest["items"]], rest["next"]) == (["1", "0"], None)


@pytest.mark.slow
def test_scopes_and_sight(world: World, server: Any) -> None:
    reader = token(world, "list:read", "spec:read")
    assert post(world, reader, report()).status_code == 403
    assert reader.get(f"/v1/projects/{world.project_id}/baseline.json").status_code == 200
    assert reader.get(f"/v1/projects/{world.project_id}/sound-list.csv").status_code == 200
    assert reader.get(f"/v1/projects/{world.project_id}/pack").status_code == 403
    assert token(world, "manifest:read").get(f"/v1/projects/{world.project_id}/pack").status_code == 200
    elsewhere = token(World(server), "checks:write", "list:read", "manifest:read")
    assert post(world, elsewhere, report()).status_code == 404
    assert elsewhere.get(f"/v1/projects/{world.project_id}/baseline.json").status_code == 404
    assert elsewhere.get(f"/v1/projects/{world.project_id}/pack.zip").status_code == 404
    assert post(world, world.designer, report()).status_code == 403
    build_id = post(world, world.producer, report()).json()["id"]
    for client, status in ((world.designer, 403), (world.stranger, 404), (world.nobody, 401)):
        assert client.get(f"/v1/builds/{build_id}").status_code == status
    assert world.producer.get(f"/v1/builds/{uuid4()}").status_code == 404


@pytest.mark.slow
def test_the_baseline_names_master_and_game_files(world: World) -> None:
    add_cues(world, {"name": "Alarm"})
    loud = wav_bytes(sine(hz=997, dbfs=0.0, seconds=0.5, rate=44_100), rate=44_100, bits=24)
    take = deliver(world, "alarm.wav", loud)
    world.server.wait_for_jobs()
    check = world.designer.get(f"/v1/takes/{take['id']}/check").json()
    assert check["verdict"] == "rejected"
    waived = world.approver.post(f"/v1/takes/{take['id']}/waiver", json={"reason": "it is meant to hurt"})
    assert waived.status_code in (200, 201), waived.text
    world.server.wait_for_jobs()
    url = f"/v1/projects/{world.project_id}/baseline.json"
    reported = world.designer.get(url).json()
    assert reported["format"] == 1
    assert len(reported["waived"]) == 3  # the master, and its game files for two targets
    assert len({one["pcm_sha256"] for one in reported["waived"]}) == 3
    assert {(one["cue"], one["reason"], one["file_name"]) for one in reported["waived"]} == {
        ("SW-001", "it is meant to hurt", "alarm.wav")
    }
    assert all("sample-peak:over" in one["codes"] for one in reported["waived"])
    assert world.stranger.get(url).status_code == 404


@pytest.mark.slow
def test_the_lines_for_ci_do_what_they_say(world: World, tmp_path: Path) -> None:
    accepted_list(world)
    secret = (
        token(world, "spec:read", "list:read", "checks:write", "manifest:read")
        .headers["Authorization"]
        .removeprefix("Bearer ")
    )
    pack = tmp_path / "pack.zip"
    pack.write_bytes(world.producer.get(f"/v1/projects/{world.project_id}/pack.zip").content)
    with zipfile.ZipFile(pack) as archive:
        archive.extractall(tmp_path / "assets")
    reported = world.producer.get(f"/v1/projects/{world.project_id}/ci", params={"target": "game"}).json()["lines"]
    ours = world.server.runtime.settings.base_url

    def run() -> int:
        with listening(world.server.application) as port:
            script = "\n".join(reported).replace(ours, f"http://127.0.0.1:{port}")
            path = f"{Path(sys.executable).parent}:{os.environ['PATH']}"
            environment = {"PATH": path, "SOUNDLIST_TOKEN": secret, "BUILD": "nightly 7", "COMMIT": "abc"}
            done = subprocess.run(
                ["/bin/bash", "-c", script], cwd=tmp_path, env=environment, capture_output=True, timeout=300
            )
            print(done.stdout.decode(), done.stderr.decode())  # noqa: T201  shown when the test fails
            return done.returncode

    assert run() == 0
    broken_file = join(silence(seconds=0.2, rate=22_050), sine(hz=500, seconds=0.2, rate=22_050))
    (tmp_path / "assets" / "laser_fire_01.wav").write_bytes(wav_bytes(broken_file, rate=22_050, bits=16))
    (tmp_path / "assets" / "unasked.wav").write_bytes(sound(99))
    assert run() == 1
    builds = world.producer.get(f"/v1/projects/{world.project_id}/builds").json()["items"]
    assert [(build["label"], build["target"], build["files"]) for build in builds] == [
        ("nightly 7", "game", 4),
        ("nightly 7", "game", 3),
    ]
    assert builds[0]["rejected"] >= 1
    assert builds[1]["rejected"] == 0
