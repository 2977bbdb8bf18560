"""The text of a sound list as rows below a head, and the rows among them that are no cues."""

import csv
import io
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from audio_checks.spec.list_cells import is_broken_formula, read_number, reading_of
from audio_checks.spec.list_heads import known_heads_in, plain_head

SEPARATORS = ",;\t|"
HEAD_WITHIN_ROWS = 12
LAST_COLUMN = 2_000
MAX_NOTE_CHARS = 300
Rows = list[tuple[int, list[str]]]
HeadsIn = Callable[[Sequence[str]], int]  # how many cells of a row are heads that the reader of the table knows

_TOTAL = re.compile(
    r"(?:grand |sub[ -]?|overall )?totals?"
    r"(?: (?:sounds?|cues?|files?|assets?|count|number|length|duration|time|general))?(?: of .{1,30})?|sums?|count|"
    r"average|avg|gesamt(?:summe|zahl|dauer)?|(?:zwischen)?summe|insgesamt|somme|total général|sous[ -]?total|suma|"
    r"合計|小計|総計|計",
    re.IGNORECASE,
)
_NOTE = re.compile(
    r"(?:notes?|legend|n\.?b|todo|last updated?|updated|version|hinweis|legende|stand|remarque|nota|※|\*)"
    r"\s*[:.\-–*]|\*{1,3}\s|※",
    re.IGNORECASE,
)
_MARKED = re.compile(r"^(?:[-=–—#*_>•▼■◆●]{1,10}\s*).+|.+(?::|[-=–—]{2,})$|^\[.+\]$|^【.+】$|^<.+>$")
_SECTION_WORD = re.compile(
    r"(?:^|\s)(?:sounds?|sfx|section|category|ambiences?|ambient|music|foley|voices?|vo|ui|weapons?|characters?|"
    r"footsteps|vehicles?|environment|creatures?|effects?|level \d+|act \d+|chapter \d+|part \d+|geräusche|musik|"
    r"atmos|waffen|効果音|環境音|音楽)$"
    r"|^(?:section|category|group|chapter|abschnitt|kategorie|gruppe|kapitel)\s*[:–—-]\s*\S",
    re.IGNORECASE,
)


class TableUnreadable(ValueError):
    """The text is no table; says where it breaks off."""


@dataclass(frozen=True)
class RowWithoutCue:
    """A row that is no cue, and why."""

    row: int
    kind: str  # "section", "total", "head" or "note"
    text: str
    why: str


