"""Rows of a sheet of voice lines, read by their columns: without a database."""

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from app.sound_lists.rules import MAX_VARIATIONS, folded, tidy_line, tidy_text, typed_text
from app.sound_lists.sheets.rules import Sheet
from app.voice_lines.errors import ScriptUnreadable, SpeakerMissing
from app.voice_lines.rules import (
    MAX_DIRECTION_CHARS,
    MAX_FILES_CHARS,
    MAX_KEY_CHARS,
    MAX_LANGUAGES,
    MAX_NAME_CHARS,
    MAX_SCENE_CHARS,
    MAX_TEXT_CHARS,
    key_for,
    language_tag,
)
from app.voice_lines.script_columns import ScriptField, meaning_of
from audio_checks import names_in_row, stems_of

LONGEST: Mapping[str, int] = {
    ScriptField.KEY: MAX_KEY_CHARS,
    ScriptField.CHARACTER: MAX_NAME_CHARS,
    ScriptField.SCENE: MAX_SCENE_CHARS,
    ScriptField.DIRECTION: MAX_DIRECTION_CHARS,
    ScriptField.FILE_NAME: MAX_FILES_CHARS,
    ScriptField.VARIATIONS: MAX_KEY_CHARS,
}
ONE_LINE = LONGEST.keys() - {ScriptField.FILE_NAME}  # a cell may name each file of a line on a line of its own
NO_CHARACTERS = frozenset({"vo", "dx", "dlg", "dia", "line", "dialog", "dialogue"})  # before the name, in ids of lines
WHO_SPEAKS = (
    "map a column to the character, name one speaker for all lines, or say that line ids begin with the speaker"
)
Words = tuple[str, str, str]  # folded character, scene and text in the language of the script


@dataclass(frozen=True)
class Column:
    """A column of the sheet and what it is read as: a field of a line, a language, or `ignore`."""

    place: int
    name: str
    meaning: str


@dataclass(frozen=True)
class RowFault:
    """The error in one row."""

    row: int
    field: str | None
    message: str


@dataclass(frozen=True)
class SpokenRow:
    """One row of a script; None for what the script has no column for."""

    row: int
    key: str
    character: str
    scene: str | None
    direction: str | None
    file_name: str
    variations: int | None  # numbered files of the line
    texts: dict[str, str]  # by language


@dataclass(frozen=True)
class KnownLines:
    """Look-ups of the lines that the project has: their names by folded id, and their ids by their words."""

    file_names: Mapping[str, str] = field(default_factory=dict)
    by_words: Mapping[Words, Sequence[str]] = field(default_factory=dict)


@dataclass(frozen=True)
class Speaker:
    """Who speaks a line that names no one: one person, or whoever its id begins with."""

    name: str = ""
    is_in_key: bool = False

    def of(self, key: str) -> str:
        """Return the character of a line by its id; empty where neither says one."""
        if not self.is_in_key:
            return self.name
        words = [word for word in re.split(r"[\W\d_]+", key) if word and word.casefold() not in NO_CHARACTERS]
        return words[0] if words else self.name


UNNAMED = Speaker()


def columns_of(
    sheet: Sheet,
    language: str,
    mapping: Mapping[str, str],
    languages: Collection[str] = (),
    speaker: Speaker = UNNAMED,
) -> list[Column]:
    """Return the reading of each column; raise ScriptUnreadable for an impossible mapping.

    `languages` are those that the project has: a column that is called like one of them is one, however rare.
    """
    if unknown := [name for name in mapping if name not in sheet.columns]:
        raise ScriptUnreadable(f'the sheet has no column "{unknown[0]}"; it has {", ".join(sheet.columns)}')
    taken: dict[str, str] = {}
    for name, meaning in mapping.items():
        _take(taken, _in_language(_mapped(name, meaning), language), name)
    columns = []
    for index, name in enumerate(sheet.columns):
        if name in mapping:
            meaning = _in_language(_mapped(name, mapping[name]), language)
        elif name in sheet.notes["hidden_columns"]:
            meaning = ScriptField.IGNORE
        else:
            own_language = name if name in languages else None
            meaning = _in_language(own_language or meaning_of(name) or ScriptField.IGNORE, language)
            if meaning in taken:
                meaning = ScriptField.IGNORE
            _take(taken, meaning, name)
        columns.append(Column(index, name, str(meaning)))
    spoken = [column.meaning for column in columns if column.meaning not in set(ScriptField)]
    if len(spoken) > MAX_LANGUAGES:
        raise ScriptUnreadable(f"a script may have {MAX_LANGUAGES} languages; this one has {len(spoken)}")
    if not spoken:
        raise ScriptUnreadable(f"no column has the text, as in Text or {language}; {_heads(sheet)}")
    if ScriptField.CHARACTER not in taken and not speaker.name:
        if not speaker.is_in_key:
            raise SpeakerMissing(f"no column has the characters; {_heads(sheet)}", fix=WHO_SPEAKS)
        if ScriptField.KEY not in taken:
            raise SpeakerMissing(
                f"no column has the ids that begin with the characters; {_heads(sheet)}", fix=WHO_SPEAKS
            )
    return columns


