"""The endpoints of this room."""

from datetime import date
from typing import Annotated, Literal
from uuid import UUID

from fastapi import APIRouter, Depends, Query

from app.accounts.rules import Actor, Audience
from app.accounts.schemas import PersonBrief
from app.accounts.web.policies import allows
from app.core.web.http import BadCursor, DbSession, Page, problems
from app.deliveries.errors import DeliveryNotFound, TakeNotFound, WrongState
from app.projects.errors import ApproverNeeded, ProducerNeeded, ProjectNotFound, TeamNeeded
from app.reviews.errors import (
    AcknowledgementNotDue,
    AlreadyAccepted,
    AlreadySent,
    ApprovalBlocked,
    ChangeRequestNotFound,
    CommentNotFound,
    NoteNeeded,
    NoteNotFound,
    NothingToSend,
    NothingToUndo,
    NotMentionable,
    NotOfThisCue,
    NotReviewable,
    RangeInvalid,
    ReasonsInvalid,
    SetIncomplete,
    StaleView,
    TooLateToUndo,
    VerdictSince,
    VersionsUndecided,
)
from app.reviews.palette_fit import service as fit
from app.reviews.palette_fit.schemas import DeliveryFitRead, TakeFitRead
from app.reviews.queue import service as review_room
from app.reviews.rounds import change_requests as feedback
from app.reviews.rounds import comments
from app.reviews.rules import QueueFilter, QueueKind, VerdictKind, VersionKind
from app.reviews.schemas import (
    CarriedNote,
    ChangeRequestRead,
    CommentAdd,
    CommentRead,
    CueCut,
    CueCutRead,
    CueReviewRead,
    FeedbackAdd,
    FeedbackRead,
    HistoryEntry,
    NoteAnswerGive,
    QueueCount,
    QueueItem,
    SetAccept,
    SetAccepted,
    VerdictGive,
    VerdictGiven,
    VerdictUndone,
)
from app.reviews.verdicts import carried_notes, service, take_history
from app.sound_lists.errors import CueIsCut, CueNotFound
from app.sound_lists.models import Cue
from app.sound_lists.rules import Need

Own = Annotated[
    bool,
    Query(description="The cues that the caller approves today. Who approves none in a project is shown all of it."),
]
Designer = Annotated[UUID | None, Query(description="Of whom a version waits.")]
DueBy = Annotated[date | None, Query(description="The last target date; cues without one are left out.")]
Version = Annotated[VersionKind | None, Query(description="`new`: a version that answers a change request waits.")]
Unheard = Annotated[bool, Query(description="A version waits that the caller has not heard yet.")]
Words = Annotated[
    str, Query(max_length=200, description="Each word is in the name, the description or the use of the cue.")
]


def queue_filter(
    category: Annotated[str | None, Query(max_length=60)] = None,
    designer_id: Designer = None,
    due_by: DueBy = None,
    need: Need | None = None,
    kind: QueueKind | None = None,
    version: Version = None,
    unheard: Unheard = False,
    q: Words = "",
) -> QueueFilter:
    """Return the filter that a request names."""
    return QueueFilter(category, designer_id, due_by, need, kind, version, unheard, q)


Filter = Annotated[QueueFilter, Depends(queue_filter)]
router = APIRouter(prefix="/v1", tags=["reviews"])


@router.get("/review-queue", response_model=Page[QueueItem], responses=problems(ProjectNotFound, TeamNeeded, BadCursor))
def get_review_queue(
    session: DbSession,
    project_id: UUID | None = None,
    own: Own = False,
    *,
    wanted: Filter,
    cursor: str | None = None,
    actor: Actor = allows(Audience.TEAM),
) -> Page[QueueItem]:
    """Return the review queue, urgent cues first, then the oldest: of one project, or of all of the caller's."""
    return review_room.review_queue(session, actor, project_id=project_id, is_own=own, wanted=wanted, cursor=cursor)


@router.get("/review-queue/count", response_model=QueueCount, responses=problems(ProjectNotFound, TeamNeeded))
def count_review_queue(
    session: DbSession,
    project_id: UUID | None = None,
    own: Own = False,
    *,
    wanted: Filter,
    actor: Actor = allows(Audience.TEAM),
) -> QueueCount:
    """Count the cues that wait for review, up to 99: of one project, or of all projects of the caller's studios."""
    return review_room.queue_count(session, actor, project_id=project_id, is_own=own, wanted=wanted)


