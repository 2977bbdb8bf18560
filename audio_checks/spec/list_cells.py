"""The cells of people's sound lists: numbers, lengths, days, check boxes and words, as spreadsheets write them.

A reading that is not the plain meaning of its cell carries a note: what was guessed, and from what.
"""

import math
import re
import unicodedata
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import date, timedelta
from typing import Any

from audio_checks.spec.list_heads import COUNTED_UNITS, UNITS

STATES = ("concept", "prototype", "locked", "cut")
CHANNELS: Mapping[str, str] = {
    **dict.fromkeys(("mono", "m", "1", "1.0", "1ch", "1 ch", "1 channel", "mono 1.0"), "mono"),
    **dict.fromkeys(("stereo", "st", "s", "2", "2.0", "2ch", "2 ch", "2 channels", "stereo 2.0"), "stereo"),
}
PHASES = ("concept", "palette", "alpha", "beta", "gold")
REVERBS = ("dry", "designed-tail", "separate-tail")
NEEDS = ("must", "should", "wish")
EMPTY = frozenset({"", "-", "–", "—", "?", "n/a", "na", "none", "null", "tba", "tbd", "k.a.", "なし", "未定", "無"})
UNSPECIFIED = frozenset(
    {"varies", "variable", "various", "any", "any length", "as needed", "as long as needed", "open", "flexible", "var"}
    | {"variiert", "beliebig", "nach bedarf", "offen"}
)
YES = frozenset(
    {"yes", "y", "true", "1", "1.0", "x", "✓", "✔", "☑", "✅", "🗹", "[x]", "(x)", "on", "checked", "ticked", "ja", "j"}
    | {
        "wahr",
        "oui",
        "o",
        "vrai",
        "si",
        "sí",
        "verdadero",
        "はい",
        "有",
        "有り",
        "あり",
        "○",
        "〇",
        "◯",
        "する",
        "是",
        "loop",
    }
    | {"loops", "looping", "looped", "loopable", "seamless", "seamless loop", "endless", "endlos", "schleife", "boucle"}
    | {
        "bucle",
        "ループ",
        "ループする",
        "да",
        "tak",
        "sim",
        "sì",
        "예",
        "네",
        "循环",
        "循環",
        "루프",
        "цикл",
        "pętla",
    }
)
NO = frozenset(
    {"no", "n", "false", "0", "0.0", "☐", "✗", "✘", "❌", "✖", "×", "🗷", "[ ]", "[]", "( )", "off", "unchecked"}
    | {
        "not checked",
        "nein",
        "falsch",
        "non",
        "faux",
        "falso",
        "いいえ",
        "無し",
        "しない",
        "否",
        "one-shot",
        "one shot",
    }
    | {"oneshot", "single", "no loop", "not looped", "non-looping", "not looping", "einmalig", "単発", "ワンショット"}
    | {"нет", "nie", "não", "nao", "nee", "아니오", "아니요", "不", "不循环", "单次"}
)
PRIORITIES: Mapping[str, int] = {
    **dict.fromkeys(("highest", "critical", "must have", "höchste", "kritisch", "muss"), 1000),
    **dict.fromkeys(("high", "hoch", "wichtig"), 750),
    **dict.fromkeys(("medium", "mid", "med", "normal", "mittel"), 500),
    **dict.fromkeys(("low", "niedrig", "gering", "nice to have", "kann"), 250),
    **dict.fromkeys(("lowest", "niedrigste"), 0),
}
"""Playback priorities from 0 to 1000 for the words that lists use."""
NEED_WORDS: Mapping[str, str] = {
    **dict.fromkeys(
        ("must", "must have", "musthave", "m", "required", "mandatory", "essential", "muss", "doit"), "must"
    ),
    **dict.fromkeys(("should", "should have", "shouldhave", "s", "soll", "sollte", "devrait"), "should"),
    **dict.fromkeys(("wish", "could", "could have", "couldhave", "c", "w", "nice to have", "optional"), "wish"),
    **dict.fromkeys(("wunsch", "kann", "stretch", "stretch goal", "bonus", "deseable", "opcional"), "wish"),
}
RANKS: Mapping[str, str] = {
    **dict.fromkeys(
        ("highest", "critical", "crit", "blocker", "urgent", "very high", "high", "hi", "p0", "p1"), "must"
    ),
    **dict.fromkeys(
        ("prio 1", "höchste", "kritisch", "sehr hoch", "hoch", "wichtig", "haute", "élevée", "haut"), "must"
    ),
    **dict.fromkeys(("critique", "alta", "alto", "crítica", "muy alta", "a", "高", "最高", "必須", "至急"), "must"),
    **dict.fromkeys(("medium", "mid", "med", "normal", "moderate", "standard", "p2", "prio 2", "mittel"), "should"),
    **dict.fromkeys(("moyenne", "moyen", "normale", "media", "medio", "b", "中", "普通", "通常"), "should"),
    **dict.fromkeys(("low", "lo", "minor", "trivial", "very low", "lowest", "p3", "p4", "p5", "prio 3"), "wish"),
    **dict.fromkeys(
        ("niedrig", "niedrigste", "gering", "basse", "faible", "bas", "baja", "bajo", "低", "任意"), "wish"
    ),
}
"""Needs for the ranks of production tools: high, medium, low."""
WONT = frozenset({"won't", "wont", "won't have", "wont have", "wouldn't", "would", "would have"})
MONTHS: Mapping[str, int] = {
    name: month
    for month, names in enumerate(
        (
            "jan january januar jän jänner janv janvier ene enero",
            "feb february februar fév févr février febrero",
            "mar march mär märz mrz mars marzo",
            "apr april avr avril abr abril",
            "may mai mayo",
            "jun june juni juin junio",
            "jul july juli juil juillet julio",
            "aug august août aou aout ago agosto",
            "sep sept september septembre septiembre setiembre",
            "oct october okt oktober octobre octubre",
            "nov november novembre noviembre",
            "dec december dez dezember déc décembre dic diciembre",
        ),
        start=1,
    )
    for name in names.split()
}
NUMBER_WORDS: Mapping[str, int] = {
    word: number
    for number, words in enumerate(
        (
            "one single",
            "two",
            "three drei",
            "four vier",
            "five fünf",
            "six sechs",
            "seven",
            "eight acht",
            "nine",
            "ten zehn",
        ),
        start=1,
    )
    for word in words.split()
}
ERRORS = frozenset(
    {
        "#ref!",
        "#name?",
        "#n/a",
        "#value!",
        "#div/0!",
        "#null!",
        "#num!",
        "#spill!",
        "#calc!",
        "#error!",
        "#getting_data",
    }
    | {"#field!", "#blocked!", "#connect!", "#unknown!", "#busy!", "#bezug!", "#wert!", "#nv", "#zahl!", "#überlauf!"}
    | {"#nom?", "#valeur!", "#nombre!", "#¿nombre?", "#¡ref!", "#¡valor!", "#¡div/0!", "#¡num!", "#error"}
)
"""What a spreadsheet writes in place of a result, in the languages that it speaks."""
SLASHED = re.compile(r"(\d{1,2})[/-](\d{1,2})[/-](\d{2}|\d{4})", re.ASCII)
LOOP_WORDS = frozenset({"loop", "looping", "looped", "one-shot", "one shot", "oneshot"})
SAMPLED = 50
MAX_FIGURE_CHARS = 100  # of a cell with a number, a flag or a word of ours, which expressions are run on
FIRST_SERIAL, LAST_SERIAL = 36_526, 73_050  # days of the years 2000 to 2099 as spreadsheets count them
SERIAL_EPOCH = date(1899, 12, 30)

