import importlib.util
from collections.abc import Callable
from types import SimpleNamespace
from uuid import uuid4

import pytest
from httpx import Response
from httpx2 import Client
from sqlalchemy import select

from app.accounts import passwords, rate_limits
from app.accounts.authentication import CSRF_COOKIE, SESSION_COOKIE
from app.accounts.models import PasswordReset, Person, SignIn, Token
from app.core import clock
from app.core.web.idempotency import SavedResponse
from tests.support.links import mailed_links, secret_for
from tests.support.server import RunningServer, World

PASSWORD = "correct horse battery"
NEW_PASSWORD = "staple correct horse"


def address() -> str:
    return f"producer-{uuid4().hex}@studio.example"


def sign_up(browser: Client, email: str) -> Response:
    body = {"email": email, "name": "Producer", "password": PASSWORD, "studio_name": "Night Studio"}
    return browser.post("/v1/sign-up", json=body)


def sign_in(browser: Client, email: str, password: str = PASSWORD) -> Response:
    return browser.post("/v1/sign-in", json={"email": email, "password": password})


def with_csrf(browser: Client) -> Client:
    browser.headers["X-CSRF-Token"] = browser.cookies[CSRF_COOKIE]
    return browser


@pytest.fixture
def account(server: RunningServer) -> tuple[Client, str]:
    """A browser that has signed up, and the address."""
    browser, email = server.browser(), address()
    assert sign_up(browser, email).status_code == 201
    return with_csrf(browser), email


def test_signing_up_opens_a_studio_and_signs_in(server: RunningServer) -> None:
    browser, email = server.browser(), address()
    answer = sign_up(browser, email.upper())
    assert answer.json()["email"] == email
    me = browser.get("/v1/me").json()
    assert [(studio["name"], studio["roles"]) for studio in me["studios"]] == [("Night Studio", ["producer"])]


def test_the_session_cookie_is_out_of_reach_of_scripts(server: RunningServer) -> None:
    answer = sign_up(server.browser(), address())
    cookies = {line.partition("=")[0]: line.lower() for line in answer.headers.get_list("set-cookie")}
    assert "httponly" in cookies[SESSION_COOKIE]
    assert "samesite=lax" in cookies[SESSION_COOKIE]
    assert "httponly" not in cookies[CSRF_COOKIE]


def test_secrets_are_kept_as_hashes_only(server: RunningServer, account: tuple[Client, str]) -> None:
    browser, email = account
    with server.runtime.database.reading() as session:
        person = session.scalars(select(Person).where(Person.email == email)).one()
        signed_in = session.scalars(select(SignIn).where(SignIn.person_id == person.id)).one()
        assert person.password_hash is not None
        assert person.password_hash.startswith("$argon2id$")
        assert signed_in.secret_sha256 != browser.cookies[SESSION_COOKIE]


def test_no_answer_with_a_secret_is_kept_for_replay(server: RunningServer) -> None:
    email, key = address(), uuid4().hex
    body = {"email": email, "name": "Producer", "password": PASSWORD, "studio_name": "Night Studio"}
    server.browser().post("/v1/sign-up", json=body, headers={"Idempotency-Key": key})
    with server.runtime.database.reading() as session:
        assert not [saved for saved in session.scalars(select(SavedResponse)) if email in (saved.body or "")]


def test_an_address_has_one_account(server: RunningServer, account: tuple[Client, str]) -> None:
    answer = sign_up(server.browser(), account[1])
    assert (answer.status_code, answer.json()["code"]) == (409, "address-taken")
    assert answer.json()["errors"][0]["where"] == "email"


@pytest.mark.parametrize(
    ("field", "value", "code"),
    [
        ("email", "no address", "bad-address"),
        ("password", "short", "password-too-weak"),
        ("name", "  ", "invalid-request"),
        ("name", "Two\nlines", "invalid-request"),
        ("name", "turned \u202e round", "invalid-request"),
        ("studio_name", "x" * 121, "invalid-request"),
    ],
)
def test_what_is_wrong_with_a_sign_up_is_reported_at_its_field(
    server: RunningServer, field: str, value: str, code: str
) -> None:
    body = {"email": address(), "name": "Producer", "password": PASSWORD, "studio_name": "Night Studio", field: value}
    problem = server.browser().post("/v1/sign-up", json=body).json()
    assert (problem["status"], problem["code"], problem["errors"][0]["where"]) == (422, code, field)


