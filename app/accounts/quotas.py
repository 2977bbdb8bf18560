"""How much one studio may keep on this server: generous limits, which whoever runs it sets otherwise by command."""

from collections.abc import Callable, Mapping
from enum import StrEnum
from uuid import UUID

from sqlalchemy import delete, func, select
from sqlalchemy.orm import Session

from app.accounts.errors import QuotaReached, StorageQuotaReached
from app.accounts.models import Membership, Quota, Token
from app.kit.db import beyond_reach


class QuotaKind(StrEnum):
    """What is limited."""

    MASTER_BYTES = "master_bytes"
    CUES = "cues"
    PROJECTS = "projects"
    PEOPLE = "people"
    TOKENS = "tokens"
    OPEN_UPLOADS = "open_uploads"


DEFAULTS: Mapping[QuotaKind, int] = {
    QuotaKind.MASTER_BYTES: 2_000_000_000_000,
    QuotaKind.CUES: 500_000,
    QuotaKind.PROJECTS: 1_000,
    QuotaKind.PEOPLE: 2_000,
    QuotaKind.TOKENS: 1_000,
    QuotaKind.OPEN_UPLOADS: 10_000,
}
NOUNS: Mapping[QuotaKind, str] = {
    QuotaKind.MASTER_BYTES: "bytes of masters",
    QuotaKind.CUES: "cues",
    QuotaKind.PROJECTS: "projects",
    QuotaKind.PEOPLE: "people",
    QuotaKind.TOKENS: "tokens",
    QuotaKind.OPEN_UPLOADS: "unfinished uploads",
}


def limits_of(session: Session, studio_id: UUID) -> dict[QuotaKind, int]:
    """Return the limits of a studio."""
    rows = session.execute(select(Quota.kind, Quota.most).where(Quota.studio_id == studio_id)).all()
    return {**DEFAULTS, **{QuotaKind(kind): most for kind, most in rows}}


def set_limit(session: Session, studio_id: UUID, kind: QuotaKind, most: int | None) -> None:
    """Set a limit of a studio; None: the default again."""
    session.execute(delete(Quota).where(Quota.studio_id == studio_id, Quota.kind == kind.value))
    if most is not None:
        session.add(Quota(studio_id=studio_id, kind=kind.value, most=most))
    session.flush()


def ensure_room(
    session: Session, studio_id: UUID, kind: QuotaKind, used: Callable[[Session, UUID], int], *, added: int = 1
) -> None:
    """Raise QuotaReached where a studio would have more of a kind than it may; `used` counts what it has."""
    if added <= 0:
        return
    most = limits_of(session, studio_id)[kind]
    with beyond_reach(session):  # a designer sees their own work alone, and the limit counts everybody's
        has = used(session, studio_id)
    if has + added > most:
        refusal = StorageQuotaReached if kind is QuotaKind.MASTER_BYTES else QuotaReached
        raise refusal(
            f"the studio has {has:,} {NOUNS[kind]} and may have {most:,}; this would add {added:,}",
            fix="remove some, or ask whoever runs this server for a higher limit (soundlist quota)",
        )


def people_in(session: Session, studio_id: UUID) -> int:
    """Return how many members a studio has."""
    return session.scalar(select(func.count()).where(Membership.studio_id == studio_id)) or 0


def tokens_of(session: Session, studio_id: UUID) -> int:
    """Return how many tokens of a studio work."""
    return session.scalar(select(func.count()).where(Token.studio_id == studio_id, Token.revoked_at.is_(None))) or 0
