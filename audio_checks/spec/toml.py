"""Writes the tables of a spec as TOML."""

import json
import re
from collections.abc import Iterator, Mapping
from typing import Any

_INLINE = {"duration_s", "loudness_lufs"}
_BARE = re.compile(r"[A-Za-z0-9_-]+")


def to_toml(tables: Mapping[str, Any]) -> str:
    """Return TOML that reads back to the same tables."""
    return re.sub("\n{3,}", "\n\n", "\n".join(_lines(tables, ""))).strip("\n") + "\n"


def _lines(tables: Mapping[str, Any], path: str) -> Iterator[str]:
    inner = {}
    for key, value in tables.items():
        if isinstance(value, dict) and key not in _INLINE:
            inner[key] = value
        else:
            yield f"{_key(key)} = {_value(value)}"
    for key, table in inner.items():
        below = f"{path}.{_key(key)}" if path else _key(key)
        yield ""
        if not table or any(not isinstance(value, dict) or name in _INLINE for name, value in table.items()):
            yield f"[{below}]"
        yield from _lines(table, below)


def _key(key: str) -> str:
    return key if _BARE.fullmatch(key) else _text(key)


def _value(value: object) -> str:
    if isinstance(value, dict):
        return (
            "{ " + ", ".join(f"{_key(key)} = {_value(member)}" for key, member in value.items()) + " }"
            if value
            else "{}"
        )
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, list):
        return "[" + ", ".join(_value(element) for element in value) + "]"
    if isinstance(value, str):
        return f"'{value}'" if "\\" in value and "'" not in value and value.isprintable() else _text(value)
    return repr(value)


def _text(text: str) -> str:
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")
