"""Tries the weights of `reverb` on real recordings in measured rooms, and writes the tables of how good they are.

`RECORDED_DIR=... python -m training.reverb_recorded` tries the repositories that are not reserved. `--last-look` tries
the reserved ones and the rooms kept for them: once, when nothing is changed any more.
"""

import argparse
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from sklearn.metrics import roc_auc_score

from audio_checks.judge import reverb
from audio_checks.measure import decay, tails
from training import dataset, recorded
from training.sets import Floats, Set, layouts_of
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


TRIED = Trial(180, 63)
LAST_LOOK = Trial(400, 65, reserved=True)


def measured(trial: Trial) -> Set:
    """Return the sounds of a trial, half of them sent to measured rooms, with their features."""
    rooms = recorded.rooms(to_learn=False, reserved=trial.reserved)
    known, features = [], []
    for one, samples, rate in dataset.made(
        trial.count, trial.seed, [], rooms, dry(reserved=trial.reserved), real_share=1.0, cut_share=CUT_SHARE
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
    for one in recorded.recordings():
        if recorded.is_reserved(one.repository) == reserved:
            by_folder[one.folder].append((one.repository, one.kind, one.samples))
    return [one for some in by_folder.values() for one in some * max(1, min(MOST_TIMES, round(A_FOLDER / len(some))))]


def limits_on(some: Set, rt60_s: Floats, *, says_kind: bool) -> Floats:
    """Return under which score each sound is dry and from which on it has reverb, shape (sounds, 2)."""
    kinds, layouts = some.column(lambda one: one.kind), layouts_of(some)
    return np.array(
        [
            reverb.limits_of(kind if says_kind else None, layout, seconds)
            for kind, layout, seconds in zip(kinds, layouts, rt60_s, strict=True)
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
    """Try the weights that are there, and write the tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--last-look", action="store_true", help="try what is reserved")
    last = parser.parse_args(arguments).last_look
    some = measured(LAST_LOOK if last else TRIED)
    scores = np.array([reverb.score_of(one) for one in some.features])
    rt60_s = np.array([reverb.rt60_of(one) for one in some.features])
    columns = {
        f"kind {said}": figures_on(some, scores, limits_on(some, rt60_s, says_kind=said == "said"))
        for said in ("said", "unsaid")
    }
    name = "reverb, last look" if last else "reverb, recordings"
    write_tables({name: as_table(columns), f"{name} by repository": by_repository(some, scores)})


if __name__ == "__main__":
    main()
