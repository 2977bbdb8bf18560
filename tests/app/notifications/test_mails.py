"""Mails: sent once, gathered by topic, kept until a real SMTP server has them."""

import re
import time
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from datetime import timedelta
from uuid import UUID, uuid4

import pytest
import sqlalchemy as sa
from httpx2 import Client
from sqlalchemy.orm import Session

from app.conformance import service as conformance
from app.core import clock
from app.deliveries.queries import take_by_id
from app.notifications import jobs, mail_jobs, service
from app.notifications.errors import MailBusy
from app.notifications.models import Mail
from app.notifications.rules import MailState, mail_state
from tests.support.deliver import add_cues, deliver
from tests.support.mailbox import Mailbox, with_smtp
from tests.support.server import RunningServer, World
from tests.support.waves import sine, wav_bytes


@pytest.fixture(autouse=True)
def no_earlier_mail(server: RunningServer) -> None:
    """Count the mails of earlier tests as sent: sending what waits would send each of theirs too."""
    earlier = sa.update(Mail).where(Mail.sent_at.is_(None)).values(sent_at=clock.now())
    server.in_database(lambda session: session.execute(earlier))


def outbox(world: World) -> list[dict[str, object]]:
    world.server.wait_for_jobs()
    answer = world.producer.get(f"/v1/studios/{world.studio_id}/outbox")
    assert answer.status_code == 200
    return list(answer.json()["mails"])


def invite(world: World, address: str) -> None:
    body = {"email": address, "kind": "contract", "note": "Six palette sounds first."}
    assert world.producer.post(f"/v1/projects/{world.project_id}/invitations", json=body).is_success


def test_without_a_server_the_invitation_waits_with_its_link(world: World):
    invite(world, "maker@example.test")
    (mail,) = outbox(world)
    assert mail["recipient"] == "maker@example.test"
    assert "/invitation/" in str(mail["link"])
    assert "Six palette sounds first." in str(mail["text"])
    assert mail["sent_at"] is None


def links_of(world: World, by: Client | None = None) -> dict[str, dict[str, object]]:
    world.server.wait_for_jobs()
    answer = (by or world.producer).get(f"/v1/projects/{world.project_id}/mailed-links")
    assert answer.status_code == 200, answer.text
    return {str(link["recipient"]): link for link in answer.json()["links"]}


def test_the_page_of_an_invitation_says_how_its_mail_stands(world: World, mailbox: Mailbox, smtp_url: str):
    maker, bidder, member = (f"{uuid4()}@example.test" for _ in range(3))
    invite(world, maker)
    posting = world.producer.post(f"/v1/projects/{world.project_id}/postings", json={"title": "Effects"}).json()
    path = f"/v1/postings/{posting['id']}"
    world.producer.post(f"{path}/candidates", json={"email": bidder})
    assert bidder not in links_of(world)  # mailed when it opens
    add_cues(world, {"name": "Door"})
    assert world.producer.post(f"{path}/open").is_success
    world.producer.post(f"/v1/studios/{world.studio_id}/invitations", json={"email": member, "roles": ["liaison"]})
    links = links_of(world)
    assert {str(link["state"]) for link in links.values()} == {"no_server"}
    assert links.keys() == {maker, bidder, member}
    assert "/posting/" in str(links[bidder]["link"])
    assert "/invitation/" in str(links[maker]["link"])
    candidates = world.producer.get(path).json()["candidates"]
    assert links[bidder]["of_id"] == candidates[0]["id"]
    assert world.designer.get(f"/v1/projects/{world.project_id}/mailed-links").status_code == 403
    assert world.stranger.get(f"/v1/projects/{world.project_id}/mailed-links").status_code == 404
    mail_jobs.send_pending(with_smtp(world.server.runtime, smtp_url))
    sent = links_of(world)[bidder]
    assert (sent["state"], sent["link"]) == ("sent", None)


