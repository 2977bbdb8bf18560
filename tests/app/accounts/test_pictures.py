"""Pictures of people: drawn again in a child, shown to those who see the name, and refused in words."""

import io
import zlib

import pytest
from httpx import Response
from httpx2 import Client
from PIL import Image
from sqlalchemy import select
from sqlalchemy.orm import Session

from app.accounts.models import Person, PersonPicture
from app.core import clock
from app.hiring.models import Candidate, Posting
from app.hiring.rules import AskedScope, PostingPhase, PostingState
from tests.support.references import picture, png
from tests.support.server import World

RED = picture("PNG", (300, 200))


def save(client: Client, content: bytes) -> Response:
    return client.put("/v1/me/picture", content=content)


def address(client: Client, content: bytes = RED) -> str:
    saved = save(client, content)
    assert saved.status_code == 200, saved.text
    return str(saved.json()["picture"])


def decoded(content: bytes) -> Image.Image:
    return Image.open(io.BytesIO(content))


@pytest.mark.parametrize("form", ["PNG", "JPEG", "WEBP"])
def test_a_picture_becomes_a_small_square(world: World, form: str) -> None:
    answer = world.producer.get(address(world.producer, picture(form, (300, 200))))
    assert (answer.status_code, answer.headers["content-type"]) == (200, "image/webp")
    assert (decoded(answer.content).format, decoded(answer.content).size) == ("WEBP", (128, 128))
    red, green, blue = decoded(answer.content).convert("RGB").getpixel((64, 64))
    assert red > 180 > 90 > green > blue
    assert "immutable" in answer.headers["cache-control"]
    assert answer.headers["cache-control"].startswith("private")
    assert answer.headers["content-security-policy"] == "default-src 'none'; sandbox"
    again = world.producer.get(str(answer.url), headers={"If-None-Match": answer.headers["etag"]})
    assert again.status_code == 304


def test_its_middle_is_kept(world: World) -> None:
    wide = Image.new("RGB", (300, 100), "red")
    wide.paste((0, 0, 255), (100, 0, 200, 100))
    out = io.BytesIO()
    wide.save(out, "PNG")
    kept = decoded(world.producer.get(address(world.producer, out.getvalue())).content).convert("RGB")
    for x in (8, 64, 119):
        assert kept.getpixel((x, 64))[2] > 200, "the red sides are cut off"


def test_nothing_else_that_the_file_says_is_kept(world: World) -> None:
    exif = Image.Exif()
    exif[0x0112], exif[0x010E] = 6, "taken at home"  # turned by a quarter; a description
    content = picture("JPEG", (40, 30), exif=exif, icc_profile=b"made by a known screen" * 20)
    kept = world.producer.get(address(world.producer, content)).content
    assert b"taken at home" not in kept
    assert b"known screen" not in kept
    assert b"EXIF" not in kept


@pytest.mark.slow
def test_the_name_carries_it_wherever_the_person_is_named(world: World) -> None:
    shown = address(world.approver)
    assert world.approver.get("/v1/me").json()["person"]["picture"] == shown
    assert world.approver.get("/v1/session").json()["person"]["picture"] == shown
    people = world.producer.get(f"/v1/studios/{world.studio_id}/people").json()
    assert {person["person"]["name"]: person["person"]["picture"] for person in people} == {
        "Producer": None,
        "Audio director": shown,
        "Composer": None,
    }
    assert world.designer.get(f"/v1/projects/{world.project_id}").json()["approver"]["picture"] == shown


@pytest.mark.slow
def test_those_who_see_the_name_see_it_and_no_others(world: World) -> None:
    of_approver, of_designer = address(world.approver), address(world.designer)
    for client in (world.producer, world.reviewer, world.designer):
        assert client.get(of_approver).status_code == 200
    for client in (world.producer, world.reviewer, world.approver):
        assert client.get(of_designer).status_code == 200
    for client in (world.stranger, world.other_designer):
        assert client.get(of_approver).status_code == 404
        assert client.get(of_designer).status_code == 404
    assert world.nobody.get(of_approver).status_code == 401


def test_designers_of_a_project_do_not_see_each_other(world: World) -> None:
    shown = address(world.designer)
    assert world.other_designer.get(shown).status_code == 404


def test_who_left_sees_none_and_is_not_seen(world: World) -> None:
    of_reviewer, of_producer = address(world.reviewer), address(world.producer)
    assert world.reviewer.get(of_producer).status_code == world.designer.get(of_producer).status_code == 200
    assert world.producer.get(of_reviewer).status_code == 200
    (engagement,) = world.producer.get(f"/v1/projects/{world.project_id}").json()["engagements"]
    path = f"/v1/projects/{world.project_id}/engagements/{engagement['id']}"
    assert world.producer.patch(path, json={"ended": True}).status_code == 200
    assert world.producer.delete(f"/v1/studios/{world.studio_id}/people/{world.reviewer_id}").status_code == 204
    for former in (world.reviewer, world.designer):
        assert former.get(of_producer).status_code == 404
    assert world.producer.get(of_reviewer).status_code == 404


