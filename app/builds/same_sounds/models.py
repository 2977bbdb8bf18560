"""The tables by which a sound is found again in the studio's other projects."""

from datetime import datetime
from uuid import UUID

from sqlalchemy import ForeignKey
from sqlalchemy.orm import Mapped, mapped_column

from app.core import clock
from app.core.columns import StudioOwned
from app.core.db import Base


class MasterFingerprint(Base):
    """The fingerprint by which a master is recognised among those of other projects."""

    __tablename__ = "builds_master_fingerprints"

    studio_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_studios.id"), primary_key=True)
    sound_sha256: Mapped[str] = mapped_column(primary_key=True)
    fingerprint_version: Mapped[int]  # of audio_checks: fingerprints of earlier versions are not used
    pcm_sha256: Mapped[str | None]  # None: the master could not be read
    sample_rate_hz: Mapped[int] = mapped_column(default=0)
    fingerprint: Mapped[bytes | None]  # None: silence, or next to nothing between 60 Hz and 3.8 kHz
    moments: Mapped[bytes] = mapped_column(default=b"")  # of the fingerprint: its loudest, for finding it quickly
    made_at: Mapped[datetime] = mapped_column(default=clock.now)


class SameSound(StudioOwned, Base):
    """A take that holds the same sound as one of another project; each of the two has a row."""

    __tablename__ = "builds_same_sounds"

    take_id: Mapped[UUID] = mapped_column(ForeignKey("deliveries_takes.id"), primary_key=True)
    other_take_id: Mapped[UUID] = mapped_column(ForeignKey("deliveries_takes.id"), primary_key=True)
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))  # of the take, not of the other
    score: Mapped[float]
    gain_db: Mapped[float]  # by how much the take is louder than the other
    has_same_samples: Mapped[bool]
    is_trimmed: Mapped[bool]
    is_resampled: Mapped[bool]
    found_at: Mapped[datetime] = mapped_column(default=clock.now)
