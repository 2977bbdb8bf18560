"""Writes a table of RESULTS.md: `SOUNDS_DIR=... make audit`.

The real masters are looked at here alone, and each look is written down in looks.csv.
"""

import csv
import os
import sys
from collections.abc import Iterable
from concurrent.futures import ProcessPoolExecutor
from datetime import UTC, datetime
from pathlib import Path

from benchmarks.audits.changes import CHANGES, MEASURED_GAIN, TRIMS
from benchmarks.audits.trial import Found, generated, real, trial
from benchmarks.tables import write_between

PAGE = Path(__file__).with_name("RESULTS.md")
LOOKS = Path(__file__).with_name("looks.csv")
MASTERS = 128
WANTED, WANTED_TRIMMED, WANTED_OFF_DB = 0.99, 0.98, 0.45
KNOWN_SEED, FINAL_SEED = 3, 20


def main() -> int:
    """Look, write the table, and return 1 where a promise is not kept."""
    folder = Path(os.environ.get("SOUNDS_DIR", ""), "masters")
    if not folder.is_dir():
        sys.stderr.write("SOUNDS_DIR does not name a folder with masters/ in it\n")
        return 2
    masters = list(real(folder))
    made = list(generated(FINAL_SEED, MASTERS - len(masters)))
    with ProcessPoolExecutor(2) as pool:
        known, final = pool.map(
            trial,
            (list(generated(KNOWN_SEED, MASTERS)), [*masters, *made]),
            (KNOWN_SEED, FINAL_SEED),
        )
    with LOOKS.open("a", encoding="utf-8", newline="") as file:
        row = [f"{100 * share:.1f}" for share in (final.share(CHANGES), final.share(TRIMS))]
        now = f"{datetime.now(UTC):%Y-%m-%d %H:%M}"
        csv.writer(file, lineterminator="\n").writerow([now, *row, len(final.false)])
    write_between(PAGE, "audits", _table(known, final))
    for who, tally in (("known sounds", known), ("masters", final)):
        sys.stdout.write(f"{who}: not found: {_listed(tally.missed)}; taken for another: {_listed(tally.false)}\n")
    kept = [
        one.share(CHANGES) >= WANTED
        and one.share(TRIMS) >= WANTED_TRIMMED
        and not one.false
        and max(one.off_db.values()) <= WANTED_OFF_DB
        for one in (known, final)
    ]
    sys.stdout.write(f"{PAGE} written; kept with known sounds: {kept[0]}, with the masters: {kept[1]}\n")
    return 0 if all(kept) else 1


def _table(known: Found, final: Found) -> str:
    rows = "".join(
        f"| {name} | {_count(known, [name])} | {_count(final, [name])} | {_off(known, name)} | {_off(final, name)} |\n"
        for name in (*CHANGES, *TRIMS)
    )
    return f"""| changed by | known: found | masters: found | known: gain off by, at most | masters: gain off by, \
at most |
|---|---|---|---|---|
{rows}| all but cuts (99 % wanted) | {_count(known, CHANGES)} | {_count(final, CHANGES)} | | |
| cuts (98 % wanted) | {_count(known, TRIMS)} | {_count(final, TRIMS)} | | |

Gain is compared with the gain applied, for gain and other rates ({WANTED_OFF_DB} dB wanted); after an equaliser or
a codec there is no such figure.

False matches: {len(known.false)} with known sounds, {len(final.false)} with the masters, among {known.pairs:,} and
{final.pairs:,} pairs of different sounds as they are, and in all audits above."""


def _count(tally: Found, names: Iterable[str]) -> str:
    wanted = list(names)
    found, tried = (sum(counts[name] for name in wanted) for counts in (tally.found, tally.tried))
    return f"{found} of {tried} ({100 * found / tried:.1f} %)"


def _off(tally: Found, name: str) -> str:
    return f"{tally.off_db.get(name, 0.0):.2f} dB" if name in MEASURED_GAIN else ""


def _listed(names: list[str]) -> str:
    return "; ".join(names) or "none"


if __name__ == "__main__":
    sys.exit(main())
