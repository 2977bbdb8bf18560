"""Learns the part of `reverb` that comes from real recordings in measured rooms, and writes how good all of it is.

`RECORDED_DIR=... python -m training.reverb_recorded` learns from the repositories that are not reserved, sets what a
score means, and says of each repository what models, scores and limits say that never met it. `--tables-only` leaves
the weights as they are. The reserved repositories and rooms were kept for a last look, on 24 November 2026; nothing
is learned from them since, but limits are set on them too.
"""

import argparse
import json
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from sklearn.ensemble import HistGradientBoostingClassifier
from sklearn.linear_model import QuantileRegressor
from sklearn.metrics import roc_auc_score

from audio_checks.judge import reverb
from audio_checks.judge.learned.nets import Nets
from audio_checks.judge.learned.trees import Trees
from audio_checks.measure import decay, tails
from training import dataset, recorded
from training.reverb import numbers_of
from training.reverb_levels import by_layout, calibrated, calibration, levels_by_kind
from training.reverb_limits import at_the_edge, held, scored
from training.sets import Floats, Set, layouts_of, together
from training.tables import write_tables

CUT_SHARE = 0.35  # of the sounds end before they have died away
FEWEST = 10  # sounds of a repository that has a row of its own
MOST_TIMES = 4  # a recording of a small folder is in the trial
A_FOLDER = 60  # recordings, where there are so many
Rows = NDArray[np.bool_]


@dataclass(frozen=True)
class Trial:
    """How many sounds, from which seed, of reserved repositories and rooms or of the others."""

    count: int
    seed: int
    reserved: bool = False
    to_learn: bool = False  # in rooms that may be learned from, without share-alike recordings


LEARNED = (Trial(900, 81, to_learn=True), Trial(4000, 82, to_learn=True))
TREES = {"max_leaf_nodes": 8, "max_iter": 120, "learning_rate": 0.06, "min_samples_leaf": 12, "max_features": 0.2}
SHARE = 0.85  # of the logit; what was learned from sounds and rooms of our own code has the rest
TRIED = (Trial(180, 63), Trial(420, 64))
RESERVED = Trial(400, 65, reserved=True)
HEARD_FROM_DB = -14.0  # of reverb, under the sound: its decay time can be told


def measured(trial: Trial) -> Set:
    """Return the sounds of a trial, half of them sent to measured rooms, with their features."""
    rooms = recorded.rooms(to_learn=trial.to_learn, reserved=trial.reserved)
    sounds = [one for one in dry(reserved=trial.reserved) if not (trial.to_learn and one[0] in recorded.SHARE_ALIKE)]
    known, features = [], []
    for one, samples, rate in dataset.made(
        trial.count, trial.seed, [], rooms, sounds, real_share=1.0, cut_share=CUT_SHARE
    ):
        following = decay.Decay(rate, samples.shape[1], len(samples))
        following.add(samples)
        found = tails.features_of(following.result()["decay"])
        if found is not None:
            known.append(one)
            features.append(found)
    return Set(known, np.array(features))


def dry(*, reserved: bool) -> list[tuple[str, str, Floats]]:
    """Return repository, kind and samples of dry recordings; those of small folders several times."""
    by_folder: dict[str, list[tuple[str, str, Floats]]] = defaultdict(list)
    for recording in recorded.recordings():
        if recorded.is_reserved(recording.repository) == reserved:
            by_folder[recording.folder].append((recording.repository, recording.kind, recording.samples))
    return [one for some in by_folder.values() for one in some * max(1, min(MOST_TIMES, round(A_FOLDER / len(some))))]


def first_logits(some: Set) -> Floats:
    """Return what the models say that were learned from sounds and rooms of our own code."""
    numbers = reverb.weights()
    trees, nets = Trees(numbers["reverb"]), Nets(numbers["nets"])
    return np.array([reverb.logit_by(trees, nets, numbers["nets_share"], feature) for feature in some.features])


def learned(some: Set, first: Floats) -> HistGradientBoostingClassifier:
    """Return trees that weigh the features and the first logit."""
    trees = HistGradientBoostingClassifier(**TREES, l2_regularization=3.0, early_stopping=False, random_state=1)
    return trees.fit(np.column_stack((some.features, first)), some.wet)


def logits_by(trees: HistGradientBoostingClassifier, some: Set, first: Floats) -> Floats:
    """Return the logit of each sound."""
    logits: Floats = (1 - SHARE) * first + SHARE * trees.decision_function(np.column_stack((some.features, first)))
    return logits


def part(some: Set, rows: Rows) -> Set:
    """Return some of the sounds."""
    return Set([one for one, chosen in zip(some.known, rows, strict=True) if chosen], some.features[rows])


def left_out(some: Set, learning: Set) -> Floats:
    """Return the logit of each sound by trees that never met its repository."""
    first, first_learned = first_logits(some), first_logits(learning)
    sources, sources_learned = some.column(lambda one: one.source), learning.column(lambda one: one.source)
    logits = np.zeros(len(some.known))
    for source in sorted(set(sources)):
        here, others = sources == source, sources_learned != source
        trees = learned(part(learning, others), first_learned[others])
        logits[here] = logits_by(trees, part(some, here), first[here])
    return logits


