"""How a project goes: figures from what was decided and when, for both sides, and no figure from too little."""

from datetime import UTC, date, datetime, timedelta
from typing import Any

import pytest

from app.dashboards.velocity.rules import (
    FEW,
    CuePace,
    days_late,
    decided_before_and_since,
    finish_on,
    first_pass_share,
    longest_wait_hours,
    mean_rounds,
    median_hours,
    median_so_far,
    on_time_share,
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


def test_rounds_of_open_cues_count_so_far() -> None:
    accepted = [cue(accepted_days=1)] * 3
    assert mean_rounds([*accepted, cue(3, decided_days=1)]) == 0.75
    assert mean_rounds([*accepted, cue(), cue(decided_days=1)]) == 0, "nothing of these two is known yet"
    assert mean_rounds([cue(1, decided_days=1)] * 2) is None


def test_a_set_approved_in_part_is_not_yet_decided() -> None:
    partly = cue(decided_days=1)
    assert first_pass_share([cue(accepted_days=1), cue(accepted_days=1), cue(1, decided_days=1), partly]) == 2 / 3
    assert decided_before_and_since([partly], NOW - timedelta(days=3)) == ([], [])


def test_an_overdue_cue_is_late_by_the_days_so_far() -> None:
    today, due = NOW.date(), (NOW - timedelta(days=4)).date()
    cues = [cue(0, accepted_days=1, due=due), cue(3, accepted_days=2, due=due), cue(0, accepted_days=6, due=due)]
    assert days_late(cues, today) == 2
    assert days_late([*cues, cue(due=due)], today) == 2.5
    assert days_late([*cues, cue(due=today), cue()], today) == 2, "due today, or without a day: not late"
    assert days_late(cues[:2], today) is None
    assert on_time_share(cues, today) == 1 / 3
    assert on_time_share([*cues, cue(due=due), cue(due=today)], today) == 1 / 4


def test_what_was_adopted_without_a_review_measures_nothing() -> None:
    due = (NOW - timedelta(days=4)).date()
    adopted = [CuePace(0, NOW, NOW, due, is_adopted=True)] * 5
    assert (first_pass_share(adopted), mean_rounds(adopted), days_late(adopted, NOW.date())) == (None, None, None)
    assert finish_on([*adopted, cue()], NOW) is None


def test_the_finish_is_at_the_pace_of_four_weeks() -> None:
    done = [cue(accepted_days=days) for days in (1, 9, 20, 27)]
    assert finish_on([*done, cue(accepted_days=90), cue(), cue()], NOW) == date(2026, 12, 9)
    assert finish_on([cue(accepted_days=10)] * 2 + [cue()] * 4, NOW) == date(2026, 12, 15), "2 in the ten days so far"
    assert finish_on([cue(accepted_days=0)] * 2 + [cue()] * 4, NOW) == date(2026, 12, 9), "a day counts as a week"
    assert finish_on(done, NOW) is None, "nothing is left"
    assert finish_on([cue(accepted_days=90), cue()], NOW) is None, "nothing was accepted lately"


def test_half_of_the_time_it_took_longer() -> None:
    spans = [(NOW, NOW + timedelta(hours=hours)) for hours in (1, 30, 2)]
    assert median_hours(spans, NOW) == 2
    assert median_hours(spans[:2], NOW) is None


def test_an_open_wait_counts_once_it_is_longer_than_the_median() -> None:
    quick = [(NOW - timedelta(seconds=20), NOW - timedelta(seconds=12))] * 3
    assert median_hours(quick, NOW) == pytest.approx(8 / 3600)
    just_come = [(NOW - timedelta(seconds=1), None)] * 9
    assert median_hours([*quick, *just_come], NOW) == pytest.approx(8 / 3600)
    for_days = [(NOW - timedelta(days=3), None)] * 4
    assert median_hours([*quick, *for_days], NOW) == 72
    assert median_hours(for_days, NOW) is None, "nothing is finished"
    assert longest_wait_hours([NOW, NOW - timedelta(hours=5)], NOW) == 5
    assert longest_wait_hours([], NOW) is None
    assert median_so_far([0, 10], [4, 30]) == 10


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


@pytest.mark.slow
def test_both_sides_see_how_it_goes(world: World, stage: Stage) -> None:
    nothing = pace(world, world.producer)
    assert (nothing["first_pass"], nothing["rounds_per_cue"], nothing["finish_on"]) == (None, None, None)
    judge_three(stage)
    mine = pace(world, world.designer)
    assert (mine["cues"], mine["accepted"], mine["first_pass"]) == (4, 3, 0.5)
    assert mine["rounds_per_cue"] == 1, "none, none, one, and three so far"
    assert (mine["overdue"], mine["needed_on"]) == (1, "2020-01-01")
    assert [(one["name"], one["rounds"]) for one in mine["worn"]] == [("worn", 3)]
    assert mine["finish_on"] is not None
    assert 0 < mine["studio"]["review_hours"] < 1
    assert (mine["studio"]["waiting_reviews"], mine["studio"]["longest_review_wait_hours"]) == (0, None)
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
    studio = pace(world, world.producer)["studio"]
    assert (studio["open_questions"], studio["answer_hours"]) == (1, None)
    assert 0 <= studio["longest_answer_wait_hours"] < 1


def test_a_version_that_waits_for_its_verdict_is_counted(world: World, stage: Stage) -> None:
    stage.take(stage.cue("waits"))
    studio = pace(world, world.producer)["studio"]
    assert (studio["waiting_reviews"], studio["review_hours"]) == (1, None)
    assert 0 <= studio["longest_review_wait_hours"] < 1


def test_reviewers_and_strangers_do_not_see_it(world: World) -> None:
    assert world.reviewer.get(f"/v1/projects/{world.project_id}/pace").status_code == 403
    assert world.stranger.get(f"/v1/projects/{world.project_id}/pace").status_code == 404
