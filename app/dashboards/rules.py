"""The status of a cue, and the order of next steps, stated without a database."""

from collections.abc import Sequence
from enum import StrEnum
from functools import lru_cache

from app.deliveries.cue_counts.rules import VariationFact
from app.deliveries.rules import TakeState
from app.sound_lists.rules import CueState


class CueStatus(StrEnum):
    """The one word that a list shows for a cue."""

    TO_MAKE = "to_make"
    CHECKING = "checking"
    TO_REVIEW = "to_review"
    RETURNED = "returned"
    UNJUDGED = "unjudged"
    QUESTION = "question"
    CHANGE_REQUESTED = "change_requested"
    PARTLY_ACCEPTED = "partly_accepted"
    ACCEPTED = "accepted"
    PLACEHOLDER = "placeholder"
    CUT = "cut"


UNFINISHED = frozenset(
    {CueStatus.TO_MAKE, CueStatus.PLACEHOLDER, CueStatus.QUESTION, CueStatus.PARTLY_ACCEPTED}
)  # what a designer could begin now
CAME_BACK = frozenset({CueStatus.RETURNED, CueStatus.CHANGE_REQUESTED, CueStatus.UNJUDGED})


class NextStepKind(StrEnum):
    """A step that a person is the one to take, in the order of display."""

    ADD_CUES = "add_cues"
    WRITE_BRIEF = "write_brief"
    INVITE_DESIGNER = "invite_designer"
    ANSWER_CANDIDATES = "answer_candidates"
    COMPARE_BIDS = "compare_bids"
    SEND_NDA = "send_nda"
    SIGN_CONTRACT = "sign_contract"
    CHANGE_CONTRACT = "change_contract"
    SIGN_CHANGE_ORDER = "sign_change_order"
    AGREE_STATEMENT = "agree_statement"
    PAY_INVOICE = "pay_invoice"
    INVOICE_DEPOSIT = "invoice_deposit"
    DEPOSIT_DUE = "deposit_due"
    FIX = "fix"
    MATCH = "match"
    ANSWER_QUESTIONS = "answer_questions"
    ANSWER_FOLLOW_UPS = "answer_follow_ups"
    AGREE_DAYS = "agree_days"
    AGREE_HOURS = "agree_hours"
    CORRECT_WORK = "correct_work"
    AGREE_ROUND = "agree_round"
    SEND_CHANGES = "send_changes"
    REVIEW = "review"
    SEND_CONTRACT = "send_contract"
    PROPOSE_CHANGES = "propose_changes"
    THINK_OF_DAY = "think_of_day"
    INVOICE_DUE = "invoice_due"
    NAME_APPROVER = "name_approver"
    MAKE = "make"
    RECORD = "record"
    IMPLEMENT = "implement"


STEP_ORDER = {kind: rank for rank, kind in enumerate(NextStepKind)}


class AwaitedKind(StrEnum):
    """A step that another person is to take."""

    JOIN = "join"
    BIDS = "bids"
    NDA = "nda"
    SIGNATURE = "signature"
    CHANGE_ORDER = "change_order"
    STATEMENT = "statement"
    VERDICTS = "verdicts"
    ANSWER = "answer"
    FIXES = "fixes"
    INVOICE = "invoice"
    PAYMENT = "payment"


STATUS_OF_TAKE = {
    TakeState.RECEIVED: CueStatus.CHECKING,
    TakeState.CONFORMING: CueStatus.TO_REVIEW,
    TakeState.RETURNED: CueStatus.RETURNED,
    TakeState.UNJUDGED: CueStatus.UNJUDGED,
    TakeState.APPROVED: CueStatus.ACCEPTED,
    TakeState.CHANGE_REQUESTED: CueStatus.CHANGE_REQUESTED,
    TakeState.SET_ASIDE: CueStatus.TO_MAKE,
}
# A set has the state of its most urgent take.
MAX_URGENT_FIRST = (
    CueStatus.CHANGE_REQUESTED,
    CueStatus.RETURNED,
    CueStatus.UNJUDGED,
    CueStatus.TO_REVIEW,
    CueStatus.CHECKING,
)


def variation_status(fact: VariationFact) -> CueStatus:
    """Return the state of one variation: approved once is accepted; else the newest take that is not set aside."""
    if fact.has_approved:
        return CueStatus.ACCEPTED
    if fact.newest is None:
        return CueStatus.TO_MAKE
    if fact.has_waiting and fact.newest is TakeState.RETURNED:
        return CueStatus.TO_REVIEW
    return STATUS_OF_TAKE[fact.newest]


@lru_cache(maxsize=4096)
def statuses_of(facts: str | None, variations: int) -> tuple[CueStatus, ...]:
    """Return the states of a cue's variations, from their packed facts in order; the rest is still to make."""
    packed = facts.split(",")[:variations] if facts else []
    statuses = [variation_status(VariationFact.unpacked(int(part))) for part in packed]
    return (*statuses, *[CueStatus.TO_MAKE] * (variations - len(statuses)))


def cue_status(state: CueState, variations: Sequence[CueStatus], *, is_asked: bool, placeholder: bool) -> CueStatus:
    """Return the one word for a cue with the statuses of its variations."""
    if state is CueState.CUT:
        return CueStatus.CUT
    if all(status is CueStatus.ACCEPTED for status in variations):
        return CueStatus.ACCEPTED
    for status in MAX_URGENT_FIRST:
        if status in variations:
            return status
    if is_asked:
        return CueStatus.QUESTION
    if CueStatus.ACCEPTED in variations:
        return CueStatus.PARTLY_ACCEPTED
    return CueStatus.PLACEHOLDER if placeholder else CueStatus.TO_MAKE
