"""Hours of cues before they are agreed, and the days on which the work can end; every figure can be shown.

A cue takes the usual hours of its category for its first file, a tenth to a fifth of that for each further variation,
and as much again for each minute beyond the first half. Where hours were logged for three cues or more, the usual
hours are replaced by the quarter and the three quarters of what those cues took beside their usual hours.
"""

from collections import defaultdict
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from datetime import date, timedelta
from enum import StrEnum
from statistics import median, quantiles

from app.hiring.roster.rules import WORKING_DAYS, Busy, BusyKind
from app.money.estimates.rules import ENOUGH
from app.sound_lists.kits.rules import Kit

ASSUMED_WEEKLY_HOURS = 30.0  # of a designer whose hours nobody knows
MAX_DAYS = 5 * 366  # looked ahead; work that ends later has no day
MINUTES = 60.0
LONG_S = 30.0  # a sound up to here is no longer work than a short one
MAX_LENGTH_FACTOR = 6.0  # of a loop of several minutes
FURTHER_FILE = (0.1, 0.2)  # of the first file's hours, for each further variation

# Hours of the first file, from and to: our guess for work by one experienced designer, recording included, held
# against the hours of the starter kits by a test. The first beginning of a category counts; they fit the ids of the
# Universal Category System too, such as FEETHmn.
USUAL_HOURS: Mapping[str, tuple[float, float]] = {
    "ui": (0.6, 1.1),
    "user": (0.6, 1.1),
    "interface": (0.6, 1.1),
    "menu": (0.6, 1.1),
    "fol": (0.7, 1.2),
    "foot": (0.7, 1.2),
    "feet": (0.7, 1.2),
    "impact": (0.8, 1.4),
    "weap": (1.4, 2.6),
    "gun": (1.4, 2.6),
    "expl": (1.4, 2.6),
    "mag": (1.2, 2.4),
    "crea": (1.3, 2.4),
    "veh": (1.6, 2.8),
    "amb": (1.4, 2.6),
    "mus": (4.0, 8.0),
    "cinematic": (4.0, 8.0),
    "vo": (0.2, 0.5),
    "dialog": (0.2, 0.5),
    "narration": (0.3, 0.6),
}
OTHER_HOURS = (0.8, 2.0)
AMBIENCES_PER_SCENE = (1, 2)  # a bed, and at times a second layer
MUSIC_PER_SCENE = (1, 1)


class Basis(StrEnum):
    """The source of an estimate."""

    PLAN = "plan"  # typed into a contract's plan
    DESIGNER = "designer"  # hours that this designer logged with the studio
    STUDIO = "studio"  # hours that were logged with the studio
    USUAL = "usual"  # our figures


class Fit(StrEnum):
    """The place of a due date among the days on which the work can end."""

    IMPOSSIBLE = "impossible"  # before the earliest
    TIGHT = "tight"  # between the two
    FITS = "fits"


@dataclass(frozen=True)
class Work:
    """A cue as its hours are estimated."""

    category: str
    variations: int
    duration_s: float | None
    estimate_min: int | None = None  # of a plan


@dataclass(frozen=True)
class Logged:
    """An accepted cue and the minutes that went into it."""

    work: Work
    minutes: int


@dataclass(frozen=True)
class Hours:
    """Hours from and to."""

    low_h: float
    high_h: float

    def __add__(self, other: "Hours") -> "Hours":
        """Return the sum of two ranges."""
        return Hours(self.low_h + other.low_h, self.high_h + other.high_h)


NO_HOURS = Hours(0.0, 0.0)


@dataclass(frozen=True)
class _Source:
    """The source of a cue's hours, and what its usual hours are multiplied by; None: nothing."""

    basis: Basis
    based_on: int = 0  # cues whose hours were logged
    factors: tuple[float, float] | None = None


PLAN_SOURCE, USUAL_SOURCE = _Source(Basis.PLAN), _Source(Basis.USUAL)


@dataclass(frozen=True)
class CategoryEffort:
    """The hours of the cues of one category that are estimated in one way."""

    category: str
    basis: Basis
    based_on: int  # cues whose hours were logged
    cues: int
    files: int
    hours: Hours


@dataclass(frozen=True)
class SizeLine:
    """The cues of one category that a brief leads to: of one scene, or of the whole game."""

    scene: str  # empty: the whole game
    category: str
    low_cues: int
    high_cues: int
    hours: Hours


def usual_hours(work: Work) -> Hours:
    """Return the usual hours of a cue."""
    low, high = _first_file_hours(work.category)
    minutes_beyond = max(0.0, (work.duration_s or 0.0) - LONG_S) / 60
    length = min(MAX_LENGTH_FACTOR, 1.0 + minutes_beyond)
    further = work.variations - 1
    return Hours(low * length * (1 + FURTHER_FILE[0] * further), high * length * (1 + FURTHER_FILE[1] * further))


def _first_file_hours(category: str) -> tuple[float, float]:
    return USUAL_HOURS.get(kind_of(category), OTHER_HOURS)


def kind_of(category: str) -> str:
    """Return the key of the usual hours that a category begins with; itself where there is none."""
    folded = category.casefold()
    return next((key for key in USUAL_HOURS if folded.startswith(key)), folded)