def test_signing_in_and_out(server: RunningServer, account: tuple[Client, str]) -> None:
    browser = server.browser()
    assert sign_in(browser, account[1]).status_code == 200
    assert browser.get("/v1/session").json()["signed_in"] is True
    session_cookie = browser.cookies[SESSION_COOKIE]
    assert with_csrf(browser).post("/v1/sign-out").status_code == 204
    assert SESSION_COOKIE not in browser.cookies
    thief = server.browser()
    thief.cookies.set(SESSION_COOKIE, session_cookie)
    assert thief.get("/v1/me").status_code == 401


def test_a_sign_in_ends_by_itself(server: RunningServer, account: tuple[Client, str]) -> None:
    browser, email = account
    with server.runtime.database.writing() as session:
        person = session.scalars(select(Person).where(Person.email == email)).one()
        for signed_in in session.scalars(select(SignIn).where(SignIn.person_id == person.id)):
            signed_in.expires_at = clock.now()
    assert browser.get("/v1/me").status_code == 401


def test_wrong_and_unknown_are_one_answer(server: RunningServer, account: tuple[Client, str]) -> None:
    wrong = sign_in(server.browser(), account[1], "not the password")
    unknown = sign_in(server.browser(), address(), "not the password")
    assert wrong.status_code == unknown.status_code == 401
    assert wrong.json()["code"] == unknown.json()["code"] == "wrong-sign-in"
    assert wrong.json()["detail"] == unknown.json()["detail"]


@pytest.mark.slow
def test_a_hash_costs_what_is_recommended() -> None:
    """Tests run with cheaper hashes: what a server has is in a module of its own."""
    spec = importlib.util.find_spec("app.accounts.passwords")
    assert spec is not None
    assert spec.loader is not None
    fresh = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(fresh)
    assert fresh.hash_of(PASSWORD).startswith("$argon2id$v=19$m=65536,t=3,p=4$")


def test_an_unknown_address_costs_a_hash_too(monkeypatch: pytest.MonkeyPatch) -> None:
    costs: list[str] = []

    def verify(password: str, password_hash: str) -> bool:
        costs.append(password_hash.rpartition("$")[0].rpartition("$")[0])  # algorithm, memory, rounds and threads
        return hasher.verify(password, password_hash)

    hasher = passwords._hasher
    known = passwords.hash_of(PASSWORD)
    monkeypatch.setattr(passwords, "_hasher", SimpleNamespace(hash=hasher.hash, verify=verify))
    assert not passwords.matches("another password", known)
    assert not passwords.matches("another password", None)
    assert costs[0].startswith("$argon2id$")
    assert costs == [costs[0]] * 2


@pytest.mark.slow
def test_guessing_is_slowed_down_and_says_for_how_long(server: RunningServer, account: tuple[Client, str]) -> None:
    for _ in range(10):
        assert sign_in(server.browser(), account[1], "a guess").status_code == 401
    answer = sign_in(server.browser(), account[1])
    assert (answer.status_code, answer.json()["code"]) == (429, "too-many-attempts")
    assert 0 < int(answer.headers["Retry-After"]) <= 300
    assert answer.headers["content-type"] == "application/problem+json"
    assert sign_in(server.browser(), address(), "a guess").status_code == 401  # others are not locked out


def test_being_right_clears_the_count(server: RunningServer, account: tuple[Client, str]) -> None:
    for _ in range(2):
        with server.runtime.database.writing() as session:
            for _ in range(9):
                limit = rate_limits.SIGN_INS_TO_ACCOUNT_FROM_NETWORK
                rate_limits.count_attempt(session, limit, f"{account[1]} testclient")
        assert sign_in(server.browser(), account[1]).status_code == 200


