"""A change order as the text that both parties accept: what changes, and nothing of what stays."""

from collections.abc import Sequence
from datetime import date, datetime

from app.agreements.clauses.facts import format_long_date
from app.agreements.clauses.text import literal
from app.agreements.rules import Party
from app.amendments.schemas import ChangedMilestone
from app.core.money import money

PARTY_WORDS = {Party.STUDIO: "the studio", Party.DESIGNER: "the designer"}


def change_order_title(number: int, title: str) -> str:
    """Return the title of a change order."""
    return f"Change order {number} to {title}"


def change_order_text(
    *,
    number: int,
    title: str,
    agreed_at: datetime | None,
    contract_sha256: str,
    studio: str,
    designer: str,
    party: Party,
    proposed_by: str,
    proposed_on: date,
    reason: str,
    begins_at_once: bool,
    changes: Sequence[str],
    milestones: Sequence[ChangedMilestone],
    currency: str,
) -> str:
    """Return a change order in Markdown."""
    agreed = f", agreed on {format_long_date(agreed_at.date())}" if agreed_at else ""
    changed = [
        milestone
        for milestone in milestones
        if (milestone.amount_before_minor, milestone.due_before) != (milestone.amount_after_minor, milestone.due_after)
    ]
    rows = [
        f"| {literal(milestone.name)} | {_on(milestone.due_before)} | {_on(milestone.due_after)} "
        f"| {money(milestone.amount_before_minor, currency)} | {money(milestone.amount_after_minor, currency)} |"
        for milestone in changed
    ]
    heads = ["| Milestone | Date | New date | Amount | New amount |", "| --- | --- | --- | --- | --- |"]
    begins = (
        f"Work may begin before both have agreed, at the risk of {PARTY_WORDS[party]}."
        if begins_at_once
        else "Work on it begins when both have agreed."
    )
    paragraphs = [
        f"# {literal(change_order_title(number, title))}",
        f"Between **{literal(studio)}** (the studio) and **{literal(designer)}** (the designer), to the contract "
        f"**{literal(title)}**{agreed}, whose text has the SHA-256 {contract_sha256}.",
        f"{literal(proposed_by)} proposed it for {PARTY_WORDS[party]} on {format_long_date(proposed_on)}. "
        f"Reason: {literal(reason)}",
        "## What changes",
        "\n".join(f"- {literal(sentence)}" for sentence in changes),
        "\n".join([*heads, *rows]) if rows else "",
        "## What stays",
        f"Everything else stays as agreed. {begins} This holds when both parties have accepted the same text of it.",
    ]
    return "\n\n".join(paragraph for paragraph in paragraphs if paragraph) + "\n"


def _on(day: date | None) -> str:
    return format_long_date(day) if day else "none"
