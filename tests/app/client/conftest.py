"""An approved project, made once for a file of tests, and a client of it."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from app.client.commands import main
from tests.app.builds.approved import accepted_list
from tests.app.client.served import Client, RunDesk, client_of
from tests.support.server import RunningServer, World


@pytest.fixture(scope="module")  # a token wants a sign-in of the last minutes
def approved(server: RunningServer) -> World:
    """Three accepted sounds of two cues, and a third cue without one; tests leave it as it is."""
    world = World(server)
    accepted_list(world)
    return world


@pytest.fixture
def client(approved: World, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Iterator[Client]:
    """A client of the approved project."""
    with client_of(approved, monkeypatch, capsys) as made:
        yield made


@pytest.fixture
def game(tmp_path: Path) -> Path:
    """An empty folder of a game."""
    folder = tmp_path / "game"
    folder.mkdir()
    return folder


@pytest.fixture
def run_desk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> RunDesk:
    """`soundlist desk`, with a folder for settings of its own."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    monkeypatch.setattr("app.client.desk.RETRY_DELAYS_S", ())

    def run(*arguments: str, token: str | None = None) -> tuple[int, str, str]:
        monkeypatch.setenv("SOUNDLIST_TOKEN", token or "")
        capsys.readouterr()
        code = main(["desk", *arguments])
        return code, *capsys.readouterr()

    return run
