"""Learns the weights of the judgement `reversed`, and writes them and the table of how good they are.

`make weights` (`python -m training.reversed`) makes sounds, dry and with reverb, half of them turned round before they
are trimmed, faded and equalised; it learns, sets the thresholds, and tries the result on families of sources, families
of reverbs and recordings that were kept apart. With SOUNDS_DIR real recordings are part of both sides.
"""

import json
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from sklearn.ensemble import HistGradientBoostingClassifier
from sklearn.metrics import roc_auc_score

from audio_checks.judge import reversed as judgement
from audio_checks.measure import decay, turning
from training import dataset
from training.dataset import Known
from training.reverb import numbers_of
from training.sets import KINDS
from training.tables import as_table, write_tables

Floats = NDArray[np.float64]
FALSE_ALARMS = 0.01  # of what plays forwards
FOLDS = 5
TREES = {"max_leaf_nodes": 10, "max_iter": 200, "learning_rate": 0.06, "min_samples_leaf": 20, "max_features": 0.4}
# Sounds with an audible direction: something is struck, shot or switched. A rustle or an engine is alike both ways.
IMPACTS_AND_UI = {
    *("impact", "blip", "footsteps", "gunshot", "debris", "drum", "bell", "boom", "explosion", "keys", "plucked"),
    *("arcade", "reload", "splash", "cymbal", "gong"),
}


@dataclass(frozen=True)
class Made:
    """How some sounds are made: how many, from which seed, and what of them is new."""

    count: int
    seed: int
    is_kept_apart: bool = False
    only: str = ""  # one family
    shortest_s: float = 0.0


LEARNING = Made(1600, 61)
TRIED = {"development": Made(400, 62), "kept apart": Made(800, 63, is_kept_apart=True)}
SPEECH = Made(150, 64, only="speech", shortest_s=3.0)


@dataclass
class Set:
    """Some sounds: what is known of each, and its features."""

    known: list[Known]
    features: Floats

    @property
    def backwards(self) -> NDArray[np.bool_]:
        return np.array([one.is_reversed for one in self.known])

    def where(self, kept: NDArray[np.bool_]) -> "Set":
        return Set([one for one, wanted in zip(self.known, kept, strict=True) if wanted], self.features[kept])


def measured(made: Made) -> Set:
    """Make some sounds, and return what is known and measured of each."""
    families = dataset.families(is_kept_apart=made.is_kept_apart)
    real = dataset.real_sounds(is_kept_apart=made.is_kept_apart)
    if made.only:
        families, real = [family for family in families if family.name == made.only], []
    rooms = dataset.responses(dataset.rooms(is_kept_apart=made.is_kept_apart), made.seed, count=8)
    known, features = [], []
    for one, samples, rate in dataset.made(made.count, made.seed, families, rooms, real, reversed_share=0.5):
        if len(samples) < made.shortest_s * rate:
            continue
        following = decay.Decay(rate, samples.shape[1], len(samples))
        following.add(samples)
        found = turning.features_of(following.result()["decay"])
        if found is not None:
            known.append(one)
            features.append(found)
    return Set(known, np.array(features))


def learned(some: Set) -> HistGradientBoostingClassifier:
    """Return trees that distinguish backwards from forwards."""
    trees = HistGradientBoostingClassifier(**TREES, l2_regularization=1.0, early_stopping=False, random_state=1)
    return trees.fit(some.features, some.backwards)


def scores_by_others(some: Set) -> Floats:
    """Return each sound's score by trees that never met its family of sources: what thresholds are set on."""
    families = np.array([one.source for one in some.known])
    names = sorted(set(families))
    scores = np.zeros(len(families))
    for fold in range(FOLDS):
        held = np.isin(families, names[fold::FOLDS])
        scores[held] = learned(some.where(~held)).predict_proba(some.features[held])[:, 1]
    return scores


def thresholds(some: Set, scores: Floats) -> dict[str, list[float]]:
    """Return for each kind below what a sound plays forwards, and from what on backwards."""
    kinds = np.array([one.kind for one in some.known])
    found = {}
    for kind in KINDS[:-1]:
        here = kinds == kind
        if min((some.backwards & here).sum(), (~some.backwards & here).sum()) >= 50:
            low = float(np.quantile(scores[here & some.backwards], FALSE_ALARMS * 5))
            high = float(np.quantile(scores[here & ~some.backwards], 1 - FALSE_ALARMS))
            found[kind] = [round(min(low, 0.5), 4), round(max(high, 0.5), 4)]
    strictest = [min(low for low, _ in found.values()), max(high for _, high in found.values())]
    return {kind: found.get(kind, strictest) for kind in KINDS}


def right_on_speech(learning: Set, speech: Set) -> float:
    """Return how often trees that never met speech find its direction, with no undecided verdict."""
    others = learning.where(np.array([one.source != SPEECH.only for one in learning.known]))
    return float((learned(others).predict(speech.features) == speech.backwards).mean())


def figures_on(some: Set) -> dict[str, float]:
    """Return how good the judgement is on some sounds, as it ships."""
    backwards = some.backwards
    scores = np.array([judgement.score_of(feature) for feature in some.features])
    struck = np.array([one.source in IMPACTS_AND_UI for one in some.known])
    table = judgement.weights()["thresholds"]
    low, high = np.array([table[one.kind] for one in some.known]).T
    positive = scores >= high
    decided = positive | (scores < low)
    return {
        "AUC, all": roc_auc_score(backwards, scores),
        "AUC, impacts and UI": roc_auc_score(backwards[struck], scores[struck]),
        "forwards called reversed": positive[~backwards].mean(),
        "found, impacts and UI": positive[backwards & struck].mean(),
        "found, all": positive[backwards].mean(),
        "right when decided": (positive == backwards)[decided].mean(),
        "share decided": decided.mean(),
    }


MUST = {"AUC, impacts and UI": 0.98}


def by_family(some: Set) -> str:
    """Return for each family of sources how well its directions are distinguished."""
    names = np.array(["real recordings" if one.is_real else one.source for one in some.known])
    scores = np.array([judgement.score_of(feature) for feature in some.features])
    lines = ["| source | sounds | AUC |", "|---|---|---|"]
    for name in sorted(set(names)):
        here = names == name
        lines.append(f"| {name} | {here.sum()} | {roc_auc_score(some.backwards[here], scores[here]):.3f} |")
    return "\n".join(lines)


def main() -> None:
    """Make, learn, write the weights, try them, and write the tables."""
    learning = measured(LEARNING)
    numbers: dict[str, Any] = {
        "thresholds": thresholds(learning, scores_by_others(learning)),
        "reversed": numbers_of(learned(learning)),
    }
    judgement.WEIGHTS.write_text(json.dumps(numbers, separators=(",", ":")) + "\n", encoding="ascii")
    tried, speech = {name: measured(made) for name, made in TRIED.items()}, measured(SPEECH)
    write_tables(
        {
            "reversed": as_table({name: figures_on(some) for name, some in tried.items()}, MUST),
            "reversed by source": by_family(tried["kept apart"]),
            "reversed speech": f"{right_on_speech(learning, speech):.3f} of {len(speech.known)} (must: 0.90)",
        }
    )


if __name__ == "__main__":
    main()
