"""Hand-offs: what a maker did of a cue and what is missing, for the next maker, with takes and source banks."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.accounts.schemas import PersonBrief
from app.core.events import send
from app.deliveries.errors import (
    DownloadUnpaid,
    HandoffNotFound,
    NextMakerUnknown,
    NothingToHandOff,
    SourceFileNotFound,
    TakeNotFound,
)
from app.deliveries.handoffs import queries
from app.deliveries.models import Handoff, SourceFile, Take
from app.deliveries.rules import ensure_master_kept, shown_name
from app.deliveries.schemas import HandoffAdd, HandoffRead, HandoffTake
from app.deliveries.signals import DownloadsClosed, WorkDone
from app.deliveries.source_banks.queries import source_banks, source_file_by_id, source_files
from app.deliveries.source_banks.service import handed_over, read_source_files
from app.projects.errors import ProjectNotFound
from app.projects.queries import any_engagement_of
from app.projects.service import ProjectAccess, project_access
from app.sound_lists.service import visible_cue

PEOPLE = ("maker", "next_maker", "author")  # relations that are shown


def hand_off(session: Session, actor: Actor, cue_id: UUID, body: HandoffAdd) -> HandoffRead:
    """Hand off a cue: as its maker, or for one as a producer; raise NothingToHandOff where they delivered nothing."""
    access, cue = visible_cue(session, actor, cue_id)
    maker_id = access.only_designer_id or body.from_id or actor.person
    if maker_id != actor.person:
        access.ensure_producer()
    if not queries.takes_by(session, cue_id, [maker_id]):
        raise NothingToHandOff(
            "this maker has delivered no file for this cue",
            fix="deliver what there is first; an unfinished file is enough",
        )
    handoff = Handoff(
        studio_id=cue.studio_id,
        project_id=cue.project_id,
        cue_id=cue.id,
        from_id=maker_id,
        done_percent=body.done_percent,
        missing=body.missing,
        written_by=actor.person,
    )
    session.add(handoff)
    session.flush()
    session.refresh(handoff, PEOPLE)
    facts = {"done_percent": handoff.done_percent, "missing": handoff.missing}
    send(session, WorkDone(cue_id, maker_id, "handed_off", facts, actor.person))
    return _read(session, access, [handoff])[0]


def name_next_maker(session: Session, actor: Actor, handoff_id: UUID, designer_id: UUID) -> HandoffRead:
    """Name the designer who continues a cue; from then on they see its hand-off, and no longer one named before."""
    handoff, access = _visible(session, actor, handoff_id)
    access.ensure_producer()
    engagement = any_engagement_of(session, handoff.project_id, designer_id)
    if engagement is None or engagement.ended_at is not None or designer_id == handoff.from_id:
        raise NextMakerUnknown(
            "that is no other designer of this project",
            fix="name a designer who is engaged here and did not make what is handed off",
        )
    handoff.to_id = designer_id
    session.flush()
    session.refresh(handoff, PEOPLE)
    made = [f"{shown_name(take.file_name)}, version {take.number}" for take in _takes(session, handoff)]
    send(
        session,
        WorkDone(handoff.cue_id, handoff.from_id, "continued_by", {"by_maker": engagement.designer.name}, actor.person),
    )
    facts = {"from_maker": handoff.maker.name, "done_percent": handoff.done_percent, "made_before": made}
    send(session, WorkDone(handoff.cue_id, designer_id, "taken_over", facts, actor.person))
    return _read(session, access, [handoff])[0]


def list_handoffs(session: Session, actor: Actor, cue_id: UUID) -> list[HandoffRead]:
    """Return the hand-offs of a cue, the newest first; a designer's from or to them."""
    access, _ = visible_cue(session, actor, cue_id)
    return _read(session, access, queries.handoffs_of(session, cue_id, access.only_designer_id))


def handed_take(session: Session, actor: Actor, handoff_id: UUID, take_id: UUID) -> Take:
    """Return a take of a hand-off whose master the caller may download.

    Raises DownloadUnpaid while the contract of its maker keeps it closed, MasterDeleted where it is gone.
    """
    handoff, _ = _visible(session, actor, handoff_id)
    take = next((take for take in _takes(session, handoff) if take.id == take_id), None)
    if take is None:
        raise TakeNotFound(f"no take {take_id}")
    _ensure_open(session, actor, handoff)
    ensure_master_kept(take.master_deleted_at)
    return take


