"""Postings, bids and comparisons as each caller may see them."""

from collections.abc import Sequence
from datetime import date
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.queries import has_account
from app.accounts.rules import Actor
from app.accounts.schemas import PersonBrief
from app.hiring import queries
from app.hiring.bids import comparison
from app.hiring.bids import service as bids
from app.hiring.bids.samples import samples_read
from app.hiring.models import Bid, Candidate, Posting, Score
from app.hiring.postings.access import PostingAccess, today_of
from app.hiring.postings.service import posting_seen
from app.hiring.roster.rules import Busy, clashes
from app.hiring.roster.service import entries_of_bidders, is_full
from app.hiring.rules import amount_minor, concept_minor, hourly_rate_minor, missing_lines, takes_bids, total_minor
from app.hiring.schemas import (
    AskedLine,
    BidComparison,
    BidContent,
    BidNoteRead,
    BusyRangeWrite,
    CandidateRead,
    Clash,
    ComparedBid,
    OwnBidRead,
    PersonScores,
    PostingPreview,
    PostingQuestionRead,
    PostingRead,
    PostingSummary,
)

_HEAD = ("title", "phase", "state", "bids_until_on", "work_from_on", "work_to_on")


def _head(posting: Posting) -> dict[str, Any]:
    return {name: getattr(posting, name) for name in _HEAD} | {
        "studio_name": posting.project.studio.name,
        "takes_bids": takes_bids(posting.state, posting.bids_until_on, today_of(posting)),
    }


def summary(posting: Posting, *, sent: int | None, own: Bid | None, is_closed: bool = False) -> PostingSummary:
    """Return a posting as a list shows it; `is_closed`: an NDA keeps the project's name from the caller."""
    return PostingSummary(
        **_head(posting),
        id=posting.id,
        project_id=posting.project_id,
        project_name="" if is_closed else posting.project.name,
        bids=sent,
        own_bid=own.state if own else None,
    )


def preview(
    session: Session, posting: Posting, candidate: Candidate | None, *, is_closed: bool, sends_mail: bool
) -> PostingPreview:
    """Return a posting as its link shows it; `is_closed`: an NDA comes first."""
    return PostingPreview(
        **_head(posting),
        email=candidate.email if candidate else None,
        has_account=candidate is not None and has_account(session, candidate.email),
        sends_mail=sends_mail,
        nda_needed=is_closed,
        project_name="" if is_closed else posting.project.name,
        text="" if is_closed else posting.text,
        currency=posting.currency,
        price_minor=None if is_closed else posting.price_minor,
        budget_minor=posting.budget_minor if posting.is_budget_shown and not is_closed else None,
        lines=[] if is_closed else [AskedLine.model_validate(line) for line in posting.lines],
    )


def posting_read(session: Session, actor: Actor, posting_id: UUID) -> PostingRead:
    """Return a posting as the caller may see it."""
    access = posting_seen(session, actor, posting_id)
    posting, is_team, is_closed = access.posting, access.team is not None, access.nda_open
    own = None if is_team else queries.own_bid(session, posting_id, actor.person)
    shows_budget = is_team or (posting.is_budget_shown and not is_closed)
    return PostingRead(
        **_head(posting),
        id=posting.id,
        project_id=posting.project_id,
        project_name="" if is_closed else posting.project.name,
        revision=posting.revision,
        currency=posting.currency,
        nda_open=is_closed,
        is_team=is_team,
        text="" if is_closed else posting.text,
        equipment="" if is_closed else posting.equipment,
        price_minor=None if is_closed else posting.price_minor,
        budget_minor=posting.budget_minor if shows_budget else None,
        is_budget_shown=posting.is_budget_shown,
        rate_floor_minor=posting.rate_floor_minor if is_team else None,
        scope=posting.scope,
        categories=[] if is_closed else posting.categories,
        cue_ids=[UUID(cue_id_) for cue_id_ in posting.cue_ids] if is_team else [],
        lines=[] if is_closed else [AskedLine.model_validate(line) for line in posting.lines],
        headings=posting.headings if is_team else [],
        has_link=is_team and posting.secret_sha256 is not None,
        candidates=_candidates(session, posting_id) if is_team else [],
        questions=[] if is_closed else _questions(session, access),
        bids=queries.counts_of_bids(session, [posting_id]).get(posting_id, 0) if is_team else None,
        own_bid=_own_bid(session, posting, own) if own else None,
        clashes=[] if is_team else _clashes(session, access),
        opened_at=posting.opened_at,
        closed_at=posting.closed_at,
        awarded_at=posting.awarded_at,
        contract_id=posting.contract_id if is_team else None,
    )


def _candidates(session: Session, posting_id: UUID) -> list[CandidateRead]:
    return [
        CandidateRead(
            id=candidate.id,
            email=candidate.email,
            person=PersonBrief.model_validate(candidate.person) if candidate.person else None,
            is_invited=candidate.invited_by is not None,
            joined_at=candidate.joined_at,
            created_at=candidate.created_at,
        )
        for candidate in queries.candidates_of(session, posting_id)
    ]


