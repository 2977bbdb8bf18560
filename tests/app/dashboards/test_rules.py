"""Where a cue stands follows from its takes alone."""

import pytest

from app.dashboards.rules import CueStatus, TakeFact, cue_status, variation_status
from app.deliveries.rules import TakeState
from app.sound_lists.rules import CueState

S, T = CueStatus, TakeState


def takes(*states: TakeState) -> list[TakeFact]:
    return [TakeFact(1, number, state) for number, state in enumerate(states, start=1)]


@pytest.mark.parametrize(
    ("states", "status"),
    [
        ([], S.TO_MAKE),
        ([T.RECEIVED], S.CHECKING),
        ([T.RETURNED], S.RETURNED),
        ([T.CONFORMING, T.RETURNED], S.TO_REVIEW),  # what conforms can be heard while a newer one came back
        ([T.RETURNED, T.RECEIVED], S.CHECKING),
        ([T.APPROVED, T.SET_ASIDE, T.SET_ASIDE], S.ACCEPTED),
        ([T.SET_ASIDE], S.TO_MAKE),
        ([T.CHANGE_REQUESTED, T.CONFORMING], S.TO_REVIEW),
        ([T.CHANGE_REQUESTED], S.CHANGE_REQUESTED),
        ([T.UNJUDGED], S.UNJUDGED),
    ],
)
def test_one_variation(states: list[TakeState], status: CueStatus):
    assert variation_status(takes(*states)) is status


@pytest.mark.parametrize(
    ("variations", "questions", "placeholder", "status"),
    [
        ([S.ACCEPTED, S.ACCEPTED], 1, True, S.ACCEPTED),
        ([S.ACCEPTED, S.TO_MAKE], 0, True, S.PARTLY_ACCEPTED),
        ([S.ACCEPTED, S.TO_REVIEW], 0, False, S.TO_REVIEW),
        ([S.TO_REVIEW, S.RETURNED], 0, False, S.RETURNED),
        ([S.TO_MAKE], 1, True, S.QUESTION),
        ([S.TO_MAKE], 0, True, S.PLACEHOLDER),
        ([S.TO_MAKE], 0, False, S.TO_MAKE),
    ],
)
def test_a_cue_shows_what_needs_somebody(variations, questions, placeholder, status):
    found = cue_status(CueState.LOCKED, variations, open_questions=questions, placeholder=placeholder)
    assert found is status


def test_a_cut_cue_is_cut_whatever_was_delivered():
    assert cue_status(CueState.CUT, [S.ACCEPTED], open_questions=1, placeholder=True) is S.CUT
