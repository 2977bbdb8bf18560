"""An address means something once its holder has followed a link that was mailed to it."""

from collections.abc import Callable, Iterator
from typing import Any
from uuid import uuid4

import pytest
from httpx2 import Client
from sqlalchemy import select
from typer.testing import CliRunner

from app.accounts import operators
from app.accounts.errors import AddressNotVerified, OperatorNotFound
from app.accounts.models import EmailVerification, Person
from app.accounts.rules import AddressProof
from app.cli import cli
from app.core import clock
from app.notifications.models import Mail
from tests.app.accounts.test_sign_in import PASSWORD, address, desk_token, sign_in, sign_up, with_csrf
from tests.app.core.test_queue import until
from tests.support.links import secret_for
from tests.support.server import RunningServer, World
from tests.support.smtp import MailServer, mail_server


@pytest.fixture
def mails(server: RunningServer) -> Iterator[MailServer]:
    with mail_server(server) as box:
        yield box


@pytest.fixture
def account(server: RunningServer) -> tuple[Client, str]:
    browser, email = server.browser(), address()
    assert sign_up(browser, email).status_code == 201
    return with_csrf(browser), email


def proof_of(server: RunningServer, email: str) -> AddressProof | None:
    with server.runtime.database.reading() as session:
        return session.scalars(select(Person).where(Person.email == email)).one().email_proof


def ask_link(browser: Client) -> int:
    return browser.post("/v1/me/email-verifications").status_code


@pytest.mark.slow
def test_a_new_account_is_not_verified(server: RunningServer, account: tuple[Client, str]) -> None:
    assert account[0].get("/v1/me").json()["email_verified_at"] is None
    assert proof_of(server, account[1]) is None


@pytest.mark.slow
def test_the_mailed_link_verifies_once(server: RunningServer, account: tuple[Client, str], mails: MailServer) -> None:
    browser, email = account
    assert ask_link(browser) == 202
    path = f"/v1/email-verifications/{mails.secret_for(email)}"
    assert browser.post(path).json()["email_verified_at"] is not None
    assert proof_of(server, email) is AddressProof.MAIL
    assert browser.post(path).json()["code"] == "verification-not-found"
    assert browser.post("/v1/me/email-verifications").json()["code"] == "already-verified"


@pytest.mark.slow
def test_the_link_verifies_nobody_elses_account(
    server: RunningServer, account: tuple[Client, str], mails: MailServer
) -> None:
    """Opening an account with a stranger's address gains nothing by the stranger's click."""
    browser, email = account
    ask_link(browser)
    path = f"/v1/email-verifications/{mails.secret_for(email)}"
    assert server.browser().post(path).status_code == 401
    stranger = server.browser()
    settings = server.runtime.settings
    smtp_url, settings.smtp_url = settings.smtp_url, ""
    assert sign_up(stranger, address()).status_code == 201
    settings.smtp_url = smtp_url
    assert with_csrf(stranger).post(path).json()["code"] == "verification-not-found"
    assert proof_of(server, email) is None


@pytest.mark.slow
def test_a_link_asked_for_again_replaces_the_one_before(account: tuple[Client, str], mails: MailServer) -> None:
    browser, email = account
    ask_link(browser)
    first = mails.secret_for(email)
    ask_link(browser)
    second = mails.secret_for(email)
    assert browser.post(f"/v1/email-verifications/{first}").status_code == 404
    assert browser.post(f"/v1/email-verifications/{second}").status_code == 200


def test_a_link_grows_old(server: RunningServer, account: tuple[Client, str], mails: MailServer) -> None:
    browser, email = account
    ask_link(browser)
    secret = mails.secret_for(email)
    with server.runtime.database.writing() as session:
        for asked in session.scalars(select(EmailVerification)):
            asked.expires_at = clock.now()
    assert browser.post(f"/v1/email-verifications/{secret}").status_code == 404


def test_without_a_mail_server_the_command_line_reads_the_link(
    server: RunningServer, account: tuple[Client, str], soundlist: Callable[..., Any]
) -> None:
    browser, email = account
    ask_link(browser)
    server.wait_for_jobs()
    ran = soundlist("mails", email)
    (line,) = ran.stdout.splitlines()
    recipient, _, link = line.split("\t")
    assert recipient == email
    assert browser.post(f"/v1/email-verifications/{link.rpartition('/')[2]}").status_code == 200
    assert proof_of(server, email) is AddressProof.OPERATOR


def test_a_new_password_by_mail_verifies_too(
    server: RunningServer, account: tuple[Client, str], mails: MailServer
) -> None:
    assert server.browser().post("/v1/password-resets", json={"email": account[1]}).status_code == 202
    secret = mails.secret_for(account[1])
    assert server.browser().post(f"/v1/password-resets/{secret}", json={"password": "staple correct horse"}).is_success
    assert proof_of(server, account[1]) is AddressProof.MAIL


def accept_studio_invitation(server: RunningServer, world: World, secret: str) -> None:
    body = {"name": "Reviewer", "password": PASSWORD}
    answer = server.browser().post(f"/v1/studio-invitations/{secret}/accept", json=body)
    assert answer.is_success, answer.text


def invite(world: World, email: str) -> None:
    body = {"email": email, "roles": ["reviewer"]}
    assert world.producer.post(f"/v1/studios/{world.studio_id}/invitations", json=body).is_success


