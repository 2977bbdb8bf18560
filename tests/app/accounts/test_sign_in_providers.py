"""A provider signs in whom it vouches for, by addresses of domains bound to its studio, and nobody else."""

import re
import shutil
import subprocess
from base64 import b64decode
from collections.abc import Iterator
from datetime import timedelta
from pathlib import Path
from typing import Any
from urllib.parse import parse_qs, unquote, urljoin, urlsplit
from uuid import UUID, uuid4

import httpx
import pyotp
import pytest
import sqlalchemy as sa
from httpx import Response
from httpx2 import Client
from joserfc.jwk import OctKey

from app.accounts.errors import DomainTaken, ProviderRefused
from app.accounts.models import Person, SignInProvider
from app.accounts.providers import service as providers
from app.accounts.providers.rules import SIGN_IN_LIFETIME, endpoints_in
from app.accounts.providers.sign_ins import COOKIE
from app.accounts.rules import AddressProof
from app.core import clock
from tests.app.accounts.test_sign_in import PASSWORD, sign_up, with_csrf
from tests.app.notifications.test_security_mails import mails_to
from tests.support.oidc_provider import CLIENT_ID, CLIENT_SECRET, KEY, OTHER_KEY, Provider, oidc_provider
from tests.support.server import RunningServer


class Studio:
    """A studio with a provider and a domain of its own."""

    def __init__(self, server: RunningServer, provider: Provider) -> None:
        self.server, self.provider = server, provider
        self.domain = f"{uuid4().hex}.example"
        self.producer, self.email = server.browser(), f"producer@{self.domain}"
        assert sign_up(self.producer, self.email).status_code == 201
        with_csrf(self.producer)
        self.id = self.producer.get("/v1/me").json()["studios"][0]["id"]
        self.path = f"/v1/studios/{self.id}/sign-in-provider"
        self.saved = self.save(provider.issuer)
        server.in_database(lambda session: providers.bind_domain(session, UUID(self.id), self.domain.upper()))

    def save(self, issuer: str) -> Response:
        body = {"issuer": issuer, "client_id": CLIENT_ID, "client_secret": CLIENT_SECRET}
        return self.producer.put(self.path, json=body)

    def person(self, email: str) -> Person | None:
        with self.server.runtime.database.reading() as session:
            return session.scalar(sa.select(Person).where(Person.email == email))

    def verify(self, email: str) -> None:
        changed = sa.update(Person).where(Person.email == email)
        values = {"email_verified_at": clock.now(), "email_proof": AddressProof.MAIL}
        self.server.in_database(lambda session: session.execute(changed.values(**values)))

    def begin(self, browser: Client) -> dict[str, str]:
        started = browser.post("/v1/sign-in/oidc/start", json={"studio_id": self.id, "next_path": "/account"})
        assert started.status_code == 200, started.text
        return self.provider.redirect(started.json()["url"])

    def sign_in(self, browser: Client, email: str, **claims: Any) -> Response:
        self.provider.claims = {"email": email, **claims}
        return browser.post("/v1/sign-in/oidc/callback", json=self.begin(browser))


@pytest.fixture(scope="module")
def night_studio(server: RunningServer) -> Iterator[Studio]:
    with pytest.MonkeyPatch.context() as patched, oidc_provider() as provider:
        patched.setattr(server.runtime.settings, "webhook_localhost", True)
        studio = Studio(server, provider)
        assert studio.saved.status_code == 200, studio.saved.text
        yield studio


@pytest.fixture
def studio(night_studio: Studio) -> Studio:
    """The studio of all tests, with the provider as it is when nobody tells it otherwise."""
    provider = night_studio.provider
    provider.claims, provider.discovery = {}, {}
    provider.signing_key, provider.algorithm = KEY, "RS256"
    return night_studio


@pytest.fixture
def fresh_studio(studio: Studio) -> Studio:
    """A studio of one test, which changes it."""
    return Studio(studio.server, studio.provider)


