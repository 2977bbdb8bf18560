"""How a project goes: figures from what was decided and when, for both sides, and no figure from too little."""

from datetime import UTC, date, datetime, timedelta
from typing import Any

import pytest

from app.dashboards.pace_rules import (
    FEW,
    CuePace,
    days_late,
    decided_before_and_since,
    finish_on,
    first_pass_share,
    mean_rounds,
    median_hours,
)
from tests.app.reviews.making import Stage
from tests.support.server import World

NOW = datetime(2026, 11, 25, 12, tzinfo=UTC)


def cue(rounds: int = 0, *, decided_days: int | None = None, accepted_days: int | None = None, due: date | None = None):
    """Return a cue that was first decided, and accepted, so many days ago."""
    ago = [NOW - timedelta(days=days) if days is not None else None for days in (decided_days, accepted_days)]
    return CuePace(rounds, ago[0] or ago[1], ago[1], due)


def test_first_pass_is_what_was_accepted_as_it_came() -> None:
    cues = [cue(accepted_days=1), cue(accepted_days=2), cue(1, decided_days=3), cue(2, decided_days=9, accepted_days=1)]
    assert first_pass_share([*cues, cue()]) == 0.5
    assert first_pass_share(cues[: FEW - 1]) is None
    before, lately = decided_before_and_since([*cues, cue()], NOW - timedelta(days=3))
    assert (len(before), len(lately)) == (1, 3)


def test_equal_cues_count_each() -> None:
    before, lately = decided_before_and_since([cue(accepted_days=1)] * 4, NOW - timedelta(days=3))
    assert (before, len(lately)) == ([], 4)


def test_rounds_and_lateness_are_of_accepted_cues() -> None:
    due = (NOW - timedelta(days=4)).date()
    cues = [cue(0, accepted_days=1, due=due), cue(3, accepted_days=2, due=due), cue(0, accepted_days=6, due=due)]
    assert mean_rounds([*cues, cue(9, decided_days=1)]) == 1
    assert days_late([*cues, cue(due=due)]) == 2
    assert days_late(cues[:2]) is None


def test_the_finish_is_at_the_pace_of_four_weeks() -> None:
    done = [cue(accepted_days=days) for days in (1, 9, 20, 27)]
    assert finish_on([*done, cue(accepted_days=90), cue(), cue()], NOW) == date(2026, 12, 9)
    assert finish_on(done, NOW) is None, "nothing is left"
    assert finish_on([cue(accepted_days=90), cue()], NOW) is None, "nothing was accepted lately"


def test_half_of_the_time_it_took_longer() -> None:
    spans = [(NOW, NOW + timedelta(hours=hours)) for hours in (1, 30, 2)]
    assert median_hours(spans) == 2
    assert median_hours(spans[:2]) is None


@pytest.fixture
def stage(world: World) -> Stage:
    return Stage(world)


def pace(world: World, by: Any) -> dict[str, Any]:
    answer = by.get(f"/v1/projects/{world.project_id}/pace")
    assert answer.status_code == 200, answer.text
    return dict(answer.json())


def judge_three(stage: Stage) -> None:
    """Accept two cues as they came, and one after a round; one waits after three rounds."""
    for number in range(2):
        stage.approve(stage.take(stage.cue(f"kept_{number}")))
    second = stage.cue("second_try")
    stage.draft(stage.take(second))
    stage.send()
    stage.approve(stage.take(second))
    worn = stage.cue("worn", due_on=date(2020, 1, 1))
    for _ in range(3):
        stage.draft(stage.take(worn))
        stage.send()


def test_both_sides_see_how_it_goes(world: World, stage: Stage) -> None:
    nothing = pace(world, world.producer)
    assert (nothing["first_pass"], nothing["rounds_per_cue"], nothing["finish_on"]) == (None, None, None)
    judge_three(stage)
    mine = pace(world, world.designer)
    assert (mine["cues"], mine["accepted"], mine["first_pass"]) == (4, 3, 0.5)
    assert mine["rounds_per_cue"] == pytest.approx(1 / 3)
    assert (mine["overdue"], mine["needed_on"]) == (1, "2020-01-01")
    assert [(one["name"], one["rounds"]) for one in mine["worn"]] == [("worn", 3)]
    assert mine["finish_on"] is not None
    assert mine["studio"]["review_hours"] is not None
    whole = pace(world, world.producer)
    assert whole["accepted"] == 3
    assert whole["first_pass"] == 0.5


@pytest.mark.slow
def test_what_was_undone_was_not_decided(world: World, stage: Stage) -> None:
    judge_three(stage)
    take = stage.take(stage.cue("undone"))
    stage.approve(take)
    assert pace(world, world.producer)["accepted"] == 4
    assert stage.undo(take).status_code == 200
    assert pace(world, world.producer)["accepted"] == 3


def test_a_question_that_waits_is_counted(world: World, stage: Stage) -> None:
    cue_id = stage.cue("asked")
    world.designer.post(f"/v1/cues/{cue_id}/questions", json={"text": "how heavy?"})
    assert pace(world, world.producer)["studio"]["open_questions"] == 1


def test_reviewers_and_strangers_do_not_see_it(world: World) -> None:
    assert world.reviewer.get(f"/v1/projects/{world.project_id}/pace").status_code == 403
    assert world.stranger.get(f"/v1/projects/{world.project_id}/pace").status_code == 404
