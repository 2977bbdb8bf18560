"""Transitions between states of takes, and the parts of file names, stated without a database."""

import re
import unicodedata
from collections import defaultdict
from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass
from datetime import datetime, timedelta
from enum import StrEnum
from itertools import pairwise
from typing import NamedTuple
from uuid import UUID

import audio_checks
from app.core.plural import day_in_words
from app.deliveries.errors import MasterDeleted, VariationUnknown, WrongState

MAX_FILE_BYTES = 2 << 30
MAX_ARCHIVE_BYTES = 5 << 30  # the largest object that S3 copies in one request
MAX_NAME_CHARS = 255
_KEPT_END = 24  # of a name that is too long: its end says what kind of file it is


class TakeState(StrEnum):
    """The state of a take."""

    RECEIVED = "received"
    CONFORMING = "conforming"
    RETURNED = "returned"
    UNJUDGED = "unjudged"
    APPROVED = "approved"
    CHANGE_REQUESTED = "change_requested"
    SET_ASIDE = "set_aside"


WORK_STATES = {TakeState.APPROVED: "approved", TakeState.CONFORMING: "in review"}


def work_state(state: TakeState, *, is_placeholder: bool) -> str:
    """Return the state of a take as its file's metadata says it."""
    return "placeholder" if is_placeholder else WORK_STATES.get(state, state.replace("_", " "))


class ArchiveState(StrEnum):
    """The state of a delivered ZIP."""

    RECEIVED = "received"
    UNPACKED = "unpacked"
    REFUSED = "refused"


class SourceFileKind(StrEnum):
    """The kind of a file that a take was made from."""

    SESSION = "session"
    LAYER = "layer"


LAYER_ENDINGS = (".wav", ".wave", ".flac", ".aif", ".aiff", ".mp3", ".ogg", ".opus", ".m4a", ".caf", ".w64")


def source_file_kind(file_name: str) -> SourceFileKind:
    """Return the kind of a source file by the ending of its name: audio is a layer, anything else the session."""
    return SourceFileKind.LAYER if file_name.lower().endswith(LAYER_ENDINGS) else SourceFileKind.SESSION


class TrayActionKind(StrEnum):
    """The actions on many takes at once."""

    MATCHED = "matched"
    MOVED = "moved"
    DISCARDED = "discarded"
    RESTORED = "restored"
    SPLIT = "split"


S = TakeState
NEXT_STATES: dict[TakeState, frozenset[TakeState]] = {
    S.RECEIVED: frozenset({S.RECEIVED, S.CONFORMING, S.RETURNED, S.UNJUDGED}),
    S.CONFORMING: frozenset({S.RECEIVED, S.APPROVED, S.CHANGE_REQUESTED, S.SET_ASIDE}),
    S.RETURNED: frozenset({S.RECEIVED, S.CONFORMING}),
    S.UNJUDGED: frozenset({S.RECEIVED}),
    S.APPROVED: frozenset({S.SET_ASIDE, S.CHANGE_REQUESTED}),
    S.CHANGE_REQUESTED: frozenset(),
    S.SET_ASIDE: frozenset({S.APPROVED}),
}
CHECKABLE = frozenset(state for state, following in NEXT_STATES.items() if S.RECEIVED in following)


@dataclass(frozen=True)
class ReviewClock:
    """A take's time of readiness for a verdict: since its first conforming check, less the time it was returned."""

    conforming_since: datetime | None
    returned_since: datetime | None  # only once it has conformed

    def at(self, state: TakeState, now: datetime) -> "ReviewClock":
        """Return the clock of a take that goes to a state now."""
        if state is TakeState.CONFORMING:
            return ReviewClock(self._resumed(now), None)
        if state in (TakeState.RETURNED, TakeState.UNJUDGED) and self.conforming_since is not None:
            return ReviewClock(self.conforming_since, self.returned_since or now)
        return self

    def _resumed(self, now: datetime) -> datetime:
        if self.conforming_since is None:
            return now
        return self.conforming_since + (now - self.returned_since if self.returned_since else timedelta())


def ensure_may_become(now: TakeState, wanted: TakeState) -> None:
    """Raise WrongState unless a take may go from one state to the other."""
    if wanted not in NEXT_STATES[now]:
        raise WrongState(f"a {now} take cannot become {wanted}")


class OpenTake(NamedTuple):
    """Facts that decide whether files of one delivery compete for a place in the list."""

    id: UUID
    delivery_id: UUID
    cue_id: UUID
    variation: int
    alternate: int | None
    number: int
    file_name: str
    fix_of_id: UUID | None


OPEN_STATES = frozenset({TakeState.RECEIVED, TakeState.CONFORMING})  # in which a take goes, or has gone, to review


