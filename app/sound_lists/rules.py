"""Rules of cues, stated without a database."""

import re
import unicodedata
from collections.abc import Iterator, Mapping
from enum import StrEnum
from typing import Any, Literal
from uuid import UUID

import audio_checks
from app.core.spreadsheets import FORMULA_STARTS


class CueState(StrEnum):
    """The finality of a cue."""

    CONCEPT = "concept"
    PROTOTYPE = "prototype"
    LOCKED = "locked"
    CUT = "cut"


class Reverb(StrEnum):
    """Whether the file contains reverb."""

    DRY = "dry"
    DESIGNED_TAIL = "designed-tail"
    SEPARATE_TAIL = "separate-tail"


class CueChannels(StrEnum):
    """The channels of a cue's files, where they are not as the delivery spec says."""

    MONO = "mono"
    STEREO = "stereo"


class Phase(StrEnum):
    """A phase of the production, in order; a later one opens once every sound of it is accepted."""

    CONCEPT = "concept"
    PALETTE = "palette"
    ALPHA = "alpha"
    BETA = "beta"
    GOLD = "gold"


class Need(StrEnum):
    """The game's need for a cue: without a "must" it cannot ship."""

    MUST = "must"
    SHOULD = "should"
    WISH = "wish"


PAGE = 50  # cues answered at once, unless the request asks for more: what a tall screen shows
MAX_PAGE = 500
MAX_VARIATIONS = 99
MAX_LABEL_CHARS = 60
MAX_DURATION_S = 86_400.0
LENGTHS = ("duration_s", "duration_min_s", "duration_max_s")  # to plan with, and the bounds where the list has some
Facts = dict[str, Any]  # what the list says of one cue, by the names of NEW_CUE

NEW_CUE: Mapping[str, Any] = {
    "name": "",
    "file_name": "",
    "category": "",
    "description": "",
    "use": "",
    "trigger": "",
    "duration_s": None,
    "duration_min_s": None,
    "duration_max_s": None,
    "length_locked": False,
    "frame_rate_fps": None,
    "loop": False,
    "reverb": None,
    "channels": None,
    "variations": 1,
    "state": CueState.PROTOTYPE,
    "need": Need.MUST,
    "phase": None,
    "playback_priority": None,
    "due_on": None,
    "placeholder": False,
    "palette": False,
    "implementer_id": None,
    "recorder_id": None,
    "extra": {},
}
CueOrdering = Literal["list", "playback_priority"]
NO_PLAYBACK_PRIORITY = 1_001  # after every playback priority, which end at 1000; 0 comes first
PEOPLE: Mapping[str, str] = {"implementer": "implementer_id", "recorder": "recorder_id"}  # columns of sheets, facts
CHECKED_FACTS = frozenset({"category", *LENGTHS, "length_locked", "frame_rate_fps", "loop", "reverb", "channels"})
NAMING_FACTS = frozenset({"name", "file_name", "variations"})
LINES = {"name": 200, "file_name": 200, "category": 60}
TEXTS = {"description": 10_000, "use": 2_000, "trigger": 2_000}
MAX_EXTRA_COLUMNS = 100
MAX_EXTRA_CHARS = 2_000
MAX_EXTRA_NAME_CHARS = 100
DURATION_DECIMALS = 6  # as many as an import reads

_UNSEEN = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u200b-\u200f\u2028-\u202e\u2060-\u2069\ufeff\ufffe\uffff]")
_NOT_IN_FILE_NAMES = re.compile(r'[<>:"/\\|?*]')
_DEVICE_NAME = re.compile(r"(con|prn|aux|nul|com[0-9]|lpt[0-9])(\..*)?", re.IGNORECASE)


def facts_seen(facts: Facts, designer_id: UUID | None) -> Facts:
    """Return the facts of a cue as the caller may see them: of its people, a designer sees only themselves."""
    if designer_id is None:
        return facts
    return facts | {fact: facts[fact] if facts[fact] == designer_id else None for fact in PEOPLE.values()}


def label(cue_prefix: str, number: int) -> str:
    """Return the short name of a cue: SW-014."""
    return f"{cue_prefix}-{number:03d}"


def read_label(cue_prefix: str, text: str) -> int | None:
    """Return the number that `SW-014`, `sw14` or `14` names, None where it names none of this project's."""
    if len(text) > MAX_LABEL_CHARS:  # the expression takes longer than the text is long
        return None
    match = re.fullmatch(r"(?:(.*?)[\s_-]*)?0*([1-9][0-9]{0,5})(?:\.0+)?", text.strip())
    if match is None or (match[1] and match[1].casefold() != cue_prefix.casefold()):
        return None
    return int(match[2])


def folded(stem: str) -> str:
    """Return the one key of two stems that some disks cannot hold side by side: case and composition do not count."""
    return unicodedata.normalize("NFC", unicodedata.normalize("NFC", stem).casefold())


def tidy_text(text: str) -> str:
    """Return text in NFC with plain line ends and without invisible characters."""
    plain = text.replace("\r\n", "\n").replace("\r", "\n")
    return _UNSEEN.sub("", unicodedata.normalize("NFC", plain)).strip()


