"""The address of an account changes once its holder has confirmed it from the old address and from the new one."""

from collections.abc import Iterator
from datetime import timedelta
from typing import Any

import pytest
import sqlalchemy as sa
from httpx2 import Client

from app.accounts.models import EmailChange, Person
from app.accounts.rules import AddressProof
from app.core import clock
from tests.app.accounts.test_sign_in import PASSWORD, address, sign_up, with_csrf
from tests.app.notifications.test_security_mails import mails_to
from tests.support.server import RunningServer
from tests.support.smtp import MailServer, mail_server


@pytest.fixture
def mails(server: RunningServer) -> Iterator[MailServer]:
    """Let the server send mail to a server of the test's own."""
    with mail_server(server) as mails:
        yield mails


class Change:
    """An account whose holder has asked for another address."""

    def __init__(self, server: RunningServer, mails: MailServer) -> None:
        self.server, self.mails, self.browser = server, mails, server.browser()
        self.old, self.new = address(), address()
        smtp_url, server.runtime.settings.smtp_url = server.runtime.settings.smtp_url, ""
        assert sign_up(self.browser, self.old).status_code == 201
        server.runtime.settings.smtp_url = smtp_url
        with_csrf(self.browser)
        self.asked = self.browser.post("/v1/me/email-change", json={"email": f" {self.new.upper()} "})

    def confirm(self, recipient: str, browser: Client | None = None) -> Any:
        return (browser or self.browser).post(f"/v1/email-changes/{self.mails.secret_for(recipient)}/confirm")

    def me(self) -> str:
        email: str = self.browser.get("/v1/me").json()["email"]
        return email


@pytest.fixture
def change(server: RunningServer, mails: MailServer) -> Change:
    change = Change(server, mails)
    assert change.asked.status_code == 202, change.asked.text
    return change


@pytest.mark.parametrize("is_new_first", [False, True])
def test_it_changes_once_both_ends_have_confirmed(change: Change, is_new_first: bool) -> None:
    server, other = change.server, change.server.browser()
    body = {"email": change.old, "password": PASSWORD}
    assert other.post("/v1/sign-in", json=body).status_code == 200
    first, second = (change.new, change.old) if is_new_first else (change.old, change.new)
    assert change.confirm(first).json()["email"] == change.old
    assert change.confirm(first).json()["email"] == change.old  # twice is not both
    pending = change.browser.get("/v1/me/email-change").json()
    assert (pending["new_email"], pending["old_confirmed"], pending["new_confirmed"]) == (
        change.new,
        not is_new_first,
        is_new_first,
    )
    assert change.me() == change.old
    assert change.confirm(second).json()["email"] == change.new
    assert (change.me(), change.browser.get("/v1/me/email-change").json()) == (change.new, None)
    with server.runtime.database.reading() as session:
        person = session.scalars(sa.select(Person).where(Person.email == change.new)).one()
        assert person.email_proof is AddressProof.MAIL
    # Other browsers are signed out, the old address signs in no more, and both addresses are told.
    assert other.get("/v1/me").status_code == 401
    assert server.browser().post("/v1/sign-in", json=body).status_code == 401
    assert server.browser().post("/v1/sign-in", json=body | {"email": change.new}).status_code == 200
    for recipient in (change.old, change.new):
        assert "The email of your account was changed" in mails_to(server, recipient)


def test_either_end_stops_it_without_signing_in(change: Change) -> None:
    secret = change.mails.secret_for(change.old)
    nobody = change.server.browser()
    shown = nobody.get(f"/v1/email-changes/{secret}").json()
    assert (shown["new_email"], shown["is_new_end"], shown["is_confirmed"]) == (change.new, False, False)
    assert nobody.post(f"/v1/email-changes/{secret}/confirm").status_code == 401
    new_secret = change.mails.secret_for(change.new)
    assert nobody.delete(f"/v1/email-changes/{secret}").status_code == 204
    for stopped in (secret, new_secret):
        answer = change.browser.post(f"/v1/email-changes/{stopped}/confirm")
        assert (answer.status_code, answer.json()["code"]) == (404, "email-change-not-found")
    assert change.me() == change.old


def test_another_account_does_not_confirm_it(change: Change) -> None:
    stranger = change.server.browser()
    smtp_url, change.server.runtime.settings.smtp_url = change.server.runtime.settings.smtp_url, ""
    assert sign_up(stranger, address()).status_code == 201
    change.server.runtime.settings.smtp_url = smtp_url
    assert change.confirm(change.new, with_csrf(stranger)).json()["code"] == "email-change-not-found"
    assert change.me() == change.old


def test_an_address_with_an_account_is_told_to_its_reader_alone(change: Change) -> None:
    smtp_url, change.server.runtime.settings.smtp_url = change.server.runtime.settings.smtp_url, ""
    assert sign_up(change.server.browser(), change.new).status_code == 201
    change.server.runtime.settings.smtp_url = smtp_url
    again = change.browser.post("/v1/me/email-change", json={"email": change.new})
    assert (again.status_code, again.json()["new_confirmed"]) == (202, False)
    assert change.confirm(change.old).status_code == 200
    assert change.confirm(change.new).json()["code"] == "address-taken"
    assert change.me() == change.old


def test_it_ends_after_a_day_and_with_the_next_one(change: Change) -> None:
    first = change.mails.secret_for(change.old)
    assert change.browser.post("/v1/me/email-change", json={"email": change.old}).json()["code"] == "same-address"
    assert change.browser.post("/v1/me/email-change", json={"email": address()}).status_code == 202
    assert change.browser.post(f"/v1/email-changes/{first}/confirm").status_code == 404
    second = change.mails.secret_for(change.old)
    ended = sa.update(EmailChange).values(expires_at=clock.now() - timedelta(seconds=1))
    change.server.in_database(lambda session: session.execute(ended))
    assert change.browser.get("/v1/me/email-change").json() is None
    assert change.browser.post(f"/v1/email-changes/{second}/confirm").status_code == 404
