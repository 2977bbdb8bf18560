"""Writes tables of docs/reference/judgements.md, and RESULTS.md in full: `SOUNDS_DIR=... make false-alarms`.

The held-out set is evaluated here alone, and each run appends its figures to looks.csv.
"""

import argparse
import csv
import sys
from collections import Counter, defaultdict
from collections.abc import Collection, Iterable, Mapping
from concurrent.futures import ProcessPoolExecutor
from datetime import UTC, datetime
from pathlib import Path

from benchmarks.faults import held_out_injuries, held_out_sounds, injuries, sounds
from benchmarks.faults.injuries import Fault
from benchmarks.faults.masters import MOST, NAMED, flagged_masters, masters_folder
from benchmarks.faults.promise import BEYOND, PROMISED
from benchmarks.faults.sounds import Family
from benchmarks.faults.thresholds import thresholds
from benchmarks.faults.trial import AUDIBLE, CHECKS, NO_PLACE, Trial, counts, false_alarms, trials
from benchmarks.tables import DOCS, write_between

PAGE = DOCS / "reference/judgements.md"
RESULTS = Path(__file__).with_name("RESULTS.md")
MARK = "<!-- Made by `SOUNDS_DIR=... make false-alarms`. Change it there. -->"
LOOKS = Path(__file__).with_name("looks.csv")
FOUND = 0.95  # of the faults at levels that count
MUST = f"{100 * FOUND:.0f} %"


def main() -> int:
    """Run both sets, write the pages, and return 1 where a promise is not kept."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, default=10, help="sounds of each family")
    parser.add_argument("--development", action="store_true", help="the development set alone, and write no page")
    parser.add_argument("--checks", nargs="+", choices=CHECKS, help="the development set of these alone, and no page")
    parser.add_argument("--families", nargs="+", metavar="NAME", help="the development set in these alone, and no page")
    arguments = parser.parse_args()
    seeds = range(arguments.seeds)
    some = bool(arguments.checks or arguments.families)
    chosen = {name: sounds.FAMILIES[name] for name in arguments.families or sounds.FAMILIES}
    development = _trials(injuries.FAULTS, chosen, seeds, arguments.checks or CHECKS)
    if arguments.development or some:
        sys.stdout.write(_found_table(development))
        return 0
    folder = masters_folder()
    if folder is None:
        sys.stderr.write("SOUNDS_DIR does not name a folder with masters/ in it; their table cannot be made\n")
        return 2
    held_out = _trials(injuries.FAULTS, held_out_sounds.FAMILIES, seeds)
    held_out += _trials(held_out_injuries.FAULTS, held_out_sounds.FAMILIES, seeds)
    whole = (false_alarms(sounds.FAMILIES, seeds), false_alarms(held_out_sounds.FAMILIES, seeds))
    count, flagged = flagged_masters(folder)
    _write_down(held_out)
    for mark, text in _tables(development, held_out, whole, count, flagged).items():
        write_between(PAGE, mark, text)
    RESULTS.write_text(_results(development, held_out, whole, len(seeds), count, flagged), encoding="utf-8")
    too_many = [check for check, names in flagged.items() if len(names) > MOST]
    missed = [check for check in CHECKS for tried in (development, held_out) if _share(tried, check) < FOUND]
    sys.stdout.write(
        f"{PAGE} written; too many masters flagged: {too_many or 'none'}; below {MUST}: {missed or 'none'}\n"
    )
    return 1 if too_many or missed else 0


def _trials(
    faults: tuple[Fault, ...], families: Mapping[str, Family], seeds: range, checks: Collection[str] = CHECKS
) -> list[Trial]:
    """Return every trial of these faults for these checks, with families side by side."""
    with ProcessPoolExecutor() as pool:
        parts = [
            pool.submit(_family_trials, faults, {name: family}, seeds, checks) for name, family in families.items()
        ]
        return [trial for part in parts for trial in part.result()]


def _family_trials(
    faults: tuple[Fault, ...], families: Mapping[str, Family], seeds: range, checks: Collection[str]
) -> list[Trial]:
    return list(trials(faults, families, seeds, checks))


def _write_down(held_out: list[Trial]) -> None:
    """Append a line to the log of looks at the held-out set: when, and the share found of each check's faults."""
    with LOOKS.open("a", encoding="utf-8", newline="") as file:
        shares = (f"{100 * _share(held_out, check):.1f}" for check in CHECKS)
        csv.writer(file, lineterminator="\n").writerow([f"{datetime.now(UTC):%Y-%m-%d %H:%M}", *shares])


def _looks() -> list[list[str]]:
    """Return the log of looks at the held-out set, with its heading."""
    with LOOKS.open(encoding="utf-8", newline="") as file:
        return list(csv.reader(file))


def _looks_table() -> str:
    head, *looks = _looks()
    rows = "".join(f"| {' | '.join(look)} |\n" for look in looks)
    return f"| {' | '.join(head)} |\n|{'---|' * len(head)}\n{rows}"


def _tables(
    development: list[Trial],
    held_out: list[Trial],
    whole: tuple[tuple[int, Counter[tuple[str, str]]], ...],
    masters: int,
    flagged: dict[str, set[str]],
) -> dict[str, str]:
    """Return the tables of the page by their marks."""
    return {
        "promised": _list(PROMISED),
        "false alarms": f"""| check | real masters flagged, of {masters} | faults found, development set | \
faults found, held-out set | whole sounds flagged, development set, of {whole[0][0]} | held-out set, of {whole[1][0]} |
|---|---|---|---|---|---|
{_right_rows(development, held_out, whole, flagged).rstrip()}""",
    }


