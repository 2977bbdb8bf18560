"""Draws the picture of a place in a sound: its shape, a play button, and a line at the place."""

import math
from collections.abc import Mapping
from io import BytesIO
from typing import TYPE_CHECKING, Any

from app.notifications.audio_excerpts.rules import HEIGHT_PX, WIDTH_PX

if TYPE_CHECKING:
    from PIL.ImageDraw import ImageDraw

_SCALE = 2  # for dense screens
_WIDTH, _HEIGHT = WIDTH_PX * _SCALE, HEIGHT_PX * _SCALE
_MIDDLE = _HEIGHT / 2
_LEFT, _RIGHT = float(_HEIGHT), _WIDTH - 4.0 * _SCALE  # of the sound, beside its button
_FULL_SCALE = 127  # of a thumb
# Those of the light theme: an email has a background of its own on every screen.
_PAPER, _EDGE, _PEAK, _RMS, _INK, _NOW = "#ffffff", "#dadcd6", "#a3a79f", "#5f645d", "#131514", "#d94b00"


def draw(thumb: Mapping[str, Any], *, duration_s: float, at_s: float | None) -> bytes:
    """Return a PNG of a sound with a play button, given its thumb and the place in seconds."""
    from PIL import Image, ImageDraw  # only the worker that sends such an email loads it

    image = Image.new("RGB", (_WIDTH, _HEIGHT), _PAPER)
    surface = ImageDraw.Draw(image)
    _draw_bars(surface, thumb["min"], thumb["max"], _PEAK)
    _draw_bars(surface, [-value for value in thumb["rms"]], thumb["rms"], _RMS)
    if at_s is not None and duration_s > 0:
        x = _LEFT + (_RIGHT - _LEFT) * min(1.0, at_s / duration_s)
        surface.rectangle((x - _SCALE / 2, 0, x + _SCALE / 2, _HEIGHT), fill=_NOW)
    _draw_button(surface)
    surface.rectangle((0, 0, _WIDTH - 1, _HEIGHT - 1), outline=_EDGE)
    written = BytesIO()
    image.save(written, "PNG", optimize=True)
    return written.getvalue()


def _draw_bars(surface: "ImageDraw", lows: list[int], highs: list[int], colour: str) -> None:
    step = (_RIGHT - _LEFT) / len(highs)
    half = _MIDDLE - 4 * _SCALE
    for at, (low, high) in enumerate(zip(lows, highs, strict=True)):
        top, bottom = _MIDDLE - half * high / _FULL_SCALE, _MIDDLE - half * low / _FULL_SCALE
        x = _LEFT + at * step
        surface.rectangle((x, min(top, _MIDDLE - 1), x + max(1.0, step - 1), max(bottom, _MIDDLE + 1)), fill=colour)


def _draw_button(surface: "ImageDraw") -> None:
    radius = 16 * _SCALE
    surface.ellipse((_MIDDLE - radius, _MIDDLE - radius, _MIDDLE + radius, _MIDDLE + radius), fill=_INK)
    turns = (0.0, 2 * math.pi / 3, 4 * math.pi / 3)  # the directions of the triangle's corners
    corners = [(_MIDDLE + radius / 2 * math.cos(turn), _MIDDLE + radius / 2 * math.sin(turn)) for turn in turns]
    surface.polygon(corners, fill=_PAPER)
