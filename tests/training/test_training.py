"""What weights are learned from and how they are written: rooms keep their times, trees say the same here and there."""

import numpy as np
import pytest
from sklearn.ensemble import HistGradientBoostingClassifier

from audio_checks.nets import Nets
from audio_checks.trees import Trees
from training import layers
from training.dataset import RATE, Known, decay_time_s, made
from training.reverb import Learned, Set, numbers_of
from training.rooms import ROOMS
from training.sources import FAMILIES

DRY_SEED = 1  # of a sound that is sent nowhere


@pytest.mark.parametrize("room", [room for room in ROOMS if room.name != "two rooms"], ids=lambda room: room.name)
def test_a_room_has_about_the_decay_time_that_was_asked_for(room):
    response = room.make(np.random.default_rng(3), RATE, 0.5)
    assert np.isfinite(response).all()
    assert 0.25 <= decay_time_s(response) <= 1.0  # highs die sooner; echoes on the way add


def test_families_of_both_sides_are_there_and_none_is_on_both():
    for some in (FAMILIES, ROOMS):
        assert {one.is_kept_apart for one in some} == {True, False}
        assert len({one.name for one in some}) == len(some)


@pytest.mark.parametrize("family", [*FAMILIES, *dict.fromkeys(layers.FAMILIES)], ids=lambda family: family.name)
def test_a_family_makes_sounds_that_are_finite_and_not_silent(family):
    sound = family.make(np.random.default_rng(5), 16_000)
    assert np.isfinite(sound).all()
    assert sound.any()


def test_the_same_seed_makes_the_same_sounds():
    blips = [family for family in FAMILIES if family.name == "blip"]
    (one,), (again,) = (list(made(1, DRY_SEED, blips, [], [])) for _ in range(2))
    assert one[0] == again[0]
    np.testing.assert_array_equal(one[1], again[1])


def test_trees_say_the_same_as_numbers_in_a_file():
    draws = np.random.default_rng(1)
    features = draws.standard_normal((600, 6))
    features[draws.random(features.shape) < 0.1] = np.nan
    features, others = np.split(features, [400])
    wet = np.nan_to_num(features[:, 0]) + np.nan_to_num(features[:, 3]) ** 2 > 0.5
    learned = HistGradientBoostingClassifier(max_iter=20, max_leaf_nodes=8, early_stopping=False).fit(features, wet)
    written = Trees(numbers_of(learned))
    # Thresholds are values of what was learned from, and written with seven digits: other values tell.
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
    held = np.clip(features, learned.scale["lowest"], learned.scale["highest"])
    scaled = np.nan_to_num((held - learned.scale["middle"]) / learned.scale["spread"])
    odds = np.mean(
        [np.log(net.predict_proba(scaled) / (1 - net.predict_proba(scaled)))[:, 1] for net in learned.nets], 0
    )
    np.testing.assert_allclose([written.mean(row) for row in features], odds, atol=0.02)
    assert ((odds > 0) == wet).mean() > 0.9
