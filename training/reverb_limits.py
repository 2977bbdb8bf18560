"""Sets the limits of `reverb`: under which score a sound is dry, and from which on it has reverb.

They come from the scores of sounds by models that never met their family, and are bounded by borderline sounds:
those of the demo project that are dry keep the limit of reverb above them, and single bursts of noise, which no one
can distinguish from a burst in a room, are between both.
"""

import io
import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import soundfile
from numpy.typing import NDArray
from sklearn.isotonic import IsotonicRegression

from app.demo.cues import CUES
from app.demo.sounds import demo_sounds
from audio_checks import parse_spec
from audio_checks.judge import reverb
from audio_checks.judge.learned.nets import Nets
from audio_checks.judge.learned.trees import Trees
from audio_checks.measure import decay, tails
from audio_checks.spec.presets import new_spec
from training.sets import KINDS, LAYOUTS, Floats, Set, layouts_of

Table = dict[str, dict[str, dict[str, tuple[float, float]]]]  # of limits, by kind, layout and length of decay
Levels = dict[str, dict[str, dict[str, tuple[float, float, float]]]]  # with that of likely reverb between
# That thresholds aim at, under the 2 and 5 % that are allowed: who is blamed for what is not there, trusts no more.
FALSE_ALARMS = {"event": 0.012, "natural-decay": 0.004, "unknown": 0.001}
MOST_WRONG = 0.45  # of the sounds that are decided by a hair; of all that are decided far fewer are
FEWEST = 60  # sounds, of at least two families, that a threshold of its own takes
FEWEST_FAMILIES = 3  # from which on it may call reverb sooner than where the kind is unsaid
BURST_RATE_HZ = 48_000
BURSTS = [(rt60_s, seed) for rt60_s in (1.2, 1.5, 2.0, 2.5) for seed in range(12)]
DEMO_NOT_HELD = {"warp_in", "explosion_far"}  # in a hall, and wide noise of 2 s that may as well be its own tail


@dataclass(frozen=True)
class AtTheEdge:
    """A sound that holds limits: those of its kind where it is said, and those where none is."""

    kind: str
    layout: str
    features: Floats
    is_undecidable: bool


def thresholds(
    some: Set, scores: Floats, rt60_s: Floats, aims: Mapping[str, float] = FALSE_ALARMS, most_wrong: float = MOST_WRONG
) -> Table:
    """Return by kind, layout and length under which score a sound is dry, and from which on it has reverb.

    `aims` are the shares of dry sounds that may be called reverberant, by kind; `most_wrong` is the share of sounds of
    just a limit's score that may be called wrongly.
    """
    wet, kinds, layouts = some.wet, some.column(lambda one: one.kind), layouts_of(some)
    families, real = some.column(lambda one: one.source), some.column(lambda one: one.is_real)
    is_long = rt60_s >= reverb.LONG_FROM_S
    counted = ~real | real.all()  # of recordings alone, each repository is a family
    counts = {kind: len(set(families[counted & (kinds == kind)])) for kind in KINDS}
    table: Table = {kind: {} for kind in KINDS}
    for layout in LAYOUTS:
        here = layouts == layout
        rows_of = {kind: here & (kinds == kind) for kind in KINDS}
        known = [kind for kind in KINDS if rows_of[kind].sum() >= FEWEST and counts[kind] > 1]
        for kind in known:
            aim, rows = aims.get(kind, aims["event"]), rows_of[kind]
            table[kind][layout] = limits(scores[rows], wet[rows], is_long[rows], aim, most_wrong)
        # An unknown kind may be any, a long natural decay too: it needs the limits of the hardest one.
        unsaid = limits(scores[here], wet[here], is_long[here], aims["unknown"], most_wrong)
        surest = max(
            *(np.quantile(scores[rows_of[kind] & ~wet], 1 - aims["unknown"]) for kind in known),
            *(reverb_from for kind in known for _, reverb_from in table[kind][layout].values()),
        )
        for kind in KINDS:
            if kind not in known or counts[kind] < FEWEST_FAMILIES:  # how others of the kind would score is not known
                own = table[kind].get(layout, unsaid)
                table[kind][layout] = {length: (dry_below, surest) for length, (dry_below, _) in own.items()}
    return {
        kind: {
            layout: {length: (round(min(pair), 4), math.ceil(pair[1] * 1e4) / 1e4) for length, pair in pairs.items()}
            for layout, pairs in by_layout.items()
        }
        for kind, by_layout in table.items()
    }


