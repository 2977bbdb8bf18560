"""The meaning of columns in people's spreadsheets, and how their cells are read."""

import math
import re
import unicodedata
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from datetime import date
from typing import Any

from app.sound_lists.rules import CueState, Need, Reverb

HEADS: Mapping[str, str] = {
    "number": "number|no|nr|num|id|cue|cue no|cue nr|cue number|cue id|sound id|sound no|asset id|ref|nummer|lfd nr|"
    "soundnummer|sound nr|kennung",
    "name": "name|sound|title|cue name|sound name|sound title|sound effect|effect|effect name|asset|asset name|sfx|"
    "sfx name|titel|bezeichnung|klang|nom|nombre",
    "file_name": "filename|file|wav|file name|wav name|wav file|asset file|audio file|sound file|dateiname|datei|"
    "fichier|nom de fichier|archivo|wav datei|asset path|file path|dateipfad",
    "category": "category|type|class|group|sound type|sound category|kategorie|gruppe|art|"
    "categorie|categoria|kind|sound kind|kind of sound|sfx type|sfx category|typ|soundtyp|klangart|sorte",
    "description": "description|desc|descr|details|brief|sound description|what it is|beschreibung|descripcion",
    "use": "use|usage|context|use in game|use in the game|used in|used for|in game use|verwendung|einsatz|kontext|"
    "where used|where|used where|scene|szene|verwendet in|einsatzort|wo",
    "trigger": "trigger|event|when|triggered by|trigger event|game event|event name|auslöser|"
    "ereignis|ausgelöst durch|played when|played on",
    "duration_s": "duration|length|len|requested duration|requested length|target length|dauer|länge|laenge|duree|"
    "duracion|dur|length approx|approx length|time|zeit|laufzeit|spieldauer",
    "length_locked": "locked|length locked|locked length|fixed length|exact length|duration locked|länge fest",
    "frame_rate_fps": "fps|frame rate|framerate|bildrate",
    "loop": "loop|looping|looped|loops|is loop|loop one shot|loop oneshot|loop or one shot|one shot or loop|schleife|"
    "loop j n|loop y n|geloopt|endlos",
    "reverb": "reverb|reverb tail|hall",
    "variations": "variations|variation|variants|variant|vars|count|qty|quantity|number of variations|"
    "num variations|variation count|no of variations|varianten|variationen|anzahl|"
    "var|nr of variations|number of variants|no of variants|number of files|files|anz|stück|"
    "dateien|anzahl varianten|anzahl variationen",
    "state": "state|status|stage|stand|design status|maturity|reife|reifegrad",
    "need": "need|needed|need level|moscow|must should wish|must have|necessity|bedarf|notwendigkeit|muss soll wunsch",
    "playback_priority": "priority|prio|playback priority|playback prio|voice priority|importance|sound priority|"
    "priorität|abspielpriorität|wichtigkeit|rang",
    "due_on": "due|due date|due on|due by|deadline|needed by|needed on|need by|date due|date needed|delivery date|"
    "target date|milestone date|eta|fällig|fällig am|fälligkeit|termin|abgabe|abgabetermin|liefertermin|bis wann|"
    "échéance|date limite|fecha límite",
    "placeholder": "placeholder|temp|is placeholder|platzhalter",
    "palette": "palette|in palette",
    "implementer": "implementer|implemented by|integrator|integrated by|puts it in|audio implementer|eingebaut von|"
    "implementiert von|einbau",
    "recorder": "recorder|recorded by|recordist|records|aufgenommen von|aufnahme|aufnahme von",
}
UNITS: Mapping[str, float] = {
    **dict.fromkeys(("s", "sec", "secs", "second", "seconds", "sek", "sekunde", "sekunden"), 1.0),
    **dict.fromkeys(("ms", "msec", "millisecond", "milliseconds", "millisekunden"), 0.001),
    **dict.fromkeys(("min", "mins", "minute", "minutes", "minuten"), 60.0),
}
EMPTY = frozenset({"", "-", "–", "—", "?", "n/a", "na", "none", "null", "tba", "tbd", "k.a."})
YES = frozenset(
    {"yes", "y", "true", "1", "x", "✓", "✔", "☑", "on", "ja", "j", "wahr", "oui", "si", "sí", "loop", "looping"}
)
NO = frozenset(
    {"no", "n", "false", "0", "☐", "off", "nein", "falsch", "non", "one-shot", "one shot", "oneshot", "single"}
)
PRIORITIES: Mapping[str, int] = {
    **dict.fromkeys(("highest", "critical", "must have", "höchste", "kritisch", "muss"), 1000),
    **dict.fromkeys(("high", "hoch", "wichtig"), 750),
    **dict.fromkeys(("medium", "mid", "med", "normal", "mittel"), 500),
    **dict.fromkeys(("low", "niedrig", "gering", "nice to have", "kann"), 250),
    **dict.fromkeys(("lowest", "niedrigste"), 0),
}
"""Playback priorities from 0 to 1000 for the words that lists use."""
NEEDS: Mapping[str, Need] = {
    **dict.fromkeys(("must", "must have", "m", "required", "muss"), Need.MUST),
    **dict.fromkeys(("should", "should have", "s", "soll"), Need.SHOULD),
    **dict.fromkeys(("wish", "could", "could have", "c", "w", "nice to have", "optional", "wunsch", "kann"), Need.WISH),
}
GERMAN_MONTHS = {"mrz": "mar", "mai": "may", "okt": "oct", "dez": "dec"}
MONTHS = ("jan", "feb", "mar", "apr", "may", "jun", "jul", "aug", "sep", "oct", "nov", "dec")
SLASHED = re.compile(r"(\d{1,2})[/-](\d{1,2})[/-](\d{2}|\d{4})", re.ASCII)
LOOP_WORDS = frozenset({"loop", "looping", "looped", "one-shot", "one shot", "oneshot"})
SAMPLED = 50
MAX_HEADER_CHARS = 200  # what is longer is not a head of ours
MAX_FIGURE_CHARS = 100  # of a cell with a number, a flag or a word of ours, which expressions are run on


