"""The line of the security log about a file that leaves the studio by a GET, whose own transaction only reads."""

from uuid import UUID

from fastapi import Request
from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.accounts.security_log.rules import SecurityEventKind
from app.accounts.security_log.service import record
from app.core.web.http import CLIENT_ADDRESS, database_of


def record_download(
    request: Request, session: Session, actor: Actor, studio_id: UUID, project_id: UUID, file_name: str
) -> None:
    """Record who downloaded a file of a project; the reading session ends here, so that one connection is enough."""
    session.close()
    with database_of(request).writing() as writing:
        writing.info[CLIENT_ADDRESS] = request.client.host if request.client else ""
        record(
            writing,
            SecurityEventKind.EXPORT,
            f"downloaded {file_name}",
            studio_ids=[studio_id],
            project_id=project_id,
            person_id=actor.person_id,
        )
