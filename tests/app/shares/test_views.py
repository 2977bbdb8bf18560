"""Saved views: each person's own, in the projects that they see."""

from typing import Any

import pytest
from httpx2 import Client

from app.shares.rules import MAX_VIEWS
from tests.support.server import World


def save(world: World, client: Client, **body: Any) -> Any:
    wanted = {"page": "sound_list", "name": "Mine", "query": "own=true", **body}
    return client.post(f"/v1/projects/{world.project_id}/saved-views", json=wanted)


def views(world: World, client: Client) -> list[dict[str, Any]]:
    answer = client.get(f"/v1/projects/{world.project_id}/saved-views")
    assert answer.status_code == 200, answer.text
    return list(answer.json())


def test_each_person_has_their_own_by_name(world: World) -> None:
    assert save(world, world.producer, name="Zone 2", query="category=zone2").status_code == 201
    assert save(world, world.producer, name="Late", query="need=must").status_code == 201
    assert save(world, world.designer, name="Zone 2", query="x=1").status_code == 201
    assert [(view["name"], view["query"]) for view in views(world, world.producer)] == [
        ("Late", "need=must"),
        ("Zone 2", "category=zone2"),
    ]
    assert [view["query"] for view in views(world, world.designer)] == ["x=1"]
    assert views(world, world.reviewer) == []


def test_the_same_name_is_replaced(world: World) -> None:
    first = save(world, world.producer).json()
    assert save(world, world.producer, query="category=zone").json()["id"] == first["id"]
    assert save(world, world.approver).json()["id"] != first["id"]
    assert [view["query"] for view in views(world, world.producer)] == ["category=zone"]


def test_only_its_owner_deletes_it(world: World) -> None:
    view = save(world, world.producer).json()
    url = f"/v1/saved-views/{view['id']}"
    for client in (world.approver, world.designer, world.stranger):
        assert client.delete(url).status_code == 404
    assert world.producer.delete(url).status_code == 204
    assert views(world, world.producer) == []


@pytest.mark.slow
def test_strangers_and_too_many(world: World) -> None:
    assert save(world, world.stranger).status_code == 404
    for number in range(MAX_VIEWS):
        assert save(world, world.producer, name=f"View {number}").status_code == 201
    refused = save(world, world.producer, name="One more")
    assert (refused.status_code, refused.json()["code"]) == (422, "saved-view-invalid")
    assert save(world, world.producer, query="x" * 2_001, name="View 1").status_code == 422


def test_views_of_the_review_queue_are_shared_by_the_team(world: World) -> None:
    queue = {"page": "review_queue", "name": "Music, new"}
    view = save(world, world.producer, **queue, query="category=music").json()
    assert [one["id"] for one in views(world, world.reviewer)] == [view["id"]]
    replaced = save(world, world.reviewer, **queue, query="category=music&version=new").json()
    assert (replaced["id"], replaced["query"]) == (view["id"], "category=music&version=new")
    assert views(world, world.designer) == []
    assert save(world, world.designer, **queue).status_code == 403
    for client in (world.designer, world.stranger):
        assert client.delete(f"/v1/saved-views/{view['id']}").status_code == 404
    assert world.approver.delete(f"/v1/saved-views/{view['id']}").status_code == 204
    assert views(world, world.producer) == []
