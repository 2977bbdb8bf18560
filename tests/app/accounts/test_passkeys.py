"""A passkey signs in without password and code, and only its own answer to a fresh challenge does."""

from base64 import urlsafe_b64encode
from collections.abc import Iterator
from datetime import timedelta
from typing import Any

import pytest
import sqlalchemy as sa
from httpx2 import Client

from app.accounts.authentication import RECENT_SIGN_IN
from app.accounts.models import SignIn
from app.accounts.passkeys.rules import CHALLENGE_LIFETIME
from app.accounts.second_factors.rules import RECOVERY_CODES
from app.core import clock
from tests.app.accounts.test_sign_in import PASSWORD, address, sign_up, with_csrf
from tests.app.notifications.test_security_mails import mails_to
from tests.support.server import RunningServer
from tests.support.software_authenticator import USER_VERIFIED, SoftwareAuthenticator

ORIGIN = "http://127.0.0.1:8000"


class Account:
    """A person with a passkey."""

    def __init__(self, server: RunningServer, authenticator: SoftwareAuthenticator | None = None) -> None:
        self.server, self.browser, self.email = server, server.browser(), address()
        self.authenticator = authenticator or SoftwareAuthenticator(ORIGIN)
        assert sign_up(self.browser, self.email).status_code == 201
        with_csrf(self.browser)
        options = self.browser.post("/v1/me/passkeys/options").json()["public_key"]
        credential = self.authenticator.make(options)
        self.added = self.browser.post("/v1/me/passkeys", json={"name": "Phone", "credential": credential})


@pytest.fixture
def account(server: RunningServer) -> Account:
    account = Account(server)
    assert account.added.status_code == 201, account.added.text
    return account


def challenge(browser: Client) -> dict[str, Any]:
    options: dict[str, Any] = browser.post("/v1/passkeys/options").json()["public_key"]
    return options


def sign_in(browser: Client, credential: dict[str, Any]) -> Any:
    return browser.post("/v1/passkeys/sign-in", json={"credential": credential})


def test_it_signs_in_alone_and_its_use_is_shown(account: Account) -> None:
    assert len(account.added.json()["recovery_codes"]) == RECOVERY_CODES
    browser = account.server.browser()
    answer = sign_in(browser, account.authenticator.answer(challenge(browser)))
    assert (answer.status_code, answer.json()["email"]) == (200, account.email)
    (passkey,) = browser.get("/v1/me/passkeys").json()
    assert (passkey["name"], passkey["last_used_at"] is None) == ("Phone", False)
    assert "The second factor of your account" in mails_to(account.server, account.email)


def test_a_password_alone_does_not_sign_in_beside_a_passkey(account: Account) -> None:
    body = {"email": account.email, "password": PASSWORD}
    assert account.server.browser().post("/v1/sign-in", json=body).json()["code"] == "second-factor-needed"
    code = account.added.json()["recovery_codes"][0]
    assert account.server.browser().post("/v1/sign-in", json=body | {"code": code}).status_code == 200


def test_an_answer_counts_once_and_for_five_minutes(account: Account, monkeypatch: pytest.MonkeyPatch) -> None:
    browser = account.server.browser()
    options = challenge(browser)
    answer = account.authenticator.answer(options)
    assert sign_in(browser, answer).status_code == 200
    assert sign_in(browser, answer).json()["code"] == "passkey-refused"
    assert sign_in(browser, account.authenticator.answer(options)).json()["code"] == "passkey-refused"
    late, started = challenge(browser), clock.now()
    monkeypatch.setattr(clock, "now", lambda: started + CHALLENGE_LIFETIME + timedelta(minutes=1))
    assert "five minutes" in sign_in(browser, account.authenticator.answer(late)).json()["detail"]


def wrong_answers(account: Account, browser: Client) -> Iterator[tuple[str, dict[str, Any]]]:
    """Yield what somebody else, another page or a program could send, each to a challenge of its own."""
    mine = account.authenticator
    yield "another key", SoftwareAuthenticator(ORIGIN).answer(challenge(browser))
    mine.origin = "https://soundlist.example.evil"
    yield "another page", mine.answer(challenge(browser))
    mine.origin = ORIGIN
    yield "another host", mine.answer(challenge(browser) | {"rpId": "evil.example"})
    registration = account.browser.post("/v1/me/passkeys/options").json()["public_key"]
    yield (
        "our challenge for another purpose",
        mine.answer(challenge(browser) | {"challenge": registration["challenge"]}),
    )
    yield "a challenge of their own", mine.answer(challenge(browser) | {"challenge": "AAAA"})
    mine.flags &= ~USER_VERIFIED
    yield "a user who was not verified", mine.answer(challenge(browser))
    mine.flags |= USER_VERIFIED
    forger = SoftwareAuthenticator(ORIGIN)
    forger.credential_id = mine.credential_id
    yield "a signature by another key", forger.answer(challenge(browser))
    mine.sign_count = 0
    yield "a copy whose count fell behind", mine.answer(challenge(browser))