def _right_rows(
    development: list[Trial],
    held_out: list[Trial],
    whole: tuple[tuple[int, Counter[tuple[str, str]]], ...],
    flagged: dict[str, set[str]],
) -> str:
    rows = ""
    for check in CHECKS:
        totals = [_counts(tried, check) for tried in (development, held_out)]
        found = [
            _bold(f"{number} of {count}, {_percent(number, count)}", number < FOUND * count) for number, count in totals
        ]
        alarms = [str(sum(times for (one, _), times in alarm.items() if one == check)) for _, alarm in whole]
        masters = _bold(str(len(flagged[check])), len(flagged[check]) > MOST)
        rows += f"| {check} | {masters} | {' | '.join([*found, *alarms])} |\n"
    return rows


def _bold(cell: str, is_short: bool) -> str:
    """Return a cell in bold where it misses what is asked for."""
    return f"**{cell}**" if is_short else cell


def _results(
    development: list[Trial],
    held_out: list[Trial],
    whole: tuple[tuple[int, Counter[tuple[str, str]]], ...],
    seeds: int,
    masters: int,
    flagged: dict[str, set[str]],
) -> str:
    return f"""{MARK}

# Every fault that was tried

docs/reference/judgements.md has the summary.

## Flagged masters
| check | flagged of {masters} | what is there |
|---|---|---|
{_masters_rows(flagged)}
## Not promised
These faults were tried and are not promised.

| check | fault | development set | held-out set | why it is not promised |
|---|---|---|---|---|
{_beyond_rows(development, held_out)}
## Thresholds
{_list(thresholds())}

## Faults found
A click's level is how far a click stands out of the sound in its most audible Bark band above 1 kHz, with
masking spread over the bands by 10 dB a Bark upwards and 27 dB downwards; and it is as sharp as one sample 40 dB
under the sound's peak, or sharper. From {AUDIBLE["click"]:g} dB on it counts. Clicks and dropouts are put where a
sound goes on: within 35 dB of its peak, and as loud, within 10 dB, in the 10 ms before as after. Clipping counts
where five crests are cut off for three samples each. Hum counts by its third strongest line, against what the
sound has in the 100 Hz around it in its quietest quarter. Noise lies 15 dB or more under the sound.

### Development set: {", ".join(sounds.FAMILIES)}
{seeds} sounds of each, of 44.1, 48 and 96 kHz, mono and stereo.

{_found_table(_promised(development))}
### Held-out set: {", ".join(held_out_sounds.FAMILIES)}
{seeds} sounds of each.

{_found_table(_promised(held_out))}
Left out of both sets, because the sound has by its nature what the fault would leave: {_left_out()}.

### Looks at the held-out set
Per cent found of each check's faults, at the levels that count.

{_looks_table()}
The look at 20:33 had 4 sounds of each family, and also counted the start point of a sampler, which fades a start in:
the promise holds for a start without a fade. The look at 20:44 was at hum alone. The looks of 22 November also put in
faults of three sets that detectors had been developed on and that are not kept. No detector was changed because of
what a look showed.

## Whole sounds of these families
| check | development set: flagged of {whole[0][0]} | held-out set: flagged of {whole[1][0]} |
|---|---|---|
{_alarm_rows(whole)}"""


def _list(texts: Mapping[str, str]) -> str:
    return "\n".join(f"- **{check}**: {text}" for check, text in texts.items())


def _masters_rows(flagged: dict[str, set[str]]) -> str:
    rows = ""
    for check in CHECKS:
        names = sorted(flagged[check])
        there = "; ".join(f"`{name}`: {NAMED[check].get(name, 'not yet looked at')}" for name in names) or "nothing"
        rows += f"| {check} | {len(names)} | {there} |\n"
    return rows


def _counts(tried: Iterable[Trial], check: str) -> tuple[int, int]:
    counted = [one for one in _promised(tried) if one.fault.check == check and counts(one.fault, one.level)]
    return sum(one.found for one in counted), len(counted)


def _promised(tried: Iterable[Trial]) -> list[Trial]:
    return [one for one in tried if (one.fault.check, one.fault.name) not in BEYOND]


def _beyond_rows(*sets: Iterable[Trial]) -> str:
    rows = ""
    for (check, name), why in BEYOND.items():
        cells = []
        for tried in sets:
            found = [one.found for one in tried if (one.fault.check, one.fault.name) == (check, name)]
            cells.append(f"{sum(found)} of {len(found)}, {_percent(sum(found), len(found))}" if found else "not tried")
        rows += f"| {check} | {name} | {' | '.join(cells)} | {why} |\n"
    return rows


def _share(tried: Iterable[Trial], check: str) -> float:
    found, count = _counts(tried, check)
    return found / count if count else 0.0


def _found_table(tried: Iterable[Trial]) -> str:
    by_fault: dict[tuple[str, str, float, str], list[Trial]] = defaultdict(list)
    for one in tried:
        by_fault[one.fault.check, one.fault.name, one.level, one.fault.unit].append(one)
    order = {check: place for place, check in enumerate(CHECKS)}
    rows = "| check | fault | level | found | missed in |\n|---|---|---|---|---|\n"
    for (check, name, level, unit), tries in sorted(by_fault.items(), key=lambda item: (order[item[0][0]], item[0])):
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
            listed = ", ".join(f"{family} {times}" for family, times in families.items())
            cells.append(f"{sum(families.values())}" + (f" ({listed})" if listed else ""))
        rows += f"| {check} | {' | '.join(cells)} |\n"
    return rows


def _percent(found: int, tried: int) -> str:
    return f"{100 * found / tried:.1f} %" if tried else "none"


def _left_out() -> str:
    return "; ".join(f"{check} in {', '.join(sorted(families))}" for check, families in NO_PLACE.items())


if __name__ == "__main__":
    sys.exit(main())