@router.get("/cues/{cue_id}/review", response_model=CueReviewRead, responses=problems(CueNotFound, TeamNeeded))
def get_cue_review(cue_id: UUID, session: DbSession, actor: Actor = allows(Audience.TEAM)) -> CueReviewRead:
    """Return everything of one cue that the review room shows, takes in every state included."""
    return review_room.cue_review(session, actor, cue_id)


@router.post(
    "/takes/{take_id}/verdict",
    response_model=VerdictGiven,
    responses=problems(
        TakeNotFound,
        ApproverNeeded,
        StaleView,
        NotReviewable,
        WrongState,
        CueIsCut,
        NoteNeeded,
        RangeInvalid,
        NotMentionable,
        ApprovalBlocked,
        ReasonsInvalid,
    ),
)
def give_verdict(
    take_id: UUID, body: VerdictGive, session: DbSession, actor: Actor = allows(Audience.APPROVER)
) -> VerdictGiven:
    """Approve a take, set it aside, or request a change, as a draft or to be sent by itself."""
    return service.give_verdict(
        session,
        actor,
        take_id,
        kind=VerdictKind(body.kind),
        note=body.note,
        reasons=body.reasons,
        start_s=body.start_s,
        end_s=body.end_s,
        seen_state=body.seen_state,
        mentions=body.mentions,
        heard=body.heard,
        sends=body.send,
    )


@router.delete(
    "/takes/{take_id}/verdict",
    response_model=VerdictUndone,
    responses=problems(TakeNotFound, ApproverNeeded, NothingToUndo, TooLateToUndo, VerdictSince, CueIsCut),
)
def undo_verdict(take_id: UUID, session: DbSession, actor: Actor = allows(Audience.APPROVER)) -> VerdictUndone:
    """Take back what the last click on a take decided, a whole accepted set included, within a minute."""
    return service.undo_verdict(session, actor, take_id)


@router.post(
    "/cues/{cue_id}/accept-set",
    response_model=SetAccepted,
    responses=problems(
        CueNotFound,
        ApproverNeeded,
        SetIncomplete,
        AlreadyAccepted,
        VersionsUndecided,
        NotReviewable,
        NotOfThisCue,
        CueIsCut,
        ApprovalBlocked,
        ReasonsInvalid,
    ),
)
def accept_set(
    cue_id: UUID, body: SetAccept, session: DbSession, actor: Actor = allows(Audience.APPROVER)
) -> SetAccepted:
    """Approve one take of every variation at once, or none where a variation lacks one."""
    return service.accept_set(
        session,
        actor,
        cue_id,
        note=body.note,
        reasons=body.reasons,
        take_ids=body.take_ids,
        heard_take_ids=body.heard_take_ids,
    )


@router.get(
    "/projects/{project_id}/change-requests",
    response_model=Page[ChangeRequestRead],
    responses=problems(ProjectNotFound, TeamNeeded, BadCursor),
)
def list_change_requests(
    project_id: UUID,
    session: DbSession,
    state: Literal["draft", "sent"] = "sent",
    cursor: str | None = None,
    actor: Actor = allows(Audience.PROJECT),
) -> Page[ChangeRequestRead]:
    """Return drafts (the team's alone) or sent change requests, newest first."""
    return feedback.change_requests(session, actor, project_id, state=state, cursor=cursor)


@router.delete(
    "/change-requests/{change_request_id}",
    status_code=204,
    responses=problems(ChangeRequestNotFound, ApproverNeeded, AlreadySent),
)
def drop_change_request(change_request_id: UUID, session: DbSession, actor: Actor = allows(Audience.APPROVER)) -> None:
    """Drop a draft."""
    feedback.drop_change_request(session, actor, change_request_id)


@router.post(
    "/projects/{project_id}/feedback",
    status_code=201,
    response_model=FeedbackRead,
    responses=problems(ProjectNotFound, ApproverNeeded, NothingToSend),
)
def send_change_requests(
    project_id: UUID, body: FeedbackAdd, session: DbSession, actor: Actor = allows(Audience.APPROVER)
) -> FeedbackRead:
    """Send all drafts together; one sending counts one round for each cue or set it names."""
    return feedback.send_changes(session, actor, project_id, note=body.note)


