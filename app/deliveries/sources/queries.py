"""Queries of the sources of takes."""

from collections.abc import Collection, Sequence
from uuid import UUID

from sqlalchemy import select
from sqlalchemy.orm import Session, joinedload

from app.core.in_array import in_array
from app.deliveries.models import SourceStatement, Take
from app.deliveries.rules import TakeState


def source_statements(session: Session, take_ids: Collection[UUID]) -> dict[UUID, SourceStatement]:
    """Return by take what was stated of its sources: its own statement, else that of its delivery."""
    rows = session.execute(
        select(Take.id, SourceStatement)
        .join(
            SourceStatement,
            (SourceStatement.take_id == Take.id)
            | (SourceStatement.take_id.is_(None) & (SourceStatement.delivery_id == Take.delivery_id)),
        )
        .where(in_array(Take.id, take_ids))
        .options(joinedload(SourceStatement.designer))
    )
    statements: dict[UUID, SourceStatement] = {}
    for take_id, statement in rows:
        if statement.take_id is not None or take_id not in statements:
            statements[take_id] = statement
    return statements


def source_statement_of(session: Session, delivery_id: UUID, take_id: UUID | None) -> SourceStatement | None:
    """Return the statement of one take, or that of its delivery, with who made it."""
    mine = SourceStatement.take_id.is_(None) if take_id is None else SourceStatement.take_id == take_id
    return session.scalar(
        select(SourceStatement)
        .where(SourceStatement.delivery_id == delivery_id, mine)
        .options(joinedload(SourceStatement.designer))
    )


def last_source_statement(session: Session, studio_id: UUID, designer_id: UUID) -> SourceStatement | None:
    """Return a designer's last statement in a studio."""
    return session.scalar(
        select(SourceStatement)
        .where(SourceStatement.studio_id == studio_id, SourceStatement.designer_id == designer_id)
        .order_by(SourceStatement.stated_at.desc(), SourceStatement.id.desc())
        .limit(1)
    )


def approved_takes_of(session: Session, cue_ids: Collection[UUID], designer_id: UUID) -> Sequence[Take]:
    """Return the approved takes of a designer for cues, with the cues."""
    return session.scalars(
        select(Take)
        .where(in_array(Take.cue_id, cue_ids), Take.state == TakeState.APPROVED, Take.designer_id == designer_id)
        .options(joinedload(Take.cue))
        .order_by(Take.cue_id, Take.variation)
    ).all()
