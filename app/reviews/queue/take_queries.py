"""Takes with all that the review room shows of them, read in few columns; callers have checked access."""

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from datetime import datetime
from functools import cache
from typing import Any
from uuid import UUID

from sqlalchemy import Row, Select, and_, bindparam, func, select
from sqlalchemy.orm import Session, joinedload, load_only

from app.accounts.models import Person
from app.conformance.models import CheckRun, Waiver
from app.conformance.rules import Report
from app.core.exists import row_exists
from app.core.in_array import in_array
from app.deliveries.models import Delivery, Take
from app.projects.models import Spec
from app.renders.models import Picture
from app.renders.shown_render_queries import PICTURE, ShownPicture, ShownRender, shown_renders
from app.renders.thumb_queries import Thumb, thumbs
from app.reviews.models import ChangeRequest, Comment, HeardTake
from app.reviews.queries import open_drafts

SHOWN_OF_TAKES = (
    *(Take.studio_id, Take.project_id, Take.delivery_id, Take.cue_id, Take.variation, Take.number, Take.alternate),
    *(Take.state, Take.state_since, Take.received_at, Take.late, Take.file_name, Take.note, Take.fix_of_id),
    *(Take.master_sha256, Take.label),
)


@dataclass(frozen=True)
class TakeOnReview:
    """A take with what is shown of it."""

    take: Take
    spec: Spec
    picture: ShownPicture | None
    report: Report | None
    waiver: Waiver | None
    draft: ChangeRequest | None
    renders: dict[str, ShownRender | None]
    thumb: Thumb | None
    open_comments: int
    heard_at: datetime | None  # by the caller


def _takes() -> Select[*tuple[Any, ...]]:
    drafts = select(ChangeRequest.id).where(ChangeRequest.take_id == Take.id, ChangeRequest.feedback_id.is_(None))
    waivers = select(Waiver.id).where(Waiver.take_id == Take.id)
    heard = select(HeardTake.heard_at).where(
        HeardTake.take_id == Take.id, HeardTake.person_id == bindparam("person_id")
    )
    comments = select(func.count()).where(Comment.take_id == Take.id, Comment.resolved_at.is_(None))
    return (
        select(
            *(Take, CheckRun.report, row_exists(drafts, Take), row_exists(waivers, Take)),
            *(comments.correlate(Take).scalar_subquery(), heard.correlate(Take).scalar_subquery(), *PICTURE),
        )
        .outerjoin(Picture, and_(Picture.studio_id == Take.studio_id, Picture.sound_sha256 == Take.master_sha256))
        .outerjoin(CheckRun, and_(CheckRun.take_id == Take.id, CheckRun.is_current))
        .options(
            load_only(*SHOWN_OF_TAKES, raiseload=True),
            joinedload(Take.cue),
            joinedload(Take.delivery)
            .load_only(Delivery.number, Delivery.note, raiseload=True)
            .joinedload(Delivery.designer)
            .load_only(Person.name, Person.picture_sha256, raiseload=True),
        )
        .order_by(Take.variation, Take.number.desc())
    )


@cache
def _takes_by_id() -> Select[*tuple[Any, ...]]:
    return _takes().where(in_array(Take.id, "ids"))


@cache
def _takes_of_cue() -> Select[*tuple[Any, ...]]:
    return _takes().where(Take.cue_id == bindparam("cue_id"))


def takes_on_review(session: Session, person_id: UUID, take_ids: Collection[UUID]) -> list[TakeOnReview]:
    """Return some takes as a person sees them, newest first of each variation."""
    rows = session.execute(_takes_by_id(), {"ids": take_ids, "person_id": person_id})
    return _with_what_is_shown(session, rows.all())


def takes_of_cue(session: Session, person_id: UUID, cue_id: UUID) -> list[TakeOnReview]:
    """Return a cue's takes in every state as a person sees them, newest first."""
    rows = session.execute(_takes_of_cue(), {"cue_id": cue_id, "person_id": person_id})
    return _with_what_is_shown(session, rows.all())


def _with_what_is_shown(session: Session, rows: Sequence[Row[*tuple[Any, ...]]]) -> list[TakeOnReview]:
    takes: list[Take] = [row[0] for row in rows]
    masters = {row[0].id: ShownPicture.read(*row[6:]) for row in rows}
    specs = newest_specs(session, {take.project_id for take in takes})
    renders = shown_renders(session, specs, takes)
    # A game file's is in no list, and was a third of what the queue's answer weighed.
    drawn = thumbs(session, [picture.id for picture in masters.values() if picture])
    shapes = {take_id: drawn.get(picture.id) for take_id, picture in masters.items() if picture}
    drafted = [take.id for take, _, is_drafted, *_ in rows if is_drafted]
    drafts = {draft.take_id: draft for draft in open_drafts(session, drafted)} if drafted else {}
    waived = [take.id for take, _, _, is_waived, *_ in rows if is_waived]
    waivers = {waiver.take_id: waiver for waiver in _waivers_of(session, waived)} if waived else {}
    return [
        TakeOnReview(
            take=take,
            spec=specs[take.project_id],
            picture=masters[take.id],
            report=report,
            waiver=waivers.get(take.id),
            draft=drafts.get(take.id),
            renders=renders[take.id],
            thumb=shapes.get(take.id),
            open_comments=comments,
            heard_at=heard_at,
        )
        for take, report, _, _, comments, heard_at, *_ in rows
    ]


def _waivers_of(session: Session, take_ids: Collection[UUID]) -> Sequence[Waiver]:
    return session.scalars(select(Waiver).where(in_array(Waiver.take_id, take_ids)).order_by(Waiver.id)).all()


def newest_specs(session: Session, project_ids: Collection[UUID]) -> dict[UUID, Spec]:
    """Return the newest spec of each project."""
    return {spec.project_id: spec for spec in session.scalars(_newest_specs(), {"project_ids": project_ids})}


@cache
def _newest_specs() -> Select[Spec]:
    newest = (
        select(Spec.project_id, func.max(Spec.version).label("version"))
        .where(in_array(Spec.project_id, "project_ids"))
        .group_by(Spec.project_id)
        .subquery()
    )
    return select(Spec).join(newest, and_(newest.c.project_id == Spec.project_id, newest.c.version == Spec.version))