def test_a_write_needs_the_token_of_our_page(account: tuple[Client, str]) -> None:
    browser, _ = account
    del browser.headers["X-CSRF-Token"]
    answer = browser.put("/v1/me", json={"name": "Someone else"})
    assert (answer.status_code, answer.json()["code"]) == (403, "csrf-mismatch")
    answer = browser.put(
        "/v1/me", json={"name": "Someone else"}, headers={b"X-CSRF-Token": "wrong ümläut".encode("latin-1")}
    )
    assert answer.status_code == 403


@pytest.mark.parametrize("origin", ["https://evil.example", "null", "http://127.0.0.1:9999"])
def test_a_write_from_another_sites_page_is_refused(
    server: RunningServer, account: tuple[Client, str], origin: str
) -> None:
    browser, email = account
    assert browser.put("/v1/me", json={"name": "Renamed"}, headers={"Origin": origin}).status_code == 403
    body = {"email": email, "password": PASSWORD}
    assert server.browser().post("/v1/sign-in", json=body, headers={"Origin": origin}).status_code == 403


def test_a_write_from_our_own_page_passes(account: tuple[Client, str]) -> None:
    browser, _ = account
    answer = browser.put("/v1/me", json={"name": "Renamed"}, headers={"Origin": "http://127.0.0.1:8000"})
    assert answer.json()["name"] == "Renamed"


def test_a_page_that_starts_gets_its_token(server: RunningServer, account: tuple[Client, str]) -> None:
    browser = server.browser()
    browser.cookies.set(SESSION_COOKIE, account[0].cookies[SESSION_COOKIE])
    assert browser.get("/v1/session").json()["signed_in"] is True
    assert browser.cookies[CSRF_COOKIE] == account[0].cookies[CSRF_COOKIE]
    assert server.browser().get("/v1/session").json() == {"signed_in": False, "demo": False, "person": None}


def test_changing_the_password_ends_the_other_sign_ins(server: RunningServer, account: tuple[Client, str]) -> None:
    browser, email = account
    elsewhere = server.browser()
    sign_in(elsewhere, email)
    body = {"current": "not it, really", "new": NEW_PASSWORD}
    assert browser.put("/v1/me/password", json=body).json()["code"] == "wrong-password"
    body = {"current": PASSWORD, "new": "short"}
    assert browser.put("/v1/me/password", json=body).json()["code"] == "password-too-weak"
    assert elsewhere.get("/v1/me").status_code == 200
    assert browser.put("/v1/me/password", json={"current": PASSWORD, "new": NEW_PASSWORD}).status_code == 204
    assert browser.get("/v1/me").status_code == 200
    assert elsewhere.get("/v1/me").status_code == 401
    assert sign_in(server.browser(), email).status_code == 401
    assert sign_in(server.browser(), email, NEW_PASSWORD).status_code == 200


def desk_token(server: RunningServer, browser: Client) -> Callable[[], int]:
    """Make a desk token; return a function that asks for the desk with it, and returns the status."""
    made = browser.post("/v1/me/desk-tokens", json={"name": "Laptop"})
    assert made.status_code == 201, made.text
    bearer = {"Authorization": f"Bearer {made.json()['secret']}"}
    return lambda: server.browser().get("/v1/me/desk", headers=bearer).status_code


@pytest.mark.slow
def test_a_changed_password_ends_the_desk_tokens(server: RunningServer, account: tuple[Client, str]) -> None:
    browser, _ = account
    token = desk_token(server, browser)
    refused = browser.put("/v1/me/password", json={"current": "not it, really", "new": NEW_PASSWORD})
    assert refused.json()["code"] == "wrong-password"
    assert token() == 200
    assert browser.put("/v1/me/password", json={"current": PASSWORD, "new": NEW_PASSWORD}).status_code == 204
    assert token() == 401
    assert browser.get("/v1/me/desk-tokens").json() == []


def test_a_password_set_by_mail_ends_the_desk_tokens_of_that_person_alone(
    server: RunningServer, account: tuple[Client, str]
) -> None:
    browser, email = account
    other = server.browser()
    assert sign_up(other, address()).status_code == 201
    token, others = desk_token(server, browser), desk_token(server, with_csrf(other))
    server.browser().post("/v1/password-resets", json={"email": email})
    secret = secret_for(server, email)
    assert server.browser().post(f"/v1/password-resets/{secret}", json={"password": NEW_PASSWORD}).status_code == 200
    assert (token(), others()) == (401, 200)


