"""Change requests and their sending: drafts go out together, and each cue counts one round at most."""

from collections import defaultdict
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.contracts.settlement import price_round
from app.deliveries.rules import TakeState
from app.deliveries.service import change_state
from app.kit.db import new_id
from app.kit.events import publish
from app.kit.http import Page, cursor_of, uuid_cursor
from app.projects.errors import ProjectNotFound, TeamNeeded
from app.projects.service import standing_in
from app.reviews import queries
from app.reviews.errors import AlreadySent, ChangeRequestNotFound, NothingToSend
from app.reviews.models import ChangeRequest, Round, Sending
from app.reviews.owed import settle_acceptance
from app.reviews.review_room import change_request_read
from app.reviews.rules import STATE_WORDS, VerdictKind, why_not_counted
from app.reviews.schemas import ChangeRequestRead, HeldBack, RoundRead, SendingRead
from app.reviews.service import new_verdict
from app.sound_lists.models import Cue

PAGE_CHANGE_REQUESTS = 200


def change_requests(
    session: Session, actor: Actor, project_id: UUID, *, state: str, cursor: str | None
) -> Page[ChangeRequestRead]:
    """Return drafts or sent change requests, newest first; a designer sees what was sent on their own takes."""
    standing = standing_in(session, actor, project_id)
    drafts = state == "draft"
    if drafts and not standing.is_team:
        raise TeamNeeded("drafts are the game team's until they are sent")
    where = [
        ChangeRequest.project_id == project_id,
        ChangeRequest.sending_id.is_(None) if drafts else ChangeRequest.sending_id.is_not(None),
    ]
    if standing.only_designer_id is not None:
        where.append(ChangeRequest.take.has(designer_id=standing.only_designer_id))
    found = queries.change_requests_of(session, *where, after=uuid_cursor(cursor), limit=PAGE_CHANGE_REQUESTS + 1)
    shown = found[:PAGE_CHANGE_REQUESTS]
    items = [change_request_read(one, standing.project.cue_prefix) for one in shown]
    return Page(items=items, next=cursor_of(shown[-1].id) if len(found) > len(shown) else None)


def drop_change_request(session: Session, actor: Actor, change_request_id: UUID) -> None:
    """Drop a draft."""
    request = queries.change_request_by_id(session, change_request_id)
    if request is None:
        raise ChangeRequestNotFound(f"no change request {change_request_id}")
    try:
        standing = standing_in(session, actor, request.project_id)
    except ProjectNotFound:
        raise ChangeRequestNotFound(f"no change request {change_request_id}") from None
    if standing.only_designer_id is not None and (
        request.sending_id is None or request.take.designer_id != standing.only_designer_id
    ):
        raise ChangeRequestNotFound(f"no change request {change_request_id}")
    standing.ensure_decider()
    if request.sending_id is not None:
        raise AlreadySent("this change request went to its designer; what was sent stays sent")
    session.delete(request)


def send_changes(session: Session, actor: Actor, project_id: UUID, *, note: str = "") -> SendingRead:
    """Send all drafts of a project together: their takes go back, and each cue counts one round at most."""
    standing = standing_in(session, actor, project_id)
    standing.ensure_decider()
    sendable, held_back = _sorted_drafts(session, project_id)
    if not sendable:
        raise NothingToSend(held_back[0].why if held_back else "no change is noted, so there is nothing to send")
    sending = Sending(studio_id=standing.project.studio_id, project_id=project_id, sent_by=actor.person, note=note)
    session.add(sending)
    session.flush()
    reversals: dict[UUID, list[bool]] = defaultdict(list)
    action_id = new_id()
    for draft in sorted(sendable, key=lambda each: each.cue_id):  # contracts are locked in one order
        reversals[draft.cue_id].append(draft.take.state is TakeState.APPROVED)
        session.add(new_verdict(session, actor.person, draft.take, VerdictKind.REQUEST_CHANGE, draft.text, action_id))
        change_state(session, draft.take, TakeState.CHANGE_REQUESTED)
        draft.sending_id = sending.id
    rounds = _count_rounds(session, sending, reversals)
    session.flush()
    for one in sorted(rounds, key=lambda each: each.cue_id):  # contracts are locked in one order
        if one.number is not None:
            price_round(session, one.cue_id, number=one.number, person_id=actor.person)
        settle_acceptance(session, session.get_one(Cue, one.cue_id), person_id=actor.person)
    session.expire_all()
    publish(session, "changes.sent", studio_id=sending.studio_id, sending_id=sending.id)
    sent = queries.change_requests_of(session, ChangeRequest.sending_id == sending.id)
    return SendingRead(
        id=sending.id,
        note=sending.note,
        created_at=sending.created_at,
        change_requests=[change_request_read(one, standing.project.cue_prefix) for one in reversed(sent)],
        rounds=[RoundRead.model_validate(one) for one in rounds],
        held_back=held_back,
    )


def _sorted_drafts(session: Session, project_id: UUID) -> tuple[list[ChangeRequest], list[HeldBack]]:
    """Return the drafts that can go now, and why the others cannot; their cues are locked."""
    sendable: list[ChangeRequest] = []
    held_back: list[HeldBack] = []
    for cue_id in sorted({draft.cue_id for draft in queries.drafts_of_project(session, project_id)}):
        queries.lock_cue(session, cue_id)
    for draft in queries.drafts_of_project(session, project_id):
        take = draft.take
        if take.state in (TakeState.CONFORMING, TakeState.APPROVED):
            sendable.append(draft)
        else:
            why = f"version {take.number} of {take.file_name} {STATE_WORDS[take.state]}; its draft is kept"
            held_back.append(HeldBack(change_request_id=draft.id, take_id=take.id, why=why))
    return sendable, held_back


def _count_rounds(session: Session, sending: Sending, reversals: dict[UUID, list[bool]]) -> list[Round]:
    counted = queries.round_counts(session, reversals)
    rounds = []
    for cue_id, reversed_ones in reversals.items():
        why_not = why_not_counted(reversed_ones)
        rounds.append(
            Round(
                studio_id=sending.studio_id,
                project_id=sending.project_id,
                cue_id=cue_id,
                sending_id=sending.id,
                number=None if why_not else counted.get(cue_id, 0) + 1,
                why_not_counted=why_not,
            )
        )
    session.add_all(rounds)
    return rounds
