"""Deliveries and takes, read from the database; a designer's own only."""

from collections.abc import Collection, Sequence
from functools import cache
from typing import Any
from uuid import UUID

from sqlalchemy import ColumnElement, Select, and_, bindparam, func, select
from sqlalchemy.orm import Session, joinedload

from app.accounts.models import Person
from app.accounts.quotas.queries import Usage
from app.core.in_array import in_array
from app.core.uploads import Upload
from app.deliveries.models import Archive, Delivery, DryStem, SourceFile, Take, TrayAction
from app.deliveries.rules import OPEN_STATES, TakeState
from app.deliveries.rules import stem_of as stem_of_name
from app.projects.models import Engagement, Project
from app.projects.queries import AccessFacts, access_facts_query
from app.projects.rules import EngagementKind
from app.sound_lists.models import Cue, Stem

NAMES_COMPARED = 2_000  # of a tray, for the prefixes that they share
PLACES_ASKED = 200  # for which several files came, in one answer

# Asked for by each step of an upload: to build the statement takes as long as to run it.
_DELIVERY = select(Delivery).where(Delivery.id == bindparam("delivery_id")).options(joinedload(Delivery.designer))
_WITH_CUE_AND_DESIGNER = (joinedload(Take.cue), joinedload(Take.designer))
_OF_UPLOAD = select(Take).where(Take.upload_id == bindparam("upload_id")).options(*_WITH_CUE_AND_DESIGNER)


kept_master_bytes = Usage(
    Take.studio_id,
    Take.master_deleted_at.is_(None),
    sha256=Take.master_sha256,
    size_bytes=Take.master_bytes,
    also=Usage(SourceFile.studio_id, sha256=SourceFile.sha256, size_bytes=SourceFile.file_bytes),
)
open_uploads = Usage(Upload.studio_id, Upload.sha256.is_(None))


def delivery_by_id(session: Session, delivery_id: UUID) -> Delivery | None:
    """Return a delivery with its designer, without a check of the caller."""
    return session.scalar(_DELIVERY, {"delivery_id": delivery_id})


def delivery_with_facts(session: Session, delivery_id: UUID, person_id: UUID) -> tuple[Delivery, AccessFacts] | None:
    """Return a delivery with its designer and what a person's standing in its project depends on, all at once."""
    row = session.execute(_with_facts(), {"delivery_id": delivery_id, "person_id": person_id}).one_or_none()
    return (row[-1], AccessFacts._make(row[:-1])) if row else None


@cache
def _with_facts() -> Select[*tuple[Any, ...]]:
    query = access_facts_query().join(Delivery, Delivery.project_id == Project.id).add_columns(Delivery)
    return query.where(Delivery.id == bindparam("delivery_id")).options(joinedload(Delivery.designer))


def deliveries_of(
    session: Session, project_id: UUID, *, designer_id: UUID | None, before: UUID | None, limit: int
) -> Sequence[Delivery]:
    """Return deliveries with their designers, the newest first; of one designer where one is given."""
    query = select(Delivery).where(Delivery.project_id == project_id)
    if designer_id is not None:
        query = query.where(Delivery.designer_id == designer_id)
    if before is not None:
        query = query.where(Delivery.id < before)
    designer = joinedload(Delivery.designer).load_only(Person.name, Person.picture_sha256, raiseload=True)
    return session.scalars(query.options(designer).order_by(Delivery.id.desc()).limit(limit)).all()


def takes_counts(session: Session, delivery_ids: Collection[UUID]) -> dict[UUID, int]:
    """Return the number of takes of each delivery; deliveries without any are left out."""
    rows = session.execute(
        select(Take.delivery_id, func.count())
        .where(in_array(Take.delivery_id, delivery_ids), Take.discarded_at.is_(None))
        .group_by(Take.delivery_id)
    )
    return {row[0]: row[1] for row in rows}


def next_delivery_number(session: Session, project_id: UUID) -> int:
    """Return the number of the next delivery; locked until the transaction ends."""
    session.execute(select(Project.id).where(Project.id == project_id).with_for_update(key_share=True))
    last = session.scalar(select(func.max(Delivery.number)).where(Delivery.project_id == project_id))
    return (last or 0) + 1


def in_house_designers(session: Session, project_id: UUID) -> Sequence[UUID]:
    """Return the people of the studio who make sounds for this project."""
    return session.scalars(
        select(Engagement.designer_id).where(
            Engagement.project_id == project_id,
            Engagement.kind == EngagementKind.IN_HOUSE,
            Engagement.ended_at.is_(None),
        )
    ).all()


