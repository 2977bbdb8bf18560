"""Writes WARNINGS.md: which checks of a new project's spec warn of recordings as they are, by source.

`RECORDED_DIR=... python -m benchmarks.faults.warnings`. See `training/recorded.py` for the folder.
"""

import csv
import os
import sys
import tempfile
from collections import Counter, defaultdict
from pathlib import Path

import soundfile

from audio_checks import check_file
from audio_checks.spec.delivery_spec import new_spec, parse_spec
from tests.support.waves import write_wav

PAGE = Path(__file__).with_name("WARNINGS.md")
FACTS = frozenset(  # of format and level
    {
        *("sample-peak", "true-peak", "loudness", "low-level", "silence", "sample-rate", "bit-depth", "channels"),
        *("duration", "naming", "false-stereo", "phase"),
    }
)
HELD_OUT = (
    "pairs/frankensnare",
    "pairs/archtop_guitar",
    "game/openclonk",
    "game/redeclipse",
    "game/godot",
    "game/gdquest",
)
DRY = ("dry/", "pairs/frankensnare/top_close", "pairs/muldjordkit/close", "pairs/archtop_guitar/magnetic_pickup")

CLICKS = """`click` names 18 of them. By what is measured there, six are ticks of the thing itself, which rings after
each: four pulls of a wooden bow, an arrow that is set to it, a clash of sticks. Rubber, a fire, a firework and a
chalk crackle. A helicopter ticks every 70 ms, with its blades. Two cries and an impact have one sample or two that
stand 36 dB or more over both sides alike, as a splice or a lost sample leaves them. Four of those held out (a drop, a
splash, a catapult, a teleport) were not looked at more closely."""


def warned(folder: Path) -> dict[str, list[set[str]]]:
    """Return of each source the checks that warn of each of its recordings, format and level left out."""
    text = new_spec().replace('adds = ["reverb"]', "adds = []").replace("[a-z0-9]+(_[a-z0-9]+)*", ".*")
    spec = parse_spec(text)
    found = defaultdict(list)
    with tempfile.TemporaryDirectory() as made, (folder / "FILES.csv").open(encoding="utf-8", newline="") as rows:
        path = Path(made, "sound.wav")
        for row in csv.DictReader(rows):
            if row["file"].startswith("ir/"):
                continue
            samples, rate = soundfile.read(folder / row["file"], always_2d=True)
            bits = 24 if row["subtype"] == "PCM_24" else 16
            report = check_file(write_wav(path, samples, rate=rate, bits=bits), spec)
            checks = {finding.check for finding in report.findings if finding.severity != "information"}
            found[row["file"].rsplit("/", 1)[0]].append(checks - FACTS)
    return found


def page(found: dict[str, list[set[str]]]) -> str:
    """Return the tables: by source, those developed on first, with a sum of each and of all dry ones."""
    is_held_out = {source: source.startswith(HELD_OUT) for source in found}
    groups = {
        "developed on": [source for source in found if not is_held_out[source]],
        "held out": [source for source in found if is_held_out[source]],
        "dry, of both": [source for source in found if source.startswith(DRY)],
    }
    rows = ""
    for name, sources in list(groups.items())[:2]:
        rows += "".join(_row(f"{source} ({name})", found[source]) for source in sorted(sources))
    rows += "".join(
        _row(f"**all {name}**", [one for source in sources for one in found[source]])
        for name, sources in groups.items()
    )
    return f"""<!-- Made by `python -m benchmarks.faults.warnings`. Change it there. -->

# Warnings on recordings as they are

By the spec of a new project; names, format, level, width and reverb are left out. None was listened to for this table:
a sound of a game may be cut, clipped or crackle in fact. Those held out were looked at on 29 November 2026, and again
on 30 November after `click` was changed by those developed on.

| source | recordings | with a warning | of which checks |
|---|---|---|---|
{rows}
{CLICKS}
"""


def _row(name: str, recordings: list[set[str]]) -> str:
    count = sum(bool(checks) for checks in recordings)
    counts = Counter(check for checks in recordings for check in sorted(checks))
    named = ", ".join(
        f"{check} {times}" for check, times in sorted(counts.items(), key=lambda item: (-item[1], item[0]))
    )
    return f"| {name} | {len(recordings)} | {count}, {100 * count / len(recordings):.0f} % | {named or 'none'} |\n"


def main() -> int:
    """Try all, write the page."""
    named = os.environ.get("RECORDED_DIR")
    if not named:
        sys.stderr.write("RECORDED_DIR does not name a folder of recordings\n")
        return 2
    PAGE.write_text(page(warned(Path(named))), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
