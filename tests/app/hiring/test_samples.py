"""Samples of a bid: added by the designer, checked by the spec, heard by the two parties, closed after a refusal."""

import base64
from datetime import timedelta
from typing import Any
from uuid import UUID

import pytest
from httpx import Response
from httpx2 import Client

from app.core import clock
from app.deliveries.models import Take
from app.hiring.models import Posting
from app.hiring.rules import SAMPLES_KEPT, sample_is_open
from tests.app.hiring.test_bids import DATES, WHOLE, compared, save, send
from tests.app.hiring.test_postings import add_cues, join, opened
from tests.support.server import World
from tests.support.waves import noise, sine, wav_bytes

GOOD = wav_bytes(noise(dbfs=-20, seconds=0.3))
LOUD = wav_bytes(sine(hz=997, dbfs=0.0, seconds=0.3))


@pytest.fixture
def posting(world: World) -> dict[str, Any]:
    """An open posting for footsteps and a click."""
    add_cues(world)
    return opened(world, **DATES)


def add(by: Client, posting: dict[str, Any], content: bytes = GOOD, line: str = "ui", **more: Any) -> Response:
    encoded = base64.b64encode(content).decode()
    body = {"line_key": line, "file_name": "click.wav", "content_base64": encoded, **more}
    return by.post(f"/v1/postings/{posting['id']}/bid/samples", json=body)


def own(by: Client, posting: dict[str, Any]) -> list[dict[str, Any]]:
    samples: list[dict[str, Any]] = by.get(f"/v1/postings/{posting['id']}").json()["own_bid"]["samples"]
    return samples


@pytest.mark.slow
@pytest.mark.both_databases
def test_a_sample_is_checked_and_heard_by_both_once_the_bid_is_sent(world: World, posting: dict[str, Any]) -> None:
    designer = world.other_designer
    join(world, posting, designer)
    assert save(designer, posting, WHOLE).status_code == 200
    for content, line in ((LOUD, "ui"), (GOOD, "footsteps")):
        added = add(designer, posting, content, line)
        assert added.status_code == 201, added.text
    world.server.wait_for_jobs()
    footsteps, click = own(designer, posting)  # in the order of the posting's lines
    assert [footsteps["line_key"], click["line_key"]] == ["footsteps", "ui"]
    assert (footsteps["state"], footsteps["spec_version"], footsteps["problem"]) == ("conforming", 1, "")
    assert click["state"] == "returned"
    assert "true-peak:over" in [finding["code"] for finding in click["findings"]]
    assert not any(finding["code"].startswith("naming") for finding in click["findings"])
    path = f"/v1/bid-samples/{click['id']}/file"
    assert designer.get(path).content == LOUD
    assert world.producer.get(path).status_code == 404  # the bid is a draft
    sent = designer.post(f"/v1/postings/{posting['id']}/bid/send", json={"revision": 1})
    assert sent.status_code == 200, sent.text
    (bid,) = compared(world, posting)["bids"]
    assert [(one["line_key"], one["state"]) for one in bid["samples"]] == [
        ("footsteps", "conforming"),
        ("ui", "returned"),
    ]
    assert world.producer.get(path).content == LOUD
    assert world.producer.get(path, headers={"Range": "bytes=0-3"}).content == b"RIFF"
    for by, status in ((world.designer, 404), (world.stranger, 404), (world.reviewer, 403), (world.nobody, 401)):
        assert by.get(path).status_code == status
    assert (
        world.server.in_database(lambda session: session.query(Take).filter_by(project_id=world.project_id).count())
        == 0
    )


@pytest.mark.slow
@pytest.mark.both_databases
def test_a_sample_is_removed_by_its_designer_alone(world: World, posting: dict[str, Any]) -> None:
    send(world, posting, world.other_designer, WHOLE)
    add(world.other_designer, posting)
    (sample,) = own(world.other_designer, posting)
    path = f"/v1/bid-samples/{sample['id']}"
    assert world.designer.delete(path).status_code == 404
    assert world.producer.delete(path).status_code in (403, 404)
    assert world.other_designer.delete(path).status_code == 200
    assert own(world.other_designer, posting) == []
    assert world.other_designer.delete(path).status_code == 404


@pytest.mark.slow
def test_what_is_no_sample_is_refused(world: World, posting: dict[str, Any]) -> None:
    designer = world.other_designer
    join(world, posting, designer)
    early = add(designer, posting)
    assert (early.status_code, early.json()["code"]) == (409, "bid-not-sent")
    save(designer, posting, WHOLE)
    assert add(designer, posting, b"GIF89a no sound").json()["code"] == "no-sound"
    assert add(designer, posting, line="weapons").json()["errors"][0]["where"] == "line_key"
    assert add(designer, posting, content_base64="???").json()["errors"][0]["where"] == "content_base64"
    assert add(designer, posting, file_name="a\x00b").status_code == 422
    for _ in range(8):
        assert add(designer, posting).status_code == 201
    assert add(designer, posting).json()["code"] == "samples-full"
    assert add(world.designer, posting).status_code == 404  # was not asked
    assert add(world.producer, posting).status_code == 403
    world.producer.post(f"/v1/postings/{posting['id']}/close")
    assert add(designer, posting).json()["code"] == "posting-closed"


@pytest.mark.slow
def test_a_refused_bids_samples_are_closed_after_thirty_days(world: World, posting: dict[str, Any]) -> None:
    send(world, posting, world.other_designer, WHOLE)
    send(world, posting, world.designer, WHOLE)
    add(world.other_designer, posting)
    add(world.designer, posting)
    (lost,), (won,) = own(world.other_designer, posting), own(world.designer, posting)
    chosen = next(bid for bid in compared(world, posting)["bids"] if bid["samples"][0]["id"] == won["id"])
    awarded = world.producer.post(f"/v1/bids/{chosen['id']}/award")
    assert awarded.status_code in (200, 201), awarded.text
    path = f"/v1/bid-samples/{lost['id']}/file"
    assert world.producer.get(path).status_code == 200

    def month_ago(session: Any) -> None:
        session.get(Posting, UUID(posting["id"])).awarded_at = clock.now() - SAMPLES_KEPT

    world.server.in_database(month_ago)
    assert world.producer.get(path).status_code == 404
    assert own(world.other_designer, posting)[0]["is_open"] is False
    assert world.producer.get(f"/v1/bid-samples/{won['id']}/file").status_code == 200


def test_samples_close_on_the_thirtieth_day() -> None:
    now = clock.now()
    last = SAMPLES_KEPT - timedelta(seconds=1)
    assert sample_is_open(now, is_refused=True, refused_at=now - last)
    assert not sample_is_open(now, is_refused=True, refused_at=now - SAMPLES_KEPT)
    assert sample_is_open(now, is_refused=False, refused_at=now - SAMPLES_KEPT)
    assert sample_is_open(now, is_refused=True, refused_at=None)
