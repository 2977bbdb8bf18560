"""Tokens for the builds of a project."""

from collections.abc import Collection, Sequence
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.models import Token
from app.accounts.queries import project_token, project_tokens
from app.accounts.rules import MAX_TOKEN_DAYS, Actor, Scope
from app.accounts.security_log.rules import SecurityEventKind
from app.accounts.security_log.service import record
from app.accounts.service import add_token
from app.core import clock
from app.projects import queries
from app.projects.errors import (
    ProjectNotFound,
    TokenNotFound,
)
from app.projects.service import project_access


def create_token(
    session: Session, actor: Actor, project_id: UUID, *, name: str, scopes: Collection[Scope], days: int
) -> tuple[Token, str]:
    """Make a key for the project's builds that ends after so many days; its secret is shown this once."""
    access = project_access(session, actor, project_id)
    access.ensure_producer()
    return add_token(
        session,
        studio_id=access.project.studio_id,
        project_id=project_id,
        created_by=actor.person,
        name=name,
        scopes=scopes,
        days=days,
    )


def issue_token(
    session: Session, project_id: UUID, *, name: str, scopes: Collection[Scope], days: int = MAX_TOKEN_DAYS
) -> str:
    """Make a key for the project's builds from the server's own command line, and return its secret."""
    project = queries.project_by_id(session, project_id)
    if project is None:
        raise ProjectNotFound(f"no project {project_id}")
    _, secret = add_token(
        session,
        studio_id=project.studio_id,
        project_id=project_id,
        created_by=queries.approver_of(session, project),  # who opened it may have left
        name=name,
        scopes=scopes,
        days=days,
    )
    return secret


def tokens_of(session: Session, actor: Actor, project_id: UUID) -> Sequence[Token]:
    """Return the project's tokens, without their secrets."""
    project_access(session, actor, project_id).ensure_producer()
    return project_tokens(session, project_id)


def revoke_token(session: Session, actor: Actor, project_id: UUID, token_id: UUID) -> None:
    """Revoke a token at once."""
    project_access(session, actor, project_id).ensure_producer()
    token = project_token(session, project_id, token_id)
    if token is None:
        raise TokenNotFound(f"no token {token_id} in this project")
    if token.revoked_at is None:
        token.revoked_at = clock.now()
        summary = f"revoked the build token {token.name}"
        record(
            session,
            SecurityEventKind.TOKEN,
            summary,
            studio_ids=[token.studio_id],
            project_id=project_id,
            person_id=actor.person,
        )
