"""Learns the part of `reverb` that comes from real recordings in measured rooms, and writes how good all of it is.

`RECORDED_DIR=... python -m training.reverb_recorded` learns from the repositories that are not reserved, and says of
each what models and limits say that never met it. `--tables-only` leaves the weights as they are. `--last-look` tries
them on the reserved repositories and the rooms kept for them: once, when nothing is changed any more.
"""

import argparse
import json
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from sklearn.ensemble import HistGradientBoostingClassifier
from sklearn.metrics import roc_auc_score

from audio_checks.judge import reverb
from audio_checks.judge.learned.nets import Nets
from audio_checks.judge.learned.trees import Trees
from audio_checks.measure import decay, tails
from training import dataset, recorded
from training.reverb import numbers_of
from training.reverb_limits import Levels, Table, at_the_edge, held, in_levels, scored, thresholds
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


LEARNED = (Trial(900, 81, to_learn=True),)
TREES = {"max_leaf_nodes": 8, "max_iter": 120, "learning_rate": 0.06, "min_samples_leaf": 12, "max_features": 0.2}
SHARE = 0.5  # of the logit; what was learned from sounds and rooms of our own code has the rest
FALSE_ALARMS = {"event": 0.012, "natural-decay": 0.03, "unknown": 0.012}
MOST_WRONG = 0.3  # of the sounds that are decided by a hair: fewer than of synthetic ones, which are better known
TRIED = (Trial(180, 63), Trial(420, 64))
LAST_LOOK = Trial(400, 65, reserved=True)


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


def scores_by(trees: HistGradientBoostingClassifier, some: Set, first: Floats) -> Floats:
    """Return the score of each sound, 0..1."""
    beside = trees.decision_function(np.column_stack((some.features, first)))
    scores: Floats = 1 / (1 + np.exp(-(1 - SHARE) * first - SHARE * beside))
    return scores


def said_by_others(some: Set, first: Floats, without: str = "") -> Floats:
    """Return the score of each sound by trees that never met its repository, nor one that is named; nan of that."""
    sources, scores = some.column(lambda one: one.source), np.full(len(some.known), np.nan)
    for source in set(sources) - {without}:
        here, others = sources == source, (sources != source) & (sources != without)
        scores[here] = scores_by(learned(part(some, others), first[others]), part(some, here), first[here])
    return scores


def part(some: Set, rows: Rows) -> Set:
    """Return some of the sounds."""
    return Set([one for one, chosen in zip(some.known, rows, strict=True) if chosen], some.features[rows])


def left_out(tried: Set, learning: Set, rt60_s: Floats) -> tuple[Floats, dict[str, Floats]]:
    """Return score and limits of each sound by models and limits that never met its repository.

    The limits come from scores of repositories by models that met neither them nor the one that is left out.
    """
    first, first_tried = first_logits(learning), first_logits(tried)
    sources, sources_tried = learning.column(lambda one: one.source), tried.column(lambda one: one.source)
    learned_rt60_s = decay_times(learning)
    scores = np.zeros(len(tried.known))
    limits = {said: np.zeros((len(tried.known), 2)) for said in ("kind said", "kind unsaid")}
    for source in sorted(set(sources_tried)):
        here, others = sources_tried == source, sources != source
        trees = learned(part(learning, others), first[others])
        scores[here] = scores_by(trees, part(tried, here), first_tried[here])
        by_others = said_by_others(learning, first, without=source)[others]
        table = thresholds(part(learning, others), by_others, learned_rt60_s[others], FALSE_ALARMS, MOST_WRONG)
        for said, found in limits.items():
            found[here] = limits_on(part(tried, here), rt60_s[here], table, says_kind=said == "kind said")
    return scores, limits


def decay_times(some: Set) -> Floats:
    """Return the decay time that the judgement states of each sound, in seconds."""
    return np.array([reverb.rt60_of(feature) for feature in some.features])


def limits_on(some: Set, rt60_s: Floats, table: Table | Levels, *, says_kind: bool) -> Floats:
    """Return under which score each sound is dry and from which on it has reverb, shape (sounds, 2)."""
    kinds, layouts = some.column(lambda one: one.kind), layouts_of(some)
    lengths = np.where(rt60_s >= reverb.LONG_FROM_S, "long", "short")
    return np.array(
        [
            (own[0], own[-1])
            for kind, layout, length in zip(kinds, layouts, lengths, strict=True)
            for own in [table[kind if says_kind else "unknown"][layout][length]]
        ]
    )


def figures_on(some: Set, scores: Floats, limits: Floats) -> dict[str, float]:
    """Return how good scores and limits are on some sounds; nan where there are none."""
    wet, layouts, kinds = some.wet, layouts_of(some), some.column(lambda one: one.kind)
    audible = some.column(lambda one: one.is_audible)
    low, high = limits.T
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


def main(arguments: Sequence[str] | None = None) -> None:
    """Learn, write the weights, and write the tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--last-look", action="store_true", help="try the weights that are there on what is reserved")
    parser.add_argument("--tables-only", action="store_true", help="leave the weights as they are")
    options = parser.parse_args(arguments)
    if options.last_look:
        some = measured(LAST_LOOK)
        rt60_s, scores = decay_times(some), np.array([reverb.score_of(feature) for feature in some.features])
        table: Table | Levels = reverb.weights()["thresholds"]
        limits = {
            f"kind {said}": limits_on(some, rt60_s, table, says_kind=said == "said") for said in ("said", "unsaid")
        }
    else:
        learning, some = (together([measured(trial) for trial in trials]) for trials in (LEARNED, TRIED))
        if not options.tables_only:
            write_weights(learning)
        rt60_s = decay_times(some)
        scores, limits = left_out(some, learning, rt60_s)
    name = "reverb, last look" if options.last_look else "reverb, recordings"
    columns = {said: figures_on(some, scores, found) for said, found in limits.items()}
    write_tables({name: as_table(columns), f"{name} by repository": by_repository(some, scores)})


def write_weights(learning: Set) -> None:
    """Add what recordings teach to the weights, with limits by models that never met the repository of a sound."""
    first = first_logits(learning)
    numbers = reverb.weights() | {"recorded": numbers_of(learned(learning, first)), "recorded_share": SHARE}
    limits = thresholds(learning, said_by_others(learning, first), decay_times(learning), FALSE_ALARMS, MOST_WRONG)
    numbers["thresholds"] = in_levels(held(limits, scored(at_the_edge(), numbers)))
    reverb.WEIGHTS.write_text(json.dumps(numbers, separators=(",", ":")) + "\n", encoding="ascii")


if __name__ == "__main__":
    main()
