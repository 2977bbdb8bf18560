"""Change requests and their sending: drafts go out together, and each cue counts one round at most."""

from collections import defaultdict
from datetime import timedelta
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.queries import actor_for_person
from app.accounts.rules import Actor
from app.core import clock
from app.core.db import new_id
from app.core.events import publish, send
from app.core.web.http import Page, cursor_of, uuid_cursor
from app.deliveries.rules import TakeState
from app.deliveries.take_states import change_state
from app.projects.approval.service import approval_rights, ensure_may_approve
from app.projects.errors import ApproverNeeded, ProjectNotFound, TeamNeeded
from app.projects.rules import ApprovalScope
from app.projects.service import project_access
from app.reviews import queries
from app.reviews.errors import AlreadySent, ChangeRequestNotFound, NothingToSend
from app.reviews.models import ChangeRequest, Feedback, Round
from app.reviews.queue.service import change_request_read
from app.reviews.rounds.mentions import publish_mentions
from app.reviews.rules import STATE_WORDS, VerdictKind, why_not_counted
from app.reviews.schemas import ChangeRequestRead, FeedbackRead, HeldBack, RoundRead
from app.reviews.signals import GivenVerdict, RoundCounted, VerdictsOnFile
from app.reviews.verdicts.decisions import decide_cue, new_verdict
from app.sound_lists.models import Cue

PAGE_CHANGE_REQUESTS = 200
CLOCK_TOLERANCE = timedelta(seconds=1)  # between the clock that a job waits by and ours


def change_requests(
    session: Session, actor: Actor, project_id: UUID, *, state: str, cursor: str | None
) -> Page[ChangeRequestRead]:
    """Return drafts or sent change requests, newest first; a designer sees those sent on their own takes."""
    access = project_access(session, actor, project_id)
    drafts = state == "draft"
    if drafts and not access.is_team:
        raise TeamNeeded("drafts are the game team's until they are sent")
    where = [
        ChangeRequest.project_id == project_id,
        ChangeRequest.feedback_id.is_(None) if drafts else ChangeRequest.feedback_id.is_not(None),
    ]
    if access.only_designer_id is not None:
        where.append(ChangeRequest.take.has(designer_id=access.only_designer_id))
    requests = queries.change_requests_of(session, *where, after=uuid_cursor(cursor), limit=PAGE_CHANGE_REQUESTS + 1)
    shown = requests[:PAGE_CHANGE_REQUESTS]
    items = [change_request_read(request, access.project.cue_prefix) for request in shown]
    return Page(items=items, next=cursor_of(shown[-1].id) if len(requests) > len(shown) else None)


def drop_change_request(session: Session, actor: Actor, change_request_id: UUID) -> None:
    """Drop a draft."""
    request = queries.change_request_by_id(session, change_request_id)
    if request is None:
        raise ChangeRequestNotFound(f"no change request {change_request_id}")
    try:
        access = project_access(session, actor, request.project_id)
    except ProjectNotFound:
        raise ChangeRequestNotFound(f"no change request {change_request_id}") from None
    if access.only_designer_id is not None and (
        request.feedback_id is None or request.take.designer_id != access.only_designer_id
    ):
        raise ChangeRequestNotFound(f"no change request {change_request_id}")
    ensure_may_approve(session, access, request.cue.category)
    if request.feedback_id is not None:
        raise AlreadySent("this change request was sent and can't be deleted")
    session.delete(request)


def send_due_change(session: Session, change_request_id: UUID) -> None:
    """Send a change request whose time to undo it is over, with the others of its cue that are on their way."""
    request = queries.change_request_by_id(session, change_request_id)
    if request is None or request.feedback_id is not None or request.sends_at is None:
        return  # undone, sent with others, or left as a draft
    if request.sends_at > clock.now() + CLOCK_TOLERANCE:
        return  # it was written again, and leaves later
    try:
        sent = send_changes(
            session, actor_for_person(session, request.written_by), request.project_id, cue_id=request.cue_id
        )
        kept = {held.change_request_id for held in sent.held_back}
    except (ApproverNeeded, NothingToSend, ProjectNotFound):
        kept = {change_request_id}
    for draft in queries.drafts_of_project(session, request.project_id):
        if draft.id in kept:
            draft.sends_at = None  # it stays a draft that its approver sees


