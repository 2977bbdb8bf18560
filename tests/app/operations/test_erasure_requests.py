"""Erasures by the endpoints: what is listed first, who may, what is mailed, and the days of grace."""

from datetime import timedelta
from typing import Any
from uuid import UUID

import pytest
import sqlalchemy as sa

from app.accounts.authentication import RECENT_SIGN_IN
from app.accounts.models import Person, SignIn
from app.core import clock
from app.notifications.models import Mail
from app.operations import jobs
from app.operations.erasure import requests as erasure_requests
from tests.app.agreements.conftest import Contracts
from tests.app.projects.test_members import add_producer, limit
from tests.support.deliver import add_cues
from tests.support.server import World

pytestmark = pytest.mark.both_databases


def mails(world: World, subject: str) -> list[str]:
    """Return the recipients of the mails of a subject."""
    with world.server.runtime.database.reading() as session:
        return sorted(session.scalars(sa.select(Mail.recipient).where(Mail.subject.startswith(subject))))


def pass_days_of_grace(monkeypatch: pytest.MonkeyPatch, world: World) -> None:
    """Run the job of erasures once their day has come."""
    later = clock.now() + erasure_requests.GRACE + timedelta(minutes=1)
    with monkeypatch.context() as patched:
        patched.setattr(clock, "now", lambda: later)
        jobs.carry_out_erasures(world.server.runtime, {})


def address(person_id: UUID) -> str:
    return f"{person_id}@example.test"


def test_a_project_is_erased_after_days_of_grace(world: World, monkeypatch: pytest.MonkeyPatch) -> None:
    add_cues(world, {"name": "Door"}, {"name": "Gate"})
    path = f"/v1/projects/{world.project_id}/erasure"
    plan: dict[str, Any] = world.producer.get(path).json()
    assert (plan["confirmation"], plan["obstacles"], plan["due_at"]) == ("Shield Wing", [], None)
    assert "2 sounds" in plan["deleted"]
    assert any(kept["name"] == "copies in backups" and kept["reason"] for kept in plan["kept"])

    wrong = world.producer.post(path, json={"confirmation": "shield wing"})
    assert (wrong.status_code, wrong.json()["code"]) == (422, "confirmation-mismatch")
    assert wrong.json()["errors"][0]["where"] == "confirmation"
    requested = world.producer.post(path, json={"confirmation": "Shield Wing"}).json()
    assert requested["requested_by"] == "Producer"
    assert requested["due_at"] is not None
    concerned = sorted(address(one) for one in (world.producer_id, world.reviewer_id, world.designer_id))
    assert [one for one in concerned if one not in mails(world, "Shield Wing will be erased on")] == []

    jobs.carry_out_erasures(world.server.runtime, {})
    assert world.producer.get(f"/v1/projects/{world.project_id}").status_code == 200
    pass_days_of_grace(monkeypatch, world)
    for person in (world.producer, world.designer):
        assert person.get(f"/v1/projects/{world.project_id}").status_code == 404
    assert world.producer.get(f"/v1/studios/{world.studio_id}/people").status_code == 200
    assert set(concerned) <= set(mails(world, "Shield Wing was erased"))


def test_a_cancelled_erasure_is_not_carried_out(world: World, monkeypatch: pytest.MonkeyPatch) -> None:
    path = f"/v1/studios/{world.studio_id}/erasure"
    assert world.producer.post(path, json={"confirmation": "Test studio"}).status_code == 200
    assert world.producer.post(path, json={"confirmation": "Test studio"}).status_code == 200  # twice is once
    assert world.producer.delete(path).status_code == 204
    assert world.producer.get(path).json()["due_at"] is None
    assert address(world.designer_id) in mails(world, "Test studio will not be erased")
    pass_days_of_grace(monkeypatch, world)
    assert world.producer.get(f"/v1/projects/{world.project_id}").status_code == 200


def test_a_studio_goes_with_its_projects_and_its_people_stay(world: World, monkeypatch: pytest.MonkeyPatch) -> None:
    path = f"/v1/studios/{world.studio_id}/erasure"
    plan = world.producer.get(path).json()
    assert "1 project" in plan["deleted"]
    assert world.producer.post(path, json={"confirmation": "Test studio"}).status_code == 200
    pass_days_of_grace(monkeypatch, world)
    me = world.producer.get("/v1/me").json()
    assert (me["studios"], me["projects"]) == ([], [])
    assert address(world.producer_id) in mails(world, "Test studio was erased")


