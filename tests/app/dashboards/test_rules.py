"""Where a cue stands follows from its takes alone."""

import pytest

from app.dashboards.rules import CueStatus, VariationFact, cue_status, statuses_of, variation_status
from app.deliveries.rules import TakeState
from app.sound_lists.rules import CueState

S, T = CueStatus, TakeState


def summed(*states: TakeState) -> VariationFact:
    """What takes that came in this order add up to."""
    seen = [state for state in states if state is not T.SET_ASIDE]
    return VariationFact(T.APPROVED in states, T.CONFORMING in states, seen[-1] if seen else None)


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
    assert variation_status(summed(*states)) is status


def test_variations_without_a_take_are_to_make():
    assert statuses_of(None, 3) == (S.TO_MAKE,) * 3
    sums = f"{summed(T.APPROVED).packed},{summed(T.RETURNED).packed}"
    assert statuses_of(sums, 4) == (S.ACCEPTED, S.RETURNED, S.TO_MAKE, S.TO_MAKE)
    assert statuses_of(sums, 1) == (S.ACCEPTED,)  # the list asks for fewer than were delivered


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
def test_a_cue_shows_what_needs_a_person(variations, questions, placeholder, status):
    found = cue_status(CueState.LOCKED, variations, is_asked=bool(questions), placeholder=placeholder)
    assert found is status


def test_a_cut_cue_is_cut_whatever_was_delivered():
    assert cue_status(CueState.CUT, [S.ACCEPTED], is_asked=True, placeholder=True) is S.CUT
