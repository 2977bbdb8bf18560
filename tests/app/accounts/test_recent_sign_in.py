"""Who gives access to others has signed in a short while ago: someone else may sit at a browser left open."""

from datetime import timedelta
from typing import Any

import pytest
import sqlalchemy as sa
from httpx2 import Client

from app.accounts.authentication import RECENT_SIGN_IN
from app.accounts.models import Membership, SignIn
from app.core import clock
from tests.house.routes import operations
from tests.support.deliver import add_cues
from tests.support.server import World

# Each gives access that outlives the sign-in by which it was given.
ACCESS_GIVEN = {
    "create_token",
    "create_my_desk_token",
    "add_webhook",
    "rotate_webhook_secret",
    "add_guest_link",
    "make_posting_link",
    "make_calendar",
    # Each changes how one signs in.
    "begin_my_totp",
    "confirm_my_totp",
    "end_my_totp",
    "renew_my_recovery_codes",
    "set_members_see",
    "set_second_factor_requirement",
    "request_my_email_change",
    "begin_my_passkey",
    "add_my_passkey",
    "remove_my_passkey",
    "set_sign_in_provider",
    "remove_sign_in_provider",
    # Each erases for good.
    "erase_me",
    "request_project_erasure",
    "request_studio_erasure",
}


def age_sign_ins(world: World, age: timedelta) -> None:
    """Let the sign-ins of a world's people be as old as that."""
    people = world.producer_id, world.designer_id, world.stranger_id
    aged = sa.update(SignIn).where(SignIn.person_id.in_(people)).values(created_at=clock.now() - age)
    world.server.in_database(lambda session: session.execute(aged))


def refusal_of(by: Client, method: str, path: str, body: Any) -> str | None:
    answer = by.request(method, path, json=body)
    return str(answer.json()["code"]) if answer.status_code >= 400 else None


def test_what_gives_access_to_others_declares_it() -> None:
    assert {operation.name for operation in operations() if operation.policy.recent_sign_in} == ACCESS_GIVEN


def test_an_old_sign_in_makes_no_token_no_link_and_no_producer(world: World) -> None:
    add_cues(world, {"name": "Door"})
    project, studio = f"/v1/projects/{world.project_id}", f"/v1/studios/{world.studio_id}"
    posting = world.producer.post(f"{project}/postings", json={"title": "Effects"}).json()["id"]
    hook = {"url": "https://hooks.example/sounds", "form": "json", "events": ["take.approved"]}
    webhook = world.producer.post(f"{studio}/webhooks", json=hook).json()["id"]
    guests = {"kind": "cues", "title": "For the publisher"}
    acts: list[tuple[str, str, Any]] = [
        ("POST", f"{project}/tokens", {"name": "CI", "scopes": ["spec:read"]}),
        ("POST", "/v1/me/desk-tokens", {"name": "Laptop"}),
        ("POST", f"{studio}/webhooks", hook),
        ("PATCH", f"/v1/webhooks/{webhook}", {"url": "https://elsewhere.example/"}),
        ("POST", f"/v1/webhooks/{webhook}/secret", None),
        ("POST", f"{project}/guest-links", guests),
        ("POST", f"/v1/postings/{posting}/link", None),
        ("POST", f"{project}/calendar", None),
        ("POST", f"{studio}/invitations", {"email": "new@studio.example", "roles": ["producer"]}),
        ("PUT", f"{studio}/people/{world.reviewer_id}", {"roles": ["producer"]}),
    ]
    age_sign_ins(world, RECENT_SIGN_IN + timedelta(minutes=1))
    refusals = {path: refusal_of(world.producer, method, path, body) for method, path, body in acts}
    assert refusals == dict.fromkeys(refusals, "recent-sign-in-needed")
    with world.server.runtime.database.reading() as session:
        assert session.get_one(Membership, (world.studio_id, world.reviewer_id)).roles == ["reviewer"]
    # What gives nobody access goes on.
    reviewer = {"email": "new@studio.example", "roles": ["reviewer"]}
    assert refusal_of(world.producer, "POST", f"{studio}/invitations", reviewer) is None
    assert refusal_of(world.producer, "PATCH", f"/v1/webhooks/{webhook}", {"enabled": False}) is None
    age_sign_ins(world, RECENT_SIGN_IN - timedelta(minutes=1))
    assert refusal_of(world.producer, *acts[0]) is None


def test_it_is_asked_of_strangers_alike(world: World) -> None:
    # The answer says nothing of what there is: it is the same for a project that exists and for none.
    path, body = "/v1/projects/{}/tokens", {"name": "CI", "scopes": ["spec:read"]}
    assert world.stranger.get("/v1/me").status_code == 200
    age_sign_ins(world, timedelta(hours=1))
    answers = {
        refusal_of(world.stranger, "POST", path.format(id_), body) for id_ in (world.project_id, world.studio_id)
    }
    assert answers == {"recent-sign-in-needed"}


@pytest.mark.parametrize("who", ["producer", "designer"])
def test_reading_needs_no_recent_sign_in(world: World, who: str) -> None:
    by: Client = getattr(world, who)
    age_sign_ins(world, timedelta(days=13))
    assert by.get(f"/v1/projects/{world.project_id}").status_code == 200
