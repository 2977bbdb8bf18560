"""Draws how long screens take as projects grow, as an SVG that reads on light and on dark pages."""

import math
from collections.abc import Mapping, Sequence
from pathlib import Path

WIDTH, HEIGHT = 760, 380
LEFT, RIGHT, TOP, BOTTOM = 56, 210, 44, 48
COLOURS = ("#2a6fb0", "#b3541e", "#2f7d4f", "#7b4fa3", "#8a6d0b")  # 4.5:1 or more on white, 3:1 or more on black
LABEL_PX = 15
GRID_MS = (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000)


def draw_growth(
    path: Path, *, title: str, takes: Sequence[int], times_ms: Mapping[str, Sequence[float]], limit_ms: float
) -> None:
    """Write the picture: takes to the right, time upwards, both by powers of ten."""
    every = [one for times in times_ms.values() for one in times] + [limit_ms]
    lowest = max(each for each in GRID_MS if each <= max(min(every), GRID_MS[0]))
    highest = min((each for each in GRID_MS if each >= max(every)), default=GRID_MS[-1])

    def x(count: float) -> float:
        return LEFT + (WIDTH - LEFT - RIGHT) * _share(count, takes[0], takes[-1])

    def y(time_ms: float) -> float:
        return HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * _share(time_ms, lowest, highest)

    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" role="img" aria-label="{title}">',
        "<style>text{font:12px system-ui,sans-serif;fill:#333}.t{font-weight:600}.g{stroke:#8885;fill:none}"
        ".l{stroke:#8a8a8a;stroke-dasharray:5 4}.c{stroke-width:2;fill:none}rect{fill:#fff}"
        "@media(prefers-color-scheme:dark){text{fill:#ddd}rect{fill:#16181c}}</style>",
        f'<rect width="{WIDTH}" height="{HEIGHT}"/><text class="t" x="{LEFT}" y="24">{title}</text>',
    ]
    for each in (each for each in GRID_MS if lowest <= each <= highest):
        lines.append(f'<path class="g" d="M{LEFT} {y(each):.1f}H{WIDTH - RIGHT}"/>')
        lines.append(f'<text x="{LEFT - 8}" y="{y(each) + 4:.1f}" text-anchor="end">{each} ms</text>')
    lines += [
        f'<text x="{x(count):.1f}" y="{HEIGHT - BOTTOM + 18}" text-anchor="middle">{count:,}</text>' for count in takes
    ]
    middle = LEFT + (WIDTH - LEFT - RIGHT) / 2
    lines.append(f'<text x="{middle}" y="{HEIGHT - 10}" text-anchor="middle">takes in the project</text>')
    lines.append(f'<path class="l" d="M{LEFT} {y(limit_ms):.1f}H{WIDTH - RIGHT}"/>')
    places = _apart({name: y(times[-1]) + 4 for name, times in times_ms.items()})
    for (name, times), colour in zip(times_ms.items(), COLOURS, strict=False):
        points = " ".join(f"{x(count):.1f},{y(time):.1f}" for count, time in zip(takes, times, strict=True))
        lines.append(f'<polyline class="c" stroke="{colour}" points="{points}"/>')
        lines.append(f'<text x="{WIDTH - RIGHT + 8}" y="{places[name]:.1f}" style="fill:{colour}">{name}</text>')
    path.write_text("\n".join([*lines, "</svg>\n"]), encoding="utf-8")


def _share(value: float, low: float, high: float) -> float:
    return (math.log(max(value, low)) - math.log(low)) / (math.log(high) - math.log(low))


def _apart(wanted: Mapping[str, float]) -> dict[str, float]:
    """Return where labels stand so that none covers another, from the top down."""
    placed, last = {}, -math.inf
    for name, place in sorted(wanted.items(), key=lambda each: each[1]):
        last = max(place, last + LABEL_PX)
        placed[name] = last
    return placed
