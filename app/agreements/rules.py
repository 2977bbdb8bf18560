"""Possible states and changes of a contract, stated without a database."""

from collections.abc import Collection, Iterable
from enum import StrEnum
from uuid import UUID

from app.accounts.rules import AddressProof, mailbox_of
from app.agreements.errors import (
    AddressNotProven,
    FrameworkNeeded,
    NoContractNeeded,
    NoticeNeeded,
    SamePersonOnBothSides,
    TextChanged,
    WrongState,
)


class ContractKind(StrEnum):
    """The matter agreed by one text."""

    NDA = "nda"
    FRAMEWORK = "framework"  # rights and rates once, for many batches
    STATEMENT_OF_WORK = "statement_of_work"  # one batch under a framework: cues, price, dates
    SINGLE = "single"  # all of it in one text


class ContractState(StrEnum):
    """The progress of the parties."""

    DRAFT = "draft"
    SENT = "sent"
    AGREED = "agreed"
    ENDED = "ended"


class ReleaseClause(StrEnum):
    """The due time of an accepted cue's share."""

    PER_CUE = "per_cue"
    ON_COMPLETION = "on_completion"  # with the last cue of its milestone


class Party(StrEnum):
    """A side of an agreement."""

    STUDIO = "studio"
    DESIGNER = "designer"


class AcceptedBy(StrEnum):
    """The way a cue came to be accepted."""

    VERDICT = "verdict"  # the approver's
    SILENCE = "silence"  # no decision within the days of the contract's clause
    ADOPTION = "adoption"  # it was approved already when the contract was agreed


class WorkState(StrEnum):
    """The progress of the work on a cue when it was cut; `WORK_STATE_WORDS` define each."""

    NOT_BEGUN = "not_begun"
    IN_WORK = "in_work"
    DELIVERED = "delivered"
    ACCEPTED = "accepted"


# The clause on cut cues and the settlement statement define the states in these words, so a cue has one of them.
WORK_STATE_WORDS = {
    WorkState.NOT_BEGUN: "not begun, with no file delivered",
    WorkState.IN_WORK: "in work, with a file delivered and one missing, unchecked, returned, set aside or to change",
    WorkState.DELIVERED: "delivered, with every file of the cue conforming and in review, or approved",
    WorkState.ACCEPTED: "accepted",
}

KIND_WORDS = {
    ContractKind.NDA: "non-disclosure agreement",
    ContractKind.FRAMEWORK: "framework agreement",
    ContractKind.STATEMENT_OF_WORK: "statement of work",
    ContractKind.SINGLE: "contract",
}
ORDERS = frozenset({ContractKind.SINGLE, ContractKind.STATEMENT_OF_WORK})  # kinds that order work
STATE_WORDS = {
    ContractState.DRAFT: "is a draft",
    ContractState.SENT: "was sent and needs both signatures",
    ContractState.AGREED: "is agreed",
    ContractState.ENDED: "has ended",
}


def ensure_state(now: ContractState, allowed_states: Collection[ContractState], fix: str) -> None:
    """Raise WrongState unless a contract is in one of the states in which this can be done."""
    if now not in allowed_states:
        raise WrongState(f"this contract {STATE_WORDS[now]}", fix=fix)


def next_action_hint(state: ContractState, kind: ContractKind, party: Party = Party.STUDIO) -> str:
    """Return a hint on a party's options where a contract's text or plan cannot be changed in its state."""
    is_designer = party is Party.DESIGNER
    match state:
        case ContractState.DRAFT:
            return "wait until the studio sends it again" if is_designer else "edit the draft, then send it"
        case ContractState.SENT if is_designer:
            return "request a change while it needs your signature"
        case ContractState.SENT:
            return "recall it first; then change it and send it again"
        case ContractState.AGREED if kind in ORDERS:
            return "propose a change order"
        case ContractState.AGREED:
            return "end it on its page; then the studio begins another contract"
        case ContractState.ENDED:
            return "this is final: the text stays readable, and the studio begins another contract for further work"


def ensure_ends_without_settlement(kind: ContractKind, state: ContractState) -> None:
    """Raise NoticeNeeded for an agreed contract under which money may be owed."""
    if kind in ORDERS and state is ContractState.AGREED:
        raise NoticeNeeded(
            "this contract orders work, so it ends with a settlement of what each cue is owed",
            fix="give notice on its page Terminate contract; where both agree to the statement, it ends at once",
        )


def ensure_same_text(seen_sha256: str, sent_sha256: str) -> None:
    """Raise TextChanged unless the accepted text is the one that was sent."""
    if seen_sha256 != sent_sha256:
        raise TextChanged(
            "the text was changed after you opened it; nothing was signed",
            fix="reload the page and read what changed, then sign",
        )


def ensure_needs_contract(*, is_in_house: bool) -> None:
    """Raise NoContractNeeded for the studio's own people."""
    if is_in_house:
        raise NoContractNeeded(
            "this designer works in-house and needs no contract",
            fix="change their engagement to contractor first",
        )


def ensure_under_framework(kind: ContractKind, *, has_framework: bool) -> None:
    """Raise FrameworkNeeded where a batch names no framework, or another text names one."""
    if (kind is ContractKind.STATEMENT_OF_WORK) != has_framework:
        message = (
            "a statement of work is a batch under a framework agreement that both have agreed to"
            if kind is ContractKind.STATEMENT_OF_WORK
            else f"a {KIND_WORDS[kind]} stands by itself"
        )
        fix = (
            "leave the framework out" if has_framework else "sign a framework agreement first, or use a single contract"
        )
        raise FrameworkNeeded(message, errors=[{"where": "framework_id", "message": message}], fix=fix)


def ensure_another_person(person_id: UUID, email: str, others: Iterable[tuple[UUID, str]]) -> None:
    """Raise SamePersonOnBothSides if the other party has the same person, or one with the same mailbox."""
    for other_id, other_email in others:
        if person_id == other_id or mailbox_of(email) == mailbox_of(other_email):
            raise SamePersonOnBothSides(
                f"{other_email} is on the contract's other side; you can't sign for both sides",
                fix="have someone else on your side do it",
            )


def ensure_address_proven(proof: AddressProof | None, email: str) -> None:
    """Raise AddressNotProven for an address that is not verified."""
    if proof is None:
        raise AddressNotProven(
            f"{email} is not verified, so the other party could not know who signs",
            fix="verify your email on the Account page, then sign",
        )
