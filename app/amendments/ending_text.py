"""The settlement statement as the text that both parties agree to."""

from collections.abc import Collection

from app.agreements.clauses.facts import format_long_date
from app.agreements.clauses.terms import DepositAtEnd
from app.agreements.clauses.text import literal
from app.agreements.rules import WORK_STATE_WORDS, Party, WorkState
from app.amendments.schemas import EndingRead, StatedCueRead
from app.core.money import money, percent

STATE_WORDS = {
    WorkState.NOT_BEGUN: "not begun",
    WorkState.IN_WORK: "in work",
    WorkState.DELIVERED: "delivered",
    WorkState.ACCEPTED: "accepted",
}
PARTY_WORDS = {Party.STUDIO: "The studio", Party.DESIGNER: "The designer"}


def statement_title(ending: EndingRead) -> str:
    """Return the title of a statement."""
    return f"Settlement of {ending.title}"


def statement_text(ending: EndingRead, studio: str) -> str:
    """Return the statement in Markdown; the same states and amounts give the same text."""
    notice = ending.notice
    if notice is None:
        raise AssertionError("a forecast is not a statement")

    def amount(amount_minor: int) -> str:
        return money(amount_minor, ending.currency)

    figures = ending.figures
    ends = (
        f"It ends when both agree to this statement, else when {format_long_date(notice.ends_on)} is over (UTC)."
        if notice.ends_on
        else "It ends when both agree to this statement."
    )
    deposit = "stays with the designer" if ending.deposit_at_end is DepositAtEnd.STAYS else "set off"
    sums = [
        f"| Cues | {amount(ending.cues_minor)} |",
        f"| Deposit, {deposit} | {amount(ending.deposit_minor)} |",
        f"| Rounds beyond those included | {amount(ending.rounds_minor)} |",
        f"| Work by change orders, and late interest | {amount(ending.extra_minor)} |",
        f"| Days worked | {amount(ending.days_minor)} |",
        *([f"| Hours worked | {amount(ending.hours_minor)} |"] if ending.hours_minor else []),
        *([f"| Retainer, months begun | {amount(ending.retainer_minor)} |"] if ending.retainer_minor else []),
        f"| **Owed** | **{amount(figures.accepted_minor)}** |",
        f"| Paid so far | {amount(-figures.paid_minor)} |",
        f"| **To pay, without tax** | **{amount(figures.due_minor)}** |",
        f"| Agreed and not owed | {amount(figures.saved_minor)} |",
    ]
    left = [f"- {literal(point.text)}: {amount(point.amount_minor)}" for point in ending.open_points]
    paragraphs = [
        f"# {literal(statement_title(ending))}",
        f"Between **{literal(studio)}** (the studio) and **{literal(ending.designer.name)}** (the designer).",
        f"Notice {notice.number}: {literal(notice.given_by)} gave it for "
        f"{PARTY_WORDS[notice.party].lower()} on {format_long_date(notice.given_at.date())}. "
        f"Reason: {literal(notice.reason)}",
        f"{ends} Every cue counts by the state of its work then.",
        "\n".join(
            ["| Cue | Milestone | State | Price | Part | Owed |", "| --- | --- | --- | --- | --- | --- |"]
            + [_row(cue, ending.currency) for cue in ending.cues]
        )
        if ending.cues
        else "The contract covers no cue.",
        _state_definitions({cue.state for cue in ending.cues} - {WorkState.ACCEPTED}),
        "\n".join(["| What | Amount |", "| --- | --- |", *sums]),
        "Hours that were logged and not refused count as approved." if ending.hours_minor else "",
        "\n".join(["Not counted, since the studio has not agreed to it:", "", *left]) if left else "",
        "With this the contract is settled. Who owns what stays as the contract says, for cues accepted and cut.",
    ]
    return "\n\n".join(paragraph for paragraph in paragraphs if paragraph) + "\n"


def _state_definitions(states: Collection[WorkState]) -> str:
    """Return the meanings of the states in a statement, as the clause on cut cues defines them."""
    meanings = [WORK_STATE_WORDS[state] for state in WorkState if state in states]
    return f"Of the states, a cue is {'; '.join(meanings)}." if meanings else ""


def _row(cue: StatedCueRead, currency: str) -> str:
    state = STATE_WORDS[cue.state] + (", cut before" if cue.was_cut else "")
    cells = [
        literal(f"{cue.cue.label} {cue.cue.name}"),
        literal(cue.milestone),
        state,
        money(cue.price_minor, currency),
        percent(cue.part_bp),
        money(cue.owed_minor, currency),
    ]
    return f"| {' | '.join(cells)} |"
