"""The response that turns a dry sound into the same sound as delivered."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from audio_checks.measure.decibels import power_decibels

DIRECT_S = 0.005  # around its highest point the response is the dry sound itself
EARLIEST_S, LATEST_S = 0.25, 4.0  # of the response, before and after its highest point
ROW_S = 0.005
AROUND_HZ = 150.0  # over which the dry sound's power is averaged
NOTCH = 1e-4  # of the power around: deeper notches of the dry sound are filled
FAINTEST = 1e-7  # of the strongest power: where the dry sound has less, the response is unknown


@dataclass(frozen=True)
class Response:
    """A response, by what it is made of.

    Attributes
    ----------
    delay_s : float
        By which the delivered sound comes later than the dry one.
    wet_db : float
        Energy of what follows the direct sound, over the direct sound's; -inf where nothing stands out.
    before_db : float
        The same of an equally long time before it, where nothing can have been added: near `wet_db` the two
        sounds are not the same.
    rt60_s : float or None
        By the line through -5 to -25 dB of what follows; None where it is too short or too faint.
    curve_db : tuple of float
        Energy still to come after the direct sound, every 5 ms, 0 at the start.
    """

    delay_s: float
    wet_db: float
    before_db: float
    rt60_s: float | None
    curve_db: tuple[float, ...]


def response_between(dry: NDArray[np.float64], delivered: NDArray[np.float64], sample_rate_hz: int) -> Response | None:
    """Return the response that turns a dry sound into the delivered one, by division of their spectra.

    Parameters
    ----------
    dry, delivered : ndarray, shape (frames, channels)
        At one sample rate; their channels may differ in number. Levels do not matter.
    sample_rate_hz : int
        Frames per second.

    Returns
    -------
    Response or None
        None where either is silent or empty.
    """
    if not (dry.any() and delivered.any()):
        return None
    size = 1 << (len(dry) + len(delivered) + round(LATEST_S * sample_rate_hz)).bit_length()
    source = np.fft.rfft(dry.mean(axis=1) if dry.mean(axis=1).any() else dry[:, 0], size)
    power = np.square(np.abs(source))
    width = max(1, round(AROUND_HZ * size / sample_rate_hz))
    sums = np.concatenate((np.zeros(1), np.cumsum(np.pad(power, (width // 2, width - width // 2), mode="edge"))))
    around = (sums[width:] - sums[:-width])[: len(power)] / width
    divisor = np.where(around > FAINTEST * around.max(), source.conj() / (power + NOTCH * around + 1e-30), 0.0)
    kernel = np.fft.irfft(source * divisor, size)  # what the division makes of the dry sound itself
    energy, direct = np.zeros(size), 0.0
    responses = [np.fft.irfft(np.fft.rfft(channel, size) * divisor, size) for channel in delivered.T]
    peak = int(np.argmax(np.sum(np.abs(responses), axis=0)))
    for response in responses:
        level = response[peak] / kernel[0]
        energy += np.square(response - level * np.roll(kernel, peak))
        direct += level**2 * float(np.square(kernel).sum())
    delay = peak if peak < size // 2 else peak - size
    after, before = _rows(np.roll(energy, size // 2 - peak), sample_rate_hz)
    return _described(delay / sample_rate_hz, direct, after, before)


def _rows(energy: NDArray[np.float64], sample_rate_hz: int) -> tuple[NDArray[np.float64], float]:
    """Return the energy of every 5 ms behind the direct sound, which is in the middle, and as long before it."""
    row, direct, middle = max(1, round(ROW_S * sample_rate_hz)), round(DIRECT_S * sample_rate_hz), len(energy) // 2
    count = min(round(LATEST_S / ROW_S), (len(energy) - middle - direct) // row)
    after = energy[middle + direct : middle + direct + count * row].reshape(count, row).sum(axis=1)
    earlier = min(round(EARLIEST_S * sample_rate_hz), middle - direct)
    return after, float(energy[middle - direct - earlier : middle - direct].sum() * count * row / earlier)


def _described(delay_s: float, direct: float, after: NDArray[np.float64], before: float) -> Response:
    noise = before / len(after)
    heard = np.maximum(after - noise, 0.0)
    loud = np.flatnonzero(after > 4 * noise)
    heard = heard[: loud[-1] + 1] if len(loud) else heard[:0]
    total = float(heard.sum())
    curve = 10 * np.log10(np.cumsum(heard[::-1])[::-1] / total + 1e-12) if total > 0 else np.empty(0)
    rows = np.flatnonzero((curve <= -5) & (curve >= -25))
    rt60_s = None
    if len(rows) >= 4 and curve[-1] <= -20:
        slope = float(np.polyfit(rows * ROW_S, curve[rows], 1)[0])
        rt60_s = -60 / slope if slope < 0 else None
    return Response(
        delay_s=delay_s,
        wet_db=power_decibels(total / direct) if direct > 0 else math.inf,
        before_db=power_decibels(before / direct) if direct > 0 else math.inf,
        rt60_s=rt60_s,
        curve_db=tuple(round(float(level), 1) for level in np.maximum(curve, -80.0)),
    )
