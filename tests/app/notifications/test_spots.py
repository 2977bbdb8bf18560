"""Emails say which cue and what was said, and lead to the spot by a picture with a play button."""

import re
from collections.abc import Callable
from email.message import EmailMessage
from io import BytesIO
from typing import Any
from uuid import UUID

import pytest
import sqlalchemy as sa
from PIL import Image

from app.core import clock
from app.deliveries.models import Take
from app.notifications import mail_jobs
from app.notifications.audio_excerpts import service as spots
from app.notifications.audio_excerpts.drawing import draw
from app.notifications.audio_excerpts.rules import SpotPicture, html_of, spot_of
from app.notifications.models import Mail
from app.renders.models import Picture
from tests.app.reviews.making import Stage
from tests.support.mailbox import Mailbox, with_smtp
from tests.support.server import RunningServer, World

THUMB = {"points": 4, "min": [-127, -60, -20, 0], "max": [127, 60, 20, 0], "rms": [90, 40, 10, 0]}
SAID = "a duller clank <b>& less</b>"


@pytest.fixture(autouse=True)
def only_these_mails(server: RunningServer) -> None:
    earlier = sa.update(Mail).where(Mail.sent_at.is_(None)).values(sent_at=clock.now())
    server.in_database(lambda session: session.execute(earlier))


@pytest.fixture
def stage(world: World) -> Stage:
    return Stage(world)


@pytest.fixture
def sent(world: World, mailbox: Mailbox, smtp_url: str) -> Callable[[UUID], list[EmailMessage]]:
    """Send what waits, and return what a person received."""

    def send(person_id: UUID) -> list[EmailMessage]:
        world.server.wait_for_jobs()
        address = f"{person_id}@example.test"
        waiting = sa.select(Mail.id).where(Mail.recipient == address, Mail.sent_at.is_(None))
        for mail_id in world.server.in_database(lambda session: session.scalars(waiting).all()):
            mail_jobs.send_mail(with_smtp(world.server.runtime, smtp_url), {"mail_id": str(mail_id)})
        return mailbox.messages_for(address)

    return send


def draw_takes(world: World, *take_ids: UUID) -> None:
    """Give takes the shape that their drawing finds."""

    def write(session: Any) -> None:
        for take_id in take_ids:
            of_master = Picture.sound_sha256 == session.get_one(Take, take_id).master_sha256
            session.execute(sa.update(Picture).where(of_master).values(thumb=THUMB, duration_s=2.0))

    world.server.in_database(write)


def body_of(message: EmailMessage, kind: str) -> str:
    part = message.get_body((kind,))
    return str(part.get_content()) if part else ""


@pytest.mark.slow
def test_a_change_is_mailed_with_its_cue_its_words_and_a_picture_that_leads_to_its_spot(world, stage, sent):
    cue_id = stage.cue("shield_hit")
    take_id = stage.take(cue_id)
    draw_takes(world, take_id)
    stage.draft(take_id, SAID, start_s=1.25)
    stage.send("Once more.")
    (message,) = sent(world.designer_id)
    spot = f"{world.server.runtime.settings.base_url}/takes/{take_id}?at=1.25"
    plain, html = body_of(message, "plain"), body_of(message, "html")
    assert re.search(rf"shield_hit, version 1 at 1\.250 s: {re.escape(SAID)}\r?\n{re.escape(spot)}", plain)
    (cid,) = re.findall(rf'<a href="{re.escape(spot)}"><img src="cid:([^"]+)"', html)
    assert re.search(r'alt="Play \S+ shield_hit, version 1 from 1\.250 s"', html)
    assert "&lt;b&gt;&amp; less&lt;/b&gt;" in html
    assert "<b>" not in html
    (picture,) = [part for part in message.walk() if part.get_content_type() == "image/png"]
    assert picture["Content-ID"] == f"<{cid}>"
    assert Image.open(BytesIO(picture.get_content())).size == (640, 96)