_DAY_NAME = re.compile(
    r"^(?:(?:mon|tues?|wed(?:nes)?|thu(?:rs)?|fri|sat(?:ur)?|sun)(?:day)?|(?:montag|dienstag|mittwoch|donnerstag|freitag|"
    r"samstag|sonnabend|sonntag|mo|di|mi|do|fr|sa|so)|(?:lundi|mardi|mercredi|jeudi|vendredi|samedi|dimanche)|"
    r"(?:lunes|martes|miércoles|jueves|viernes|sábado|domingo))[.,]*\s+(?:den\s+|the\s+|le\s+|el\s+)?"
)
_TIME_OF_DAY = re.compile(r"[t,]?\s*(?:at |um |à )?\d{1,2}:\d{2}(?::\d{2}(?:\.\d{1,6})?)?\s*(?:am|pm|uhr|z|utc|gmt)?$")
_ERA_DAY = re.compile(r"(\d{4})\s*[年년]\s*(\d{1,2})\s*[月월]\s*(\d{1,2})\s*[日일]?(?:\s*\([^)]{1,3}\))?")
_ABOUT = re.compile(
    r"^(?:~|≈|≃|∼|〜|±|(?:ca|c|approx|appr|est|env|aprox|ungef|circa|about|around|roughly|approximately|ungefähr|etwa|"
    r"environ|aproximadamente|約|およそ)(?![a-z])\.?)\s*"
)
_MOST = re.compile(
    r"^(?:<=?|≤|＜|(?:max(?:imum|imal)?|up to|at most|under|less than|below|no more than|not more than|within|bis zu|"
    r"höchstens|unter|maximal|kürzer als|jusqu'à|moins de|hasta|menos de|máx)(?![a-z])\.?)\s*"
)
_LEAST = re.compile(
    r"^(?:>=?|≥|＞|(?:min(?:imum|imal)?|at least|over|more than|longer than|above|mind|mindestens|mehr als|über|ab|"
    r"au moins|plus de|al menos|más de|mín)(?![a-z])\.?)\s*"
)
_MOST_AFTER = re.compile(r"\s*(?:\(?max\.?(?:imum)?\)?|or less|or shorter|tops|以下|以内|未満)$")
_LEAST_AFTER = re.compile(r"\s*(?:\+|\(?min\.?imum\)?|or more|or longer|以上)$")
_ABOUT_AFTER = re.compile(r"\s*(?:\(?approx\.?\)?|\(?ca\.?\)?|or so|ish|程度|くらい|前後)$")
_BETWEEN = re.compile(r"^(?:between|from|von|zwischen|de|entre)\s+")
_RANGE_MARK = re.compile(r"\s*(?:–|—|−|～|〜|~|…|\.{2,3}|(?<=[\ds.])\s*-\s*(?=[\d.])|(?<=[a-z秒分])\s*-\s*(?=[\d.])|"
                         r"\s(?:to|bis|and|und|à|a|y|et|or|oder|-)\s)\s*")  # fmt: skip
