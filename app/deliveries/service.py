"""Deliveries: how finished uploads become takes, and how takes find their cue."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from datetime import datetime
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.contracts.settlement import note_work
from app.deliveries import queries
from app.deliveries.errors import DeliveryClosed, DeliveryNotFound, InHouseDesignerNeeded, MakerNeeded, TakeNotFound
from app.deliveries.models import Archive, Delivery, Take
from app.deliveries.rules import (
    ReviewClock,
    TakeState,
    alternate_of,
    ensure_may_become,
    ensure_variation,
    kept_name,
    stems_to_try,
    variation_meant,
)
from app.deliveries.schemas import CueBrief, CueGuess, TakeAdded, TakeRead
from app.deliveries.sums import keep_sums
from app.kit import clock
from app.kit.events import publish
from app.kit.queue import NORMAL
from app.kit.uploads import FinishedUpload
from app.projects.errors import ProjectNotFound
from app.projects.models import Project
from app.projects.service import Standing, standing_in, standing_of
from app.sound_lists import rules as list_rules
from app.sound_lists import service as sound_lists
from app.sound_lists.models import Cue


@dataclass(frozen=True)
class Slot:
    """The place in the list that a file is for."""

    cue: Cue
    variation: int
    alternate: int | None


@dataclass(frozen=True)
class Origin:
    """Where the bytes of a take came from: an upload of its own, a place in a ZIP, or a mend of another take."""

    upload_id: UUID | None = None
    archive_id: UUID | None = None
    archive_entry: int | None = None
    mend_of_id: UUID | None = None


def delivery_for(session: Session, actor: Actor, delivery_id: UUID) -> tuple[Delivery, Standing]:
    """Return a delivery within the caller's sight, and what the caller is in its project."""
    try:
        found = _found_by(session, actor, delivery_id)
    except ProjectNotFound:
        found = None
    if found is None:
        raise DeliveryNotFound(f"no delivery {delivery_id}")
    delivery, standing = found
    if standing.only_designer_id not in (None, delivery.designer_id):
        raise DeliveryNotFound(f"no delivery {delivery_id}")
    return delivery, standing


def _found_by(session: Session, actor: Actor, delivery_id: UUID) -> tuple[Delivery, Standing] | None:
    if actor.is_build:
        delivery = queries.delivery_by_id(session, delivery_id)
        return (delivery, standing_in(session, actor, delivery.project_id)) if delivery else None
    found = queries.delivery_with_facts(session, delivery_id, actor.person_id) if actor.person_id else None
    return (found[0], standing_of(actor, found[1])) if found else None


def own_delivery(session: Session, actor: Actor, delivery_id: UUID) -> tuple[Delivery, Standing]:
    """Return a delivery that the caller may add to; raise DesignerNeeded where they only see it."""
    delivery, standing = delivery_for(session, actor, delivery_id)
    if _designer_of(session, standing) != delivery.designer_id:
        raise DeliveryNotFound(f"no delivery {delivery_id} of yours")
    return delivery, standing


def ensure_may_upload(
    session: Session, actor: Actor, delivery_id: UUID, *, beside_take_id: UUID | None = None
) -> Delivery:
    """Return an open delivery that the caller may add to, before a byte is stored.

    A closed one takes what is to stand beside a take of it: a dry stem.
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
    standing = standing_in(session, actor, project_id)
    designer_id = _designer_of(session, standing)
    delivery = Delivery(
        studio_id=standing.project.studio_id,
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
    """Say that nothing more is to come; what is on its way still comes in, marked late."""
    delivery, _ = own_delivery(session, actor, delivery_id)
    delivery.closed_at = delivery.closed_at or clock.now()
    return delivery


def change_note(session: Session, actor: Actor, delivery_id: UUID, note: str) -> Delivery:
    """Change what a delivery's designer says of it."""
    delivery, _ = own_delivery(session, actor, delivery_id)
    delivery.note = note
    return delivery


def receive_take(
    session: Session,
    standing: Standing,
    delivery: Delivery,
    *,
    upload: FinishedUpload,
    file_name: str,
    cue_id: UUID | None = None,
    variation: int | None = None,
    note: str = "",
) -> tuple[Take, bool]:
    """Make a finished upload a take, for the cue given, else matched by name or left in the tray; ask for its check.

    The delivery is the caller's own, with what they are in its project, as `own_delivery` gives both. Also return
    whether the same bytes were there before: then it is that take, and nothing was added.
    """
    if (made := queries.take_of_upload(session, upload.id)) is not None:
        return made, False
    slot = _slot_given(session, standing, cue_id, variation, file_name) if cue_id else None
    origin = Origin(upload_id=upload.id)
    sender_id = uploader(standing.actor)
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
    """Add stored bytes to a delivery (its designer loaded) and ask for their check; see `receive_take`.

    `sender_id` is the person or the build token that sent them; None: the designer.
    """
    name = kept_name(file_name)
    slot = slot or slot_named(session, delivery.project_id, name)
    cue_id, variation = (slot.cue.id, slot.variation) if slot else (None, 1)
    number = queries.next_number(session, cue_id, variation) if cue_id else None
    same = queries.same_take(session, delivery, sha256, cue_id, variation)
    if same is not None and same.id != origin.mend_of_id:  # a mend of the name alone has its master's bytes
        return same, True
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
        mend_of_id=origin.mend_of_id,
        late=delivery.closed_at is not None if late is None else late,
        file_name=name,
        note=note,
        master_sha256=sha256,
        master_bytes=size_bytes,
    )
    session.add(take)
    session.flush()
    keep_sums(session, take.cue_id)
    _note_delivered(session, take, by=sender_id or take.designer_id)
    publish(session, "take.received", studio_id=take.studio_id, take_id=take.id)
    return take, False


