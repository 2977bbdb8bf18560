"""A name drawn at signing: bounded, kept with the signature, drawn on the certificate, held against the record."""

import hashlib
import io
import json
import re
from typing import Any
from uuid import UUID

import pytest
import sqlalchemy as sa
from pypdf import PdfReader
from sqlalchemy.orm import Session

from app.agreements.errors import BadDrawing
from app.agreements.models import Contract, ContractAcceptance
from app.agreements.signing.drawn_signatures import (
    HEIGHT,
    MAX_POINTS,
    MAX_STROKES,
    WIDTH,
    drawing_sha256,
    drawing_svg,
    ensure_drawing_fits,
)
from app.amendments.verification import validation_errors
from tests.app.agreements.conftest import Contracts
from tests.support.server import World

NAME = [[[10, 20], [300, 250], [600, 20]], [[700, 150]], [[0, 0], [WIDTH, HEIGHT]]]
SHA256 = hashlib.sha256(json.dumps(NAME, separators=(",", ":")).encode()).hexdigest()


def test_a_drawing_within_its_limits_fits() -> None:
    ensure_drawing_fits(NAME)
    ensure_drawing_fits([[[x % WIDTH, x % HEIGHT] for x in range(MAX_POINTS)]])
    ensure_drawing_fits([[[10 * stroke, 0]] for stroke in range(MAX_STROKES)])


@pytest.mark.parametrize(
    ("strokes", "says"),
    [
        ([], "without a point"),
        ([[]], "without a point"),
        ([[[0, 0], [500, 100]], []], "without a point"),
        ([[[0, 0]]] * (MAX_STROKES + 1), "101 strokes"),
        ([[[0, 0], [500, 100]] * 1_501], "3,002 points"),
        ([[[0, 0], [500, HEIGHT + 1]]], "outside of its box"),
        ([[[0, 0], [-1, 100]]], "outside of its box"),
        ([[[0, 0], [500, 100, 7]]], "outside of its box"),
        ([[[500, 100], [520, 110]]], "too small"),
    ],
)
def test_what_is_no_drawing_is_refused_in_words(strokes: Any, says: str) -> None:
    with pytest.raises(BadDrawing, match=says) as refused:
        ensure_drawing_fits(strokes)
    assert refused.value.fix


def test_the_picture_is_made_of_numbers_alone() -> None:
    svg = drawing_svg(NAME)
    paths = re.findall(r'<path d="([^"]*)"/>', svg)
    assert paths == ["M 10 20 L 300 250 L 600 20", "M 700 150 L 700 150", f"M 0 0 L {WIDTH} {HEIGHT}"]
    assert set(re.findall(r"<(\w+)", svg)) == {"svg", "g", "path"}


def test_its_hash_is_that_of_its_points() -> None:
    assert drawing_sha256(NAME) == SHA256
    assert drawing_sha256(None) == ""


def accept(contracts: Contracts, contract: dict[str, Any], by: Any, name: str, drawing: Any) -> Any:
    body = {"name": name, "text_sha256": contract["version"]["text_sha256"], "drawing": drawing}
    return by.post(f"/v1/contracts/{contract['id']}/accept", json=body)


def drawn_by_designer(world: World, contracts: Contracts) -> dict[str, Any]:
    """Return a contract that the designer signed with a drawing, and the producer by typing alone."""
    sent = contracts.send(contracts.begin())
    signed = accept(contracts, sent, world.designer, "N. Designer", NAME)
    assert signed.status_code == 200, signed.text
    return contracts.accept(sent, world.producer, "P. Producer")


@pytest.mark.slow
@pytest.mark.both_databases
def test_it_is_kept_shown_recorded_and_held_against_the_record(world: World, contracts: Contracts) -> None:
    agreed = drawn_by_designer(world, contracts)
    assert [(one["name"], one["drawing"]) for one in agreed["acceptances"]] == [
        ("N. Designer", NAME),
        ("P. Producer", None),
    ]
    entries = contracts.ask(world.designer, "GET", f"/contracts/{agreed['id']}/record")["entries"]
    accepted = [entry["payload"] for entry in entries if entry["kind"] == "accepted_by"]
    assert [one.get("drawing_sha256") for one in accepted] == [SHA256, None]

    def faults(session: Session) -> list[str]:
        contract = session.get_one(Contract, UUID(agreed["id"]))
        return validation_errors(session, world.server.runtime.store, contract)

    def redraw(drawing: Any) -> None:
        def write(session: Session) -> None:
            of_designer = sa.update(ContractAcceptance).where(
                ContractAcceptance.contract_id == UUID(agreed["id"]), ContractAcceptance.name == "N. Designer"
            )
            session.execute(of_designer.values(drawing=drawing))

        world.server.in_database(write)

    assert world.server.in_database(faults) == []
    redraw([[[0, 0], [900, 200]]])
    (fault,) = world.server.in_database(faults)
    assert "its drawing is sha256:" in fault
    redraw(None)
    (fault,) = world.server.in_database(faults)
    assert "its drawing is empty, and the record says sha256:" in fault
    redraw(NAME)
    assert world.server.in_database(faults) == []


@pytest.mark.slow
def test_it_is_drawn_on_the_certificate(world: World, contracts: Contracts) -> None:
    agreed = drawn_by_designer(world, contracts)
    world.server.wait_for_jobs()
    pdf = contracts.ask(world.designer, "GET", f"/contracts/{agreed['id']}/versions/1/contract.pdf")
    assert b"pdfaid" in pdf  # still archival
    pages = PdfReader(io.BytesIO(pdf)).pages
    words = " ".join(" ".join(page.extract_text() for page in pages).split())
    assert f"Name drawn by hand, SHA-256 {SHA256}" in words
    assert words.count("Name drawn by hand") == 1
    drawn = b"".join(content_of(page) for page in pages)
    assert b"300 250 l" in drawn  # the second point of the first stroke, as a line of the page's own


def content_of(page: Any) -> bytes:
    """Return the operators of a page and of the forms that it shows."""
    found: bytes = page.get_contents().get_data()
    forms = page.get("/Resources", {}).get("/XObject", {})
    return found + b"".join(form.get_object().get_data() for form in forms.values())


@pytest.mark.slow
@pytest.mark.parametrize(
    "drawing",
    [
        [],
        [[[0, 0]]],
        [[[0, 0], [500, 301]]],
        [[[0, 0], [1_001, 10]]],
        [[[0, 0], [-5, 10]]],
        [[[0, 0], [0.5, 10]]],
        [[[0, 0], [500]]],
        [[[0, 0], [500, 10, 10]]],
        [[[0, 0], ["500", 10]]],
        [[[0, 0], [None, 10]]],
        [[[0, 0], [2**53, 10]]],
        [[[0, 0], [1e300, 10]]],
        [[[0, 0], [500, 100]]] * 101,
        [[[0, 0], [500, 100]] * 1_501],
        [[[[0, 0]], [500, 100]]],
        "<svg onload='alert(1)'/>",
        {"strokes": NAME},
        [["<path d='M0 0'/>"]],
    ],
    ids=lambda value: str(value)[:30],
)
def test_hostile_drawings_are_refused_and_nothing_is_signed(world: World, contracts: Contracts, drawing: Any) -> None:
    sent = contracts.send(contracts.begin())
    answer = accept(contracts, sent, world.designer, "N. Designer", drawing)
    assert answer.status_code == 422, answer.text
    assert any(one["where"].startswith("drawing") for one in answer.json()["errors"])
    read = contracts.ask(world.designer, "GET", f"/contracts/{sent['id']}")
    assert read["acceptances"] == []