def by_others(some: Set, logits: Floats) -> tuple[Floats, dict[str, Floats]]:
    """Return the score of each sound and the limits of its levels, by what all other repositories say."""
    sources, kinds, wet = some.column(lambda one: one.source), some.column(lambda one: one.kind), some.wet
    scores = np.zeros(len(logits))
    limits = {said: np.zeros((len(logits), 3)) for said in ("kind said", "kind unsaid")}
    for source in sorted(set(sources)):
        here, others = sources == source, sources != source
        line = calibration(logits[others], wet[others])
        scores[here] = calibrated(logits[here], line)
        table = levels_by_kind(part(some, others), calibrated(logits[others], line))
        limits["kind said"][here] = [table[kind] for kind in kinds[here]]
        limits["kind unsaid"][here] = table["unknown"]
    return scores, limits


def rt60_line(some: Set) -> list[float]:
    """Return offset and slope of the decay times of recordings over those that are estimated, as powers of two."""
    heard = some.column(lambda one: one.is_wet and one.wet_db > HEARD_FROM_DB)
    trees = Trees(reverb.weights()["rt60"])
    estimates = np.array([[trees.sum(feature)] for feature in some.features[heard]])
    fitted = QuantileRegressor(alpha=0.0).fit(estimates, np.log2(some.column(lambda one: one.rt60_s)[heard]))
    return [round(float(fitted.intercept_), 4), round(float(fitted.coef_[0]), 4)]


def figures_on(some: Set, scores: Floats, limits: Floats) -> dict[str, float]:
    """Return how good scores and limits are on some sounds; nan where there are none."""
    wet, layouts, kinds = some.wet, layouts_of(some), some.column(lambda one: one.kind)
    audible = some.column(lambda one: one.is_audible)
    low, _, high = limits.T
    reverberant = scores >= high
    is_dry = ~reverberant & (scores < low)
    decided, events, natural = reverberant | is_dry, kinds == "event", kinds == "natural-decay"
    return {
        "AUC, all": auc(wet, scores, np.ones_like(wet)),
        "AUC, mono": auc(wet, scores, layouts == "mono"),
        "AUC, stereo": auc(wet, scores, layouts == "stereo"),
        "AUC, events": auc(wet, scores, events),
        "AUC, natural decays": auc(wet, scores, natural),
        "AUC, audible reverb against dry": auc(wet, scores, audible | ~wet),
        "audible reverb called reverb, events": share(reverberant, audible & events),
        "audible reverb called dry, events": share(is_dry, audible & events),
        "dry called reverb, events": share(reverberant, ~wet & events),
        "dry called reverb, natural decays": share(reverberant, ~wet & natural),
        "right when decided": share(reverberant == wet, decided),
        "share decided": float(decided.mean()),
    }


MUST = {
    "AUC, all": 0.95,
    "AUC, mono": 0.88,
    "AUC, events": 0.97,
    "audible reverb called reverb, events": 0.70,
    "audible reverb called dry, events": -0.08,
    "dry called reverb, events": -0.02,
    "dry called reverb, natural decays": -0.05,
    "right when decided": 0.93,
    "with reverb, named `reverb` or `likely`": 0.60,
    "audible reverb, so named": 0.75,
    "dry, called `reverb`": -0.01,
    "dry, called `likely reverb`": -0.04,
    "with reverb, called `dry`": -0.05,
    "right where it says `reverb`": 0.95,
    "right where it says `likely reverb`": 0.80,
    "right where it says `dry`": 0.95,
}
"""What is asked for; below zero: at most."""
MUST_UNSAID = MUST | {"audible reverb called reverb, events": 0.55}


def auc(wet: Rows, scores: Floats, rows: Rows) -> float:
    """Return the area under the curve of some rows; nan where all or none of them have reverb."""
    return float(roc_auc_score(wet[rows], scores[rows])) if 0 < wet[rows].sum() < rows.sum() else float("nan")


def share(said: Rows, rows: Rows) -> float:
    """Return the share of some rows; nan where there are none."""
    return float(said[rows].mean()) if rows.any() else float("nan")


def as_table(columns: dict[str, dict[str, float]]) -> str:
    """Return figures as Markdown, those that are not reached bold; where the kind is unsaid other musts hold."""
    lines = [f"| | must | {' | '.join(columns)} |", f"|---|---|{'---|' * len(columns)}"]
    for row in next(iter(columns.values())):
        cells = []
        for name, figures in columns.items():
            wanted, value = (MUST_UNSAID if name == "kind unsaid" else MUST).get(row), figures[row]
            unmet = wanted is not None and (value < wanted if wanted > 0 else value > -wanted)
            cells.append("–" if np.isnan(value) else f"**{value:.3f}**" if unmet else f"{value:.3f}")
        musts = {
            f"{'≥' if must[row] > 0 else '≤'} {abs(must[row]):g}": 0 for must in (MUST, MUST_UNSAID) if row in must
        }
        lines.append(f"| {row} | {', unsaid '.join(musts)} | {' | '.join(cells)} |")
    return "\n".join(lines)


