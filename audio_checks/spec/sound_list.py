"""The sound list as a file, and the names by which files find their cues: one code for server and command line."""

import csv
import io
import math
import re
import unicodedata
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import NamedTuple

from audio_checks.errors import SpecError
from audio_checks.spec.delivery_spec import CueFacts
from audio_checks.spec.game_paths import stem_in_language
from audio_checks.system.text_files import read_text

COLUMNS = (
    "number",
    "name",
    "file_name",
    "category",
    "description",
    "use",
    "trigger",
    "duration_s",
    "length_locked",
    "frame_rate_fps",
    "loop",
    "reverb",
    "variations",
    "state",
)
STATES = ("concept", "prototype", "locked", "cut")
REVERBS = ("dry", "designed-tail", "separate-tail")
AUDIO_SUFFIXES = frozenset(
    {".wav", ".wave", ".bwf", ".rf64", ".bw64", ".w64", ".flac", ".aif", ".aiff", ".aifc", ".au", ".snd", ".caf"}
    | {".mp3", ".mp2", ".m4a", ".aac", ".wma", ".ogg", ".oga", ".opus"}
)

_ALTERNATE = re.compile(r"(?<=[^_])(?:__alt([1-9][0-9]?)|__?alt([A-Z]))$")
_DRY_STEM = re.compile(r"(?<=[^_])__dry$")
_TYPED_VERSION = re.compile(r"(?<=[^_])_+[vV]([0-9]{1,4})$")
_MOST_VARIATIONS = 999


class TakeName(NamedTuple):
    """The parts of a delivered file's name: `laser_fire_02__alt2.wav` is alternate 2 of the stem `laser_fire_02`."""

    stem: str
    alternate: int | None
    typed_version: int | None
    extension: str


def parse_file_name(file_name: str) -> TakeName:
    """Return the parts of a file's name, in NFC; folders before it are dropped.

    `__alt2` and `_altB` say that it is the second alternate; a typed `_v03` is read and dropped.
    """
    whole = unicodedata.normalize("NFC", re.split(r"[/\\]", file_name)[-1])
    stem, extension = _split(whole)
    alternate = version = None
    for _ in range(2):  # the two may come in either order
        if alternate is None and (found := _ALTERNATE.search(stem)):
            alternate = int(found[1]) if found[1] else ord(found[2]) - ord("A") + 1
            stem = stem[: found.start()]
        if version is None and (found := _TYPED_VERSION.search(stem)):
            version = int(found[1])
            stem = stem[: found.start()]
    return TakeName(stem, alternate, version, extension)


def _split(whole: str) -> tuple[str, str]:
    stem, dot, ending = whole.rpartition(".")
    return (stem, dot + ending) if stem else (whole, "")


def dry_stem_name(file_name: str) -> str | None:
    """Return the stem, in NFC, of the file that this one is the dry stem of, by its name; None for any other name.

    `warp_in__dry.wav` is that of `warp_in.wav`, and `warp_in__alt2__dry.wav` that of `warp_in__alt2.wav`.
    """
    stem = stem_of_file(file_name)
    return stem[: found.start()] if (found := _DRY_STEM.search(stem)) else None


def stem_of_file(file_name: str) -> str:
    """Return a file's name without its ending, in NFC and with all its marks; folders before it are dropped."""
    return _split(unicodedata.normalize("NFC", re.split(r"[/\\]", file_name)[-1]))[0]


def slug(name: str) -> str:
    """Return a name as a stem: lower-case letters and digits joined by `_`; empty when there is neither.

    Accents go; a name in another script keeps its letters.
    """
    plain = unicodedata.normalize("NFKD", name.replace("ß", "ss")).encode("ascii", "ignore").decode("ascii").lower()
    words = re.findall(r"[a-z0-9]+", plain) or re.findall(r"[^\W_]+", unicodedata.normalize("NFC", name).lower())
    return "_".join(words)


def stems_of(name: str, file_name: str, variations: int = 1) -> list[str]:
    """Return the stems a cue owns: that of its file name (its name slugged if empty), and `_01 …` for a set.

    Empty when the cue has neither a file name nor a name that makes one.
    """
    whole = unicodedata.normalize("NFC", file_name.strip())
    stem, extension = _split(whole)
    if extension.lower() not in AUDIO_SUFFIXES:
        stem = whole
    stem = stem or slug(name)
    if not stem:
        return []
    if variations <= 1:
        return [stem]
    width = max(2, len(str(variations)))
    return [f"{stem}_{place:0{width}}" for place in range(1, variations + 1)]


@dataclass(frozen=True)
class SoundList:
    """The cues of a project."""

    cues: tuple[CueFacts, ...]

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