_CLOCK = re.compile(r"(?:(\d{1,2}):)?(\d{1,3}):(\d{1,2}(?:[.,]\d+)?)(?:\s*(?:h|min|m|s|sec|h:m:s|m:ss)\.?)?", re.ASCII)
_TIMECODE = re.compile(r"(\d{1,2}):(\d{2}):(\d{2})[:;](\d{2,3})", re.ASCII)
_PARTS = re.compile(
    r"(?:(\d{1,2})\s*(?:h|hr|hrs|std)\.?)?\s*(?:(\d{1,4})\s*(?:m|min|mins|minutes?|minuten?|['’′]|分))?\s*"
    r"(?:(\d{1,4}(?:[.,]\d{1,6})?)\s*(?:s|sec|secs|seconds?|sek|sekunden?|\"|”|″|''|秒))?",
    re.ASCII,
)
_MINUTES_AND_REST = re.compile(r"(\d{1,3})\s*(?:min\.?\s+|['’′])\s*(\d{1,2}(?:[.,]\d{1,6})?)", re.ASCII)
_WITH_UNIT = re.compile(r"(.*[0-9.,])\s*([^\W\d_]+)\.?")


@dataclass(frozen=True)
class CellContext:
    """Facts that a cell does not say itself."""

    unit_s: float = 1.0  # seconds in the unit of the column's head
    counted: str = ""  # "frames" or "samples" where the head counts those
    frame_rate_fps: float | None = None
    sample_rate_hz: float | None = None
    day_first: bool | None = None  # whether 4/5/2026 is in May; None where nothing shows it


