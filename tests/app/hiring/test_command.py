"""The command prints what was posted and what was bid."""

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


@pytest.mark.slow
def test_postings_with_their_bids(world: World) -> None:
    empty = CliRunner().invoke(cli, ["postings", str(world.project_id)])
    assert (empty.exit_code, empty.output) == (0, "# Postings: Shield Wing\n\nThere is no posting yet.\n")
    cues = [{"name": "step", "category": "foley"}, {"name": "click", "category": "UI"}]
    assert world.producer.post(f"/v1/projects/{world.project_id}/cues", json={"cues": cues}).status_code == 201
    fields = {"title": "Effects for Alpha", "currency": "USD", "scope": "all", "bids_until_on": "2099-01-05"}
    posting = world.producer.post(f"/v1/projects/{world.project_id}/postings", json=fields).json()
    path = f"/v1/postings/{posting['id']}"
    assert world.producer.post(f"{path}/open").status_code == 200
    secret = world.producer.post(f"{path}/link").json()["url"].rpartition("/")[2]
    assert world.designer.post(f"/v1/posting-links/{secret}/join").status_code == 200
    assert world.designer.put("/v1/me", json={"name": "Ada | Tones"}).status_code == 200
    line = {"kind": "asked", "unit": "per_cue", "quantity_hundredths": 100, "price_minor": 12_000}
    bid = {
        "revision": 0,
        "lines": [line | {"key": posting["lines"][1]["key"]}],
        "hours_hundredths": 250,
        "from_on": "2099-02-01",
    }
    saved = world.designer.put(f"{path}/bid", json=bid)
    assert saved.status_code == 200, saved.text
    assert world.designer.post(f"{path}/bid/send", json={"revision": 1}).status_code == 200
    shown = CliRunner().invoke(cli, ["postings", str(world.project_id)])
    assert shown.exit_code == 0, shown.output
    assert "## Effects for Alpha\n\nOpen, bids until 5 January 2099.\n" in shown.output
    assert "| Foley | 1 | 1 |\n" in shown.output
    assert "| Ada \\| Tones | USD 120.00 | 2.5 | USD 48.00 | 2099-02-01 |  | Foley |\n" in shown.output


def test_a_project_that_there_is_not(world: World) -> None:
    shown = CliRunner().invoke(cli, ["postings", str(new_id())])
    assert shown.exit_code == 2
    assert "no project" in shown.output
