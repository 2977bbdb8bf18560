"""A version against another sound: who may ask, what is found, and the track that is played."""

from typing import Any
from uuid import UUID

import pytest

from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.projects.models import Project
from app.projects.rules import DesignersHear
from tests.app.reviews.making import Stage
from tests.app.scenes.making import drawn_take
from tests.support.server import World
from tests.support.waves import noise, sine, swelling

SOUND = swelling(noise(dbfs=-20.0, seconds=0.5))


@pytest.fixture
def versions(stage: Stage) -> tuple[str, str]:
    """Two versions of one cue: the second has a tone that the first has not."""
    cue_id = stage.cue("suit_hit")
    first = drawn_take(stage, cue_id, SOUND, state=TakeState.CHANGE_REQUESTED)
    second = drawn_take(stage, cue_id, SOUND + sine(hz=1_000, dbfs=-40.0, seconds=0.5))
    return str(first), str(second)


def ask(world: World, take_id: str, **body: Any) -> Any:
    return world.reviewer.post(f"/v1/takes/{take_id}/comparisons", json=body)


@pytest.mark.slow
def test_two_versions_are_compared_once(world: World, versions: tuple[str, str]):
    first, second = versions
    asked = ask(world, second, against_take_id=first)
    assert asked.status_code == 201, asked.text
    comparison = asked.json()
    assert (comparison["is_made"], comparison["file_url"]) == (False, None)
    unmade = world.reviewer.get(f"/v1/comparisons/{comparison['id']}/file")
    assert (unmade.status_code, unmade.json()["code"]) == (404, "comparison-not-made")
    world.server.wait_for_jobs()
    made = ask(world, second, against_take_id=first).json()
    assert made["id"] == comparison["id"]
    assert made == world.reviewer.get(f"/v1/comparisons/{comparison['id']}").json()
    assert made["residue_db"] == pytest.approx(-23.0, abs=0.5)
    assert (made["lag_s"], made["gain_db"]) == (0.0, pytest.approx(0.0, abs=0.1))
    assert len(made["spectra"]["hz"]) == len(made["spectra"]["difference_dbfs"])
    played = world.reviewer.get(made["file_url"])
    assert (played.status_code, played.headers["content-type"]) == (200, "audio/wav")
    assert len(played.content) == 44 + 2 * 24_000


@pytest.mark.parametrize("body", [{}, {"target": "nowhere"}])
def test_there_is_nothing_to_compare_with(world: World, versions: tuple[str, str], body: dict[str, Any]):
    assert ask(world, versions[0], **body).status_code == 409


def test_a_sound_is_not_compared_with_itself(world: World, versions: tuple[str, str]):
    refused = ask(world, versions[0], against_take_id=versions[0])
    assert (refused.status_code, refused.json()["code"]) == (409, "nothing-to-compare")


def test_another_project_is_not_within_sight(world: World, versions: tuple[str, str]):
    elsewhere = Stage(World(world.server))
    other = drawn_take(elsewhere, elsewhere.cue("suit_hit"), SOUND)
    assert ask(world, versions[0], against_take_id=str(other)).status_code == 404


@pytest.mark.slow
def test_the_team_and_their_designer_compare(world: World, versions: tuple[str, str]):
    first, second = versions
    body = {"against_take_id": first}
    made = ask(world, second, **body).json()
    for client, status in ((world.other_designer, 404), (world.stranger, 404)):
        assert client.post(f"/v1/takes/{second}/comparisons", json=body).status_code == status
        for path in (f"/v1/comparisons/{made['id']}", f"/v1/comparisons/{made['id']}/file"):
            assert client.get(path).status_code == status
    world.server.wait_for_jobs()


@pytest.mark.slow
@pytest.mark.parametrize(("choice", "status"), [(DesignersHear.OWN, 404), (DesignersHear.APPROVED, 200)])
def test_a_designer_compares_with_others_as_the_project_allows(
    world: World, versions: tuple[str, str], choice: DesignersHear, status: int
):
    rivals, own = versions

    def given_to_another(session) -> None:
        take = session.get_one(Take, UUID(rivals))
        take.designer_id, take.state = world.other_designer_id, TakeState.APPROVED
        session.get_one(Project, world.project_id).designers_hear = choice

    world.server.in_database(given_to_another)
    made = ask(world, own, against_take_id=rivals).json()
    world.server.wait_for_jobs()
    answer = world.designer.post(f"/v1/takes/{own}/comparisons", json={"against_take_id": rivals})
    assert answer.status_code == (201 if status == 200 else 404)
    for path in (f"/v1/comparisons/{made['id']}", f"/v1/comparisons/{made['id']}/file"):
        assert world.designer.get(path).status_code == status


@pytest.mark.slow
def test_a_designer_compares_their_own_versions(world: World, versions: tuple[str, str]):
    first, second = versions
    made = world.designer.post(f"/v1/takes/{second}/comparisons", json={"against_take_id": first})
    assert made.status_code == 201, made.text
    world.server.wait_for_jobs()
    assert world.designer.get(f"/v1/comparisons/{made.json()['id']}").json()["is_made"] is True
