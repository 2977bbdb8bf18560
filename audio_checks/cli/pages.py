"""Writes a page for every check, from its docstring: `python -m audio_checks.cli.pages docs/checks`."""

import sys
from pathlib import Path

from audio_checks.checks import Check, all_checks
from audio_checks.spec.check_names import DEFAULT_SEVERITY

_MADE = "<!-- Made from the check's docstring by `make docs`. Change it there. -->\n"


def pages() -> dict[str, str]:
    """Return the text of every page by its file name: one a check, and the index."""
    made = {f"{name}.md": _page(check) for name, check in all_checks().items()}
    return {"README.md": _index(), **made}


def write_pages(folder: str | Path) -> None:
    """Write every page into a folder, and remove the pages of checks that are gone."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    texts_by_page = pages()
    for stale in folder.glob("*.md"):
        if stale.name not in texts_by_page:
            stale.unlink()
    for name, text in texts_by_page.items():
        (folder / name).write_text(text, encoding="utf-8")


def _page(check: Check) -> str:
    parts = check.parts
    return f"""{_MADE}
# {check.name}

{_sentence(parts["summary"])}

By default: {_severity(check.name)}.

## Why

{_sentence(parts["why"])}

## How to fix

{_sentence(parts["how to fix"])}

## Source

{_sentence(parts["source"])}
"""


def _index() -> str:
    here = all_checks()
    rows = [f"| [{name}]({name}.md) | {_severity(name)} | {check.summary} |" for name, check in here.items()]
    later = ", ".join(f"`{name}`" for name in DEFAULT_SEVERITY if name not in here)
    kept = f"\nNames kept for checks to come: {later}.\n" if later else ""
    table = "\n".join(["| check | by default | what holds |", "|---|---|---|", *rows])
    return f"""{_MADE}
# The checks

A check is called only where the spec states what it could hold a file to. `[checks]` in the spec
makes it an error, a warning, or turns it off.

{table}
{kept}"""


def _severity(name: str) -> str:
    return "a warning; an error among renders" if name == "placeholder" else f"{_article(DEFAULT_SEVERITY[name])}"


def _article(noun: str) -> str:
    return f"an {noun}" if noun[0] in "aeiou" else f"a {noun}"


def _sentence(text: str) -> str:
    return text[:1].upper() + text[1:] + ("" if text.endswith(".") else ".")


if __name__ == "__main__":
    write_pages(sys.argv[1])