def next_number(session: Session, cue_id: UUID, variation: int) -> int:
    """Return the number of a cue's next take; locked until the transaction ends."""
    session.execute(select(Cue.id).where(Cue.id == cue_id).with_for_update(key_share=True))
    return last_number(session, cue_id, variation) + 1


def last_number(session: Session, cue_id: UUID, variation: int) -> int:
    """Return the number of a cue's newest take; 0 where none has come."""
    last = session.scalar(select(func.max(Take.number)).where(Take.cue_id == cue_id, Take.variation == variation))
    return last or 0


def filled_variations(session: Session, cue_ids: Collection[UUID]) -> dict[UUID, set[int]]:
    """Return the variations of each cue for which a take has come."""
    filled: dict[UUID, set[int]] = {cue_id: set() for cue_id in cue_ids}
    if filled:
        taken = select(Take.cue_id, Take.variation).where(in_array(Take.cue_id, filled)).distinct()
        for cue_id, variation in session.execute(taken):
            if cue_id is not None:
                filled[cue_id].add(variation)
    return filled


def stem_of(session: Session, take: Take) -> str | None:
    """Return the stem that the list gives to a take; None while unmatched and for a cut cue."""
    if take.cue_id is None:
        return None
    return session.scalar(_stem(), {"cue_id": take.cue_id, "variation": take.variation})


@cache  # what every job asks for is built once: that takes as long as to run it
def _stem() -> Select[str]:
    return select(Stem.stem).where(Stem.cue_id == bindparam("cue_id"), Stem.variation == bindparam("variation"))


def take_by_id(session: Session, take_id: UUID, *, locked: bool = False) -> Take | None:
    """Return a take with its cue and designer, without a check of the caller; locked where it is going to change."""
    return session.scalar(_by_id(locked=locked), {"take_id": take_id})


def uploaded_name(session: Session, take: Take) -> str | None:
    """Return the name that a take's file was uploaded by; None for one from a ZIP or made here."""
    return session.scalar(select(Upload.file_name).where(Upload.id == take.upload_id)) if take.upload_id else None


def take_with_cue(session: Session, take_id: UUID) -> Take | None:
    """Return a take with its cue, for a job."""
    return session.scalar(_with_cue(), {"take_id": take_id})


@cache
def _by_id(*, locked: bool) -> Select[Take]:
    query = _of_id().options(*_WITH_CUE_AND_DESIGNER)
    return _locked(query) if locked else query


@cache
def _with_cue() -> Select[Take]:
    return _of_id().options(joinedload(Take.cue))


def _of_id() -> Select[Take]:
    return select(Take).where(Take.id == bindparam("take_id"))


def _locked(query: Select[Take]) -> Select[Take]:
    return query.with_for_update(of=Take, key_share=True).execution_options(populate_existing=True)


def take_of_upload(session: Session, upload_id: UUID) -> Take | None:
    """Return the take that an upload became, with its cue and designer."""
    return session.scalar(_OF_UPLOAD, {"upload_id": upload_id})


def take_of_entry(session: Session, archive_id: UUID, entry_index: int) -> Take | None:
    """Return the take that a file of a ZIP became."""
    return session.scalar(_newest(Take.archive_id == archive_id, Take.archive_entry == entry_index))


def dry_stem_of(session: Session, take: Take) -> DryStem | None:
    """Return the dry stem that a take is compared with."""
    return session.scalar(_newest_stem(), {"delivery_id": take.delivery_id, "stem": stem_of_name(take.file_name)})


def live_stems(session: Session, delivery_id: UUID, stem: str) -> Sequence[DryStem]:
    """Return the dry stems of one name in a delivery that are not withdrawn, the newest first."""
    return session.scalars(_live_stems(), {"delivery_id": delivery_id, "stem": stem}).all()


@cache
def _newest_stem() -> Select[DryStem]:
    return _live_stems().limit(1)


@cache
def _live_stems() -> Select[DryStem]:
    of_name = (DryStem.delivery_id == bindparam("delivery_id"), DryStem.stem == bindparam("stem"))
    newest_first = (DryStem.received_at.desc(), DryStem.id.desc())
    return select(DryStem).where(*of_name, DryStem.withdrawn_at.is_(None)).order_by(*newest_first)


def dry_stem_of_upload(session: Session, upload_id: UUID, stem: str) -> DryStem | None:
    """Return the dry stem that an upload became for takes of this name."""
    return session.scalar(select(DryStem).where(DryStem.upload_id == upload_id, DryStem.stem == stem))


