"""Languages, names, the state of a line by its takes, lengths and releases: without a database."""

import re
from collections.abc import Hashable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from datetime import date, datetime
from enum import StrEnum
from typing import TypeVar
from uuid import UUID

import audio_checks
from app.deliveries.rules import TakeState

DEFAULT_LANGUAGE = "en"
DEFAULT_TOLERANCE_PERCENT = 10
CATEGORY = "vo"  # of the cues that are made for lines; the presets of the delivery spec have it
MAX_KEY_CHARS = 100
MAX_FILES_CHARS = 5_000  # of a cell that names each file of a line
MAX_NAME_CHARS = 120
MAX_SCENE_CHARS = 200
MAX_TEXT_CHARS = 5_000
MAX_DIRECTION_CHARS = 2_000
MAX_LANGUAGES = 60

_TAG = re.compile(r"([a-z]{2,3})(?:[-_]([a-z]{4}))?(?:[-_]([a-z]{2}|[0-9]{3}))?", re.IGNORECASE | re.ASCII)
_NAMES: Mapping[str, str] = {
    "ar": "arabic|arabisch|العربية",
    "cs": "czech|tschechisch|čeština",
    "da": "danish|dänisch|dansk",
    "de": "german|deutsch",
    "el": "greek|griechisch|ελληνικά",
    "en": "english|englisch|original english",
    "es": "spanish|spanisch|español|espanol",
    "fi": "finnish|finnisch|suomi",
    "fr": "french|französisch|français|francais",
    "hi": "hindi",
    "hu": "hungarian|ungarisch|magyar",
    "id": "indonesian|indonesisch|bahasa indonesia",
    "it": "italian|italienisch|italiano",
    "ja": "japanese|japanisch|日本語",
    "ko": "korean|koreanisch|한국어",
    "nl": "dutch|niederländisch|nederlands",
    "no": "norwegian|norwegisch|norsk",
    "pl": "polish|polnisch|polski",
    "pt": "portuguese|portugiesisch|português|portugues",
    "ro": "romanian|rumänisch|română",
    "ru": "russian|russisch|русский",
    "sv": "swedish|schwedisch|svenska",
    "th": "thai|thailändisch|ไทย",
    "tr": "turkish|türkisch|türkçe",
    "uk": "ukrainian|ukrainisch|українська",
    "vi": "vietnamese|vietnamesisch|tiếng việt",
    "zh": "chinese|chinesisch|中文",
    "zh-Hans": "simplified chinese|chinese simplified",
    "zh-Hant": "traditional chinese|chinese traditional",
    "pt-BR": "brazilian portuguese|portuguese brazil",
    "es-419": "latin american spanish|spanish latin america",
}
_BY_NAME = {name: tag for tag, names in _NAMES.items() for name in names.split("|")}
Place = TypeVar("Place", bound=Hashable)


class SyntheticUse(StrEnum):
    """A release's statement on a digital replica of the voice."""

    YES = "yes"
    NO = "no"
    NOT_ASKED = "not_asked"


class LineState(StrEnum):
    """The state of a line in one language."""

    NO_TEXT = "no_text"  # not translated yet
    NO_TAKE = "no_take"
    STALE = "stale"
    RETURNED = "returned"
    CHANGE_REQUESTED = "change_requested"
    IN_REVIEW = "in_review"  # delivered: being checked, or awaiting the verdict
    APPROVED = "approved"
    CUT = "cut"


PICK_UPS = (LineState.NO_TAKE, LineState.STALE, LineState.RETURNED, LineState.CHANGE_REQUESTED)
_FURTHEST_FIRST = (LineState.NO_TEXT, LineState.CUT, *PICK_UPS, LineState.IN_REVIEW, LineState.APPROVED)


@dataclass(frozen=True)
class TakeFacts:
    """The facts of one take that its line's state depends on."""

    id: UUID
    variation: int
    number: int
    state: TakeState
    received_at: datetime
    duration_s: float | None


@dataclass(frozen=True)
class TextFrom:
    """A text and the moment from which on it was the text of its line."""

    text: str
    written_at: datetime
    takes_fit: bool = False  # a person said that earlier takes still fit it


@dataclass(frozen=True)
class LineStatus:
    """The state of one file of a line, the take that it is judged by, and the text that this was made from."""

    state: LineState
    take: TakeFacts | None = None
    recorded_text: str | None = None  # of a stale take


@dataclass(frozen=True)
class Validity:
    """The dates of a release."""

    valid_from: date
    valid_until: date | None


def language_tag(text: str) -> str | None:
    """Return the language tag (BCP 47: language, script, region) that a code or a name means; None for neither."""
    plain = " ".join(text.split()).lower()
    if known_tag := _BY_NAME.get(plain.replace("(", "").replace(")", "")):
        return known_tag
    tag = _TAG.fullmatch(plain) if len(plain) <= MAX_KEY_CHARS else None
    if tag is None:
        return None
    language, script, region = tag.groups()
    return "-".join(part for part in (language, script and script.title(), region and region.upper()) if part)


