"""What weights are learned from and how they are written: trees and nets say the same here and there."""

import numpy as np
import pytest
from sklearn.ensemble import HistGradientBoostingClassifier

from audio_checks.judge.learned.nets import Nets
from audio_checks.judge.learned.trees import Trees
from audio_checks.judge.reverb import KNEE
from audio_checks.judge.reverb import calibrated as calibrated_score
from tests.support.waves import noise, write_wav
from training.dataset import Known, real_sounds
from training.reverb import Learned, numbers_of
from training.reverb_levels import (
    FALSE_LIKELY,
    FALSE_REVERB,
    WET_LOST,
    calibrated,
    calibration,
    levels,
    levels_by_kind,
)
from training.reverb_limits import MOST_WRONG, AtTheEdge, held, limits, thresholds
from training.rooms import ROOMS
from training.sets import Set
from training.sources import FAMILIES

pytestmark = pytest.mark.slow


def test_families_of_both_sides_are_there_and_none_is_on_both():
    for some in (FAMILIES, ROOMS):
        assert {one.is_kept_apart for one in some} == {True, False}
        assert len({one.name for one in some}) == len(some)


def test_recordings_in_a_room_do_not_count_as_dry(tmp_path, monkeypatch):
    for name in ("mehackit_phone1", "mehackit_robot1"):
        write_wav(tmp_path / f"{name}.wav", noise(seconds=0.01))
    monkeypatch.setenv("SOUNDS_DIR", str(tmp_path))
    assert [name for name, _, _ in real_sounds(is_kept_apart=True)] == ["mehackit_phone1", "mehackit_robot1"]
    assert [name for name, _, _ in real_sounds(is_kept_apart=True, is_dry=True)] == ["mehackit_robot1"]


def test_trees_say_the_same_as_numbers_in_a_file():
    draws = np.random.default_rng(1)
    features = draws.standard_normal((600, 6))
    features[draws.random(features.shape) < 0.1] = np.nan
    features, others = np.split(features, [400])
    wet = np.nan_to_num(features[:, 0]) + np.nan_to_num(features[:, 3]) ** 2 > 0.5
    learned = HistGradientBoostingClassifier(max_iter=20, max_leaf_nodes=8, early_stopping=False).fit(features, wet)
    written = Trees(numbers_of(learned))
    # Thresholds are values of what was learned from, and written with seven digits: other values show.
    said = [written.sum(row) for row in others]
    np.testing.assert_allclose(said, learned.decision_function(others), atol=1e-3)


def test_nets_say_the_same_as_numbers_in_a_file():
    draws = np.random.default_rng(2)
    features = draws.standard_normal((300, 5)) * [1, 10, 100, 1, 1]
    features[draws.random(features.shape) < 0.1] = np.nan
    wet = np.nan_to_num(features[:, 1]) > 2
    known = [Known("blip", "event", False, bool(one), "", 0.0, 0.0, 1) for one in wet]
    learned = Learned.of(Set(known, features))
    written = Nets(learned.numbers()["nets"])
    inside = np.clip(features, learned.scale["lowest"], learned.scale["highest"])
    scaled = np.nan_to_num((inside - learned.scale["middle"]) / learned.scale["spread"])
    odds = np.mean(
        [np.log(net.predict_proba(scaled) / (1 - net.predict_proba(scaled)))[:, 1] for net in learned.nets], 0
    )
    np.testing.assert_allclose([written.mean(row) for row in features], odds, atol=0.02)
    assert ((odds > 0) == wet).mean() > 0.9


def test_limits_are_where_as_many_err_as_may():
    scores, wet, is_long = some_scores(4)
    for pair in limits(scores, wet, is_long, 1.0).values():
        assert pair == pytest.approx((MOST_WRONG, 1 - MOST_WRONG), abs=0.04)


@pytest.mark.parametrize("false_alarms", [0.002, 0.02])
def test_no_more_false_alarms_than_may_be(false_alarms):
    scores, wet, is_long = some_scores(5)
    found = limits(scores, wet, is_long, false_alarms)
    assert called(found, scores, is_long)[~wet].mean() == pytest.approx(false_alarms, rel=0.05)
    assert found["short"][0] == pytest.approx(MOST_WRONG, abs=0.04)


def test_false_alarms_are_allowed_where_they_buy_most():
    """Long ones have reverb, nearly all of them: a little is given up there, and much is found."""
    draws = np.random.default_rng(6)
    is_long = draws.random(40_000) < 0.5
    scores = draws.random(len(is_long))
    wet = np.where(is_long, draws.random(len(scores)) < 0.98, draws.random(len(scores)) < scores)
    found = limits(scores, wet, is_long, 0.03)
    assert found["long"][1] < 0.5 < found["short"][1]
    assert called(found, scores, is_long)[~wet].mean() <= 0.03
    one_for_both = np.quantile(scores[~wet], 0.97)
    assert called(found, scores, is_long)[wet].sum() > 2 * (scores >= one_for_both)[wet].sum()


