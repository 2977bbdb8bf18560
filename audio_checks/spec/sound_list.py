"""The sound list as a file: read as an import of the server reads it, and written."""

import csv
import io
import re
import unicodedata
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any

from audio_checks.errors import SpecError
from audio_checks.spec.delivery_spec import CueFacts
from audio_checks.spec.game_paths import stem_in_language
from audio_checks.spec.list_cells import CellContext, is_broken_formula, reading_of
from audio_checks.spec.list_columns import guess_column, names_in_row
from audio_checks.spec.list_heads import HEADS, head_of
from audio_checks.spec.list_table import Rows, TableUnreadable, filled, headed, records, rows_without_cue
from audio_checks.spec.sound_names import parse_file_name, stem_of_file, stems_of
from audio_checks.system.text_encoding import TextDamaged, decode_text
from audio_checks.system.text_files import MOST_BYTES, read_bytes

COLUMNS = (
    "number",
    "name",
    "file_name",
    "category",
    "description",
    "use",
    "trigger",
    "duration_s",
    "duration_min_s",
    "duration_max_s",
    "length_locked",
    "frame_rate_fps",
    "loop",
    "reverb",
    "channels",
    "variations",
    "state",
)
LENGTHS = ("duration_s", "duration_min_s", "duration_max_s")
TYPED = frozenset({*LENGTHS, "length_locked", "frame_rate_fps", "loop", "reverb", "channels", "variations", "state"})
_MOST_VARIATIONS = 999


@dataclass(frozen=True)
class SoundList:
    """The cues of a project."""

    cues: tuple[CueFacts, ...]
    notes: tuple[str, ...] = ()  # what was guessed, left out or not read, as sentences

    @cached_property
    def _slots(self) -> dict[str, tuple[CueFacts, int]]:
        slots: dict[str, tuple[CueFacts, int]] = {}
        for cue in sorted(self.cues, key=lambda cue: cue.state == "cut"):  # a stem that a cut cue gave up is free
            for variation, stem in enumerate(stems_of(cue.name, cue.file_name, cue.variations), start=1):
                slots.setdefault(stem, (cue, variation))
        return slots

    def slot(self, stem: str) -> tuple[CueFacts, int] | None:
        """Return the cue and the variation (from 1) that own a stem, exactly after NFC."""
        return self._slots.get(unicodedata.normalize("NFC", stem))

    @cached_property
    def _languages(self) -> dict[str, str]:
        """The languages of the list's lines, by the folders that stand for them."""
        return {cue.language.casefold(): cue.language for cue in self.cues if cue.language}

    def slot_of_file(self, path: str) -> tuple[CueFacts, int] | None:
        """Return the cue and the variation that a file is for, by its name; a name the list has whole comes first.

        In a folder that is called after a language of the list, the file is the line of that language, if there is
        one of its name: see `game_paths`.
        """
        stems = (stem_of_file(path), parse_file_name(path).stem)
        folder = re.split(r"[/\\]", path)[-2:-1]
        language = self._languages.get(folder[0].casefold()) if folder else None
        for stem in stems if language is not None else ():
            slot = self.slot(stem_in_language(language or "", stem))
            if slot is not None and slot[0].language == language:
                return slot
        return self.slot(stems[0]) or self.slot(stems[1])

    def listed_name(self, path: str) -> str:
        """Return the name that the list has for a file: its own, or in a folder of a language that with the language.

        What a spec asks of names it asks of these, which files are delivered under.
        """
        name = re.split(r"[/\\]", path)[-1]
        slot = self.slot_of_file(path)
        if slot is None or slot[0].language is None or self.slot(stem_of_file(name)) == slot:
            return name
        named = stem_in_language(slot[0].language, name)
        return named if self.slot_of_file(named) == slot else name