def handed_source_file(session: Session, actor: Actor, handoff_id: UUID, source_file_id: UUID) -> SourceFile:
    """Return a source file of a hand-off that the caller may download; raise DownloadUnpaid while it is closed."""
    not_found = SourceFileNotFound(f"no source file {source_file_id}")
    try:
        handoff, access = _visible(session, actor, handoff_id)
    except HandoffNotFound:
        raise not_found from None
    file = source_file_by_id(session, source_file_id)
    takes = [take for take in _takes(session, handoff) if file is not None and take.id == file.take_id]
    if file is None or not takes or not (_sees_all_banks(access, handoff) or handed_over(session, takes)):
        raise not_found
    _ensure_open(session, actor, handoff)
    return file


def _visible(session: Session, actor: Actor, handoff_id: UUID) -> tuple[Handoff, ProjectAccess]:
    not_found = HandoffNotFound(f"no hand-off {handoff_id}")
    handoff = queries.handoff_by_id(session, handoff_id)
    if handoff is None:
        raise not_found
    try:
        access = project_access(session, actor, handoff.project_id)
    except ProjectNotFound:
        raise not_found from None
    if access.only_designer_id not in (None, handoff.from_id, handoff.to_id):
        raise not_found
    return handoff, access


def _takes(session: Session, handoff: Handoff) -> Sequence[Take]:
    """Return the takes that the maker delivered for the cue until it was handed off, and since."""
    return queries.takes_by(session, handoff.cue_id, [handoff.from_id])


def _sees_all_banks(access: ProjectAccess, handoff: Handoff) -> bool:
    """Return whether the caller sees every source bank of a hand-off, also those that stay its maker's.

    The maker does, and the next maker where the maker wrote the hand-off.
    """
    person = access.actor.person_id
    return person == handoff.from_id or (person == handoff.to_id and handoff.written_by == handoff.from_id)


def _ensure_open(session: Session, actor: Actor, handoff: Handoff) -> None:
    if reason := _closed(session, actor, [handoff]).get(handoff.from_id):
        raise DownloadUnpaid(f"this file cannot be downloaded: {reason}", fix="ask the producer of the project")


def _closed(session: Session, actor: Actor, handoffs: Sequence[Handoff]) -> dict[UUID, str]:
    """Return the reasons that files of one cue are closed to the caller, by maker."""
    work = {(handoff.cue_id, handoff.from_id) for handoff in handoffs if handoff.from_id != actor.person_id}
    answers = send(session, DownloadsClosed(None, work))  # no actor: another designer reads no invoice
    return {maker_id: reason for answer in answers for (_, maker_id), reason in answer.items()}


def _read(session: Session, access: ProjectAccess, handoffs: Sequence[Handoff]) -> list[HandoffRead]:
    """Return hand-offs of one cue as the caller sees them."""
    if not handoffs:
        return []
    takes = queries.takes_by(session, handoffs[0].cue_id, {handoff.from_id for handoff in handoffs})
    take_ids = [take.id for take in takes]
    files, banks = source_files(session, take_ids), source_banks(session, take_ids)
    of_studio = {take.id for take in handed_over(session, takes)}
    closed = _closed(session, access.actor, handoffs)

    def read_take(take: Take, handoff: Handoff) -> HandoffTake:
        is_shown = take.id in of_studio or _sees_all_banks(access, handoff)
        bank = banks.get(take.id) if is_shown else None
        return HandoffTake(
            id=take.id,
            file_name=take.file_name,
            variation=take.variation,
            number=take.number,
            state=take.state,
            received_at=take.received_at,
            plug_ins=bank.plug_ins if bank else [],
            recipe=bank.recipe if bank else "",
            source_files=read_source_files(files[take.id]) if is_shown else [],
        )

    return [
        HandoffRead(
            id=handoff.id,
            cue_id=handoff.cue_id,
            done_percent=handoff.done_percent,
            missing=handoff.missing,
            created_at=handoff.created_at,
            written_by=PersonBrief.model_validate(handoff.author),
            maker=PersonBrief.model_validate(handoff.maker),
            next_maker=PersonBrief.model_validate(handoff.next_maker) if handoff.next_maker else None,
            closed=closed.get(handoff.from_id),
            takes=[read_take(take, handoff) for take in takes if take.designer_id == handoff.from_id],
        )
        for handoff in handoffs
    ]
