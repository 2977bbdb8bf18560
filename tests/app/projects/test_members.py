"""Where a studio wants it, its members see only the projects that they are in."""

from typing import Any
from uuid import UUID

import pytest
from httpx2 import Client

from app.accounts.models import Membership
from app.accounts.rules import Audience, Role
from app.core.db import new_id
from app.notifications import queries as notification_queries
from app.notifications.models import Notice
from tests.house.routes import operations
from tests.support.server import World

pytestmark = pytest.mark.both_databases


def limit(world: World, browser: Client | None = None) -> None:
    answer = (browser or world.producer).put(f"/v1/studios/{world.studio_id}/members-see", json={"members_see": "own"})
    assert answer.status_code == 200, answer.text


def add_producer(world: World, name: str = "A second producer", role: Role = Role.PRODUCER) -> tuple[UUID, Client]:
    with world.server.runtime.database.writing() as session:
        person_id = world._person(session, name)
        session.flush()
        session.add(Membership(studio_id=world.studio_id, person_id=person_id, roles=[role]))
    return person_id, world.signed_in(person_id)


def project_names(browser: Client) -> list[str]:
    return [project["name"] for project in browser.get("/v1/projects").json()["items"]]


def members(world: World) -> dict[str, Any]:
    of_project: dict[str, Any] = world.producer.get(f"/v1/projects/{world.project_id}/members").json()
    return of_project


def names(world: World) -> set[str]:
    return {member["person"]["name"] for member in members(world)["members"]}


def test_members_see_all_projects_until_the_studio_limits_them(world: World):
    assert project_names(world.reviewer) == ["Shield Wing"]
    limit(world)
    assert names(world) == {"Producer", "Audio director"}, "who runs the project, and who is named in it"
    page = f"/v1/projects/{world.project_id}"
    for browser, status in ((world.producer, 200), (world.approver, 200), (world.designer, 200), (world.reviewer, 404)):
        assert browser.get(page).status_code == status
        assert project_names(browser) == ["Shield Wing"] * (status == 200)
    assert world.producer.put(f"{page}/members/{world.reviewer_id}").status_code == 204
    assert world.reviewer.get(page).status_code == 200
    assert world.producer.delete(f"{page}/members/{world.reviewer_id}").status_code == 204
    assert world.reviewer.get(page).status_code == 404
    off = world.producer.put(f"/v1/studios/{world.studio_id}/members-see", json={"members_see": "all"})
    assert off.json() == {"members_see": "all"}
    assert world.reviewer.get(page).status_code == 200


def test_a_producer_outside_sees_nothing_of_it_and_opens_projects_of_their_own(world: World):
    _, outsider = add_producer(world)
    limit(world)
    assert project_names(outsider) == []
    assert outsider.get("/v1/me").json()["projects"] == []
    opened = outsider.post(
        "/v1/projects", json={"studio_id": str(world.studio_id), "name": "Own Game", "cue_prefix": "OG"}
    )
    assert opened.status_code == 201, opened.text
    assert project_names(outsider) == ["Own Game"]
    search = outsider.get(f"/v1/projects/{opened.json()['id']}/find", params={"q": "Shield"})
    assert search.status_code == 200, search.text
    assert "Shield Wing" not in search.text
    assert project_names(world.producer) == ["Shield Wing"]


READS = [
    operation
    for operation in operations()
    if operation.method == "GET"
    and operation.parameters == ("project_id",)
    and operation.policy.audience is not Audience.ANYONE
]


def test_no_page_of_a_project_opens_for_who_is_outside(world: World):
    limit(world)
    assert len(READS) > 40
    answers = {
        operation.path: world.reviewer.get(operation.path.format(project_id=world.project_id)).status_code
        for operation in READS
        if not operation.query
    }
    assert {path: status for path, status in answers.items() if status != 404} == {}


def test_an_engaged_member_is_in_the_project(world: World):
    limit(world)
    with world.server.runtime.database.writing() as session:
        session.add(Membership(studio_id=world.studio_id, person_id=world.designer_id, roles=[Role.REVIEWER]))
    assert world.designer.get(f"/v1/projects/{world.project_id}").status_code == 200


