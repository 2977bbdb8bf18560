"""Texts of mails, stated without a database."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from datetime import datetime
from enum import StrEnum
from typing import Any

from app.core.plural import counted

FOOTER = "Please answer in Soundlist, not to this email."
SECURITY_TOPICS = (
    "tokens",
    "producers",
    "providers",
)  # first words of topics that a studio's producers are always mailed
FOLDED_LINES = 5  # that a notice shows; the page that it leads to shows all


class MailState(StrEnum):
    """The state of a mail."""

    SENT = "sent"  # the mail server took it
    WAITING = "waiting"  # it is handed to the mail server in a moment
    FAILED = "failed"  # the mail server refused it; it is tried again
    NO_SERVER = "no_server"  # there is no mail server: its link is handed over by hand


def mail_state(sent_at: datetime | None, failure: str | None, *, can_send: bool) -> MailState:
    """Return the state of an email on a server that can send, or has no mail server."""
    if sent_at is not None:
        return MailState.SENT
    if not can_send:
        return MailState.NO_SERVER
    return MailState.WAITING if failure is None else MailState.FAILED


@dataclass(frozen=True)
class Fold:
    """The subject of news that comes in numbers: its events are folded into one notice and one part of a mail."""

    project: str
    one: str
    many: str

    def subject(self, count: int) -> str:
        """Return the subject for so many: Shield Wing: 71 versions approved."""
        return f"{self.project}: {counted(count, self.one, self.many)}"


@dataclass(frozen=True)
class DigestPart:
    """The part of a digest that is about one topic: its subject counts the lines, and its link ends it."""

    topic: str
    fold: Fold
    lines: Sequence[str]
    link: str

    def begun(self, at: int) -> dict[str, Any]:
        """Return the record of a part, at line `at` of the email, that further lines can join."""
        return {self.topic: {"at": at, "lines": list(self.lines)}}

    def joined(self, folds: Mapping[str, Any]) -> tuple[dict[str, Any], str]:
        """Return the record of the part with these lines after the earlier ones, and its text."""
        lines = [*folds[self.topic]["lines"], *self.lines]
        kept = {**folds, self.topic: {**folds[self.topic], "lines": lines}}
        return kept, "\n\n".join((self.fold.subject(len(lines)), *lines, self.link))


def folded_text(text: str, count: int, lines: Sequence[str]) -> str:
    """Return the text of a notice of `count` lines with further lines: the first five, and how many more there are."""
    first = [text.removesuffix(_more(count))] if count else []
    room = max(0, FOLDED_LINES - count)
    return "\n".join([*first, *lines[:room]]) + _more(count + len(lines))


def _more(count: int) -> str:
    return f"\nand {count - FOLDED_LINES} more" if count > FOLDED_LINES else ""


def text_of(lines: Sequence[str], link: str | None, preferences_link: str | None = None) -> str:
    """Return the whole text of a mail; the last link is for who wants fewer of them."""
    parts = ["\n\n".join(lines)]
    if link:
        parts.append(link)
    footer = f"{FOOTER}\nFewer mails like this: {preferences_link}" if preferences_link else FOOTER
    parts.append(f"-- \n{footer}")
    return "\n\n".join(parts) + "\n"


def finding_line(finding: Mapping[str, Any]) -> str:
    """Return a finding on one line: what was found, and how to fix it."""
    return f"{finding['message']}. {finding['fix']}" if finding.get("fix") else str(finding["message"])
