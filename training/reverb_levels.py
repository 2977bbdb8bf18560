"""Sets what a score of `reverb` means: the share of sounds of such a score with reverb, and its four levels.

Both come from recordings in measured rooms, by models that never met the repository of a sound.
"""

import numpy as np
from numpy.typing import NDArray
from sklearn.linear_model import LogisticRegression

from audio_checks.judge import reverb
from training.reverb_limits import Levels
from training.sets import KINDS, LAYOUTS, Floats, Set

FALSE_REVERB, FALSE_LIKELY = 0.003, 0.036  # of dry sounds: under the 1 and 4 % that are allowed
WET_LOST = 0.013  # of sounds with reverb may be called dry: no more, or under 95 % of what is called dry is
FEWEST = 100  # sounds of a kind, without reverb and with it, that has limits of its own
Rows = NDArray[np.bool_]


def calibration(logits: Floats, wet: Rows) -> list[float]:
    """Return offset and slope of the line that makes logits those of the share with reverb, and what it bends by."""
    fitted = LogisticRegression(C=1e4).fit(_columns(logits), wet)
    return [round(float(value), 4) for value in (fitted.intercept_[0], *fitted.coef_[0])]


def calibrated(logits: Floats, line: list[float]) -> Floats:
    """Return the score of each logit."""
    offset, *slopes = line
    scores: Floats = 1 / (1 + np.exp(-offset - _columns(logits) @ slopes))
    return scores


def _columns(logits: Floats) -> Floats:
    return np.column_stack((logits, np.maximum(0.0, logits - reverb.KNEE)))


def levels(scores: Floats, wet: Rows) -> tuple[float, float, float]:
    """Return under which score sounds are dry, from which on they likely have reverb, and from which on they have."""
    dry, with_reverb = np.sort(scores[~wet])[::-1], np.sort(scores[wet])
    likely_from, reverb_from = (
        float(np.nextafter(dry[int(share * len(dry))], 2)) for share in (FALSE_REVERB + FALSE_LIKELY, FALSE_REVERB)
    )
    return min(float(with_reverb[int(WET_LOST * len(with_reverb))]), likely_from), likely_from, reverb_from


def levels_by_kind(some: Set, scores: Floats) -> dict[str, tuple[float, float, float]]:
    """Return the limits of each kind; of one with few sounds, and of an unknown one, the most cautious."""
    kinds, wet = some.column(lambda sound: sound.kind), some.wet
    known = [kind for kind in KINDS if min((kinds == kind)[wet].sum(), (kinds == kind)[~wet].sum()) >= FEWEST]
    table = {kind: levels(scores[kinds == kind], wet[kinds == kind]) for kind in known}
    each = np.array([levels(scores, wet), *table.values()])
    cautious = float(each[:, 0].min()), float(each[:, 1].max()), float(each[:, 2].max())
    return {kind: table.get(kind, cautious) for kind in KINDS}


def by_layout(table: dict[str, tuple[float, float, float]]) -> Levels:
    """Return the limits of each kind as the judgement reads them: the same for each layout and length of decay."""
    return {
        kind: {
            layout: dict.fromkeys(("short", "long"), tuple(round(limit, 4) for limit in limits)) for layout in LAYOUTS
        }
        for kind, limits in table.items()
    }
