"""The words that names are made of: of the API, the commands, classes, columns, metrics, settings and the frontend."""

import argparse
import ast
import json
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import typer.main
from typer.core import TyperGroup

from app import tables  # noqa: F401  the models of all rooms
from app.cli import cli
from app.kit.db import Base
from app.settings import Settings
from audio_checks.cli import parser_of

ROOT = Path(__file__).resolve().parents[2]
METRICS = {"Counter", "Gauge", "Histogram", "CounterMetricFamily", "GaugeMetricFamily"}
IRREGULAR = {"people": "person", "spectra": "spectrum"}
LEAST_BASE = 2  # letters that are left of a word without its ending
Name = tuple[str, str]  # and where it stands


def words_of(name: str) -> list[str]:
    """Return the words of a name, without single letters: those of `TakeRead` and `take-read` are "take" and "read"."""
    words = re.findall(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+", name)
    return [word.lower() for word in words if len(word) > 1]


def bases_of(word: str) -> set[str]:
    """Return a word with what it may be an inflection of: "planned" is also "plan", "planne" and "plann"."""
    bases = {word, IRREGULAR.get(word, word)}
    if word.endswith(("ies", "ied")):
        bases.add(f"{word[:-3]}y")
    for ending in ("s", "es", "ed", "ing"):
        base = word.removesuffix(ending)
        if base == word or len(base) < LEAST_BASE or word.endswith("ss"):
            continue
        bases.add(base)
        if ending in ("ed", "ing"):
            bases |= {f"{base}e", base[:-1] if base[-1] == base[-2] else base}
    return bases


def is_among(word: str, known: set[str]) -> bool:
    """Whether a word, or the one that "un" negates, is an inflection of a known one."""
    return any(bases_of(one) & known for one in (word, word.removeprefix("un")))


@cache
def words_in_use() -> dict[str, str]:
    """Return each word with the first place where it stands."""
    sources = (names_of_api(), names_of_commands(), names_of_classes(), names_of_columns(), names_of_metrics(),
               names_of_settings(), names_of_frontend())  # fmt: skip
    return words_with_places(name for source in sources for name in source)


def words_with_places(names: Iterator[Name]) -> dict[str, str]:
    """Return the words of names, each with the first place where it stands."""
    places: dict[str, str] = {}
    for name, place in names:
        for word in words_of(name):
            places.setdefault(word, place)
    return places


def names_of_api(document: dict[str, Any] | None = None) -> Iterator[Name]:
    """Yield path segments, parameters, schemas, properties and values of enums."""
    document = document or json.loads((ROOT / "frontend" / "openapi.json").read_text())
    for path, methods in document["paths"].items():
        yield path, f"path {path}"
        for method in methods.values():
            for parameter in method.get("parameters", []):
                yield parameter["name"], f"parameter {parameter['name']} of {path}"
        yield from _names_of_schema(methods, path)
    for name, schema in document["components"]["schemas"].items():
        yield name, f"schema {name}"
        yield from _names_of_schema(schema, f"schema {name}")


def _names_of_schema(part: Any, place: str) -> Iterator[Name]:
    if isinstance(part, list):
        for one in part:
            yield from _names_of_schema(one, place)
    if not isinstance(part, dict):
        return
    properties = part.get("properties")
    for name in properties if isinstance(properties, dict) else ():
        yield name, f"property {name} of {place}"
    values = part.get("enum", [part.get("const")])
    for value in values if isinstance(values, list) else ():
        if isinstance(value, str):
            yield value, f"value {value} in {place}"
    for key, inner in part.items():
        if key not in ("example", "examples", "default"):
            yield from _names_of_schema(inner, place)


def names_of_commands() -> Iterator[Name]:
    """Yield commands, arguments, options and choices of `audio-checks` and `soundlist`."""
    yield from _names_of_parser(parser_of(), "audio-checks")
    yield from _names_of_command(typer.main.get_group(cli), "soundlist")


def _names_of_parser(parser: argparse.ArgumentParser, place: str) -> Iterator[Name]:
    for action in parser._actions:
        names = action.option_strings or [action.dest]
        yield from ((name, f"{place} {name}") for name in names if name != argparse.SUPPRESS)
        if isinstance(action, argparse._SubParsersAction):
            for name, inner in action.choices.items():
                yield name, f"{place} {name}"
                yield from _names_of_parser(inner, f"{place} {name}")
        else:
            yield from ((str(choice), f"choice {choice} of {place}") for choice in action.choices or ())


def _names_of_command(command: Any, place: str) -> Iterator[Name]:
    for parameter in command.params:
        yield from ((name, f"{place} {name}") for name in (parameter.name or "", *parameter.opts))
    for name, inner in command.commands.items() if isinstance(command, TyperGroup) else ():
        yield name, f"{place} {name}"
        yield from _names_of_command(inner, f"{place} {name}")


def _modules() -> Iterator[tuple[str, ast.Module]]:
    for path in sorted(path for package in ("app", "audio_checks") for path in (ROOT / package).rglob("*.py")):
        yield str(path.relative_to(ROOT)), ast.parse(path.read_text(encoding="utf-8"))


def names_of_classes() -> Iterator[Name]:
    """Yield public classes."""
    for path, module in _modules():
        for node in module.body:
            if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
                yield node.name, f"class {node.name} in {path}"


def names_of_metrics() -> Iterator[Name]:
    """Yield metrics with their labels."""
    for path, module in _modules():
        for call in (node for node in ast.walk(module) if isinstance(node, ast.Call)):
            if isinstance(call.func, ast.Name) and call.func.id in METRICS:
                texts = [one for part in (*call.args, *call.keywords) for one in ast.walk(part)]
                names = [one.value for one in texts if isinstance(one, ast.Constant) and isinstance(one.value, str)]
                yield from ((name, f"metric {names[0]} in {path}") for name in names if re.fullmatch(r"[a-z_]+", name))


def names_of_columns() -> Iterator[Name]:
    """Yield tables and their columns."""
    for table in Base.metadata.tables.values():
        yield from (
            (f"{table.name}.{column.name}", f"column {column.name} of {table.name}") for column in table.columns
        )


def names_of_settings() -> Iterator[Name]:
    """Yield what an operator may set."""
    yield from ((name, f"setting {name}") for name in Settings.model_fields)


def names_of_frontend() -> Iterator[Name]:
    """Yield features and the addresses of their pages."""
    features = ROOT / "frontend" / "src" / "features"
    yield from ((path.name, f"feature {path.name}") for path in sorted(features.iterdir()))
    for path in sorted(features.rglob("*.tsx")):
        source = path.read_text(encoding="utf-8")
        if "createRoute(" in source:
            yield from ((address, f"page {address}") for address in re.findall(r"path: '([^']+)'", source))
