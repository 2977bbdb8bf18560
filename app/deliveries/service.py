"""Deliveries: how finished uploads become takes, and how takes find their cue."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.core import clock
from app.core.events import publish
from app.core.uploads import FinishedUpload
from app.deliveries import queries
from app.deliveries.cue_counts.service import update_take_counts
from app.deliveries.errors import (
    DeliveryClosed,
    DeliveryNotFound,
    InHouseDesignerNeeded,
    OwnDesignerNeeded,
    TakeNotFound,
)
from app.deliveries.models import Archive, Delivery, Take
from app.deliveries.rules import (
    CHECKABLE,
    alternate_of,
    base_name,
    ensure_kept,
    named_for,
    stored_name,
)
from app.deliveries.schemas import CueBrief, TakeAdded, TakeDetail, TakeRead
from app.deliveries.slots import Matching, Slot, guess_slot, matching_for, slot_given, slot_named
from app.deliveries.take_states import note_delivered, place_take
from app.projects.errors import ProjectNotFound
from app.projects.models import Project
from app.projects.service import ProjectAccess, access_from_facts, project_access
from app.sound_lists import rules as list_rules


@dataclass(frozen=True)
class Origin:
    """The origin of a take's bytes: an upload, a place in a ZIP, a fix of another take, or a range of its frames."""

    upload_id: UUID | None = None
    archive_id: UUID | None = None
    archive_entry: int | None = None
    fix_of_id: UUID | None = None
    split_of_id: UUID | None = None
    split_first_frame: int | None = None
    split_end_frame: int | None = None


def delivery_for(session: Session, actor: Actor, delivery_id: UUID) -> tuple[Delivery, ProjectAccess]:
    """Return a delivery within the caller's sight, and what the caller is in its project."""
    try:
        delivery_and_access = _found_by(session, actor, delivery_id)
    except ProjectNotFound:
        delivery_and_access = None
    if delivery_and_access is None:
        raise DeliveryNotFound(f"no delivery {delivery_id}")
    delivery, access = delivery_and_access
    if access.only_designer_id not in (None, delivery.designer_id):
        raise DeliveryNotFound(f"no delivery {delivery_id}")
    return delivery, access


def _found_by(session: Session, actor: Actor, delivery_id: UUID) -> tuple[Delivery, ProjectAccess] | None:
    if actor.is_build:
        delivery = queries.delivery_by_id(session, delivery_id)
        return (delivery, project_access(session, actor, delivery.project_id)) if delivery else None
    row = queries.delivery_with_facts(session, delivery_id, actor.person_id) if actor.person_id else None
    return (row[0], access_from_facts(actor, row[1])) if row else None


def own_delivery(session: Session, actor: Actor, delivery_id: UUID) -> tuple[Delivery, ProjectAccess]:
    """Return a delivery that the caller may add to; raise DesignerNeeded where they only see it."""
    delivery, access = delivery_for(session, actor, delivery_id)
    if _designer_of(session, access) != delivery.designer_id:
        raise DeliveryNotFound(f"no delivery {delivery_id} of yours")
    return delivery, access


def ensure_may_upload(
    session: Session, actor: Actor, delivery_id: UUID, *, beside_take_id: UUID | None = None
) -> Delivery:
    """Return an open delivery that the caller may add to, before a byte is stored.

    A closed delivery still accepts dry stems for its takes.
    """
    delivery, _ = own_delivery(session, actor, delivery_id)
    if beside_take_id is not None and take_for(session, actor, beside_take_id)[0].delivery_id == delivery_id:
        return delivery
    if delivery.closed_at is not None:
        raise DeliveryClosed(f"delivery {delivery.number} is closed; open a new one")
    return delivery


def uploader(actor: Actor) -> UUID:
    """Return the id under which the caller's uploads are kept: the person's, or the token's."""
    return actor.token_id or actor.person


def open_delivery(session: Session, actor: Actor, project_id: UUID, note: str) -> Delivery:
    """Open a delivery of the caller."""
    access = project_access(session, actor, project_id)
    designer_id = _designer_of(session, access)
    delivery = Delivery(
        studio_id=access.project.studio_id,
        project_id=project_id,
        designer_id=designer_id,
        number=queries.next_delivery_number(session, project_id),
        note=note,
    )
    session.add(delivery)
    session.flush()
    session.refresh(delivery, ["designer"])
    return delivery


def close_delivery(session: Session, actor: Actor, delivery_id: UUID) -> Delivery:
    """Close a delivery; uploads in progress are still accepted, marked late."""
    delivery, _ = own_delivery(session, actor, delivery_id)
    delivery.closed_at = delivery.closed_at or clock.now()
    return delivery


def change_note(session: Session, actor: Actor, delivery_id: UUID, note: str) -> Delivery:
    """Change a delivery's note by its designer."""
    delivery, _ = own_delivery(session, actor, delivery_id)
    delivery.note = note
    return delivery