def test_spaces_are_part_of_a_password(server: RunningServer, account: tuple[Client, str]) -> None:
    assert sign_in(server.browser(), account[1], f" {PASSWORD} ").status_code == 401


@pytest.mark.slow
def test_a_forgotten_password_is_reset_once_by_mail(server: RunningServer, account: tuple[Client, str]) -> None:
    browser, email = account
    secrets = []
    for _ in range(2):
        assert server.browser().post("/v1/password-resets", json={"email": email.upper()}).status_code == 202
        secrets.append(secret_for(server, email))  # one after the other: jobs of two events have no order
    first, second = secrets
    other = server.browser()
    answer = other.post(f"/v1/password-resets/{second}", json={"password": NEW_PASSWORD})
    assert answer.json()["email"] == email
    assert other.get("/v1/me").status_code == 200
    assert browser.get("/v1/me").status_code == 401  # the person signed in before is signed out
    for used in (first, second):
        answer = server.browser().post(f"/v1/password-resets/{used}", json={"password": PASSWORD})
        assert answer.json()["code"] == "reset-not-found"
    assert sign_in(server.browser(), email, NEW_PASSWORD).status_code == 200


def test_a_weak_new_password_does_not_use_the_link_up(server: RunningServer, account: tuple[Client, str]) -> None:
    server.browser().post("/v1/password-resets", json={"email": account[1]})
    path = f"/v1/password-resets/{secret_for(server, account[1])}"
    assert server.browser().post(path, json={"password": "short"}).status_code == 422
    assert server.browser().post(path, json={"password": NEW_PASSWORD}).status_code == 200


def test_a_link_for_a_new_password_grows_old(server: RunningServer, account: tuple[Client, str]) -> None:
    server.browser().post("/v1/password-resets", json={"email": account[1]})
    server.wait_for_jobs()
    with server.runtime.database.writing() as session:
        person = session.scalars(select(Person).where(Person.email == account[1])).one()
        session.scalars(
            select(PasswordReset).where(PasswordReset.person_id == person.id)
        ).one().expires_at = clock.now()
    path = f"/v1/password-resets/{secret_for(server, account[1])}"
    assert server.browser().post(path, json={"password": NEW_PASSWORD}).status_code == 404


def test_asking_for_a_new_password_does_not_reveal_who_has_an_account(
    server: RunningServer, account: tuple[Client, str]
) -> None:
    unknown = address()
    answers = [server.browser().post("/v1/password-resets", json={"email": email}) for email in (account[1], unknown)]
    assert answers[0].status_code == answers[1].status_code == 202
    assert answers[0].content == answers[1].content
    assert mailed_links(server, unknown) == []


def test_a_mailbox_cannot_be_flooded(server: RunningServer, account: tuple[Client, str]) -> None:
    asked = [server.browser().post("/v1/password-resets", json={"email": account[1]}).status_code for _ in range(6)]
    assert asked == [202] * 5 + [429]


@pytest.mark.slow
def test_a_revoked_or_unknown_token_is_nobody(server: RunningServer, world: World) -> None:
    path = f"/v1/projects/{world.project_id}/tokens"
    made = world.producer.post(path, json={"name": "CI", "scopes": ["spec:read"]}).json()
    build = server.browser()
    build.headers["Authorization"] = f"Bearer {made['secret']}"
    assert build.get(f"/v1/projects/{world.project_id}/spec.toml").status_code == 200
    with server.runtime.database.reading() as session:
        token = session.scalars(select(Token).where(Token.project_id == world.project_id)).one()
        assert token.last_used_at is not None
    assert world.producer.delete(f"{path}/{made['id']}").status_code == 204
    refused = build.get(f"/v1/projects/{world.project_id}/spec.toml")
    assert refused.status_code == 401
    assert refused.headers["WWW-Authenticate"] == "Bearer"
    for header in ("Bearer slt_unknown", "Basic dXNlcjpwYXNz", "Bearer"):
        build.headers["Authorization"] = header
        assert build.get("/v1/me").status_code == 401
