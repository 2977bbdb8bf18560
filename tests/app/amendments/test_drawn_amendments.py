"""Names drawn under change orders and settlement statements: on the page, in the PDF, held against the record."""

import io
from typing import Any
from uuid import UUID

import pytest
import sqlalchemy as sa
from pypdf import PdfReader

from app.agreements.queries import contract_by_id
from app.amendments.models import AmendmentAcceptance
from app.amendments.verification import validation_errors
from tests.app.agreements.test_drawn_names import NAME, SHA256, content_of
from tests.app.amendments.refusal_parties import Parties, granted
from tests.support.server import World

pytestmark = pytest.mark.slow


@pytest.fixture
def parties(world: World) -> Parties:
    return Parties(world)


def words_and_strokes(pdf: bytes) -> tuple[str, bytes]:
    pages = PdfReader(io.BytesIO(pdf)).pages
    words = " ".join(" ".join(page.extract_text() for page in pages).split())
    return words, b"".join(content_of(page) for page in pages)


def shows_the_drawing(pdf: bytes) -> None:
    words, strokes = words_and_strokes(pdf)
    assert "N. Designer, for the designer" in words
    assert "P. Producer, for the studio" in words
    assert f"Name drawn by hand, SHA-256 {SHA256}" in words
    assert words.count("Name drawn by hand") == 1
    assert b"300 250 l" in strokes


def faults(parties: Parties, contract: dict[str, Any]) -> list[str]:
    server = parties.world.server
    found: list[str] = server.in_database(
        lambda session: validation_errors(session, server.runtime.store, contract_by_id(session, UUID(contract["id"])))
    )
    return found


@pytest.mark.both_databases
def test_a_change_order_shows_who_signed_and_what_was_drawn(parties: Parties) -> None:
    contract = parties.agreed()
    pdf_path = f"/v1/contracts/{contract['id']}/change-orders/1/change-order.pdf"
    text_sha256 = granted(parties.propose(contract, parties.extra_work(contract)))["orders"][0]["text_sha256"]
    assert "Signatures" not in words_and_strokes(granted(parties.designer.get(pdf_path)))[0]
    yes = {"text_sha256": text_sha256}
    by_hand = {"name": "N. Designer", "drawing": NAME, **yes}
    granted(parties.post(parties.designer, contract, "change-orders/1/accept", **by_hand))
    read = granted(parties.post(parties.producer, contract, "change-orders/1/accept", name="P. Producer", **yes))
    assert [one["drawing"] for one in read["orders"][0]["signed"]] == [NAME, None]
    pdf = granted(parties.producer.get(pdf_path))
    shows_the_drawing(pdf)
    assert pdf == granted(parties.designer.get(pdf_path)), "the same text and signatures are the same bytes"
    assert faults(parties, contract) == []
    redrawn = sa.update(AmendmentAcceptance).where(AmendmentAcceptance.name == "N. Designer")
    parties.world.server.in_database(lambda session: session.execute(redrawn.values(drawing=[[[0, 0], [900, 200]]])))
    (fault,) = faults(parties, contract)
    assert "its drawing is " in fault


def test_a_settlement_statement_does_too(parties: Parties) -> None:
    contract = parties.agreed()
    granted(parties.notice(contract))
    said = granted(parties.designer.get(f"/v1/contracts/{contract['id']}/ending"))
    yes = {"text_sha256": said["statement_sha256"]}
    granted(parties.post(parties.designer, contract, "ending/agree", name="N. Designer", drawing=NAME, **yes))
    ended = granted(parties.post(parties.producer, contract, "ending/agree", name="P. Producer", **yes))
    assert [one["drawing"] for one in ended["signed"]] == [NAME, None]
    shows_the_drawing(granted(parties.producer.get(f"/v1/contracts/{contract['id']}/ending/statement.pdf")))