def read_sound_list(
    source: str | Path, *, frame_rate_fps: float | None = None, sample_rate_hz: float | None = None
) -> SoundList:
    """Return the sound list of a CSV file (a path), or of CSV text (a string), read as an import of the server does.

    Columns are found by their heads in many wordings, in any order, with comma, semicolon, tab or `|` between them;
    one of them must name the cues. Unknown columns are kept in each cue's `more`. What was guessed, left out or not
    read is said in the `notes` of the list.

    Raises
    ------
    SpecError
        The file cannot be read, or rows are wrong; each is named by its row and column.
    """
    where = str(source) if isinstance(source, Path) else "sound list"
    notes: list[str] = []
    text = _text_of(source, where, notes) if isinstance(source, Path) else source.removeprefix("\ufeff")
    rates = CellContext(frame_rate_fps=frame_rate_fps, sample_rate_hz=sample_rate_hz)
    columns, rows = _table(text, where)
    read = _columns(columns, rows, rates, where, notes)
    skipped = {
        passed.row: passed
        for passed in rows_without_cue(rows, columns, {column.place: column.field for column in read if column.field})
    }
    notes += [f'row {passed.row}: "{passed.text[:60]}" is no cue: {passed.why}' for passed in skipped.values()]
    cues: list[CueFacts] = []
    wrong: list[str] = []
    for number, cells in rows:
        if number in skipped:
            continue
        try:
            cues.append(_cue(read, number, cells, notes))
        except ValueError as error:
            wrong.append(f"row {number}: {error}")
    if not wrong:
        wrong = list(_twins(cues))
    if wrong:
        more = f"; and {len(wrong) - 10} more" if len(wrong) > 10 else ""
        raise SpecError("; ".join(wrong[:10]) + more, where=where)
    return SoundList(tuple(cues), tuple(notes))


def write_sound_list(cues: Iterable[CueFacts]) -> str:
    """Return the CSV of a sound list: the known columns first, then every other one that a cue brings."""
    cues = list(cues)
    extra = dict.fromkeys(key for cue in cues for key in cue.more if key not in COLUMNS)
    out = io.StringIO()
    writer = csv.DictWriter(out, [*COLUMNS, *extra], restval="", lineterminator="\n")
    writer.writeheader()
    for cue in cues:
        row = {key: _cell(getattr(cue, key)) for key in COLUMNS if hasattr(cue, key)}
        writer.writerow({**cue.more, **row})
    return out.getvalue()


def _cell(value: object) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return str(int(value)) if value.is_integer() else repr(value)
    return "" if value is None else str(value)


def _text_of(path: Path, where: str, notes: list[str]) -> str:
    data = read_bytes(path)
    if data.startswith((b"PK\x03\x04", b"\xd0\xcf\x11\xe0")):
        raise SpecError("is a workbook, and not CSV; save it as CSV UTF-8", where=where)
    try:
        decoded = decode_text(data)
    except TextDamaged as error:
        row = error.before.count("\n") + 1
        raise SpecError(f"row {row}: {error}; save it as CSV UTF-8", where=where) from None
    if "\0" in decoded.text:
        raise SpecError("is not text: it holds zero bytes; save it as CSV UTF-8", where=where)
    if decoded.is_guess:
        notes.append(f"read as {decoded.encoding}, by its letters; save it as CSV UTF-8 to be sure")
    return decoded.text


def _table(text: str, where: str) -> tuple[tuple[str, ...], Rows]:
    csv.field_size_limit(MOST_BYTES)
    try:
        rows = list(filled(records(text)))
    except TableUnreadable as error:
        raise SpecError(f"is not CSV: {error}", where=where) from None
    if not rows:
        raise SpecError(f"is empty; its first row names the columns: {', '.join(COLUMNS)}", where=where)
    header_row, columns, _, below = headed(rows, must_have_head=True)
    names = [name.strip().lower() for name in rows[[row for row, _ in rows].index(header_row or 1)][1]]
    if twice := sorted({name for name in names if name in HEADS and names.count(name) > 1}):
        raise SpecError(f"names the column {twice[0]} twice", where=where)
    return columns, below


@dataclass(frozen=True)
class _Column:
    """A column and what it is read as; None for one that is kept as it is."""

    place: int
    name: str
    field: str | None
    context: CellContext