@dataclass(frozen=True)
class Reading:
    """The value of a cell; a note where it is not the cell's plain meaning."""

    value: Any
    note: str = ""
    is_part: bool = False  # the cell says more than the value, which the list has no field for
    low: float | None = None  # the bounds of a length: "at least 1 s", "0.5–1 s"
    high: float | None = None


PLAIN = CellContext()


def is_broken_formula(text: str) -> bool:
    """Return whether a spreadsheet wrote this in place of a result."""
    plain = text.strip().casefold()
    return plain in ERRORS or re.fullmatch(r"err:\d{3}", plain) is not None


def read_number(text: str) -> float:
    """Return a number as people type it: 1.5, 1,5, 1.234,5, ~2; raise ValueError for anything else."""
    plain = unicodedata.normalize("NFKC", text.strip().lower())
    plain = re.sub(r"^(~|≈|ca\.?|approx\.?)\s*", "", plain.replace("\xa0", "").replace("'", ""))
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


def _read_duration(text: str, context: CellContext) -> Reading:
    plain = unicodedata.normalize("NFKC", text.strip().lower()).replace("\xa0", " ")
    plain = re.sub(r"\s*\(?(?:loop|looped|looping|one-shot)\)?$", "", plain) or plain
    if text.strip().lower() in EMPTY:
        return Reading(None)
    if plain in UNSPECIFIED:
        return Reading(None, "no length is set", is_part=True)
    reading = _bounded_length(plain, text, context)
    if reading.value <= 0:
        raise ValueError(f'wanted a length above 0, found "{text[:40]}"')
    return reading


def _bounded_length(plain: str, text: str, context: CellContext) -> Reading:
    for pattern, words in ((_MOST, "at most"), (_LEAST, "at least")):
        if (match := pattern.match(plain)) and (rest := plain[match.end() :]):
            value = _seconds_in(rest, text, context)
            return _bound(words, value)
    for pattern, words in ((_MOST_AFTER, "at most"), (_LEAST_AFTER, "at least"), (_ABOUT_AFTER, "about")):
        if (match := pattern.search(plain)) and match.start():
            value = _seconds_in(plain[: match.start()], text, context)
            return _bound(words, value)
    if match := _ABOUT.match(plain):
        reading = _bounded_length(plain[match.end() :], text, context) if match.end() < len(plain) else None
        if reading is None:
            raise _no_length(text)
        return replace(reading, note=reading.note or f"about {number_text(reading.value)} s")
    if match := re.fullmatch(r"(.{1,20}?)\s*(?:±|\+/-|\+-)\s*.{1,20}", plain):
        value = _seconds_in(match[1], text, context)
        return Reading(value, "the tolerance is not kept; the spec has one for lengths", is_part=True)
    try:
        reading = _with_clock_note(plain, _seconds_in(plain, text, context))
        unit = _WITH_UNIT.fullmatch(plain)
        if unit and COUNTED_UNITS.get(unit[2]) == "samples":
            return replace(reading, note=f"at {context.sample_rate_hz:,g} Hz")
        return reading
    except ValueError:
        ends = _RANGE_MARK.split(_BETWEEN.sub("", plain))
        if len(ends) != 2 or not all(ends):
            raise
    return _middle(ends[0], ends[1], text, context)


def _bound(words: str, value: float) -> Reading:
    low, high = value if words == "at least" else None, value if words == "at most" else None
    return Reading(value, f"{words} {number_text(value)} s", low=low, high=high)


def _middle(first: str, last: str, text: str, context: CellContext) -> Reading:
    if (unit := _WITH_UNIT.fullmatch(last)) and not re.search(r"[^\W\d_]|:", first):
        first = f"{first} {unit[2]}"  # 1-2 min: the unit is of both
    low, high = _seconds_in(first, text, context), _seconds_in(last, text, context)
    if low > high:
        raise _no_length(text)
    value = round((low + high) / 2, 6)
    return Reading(value, f"{number_text(low)} to {number_text(high)} s", low=low, high=high)


