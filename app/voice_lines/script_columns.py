"""The meaning of columns in sheets of voice lines: fields of a line, and languages."""

import re
from collections.abc import Mapping, Sequence
from enum import StrEnum

from app.voice_lines.rules import is_known_language, language_tag

MAX_HEAD_CHARS = 100
HEADS: Mapping[str, str] = {
    "key": "line id|id|key|line key|string id|identifier|dialogue id|dialog id|vo id|asset id|cue id|no|nr|number|"
    "line no|line nr|line number|zeilen id|zeile nr|kennung|nummer",
    "character": "character|characters|character name|speaker|role|who|char|figur|rolle|charakter|personnage|personaje",
    "scene": "scene|scenes|szene|location|level|quest|chapter|sequence|conversation|ort|scène|escena",
    "direction": "direction|directions|acting|acting note|acting notes|note|notes|performance|delivery|emotion|tone|"
    "intention|parenthetical|context|comment|regie|regieanweisung|anweisung|kontext|didascalie",
    "file_name": "file name|filename|file|wav|wav name|audio file|sound file|dateiname|datei|fichier|archivo",
    "variations": "variations|number of variations|variants|number of files|files|anzahl|varianten|variationen",
    "text": "text|line|lines|dialogue|dialog|dialogue text|line text|script|copy|spoken text|original|original text|"
    "source|source text|dialogzeile|dialogtext|sprechtext|texte|texto",
}
_TEXT_WORDS = "text|line|dialogue|dialog|translation|translated|string|copy|script|localized|texte|texto"
_AFTER = re.compile(rf"(?:{_TEXT_WORDS})[\s:_([-]{{1,3}}([^)\]]{{2,40}}?)[)\]]?", re.IGNORECASE)
_BEFORE = re.compile(rf"(.{{2,40}}?)[\s:_-]{{1,3}}(?:{_TEXT_WORDS})", re.IGNORECASE)


class ScriptField(StrEnum):
    """A possible meaning of a column, besides a language."""

    KEY = "key"
    CHARACTER = "character"
    SCENE = "scene"
    DIRECTION = "direction"
    FILE_NAME = "file_name"
    VARIATIONS = "variations"  # files of the line, numbered
    TEXT = "text"  # in the language that the request names
    IGNORE = "ignore"


def _plain(head: str) -> str:
    return " ".join(re.findall(r"[^\W_]+", head.casefold()))


_FIELD_OF = {_plain(head): field for field, heads in HEADS.items() for head in (field, *heads.split("|"))}


def meaning_of(head: str) -> str | None:
    """Return the field or the language tag that a column's head means; None where it is neither."""
    given = head.strip()
    if not given or len(given) > MAX_HEAD_CHARS:
        return None
    if field := _FIELD_OF.get(_plain(given)):
        return field
    if is_known_language(given):
        return language_tag(given)
    for pattern in (_AFTER, _BEFORE):
        match = pattern.fullmatch(given)
        if match and is_known_language(match[1]):
            return language_tag(match[1])
    return None


def script_heads_in(cells: Sequence[str]) -> int:
    """Return the number of known heads in a row's cells, each meaning counted once."""
    return len({meaning for cell in cells if (meaning := meaning_of(cell))})
