"""The real masters: which of them each detector flags, and what is there when one looks at the wave."""

import os
from pathlib import Path

from benchmarks.faults.trial import CHECKS, findings_in

MOST = 2  # of the masters that each detector may flag

NAMED: dict[str, dict[str, str]] = {
    "clipping": {
        "elec_hollow_kick.wav": "the first crest of the kick is cut off at full scale for 16 samples, in both channels",
        "perc_snap2.wav": "four tops of 6 samples pressed against full scale, with the ripples of a change of rate",
    },
    "click": {
        "glitch_bass_g.wav": "steps of one to three samples in a slow bass wave, some 25 dB over what is around them",
    },
    "cut-start": {
        "glitch_perc1.wav": "the first sample is at -7 dBFS, near the crest of a slow wave",
        "vinyl_hiss.wav": "a stretch of a longer recording, cut out without a fade: first sample at -34 dBFS",
    },
    "cut-tail": {
        "vinyl_hiss.wav": "the same at its end: last sample at -37 dBFS",
    },
    "dropout": {},
    "dc-offset": {
        "elec_fuzz_tom.wav": "a distorted tom of 0.4 s whose mean is 1.01 % of full scale, limit 1 %",
        "elec_hi_snare.wav": "a synthetic snare of 0.2 s whose mean is 1.02 % of full scale, limit 1 %",
    },
    "hum": {},
    "noise-floor": {
        "misc_burp.wav": "rumble and hiss of the recording after its last sound, -50 dBFS, limit -60 dBFS",
        "vinyl_backspin.wav": "a level stretch at -28 dBFS after the turn: part of the sound, which never pauses",
    },
}


def masters_folder() -> Path | None:
    """The folder of the masters, where SOUNDS_DIR names one."""
    folder = os.environ.get("SOUNDS_DIR")
    return Path(folder, "masters") if folder else None


def flagged_masters(folder: Path) -> tuple[int, dict[str, set[str]]]:
    """How many masters there are, and which of them each detector flags."""
    flagged: dict[str, set[str]] = {check: set() for check in CHECKS}
    masters = sorted(folder.glob("*.wav"))
    for path in masters:
        for finding in findings_in(path):
            flagged[finding.check].add(path.name)
    return len(masters), flagged