@dataclass(frozen=True)
class Head:
    """The content of a column's head: its field, None if unknown, and the unit of its numbers in seconds."""

    field: str | None
    unit_s: float = 1.0
    is_ours: bool = False  # written exactly as we export it


def _plain(head: str) -> str:
    letters = unicodedata.normalize("NFKD", head.casefold().replace("ß", "ss"))
    letters = "".join(letter for letter in letters if not unicodedata.combining(letter))
    return " ".join(re.findall(r"[^\W_]+", letters))


def _known_heads() -> dict[str, str]:
    known: dict[str, str] = {}
    for field, heads in HEADS.items():
        for head in (field, *heads.split("|")):
            known.setdefault(_plain(head), field)
    return known


_FIELD_OF = _known_heads()


def head_of(text: str) -> Head:
    """Return the meaning of a column's head, whatever its case, brackets, accents and unit."""
    if len(text) > MAX_HEADER_CHARS:
        return Head(None)
    if text.strip() in HEADS:
        return Head(text.strip(), is_ours=True)
    if text.strip() in ("#", "№"):
        return Head("number")
    plain = _plain(text)
    if field := _FIELD_OF.get(plain):
        return Head(field)
    rest, _, unit = plain.rpartition(" ")
    if unit in UNITS and _FIELD_OF.get(rest) == "duration_s":
        return Head("duration_s", UNITS[unit])
    if plain in UNITS and len(plain) > 2:  # a column called "Seconds"
        return Head("duration_s", UNITS[plain])
    without_brackets = _plain(re.sub(r"\(.*?\)|\[.*?\]", " ", text))
    return Head(_FIELD_OF.get(without_brackets))


def known_heads_in(cells: Sequence[str]) -> int:
    """Return how many cells of a row are heads that we know, each field counted once."""
    return len({head.field for cell in cells if cell.strip() and (head := head_of(cell)).field})