def assert_refused(answer: Response, words: str, browser: Client) -> None:
    assert (answer.status_code, answer.json()["code"]) == (403, "provider-sign-in-refused"), answer.text
    assert words in answer.json()["detail"]
    assert browser.get("/v1/me").status_code == 401


def test_a_new_person_gets_an_account_and_is_a_member_of_nothing(studio: Studio) -> None:
    browser, email = studio.server.browser(), f"ada@{studio.domain}"
    answer = studio.sign_in(browser, email.upper())
    assert answer.json() == {"second_factor_needed": False, "next_path": "/account"}
    me = browser.get("/v1/me").json()
    assert (me["email"], me["person"]["name"], me["studios"], me["projects"]) == (email, "Ada", [], [])
    person = studio.person(email)
    assert person is not None
    assert (person.email_proof, person.password_hash) == (AddressProof.PROVIDER, None)
    credentials = studio.provider.token_headers["authorization"].removeprefix("Basic ")
    assert [unquote(part) for part in b64decode(credentials).decode().split(":")] == [CLIENT_ID, CLIENT_SECRET]


def test_an_account_with_a_verified_address_is_signed_in(fresh_studio: Studio) -> None:
    browser = fresh_studio.server.browser()
    assert_refused(fresh_studio.sign_in(browser, fresh_studio.email), "without proving the address", browser)
    fresh_studio.verify(fresh_studio.email)
    assert fresh_studio.sign_in(browser, fresh_studio.email).status_code == 200
    assert [each["id"] for each in browser.get("/v1/me").json()["studios"]] == [fresh_studio.id]


def test_only_the_domains_of_the_studio_sign_in_by_its_provider(fresh_studio: Studio) -> None:
    browser = fresh_studio.server.browser()
    for domain in ("other.example", f"sub.{fresh_studio.domain}", f"{fresh_studio.domain}.example"):
        email = f"ada@{domain}"
        assert_refused(fresh_studio.sign_in(browser, email), "is not bound to this studio", browser)
        assert fresh_studio.person(email) is None
    fresh_studio.server.in_database(lambda session: providers.unbind_domain(session, fresh_studio.domain))
    assert_refused(fresh_studio.sign_in(browser, fresh_studio.email), "is not bound to this studio", browser)


@pytest.mark.parametrize(
    ("claims", "words"),
    [
        ({"nonce": "another"}, "ID token is wrong"),
        ({"nonce": None}, "ID token is wrong"),
        ({"iss": "https://login.example"}, "ID token is wrong"),
        ({"aud": "another client"}, "ID token is wrong"),
        ({"aud": [CLIENT_ID, "another"], "azp": "another"}, "ID token is wrong"),
        ({"exp": 1_000_000_000}, "ID token is wrong"),
        ({"exp": None}, "ID token is wrong"),
        ({"iat": 100_000_000_000}, "ID token is wrong"),
        ({"at_hash": "wrong"}, "ID token is wrong"),
        ({"amr": "mfa"}, "ID token is wrong"),
        ({"email_verified": False}, "verified your email"),
        ({"email_verified": "true"}, "verified your email"),
        ({"email": None}, "names no email"),
        ({"email": ["a@b.example"]}, "names no email"),
    ],
)
def test_a_token_that_says_anything_wrong_signs_nobody_in(studio: Studio, claims: dict[str, Any], words: str) -> None:
    browser = studio.server.browser()
    answer = studio.sign_in(browser, **{"email": f"ada@{studio.domain}", **claims})
    assert_refused(answer, words, browser)


def test_a_token_that_the_provider_did_not_sign_signs_nobody_in(studio: Studio) -> None:
    browser, email = studio.server.browser(), f"ada@{studio.domain}"
    studio.provider.signing_key = OTHER_KEY
    assert_refused(studio.sign_in(browser, email), "ID token is wrong", browser)
    public = KEY.as_pem(private=False)
    studio.provider.signing_key, studio.provider.algorithm = OctKey.import_key(public.replace(b"-----", b"")), "HS256"
    assert_refused(studio.sign_in(browser, email), "ID token is wrong", browser)


