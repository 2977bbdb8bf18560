"""Draw the modules of the server and of the library with their imports: python -m tests.support.architecture FILE.

A module stands above all that it imports. An import that follows from others is left out.
"""

import sys
from pathlib import Path

import grimp

BOX_WIDTH, BOX_HEIGHT, GAP, ROW = 132, 26, 12, 50
WIDTH = 1000
STYLE = """
  text { font: 13px system-ui, sans-serif; text-anchor: middle; fill: #1f2328; }
  rect { fill: #f3f4f6; stroke: #8c959f; }
  path { fill: none; stroke: #57606a; stroke-opacity: 0.45; }
  .title { font-weight: 600; text-anchor: start; }
  @media (prefers-color-scheme: dark) {
    text { fill: #e6edf3; }
    rect { fill: #21262d; stroke: #768390; }
    path { stroke: #adbac7; }
  }
"""
STARTS = {
    "__main__",
    "cli",
    "demo",
    "main",
    "worker",
    "backup",
    "transfers",
    "registry",
    "routers",
    "migrate",
    "row_security",
    "tables",
    "client",
}


def imports_between(package: str) -> dict[str, set[str]]:
    """Return the modules at the top of a package, each with those that it or what it holds imports."""
    graph = grimp.build_graph(package, exclude_type_checking_imports=True, cache_dir=None)
    imports: dict[str, set[str]] = {name: set() for name in names(graph, package)}
    for importer in graph.modules:
        if importer.count("."):
            above = importer.split(".")[1]
            for imported in graph.find_modules_directly_imported_by(importer):
                below = imported.split(".")[1] if imported.count(".") else above
                if below != above and above in imports and below in imports:
                    imports[above].add(below)
    return imports


def names(graph: grimp.ImportGraph, package: str) -> list[str]:
    """Return the modules that are drawn; those that put the server together import all others."""
    children = (child.split(".")[1] for child in graph.find_children(package))
    return sorted(name for name in children if name not in STARTS and not name.startswith("_"))


def heights(imports: dict[str, set[str]]) -> dict[str, int]:
    """Return the row of each module from the bottom: one above the highest that it imports."""
    known: dict[str, int] = {}

    def height(name: str) -> int:
        if name not in known:
            known[name] = 1 + max((height(below) for below in sorted(imports[name])), default=-1)
        return known[name]

    return {name: height(name) for name in sorted(imports)}


def reduced(imports: dict[str, set[str]]) -> dict[str, set[str]]:
    """Return the imports without those that lead through another import."""
    reach: dict[str, set[str]] = {}

    def below(name: str) -> set[str]:
        if name not in reach:
            reach[name] = set(imports[name]).union(*(below(lower) for lower in imports[name]))
        return reach[name]

    return {
        name: {lower for lower in lowers if not any(lower in below(other) for other in lowers - {lower})}
        for name, lowers in imports.items()
    }


def drawing(title: str, package: str, top: int) -> tuple[list[str], int]:
    """Return the lines of one package's picture, and the y below it."""
    imports = imports_between(package)
    rows = heights(imports)
    places: dict[str, tuple[float, float]] = {}
    lines = [f'<text class="title" x="16" y="{top + 20}">{title}</text>']
    for row in range(max(rows.values()), -1, -1):
        here = [name for name in sorted(rows) if rows[name] == row]
        left = (WIDTH - len(here) * BOX_WIDTH - (len(here) - 1) * GAP) / 2
        y = top + 34 + (max(rows.values()) - row) * ROW
        for number, name in enumerate(here):
            places[name] = (left + number * (BOX_WIDTH + GAP) + BOX_WIDTH / 2, y)
    for name, lowers in sorted(reduced(imports).items()):
        for lower in sorted(lowers):
            (x, y), (to_x, to_y) = places[name], places[lower]
            side = 0 if to_y - y == ROW else (90 if to_x >= x else -90)
            start, end = y + BOX_HEIGHT, to_y
            curve = f"{x + side:g} {start + 30:g} {to_x + side:g} {end - 30:g} {to_x:g} {end:g}"
            lines.append(f'<path d="M{x:g} {start:g}C{curve}"/>')
    for name, (x, y) in sorted(places.items()):
        lines.append(f'<rect x="{x - BOX_WIDTH / 2:g}" y="{y:g}" width="{BOX_WIDTH}" height="{BOX_HEIGHT}" rx="4"/>')
        lines.append(f'<text x="{x:g}" y="{y + 18:g}">{name}</text>')
    return lines, top + 34 + (max(rows.values()) + 1) * ROW


def svg() -> str:
    """Return the picture of both packages."""
    server, below = drawing("app: the server", "app", 0)
    library, bottom = drawing("audio_checks: the library", "audio_checks", below)
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {bottom}" role="img"'
        f' aria-label="Modules of the server and of the library, each above what it imports"><style>{STYLE}</style>'
    )
    return "\n".join([head, *server, *library, "</svg>\n"])


def main(path: str) -> None:
    """Write the picture."""
    Path(path).write_text(svg(), encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1])
