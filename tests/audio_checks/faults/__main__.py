"""Writes docs/false-alarms.md: `SOUNDS_DIR=... make false-alarms`.

The unseen half is looked at here alone, and each look is written down in looks.csv.
"""

import argparse
import csv
import sys
from collections import Counter, defaultdict
from collections.abc import Collection, Iterable, Mapping
from concurrent.futures import ProcessPoolExecutor
from datetime import UTC, datetime
from pathlib import Path

from audio_checks.measure import (
    abrupt,
    clicks,
    cuts,
    dropouts,
    flat_tops,
    hum,
    in_phase,
    lulls,
    noise_floor,
    repeats,
    straight_tops,
)
from audio_checks.measure.decibels import decibels, power_decibels
from tests.audio_checks.faults import known as known_half
from tests.audio_checks.faults import (
    once_unseen_sounds,
    second_unseen_sounds,
    third_unseen_sounds,
    training_sounds,
)
from tests.audio_checks.faults import unseen as unseen_half
from tests.audio_checks.faults.injuries import Fault
from tests.audio_checks.faults.masters import MOST, NAMED, flagged_masters, masters_folder
from tests.audio_checks.faults.promise import BEYOND, PROMISED
from tests.audio_checks.faults.sounds import Family
from tests.audio_checks.faults.trial import AUDIBLE, CHECKS, NO_PLACE, Trial, counts, false_alarms, trials

PAGE = Path("docs/false-alarms.md")
LOOKS = Path(__file__).with_name("looks.csv")
FORMER_LOOKS = Path(__file__).with_name("former_looks.csv")
SECOND_LOOKS = Path(__file__).with_name("second_looks.csv")
THIRD_LOOKS = Path(__file__).with_name("third_looks.csv")
FOUND = 0.95  # of the faults at levels that count
MUST = f"{100 * FOUND:.0f} %"


def main() -> int:
    """Look, write the page, and return 1 where a promise is not kept."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, default=10, help="sounds of each family")
    parser.add_argument("--only-known", action="store_true", help="leave the unseen half alone, and write no page")
    parser.add_argument("--checks", nargs="+", choices=CHECKS, help="the known half of these alone, and no page")
    parser.add_argument("--families", nargs="+", metavar="NAME", help="the known half in these alone, and no page")
    arguments = parser.parse_args()
    seeds = range(arguments.seeds)
    some = bool(arguments.checks or arguments.families)
    known = _known(seeds, arguments.checks or CHECKS, arguments.families)
    if arguments.only_known or some:
        sys.stdout.write(_found_table(known))
        return 0
    folder = masters_folder()
    if folder is None:
        sys.stderr.write("SOUNDS_DIR does not name a folder with masters/ in it; their table cannot be made\n")
        return 2
    unseen = [one for faults, tried in unseen_half.TRIED for one in _trials(faults, tried, seeds)]
    whole = (false_alarms(known_half.FAMILIES, seeds), false_alarms(unseen_half.FAMILIES, seeds))
    count, flagged = flagged_masters(folder)
    if unseen:
        _write_down(unseen)
    PAGE.write_text(_page(known, unseen, whole, count, flagged, len(seeds)), encoding="utf-8")
    too_many = [check for check, names in flagged.items() if len(names) > MOST]
    missed = [check for check in CHECKS for half in (known, unseen) if half and _share(half, check) < FOUND]
    sys.stdout.write(
        f"{PAGE} written; too many masters flagged: {too_many or 'none'}; below 95 %: {missed or 'none'}\n"
    )
    return 1 if too_many or missed else 0


def _known(seeds: range, checks: Collection[str], families: Iterable[str] | None) -> list[Trial]:
    """The trials of the known half for these checks, in these families, in all without."""
    return [
        one
        for faults, tried in known_half.TRIED
        for one in _trials(faults, {name: tried[name] for name in families or tried if name in tried}, seeds, checks)
    ]


def _trials(
    faults: tuple[Fault, ...], families: Mapping[str, Family], seeds: range, checks: Collection[str] = CHECKS
) -> list[Trial]:
    """Every trial of a half for these checks, its families side by side."""
    with ProcessPoolExecutor() as pool:
        parts = [
            pool.submit(_family_trials, faults, {name: family}, seeds, checks) for name, family in families.items()
        ]
        return [one for part in parts for one in part.result()]


def _family_trials(
    faults: tuple[Fault, ...], families: Mapping[str, Family], seeds: range, checks: Collection[str]
) -> list[Trial]:
    return list(trials(faults, families, seeds, checks))


def _write_down(unseen: list[Trial]) -> None:
    """Add a line to the list of looks at the unseen half: when, and the share found of each check's faults."""
    with LOOKS.open("a", encoding="utf-8", newline="") as file:
        shares = (f"{100 * _share(unseen, check):.1f}" for check in CHECKS)
        csv.writer(file, lineterminator="\n").writerow([f"{datetime.now(UTC):%Y-%m-%d %H:%M}", *shares])


