"""Queries of the source banks of takes."""

from collections import defaultdict
from collections.abc import Collection
from uuid import UUID

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.core.in_array import in_array
from app.deliveries.models import SourceBank, SourceFile


def source_banks(session: Session, take_ids: Collection[UUID]) -> dict[UUID, SourceBank]:
    """Return the recipes of takes by take; those without one are left out."""
    banks = session.scalars(select(SourceBank).where(in_array(SourceBank.take_id, take_ids)))
    return {bank.take_id: bank for bank in banks}


def source_files(session: Session, take_ids: Collection[UUID]) -> dict[UUID, list[SourceFile]]:
    """Return the source files of takes by take, in the order in which they came."""
    files: dict[UUID, list[SourceFile]] = defaultdict(list)
    for file in session.scalars(
        select(SourceFile).where(in_array(SourceFile.take_id, take_ids)).order_by(SourceFile.id)
    ):
        files[file.take_id].append(file)
    return files


def source_file_of_upload(session: Session, take_id: UUID, upload_id: UUID) -> SourceFile | None:
    """Return the source file that an upload became for a take."""
    return session.scalar(select(SourceFile).where(SourceFile.take_id == take_id, SourceFile.upload_id == upload_id))


def source_file_by_id(session: Session, source_file_id: UUID) -> SourceFile | None:
    """Return a source file without asking who looks."""
    return session.get(SourceFile, source_file_id)
