"""The studio's lists of reasons and labels, and the reasons that verdicts give."""

from collections.abc import Mapping, Sequence
from uuid import UUID

from sqlalchemy import delete
from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.accounts.service import ensure_member_of, ensure_producer_of
from app.core import clock
from app.core.db import insert_if_absent
from app.core.in_array import in_array
from app.projects.service import project_access
from app.reviews.models import GivenReason, ReasonList, Verdict
from app.reviews.reasons import queries
from app.reviews.reasons.rules import OURS, ReasonKind, ensure_distinct
from app.reviews.reasons.schemas import ReasonListRead, ReviewReasonsRead
from app.reviews.rules import VerdictKind
from app.reviews.signals import VerdictsOnFile


def reasons_of_studio(session: Session, actor: Actor, studio_id: UUID) -> ReviewReasonsRead:
    """Return the lists of the caller's studio."""
    ensure_member_of(actor, studio_id)
    return _lists(session, studio_id)


def reasons_of_project(session: Session, actor: Actor, project_id: UUID) -> ReviewReasonsRead:
    """Return the lists of a project's studio, for its team and designers."""
    return _lists(session, project_access(session, actor, project_id).project.studio_id)


def set_reasons(
    session: Session, actor: Actor, studio_id: UUID, reasons_by_kind: Mapping[ReasonKind, Sequence[str]]
) -> ReviewReasonsRead:
    """Write lists of a studio; an empty one, and one that says what ours says, gives ours back."""
    ensure_producer_of(session, actor, studio_id)
    for kind, reasons in reasons_by_kind.items():
        ensure_distinct(reasons, kind)
        if not reasons or tuple(reasons) == OURS[kind]:
            session.execute(delete(ReasonList).where(ReasonList.studio_id == studio_id, ReasonList.kind == kind))
            continue
        facts = {"reasons": list(reasons), "set_by": actor.person, "set_at": clock.now()}
        row = {"studio_id": studio_id, "kind": kind, **facts}
        if not insert_if_absent(session, ReasonList, row, unique=("studio_id", "kind")):
            reason_list = session.get_one(ReasonList, (studio_id, kind), populate_existing=True)
            reason_list.reasons, reason_list.set_by, reason_list.set_at = list(reasons), actor.person, clock.now()
    session.flush()
    return _lists(session, studio_id)


def _lists(session: Session, studio_id: UUID) -> ReviewReasonsRead:
    lists_of_studio = queries.lists_of(session, studio_id)
    lists = {
        kind.value: ReasonListRead(reasons=list(lists_of_studio.get(kind, OURS[kind])), is_own=kind in lists_of_studio)
        for kind in ReasonKind
    }
    return ReviewReasonsRead(**lists)


def record_reasons(session: Session, on_file: VerdictsOnFile) -> None:
    """Record the reasons of verdicts that are on file."""
    kind = ReasonKind.PICK if on_file.kind is VerdictKind.APPROVE else ReasonKind.CHANGE
    session.add_all(
        GivenReason(
            verdict_id=given.verdict.id,
            reason=reason,
            kind=kind,
            studio_id=given.verdict.studio_id,
            project_id=given.verdict.project_id,
            cue_id=given.verdict.cue_id,
            designer_id=given.take.designer_id,
            change_request_id=given.change_request_id,
        )
        for given in on_file.given
        for reason in given.verdict.reasons
    )


def forget_reasons(session: Session, verdicts: Sequence[Verdict]) -> None:
    """Count the reasons of verdicts that are taken back no longer."""
    if any(verdict.reasons for verdict in verdicts):
        session.execute(
            delete(GivenReason).where(in_array(GivenReason.verdict_id, [verdict.id for verdict in verdicts]))
        )
