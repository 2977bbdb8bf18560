"""Learns the weights of the judgement `reverb`, and writes them and the table of how good they are.

`make weights` (`python -m training.reverb`) makes the development set, learns, sets the thresholds, and tries the
result on what was kept apart from the start: families of sources, families of reverbs, and recordings. With
SOUNDS_DIR real recordings are part of both sides. What was measured of each sound is kept in `--cache`.
"""

import argparse
import hashlib
import json
import os
import time
import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from sklearn.ensemble import HistGradientBoostingClassifier, HistGradientBoostingRegressor
from sklearn.exceptions import ConvergenceWarning
from sklearn.metrics import roc_auc_score
from sklearn.neural_network import MLPClassifier

from audio_checks.judge import reverb
from audio_checks.judge.learned.nets import Nets
from audio_checks.judge.learned.trees import Trees
from audio_checks.measure import decay, tails
from training import dataset, layers, strikes
from training.dataset import Known
from training.reverb_limits import at_the_edge, held, in_levels, scored, thresholds
from training.sets import LAYOUTS, Floats, Set, layouts_of, together
from training.tables import as_table, write_tables

FOLDS = 5
TREES = {"max_leaf_nodes": 12, "max_iter": 300, "learning_rate": 0.05, "min_samples_leaf": 15, "max_features": 0.25}
NETS = {"hidden_layer_sizes": (48, 16), "alpha": 1.0, "batch_size": 128, "max_iter": 25}
NETS_AVERAGED = 3
NETS_SHARE = 0.4  # of the score; the trees have the rest
NO_TREES: dict[str, Any] = {"start": 0.0} | {
    key: [] for key in ("roots", "feature", "threshold", "left", "right", "nan_left", "value")
}
SOURCES_BESIDE = {"layers": layers.FAMILIES, "strikes": strikes.FAMILIES}
HERE = Path(__file__).parent


@dataclass(frozen=True)
class Made:
    """How some sounds of the development set are made: how many, from which seed, in rooms of which seed."""

    count: int
    seed: int
    rooms_seed: int
    rooms_a_family: int
    new_sources: bool = False
    new_rooms: bool = False
    beside: str = ""  # what its sources are instead of the named families: `layers` or `strikes`


LEARNING = [Made(2500, 6, 11, 30), Made(2500, 7, 19, 30), Made(2500, 8, 11, 30), Made(2500, 9, 19, 30)]
BESIDE = [
    *(
        Made(2500, seed, rooms_seed, 30, beside="layers")
        for seed, rooms_seed in ((31, 11), (32, 19), (33, 23), (34, 29), (36, 41))
    ),
    *(Made(1000, seed, rooms_seed, 15, beside="strikes") for seed, rooms_seed in ((41, 37), (42, 43))),
]
"""Learned from too; thresholds are not set on them."""
KEPT_APART = Made(1600, 3, 13, 20, new_sources=True, new_rooms=True)
"""What it is tried on: other families of sources in other families of rooms."""


def measured(made: Made, cache: Path) -> Set:
    """Return some sounds of the development set, from the cache where nothing that makes them has changed."""
    makers = [
        Path(decay.__file__),
        Path(tails.__file__),
        *(HERE / f"{one}.py" for one in ("dataset", "rooms", "sources", *([made.beside] if made.beside else []))),
    ]
    said = [repr(made), os.environ.get("SOUNDS_DIR", ""), *(path.read_text(encoding="utf-8") for path in makers)]
    path = cache / f"{hashlib.sha256(''.join(said).encode()).hexdigest()[:20]}.npz"
    if path.exists():
        kept = np.load(path, allow_pickle=False)
        return Set([Known(**load) for load in json.loads(str(kept["known"]))], kept["features"])
    began, known, features = time.monotonic(), [], []
    responses = dataset.responses(
        dataset.rooms(is_kept_apart=made.new_rooms), made.rooms_seed, count=made.rooms_a_family
    )
    families = SOURCES_BESIDE.get(made.beside) or dataset.families(is_kept_apart=made.new_sources)
    real = [] if made.beside else dataset.real_sounds(is_kept_apart=made.new_sources, is_dry=True)
    for one, samples, rate in dataset.made(made.count, made.seed, families, responses, real):
        following = decay.Decay(rate, samples.shape[1], len(samples))
        following.add(samples)
        found = tails.features_of(following.result()["decay"])
        if found is not None:
            known.append(one)
            features.append(found)
    cache.mkdir(parents=True, exist_ok=True)
    np.savez(path, features=np.array(features), known=json.dumps([vars(one) for one in known]))
    print(f"{made}: {time.monotonic() - began:.0f} s", flush=True)
    return Set(known, np.array(features))