def _rows(path: Path) -> list[list[str]]:
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.reader(file))


def _looks(path: Path) -> str:
    head, *looks = _rows(path)
    rows = "".join(f"| {' | '.join(look)} |\n" for look in looks)
    return f"| {' | '.join(head)} |\n|{'---|' * len(head)}\n{rows}"


def _page(
    known: list[Trial],
    unseen: list[Trial],
    whole: tuple[tuple[int, Counter[tuple[str, str]]], ...],
    masters: int,
    flagged: dict[str, set[str]],
    seeds: int,
) -> str:
    return f"""<!-- Made by `SOUNDS_DIR=... make false-alarms`. Change it there. -->

# False alarms

A detector that cries wolf is switched off, and then finds nothing. So each one is held to two figures: how
many of {masters} real, accepted game sounds it flags ({MOST} at most, each named below), and how many of the faults
that were put into whole sounds on purpose it finds ({MUST} at audible levels). One half of the families of sounds
and of faults was used to set the thresholds; the other half was never run while they were set, and is looked at for
this page alone. Who wrote it ran no detector and read none of their code, but once saw the thresholds as told below.

## What is promised
{_list(PROMISED)}

What else was tried lies beyond the promise; how much of it is found, and why no more is promised, stands
[below](#beyond-the-promise).

## Thresholds
{_thresholds()}

## Real masters
| check | flagged of {masters} | what is there |
|---|---|---|
{_masters_rows(flagged)}
## Faults found
Found at the levels that count, of all that were put in:

| check | known families | unseen families |
|---|---|---|
{_summary_rows(known, unseen)}
Short of {MUST}: {_short_of(known, unseen)}.

Click levels are told by how far a click stands out of the sound in its most audible Bark band above 1 kHz, with
masking spread over the bands by 10 dB a Bark upwards and 27 dB downwards; and it is as sharp as one sample 40 dB
under the sound's peak, or sharper. From {AUDIBLE["click"]:g} dB on it counts. Clicks and dropouts are put where a
sound goes on: within 35 dB of its peak, and as loud, within 10 dB, in the 10 ms before as after. Clipping counts
where five crests are cut off for three samples each. Hum is told by its third strongest line, against what the
sound has in the 100 Hz around it in its quietest quarter. Noise lies 15 dB or more under the sound.

### Known families: {", ".join(known_half.FAMILIES)}
{seeds} sounds of each, of 44.1, 48 and 96 kHz, mono and stereo. Clicks are put into the families that judgements
learn from as well: {", ".join(family.removeprefix("training ") for family in training_sounds.FAMILIES)}.

{_found_table(_promised(known))}
### Unseen families: {", ".join(unseen_half.FAMILIES) or "not yet written"}
{_found_table(_promised(unseen))}
### Beyond the promise
| check | fault | known families | unseen families | why it is not promised |
|---|---|---|---|---|
{_beyond_rows(known, unseen)}
### Looks at the unseen half
Per cent found of each check's faults, at the levels that count.

{_looks(LOOKS)}
The look at 20:33 counted the start point of a sampler as well, which fades a start in: the promise, as it was written
before that look, holds of a start without a fade, so that this way now stands beyond it.
At 20:33 there were 4 sounds of each family, for want of time; at 20:44 hum alone was looked at with 10, and at 22:50
everything, as in all looks before these. No detector was changed between.

### The first unseen half
{", ".join(once_unseen_sounds.FAMILIES).capitalize()}, with the faults that were put into them,
were the unseen half until they had been looked at {len(_rows(FORMER_LOOKS)) - 1} times. What is looked at so often is
not unseen any more: they are known since, were looked at case by case, and others took their place.

Between two of those looks detectors were changed on what the known half showed; for that it was made wider after the
first look, by jingle, whistle and tick, and after the second, whose table told what is missed, by drips, knocks and
chirps, by pops, by samples in the wrong order and by three or four multiples. The fourth look was at a way to
foretell clicks that found more in the known half and none in the unseen one; it was not kept. Before the fifth the
known half got pulses of any shape, which imitate nothing and of which the detector of then missed as many as of the
unseen faults. Boosted trees over seventy figures of each doubtful moment were learned from these and from sounds that
imitate nothing; in families that they had not met they did no better than two of these figures with a threshold each.

{_looks(FORMER_LOOKS)}
### The second unseen half
{", ".join(second_unseen_sounds.FAMILIES).capitalize()}, with the faults that were put into them,
took their place. The one look at them showed what no detector had been thought of for: each way that was found in few
was then looked at case by case, and so they are known too.

{_looks(SECOND_LOOKS)}
### The third unseen half
{", ".join(third_unseen_sounds.FAMILIES).capitalize()}, with faults as they come about in practice, were looked at once
and are known since.

{_looks(THIRD_LOOKS)}
Left out of both halves, because the sound has by its nature what the fault would leave: {_left_out()}.

## Whole sounds of these families
| check | known: flagged of {whole[0][0]} | unseen: flagged of {whole[1][0]} |
|---|---|---|
{_alarm_rows(whole)}"""


