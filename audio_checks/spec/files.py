"""The tables of a delivery spec as its files say them: held to the keys there are, and put on what they extend."""

import re
from pathlib import Path

from audio_checks.errors import SpecError, SpecErrors
from audio_checks.spec import keys as spec_keys
from audio_checks.spec.parts import Tables
from audio_checks.system.text_files import read_text, read_toml

MOST_FILES = 20  # that extend one another
_NAMES = r"""(?:[A-Za-z0-9_-]+|"[^"\n]*"|'[^'\n]*')(?:[ \t]*\.[ \t]*(?:[A-Za-z0-9_-]+|"[^"\n]*"|'[^'\n]*'))*"""
_HEADER = re.compile(rf"[ \t]*\[\[?[ \t]*({_NAMES})[ \t]*\]")
_KEY = re.compile(rf"[ \t]*({_NAMES})[ \t]*=")
_NAME_PART = re.compile(r"""["']([^"'\n]*)["']|([A-Za-z0-9_-]+)""")


def has_spec(path: Path) -> bool:
    """Return whether a pyproject.toml has a table for audio-checks; any other file is a spec by its name."""
    if path.name != "pyproject.toml":
        return True
    tool = read_toml(read_text(path), str(path)).get("tool")
    return isinstance(tool, dict) and "audio-checks" in tool


def load_tables(path: Path, seen: tuple[Path, ...]) -> Tables:
    """Return a file's tables, put on those that it extends; `seen` are the files that led here.

    Raises
    ------
    SpecError
        A file cannot be read or is not a spec, or one extends itself.
    """
    real = path.resolve()
    if real in seen:
        raise SpecError("extends itself in a circle", where=str(path))
    if len(seen) >= MOST_FILES:
        raise SpecError(f"extends more than {MOST_FILES} files, one after the other", where=str(path))
    tables = read_tables(read_text(path), str(path), pyproject=path.name == "pyproject.toml")
    for naming_path, naming in namings(tables):
        if "ucs_list" in naming:
            naming["ucs_ids"] = _cat_ids(path, naming.pop("ucs_list"), naming_path)
    base = tables.pop("extend", None)
    return tables if base is None else merged(load_tables(path.parent / base, (*seen, real)), tables)


def read_tables(text: str, where: str, *, pyproject: bool = False) -> Tables:
    """Return the tables of a TOML text; of a pyproject.toml only its table for audio-checks.

    Raises
    ------
    SpecError
        The text is not TOML, or has keys or values that no spec has.
    """
    document = read_toml(text, where)
    if pyproject:
        tool = document.get("tool")
        document = tool.get("audio-checks", {}) if isinstance(tool, dict) else {}
    try:
        return dict(spec_keys.SPEC.read(document, ""))
    except SpecError as error:
        raise placed(with_lines(error, text, inside="tool.audio-checks" if pyproject else ""), where) from None


def merged(base: Tables, over: Tables) -> Tables:
    """Return the base with every value of `over` put on it: tables key by key, everything else whole."""
    whole = dict(base)
    for key, value in over.items():
        below = whole.get(key)
        whole[key] = merged(below, value) if isinstance(below, dict) and isinstance(value, dict) else value
    return whole


def with_lines(error: SpecError, text: str, *, inside: str = "") -> SpecError:
    """Return the error with the line of its place in a TOML text, where it has one.

    `inside` is the table of the text that the places are in.
    """
    if isinstance(error, SpecErrors):
        return SpecErrors([with_lines(inner_error, text, inside=inside) for inner_error in error.errors])
    lines = _lines_of_keys(text)
    key_path = ".".join(part for part in (inside, re.sub(r"\[\d+\]", "", error.where)) if part)
    while key_path and key_path not in lines:
        key_path = key_path.rpartition(".")[0]
    if not key_path or key_path == inside:
        return error
    return SpecError(f"{error.args[0]} (line {lines[key_path]})", where=error.where)


def _lines_of_keys(text: str) -> dict[str, int]:
    """Return the line that each table and key of a TOML text is first named in."""
    lines: dict[str, int] = {}
    table, quote = "", ""
    for number, line in enumerate(text.splitlines(), start=1):
        if quote:  # in a text of several lines
            quote = "" if quote in line else quote
            continue
        if header := _HEADER.match(line):
            table = _dotted(header[1])
            lines.setdefault(table, number)
        elif key := _KEY.match(line):
            lines.setdefault(f"{table}.{_dotted(key[1])}" if table else _dotted(key[1]), number)
            quote = next((mark for mark in ('"""', "'''") if line.count(mark) == 1), "")
    return lines


def _dotted(name: str) -> str:
    return ".".join(quoted or plain for quoted, plain in _NAME_PART.findall(name))


def placed(error: SpecError, where: str, join: str = ": ") -> SpecError:
    """Return the error with its place put behind where the tables came from."""
    if isinstance(error, SpecErrors):
        return SpecErrors([placed(inner_error, where, join) for inner_error in error.errors])
    return SpecError(error.args[0], where=f"{where}{join}{error.where}" if error.where else where)


def namings(tables: Tables) -> list[tuple[str, Tables]]:
    """Return the tables that say how files are named, each with its place."""
    places = [
        ("naming", tables),
        *((f"categories.{name}.naming", category) for name, category in tables.get("categories", {}).items()),
    ]
    return [(path, table["naming"]) for path, table in places if "naming" in table]


def _cat_ids(spec: Path, named: str, naming_path: str) -> list[str]:
    from audio_checks.spec.ucs import read_cat_ids

    try:
        return read_cat_ids(spec.parent / named)
    except SpecError as error:
        raise SpecError(f"{error.where}: {error.args[0]}", where=f"{spec}: {naming_path}.ucs_list") from None
