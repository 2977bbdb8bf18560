"""What the database sums up of takes says the same as looking at each take: for the team and for a designer."""

import random
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any
from uuid import UUID

import pytest
from httpx2 import Client
from sqlalchemy import select
from sqlalchemy.orm import Session

from app.conformance.models import CheckRun
from app.core import clock
from app.deliveries.rules import TakeState
from app.projects.models import Engagement
from app.projects.rules import EngagementKind
from app.sound_lists.models import Question
from app.sound_lists.rules import CueState
from tests.app.reviews.making import Stage
from tests.support.server import World

T = TakeState
STATES = [*T]


@dataclass(frozen=True)
class Came:
    """One take as it was put there."""

    id: str
    variation: int
    state: TakeState
    designer_id: UUID


@dataclass(frozen=True)
class Line:
    """One cue as it was put there."""

    id: UUID
    variations: int
    is_cut: bool
    placeholder: bool
    is_asked: bool
    takes: Sequence[Came]


def of_variation(states: Sequence[TakeState]) -> str:
    """Say where one variation stands, its takes in the order they came."""
    if T.APPROVED in states:
        return "accepted"
    seen = [state for state in states if state is not T.SET_ASIDE]
    if not seen:
        return "to_make"
    if seen[-1] is T.RETURNED and T.CONFORMING in seen:
        return "to_review"
    return {T.RECEIVED: "checking", T.CONFORMING: "to_review"}.get(seen[-1], seen[-1].value)


def of_cue(line: Line, takes: Sequence[Came]) -> str:
    if line.is_cut:
        return "cut"
    reported = [
        of_variation([take.state for take in takes if take.variation == variation])
        for variation in range(1, line.variations + 1)
    ]
    if set(reported) == {"accepted"}:
        return "accepted"
    for status in ("change_requested", "returned", "unjudged", "to_review", "checking"):
        if status in reported:
            return status
    if line.is_asked:
        return "question"
    return "partly_accepted" if "accepted" in reported else "placeholder" if line.placeholder else "to_make"


@pytest.fixture
def stage(world: World) -> Stage:
    def engage(session: Any) -> None:
        session.add(
            Engagement(
                studio_id=world.studio_id,
                project_id=world.project_id,
                designer_id=world.other_designer_id,
                kind=EngagementKind.CONTRACT,
            )
        )

    world.server.in_database(engage)
    return Stage(world)


def thrown(stage: Stage, seed: int, cues: int) -> list[Line]:
    """Put cues there whose takes stand in every way that dice throw."""
    dice, world = random.Random(seed), stage.world
    lines = []
    for place in range(cues):
        variations, is_cut = dice.choice((1, 1, 2, 4)), dice.random() < 0.1
        placeholder, is_asked = dice.random() < 0.3, dice.random() < 0.2
        facts = {"state": CueState.CUT, "cut_at": clock.now()} if is_cut else {}
        cue_id = stage.cue(f"sound_{place}", variations=variations, placeholder=placeholder, **facts)
        takes = []
        for _ in range(dice.choice((0, 1, 3, 6))):
            variation = dice.randrange(1, variations + 2)  # one more than are wanted: the list was cut down since
            state, designer_id = dice.choice(STATES), dice.choice((world.designer_id, world.other_designer_id))
            if any(take.variation == variation and take.state is T.APPROVED for take in takes):
                state = T.SET_ASIDE
            take_id = stage.take(cue_id, variation, state=state, designer_id=designer_id)
            takes.append(Came(str(take_id), variation, state, designer_id))
        if is_asked:
            world.server.in_database(lambda session, cue_id=cue_id: session.add(_question(world, cue_id)))
        lines.append(Line(cue_id, variations, is_cut, placeholder, is_asked, takes))
    return lines


def _question(world: World, cue_id: UUID) -> Question:
    return Question(
        studio_id=world.studio_id,
        project_id=world.project_id,
        cue_id=cue_id,
        text="Wet or dry?",
        asked_by=world.designer_id,
    )


def read(world: World, by: Client, path: str, **query: Any) -> dict[str, Any]:
    answer = by.get(f"/v1/projects/{world.project_id}/{path}", params=query)
    assert answer.status_code == 200, answer.text
    return dict(answer.json())


