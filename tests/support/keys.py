"""Write the page of keyboard shortcuts from the frontend's sources: python -m tests.support.keys FILE."""

import re
import sys
from pathlib import Path

SOURCES = Path(__file__).resolve().parents[2] / "frontend" / "src"
SHORTCUT = re.compile(r"""\{\s*keys: '([^']+)',\s*label: (?:'([^']+)'|"([^"]+)")""")
AREAS = {  # by the folder of a source, in the order of the page
    "app/": "Everywhere",
    "features/today/": "Today",
    "features/sound-list/import": "Import",
    "features/sound-list/": "Sounds: the list and its cues",
    "features/brief/": "Brief",
    "features/references/": "References and spotting",
    "features/voice-lines/": "Voice lines",
    "features/adoption/": "Importing existing game audio",
    "features/desk/": "Deliveries: to do",
    "fixing/": "A fix, on the desk and on a version's page",
    "features/take/": "A version",
    "features/review/": "Review",
    "verdicts/": "Review and Today",
    "heard/": "Review and Today",
    "features/shares/": "Playlists and sessions",
    "features/builds/": "Builds and in-game listening",
    "features/hiring/": "Roster, postings and bids",
    "features/contracts/": "Contracts",
    "features/": "Other pages",
}
NAMES = {
    "mod": "Ctrl",
    "shift": "Shift",
    "alt": "Alt",
    "ArrowUp": "↑",
    "ArrowDown": "↓",
    "ArrowLeft": "←",
    "ArrowRight": "→",
}
HEAD = """<!-- Made from the frontend's sources by `make docs`. Change them there. -->

# Keyboard shortcuts

`?` shows all keys of the page that is open, and the switch that turns single keys off. On a Mac, Cmd stands for Ctrl.
This page lists the keys that always have the same name; digits choose among what is shown. `g` and a letter opens an
area: `g t` Today, `g d` Deliveries, `g s` Sounds, `g r` Review, `g g` Game, `g p` People, `g c` Contract & money,
`g e` Settings.
"""


def written(keys: str) -> str:
    """Return a shortcut as keyboards have it: `mod+Enter` is Ctrl Enter."""
    return " ".join(NAMES.get(key, key) for key in re.split(r"[+ ]", keys))


def area_of(path: Path) -> str:
    """Return the heading under which the shortcuts of a source stand."""
    name = path.relative_to(SOURCES).as_posix()
    return next((area for start, area in AREAS.items() if name.startswith(start)), "Other pages")


def page() -> str:
    """Return the page."""
    shortcuts: dict[str, list[tuple[str, str]]] = {area: [] for area in AREAS.values()}
    for path in sorted(SOURCES.rglob("*.ts*")):
        if ".test." not in path.name and "parts" not in path.relative_to(SOURCES).parts:
            for keys, label, quoted in SHORTCUT.findall(path.read_text(encoding="utf-8")):
                row = (written(keys), label or quoted)
                if row not in shortcuts[area_of(path)]:
                    shortcuts[area_of(path)].append(row)
    parts = [HEAD]
    for area, rows in shortcuts.items():
        if rows:
            lines = [f"- `{keys}`: {label[0].lower() + label[1:]}" for keys, label in rows]
            parts.append("\n".join([f"## {area}", "", *lines]) + "\n")
    return "\n".join(parts)


if __name__ == "__main__":
    Path(sys.argv[1]).write_text(page(), encoding="utf-8")
