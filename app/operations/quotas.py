"""A studio's use of its limits, for its producer and for operators."""

import math
from collections.abc import Mapping
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.quotas.queries import Usage, own_limits, people_in, tokens_of
from app.accounts.quotas.service import DEFAULTS, QuotaKind, with_defaults
from app.accounts.rules import Actor
from app.accounts.service import ensure_producer_of
from app.core.db import bypass_row_policies
from app.core.web.http import Page, cursor_of, number_cursor
from app.deliveries.queries import kept_master_bytes, open_uploads
from app.hiring.roster.queries import kept_reel_bytes
from app.operations import queries
from app.operations.schemas import QuotaRead, StudioQuotas
from app.projects.queries import projects_count
from app.references.queries import kept_reference_bytes
from app.sound_lists.queries import cues_count

PAGE_STUDIOS = 50
USED: Mapping[QuotaKind, Usage] = {
    QuotaKind.MASTER_BYTES: kept_master_bytes,
    QuotaKind.CUES: cues_count,
    QuotaKind.PROJECTS: projects_count,
    QuotaKind.PEOPLE: people_in,
    QuotaKind.TOKENS: tokens_of,
    QuotaKind.OPEN_UPLOADS: open_uploads,
    QuotaKind.REFERENCE_BYTES: kept_reference_bytes,
    QuotaKind.REEL_BYTES: kept_reel_bytes,
}


def studio_quotas(session: Session, actor: Actor, studio_id: UUID) -> list[QuotaRead]:
    """Return a studio's use of its limits to its producer."""
    ensure_producer_of(session, actor, studio_id)
    with bypass_row_policies(session):  # sums over the whole studio
        return quotas_of(session, studio_id)


def server_quotas(session: Session, cursor: str | None) -> Page[StudioQuotas]:
    """Return studios' use of their limits to the operator, those nearest to one first, by one statement a kind."""
    start = number_cursor(cursor) or 0
    with bypass_row_policies(session):  # sums over every studio, and no row of any
        used = {kind: usage.by_studio(session) for kind, usage in USED.items()}
        limits = own_limits(session)
        names = queries.studio_names(session)
    studios = []
    for studio_id, name in names.items():
        amounts = {kind: used[kind].get(studio_id, 0) for kind in USED}
        quotas = sorted(_quotas_read(amounts, limits.get(studio_id, {})), key=_share, reverse=True)
        studios.append(StudioQuotas(studio_id=studio_id, studio_name=name, quotas=quotas))
    studios.sort(key=lambda studio: (-_share(studio.quotas[0]), studio.studio_name, studio.studio_id))
    end = start + PAGE_STUDIOS
    return Page(items=studios[start:end], next=cursor_of(end) if end < len(studios) else None)


def quotas_of(session: Session, studio_id: UUID) -> list[QuotaRead]:
    """Return a studio's use of its limits."""
    used = {kind: usage(session, studio_id) for kind, usage in USED.items()}
    return _quotas_read(used, own_limits(session, studio_id).get(studio_id, {}))


def _quotas_read(used: Mapping[QuotaKind, int], own_limits: Mapping[str, int]) -> list[QuotaRead]:
    limits = with_defaults(own_limits)
    return [QuotaRead(kind=kind, used=used[kind], limit=limits[kind], default=DEFAULTS[kind]) for kind in USED]


def _share(quota: QuotaRead) -> float:
    return quota.used / quota.limit if quota.limit else math.inf