def _with_clock_note(plain: str, value: float) -> Reading:
    match = _CLOCK.fullmatch(plain)
    if match and match[1] and int(match[1]) and float(match[3].replace(",", ".")) == 0:
        hours, minutes = int(match[1]), int(match[2])
        return Reading(
            value, f"{hours} h {minutes} min; if {hours} min {minutes} s was meant, write 0:{hours}:{minutes:02}"
        )
    return Reading(value)


def _no_length(text: str) -> ValueError:
    return ValueError(f'wanted seconds such as 1.5, found "{text[:40]}"')


def _seconds_in(plain: str, text: str, context: CellContext) -> float:
    plain = plain.strip()
    if match := _CLOCK.fullmatch(plain):
        hours, minutes, seconds = match[1], match[2], match[3]
        return int(hours or 0) * 3600 + int(minutes) * 60 + float(seconds.replace(",", "."))
    if match := _TIMECODE.fullmatch(plain):
        hours, minutes, seconds, frames = (int(part) for part in match.groups())
        return round(hours * 3600 + minutes * 60 + seconds + frames * _unit_s("frames", text, context), 6)
    if (match := _PARTS.fullmatch(plain)) and sum(part is not None for part in match.groups()) > (
        0 if plain[-1:] in "\"”″'’′" else 1
    ):
        hours, minutes, seconds = match.groups()
        return round(int(hours or 0) * 3600 + int(minutes or 0) * 60 + float((seconds or "0").replace(",", ".")), 6)
    if match := _MINUTES_AND_REST.fullmatch(plain):  # 1'30
        return round(int(match[1]) * 60 + float(match[2].replace(",", ".")), 6)
    if match := _WITH_UNIT.fullmatch(plain):
        plain = match[1]
        if match[2] in COUNTED_UNITS or (match[2] == "f" and context.frame_rate_fps):
            unit_s = _unit_s(COUNTED_UNITS.get(match[2], "frames"), text, context)
        elif match[2] not in UNITS:
            raise _no_length(text)
        else:
            unit_s = UNITS[match[2]]
    elif context.counted:
        unit_s = _unit_s(context.counted, text, context)
    else:
        unit_s = context.unit_s
    if unit_s < 0.01 and re.fullmatch(r"\d{1,3}([,.]\d{3})+", plain):  # 1,500 ms: nobody counts a thousandth of one
        plain = re.sub("[,.]", "", plain)
    try:
        return round(read_number(plain) * unit_s, 6)
    except ValueError:
        raise _no_length(text) from None


def _unit_s(counted: str, text: str, context: CellContext) -> float:
    rate = context.frame_rate_fps if counted == "frames" else context.sample_rate_hz
    if not rate:
        what = "frame rate" if counted == "frames" else "sample rate"
        raise ValueError(f'"{text[:40]}" is in {counted}; say the {what}, or write seconds')
    return 1 / rate


def _read_rate(text: str, _context: CellContext) -> Reading:
    if text.strip().lower() in EMPTY:
        return Reading(None)
    value = read_number(re.sub(r"\s*(fps|bilder/s|frames/s)$", "", text.strip().lower()))
    if value <= 0:
        raise ValueError(f'wanted frames per second above 0, found "{text[:40]}"')
    return Reading(value)