def _list(texts: Mapping[str, str]) -> str:
    return "\n".join(f"- **{check}**: {text}" for check, text in texts.items())


def _thresholds() -> str:
    lines = {
        "click": f"the sixth difference of a half-millisecond is {clicks.STANDS_OUT:g} times, its largest step"
        f" {clicks.STEPS_OUT:g} times, or its bend below 1 kHz {clicks.BENDS_OUT:g} times the largest within"
        f" {clicks.REACH / 2:g} ms before and after. What is {clicks.DOUBTFUL:g} times as sharp, or so large a step,"
        f" or {clicks.BENDS_DOUBTFUL:g} times as bent, is a click where {clicks.ALONE[0].cells / 2:g} ms there can be"
        f" foretold neither from the {clicks.BESIDE / 2:g} ms before nor from those after,"
        f" {clicks.HARDER_THAN_BESIDE:g} times as badly as that sound itself, and {clicks.HARDER_THAN_AROUND:g} times"
        f" as badly both ways as any other place so near; from {clicks.DULL_DOUBTFUL:g} times on also where it is"
        f" foretold {clicks.DULL_HARDER_THAN_BESIDE:g} and {clicks.DULL_HARDER_THAN_AROUND:g} times as badly without"
        f" the highs, at a quarter of the rate or so. Steady sounds throughout (the peak of their sixth differences,"
        f" but for the {clicks.CLICKED} sharpest of {clicks.SEGMENT} cells, under {clicks.STEADY:g} times the"
        f" RMS) are foretold"
        f" from {clicks.ORDER} samples, and {clicks.STANDS_OUT:g} times are wanted of what cannot be. Where the largest"
        f" step changes by less than {100 * clicks.GLIDES:g} % from one half-millisecond to the next, a tone glides:"
        f" there what is {clicks.GLIDE_DOUBTFUL:g} times as hard to foretell as the {clicks.GLIDED / 2:g} ms before and"
        f" after is looked at so too, and {clicks.GLIDE_HARDER:g} times as badly as the sound on either side is enough."
        f" Several within {clicks.IN_BURSTS[0].cells / 2:g} ms are one event where one is"
        f" {clicks.BURST_STANDS_OUT:g} times as sharp as all that lies {clicks.BURST / 2:g} to {clicks.REACH / 2:g} ms"
        f" before and after, and is foretold {clicks.BURST_HARDER_THAN_BESIDE:g} and"
        f" {clicks.BURST_HARDER_THAN_AROUND:g} times as badly, in a sound whose sixth differences have there the same"
        f" power before as after, within {power_decibels(clicks.BURST_GOES_ON):.1f} dB."
        f" What lies {-decibels(clicks.BELOW_PEAK):.0f} dB under the file's peak counts for nothing.",
        "dropout": f"a hole is {dropouts.SHORTEST / 2:g} to {dropouts.LONGEST / 2:g} ms in which no step exceeds"
        f" {dropouts.STILL * 2**15:.1f} units of 16 bit, or nothing but a value that leaks away or a straight"
        f" line, or that lie {power_decibels(lulls.UNDER):.0f} dB under the sound and are level, within"
        f" {power_decibels(lulls.HALVES):.0f} dB from half to half; with sound up to both its edges, as loud within"
        f" {power_decibels(dropouts.ALIKE):.0f} dB; holes that are alike and come on a beat are a gate; a repeat is a"
        f" buffer of"
        f" {1000 * repeats.SHORTEST_S:g} to {1000 * repeats.LONGEST_S:g} ms that comes again, bit by bit, up to"
        f" {repeats.MOST_TIMES:g} times, or"
        f" once after no more than {repeats.RING - 1} others.",
        "cut-start, cut-tail": f"the outermost sample reaches {cuts.EDGE_SHARE:g} of the largest within"
        f" {1000 * abrupt.NEAR_S:g} ms, lies less than {-decibels(cuts.BELOW_PEAK):.0f} dB under the file's peak, and"
        f" the wave, followed on, does not pass through zero; or so where the sample to which it rises within"
        f" {cuts.STEP + 1:g} is the outermost, but for what rings at {cuts.RING_HZ:g} of the rate or faster and"
        f" {cuts.RING_SHARE:g} as high. Or the sound rises from {abrupt.REST:g} of the largest to {abrupt.REACHES:g}"
        f" within a sample (of 48 kHz) or, by a ramp, {1000 * abrupt.RAMP_S:g} ms, and is as loud there as"
        f" {abrupt.LOUD:g} of what follows; unless it can be foretold (within {abrupt.FORETOLD:g} of the largest) from"
        f" what follows, and is there within {abrupt.OTHERWISE:g}. At a start level and slope are, from 10 to 40 ms"
        f" after it, {abrupt.DIES:g} to {abrupt.GROWS:g} times those of the first 5 ms, or it is an attack; at an end a"
        f" low cut's smooth answer does not count.",
        "clipping": f"{flat_tops.SHORTEST_RUN} samples in a row at full scale; or {flat_tops.FEWEST} crests at the"
        f" file's own ceiling (within {100 * flat_tops.CEILING:g} %), each with {flat_tops.SHORTEST_RUN} samples or"
        f" more on one level and a corner at both ends; or {100 * flat_tops.SOFT_SHARE:.0f} % of the highest crests of"
        f" a channel's side, {flat_tops.SOFT_FEWEST} at least, less than {flat_tops.SOFT_RATIO:g} times as wide"
        f" at {flat_tops.SOFT_WIDE:g} of their height as at {flat_tops.SOFT_FLAT:g}; or, where one of the"
        f" {flat_tops.HIGHEST} highest crests of a channel's side is so, {straight_tops.FEWEST} crests or more, over"
        f" {straight_tops.HIGH:g} of the highest, that are straight between two corners: these bend 16 times as much as"
        f" anything between them (64 times where two samples lie between, 4096 times where one does); or, seen over two"
        f" samples, 10 times as much as what lies between, among ripples that bend twice as much as that. They are over"
        f" {straight_tops.SHARE:g} of all that lie as high near by, and steps are at most"
        f" {straight_tops.MOST_STEPPED:g} times as many.",
        "dc-offset": "the limit of the spec, here 1 % of full scale.",
        "hum": f"{hum.LINES} multiples of 50 or 60 Hz, within {100 * hum.OFF:g} %, in tune within"
        f" {100 * hum.IN_TUNE:.2g} %"
        f" ({hum.LINES + 1} lines: {100 * hum.LOOSER * hum.IN_TUNE:.2g} %), "
        f"{power_decibels(hum.PROMINENT):.0f} dB over what lies beside them in the quietest"
        f" quarter of windows of {hum.WINDOWS_S[0]:g} or {hum.WINDOWS_S[1]:g} s. Where fewer do, in the first"
        f" {in_phase.LONGEST_S:g} s, as many that add up in phase over windows of {in_phase.WINDOW_S:g} s, weighted by"
        f" the noise beside them, to {power_decibels(in_phase.PROMINENT):.0f} dB over what that noise adds up to; they"
        f" are there in {100 * in_phase.CONSTANT:.0f} % of the windows that could show them, and in each half of the"
        f" sound; of multiples {', '.join(map(str, hum.NEUTRAL))}, too, the first among them."
        f" {power_decibels(hum.LEAST):.0f} dBFS or more together.",
        "noise-floor": "the limit of the spec, here -60 dBFS, on the quietest"
        f" {noise_floor.PAUSE / 100:g} s, where it is steady, does not die away and lies"
        f" {power_decibels(noise_floor.DEEP):.0f} dB or more under the loudest; what stays within"
        f" {noise_floor.PLATEAU_DB:g} dB for {2 * noise_floor.PAUSE / 100:g} s does not die away.",
    }
    return _list(lines)