def dry_stem_of_entry(session: Session, archive_id: UUID, entry_index: int) -> DryStem | None:
    """Return the dry stem that a file of a ZIP became."""
    return session.scalar(select(DryStem).where(DryStem.archive_id == archive_id, DryStem.archive_entry == entry_index))


def dry_stems_in(session: Session, delivery_id: UUID) -> Sequence[DryStem]:
    """Return the dry stems of a delivery that are not withdrawn, in the order they came."""
    return session.scalars(
        select(DryStem).where(DryStem.delivery_id == delivery_id, DryStem.withdrawn_at.is_(None)).order_by(DryStem.id)
    ).all()


def takes_beside(session: Session, delivery_id: UUID, stem: str) -> list[UUID]:
    """Return the takes of a delivery that a dry stem of this name is for."""
    rows = session.execute(select(Take.id, Take.file_name).where(Take.delivery_id == delivery_id).order_by(Take.id))
    return [take_id for take_id, file_name in rows if stem_of_name(file_name) == stem]


def same_bytes(session: Session, delivery: Delivery, sha256: str, *, besides: UUID | None) -> Take | None:
    """Return the designer's newest take of the same bytes in the project, whatever its name; no discarded one."""
    facts = {"project_id": delivery.project_id, "designer_id": delivery.designer_id, "sha256": sha256}
    query = _of_bytes()
    return session.scalar(query if besides is None else query.where(Take.id != besides), facts)


@cache
def _of_bytes() -> Select[Take]:
    return _newest(
        Take.project_id == bindparam("project_id"),
        Take.designer_id == bindparam("designer_id"),
        Take.master_sha256 == bindparam("sha256"),
        Take.master_deleted_at.is_(None),
        Take.discarded_at.is_(None),
    )


def same_take(session: Session, delivery: Delivery, sha256: str, cue_id: UUID | None, variation: int) -> Take | None:
    """Return the designer's take of the same bytes for the same cue and variation, or in the tray."""
    facts = {
        "project_id": delivery.project_id,
        "designer_id": delivery.designer_id,
        "sha256": sha256,
        "variation": variation,
        **({"cue_id": cue_id} if cue_id else {}),
    }
    return session.scalar(_same(is_matched=cue_id is not None), facts)


@cache
def _same(*, is_matched: bool) -> Select[Take]:
    return _newest(
        Take.project_id == bindparam("project_id"),
        Take.designer_id == bindparam("designer_id"),
        Take.master_sha256 == bindparam("sha256"),
        Take.cue_id == bindparam("cue_id") if is_matched else Take.cue_id.is_(None),
        Take.variation == bindparam("variation"),
        Take.master_deleted_at.is_(None),
        Take.discarded_at.is_(None),
    )


def same_bytes_beside(session: Session, take: Take) -> Take | None:
    """Return the designer's other take of the same bytes for the same cue and variation that conformed first."""
    return session.scalar(
        select(Take)
        .where(
            Take.cue_id == take.cue_id,
            Take.variation == take.variation,
            Take.master_sha256 == take.master_sha256,
            Take.designer_id == take.designer_id,
            Take.id != take.id,
            Take.conforming_since.is_not(None),
        )
        .order_by(Take.conforming_since)
        .limit(1)
    )


def _newest(*conditions: ColumnElement[bool]) -> Select[Take]:
    return select(Take).where(*conditions).options(*_WITH_CUE_AND_DESIGNER).order_by(Take.id.desc()).limit(1)


def takes_of(
    session: Session,
    project_id: UUID,
    *,
    designer_id: UUID | None,
    states: Collection[TakeState] = (),
    unmatched: bool | None = None,
    discarded: bool = False,
    cue_id: UUID | None = None,
    before: UUID | None = None,
    limit: int,
) -> Sequence[Take]:
    """Return takes with their cues and designers, the newest first; of one designer where one is given."""
    query = select(Take).where(Take.project_id == project_id)
    query = query.where(Take.discarded_at.is_not(None) if discarded else Take.discarded_at.is_(None))
    if designer_id is not None:
        query = query.where(Take.designer_id == designer_id)
    if states:
        query = query.where(Take.state.in_(states))
    if unmatched is not None:
        query = query.where(Take.cue_id.is_(None) if unmatched else Take.cue_id.is_not(None))
    if cue_id is not None:
        query = query.where(Take.cue_id == cue_id)
    if before is not None:
        query = query.where(Take.id < before)
    query = query.options(*_WITH_CUE_AND_DESIGNER)
    return session.scalars(query.order_by(Take.id.desc()).limit(limit)).all()


