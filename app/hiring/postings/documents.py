"""A project's postings and their bids as one page of Markdown, as the command prints them."""

from collections.abc import Iterable, Sequence
from typing import Any

from app.core.money import money
from app.core.plural import day_in_words
from app.hiring.models import Bid, Posting
from app.hiring.rules import hourly_rate_minor, missing_lines, total_minor


def markdown_of(project_name: str, postings: Iterable[tuple[Posting, Sequence[Bid]]]) -> str:
    """Return every posting with its lines, and with each bid that was sent: total, hours, dates, lines left out."""
    blocks = [f"# Postings: {project_name}"]
    for posting, bids in postings:
        until = f", bids until {day_in_words(posting.bids_until_on)}" if posting.bids_until_on else ""
        blocks.append(f"## {posting.title}\n\n{posting.state.value.capitalize()}{until}.")
        blocks.append(
            _table("| asked for | cues | files |", ((_cell(a["label"]), a["cues"], a["files"]) for a in posting.lines))
        )
        blocks.append(_bids_of(posting, bids))
    if len(blocks) == 1:
        blocks.append("There is no posting yet.")
    return "\n\n".join(blocks) + "\n"


def _bids_of(posting: Posting, bids: Sequence[Bid]) -> str:
    sent = [(bid, bid.sent) for bid in bids if bid.sent is not None]
    if not sent:
        return "No bid yet."
    head = "| designer | total | hours | an hour | from | to | without |"
    return _table(head, (_row_of(posting, bid, content) for bid, content in sent))


def _row_of(posting: Posting, bid: Bid, content: dict[str, Any]) -> tuple[str, ...]:
    total, hours = total_minor(content["lines"]), content.get("hours_hundredths")
    rate = hourly_rate_minor(total, hours)
    return (
        _cell(bid.designer.name) + (" (awarded)" if posting.awarded_bid_id == bid.id else ""),
        money(total, posting.currency),
        f"{hours / 100:g}" if hours else "",
        money(rate, posting.currency) if rate is not None else "",
        content.get("from_on") or "",
        content.get("to_on") or "",
        ", ".join(map(_cell, missing_lines(posting.lines, content["lines"]))),
    )


def _table(head: str, rows: Iterable[tuple[object, ...]]) -> str:
    rule = "|" + "---|" * (head.count("|") - 1)
    return "\n".join([head, rule, *(f"| {' | '.join(map(str, row))} |" for row in rows)])


def _cell(text: str) -> str:
    return " ".join(text.split()).replace("\\", "\\\\").replace("|", "\\|")