def _masters_rows(flagged: dict[str, set[str]]) -> str:
    rows = ""
    for check in CHECKS:
        names = sorted(flagged[check])
        there = "; ".join(f"`{name}`: {NAMED[check].get(name, 'not yet looked at')}" for name in names) or "nothing"
        rows += f"| {check} | {len(names)} | {there} |\n"
    return rows


def _counts(half: Iterable[Trial], check: str) -> tuple[int, int]:
    counted = [one for one in _promised(half) if one.fault.check == check and counts(one.fault, one.level)]
    return sum(one.found for one in counted), len(counted)


def _promised(half: Iterable[Trial]) -> list[Trial]:
    return [one for one in half if (one.fault.check, one.fault.name) not in BEYOND]


def _beyond_rows(*halves: Iterable[Trial]) -> str:
    rows = ""
    for (check, name), why in BEYOND.items():
        cells = []
        for half in halves:
            tries = [one.found for one in half if (one.fault.check, one.fault.name) == (check, name)]
            cells.append(f"{sum(tries)} of {len(tries)}, {_percent(sum(tries), len(tries))}")
        rows += f"| {check} | {name} | {' | '.join(cells)} | {why} |\n"
    return rows


def _share(half: Iterable[Trial], check: str) -> float:
    found, tried = _counts(half, check)
    return found / tried if tried else 0.0


