"""The layouts of channels that a spec can ask for, by name, and the channel masks that say them.

Sources: Microsoft's WAVEFORMATEXTENSIBLE (speaker positions); ITU-R BS.2051 for 5.1, 7.1 and 7.1.4.
Ambisonic files of order n have (n + 1)² channels and no speaker positions.
"""

from __future__ import annotations

from dataclasses import dataclass

FRONT, CENTRE, LFE, BACK, BACK_CENTRE, SIDES = 0x3, 0x4, 0x8, 0x30, 0x100, 0x600
TOP_CORNERS = 0x1000 | 0x4000 | 0x8000 | 0x20000


@dataclass(frozen=True)
class Layout:
    """One layout.

    Attributes
    ----------
    channels : int
        How many there are.
    masks : tuple of int
        The channel masks that say it; the first is the one to write. Empty for ambisonics.
    words : str
        What is meant, for a sentence.
    """

    channels: int
    masks: tuple[int, ...]
    words: str


LAYOUTS: dict[str, Layout] = {
    "mono": Layout(1, (CENTRE,), "mono"),
    "stereo": Layout(2, (FRONT,), "stereo"),
    "lcr": Layout(3, (FRONT | CENTRE,), "left, right, centre"),
    "quad": Layout(4, (FRONT | BACK, FRONT | SIDES), "quad: two in front, two behind"),
    "5.0": Layout(5, (FRONT | CENTRE | SIDES, FRONT | CENTRE | BACK), "5.0"),
    "5.1": Layout(6, (FRONT | CENTRE | LFE | SIDES, FRONT | CENTRE | LFE | BACK), "5.1"),
    "7.1": Layout(8, (FRONT | CENTRE | LFE | BACK | SIDES,), "7.1"),
    "7.1.4": Layout(12, (FRONT | CENTRE | LFE | BACK | SIDES | TOP_CORNERS,), "7.1.4"),
    **{f"ambisonic-{order}": Layout((order + 1) ** 2, (), f"ambisonics of order {order}") for order in (1, 2, 3)},
}


def layouts_of(channels: int, mask: int | None, *, ambisonic: bool = False) -> tuple[str, ...]:
    """Return the names of the layouts that a file's header can mean; empty where it says none of them.

    Parameters
    ----------
    channels : int
        How many there are.
    mask : int or None
        Speaker positions; None and 0 say nothing, which is enough for mono, stereo and ambisonics.
    ambisonic : bool
        Whether the header says so itself.
    """
    if ambisonic:
        return tuple(name for name, layout in LAYOUTS.items() if layout.channels == channels and not layout.masks)
    if channels == 1:
        return ("mono",)
    if not mask:
        if channels == 2:
            return ("stereo",)
        return tuple(name for name, layout in LAYOUTS.items() if layout.channels == channels and not layout.masks)
    return tuple(name for name, layout in LAYOUTS.items() if layout.channels == channels and mask in layout.masks)