def _heads(sheet: Sheet) -> str:
    return f"the columns are {', '.join(sheet.columns)}"


def _mapped(name: str, meaning: str) -> str:
    if meaning in set(ScriptField):
        return meaning
    tag = language_tag(meaning)
    if tag is None:
        raise ScriptUnreadable(
            f'"{name}" is mapped to "{meaning}"; wanted {", ".join(ScriptField)} or a language such as de or pt-BR'
        )
    return tag


def _in_language(meaning: str, language: str) -> str:
    return language if meaning == ScriptField.TEXT else meaning


def _take(taken: dict[str, str], meaning: str, name: str) -> None:
    if meaning != ScriptField.IGNORE and taken.setdefault(meaning, name) != name:
        raise ScriptUnreadable(f"two columns are mapped to {meaning}: {taken[meaning]}, {name}")


def spoken_rows(
    sheet: Sheet,
    columns: Sequence[Column],
    known_lines: KnownLines,
    language: str,
    speaker: Speaker = UNNAMED,
) -> tuple[list[SpokenRow], list[RowFault]]:
    """Return the rows that can be read, and what is wrong with the others."""
    faults = [] if sheet.rows else [RowFault(sheet.header_row or 1, None, "there are no rows below the header")]
    keys = _Keys(known_lines, language)
    rows: list[SpokenRow] = []
    scene = ""
    cells_of = [(row, _cells(columns, cells)) for row, cells in sheet.rows]
    keys.reserve(given[ScriptField.KEY] for _, given in cells_of if given.get(ScriptField.KEY))
    for row, given in cells_of:
        # A scene is written once, in a merged cell or before its first line, and holds until the next.
        scene = given.get(ScriptField.SCENE) or scene
        given[ScriptField.CHARACTER] = given.get(ScriptField.CHARACTER) or speaker.of(given.get(ScriptField.KEY, ""))
        faults_of_row = [*_faults_of(row, given), *_faults_of_files(row, given)]
        if not faults_of_row:
            spoken = keys.spoken_row(row, given, scene or None)
            faults_of_row = list(keys.faults_of(spoken))
            if not faults_of_row:
                rows.append(spoken)
        faults += faults_of_row
    return rows, faults


def _cells(columns: Sequence[Column], cells: Sequence[str]) -> dict[str, str]:
    given = {}
    for column in columns:
        if column.meaning != ScriptField.IGNORE:
            text = typed_text(cells[column.place])
            given[column.meaning] = tidy_line(text) if column.meaning in ONE_LINE else tidy_text(text)
    return given


def _faults_of(row: int, given: Mapping[str, str]) -> Iterator[RowFault]:
    if not given[ScriptField.CHARACTER]:
        yield RowFault(row, ScriptField.CHARACTER, "no character; wanted the name of the one who speaks")
    if not any(text for meaning, text in given.items() if meaning not in LONGEST):
        yield RowFault(row, None, "no text in any language; wanted what is spoken")
    for meaning, text in given.items():
        longest = LONGEST.get(meaning, MAX_TEXT_CHARS)
        if len(text) > longest:
            yield RowFault(row, meaning, f"{len(text):,} characters; at most {longest:,} are kept")