def test_an_answer_is_for_the_browser_that_began(studio: Studio, monkeypatch: pytest.MonkeyPatch) -> None:
    browser, other = studio.server.browser(), studio.server.browser()
    studio.provider.claims = {"email": f"ada@{studio.domain}"}
    path, answer = "/v1/sign-in/oidc/callback", studio.begin(browser)
    assert_refused(other.post(path, json=answer), "this browser began no sign-in", other)
    studio.begin(other)
    assert_refused(other.post(path, json=answer), "not to a sign-in that this browser began", other)
    wrong_state, other_issuer = answer | {"state": "guessed"}, answer | {"iss": "https://login.example"}
    assert_refused(browser.post(path, json=wrong_state), "not to a sign-in that this browser began", browser)
    assert_refused(browser.post(path, json=other_issuer), "another provider's", browser)
    kept, began_at = browser.cookies[COOKIE], clock.now()
    with monkeypatch.context() as later:
        later.setattr(clock, "now", lambda: began_at + SIGN_IN_LIFETIME + timedelta(minutes=1))
        assert_refused(browser.post(path, json=answer), "longer than ten minutes", browser)
    assert browser.post(path, json=answer).status_code == 200
    # The same answer again, with the cookie of before: the code was used.
    other.cookies.clear()
    other.cookies.set(COOKIE, kept)
    assert_refused(other.post(path, json=answer), "did not take the code", other)
    other.cookies.set(COOKIE, kept[:-8] + "AAAAAAA=")
    assert_refused(other.post(path, json=answer), "this browser began no sign-in", other)


def test_an_account_with_a_second_factor_is_asked_for_it(fresh_studio: Studio) -> None:
    secret = fresh_studio.producer.post("/v1/me/totp").json()["secret"]
    codes = fresh_studio.producer.post("/v1/me/totp/confirm", json={"code": pyotp.TOTP(secret).now()}).json()
    fresh_studio.verify(fresh_studio.email)
    browser = fresh_studio.server.browser()
    assert browser.post("/v1/sign-in/oidc/code", json={"code": codes["recovery_codes"][0]}).status_code == 403
    assert fresh_studio.sign_in(browser, fresh_studio.email, amr=["mfa"]).json()["second_factor_needed"] is True
    assert browser.get("/v1/me").status_code == 401
    wrong = browser.post("/v1/sign-in/oidc/code", json={"code": "AAAA-AAAA-AAAA-AAAA"})
    assert (wrong.status_code, wrong.json()["code"]) == (403, "wrong-second-factor")
    right = browser.post("/v1/sign-in/oidc/code", json={"code": codes["recovery_codes"][0]})
    assert right.json() == {"second_factor_needed": False, "next_path": "/account"}
    assert browser.get("/v1/me").json()["email"] == fresh_studio.email
    # The cookie of the one step is none of the other's.
    fresh_studio.begin(browser)
    assert browser.post("/v1/sign-in/oidc/code", json={"code": codes["recovery_codes"][1]}).status_code == 403


def test_a_studio_that_requires_a_second_factor_believes_its_own_provider(fresh_studio: Studio) -> None:
    fresh_studio.verify(fresh_studio.email)
    browser = fresh_studio.server.browser()
    assert fresh_studio.sign_in(browser, fresh_studio.email, amr=["mfa"]).status_code == 200
    with_csrf(browser)
    path = f"/v1/studios/{fresh_studio.id}"
    required = browser.put(f"{path}/second-factor", json={"required_for": ["everything"]})
    assert required.status_code == 200, required.text
    for methods, status in ((["pwd", "otp"], 200), (["mfa"], 200), (["hwk"], 200), (["pwd"], 403), (None, 403)):
        again = fresh_studio.server.browser()
        assert fresh_studio.sign_in(again, fresh_studio.email, amr=methods).status_code == 200
        assert again.get(f"{path}/people").status_code == status
        assert again.get("/v1/me").json()["second_factor_required_by"] == ([] if status == 200 else ["Night Studio"])


