"""The spectral lines that lossy codecs code a sound by, as filters: what such a line is at any place of a sound.

A codec cuts a sound into overlapping frames, and codes each frame's lines, many of them as zero. Each line is a filter
of the samples, so that correlating a sound with it gives the line for all places at which a frame could begin.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

# Of the 512 taps of the polyphase filter's low-pass the first 257, in 65,536ths; the rest mirrors them.
# ISO/IEC 11172-3:1993, table 3-B.3, without the sign that it turns every 64 taps.
POLYPHASE_LOW_PASS = (
    0, -1, -1, -1, -1, -1, -1, -2, -2, -2, -2, -3, -3, -4, -4, -5, -5, -6, -7, -7, -8, -9, -10, -11, -13, -14, -16,
    -17, -19, -21, -24, -26, -29, -31, -35, -38, -41, -45, -49, -53, -58, -63, -68, -73, -79, -85, -91, -97, -104,
    -111, -117, -125, -132, -139, -147, -154, -161, -169, -176, -183, -190, -196, -202, -208, -213, -218, -222,
    -225, -227, -228, -228, -227, -224, -221, -215, -208, -200, -189, -177, -163, -146, -127, -106, -83, -57, -29,
    2, 36, 72, 111, 153, 197, 244, 294, 347, 401, 459, 519, 581, 645, 711, 779, 848, 919, 991, 1064, 1137, 1210,
    1283, 1356, 1428, 1498, 1567, 1634, 1698, 1759, 1817, 1870, 1919, 1962, 2001, 2032, 2057, 2075, 2085, 2087,
    2080, 2063, 2037, 2000, 1952, 1893, 1822, 1739, 1644, 1535, 1414, 1280, 1131, 970, 794, 605, 402, 185, -45,
    -288, -545, -814, -1095, -1388, -1692, -2006, -2330, -2663, -3004, -3351, -3705, -4063, -4425, -4788, -5153,
    -5517, -5879, -6237, -6589, -6935, -7271, -7597, -7910, -8209, -8491, -8755, -8998, -9219, -9416, -9585, -9727,
    -9838, -9916, -9959, -9966, -9935, -9863, -9750, -9592, -9389, -9139, -8840, -8492, -8092, -7640, -7134, -6574,
    -5959, -5288, -4561, -3776, -2935, -2037, -1082, -70, 998, 2122, 3300, 4533, 5818, 7154, 8540, 9975, 11455,
    12980, 14548, 16155, 17799, 19478, 21189, 22929, 24694, 26482, 28289, 30112, 31947, 33791, 35640, 37489, 39336,
    41176, 43006, 44821, 46617, 48390, 50137, 51853, 53534, 55178, 56778, 58333, 59838, 61289, 62684, 64019, 65290,
    66494, 67629, 68692, 69679, 70590, 71420, 72169, 72835, 73415, 73908, 74313, 74630, 74856, 74992, 75038,
)  # fmt: skip
POLYPHASE_BANDS, LINES_PER_BAND = 32, 18
OPUS_OVERLAP_FRAMES, OPUS_PRE_EMPHASIS = 120, 0.85


@dataclass(frozen=True)
class Lines:
    """Some lines of a codec.

    Attributes
    ----------
    codec : str
    rate_hz : int or None
        The only sample rate that it codes at; None where there are several.
    frame : int
        Frames of the sound from one frame of the codec to the next.
    filters : ndarray, shape (lines, taps)
        Each of energy 1, to correlate a sound with.
    """

    codec: str
    rate_hz: int | None
    frame: int
    filters: Floats


@cache
def all_lines() -> tuple[Lines, ...]:
    """Return lines of the codecs that are looked for, spread over the spectrum but for its lowest part."""
    spread = range(90, 930, 15)
    return (
        Lines("MP3", None, POLYPHASE_BANDS * LINES_PER_BAND, mp3_lines(range(6, 29))),
        Lines("AAC", None, 1_024, mdct_lines(sine_window(1_024), spread)),
        Lines("AAC", None, 1_024, mdct_lines(kaiser_bessel_window(1_024, 4.0), spread)),
        Lines("Vorbis", None, 1_024, mdct_lines(vorbis_window(1_024), spread)),
        Lines("Opus", 48_000, 960, emphasised(mdct_lines(opus_window(), range(60, 800, 18)))),
        Lines("AC-3", None, 256, mdct_lines(kaiser_bessel_window(256, 5.0), range(24, 240, 12))),
    )


def mdct_lines(window: Floats, numbers: Iterable[int]) -> Floats:
    """Return lines of a modified discrete cosine transform, shape (lines, len(window)).

    Parameters
    ----------
    window : ndarray, shape (2 · frame,)
        By which each frame and the one before are faded.
    numbers : iterable of int
        Of the lines, 0 to frame - 1.
    """
    frame = len(window) // 2
    turns = np.pi / frame * (np.arange(2 * frame) + 0.5 + frame / 2)
    return _at_energy_1(window * np.cos(np.outer(np.array([*numbers]) + 0.5, turns)))


def mp3_lines(bands: Iterable[int]) -> Floats:
    """Return the two middle lines of some of MP3's 32 bands, shape (2 · bands, 1632), clear of its neighbours.

    Notes
    -----
    ISO/IEC 11172-3:1993, C.1.3 (polyphase filter) and C.1.5.3.3 (18 lines of each band, long blocks; every second
    sample of odd bands changes its sign).
    """
    half = np.array(POLYPHASE_LOW_PASS, dtype=np.float64)
    low_pass = np.concatenate((half, half[255:0:-1]))
    taps, steps = np.arange(len(low_pass)), np.arange(2 * LINES_PER_BAND)
    filters = []
    for band in bands:
        within = (low_pass * np.cos((2 * band + 1) * (taps - 16) * np.pi / 64))[::-1]
        for number in (LINES_PER_BAND // 2 - 1, LINES_PER_BAND // 2):
            line = np.sin(np.pi / 36 * (steps + 0.5)) * np.cos(np.pi / 72 * (2 * steps + 19) * (2 * number + 1))
            line[1::2] *= -1 if band % 2 else 1
            spaced = np.zeros(POLYPHASE_BANDS * (len(line) - 1) + 1)
            spaced[::POLYPHASE_BANDS] = line
            filters.append(np.convolve(spaced, within))
    return _at_energy_1(np.array(filters))


def sine_window(frame: int) -> Floats:
    """Return half a sine over two frames: MP3's within a band, and one of AAC's (ISO/IEC 14496-3, 4.6.11.3)."""
    window: Floats = np.sin(np.pi * (np.arange(2 * frame) + 0.5) / (2 * frame))
    return window


def kaiser_bessel_window(frame: int, alpha: float) -> Floats:
    """Return a window of a Kaiser window's sums: AAC's other one (alpha 4), AC-3's (ATSC A/52, 7.9.5; alpha 5)."""
    sums = np.cumsum(np.kaiser(frame + 1, np.pi * alpha))
    rise = np.sqrt(sums[:frame] / sums[-1])
    return np.concatenate((rise, rise[::-1]))


