"""How good the judgement is on recordings: shares of the right sounds, and the worst repository first."""

import numpy as np
import pytest

from training import reverb_recorded
from training.dataset import Known
from training.reverb_recorded import as_table, by_others, by_repository, figures_on, left_out, levels_on, reliability
from training.sets import Set

pytestmark = pytest.mark.slow

KNOWN = [
    Known("a", "event", True, is_wet, "hall", 1.0, wet_db, 1)
    for is_wet, wet_db in ((False, -np.inf), (False, -np.inf), (True, -5.0), (True, -5.0), (True, -15.0))
]
SOME = Set(KNOWN, np.zeros((5, 1)))
LIMITS = np.tile([0.3, 0.6, 0.8], (5, 1))


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


def test_each_level_is_counted_of_events():
    figures = levels_on(SOME, np.array([0.1, 0.7, 0.9, 0.2, 0.7]), LIMITS)
    assert figures["with reverb, named `reverb` or `likely`"] == pytest.approx(2 / 3)
    assert figures["audible reverb, so named"] == 0.5
    assert (figures["dry, called `reverb`"], figures["dry, called `likely reverb`"]) == (0.0, 0.5)
    assert figures["with reverb, called `dry`"] == pytest.approx(1 / 3)
    assert figures["right where it says `reverb`"] == 1.0
    assert figures["right where it says `likely reverb`"] == 0.5


def test_each_tenth_of_the_score_has_a_row():
    rows = reliability(np.array([True, False, True]), np.array([0.31, 0.39, 1.0])).splitlines()
    assert rows[5] == "| 0.3 to 0.4 | 2 | 0.35 | 0.50 |"
    assert rows[-1] == "| 0.9 to 1.0 | 1 | 1.00 | 1.00 |"


class Memory:
    """A model that says 4 of a repository which it was learned from, and -4 of all others."""

    def __init__(self, some, _):
        self.met = {one.source for one in some.known}


def test_what_is_said_of_a_repository_comes_from_others(monkeypatch):
    known = [Known(name, "event", True, bool(number % 2), "", 1.0, 0.0, 1) for name in "abc" for number in range(8)]
    some = Set(known, np.zeros((24, 1)))
    monkeypatch.setattr(reverb_recorded, "learned", Memory)
    monkeypatch.setattr(reverb_recorded, "first_logits", lambda some: np.zeros(len(some.known)))
    monkeypatch.setattr(
        reverb_recorded,
        "logits_by",
        lambda model, some, _: np.array([4.0 if one.source in model.met else -4.0 for one in some.known]),
    )
    assert left_out(some, some).tolist() == [-4.0] * 24
    set_on = []

    def levels_by_kind(some, _):
        set_on.append({one.source for one in some.known})
        return {"event": (0.1, 0.5, 0.9), "unknown": (0.1, 0.6, 0.9)}

    monkeypatch.setattr(reverb_recorded, "levels_by_kind", levels_by_kind)
    scores, limits = by_others(some, np.tile([-3.0, 3.0, -1.0, 2.0], 6))
    assert set_on == [{"b", "c"}, {"a", "c"}, {"a", "b"}]
    assert limits["kind unsaid"].tolist() == [[0.1, 0.6, 0.9]] * 24
    assert scores[:2] == pytest.approx([0, 1], abs=0.1)
