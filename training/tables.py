"""Writes the tables of how good judgements are into the page on them and the page on how they were made."""

from pathlib import Path

DOCUMENTS = Path(__file__).parents[1] / "docs" / "reference" / "judgements.md", Path(__file__).with_name("README.md")


def write_tables(tables: dict[str, str]) -> None:
    """Put each table between its marks."""
    for name, table in tables.items():
        mark = f"<!-- {name}: made by `make weights` -->\n"
        document = next((one for one in DOCUMENTS if mark in one.read_text(encoding="utf-8")), None)
        if document is None:
            raise ValueError(f"no page has a place for the table {name}")
        head, _, rest = document.read_text(encoding="utf-8").partition(mark)
        document.write_text(f"{head}{mark}{table}\n<!-- end -->{rest.partition('<!-- end -->')[2]}", encoding="utf-8")


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
