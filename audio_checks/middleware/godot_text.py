"""The text that Godot writes for scenes and resources: sections with a header, and values that may span lines."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field

from audio_checks.middleware.reading import NotRead

MOST_SECTIONS = 1_000_000
LONGEST_VALUE = 65_536  # of a value that is kept
_HEADER = re.compile(
    r'([A-Za-z_][\w-]{0,63})\s?=\s?("(?:[^"\\]++|\\.)*+"|[A-Za-z]{1,32}\(\s?[^()]{0,256}\)|[^\s\]]{1,256})'
)
_REFERENCE = re.compile(r'\s{0,8}(ExtResource|SubResource)\(\s{0,8}"?([\w:./-]{1,128})"?\s{0,8}\)')
_STRING_END = re.compile(r'(?:[^"\\]++|\\.)*+"')
_STRUCTURE = re.compile(r'"(?:[^"\\]++|\\.)*+"|"|[\[\]{}()]', re.DOTALL)


@dataclass(slots=True)
class Section:
    """A section: the word and the keys of its header, its values as they are written, and its first line."""

    kind: str
    header: dict[str, str]
    line: str
    properties: dict[str, str] = field(default_factory=dict)


def sections(text: str) -> Iterator[Section]:
    """Yield the sections of a text, in order; NotRead where it is no such text."""
    section: Section | None = None
    count, open_, in_string = 0, 0, False
    key, kept = "", ""
    for number, line in enumerate(text.split("\n"), start=1):
        if open_ or in_string:  # of a value that spans lines
            open_, in_string = _structure(line, open_, in_string)
            if len(kept) < LONGEST_VALUE:
                kept += "\n" + line
            if section is not None and not (open_ or in_string):
                section.properties[key] = kept[:LONGEST_VALUE]
            continue
        if line.startswith("["):
            if section is not None:
                yield section
            count += 1
            if count > MOST_SECTIONS:
                raise NotRead(f"has more than {MOST_SECTIONS:,} sections", number)
            kind = re.match(r"\[\s?(\w{1,64})", line)
            if kind is None:
                raise NotRead("a section has no name; wanted one such as [node]", number)
            head = line[:16_384]
            section = Section(
                kind[1], {match[1]: match[2] for match in _HEADER.finditer(head, kind.end())}, line[:1_024]
            )
        elif section is not None and "=" in line[:1_024]:
            name, _, value = line.partition("=")
            key, kept = name.strip(), value.strip()
            open_, in_string = _structure(value, 0, False)
            if not (open_ or in_string):
                section.properties[key] = kept[:LONGEST_VALUE]
    if section is None:
        raise NotRead("has no sections; wanted a scene or a resource as Godot writes it", 1)
    yield section


def _structure(line: str, open_: int, in_string: bool) -> tuple[int, bool]:
    """Return the number of brackets open after a line, and whether it ends within a string."""
    if in_string:
        end = _STRING_END.match(line)
        if end is None:
            return open_, True
        line = line[end.end() :]
    for match in _STRUCTURE.finditer(line):
        mark = match[0]
        if mark == '"':
            return open_, True
        if mark in "[{(":
            open_ += 1
        elif mark in "]})":
            open_ = max(0, open_ - 1)
    return open_, False


def text_of(value: str) -> str:
    """Return a text without its quotes."""
    value = value.strip()
    if len(value) >= 2 and value[0] == value[-1] == '"':
        return value[1:-1].replace('\\"', '"')
    return value


def reference(value: str) -> tuple[str, str]:
    """Return the kind and the id of a reference such as ExtResource("1_a"); empty where it is none."""
    match = _REFERENCE.match(value)
    return (match[1], match[2]) if match is not None else ("", "")
