import itertools
import re
from datetime import UTC, datetime, timedelta

import pytest

from app.agreements.clauses.rules import library
from app.agreements.rules import WORK_STATE_WORDS, WorkState
from app.deliveries.rules import TakeState
from app.money.verdicts import work_state
from app.reviews.errors import RangeInvalid, StaleView, TooLateToUndo
from app.reviews.rules import (
    QueueKind,
    ensure_range,
    ensure_seen,
    ensure_undoable,
    missing_variations,
    queue_kind,
    why_not_counted,
)

NOON = datetime(2026, 11, 20, 12, tzinfo=UTC)


@pytest.mark.parametrize(
    ("variations", "approved", "missing"),
    [(1, [], [1]), (1, [1], []), (4, [1, 3], [2, 4]), (2, [1, 2, 3], []), (3, {3: "take"}, [1, 2])],
)
def test_a_cue_is_accepted_when_no_variation_is_missing(variations, approved, missing):
    assert missing_variations(variations, approved) == missing


def test_only_reversals_alone_are_no_round():
    assert why_not_counted([False]) is None
    assert why_not_counted([True, False]) is None
    assert "reversed" in (why_not_counted([True, True]) or "")


@pytest.mark.parametrize(
    ("variations", "states", "work"),
    [
        (2, {}, WorkState.NOT_BEGUN),
        (2, {1: []}, WorkState.NOT_BEGUN),
        (2, {1: [TakeState.APPROVED]}, WorkState.IN_WORK),
        (2, {2: [TakeState.APPROVED]}, WorkState.IN_WORK),
        (2, {1: [TakeState.APPROVED], 2: [TakeState.RETURNED]}, WorkState.IN_WORK),
        (2, {1: [TakeState.APPROVED], 2: [TakeState.CHANGE_REQUESTED]}, WorkState.IN_WORK),
        (2, {1: [TakeState.APPROVED], 2: [TakeState.RETURNED, TakeState.CONFORMING]}, WorkState.DELIVERED),
        (2, {1: [TakeState.APPROVED], 2: [TakeState.APPROVED]}, WorkState.ACCEPTED),
        (1, {1: [TakeState.APPROVED], 2: [TakeState.RETURNED]}, WorkState.ACCEPTED),  # the list asks for one now
    ],
)
def test_how_far_the_work_on_a_cue_is(variations, states, work):
    assert work_state(variations, states) is work


DELIVERED_OR_MORE = {TakeState.APPROVED, TakeState.CONFORMING}


def definitions_met(takes: tuple[set[TakeState], set[TakeState]]) -> list[WorkState]:
    """Return the states whose definition, as the clause on cut cues words it, holds for a cue with two files."""
    has_file = any(takes)
    is_accepted = all(TakeState.APPROVED in each for each in takes)
    is_delivered = all(DELIVERED_OR_MORE & each for each in takes)
    holds = {
        WorkState.NOT_BEGUN: not has_file,
        WorkState.IN_WORK: has_file and any(not DELIVERED_OR_MORE & each for each in takes),
        WorkState.DELIVERED: is_delivered and not is_accepted,
        WorkState.ACCEPTED: is_accepted,
    }
    return [state for state, is_met in holds.items() if is_met]


def test_every_cue_is_in_one_state_and_the_clause_defines_it():
    subsets = [set(each) for size in range(3) for each in itertools.combinations(TakeState, size)]
    for one, other in itertools.product(subsets, subsets):
        states = {1: one, 2: other}
        assert definitions_met((one, other)) == [work_state(2, states)], states
    (clause,) = (each.clause for each in library() if each.clause.key == "kill_fee")
    bullets = [line.removeprefix("- ") for line in clause.text.splitlines() if line.startswith("- ")]
    assert [re.sub(r": (?:\{\w+\}|all of it)[;.]$", "", line) for line in bullets] == list(WORK_STATE_WORDS.values())
    assert list(WORK_STATE_WORDS) == list(WorkState)


def test_a_verdict_can_be_taken_back_for_a_minute():
    ensure_undoable(NOON, NOON + timedelta(seconds=60))
    with pytest.raises(TooLateToUndo):
        ensure_undoable(NOON, NOON + timedelta(seconds=60, microseconds=1))


def test_a_stale_page_learns_the_state_of_the_take():
    ensure_seen("conforming", "conforming")
    with pytest.raises(StaleView, match="is approved"):
        ensure_seen("approved", "conforming")


@pytest.mark.parametrize(
    ("start_s", "end_s", "is_valid"),
    [
        (None, None, True),
        (0.0, None, True),
        (0.2, 0.2, True),
        (0.1, 0.84, True),
        (0.845, None, True),
        (0.9, None, False),
        (0.3, 0.2, False),
        (None, 0.2, False),
        (-0.1, 0.2, False),
        (0.1, 0.9, False),
    ],
)
def test_a_range_lies_within_the_sound(start_s, end_s, is_valid):
    if is_valid:
        ensure_range(start_s, end_s, 0.84)
    else:
        with pytest.raises(RangeInvalid):
            ensure_range(start_s, end_s, 0.84)
    if start_s is not None and (end_s or start_s) >= start_s >= 0:
        ensure_range(start_s, end_s, None)  # while it is not drawn, nobody knows its end


@pytest.mark.parametrize(
    ("variations", "waiting", "kind"),
    [(1, [1], QueueKind.SINGLE), (1, [1, 1, 1], QueueKind.ALTERNATES), (6, [2], QueueKind.SET)],
)
def test_how_a_cue_is_heard(variations, waiting, kind):
    assert queue_kind(variations, waiting) is kind
