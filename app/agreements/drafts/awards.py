"""An award opens a draft contract with the figures of the bid."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.agreements.drafts.lifecycle import create_contract
from app.agreements.models import Contract
from app.agreements.plan.amounts import split
from app.agreements.plan.planned import PlannedCue, PlannedMilestone
from app.agreements.plan.proposal import DEPOSIT_BP, WantedCue, propose_milestones
from app.agreements.plan.queries import today_of
from app.agreements.plan.service import save_plan
from app.agreements.rules import ContractKind
from app.core.events import publish
from app.core.money import BASIS_POINTS
from app.hiring.bids.comparison import award_bid, record_contract
from app.hiring.models import Bid, Posting
from app.hiring.postings.service import asked_cue_ids
from app.hiring.roster.service import keep_on_roster
from app.hiring.rules import BidLineKind, PostingPhase, amount_minor, total_minor
from app.hiring.schemas import BidContent
from app.projects.engagements import engage
from app.projects.rules import EngagementKind


@dataclass(frozen=True)
class Award:
    """The draft contract of an award, and whether the designer is on the studio's roster now."""

    contract: Contract
    is_on_roster: bool


def award(session: Session, actor: Actor, bid_id: UUID) -> Award:
    """Award a posting: engage the designer, keep them on the roster, begin a draft with the bid's lines."""
    bid = award_bid(session, actor, bid_id)
    posting = bid.posting
    is_on_roster = keep_on_roster(session, actor, posting.studio_id, bid.designer_id)
    kind = EngagementKind.ADVISORY if posting.phase is PostingPhase.ADVISORY else EngagementKind.CONTRACT
    engagement = engage(
        session, studio_id=posting.studio_id, project_id=posting.project_id, designer=bid.designer, kind=kind
    )
    contract = create_contract(
        session,
        actor,
        posting.project_id,
        engagement_id=engagement.id,
        kind=ContractKind.SINGLE,
        title=posting.title,
        currency=posting.currency,
    )
    save_plan(session, actor, contract.id, _plan(session, contract, posting, bid))
    record_contract(session, posting, contract.id)
    publish(session, "posting.awarded", studio_id=posting.studio_id, project_id=posting.project_id, bid_id=bid.id)
    return Award(contract, is_on_roster)


def _plan(session: Session, contract: Contract, posting: Posting, bid: Bid) -> list[PlannedMilestone]:
    """Return the plan that a bid leads to: its whole price with the deposit in it, in parts over the time of the work.

    A cue weighs what its line offers for it. Lines without a cue, such as voice or direction, are in the price.
    """
    content = BidContent.model_validate(bid.sent)
    lines: Sequence[dict[str, Any]] = (bid.sent or {})["lines"]
    labels = {line["key"]: line["label"] for line in posting.lines}
    cues: list[WantedCue] = []
    for line in lines:
        if line["kind"] == BidLineKind.ASKED and line["key"] in labels:
            cue_ids = asked_cue_ids(session, posting, [line["key"]])
            weight = amount_minor(line) // max(len(cue_ids), 1)
            cues += [WantedCue(cue_id, labels[line["key"]], None, weight) for cue_id in cue_ids]
    begins_on = content.from_on or posting.work_from_on
    ends_on = content.to_on or posting.work_to_on
    whole_minor = total_minor(lines)
    if not cues:  # nothing of the list is asked for: a deposit and the rest
        deposit_minor = math.ceil(whole_minor * DEPOSIT_BP / BASIS_POINTS)
        rest = PlannedMilestone(posting.title, whole_minor - deposit_minor, ends_on)
        return [PlannedMilestone("Deposit", deposit_minor, None, is_deposit=True), rest]
    weights = {cue.cue_id: cue.weight for cue in cues}
    proposed = propose_milestones(
        cues,
        today=today_of(session, contract),
        begins_on=begins_on,
        ends_on=ends_on,
        total_minor=whole_minor,
        deposit_bp=DEPOSIT_BP,
    )
    return [
        PlannedMilestone(
            milestone.name,
            milestone.amount_minor,
            milestone.due_on,
            is_deposit=milestone.is_deposit,
            cues=_priced(milestone.cue_ids, milestone.amount_minor or 0, weights),
        )
        for milestone in proposed
    ]


def _priced(cue_ids: Sequence[UUID], amount: int, weights: Mapping[UUID, int]) -> list[PlannedCue]:
    """Return the cues of a part with their prices, which add up to what it pays."""
    if not cue_ids:
        return []
    shares = split(amount, [weights[cue_id] for cue_id in cue_ids])
    return [PlannedCue(cue_id, price_minor) for cue_id, price_minor in zip(cue_ids, shares, strict=True)]