@pytest.mark.slow
def test_a_mention_leads_to_review_and_an_answer_to_the_version(world, stage, sent):
    cue_id = stage.cue("shield_hit")
    take_id = stage.take(cue_id)
    draw_takes(world, take_id)
    body = {"text": "@Audio director, too sharp?", "start_s": 0.5, "mentions": [str(world.approver_id)]}
    answer = world.producer.post(f"/v1/takes/{take_id}/comments", json=body)
    assert answer.status_code == 201, answer.text
    html = "".join(body_of(message, "html") for message in sent(world.approver_id))
    assert f"/projects/{world.project_id}/review/{cue_id}?take={take_id}&amp;at=0.5" in html


@pytest.mark.slow
def test_a_sound_that_is_not_drawn_is_led_to_by_its_address_alone(world, stage, sent):
    take_id = stage.take(stage.cue("shield_hit"))
    world.server.in_database(lambda session: session.execute(sa.update(Picture).values(thumb={})))
    stage.draft(take_id, SAID, start_s=0.5)
    stage.send()
    (message,) = sent(world.designer_id)
    assert message.get_content_type() == "text/plain"
    assert f"/takes/{take_id}?at=0.5" in body_of(message, "plain")


def test_a_digest_has_the_pictures_too(world, stage, sent):
    body = {"cadences": {"sounds": "hourly"}, "time_zone": "UTC", "daily_at": "08:00"}
    world.designer.put("/v1/me/mail-preferences", json=body).raise_for_status()
    take_id = stage.take(stage.cue("shield_hit"))
    draw_takes(world, take_id)
    stage.draft(take_id, SAID)
    stage.send()
    world.server.wait_for_jobs()
    (digest,) = world.server.in_database(
        lambda session: session.scalars(sa.select(Mail).where(Mail.topic.startswith("digest:hourly"))).all()
    )
    address = f"{world.server.runtime.settings.base_url}/takes/{take_id}"
    assert set(digest.spots) == {address}
    assert address in digest.lines[0].split("\n")


@pytest.mark.slow
def test_a_mail_has_few_pictures_however_many_changes_were_sent(world, stage, sent):
    takes = [stage.take(stage.cue(f"hit_{number}")) for number in range(spots.MAX_PICTURES + 2)]
    draw_takes(world, *takes)
    for take_id in takes:
        stage.draft(take_id, SAID)
    stage.send()
    (message,) = sent(world.designer_id)
    assert sum(part.get_content_type() == "image/png" for part in message.walk()) == spots.MAX_PICTURES
    assert all(f"/takes/{take_id}" in body_of(message, "html") for take_id in takes)


@pytest.mark.slow
def test_an_address_typed_in_a_text_shows_no_picture_of_another_sound(world, stage, sent):
    mine, secret = stage.take(stage.cue("hit")), stage.take(stage.cue("secret"))
    draw_takes(world, mine, secret)
    stage.draft(mine, f"as in\n{world.server.runtime.settings.base_url}/takes/{secret}\nplease")
    stage.send()
    (message,) = sent(world.designer_id)
    assert sum(part.get_content_type() == "image/png" for part in message.walk()) == 1


def test_the_line_stands_at_the_spot() -> None:
    def first_orange_px(at_s: float) -> int:
        image = Image.open(BytesIO(draw(THUMB, duration_s=2.0, at_s=at_s))).convert("RGB")
        return next(x for x in range(96, 640) if image.getpixel((x, 1)) == (0xD9, 0x4B, 0x00))

    assert [first_orange_px(at_s) for at_s in (0.0, 1.0, 2.0, 9.0)] == [96, 363, 631, 631]


def test_an_address_is_escaped_in_html() -> None:
    spot = spot_of(UUID(int=1), 'a "quoted" <hit>', 0.25, project_id=UUID(int=2))
    address = f"http://localhost{spot.path}"
    html = html_of(f"x < y\n{address}", {address: SpotPicture(b"", "one@soundlist", spot.alt)})
    assert 'alt="Play a &quot;quoted&quot; &lt;hit&gt; from 0.250 s"' in html
    assert "x &lt; y" in html