def limits(
    scores: Floats,
    wet: NDArray[np.bool_],
    is_long: NDArray[np.bool_],
    false_alarms: float,
    most_wrong: float = MOST_WRONG,
) -> dict[str, tuple[float, float]]:
    """Return by length of decay the score under which sounds are dry, and the one from which on they have reverb.

    Of the sounds of just such a score and length no more than `most_wrong` are called wrongly. Of all dry ones no more
    than a share of `false_alarms` is called reverberant; the lengths share these so that most reverb is found.
    """
    likely, reverb_from = {}, {}
    allowed = np.arange(int(false_alarms * (~wet).sum()) + 1)
    found = np.zeros(len(allowed))
    for length, rows, mistaken in (("short", ~is_long, allowed[::-1]), ("long", is_long, allowed)):
        known, has_reverb = scores[rows], wet[rows]
        likely[length], from_likely = _likely(known, has_reverb, most_wrong)
        reverb_from[length] = np.maximum(from_likely, _over_all_but(known[~has_reverb], mistaken))
        found -= np.searchsorted(np.sort(known[has_reverb]), reverb_from[length])  # but for these all are found
    best = found.argmax()
    return {length: (likely[length], float(reverb_from[length][best])) for length in likely}


def _likely(scores: Floats, wet: NDArray[np.bool_], most_wrong: float) -> tuple[float, float]:
    """Return up to which score few have reverb, and from which on most do."""
    if not len(scores):
        return 0.0, 1.0
    known = np.sort(scores)
    shares = IsotonicRegression().fit(scores, wet).predict(known)  # of sounds with reverb among those of a score
    dry, reverberant = known[shares <= most_wrong], known[shares >= 1 - most_wrong]
    return float(max(dry, default=0.0)), float(min(reverberant, default=1.0))


def _over_all_but(scores: Floats, counts: NDArray[np.int64]) -> Floats:
    """Return for each count the lowest limit that no more of the scores reach."""
    lowest: Floats = np.append(np.nextafter(np.sort(scores)[::-1], 2), 0.0)
    return lowest[np.minimum(counts, len(scores))]


def at_the_edge() -> Iterator[AtTheEdge]:
    """Yield the dry sounds of the demo project, and bursts of noise that die away by themselves."""
    spec = parse_spec(new_spec("44k1"))
    for key, sound in demo_sounds().items():
        if key not in DEMO_NOT_HELD:
            samples, rate = soundfile.read(io.BytesIO(sound.wav_bytes()), always_2d=True)
            category = next((cue["category"] for cue in CUES if key.startswith(cue["name"])), "music")
            yield from _measured(spec.for_category(category).kind, samples, rate)
    for rt60_s, seed in BURSTS:
        times_s = np.arange(int(1.25 * rt60_s * BURST_RATE_HZ)) / BURST_RATE_HZ
        burst = np.random.default_rng(seed).normal(0, 0.15, len(times_s)).clip(-1, 1) * 10 ** (-3 * times_s / rt60_s)
        yield from _measured("natural-decay", burst[:, np.newaxis], BURST_RATE_HZ, is_undecidable=True)


def _measured(kind: str | None, samples: Floats, rate: int, *, is_undecidable: bool = False) -> Iterator[AtTheEdge]:
    following = decay.Decay(rate, samples.shape[1], len(samples))
    following.add(samples)
    features = tails.features_of(following.result()["decay"])
    if features is not None:
        layout = "mono" if samples.shape[1] == 1 else "stereo"
        yield AtTheEdge(kind or "unknown", layout, features, is_undecidable)


def scored(some: Iterable[AtTheEdge], numbers: dict[str, Any]) -> Iterator[tuple[AtTheEdge, float, str]]:
    """Yield each sound with its score and the length of its decay, as estimated by the models."""
    trees, nets, rt60_trees = Trees(numbers["reverb"]), Nets(numbers["nets"]), Trees(numbers["rt60"])
    recorded = Trees(numbers["recorded"])
    for one in some:
        first = reverb.logit_by(trees, nets, numbers["nets_share"], one.features)
        logit = reverb.logit_on_top(recorded, numbers["recorded_share"], first, one.features)
        rt60_s = reverb.rt60_by(rt60_trees, numbers["rt60_line"], one.features)
        yield one, reverb.calibrated(logit, numbers["score_line"]), "long" if rt60_s >= reverb.LONG_FROM_S else "short"


def held(table: Levels, by: Iterable[tuple[AtTheEdge, float, str]]) -> Levels:
    """Return the limits with each sound at the edge on the side where it belongs."""
    for one, score, length in by:
        for kind in {one.kind, "unknown"}:
            dry_below, likely_from, reverb_from = table[kind][one.layout][length]
            if one.is_undecidable:
                dry_below = min(dry_below, math.floor(score * 1e4) / 1e4)
            above = math.floor(score * 1e4 + 1) / 1e4
            table[kind][one.layout][length] = dry_below, max(likely_from, above), max(reverb_from, above)
    return table


def in_levels(table: Table) -> Levels:
    """Return the limits as the judgement reads them; nothing is likely until `reverb_recorded` says from where on."""
    return {
        kind: {
            layout: {
                length: (dry_below, reverb_from, reverb_from) for length, (dry_below, reverb_from) in pairs.items()
            }
            for layout, pairs in by_layout.items()
        }
        for kind, by_layout in table.items()
    }