def _read_count(text: str, _context: CellContext) -> Reading:
    if text.strip().lower() in EMPTY:
        return Reading(1)
    plain = unicodedata.normalize("NFKC", text.strip().lower())
    if match := re.fullmatch(r"[x×]?\s*([0-9]{1,6})(?:[.,]0+)?\s*[x×]?(?:\s*[(\[]?[^\W\d_][^\d]{0,30})?", plain):
        return Reading(int(match[1]))
    if plain in NUMBER_WORDS:
        return Reading(NUMBER_WORDS[plain])
    if match := re.fullmatch(
        r"(~|≈|ca\.?|approx\.?|about|min\.?|max\.?|up to|at least|>=?|<=?|≥|≤)\s*([0-9]{1,6})", plain
    ):
        return Reading(int(match[2]), f"{match[1]} {match[2]}; the list keeps one number", is_part=True)
    if match := re.fullmatch(r"([0-9]{1,6})\s*(?:\+|or more|以上)", plain):
        return Reading(int(match[1]), f"at least {match[1]}; the list keeps one number", is_part=True)
    if match := re.fullmatch(r"([0-9]{1,6})\s*(?:-|–|—|−|~|to|bis|à|or|/)\s*([0-9]{1,6})(?:\s*[^\W\d_]{1,20})?", plain):
        most = max(int(match[1]), int(match[2]))
        return Reading(most, f"the larger of {match[1]} and {match[2]}", is_part=True)
    raise ValueError(f'wanted a whole number, found "{text[:40]}"')


def _read_priority(text: str, context: CellContext) -> Reading:
    plain = " ".join(re.split(r"[\s_-]+", text.strip().lower()))
    if plain in PRIORITIES:
        return Reading(PRIORITIES[plain], f"{PRIORITIES[plain]} for {text.strip()[:40]}")
    return Reading(None) if text.strip().lower() in EMPTY else _read_count(text, context)


def _read_flag(text: str, _context: CellContext) -> Reading:
    plain = " ".join(text.strip().lower().replace("\ufe0f", "").replace("\ufe0e", "").split())
    for words in (plain, re.split(r"\s*[,;(:]|\s[-–—]\s", plain)[0]):  # yes, seamless
        if words in YES:
            return Reading(value=True)
        if words in NO or plain in EMPTY:
            return Reading(value=False)
    raise ValueError(f'wanted yes or no, found "{text[:40]}"')


def _read_state(text: str, _context: CellContext) -> Reading:
    plain = text.strip().lower()
    if plain in EMPTY:
        return Reading(None)
    if plain not in STATES:
        raise ValueError(f'wanted {", ".join(STATES)}, found "{text[:40]}"')
    return Reading(plain)


def _read_reverb(text: str, _context: CellContext) -> Reading:
    plain = re.sub(r"[\s_]+", "-", text.strip().lower())
    if plain in EMPTY:
        return Reading(None)
    if plain not in REVERBS:
        raise ValueError(f'wanted {", ".join(REVERBS)}, found "{text[:40]}"')
    return Reading(plain)


def _read_channels(text: str, _context: CellContext) -> Reading:
    plain = " ".join(re.split(r"[\s_-]+", text.strip().lower()))
    if plain in EMPTY:
        return Reading(None)
    if plain not in CHANNELS:
        raise ValueError(f'wanted mono, stereo, or nothing for what the spec says, found "{text[:40]}"')
    return Reading(CHANNELS[plain])


def _read_phase(text: str, _context: CellContext) -> Reading:
    plain = text.strip().lower()
    if plain in EMPTY:
        return Reading(None)
    if plain not in PHASES:
        raise ValueError(f'wanted {", ".join(PHASES)}, found "{text[:40]}"')
    return Reading(plain)


def _read_need(text: str, _context: CellContext) -> Reading:
    if text.strip().lower() in EMPTY:
        return Reading(None)
    plain = " ".join(re.split(r"[\s_-]+", text.strip().lower()))
    bare = re.sub(r"^\W*(?:\d\W+)?|\W*(?:\(.{0,20}\))?\W*$", "", plain)  # without a coloured circle, "1 -" or "(P1)"
    for words in (plain, bare):
        if words in NEED_WORDS:
            return Reading(NEED_WORDS[words])
        if words in RANKS:
            return Reading(RANKS[words], f'"{text.strip()[:40]}" is read as {RANKS[words]}')
        if words.replace("’", "'") in WONT:
            return Reading("wish", f'"{text.strip()[:40]}" is read as wish; skip the row if no sound is wanted')
    raise ValueError(f'wanted {", ".join(NEEDS)}, found "{text[:40]}"')


