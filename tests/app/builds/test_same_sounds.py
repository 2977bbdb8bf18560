"""A sound that equals an approved one of another project is reported to those who may see both."""

import copy
import io
from typing import Any
from uuid import UUID

import numpy as np
import pytest
import python_calamine
import sqlalchemy as sa
from numpy.typing import NDArray
from sqlalchemy.orm import Session

import audio_checks
from app.builds.same_sounds.models import MasterFingerprint
from app.projects.models import ApproverChange, Engagement, Liaison, Project, Spec
from app.projects.rules import EngagementKind
from tests.app.reviews.making import body_of
from tests.support.deliver import add_cues, deliver
from tests.support.server import World
from tests.support.waves import noise, wav_bytes

pytestmark = pytest.mark.slow

RATE = 44_100


def burst(seed: int, seconds: float = 0.6) -> NDArray[np.float64]:
    """A burst of noise that dies away, so that no part of it is like another."""
    fall = np.exp(-np.linspace(0, 3, round(seconds * RATE)))[:, np.newaxis]
    return noise(dbfs=-12, seconds=seconds, rate=RATE, seed=seed) * fall


def other_project(world: World, designer_id: UUID) -> World:
    """The same people with another project of the studio, on which a designer is engaged."""

    def add(session: Session) -> UUID:
        project = Project(
            studio_id=world.studio_id, name="Night Harbour", cue_prefix="NH", created_by=world.producer_id
        )
        session.add(project)
        session.flush()
        of: dict[str, Any] = {"studio_id": world.studio_id, "project_id": project.id}
        toml = audio_checks.new_spec("44k1", name="Night Harbour")
        sha256 = audio_checks.parse_spec(toml).sha256
        why = {"reason": "named when the project opened", "changed_by": world.producer_id}
        session.add_all(
            [
                Liaison(**of, person_id=world.approver_id),
                ApproverChange(**of, person_id=world.approver_id, **why),
                Engagement(**of, designer_id=designer_id, kind=EngagementKind.CONTRACT),
                Spec(**of, version=1, toml=toml, sha256=sha256, created_by=world.producer_id),
            ]
        )
        return project.id

    other = copy.copy(world)
    other.project_id = world.server.in_database(add)
    if designer_id != world.designer_id:
        vars(other)["designer"] = world.other_designer
    return other


def take_of(world: World, name: str, samples: NDArray[np.float64]) -> str:
    """Deliver a sound for a new cue, and return the take, checked."""
    (cue,) = add_cues(world, {"name": name})
    take = deliver(world, f"{cue['stems'][0]}.wav", wav_bytes(samples, rate=RATE, bits=24))
    world.server.wait_for_jobs()
    return str(take["id"])


def approve(world: World, take_id: str) -> None:
    """Approve a take, and run what follows."""
    body_of(world.approver.post(f"/v1/takes/{take_id}/verdict", json={"kind": "approve", "note": ""}))
    world.server.wait_for_jobs()


def same_sounds(client: Any, take_id: str) -> list[dict[str, Any]]:
    """Return where else a take's sound is."""
    return list(body_of(client.get(f"/v1/takes/{take_id}/same-sounds"))["sounds"])


@pytest.mark.both_databases
def test_a_changed_copy_of_an_approved_sound_is_reported_to_both_projects(world: World) -> None:
    sound = burst(1)
    approved = take_of(world, "Shield hit", sound)
    approve(world, approved)
    other = other_project(world, world.designer_id)
    quieter = take_of(other, "Hull knock", sound * 10 ** (-6 / 20))
    cut = take_of(other, "Hull knock short", sound[round(0.02 * RATE) :])
    unlike = take_of(other, "Gull", burst(2))

    (found,) = same_sounds(world.approver, quieter)
    assert (found["take_id"], found["project_name"], found["version"]) == (approved, "Shield Wing", 1)
    assert found["cue"].endswith("Shield hit")
    assert found["words"] == "the same sound, 6.0 dB quieter"
    assert found["gain_db"] == pytest.approx(-6.0, abs=0.15)
    assert [same_sound["words"] for same_sound in same_sounds(world.approver, cut)] == [
        "the same sound, with another start or end"
    ]
    assert body_of(world.producer.get(f"/v1/takes/{unlike}/same-sounds")) == {
        "take_id": unlike, "is_compared": True, "sounds": [], "libraries": [],
    }  # fmt: skip

    assert same_sounds(world.approver, approved) == [], "nothing of the other project is approved"
    approve(other, quieter)
    (back,) = same_sounds(world.approver, approved)
    assert (back["take_id"], back["words"]) == (quieter, "the same sound, 6.0 dB louder")