def by_repository(some: Set, scores: Floats) -> str:
    """Return the AUC of each repository with enough sounds for a row, the worst first, and their mean."""
    sources = some.column(lambda one: one.source)
    rows = []
    for source in sorted(set(sources)):
        here = sources == source
        value = auc(some.wet, scores, here)
        if here.sum() >= FEWEST and not np.isnan(value):
            rows.append((value, f"| {source} | {here.sum()} | {value:.3f} |"))
    mean = np.mean([value for value, _ in rows])
    head = ["| repository | sounds | AUC |", "|---|---|---|"]
    return "\n".join([*head, *(row for _, row in sorted(rows)), f"| mean of these | | {mean:.3f} |"])


def levels_on(some: Set, scores: Floats, limits: Floats) -> dict[str, float]:
    """Return the shares of events that each level names, rightly and wrongly."""
    wet, audible = some.wet, some.column(lambda one: one.is_audible)
    events = some.column(lambda one: one.kind) == "event"
    dry_below, likely_from, reverb_from = limits.T
    reverberant, is_dry = scores >= reverb_from, scores < dry_below
    likely = (scores >= likely_from) & ~reverberant
    return {
        "with reverb, named `reverb` or `likely`": share(reverberant | likely, events & wet),
        "audible reverb, so named": share(reverberant | likely, events & audible),
        "dry, called `reverb`": share(reverberant, events & ~wet),
        "dry, called `likely reverb`": share(likely, events & ~wet),
        "with reverb, called `dry`": share(is_dry, events & wet),
        "right where it says `reverb`": share(wet, events & reverberant),
        "right where it says `likely reverb`": share(wet, events & likely),
        "right where it says `dry`": share(~wet, events & is_dry),
    }


def reliability(wet: Rows, scores: Floats) -> str:
    """Return the share of sounds with reverb among those of each tenth of the score."""
    lines = ["| score | sounds | mean score | with reverb |", "|---|---|---|---|"]
    tenths = np.minimum((scores * 10).astype(int), 9)
    for tenth in range(10):
        here = tenths == tenth
        lines.append(
            f"| {tenth / 10:.1f} to {(tenth + 1) / 10:.1f} | {here.sum()} | {share(scores, here):.2f} |"
            f" {share(wet, here):.2f} |"
        )
    return "\n".join(lines)


def main(arguments: Sequence[str] | None = None) -> None:
    """Learn, write the weights, and write the tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--tables-only", action="store_true", help="leave the weights as they are")
    options = parser.parse_args(arguments)
    parts = [measured(trial) for trial in LEARNED]
    tried, reserved = together([measured(trial) for trial in TRIED]), measured(RESERVED)
    learning, some = together(parts), together([parts[0], tried, reserved])
    logits = left_out(some, learning)
    if not options.tables_only:
        write_weights(learning, some, logits)
    scores, limits = by_others(some, logits)
    is_reserved = np.isin(some.column(lambda one: one.source), list(set(reserved.column(lambda one: one.source))))
    is_tried = np.zeros(len(scores), bool)
    is_tried[len(parts[0].known) : len(scores) - len(reserved.known)] = True
    columns = {
        f"{name}, {said}": levels_on(part(some, rows), scores[rows], found[rows])
        for name, rows in (("all", np.ones_like(is_tried)), ("reserved", is_reserved), ("the others", ~is_reserved))
        for said, found in limits.items()
    }
    figures = {
        said: figures_on(part(some, is_tried), scores[is_tried], found[is_tried]) for said, found in limits.items()
    }
    heard = some.column(lambda one: one.is_audible and one.kind == "event")
    errors = np.array(
        [
            abs(reverb.rt60_of(feature) / one.rt60_s - 1)
            for one, feature in zip(some.known, some.features, strict=True)
            if one.is_audible and one.kind == "event"
        ]
    )
    write_tables(
        {
            "reverb, levels": as_table(columns),
            "reverb, reliability": reliability(some.wet, scores),
            "reverb, decay times": f"{np.median(errors):.3f} of {len(errors)} (must: 0.25);"
            f" of the reserved repositories {np.median(errors[is_reserved[heard]]):.3f}",
            "reverb, recordings": as_table(figures),
            "reverb, recordings by repository": by_repository(part(some, is_tried), scores[is_tried]),
        }
    )


def write_weights(learning: Set, some: Set, logits: Floats) -> None:
    """Add what recordings teach to the weights: trees, what a score means and its limits, and decay times."""
    line = calibration(logits, some.wet)
    numbers = reverb.weights()
    numbers |= {
        "recorded": numbers_of(learned(learning, first_logits(learning))),
        "recorded_share": SHARE,
        "score_line": line,
        "rt60_line": rt60_line(some),
    }
    limits = by_layout(levels_by_kind(some, calibrated(logits, line)))
    numbers["thresholds"] = held(limits, scored(at_the_edge(), numbers))
    reverb.WEIGHTS.write_text(json.dumps(numbers, separators=(",", ":")) + "\n", encoding="ascii")


if __name__ == "__main__":
    main()
