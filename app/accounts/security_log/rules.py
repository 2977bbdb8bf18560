"""Kinds of the security log, its words and its CSV, as plain functions."""

import csv
import io
from collections.abc import Collection, Iterable
from datetime import timedelta
from enum import StrEnum

from app.accounts.rules import Role
from app.core.spreadsheets import quoted_cell

KEPT_FOR = timedelta(days=730)
COLUMNS = ("at", "kind", "person", "about", "summary", "network")
ROLE_NAMES = {
    Role.PRODUCER: "Producer",
    Role.LIAISON: "Audio lead",
    Role.REVIEWER: "Reviewer",
    Role.IMPLEMENTER: "Implementer",
}


class SecurityEventKind(StrEnum):
    """The subject of a line of the security log."""

    SIGN_IN = "sign_in"
    EMAIL = "email"
    PASSWORD = "password"  # noqa: S105  a kind of event
    SECOND_FACTOR = "second_factor"
    ROLES = "roles"
    REMOVAL = "removal"
    TOKEN = "token"  # noqa: S105  a kind of event
    WEBHOOK = "webhook"
    GUEST_LINK = "guest_link"
    EXPORT = "export"


def names_of_roles(roles: Collection[str]) -> str:
    """Return roles in words, in a fixed order."""
    return ", ".join(name for role, name in ROLE_NAMES.items() if role in roles)


def csv_of(rows: Iterable[tuple[str, ...]]) -> str:
    """Return lines of the log as CSV, no cell of which a spreadsheet takes for a formula."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\r\n")
    writer.writerow(COLUMNS)
    writer.writerows([quoted_cell(cell) for cell in row] for row in rows)
    return out.getvalue()
