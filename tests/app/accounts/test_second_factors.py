"""A password alone does not sign in where an authenticator app is set up."""

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from datetime import UTC, datetime, timedelta
from typing import Any
from xml.etree import ElementTree as ET

import pyotp
import pytest
import sqlalchemy as sa
from httpx2 import Client
from typer.testing import CliRunner

from app.accounts import rate_limits
from app.accounts.authentication import RECENT_SIGN_IN, SESSION_COOKIE
from app.accounts.models import Person, RecoveryCode, SignIn, TotpFactor
from app.accounts.second_factors.rules import RECOVERY_CODES, accepted_step, new_recovery_codes, plain_code
from app.cli import cli
from app.core import clock
from tests.app.accounts.test_sign_in import NEW_PASSWORD, PASSWORD, address, sign_up, with_csrf
from tests.app.notifications.test_security_mails import mails_to
from tests.support.links import secret_for
from tests.support.server import RunningServer, World

NOON = datetime(2026, 11, 29, 12, 0, tzinfo=UTC)
SECRET = "GEZDGNBVGY3TQOJQGEZDGNBVGY3TQOJQ"


@pytest.fixture
def at(monkeypatch: pytest.MonkeyPatch) -> Callable[[timedelta], datetime]:
    """Stop the clock, and let it be set ahead: the same code is always as old, however slow the machine."""
    start = clock.now()

    def set_ahead(by: timedelta) -> datetime:
        moment = start + by
        monkeypatch.setattr(clock, "now", lambda: moment)
        return moment

    set_ahead(timedelta())
    return set_ahead


class Account:
    """A person with an authenticator app."""

    def __init__(self, server: RunningServer) -> None:
        self.server, self.browser, self.email = server, server.browser(), address()
        assert sign_up(self.browser, self.email).status_code == 201
        with_csrf(self.browser)
        self.setup = self.browser.post("/v1/me/totp").json()
        confirmed = self.browser.post("/v1/me/totp/confirm", json={"code": self.code()})
        assert confirmed.status_code == 200, confirmed.text
        self.recovery_codes: list[str] = confirmed.json()["recovery_codes"]

    def code(self) -> str:
        """Return what the app shows now."""
        return pyotp.TOTP(self.setup["secret"]).at(clock.now())

    def sign_in(self, code: str | None = None, browser: Client | None = None, password: str = PASSWORD) -> Any:
        body = {"email": self.email, "password": password} | ({"code": code} if code is not None else {})
        return (browser or self.server.browser()).post("/v1/sign-in", json=body)


@pytest.fixture
def account(server: RunningServer, at: Callable[[timedelta], datetime]) -> Account:
    return Account(server)


def test_codes_are_those_of_the_standard_and_count_once() -> None:
    # RFC 6238, appendix B: at 59 s the eight digits are 94287082, of which apps show the last six.
    moment = datetime.fromtimestamp(59, UTC)
    assert accepted_step(SECRET, "287082", moment, last_step=0) == 1
    assert accepted_step(SECRET, "287082", moment, last_step=1) is None
    assert accepted_step(SECRET, "287083", moment, last_step=0) is None
    # Shown from 30 s to 60 s, and taken half a minute around that.
    for seconds, is_right in ((-1, False), (1, True), (89, True), (91, False)):
        step = accepted_step(SECRET, "287082", datetime.fromtimestamp(seconds, UTC), last_step=0)
        assert (step == 1) is is_right, seconds
    assert accepted_step(SECRET, "２８７０８２", moment, last_step=0) is None


def test_recovery_codes_have_eighty_bits_and_are_read_as_people_type_them() -> None:
    codes = new_recovery_codes()
    assert len(set(codes)) == RECOVERY_CODES
    assert all(len(plain_code(code)) * 5 == 80 for code in codes)
    assert plain_code(f" {codes[0].lower().replace('-', ' ')} ") == plain_code(codes[0])


