"""`reverb-set`: sounds that come together carry no reverb, where the game adds its own.

Why: one short sound often does not show whether it rings by itself or in a room. A reverb that was put on a set is on
all of its sounds, and these together show it.
How to fix: listen to the named sounds one after another. Take the reverb off, or say in the sound list that the tail
is part of the design (`designed-tail`).
Source: the delivery spec, `[engine] adds`. The scores of the judgement on reverb, as logits within 4 of 0, are averaged
over the sounds of one folder, at least 4 of them; on the server over the variations of a cue. Named are sounds that
`baked-reverb` cannot decide alone. docs/judgements.md says how often that is right. The server returns no take for it.
"""

import math
import os
from collections import defaultdict
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from audio_checks.judge import CANNOT_TELL, score_in_words
from audio_checks.report.findings import Finding

if TYPE_CHECKING:
    from audio_checks.report.judged import JudgedFile

SEVERITY = "warning"
LABEL = "Reverb across a set"
OVER_FILES = True
NOT_FIXED = "Reverb cannot be taken off a file: export the sounds again without it."
FIGURES = ()
FEWEST, MANY = 4, 8
MOST_LOGIT = 4.0  # of one sound: none outweighs three others
REVERB_FROM, REVERB_FROM_OF_MANY = 0.85, 0.8


def check_set(files: "Sequence[JudgedFile]") -> Iterator[tuple[int, Finding]]:
    """Yield `reverb-set:heard` for each sound of a reverberant set that is undecided alone."""
    by_folder: dict[str, list[int]] = defaultdict(list)
    for place, one in enumerate(files):
        if one.spec.asks_for_dry_sound(one.cue) and _reverb(one).get("score") is not None:
            by_folder[os.path.dirname(one.path)].append(place)
    for places in by_folder.values():
        score = score_together([_reverb(files[place])["score"] for place in places])
        limit = REVERB_FROM_OF_MANY if len(places) >= MANY else REVERB_FROM
        if len(places) >= FEWEST and score >= limit:
            for place in places:
                if _reverb(files[place])["verdict"] == CANNOT_TELL:
                    yield place, _finding(len(places), score, limit)


def score_together(scores: Sequence[float]) -> float:
    """Return the score of some sounds together, 0..1, by the mean of their logits; each score is 0..1."""
    low, high = 1 / (1 + math.exp(MOST_LOGIT)), 1 / (1 + math.exp(-MOST_LOGIT))
    held = [min(high, max(low, score)) for score in scores]
    mean = sum(math.log(score / (1 - score)) for score in held) / len(held)
    return 1 / (1 + math.exp(-mean))


def _reverb(one: "JudgedFile") -> dict[str, Any]:
    judged: dict[str, Any] = one.report.judgements.get("reverb", {})
    return judged


def _finding(count: int, score: float, limit: float) -> Finding:
    return Finding(
        code="reverb-set:heard",
        message=f"{count} sounds that came together have reverb (score {score_in_words(score)} of 1), this one perhaps",
        fix="listen to them one after another; take the reverb off, or say in the sound list that it is meant",
        measured=score,
        limit=limit,
        unit="of 1",
    )
