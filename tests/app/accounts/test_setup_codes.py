"""The first account of an empty server: by the set-up code that is printed, or on the command line."""

import os
import re
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

import httpx
import pytest
import sqlalchemy as sa
from fastapi.testclient import TestClient
from pwdlib import PasswordHash
from pwdlib.hashers.argon2 import Argon2Hasher
from typer.testing import CliRunner

from app.accounts import passwords, queries, rate_limits
from app.accounts.models import Membership, Person
from app.accounts.setup_codes import setup_code
from app.cli.groups import cli
from app.core.runtime import Runtime
from app.main import create_app
from app.migrate import migrate
from app.settings import Settings
from tests.app.accounts.test_sign_in import PASSWORD
from tests.app.demo.test_run import free_port

pytestmark = pytest.mark.on_folder
SECRET_KEY = "sixteen and more for tests"
BODY = {"email": "ada@studio.example", "name": "Ada", "password": PASSWORD, "studio_name": "Night Studio"}
CODE = re.compile(r"Set-up code of the first one: ([A-Z2-7-]{19})\n")


@pytest.fixture(scope="module")
def runtime(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Runtime]:
    runtime = Runtime.of(Settings(data_dir=tmp_path_factory.mktemp("empty"), secret_key=SECRET_KEY))
    migrate(runtime.database)
    yield runtime
    runtime.close()


@pytest.fixture(scope="module")
def application(runtime: Runtime) -> Any:
    return create_app(runtime)


@pytest.fixture
def empty(runtime: Runtime, monkeypatch: pytest.MonkeyPatch) -> Iterator[Runtime]:
    """A server without accounts, which takes people by invitation."""
    cheap = PasswordHash((Argon2Hasher(time_cost=1, memory_cost=8, parallelism=1),))
    monkeypatch.setattr(passwords, "_hasher", cheap)
    yield runtime
    with runtime.database.writing() as session:
        for table in ("security_events", "sign_ins", "memberships", "studios", "rate_limits"):
            session.execute(sa.text(f"delete from accounts_{table}"))  # noqa: S608
        session.execute(sa.delete(Person))


@pytest.fixture
def browser(application: Any) -> TestClient:
    return TestClient(application, base_url="http://127.0.0.1:8000")


def has_people(runtime: Runtime) -> bool:
    with runtime.database.reading() as session:
        return queries.has_people(session)


def test_the_code_follows_from_the_secret_key_alone(tmp_path: Path) -> None:
    settings = Settings(data_dir=tmp_path, secret_key=SECRET_KEY)
    assert re.fullmatch("([A-Z2-7]{4}-){3}[A-Z2-7]{4}", setup_code(settings))
    assert setup_code(settings) == setup_code(Settings(data_dir=tmp_path / "other", secret_key=SECRET_KEY))
    assert setup_code(settings) != setup_code(Settings(data_dir=tmp_path, secret_key=SECRET_KEY + "!"))


def test_the_first_account_needs_the_code_and_no_other_does(empty: Runtime, browser: TestClient) -> None:
    assert browser.get("/v1/sign-up").json() == {"open": True, "by_mail": False, "setup_code": True}
    for code in ({}, {"setup_code": ""}, {"setup_code": "AAAA-BBBB-CCCC-DDDD"}):
        refused = browser.post("/v1/sign-up", json=BODY | code)
        assert (refused.status_code, refused.json()["code"]) == (403, "setup-code-needed")
        assert "soundlist accounts add" in refused.json()["fix"]
        assert [error["where"] for error in refused.json()["errors"]] == ["setup_code"]
    assert not has_people(empty)
    typed = f" {setup_code(empty.settings).lower().replace('-', ' ')} "
    assert browser.post("/v1/sign-up", json=BODY | {"setup_code": typed}).status_code == 201
    assert browser.get("/v1/sign-up").json() == {"open": False, "by_mail": False, "setup_code": False}
    other = BODY | {"email": "eve@studio.example", "setup_code": typed}
    browser.cookies.clear()
    assert browser.post("/v1/sign-up", json=other).json()["code"] == "sign-up-closed"