def separator_of(text: str, heads_in: HeadsIn = known_heads_in, *, pasted: bool = False) -> str:
    """Return the separator of cells: the one that gives most known heads, then most cells in most rows."""
    if pasted and "\t" in text:
        return "\t"
    start = "\n".join(text[:200_000].splitlines()[:60])

    def promise(separator: str) -> tuple[int, int]:
        rows = [row for row in csv.reader(io.StringIO(start, newline=""), delimiter=separator) if row][:30]
        widths = sorted(len(row) for row in rows)
        heads = max((heads_in(row[:LAST_COLUMN]) for row in rows[:HEAD_WITHIN_ROWS]), default=0)
        return heads, widths[len(widths) // 2] if widths else 0

    promises = {separator: promise(separator) for separator in SEPARATORS}
    best = max(SEPARATORS, key=promises.__getitem__)
    if pasted and promises[best][0] < 2:
        return "\t"  # one column: a comma in a pasted name is part of the name
    return best


def records(text: str, heads_in: HeadsIn = known_heads_in, *, pasted: bool = False) -> Iterator[tuple[int, list[str]]]:
    """Yield the numbered rows of CSV text or of pasted cells; raise TableUnreadable where a quote never closes."""
    first = 1
    if match := re.match(rf"sep=([{SEPARATORS}:])\r?\n", text):  # Excel's own way to name the separator
        text, first, separator = text[match.end() :], 2, match[1]
    else:
        separator = separator_of(text, heads_in, pasted=pasted)
    yield from enumerate(_split(text, separator), start=first)


def _split(text: str, separator: str) -> Iterator[list[str]]:
    reader = csv.reader(io.StringIO(text, newline=""), delimiter=separator)
    row = 0
    try:
        for record in reader:
            row += 1
            yield record
    except csv.Error as error:
        raise TableUnreadable(f"line {reader.line_num}: {error}; a quote may be opened and never closed") from None
    if text.count('"') % 2:  # only then can a quote be open at the end
        try:
            for _ in csv.reader(io.StringIO(text, newline=""), delimiter=separator, strict=True):
                pass
        except csv.Error as error:
            if "end of data" in str(error):
                raise TableUnreadable(f"row {row}: a quote is opened and never closed") from None


def filled(rows: Iterable[tuple[int, Sequence[str]]]) -> Iterator[tuple[int, list[str]]]:
    """Yield the rows that have something in them, without what is empty at their ends."""
    for row, cells in rows:
        texts = [cell.strip() for cell in cells]
        while texts and not texts[-1]:
            texts.pop()
        if texts:
            yield row, texts


def headed(
    rows: Rows, heads_in: HeadsIn = known_heads_in, *, must_have_head: bool
) -> tuple[int | None, tuple[str, ...], list[int], Rows]:
    """Return the row of the head, the names of columns, the places that these have in rows, and the rows below."""
    heads = max(range(min(HEAD_WITHIN_ROWS, len(rows))), key=lambda index: heads_in(rows[index][1]))
    has_head = must_have_head or heads_in(rows[heads][1]) > 0
    header_row, names = rows[heads] if has_head else (None, [])
    below = rows[heads + 1 :] if has_head else rows
    used = sorted(
        {index for cells in (names, *(cells for _, cells in below)) for index, cell in enumerate(cells) if cell}
    )
    if header_row is None:
        names = [f"Column {index + 1}" for index in range(used[-1] + 1)]
    columns = tuple(_distinct((names[index] if index < len(names) else "", index) for index in used))
    return (
        header_row,
        columns,
        used,
        [(row, [cells[index] if index < len(cells) else "" for index in used]) for row, cells in below],
    )


def _distinct(names: Iterable[tuple[str, int]]) -> Iterator[str]:
    """Yield column names of which no two are alike in lower case; a column without a name gets its place."""
    seen: set[str] = set()
    for name, index in names:
        plain = " ".join(name.split())[:100] or f"Column {index + 1}"
        again = 2
        unique = plain
        while unique.lower() in seen:
            unique = f"{plain} ({again})"
            again += 1
        seen.add(unique.lower())
        yield unique


def rows_without_cue(
    rows: Rows, columns: Sequence[str], fields: Mapping[int, str], merged_across: Iterable[int] = ()
) -> list[RowWithoutCue]:
    """Return the rows of a list that are titles of sections, totals, repeated heads or notes.

    Parameters
    ----------
    rows : list of (int, list of str)
        The rows below the head, with their numbers.
    columns : sequence of str
        The names of the columns.
    fields : mapping of int to str
        What columns are read as, by their place.
    merged_across : iterable of int
        Numbers of rows with a cell that is merged over several columns.
    """
    reader = _Reader(rows, columns, fields, frozenset(merged_across))
    return [without_cue for index in range(len(rows)) if (without_cue := reader.row_without_cue(index))]


class _Reader:
    """Knowledge of the look of cues' rows, to tell other rows from them."""

    def __init__(
        self, rows: Rows, columns: Sequence[str], fields: Mapping[int, str], merged_across: frozenset[int]
    ) -> None:
        self._rows = rows
        self._merged_across = merged_across
        self._heads = [plain_head(column) for column in columns]
        self._names = [index for index, field in fields.items() if field in ("name", "file_name", "number")]
        self._categories = {
            plain_head(cells[index]) for _, cells in rows for index, field in fields.items() if field == "category"
        } - {""}
        counts = [sum(map(bool, cells)) for _, cells in rows]
        full = [cells for (_, cells), count in zip(rows, counts, strict=True) if count > 1]
        self._is_table = len(columns) > 1 and 2 * len(full) > len(rows) / 2
        names = [cells[index] for cells in full for index in self._names[:1] if cells[index]]
        self._has_capitals = 2 * sum(name == name.upper() != name.lower() for name in names) > len(names)
        self._is_snake = bool(names) and 10 * sum(_is_snake(name) for name in names) >= 8 * len(names)
        self._duration = next((index for index, field in fields.items() if field == "duration_s"), None)

    def row_without_cue(self, index: int) -> RowWithoutCue | None:
        row, cells = self._rows[index]
        texts = [(at, cell) for at, cell in enumerate(cells) if cell]
        row_text = ", ".join(text for _, text in texts)[:MAX_NOTE_CHARS]
        if len(texts) > 1 and all(plain_head(text) == self._heads[at] for at, text in texts):
            return RowWithoutCue(row, "head", row_text, "the head again")
        first_at, first = texts[0]
        others = [text for _, text in texts[1:]]
        if _TOTAL.fullmatch(first.strip(" :.=")) and all(_is_figure(text) for text in others):
            return RowWithoutCue(row, "total", row_text, "a sum of the list, and not a sound")
        is_nameless = bool(self._names) and not any(cells[at] for at in self._names)
        is_last = index == len(self._rows) - 1
        if is_nameless and (len(texts) > 1 or is_last) and all(_is_figure(text) for _, text in texts):
            return RowWithoutCue(row, "total", row_text, "figures without a name")
        if others or not self._is_table or is_broken_formula(first):
            return None
        if _NOTE.match(first):
            return RowWithoutCue(row, "note", row_text, "a note, and not a sound")
        if first_at in self._names[:1] or first_at == 0 or not cells[self._names[0] if self._names else 0]:
            why = self._why_section(index, first)
            if why:
                return RowWithoutCue(row, "section", row_text, why)
        return None

    def _why_section(self, index: int, text: str) -> str:
        row = self._rows[index][0]
        follows = self._rows[index + 1] if index + 1 < len(self._rows) else None
        leads = follows is not None
        plain = plain_head(text)
        words = {plain, plain.removesuffix("s"), f"{plain}s"} | {plain.rpartition(" ")[0]}
        if row in self._merged_across:
            return "a title over several columns"
        if _MARKED.match(text):
            return "a title by its marks"
        if not leads:
            return ""
        if self._categories & (words - {""}):
            return "the name of a category, with nothing beside it"
        if not self._has_capitals and text == text.upper() != text.lower() and len(plain) > 1:
            return "in capitals, with nothing beside it"
        if self._is_snake and not _is_snake(text):
            return "not written as the other names are, with nothing beside it"
        if _SECTION_WORD.search(text) and not _is_snake(text):
            return "a title by its words, with nothing beside it"
        before = self._rows[index - 1][0] if index else row - 1
        if row - before > 1 and follows and follows[0] - row == 1:
            return "stands alone below an empty row"
        return ""


def _is_snake(name: str) -> bool:
    return re.fullmatch(r"[a-z0-9]+(?:[_.-][A-Za-z0-9]+)*", name) is not None


def _is_figure(text: str) -> bool:
    """Return whether a cell of a total fits it: a number, a length or a broken formula."""
    if is_broken_formula(text):
        return True
    try:
        read_number(re.sub(r"\s*(?:sounds?|cues?|files?|assets?|variations?|%)$", "", text.strip().lower()))
    except ValueError:
        try:
            return reading_of("duration_s", text).value is not None
        except ValueError:
            return False
    return True