def test_a_candidate_and_the_team_see_each_other(world: World) -> None:
    of_candidate, of_producer = address(world.other_designer), address(world.producer)
    assert world.producer.get(of_candidate).status_code == 404
    of = {"studio_id": world.studio_id, "project_id": world.project_id}

    def invite(session: Session) -> None:
        posting = Posting(
            **of,
            title="Weapons",
            phase=PostingPhase.PRODUCTION,
            state=PostingState.OPEN,
            currency="USD",
            scope=AskedScope.ALL,
            categories=[],
            cue_ids=[],
            lines=[],
            headings=[],
            created_by=world.producer_id,
        )
        session.add(posting)
        session.flush()
        session.add(
            Candidate(
                **of,
                posting_id=posting.id,
                email="another@example.test",
                person_id=world.other_designer_id,
                expires_at=clock.now(),
            )
        )

    world.server.in_database(invite)
    assert world.producer.get(of_candidate).status_code == 200
    assert world.other_designer.get(of_producer).status_code == 200
    assert world.stranger.get(of_candidate).status_code == 404


def test_another_picture_has_another_address(world: World) -> None:
    first = address(world.producer)
    second = address(world.producer, picture("PNG", colour="#0000ff"))
    assert first != second
    assert world.producer.get(first).status_code == 404
    assert world.producer.get(second).status_code == 200
    plain = world.producer.get(second.partition("?")[0])
    assert (plain.status_code, plain.headers["cache-control"]) == (200, "private, no-cache")


def test_it_is_taken_away(world: World) -> None:
    shown = address(world.producer)
    assert world.producer.delete("/v1/me/picture").status_code == 204
    assert world.producer.delete("/v1/me/picture").status_code == 204, "once more changes nothing"
    assert world.producer.get(shown).status_code == 404
    assert world.producer.get("/v1/me").json()["person"]["picture"] is None


def test_it_goes_with_the_account(world: World) -> None:
    def come_and_go(session: Session) -> PersonPicture | None:
        person = Person(email="short@example.test", name="Short")
        session.add(person)
        session.flush()
        session.add(PersonPicture(person_id=person.id, sha256="0", content=b"0"))
        session.flush()
        session.delete(person)
        session.flush()
        return session.scalar(select(PersonPicture).where(PersonPicture.person_id == person.id))

    assert world.server.in_database(come_and_go) is None


def _moving(form: str) -> bytes:
    out = io.BytesIO()
    frames = [Image.new("RGB", (8, 8), colour) for colour in ("red", "blue")]
    frames[0].save(out, form, save_all=True, append_images=frames[1:])
    return out.getvalue()


REFUSED = {
    "empty": (b"", "this is an empty file; a PNG, JPEG or WebP picture is wanted"),
    "a GIF": (picture("GIF"), "this is a GIF; a PNG, JPEG or WebP picture is wanted"),
    "a TIFF": (picture("TIFF"), "this is a TIFF picture"),
    "an SVG": (b'<?xml version="1.0"?>\n<svg xmlns="http://www.w3.org/2000/svg"/>', "this is an SVG drawing"),
    "HTML": (b"<!doctype html><script>fetch('/v1/me')</script>", "this is a page of markup"),
    "a text": (b"not a picture", "this is a file of another kind"),
    "HEIC": (b"\0\0\0\x18ftypheic" + bytes(40), "this is a HEIC picture"),
    "cut short": (RED[: len(RED) // 2], "this picture is damaged: its pixels cannot be read"),
    "no more than a head": (b"\x89PNG\r\n\x1a\n", "this picture is damaged: its pixels cannot be read"),
    "a moving PNG": (_moving("PNG"), "this picture moves: it has 2 frames; one is wanted"),
    "a moving WebP": (_moving("WEBP"), "this picture moves: it has 2 frames; one is wanted"),
    "too many pixels": (
        png(11_000, 11_000, b""),
        "this picture has 11,000 × 11,000 pixels; at most 25,000,000 are drawn, and 12,000 on a side",
    ),
    "a long side": (png(12_001, 1, b""), "this picture has 12,001 × 1 pixels"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_is_no_such_picture_is_refused_in_words(world: World, name: str) -> None:
    content, message = REFUSED[name]
    answer = save(world.producer, content)
    assert answer.status_code == 422, answer.text
    assert answer.json()["code"] == "picture-refused"
    assert answer.json()["detail"].startswith(message)
    assert "choose it again" in answer.json()["fix"]
    assert world.producer.get("/v1/me").json()["person"]["picture"] is None


@pytest.mark.slow
def test_a_bomb_of_the_largest_size_is_drawn_within_the_childs_memory(world: World) -> None:
    rows = zlib.compress((b"\0" + bytes(5_000)) * 5_000)
    assert len(rows) < 100_000
    assert world.producer.get(address(world.producer, png(5_000, 5_000))).status_code == 200


def test_a_file_of_20_mb_is_refused_before_it_is_read(world: World) -> None:
    answer = save(world.producer, bytes(20_000_000))
    assert answer.status_code == 413
    assert answer.json()["detail"] == "this request may have 10 MiB; this one has 19.1 MiB"
