"""What a set says of its takes: once it is whole, to both sides, and without returning any of them."""

import re
from typing import Any
from uuid import UUID

import numpy as np
import pytest

from app.conformance import queries, set_findings
from app.conformance.rules import MemberFact, members_of_set
from app.core.db import new_id
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.projects.queries import current_spec
from app.sound_lists.models import Cue
from benchmarks.plans import heard
from tests.support.deliver import add_cues, checked, deliver, open_delivery
from tests.support.server import World
from tests.support.waves import noise, wav_bytes


def burst(variation: int, dbfs: float = -20.0) -> bytes:
    """One of a set of noises that begin and end softly."""
    edges = np.minimum(1, np.minimum(np.arange(24_000), np.arange(24_000)[::-1]) / 48)
    return wav_bytes(noise(seconds=0.5, seed=variation, dbfs=dbfs) * edges[:, np.newaxis])


def of_sets(check: dict[str, Any]) -> list[tuple[str, str]]:
    """Return what is found over files together, with its message."""
    return [
        (one["code"], one["message"]) for one in check["findings"] if one["check"] in ("variation-set", "duplicate")
    ]


def deliver_set(world: World, levels: dict[int, float]) -> dict[int, str]:
    """Deliver variations at their levels, and return their takes by variation."""
    delivery = open_delivery(world)
    return {
        variation: deliver(world, f"step_{variation:02}.wav", burst(variation, level), delivery_id=delivery)["id"]
        for variation, level in levels.items()
    }


@pytest.mark.slow
def test_the_one_that_stands_out_is_named_once_the_set_is_whole(world: World) -> None:
    add_cues(world, {"name": "Step", "variations": 4})
    takes = deliver_set(world, {1: -20, 2: -20, 3: -16})
    assert of_sets(checked(world, takes[3])) == []
    takes |= deliver_set(world, {4: -20})
    found = checked(world, takes[3])
    assert [code for code, _ in of_sets(found)] == ["variation-set:level"]
    assert re.fullmatch(r"_03 is (3\.9|4\.[01]) LU louder than the rest of its set, limit 2 LU", of_sets(found)[0][1])
    assert found["state"] == "conforming"  # a verdict is over one file
    assert of_sets(checked(world, takes[1])) == []


@pytest.mark.slow
def test_the_review_room_shows_it_and_how_far_each_is_away(world: World) -> None:
    [cue] = add_cues(world, {"name": "Step", "variations": 3})
    deliver_set(world, {1: -20, 2: -20, 3: -16})
    world.server.wait_for_jobs()
    [item] = world.approver.get("/v1/review-queue", params={"project_id": world.project_id}).json()["items"]
    codes = [finding["code"] for take in item["takes"] for finding in take["findings"]]
    assert codes == ["variation-set:level"]
    assert item["worst_finding"]["code"] == "variation-set:level"
    away = {take["variation"]: take["away_from_set_lu"] for take in item["takes"]}
    assert away == {1: pytest.approx(-2, abs=0.2), 2: pytest.approx(-2, abs=0.2), 3: pytest.approx(4, abs=0.2)}
    room = world.approver.get(f"/v1/cues/{cue['id']}/review").json()
    third = next(take for take in room["takes"] if take["variation"] == 3)
    assert "variation-set:level" in [finding["code"] for finding in third["findings"]]


@pytest.mark.slow
def test_the_list_shows_it(world: World) -> None:
    [cue] = add_cues(world, {"name": "Step", "variations": 3})
    deliver_set(world, {1: -20, 2: -20, 3: -16})
    world.server.wait_for_jobs()
    for who in (world.producer, world.designer):
        rows = who.get(f"/v1/projects/{world.project_id}/sound-list/progress").json()["cues"]
        [row] = [row for row in rows if row["cue_id"] == cue["id"]]
        assert row["worst_finding"]["message"].startswith("_03 is ")


@pytest.mark.slow
def test_a_newer_take_replaces_the_one_in_its_place(world: World) -> None:
    add_cues(world, {"name": "Step", "variations": 3})
    takes = deliver_set(world, {1: -20, 2: -20, 3: -16})
    again = deliver(world, "step_03.wav", burst(9, -20))
    assert of_sets(checked(world, again["id"])) == []
    assert of_sets(checked(world, takes[3])) == []  # it stands in the set no more


