"""The sample project: made in the caller's studio, with sounds to review, and deleted at once."""

from uuid import UUID

import pytest
import sqlalchemy as sa

from app.operations.samples.cues import sample_cues
from app.operations.samples.sounds import SOUNDS
from app.projects.models import Project
from tests.support.server import World
from tests.support.waiting import until


def open_sample(world: World) -> str:
    answer = world.producer.post(f"/v1/studios/{world.studio_id}/sample")
    assert answer.status_code == 201, answer.text
    sample_id: str = answer.json()["id"]
    return sample_id


@pytest.mark.slow
def test_a_sample_has_cues_and_sounds_to_review_and_goes_at_once(world: World) -> None:
    sample_id = open_sample(world)
    assert open_sample(world) == sample_id  # one a studio
    [mine] = [project for project in world.producer.get("/v1/me").json()["projects"] if project["id"] == sample_id]
    assert (mine["name"], mine["is_sample"], mine["is_approver"]) == ("Sample project", True, True)
    listed = world.producer.get(f"/v1/projects/{sample_id}/sound-list").json()["cues"]
    assert [cue["name"] for cue in listed] == [cue["name"] for cue in sample_cues()]
    assert [cue["name"] for cue in listed if cue.get("refused_name")] == []
    world.server.wait_for_jobs()
    queue = world.producer.get("/v1/review-queue", params={"project_id": sample_id}).json()["items"]
    assert {item["cue"]["name"] for item in queue} == set(SOUNDS)

    assert world.producer.delete(f"/v1/projects/{sample_id}/sample").status_code == 204
    assert world.producer.get(f"/v1/projects/{sample_id}").status_code == 404
    assert open_sample(world) != sample_id  # and may be looked at again
    world.server.wait_for_jobs()


@pytest.mark.slow
def test_only_its_producers_make_and_delete_a_sample(world: World) -> None:
    sample_id = open_sample(world)
    path = f"/v1/projects/{sample_id}/sample"
    assert world.reviewer.post(f"/v1/studios/{world.studio_id}/sample").json()["code"] == "producer-needed"
    assert world.reviewer.delete(path).json()["code"] == "producer-needed"
    assert world.designer.delete(path).status_code == 404
    world.server.wait_for_jobs()


def test_no_other_project_is_deleted_as_a_sample(world: World) -> None:
    refused = world.producer.delete(f"/v1/projects/{world.project_id}/sample")
    assert (refused.status_code, refused.json()["code"]) == (409, "not-a-sample")
    assert refused.json()["fix"]
    assert world.producer.get(f"/v1/projects/{world.project_id}").status_code == 200


@pytest.mark.both_databases
def test_a_sample_that_is_deleted_while_its_sounds_are_checked_leaves_nothing(world: World) -> None:
    sample_id = open_sample(world)

    def is_deleted() -> bool:
        answer = world.producer.delete(f"/v1/projects/{sample_id}/sample")
        assert answer.status_code == 204 or answer.json()["code"] == "crossed"  # by a check of one of its sounds
        return answer.status_code == 204

    until(is_deleted)
    world.server.wait_for_jobs()
    with world.server.runtime.database.reading() as session:
        assert session.scalar(sa.select(Project).where(Project.id == UUID(sample_id))) is None
    jobs = world.producer.get(f"/v1/studios/{world.studio_id}/jobs", params={"state": "parked"}).json()
    assert jobs["items"] == []
