"""The tables of this room."""

from datetime import datetime
from uuid import UUID

from sqlalchemy import ForeignKey
from sqlalchemy.orm import Mapped, mapped_column

from app.kit import clock
from app.kit.db import Base, new_id


class Mail(Base):
    """One mail, waiting or sent."""

    __tablename__ = "notifications_mails"

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    studio_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_studios.id"), index=True)
    key: Mapped[str] = mapped_column(unique=True)  # of the event and the recipient: told once
    recipient: Mapped[str]
    subject: Mapped[str]
    text: Mapped[str]
    link: Mapped[str | None]  # what the producer may copy while no SMTP server is set
    created_at: Mapped[datetime] = mapped_column(default=clock.now)
    sent_at: Mapped[datetime | None]
    failure: Mapped[str | None]
