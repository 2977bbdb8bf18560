"""Changing the credits of a project: one's own name, and names that are added by hand."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.projects.credits import queries as credit_queries
from app.projects.errors import CreditLineNotFound, ProjectNotFound, TooManyCredits
from app.projects.models import CreditLine, CreditName
from app.projects.service import project_access

MAX_LINES = 500


def save_credit_name(session: Session, actor: Actor, project_id: UUID, *, name: str, is_left_out: bool) -> None:
    """Name the caller in a project's credits, or note that they are left out; else as in their account."""
    access = project_access(session, actor, project_id)
    credit_name = credit_queries.credit_names(session, project_id).get(actor.person)
    if credit_name is None:
        credit_name = CreditName(project_id=project_id, person_id=actor.person, studio_id=access.project.studio_id)
        session.add(credit_name)
    credit_name.name, credit_name.is_left_out = name, is_left_out
    session.flush()


def add_credit_line(session: Session, actor: Actor, project_id: UUID, *, role: str, name: str) -> CreditLine:
    """Add a name to a project's credits by hand, as a producer; raise TooManyCredits."""
    access = project_access(session, actor, project_id)
    access.ensure_producer()
    if len(credit_queries.credit_lines(session, project_id)) >= MAX_LINES:
        raise TooManyCredits(f"{MAX_LINES} names were added by hand, which is the limit", fix="remove one first")
    line = CreditLine(
        studio_id=access.project.studio_id, project_id=project_id, role=role, name=name, added_by=actor.person
    )
    session.add(line)
    session.flush()
    return line


def remove_credit_line(session: Session, actor: Actor, line_id: UUID) -> None:
    """Remove a name that was added by hand, as a producer; raise CreditLineNotFound unseen."""
    line = credit_queries.credit_line(session, line_id)
    if line is None:
        raise CreditLineNotFound(f"no name {line_id} in credits")
    try:
        access = project_access(session, actor, line.project_id)
    except ProjectNotFound:
        raise CreditLineNotFound(f"no name {line_id} in credits") from None
    if not access.is_team:
        raise CreditLineNotFound(f"no name {line_id} in credits")
    access.ensure_producer()
    session.delete(line)