def read_number(text: str) -> float:
    """Return a number as people type it: 1.5, 1,5, 1.234,5, ~2; raise ValueError for anything else."""
    plain = re.sub(r"^(~|≈|ca\.?|approx\.?)\s*", "", text.strip().lower().replace("\xa0", "").replace("'", ""))
    if "," in plain and "." in plain:
        thousands = "," if plain.rindex(",") < plain.rindex(".") else "."
        plain = plain.replace(thousands, "")
    plain = plain.replace(",", ".")
    if not re.fullmatch(r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)(e[+-]?[0-9]{1,3})?", plain, re.ASCII):
        raise ValueError(f'wanted a number such as 1.5, found "{text[:40]}"')
    value = float(plain)
    if not math.isfinite(value):
        raise ValueError(f'wanted a number such as 1.5, found "{text[:40]}"')
    return value


def number_text(value: float) -> str:
    """Return a number as a cell has it: without a point where it is whole."""
    return str(int(value)) if value.is_integer() and abs(value) < 1e15 else repr(value)


def _read_duration(text: str, unit_s: float) -> float | None:
    if text.lower() in EMPTY:
        return None
    value = _seconds_in(text, unit_s)
    if value <= 0:
        raise ValueError(f'wanted a length above 0, found "{text[:40]}"')
    return value


def _seconds_in(text: str, unit_s: float) -> float:
    plain = text.strip().lower()
    if found := re.fullmatch(r"(?:(\d{1,2}):)?(\d{1,3}):(\d{1,2}(?:[.,]\d+)?)", plain, re.ASCII):
        hours, minutes, seconds = found.groups()
        return int(hours or 0) * 3600 + int(minutes) * 60 + float(seconds.replace(",", "."))
    if found := re.fullmatch(r"(.*[0-9.,])\s*([a-z]+)\.?", plain):
        if found[2] not in UNITS:
            raise ValueError(f'wanted seconds such as 1.5, found "{text[:40]}"')
        plain, unit_s = found[1], UNITS[found[2]]
    try:
        return round(read_number(plain) * unit_s, 6)
    except ValueError:
        raise ValueError(f'wanted seconds such as 1.5, found "{text[:40]}"') from None


def _read_rate(text: str, _unit_s: float) -> float | None:
    if text.lower() in EMPTY:
        return None
    value = read_number(re.sub(r"\s*fps$", "", text.lower()))
    if value <= 0:
        raise ValueError(f'wanted frames per second above 0, found "{text[:40]}"')
    return value


def _read_count(text: str, _unit_s: float) -> int:
    if text.lower() in EMPTY:
        return 1
    found = re.fullmatch(r"[x×]?\s*([0-9]{1,6})(?:[.,]0+)?\s*[x×]?", text.strip().lower(), re.ASCII)
    if found is None:
        raise ValueError(f'wanted a whole number, found "{text[:40]}"')
    return int(found[1])


def _read_priority(text: str, _unit_s: float) -> int | None:
    plain = " ".join(re.split(r"[\s_-]+", text.strip().lower()))
    if plain in PRIORITIES:
        return PRIORITIES[plain]
    return None if text.lower() in EMPTY else _read_count(text, 1.0)


def _read_flag(text: str, _unit_s: float) -> bool:
    plain = text.strip().lower()
    if plain in YES:
        return True
    if plain in NO or plain in EMPTY:
        return False
    raise ValueError(f'wanted yes or no, found "{text[:40]}"')


def _read_state(text: str, _unit_s: float) -> CueState | None:
    plain = text.strip().lower()
    if plain in EMPTY:
        return None
    if plain not in set(CueState):
        raise ValueError(f'wanted {", ".join(CueState)}, found "{text[:40]}"')
    return CueState(plain)


def _read_reverb(text: str, _unit_s: float) -> Reverb | None:
    plain = re.sub(r"[\s_]+", "-", text.strip().lower())
    if plain in EMPTY:
        return None
    if plain not in set(Reverb):
        raise ValueError(f'wanted {", ".join(Reverb)}, found "{text[:40]}"')
    return Reverb(plain)


def _read_need(text: str, _unit_s: float) -> Need | None:
    plain = " ".join(re.split(r"[\s_-]+", text.strip().lower()))
    if text.strip().lower() in EMPTY:
        return None
    if plain not in NEEDS:
        raise ValueError(f'wanted {", ".join(Need)}, found "{text[:40]}"')
    return NEEDS[plain]


