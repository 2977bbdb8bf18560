"""`soundlist verify` finds changes by hand, even where the whole chain was rewritten."""

import json
import re
from hashlib import sha256
from pathlib import Path
from typing import Any
from uuid import UUID

import pytest
import sqlalchemy as sa
from click.testing import Result
from sqlalchemy.orm import Session
from typer.testing import CliRunner

from app.agreements.models import Contract, ContractEvent, ContractVersion
from app.cli import cli, keeping
from app.core.record import START, link
from app.core.runtime import Runtime
from app.migrate import migrate
from app.settings import Settings
from tests.app.agreements.conftest import Contracts
from tests.support.server import World

pytestmark = pytest.mark.slow


@pytest.fixture
def agreed(contracts: Contracts) -> dict[str, Any]:
    contract = contracts.agree(contracts.begin())
    contracts.world.server.wait_for_jobs()  # which seal it
    return contract


def verify(monkeypatch: pytest.MonkeyPatch, settings: Settings, *paths: Path) -> Result:
    monkeypatch.setattr(keeping, "read_settings_or_exit", lambda: settings)
    return CliRunner().invoke(cli, ["verify", *map(str, paths)])


def lines_on(result: Result, name: object) -> list[str]:
    return [line for line in result.output.splitlines() if str(name) in line]


def counted(result: Result) -> tuple[int, ...]:
    """Return how many records and entries were looked at, and how many are not whole."""
    (found,) = re.findall(
        r"^(\d+) records with (\d+) entries and \d+ copies looked at; (\d+) are",
        result.output,
        re.M,
    )
    return tuple(map(int, found))


def test_nothing_is_whole(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    settings = Settings(data_dir=tmp_path)
    runtime = Runtime.of(settings)
    migrate(runtime.database)
    runtime.close()
    result = verify(monkeypatch, settings)
    assert (result.exit_code, result.output.strip()) == (
        0,
        "0 records with 0 entries and 0 copies looked at; 0 are not whole",
    )


def test_what_was_agreed_is_whole(
    world: World, contracts: Contracts, agreed: dict[str, Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    copy = tmp_path / "record.json"
    copy.write_bytes(
        json.dumps(contracts.ask(world.designer, "GET", f"/contracts/{agreed['id']}/record.json")).encode()
    )
    result = verify(monkeypatch, world.server.runtime.settings, copy)
    assert lines_on(result, agreed["id"]) == []
    assert lines_on(result, copy) == []
    assert "and 1 copies looked at" in result.output
    records, entries, _ = counted(result)
    assert 1 <= records <= entries


VERSIONS, EVENTS = sa.update(ContractVersion), sa.update(ContractEvent)
LAST = sa.delete(ContractEvent).where(ContractEvent.seq == 5)
BY_HAND = {
    "an edited text": (VERSIONS.values(text="# Other\n"), "the text of version 1 was altered"),
    "a text with its hash": (
        VERSIONS.values(text="# Other\n", text_sha256=sha256(b"# Other\n").hexdigest()),
        "version 1 is not the text that entry 1 names",
    ),
    "another pdf": (VERSIONS.values(pdf_sha256="0" * 64), "the PDF of version 1 is not in the store"),
    "an edited entry": (EVENTS.where(ContractEvent.seq == 2).values(kind="paid"), "entry 2 was altered"),
    "a deleted entry": (sa.delete(ContractEvent).where(ContractEvent.seq == 2), "entry 2 is missing"),
    "the last entry deleted": (LAST, "the last 1 of 5 entries is missing"),
}


@pytest.mark.parametrize("deed", BY_HAND)
def test_what_was_done_by_hand_is_named(
    world: World, agreed: dict[str, Any], monkeypatch: pytest.MonkeyPatch, deed: str
):
    statement, fault = BY_HAND[deed]
    of_it = sa.column("contract_id", sa.Uuid) == UUID(agreed["id"])
    world.server.in_database(lambda session: session.execute(statement.where(of_it)))
    result = verify(monkeypatch, world.server.runtime.settings)
    assert result.exit_code == 1
    assert counted(result)[2] >= 1
    assert any(line.endswith(fault) for line in lines_on(result, agreed["id"])), result.output


def rewrite(session: Session, contract_id: UUID) -> None:
    """Alter an entry and rebuild the chain, as the owner of the database could who knows the code."""
    contract = session.get_one(Contract, contract_id)
    previous = START
    for event in session.scalars(
        sa.select(ContractEvent).where(ContractEvent.contract_id == contract_id).order_by(ContractEvent.seq)
    ):
        kind = "paid" if event.seq == 3 else event.kind
        at = event.at.isoformat(timespec="microseconds")
        entry = link(previous, of=str(contract_id), seq=event.seq, at=at, kind=kind, payload=event.payload)
        event.kind, event.previous_sha256, event.sha256 = kind, previous, entry.sha256
        previous = entry.sha256
    contract.record_sha256 = previous


def test_a_copy_shows_what_was_rewritten(
    world: World, contracts: Contracts, agreed: dict[str, Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    copy = tmp_path / "record.json"
    copy.write_text(json.dumps(contracts.ask(world.designer, "GET", f"/contracts/{agreed['id']}/record.json")))
    world.server.in_database(lambda session: rewrite(session, UUID(agreed["id"])))
    result = verify(monkeypatch, world.server.runtime.settings, copy)
    assert lines_on(result, agreed["id"]) == [], "it is whole in itself"
    assert [line.removeprefix(f"{copy}: ") for line in lines_on(result, copy)] == ["entry 3 is another one in the copy"]
    assert result.exit_code == 1


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"entries": []}, "the file itself was altered"),
        ({"length": 3}, "the file itself was altered"),
        ({"format": 9}, "its format is 9"),
        ({"contract": "none"}, "it is not a record"),
    ],
)
def test_a_copy_that_was_altered_is_none(
    world: World,
    contracts: Contracts,
    agreed: dict[str, Any],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    change: dict[str, Any],
    words: str,
):
    copy = tmp_path / "record.json"
    kept = contracts.ask(world.designer, "GET", f"/contracts/{agreed['id']}/record.json")
    copy.write_text(json.dumps(kept | change))
    result = verify(monkeypatch, world.server.runtime.settings, copy)
    assert words in lines_on(result, copy)[0]
    assert result.exit_code == 1