@pytest.mark.slow
@pytest.mark.parametrize("table", ["checks", "categories.foley.checks"], ids=["for all", "for its category"])
def test_where_the_spec_turns_it_off(world: World, table: str) -> None:
    add_cues(world, {"name": "Step", "variations": 2, "category": "foley"})
    takes = deliver_set(world, {1: -20, 2: -14})
    assert of_sets(checked(world, takes[2]))
    path = f"/v1/projects/{world.project_id}/spec"
    now = world.producer.get(path).json()
    off = f'[{table}]\nvariation-set = "off"'
    toml = now["toml"].replace("[checks]", off, 1) if table == "checks" else f"{now['toml']}\n{off}\n"
    saved = world.producer.put(path, json={"toml": toml, "note": "", "based_on_version": now["version"]})
    assert saved.status_code == 200, saved.text
    assert of_sets(checked(world, takes[2])) == []


@pytest.mark.slow
def test_what_was_found_is_remembered_until_something_of_it_changes(world: World) -> None:
    [cue] = add_cues(world, {"name": "Step", "variations": 2, "category": "foley"})
    takes = deliver_set(world, {1: -20, 2: -14})
    assert of_sets(checked(world, takes[2]))
    path = f"/v1/projects/{world.project_id}/spec"
    now = world.producer.get(path).json()
    toml = f'{now["toml"]}\n[categories.impact.checks]\nvariation-set = "off"\n'
    world.producer.put(path, json={"toml": toml, "note": "", "based_on_version": now["version"]})
    assert of_sets(checked(world, takes[2]))
    with heard(world.server.runtime.database.engine) as statements:
        assert of_sets(checked(world, takes[2]))
    assert not [text for text, _ in statements if "likeness_print" in text]
    changed = world.producer.patch(f"/v1/cues/{cue['id']}", json={"category": "impact", "edition": cue["edition"]})
    assert changed.status_code == 200, changed.text
    assert of_sets(checked(world, takes[2])) == []


@pytest.mark.slow
def test_what_was_found_counts_for_the_facts_of_its_cue(world: World) -> None:
    [cue] = add_cues(world, {"name": "Step", "variations": 3, "category": "foley"})
    takes = deliver_set(world, {1: -20, 2: -20, 3: -14})
    world.server.wait_for_jobs()
    with world.server.runtime.database.reading() as session:
        asked, spec = session.get_one(Cue, UUID(cue["id"])), current_spec(session, world.project_id)
        session.expunge(asked)  # what changes of it below reaches no table, and so no job checks its takes again

        def found() -> list[str]:
            word = set_findings.findings_of_sets(session, [asked], {world.project_id: spec}).get(UUID(takes[3]))
            return [str(finding["code"]) for finding in word.findings] if word else []

        assert found() == ["variation-set:level"]
        asked.variations = 4  # one is missing now: a set speaks when it is whole
        assert found() == []


@pytest.mark.slow
def test_a_set_is_another_once_anything_of_a_take_in_it_changes(world: World) -> None:
    [cue] = add_cues(world, {"name": "Step", "variations": 2, "category": "foley"})
    takes = deliver_set(world, {1: -20, 2: -14})
    world.server.wait_for_jobs()
    cue_id = UUID(cue["id"])
    changes = {"state": TakeState.APPROVED, "alternate": 2, "number": 7, "variation": 3}
    with world.server.runtime.database.writing() as session:
        seen = [queries.sets_of_takes(session, [cue_id], None)[cue_id]]
        assert set(queries.takes_in(seen[0])) == {UUID(take_id) for take_id in takes.values()}
        take = session.get_one(Take, UUID(takes[1]))
        for name, value in changes.items():
            setattr(take, name, value)
            session.flush()
            seen.append(queries.sets_of_takes(session, [cue_id], None)[cue_id])
        session.rollback()
    assert len(set(seen)) == 1 + len(changes)


@pytest.mark.slow
def test_one_sound_under_two_names_of_a_delivery(world: World) -> None:
    _, close = add_cues(world, {"name": "Door open"}, {"name": "Door close"})
    delivery = open_delivery(world)
    first = deliver(world, "door_open.wav", burst(1), delivery_id=delivery)
    second = deliver(world, "door_close.wav", burst(1), delivery_id=delivery, cue_id=close["id"])
    assert of_sets(checked(world, second["id"])) == [("duplicate:same-sound", "the same samples as door_open.wav")]
    assert of_sets(checked(world, first["id"])) == []


def member(variation: int, number: int, *, alternate: int | None = None, approved: bool = False) -> MemberFact:
    return MemberFact(new_id(), variation, alternate, number, approved)


def test_who_stands_in_a_set() -> None:
    old, new, other = member(1, 1), member(1, 3), member(1, 2, alternate=2)
    approved, later = member(2, 1, approved=True), member(2, 2)
    standing = members_of_set([new, later, old, approved, other])
    assert set(standing) == {other.take_id, new.take_id, approved.take_id}