@pytest.mark.parametrize(
    ("who", "problem"), [("producer_id", "the only producer"), ("approver_id", "an approver or an audio lead")]
)
def test_whom_a_project_needs_stays_in_it(world: World, who: str, problem: str):
    limit(world)
    answer = world.producer.delete(f"/v1/projects/{world.project_id}/members/{getattr(world, who)}")
    assert (answer.status_code, answer.json()["code"]) == (409, "member-needed")
    assert problem in answer.json()["detail"]


def test_strangers_are_not_added(world: World):
    answer = world.producer.put(f"/v1/projects/{world.project_id}/members/{world.stranger_id}")
    assert (answer.status_code, answer.json()["code"]) == (404, "project-member-not-found")


def test_who_is_named_is_in_the_project(world: World):
    limit(world)
    page = f"/v1/projects/{world.project_id}"
    assert world.producer.put(f"{page}/liaisons/{world.reviewer_id}").status_code < 300
    assert world.reviewer.get(page).status_code == 200
    assert "Composer" in names(world)


def test_a_project_keeps_a_producer_when_its_last_one_leaves(world: World):
    leaver_id, leaver = add_producer(world, "Leaver")
    limit(world)
    opened = leaver.post(
        "/v1/projects", json={"studio_id": str(world.studio_id), "name": "Left Game", "cue_prefix": "LG"}
    )
    address = f"/v1/studios/{world.studio_id}/people/{leaver_id}"
    departure = world.producer.get(f"{address}/departure")
    assert "Left Game" not in departure.text
    assert {item["id"] for item in departure.json()} == {None}
    refused = world.producer.delete(address)
    assert refused.json()["code"] == "hand-over-needed"
    assert "Left Game" not in refused.text
    assert "1 project that you are not in" in refused.text
    assert world.producer.get(f"/v1/projects/{opened.json()['id']}").status_code == 404
    removed = world.producer.delete(address, params={"hand_over_to": str(world.producer_id)})
    assert removed.status_code == 204, removed.text
    assert set(project_names(world.producer)) == {"Shield Wing", "Left Game"}


def test_the_last_producer_who_leaves_by_themselves_leaves_it_to_the_others(world: World):
    leaver_id, leaver = add_producer(world, "Leaver")
    limit(world)
    leaver.post("/v1/projects", json={"studio_id": str(world.studio_id), "name": "Left Game", "cue_prefix": "LG"})
    address = f"/v1/studios/{world.studio_id}/people/{leaver_id}"
    left = leaver.delete(address, params={"hand_over_to": str(world.producer_id)})
    assert left.status_code == 204, left.text
    assert set(project_names(world.producer)) == {"Shield Wing", "Left Game"}


def test_a_removed_members_tokens_and_notices_end(world: World):
    maker_id, maker = add_producer(world)
    limit(world)
    page = f"/v1/projects/{world.project_id}"
    world.producer.put(f"{page}/members/{maker_id}")
    made = maker.post(f"{page}/tokens", json={"name": "CI", "scopes": ["spec:read"], "days": 30})
    assert made.status_code == 201, made.text
    build = world.server.browser()
    build.headers["Authorization"] = f"Bearer {made.json()['secret']}"
    assert build.get(f"{page}/spec.toml").status_code == 200
    with world.server.runtime.database.writing() as session:
        of = {"studio_id": world.studio_id, "project_id": world.project_id, "person_id": maker_id}
        session.add(
            Notice(**of, topic="list", event_id="1", news="list", subject="News", text="News", path=f"/{new_id()}")
        )
        assert notification_queries.is_addressed(session, world.studio_id, maker_id, world.project_id)
    assert maker.get("/v1/me/notices").json()["items"]
    world.producer.delete(f"{page}/members/{maker_id}")
    assert build.get(f"{page}/spec.toml").status_code == 401
    assert maker.get("/v1/me/notices").json()["items"] == []
    with world.server.runtime.database.reading() as session:
        assert not notification_queries.is_addressed(session, world.studio_id, maker_id, world.project_id)
        assert notification_queries.is_addressed(session, world.studio_id, maker_id)
