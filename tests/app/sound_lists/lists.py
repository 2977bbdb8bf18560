"""Lists as a producer makes them, for the tests of this room."""

from typing import Any
from uuid import UUID

from httpx2 import Client
from sqlalchemy.orm import Session

from app.accounts.rules import Actor, Role
from app.sound_lists import service
from app.sound_lists.models import Cue
from tests.support.server import World


def add(world: World, *rows: dict[str, object], by: Client | None = None) -> list[dict[str, Any]]:
    answer = (by or world.producer).post(f"/v1/projects/{world.project_id}/cues", json={"cues": list(rows)})
    assert answer.status_code == 201, answer.text
    cues: list[dict[str, Any]] = answer.json()
    return cues


def the_list(world: World) -> dict[str, Any]:
    """The revision and every cue, whatever the number of pages."""
    found: dict[str, Any] = {"cues": []}
    cursor: str | None = None
    while "revision" not in found or cursor:
        page = page_of(world, cursor=cursor)
        cursor = page["next"]
        found = {"revision": page["revision"], "cues": [*found["cues"], *page["cues"]]}
    return found


def page_of(world: World, path: str = "sound-list", by: Client | None = None, **query: Any) -> dict[str, Any]:
    asked = {name: value for name, value in query.items() if value is not None}
    answer = (by or world.producer).get(f"/v1/projects/{world.project_id}/{path}", params=asked)
    assert answer.status_code == 200, answer.text
    page: dict[str, Any] = answer.json()
    return page


def columns_of(world: World) -> dict[str, Any]:
    """The columns of the project's own, and their edition."""
    return page_of(world, "sound-list/columns", by=world.designer)


def set_columns(world: World, columns: list[dict[str, Any]]) -> dict[str, Any]:
    body = {"columns": columns, "edition": columns_of(world)["edition"]}
    answer = world.producer.put(f"/v1/projects/{world.project_id}/sound-list/columns", json=body)
    assert answer.status_code == 200, answer.text
    found: dict[str, Any] = answer.json()
    return found


def cut(world: World, cue_id: object, reason: str) -> None:
    actor = Actor(person_id=world.approver_id, roles={world.studio_id: frozenset({Role.LIAISON})})

    def do(session: Session) -> None:
        cue = session.get_one(Cue, UUID(str(cue_id)))
        service.cut_cue(session, actor, cue, reason)

    world.server.in_database(do)
