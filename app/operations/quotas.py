"""A studio's use of its limits, for its producer and for operators."""

import math
from collections.abc import Callable, Mapping
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.quota_queries import people_in, tokens_of
from app.accounts.quotas import DEFAULTS, QuotaKind, limits_of
from app.accounts.rules import Actor
from app.accounts.service import ensure_producer_of
from app.deliveries.queries import kept_master_bytes, open_uploads
from app.hiring.roster_queries import kept_reel_bytes
from app.kit.db import bypass_row_policies
from app.operations import queries
from app.operations.schemas import QuotaRead, StudioQuotas
from app.projects.queries import projects_count
from app.references.queries import kept_reference_bytes
from app.sound_lists.queries import cues_count

USED: Mapping[QuotaKind, Callable[[Session, UUID], int]] = {
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
    """Return what a studio uses of its limits to its producer."""
    ensure_producer_of(session, actor, studio_id)
    with bypass_row_policies(session):  # sums over the whole studio
        return quotas_of(session, studio_id)


def server_quotas(session: Session) -> list[StudioQuotas]:
    """Return what every studio uses of its limits to the operator; who is nearest to one comes first."""
    with bypass_row_policies(session):  # sums over every studio, and no row of any
        studios = [
            StudioQuotas(
                studio_id=studio.id,
                studio_name=studio.name,
                quotas=sorted(quotas_of(session, studio.id), key=_share, reverse=True),
            )
            for studio in queries.studios(session)
        ]
    return sorted(studios, key=lambda studio: _share(studio.quotas[0]), reverse=True)


def _share(quota: QuotaRead) -> float:
    return quota.used / quota.limit if quota.limit else math.inf


def quotas_of(session: Session, studio_id: UUID) -> list[QuotaRead]:
    """Return what a studio uses of its limits."""
    limits = limits_of(session, studio_id)
    return [
        QuotaRead(kind=kind, used=used(session, studio_id), limit=limits[kind], default=DEFAULTS[kind])
        for kind, used in USED.items()
    ]
