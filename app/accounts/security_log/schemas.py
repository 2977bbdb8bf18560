"""Answers of the security log."""

from datetime import datetime
from uuid import UUID

from pydantic import Field

from app.accounts.schemas import PersonBrief
from app.accounts.security_log.rules import SecurityEventKind
from app.core.web.http import Schema


class SecurityEventRead(Schema):
    """One line of a studio's security log."""

    id: UUID
    at: datetime
    kind: SecurityEventKind
    summary: str
    person: PersonBrief | None = Field(description="Who did it; null: the server's command line.")
    about: PersonBrief | None = Field(description="Whose roles or membership changed; null where nobody else is meant.")
    network: str = Field(description="An IPv4 address or the /64 of an IPv6 one; empty for the command line.")
