"""The row of an upload: bound to its owner before a byte comes, and finished once its bytes are in the store."""

from dataclasses import dataclass
from datetime import datetime, timedelta
from uuid import UUID

from sqlalchemy import BigInteger, CheckConstraint, bindparam, insert, select, update
from sqlalchemy.orm import Mapped, Session, mapped_column

from app.core import clock
from app.core.columns import Dated
from app.core.db import Base, new_id
from app.core.uploads.errors import UploadNotFound, UploadUnfinished

FINISHED_KEPT_FOR = timedelta(days=30)  # by then something was made of it, or nothing will be


class Upload(Dated, Base):
    """One file on its way in, or arrived; `scope` and `owner_id` mean something to the caller only."""

    __tablename__ = "core_uploads"
    __table_args__ = (
        CheckConstraint("length >= 0", name="length_known"),
        CheckConstraint("(sha256 is null) = (finished_at is null)", name="finished_is_hashed"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    studio_id: Mapped[UUID] = mapped_column(index=True)
    owner_id: Mapped[UUID]
    scope: Mapped[str]
    file_name: Mapped[str]
    length: Mapped[int] = mapped_column(BigInteger)
    expected_sha256: Mapped[str | None]
    sha256: Mapped[str | None]  # once it is in the store
    multipart_id: Mapped[str | None]  # what the store calls it, where it comes there in parts
    finished_at: Mapped[datetime | None]


# To build a statement takes longer than to run it.
OF_ID = select(Upload).where(Upload.id == bindparam("upload_id"))
_OF_ID_LOCKED = OF_ID.with_for_update()
BEGIN = insert(Upload)
FINISH = (
    update(Upload)
    .where(Upload.id == bindparam("upload_id"))
    .values(sha256=bindparam("found_sha256"), finished_at=bindparam("then"))
)


@dataclass(frozen=True)
class FinishedUpload:
    """A file that is wholly here and in the store."""

    id: UUID
    file_name: str
    sha256: str
    size_bytes: int


def finished_upload(session: Session, upload_id: UUID, *, owner_id: UUID, scope: str) -> FinishedUpload:
    """Return a finished upload of this owner and scope, locked until the transaction ends.

    Raises UploadNotFound where it belongs to another owner, UploadUnfinished where bytes are missing.
    """
    upload = session.scalar(_OF_ID_LOCKED, {"upload_id": upload_id})
    if upload is None or upload.owner_id != owner_id or upload.scope != scope:
        raise UploadNotFound(f"no upload {upload_id}")
    if upload.finished_at is not None and upload.finished_at < clock.now() - FINISHED_KEPT_FOR:
        raise UploadNotFound(f"the upload {upload_id} has expired", fix="upload the file again")
    if upload.sha256 is None:
        raise UploadUnfinished("this file is not completely uploaded yet", fix="ask for its offset and send the rest")
    return FinishedUpload(upload.id, upload.file_name, upload.sha256, upload.length)