def test_nothing_changes_before_a_code_confirms_the_app(server: RunningServer, at: object) -> None:
    browser, email = server.browser(), address()
    assert sign_up(browser, email).status_code == 201
    with_csrf(browser)
    setup = browser.post("/v1/me/totp").json()
    assert pyotp.parse_uri(setup["uri"]).provisioning_uri() == setup["uri"]
    assert f"secret={setup['secret']}" in setup["uri"]
    assert ET.fromstring(setup["qr_svg"]).tag == "{http://www.w3.org/2000/svg}svg"  # noqa: S314  our own
    assert browser.post("/v1/me/totp/confirm", json={"code": "000000x"}).json()["code"] == "wrong-second-factor"
    assert browser.get("/v1/me/second-factors").json() == {"totp_since": None, "recovery_codes_left": 0}
    assert server.browser().post("/v1/sign-in", json={"email": email, "password": PASSWORD}).status_code == 200


def test_signing_in_asks_for_the_code_and_takes_it_once(account: Account, at: Callable[[timedelta], datetime]) -> None:
    refused = account.sign_in()
    assert (refused.status_code, refused.json()["code"]) == (401, "second-factor-needed")
    assert SESSION_COOKIE not in refused.cookies
    # The code that confirmed the app counts as used too.
    assert account.sign_in(account.code()).json()["code"] == "wrong-second-factor"
    at(timedelta(seconds=30))
    assert account.sign_in(account.code(), password=NEW_PASSWORD).json()["code"] == "wrong-sign-in"
    assert account.sign_in(f"{account.code()[:3]} {account.code()[3:]}").status_code == 200
    replayed = account.sign_in(account.code())
    assert (replayed.status_code, replayed.json()["code"]) == (403, "wrong-second-factor")


def test_of_two_sign_ins_with_the_same_code_at_once_one_succeeds(
    account: Account, at: Callable[[timedelta], datetime]
) -> None:
    at(timedelta(seconds=30))
    code = account.code()
    with ThreadPoolExecutor(2) as pool:
        statuses = sorted(answer.status_code for answer in pool.map(lambda _: account.sign_in(code), range(2)))
    assert statuses == [200, 403]


def test_a_recovery_code_signs_in_once_and_is_kept_as_a_hash(account: Account) -> None:
    code = account.recovery_codes[0]
    assert account.sign_in(code.lower()).status_code == 200
    assert account.sign_in(code).json()["code"] == "wrong-second-factor"
    assert account.browser.get("/v1/me/second-factors").json()["recovery_codes_left"] == RECOVERY_CODES - 1
    with account.server.runtime.database.reading() as session:
        stored = set(session.scalars(sa.select(RecoveryCode.code_sha256)))
        sealed = set(session.scalars(sa.select(TotpFactor.sealed_secret)))
    assert not stored & {plain for code in account.recovery_codes for plain in (code, plain_code(code))}
    assert not any(account.setup["secret"].encode() in secret for secret in sealed)
    subjects = mails_to(account.server, account.email)
    assert subjects.count("The second factor of your account") == 2  # set up, and a recovery code used


def test_new_recovery_codes_end_the_earlier_ones(account: Account) -> None:
    renewed = account.browser.post("/v1/me/recovery-codes").json()["recovery_codes"]
    assert account.sign_in(account.recovery_codes[1]).status_code == 403
    assert account.sign_in(renewed[1]).status_code == 200


def test_guesses_at_the_code_are_few_and_do_not_lock_the_owner_out(
    account: Account, at: Callable[[timedelta], datetime]
) -> None:
    at(timedelta(seconds=30))
    limit = rate_limits.SECOND_FACTORS_OF_ACCOUNT
    answers = []
    for _ in range(limit.burst + 1):
        answers.append(account.sign_in("000000x").status_code)
        with account.server.runtime.database.writing() as session:  # from as many places as one likes
            for kind in (rate_limits.SIGN_INS_FROM_NETWORK, rate_limits.SIGN_INS_TO_ACCOUNT):
                rate_limits.reset(session, kind, account.email)
            rate_limits.reset(session, rate_limits.SIGN_INS_TO_ACCOUNT_FROM_NETWORK, f"{account.email} testclient")
    assert answers == [403] * limit.burst + [429]
    assert account.sign_in(account.code(), browser=account.browser).status_code == 200


