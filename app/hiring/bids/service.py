"""Bids: kept as they are typed, sent, changed until the posting closes, withdrawn; and questions beside them."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.core import clock
from app.core.db import bypass_row_policies
from app.core.events import publish
from app.hiring import queries
from app.hiring.errors import BidChanged, BidNotSent, PostingQuestionAnswered, PostingQuestionNotFound
from app.hiring.models import Bid, Posting, PostingQuestion
from app.hiring.postings.access import PostingAccess, posting_access, today_of
from app.hiring.rules import BidState, PostingState, ensure_bid_fits, ensure_sendable, ensure_takes_bids, overlap
from app.projects.errors import TeamNeeded


@dataclass(frozen=True)
class OtherWork:
    """An offer or award elsewhere in the days of a posting."""

    posting: Posting
    bid: Bid


def _own(session: Session, actor: Actor, posting_id: UUID) -> tuple[PostingAccess, Bid | None]:
    access = posting_access(session, actor, posting_id)
    access.ensure_candidate()
    queries.lock_posting(session, posting_id)
    return access, queries.own_bid(session, posting_id, actor.person)


def save_bid(session: Session, actor: Actor, posting_id: UUID, content: dict[str, Any], *, revision: int) -> None:
    """Keep a bid as it is typed; the studio does not see it until it is sent."""
    access, bid = _own(session, actor, posting_id)
    posting = access.posting
    ensure_takes_bids(posting.state, posting.bids_until_on, today_of(posting))
    ensure_bid_fits(posting.lines, content)
    if bid is None:
        bid = Bid(
            studio_id=posting.studio_id, project_id=posting.project_id, posting_id=posting_id, designer_id=actor.person
        )
        bid.revision = 0
        session.add(bid)
    if bid.revision != revision:
        raise BidChanged("you changed this bid in another window", fix="reload it, then save what you still want")
    bid.content, bid.changed_at = content, clock.now()
    bid.revision += 1
    session.flush()


def send_bid(session: Session, actor: Actor, posting_id: UUID, *, revision: int) -> None:
    """Show the studio the bid as it was read; sending again replaces what was sent."""
    access, bid = _own(session, actor, posting_id)
    posting = access.posting
    ensure_takes_bids(posting.state, posting.bids_until_on, today_of(posting))
    if bid is None:
        raise BidNotSent("there is no bid to send yet", fix="save a draft first")
    if bid.revision != revision:
        raise BidChanged("you changed this bid in another window", fix="reload it and read it before you send it")
    ensure_sendable(bid.content)
    is_first = bid.sent_at is None or bid.state is BidState.WITHDRAWN
    bid.sent, bid.state = bid.content, BidState.SENT
    bid.resent_at = None if is_first else clock.now()
    bid.sent_at = clock.now() if is_first else bid.sent_at
    bid.is_shortlisted = bid.is_shortlisted and not is_first
    session.flush()
    publish(session, "bid.sent", studio_id=posting.studio_id, project_id=posting.project_id, bid_id=bid.id)


def withdraw_bid(session: Session, actor: Actor, posting_id: UUID) -> None:
    """Take a bid back: the studio sees it no longer; the draft is kept."""
    access, bid = _own(session, actor, posting_id)
    if bid is None or bid.state is not BidState.SENT:
        raise BidNotSent("no bid of yours is with the studio")
    if access.posting.awarded_bid_id == bid.id:
        raise BidNotSent("this bid was awarded", fix="talk to the studio; nothing is signed yet")
    bid.state, bid.is_shortlisted = BidState.WITHDRAWN, False
    session.flush()


def clashes(session: Session, access: PostingAccess) -> Sequence[OtherWork]:
    """Return the candidate's offers and awards elsewhere in the days of a posting."""
    posting = access.posting
    days = (posting.work_from_on, posting.work_to_on)
    with bypass_row_policies(session):  # the candidate's own bids, at other studios too
        others = queries.other_sent_bids(session, access.actor.person, posting.id)
    works = [OtherWork(bid.posting, bid) for bid in others]
    return [work for work in works if overlap(days, (work.posting.work_from_on, work.posting.work_to_on))]


def ask(session: Session, actor: Actor, posting_id: UUID, text: str) -> UUID:
    """Ask the studio about a posting."""
    access = posting_access(session, actor, posting_id)
    access.ensure_candidate()
    posting = access.posting
    question = PostingQuestion(
        studio_id=posting.studio_id,
        project_id=posting.project_id,
        posting_id=posting_id,
        text=text,
        asked_by=actor.person,
    )
    session.add(question)
    session.flush()
    publish(
        session,
        "posting_question.asked",
        studio_id=posting.studio_id,
        project_id=posting.project_id,
        question_id=question.id,
    )
    return question.id


def answer(session: Session, actor: Actor, question_id: UUID, text: str, *, is_for_all: bool) -> UUID:
    """Answer a question once, for all candidates or for the one who asked; return its posting."""
    question = queries.question_for(session, actor, question_id)
    if question is None:
        raise PostingQuestionNotFound(f"no question {question_id}")
    if not actor.roles_in(question.studio_id):
        raise TeamNeeded("only a producer or an audio lead of this project can do this")
    access = posting_access(session, actor, question.posting_id)
    access.ensure_team()
    queries.lock_posting(session, question.posting_id)
    session.refresh(question)
    if question.answered_at is not None:
        raise PostingQuestionAnswered("this question has its answer")
    question.answer, question.is_for_all = text, is_for_all
    question.answered_by, question.answered_at = actor.person, clock.now()
    session.flush()
    publish(
        session,
        "posting_question.answered",
        studio_id=question.studio_id,
        project_id=question.project_id,
        question_id=question.id,
    )
    return question.posting_id


def questions_seen(session: Session, access: PostingAccess) -> Sequence[PostingQuestion]:
    """Return all questions for the team; for a candidate their own, and those that were answered for all."""
    questions = queries.questions_of(session, access.posting.id)
    if access.team is not None:
        return questions
    return [
        question
        for question in questions
        if question.asked_by == access.actor.person or (question.is_for_all and question.answer)
    ]


def is_awarded(posting: Posting, bid: Bid) -> bool:
    """Whether a posting was awarded to a bid."""
    return posting.state is PostingState.AWARDED and posting.awarded_bid_id == bid.id
