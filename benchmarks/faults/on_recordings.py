"""Writes RECORDINGS.md: how often checks and judgements are right on real recordings.

`RECORDED_DIR=... python -m benchmarks.faults.on_recordings`. Nothing was learned from these recordings, and no
threshold was set on them. See `training/recorded.py` for the folder.
"""

import csv
import hashlib
import os
import sys
import tempfile
from collections import Counter, defaultdict
from pathlib import Path

import numpy as np
import soundfile
from scipy import signal
from sklearn.metrics import roc_auc_score

from audio_checks.audio.audio_file import AudioFile
from audio_checks.judge import Judgement, figures_of, judge
from benchmarks.faults.injuries import FAULTS
from benchmarks.faults.promise import BEYOND
from benchmarks.faults.trial import AUDIBLE, CHECKS, _try, findings_in
from tests.support.waves import write_wav

PAGE = Path(__file__).with_name("RECORDINGS.md")
A_REPOSITORY = 2  # recordings of each, those with the lowest hash of their name
LONGEST_S, SHORTEST_S = 4.0, 0.1
LEAST_RATE_HZ = 44_100  # the faults are made for
CODED = "VORBIS"
JUDGEMENTS = ("reversed", "upsampled", "lossy")


def recordings(folder: Path) -> list[tuple[str, str, bool, np.ndarray, int]]:
    """Return repository, name, whether it was coded by Vorbis, samples and rate of some of each repository."""
    by_repository: dict[str, list[dict[str, str]]] = defaultdict(list)
    with (folder / "FILES.csv").open(encoding="utf-8", newline="") as rows:
        for row in csv.DictReader(rows):
            fits = SHORTEST_S <= float(row["seconds"]) <= LONGEST_S and int(row["rate"]) >= LEAST_RATE_HZ
            if fits and not row["file"].startswith("ir/"):
                by_repository[row["repository"]].append(row)
    found = []
    for repository, rows in sorted(by_repository.items()):
        rows.sort(key=lambda row: hashlib.sha256(row["file"].encode()).hexdigest())
        for row in rows[:A_REPOSITORY]:
            samples, rate = soundfile.read(folder / row["file"], always_2d=True)
            found.append((repository, row["file"], row["subtype"] == CODED, samples[:, :2], rate))
    return found


def judged(path: Path, samples: np.ndarray, rate: int) -> dict[str, Judgement]:
    """Return the judgements of a sound as a file of 16 bits, kind unsaid."""
    with AudioFile(write_wav(path, np.clip(samples, -1, 1), rate=rate, bits=16)) as file:
        file.prepare([figure for name in JUDGEMENTS for figure in figures_of(name)])
        return {name: judge(name, file, None) for name in JUDGEMENTS}


def brought_up(samples: np.ndarray, rate: int) -> np.ndarray:
    """Return a sound brought to half its rate and back."""
    half = signal.resample_poly(samples, 1, 2, axis=0, window=("kaiser", 12.0))
    return signal.resample_poly(half, 2, 1, axis=0, window=("kaiser", 12.0))


def main() -> int:
    """Try all, write the page."""
    named = os.environ.get("RECORDED_DIR")
    if not named:
        sys.stderr.write("RECORDED_DIR does not name a folder of recordings\n")
        return 2
    sounds = recordings(Path(named))
    flagged: Counter[str] = Counter()
    tried: Counter[str] = Counter()
    found: Counter[str] = Counter()
    scores: dict[str, list[tuple[bool, float, str]]] = defaultdict(list)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "sound.wav")
        for number, (_, _, is_coded, samples, rate) in enumerate(sounds):
            flagged.update({finding.check for finding in findings_in(write_wav(path, samples, rate=rate))})
            for place, fault in enumerate(FAULTS):
                if (fault.check, fault.name) in BEYOND:
                    continue
                level = next(level for level in fault.levels if level >= AUDIBLE.get(fault.check, level))
                hit = _try(path, fault, level, samples, rate, np.random.default_rng([number, place]))
                if hit is not None:
                    tried[fault.check] += 1
                    found[fault.check] += hit
            whole = judged(path, samples, rate)
            turned = judged(path, samples[::-1], rate)
            up = judged(path, brought_up(samples, rate), rate)
            for truth, said in ((False, whole), (True, turned)):
                _keep(scores["reversed"], truth, said["reversed"])
            for truth, said in ((False, whole), (True, up)):
                if not is_coded:
                    _keep(scores["upsampled"], truth, said["upsampled"])
            _keep(scores["lossy"], is_coded, whole["lossy"])
    PAGE.write_text(_page(len(sounds), flagged, tried, found, scores), encoding="utf-8")
    return 0


def _keep(some: list[tuple[bool, float, str]], truth: bool, said: Judgement) -> None:
    if said.score is not None:
        some.append((truth, said.score, said.verdict))


def _page(
    count: int,
    flagged: Counter[str],
    tried: Counter[str],
    found: Counter[str],
    scores: dict[str, list[tuple[bool, float, str]]],
) -> str:
    checks = "".join(f"| {check} | {flagged[check]} | {found[check]} of {tried[check]} |\n" for check in CHECKS)
    judgements = ""
    for name, some in scores.items():
        truth, score = np.array([one[0] for one in some]), np.array([one[1] for one in some])
        said = np.array([one[2] == name for one in some])
        judgements += (
            f"| {name} | {len(some)} | {roc_auc_score(truth, score):.3f} | {said[truth].mean():.2f} |"
            f" {said[~truth].mean():.3f} |\n"
        )
    return f"""<!-- Made by `python -m benchmarks.faults.on_recordings`. Change it there. -->

# On real recordings

{count} recordings, up to {A_REPOSITORY} of each public repository, of {SHORTEST_S:g} to {LONGEST_S:g} s and 44.1 kHz or
more. Nothing was learned from them and no threshold was set on them. The faults are those of
`injuries.py`, at the faintest level that counts. Sounds flagged as they are may have a fault of the recording: none was
checked by ear.

| check | flagged as it is, of {count} | faults found |
|---|---|---|
{checks}
Reversed: each recording both ways. Upsampled: those that were not coded, as they are and brought to half their
rate and back. Lossy: those that came as Ogg Vorbis against all others, some of which may have been coded before.

| judgement | sounds | AUC | found | falsely called so |
|---|---|---|---|---|
{judgements}"""


if __name__ == "__main__":
    sys.exit(main())