def is_day_first(cells: Sequence[str]) -> bool | None:
    """Return whether a column writes the day before the month, as in 31/5/2026; None where no cell shows it."""
    for cell in cells:
        if match := SLASHED.match(cell.strip()[:MAX_FIGURE_CHARS]):
            if int(match[1]) > 12:
                return True
            if int(match[2]) > 12:
                return False
    return None


def read_day(text: str, day_first: bool | None = None) -> date | None:
    """Return a day as people type it; raise ValueError where it is none, or could be two."""
    value: date | None = _read_day(text, CellContext(day_first=day_first)).value
    return value


def _read_day(text: str, context: CellContext) -> Reading:
    plain = " ".join(unicodedata.normalize("NFKC", text).strip().lower().split())
    if plain in EMPTY:
        return Reading(None)
    if len(plain) > MAX_FIGURE_CHARS:
        raise ValueError(f'wanted a day such as 2026-12-04, found "{text[:40]}"')
    if match := re.fullmatch(r"(.{6,40}?)\s*(?:→|->|–|—|\sto\s|\sbis\s)\s*(.{6,40})", plain):
        last = _read_day(match[2], context)  # a period, as project tools write it: needed by its end
        return Reading(last.value, f"the end of {text.strip()[:60]}", is_part=True)
    bare = _DAY_NAME.sub("", plain)
    bare = _TIME_OF_DAY.sub("", bare).strip(" ,")
    try:
        reading = _day_in(bare, text, context)
    except _TwoDays as error:
        raise ValueError(str(error)) from None
    except ValueError:
        reading = None
    if reading is None:
        words = re.findall(r"[^\W\d_]{3,}", bare)
        has_month = len(words) == 1 and words[0] in MONTHS and len(re.findall(r"\d+", bare)) == 1
        if (has_month and not re.search(r"\d{4}", bare)) or re.fullmatch(r"\d{1,2}[./月]\s*\d{1,2}[.日]?", bare):
            raise ValueError(f'"{text[:40]}" has no year; write a day such as 2026-12-04')
        raise ValueError(f'wanted a day such as 2026-12-04, found "{text[:40]}"')
    return reading


class _TwoDays(ValueError):
    """A day could be two."""


def _day_in(plain: str, text: str, context: CellContext) -> Reading | None:
    if match := re.fullmatch(r"(\d{4})[-/.]\s?(\d{1,2})[-/.]\s?(\d{1,2})\.?(?:[t ].*)?", plain, re.ASCII):
        return Reading(date(int(match[1]), int(match[2]), int(match[3])))
    if match := re.fullmatch(r"(20\d{2})(\d{2})(\d{2})", plain, re.ASCII):
        return Reading(date(int(match[1]), int(match[2]), int(match[3])))
    if match := _ERA_DAY.fullmatch(plain):
        return Reading(date(int(match[1]), int(match[2]), int(match[3])))
    if match := re.fullmatch(r"(\d{1,2})\.\s*(\d{1,2})\.\s*(\d{2}|\d{4})", plain, re.ASCII):
        return Reading(date(_year(match[3]), int(match[2]), int(match[1])))
    if match := SLASHED.fullmatch(plain):
        return _slashed_day(match, text, context.day_first)
    if match := re.fullmatch(
        r"(\d{1,2})(?:st|nd|rd|th|er|º|\.)?[\s/-]*(?:of |de |d')?\s*([^\W\d_]{3,10})\.?,?[\s/-]*(?:of |de |del )?"
        r"'?(\d{4}|\d{2})",
        plain,
    ):
        return Reading(date(_year(match[3]), MONTHS.get(match[2], 0), int(match[1])))
    if match := re.fullmatch(
        r"([^\W\d_]{3,10})\.?[\s/-]*(\d{1,2})(?:st|nd|rd|th)?(?:,\s*|[\s/-]+)'?(\d{4}|\d{2})", plain
    ):
        return Reading(date(_year(match[3]), MONTHS.get(match[1], 0), int(match[2])))
    if match := re.fullmatch(r"(\d{4})[\s/-]+([^\W\d_]{3,10})\.?[\s/-]+(\d{1,2})", plain):
        return Reading(date(int(match[1]), MONTHS.get(match[2], 0), int(match[3])))
    if re.fullmatch(r"\d{5}(?:\.\d+)?", plain, re.ASCII) and FIRST_SERIAL <= float(plain) <= LAST_SERIAL:
        day = SERIAL_EPOCH + timedelta(days=int(float(plain)))
        return Reading(day, f"{day} is day {int(float(plain)):,} as spreadsheets count them")
    return None