def receive_take(
    session: Session,
    access: ProjectAccess,
    delivery: Delivery,
    *,
    upload: FinishedUpload,
    file_name: str,
    cue_id: UUID | None = None,
    variation: int | None = None,
    note: str = "",
) -> tuple[Take, bool]:
    """Make a finished upload a take, for the cue given, else matched by name or left in the tray; schedule its check.

    The delivery is the caller's own, with what they are in its project, as `own_delivery` gives both. Also return
    whether the same bytes were there before: then it is that take, and nothing was added.
    """
    if (made := queries.take_of_upload(session, upload.id)) is not None:
        return made, False
    slot = slot_given(session, access, cue_id, variation, file_name) if cue_id else None
    origin = Origin(upload_id=upload.id)
    sender_id = uploader(access.actor)
    return add_take(
        session,
        delivery,
        upload.sha256,
        upload.size_bytes,
        file_name,
        origin,
        slot=slot,
        note=note,
        sender_id=sender_id,
    )


def add_take(
    session: Session,
    delivery: Delivery,
    sha256: str,
    size_bytes: int,
    file_name: str,
    origin: Origin,
    *,
    slot: Slot | None = None,
    note: str = "",
    late: bool | None = None,
    sender_id: UUID | None = None,
) -> tuple[Take, bool]:
    """Add stored bytes to a delivery (its designer loaded) and schedule their check; see `receive_take`.

    `sender_id` is the person or the build token that sent them; None: the designer.
    """
    name = stored_name(file_name)
    if slot is None:
        same = queries.same_bytes(session, delivery, sha256, besides=origin.fix_of_id)
        if same is not None:
            return _matched_by(session, same, name, by=sender_id or same.designer_id), True
        slot = slot_named(session, delivery.project_id, name, delivery.designer.name)
    else:
        same = queries.same_take(session, delivery, sha256, slot.cue.id, slot.variation)
        if same is not None and same.id != origin.fix_of_id:  # a fix of the name alone has its master's bytes
            return same, True
    cue_id, variation = (slot.cue.id, slot.variation) if slot else (None, 1)
    number = queries.next_number(session, cue_id, variation) if cue_id else None
    take = Take(
        studio_id=delivery.studio_id,
        project_id=delivery.project_id,
        delivery_id=delivery.id,
        designer_id=delivery.designer_id,
        designer=delivery.designer,
        upload_id=origin.upload_id,
        archive_id=origin.archive_id,
        archive_entry=origin.archive_entry,
        cue_id=cue_id,
        cue=slot.cue if slot else None,
        variation=variation,
        number=number,
        alternate=slot.alternate if slot else alternate_of(name),
        fix_of_id=origin.fix_of_id,
        split_of_id=origin.split_of_id,
        split_first_frame=origin.split_first_frame,
        split_end_frame=origin.split_end_frame,
        late=delivery.closed_at is not None if late is None else late,
        file_name=name,
        note=note,
        master_sha256=sha256,
        master_bytes=size_bytes,
    )
    session.add(take)
    session.flush()
    update_take_counts(session, take.cue_id)
    note_delivered(session, take, by=sender_id or take.designer_id)
    publish(session, "take.received", studio_id=take.studio_id, take_id=take.id)
    return take, False


def _matched_by(session: Session, take: Take, file_name: str, *, by: UUID) -> Take:
    """Match a take that waits in the tray by a further name that its bytes came under, where that is sure."""
    if take.cue_id is None and take.state in CHECKABLE:
        slot = slot_named(session, take.project_id, file_name, take.designer.name)
        if slot is not None:
            place_take(session, take, slot, by=by)
    return take


def add_fixed_take(session: Session, of: Take, sha256: str, size_bytes: int, file_name: str) -> tuple[Take, bool]:
    """Add the fixed copy of a matched take (its cue loaded) as a new take, late if that one is; see `receive_take`."""
    delivery = queries.delivery_by_id(session, of.delivery_id)
    if delivery is None or of.cue is None:
        raise LookupError(f"take {of.id} has no delivery or no cue")
    origin, slot = Origin(fix_of_id=of.id), Slot(of.cue, of.variation, of.alternate)
    return add_take(session, delivery, sha256, size_bytes, file_name, origin, slot=slot, note=of.note, late=of.late)


def receive_archive(
    session: Session, actor: Actor, delivery_id: UUID, *, upload: FinishedUpload, file_name: str
) -> Archive:
    """Store a delivered ZIP and schedule its unpacking; the same upload is one archive."""
    delivery, _ = own_delivery(session, actor, delivery_id)
    if (made := queries.archive_of_upload(session, upload.id)) is not None:
        return made
    archive = Archive(
        studio_id=delivery.studio_id,
        project_id=delivery.project_id,
        delivery_id=delivery.id,
        upload_id=upload.id,
        file_name=stored_name(file_name),
        sha256=upload.sha256,
        archive_bytes=upload.size_bytes,
    )
    session.add(archive)
    session.flush()
    publish(session, "archive.received", studio_id=archive.studio_id, archive_id=archive.id)
    return archive