@pytest.mark.parametrize(
    ("is_sent", "failure", "can_send", "state"),
    [
        (False, None, False, MailState.NO_SERVER),
        (False, "SMTPConnectError: refused", False, MailState.NO_SERVER),
        (False, None, True, MailState.WAITING),
        (False, "SMTPConnectError: refused", True, MailState.FAILED),
        (True, None, True, MailState.SENT),
        (True, None, False, MailState.SENT),
    ],
)
def test_a_mail_stands_by_its_server_and_its_failure(
    is_sent: bool, failure: str | None, can_send: bool, state: MailState
):
    assert mail_state(clock.now() if is_sent else None, failure, can_send=can_send) is state


@pytest.mark.slow
def test_once_a_server_is_set_what_waited_goes_out_once(world: World, mailbox: Mailbox, smtp_url: str):
    address = f"{uuid4()}@example.test"
    invite(world, address)
    shown = str(outbox(world)[0]["link"])
    runtime = with_smtp(world.server.runtime, smtp_url)
    mail_jobs.send_pending(runtime)
    mail_jobs.send_pending(runtime)
    (text,) = mailbox.texts_for(address)
    (mailed,) = re.findall(r"http\S+/invitation/[\w-]+", text.replace("=\r\n", "").replace("=3D", "="))
    assert mailed != shown, "a link that was seen elsewhere proves nothing about the address"
    statuses = [
        world.server.browser().get(f"/v1/invitations/{link.rpartition('/')[2]}").status_code for link in (mailed, shown)
    ]
    assert statuses == [200, 404]
    assert outbox(world)[0]["sent_at"] is not None


@pytest.mark.slow
def test_a_server_that_refuses_loses_nothing(world: World, mailbox: Mailbox, smtp_url: str):
    address = f"{uuid4()}@example.test"
    invite(world, address)
    outbox(world)
    runtime = with_smtp(world.server.runtime, smtp_url)
    mailbox.refuses = True
    mail_jobs.send_pending(runtime)
    (mail,) = [each for each in outbox(world) if each["recipient"] == address]
    assert (mail["sent_at"], "451" in str(mail["failure"])) == (None, True)
    mailbox.refuses = False
    mail_jobs.send_pending(runtime)
    assert len(mailbox.texts_for(address)) == 1


def test_a_link_is_handed_over_while_the_server_refuses_and_works_after_it_took_the_mail(
    world: World, mailbox: Mailbox, smtp_url: str
):
    address = f"{uuid4()}@example.test"
    invite(world, address)
    mail_id = str(links_of(world)[address]["mail_id"])
    path = f"/v1/mails/{mail_id}/link"
    assert world.producer.post(path).json()["code"] == "mail-not-failed"
    runtime = with_smtp(world.server.runtime, smtp_url)
    mailbox.refuses = True
    mail_jobs.send_pending(runtime)
    assert links_of(world)[address]["link"] is None
    assert world.designer.post(path).status_code in (403, 404)
    assert world.stranger.post(path).status_code == 404
    link = world.producer.post(path).json()["link"]
    assert world.producer.post(path).json()["link"] == link == links_of(world)[address]["link"]
    mail_jobs.send_pending(runtime)  # refused once more
    mailbox.refuses = False
    mail_jobs.send_pending(runtime)
    (text,) = mailbox.texts_for(address)
    assert link in text.replace("=\r\n", "").replace("=3D", "=")
    assert world.server.browser().get(f"/v1/invitations/{link.rpartition('/')[2]}").status_code == 200
    assert (links_of(world)[address]["state"], links_of(world)[address]["link"]) == ("sent", None)


def test_many_workers_send_one_mail(world: World, mailbox: Mailbox, smtp_url: str):
    address = f"{uuid4()}@example.test"
    invite(world, address)
    (mail,) = [each for each in outbox(world) if each["recipient"] == address]
    runtime = with_smtp(world.server.runtime, smtp_url)
    mailbox.takes_s = 0.3
    with ThreadPoolExecutor(4) as workers:
        tried = [workers.submit(mail_jobs.send_mail, runtime, {"mail_id": mail["id"]}) for _ in range(4)]
    failures = [attempt.exception() for attempt in tried]
    assert len(mailbox.texts_for(address)) == 1
    assert failures.count(None) == 1
    assert {type(failure) for failure in failures} == {type(None), MailBusy}, "the others come again later"
    mail_jobs.send_mail(runtime, {"mail_id": mail["id"]})
    assert len(mailbox.texts_for(address)) == 1


