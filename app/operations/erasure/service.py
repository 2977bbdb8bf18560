"""Erasing a project, a studio or a person, and what stays because law or a contract requires it.

Files that no row names any more are deleted by the next pass over all stored files.
"""

from dataclasses import dataclass, field
from uuid import UUID

import sqlalchemy as sa
from sqlalchemy.exc import IntegrityError
from sqlalchemy.orm import Session

from app.accounts.models import SignUp
from app.accounts.security_log.models import SecurityEvent
from app.core import clock
from app.core.db import Base
from app.core.plural import counted
from app.notifications.models import Mail
from app.operations.erasure import queries as erasure_queries
from app.operations.erasure import scope_queries as scopes
from app.operations.erasure.queries import Kept
from app.operations.errors import ErasureRefused

ERASED_DOMAIN = "erased.invalid"
PERSONAL = frozenset({"notifications_notices", "accounts_invoice_details", "shares_saved_views"})
INVITED = ("accounts_studio_invitations", "projects_invitations", "hiring_candidates")


@dataclass
class Erased:
    """The name of what was erased, the number of rows deleted, and what stays with the reason."""

    name: str
    rows: int = 0
    kept: list[Kept] = field(default_factory=list)


def erase_project(session: Session, project_id: UUID) -> Erased:
    """Delete a project with everything in it; raise ErasureRefused where it has a signed contract."""
    project = erasure_queries.project(session, project_id)
    if project is None:
        raise ErasureRefused(f"no project {project_id}")
    _ensure_unsigned(session, f"the project {project.name}", project_id=project_id)
    name = project.name
    session.expunge_all()
    return Erased(name, _delete(session, lambda table: scopes.of_project(table, project_id)))


def erase_studio(session: Session, studio_id: UUID) -> Erased:
    """Delete a studio with all its projects; raise ErasureRefused where one has a signed contract."""
    studio = erasure_queries.studio(session, studio_id)
    if studio is None:
        raise ErasureRefused(f"no studio {studio_id}")
    _ensure_unsigned(session, f"the studio {studio.name}", studio_id=studio_id)
    name = studio.name
    session.expunge_all()
    return Erased(name, _delete(session, lambda table: scopes.of_studio(table, studio_id)))


def erase_person(session: Session, address: str) -> Erased:
    """Delete the account of an address and what is about the person alone.

    Their name and address become a pseudonym everywhere else. Raises ErasureRefused while the person is a member of a
    studio, an operator, or a party of a running contract.
    """
    person = erasure_queries.person(session, address)
    if person is None:
        raise ErasureRefused(f"no account has the address {address}")
    if reasons := erasure_queries.obstacles_of_person(session, person.id):
        raise ErasureRefused(f"{person.email} {'; '.join(reasons)}")
    name, email, pseudonym = person.name, person.email, f"{person.id}@{ERASED_DOMAIN}"
    erased = Erased(name, kept=erasure_queries.kept_of_person(session, person.id))
    scope = of_person(person.id)
    for table in scopes.tables():
        where = scope(table)
        if where is not None:
            erased.rows += _count(session, sa.delete(table).where(where))
    session.connection().execute(
        sa.update(SecurityEvent).where(SecurityEvent.person_id == person.id).values(network="")
    )
    erased.rows += _count(session, sa.delete(Mail).where(Mail.recipient == email))
    erased.rows += _count(session, sa.delete(SignUp).where(SignUp.email == email))
    for name_of_table in INVITED:
        table = Base.metadata.tables[name_of_table]
        erased.rows += _count(session, sa.update(table).where(table.c.email == email).values(email=pseudonym))
    person.name, person.email = f"Former user {str(person.id)[-6:]}", pseudonym
    person.password_hash = person.email_verified_at = person.email_proof = person.picture_sha256 = None
    erasure_queries.end_engagements(session, person.id, clock.now())
    return erased


def of_person(person_id: UUID) -> scopes.Scope:
    """Return the rows of a table that are about a person alone; None where none are."""

    def scope(table: sa.Table) -> sa.ColumnElement[bool] | None:
        is_personal = "studio_id" not in table.c or table.name in PERSONAL
        return table.c.person_id == person_id if is_personal and "person_id" in table.c else None

    return scope


def obstacle_of_contracts(session: Session, name: str, **of: UUID) -> str | None:
    """Return the reason signed contracts keep a project or a studio; None where it has none."""
    signed = erasure_queries.signed_contracts(session, **of)
    if not signed:
        return None
    is_of_project = "project_id" in of  # one of a studio may be in a project that the reader does not see
    example = f", such as {signed[0].title}" if is_of_project else ""
    return (
        f"{name} has {counted(len(signed), 'signed contract')}{example}: contracts, invoices and "
        "the record of what was accepted are kept as evidence and for the tax office"
    )


def _ensure_unsigned(session: Session, name: str, **of: UUID) -> None:
    if obstacle := obstacle_of_contracts(session, name, **of):
        raise ErasureRefused(
            obstacle,
            fix="export the studio and keep the file as long as the law asks, or erase what has no contract",
        )


def _delete(session: Session, scope: scopes.Scope) -> int:
    count = 0
    try:
        for table in reversed(scopes.tables()):
            where = scope(table)
            if where is not None:
                count += _count(session, sa.delete(table).where(where))
    except IntegrityError as error:
        raise ErasureRefused(
            f"rows elsewhere refer to it ({str(error.orig).splitlines()[0]}); nothing was erased"
        ) from None
    return count


def _count(session: Session, statement: sa.Delete | sa.Update) -> int:
    return session.connection().execute(statement).rowcount