def _questions(session: Session, access: PostingAccess) -> list[PostingQuestionRead]:
    is_team = access.team is not None
    return [
        PostingQuestionRead(
            id=question.id,
            text=question.text,
            asked_by=PersonBrief.model_validate(question.asker)
            if is_team or question.asked_by == access.actor.person
            else None,
            asked_at=question.asked_at,
            answer=question.answer,
            is_for_all=question.is_for_all,
            answered_at=question.answered_at,
        )
        for question in bids.questions_seen(session, access)
    ]


def _own_bid(session: Session, posting: Posting, bid: Bid) -> OwnBidRead:
    return OwnBidRead(
        id=bid.id,
        state=bid.state,
        revision=bid.revision,
        content=BidContent.model_validate(bid.content),
        total_minor=total_minor(bid.content["lines"]),
        concept_minor=concept_minor(posting.lines, bid.content["lines"]),
        missing=missing_lines(posting.lines, bid.content["lines"]),
        sent_at=bid.sent_at,
        resent_at=bid.resent_at,
        differs=bid.sent is not None and bid.sent != bid.content,
        is_awarded=bids.is_awarded(posting, bid),
        samples=samples_read(posting, bid, queries.samples_of(session, [bid.id])),
    )


def _clashes(session: Session, access: PostingAccess) -> list[Clash]:
    return [
        Clash(
            title=clash.posting.title,
            is_awarded=bids.is_awarded(clash.posting, clash.bid),
            from_on=clash.posting.work_from_on,
            to_on=clash.posting.work_to_on,
        )
        for clash in bids.clashes(session, access)
        if clash.posting.work_from_on and clash.posting.work_to_on
    ]


def _scores(score: Score) -> PersonScores:
    return PersonScores(person=PersonBrief.model_validate(score.person), scores=score.scores, note=score.note)


def _busy_in(
    busy: Sequence[Busy], days: tuple[date | None, date | None], available_from_on: date | None
) -> list[BusyRangeWrite]:
    return [BusyRangeWrite(**vars(clash)) for clash in clashes(busy, *days, available_from_on)]


def comparison_read(session: Session, actor: Actor, posting_id: UUID) -> BidComparison:
    """Return the bids of a posting on the same lines."""
    posting, sent = comparison.compared_bids(session, actor, posting_id)
    scores = comparison.scores_seen(session, actor, posting, sent)
    proven = [bid.designer.email for bid in sent if bid.designer.email_proof is not None]
    on_file = entries_of_bidders(session, actor, posting.studio_id, proven)
    samples = queries.samples_of(session, [bid.id for bid in sent])
    notes = queries.notes_of(session, [bid.id for bid in sent])
    compared = []
    for bid in sent:
        entry, busy = on_file.get(bid.designer.email, (None, []))
        content = BidContent.model_validate(bid.sent)
        lines = (bid.sent or {})["lines"]
        whole = total_minor(lines)
        rate = hourly_rate_minor(whole, content.hours_hundredths)
        own, others, count = scores[bid.id]
        late = (content.to_on - posting.work_to_on).days if content.to_on and posting.work_to_on else None
        compared.append(
            ComparedBid(
                id=bid.id,
                designer=PersonBrief.model_validate(bid.designer),
                is_shortlisted=bid.is_shortlisted,
                sent_at=bid.sent_at,
                resent_at=bid.resent_at,
                content=content,
                amounts_minor=[amount_minor(line) for line in lines],
                total_minor=whole,
                concept_minor=concept_minor(posting.lines, lines),
                missing=missing_lines(posting.lines, lines),
                hourly_rate_minor=rate,
                is_below_floor=rate is not None
                and posting.rate_floor_minor is not None
                and rate < posting.rate_floor_minor,
                over_budget_minor=whole - posting.budget_minor if posting.budget_minor is not None else None,
                days_late=late if late is not None and late > 0 else None,
                roster_entry_id=entry.id if entry else None,
                busy=_busy_in(
                    busy,
                    (content.from_on or posting.work_from_on, content.to_on or posting.work_to_on),
                    entry.available_from_on if entry else None,
                ),
                samples=samples_read(posting, bid, [sample for sample in samples if sample.bid_id == bid.id]),
                notes=[BidNoteRead.model_validate(note) for note in notes if note.bid_id == bid.id],
                own_scores=_scores(own) if own else None,
                others=[_scores(other) for other in others] if others is not None else None,
                scored_by=count,
            )
        )
    bidders = {bid.designer_id for bid in sent}
    return BidComparison(
        posting_id=posting.id,
        title=posting.title,
        state=posting.state,
        currency=posting.currency,
        budget_minor=posting.budget_minor,
        rate_floor_minor=posting.rate_floor_minor,
        work_from_on=posting.work_from_on,
        work_to_on=posting.work_to_on,
        headings=posting.headings,
        lines=[AskedLine.model_validate(line) for line in posting.lines],
        bids=compared,
        awarded_bid_id=posting.awarded_bid_id,
        contract_id=posting.contract_id,
        may_award=comparison.may_award(session, actor, posting),
        is_roster_full=is_full(session, posting.studio_id),
        pending=[
            candidate.person.name if candidate.person else candidate.email
            for candidate in queries.candidates_of(session, posting_id)
            if candidate.person_id not in bidders
        ],
    )