def test_another_studio_does_not_believe_it(fresh_studio: Studio) -> None:
    fresh_studio.verify(fresh_studio.email)
    browser = fresh_studio.server.browser()
    assert fresh_studio.sign_in(browser, fresh_studio.email, amr=["mfa"]).status_code == 200
    with_csrf(browser)
    other_id = browser.post("/v1/studios", json={"name": "Other"}).json()["id"]
    refused = browser.put(f"/v1/studios/{other_id}/second-factor", json={"required_for": ["everything"]})
    assert refused.json()["code"] == "no-second-factor"


def test_the_client_secret_is_encrypted_and_never_shown(studio: Studio) -> None:
    shown = studio.producer.get(studio.path)
    assert shown.json() == studio.saved.json() | {"domains": [studio.domain]}
    assert shown.json()["redirect_uri"] == f"{studio.server.runtime.settings.base_url}/sign-in/provider"
    assert CLIENT_SECRET not in shown.text
    with studio.server.runtime.database.reading() as session:
        provider = session.get_one(SignInProvider, UUID(studio.id))
        assert CLIENT_SECRET.encode() not in provider.sealed_client_secret
        assert providers.client_secret_of(studio.server.runtime.settings, provider) == CLIENT_SECRET
    assert "Night Studio: the sign-in provider was changed" in mails_to(studio.server, studio.email)


def test_the_page_asks_by_domain_and_learns_of_no_account(fresh_studio: Studio) -> None:
    browser = fresh_studio.server.browser()
    ask = "/v1/sign-in/provider"
    named = {"studio_id": fresh_studio.id, "studio_name": "Night Studio"}
    assert browser.get(ask, params={"domain": fresh_studio.domain.title()}).json() == named
    nothing = {"studio_id": None, "studio_name": None}
    for domain in ("other.example", "", f"sub.{fresh_studio.domain}"):
        assert browser.get(ask, params={"domain": domain}).json() == nothing
    assert fresh_studio.producer.delete(fresh_studio.path).status_code == 204
    assert browser.get(ask, params={"domain": fresh_studio.domain}).json() == nothing
    gone = browser.post("/v1/sign-in/oidc/start", json={"studio_id": fresh_studio.id})
    assert (gone.status_code, gone.json()["code"]) == (404, "provider-not-found")


def test_a_domain_belongs_to_one_studio(studio: Studio) -> None:
    other = Studio(studio.server, studio.provider)
    with pytest.raises(DomainTaken):
        studio.server.in_database(lambda session: providers.bind_domain(session, UUID(other.id), studio.domain))
    browser = studio.server.browser()
    assert_refused(other.sign_in(browser, f"ada@{studio.domain}"), "is not bound to this studio", browser)


@pytest.mark.parametrize(
    "discovery",
    [
        {"issuer": "https://login.example"},
        {"token_endpoint": None},
        {"jwks_uri": "http://10.0.0.5/jwks"},
        {"authorization_endpoint": "javascript:alert(1)"},
        {"code_challenge_methods_supported": ["plain"]},
    ],
)
def test_a_provider_that_does_not_fit_is_refused(studio: Studio, discovery: dict[str, Any]) -> None:
    studio.provider.discovery = discovery
    refused = studio.save(studio.provider.issuer)
    assert (refused.status_code, refused.json()["code"]) == (422, "provider-refused")
    assert refused.json()["errors"][0]["where"] == "issuer"


