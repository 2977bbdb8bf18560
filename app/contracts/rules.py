"""What a contract may be and become, stated without a database."""

from collections.abc import Collection, Iterable
from datetime import date, timedelta
from enum import StrEnum
from uuid import UUID

from app.accounts.rules import AddressProof, mailbox_of
from app.contracts.errors import (
    AddressNotProven,
    BothSides,
    DayAhead,
    FrameworkNeeded,
    NoContractNeeded,
    TextMovedOn,
    WrongState,
)


class ContractKind(StrEnum):
    """What is agreed by one text."""

    NDA = "nda"
    FRAMEWORK = "framework"  # rights and rates once, for many batches
    STATEMENT_OF_WORK = "statement_of_work"  # one batch under a framework: cues, price, dates
    SINGLE = "single"  # all of it in one text


class ContractState(StrEnum):
    """How far the parties are."""

    DRAFT = "draft"
    SENT = "sent"
    AGREED = "agreed"
    ENDED = "ended"


class ReleaseClause(StrEnum):
    """When an accepted cue's share becomes due."""

    PER_CUE = "per_cue"
    ON_COMPLETION = "on_completion"  # with the last cue of its milestone


class Party(StrEnum):
    """Who agrees with whom."""

    STUDIO = "studio"
    DESIGNER = "designer"


class LineKind(StrEnum):
    """Why a line of the ledger was written."""

    DEPOSIT = "deposit"
    ACCEPTED = "accepted"
    HELD_BACK = "held_back"  # what of an accepted cue's share waited for the last cue
    CUT = "cut"
    EXTRA_ROUND = "extra_round"
    WORKED_DAY = "worked_day"
    TAX = "tax"
    REVERSED = "reversed"  # takes back a line of any kind above
    PAID = "paid"
    REFUNDED = "refunded"  # takes back a line of a payment


class AcceptedBy(StrEnum):
    """How a cue came to be accepted."""

    VERDICT = "verdict"  # the decider's
    SILENCE = "silence"  # nobody said anything in the days that the contract's clause names
    ADOPTION = "adoption"  # it was approved already when the contract was agreed


class WorkState(StrEnum):
    """How far the work on a cue was when it was cut."""

    NOT_BEGUN = "not_begun"
    IN_WORK = "in_work"
    DELIVERED = "delivered"  # every variation conforms and waits for the decider
    ACCEPTED = "accepted"


KIND_WORDS = {
    ContractKind.NDA: "non-disclosure agreement",
    ContractKind.FRAMEWORK: "framework agreement",
    ContractKind.STATEMENT_OF_WORK: "statement of work",
    ContractKind.SINGLE: "contract",
}
STATE_WORDS = {
    ContractState.DRAFT: "is a draft",
    ContractState.SENT: "was sent and waits for both to accept",
    ContractState.AGREED: "is agreed",
    ContractState.ENDED: "has ended",
}


def ensure_state(now: ContractState, wanted: Collection[ContractState], fix: str) -> None:
    """Raise WrongState unless a contract is in one of the states in which this can be done."""
    if now not in wanted:
        raise WrongState(f"this contract {STATE_WORDS[now]}", fix=fix)


def ensure_not_ahead(day: date, today: date, why: str) -> None:
    """Raise DayAhead for a day that has come nowhere on earth yet: somewhere it is tomorrow already."""
    if day > today + timedelta(days=1):
        raise DayAhead(f"{day} lies ahead; {why}", fix="give the day on which it happened")


def ensure_same_text(seen_sha256: str, sent_sha256: str) -> None:
    """Raise TextMovedOn unless the text that somebody says yes to is the one that was sent."""
    if seen_sha256 != sent_sha256:
        raise TextMovedOn(
            "the text that you read is not the one that stands now; nothing was accepted",
            fix="load the page again and read what changed, then accept",
        )


def ensure_needs_contract(*, is_in_house: bool) -> None:
    """Raise NoContractNeeded for the studio's own people."""
    if is_in_house:
        raise NoContractNeeded(
            "this designer is one of the studio's own people and works without a contract",
            fix="change their tie to the project to by contract first",
        )


def ensure_under_framework(kind: ContractKind, *, has_framework: bool) -> None:
    """Raise FrameworkNeeded where a batch names no framework, or another text names one."""
    if (kind is ContractKind.STATEMENT_OF_WORK) != has_framework:
        message = (
            "a statement of work is a batch under a framework agreement that both have agreed to"
            if kind is ContractKind.STATEMENT_OF_WORK
            else f"a {KIND_WORDS[kind]} stands by itself"
        )
        fix = "agree on a framework first, or make one contract that holds all of it" if not has_framework else None
        raise FrameworkNeeded(message, errors=[{"where": "framework_id", "message": message}], fix=fix)


def ensure_another_person(person_id: UUID, email: str, others: Iterable[tuple[UUID, str]]) -> None:
    """Raise BothSides where somebody of the other party is the same person, or has the same mailbox."""
    for other_id, other_email in others:
        if person_id == other_id or mailbox_of(email) == mailbox_of(other_email):
            raise BothSides(
                f"{other_email} is on the contract's other side; nobody agrees with themselves",
                fix="have somebody else of your side do it",
            )


def ensure_address_proven(proof: AddressProof | None, email: str) -> None:
    """Raise AddressNotProven for an address of which nobody has shown to read the mail."""
    if proof is None:
        raise AddressNotProven(
            f"{email} is not verified, so the other party could not tell who accepts",
            fix="open the page Account, have a link mailed to it, and follow the link; then accept",
        )
