"""The endpoints of bids, of questions beside them, and of their comparison."""

from uuid import UUID

from fastapi import APIRouter

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.web.http import DbSession, problems
from app.hiring.bids import comparison
from app.hiring.bids import service as bids
from app.hiring.errors import (
    BidChanged,
    BidInvalid,
    BidNoteNotFound,
    BidNotFound,
    BidNotSent,
    PostingClosed,
    PostingNotFound,
    PostingQuestionAnswered,
    PostingQuestionNotFound,
    ScoresInvalid,
)
from app.hiring.postings.reads import comparison_read, posting_read
from app.hiring.schemas import (
    BidComparison,
    BidContent,
    BidNoteWrite,
    BidSend,
    BidWrite,
    PostingQuestionAdd,
    PostingQuestionAnswer,
    PostingRead,
    ScoresWrite,
    ShortlistWrite,
)
from app.projects.errors import DesignerNeeded, TeamNeeded

router = APIRouter(prefix="/v1", tags=["postings"])


@router.put(
    "/postings/{posting_id}/bid",
    responses=problems(PostingNotFound, DesignerNeeded, PostingClosed, BidInvalid, BidChanged),
)
def save_bid(
    posting_id: UUID, body: BidWrite, session: DbSession, actor: Actor = allows(Audience.DESIGNER)
) -> PostingRead:
    """Keep a bid as it is typed; the studio does not see it until it is sent."""
    content = BidContent(**{name: getattr(body, name) for name in BidContent.model_fields}).model_dump(mode="json")
    bids.save_bid(session, actor, posting_id, content, revision=body.revision)
    return posting_read(session, actor, posting_id)


@router.post(
    "/postings/{posting_id}/bid/send",
    responses=problems(PostingNotFound, DesignerNeeded, PostingClosed, BidInvalid, BidChanged, BidNotSent),
)
def send_bid(
    posting_id: UUID, body: BidSend, session: DbSession, actor: Actor = allows(Audience.DESIGNER)
) -> PostingRead:
    """Show the studio the bid as it was read; sending again replaces what was sent."""
    bids.send_bid(session, actor, posting_id, revision=body.revision)
    return posting_read(session, actor, posting_id)


@router.post("/postings/{posting_id}/bid/withdraw", responses=problems(PostingNotFound, DesignerNeeded, BidNotSent))
def withdraw_bid(posting_id: UUID, session: DbSession, actor: Actor = allows(Audience.DESIGNER)) -> PostingRead:
    """Take a bid back; the draft is kept."""
    bids.withdraw_bid(session, actor, posting_id)
    return posting_read(session, actor, posting_id)


@router.post("/postings/{posting_id}/questions", status_code=201, responses=problems(PostingNotFound, DesignerNeeded))
def ask_about_posting(
    posting_id: UUID, body: PostingQuestionAdd, session: DbSession, actor: Actor = allows(Audience.DESIGNER)
) -> PostingRead:
    """Ask the studio about a posting."""
    bids.ask(session, actor, posting_id, body.text)
    return posting_read(session, actor, posting_id)


@router.post(
    "/posting-questions/{posting_question_id}/answer",
    responses=problems(PostingQuestionNotFound, TeamNeeded, PostingQuestionAnswered),
)
def answer_posting_question(
    posting_question_id: UUID,
    body: PostingQuestionAnswer,
    session: DbSession,
    actor: Actor = allows(Audience.TEAM),
) -> PostingRead:
    """Answer a question once, for all candidates or for the one who asked."""
    posting_id = bids.answer(session, actor, posting_question_id, body.text, is_for_all=body.is_for_all)
    return posting_read(session, actor, posting_id)


@router.get("/postings/{posting_id}/bids", responses=problems(PostingNotFound, TeamNeeded))
def compare_bids(posting_id: UUID, session: DbSession, actor: Actor = allows(Audience.TEAM)) -> BidComparison:
    """Return the bids side by side: those shortlisted first, then the first sent first."""
    return comparison_read(session, actor, posting_id)


@router.put("/bids/{bid_id}/shortlist", responses=problems(BidNotFound, TeamNeeded, BidNotSent))
def shortlist_bid(
    bid_id: UUID, body: ShortlistWrite, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> BidComparison:
    """Put a bid on the shortlist, or take it off."""
    posting_id = comparison.shortlist(session, actor, bid_id, is_shortlisted=body.is_shortlisted)
    return comparison_read(session, actor, posting_id)


@router.put("/bids/{bid_id}/scores", responses=problems(BidNotFound, TeamNeeded, BidNotSent, ScoresInvalid))
def score_bid(
    bid_id: UUID, body: ScoresWrite, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> BidComparison:
    """Keep the caller's scores of a bid; the others' are shown once each heading has one."""
    posting_id = comparison.score(session, actor, bid_id, body.scores, body.note)
    return comparison_read(session, actor, posting_id)


@router.post("/bids/{bid_id}/notes", status_code=201, responses=problems(BidNotFound, TeamNeeded, BidNotSent))
def add_bid_note(
    bid_id: UUID, body: BidNoteWrite, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> BidComparison:
    """Add a note of a call or an interview to a bid, for the team only."""
    posting_id = comparison.add_note(session, actor, bid_id, body)
    return comparison_read(session, actor, posting_id)


@router.delete(
    "/bids/{bid_id}/notes/{bid_note_id}", responses=problems(BidNotFound, BidNoteNotFound, TeamNeeded, BidNotSent)
)
def remove_bid_note(
    bid_id: UUID, bid_note_id: UUID, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> BidComparison:
    """Remove a note of the caller's own from a bid."""
    posting_id = comparison.remove_note(session, actor, bid_id, bid_note_id)
    return comparison_read(session, actor, posting_id)
