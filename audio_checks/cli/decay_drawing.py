"""The evidence for reverb in lines of text: how each octave dies away, and how alike left and right are."""

import math
from collections.abc import Iterator, Mapping
from typing import Any

BLOCKS = "▁▂▃▄▅▆▇█"
FLOOR_DB = -60.0  # drawn as the lowest block; 0 dB is the highest
MOST_COLUMNS = 24


def drawn(evidence: Mapping[str, Any]) -> Iterator[str]:
    """Yield a line that says what is drawn, and then one an octave; none where no decay was found.

    Parameters
    ----------
    evidence : mapping
        The `evidence` of a judgement on reverb: `decay` and `coherence`, as `measure` gives them in JSON.
    """
    decay = evidence.get("decay")
    if decay is None or not decay["bands"]:
        return
    widest = max(len(band["curve_db"]) for band in decay["bands"])
    points = math.ceil(widest / MOST_COLUMNS)
    columns = math.ceil(widest / points)
    sides = {octave["hz"]: octave for octave in evidence.get("coherence") or ()}
    head = f"decay from {decay['start_s']:.2f} s on, one block every {points * decay['step_s'] * 1000:.0f} ms"
    yield f"{head}; left and right alike in head, tail" if sides else head
    for band in decay["bands"]:
        curve = "".join(_block(level) for level in band["curve_db"][::points])
        line = f"{_hertz(band['hz'])}  {curve:<{columns}}  {_rate(band)}"
        alike = sides.get(band["hz"])
        yield f"{line}  {_share(alike['head'])}, {_share(alike['tail'])}" if alike else line.rstrip()


def _block(level_db: float) -> str:
    return BLOCKS[round((1 - max(level_db, FLOOR_DB) / FLOOR_DB) * (len(BLOCKS) - 1))]


def _hertz(hz: float) -> str:
    return f"{hz / 1000:>3g} kHz" if hz >= 1000 else f"{hz:>3g} Hz "


def _rate(band: Mapping[str, Any]) -> str:
    if band["rate_db_s"] is None:
        return f"{'too short for a rate':<31}"
    return f"{band['rate_db_s']:>7.1f} dB/s, 60 dB in {band['rt60_s']:>5.2f} s"


def _share(share: float | None) -> str:
    return "-" if share is None else f"{share:.2f}"