def send_changes(
    session: Session, actor: Actor, project_id: UUID, *, note: str = "", cue_id: UUID | None = None
) -> FeedbackRead:
    """Send the caller's drafts of a project together: their takes go back, and each cue counts one round at most.

    With a cue, only its drafts that send themselves go.
    """
    access = project_access(session, actor, project_id)
    rights = approval_rights(session, access.project)
    if not (access.is_team and rights.scope_of(actor.person).is_any):
        raise ApproverNeeded("only an approver of the project sends changes; add a comment instead")
    sendable, held_back = _sorted_drafts(session, project_id, rights.scope_of(actor.person), cue_id)
    if not sendable:
        raise NothingToSend(held_back[0].why if held_back else "there are no draft change requests to send")
    sending = Feedback(studio_id=access.project.studio_id, project_id=project_id, sent_by=actor.person, note=note)
    session.add(sending)
    session.flush()
    reversals: dict[UUID, list[bool]] = defaultdict(list)
    action_id = new_id()
    given: list[GivenVerdict] = []
    for draft in sorted(sendable, key=lambda draft: draft.cue_id):  # contracts are locked in one order
        reversals[draft.cue_id].append(draft.take.state is TakeState.APPROVED)
        for_whom = rights.on_behalf_of(actor.person, draft.cue.category)
        verdict = new_verdict(
            session,
            actor.person,
            draft.take,
            VerdictKind.REQUEST_CHANGE,
            draft.text,
            action_id,
            reasons=draft.reasons,
            on_behalf_of=for_whom,
            sent_with=(sending, draft),
        )
        session.add(verdict)
        given.append(GivenVerdict(verdict, draft.take, draft.id))
        change_state(session, draft.take, TakeState.CHANGE_REQUESTED, reasons=draft.reasons)
        draft.feedback_id = sending.id
    rounds = _count_rounds(session, sending, reversals, joins=cue_id is not None)
    session.flush()
    send(session, VerdictsOnFile(VerdictKind.REQUEST_CHANGE, given))
    for round_ in sorted(rounds, key=lambda round_: round_.cue_id):  # contracts are locked in one order
        if round_.number is not None:
            send(session, RoundCounted(round_.cue_id, round_.number, actor.person))
        decide_cue(session, session.get_one(Cue, round_.cue_id), person_id=actor.person)
    session.expire_all()
    publish(session, "changes.sent", studio_id=sending.studio_id, feedback_id=sending.id)
    sent = queries.change_requests_of(session, ChangeRequest.feedback_id == sending.id)
    for request in sent:
        publish_mentions(session, request, without=request.take.designer_id)
    return FeedbackRead(
        id=sending.id,
        note=sending.note,
        created_at=sending.created_at,
        change_requests=[
            change_request_read(sent_request, access.project.cue_prefix) for sent_request in reversed(sent)
        ],
        rounds=[RoundRead.model_validate(sent_round) for sent_round in rounds],
        held_back=held_back,
    )


def _sorted_drafts(
    session: Session, project_id: UUID, scope: ApprovalScope, cue_id: UUID | None
) -> tuple[list[ChangeRequest], list[HeldBack]]:
    """Return the drafts that can go now, and why the others cannot; their cues are locked.

    Those on cues that the sender does not approve are left to their own approver.
    """
    sendable: list[ChangeRequest] = []
    held_back: list[HeldBack] = []
    for drafted_id in sorted({draft.cue_id for draft in queries.drafts_of_project(session, project_id)}):
        if cue_id in (None, drafted_id):
            queries.lock_cue(session, drafted_id)
    for draft in queries.drafts_of_project(session, project_id):
        is_asked = cue_id is None or (draft.cue_id == cue_id and draft.sends_at is not None)
        if not is_asked or not scope.covers(draft.cue.category):
            continue
        take = draft.take
        if take.cue_id != draft.cue_id:
            why = f"{take.file_name} is not matched to this cue any more; its draft is kept"
        elif take.state not in (TakeState.CONFORMING, TakeState.APPROVED):
            why = f"version {take.number} of {take.file_name} {STATE_WORDS[take.state]}; its draft is kept"
        else:
            sendable.append(draft)
            continue
        held_back.append(HeldBack(change_request_id=draft.id, take_id=take.id, why=why))
    return sendable, held_back


def _count_rounds(
    session: Session, sending: Feedback, reversals: dict[UUID, list[bool]], *, joins: bool
) -> list[Round]:
    """Return the rounds of a sending; `joins` has it belong to the round that nothing was delivered for yet."""
    counted = queries.round_counts(session, reversals)
    unanswered = queries.unanswered_rounds(session, reversals) if joins else {}
    rounds = []
    for cue_id, reversed_ones in reversals.items():
        why_not = why_not_counted(reversed_ones, unanswered.get(cue_id))
        rounds.append(
            Round(
                studio_id=sending.studio_id,
                project_id=sending.project_id,
                cue_id=cue_id,
                feedback_id=sending.id,
                number=None if why_not else counted.get(cue_id, 0) + 1,
                why_not_counted=why_not,
            )
        )
    session.add_all(rounds)
    return rounds