@pytest.mark.slow
def test_an_invitation_that_was_only_mailed_verifies(world: World, mails: MailServer) -> None:
    email = address()
    invite(world, email)
    accept_studio_invitation(world.server, world, mails.secret_for(email))
    assert proof_of(world.server, email) is AddressProof.MAIL


def test_an_invitation_that_the_outbox_showed_verifies_nothing(world: World) -> None:
    email = address()
    invite(world, email)
    accept_studio_invitation(world.server, world, secret_for(world.server, email))
    assert proof_of(world.server, email) is None


@pytest.mark.slow
def test_a_link_that_the_outbox_showed_is_invalid_once_it_is_mailed(world: World) -> None:
    email = address()
    invite(world, email)
    shown = secret_for(world.server, email)
    with mail_server(world.server) as mails:
        mailed = mails.secret_for(email)
        assert world.nobody.get(f"/v1/studio-invitations/{shown}").status_code == 404
        assert world.nobody.get(f"/v1/studio-invitations/{mailed}").status_code == 200


@pytest.mark.slow
def test_a_mailed_secret_stands_nowhere_in_the_database(world: World, mails: MailServer) -> None:
    email = address()
    invite(world, email)
    secret = mails.secret_for(email)
    outbox = world.producer.get(f"/v1/studios/{world.studio_id}/outbox")
    assert secret not in outbox.text
    (mail,) = [each for each in outbox.json()["mails"] if each["recipient"] == email]
    assert (mail["link"], mail["sent_at"] is None) == (None, False)
    engine = world.server.runtime.database.engine
    if engine.dialect.name == "sqlite":
        with engine.connect() as connection:
            dump = "\n".join(connection.connection.dbapi_connection.iterdump())  # type: ignore[union-attr]
        assert email in dump
        assert secret not in dump  # nor in what jobs were given
    with world.server.runtime.database.reading() as session:
        assert session.scalars(select(Mail.link).where(Mail.recipient == email)).one() is None


def test_while_a_mail_server_is_set_no_waiting_link_is_shown(world: World, mails: MailServer) -> None:
    email = address()
    mails.refuses = True
    invite(world, email)

    def refused() -> list[dict[str, Any]]:
        mails_now = world.producer.get(f"/v1/studios/{world.studio_id}/outbox").json()["mails"]
        return [each for each in mails_now if each["recipient"] == email and each["failure"]]

    until(lambda: bool(refused()))
    (mail,) = refused()
    assert (mail["link"], mail["sent_at"], "550" in mail["failure"]) == (None, None, True)
    assert "/join/" not in mail["text"]


@pytest.fixture
def soundlist(server: RunningServer, monkeypatch: pytest.MonkeyPatch) -> Callable[..., Any]:
    """Run the command line on the server's database."""
    settings = server.runtime.settings
    monkeypatch.setenv("SOUNDLIST_DATA_DIR", str(settings.data_dir))
    monkeypatch.setenv("SOUNDLIST_DATABASE_URL", settings.database_url)
    return lambda *arguments: CliRunner().invoke(cli, arguments)


@pytest.mark.slow
def test_an_operator_is_named_by_the_command_line_alone(
    server: RunningServer, account: tuple[Client, str], mails: MailServer, soundlist: Callable[..., Any]
) -> None:
    browser, email = account
    refused = soundlist("operators", "add", email)
    assert refused.exit_code == 2
    assert f"{email} is not verified" in refused.stderr
    assert f"soundlist mails {email}" in refused.stderr
    assert browser.get("/v1/operations").status_code == 403
    ask_link(browser)
    browser.post(f"/v1/email-verifications/{mails.secret_for(email)}")
    assert browser.get("/v1/operations").status_code == 403
    assert soundlist("operators", "add", email.upper()).stdout == f"{email} is an operator now\n"
    assert browser.get("/v1/operations").status_code == 200
    assert browser.get("/v1/me").json()["is_operator"] is True
    assert email in soundlist("operators", "list").stdout
    assert soundlist("operators", "remove", email).exit_code == 0
    assert browser.get("/v1/operations").status_code == 403


@pytest.mark.slow
def test_the_command_line_signs_an_account_out_everywhere(
    server: RunningServer, account: tuple[Client, str], world: World, soundlist: Callable[..., Any]
) -> None:
    browser, email = account
    other = server.browser()
    assert sign_in(other, email).status_code == 200
    token = desk_token(server, browser)
    assert soundlist("sign-out", email.upper()).stdout == f"{email} is signed out everywhere\n"
    assert [each.get("/v1/me").status_code for each in (browser, other)] == [401, 401]
    assert token() == 401
    assert world.producer.get("/v1/me").status_code == 200
    assert sign_in(server.browser(), email).status_code == 200
    unknown = soundlist("sign-out", "unknown@example.test")
    assert (unknown.exit_code, "no account has the address" in unknown.stderr) == (2, True)


def test_an_operator_has_an_account(server: RunningServer) -> None:
    with server.runtime.database.writing() as session:
        for change in (operators.add_operator, operators.remove_operator):
            with pytest.raises(OperatorNotFound):
                change(session, f"{uuid4()}@example.test")


def test_nobody_is_an_operator_by_an_unverified_address(server: RunningServer, world: World) -> None:
    with server.runtime.database.writing() as session, pytest.raises(AddressNotVerified):
        operators.add_operator(session, f"{world.producer_id}@example.test")


def test_signing_in_still_works_for_who_is_not_verified(server: RunningServer, account: tuple[Client, str]) -> None:
    assert sign_in(server.browser(), account[1]).status_code == 200