def add_mended_take(session: Session, of: Take, sha256: str, size_bytes: int, file_name: str) -> tuple[Take, bool]:
    """Add the mended copy of a matched take (its cue loaded) beside it, as late as that is; see `receive_take`."""
    delivery = queries.delivery_by_id(session, of.delivery_id)
    if delivery is None or of.cue is None:
        raise LookupError(f"take {of.id} has no delivery or no cue")
    origin, slot = Origin(mend_of_id=of.id), Slot(of.cue, of.variation, of.alternate)
    return add_take(session, delivery, sha256, size_bytes, file_name, origin, slot=slot, note=of.note, late=of.late)


def receive_archive(
    session: Session, actor: Actor, delivery_id: UUID, *, upload: FinishedUpload, file_name: str
) -> Archive:
    """Keep a delivered ZIP and ask for its unpacking; the same upload is one archive."""
    delivery, _ = own_delivery(session, actor, delivery_id)
    if (made := queries.archive_of_upload(session, upload.id)) is not None:
        return made
    archive = Archive(
        studio_id=delivery.studio_id,
        project_id=delivery.project_id,
        delivery_id=delivery.id,
        upload_id=upload.id,
        file_name=kept_name(file_name),
        sha256=upload.sha256,
        archive_bytes=upload.size_bytes,
    )
    session.add(archive)
    session.flush()
    publish(session, "archive.received", studio_id=archive.studio_id, archive_id=archive.id)
    return archive


def take_for(session: Session, actor: Actor, take_id: UUID, *, locked: bool = False) -> tuple[Take, Standing]:
    """Return a take within the caller's sight, and what the caller is in its project."""
    take = queries.take_by_id(session, take_id, locked=locked)
    if take is None:
        raise TakeNotFound(f"no take {take_id}")
    try:
        standing = standing_in(session, actor, take.project_id)
    except ProjectNotFound:
        raise TakeNotFound(f"no take {take_id}") from None
    if standing.only_designer_id not in (None, take.designer_id):
        raise TakeNotFound(f"no take {take_id}")
    return take, standing


def ensure_maker(standing: Standing, take: Take) -> None:
    """Raise MakerNeeded unless the caller is the designer who made the take, still engaged on its project."""
    if standing.engagement is None or standing.actor.person != take.designer_id:
        raise MakerNeeded("only the sound's own designer does this")


def match_take(
    session: Session, actor: Actor, take_id: UUID, cue_id: UUID, variation: int | None
) -> tuple[Take, Standing]:
    """Say which cue a take is for; it gets a number there and is checked again as that cue."""
    take, standing = take_for(session, actor, take_id, locked=True)
    slot = _slot_given(session, standing, cue_id, variation, take.file_name)
    if (take.cue_id, take.variation) == (slot.cue.id, slot.variation):
        return take, standing
    ensure_may_become(take.state, TakeState.RECEIVED)
    number = queries.next_number(session, slot.cue.id, slot.variation)
    note_take(session, take, "moved_away", {"file": take.file_name}, by=actor.person, on_behalf_of=take.designer_id)
    take.conforming_since = take.returned_since = None
    keep_sums(session, take.cue_id, slot.cue.id)
    take.cue_id, take.variation, take.number = slot.cue.id, slot.variation, number
    take.alternate = slot.alternate
    session.flush()
    session.refresh(take, ["cue"])
    _note_delivered(session, take, by=actor.person)
    check_again(session, take, by=actor.person)
    return take, standing


def _note_delivered(session: Session, take: Take, *, by: UUID) -> None:
    facts = {"file": take.file_name, "sha256": take.master_sha256}
    note_take(session, take, "delivered", facts, by=by, on_behalf_of=take.designer_id)


def note_take(
    session: Session,
    take: Take,
    kind: str,
    facts: Mapping[str, object],
    *,
    by: UUID | None,
    on_behalf_of: UUID | None = None,
) -> None:
    """Write what became of a take into the record of the contract that covers its cue, if one does."""
    if take.cue_id is not None and take.number is not None:
        told = {"variation": take.variation, "version": take.number, **facts}
        note_work(session, take.cue_id, take.designer_id, kind, told, by=by, on_behalf_of=on_behalf_of)