def is_day_first(cells: Sequence[str]) -> bool | None:
    """Return whether a column writes the day before the month, as in 31/5/2026; None where no cell shows it."""
    for cell in cells:
        if found := SLASHED.fullmatch(cell.strip()[:MAX_FIGURE_CHARS]):
            if int(found[1]) > 12:
                return True
            if int(found[2]) > 12:
                return False
    return None


def read_day(text: str, day_first: bool | None = None) -> date | None:
    """Return a day as people type it; raise ValueError where it is none, or could be two."""
    plain = text.strip().lower()
    if plain in EMPTY:
        return None
    try:
        if found := re.fullmatch(r"(\d{4})[-/.](\d{1,2})[-/.](\d{1,2})(?:[t ]\d{1,2}:\d{2}.*)?", plain, re.ASCII):
            return date(int(found[1]), int(found[2]), int(found[3]))
        if found := re.fullmatch(r"(\d{1,2})\.\s*(\d{1,2})\.\s*(\d{2}|\d{4})", plain, re.ASCII):
            return date(_year(found[3]), int(found[2]), int(found[1]))
        if found := SLASHED.fullmatch(plain):
            first, second, year = int(found[1]), int(found[2]), _year(found[3])
            if day_first is None and first != second and max(first, second) <= 12:
                raise ValueError(
                    f'"{text[:40]}" could be {date(year, second, first):%d %B} or {date(year, first, second):%d %B}; '
                    f"write {date(year, second, first)}"
                )
            is_day = first > 12 or (second <= 12 and bool(day_first))
            return date(year, second, first) if is_day else date(year, first, second)
        if found := re.fullmatch(r"(?:[a-zä]{2,10},? )?(\d{1,2})(?:st|nd|rd|th|\.)? ([a-zä]{3,9})\.?,? (\d{4})", plain):
            return date(int(found[3]), _month(found[2]), int(found[1]))
        if found := re.fullmatch(r"([a-zä]{3,9})\.? (\d{1,2})(?:st|nd|rd|th)?,? (\d{4})", plain):
            return date(int(found[3]), _month(found[1]), int(found[2]))
    except ValueError as error:
        if "could be" in str(error):
            raise
    raise ValueError(f'wanted a day such as 2026-12-04, found "{text[:40]}"')


def _year(digits: str) -> int:
    return int(digits) + (2000 if len(digits) == 2 else 0)


def _month(name: str) -> int:
    start = name[:3].replace("ä", "a")
    return MONTHS.index(GERMAN_MONTHS.get(start, start)) + 1


READERS: Mapping[str, Callable[[str, float], Any]] = {
    "duration_s": _read_duration,
    "frame_rate_fps": _read_rate,
    "variations": _read_count,
    "playback_priority": _read_priority,
    "length_locked": _read_flag,
    "loop": _read_flag,
    "placeholder": _read_flag,
    "palette": _read_flag,
    "state": _read_state,
    "reverb": _read_reverb,
    "need": _read_need,
}


def read_cell(field: str, text: str, unit_s: float = 1.0, day_first: bool | None = None) -> Any:
    """Return the value of a cell for a field; raise ValueError that says what was wanted and what was found."""
    reader = READERS.get(field)
    if reader is None and field != "due_on":
        return text
    if len(text) > MAX_FIGURE_CHARS:
        raise ValueError(f'{len(text):,} characters; wanted {MAX_FIGURE_CHARS} at most, found "{text[:40]}"')
    return reader(text, unit_s) if reader else read_day(text, day_first)


def says_loop(cells: Sequence[str]) -> bool:
    """Whether every filled cell of a column says loop or one-shot, whatever its head."""
    filled = [cell.strip().lower() for cell in cells if cell.strip()]
    return bool(filled) and LOOP_WORDS.issuperset(filled)


def looks_like(field: str, cells: Sequence[str], unit_s: float) -> bool:
    """Whether most of a column's cells can be read for a field."""
    filled = [cell for cell in cells if cell][:SAMPLED]
    day_first = is_day_first(filled) is not False  # either order shows that these are days
    readable = 0
    for cell in filled:
        try:
            read_cell(field, cell, unit_s, day_first)
        except ValueError:
            continue
        readable += 1
    return 2 * readable >= len(filled)
