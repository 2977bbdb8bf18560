"""Limits of what a studio may store on this server: generous, changed by the operator's command."""

from collections.abc import Callable, Mapping
from enum import StrEnum
from uuid import UUID

from sqlalchemy import delete
from sqlalchemy.orm import Session

from app.accounts.errors import QuotaReached, StorageQuotaReached
from app.accounts.models import Quota
from app.accounts.quotas import queries as quota_queries
from app.core.db import bypass_row_policies


class QuotaKind(StrEnum):
    """The limited resources."""

    MASTER_BYTES = "master_bytes"
    CUES = "cues"
    PROJECTS = "projects"
    PEOPLE = "people"
    TOKENS = "tokens"
    OPEN_UPLOADS = "open_uploads"
    REFERENCE_BYTES = "reference_bytes"
    REEL_BYTES = "reel_bytes"


DEFAULTS: Mapping[QuotaKind, int] = {
    QuotaKind.MASTER_BYTES: 2_000_000_000_000,
    QuotaKind.CUES: 500_000,
    QuotaKind.PROJECTS: 1_000,
    QuotaKind.PEOPLE: 2_000,
    QuotaKind.TOKENS: 1_000,
    QuotaKind.OPEN_UPLOADS: 10_000,
    QuotaKind.REFERENCE_BYTES: 200_000_000_000,
    QuotaKind.REEL_BYTES: 50_000_000_000,
}
NOUNS: Mapping[QuotaKind, str] = {
    QuotaKind.MASTER_BYTES: "bytes of masters and source files",
    QuotaKind.CUES: "cues",
    QuotaKind.PROJECTS: "projects",
    QuotaKind.PEOPLE: "people",
    QuotaKind.TOKENS: "tokens",
    QuotaKind.OPEN_UPLOADS: "unfinished uploads",
    QuotaKind.REFERENCE_BYTES: "bytes of references",
    QuotaKind.REEL_BYTES: "bytes of reels on the roster",
}


def limits_of(session: Session, studio_id: UUID) -> dict[QuotaKind, int]:
    """Return the limits of a studio."""
    return with_defaults(quota_queries.own_limits(session, studio_id).get(studio_id, {}))


def with_defaults(own_limits: Mapping[str, int]) -> dict[QuotaKind, int]:
    """Return the limit of each kind: the studio's own, or the default."""
    return {**DEFAULTS, **{QuotaKind(kind): maximum for kind, maximum in own_limits.items()}}


def set_limit(session: Session, studio_id: UUID, kind: QuotaKind, maximum: int | None) -> None:
    """Set a limit of a studio; None: the default again."""
    session.execute(delete(Quota).where(Quota.studio_id == studio_id, Quota.kind == kind.value))
    if maximum is not None:
        session.add(Quota(studio_id=studio_id, kind=kind.value, maximum=maximum))
    session.flush()


def ensure_quota(
    session: Session, studio_id: UUID, kind: QuotaKind, used: Callable[[Session, UUID], int], *, added: int = 1
) -> None:
    """Raise QuotaReached where a studio would have more of a kind than it may; `used` counts what it has."""
    if added <= 0:
        return
    maximum = limits_of(session, studio_id)[kind]
    with bypass_row_policies(session):  # a designer sees their own work only, and the limit counts all work
        has = used(session, studio_id)
    if has + added > maximum:
        is_storage = kind in (QuotaKind.MASTER_BYTES, QuotaKind.REFERENCE_BYTES, QuotaKind.REEL_BYTES)
        refusal = StorageQuotaReached if is_storage else QuotaReached
        raise refusal(
            f"the studio has {has:,} {NOUNS[kind]} and may have {maximum:,}; this would add {added:,}",
            fix="remove some, or ask the operator for a higher limit (soundlist quota)",
        )
