"""Credits as a list by role, stated without a database, and as the text and the table that leave."""

import csv
import io
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from enum import StrEnum
from uuid import UUID

from app.sound_lists.rules import spreadsheet_safe


class CreditRole(StrEnum):
    """A person's work for a project, as Soundlist knows it; roles added by hand come after these."""

    SOUND_DESIGN = "Sound design"
    AUDIO_DIRECTION = "Audio direction"
    AUDIO_LEAD = "Audio lead"
    PRODUCTION = "Production"


ORDER = {role.value: rank for rank, role in enumerate(CreditRole)}


@dataclass(frozen=True)
class Credit:
    """One name under one role."""

    role: str
    name: str
    person_id: UUID | None = None
    line_id: UUID | None = None  # of a name that was added by hand
    agreed_line: str = ""  # what the person's contract says to the letter


def in_order(listed: Iterable[Credit]) -> list[Credit]:
    """Return credits by role, and by name within a role; roles added by hand come last, by their names."""
    return sorted(
        listed, key=lambda credit: (ORDER.get(credit.role, len(ORDER)), credit.role.casefold(), credit.name.casefold())
    )


def text_of(listed: Sequence[Credit]) -> str:
    """Return credits as text: each role with its names, then the lines that contracts name to the letter."""
    names_by_role: dict[str, list[str]] = {}
    for credit in listed:
        names_by_role.setdefault(credit.role, []).append(credit.name)
    blocks = ["\n".join([role, *names]) for role, names in names_by_role.items()]
    if agreed := list(
        dict.fromkeys(agreed_credit.agreed_line for agreed_credit in listed if agreed_credit.agreed_line)
    ):
        blocks.append("\n".join(["Lines agreed in contracts", *agreed]))
    return "\n\n".join(blocks) + "\n" if blocks else ""


def csv_of(listed: Sequence[Credit]) -> str:
    """Return credits as CSV, no cell of which a spreadsheet takes for a formula."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\r\n")
    writer.writerow(("role", "name", "agreed_line"))
    for credit in listed:
        writer.writerow([spreadsheet_safe(cell) for cell in (credit.role, credit.name, credit.agreed_line)])
    return out.getvalue()