def test_no_link_is_mailed_without_the_code(
    empty: Runtime, browser: TestClient, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(empty.settings, "smtp_url", "smtp://127.0.0.1:9")
    assert browser.get("/v1/sign-up").json() == {"open": True, "by_mail": True, "setup_code": True}
    refused = browser.post("/v1/sign-ups", json={"email": BODY["email"]})
    assert (refused.status_code, refused.json()["code"]) == (403, "setup-code-needed")
    asked = {"email": BODY["email"], "setup_code": setup_code(empty.settings)}
    assert browser.post("/v1/sign-ups", json=asked).status_code == 202


@pytest.mark.slow
def test_guesses_are_counted(empty: Runtime, browser: TestClient, monkeypatch: pytest.MonkeyPatch) -> None:
    few = replace(rate_limits.SIGN_UPS_FROM_NETWORK, burst=2)
    monkeypatch.setattr(rate_limits, "SIGN_UPS_FROM_NETWORK", few)
    tries = [browser.post("/v1/sign-up", json=BODY) for _ in range(3)]
    assert [answer.status_code for answer in tries] == [403, 403, 429]
    assert int(tries[-1].headers["Retry-After"]) > 0


@pytest.mark.parametrize(("name", "value"), [("sign_up", "open"), ("demo", True)])
def test_an_open_server_and_the_demo_ask_for_none(
    empty: Runtime, browser: TestClient, monkeypatch: pytest.MonkeyPatch, name: str, value: object
) -> None:
    monkeypatch.setattr(empty.settings, name, value)
    assert browser.get("/v1/sign-up").json()["setup_code"] is False
    assert browser.post("/v1/sign-up", json=BODY).status_code == 201


@pytest.mark.parametrize("studio", ["Night Studio", ""])
def test_the_command_line_makes_an_account_without_the_code(
    empty: Runtime, browser: TestClient, monkeypatch: pytest.MonkeyPatch, studio: str
) -> None:
    monkeypatch.setenv("SOUNDLIST_DATA_DIR", str(empty.settings.data_dir))
    command = ["accounts", "add", "Ada@Studio.example", "--name", "Ada", *(("--studio", studio) if studio else ())]
    weak = CliRunner().invoke(cli, command, input="1234567890\n")
    assert weak.exit_code == 2
    assert "easily guessed" in weak.output
    made = CliRunner().invoke(cli, command, input=f"{PASSWORD}\n")
    assert (made.exit_code, made.output) == (0, "ada@studio.example has an account\n")
    assert "already has an account" in CliRunner().invoke(cli, command, input=f"{PASSWORD}\n").output
    signed_in = browser.post("/v1/sign-in", json={"email": BODY["email"], "password": PASSWORD})
    assert signed_in.status_code == 200
    with empty.database.reading() as session:
        memberships = session.scalars(sa.select(Membership)).all()
        assert [membership.roles for membership in memberships] == ([["producer"]] if studio else [])


@pytest.mark.slow
def test_serve_prints_the_code_that_all_its_processes_take_until_there_is_an_account(empty: Runtime) -> None:
    with serving(empty.settings) as (process, browser):
        code = CODE.search(lines_until(process, "Enter it at"))
        assert code is not None
        answered(process, browser, "/v1/sign-up")
        assert browser.post("/v1/sign-up", json=BODY | {"setup_code": code[1]}).status_code == 201
        assert not CODE.search(output_of(process))
    with serving(empty.settings) as (process, browser):
        assert answered(process, browser, "/v1/sign-up").json()["open"] is False
        assert not CODE.search(output_of(process))


@contextmanager
def serving(settings: Settings) -> Iterator[tuple["subprocess.Popen[str]", httpx.Client]]:
    """Run `soundlist serve` with two processes."""
    port = str(free_port())
    environment = os.environ | {
        "SOUNDLIST_DATA_DIR": str(settings.data_dir),
        "SOUNDLIST_SECRET_KEY": SECRET_KEY,
        "SOUNDLIST_WEB_PROCESSES": "2",
    }
    process = subprocess.Popen(
        [sys.executable, "-m", "app", "serve", "--port", port, "--stop-with-input"],
        env=environment, text=True, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
    )  # fmt: skip
    try:
        with httpx.Client(base_url=f"http://127.0.0.1:{port}", timeout=None) as browser:  # noqa: S113
            yield process, browser
    finally:
        process.kill()
        process.wait()


def lines_until(process: "subprocess.Popen[str]", mark: str) -> str:
    lines = ""
    assert process.stdout is not None
    for line in process.stdout:
        lines += line
        if mark in line:
            return lines
    raise AssertionError(lines)


def answered(process: "subprocess.Popen[str]", browser: httpx.Client, path: str) -> httpx.Response:
    while process.poll() is None:
        try:
            return browser.get(path)
        except httpx.TransportError:
            time.sleep(0.2)
    raise AssertionError(output_of(process))


def output_of(process: "subprocess.Popen[str]") -> str:
    """Return the rest of what a server prints; the end of its input stops it."""
    output, _ = process.communicate()
    return output