@dataclass
class Learned:
    """The classifier of wet and dry: trees, and nets over scaled features."""

    trees: HistGradientBoostingClassifier
    nets: list[MLPClassifier]
    scale: dict[str, Floats]

    @classmethod
    def of(cls, some: Set) -> "Learned":
        trees = HistGradientBoostingClassifier(**TREES, l2_regularization=1.0, early_stopping=False, random_state=1)
        lowest, highest = np.nanpercentile(some.features, [1, 99], axis=0)
        held = np.clip(some.features, lowest, highest)
        scale = {"lowest": lowest, "highest": highest, "middle": np.nanmean(held, axis=0)}
        scale["spread"] = np.nanstd(held, axis=0) + 1e-9
        scaled = np.nan_to_num((held - scale["middle"]) / scale["spread"])
        nets = [MLPClassifier(**NETS, random_state=seed) for seed in range(NETS_AVERAGED)]
        with warnings.catch_warnings(action="ignore", category=ConvergenceWarning):  # they stop early on purpose
            for net in nets:
                net.fit(scaled, some.wet)
        return cls(trees.fit(some.features, some.wet), nets, scale)

    def numbers(self) -> dict[str, Any]:
        """Return what the judgement reads."""
        return {"nets_share": NETS_SHARE, "reverb": numbers_of(self.trees), "nets": numbers_of_nets(self)}


def learned_rt60(some: Set) -> HistGradientBoostingRegressor:
    """Return trees that estimate the decay time, as a power of two; learned from reverb that can be heard."""
    heard = some.column(lambda one: one.is_wet and one.wet_db > -14)
    trees = HistGradientBoostingRegressor(**TREES, loss="absolute_error", early_stopping=False, random_state=1)
    return trees.fit(some.features[heard], np.log2(some.column(lambda one: one.rt60_s or 1.0)[heard]))


def said_by_others(some: Set, beside: Set) -> tuple[Floats, Floats]:
    """Return each sound's score and decay time by what never met its family of sources: what thresholds are set on."""
    families = some.column(lambda one: one.source)
    names = sorted(set(families))
    scores, rt60_s = np.zeros((2, len(families)))
    for fold in range(FOLDS):
        held = np.isin(families, names[fold::FOLDS])
        others = Set([one for one, out in zip(some.known, held, strict=True) if not out], some.features[~held])
        said = Learned.of(together([others, beside])).numbers()
        trees, nets = Trees(said["reverb"]), Nets(said["nets"])
        scores[held] = [
            reverb.logistic(reverb.logit_by(trees, nets, NETS_SHARE, feature)) for feature in some.features[held]
        ]
        rt60_s[held] = np.exp2(learned_rt60(others).predict(some.features[held]))
    return scores, rt60_s


def limits_on(some: Set, *, says_kind: bool = True) -> tuple[Floats, Floats]:
    """Return under which score each sound is dry and from which on it has reverb, as the judgement ships."""
    kinds, layouts = some.column(lambda one: one.kind), layouts_of(some)
    found = [
        reverb.limits_of(kind if says_kind else None, layout, reverb.rt60_of(features))
        for kind, layout, features in zip(kinds, layouts, some.features, strict=True)
    ]
    low, _, high = np.array(found).T
    return low, high


def numbers_of(trees: Any) -> dict[str, Any]:
    """Return scikit-learn's trees as `audio_checks.judge.learned.trees` reads them."""
    out: dict[str, Any] = {"start": float(np.ravel(trees._baseline_prediction)[0]), "roots": []}
    columns: dict[str, list[Any]] = {key: [] for key in ("feature", "threshold", "left", "right", "nan_left", "value")}
    for (tree,) in trees._predictors:
        first = len(columns["feature"])
        out["roots"].append(first)
        for place, node in enumerate(tree.nodes):
            leaf = bool(node["is_leaf"])
            columns["feature"].append(0 if leaf else int(node["feature_idx"]))
            columns["threshold"].append(0.0 if leaf else float(f"{node['num_threshold']:.7g}"))
            columns["left"].append(first + (place if leaf else int(node["left"])))
            columns["right"].append(first + (place if leaf else int(node["right"])))
            columns["nan_left"].append(0 if leaf else int(node["missing_go_to_left"]))
            columns["value"].append(float(f"{node['value']:.5g}") if leaf else 0.0)
    return out | columns


def numbers_of_nets(learned: Learned) -> dict[str, Any]:
    """Return scikit-learn's nets as `audio_checks.judge.learned.nets` reads them."""
    return {name: _rounded(values) for name, values in learned.scale.items()} | {
        "nets": [
            [
                {"weights": _rounded(weights), "offsets": _rounded(offsets)}
                for weights, offsets in zip(net.coefs_, net.intercepts_, strict=True)
            ]
            for net in learned.nets
        ]
    }


def _rounded(values: Floats) -> Any:
    return np.vectorize(lambda value: float(f"{value:.4g}"))(values).tolist()


