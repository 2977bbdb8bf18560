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
from app.deliveries.models import Handoff, SourceBank, SourceFile, Take
from app.deliveries.rules import ensure_master_kept, shown_name
from app.deliveries.schemas import HandoffAdd, HandoffRead, HandoffTake
from app.deliveries.signals import DownloadsClosed, WorkDone
from app.deliveries.source_banks.queries import source_file_by_id, source_files
from app.deliveries.source_banks.service import handed_over, read_source_files
from app.projects.errors import ProjectNotFound
from app.projects.queries import any_engagement_of
from app.projects.service import ProjectAccess, project_access
from app.sound_lists.service import visible_cue


def hand_off(session: Session, actor: Actor, cue_id: UUID, body: HandoffAdd) -> HandoffRead:
    """Hand off a cue: as its maker, or for one as a producer; raise NothingToHandOff where they delivered nothing."""
    access, cue = visible_cue(session, actor, cue_id)
    maker_id = access.only_designer_id or body.from_id or actor.person
    if maker_id != actor.person:
        access.ensure_producer()
    if not queries.takes_by(session, cue_id, maker_id):
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
    facts = {"done_percent": handoff.done_percent, "missing": handoff.missing}
    send(session, WorkDone(cue_id, maker_id, "handed_off", facts, actor.person))
    return _read(session, access, handoff)


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
    session.refresh(handoff, ["next_maker", "maker"])
    made = [f"{shown_name(take.file_name)}, version {take.number}" for take in _takes(session, handoff)]
    send(
        session,
        WorkDone(handoff.cue_id, handoff.from_id, "continued_by", {"by_maker": engagement.designer.name}, actor.person),
    )
    facts = {"from_maker": handoff.maker.name, "done_percent": handoff.done_percent, "made_before": made}
    send(session, WorkDone(handoff.cue_id, designer_id, "taken_over", facts, actor.person))
    return _read(session, access, handoff)


def list_handoffs(session: Session, actor: Actor, cue_id: UUID) -> list[HandoffRead]:
    """Return the hand-offs of a cue, the newest first; a designer's from or to them."""
    access, _ = visible_cue(session, actor, cue_id)
    return [
        _read(session, access, handoff) for handoff in queries.handoffs_of(session, cue_id, access.only_designer_id)
    ]


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
    if file is None or file.take_id not in {take.id for take in _with_banks(session, access, handoff)}:
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
    return queries.takes_by(session, handoff.cue_id, handoff.from_id)


def _with_banks(session: Session, access: ProjectAccess, handoff: Handoff) -> list[Take]:
    """Return the takes whose source banks the caller sees in a hand-off.

    The maker sees all of them. The next maker sees all where the maker wrote the hand-off, else those that the
    contract hands over, as the team does.
    """
    takes = list(_takes(session, handoff))
    person = access.actor.person_id
    if person == handoff.from_id or (person == handoff.to_id and handoff.written_by == handoff.from_id):
        return takes
    return handed_over(session, takes)


def _ensure_open(session: Session, actor: Actor, handoff: Handoff) -> None:
    if reason := _closed(session, actor, handoff):
        raise DownloadUnpaid(f"this file cannot be downloaded: {reason}", fix="ask the producer of the project")


def _closed(session: Session, actor: Actor, handoff: Handoff) -> str | None:
    if actor.person_id == handoff.from_id:
        return None
    work = (handoff.cue_id, handoff.from_id)
    # No actor: another designer reads no invoice.
    closed = [reasons[work] for reasons in send(session, DownloadsClosed(None, [work])) if work in reasons]
    return closed[0] if closed else None


def _read(session: Session, access: ProjectAccess, handoff: Handoff) -> HandoffRead:
    session.refresh(handoff, ["maker", "next_maker", "author"])
    takes, with_banks = _takes(session, handoff), {take.id for take in _with_banks(session, access, handoff)}
    files = source_files(session, with_banks)
    banks = {take_id: session.get(SourceBank, take_id) for take_id in with_banks}
    return HandoffRead(
        id=handoff.id,
        cue_id=handoff.cue_id,
        done_percent=handoff.done_percent,
        missing=handoff.missing,
        created_at=handoff.created_at,
        written_by=PersonBrief.model_validate(handoff.author),
        maker=PersonBrief.model_validate(handoff.maker),
        next_maker=PersonBrief.model_validate(handoff.next_maker) if handoff.next_maker else None,
        closed=_closed(session, access.actor, handoff),
        takes=[
            HandoffTake(
                id=take.id,
                file_name=take.file_name,
                variation=take.variation,
                number=take.number,
                state=take.state,
                received_at=take.received_at,
                plug_ins=bank.plug_ins if (bank := banks.get(take.id)) else [],
                recipe=bank.recipe if bank else "",
                source_files=read_source_files(files.get(take.id, [])),
            )
            for take in takes
        ],
    )
