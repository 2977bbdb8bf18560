"""Postings and bids within the caller's reach."""

from collections.abc import Collection, Sequence
from datetime import datetime
from typing import NamedTuple
from uuid import UUID

from sqlalchemy import exists, func, or_, select, true
from sqlalchemy.orm import Session, joinedload

from app.accounts.rules import Actor
from app.core import clock
from app.hiring.models import Bid, BidNote, Candidate, Posting, PostingQuestion, Sample, Score
from app.hiring.rules import BidState, CountedCue, PostingState
from app.projects.models import Project
from app.sound_lists.models import Cue
from app.sound_lists.rules import CueState

MAX_POSTINGS = 200
MAX_BIDS = 100
MAX_QUESTIONS = 500
MAX_CANDIDATES = 500

_WITH_PROJECT = joinedload(Posting.project).joinedload(Project.studio)


def counted_cues(session: Session, project_id: UUID) -> list[CountedCue]:
    """Return the cues of a project that are not cut, in list order, as postings count them."""
    rows = session.execute(
        select(Cue.id, Cue.category, Cue.variations, Cue.state)
        .where(Cue.project_id == project_id, Cue.state != CueState.CUT)
        .order_by(Cue.position, Cue.number)
    )
    return [
        CountedCue(str(cue_id), category, variations, state is CueState.CONCEPT)
        for cue_id, category, variations, state in rows
    ]


def cues_of_lines(session: Session, project_id: UUID, keys: Collection[str]) -> Sequence[Cue]:
    """Return the cues that lines of a posting count, in list order; those that are cut are left out."""
    return session.scalars(
        select(Cue)
        .where(Cue.project_id == project_id, Cue.state != CueState.CUT, Cue.category.in_(keys))
        .order_by(Cue.position, Cue.number)
    ).all()


def posting_for(session: Session, actor: Actor, posting_id: UUID) -> Posting | None:
    """Return a posting of the caller's studios, or one that the caller may bid on."""
    joined = exists().where(
        Candidate.posting_id == Posting.id, Candidate.person_id == actor.person, Candidate.revoked_at.is_(None)
    )
    return session.scalar(
        select(Posting)
        .where(Posting.id == posting_id, or_(Posting.studio_id.in_(actor.roles), joined))
        .options(_WITH_PROJECT)
        .execution_options(populate_existing=True)
    )


def postings_in(session: Session, project_id: UUID) -> Sequence[Posting]:
    """Return the postings of a project, newest first."""
    query = select(Posting).where(Posting.project_id == project_id).options(_WITH_PROJECT)
    return session.scalars(query.order_by(Posting.id.desc()).limit(MAX_POSTINGS)).all()


def last_currency(session: Session, studio_id: UUID, project_id: UUID | None = None) -> str | None:
    """Return the currency of the newest posting of a project, or of any project of a studio."""
    of_project = Posting.project_id == project_id if project_id else true()
    currencies = select(Posting.currency).where(Posting.studio_id == studio_id, of_project)
    return session.scalar(currencies.order_by(Posting.id.desc()).limit(1))


def postings_of_candidate(session: Session, person_id: UUID) -> Sequence[Posting]:
    """Return the postings that a person may bid on, newest first; drafts are left out."""
    return session.scalars(
        select(Posting)
        .join(Candidate, Candidate.posting_id == Posting.id)
        .where(
            Candidate.person_id == person_id,
            Candidate.revoked_at.is_(None),
            Posting.state != PostingState.DRAFT,
        )
        .options(_WITH_PROJECT)
        .order_by(Posting.id.desc())
        .limit(MAX_POSTINGS)
    ).all()


def posting_by_secret(session: Session, secret_sha256: str) -> tuple[Posting, Candidate | None] | None:
    """Return the posting behind a link, with the candidate whose personal link it is."""
    candidate = session.scalar(
        select(Candidate)
        .join(Candidate.posting)
        .where(
            Candidate.secret_sha256 == secret_sha256,
            Candidate.revoked_at.is_(None),
            Candidate.expires_at > clock.now(),
        )
        .options(joinedload(Candidate.posting).options(_WITH_PROJECT))
    )
    if candidate is not None:
        return candidate.posting, candidate
    posting = session.scalar(select(Posting).where(Posting.secret_sha256 == secret_sha256).options(_WITH_PROJECT))
    return (posting, None) if posting is not None else None