def test_a_signed_contract_stands_against_it_before_and_in_the_days_of_grace(
    world: World, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = f"/v1/projects/{world.project_id}/erasure"
    assert world.producer.post(path, json={"confirmation": "Shield Wing"}).status_code == 200
    contracts = Contracts(world)
    contracts.agree(contracts.begin())
    pass_days_of_grace(monkeypatch, world)
    assert world.producer.get(f"/v1/projects/{world.project_id}").status_code == 200
    assert address(world.producer_id) in mails(world, "Shield Wing was not erased")
    plan = world.producer.get(path).json()
    assert plan["due_at"] is None
    assert "1 signed contract" in plan["obstacles"][0]
    refused = world.producer.post(path, json={"confirmation": "Shield Wing"})
    assert (refused.status_code, refused.json()["code"]) == (409, "erasure-refused")


def test_a_contract_of_an_unseen_project_stands_against_it_without_its_name(world: World) -> None:
    contracts = Contracts(world)
    contracts.agree(contracts.begin())
    _, outsider = add_producer(world)
    limit(world)
    (obstacle,) = outsider.get(f"/v1/studios/{world.studio_id}/erasure").json()["obstacles"]
    assert "The studio Test studio has 1 signed contract: " in obstacle


def test_only_producers_erase_and_for_others_there_is_nothing(world: World) -> None:
    for path in (f"/v1/projects/{world.project_id}/erasure", f"/v1/studios/{world.studio_id}/erasure"):
        for client, status in ((world.reviewer, 403), (world.stranger, 404)):
            answers = client.get(path), client.post(path, json={"confirmation": "x"}), client.delete(path)
            assert [answer.status_code for answer in answers] == [status] * 3
    assert world.designer.get(f"/v1/projects/{world.project_id}/erasure").status_code == 403
    assert world.designer.get(f"/v1/studios/{world.studio_id}/erasure").status_code == 404


def test_a_person_erases_their_own_account(world: World) -> None:
    email = address(world.designer_id)
    plan = world.designer.get("/v1/me/erasure").json()
    assert (plan["confirmation"], plan["obstacles"], plan["grace_days"]) == (email, [], 0)
    assert "your name, address, password and picture" in plan["deleted"]
    assert any("sign-in" in item for item in plan["deleted"])
    wrong = world.designer.post("/v1/me/erasure", json={"confirmation": "yes"})
    assert wrong.json()["code"] == "confirmation-mismatch"

    aged = sa.update(SignIn).where(SignIn.person_id == world.designer_id)
    long_ago = clock.now() - RECENT_SIGN_IN - timedelta(minutes=1)
    world.server.in_database(lambda session: session.execute(aged.values(created_at=long_ago)))
    refused = world.designer.post("/v1/me/erasure", json={"confirmation": email})
    assert refused.json()["code"] == "recent-sign-in-needed"
    world.server.in_database(lambda session: session.execute(aged.values(created_at=clock.now())))
    assert world.designer.post("/v1/me/erasure", json={"confirmation": email}).status_code == 204
    assert world.designer.get("/v1/me").status_code == 401
    with world.server.runtime.database.reading() as session:
        person = session.get_one(Person, world.designer_id)
        assert person.name.startswith("Former user ")
        text = " ".join(line for lines in session.scalars(sa.select(Mail.lines)) for line in lines)
    assert person.name in text  # the producers are told, under the pseudonym
    assert address(world.producer_id) in mails(world, "An account was erased")


def test_what_must_end_first_is_named_before_and_refused(world: World) -> None:
    plan = world.producer.get("/v1/me/erasure").json()
    assert plan["obstacles"] == [
        "Your account is a member of Test studio: a producer removes them first, or erases the studio"
    ]
    refused = world.producer.post("/v1/me/erasure", json={"confirmation": address(world.producer_id)})
    assert (refused.status_code, refused.json()["code"]) == (409, "erasure-refused")
    assert world.producer.get("/v1/me").status_code == 200
