"""Approvers, engagements, numbers of cues and forms: without a database."""

from collections.abc import Mapping
from enum import StrEnum
from typing import Any

from app.projects.errors import CannotApprove


class EngagementKind(StrEnum):
    """A designer's tie to a project."""

    ADVISORY = "advisory"
    CONTRACT = "contract"
    IN_HOUSE = "in-house"


def ensure_can_approve(*, is_liaison: bool, is_producer: bool) -> None:
    """Raise CannotApprove unless the person may be the approver."""
    if not (is_liaison or is_producer):
        message = (
            "the approver must be an audio lead of this project or a producer of the studio; "
            "make them an audio lead first"
        )
        raise CannotApprove(message, errors=[{"where": "person_id", "message": message}])


def stated(tables: Mapping[str, Any]) -> dict[str, Any]:
    """Return what a form states: a field left empty is a key left out."""
    said = {key: stated(value) if isinstance(value, Mapping) else value for key, value in tables.items()}
    return {key: value for key, value in said.items() if value is not None}