def postings_linked_by(session: Session, studio_id: UUID, person_id: UUID) -> Sequence[Posting]:
    """Return the postings of a studio whose link for everyone a person made, with their projects, the oldest first."""
    return session.scalars(
        select(Posting)
        .where(Posting.studio_id == studio_id, Posting.link_made_by == person_id, Posting.secret_sha256.is_not(None))
        .options(joinedload(Posting.project))
        .order_by(Posting.id)
    ).all()


def candidates_of(session: Session, posting_id: UUID) -> Sequence[Candidate]:
    """Return those who may bid on a posting, in the order in which they were added."""
    return session.scalars(
        select(Candidate)
        .where(Candidate.posting_id == posting_id, Candidate.revoked_at.is_(None))
        .options(joinedload(Candidate.person))
        .order_by(Candidate.id)
        .limit(MAX_CANDIDATES)
    ).all()


def candidate_by_address(session: Session, posting_id: UUID, email: str) -> Candidate | None:
    """Return the candidate of an address, withdrawn ones too."""
    return session.scalar(select(Candidate).where(Candidate.posting_id == posting_id, Candidate.email == email))


def candidate_by_person(session: Session, posting_id: UUID, person_id: UUID) -> Candidate | None:
    """Return the candidate that a person is, withdrawn ones too."""
    return session.scalar(select(Candidate).where(Candidate.posting_id == posting_id, Candidate.person_id == person_id))


def own_bid(session: Session, posting_id: UUID, designer_id: UUID) -> Bid | None:
    """Return a designer's own bid on a posting."""
    return session.scalar(
        select(Bid)
        .where(Bid.posting_id == posting_id, Bid.designer_id == designer_id)
        .execution_options(populate_existing=True)
    )


def bid_for(session: Session, actor: Actor, bid_id: UUID) -> Bid | None:
    """Return a bid that was sent to one of the caller's studios, or the caller's own."""
    sent = Bid.studio_id.in_(actor.roles) & (Bid.state == BidState.SENT)
    return session.scalar(
        select(Bid)
        .where(Bid.id == bid_id, or_(sent, Bid.designer_id == actor.person))
        .options(joinedload(Bid.designer), joinedload(Bid.posting).options(_WITH_PROJECT))
        .execution_options(populate_existing=True)
    )


def samples_of(session: Session, bid_ids: Collection[UUID]) -> Sequence[Sample]:
    """Return the samples of bids, in the order in which they were added."""
    return session.scalars(select(Sample).where(Sample.bid_id.in_(bid_ids)).order_by(Sample.id)).all()


def sample_for(session: Session, actor: Actor, sample_id: UUID) -> Sample | None:
    """Return a sample of a bid to one of the caller's studios, or of the caller's own."""
    of_caller = or_(Sample.studio_id.in_(actor.roles), Sample.designer_id == actor.person)
    return session.scalar(select(Sample).where(Sample.id == sample_id, of_caller))


def bid_behind(session: Session, contract_id: UUID) -> Bid | None:
    """Return the bid whose award opened a draft contract, with its posting; None where none did."""
    return session.scalar(
        select(Bid)
        .join(Posting, Posting.awarded_bid_id == Bid.id)
        .where(Posting.contract_id == contract_id)
        .options(joinedload(Bid.posting))
    )


def sent_bids(session: Session, posting_id: UUID) -> Sequence[Bid]:
    """Return the bids on a posting that were sent and not withdrawn, the first sent first."""
    return session.scalars(
        select(Bid)
        .where(Bid.posting_id == posting_id, Bid.state == BidState.SENT)
        .options(joinedload(Bid.designer))
        .order_by(Bid.sent_at)
        .limit(MAX_BIDS)
    ).all()


class WaitingPosting(NamedTuple):
    """A posting that is not awarded: what came in for the team to act on, and since when."""

    id: UUID
    title: str
    state: PostingState
    opened_at: datetime | None
    bids: int
    first_bid_at: datetime | None
    questions: int  # without an answer
    first_asked_at: datetime | None


