"""The jobs of this room: an invited approver is named once they join."""

from uuid import UUID

from app.core.jobs.queue import Payload, job
from app.core.runtime import Runtime
from app.projects.approval import approvers


@job("projects.name_invited_approver")
def name_invited_approver(runtime: Runtime, payload: Payload) -> None:
    """Make a person who joined as approver the approver of their project."""
    with runtime.database.writing() as session:
        approvers.name_invited(
            session,
            project_id=UUID(payload["project_id"]),
            person_id=UUID(payload["person_id"]),
            invited_by=UUID(payload["invited_by"]),
        )
