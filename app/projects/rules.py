"""Approvers and their deputies, engagements, numbers of cues and forms: without a database."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from datetime import date
from enum import StrEnum
from typing import Any
from uuid import UUID

from app.core.errors import FieldProblem
from app.projects.errors import BadDeputy, CannotApprove


class EngagementKind(StrEnum):
    """A designer's tie to a project."""

    ADVISORY = "advisory"
    CONTRACT = "contract"
    IN_HOUSE = "in-house"


class DesignersHear(StrEnum):
    """The sounds of others that the designers of a project may hear."""

    OWN = "own"
    APPROVED = "approved"
    WAITING = "waiting"


# The choices that open a sound, by whether it is approved or waits for approval.
OPENS_APPROVED = frozenset({DesignersHear.APPROVED, DesignersHear.WAITING})
OPENS_WAITING = frozenset({DesignersHear.WAITING})
USUAL_AUDIO_LEADS = 2  # one or two people speak for a studio; more give different answers


@dataclass(frozen=True)
class ApprovalScope:
    """The cues of a project that one person approves, by their category."""

    rest: bool  # cues of every category without an approver of its own
    own: frozenset[str]  # the categories with an approver of their own that the person approves
    others: frozenset[str]  # the other categories with an approver of their own

    def covers(self, category: str) -> bool:
        """Whether the person approves cues of a category."""
        return category in self.own or (self.rest and category not in self.others)

    @property
    def is_all(self) -> bool:
        """Whether the person approves every cue."""
        return self.rest and not self.others

    @property
    def is_any(self) -> bool:
        """Whether the person approves some cues."""
        return self.rest or bool(self.own)


EVERY_CUE = ApprovalScope(rest=True, own=frozenset(), others=frozenset())
NO_CUE = ApprovalScope(rest=False, own=frozenset(), others=frozenset())


@dataclass(frozen=True)
class ApprovalRights:
    """The approvers of sounds in a project today: the one rule that every room asks."""

    approver_id: UUID  # of cues whose category has no approver of its own
    by_category: Mapping[str, UUID] = field(default_factory=dict)
    deputies: Mapping[UUID, Sequence[UUID]] = field(default_factory=dict)  # today's, by the person they stand in for

    def approver_of(self, category: str) -> UUID:
        """Return the approver of a category; of the project for one without an approver of its own."""
        return self.by_category.get(category, self.approver_id)

    def people_for(self, category: str) -> list[UUID]:
        """Return the approvers for a category today: its own approver, then their deputies."""
        approver_id = self.approver_of(category)
        return [approver_id, *self.deputies.get(approver_id, ())]

    def on_behalf_of(self, person_id: UUID, category: str) -> UUID | None:
        """Return the approver in whose place a person approves in a category; None: their own right, or none."""
        approver_id = self.approver_of(category)
        is_deputy = person_id != approver_id and person_id in self.deputies.get(approver_id, ())
        return approver_id if is_deputy else None

    def is_approver(self, person_id: UUID) -> bool:
        """Whether a person is the approver of the project or of a category, deputies apart."""
        return person_id in (self.approver_id, *self.by_category.values())

    def scope_of(self, person_id: UUID, *, as_deputy: bool = True) -> ApprovalScope:
        """Return the cues that a person approves, with or without those that they approve as a deputy."""

        def approves(approver_id: UUID) -> bool:
            return person_id == approver_id or (as_deputy and person_id in self.deputies.get(approver_id, ()))

        own = frozenset(category for category, approver_id in self.by_category.items() if approves(approver_id))
        return ApprovalScope(approves(self.approver_id), own, frozenset(self.by_category) - own)


def audio_leads_warning(count: int) -> str | None:
    """Return the warning against none or so many audio leads; None for one or two."""
    if count == 0:
        return "No audio lead speaks for the team; name one or two, so that designers know whom to ask"
    if count <= USUAL_AUDIO_LEADS:
        return None
    return (
        f"{count} audio leads speak for the team; one or two are usual, since more give designers different answers. "
        "Who only listens and comments needs no such part"
    )


def ensure_can_approve(*, is_liaison: bool, is_producer: bool, where: str = "person_id") -> None:
    """Raise CannotApprove unless the person may be the approver, or a deputy."""
    if not (is_liaison or is_producer):
        who = "a deputy" if where == "deputy_id" else "the approver"
        message = (
            f"{who} must be an audio lead of this project or a producer of the studio; make them an audio lead first"
        )
        raise CannotApprove(message, errors=[FieldProblem(where=where, message=message)])


def ensure_deputy(person_id: UUID, deputy_id: UUID, *, from_on: date, until_on: date, today: date) -> None:
    """Raise BadDeputy for one's own deputy, and for days that end before they begin or that are over."""
    where = "until_on"
    if person_id == deputy_id:
        where, message = "deputy_id", "choose another person as the deputy"
    elif until_on < from_on:
        message = "the last day is before the first day"
    elif until_on < today:
        message = "the last day is over"
    else:
        return
    raise BadDeputy(message, errors=[FieldProblem(where=where, message=message)])


def stated(tables: Mapping[str, Any]) -> dict[str, Any]:
    """Return the statements of a form: a field left empty is a key left out."""
    filled = {key: stated(value) if isinstance(value, Mapping) else value for key, value in tables.items()}
    return {key: value for key, value in filled.items() if value is not None}
