"""What studios keep, summed up from what the rooms know; callers have checked who looks."""

from dataclasses import dataclass
from uuid import UUID

from sqlalchemy import Row, Select, func, select
from sqlalchemy.orm import Session

from app.accounts.models import Person, Studio
from app.deliveries.models import Take
from app.renders.models import Render


@dataclass(frozen=True)
class Storage:
    """What one studio keeps."""

    studio_id: UUID
    studio_name: str
    masters: int
    master_bytes: int
    renders: int
    render_bytes: int


def address_of(session: Session, person_id: UUID) -> str:
    """Return a person's normalised mail address."""
    return session.get_one(Person, person_id).email


def studio_names(session: Session, ids: set[UUID]) -> dict[UUID, str]:
    """Return the names of studios."""
    return dict(session.execute(select(Studio.id, Studio.name).where(Studio.id.in_(ids))).all())


def storage(session: Session, studio_id: UUID | None = None) -> list[Storage]:
    """Return what each studio keeps, the largest first; one studio alone where it is given."""
    masters = select(Take.studio_id, Take.master_sha256, func.max(Take.master_bytes).label("size_bytes"))
    renders = select(Render.studio_id, Render.sha256, func.max(Render.file_bytes).label("size_bytes"))
    renders = renders.where(Render.sha256.is_not(None))
    studios = select(Studio.id, Studio.name)
    if studio_id is not None:
        masters, renders = masters.where(Take.studio_id == studio_id), renders.where(Render.studio_id == studio_id)
        studios = studios.where(Studio.id == studio_id)
    kept_masters = _summed(session, masters.group_by(Take.studio_id, Take.master_sha256))
    kept_renders = _summed(session, renders.group_by(Render.studio_id, Render.sha256))
    found = [
        Storage(id_, name, *kept_masters.get(id_, (0, 0)), *kept_renders.get(id_, (0, 0)))
        for id_, name in session.execute(studios)
    ]
    return sorted(found, key=lambda each: (-each.master_bytes - each.render_bytes, each.studio_name))


def _summed(
    session: Session, blobs: Select[UUID, str, int] | Select[UUID, str | None, int | None]
) -> dict[UUID, tuple[int, int]]:
    kept = blobs.subquery()
    rows: list[Row[UUID, int, int]] = list(
        session.execute(select(kept.c.studio_id, func.count(), func.sum(kept.c.size_bytes)).group_by(kept.c.studio_id))
    )
    return {studio_id: (count, int(size_bytes or 0)) for studio_id, count, size_bytes in rows}
