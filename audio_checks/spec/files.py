"""The tables of a delivery spec as its files say them: held to the keys there are, and put on what they extend."""

from pathlib import Path

from audio_checks.errors import SpecError
from audio_checks.spec import keys as spec_keys
from audio_checks.spec.parts import Tables
from audio_checks.system.text_files import read_text, read_toml

MOST_FILES = 20  # that extend one another


def has_spec(path: Path) -> bool:
    """Return whether a pyproject.toml has a table for audio-checks; any other file is a spec by its name."""
    if path.name != "pyproject.toml":
        return True
    tool = read_toml(read_text(path), str(path)).get("tool")
    return isinstance(tool, dict) and "audio-checks" in tool


def load_tables(path: Path, seen: tuple[Path, ...]) -> Tables:
    """Return what a file says, put on what it extends; `seen` are the files that led here.

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
    for place, naming in namings(tables):
        if "ucs_list" in naming:
            naming["ucs_ids"] = _cat_ids(path, naming.pop("ucs_list"), place)
    base = tables.pop("extend", None)
    return tables if base is None else merged(load_tables(path.parent / base, (*seen, real)), tables)


def read_tables(text: str, where: str, *, pyproject: bool = False) -> Tables:
    """Return what a TOML text says; of a pyproject.toml only its table for audio-checks.

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
        raise placed(error, where) from None


def merged(base: Tables, over: Tables) -> Tables:
    """Return the base with every value of `over` put on it: tables key by key, everything else whole."""
    whole = dict(base)
    for key, value in over.items():
        below = whole.get(key)
        whole[key] = merged(below, value) if isinstance(below, dict) and isinstance(value, dict) else value
    return whole


def placed(error: SpecError, where: str, join: str = ": ") -> SpecError:
    """Return the error with its place put behind where the tables came from."""
    return SpecError(error.args[0], where=f"{where}{join}{error.where}" if error.where else where)


def namings(tables: Tables) -> list[tuple[str, Tables]]:
    """Return the tables that say how files are named, each with its place."""
    places = [
        ("naming", tables),
        *((f"categories.{name}.naming", one) for name, one in tables.get("categories", {}).items()),
    ]
    return [(place, one["naming"]) for place, one in places if "naming" in one]


def _cat_ids(spec: Path, named: str, place: str) -> list[str]:
    from audio_checks.spec.ucs import read_cat_ids

    try:
        return read_cat_ids(spec.parent / named)
    except SpecError as error:
        raise SpecError(f"{error.where}: {error.args[0]}", where=f"{spec}: {place}.ucs_list") from None