def test_addresses_inside_are_never_asked(studio: Studio, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(studio.server.runtime.settings, "webhook_localhost", False)
    for issuer in (studio.provider.issuer, "https://10.0.0.5", "https://localhost", "file:///etc/passwd"):
        assert studio.save(issuer).json()["code"] == "provider-refused"
    with pytest.raises(ProviderRefused, match="has no public address"):
        providers.discover(
            studio.server.runtime.settings, "https://login.example", resolver=lambda _host, _port: ["169.254.169.254"]
        )
    # One that was saved while it was allowed is asked no more either.
    browser = studio.server.browser()
    assert_refused(studio.sign_in(browser, f"ada@{studio.domain}"), "can't be reached", browser)


@pytest.mark.parametrize("document", ["", "[]", "{", "[" * 100_000, "null"])
def test_a_malformed_document_is_refused(document: str) -> None:
    with pytest.raises(ProviderRefused):
        endpoints_in(document, "https://login.example")


def test_who_has_no_password_is_told_how_to_get_one(studio: Studio) -> None:
    browser = studio.server.browser()
    assert studio.sign_in(browser, f"ada@{studio.domain}").status_code == 200
    with_csrf(browser)
    refused = browser.put("/v1/me/password", json={"current": PASSWORD, "new": "staple correct horse"})
    assert (refused.status_code, refused.json()["code"]) == (403, "wrong-password")
    assert "Forgot password" in refused.json()["fix"]
    signed = browser.post("/v1/sign-in", json={"email": f"ada@{studio.domain}", "password": ""})
    assert signed.status_code == 401


def test_the_address_of_the_provider_keeps_its_own_query(studio: Studio) -> None:
    started = studio.server.browser().post("/v1/sign-in/oidc/start", json={"studio_id": studio.id})
    query = parse_qs(urlsplit(started.json()["url"]).query)
    assert (query["tenant"], query["scope"], query["client_id"]) == (["1"], ["openid email profile"], [CLIENT_ID])
    assert len(query["state"][0]) >= 32
    assert len(query["nonce"][0]) >= 32


NODE = shutil.which("node")


@pytest.mark.slow
@pytest.mark.skipif(NODE is None, reason="needs Node.js")
def test_a_real_provider_signs_in_and_takes_no_code_twice(studio: Studio) -> None:
    """npm's oidc-provider, with its own login page, discovery, keys and rules."""
    email = f"grace@{studio.domain}"
    script = Path(__file__).parents[2] / "support/oidc_provider.mjs"
    command = [str(NODE), str(script), f"{studio.server.runtime.settings.base_url}/sign-in/provider", email]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as process:
        assert process.stdout is not None
        try:
            issuer = process.stdout.readline().strip()
            assert issuer.startswith("http://127.0.0.1:")
            real = Studio(studio.server, studio.provider)
            assert real.save(issuer).status_code == 200
            studio.server.in_database(lambda session: providers.unbind_domain(session, studio.domain))
            studio.server.in_database(lambda session: providers.bind_domain(session, UUID(real.id), studio.domain))
            browser = studio.server.browser()
            url = browser.post("/v1/sign-in/oidc/start", json={"studio_id": real.id}).json()["url"]
            answer, kept = signed_in_at(url), browser.cookies[COOKIE]
            assert answer["iss"] == issuer
            done = browser.post("/v1/sign-in/oidc/callback", json=answer)
            assert done.json() == {"second_factor_needed": False, "next_path": "/"}
            assert browser.get("/v1/me").json()["email"] == email
            other = studio.server.browser()
            other.cookies.set(COOKIE, kept)
            assert_refused(other.post("/v1/sign-in/oidc/callback", json=answer), "did not take the code", other)
        finally:
            process.terminate()


def signed_in_at(url: str) -> dict[str, str]:
    """Sign in and consent at the pages of npm's oidc-provider; return what its last redirect carries."""
    with httpx.Client(follow_redirects=False) as person:
        page = person.get(url)
        for _ in range(12):
            if page.is_redirect:
                target = urljoin(str(page.url), page.headers["location"])
                if "/sign-in/provider?" in target:
                    return {name: values[0] for name, values in parse_qs(urlsplit(target).query).items()}
                page = person.get(target)
                continue
            action = re.search(r'action="([^"]+)"', page.text)
            prompt = re.search(r'name="prompt" value="([^"]+)"', page.text)
            assert action is not None, page.text
            assert prompt is not None, page.text
            form = {"prompt": prompt[1], "login": "grace", "password": "any"}
            page = person.post(urljoin(str(page.url), action[1]), data=form)
    raise AssertionError("the provider never sent the browser back")