def _summary_rows(known: list[Trial], unseen: list[Trial]) -> str:
    rows = ""
    for check in CHECKS:
        cells = (_counts(half, check) for half in (known, unseen))
        rows += f"| {check} | " + " | ".join(f"{found} of {tried}, {_percent(found, tried)}" for found, tried in cells)
        rows += " |\n"
    return rows


def _short_of(known: list[Trial], unseen: list[Trial]) -> str:
    halves = {"known": known, "unseen": unseen} if unseen else {"known": known}
    short = [f"{check} ({name})" for check in CHECKS for name, half in halves.items() if _share(half, check) < FOUND]
    return ", ".join(short) or "none"


def _found_table(half: Iterable[Trial]) -> str:
    counts: dict[tuple[str, str, float, str], list[Trial]] = defaultdict(list)
    for one in half:
        counts[one.fault.check, one.fault.name, one.level, one.fault.unit].append(one)
    order = {check: place for place, check in enumerate(CHECKS)}
    rows = "| check | fault | level | found | missed in |\n|---|---|---|---|---|\n"
    for (check, name, level, unit), tries in sorted(counts.items(), key=lambda item: (order[item[0][0]], item[0])):
        found = sum(one.found for one in tries)
        missed = Counter(one.family for one in tries if not one.found)
        where = ", ".join(f"{family} {times}" for family, times in sorted(missed.items()))
        share = f"{found} of {len(tries)}, {_percent(found, len(tries))}"
        rows += f"| {check} | {name} | {level:g} {unit} | {share} | {where} |\n"
    return rows


def _alarm_rows(whole: tuple[tuple[int, Counter[tuple[str, str]]], ...]) -> str:
    rows = ""
    for check in CHECKS:
        cells = []
        for _, flagged in whole:
            families = {family: times for (one, family), times in sorted(flagged.items()) if one == check}
            told = ", ".join(f"{family} {times}" for family, times in families.items())
            cells.append(f"{sum(families.values())}" + (f" ({told})" if told else ""))
        rows += f"| {check} | {' | '.join(cells)} |\n"
    return rows


def _percent(found: int, tried: int) -> str:
    return f"{100 * found / tried:.1f} %" if tried else "none"


def _left_out() -> str:
    return "; ".join(f"{check} in {', '.join(sorted(families))}" for check, families in NO_PLACE.items())


if __name__ == "__main__":
    sys.exit(main())
