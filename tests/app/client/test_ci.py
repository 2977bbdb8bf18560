"""`soundlist ci`: the checks of a game's build in one command, against a real server and with the real audio-checks."""

import json
import os
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import yaml

from app.client import ci
from app.client.commands import main
from app.client.errors import Refusal
from tests.app.client.served import PATHS, Client, client_of
from tests.support.server import World
from tests.support.waves import join, silence, sine, wav_bytes

SCOPES = ("spec:read", "list:read", "checks:write", "manifest:read")
ROOT = Path(ci.__file__).parents[2]


@pytest.fixture
def building(
    approved: World, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], game: Path
) -> Iterator[Client]:
    """A client that works in the folder of a game whose `assets` have the approved sounds."""
    for variable in (*ci.LABELS, *ci.COMMITS):
        monkeypatch.delenv(variable, raising=False)
    with client_of(approved, monkeypatch, capsys, *SCOPES) as client:
        monkeypatch.chdir(game)
        (game / "assets").mkdir()
        assert client.pull(game / "assets") == 0, client.out
        yield client


def run(client: Client, *options: str, **variables: str) -> tuple[int, str, str]:
    """Run the command as a process of its own, so that what it and audio-checks print is one text."""
    command = [sys.executable, "-P", "-m", "app.client.commands", "ci", "assets", *client.source, *options]
    environment = {**os.environ, "PYTHONPATH": str(ROOT), **variables}
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    return done.returncode, done.stdout, done.stderr


def posted(client: Client, what: str) -> list[dict[str, Any]]:
    """Return what was posted, the newest first."""
    url = f"/v1/projects/{client.world.project_id}/{what}"
    items: list[dict[str, Any]] = client.world.producer.get(url).json()["items"]
    return items


@pytest.mark.slow
def test_a_build_as_it_was_approved(building: Client) -> None:
    options = ("--target", "game", "--fail-level", "warning")
    code, out, err = run(building, *options, GITHUB_RUN_NUMBER="7", GITHUB_SHA="abc")
    assert code == 0, out + err
    assert "3 files: 3 conforming" in out
    build, audit = posted(building, "builds")[0], posted(building, "audits")[0]
    assert {key: build[key] for key in ("label", "commit", "target", "files", "rejected", "warnings")} == {
        "label": "7", "commit": "abc", "target": "game", "files": 3, "rejected": 0, "warnings": 0,
    }  # fmt: skip
    assert (audit["label"], audit["target"]) == ("7", "game")


@pytest.mark.slow
def test_a_broken_sound_fails_and_is_posted(building: Client, game: Path) -> None:
    broken = join(silence(seconds=0.2, rate=22_050), sine(hz=500, seconds=0.2, rate=22_050))
    (game / "assets" / PATHS[0]).write_bytes(wav_bytes(broken, rate=22_050, bits=16))
    report = game / "report.json"
    code, out, _ = run(building, "--label", "nightly", "--format", f"json:{report}")
    assert (code, PATHS[0] in out) == (1, True)
    build = posted(building, "builds")[0]
    assert (build["label"], build["rejected"], build["target"]) == ("nightly", 1, "game")
    assert json.loads(report.read_text())["summary"]["rejected"] == 1


@pytest.mark.slow
def test_nothing_is_posted_or_audited_on_request(building: Client) -> None:
    before = len(posted(building, "builds")), len(posted(building, "audits"))
    code, out, err = run(building, "--no-post", "--no-audit")
    assert code == 0, out + err
    assert (len(posted(building, "builds")), len(posted(building, "audits"))) == before


@pytest.mark.slow
def test_what_cannot_be_done_is_two(building: Client) -> None:
    code, _, err = run(building, "--target", "pc")
    assert (code, 'no target "pc"' in err) == (2, True)
    building.source[1] = "http://127.0.0.1:9"
    assert main(["ci", "assets", *building.source]) == 2


def test_without_audio_checks_it_says_what_to_install(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "executable", str(tmp_path / "python"))
    monkeypatch.setattr("importlib.util.find_spec", lambda _: None)
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(Refusal, match="audio-checks is not installed here"):
        ci.audio_checks_command()
    (tmp_path / "audio-checks").touch(mode=0o755)
    assert ci.audio_checks_command() == [str(tmp_path / "audio-checks")]


