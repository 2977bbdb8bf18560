"""Cues with files, and hostile names, for tests of the hand-off."""

import hashlib

from hypothesis import strategies

from app.builds.engine_export.cues import ArchivedFile, ExportedCue

HOSTILE = [
    '"); studio.project.close(); ("',
    "*/ evil() /*",
    "</script>",
    "$(touch /tmp/owned)",
    "a\\",
    "\\N{BULLET} \\x41 \\u0041",
    "{0} %s {name}",
    "tab\there",
    "line\nbreak\r\nmore",
    "\u2028\u2029",
    "'''\"\"\"",
    "../../etc/passwd",
    "=cmd|' /C calc'!A0",
    "Ünïcödé 音 🎧",
    "[resource]\nscript = 1",
    "",
    " . ",
]
names = strategies.sampled_from(HOSTILE) | strategies.text(
    strategies.characters(exclude_categories=["Cs"]), max_size=40
)


def file(path: str, *, seconds: float = 0.5, loop: tuple[int, int] | None = None) -> ArchivedFile:
    sha256 = hashlib.sha256(path.encode()).hexdigest()
    points = (loop,) if loop else ()
    return ArchivedFile(path, sha256, seconds, sample_rate_hz=48_000, loop_points=points)


def cue(number: int, *paths: str, **facts) -> ExportedCue:
    files = tuple(file(path) for path in paths)
    known = {"label": f"SW-{number:03d}", "name": files[0].stem, "title": files[0].stem, "category": "", "loop": False}
    return ExportedCue(**{**known, "notes": "", "files": files, **facts})


LASER = cue(
    1,
    "Assets/weapon/laser_fire_01.wav",
    "Assets/weapon/laser_fire_02.wav",
    name="laser_fire",
    title="Laser fire",
    category="weapon",
    notes="SW-001 Laser fire. Bright, thin.",
)
HUM = cue(
    2,
    "Assets/ambience/hum.wav",
    files=(file("Assets/ambience/hum.wav", seconds=12.0, loop=(4_800, 575_999)),),
    title="Hum",
    category="ambience",
    loop=True,
    notes="SW-002 Hum.",
    event="event:/Ambience/Ship/Hum",
    codec_ratio=10.0,
)
CONFIRM = cue(3, "Assets/ui_confirm.wav", title="UI confirm", event="Play_Confirm")
CUES = [LASER, HUM, CONFIRM]


@strategies.composite
def hostile_cues(draw) -> list[ExportedCue]:
    """Cues whose every text is hostile. Paths are as the list keeps them: no slash or backslash within a name."""
    made = []
    for number in range(1, draw(strategies.integers(1, 4)) + 1):
        stem = draw(names).replace("/", "_").replace("\\", "_").replace("\0", "")
        count = draw(strategies.integers(1, 3))
        paths = [f"Assets/{stem}x{number}_{place}.wav" for place in range(count)]
        texts = {key: draw(names) for key in ("name", "title", "category", "notes", "event", "language")}
        made.append(cue(number, *paths, **texts, loop=draw(strategies.booleans())))
    return made
