"""Upload destinations: a delivery, an adoption, a project's references or a reel; permitted senders and sizes."""

from collections.abc import Mapping
from dataclasses import dataclass
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.core.events import send
from app.deliveries import service
from app.deliveries.adoptions import service as adoptions
from app.deliveries.errors import BadUploadHeader
from app.deliveries.rules import max_bytes
from app.deliveries.signals import ReelUpload
from app.deliveries.uploads.headers import uuid_in
from app.deliveries.uploads.quotas import ensure_upload_fits
from app.references import service as references

REEL_SCOPE = "roster:"  # of uploads, before the id of the designer on file
MAX_REEL_SOUND_BYTES = 50_000_000


def reel_scope(roster_entry_id: UUID) -> str:
    """Return the scope of uploads that become sounds of a reel."""
    return f"{REEL_SCOPE}{roster_entry_id}"


@dataclass(frozen=True)
class Destination:
    """The destination of a file, by the metadata of its upload."""

    delivery_id: UUID | None = None
    beside_take_id: UUID | None = None  # of the take that a dry stem is for
    project_id: UUID | None = None
    adoption_id: UUID | None = None
    roster_entry_id: UUID | None = None

    @property
    def scope(self) -> str:
        """The scope that the upload keeps."""
        if self.adoption_id:
            return f"{adoptions.SCOPE}{self.adoption_id}"
        if self.roster_entry_id:
            return reel_scope(self.roster_entry_id)
        return references.upload_scope(self.project_id) if self.project_id else str(self.delivery_id)

    def most_bytes(self, file_name: str, reference_max_bytes: int) -> int:
        """Return the most bytes that a file may have there."""
        if self.roster_entry_id:
            return MAX_REEL_SOUND_BYTES
        return reference_max_bytes if self.project_id else max_bytes(file_name)


def destination_in(metadata: Mapping[str, str]) -> Destination:
    """Read the destination of an upload; raise BadUploadHeader where that is two places, or none."""
    places = [field for field in ("delivery_id", "project_id", "adoption_id", "roster_entry_id") if field in metadata]
    if len(places) > 1:
        raise BadUploadHeader(f"Upload-Metadata names {places[0]} and {places[1]}; a file goes to one of them")
    if "adoption_id" in metadata:
        return Destination(adoption_id=uuid_in("adoption_id", metadata["adoption_id"]))
    if "roster_entry_id" in metadata:
        return Destination(roster_entry_id=uuid_in("roster_entry_id", metadata["roster_entry_id"]))
    if "project_id" in metadata:
        return Destination(project_id=uuid_in("project_id", metadata["project_id"]))
    take_id = uuid_in("take_id", metadata["take_id"]) if "take_id" in metadata else None
    return Destination(uuid_in("delivery_id", metadata.get("delivery_id", "")), take_id)


def ensure_may_send(session: Session, actor: Actor, destination: Destination, length: int) -> UUID:
    """Return the studio of a destination; raise unless the caller may send a file there, and it has room."""
    if destination.project_id is not None:
        studio_id = references.ensure_may_upload(session, actor, destination.project_id, length)
        ensure_upload_fits(session, studio_id, 0)
        return studio_id
    if destination.roster_entry_id is not None:
        studio_id = _studio_of_reel(session, ReelUpload(actor, destination.roster_entry_id, length))
        ensure_upload_fits(session, studio_id, 0)
        return studio_id
    if destination.adoption_id is not None:
        studio_id = adoptions.ensure_may_upload(session, actor, destination.adoption_id)
        ensure_upload_fits(session, studio_id, length)
        return studio_id
    if destination.delivery_id is None:
        raise LookupError("a destination without a place")
    delivery = service.ensure_may_upload(
        session, actor, destination.delivery_id, beside_take_id=destination.beside_take_id
    )
    ensure_upload_fits(session, delivery.studio_id, length)
    return delivery.studio_id


def ensure_may_continue(session: Session, actor: Actor, scope: str) -> None:
    """Raise unless the caller may still send to where an upload goes; a delivery closed meanwhile takes it."""
    if scope.startswith(REEL_SCOPE):
        _studio_of_reel(session, ReelUpload(actor, UUID(scope.removeprefix(REEL_SCOPE)), None))
    elif scope.startswith(references.SCOPE):
        references.ensure_may_continue(session, actor, scope)
    elif scope.startswith(adoptions.SCOPE):
        adoptions.ensure_may_continue(session, actor, scope)
    else:
        service.own_delivery(session, actor, UUID(scope))


def _studio_of_reel(session: Session, upload: ReelUpload) -> UUID:
    studios = send(session, upload)
    if not studios:
        raise BadUploadHeader("Upload-Metadata names roster_entry_id; this server keeps no designers on file")
    return studios[0]
