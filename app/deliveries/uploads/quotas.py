"""Whether a studio has room for another upload; its use is counted every few seconds, not for each file."""

import time
from collections.abc import Callable
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.quotas.service import QuotaKind, ensure_quota
from app.deliveries import queries

COUNTED_EVERY_S = 15.0  # a count reads an index of all masters of a studio
_counted: dict[tuple[QuotaKind, UUID], tuple[float, int]] = {}


def ensure_upload_fits(session: Session, studio_id: UUID, length: int) -> None:
    """Raise StorageQuotaReached or QuotaReached before a byte is stored; what is finished is never refused."""
    ensure_quota(session, studio_id, QuotaKind.MASTER_BYTES, _lately(QuotaKind.MASTER_BYTES), added=length)
    ensure_quota(session, studio_id, QuotaKind.OPEN_UPLOADS, _lately(QuotaKind.OPEN_UPLOADS))


def _lately(kind: QuotaKind) -> Callable[[Session, UUID], int]:
    count = queries.kept_master_bytes if kind is QuotaKind.MASTER_BYTES else queries.open_uploads

    def counted(session: Session, studio_id: UUID) -> int:
        at, known = _counted.get((kind, studio_id), (float("-inf"), 0))
        if time.monotonic() - at > COUNTED_EVERY_S:
            known = count(session, studio_id)
            _counted[kind, studio_id] = time.monotonic(), known
        return known

    return counted
