"""`soundlist desk`: what is owed on several servers, in one table."""

import json
import os
import socket
import subprocess
import sys
from collections.abc import Iterator
from datetime import date
from pathlib import Path
from typing import Any

import pytest

from app.core.runtime import Runtime
from app.main import create_app
from app.migrate import migrate
from app.settings import Settings
from tests.app.client.served import RunDesk
from tests.app.dashboards.test_own_desk import make_token, set_due
from tests.app.reviews.making import Stage
from tests.support.listening import listening
from tests.support.server import RunningServer, World


@pytest.fixture
def other(tmp_path: Path, server: RunningServer) -> Iterator[World]:
    """A studio on a second server with its own database."""
    runtime = Runtime.of(Settings(data_dir=tmp_path / "other", secret_key="only for tests", sign_up="open"))
    migrate(runtime.database)
    try:
        yield World(RunningServer(runtime, create_app(runtime), server.portal))
    finally:
        runtime.close()


@pytest.fixture
def port(world: World) -> Iterator[int]:
    with listening(world.server.application, lifespan="off", log_level="critical") as port:
        yield port


def kept(tmp_path: Path) -> Path:
    return tmp_path / "config" / "soundlist" / "desk.json"


@pytest.mark.slow
def test_two_servers_and_a_dead_one(world: World, other: World, port: int, run_desk: RunDesk, tmp_path: Path):
    for studio, name, day in ((world, "laser", "2026-12-02"), (other, "engine", "2026-12-01")):
        cue_id = Stage(studio).cue(name)
        set_due(studio, cue_id, date.fromisoformat(day))
    with socket.create_server(("127.0.0.1", 0)) as closed:
        dead_port = closed.getsockname()[1]
    with listening(other.server.application, lifespan="off", log_level="critical") as other_port:
        for name, at, studio in (("one", port, world), ("two", other_port, other)):
            code, out, err = run_desk("add", f"http://127.0.0.1:{at}", "--name", name, token=make_token(studio)[1])
            assert code == 0, err
            assert "signed in as Sound designer" in out
        assert run_desk()[0] == 0
        said = json.loads(kept(tmp_path).read_text())
        said["servers"]["three"] = {"address": f"http://127.0.0.1:{dead_port}", "token": "sld_x"}
        kept(tmp_path).write_text(json.dumps(said))
        code, out, err = run_desk()
        assert code == 3
        assert "three is left out: cannot be reached" in err
        head, first, second = out.splitlines()
        assert head.split() == ["due", "cue", "name", "state", "project", "studio", "server", "said", "last"]
        assert first.split()[::2][:2] == ["2026-12-01", "engine"]
        assert second.split()[::2][:2] == ["2026-12-02", "laser"]
        code, out, _ = run_desk("--format", "json")
        answer = json.loads(out)
        assert [(one["server"], one["name"]) for one in answer["cues"]] == [("two", "engine"), ("one", "laser")]
        assert [one["problem"] is None for one in answer["servers"]] == [True, True, False]
        code, out, _ = run_desk("--server", "one")
        assert code == 0
        assert "engine" not in out


def test_the_token_is_kept_for_its_owner_and_never_printed(world: World, port: int, run_desk: RunDesk, tmp_path: Path):
    secret = make_token(world)[1]
    printed = [run_desk("add", f"http://127.0.0.1:{port}", "--name", "one", token=secret), run_desk("list"), run_desk()]
    printed.append(run_desk("--format", "json"))
    assert secret not in str(printed)
    assert kept(tmp_path).stat().st_mode & 0o777 == 0o600
    kept(tmp_path).chmod(0o644)
    code, _, err = run_desk()
    assert code == 2
    assert "chmod 600" in err
    kept(tmp_path).chmod(0o600)
    assert run_desk("remove", "one")[0] == 0
    assert secret not in kept(tmp_path).read_text()
    assert run_desk("remove", "one")[0] == 2


@pytest.mark.slow
def test_a_token_by_standard_input(world: World, port: int, tmp_path: Path):
    environment = {"PATH": os.environ["PATH"], "XDG_CONFIG_HOME": str(tmp_path / "config")}
    command = [sys.executable, "-m", "app", "desk", "add", f"http://127.0.0.1:{port}"]
    done = subprocess.run(
        command, input=make_token(world)[1] + "\n", env=environment, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    assert json.loads(kept(tmp_path).read_text())["servers"].keys() == {f"127.0.0.1:{port}"}


@pytest.mark.parametrize(
    ("address", "token", "said"),
    [
        ("http://sounds.example", "sld_x", "unencrypted"),
        ("sounds.example", "sld_x", "not an address of a server"),
        ("https://sounds.example", "two words", "no token"),
    ],
)
def test_what_is_no_server_or_token_is_not_asked(
    run_desk: RunDesk, tmp_path: Path, address: str, token: str, said: str
):
    code, _, err = run_desk("add", address, token=token)
    assert code == 2
    assert said in err
    assert not kept(tmp_path).exists()


def test_an_unknown_token_is_refused_and_nothing_is_kept(port: int, run_desk: RunDesk, tmp_path: Path):
    code, _, err = run_desk("add", f"http://127.0.0.1:{port}", token="sld_unknown")
    assert code == 2
    assert "does not know this token" in err
    assert not kept(tmp_path).exists()


@pytest.mark.slow
def test_a_revoked_token_is_named_and_the_rest_is_shown(world: World, port: int, run_desk: RunDesk):
    Stage(world).cue("laser")
    revoked_id, revoked = make_token(world)
    run_desk("add", f"http://127.0.0.1:{port}", "--name", "one", token=make_token(world)[1])
    run_desk("add", f"http://127.0.0.1:{port}", "--name", "two", token=revoked)
    world.designer.delete(f"/v1/me/desk-tokens/{revoked_id}")
    code, out, err = run_desk()
    assert code == 2
    assert "laser" in out
    assert "two is left out: the server does not know this token" in err


async def _elsewhere(scope: Any, _receive: Any, send: Any) -> None:
    headers = [(b"location", b"http://127.0.0.2:1/v1/me/desk")]
    await send({"type": "http.response.start", "status": 307, "headers": headers})
    await send({"type": "http.response.body"})


async def _nonsense(scope: Any, _receive: Any, send: Any) -> None:
    await send({"type": "http.response.start", "status": 200, "headers": [(b"content-type", b"application/json")]})
    await send({"type": "http.response.body", "body": b'{"person": 1, "items": [2], "next": 3}'})


@pytest.mark.parametrize(("application", "said"), [(_elsewhere, "redirects"), (_nonsense, "not understood")])
def test_a_server_that_answers_as_no_soundlist_does(run_desk: RunDesk, application: Any, said: str):
    with listening(application, lifespan="off", log_level="critical") as port:
        code, _, err = run_desk("add", f"http://127.0.0.1:{port}", token="sld_x")
    assert code == 2
    assert said in err


def test_what_a_server_says_does_not_control_the_terminal(world: World, port: int, run_desk: RunDesk):
    Stage(world).cue("laser\x1b[2J")
    run_desk("add", f"http://127.0.0.1:{port}", token=make_token(world)[1])
    assert "\x1b" not in run_desk()[1]


def test_without_a_server_it_names_the_next_step(run_desk: RunDesk):
    code, _, err = run_desk()
    assert code == 2
    assert "soundlist desk add" in err
    assert run_desk("list") == (0, "", "")


def test_it_loads_nothing_of_the_server():
    names = "sqlalchemy, fastapi, typer, numpy"
    code = f"import app.client.commands, sys; print([n for n in '{names}'.split(', ') if n in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