def _columns(names: Sequence[str], rows: Rows, rates: CellContext, where: str, notes: list[str]) -> tuple[_Column, ...]:
    has_rate_column = any(head_of(name).field == "frame_rate_fps" for name in names)
    taken: dict[str, str] = {}
    columns = []
    for index, name in enumerate(names):
        guess = guess_column(name, [cells[index] for _, cells in rows], rates, has_rate_column=has_rate_column)
        guess = guess if name.strip().lower() not in HEADS else replace(guess, field=name.strip().lower(), note="")
        field = guess.field
        if field in taken:
            notes.append(f'column "{name}" is not read: {field} is read from "{taken[field]}"')
            field = None
        elif guess.note:
            notes.append(f'column "{name}"{"" if field else " is not read"}: {guess.note}')
        if field:
            taken[field] = name
        columns.append(_Column(index, name, field, guess.context))
    if not {"number", "name", "file_name"} & taken.keys():
        raise SpecError(
            f"no column has numbers, names or file names of cues; found {', '.join(names)[:200]}; "
            f"columns: {', '.join(COLUMNS)}",
            where=where,
        )
    return tuple(columns)


def _cue(columns: Sequence[_Column], row: int, cells: Sequence[str], notes: list[str]) -> CueFacts:
    facts: dict[str, Any] = {}
    more: dict[str, str] = {}
    rate = next((column for column in columns if column.field == "frame_rate_fps" and cells[column.place]), None)
    own_rate = reading_of("frame_rate_fps", cells[rate.place]).value if rate else None
    for column in columns:
        text = cells[column.place]
        if column.field in TYPED:
            context = replace(column.context, frame_rate_fps=own_rate) if own_rate else column.context
            try:
                reading = reading_of(column.field or "", text, context)
            except ValueError as error:
                raise ValueError(f"{column.field}: {error}") from None
            if column.field != "duration_s":
                facts[column.field or ""] = reading.value
            else:
                lengths = zip(LENGTHS, (reading.value, reading.low, reading.high), strict=True)
                facts = dict(lengths) | {name: value for name, value in facts.items() if value is not None}
            if reading.note:
                notes.append(f'row {row}, {column.name}: "{text[:40]}" is read as {reading.value}: {reading.note}')
        elif column.field:
            more[column.field] = text
        else:
            more[column.name.strip().lower()] = text
    names = names_in_row(more.pop("name", ""), more.pop("file_name", ""))
    if names.note:
        notes.append(f"row {row}: {names.note}")
    for field in ("number", "name", "file_name"):
        if is_broken_formula({"name": names.name, "file_name": names.file_name}.get(field, more.get(field, ""))):
            raise ValueError(f"{field}: a broken formula; repair it in the spreadsheet")
    number = more.pop("number", "") or names.name or stem_of_file(names.file_name)
    if not number:
        raise ValueError("number: a cue needs a number or a name")
    variations = facts.pop("variations", 1) if names.variations is None else names.variations
    facts.pop("variations", None)
    if not 1 <= variations <= _MOST_VARIATIONS:
        raise ValueError(f'variations: wanted a whole number from 1 to {_MOST_VARIATIONS}, found "{variations}"')
    if not (facts.get("frame_rate_fps") or 1) > 0:
        raise ValueError("frame_rate_fps: wanted a number above 0")
    return CueFacts(
        number=number,
        name=names.name,
        file_name=names.file_name,
        category=_category_of(more.pop("category", "")),
        variations=variations,
        state=facts.pop("state", None) or "concept",
        more=more,
        says_loop="loop" in facts,
        **facts,
    )


def _category_of(text: str) -> str | None:
    return text.lower().replace(" ", "-") or None  # as the server keeps it: [categories.ui] is meant for "UI" as well


def _twins(cues: Iterable[CueFacts]) -> Iterator[str]:
    owners: dict[str, CueFacts] = {}
    for cue in cues:
        if cue.state == "cut":
            continue
        for stem in stems_of(cue.name, cue.file_name, cue.variations):
            if owners.setdefault(stem, cue) is not cue:
                yield f'cues {owners[stem].number} and {cue.number} both own the file name "{stem}"'
