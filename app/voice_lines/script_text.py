"""Scripts as people send them, in sheets or as text: bytes in, a head and numbered rows of text out.

All of it runs in a child process (`app.core.parsing`). A text is read like Fountain: a scene heading, a name in
capitals with the lines below it, directions in brackets; `[[maya_010]]` beside the name is the id of the line.
"""

import re
from collections.abc import Iterator

from app.sound_lists.sheets.rules import (
    AS_FOUND,
    MAX_BYTES,
    MAX_CHARACTERS,
    MAX_ROWS,
    ParsedSheet,
    Rows,
    SheetOptions,
    decoded,
    no_notes,
    parse_bytes,
    parse_text,
)
from app.voice_lines.errors import ScriptUnreadable
from app.voice_lines.script_columns import script_heads_in

COLUMNS = ("key", "character", "scene", "direction", "text")
MAX_CHARACTER_CHARS = 120
PAUSE = "  "  # a line of two spaces, after which the same person goes on speaking
_BONEYARD = re.compile(r"/\*.*?\*/", re.DOTALL)
_NOTE = re.compile(r"\[\[([^\[\]\n]{0,200})\]\]")
_TITLE_PAGE = re.compile(r"(title|credit|authors?|source|draft date|contact|copyright|notes|revision):", re.IGNORECASE)
_HEADING = re.compile(r"(int|ext|est|int\.?/ext|i/e)[. ]", re.IGNORECASE)
_SCENE_NUMBER = re.compile(r"\s*#[^#\n]{1,20}#$")
_EXTENSION = re.compile(r"\(([^()]{0,60})\)")
_CONTINUED = re.compile(r"cont(inue|['’.]?)d?\.?", re.IGNORECASE)


def read_script_bytes(data: bytes, is_sheet: bool, options: SheetOptions = AS_FOUND) -> ParsedSheet:
    """Return the fields of a sheet of the lines in a CSV or XLSX file, or in the bytes of a text."""
    if is_sheet:
        return parse_bytes(data, script_heads_in, options)
    if len(data) > MAX_BYTES:
        raise ScriptUnreadable(f"a file may have {MAX_BYTES:,} bytes; this one has {len(data):,}")
    if data.startswith((b"PK\x03\x04", b"\xd0\xcf\x11\xe0", b"%PDF-")):
        raise ScriptUnreadable("this is not plain text; save the script as text, or send a sheet as CSV or XLSX")
    text, notes = decoded(data, options.encoding)
    return (*_read_text(text)[:3], notes)


def read_script_text(text: str, is_sheet: bool, is_pasted: bool) -> ParsedSheet:
    """Return the fields of a sheet of the lines in CSV text, in pasted cells, or in a script."""
    return parse_text(text, is_pasted, script_heads_in) if is_sheet else _read_text(text)


def _read_text(text: str) -> ParsedSheet:
    if len(text) > min(MAX_BYTES, MAX_CHARACTERS):
        raise ScriptUnreadable(f"a text may have {MAX_BYTES:,} characters; this one has {len(text):,}")
    if (offset := text.find("\0")) >= 0:
        line = text.count("\n", 0, offset) + 1
        raise ScriptUnreadable(f"line {line}: this is not text: it holds zero bytes; save it as UTF-8")
    rows: Rows = []
    for row in _spoken(_lines_of(text)):
        rows.append(row)
        if len(rows) > MAX_ROWS:
            raise ScriptUnreadable(f"a script may have {MAX_ROWS:,} lines of dialogue; this one has more")
    if not rows:
        raise ScriptUnreadable(
            "no dialogue was found; wanted a name in capitals on a line of its own, with its text on the next line"
        )
    return None, COLUMNS, rows, no_notes()


def _lines_of(text: str) -> list[str]:
    plain = text.removeprefix("\ufeff").replace("\r\n", "\n").replace("\r", "\n")
    plain = _BONEYARD.sub(lambda match: "\n" * match[0].count("\n"), plain)
    lines = [line.strip() or (PAUSE if len(line) > 1 and not line.strip(" ") else "") for line in plain.split("\n")]
    first = next((index for index, line in enumerate(lines) if line.strip()), 0)
    if lines and _TITLE_PAGE.match(lines[first]):
        while first < len(lines) and lines[first].strip():
            lines[first] = ""
            first += 1
    return lines


def _spoken(lines: list[str]) -> Iterator[tuple[int, list[str]]]:
    """Yield the number of each line that names a speaker, with the cells of what is spoken."""
    scene, index = "", 0
    while index < len(lines):
        line = lines[index]
        follows_blank = index == 0 or not lines[index - 1].strip() or _heading_in(lines[index - 1]) is not None
        index += 1
        heading = _heading_in(line) if follows_blank else None
        if heading is not None:
            scene = heading
        elif follows_blank and index < len(lines) and lines[index].strip() and _names_a_speaker(line):
            number, block = index, []
            while index < len(lines) and lines[index] and not _ends_at_pause(lines, index):
                block.append(lines[index])
                index += 1
            yield number, _cells(line, scene, block)


def _ends_at_pause(lines: list[str], index: int) -> bool:
    """Return whether a line of two spaces ends a speech after all: another speaker or a scene comes next."""
    if lines[index] != PAUSE:
        return False
    after = next((at for at in range(index, len(lines)) if lines[at] != PAUSE), len(lines))
    if after == len(lines) or not lines[after]:
        return True
    has_text = after + 1 < len(lines) and bool(lines[after + 1].strip())
    return _heading_in(lines[after]) is not None or (has_text and _names_a_speaker(lines[after]))


def _heading_in(line: str) -> str | None:
    if line.startswith("#"):
        return line.lstrip("#").strip()
    if line.startswith(".") and line[1:2].isalnum():
        return _SCENE_NUMBER.sub("", line[1:].strip())
    return _SCENE_NUMBER.sub("", line) if _HEADING.match(line) else None


def _names_a_speaker(line: str) -> bool:
    name = _EXTENSION.sub("", _NOTE.sub("", line)).strip(" ^")
    if not name or len(name) > MAX_CHARACTER_CHARS or name.startswith((">", "!", "~", "=")):
        return False
    if name.startswith("@"):
        return len(name) > 1
    return any(letter.isalpha() for letter in name) and name == name.upper() and name[-1] not in ":.!?…"


def _cells(line: str, scene: str, block: list[str]) -> list[str]:
    note = _NOTE.search(line)
    rest = _NOTE.sub("", line).strip(" ^")
    directions = [
        extension.strip()
        for extension in _EXTENSION.findall(rest)
        if extension and not _CONTINUED.fullmatch(extension.strip())
    ]
    spoken = []
    for part in (_NOTE.sub("", block_line).strip() for block_line in block):
        if part.startswith("(") and part.endswith(")"):
            directions.append(part[1:-1].strip())
        elif part:
            spoken.append(part.removeprefix("~").strip())
    name = _EXTENSION.sub("", rest).strip(" ^").removeprefix("@").strip()
    return [note[1].strip() if note else "", name, scene, "; ".join(directions), " ".join(spoken)]
