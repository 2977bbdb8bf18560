"""Dry stems: a sound without its reverb, delivered with a take, so that its reverb is measured and not estimated."""

from collections.abc import Collection
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.core import clock
from app.core.events import publish
from app.core.uploads import FinishedUpload, finished_upload
from app.deliveries import queries
from app.deliveries.downloads import ensure_open
from app.deliveries.errors import DryStemNotFound
from app.deliveries.models import Delivery, DryStem, Take
from app.deliveries.rules import dry_stem_for, ensure_no_verdict, stem_of, stored_name
from app.deliveries.schemas import DryStemRead
from app.deliveries.service import Origin, ensure_own_designer, own_delivery, take_for, uploader
from app.deliveries.slots import slot_of_stem


def stem_for_name(session: Session, delivery: Delivery, file_name: str) -> str | None:
    """Return the stem of the takes that a delivered file is the dry stem of, by its name; None for a take.

    A name that a cue of the list owns whole is that cue's.
    """
    name = stored_name(file_name)
    stem = dry_stem_for(name)
    return stem if stem is not None and slot_of_stem(session, delivery.project_id, name) is None else None


def receive_dry_stem(
    session: Session, actor: Actor, delivery_id: UUID, *, upload: FinishedUpload, file_name: str, stem: str
) -> DryStem:
    """Keep a finished upload as the dry stem of the takes of a name in its delivery, come or still to come."""
    delivery, _ = own_delivery(session, actor, delivery_id)
    return add_dry_stem(
        session, delivery, upload.sha256, upload.size_bytes, file_name, stem, Origin(upload_id=upload.id)
    )


def add_dry_stem(
    session: Session, delivery: Delivery, sha256: str, file_bytes: int, file_name: str, stem: str, origin: Origin
) -> DryStem:
    """Keep stored bytes as a dry stem, and have the takes that it is for compared with it.

    The same upload again is the same stem, and is back where it was withdrawn.
    """
    live = queries.live_stems(session, delivery.id, stem)
    if live and live[0].sha256 == sha256:
        return live[0]
    made = queries.dry_stem_of_upload(session, origin.upload_id, stem) if origin.upload_id else None
    if made is None:
        made = DryStem(
            studio_id=delivery.studio_id,
            project_id=delivery.project_id,
            delivery_id=delivery.id,
            stem=stem,
            upload_id=origin.upload_id,
            archive_id=origin.archive_id,
            archive_entry=origin.archive_entry,
            file_name=stored_name(file_name),
            sha256=sha256,
            file_bytes=file_bytes,
        )
        session.add(made)
    made.withdrawn_at, made.received_at = None, clock.now()
    _changed(session, made)
    return made


def add_dry_stem_to_take(session: Session, actor: Actor, take_id: UUID, upload_id: UUID) -> DryStem:
    """Give a take the dry stem that an upload into its delivery brought, whatever that is called."""
    take, access = take_for(session, actor, take_id, locked=True)
    ensure_own_designer(access, take)
    ensure_no_verdict(take.state)
    upload = finished_upload(session, upload_id, owner_id=uploader(actor), scope=str(take.delivery_id))
    delivery, _ = own_delivery(session, actor, take.delivery_id)
    origin = Origin(upload_id=upload.id)
    stem = stem_of(take.file_name)
    return add_dry_stem(session, delivery, upload.sha256, upload.size_bytes, upload.file_name, stem, origin)


def withdraw_dry_stem(session: Session, actor: Actor, take_id: UUID) -> None:
    """Have a take judged without its dry stem again; the file stays on record."""
    take, access = take_for(session, actor, take_id, locked=True)
    ensure_own_designer(access, take)
    ensure_no_verdict(take.state)
    live = queries.live_stems(session, take.delivery_id, stem_of(take.file_name))
    for stem in live:
        stem.withdrawn_at = clock.now()
    if live:
        _changed(session, live[0])


def visible_dry_stem(session: Session, actor: Actor, take_id: UUID) -> DryStem:
    """Return the dry stem of a take within the caller's sight.

    Raises DryStemNotFound where it has none, DownloadUnpaid where its contract opens it by payment.
    """
    take, _ = take_for(session, actor, take_id)
    ensure_open(session, actor, take.cue_id, take.designer_id)
    stem = queries.dry_stem_of(session, take)
    if stem is None:
        raise DryStemNotFound(f"take {take_id} has no dry stem")
    return stem


def copy_to_fix(session: Session, take: Take, fixed: Take) -> None:
    """Let the fixed copy of a take keep its dry stem, where the fix gave it another name."""
    stem = queries.dry_stem_of(session, take)
    if stem is None or queries.dry_stem_of(session, fixed) is not None:
        return
    copied = ("studio_id", "project_id", "delivery_id", "upload_id", "file_name", "sha256", "file_bytes")
    own = {name: getattr(stem, name) for name in copied}
    session.add(DryStem(**own, stem=stem_of(fixed.file_name)))
    session.flush()


def read_dry_stem(session: Session, stem: DryStem) -> DryStemRead:
    """Return a dry stem as it is shown."""
    return _read(stem, queries.takes_beside(session, stem.delivery_id, stem.stem))


def read_dry_stems(session: Session, delivery_id: UUID, takes: Collection[Take]) -> list[DryStemRead]:
    """Return the dry stems of a delivery as they are shown with its takes."""
    here: dict[str, list[UUID]] = {}
    for take in takes:
        here.setdefault(stem_of(take.file_name), []).append(take.id)
    return [_read(stem, here.get(stem.stem, [])) for stem in queries.dry_stems_in(session, delivery_id)]


def _read(stem: DryStem, take_ids: list[UUID]) -> DryStemRead:
    own = {name: getattr(stem, name) for name in DryStemRead.model_fields if name != "take_ids"}
    return DryStemRead.model_validate(own | {"take_ids": take_ids})


def _changed(session: Session, stem: DryStem) -> None:
    session.flush()
    publish(session, "dry_stem.changed", studio_id=stem.studio_id, delivery_id=stem.delivery_id, stem=stem.stem)