def test_sounds_of_one_project_are_not_compared_with_each_other(world: World) -> None:
    sound = burst(3)
    approve(world, take_of(world, "Shield hit", sound))
    again = take_of(world, "Shield hit soft", sound / 2)
    assert same_sounds(world.approver, again) == []


def test_a_designer_never_learns_of_another_project(world: World) -> None:
    sound = burst(4)
    approved = take_of(world, "Shield hit", sound)
    approve(world, approved)
    other = other_project(world, world.other_designer_id)
    copied = take_of(other, "Hull knock", sound / 2)
    approve(other, copied)
    assert len(same_sounds(world.approver, copied)) == 1
    for designer, own, foreign in (
        (world.designer, approved, copied),
        (world.other_designer, copied, approved),
    ):
        answer = designer.get(f"/v1/takes/{own}/same-sounds")
        assert answer.json() == {"take_id": own, "is_compared": None, "sounds": [], "libraries": []}
        assert designer.get(f"/v1/takes/{foreign}/same-sounds").status_code == 404
    assert world.stranger.get(f"/v1/takes/{copied}/same-sounds").status_code == 404


def test_a_designer_sees_a_match_of_two_takes_of_their_own_while_engaged_on_both(world: World) -> None:
    sound = burst(5)
    approved = take_of(world, "Shield hit", sound)
    approve(world, approved)
    other = other_project(world, world.designer_id)
    copied = take_of(other, "Hull knock", sound / 2)
    assert [same_sound["take_id"] for same_sound in same_sounds(world.designer, copied)] == [approved]

    def end_engagement(session: Session) -> None:
        session.execute(sa.delete(Engagement).where(Engagement.project_id == world.project_id))

    world.server.in_database(end_engagement)
    assert same_sounds(world.designer, copied) == []


def test_the_clearance_sheet_names_the_same_sound(world: World) -> None:
    sound = burst(6)
    other = other_project(world, world.designer_id)
    approve(other, take_of(other, "Hull knock", sound))
    approve(world, take_of(world, "Shield hit", sound / 2))
    approve(world, take_of(world, "Gull", burst(7)))
    content = world.producer.get(f"/v1/projects/{world.project_id}/clearance-sheet.xlsx").content
    head, *rows = python_calamine.load_workbook(io.BytesIO(content)).get_sheet_by_index(0).to_python()
    said = {row[head.index("name")]: row[head.index("same_sound_in")] for row in rows}
    assert said["Gull"] == ""
    assert said["Shield hit"].startswith("Night Harbour: NH")
    assert said["Shield hit"].endswith("Hull knock, the same sound, 6.0 dB quieter")


@pytest.mark.both_databases
def test_sounds_approved_before_masters_were_fingerprinted_are_found_too(world: World) -> None:
    sound = burst(8)
    approved = take_of(world, "Shield hit", sound)
    approve(world, approved)
    world.server.in_database(lambda session: session.execute(sa.delete(MasterFingerprint)))
    other = other_project(world, world.designer_id)
    first = take_of(other, "Hull knock", sound / 2)
    approve(other, first)
    assert [same_sound["take_id"] for same_sound in same_sounds(world.approver, first)] == [approved]
    assert [same_sound["take_id"] for same_sound in same_sounds(world.approver, approved)] == [first]
