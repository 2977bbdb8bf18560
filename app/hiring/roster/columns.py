"""The meaning of columns in people's lists of designers, and how their cells are read."""

import re
import unicodedata
from collections.abc import Callable, Mapping, Sequence
from datetime import date
from enum import StrEnum
from typing import Any

from app.accounts.errors import BadAddress
from app.accounts.rules import ensure_address
from app.core.money import minor_digits
from app.hiring.roster.rules import Exclusivity, RateUnit, RosterService, tidy_values
from audio_checks import read_day, read_number

MAX_HEAD_CHARS = 100
MAX_CELL_CHARS = 5_000  # as many as the longest text of an entry
MAX_WORD_CHARS = 60
MAX_WORDS = 30


class RosterField(StrEnum):
    """A possible reading of a column."""

    NAME = "name"
    EMAIL = "email"
    SPECIALITIES = "specialities"
    SERVICES = "services"
    LANGUAGES = "languages"
    EQUIPMENT = "equipment"
    CREDITS = "credits"
    REFEREES = "referees"
    LINKS = "links"
    EXCLUSIVITY = "exclusivity"
    WEEKLY_HOURS = "weekly_hours"
    AVAILABLE_FROM_ON = "available_from_on"
    RATE = "rate"
    NOTES = "notes"
    IGNORE = "ignore"


HEADS: Mapping[RosterField, str] = {
    RosterField.NAME: "name|full name|designer|sound designer|contact|contact name|person|who|freelancer",
    RosterField.EMAIL: "email|e mail|mail|email address|e mail address|address|contact email|mailadresse|"
    "e mail adresse",
    RosterField.SPECIALITIES: "specialities|speciality|specialties|specialty|specialisation|specialization|skills|"
    "skill|strengths|categories|tags|schwerpunkte|schwerpunkt",
    RosterField.SERVICES: "services|service|capabilities|also does|also|offers|roles|role|leistungen",
    RosterField.LANGUAGES: "languages|language|speaks|sprachen|sprache",
    RosterField.EQUIPMENT: "equipment|gear|studio|setup|microphones|daw|software|ausrüstung|technik",
    RosterField.CREDITS: "credits|credit|games|shipped|shipped games|shipped titles|titles|experience|projekte|"
    "references games",
    RosterField.REFEREES: "references|reference|referees|referee|recommended by|referred by|referenzen|empfohlen von",
    RosterField.LINKS: "links|link|reel|demo reel|demoreel|showreel|website|site|web|url|portfolio|webseite",
    RosterField.EXCLUSIVITY: "exclusivity|exclusive|works alone|exklusiv|exklusivität",
    RosterField.WEEKLY_HOURS: "weekly hours|hours per week|hours a week|hours week|h week|load|capacity|"
    "availability hours|wochenstunden",
    RosterField.AVAILABLE_FROM_ON: "available from|available|free from|availability|available on|start|verfügbar ab|"
    "frei ab",
    RosterField.RATE: "rate|rates|day rate|hourly rate|price|fee|cost|satz|stundensatz|tagessatz|honorar",
    RosterField.NOTES: "notes|note|comments|comment|remarks|remark|notizen|bemerkung|bemerkungen",
}
SERVICE_HEADS: Mapping[RosterService, str] = {
    RosterService.COMPOSES: "composes|composes music|composer|composition|composing|music|musik|komponiert",
    RosterService.DIRECTS: "directs|directs voice sessions|direction|director|voice direction|voice director|"
    "vo direction|directing|regie|sprachregie",
    RosterService.SUPPLIES_TALENT: "supplies talent|supplies voice talent|talent|voice talent|casting|voice casting|"
    "voices|sprecher",
    RosterService.NARRATION: "narration|records narration|narrator|voice over|voiceover|vo",
    RosterService.FIELD_RECORDING: "field recording|field recordings|records in the field|location recording|foley",
    RosterService.IMPLEMENTS: "implements|implements in the engine|implementation|implementer|technical sound design|"
    "wwise|fmod|integration",
}
EXCLUSIVITY_WORDS: Mapping[Exclusivity, str] = {
    Exclusivity.ALONE: "alone|yes|y|ja|exclusive|exclusively|one project|one project at a time|true|x",
    Exclusivity.SEVERAL: "several|no|n|nein|not exclusive|non exclusive|shared|several projects|"
    "several projects at once|false",
    Exclusivity.UNKNOWN: "unknown|ask|tbd|?",
}
SYMBOLS = {"$": "USD", "€": "EUR", "£": "GBP", "¥": "JPY"}
PER_HOUR = "h|hr|hrs|hour|hours|hourly|stunde|std"
PER_DAY = "d|day|days|daily|tag"
RATE = re.compile(
    r"(?P<before>[A-Za-z]{3}|[$€£¥])?\s*(?P<number>[0-9][0-9.,' ]{0,20})\s*(?P<after>[A-Za-z]{3}|[$€£¥])?"
    r"\s*(?:(?:/|per|an?|pro|je)\s*)?(?P<unit>[a-z]{1,8})?\.?",
    re.IGNORECASE,
)


def _plain(text: str) -> str:
    return " ".join(re.split(r"[\W_]+", unicodedata.normalize("NFKC", text).casefold())).strip()


def _by_word(words: Mapping[Any, str]) -> dict[str, Any]:
    return {_plain(word): value for value, listed in words.items() for word in (str(value), *listed.split("|"))}