def all_progress(world: World, by: Client) -> dict[str, dict[str, Any]]:
    """Return where every cue stands, gathered from short pages."""
    found, page = {}, read(world, by, "sound-list/progress", limit=7)
    while True:
        found |= {each["cue_id"]: each for each in page["cues"]}
        if not page["next"]:
            return found
        page = read(world, by, "sound-list/progress", limit=7, cursor=page["next"])


@pytest.mark.slow
@pytest.mark.parametrize("seed", [1, 2])
def test_sums_say_what_looking_at_each_take_says(stage: Stage, seed: int):
    world = stage.world
    lines = thrown(stage, seed, cues=24)
    for by, designer_id in ((world.producer, None), (world.designer, world.designer_id)):
        seen = {line.id: [take for take in line.takes if designer_id in (None, take.designer_id)] for line in lines}
        wanted = {str(line.id): of_cue(line, seen[line.id]) for line in lines}
        found = all_progress(world, by)
        assert {cue_id: each["status"] for cue_id, each in found.items()} == wanted
        assert list(found) == [str(line.id) for line in lines]  # in list order
        counts = read(world, by, "sound-list/counts")
        assert counts["counts"] == Counter(wanted.values())
        matched = [take for takes in seen.values() for take in takes]
        assert counts["files_to_review"] == sum(take.state is T.CONFORMING for take in matched)
        steps = read(world, by, "overview")["steps"]
        assert {step["cue"]["id"]: step["status"] for step in steps} == wanted
        for line in lines:
            reported, takes = found[str(line.id)], seen[line.id]
            if wanted[str(line.id)] != "accepted":
                assert (reported["newest_take"] or {}).get("id") == (takes[-1].id if takes else None)
            waiting = Counter(take.variation for take in takes if take.state is T.CONFORMING)
            assert reported["alternates"] == max(waiting.values(), default=0)
            assert reported["open_question"] == ("Wet or dry?" if line.is_asked else None)


@pytest.mark.slow
@pytest.mark.parametrize("seed", [3])
def test_what_waits_for_others_is_the_newest_of_cues_that_still_need_it(stage: Stage, seed: int):
    world = stage.world
    lines = thrown(stage, seed, cues=24)
    back = {T.RETURNED, T.CHANGE_REQUESTED, T.UNJUDGED}
    wanted = sorted(
        line.takes[-1].state.value
        for line in lines
        if line.takes
        and line.takes[-1].state in back
        and not line.is_cut
        and {take.variation for take in line.takes if take.state is T.APPROVED} < set(range(1, line.variations + 1))
    )
    assert sorted(each["status"] for each in read(world, world.producer, "today")["with_others"]) == wanted


def test_an_accepted_cue_shows_what_was_approved_and_not_what_came_later(stage: Stage):
    cue_id = stage.cue("shield_hit")
    approved = stage.take(cue_id, state=T.APPROVED)
    stage.take(cue_id, state=T.SET_ASIDE)
    reported = all_progress(stage.world, stage.world.producer)[str(cue_id)]
    assert (reported["status"], reported["newest_take"]["id"], reported["versions"]) == ("accepted", str(approved), 2)
    assert reported["worst_finding"] is None  # what was found is settled


def test_the_worst_of_what_stands_is_shown(stage: Stage):
    cue_id = stage.cue("shield_hit")
    stage.take(cue_id, state=T.CONFORMING)
    reported = all_progress(stage.world, stage.world.producer)[str(cue_id)]
    assert reported["worst_finding"]["code"] == "true-peak:over"
    gone = stage.cue("laser_fire")
    stage.take(gone, state=T.SET_ASIDE)
    assert all_progress(stage.world, stage.world.producer)[str(gone)]["worst_finding"] is None


def test_a_return_that_was_answered_no_longer_stands(stage: Stage):
    cue_id = stage.cue("alarm")
    returned = stage.take(cue_id, state=T.RETURNED)

    def silent(session: Session) -> None:
        run = session.scalars(select(CheckRun).where(CheckRun.take_id == returned)).one()
        finding = run.report["findings"][0] | {"check": "silence", "code": "silence:file", "severity": "error"}
        run.report = run.report | {"findings": [finding]}

    stage.world.server.in_database(silent)
    sides = (stage.world.producer, stage.world.designer)

    def shown() -> list[str]:
        return [all_progress(stage.world, by)[str(cue_id)]["worst_finding"]["code"] for by in sides]

    assert shown() == ["silence:file"] * 2
    stage.take(cue_id, state=T.CONFORMING)  # as a fix that was used is
    assert shown() == ["true-peak:over"] * 2
