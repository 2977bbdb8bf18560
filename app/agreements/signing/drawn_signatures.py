"""A name drawn beside the typed one: strokes of whole numbers in a fixed box, and the picture made of them."""

import hashlib
import json
from collections.abc import Sequence

from app.agreements.errors import BadDrawing
from app.core.errors import FieldProblem
from app.core.plural import counted

WIDTH, HEIGHT = 1_000, 300  # of the box that coordinates are in; the screen scales its own to it
MAX_STROKES = 100
MAX_POINTS = 3_000  # of all strokes together
MIN_SPAN = 40  # a drawing that is smaller both ways is a slip of the hand

DRAWING = (
    f"The name as it was drawn: strokes of points (x, y) in a box of {WIDTH} by {HEIGHT}, from its upper left; "
    f"at most {MAX_STROKES} strokes and {MAX_POINTS} points."
)

Strokes = Sequence[Sequence[Sequence[int]]]  # each a line through points (x, y)


def ensure_drawing_fits(strokes: Strokes) -> None:
    """Raise BadDrawing, with what was found, unless strokes are a drawing of a name within the limits."""
    points = [point for stroke in strokes for point in stroke]
    if not points or not all(strokes):
        raise _bad("a stroke without a point was sent", "send strokes of one point or more, or no drawing")
    if len(strokes) > MAX_STROKES or len(points) > MAX_POINTS:
        raise _bad(
            f"the drawing has {counted(len(strokes), 'stroke')} and {counted(len(points), 'point')}; "
            f"at most {MAX_STROKES} and {MAX_POINTS:,} are kept",
            "clear it and draw the name in fewer strokes",
        )
    if any(len(point) != 2 or not (0 <= point[0] <= WIDTH and 0 <= point[1] <= HEIGHT) for point in points):
        raise _bad(
            f"a point of the drawing is outside of its box of {WIDTH} by {HEIGHT}",
            "clear it and draw inside of the field",
        )
    spans = [max(point[axis] for point in points) - min(point[axis] for point in points) for axis in (0, 1)]
    if max(spans) < MIN_SPAN:
        raise _bad("the drawing is too small to be a name", "clear it and draw your name larger, or leave it out")


def _bad(message: str, fix: str) -> BadDrawing:
    return BadDrawing(message, fix=fix, errors=[FieldProblem(where="drawing", message=message)])


def drawing_sha256(strokes: Strokes | None) -> str:
    """Return the hash by which the record knows a drawing; empty where none was made."""
    if strokes is None:
        return ""
    written = json.dumps([[list(point) for point in stroke] for stroke in strokes], separators=(",", ":"))
    return hashlib.sha256(written.encode()).hexdigest()


def drawing_svg(strokes: Strokes) -> str:
    """Return a drawing as SVG that is made of its numbers alone."""
    lines = "".join(_path(stroke) for stroke in strokes)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" viewBox="0 0 {WIDTH} {HEIGHT}">'
        '<g fill="none" stroke="#000000" stroke-width="6" stroke-linecap="round" stroke-linejoin="round">'
        f"{lines}</g></svg>"
    )


def _path(stroke: Sequence[Sequence[int]]) -> str:
    points = [f"{int(x)} {int(y)}" for x, y in stroke]
    if len(points) == 1:
        points *= 2  # a line to itself is a dot, by its round ends
    return f'<path d="M {" L ".join(points)}"/>'