def take_for(session: Session, actor: Actor, take_id: UUID, *, locked: bool = False) -> tuple[Take, ProjectAccess]:
    """Return a take within the caller's sight, and what the caller is in its project."""
    take = queries.take_by_id(session, take_id, locked=locked)
    if take is None:
        raise TakeNotFound(f"no take {take_id}")
    try:
        access = project_access(session, actor, take.project_id)
    except ProjectNotFound:
        raise TakeNotFound(f"no take {take_id}") from None
    if access.only_designer_id not in (None, take.designer_id):
        raise TakeNotFound(f"no take {take_id}")
    return take, access


def ensure_own_designer(access: ProjectAccess, take: Take) -> None:
    """Raise OwnDesignerNeeded unless the caller is the designer who made the take, still engaged on its project."""
    if access.engagement is None or access.actor.person != take.designer_id:
        raise OwnDesignerNeeded("only the sound's own designer does this")


def match_take(
    session: Session, actor: Actor, take_id: UUID, cue_id: UUID, variation: int | None
) -> tuple[Take, ProjectAccess]:
    """Match a take to a cue; it gets a number there and is checked again as that cue."""
    take, access = take_for(session, actor, take_id, locked=True)
    slot = slot_given(session, access, cue_id, variation, take.file_name)
    if (take.cue_id, take.variation) == (slot.cue.id, slot.variation):
        return take, access
    ensure_kept(take.discarded_at)
    place_take(session, take, slot, by=actor.person)
    return take, access


def check_name(session: Session, take: Take) -> str:
    """Return the name that a take is checked under: its cue's, for a file dropped on a cue is named for it."""
    return name_checked(take, queries.stem_of(session, take))


def name_checked(take: Take, stem: str | None) -> str:
    """Return the name that a take is checked under, where it is known what the list calls it."""
    return take.file_name if stem is None else named_for(take.file_name, stem)


def read_takes(session: Session, project: Project, takes: Sequence[Take]) -> list[TakeRead]:
    """Return takes of one project as they are shown; those of the tray with their matches by name."""
    in_tray = [take for take in takes if take.cue_id is None and take.discarded_at is None]
    one_designer = in_tray[0].designer_id if len({take.designer_id for take in in_tray}) == 1 else None
    matching = matching_for(session, project.id, one_designer) if in_tray else None
    return [_read(project, take, matching) for take in takes]


def _read(project: Project, take: Take, matching: Matching | None) -> TakeRead:
    if matching is None or take.cue_id is not None or take.discarded_at is not None:
        return TakeRead(**_facts_of(project, take), discarded_at=take.discarded_at, sure=None, guesses=[])
    sure = matching.sure(take)
    guesses = [] if sure else matching.guesses(take)
    shown = sure and guess_slot(take, sure)
    return TakeRead(**_facts_of(project, take), discarded_at=None, sure=shown, guesses=guesses)


def read_take(session: Session, project: Project, take: Take) -> TakeRead:
    """Return a take as it is shown; an unmatched one with its guesses."""
    return read_takes(session, project, [take])[0]


def detailed_take(session: Session, project: Project, take: Take) -> TakeDetail:
    """Return a take as it is shown alone, with its name before it was renamed."""
    first = queries.uploaded_name(session, take)
    is_renamed = first is not None and base_name(first) != base_name(take.file_name)
    return TakeDetail(**dict(read_take(session, project, take)), received_name=first if is_renamed else None)


def added_take(project: Project, take: Take, *, already_here: bool) -> TakeAdded:
    """Return a take as its sender receives it."""
    return TakeAdded(**_facts_of(project, take), already_here=already_here)


def _facts_of(project: Project, take: Take) -> dict[str, Any]:
    cue = take.cue
    label = cue and list_rules.label(project.cue_prefix, cue.number)
    own = {name: getattr(take, name) for name in TakeAdded.model_fields.keys() - {"cue", "already_here"}}
    return own | {"cue": cue and CueBrief(id=cue.id, label=str(label), name=cue.name)}


def _designer_of(session: Session, access: ProjectAccess) -> UUID:
    """Return the designer for whom the caller delivers; raise DesignerNeeded or InHouseDesignerNeeded if none."""
    if not access.actor.is_build:
        return access.ensure_designer().designer_id
    designers = queries.in_house_designers(session, access.project.id)
    if len(designers) != 1:
        raise InHouseDesignerNeeded(
            f"a build delivers in the name of the project's in-house designer, and {len(designers)} are engaged",
            fix="engage one designer as in-house, or deliver as a person",
        )
    return designers[0]