def tidy_line(text: str) -> str:
    """Return tidy text on one line."""
    return re.sub(r"\s+", " ", tidy_text(text))


def tidy(facts: Mapping[str, Any]) -> Facts:
    """Return facts as the list keeps them; a cue without a name is called after its file."""
    kept = dict(facts)
    for field in LINES.keys() & kept.keys():
        kept[field] = tidy_line(kept[field])
    for field in TEXTS.keys() & kept.keys():
        kept[field] = tidy_text(kept[field])
    if "category" in kept:  # the spec names categories by slugs, and [categories.ui] is meant for "UI" as well
        kept["category"] = kept["category"].lower().replace(" ", "-")
    for field in LENGTHS:
        if kept.get(field) is not None:
            kept[field] = round(kept[field], DURATION_DECIMALS)
    if kept.get("name") == "" and kept.get("file_name"):
        kept["name"] = audio_checks.stems_of("", kept["file_name"], 1)[0]
    return kept


def validation_errors(facts: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """Yield the faults in the facts of one cue: the field, and the fault in words."""
    if not facts["name"]:
        yield "name", "enter a name for the cue"
    elif not audio_checks.stems_of(facts["name"], facts["file_name"], 1):
        yield "file_name", f'"{facts["name"]}" has no letter or digit for a file name; enter a file name'
    for field, longest in (LINES | TEXTS).items():
        if len(facts[field]) > longest:
            yield field, f"{len(facts[field])} characters; at most {longest} are kept"
    if fault := _fault_of_file_name(facts["file_name"]):
        yield "file_name", fault
    if facts["category"] and not re.fullmatch(r"[^\W_][\w-]*", facts["category"]):
        yield "category", f'"{facts["category"]}": wanted letters, digits, "-" and "_" only'
    yield from _faults_of_figures(facts)
    if len(facts["extra"]) > MAX_EXTRA_COLUMNS:
        yield "extra", f"{len(facts['extra'])} columns of your own; at most {MAX_EXTRA_COLUMNS} are kept"
    for column, text in facts["extra"].items():
        if not 0 < len(column) <= MAX_EXTRA_NAME_CHARS:
            yield (
                "extra",
                f"a column of your own has a name of 1 to {MAX_EXTRA_NAME_CHARS} characters, not {len(column)}",
            )
        if len(text) > MAX_EXTRA_CHARS:
            yield column, f"{len(text)} characters; at most {MAX_EXTRA_CHARS} are kept"


def _fault_of_file_name(file_name: str) -> str | None:
    if match := _NOT_IN_FILE_NAMES.search(file_name):
        return f'"{match[0]}" cannot stand in a file name; give the name alone, without folders'
    if file_name.startswith((*FORMULA_STARTS, "'", ".", "~")) or file_name.endswith("."):
        return f'"{file_name}": a file name starts with a letter, a digit or "_", and does not end in a dot'
    if _DEVICE_NAME.fullmatch(file_name):
        return f'"{file_name}" is the name of a device on Windows'
    return None


def _faults_of_figures(facts: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    if not 1 <= facts["variations"] <= MAX_VARIATIONS:
        yield "variations", f"{facts['variations']} variations; wanted 1 to {MAX_VARIATIONS}"
    for field, highest in (*((length, MAX_DURATION_S) for length in LENGTHS), ("frame_rate_fps", 1000.0)):
        value = facts[field]
        if value is not None and not 0 < value <= highest:  # nan fails too
            yield field, f"{value:g}; wanted a number above 0, at most {highest:g}"
    low, high = facts["duration_min_s"], facts["duration_max_s"]
    if low is not None and high is not None and low > high:
        yield "duration_min_s", f"at least {low:g} s and at most {high:g} s; wanted the smaller one first"
    priority = facts["playback_priority"]
    if priority is not None and not 0 <= priority <= 1000:
        yield "playback_priority", f"{priority}; wanted 0 to 1000"


def length_in_words(duration_s: float | None, min_s: float | None, max_s: float | None) -> str:
    """Return the length that a cue asks for, as a contract states it; empty where it asks for none."""
    if min_s is not None and max_s is not None:
        return f"{min_s:g} to {max_s:g} s"
    if min_s is not None or max_s is not None:
        return f"at least {min_s:g} s" if min_s is not None else f"at most {max_s:g} s"
    return f"{duration_s:.2f} s" if duration_s else ""


def spreadsheet_safe(text: str) -> str:
    """Return text that no spreadsheet takes for a formula, or for a broken one; `typed_text` undoes it."""
    return f"'{text}" if _is_like_formula(text) else text


def typed_text(cell: str) -> str:
    """Return the text typed into a cell that was made safe."""
    return cell[1:] if cell.startswith("'") and _is_like_formula(cell[1:]) else cell


def _is_like_formula(text: str) -> bool:
    return text.startswith((*FORMULA_STARTS, "'")) or audio_checks.is_broken_formula(text)