def _faults_of_files(row: int, given: dict[str, str]) -> Iterator[RowFault]:
    """Yield the errors in the files of a row, and put the name and number of a numbered set in their place."""
    count = given.get(ScriptField.VARIATIONS, "")
    if count and not (count.isdecimal() and 1 <= int(count) <= MAX_VARIATIONS):
        message = f'{MAX_VARIATIONS} files are the most of a line, in whole numbers from 1; found "{count[:40]}"'
        yield RowFault(row, ScriptField.VARIATIONS, message)
        return
    files = _with_endings(given.get(ScriptField.FILE_NAME, ""))
    try:
        named = names_in_row("", files)
    except ValueError as error:
        yield RowFault(row, ScriptField.FILE_NAME, str(error))
        return
    given[ScriptField.FILE_NAME] = next(iter(stems_of("", named.file_name if named.variations else files)), "")
    if len(given[ScriptField.FILE_NAME]) > MAX_KEY_CHARS:
        message = f"{len(given[ScriptField.FILE_NAME]):,} characters; at most {MAX_KEY_CHARS} are kept"
        yield RowFault(row, ScriptField.FILE_NAME, message)
    if named.variations is not None:
        if count and int(count) != named.variations:
            message = f"{named.variations} files are named, and {count} are wanted beside; make them one number"
            yield RowFault(row, ScriptField.FILE_NAME, message)
        given[ScriptField.VARIATIONS] = str(named.variations)


def _with_endings(files: str) -> str:
    """Return the names in a cell of files; where none of several has an ending, each gets one, to tell them apart."""
    names = [name.strip() for name in re.split(r"[,;|\n]", files) if name.strip()]
    return ", ".join(f"{name}.wav" for name in names) if len(names) > 1 and "." not in files else files


class _Keys:
    """The ids of lines: given, found by their words, or new."""

    def __init__(self, known_lines: KnownLines, language: str) -> None:
        self._known = known_lines
        self._language = language
        self._taken = set(known_lines.file_names)
        self._rows: dict[str, int] = {}
        self._found: dict[Words, int] = {}
        self._counts: dict[str, int] = {}

    def reserve(self, given: Iterator[str]) -> None:
        """Keep the ids of the script from being given to lines that have none."""
        self._taken.update(map(folded, given))

    def spoken_row(self, row: int, given: Mapping[str, str], scene: str | None) -> SpokenRow:
        """Return a row with its id."""
        character = given[ScriptField.CHARACTER]
        texts = {meaning: text for meaning, text in given.items() if meaning not in LONGEST and text}
        key = given.get(ScriptField.KEY) or self._by_words(character, scene, texts) or self._new(character)
        return SpokenRow(
            row=row,
            key=key,
            character=character,
            scene=scene,
            direction=given.get(ScriptField.DIRECTION),
            file_name=given.get(ScriptField.FILE_NAME) or self._known.file_names.get(folded(key)) or key,
            variations=int(given.get(ScriptField.VARIATIONS) or 0) or None,
            texts=texts,
        )

    def faults_of(self, spoken: SpokenRow) -> Iterator[RowFault]:
        """Yield the faults of a row's id."""
        key = folded(spoken.key)
        if self._rows.setdefault(key, spoken.row) != spoken.row:
            yield RowFault(spoken.row, ScriptField.KEY, f'row {self._rows[key]} has the id "{spoken.key}" already')
        name = self._known.file_names.get(key)
        if name is not None and name != spoken.file_name:
            yield RowFault(
                spoken.row,
                ScriptField.FILE_NAME,
                f'the file of "{spoken.key}" is called "{name}", found "{spoken.file_name}"; '
                "leave the name as it is, or give the line another id",
            )

    def _by_words(self, character: str, scene: str | None, texts: Mapping[str, str]) -> str | None:
        words = (folded(character), scene or "", texts.get(self._language, ""))
        keys = self._known.by_words.get(words, ())
        occurrence = self._found.get(words, 0)  # the same words may be spoken twice in a scene
        self._found[words] = occurrence + 1
        return keys[occurrence] if occurrence < len(keys) else None

    def _new(self, character: str) -> str:
        slug = folded(character)
        while True:
            self._counts[slug] = self._counts.get(slug, 0) + 1
            key = key_for(character, self._counts[slug])
            if folded(key) not in self._taken:
                self._taken.add(folded(key))
                return key