def undecided_groups(takes: Iterable[OpenTake]) -> list[list[OpenTake]]:
    """Return the takes between which nobody chose: open files of one delivery for one place under different names.

    A file sent again under its own name is its newer version, and so is one whose name says a later version than the
    file before it. Alternates of different letters are for the approver to choose from.
    """
    by_place: dict[tuple[object, ...], list[OpenTake]] = defaultdict(list)
    for take in takes:
        by_place[take.delivery_id, take.cue_id, take.variation, take.alternate].append(take)
    groups = []
    for at_place in by_place.values():
        fixed = {take.fix_of_id for take in at_place}
        newest = {take.file_name: take for take in sorted(at_place, key=_number) if take.id not in fixed}
        group = sorted(newest.values(), key=_number)
        if len(group) > 1 and not _are_typed_versions(group):
            groups.append(group)
    return groups


def _number(take: OpenTake) -> int:
    return take.number


def _are_typed_versions(group: Sequence[OpenTake]) -> bool:
    """Whether the names count versions in the order in which the files came: laser, laser_v2, laser_v3."""
    versions = [audio_checks.parse_file_name(take.file_name).typed_version or 0 for take in group]
    return all(earlier < later for earlier, later in pairwise(versions))


def is_archive(file_name: str) -> bool:
    """Whether a name says that the file is a ZIP."""
    return file_name.lower().endswith(".zip")


def max_bytes(file_name: str) -> int:
    """Return the length limit of a file of this name."""
    return MAX_ARCHIVE_BYTES if is_archive(file_name) else MAX_FILE_BYTES


def stored_name(given: str) -> str:
    """Return a file name as it is kept: as given, but of bounded length, and with what no database takes marked."""
    name = re.sub("[\0\ud800-\udfff]", "\ufffd", given)
    if len(name) <= MAX_NAME_CHARS:
        return name
    return f"{name[: MAX_NAME_CHARS - _KEPT_END - 1]}…{name[-_KEPT_END:]}"


def shown_name(kept: str) -> str:
    r"""Return a file name as it may be shown on one line: what does not print is escaped, as in `\n` or `\u202e`."""
    return "".join(
        letter if letter.isprintable() else letter.encode("unicode_escape").decode("ascii") for letter in kept
    )


def named_for(file_name: str, stem: str) -> str:
    """Return the name of a file with the list's stem and the file's extension."""
    _, dot, ending = file_name.rpartition(".")
    return f"{stem}{dot}{ending}" if dot else stem


def list_name_for(file_name: str, stem: str, ending: str | None) -> str:
    """Return the list's name for a file: its alternate is kept, its extension is spelt as the spec has it."""
    name = audio_checks.parse_file_name(file_name)
    alternate = "" if name.alternate is None else f"__alt{name.alternate}"
    is_spelt_otherwise = ending is not None and ending.lower() == name.extension.lower()
    return f"{stem}{alternate}{ending if is_spelt_otherwise else name.extension}"


def base_name(kept: str) -> str:
    """Return a file name without the folders before it."""
    return re.split(r"[/\\]", kept)[-1]


def stems_to_try(file_name: str) -> list[tuple[str, int | None]]:
    """Return the stems by which a file may find its cue, with the alternate each implies; the whole name first."""
    name = audio_checks.parse_file_name(file_name)
    whole = unicodedata.normalize("NFC", base_name(file_name)).removesuffix(name.extension)
    return list(dict.fromkeys([(whole, None), (name.stem, name.alternate)]))


def dry_stem_for(file_name: str) -> str | None:
    """Return the stem of the takes that a file is the dry stem of, by its name; None for any other name."""
    return audio_checks.dry_stem_name(file_name)


def stem_of(file_name: str) -> str:
    """Return the stem by which a take finds its dry stem: its name as delivered without the ending."""
    return audio_checks.stem_of_file(file_name)


def ensure_no_verdict(state: TakeState) -> None:
    """Raise WrongState where a take is decided upon: what its verdict went by stays."""
    if state not in CHECKABLE:
        raise WrongState(f"this version is {state.replace('_', ' ')}; its files can't be changed any more")


def ensure_kept(discarded_at: datetime | None) -> None:
    """Raise WrongState for a take that was discarded."""
    if discarded_at is not None:
        raise WrongState("this file was discarded; restore it first")


def ensure_master_kept(deleted_at: datetime | None) -> None:
    """Raise MasterDeleted for a take whose master was deleted."""
    if deleted_at is not None:
        raise MasterDeleted(
            f"its master was deleted on {day_in_words(deleted_at)}: the contract's years of keeping it were over",
            fix="use its game files, or ask its designer for a copy",
        )


def alternate_of(file_name: str) -> int | None:
    """Return the number of the alternate that a name ends in; 2 for `_altB` and `__alt2`."""
    return audio_checks.parse_file_name(file_name).alternate


def variation_for_name(file_name: str, variations: int, filled: Collection[int]) -> int:
    """Return the variation of a set that a file dropped on its cue is for: the one it names, else the first empty."""
    named = audio_checks.variation_in(file_name, variations)
    if named is not None:
        return named
    return next((place for place in range(1, variations + 1) if place not in filled), 1)


def ensure_variation(variation: int, variations: int) -> None:
    """Raise VariationUnknown unless the cue has a variation of that number."""
    if not 1 <= variation <= variations:
        files = "1 variation" if variations == 1 else f"{variations} variations"
        raise VariationUnknown(f"the cue has {files}; there is no number {variation}")