def _slashed_day(match: re.Match[str], text: str, day_first: bool | None) -> Reading:
    first, second, year = int(match[1]), int(match[2]), _year(match[3])
    if day_first is None and first != second and max(first, second) <= 12:
        raise _TwoDays(
            f'"{text[:40]}" could be {date(year, second, first):%d %B} or {date(year, first, second):%d %B}; '
            f"write {date(year, second, first)}"
        )
    is_day = first > 12 or (second <= 12 and bool(day_first))
    day = date(year, second, first) if is_day else date(year, first, second)
    is_shown = max(first, second) > 12 or first == second
    return Reading(day, "" if is_shown else f"{day:%d %B %Y}: the {'day' if is_day else 'month'} comes first")


def _year(digits: str) -> int:
    return int(digits) + (2000 if len(digits) == 2 else 0)


READERS: Mapping[str, Callable[[str, CellContext], Reading]] = {
    **dict.fromkeys(("duration_s", "duration_min_s", "duration_max_s"), _read_duration),
    "frame_rate_fps": _read_rate,
    "variations": _read_count,
    "playback_priority": _read_priority,
    "length_locked": _read_flag,
    "loop": _read_flag,
    "placeholder": _read_flag,
    "palette": _read_flag,
    "state": _read_state,
    "reverb": _read_reverb,
    "channels": _read_channels,
    "phase": _read_phase,
    "need": _read_need,
    "due_on": _read_day,
}


def reading_of(field: str, text: str, context: CellContext = PLAIN) -> Reading:
    """Return the reading of a cell for a field; raise ValueError that says what was wanted and what was found."""
    if is_broken_formula(text):
        raise ValueError(f'"{text.strip()[:40]}" is a broken formula; repair it in the spreadsheet')
    reader = READERS.get(field)
    if reader is None:
        return Reading(text)
    if len(text) > MAX_FIGURE_CHARS:
        raise ValueError(f'{len(text):,} characters; wanted {MAX_FIGURE_CHARS} at most, found "{text[:40]}"')
    return reader(text, context)


def read_cell(field: str, text: str, unit_s: float = 1.0, day_first: bool | None = None) -> Any:
    """Return the value of a cell for a field; raise ValueError that says what was wanted and what was found."""
    return reading_of(field, text, CellContext(unit_s=unit_s, day_first=day_first)).value


def says_loop(cells: Sequence[str]) -> bool:
    """Return whether every filled cell of a column says loop or one-shot, whatever its head."""
    filled = [cell.strip().lower() for cell in cells if cell.strip()]
    return bool(filled) and LOOP_WORDS.issuperset(filled)


def says_need(cells: Sequence[str]) -> bool:
    """Return whether most filled cells of a column are words for a need, such as high, P2 or must have."""
    filled = [cell for cell in cells if cell.strip()][:SAMPLED]
    return bool(filled) and 2 * (len(filled) - len(unreadable("need", filled))) >= len(filled)


def unreadable(field: str, cells: Sequence[str], context: CellContext = PLAIN) -> list[str]:
    """Return the filled cells of a column that cannot be read for a field."""
    wrong = []
    either = context.day_first is None  # either order shows that these are days
    for cell in (cell for cell in cells if cell.strip()):
        try:
            reading_of(field, cell, CellContext(**{**vars(context), "day_first": True}) if either else context)
        except ValueError:
            wrong.append(cell)
    return wrong