def test_nothing_but_its_own_answer_signs_in(account: Account) -> None:
    browser = account.server.browser()
    assert sign_in(browser, account.authenticator.answer(challenge(browser))).status_code == 200
    browser = account.server.browser()
    for kind, answer in wrong_answers(account, browser):
        refused = sign_in(browser, answer)
        assert (refused.status_code, refused.json()["code"]) == (422, "passkey-refused"), kind
    assert browser.get("/v1/me").status_code == 401


def test_a_malformed_answer_is_refused_and_never_an_error_of_the_server(account: Account) -> None:
    browser = account.server.browser()
    nested = urlsafe_b64encode(b"[" * 100_000).decode()
    made = account.authenticator.make(account.browser.post("/v1/me/passkeys/options").json()["public_key"])
    attestation = made["response"]["attestationObject"]
    for length in range(0, len(attestation), 7):
        cut = made | {"response": made["response"] | {"attestationObject": attestation[:length]}}
        refused = account.browser.post("/v1/me/passkeys", json={"name": "Cut", "credential": cut})
        assert (refused.status_code, refused.json()["code"]) == (422, "passkey-refused"), length
    for credential in (
        {},
        {"response": {"clientDataJSON": nested}},
        {"response": {"clientDataJSON": [1]}},
        {"response": None},
        {"id": None, "response": {}},
    ):
        assert sign_in(browser, credential).json()["code"] == "passkey-refused"
    options = challenge(browser)
    answer = account.authenticator.answer(options)
    for name in ("authenticatorData", "signature"):
        cut = answer | {"response": answer["response"] | {name: answer["response"][name][:20]}}
        assert sign_in(browser, cut).json()["code"] == "passkey-refused", name
    assert sign_in(browser, answer | {"id": 1}).json()["code"] == "passkey-refused"
    assert sign_in(browser, answer).status_code == 200


def test_a_device_that_does_not_verify_its_user_is_not_both_factors(server: RunningServer) -> None:
    refused = Account(server, SoftwareAuthenticator(ORIGIN, is_verifying=False)).added
    assert (refused.status_code, refused.json()["code"]) == (422, "passkey-refused")


def test_a_passkey_is_made_for_who_asked_and_belongs_to_one_account(account: Account) -> None:
    other = account.server.browser()
    assert sign_up(other, address()).status_code == 201
    with_csrf(other)
    options = account.browser.post("/v1/me/passkeys/options").json()["public_key"]
    body = {"name": "Theirs", "credential": SoftwareAuthenticator(ORIGIN).make(options)}
    assert other.post("/v1/me/passkeys", json=body).json()["code"] == "passkey-refused"
    own = other.post("/v1/me/passkeys/options").json()["public_key"]
    again = {"name": "Same", "credential": account.authenticator.make(own)}
    assert "belongs to an account" in other.post("/v1/me/passkeys", json=again).json()["detail"]


def test_a_further_passkey_signs_other_browsers_out(account: Account) -> None:
    other, tablet = account.server.browser(), SoftwareAuthenticator(ORIGIN)
    assert sign_in(other, account.authenticator.answer(challenge(other))).status_code == 200
    options = account.browser.post("/v1/me/passkeys/options").json()["public_key"]
    added = account.browser.post("/v1/me/passkeys", json={"name": "Tablet", "credential": tablet.make(options)})
    assert (added.status_code, added.json()["recovery_codes"]) == (201, [])
    assert (other.get("/v1/me").status_code, account.browser.get("/v1/me").status_code) == (401, 200)


def test_a_sign_in_by_passkey_is_recent(account: Account) -> None:
    ages_ago = sa.update(SignIn).values(created_at=clock.now() - RECENT_SIGN_IN - timedelta(minutes=1))
    account.server.in_database(lambda session: session.execute(ages_ago))
    renewal = account.browser.post("/v1/me/recovery-codes")
    assert (renewal.status_code, renewal.json()["code"]) == (403, "recent-sign-in-needed")
    answer = account.authenticator.answer(challenge(account.browser))
    assert sign_in(account.browser, answer).status_code == 200
    with_csrf(account.browser)
    assert account.browser.post("/v1/me/recovery-codes").status_code == 201


def test_a_removed_passkey_signs_nobody_in(account: Account) -> None:
    passkey_id = account.added.json()["id"]
    stranger = account.server.browser()
    assert sign_up(stranger, address()).status_code == 201
    assert with_csrf(stranger).delete(f"/v1/me/passkeys/{passkey_id}").status_code == 404
    assert account.browser.delete(f"/v1/me/passkeys/{passkey_id}").status_code == 204
    browser = account.server.browser()
    answer = account.authenticator.answer(challenge(browser))
    assert sign_in(browser, answer).json()["code"] == "passkey-refused"
    body = {"email": account.email, "password": PASSWORD}
    assert browser.post("/v1/sign-in", json=body).status_code == 200  # no second factor is left