def effort(works: Iterable[Work], histories: Sequence[tuple[Basis, Collection[Logged]]]) -> list[CategoryEffort]:
    """Return the hours of cues by category and source, the most hours first.

    `histories` are in the order in which they are preferred.
    """
    by_kind, otherwise = _sources(histories)
    by_line: dict[tuple[str, Basis, int], list[tuple[Work, Hours]]] = defaultdict(list)
    for work in works:
        is_planned = work.estimate_min is not None
        source = PLAN_SOURCE if is_planned else by_kind.get(kind_of(work.category), otherwise)
        by_line[work.category, source.basis, source.based_on].append((work, _hours(work, source.factors)))
    lines = [
        CategoryEffort(
            *key,
            cues=len(estimated),
            files=sum(work.variations for work, _ in estimated),
            hours=sum((hours for _, hours in estimated), NO_HOURS),
        )
        for key, estimated in by_line.items()
    ]
    return sorted(lines, key=lambda line: (-line.hours.high_h, line.category, line.basis))


def _hours(work: Work, factors: tuple[float, float] | None) -> Hours:
    if work.estimate_min is not None:
        return Hours(work.estimate_min / MINUTES, work.estimate_min / MINUTES)
    usual = usual_hours(work)
    if factors is None:
        return usual
    middle_h = (usual.low_h + usual.high_h) / 2
    return Hours(middle_h * factors[0], middle_h * factors[1])


def _sources(histories: Sequence[tuple[Basis, Collection[Logged]]]) -> tuple[dict[str, _Source], _Source]:
    """Return the sources of hours by kind of cue, and the one for all other kinds.

    The first history with enough cues counts: those of the kind where they are enough, else all of them.
    """
    for basis, history in histories:
        if len(history) >= ENOUGH:
            by_kind: dict[str, list[Logged]] = defaultdict(list)
            for logged in history:
                by_kind[kind_of(logged.work.category)].append(logged)
            sources = {
                kind: _Source(basis, len(samples), _factors(samples))
                for kind, samples in by_kind.items()
                if len(samples) >= ENOUGH
            }
            return sources, _Source(basis, len(history), _factors(history))
    return {}, USUAL_SOURCE


def _factors(samples: Iterable[Logged]) -> tuple[float, float]:
    """Return the quarter and the three quarters of what cues took, in usual hours."""
    taken = []
    for logged in samples:
        usual = usual_hours(logged.work)
        taken.append(logged.minutes / MINUTES / ((usual.low_h + usual.high_h) / 2))
    low, _, high = quantiles(taken, n=4, method="inclusive")
    return low, high


def finish_on(hours: float, begin_on: date, weekly_hours: float, busy: Iterable[Busy] = ()) -> date | None:
    """Return the working day on which so many hours are done; None where that is more than five years away."""
    taken = [(span.from_on, span.to_on, 0.5 if span.kind is BusyKind.HALF_DAYS else 0.0) for span in busy]
    left = hours - 1e-9
    for offset in range(MAX_DAYS):
        day = begin_on + timedelta(days=offset)
        if day.weekday() >= WORKING_DAYS:
            continue
        free = min((part for first, last, part in taken if first <= day <= last), default=1.0)
        left -= weekly_hours / WORKING_DAYS * free
        if left <= 0:
            return day
    return None


def fit_of(due_on: date | None, earliest_on: date | None, latest_on: date | None) -> Fit | None:
    """Return the place of a due date among the days on which the work can end; None without a due date."""
    if due_on is None:
        return None
    if earliest_on is None or due_on < earliest_on:
        return Fit.IMPOSSIBLE
    return Fit.TIGHT if latest_on is None or due_on < latest_on else Fit.FITS


def size_of_game(
    categories: Iterable[str], scenes: Iterable[Mapping[str, object]], kits: Sequence[Kit]
) -> list[SizeLine]:
    """Return the cues that the answers of a brief lead to: ambience and music by scene, the rest as kits have it.

    A category that no kit has is left out, since nothing is known of it.
    """
    of_scenes = [line for scene in scenes for line in _of_scene(scene, kits)]
    by_scene = {line.category for line in of_scenes}
    lines = [line for category in categories if category not in by_scene for line in _of_game(category, kits)]
    return [*of_scenes, *lines]


def _of_scene(scene: Mapping[str, object], kits: Sequence[Kit]) -> Iterable[SizeLine]:
    for category, is_there, cues in (
        ("ambience", bool(scene["ambience"]), AMBIENCES_PER_SCENE),
        ("music", bool(scene["music"]), MUSIC_PER_SCENE),
    ):
        if is_there:
            yield _size_line(str(scene["scene"]), category, cues, kits)


def _of_game(category: str, kits: Sequence[Kit]) -> Iterable[SizeLine]:
    """Yield the share that a category has of the kits that have it, taken of the cues that such games usually have."""
    shares = [
        (sum(cue.category == category for cue in kit.cues) / len(kit.cues), kit.usual_cues)
        for kit in kits
        if any(cue.category == category for cue in kit.cues)
    ]
    if shares:
        low, high = (median(share * usual[end] for share, usual in shares) for end in (0, 1))
        yield _size_line("", category, (max(1, round(low)), max(1, round(high))), kits)


def _size_line(scene: str, category: str, cues: tuple[int, int], kits: Sequence[Kit]) -> SizeLine:
    """Return a line with the hours of its cues, each taken to be like those of the kits."""
    like = [
        usual_hours(Work(cue.category, cue.variations, cue.duration_s))
        for kit in kits
        for cue in kit.cues
        if cue.category == category
    ] or [usual_hours(Work(category, 1, None))]
    low_h, high_h = (sum(getattr(hours, end) for hours in like) / len(like) for end in ("low_h", "high_h"))
    return SizeLine(scene, category, *cues, hours=Hours(low_h * cues[0], high_h * cues[1]))
