"""How good the judgement is on recordings: shares of the right sounds, and the worst repository first."""

import numpy as np
import pytest

from training import reverb_recorded
from training.dataset import Known
from training.reverb_recorded import as_table, by_repository, figures_on, left_out, said_by_others
from training.sets import Set

pytestmark = pytest.mark.slow

KNOWN = [
    Known("a", "event", True, is_wet, "hall", 1.0, wet_db, 1)
    for is_wet, wet_db in ((False, -np.inf), (False, -np.inf), (True, -5.0), (True, -5.0), (True, -15.0))
]
SOME = Set(KNOWN, np.zeros((5, 1)))
LIMITS = np.tile([0.3, 0.8], (5, 1))


def test_audible_reverb_is_counted_apart_and_what_is_between_the_limits_is_undecided():
    figures = figures_on(SOME, np.array([0.1, 0.9, 0.9, 0.2, 0.5]), LIMITS)
    assert figures["audible reverb called reverb, events"] == 0.5
    assert figures["audible reverb called dry, events"] == 0.5
    assert figures["dry called reverb, events"] == 0.5
    assert figures["share decided"] == pytest.approx(0.8)
    assert figures["right when decided"] == 0.5
    assert np.isnan(figures["AUC, natural decays"])


def test_what_is_not_reached_is_bold_and_unsaid_kinds_have_their_own_must():
    figures = figures_on(SOME, np.array([0.1, 0.2, 0.9, 0.9, 0.5]), LIMITS)
    table = as_table(
        {
            "kind said": figures | {"audible reverb called reverb, events": 0.6},
            "kind unsaid": figures | {"audible reverb called reverb, events": 0.6},
        }
    )
    assert "| audible reverb called reverb, events | ≥ 0.7, unsaid ≥ 0.55 | **0.600** | 0.600 |" in table
    assert "| AUC, stereo |  | – | – |" in table


def test_the_worst_repository_comes_first():
    known = [Known(name, "event", True, bool(n % 2), "", 1.0, 0.0, 1) for name in "ab" for n in range(12)]
    scores = np.array([n % 2 for n in range(12)] + [1 - n % 2 for n in range(12)], dtype=float)
    _, _, first, second, mean = by_repository(Set(known, np.zeros((24, 1))), scores).splitlines()
    assert (first, second) == ("| b | 12 | 0.000 |", "| a | 12 | 1.000 |")
    assert mean == "| mean of these | | 0.500 |"


class Memory:
    """A model that says 0.9 of a repository which it was learned from, and 0.1 of all others."""

    def __init__(self, some, _):
        self.met = {one.source for one in some.known}


@pytest.fixture
def repositories(monkeypatch):
    known = [
        Known(name, "event", True, bool(number % 2), "", 1.0, 0.0, 1 + number // 2 % 2)
        for name in "abc"
        for number in range(8)
    ]
    monkeypatch.setattr(reverb_recorded, "learned", Memory)
    monkeypatch.setattr(
        reverb_recorded,
        "scores_by",
        lambda model, some, _: np.array([0.9 if one.source in model.met else 0.1 for one in some.known]),
    )
    return Set(known, np.zeros((24, 1)))


def test_scores_come_from_models_that_never_met_the_repository(repositories):
    assert said_by_others(repositories, np.zeros(24)) == pytest.approx(np.full(24, 0.1))
    without = said_by_others(repositories, np.zeros(24), without="b")
    assert np.isnan(without).tolist() == [one.source == "b" for one in repositories.known]


def test_so_do_limits(repositories, monkeypatch):
    set_on = []

    def thresholds(some, scores, *_):
        set_on.append({one.source for one in some.known})
        assert scores == pytest.approx(np.full(len(scores), 0.1))
        both = {layout: {"short": (0.2, 0.8), "long": (0.2, 0.8)} for layout in ("mono", "stereo")}
        return {"event": both, "unknown": both}

    monkeypatch.setattr(reverb_recorded, "thresholds", thresholds)
    monkeypatch.setattr(reverb_recorded, "first_logits", lambda some: np.zeros(len(some.known)))
    monkeypatch.setattr(reverb_recorded, "decay_times", lambda some: np.zeros(len(some.known)))
    scores, limits = left_out(repositories, repositories, np.zeros(24))
    assert scores == pytest.approx(np.full(24, 0.1))
    assert set_on == [{"b", "c"}, {"a", "c"}, {"a", "b"}]
    assert limits["kind said"].tolist() == [[0.2, 0.8]] * 24
