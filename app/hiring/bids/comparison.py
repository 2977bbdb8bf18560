"""Bids side by side: the same lines, the team's scores, the shortlist, the award."""

from collections.abc import Mapping, Sequence
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.core import clock
from app.hiring import queries
from app.hiring.errors import BidNoteNotFound, WrongPostingState
from app.hiring.models import Bid, BidNote, Posting, Score
from app.hiring.postings.access import bid_for_team, posting_access, posting_for_team
from app.hiring.rules import PostingState, ensure_scores_fit, place_of
from app.hiring.schemas import BidNoteWrite
from app.projects.service import project_access


def compared_bids(session: Session, actor: Actor, posting_id: UUID) -> tuple[Posting, Sequence[Bid]]:
    """Return a posting and its sent bids: those shortlisted first, then the first sent first."""
    access = posting_access(session, actor, posting_id)
    access.ensure_team()
    bids = queries.sent_bids(session, posting_id)
    dated = [(place_of(is_shortlisted=bid.is_shortlisted, sent_at=bid.sent_at), bid) for bid in bids if bid.sent_at]
    return access.posting, [bid for _, bid in sorted(dated, key=lambda pair: pair[0])]


def scores_seen(
    session: Session, actor: Actor, posting: Posting, bids: Sequence[Bid]
) -> Mapping[UUID, tuple[Score | None, Sequence[Score] | None, int]]:
    """Return for each bid the caller's scores, the others' once the caller has given all of theirs, and how many."""
    by_bid: dict[UUID, list[Score]] = {bid.id: [] for bid in bids}
    for score in queries.scores_of(session, list(by_bid)):
        by_bid[score.bid_id].append(score)
    seen: dict[UUID, tuple[Score | None, Sequence[Score] | None, int]] = {}
    for bid_id, scores in by_bid.items():
        own = next((known_score for known_score in scores if known_score.person_id == actor.person), None)
        is_whole = own is not None and set(posting.headings) <= own.scores.keys()
        others = [other_score for other_score in scores if other_score.person_id != actor.person] if is_whole else None
        seen[bid_id] = (own, others, len(scores))
    return seen


def shortlist(session: Session, actor: Actor, bid_id: UUID, *, is_shortlisted: bool) -> UUID:
    """Put a bid on the shortlist or take it off; return its posting."""
    bid = bid_for_team(session, actor, bid_id)
    bid.is_shortlisted = is_shortlisted
    session.flush()
    return bid.posting_id


def score(session: Session, actor: Actor, bid_id: UUID, scores: Mapping[str, int], note: str) -> UUID:
    """Keep the caller's scores for a bid, and return its posting; giving again replaces them."""
    bid = bid_for_team(session, actor, bid_id)
    ensure_scores_fit(bid.posting.headings, scores)
    queries.lock_posting(session, bid.posting_id)
    own = session.get(Score, (bid.id, actor.person))
    if own is None:
        own = Score(bid_id=bid.id, person_id=actor.person, studio_id=bid.studio_id, project_id=bid.project_id)
        session.add(own)
    own.scores, own.note, own.changed_at = dict(scores), note, clock.now()
    session.flush()
    return bid.posting_id


def add_note(session: Session, actor: Actor, bid_id: UUID, note: BidNoteWrite) -> UUID:
    """Keep a note of a call, an interview or otherwise on a bid, and return its posting."""
    bid = bid_for_team(session, actor, bid_id)
    session.add(
        BidNote(
            studio_id=bid.studio_id,
            project_id=bid.project_id,
            bid_id=bid.id,
            kind=note.kind,
            held_on=note.held_on,
            text=note.text,
            written_by=actor.person,
        )
    )
    session.flush()
    return bid.posting_id


def remove_note(session: Session, actor: Actor, bid_id: UUID, note_id: UUID) -> UUID:
    """Remove a note of the caller's own on a bid, and return its posting; raise BidNoteNotFound for any other."""
    bid = bid_for_team(session, actor, bid_id)
    note = queries.own_note(session, note_id, actor.person)
    if note is None or note.bid_id != bid_id:
        raise BidNoteNotFound(f"no note {note_id} of yours")
    session.delete(note)
    session.flush()
    return bid.posting_id


def award_bid(session: Session, actor: Actor, bid_id: UUID) -> Bid:
    """Award a posting to one of its bids, once; only a producer does."""
    bid = bid_for_team(session, actor, bid_id)
    project_access(session, actor, bid.project_id).ensure_producer()
    posting = posting_for_team(session, actor, bid.posting_id)
    if posting.state not in (PostingState.OPEN, PostingState.CLOSED):
        raise WrongPostingState(f"this posting is {posting.state.value}")
    posting.state, posting.awarded_bid_id, posting.awarded_at = PostingState.AWARDED, bid.id, clock.now()
    posting.closed_at = posting.closed_at or clock.now()
    posting.revision += 1
    session.flush()
    return bid


def may_award(session: Session, actor: Actor, posting: Posting) -> bool:
    """Whether the caller may award a posting now."""
    is_undecided = posting.state in (PostingState.OPEN, PostingState.CLOSED)
    return is_undecided and project_access(session, actor, posting.project_id).is_producer


def record_contract(session: Session, posting: Posting, contract_id: UUID) -> None:
    """Keep the draft contract that an award opened."""
    posting.contract_id = contract_id
    session.flush()
