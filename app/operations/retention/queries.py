"""The masters of a designer in a project, and the contracts that say how long they are kept."""

from collections.abc import Sequence
from datetime import datetime, timedelta
from typing import NamedTuple
from uuid import UUID

from sqlalchemy import ColumnElement, Row, case, exists, func, select, update
from sqlalchemy.orm import Session, joinedload

from app.agreements.models import Contract
from app.agreements.rules import ContractKind, ContractState
from app.deliveries.models import Take
from app.operations.models import MasterRetention
from app.operations.retention.rules import ANNOUNCED_BEFORE
from app.renders.models import Picture

SIGNED = (ContractState.AGREED, ContractState.ENDED)
SHORTEST = timedelta(days=365) - ANNOUNCED_BEFORE  # no contract asks for less than a year


class Masters(NamedTuple):
    """The kept masters of a designer in a project: number, size and last delivery."""

    kept: int
    size_bytes: int
    last_delivery_at: datetime | None


def masters(session: Session, project_id: UUID, designer_id: UUID) -> Masters:
    """Return the number, size and last delivery of the kept masters of a designer in a project."""
    row = session.execute(
        select(func.count(), func.coalesce(func.sum(Take.master_bytes), 0), func.max(Take.received_at)).where(
            *_kept(project_id, designer_id)
        )
    ).one()
    return Masters(row[0], int(row[1]), row[2])


def candidates(session: Session, now: datetime) -> Sequence[Row[UUID, UUID]]:
    """Return the projects and designers with masters, signed long ago, that no producer keeps longer."""
    is_kept_longer = exists().where(
        MasterRetention.project_id == Contract.project_id,
        MasterRetention.designer_id == Contract.designer_id,
        MasterRetention.kept_by.is_not(None),
    )
    has_masters = exists().where(
        Take.project_id == Contract.project_id,
        Take.designer_id == Contract.designer_id,
        Take.master_deleted_at.is_(None),
    )
    return session.execute(
        select(Contract.project_id, Contract.designer_id)
        .where(
            Contract.state.in_(SIGNED),
            Contract.kind != ContractKind.NDA,
            Contract.agreed_at <= now - SHORTEST,
            has_masters,
            ~is_kept_longer,
        )
        .distinct()
        .order_by(Contract.project_id, Contract.designer_id)
    ).all()


def contracts(session: Session, project_id: UUID, designer_id: UUID) -> Sequence[Contract]:
    """Return the contracts with a designer in a project that were sent or signed, NDAs left out."""
    return session.scalars(
        select(Contract)
        .where(
            Contract.project_id == project_id,
            Contract.designer_id == designer_id,
            Contract.state != ContractState.DRAFT,
            Contract.kind != ContractKind.NDA,
        )
        .options(joinedload(Contract.project), joinedload(Contract.designer))
        .order_by(Contract.id)
    ).all()


def retention(session: Session, project_id: UUID, designer_id: UUID, *, locked: bool = False) -> MasterRetention | None:
    """Return the retention of a designer's masters in a project; None before anything was announced or kept longer."""
    return session.get(MasterRetention, (project_id, designer_id), with_for_update=locked or None)


def mark_deleted(session: Session, studio_id: UUID, project_id: UUID, designer_id: UUID, now: datetime) -> None:
    """Mark a designer's masters in a project as deleted; no row names their files from then on.

    A master that was its own preview is played by its light one, if it has one.
    """
    session.execute(update(Take).where(*_kept(project_id, designer_id)).values(master_deleted_at=now))
    of_studio = select(Take.master_sha256).where(Take.studio_id == studio_id)
    of_designer = of_studio.where(Take.project_id == project_id, Take.designer_id == designer_id)
    session.execute(
        update(Picture)
        .where(
            Picture.studio_id == studio_id,
            Picture.preview_sha256 == Picture.sound_sha256,
            Picture.sound_sha256.in_(of_designer),
            Picture.sound_sha256.not_in(of_studio.where(Take.master_deleted_at.is_(None))),
        )
        .values(
            preview_sha256=Picture.light_sha256,
            preview_media_type=case((Picture.light_sha256.is_not(None), "audio/ogg")),
        )
    )


def _kept(project_id: UUID, designer_id: UUID) -> tuple[ColumnElement[bool], ...]:
    return Take.project_id == project_id, Take.designer_id == designer_id, Take.master_deleted_at.is_(None)