@pytest.mark.slow
def test_the_token_is_not_handed_on(building: Client, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    spy = tmp_path / "spy"
    spy.write_text(f'#!/bin/sh\necho "token: $SOUNDLIST_TOKEN." > {tmp_path / "said"}\nexit 2\n')
    spy.chmod(0o755)
    monkeypatch.setattr(ci, "audio_checks_command", lambda: [str(spy)])
    assert main(["ci", "assets", *building.source, "--no-audit"]) == 2
    assert (tmp_path / "said").read_text() == "token: .\n"


@pytest.mark.slow
def test_the_line_of_the_page(building: Client, game: Path) -> None:
    url = f"/v1/projects/{building.world.project_id}/ci"
    said = building.world.producer.get(url, params={"target": "game"}).json()
    ours = building.world.server.runtime.settings.base_url
    line = said["command"].replace(ours, f"http://127.0.0.1:{building.port}").replace("python3", sys.executable)
    before = len(posted(building, "builds"))
    unnumbered = {name: value for name, value in os.environ.items() if name not in ci.LABELS}
    done = subprocess.run(
        ["/bin/sh", "-c", line], cwd=game, env=unnumbered, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr
    builds = posted(building, "builds")
    assert len(builds) == before + 1
    assert re.fullmatch(r"\d{4}-\d\d-\d\d \d\d:\d\d UTC", builds[0]["label"])


def step_of_action() -> str:
    action = yaml.safe_load((ROOT / "action.yml").read_text())
    (step,) = [step for step in action["runs"]["steps"] if step["name"] == "Check"]
    return str(step["run"])


def script_of_gitlab() -> str:
    job = yaml.safe_load((ROOT / "integrations/gitlab/audio-checks.gitlab-ci.yml").read_text())["audio-checks"]
    (script,) = job["script"]
    return str(script)


def run_script(client: Client, shell: str, script: str, **variables: str) -> tuple[int, str]:
    """Run what a CI service runs, in the game's folder."""
    server = client.source[1]
    given = {"SERVER": server, "PROJECT": client.source[3]}
    environment = {
        **os.environ,
        "PATH": f"{Path(sys.executable).parent}:{os.environ['PATH']}",
        "PYTHONPATH": str(ROOT),
        **{f"{prefix}_{name}": value for prefix in ("CHECK", "AUDIO") for name, value in given.items()},
        **variables,
    }
    done = subprocess.run([shell, "-e", "-c", script], env=environment, capture_output=True, text=True, check=False)
    return done.returncode, done.stdout + done.stderr


INPUTS = dict.fromkeys(("SPEC", "TARGET", "LIST", "BASELINE", "REQUIRE_SPEC", "CHANGED_SINCE", "SARIF"), "")
CHECKS = {f"CHECK_{name}": value for name, value in {**INPUTS, "FAIL_LEVEL": "error", "PATHS": "assets\n"}.items()}


@pytest.mark.slow
def test_the_github_action_runs_it_where_a_server_is_named(building: Client, game: Path) -> None:
    places = {"RUNNER_TEMP": str(game), "GITHUB_STEP_SUMMARY": str(game / "summary.md"), "GITHUB_RUN_NUMBER": "12"}
    code, out = run_script(building, "bash", step_of_action(), **CHECKS, **places)
    assert code == 0, out
    assert "3 files: 3 conforming" in out
    assert posted(building, "builds")[0]["label"] == posted(building, "audits")[0]["label"] == "12"
    for name, value, fault in (
        ("CHECK_PATHS", "assets\nmusic\n", "paths is one folder"),
        ("CHECK_LIST", "sounds.csv", "leave these inputs out"),
    ):
        code, out = run_script(building, "bash", step_of_action(), **{**CHECKS, **places, name: value})
        assert (code, fault in out) == (2, True), out


@pytest.mark.slow
def test_the_gitlab_job_runs_it_where_a_server_is_named(building: Client, game: Path) -> None:
    code, out = run_script(building, "sh", script_of_gitlab(), AUDIO_PATHS="assets", CI_PIPELINE_IID="13")
    assert code == 0, out
    assert posted(building, "builds")[0]["label"] == posted(building, "audits")[0]["label"] == "13"
    assert (game / "audio-checks.xml").exists()