def check_again(session: Session, take: Take, *, by: UUID | None, priority: int = NORMAL) -> None:
    """Put a take back to received, and ask for its check; whatever a running check says no longer counts.

    `by` is the person whose act asks for it; None: the server.
    """
    change_state(session, take, TakeState.RECEIVED)
    take.edition += 1
    take.rechecked_by = by
    session.flush()
    publish(session, "take.received", studio_id=take.studio_id, priority=priority, take_id=take.id)


def change_state(session: Session, take: Take, wanted: TakeState) -> None:
    """Take a take from state to state; raise WrongState where that cannot be."""
    ensure_may_become(take.state, wanted)
    now = clock.now()
    _run_review_clock(session, take, wanted, now)
    put_back(session, take, wanted, now)


def _run_review_clock(session: Session, take: Take, wanted: TakeState, now: datetime) -> None:
    of = take
    if wanted is TakeState.CONFORMING and take.conforming_since is None and take.cue_id is not None:
        of = queries.same_bytes_beside(session, take) or take
    review_clock = ReviewClock(of.conforming_since, of.returned_since).at(wanted, now)
    take.conforming_since, take.returned_since = review_clock.conforming_since, review_clock.returned_since


def put_back(session: Session, take: Take, state: TakeState, since: datetime) -> None:
    """Have a take stand as it did at some time, whatever it is now."""
    take.state, take.state_since = state, since
    session.flush()
    keep_sums(session, take.cue_id)


def check_name(session: Session, take: Take) -> str:
    """Return the name that a take is checked under: its cue's, for a file dropped on a cue is named for it."""
    return name_checked(take, queries.stem_of(session, take))


def name_checked(take: Take, stem: str | None) -> str:
    """Return the name that a take is checked under, where it is known what the list calls it."""
    if stem is None:
        return take.file_name
    _, dot, ending = take.file_name.rpartition(".")
    return f"{stem}{dot}{ending}" if dot else stem


def read_takes(session: Session, project: Project, takes: Sequence[Take]) -> list[TakeRead]:
    """Return takes of one project as they are shown; unmatched ones with their guesses."""
    unmatched = [take for take in takes if take.cue_id is None]
    guesses = dict(zip([take.id for take in unmatched], _guesses(session, project, unmatched), strict=True))
    return [TakeRead(**_facts_of(project, take), guesses=guesses.get(take.id, [])) for take in takes]


def read_take(session: Session, project: Project, take: Take) -> TakeRead:
    """Return a take as it is shown; an unmatched one with its guesses."""
    return read_takes(session, project, [take])[0]


def _guesses(session: Session, project: Project, unmatched: Sequence[Take]) -> list[list[CueGuess]]:
    if not unmatched:
        return []
    waiting = queries.cues_without_takes(session, project.id)
    found = sound_lists.guesses_for(session, project.id, [(take.file_name, None) for take in unmatched], favour=waiting)
    return [[CueGuess.model_validate(guess) for guess in guesses] for guesses in found]


def added_take(project: Project, take: Take, *, already_here: bool) -> TakeAdded:
    """Return a take as whoever sent it is answered."""
    return TakeAdded(**_facts_of(project, take), already_here=already_here)


def _facts_of(project: Project, take: Take) -> dict[str, Any]:
    cue = take.cue
    label = cue and list_rules.label(project.cue_prefix, cue.number)
    own = {name: getattr(take, name) for name in TakeAdded.model_fields.keys() - {"cue", "already_here"}}
    return own | {"cue": cue and CueBrief(id=cue.id, label=str(label), name=cue.name)}


def _designer_of(session: Session, standing: Standing) -> UUID:
    """Return in whose name the caller delivers; raise DesignerNeeded or InHouseDesignerNeeded where in nobody's."""
    if not standing.actor.is_build:
        return standing.ensure_designer().designer_id
    designers = queries.in_house_designers(session, standing.project.id)
    if len(designers) != 1:
        raise InHouseDesignerNeeded(
            f"a build delivers in the name of the project's in-house designer, and {len(designers)} are engaged",
            fix="engage one designer as in-house, or deliver as a person",
        )
    return designers[0]


def _slot_given(session: Session, standing: Standing, cue_id: UUID, variation: int | None, file_name: str) -> Slot:
    cue = sound_lists.cue_for(session, standing, cue_id)
    if variation is None:
        variation = variation_meant(file_name, cue.variations, queries.filled_variations(session, cue.id))
    ensure_variation(variation, cue.variations)
    return Slot(cue, variation, alternate_of(file_name))


def slot_named(session: Session, project_id: UUID, file_name: str) -> Slot | None:
    """Return the place in the list that a file is for by its name; None where no cue owns that."""
    for stem, alternate in stems_to_try(file_name):
        if (found := sound_lists.slot_by_stem(session, project_id, stem)) is not None:
            return Slot(*found, alternate)
    return None