_FIELD_OF, _SERVICE_OF, _EXCLUSIVITY_OF = _by_word(HEADS), _by_word(SERVICE_HEADS), _by_word(EXCLUSIVITY_WORDS)


def field_of(head: str) -> RosterField | None:
    """Return the meaning of a column's head, whatever its case and punctuation; None for a head that is not known."""
    if len(head) > MAX_HEAD_CHARS:
        return None
    without_brackets = re.sub(r"\(.*?\)|\[.*?\]", " ", head)
    field: RosterField | None = _FIELD_OF.get(_plain(head)) or _FIELD_OF.get(_plain(without_brackets))
    return field


def known_heads_in(cells: Sequence[str]) -> int:
    """Return the number of known heads among the cells of a row, each field counted once."""
    return len({field for cell in cells if cell.strip() and (field := field_of(cell))})


def parts_of(text: str) -> list[str]:
    """Return the items of a cell between commas, semicolons, slashes or line ends."""
    return tidy_values(re.split(r"[,;/|\n]", text))


def _read_words(text: str) -> list[str]:
    words = parts_of(text)
    if len(words) > MAX_WORDS:
        raise ValueError(f"wanted {MAX_WORDS} at most, found {len(words)}")
    if long := next((word for word in words if len(word) > MAX_WORD_CHARS), None):
        raise ValueError(
            f'wanted words of {MAX_WORD_CHARS} characters at most, separated by commas; found "{long[:40]}"'
        )
    return words


def _read_services(text: str) -> list[str]:
    services = []
    for part in parts_of(text):
        service = _SERVICE_OF.get(_plain(part))
        if service is None:
            raise ValueError(f'wanted {", ".join(RosterService)}, found "{part[:40]}"')
        services.append(str(service))
    return list(dict.fromkeys(services))


def _read_links(text: str) -> list[dict[str, str]]:
    urls = re.split(r"[\s;|]+|,\s+", text.strip())
    return [{"title": "", "url": url if "://" in url else f"https://{url}"} for url in urls if url]


def _read_email(text: str) -> str:
    bare = re.sub(r"^mailto:", "", text.strip(), flags=re.IGNORECASE)
    if match := re.fullmatch(r".{0,200}<([^<>]{1,254})>", bare):
        bare = match[1]
    try:
        return ensure_address(bare)
    except BadAddress:
        raise ValueError(f'wanted an email such as name@studio.example, found "{text[:40]}"') from None


def _read_exclusivity(text: str) -> Exclusivity:
    exclusivity: Exclusivity | None = _EXCLUSIVITY_OF.get(_plain(text))
    if exclusivity is None:
        raise ValueError(f'wanted alone or several, found "{text[:40]}"')
    return exclusivity


def _read_hours(text: str) -> int:
    plain = re.sub(r"\s*(h|hr|hrs|hours?)?\s*((/|per|a)\s*(w|wk|week))?\.?$", "", text.strip().lower())
    hours = read_number(plain)
    if not 1 <= hours <= 168:
        raise ValueError(f'wanted hours a week from 1 to 168, found "{text[:40]}"')
    return round(hours)


def read_rate(text: str) -> dict[str, Any]:
    """Return amount, currency and unit of a rate such as "45 EUR/h" or "$400 a day"; raise ValueError for others."""
    wanted = ValueError(f'wanted a rate such as 45 USD/hour or 400 EUR/day, found "{text[:40]}"')
    match = RATE.fullmatch(text.strip())
    if match is None:
        raise wanted
    currency = match["before"] or match["after"]
    unit = (match["unit"] or "").lower()
    is_hour, is_day = unit in PER_HOUR.split("|"), unit in PER_DAY.split("|")
    if currency is None or not (is_hour or is_day):
        raise wanted
    code = SYMBOLS.get(currency, currency.upper())
    amount = round(read_number(match["number"].replace(" ", "")) * 10 ** minor_digits(code))
    if not 0 <= amount <= 10**10:
        raise wanted
    return {"rate_minor": amount, "rate_currency": code, "rate_unit": RateUnit.HOUR if is_hour else RateUnit.DAY}


def _read_day(text: str) -> date | None:
    if text.strip().casefold() in ("now", "immediately", "sofort", "yes", "ja"):
        return None
    return read_day(text)


def _read_name(text: str) -> str:
    name = " ".join(text.split())
    if len(name) > 120:
        raise ValueError(f"wanted a name of 120 characters at most, found {len(name)}")
    return name


READERS: Mapping[RosterField, Callable[[str], Any]] = {
    RosterField.NAME: _read_name,
    RosterField.EMAIL: _read_email,
    RosterField.SPECIALITIES: _read_words,
    RosterField.SERVICES: _read_services,
    RosterField.LANGUAGES: _read_words,
    RosterField.LINKS: _read_links,
    RosterField.EXCLUSIVITY: _read_exclusivity,
    RosterField.WEEKLY_HOURS: _read_hours,
    RosterField.AVAILABLE_FROM_ON: _read_day,
    RosterField.RATE: read_rate,
}


def read_cell(field: RosterField, text: str) -> Any:
    """Return the value of a filled cell for a field; raise ValueError that says what was wanted and what was found."""
    if len(text) > MAX_CELL_CHARS:
        raise ValueError(f"wanted {MAX_CELL_CHARS:,} characters at most, found {len(text):,}")
    reader = READERS.get(field)
    return reader(text) if reader else text.strip()
