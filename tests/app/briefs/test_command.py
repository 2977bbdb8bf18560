"""The command prints what the page shows."""

import json

import pytest
from typer.testing import CliRunner

from app.cli import cli
from app.cli import projects as commands
from app.core.db import new_id
from tests.support.commands import use_server_of
from tests.support.server import World


@pytest.fixture(autouse=True)
def _this_server(world: World, monkeypatch: pytest.MonkeyPatch) -> None:
    use_server_of(world, commands, monkeypatch)


def test_as_markdown(world: World) -> None:
    body = {"revision": 0, "answers": {"genre": {"value": "A platformer"}, "silence": {"is_unknown": True}}}
    assert world.producer.patch(f"/v1/projects/{world.project_id}/brief", json=body).status_code == 200
    shown = CliRunner().invoke(cli, ["brief", str(world.project_id)])
    assert shown.exit_code == 0, shown.output
    assert shown.output.startswith("# Brief: Shield Wing\n\n1 of 23 questions answered. No version is published.\n")
    assert "**1. What kind of game is it?**\n\n> A platformer\n" in shown.output
    assert "**2. How should the game feel to the ear?** (needed before signing)\n\n> Open\n" in shown.output
    assert "> Not known yet\n" in shown.output


def test_as_json(world: World) -> None:
    shown = CliRunner().invoke(cli, ["brief", str(world.project_id), "--format", "json"])
    assert shown.exit_code == 0, shown.output
    assert json.loads(shown.output)["total"] == 23


def test_a_project_that_there_is_not(world: World) -> None:
    shown = CliRunner().invoke(cli, ["brief", str(new_id())])
    assert shown.exit_code == 2
    assert "no project" in shown.output
