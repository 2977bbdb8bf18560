"""Who decides, who is engaged, what a number looks like, what a form says: without a database."""

from collections.abc import Mapping
from enum import StrEnum
from typing import Any

from app.projects.errors import CannotDecide


class EngagementKind(StrEnum):
    """A designer's tie to a project."""

    ADVISORY = "advisory"
    CONTRACT = "contract"
    IN_HOUSE = "in-house"


def ensure_can_decide(*, is_liaison: bool, is_producer: bool) -> None:
    """Raise CannotDecide unless the person may be given the last word."""
    if not (is_liaison or is_producer):
        message = "the approver is a liaison of this project or a producer of the studio; make them a liaison first"
        raise CannotDecide(message, errors=[{"where": "person_id", "message": message}])


def stated(tables: Mapping[str, Any]) -> dict[str, Any]:
    """Return what a form states: a field left empty is a key left out."""
    said = {key: stated(value) if isinstance(value, Mapping) else value for key, value in tables.items()}
    return {key: value for key, value in said.items() if value is not None}