def is_known_language(text: str) -> bool:
    """Whether a text is the name of a language, or begins with the code of one that is commonly dubbed."""
    tag = language_tag(text)
    return tag is not None and (tag in _NAMES or tag.split("-")[0] in _NAMES)


def key_for(character: str, number: int) -> str:
    """Return an id for a line of a script that has none: maya_010."""
    return f"{(audio_checks.slug(character) or 'line')[:40]}_{number:03d}"


def is_stale(texts: Sequence[TextFrom], received_at: datetime) -> bool:
    """Whether the text of a line has changed since a take of it was received; `texts` has the oldest first."""
    return texts[-1].text != text_at(texts, received_at) and not texts[-1].takes_fit


def text_at(texts: Sequence[TextFrom], moment: datetime) -> str:
    """Return the text that was the newest at a moment; the first one, where the moment is before all."""
    before = [text for text in texts if text.written_at <= moment]
    return (before or texts)[-1 if before else 0].text


def file_statuses(
    takes: Sequence[TakeFacts], texts: Sequence[TextFrom], *, variations: int, is_cut: bool
) -> list[LineStatus]:
    """Return the state of each file of a line in one language."""
    if is_cut:
        return [LineStatus(LineState.CUT)] * variations
    return [
        _file_status([take for take in takes if take.variation == variation], texts)
        for variation in range(1, variations + 1)
    ]


def line_status(statuses: Sequence[LineStatus]) -> LineStatus:
    """Return the state of a line: that of its file which is furthest from approved."""
    return min(statuses, key=lambda status: _FURTHEST_FIRST.index(status.state))


def _file_status(takes: Iterable[TakeFacts], texts: Sequence[TextFrom]) -> LineStatus:
    """Return the state of one file.

    It is judged by its newest approved take of the present text, or else by its newest take of that text. Where every
    take was made from another text, the file is stale, by its newest approved take, or else its newest.
    """
    heard = [take for take in takes if take.state is not TakeState.SET_ASIDE]
    newest_first = sorted(heard, key=lambda take: (take.received_at, take.number), reverse=True)
    if not newest_first:
        return LineStatus(LineState.NO_TAKE)
    fresh = [take for take in newest_first if not is_stale(texts, take.received_at)]
    of_them = fresh or newest_first
    take = next((candidate for candidate in of_them if candidate.state is TakeState.APPROVED), of_them[0])
    if not fresh:
        return LineStatus(LineState.STALE, take, text_at(texts, take.received_at))
    return LineStatus(_STATES.get(take.state, LineState.IN_REVIEW), take)


_STATES = {
    TakeState.APPROVED: LineState.APPROVED,
    TakeState.RETURNED: LineState.RETURNED,
    TakeState.CHANGE_REQUESTED: LineState.CHANGE_REQUESTED,
}


def reason_of(status: LineStatus, *, requested: str, error: str) -> str:
    """Return the reason to record a file, or record it again; empty where there is none.

    `requested` is the change that was requested for the take, `error` what the checks found in it.
    """
    match status.state:
        case LineState.NO_TAKE:
            return "no take yet"
        case LineState.STALE:
            return f"the text changed; the take says: {status.recorded_text}"
        case LineState.CHANGE_REQUESTED:
            return f"change requested: {requested}" if requested else "change requested"
        case LineState.RETURNED:
            return f"returned by the checks: {error}" if error else "returned by the checks"
        case _:
            return ""


def approved_duration_s(takes: Iterable[TakeFacts]) -> float | None:
    """Return the length of the newest approved take; None where none is approved, or none measured."""
    approved = [take for take in takes if take.state is TakeState.APPROVED and take.duration_s is not None]
    return max(approved, key=lambda take: (take.received_at, take.number)).duration_s if approved else None


def length_percent(duration_s: float | None, original_s: float | None) -> float | None:
    """Return the percentage by which a take is longer than the original's; None where either is not known."""
    if duration_s is None or not original_s:
        return None
    return round(100 * (duration_s / original_s - 1), 1)


def is_length_off(percent: float | None, tolerance_percent: int) -> bool:
    """Whether a length differs from the original's by more than the tolerance; one that is not known does not."""
    return percent is not None and abs(percent) > tolerance_percent


def is_covered(releases: Iterable[Validity], day: date) -> bool:
    """Whether a release is valid on a day; its first and last days count."""
    return any(
        release.valid_from <= day and (release.valid_until is None or day <= release.valid_until)
        for release in releases
    )


def merged_order(present: Sequence[Place], script: Sequence[Place]) -> list[Place]:
    """Return the order of lines after an import.

    A script with every present line gives the order. Otherwise the present lines keep theirs, and each new one comes
    after the line that is before it in the script; one with none before it comes last.
    """
    present_set = set(present)
    if present_set.issubset(script):
        return list(script)
    after: dict[Place | None, list[Place]] = {}
    last: Place | None = None
    for line in script:
        if line in present_set:
            last = line
        else:
            after.setdefault(last, []).append(line)
    ordered = [entry for line in present for entry in (line, *after.get(line, ()))]
    return [*ordered, *after.get(None, ())]
