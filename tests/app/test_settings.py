"""Settings are checked at start, all at once, each with what was found, what is wanted and how to fix it."""

import socket
import sqlite3
from collections.abc import Callable
from contextlib import closing
from pathlib import Path

import pytest
from click.testing import Result
from typer.testing import CliRunner

from app.cli import cli
from app.settings import Settings, SettingsWrong, read_settings


@pytest.fixture
def environment(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Callable[..., None]:
    monkeypatch.setenv("SOUNDLIST_DATA_DIR", str(tmp_path / "data"))
    monkeypatch.setattr("app.logs.configure", lambda _: None)  # of this whole process

    def of(**settings: str) -> None:
        for name, value in settings.items():
            monkeypatch.setenv(f"SOUNDLIST_{name}", value)

    return of


def wrong(*, serving: bool = True) -> list[str]:
    with pytest.raises(SettingsWrong) as refused:
        read_settings(serving=serving)
    return refused.value.lines


def test_everything_that_is_wrong_is_said_at_once(environment):
    environment(
        BASE_URL="sounds.example", WORKER_JOBS="many", SMTP_URL="mail.example:587", DATABSE_URL="postgresql://x/y"
    )
    reported = wrong()
    assert len(reported) == 4
    assert any("SOUNDLIST_BASE_URL is 'sounds.example'" in line for line in reported)
    assert any(line.startswith("SOUNDLIST_WORKER_JOBS") for line in reported)
    assert any("smtp://user:password@host:587" in line for line in reported)
    assert "SOUNDLIST_DATABSE_URL is not a setting; is it SOUNDLIST_DATABASE_URL?" in reported


def test_an_address_with_a_password_is_not_repeated(environment):
    environment(SMTP_URL="http://ada:hush@mail.example", DATABASE_URL="mysql://ada:hush@db/x", SECRET_KEY="k" * 32)
    reported = wrong()
    assert len(reported) == 2
    assert "hush" not in "".join(reported)


def test_a_short_key_is_no_key(environment):
    environment(SECRET_KEY="hush")
    assert wrong() == [
        "SOUNDLIST_SECRET_KEY has 4 characters; 16 or more are wanted. Make one with: openssl rand -hex 32"
    ]
    assert read_settings(serving=False)


def test_a_name_like_none_of_ours_is_reported_too(environment):
    environment(SECRET_KEY="k" * 32, ZZZ="1")
    assert wrong() == ["SOUNDLIST_ZZZ is not a setting; docs/reference/settings.md lists them"]


def test_trusted_proxies_are_networks(environment):
    environment(TRUSTED_PROXIES=" 10.0.0.0/24, 192.0.2.7 ,fd00::/64,")
    assert Settings().trusted_proxies == ("10.0.0.0/24", "192.0.2.7", "fd00::/64")
    for wrong_one in ("caddy", "10.0.0.1/24", "*"):
        environment(TRUSTED_PROXIES=wrong_one, SECRET_KEY="k" * 32)
        (line,) = wrong()
        assert f"SOUNDLIST_TRUSTED_PROXIES holds {wrong_one!r}" in line
        assert "write networks such as 10.0.0.0/24" in line


def test_figures_of_several_web_processes_want_a_port_for_each(environment):
    environment(SECRET_KEY="k" * 32, WEB_PROCESSES="2", METRICS_TOKEN="t")
    (line,) = wrong()
    assert "set SOUNDLIST_METRICS_PORT to the first of as many ports" in line
    environment(METRICS_PORT="9100")
    assert read_settings(serving=True).web_processes == 2


def started(*command: str) -> Result:
    return CliRunner().invoke(cli, command)


@pytest.mark.parametrize("command", ["serve", "worker"])
def test_what_cannot_serve_does_not_start(environment, tmp_path: Path, command: str):
    environment(SECRET_KEY="k" * 32, STORE_URL=f"file://{tmp_path}/blobs")
    (tmp_path / "blobs").write_text("a file where a folder is wanted")
    result = started(command)
    assert result.exit_code == 2
    assert "run: soundlist migrate" in result.output
    assert "the store cannot be written to" in result.output
    assert "Traceback" not in result.output


@pytest.mark.slow
@pytest.mark.parametrize("command", ["serve", "worker", "migrate"])
def test_a_database_from_before_the_release_is_reported_and_kept(environment, tmp_path: Path, command: str):
    environment(SECRET_KEY="k" * 32)
    file = tmp_path / "data" / "soundlist.sqlite"
    assert started("migrate").exit_code == 0
    with closing(sqlite3.connect(file)) as database:
        database.execute("update alembic_version set version_num = '0077'")
        database.commit()
        before = list(database.iterdump())
    result = started(command)
    assert result.exit_code == 2
    assert "the database is at revision 0077, which a version before 1.0 made" in result.output
    assert "an empty folder in SOUNDLIST_DATA_DIR" in result.output
    assert "Traceback" not in result.output
    with closing(sqlite3.connect(file)) as database:
        assert list(database.iterdump()) == before


def test_a_data_folder_that_cannot_be_made_is_reported(environment, tmp_path: Path):
    (tmp_path / "data").write_text("a file where a folder is wanted")
    result = started("migrate")
    assert result.exit_code == 2
    assert f"SOUNDLIST_DATA_DIR is {tmp_path / 'data'}" in result.output
    assert "Traceback" not in result.output


@pytest.mark.slow
def test_a_metrics_port_that_is_in_use_is_reported(environment):
    environment(SECRET_KEY="k" * 32)
    assert started("migrate").exit_code == 0
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        environment(METRICS_PORT=str(taken.getsockname()[1]))
        for command in ("serve", "worker"):
            result = started(command)
            assert result.exit_code == 2
            assert "its own SOUNDLIST_METRICS_PORT" in result.output