def test_where_no_sound_is_long_none_that_is_may_be_called_anything():
    scores, wet, is_long = some_scores(7)
    assert limits(scores, wet, np.zeros_like(is_long), 0.01)["long"] == (0.0, 1.0)


def test_a_kind_of_two_families_calls_reverb_no_sooner_than_one_unsaid():
    scores, wet, is_long = some_scores(8)
    families = {"music": ["keys", "pad"], "event": ["blip", "laser", "servo"]}
    kinds = [kind for kind in families for _ in range(len(scores) // 2)]
    known = [
        Known(families[kind][number % len(families[kind])], kind, False, bool(one), "", 0.0, 0.0, 1 + number // 7 % 2)
        for number, (kind, one) in enumerate(zip(kinds, wet, strict=True))
    ]
    table = thresholds(Set(known, np.zeros((len(known), 1))), scores, np.where(is_long, 2.0, 0.2))
    for layout in ("mono", "stereo"):
        for length, (_, reverb_from) in table["unknown"][layout].items():
            assert table["music"][layout][length][1] == reverb_from > table["event"][layout][length][1]


def test_sounds_at_the_edge_hold_the_limits_of_their_kind_and_of_none():
    table = {
        kind: {"mono": dict.fromkeys(("long", "short"), (0.6, 0.7, 0.8))} for kind in ("event", "music", "unknown")
    }
    dry, burst = (AtTheEdge("event", "mono", np.zeros(0), is_undecidable=flag) for flag in (False, True))
    found = held(table, [(dry, 0.91234, "short"), (dry, 0.3, "short"), (burst, 0.5, "long"), (burst, 0.75, "long")])
    for kind in ("event", "unknown"):
        assert found[kind]["mono"] == {"long": (0.5, 0.7501, 0.8), "short": (0.6, 0.9124, 0.9124)}
    assert found["music"]["mono"] == dict.fromkeys(("long", "short"), (0.6, 0.7, 0.8))


def some_scores(seed):
    """A score says how likely reverb is, however long the decay."""
    draws = np.random.default_rng(seed)
    scores = draws.random(40_000)
    return scores, draws.random(len(scores)) < scores, draws.random(len(scores)) < 0.5


def called(found, scores, is_long):
    return scores >= np.where(is_long, found["long"][1], found["short"][1])


def test_levels_name_few_dry_sounds_and_lose_few_with_reverb():
    wet = np.arange(2_000) % 2 == 1
    scores = np.where(wet, 0.3, 0.0) + np.arange(2_000) / 4_000  # dry up to 0.5, wet from 0.3 on
    dry_below, likely_from, reverb_from = levels(scores, wet)
    assert (scores[~wet] >= reverb_from).mean() == pytest.approx(FALSE_REVERB, abs=0.002)
    assert (scores[~wet] >= likely_from).mean() == pytest.approx(FALSE_REVERB + FALSE_LIKELY, abs=0.002)
    assert (scores[wet] < dry_below).mean() == pytest.approx(WET_LOST, abs=0.002)
    assert dry_below < likely_from < reverb_from


def test_a_calibrated_score_is_the_share_of_sounds_with_reverb():
    draws = np.random.default_rng(9)
    logits = draws.normal(0, 2, 40_000)
    wet = draws.random(len(logits)) < 1 / (1 + np.exp(0.5 - 0.6 * logits - 0.8 * np.maximum(0, logits - KNEE)))
    line = calibration(logits, wet)
    assert line == pytest.approx([-0.5, 0.6, 0.8], abs=0.1)
    scores = calibrated(logits, line)
    assert scores[:20] == pytest.approx([calibrated_score(logit, line) for logit in logits[:20]])
    for lowest in np.arange(0, 1, 0.1):
        here = (scores >= lowest) & (scores < lowest + 0.1)
        assert wet[here].mean() == pytest.approx(scores[here].mean(), abs=0.03)


def test_kinds_without_enough_sounds_and_none_said_are_the_most_cautious():
    scores, wet, is_long = some_scores(8)
    known = [
        Known("a", kind, False, bool(one), "", 0.0, 0.0, 1)
        for kind, one in zip(np.where(is_long, "event", "natural-decay"), wet, strict=True)
    ]
    table = levels_by_kind(Set(known, np.zeros((len(known), 1))), np.where(is_long, scores / 2, scores))
    assert table["music"] == table["unknown"]
    for place, most in ((0, min), (1, max), (2, max)):
        assert table["unknown"][place] == most(limits[place] for limits in table.values())