def in_tray(project_id: UUID, designer_id: UUID | None) -> tuple[ColumnElement[bool], ...]:
    """Return the condition that a take waits in the tray: without a cue, and not discarded."""
    waiting = (Take.project_id == project_id, Take.cue_id.is_(None), Take.discarded_at.is_(None))
    return waiting if designer_id is None else (*waiting, Take.designer_id == designer_id)


def unmatched_count(session: Session, project_id: UUID, designer_id: UUID | None) -> int:
    """Return the number of takes that wait in the tray; of one designer where one is given."""
    return session.scalar(select(func.count()).where(*in_tray(project_id, designer_id))) or 0


def tray(session: Session, project_id: UUID, designer_id: UUID | None, *, limit: int) -> list[Take]:
    """Return the takes of the tray, locked, in the order they came; of one designer where one is given."""
    query = select(Take).where(*in_tray(project_id, designer_id)).options(*_WITH_CUE_AND_DESIGNER)
    return list(session.scalars(_locked(query.order_by(Take.id).limit(limit))))


def tray_names(session: Session, project_id: UUID, designer_id: UUID | None) -> Sequence[str]:
    """Return the newest names of files that wait in the tray; see `tray`."""
    query = select(Take.file_name).where(*in_tray(project_id, designer_id))
    return session.scalars(query.order_by(Take.id.desc()).limit(NAMES_COMPARED)).all()


def takes_by_id(session: Session, project_id: UUID, take_ids: Collection[UUID], designer_id: UUID | None) -> list[Take]:
    """Return takes of a project with cues and designers, locked, in the order of their ids; see `tray`."""
    query = select(Take).where(Take.project_id == project_id, in_array(Take.id, take_ids))
    if designer_id is not None:
        query = query.where(Take.designer_id == designer_id)
    return list(session.scalars(_locked(query.options(*_WITH_CUE_AND_DESIGNER).order_by(Take.id))))


def master_of(session: Session, take_id: UUID) -> str | None:
    """Return the hash of a take's master."""
    return session.scalar(select(Take.master_sha256).where(Take.id == take_id))


def tray_action_by_id(session: Session, action_id: UUID) -> TrayAction | None:
    """Return an action on many takes, locked."""
    return session.scalar(select(TrayAction).where(TrayAction.id == action_id).with_for_update())


def takes_in(session: Session, delivery_id: UUID) -> Sequence[Take]:
    """Return the takes of a delivery with their cues and designers, in the order they came."""
    return session.scalars(
        select(Take)
        .where(Take.delivery_id == delivery_id, Take.discarded_at.is_(None))
        .options(*_WITH_CUE_AND_DESIGNER)
        .order_by(Take.id)
    ).all()


def archives_in(session: Session, delivery_id: UUID) -> Sequence[Archive]:
    """Return the ZIPs of a delivery in the order they came."""
    return session.scalars(select(Archive).where(Archive.delivery_id == delivery_id).order_by(Archive.id)).all()


def archive_of_upload(session: Session, upload_id: UUID) -> Archive | None:
    """Return the ZIP that an upload became."""
    return session.scalar(select(Archive).where(Archive.upload_id == upload_id))


def competing_takes(session: Session, project_id: UUID, designer_id: UUID | None) -> Sequence[Take]:
    """Return open takes that share delivery, cue, variation and alternate with another one; see `tray`."""
    slot = (Take.delivery_id, Take.cue_id, Take.variation, func.coalesce(Take.alternate, 0))
    is_open = [Take.project_id == project_id, Take.cue_id.is_not(None), Take.state.in_(OPEN_STATES)]
    if designer_id is not None:
        is_open.append(Take.designer_id == designer_id)
    shared = select(*slot).where(*is_open).group_by(*slot).having(func.count() > 1).limit(PLACES_ASKED).subquery()
    in_slot = [column == other for column, other in zip(slot, shared.c, strict=True)]
    query = select(Take).join(shared, and_(*in_slot)).where(*is_open).options(*_WITH_CUE_AND_DESIGNER)
    return session.scalars(query.order_by(Take.id)).all()


def next_alternate(session: Session, cue_id: UUID, variation: int) -> int:
    """Return the number of the next alternate of a place in the list; the file without a letter is the first."""
    query = select(func.max(Take.alternate)).where(Take.cue_id == cue_id, Take.variation == variation)
    return max(session.scalar(query) or 1, 1) + 1
