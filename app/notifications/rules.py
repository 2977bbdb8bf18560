"""Texts of mails, stated without a database."""

from collections.abc import Mapping, Sequence
from datetime import datetime
from enum import StrEnum
from typing import Any

FOOTER = "Please answer in Soundlist, not to this email."


class MailState(StrEnum):
    """How a mail stands."""

    SENT = "sent"  # the mail server took it
    WAITING = "waiting"  # it is handed to the mail server in a moment
    FAILED = "failed"  # the mail server refused it; it is tried again
    NO_SERVER = "no_server"  # there is no mail server: its link is handed over by hand


def mail_state(sent_at: datetime | None, failure: str | None, *, can_send: bool) -> MailState:
    """Return how a mail stands; `can_send`: a mail server is set."""
    if sent_at is not None:
        return MailState.SENT
    if not can_send:
        return MailState.NO_SERVER
    return MailState.WAITING if failure is None else MailState.FAILED


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
