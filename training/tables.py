"""Writes the tables of how good judgements are into the page on them."""

from pathlib import Path

DOCUMENT = Path(__file__).parents[1] / "docs" / "judgements.md"


def write_tables(tables: dict[str, str]) -> None:
    """Put each table between its marks."""
    text = DOCUMENT.read_text(encoding="utf-8")
    for name, table in tables.items():
        mark = f"<!-- {name}: made by `make weights` -->\n"
        head, found, rest = text.partition(mark)
        if not found:
            raise ValueError(f"{DOCUMENT} has no place for the table {name}")
        text = f"{head}{mark}{table}\n<!-- end -->{rest.partition('<!-- end -->')[2]}"
    DOCUMENT.write_text(text, encoding="utf-8")


def as_table(tried: dict[str, dict[str, float]], must: dict[str, float]) -> str:
    """Return figures by what they were tried on as Markdown; a must below zero is a most, and one not met is bold."""
    lines = [f"| | must | {' | '.join(tried)} |", f"|---|---|{'---|' * len(tried)}"]
    for row in next(iter(tried.values())):
        wanted = must.get(row)
        cells = []
        for column, figures in tried.items():
            value = figures[row]
            unmet = wanted is not None and (value < wanted if wanted > 0 else value > -wanted)
            cells.append(f"**{value:.3f}**" if unmet and column.startswith("kept apart") else f"{value:.3f}")
        asked = "" if wanted is None else f"≥ {wanted:g}" if wanted > 0 else f"≤ {-wanted:g}"
        lines.append(f"| {row} | {asked} | {' | '.join(cells)} |")
    return "\n".join(lines)