def read_sound_list(source: str | Path) -> SoundList:
    """Return the sound list of a CSV file (a path), or of CSV text (a string).

    Columns are found by name, in any order, with comma, semicolon or tab between them; only `number`
    or `name` is needed, and unknown columns are kept in each cue's `more`.

    Raises
    ------
    SpecError
        The file cannot be read, or rows are wrong; each is named by its row and column.
    """
    where = str(source) if isinstance(source, Path) else "sound list"
    text = read_text(source, fix="save it as CSV UTF-8") if isinstance(source, Path) else source.removeprefix("\ufeff")
    rows = _rows(text, where)
    cues: list[CueFacts] = []
    wrong: list[str] = []
    for number, row in rows:
        try:
            cues.append(_cue(row))
        except ValueError as error:
            wrong.append(f"row {number}: {error}")
    if not wrong:
        wrong = list(_twins(cues))
    if wrong:
        more = f"; and {len(wrong) - 10} more" if len(wrong) > 10 else ""
        raise SpecError("; ".join(wrong[:10]) + more, where=where)
    return SoundList(tuple(cues))


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


def _rows(text: str, where: str) -> Iterator[tuple[int, dict[str, str]]]:
    header = text.partition("\n")[0]
    between = max(",;\t", key=header.count)
    try:
        rows = list(csv.reader(io.StringIO(text, newline=""), delimiter=between))
    except csv.Error as error:
        raise SpecError(f"is not CSV: {error}", where=where) from None
    names = [name.strip().lower() for name in rows[0]] if rows else []
    if not {"number", "name"} & set(names):
        raise SpecError(f"its first row names no column number or name; columns: {', '.join(COLUMNS)}", where=where)
    twice = sorted({name for name in names if name and names.count(name) > 1})
    if twice:
        raise SpecError(f"names the column {twice[0]} twice", where=where)
    for number, cells in enumerate(rows[1:], start=2):
        row = {name: cell.strip() for name, cell in zip(names, cells, strict=False) if name}
        if any(row.values()):
            yield number, row


def _cue(row: Mapping[str, str]) -> CueFacts:
    known = {"number", "name", "file_name", "category"}
    typed = {"duration_s", "length_locked", "frame_rate_fps", "loop", "reverb", "variations", "state"}
    number, name = row.get("number", ""), row.get("name", "")
    if not (number or name):
        raise ValueError("number: a cue needs a number or a name")
    return CueFacts(
        number=number or name,
        name=name,
        file_name=row.get("file_name", ""),
        category=row.get("category") or None,
        duration_s=_positive(row, "duration_s"),
        length_locked=_flag(row, "length_locked"),
        frame_rate_fps=_positive(row, "frame_rate_fps"),
        loop=_flag(row, "loop"),
        reverb=_word(row, "reverb", REVERBS),
        variations=_variations(row),
        state=_word(row, "state", STATES) or "concept",
        more={key: value for key, value in row.items() if key not in known | typed},
        says_loop="loop" in row,
    )


def _positive(row: Mapping[str, str], column: str) -> float | None:
    text = row.get(column, "")
    if not text:
        return None
    try:
        value = float(text.replace(",", "."))
    except ValueError:
        value = math.nan
    if not (math.isfinite(value) and value > 0):
        raise ValueError(f'{column}: wanted a number above 0, found "{text[:40]}"')
    return value


def _variations(row: Mapping[str, str]) -> int:
    text = row.get("variations", "") or "1"
    if not re.fullmatch(r"[0-9]{1,6}", text, re.ASCII) or not 1 <= int(text) <= _MOST_VARIATIONS:
        raise ValueError(f'variations: wanted a whole number from 1 to {_MOST_VARIATIONS}, found "{text[:40]}"')
    return int(text)


_FLAGS = {
    **dict.fromkeys(("", "no", "false", "0", "n", "one-shot"), False),
    **dict.fromkeys(("yes", "true", "1", "y", "x", "loop"), True),
}


def _flag(row: Mapping[str, str], column: str) -> bool:
    text = row.get(column, "")
    if text.lower() not in _FLAGS:
        raise ValueError(f'{column}: wanted yes or no, found "{text[:40]}"')
    return _FLAGS[text.lower()]


def _word(row: Mapping[str, str], column: str, words: tuple[str, ...]) -> str | None:
    text = row.get(column, "").lower()
    if text and text not in words:
        raise ValueError(f'{column}: wanted one of {", ".join(words)}, found "{text[:40]}"')
    return text or None


def _twins(cues: Iterable[CueFacts]) -> Iterator[str]:
    owners: dict[str, CueFacts] = {}
    for cue in cues:
        if cue.state == "cut":
            continue
        for stem in stems_of(cue.name, cue.file_name, cue.variations):
            if owners.setdefault(stem, cue) is not cue:
                yield f'cues {owners[stem].number} and {cue.number} both own the file name "{stem}"'