def waiting_postings(session: Session, project_id: UUID) -> list[WaitingPosting]:
    """Return the postings of a project that are open or closed and not awarded, the oldest first."""
    sent = (
        select(Bid.posting_id, func.count().label("count"), func.min(Bid.sent_at).label("since"))
        .where(Bid.project_id == project_id, Bid.state == BidState.SENT)
        .group_by(Bid.posting_id)
        .subquery()
    )
    asked = (
        select(
            PostingQuestion.posting_id, func.count().label("count"), func.min(PostingQuestion.asked_at).label("since")
        )
        .where(PostingQuestion.project_id == project_id, PostingQuestion.answered_at.is_(None))
        .group_by(PostingQuestion.posting_id)
        .subquery()
    )
    rows = session.execute(
        select(
            *(Posting.id, Posting.title, Posting.state, Posting.opened_at),
            *(func.coalesce(sent.c.count, 0), sent.c.since, func.coalesce(asked.c.count, 0), asked.c.since),
        )
        .outerjoin(sent, sent.c.posting_id == Posting.id)
        .outerjoin(asked, asked.c.posting_id == Posting.id)
        .where(Posting.project_id == project_id, Posting.state.in_((PostingState.OPEN, PostingState.CLOSED)))
        .order_by(Posting.id)
        .limit(MAX_POSTINGS)
    )
    return [WaitingPosting(*row) for row in rows]


def counts_of_bids(session: Session, posting_ids: Collection[UUID]) -> dict[UUID, int]:
    """Return the number of sent bids of each posting."""
    counted = (
        select(Bid.posting_id, func.count())
        .where(Bid.posting_id.in_(posting_ids), Bid.state == BidState.SENT)
        .group_by(Bid.posting_id)
    )
    return dict(session.execute(counted).all())


def own_bids(session: Session, designer_id: UUID, posting_ids: Collection[UUID]) -> dict[UUID, Bid]:
    """Return a designer's own bids by posting."""
    query = select(Bid).where(Bid.designer_id == designer_id, Bid.posting_id.in_(posting_ids))
    return {bid.posting_id: bid for bid in session.scalars(query)}


def other_sent_bids(session: Session, designer_id: UUID, posting_id: UUID) -> Sequence[Bid]:
    """Return a designer's offers elsewhere that were not refused, with the postings."""
    lost = Posting.awarded_bid_id.is_not(None) & (Posting.awarded_bid_id != Bid.id)
    return session.scalars(
        select(Bid)
        .join(Bid.posting)
        .where(Bid.designer_id == designer_id, Bid.posting_id != posting_id, Bid.state == BidState.SENT, ~lost)
        .options(joinedload(Bid.posting))
        .order_by(Bid.sent_at)
        .limit(MAX_BIDS)
    ).all()


def questions_of(session: Session, posting_id: UUID) -> Sequence[PostingQuestion]:
    """Return the questions on a posting, the oldest first."""
    return session.scalars(
        select(PostingQuestion)
        .where(PostingQuestion.posting_id == posting_id)
        .options(joinedload(PostingQuestion.asker))
        .order_by(PostingQuestion.id)
        .limit(MAX_QUESTIONS)
    ).all()


def question_for(session: Session, actor: Actor, question_id: UUID) -> PostingQuestion | None:
    """Return a question that was asked of one of the caller's studios, or by the caller."""
    return session.scalar(
        select(PostingQuestion)
        .where(
            PostingQuestion.id == question_id,
            or_(PostingQuestion.studio_id.in_(actor.roles), PostingQuestion.asked_by == actor.person),
        )
        .options(joinedload(PostingQuestion.asker))
        .execution_options(populate_existing=True)
    )


def scores_of(session: Session, bid_ids: Collection[UUID]) -> Sequence[Score]:
    """Return the scores that people of the team gave bids."""
    return session.scalars(
        select(Score).where(Score.bid_id.in_(bid_ids)).options(joinedload(Score.person)).order_by(Score.changed_at)
    ).all()


def notes_of(session: Session, bid_ids: Collection[UUID]) -> Sequence[BidNote]:
    """Return the notes of the team on bids with their authors, the newest day first."""
    return session.scalars(
        select(BidNote)
        .where(BidNote.bid_id.in_(bid_ids))
        .options(joinedload(BidNote.author))
        .order_by(BidNote.held_on.desc(), BidNote.id.desc())
    ).all()


def own_note(session: Session, note_id: UUID, person_id: UUID) -> BidNote | None:
    """Return a note on a bid by its author."""
    return session.scalar(select(BidNote).where(BidNote.id == note_id, BidNote.written_by == person_id))


def lock_posting(session: Session, posting_id: UUID) -> None:
    """Lock a posting until the transaction ends."""
    session.execute(select(Posting.id).where(Posting.id == posting_id).with_for_update(key_share=True))