def figures_on(some: Set, *, says_kind: bool = True) -> dict[str, float]:
    """Return how good the judgement is on some sounds, as it ships."""
    wet, layouts, kinds = some.wet, layouts_of(some), some.column(lambda one: one.kind)
    audible = some.column(lambda one: one.is_audible)
    scores = np.array([reverb.score_of(feature) for feature in some.features])
    low, high = limits_on(some, says_kind=says_kind)
    positive = scores >= high
    decided = positive | (scores < low)
    events, natural = kinds == "event", kinds == "natural-decay"
    at_five = np.zeros(len(wet), bool)  # thresholds for 5 % false alarms, mono and stereo each
    for layout in LAYOUTS:
        here = layouts == layout
        at_five |= here & (scores > np.quantile(scores[here & ~wet], 0.95))
    heard = audible & events
    said = np.array([reverb.rt60_of(feature) for feature in some.features[heard]])
    return {
        "AUC, all": roc_auc_score(wet, scores),
        **{f"AUC, {layout}": roc_auc_score(wet[layouts == layout], scores[layouts == layout]) for layout in LAYOUTS},
        "AUC, events": roc_auc_score(wet[events], scores[events]),
        "found at 5 % false alarms, all": at_five[wet].mean(),
        "found at 5 % false alarms, audible": at_five[audible].mean(),
        "dry called reverb, events": positive[events & ~wet].mean(),
        "dry called reverb, long natural decays": positive[natural & ~wet].mean(),
        "right when decided": (positive == wet)[decided].mean(),
        "share decided": decided.mean(),
        "called reverb, audible": positive[audible].mean(),
        "RT60 of audible events, median error": np.median(
            np.abs(said / some.column(lambda one: one.rt60_s)[heard] - 1)
        ),
    }


MUST = {
    "AUC, all": 0.95,
    "AUC, mono": 0.88,
    "AUC, stereo": 0.98,
    "AUC, events": 0.97,
    "found at 5 % false alarms, all": 0.75,
    "found at 5 % false alarms, audible": 0.88,
    "dry called reverb, events": -0.02,
    "dry called reverb, long natural decays": -0.05,
    "right when decided": 0.93,
    "share decided": 0.75,
    "RT60 of audible events, median error": -0.20,
}
"""What is asked for on unseen material; below zero: at most."""


def by_family(some: Set) -> str:
    """Return where it fails: for each family of sources how often dry is called reverb, and reverb found and missed."""
    wet = some.wet
    families = np.where(some.column(lambda one: one.is_real), "real recordings", some.column(lambda one: one.source))
    scores = np.array([reverb.score_of(feature) for feature in some.features])
    low, high = limits_on(some)
    lines = [
        "| source | sounds | AUC | dry called reverb | reverb called dry | cannot tell |",
        "|---|---|---|---|---|---|",
    ]
    for family in sorted(set(families)):
        here = families == family
        reverberant, dry = scores >= high, (scores < low) & (scores < high)
        cells = [
            f"{roc_auc_score(wet[here], scores[here]):.3f}",
            f"{reverberant[here & ~wet].mean():.3f}",
            f"{dry[here & wet].mean():.3f}",
            f"{(~reverberant & ~dry)[here].mean():.3f}",
        ]
        lines.append(f"| {family} | {here.sum()} | {' | '.join(cells)} |")
    return "\n".join(lines)


def main(arguments: Sequence[str] | None = None) -> None:
    """Make, learn, write the weights, try them, and write the tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    home = Path(os.environ.get("XDG_CACHE_HOME", Path.home() / ".cache"))
    parser.add_argument("--cache", type=Path, default=home / "audio-checks-training", help="keeps sounds' figures")
    parser.add_argument("--tables-only", action="store_true", help="try the weights that are there")
    options = parser.parse_args(arguments)
    if not options.tables_only:
        learning, beside = (together([measured(made, options.cache) for made in some]) for some in (LEARNING, BESIDE))
        numbers = {
            **Learned.of(together([learning, beside])).numbers(),
            "rt60": numbers_of(learned_rt60(learning)),
            "recorded": NO_TREES,  # reverb_recorded adds them
            "recorded_share": 0.0,
            "score_line": [0.0, 1.0, 0.0],
            "rt60_line": [0.0, 1.0],
        }
        limits = thresholds(learning, *said_by_others(learning, beside))
        numbers["thresholds"] = held(in_levels(limits), scored(at_the_edge(), numbers))
        reverb.WEIGHTS.write_text(json.dumps(numbers, separators=(",", ":")) + "\n", encoding="ascii")
    tried = measured(KEPT_APART, options.cache)
    columns = {f"kept apart, kind {said}": figures_on(tried, says_kind=said == "said") for said in ("said", "unsaid")}
    write_tables({"reverb": as_table(columns, MUST), "reverb by source": by_family(tried)})


if __name__ == "__main__":
    main()
