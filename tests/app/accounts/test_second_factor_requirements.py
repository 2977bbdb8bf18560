"""A studio requires a second factor of those who sign, of those who pay, or of all its members."""

from contextlib import nullcontext
from typing import Any

import pyotp
import pytest
from httpx2 import Client

from app.accounts.authentication import AuthResult, ensure_second_factor
from app.accounts.errors import SecondFactorRequired
from app.accounts.models import Studio
from app.accounts.rules import Actor, SecondFactorUse
from app.accounts.second_factors.requirements import ensure_second_factor_for
from app.core import clock
from tests.support.server import World

REQUIRED = (403, "second-factor-required")


def require_second_factor(world: World, *uses: str) -> Any:
    return world.producer.put(f"/v1/studios/{world.studio_id}/second-factor", json={"required_for": list(uses)})


def set_up_totp(browser: Client) -> None:
    secret = browser.post("/v1/me/totp").json()["secret"]
    code = pyotp.TOTP(secret).at(clock.now())
    assert browser.post("/v1/me/totp/confirm", json={"code": code}).status_code == 200


def test_a_producer_without_one_cannot_require_it(world: World) -> None:
    refused = require_second_factor(world, "everything")
    assert (refused.status_code, refused.json()["code"]) == (409, "no-second-factor")
    assert require_second_factor(world).json() == {"required_for": []}
    set_up_totp(world.producer)
    assert require_second_factor(world, "everything", "signing", "signing").json() == {
        "required_for": ["signing", "everything"]
    }


def test_required_for_everything_a_member_without_one_reaches_their_account_alone(world: World) -> None:
    set_up_totp(world.producer)
    project = f"/v1/projects/{world.project_id}"
    assert [each["name"] for each in world.reviewer.get("/v1/me").json()["projects"]] != []
    assert require_second_factor(world, "everything").status_code == 200
    for method, path in (
        ("GET", project),
        ("GET", f"/v1/studios/{world.studio_id}/people"),
        ("POST", "/v1/projects"),
        ("GET", "/v1/me/work"),
    ):
        refused = world.reviewer.request(method, path)
        assert (refused.status_code, refused.json()["code"]) == REQUIRED, path
        assert "Account" in refused.json()["fix"]
    me = world.reviewer.get("/v1/me").json()
    assert (me["second_factor_required_by"], me["projects"]) == (["Test studio"], [])
    # A designer of the studio and people of other studios are not its members.
    assert world.designer.get(project).status_code == 200
    assert world.stranger.get("/v1/me/work").status_code == 200
    set_up_totp(world.reviewer)
    assert world.reviewer.get("/v1/me").json()["second_factor_required_by"] == []
    assert world.reviewer.get(project).status_code == 200


@pytest.mark.parametrize(
    ("path", "is_open"),
    [
        ("/v1/me", True),
        ("/v1/me/totp/confirm", True),
        ("/v1/me/sign-ins/1", True),
        ("/v1/sign-out", True),
        ("/v1/me/work", False),
        ("/v1/me/desk", False),
        ("/v1/me/notices", False),
        ("/v1/me/desk-tokens", False),
        ("/v1/projects", False),
        ("/v1/meetings", False),
    ],
)
def test_what_stays_open_is_the_account(path: str, is_open: bool) -> None:
    lacking = AuthResult(Actor(), lacks_second_factor=True)
    ensure_second_factor(AuthResult(Actor()), path)
    if is_open:
        ensure_second_factor(lacking, path)
    else:
        with pytest.raises(SecondFactorRequired, match="nothing was done"):
            ensure_second_factor(lacking, path)


def test_each_use_is_required_by_itself(world: World) -> None:
    signing, paying = SecondFactorUse.SIGNING, SecondFactorUse.PAYING
    required: list[tuple[list[str], set[SecondFactorUse]]] = [
        (["signing"], {signing}),
        (["paying"], {paying}),
        (["everything"], {signing, paying}),
        ([], set()),
    ]
    for required_for, refused in required:
        with world.server.runtime.database.writing() as session:
            session.get_one(Studio, world.studio_id).second_factor_for = required_for
        for use in (signing, paying):
            with world.server.runtime.database.writing() as session:
                actor = Actor(person_id=world.producer_id)
                expected: Any = nullcontext()
                if use in refused:
                    expected = pytest.raises(SecondFactorRequired, match="Test studio requires a second factor of who")
                with expected:
                    ensure_second_factor_for(session, actor, world.studio_id, use)