def test_confirming_the_app_signs_other_browsers_out(server: RunningServer, at: object) -> None:
    browser, email = server.browser(), address()
    assert sign_up(browser, email).status_code == 201
    other = server.browser()
    assert other.post("/v1/sign-in", json={"email": email, "password": PASSWORD}).status_code == 200
    with_csrf(browser)
    setup = browser.post("/v1/me/totp").json()
    code = pyotp.TOTP(setup["secret"]).at(clock.now())
    assert browser.post("/v1/me/totp/confirm", json={"code": code}).status_code == 200
    assert (browser.get("/v1/me").status_code, other.get("/v1/me").status_code) == (200, 401)


def test_ending_it_needs_a_recent_sign_in(account: Account) -> None:
    with account.server.runtime.database.writing() as session:
        person_id = session.scalars(sa.select(Person.id).where(Person.email == account.email)).one()
        aged = sa.update(SignIn).where(SignIn.person_id == person_id)
        session.execute(aged.values(created_at=clock.now() - RECENT_SIGN_IN - timedelta(minutes=1)))
    assert account.browser.delete("/v1/me/totp").json()["code"] == "recent-sign-in-needed"
    assert account.sign_in(account.recovery_codes[0], browser=account.browser).status_code == 200
    with_csrf(account.browser)
    assert account.browser.delete("/v1/me/totp").status_code == 204
    assert account.browser.delete("/v1/me/totp").json()["code"] == "no-second-factor"
    assert account.browser.get("/v1/me/second-factors").json() == {"totp_since": None, "recovery_codes_left": 0}
    assert account.sign_in().status_code == 200


def test_a_new_password_by_mail_does_not_pass_the_second_factor_by(
    account: Account, at: Callable[[timedelta], datetime]
) -> None:
    browser = account.server.browser()
    assert browser.post("/v1/password-resets", json={"email": account.email}).status_code == 202
    secret = secret_for(account.server, account.email)
    assert browser.post(f"/v1/password-resets/{secret}", json={"password": NEW_PASSWORD}).status_code == 200
    assert browser.get("/v1/me").status_code == 401
    at(timedelta(seconds=30))
    assert account.sign_in(account.code(), browser=browser, password=NEW_PASSWORD).status_code == 200


def test_an_invitation_with_the_password_does_not_pass_it_by(account: Account, world: World) -> None:
    path = f"/v1/studios/{world.studio_id}/invitations"
    assert world.producer.post(path, json={"email": account.email, "roles": ["reviewer"]}).status_code == 201
    secret = secret_for(account.server, account.email)
    stranger = account.server.browser()
    accept = f"/v1/studio-invitations/{secret}/accept"
    refused = stranger.post(accept, json={"password": PASSWORD})
    assert (refused.status_code, refused.json()["code"]) == (403, "sign-in-needed")
    assert "second factor" in refused.json()["detail"]
    assert account.browser.post(accept, json={}).status_code == 200  # who is signed in has shown it


def test_the_operator_takes_a_lost_one_away(account: Account, monkeypatch: pytest.MonkeyPatch) -> None:
    settings = account.server.runtime.settings
    monkeypatch.setenv("SOUNDLIST_DATA_DIR", str(settings.data_dir))
    monkeypatch.setenv("SOUNDLIST_DATABASE_URL", settings.database_url)
    command = ["accounts", "remove-second-factor"]
    removed = CliRunner().invoke(cli, [*command, account.email.upper()])
    assert removed.exit_code == 0, removed.output
    assert account.browser.get("/v1/me").status_code == 401
    assert account.sign_in().status_code == 200
    assert CliRunner().invoke(cli, [*command, account.email]).exit_code != 0