def vorbis_window(frame: int) -> Floats:
    """Return the sine of a squared sine, which Vorbis fades by (Vorbis I, 4.3.1), Opus too."""
    window: Floats = np.sin(np.pi / 2 * np.square(sine_window(frame)))
    return window


def opus_window() -> Floats:
    """Return the window of Opus's frames of 20 ms at 48 kHz, of which only 2.5 ms overlap (RFC 6716, 4.3.7)."""
    rise = vorbis_window(OPUS_OVERLAP_FRAMES)[:OPUS_OVERLAP_FRAMES]
    apart = (960 - OPUS_OVERLAP_FRAMES) // 2
    half = np.concatenate((np.zeros(apart), rise, np.ones(apart)))
    return np.concatenate((half, half[::-1]))


def emphasised(filters: Floats) -> Floats:
    """Return lines of a sound whose highs were raised before they were coded, as Opus does (RFC 6716, 4.3.7.2)."""
    return _at_energy_1(np.pad(filters, ((0, 0), (1, 0))) - OPUS_PRE_EMPHASIS * np.pad(filters, ((0, 0), (0, 1))))


def _at_energy_1(filters: Floats) -> Floats:
    scaled: Floats = filters / np.sqrt(np.square(filters).sum(axis=1, keepdims=True))
    return scaled
