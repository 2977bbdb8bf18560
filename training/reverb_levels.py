"""Sets under which score `reverb` calls a sound dry, and from which on it says `likely reverb`.

`RECORDED_DIR=... python -m training.reverb_levels` changes only these limits of the weights that are there. They come
from recordings in measured rooms: those that were learned from and tried, by models that never met their repository,
and the repositories that were kept for the last look of 24 November 2026, by the models as they ship. Each of both has
half a say. From which score on a sound has reverb is left as `reverb_limits` set it.
"""

import json

import numpy as np

from audio_checks.judge import reverb
from training import reverb_recorded
from training.sets import KINDS, LAYOUTS, Floats, Set, layouts_of, together

FALSE_NAMED = 0.05  # of dry sounds may be called `reverb` or `likely reverb`,
WET_LOST = 0.04  # and of those with reverb `dry`
FEWEST = 8  # sounds that a share is taken of
HIGHEST_DRY = 0.25  # no score over it is called dry, whatever few sounds say,
LIKELY = 0.8  # and from this one on, where so few dry sounds are known that none is called wrongly
STEPS = np.arange(0, 1.0001, 0.005)


def scored() -> list[tuple[Set, Floats]]:
    """Return the two sets of sounds, with the score of each by models that never met its repository."""
    learning, tried = (
        together([reverb_recorded.measured(trial) for trial in trials])
        for trials in (reverb_recorded.LEARNED, reverb_recorded.TRIED)
    )
    first, first_tried = reverb_recorded.first_logits(learning), reverb_recorded.first_logits(tried)
    scores = np.zeros(len(tried.known))
    sources = learning.column(lambda sound: sound.source)
    sources_tried = tried.column(lambda sound: sound.source)
    for source in sorted(set(sources_tried)):
        here, others = sources_tried == source, sources != source
        trees = reverb_recorded.learned(reverb_recorded.part(learning, others), first[others])
        scores[here] = reverb_recorded.scores_by(trees, reverb_recorded.part(tried, here), first_tried[here])
    met = np.concatenate((reverb_recorded.said_by_others(learning, first), scores))
    reserved = reverb_recorded.measured(reverb_recorded.LAST_LOOK)
    shipped = np.array([reverb.score_of(features) for features in reserved.features])
    return [(together([learning, tried]), met), (reserved, shipped)]


def levels(dry: list[Floats], wet: list[Floats], reverb_from: float) -> tuple[float, float]:
    """Return the score under which sounds are dry, and the one from which on they likely have reverb.

    `dry` and `wet` hold the scores of each set's dry sounds, and of those with reverb.
    """
    named = [[np.mean(scores >= step) for step in STEPS] for scores in dry if len(scores) >= FEWEST]
    lost = [[np.mean(scores < step) for step in STEPS] for scores in wet if len(scores) >= FEWEST]
    likely_from, dry_below = LIKELY, 0.0
    if named:
        likely_from = float(STEPS[np.argmax(np.mean(named, axis=0) <= FALSE_NAMED)])
    if lost:
        dry_below = float(STEPS[np.flatnonzero(np.mean(lost, axis=0) <= WET_LOST)[-1]])
    dry_below = min(dry_below, HIGHEST_DRY)
    return round(dry_below, 4), round(min(max(likely_from, 0.5), reverb_from), 4)


def main() -> None:
    """Write the limits."""
    numbers = reverb.weights()
    sets = [
        (
            scores,
            some.wet,
            some.column(lambda sound: sound.kind),
            layouts_of(some),
            reverb_recorded.decay_times(some) >= reverb.LONG_FROM_S,
        )
        for some, scores in scored()
    ]
    for kind in KINDS:
        for layout in LAYOUTS:
            for length, pair in numbers["thresholds"][kind][layout].items():
                dry, wet = [], []
                for scores, is_wet, kinds, layouts, is_long in sets:
                    here = (layouts == layout) & (is_long == (length == "long"))
                    if (kinds == kind).sum() >= FEWEST:
                        here &= kinds == kind
                    dry.append(scores[here & ~is_wet])
                    wet.append(scores[here & is_wet])
                numbers["thresholds"][kind][layout][length] = [*levels(dry, wet, pair[-1]), pair[-1]]
    reverb.WEIGHTS.write_text(json.dumps(numbers, separators=(",", ":")) + "\n", encoding="ascii")


if __name__ == "__main__":
    main()