@router.get("/takes/{take_id}/comments", response_model=list[CommentRead], responses=problems(TakeNotFound))
def list_comments(take_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> list[CommentRead]:
    """Return the advice on a take, oldest first."""
    return comments.take_comments(session, actor, take_id)


@router.post(
    "/takes/{take_id}/comments",
    status_code=201,
    response_model=CommentRead,
    responses=problems(TakeNotFound, RangeInvalid, CommentNotFound, ChangeRequestNotFound, NotMentionable),
)
def add_comment(
    take_id: UUID, body: CommentAdd, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> CommentRead:
    """Write advice on a take, at a time in the sound or on the whole of it, or a reply to what was said of it."""
    return comments.add_comment(
        session,
        actor,
        take_id,
        text=body.text,
        start_s=body.start_s,
        end_s=body.end_s,
        answers=comments.Answered(body.reply_to_id, body.change_request_id),
        mentions=body.mentions,
    )


@router.post(
    "/comments/{comment_id}/resolve",
    response_model=CommentRead,
    responses=problems(CommentNotFound),
)
def resolve_comment(comment_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> CommentRead:
    """Mark advice as seen to."""
    return comments.resolve_comment(session, actor, comment_id)


@router.post("/comments/{comment_id}/reopen", response_model=CommentRead, responses=problems(CommentNotFound))
def reopen_comment(comment_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> CommentRead:
    """Open advice again that was marked as seen to."""
    return comments.reopen_comment(session, actor, comment_id)


@router.post(
    "/comments/{comment_id}/acknowledgement",
    response_model=CommentRead,
    responses=problems(CommentNotFound, AcknowledgementNotDue),
)
def acknowledge_comment(comment_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> CommentRead:
    """Say that the caller, whom a comment mentions or whose sound it is about, has seen it."""
    return comments.acknowledge_comment(session, actor, comment_id)


@router.get("/takes/{take_id}/people", response_model=list[PersonBrief], responses=problems(TakeNotFound))
def list_people_to_mention(
    take_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> list[PersonBrief]:
    """Return the people who may see a version, without the caller: those who can be mentioned there, by name."""
    return comments.people_for(session, actor, take_id)


@router.post(
    "/takes/{take_id}/carried-notes/{note_id}",
    response_model=CarriedNote,
    responses=problems(TakeNotFound, TeamNeeded, NoteNotFound),
)
def answer_carried_note(
    take_id: UUID, note_id: UUID, body: NoteAnswerGive, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> CarriedNote:
    """Say whether a version does what a comment or a change request on an earlier one asked."""
    return carried_notes.answer_note(session, actor, take_id, note_id, is_done=body.is_done)


@router.get("/takes/{take_id}/history", response_model=list[HistoryEntry], responses=problems(TakeNotFound))
def get_take_history(take_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> list[HistoryEntry]:
    """Return the events of a take, oldest first."""
    return take_history.take_history(session, actor, take_id)


@router.post(
    "/cues/{cue_id}/cut",
    response_model=CueCutRead,
    responses=problems(CueNotFound, ProducerNeeded, CueIsCut),
)
def cut_cue(cue_id: UUID, body: CueCut, session: DbSession, actor: Actor = allows(Audience.TEAM)) -> Cue:
    """Cut a cue that the game no longer needs; it is kept with its reason and its takes."""
    return service.cut_cue(session, actor, cue_id, reason=body.reason)


@router.get("/takes/{take_id}/fit", response_model=TakeFitRead, responses=problems(TakeNotFound))
def see_take_fit(take_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> TakeFitRead:
    """Compare a take with the approved sounds of its category, or of the palette."""
    return fit.take_fit(session, actor, take_id)


@router.get(
    "/deliveries/{delivery_id}/fit", response_model=DeliveryFitRead, responses=problems(DeliveryNotFound, TeamNeeded)
)
def see_delivery_fit(delivery_id: UUID, session: DbSession, actor: Actor = allows(Audience.TEAM)) -> DeliveryFitRead:
    """Compare a delivery with other designers' approved sounds."""
    return fit.delivery_fit(session, actor, delivery_id)
