"""`reverb-set`: sounds that come together carry no reverb, where the game adds its own.

Why: one short sound often does not show whether it rings by itself or in a room. A reverb that was put on a set is on
all of its sounds, and these together show it.
How to fix: listen to the named sounds one after another. Take the reverb off, or say in the sound list that the tail
is part of the design (`designed-tail`).
Source: the delivery spec, `[engine] adds`. Together are the sounds of one folder and one category, at least 4 of them;
on the server the variations of a cue. Those count whose own score is 0.7 or more, three of them and a third of all at
least: their scores as logits within 4 of 0 are averaged. Named are those of them that `baked-reverb` leaves undecided
alone. docs/reference/judgements.md says how often that is right. The server returns no take for it.
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
OWN_FROM = 0.7  # of a sound's own score: what agrees with its company
SHARE = 1 / 3  # of a company must agree, or it is chance
MOST_LOGIT = 4.0  # of one sound: none outweighs three others
REVERB_FROM, REVERB_FROM_OF_MANY = 0.88, 0.85


def check_set(files: "Sequence[JudgedFile]") -> Iterator[tuple[int, Finding]]:
    """Yield `reverb-set:heard` for each sound of a reverberant set that is undecided alone."""
    companies: dict[tuple[str, str | None], list[int]] = defaultdict(list)
    for index, file in enumerate(files):
        if file.spec.asks_for_dry_sound(file.cue) and _reverb(file).get("score") is not None:
            companies[os.path.dirname(file.path), file.spec.category].append(index)
    for company in companies.values():
        agreeing = [index for index in company if _reverb(files[index])["score"] >= OWN_FROM]
        if len(company) < FEWEST or len(agreeing) < max(FEWEST - 1, SHARE * len(company)):
            continue
        score = score_together([_reverb(files[index])["score"] for index in agreeing])
        limit = REVERB_FROM_OF_MANY if len(agreeing) >= MANY else REVERB_FROM
        if score >= limit:
            for index in agreeing:
                if _reverb(files[index])["verdict"] == CANNOT_TELL:
                    yield index, _finding(len(agreeing), len(company), score, limit)


def score_together(scores: Sequence[float]) -> float:
    """Return the score of some sounds together, 0..1, by the mean of their logits; each score is 0..1."""
    low, high = 1 / (1 + math.exp(MOST_LOGIT)), 1 / (1 + math.exp(-MOST_LOGIT))
    held = [min(high, max(low, score)) for score in scores]
    mean = sum(math.log(score / (1 - score)) for score in held) / len(held)
    return 1 / (1 + math.exp(-mean))


def _reverb(file: "JudgedFile") -> dict[str, Any]:
    judged: dict[str, Any] = file.report.judgements.get("reverb", {})
    return judged


def _finding(agreeing: int, company: int, score: float, limit: float) -> Finding:
    these = f"these {company} sounds" if agreeing == company else f"{agreeing} of these {company} sounds"
    return Finding(
        code="reverb-set:heard",
        message=f"{these} have reverb together (score {score_in_words(score)} of 1), this one among them",
        fix="listen to them one after another; take the reverb off, or say in the sound list that it is meant",
        measured=score,
        limit=limit,
        unit="of 1",
    )
