"""Signing up: open or by invitation, and with a mail server without a word about who has an account."""

from collections.abc import Iterator

import pytest
from httpx2 import Client

from app.accounts.rules import AddressProof
from tests.app.accounts.test_addresses import proof_of
from tests.app.accounts.test_sign_in import NEW_PASSWORD, PASSWORD, address, sign_in, sign_up, with_csrf
from tests.support.server import RunningServer
from tests.support.smtp import MailServer, mail_server


@pytest.fixture
def mails(server: RunningServer) -> Iterator[MailServer]:
    with mail_server(server) as box:
        yield box


def ask(browser: Client, email: str) -> int:
    return browser.post("/v1/sign-ups", json={"email": email}).status_code


REST = {"name": "Producer", "password": PASSWORD, "studio_name": "Night Studio"}


@pytest.mark.slow
def test_the_mailed_link_opens_a_verified_account_once(server: RunningServer, mails: MailServer) -> None:
    browser, email = server.browser(), address()
    assert ask(browser, email.upper()) == 202
    path = f"/v1/sign-ups/{mails.secret_for(email)}"
    assert browser.get(path).json() == {"email": email}
    assert browser.post(path, json=REST).status_code == 201
    assert proof_of(server, email) is AddressProof.MAIL
    me = browser.get("/v1/me").json()
    assert [studio["name"] for studio in me["studios"]] == ["Night Studio"]
    assert server.browser().post(path, json=REST).json()["code"] == "sign-up-not-found"


@pytest.mark.slow
def test_known_and_unknown_are_one_answer_and_the_owner_is_notified(server: RunningServer, mails: MailServer) -> None:
    known, unknown = address(), address()
    ask(server.browser(), known)
    server.browser().post(f"/v1/sign-ups/{mails.secret_for(known)}", json=REST)
    answers = [server.browser().post("/v1/sign-ups", json={"email": email}) for email in (known, unknown)]
    assert answers[0].status_code == answers[1].status_code == 202
    assert answers[0].content == answers[1].content
    reported = mails.texts_for(known)[-1]
    assert "which already has one" in reported
    assert "/sign-up/" not in reported
    assert "/sign-up/" in mails.texts_for(unknown)[-1]


@pytest.mark.slow
@pytest.mark.parametrize("path", ["/v1/sign-ups", "/v1/password-resets"])
def test_the_request_itself_looks_nobody_up(server: RunningServer, mails: MailServer, path: str) -> None:
    """The same statements for a known and an unknown address, so the same time; the job finds out."""
    known, counts = address(), []
    ask(server.browser(), known)
    server.browser().post(f"/v1/sign-ups/{mails.secret_for(known)}", json=REST)
    for email in (known, address()):
        with server.counted_selects() as selects:
            assert server.browser().post(path, json={"email": email}).status_code == 202
        counts.append([" ".join(each.split()) for each in selects])
    assert counts[0] == counts[1]
    assert not [each for each in counts[0] if "accounts_people.email =" in each]


def test_a_weak_password_does_not_use_the_link_up(server: RunningServer, mails: MailServer) -> None:
    browser, email = server.browser(), address()
    ask(browser, email)
    path = f"/v1/sign-ups/{mails.secret_for(email)}"
    assert browser.post(path, json=REST | {"password": "1234567890"}).json()["code"] == "password-too-weak"
    assert browser.post(path, json=REST).status_code == 201


def test_with_a_mail_server_nobody_signs_up_without_the_mail(server: RunningServer, mails: MailServer) -> None:
    refused = sign_up(server.browser(), address())
    assert (refused.status_code, refused.json()["code"]) == (409, "verification-needed")


def test_without_a_mail_server_no_link_is_promised(server: RunningServer) -> None:
    refused = server.browser().post("/v1/sign-ups", json={"email": address()})
    assert (refused.status_code, refused.json()["code"]) == (409, "no-mail-server")
    assert server.browser().get("/v1/sign-up").json() == {"open": True, "by_mail": False, "setup_code": False}


def test_by_invitation_only_the_first_person_signs_up(server: RunningServer) -> None:
    settings = server.runtime.settings
    assert sign_up(server.browser(), address()).status_code == 201
    settings.sign_up = "invited"
    try:
        assert server.browser().get("/v1/sign-up").json()["open"] is False
        refused = sign_up(server.browser(), address())
        assert (refused.status_code, refused.json()["code"]) == (403, "sign-up-closed")
        assert "by invitation only" in refused.json()["detail"]
        with mail_server(server):
            assert ask(server.browser(), address()) == 403
    finally:
        settings.sign_up = "open"


@pytest.mark.slow
def test_a_new_password_of_an_unverified_holder_is_theirs_alone(server: RunningServer) -> None:
    """A person who opened an account with another's address loses it to the reader of that mail."""
    thief, email = server.browser(), address()
    assert sign_up(thief, email).status_code == 201
    with mail_server(server) as mails:
        server.browser().post("/v1/password-resets", json={"email": email})
        path = f"/v1/password-resets/{mails.secret_for(email)}"
        assert server.browser().post(path, json={"password": NEW_PASSWORD}).is_success
    assert with_csrf(thief).get("/v1/me").status_code == 401
    assert sign_in(server.browser(), email).status_code == 401
