"""The record of who opened which version, and when."""

from datetime import timedelta
from typing import Any

import pytest
from httpx2 import Client
from sqlalchemy.orm import Session

from app.references import endpoints
from app.references.models import ReferenceOpening
from app.references.service import ONE_OPENING
from tests.support.references import add, added, opened, uploaded
from tests.support.server import World

STORY = b"The ship is hit, and the lights go out."


def log(world: World, by: Client | None = None, **query: str) -> dict[str, Any]:
    answer = (by or world.producer).get(f"/v1/projects/{world.project_id}/reference-openings", params=query)
    assert answer.status_code == 200, answer.text
    return dict(answer.json())


def test_a_file_is_sent_to_who_is_on_record(world: World) -> None:
    reference = added(world, "story.txt", STORY, caption="Story")
    version = f"/v1/reference-versions/{reference['version']['id']}"
    refused = world.designer.get(f"{version}/file")
    assert (refused.status_code, refused.json()["code"]) == (409, "reference-unopened")
    assert opened(world, reference, by=world.designer).content == STORY
    assert world.producer.get(f"{version}/file").status_code == 409  # one person's opening is not another's
    [entry] = log(world)["items"]
    assert entry["person"]["name"] == "Sound designer"
    assert (entry["reference_id"], entry["caption"]) == (reference["id"], "Story")
    assert (entry["file_name"], entry["version"], entry["is_removed"]) == ("story.txt", 1, False)


@pytest.mark.slow
def test_each_version_is_opened_for_itself(world: World) -> None:
    first = added(world, "story.txt", STORY)
    opened(world, first, by=world.designer)
    upload_id = uploaded(world, "story2.txt", STORY + b" At once.")
    second = world.producer.post(f"/v1/references/{first['id']}/versions", json={"upload_id": upload_id}).json()
    newer = f"/v1/reference-versions/{second['version']['id']}/file"
    assert world.designer.get(newer).status_code == 409
    opened(world, second, by=world.designer)
    assert [entry["version"] for entry in log(world)["items"]] == [2, 1]


@pytest.mark.slow
def test_what_is_opened_again_within_minutes_is_one_opening(world: World) -> None:
    reference = added(world, "story.txt", STORY)
    for _ in range(3):
        opened(world, reference, by=world.designer)
    assert len(log(world)["items"]) == 1

    def age(session: Session) -> None:
        for opening in session.query(ReferenceOpening).filter_by(person_id=world.designer_id):
            opening.opened_at -= ONE_OPENING + timedelta(seconds=1)

    world.server.in_database(age)
    opened(world, reference, by=world.designer)
    assert len(log(world)["items"]) == 2


def test_a_link_is_on_record_too(world: World) -> None:
    reference = add(world, url="https://example.test/clip").json()
    answer = world.designer.post(f"/v1/reference-versions/{reference['version']['id']}/openings")
    assert answer.status_code == 204
    assert [entry["file_name"] for entry in log(world)["items"]] == ["example.test"]


def test_the_record_outlives_the_reference(world: World) -> None:
    reference = added(world, "story.txt", STORY, caption="Story")
    opened(world, reference, by=world.designer)
    world.producer.delete(f"/v1/references/{reference['id']}")
    [entry] = log(world, world.approver)["items"]
    assert (entry["caption"], entry["is_removed"]) == ("Story", True)


def test_it_is_read_by_who_acts_for_the_team(world: World) -> None:
    url = f"/v1/projects/{world.project_id}/reference-openings"
    assert [client.get(url).status_code for client in (world.reviewer, world.designer, world.stranger)] == [
        403, 403, 404,
    ]  # fmt: skip


@pytest.mark.slow
def test_it_comes_in_pages_and_of_one_reference(world: World, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(endpoints, "PAGE", 2)
    references = [added(world, f"story{number}.txt", STORY) for number in range(3)]
    for reference in references:
        opened(world, reference, by=world.designer)
    first = log(world)
    second = log(world, cursor=first["next"])
    names = [entry["file_name"] for entry in first["items"] + second["items"]]
    assert (names, second["next"]) == (["story2.txt", "story1.txt", "story0.txt"], None)
    [only] = log(world, reference=references[1]["id"])["items"]
    assert only["file_name"] == "story1.txt"