def test_a_mail_whose_worker_died_goes_out_later(world: World, mailbox: Mailbox, smtp_url: str):
    address = f"{uuid4()}@example.test"
    invite(world, address)
    (mail,) = [each for each in outbox(world) if each["recipient"] == address]
    runtime, mail_id = with_smtp(world.server.runtime, smtp_url), UUID(str(mail["id"]))
    world.server.in_database(lambda session: service.claim(session, mail_id))  # and is heard of no more
    with pytest.raises(MailBusy):
        mail_jobs.send_mail(runtime, {"mail_id": str(mail_id)})

    def let_time_pass(session: Session) -> None:
        session.get_one(Mail, mail_id).claimed_until = clock.now()

    world.server.in_database(let_time_pass)
    mail_jobs.send_mail(runtime, {"mail_id": str(mail_id)})
    assert len(mailbox.texts_for(address)) == 1


def of_checks(world: World) -> list[dict[str, object]]:
    return [
        mail
        for mail in outbox(world)
        if any(word in str(mail["subject"]) for word in ("returned by the check", "to review"))
    ]


def notify_checks(world: World) -> list[dict[str, object]]:
    """Notify of what checks said, as their job does some seconds later; return the mails."""
    world.server.wait_for_jobs()
    jobs.notify_checks(world.server.runtime, {"project_id": str(world.project_id), "event_id": str(uuid4())})
    return of_checks(world)


def deliver_pair(world: World, dbfs: float) -> list[str]:
    names = ["laser_fire_01.wav", "laser_fire_02.wav"]
    add_cues(world, {"name": "laser_fire", "variations": 2})
    for hz, name in zip((997, 1_009), names, strict=True):  # the same bytes would be the same take
        deliver(world, name, wav_bytes(sine(hz=hz, dbfs=dbfs, seconds=0.2)))
    return names


@pytest.mark.slow
@pytest.mark.parametrize(
    ("dbfs", "subject", "words"),
    [(0.0, "returned by the check", "0.00 dBFS"), (-6.0, "to review", "is ready for your review")],
)
def test_what_checks_said_is_notified_once_and_together(world: World, dbfs: float, subject: str, words: str):
    """However often it is asked for: both takes are lines of one mail, of which each stands there once."""
    names = deliver_pair(world, dbfs)
    notify_checks(world)
    (mail,) = notify_checks(world)
    person = world.designer_id if subject == "returned by the check" else world.approver_id
    assert mail["recipient"] == f"{person}@example.test"
    assert subject in str(mail["subject"])
    assert [str(mail["text"]).count(name) for name in names] == [1, 1]
    assert str(mail["text"]).count(words) == 2


