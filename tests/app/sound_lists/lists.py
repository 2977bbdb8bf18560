"""Lists as a producer makes them, for the tests of this room."""

from typing import Any
from uuid import UUID

from fastapi.testclient import TestClient
from sqlalchemy.orm import Session

from app.accounts.rules import Actor, Role
from app.sound_lists import service
from app.sound_lists.models import Cue
from tests.support.server import World


def add(world: World, *rows: dict[str, object], by: TestClient | None = None) -> list[dict[str, Any]]:
    answer = (by or world.producer).post(f"/v1/projects/{world.project_id}/cues", json={"cues": list(rows)})
    assert answer.status_code == 201, answer.text
    cues: list[dict[str, Any]] = answer.json()
    return cues


def the_list(world: World) -> dict[str, Any]:
    answer = world.producer.get(f"/v1/projects/{world.project_id}/sound-list")
    assert answer.status_code == 200
    found: dict[str, Any] = answer.json()
    return found


def cut(world: World, cue_id: object, reason: str) -> None:
    actor = Actor(person_id=world.decider_id, roles={world.studio_id: frozenset({Role.LIAISON})})

    def do(session: Session) -> None:
        cue = session.get_one(Cue, UUID(str(cue_id)))
        service.cut_cue(session, actor, cue, reason)

    world.server.in_database(do)
