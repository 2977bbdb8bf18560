"""What this room tells and asks the rooms above it, in the transaction of a verdict."""

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from datetime import date
from uuid import UUID

from app.core.events import Signal
from app.deliveries.models import Take
from app.reviews.models import ChangeRequest, Comment, Feedback, Verdict
from app.reviews.rules import PausedBy, VerdictKind
from app.sound_lists.models import Cue


@dataclass(frozen=True)
class TakeJudged(Signal[None]):
    """A verdict was given, before its take moves."""

    verdict: Verdict
    take: Take
    sent_with: Sequence[Feedback | ChangeRequest] = ()


@dataclass(frozen=True)
class GivenVerdict:
    """A verdict on file, with its take and the change request that it sent."""

    verdict: Verdict
    take: Take
    change_request_id: UUID | None = None


@dataclass(frozen=True)
class VerdictsOnFile(Signal[None]):
    """Approvals or sent changes are on file, and their takes have moved."""

    kind: VerdictKind
    given: Sequence[GivenVerdict]


@dataclass(frozen=True)
class CueDecided(Signal[None]):
    """The takes of a cue were decided on; it is accepted now, or it is not."""

    cue: Cue
    is_accepted: bool
    approved: Sequence[Take]
    person_id: UUID | None
    is_deemed: bool = False  # by a clause, without a decision


@dataclass(frozen=True)
class CueCut(Signal[None]):
    """A cue is about to be cut."""

    cue: Cue
    person_id: UUID


@dataclass(frozen=True)
class RoundCounted(Signal[None]):
    """A round of changes counts for a cue."""

    cue_id: UUID
    number: int
    person_id: UUID


@dataclass(frozen=True)
class CommentWritten(Signal[None]):
    """A comment was written on a take."""

    comment: Comment
    take: Take


@dataclass(frozen=True)
class LastDay:
    """The day after which a cue is deemed accepted, and what stops the count until then."""

    day: date
    paused_by: PausedBy | None


@dataclass(frozen=True)
class LastDaysAsked(Signal[dict[UUID, LastDay]]):
    """Asks by cue for the day after which it is deemed accepted."""

    cue_ids: Collection[UUID]