@pytest.mark.slow
def test_a_delivery_schedules_few_notifications(world: World, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(conformance, "NOTIFY_EVERY_S", 3600.0)
    deliver_pair(world, -6.0)
    world.server.wait_for_jobs()
    mine = [job for job in world.server.runtime.queue.unfinished() if job.studio_id == world.studio_id]
    reported = [job.state for job in mine if job.name == "notifications.notify_checks"]
    assert reported == ["delayed"]


def test_a_process_schedules_a_notification_until_that_is_committed(world: World, monkeypatch: pytest.MonkeyPatch):
    delivered = deliver(world, "laser_fire.wav", wav_bytes(sine(hz=997, dbfs=-6.0, seconds=0.2)))
    asked: list[str] = []
    monkeypatch.setattr(conformance, "NOTIFY_EVERY_S", 1e10)  # the same for all of them
    monkeypatch.setattr(conformance, "publish", lambda *_, once, **__: asked.append(once))

    def ask(*, undo: bool) -> None:
        with suppress(ZeroDivisionError), world.server.runtime.database.writing() as session:
            take = take_by_id(session, UUID(str(delivered["id"])))
            assert take is not None
            conformance.schedule_notification(session, take)
            if undo:
                raise ZeroDivisionError("anything that undoes the transaction")

    ask(undo=True)
    ask(undo=False)
    ask(undo=False)
    assert len(asked) == 2


@pytest.mark.slow
def test_what_was_committed_too_late_to_be_notified_is_notified_by_the_chore(
    world: World, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setattr(conformance, "NOTIFY_EVERY_S", 3600.0)  # as if its job had run before
    deliver_pair(world, -6.0)
    world.server.wait_for_jobs()
    jobs.notify_overdue_checks(world.server.runtime, {})
    assert of_checks(world) == []
    monkeypatch.setattr(jobs, "NOTIFICATION_OVERDUE_AFTER", timedelta(0))
    jobs.notify_overdue_checks(world.server.runtime, {})
    (mail,) = of_checks(world)
    assert str(mail["text"]).count("is ready for your review") == 2


def test_an_event_delivered_twice_is_in_the_mail_once(world: World):
    event_id = str(uuid4())
    payload = {
        "event": "designer.invited", "event_id": event_id, "studio_id": str(world.studio_id),
        "recipient": "twice@example.test", "subject_name": "Shield Wing",
        "from_name": "Producer", "note": "",
    }  # fmt: skip
    mail_jobs.mail_link(world.server.runtime, payload)
    mail_jobs.mail_link(world.server.runtime, payload)
    assert [mail["recipient"] for mail in outbox(world)].count("twice@example.test") == 1


@pytest.mark.slow
def test_a_question_reaches_those_who_answer_and_the_answer_who_asked(world: World):
    (cue,) = add_cues(world, {"name": "coolant_splash"})
    asked = world.designer.post(f"/v1/cues/{cue['id']}/questions", json={"text": "A drop, a tool, a person?"})
    assert asked.is_success, asked.text
    answer = world.approver.post(f"/v1/questions/{asked.json()['id']}/answer", json={"text": "A tool."})
    assert answer.is_success, answer.text
    reported = {(mail["recipient"], mail["subject"]) for mail in outbox(world)}
    assert (f"{world.approver_id}@example.test", "Shield Wing: a question on the sound list") in reported
    assert (f"{world.designer_id}@example.test", "Shield Wing: your question is answered") in reported


def test_only_the_studios_producer_sees_the_outbox(world: World):
    path = f"/v1/studios/{world.studio_id}/outbox"
    assert world.reviewer.get(path).status_code == 403
    assert world.stranger.get(path).status_code == 404
    assert world.designer.get(path).status_code == 404
    assert world.nobody.get(path).status_code == 401


def test_mail_about_an_account_goes_to_its_owner_only(world: World):
    address = f"{world.approver_id}@example.test"
    assert world.nobody.post("/v1/password-resets", json={"email": address}).is_success
    assert not [mail for mail in outbox(world) if "password" in str(mail["subject"])]
    with world.server.runtime.database.reading() as session:
        reset = session.query(Mail).filter_by(recipient=address, studio_id=None).one()
    assert world.producer.post(f"/v1/mails/{reset.id}/send").status_code == 404
    assert isinstance(reset.id, UUID)


def test_two_jobs_that_notify_at_the_same_moment_write_one_mail(world: World):
    database, topic = world.server.runtime.database, f"approved:{uuid4()}"

    def notify(session: Session, event_id: str) -> None:
        service.write_mail(
            session,
            event_id=event_id,
            studio_id=world.studio_id,
            topic=topic,
            recipient="maker@example.test",
            subject="sounds approved",
            lines=[event_id],
            send_after=clock.now() + timedelta(hours=1),
        )

    def second() -> None:
        with database.writing() as session:
            notify(session, "second")

    with ThreadPoolExecutor(1) as other:
        with database.writing() as session:
            notify(session, "first")
            sending = other.submit(second)
            time.sleep(0.3)  # the second looks for an open mail, and finds none that is committed
        sending.result(timeout=300)
    (mail,) = [each for each in outbox(world) if each["recipient"] == "maker@example.test"]
    assert str(mail["text"]).startswith("first\n\nsecond")
