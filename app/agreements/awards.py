"""An award opens a draft contract with the figures of the bid."""

from collections.abc import Sequence
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.agreements.lifecycle import create_contract
from app.agreements.models import Contract
from app.agreements.plan import PlannedCue, PlannedMilestone, save_plan
from app.agreements.rules import ContractKind
from app.hiring.comparison import award_bid, record_contract
from app.hiring.models import Bid, Posting
from app.hiring.postings import asked_cue_ids
from app.hiring.rules import BidLineKind, PostingPhase, amount_minor
from app.hiring.schemas import BidContent
from app.kit.events import publish
from app.projects.engagements import engage
from app.projects.rules import EngagementKind


def award(session: Session, actor: Actor, bid_id: UUID) -> Contract:
    """Award a posting to a bid: engage its designer, and begin a draft with the bid's lines as milestones."""
    bid = award_bid(session, actor, bid_id)
    posting = bid.posting
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
    save_plan(session, actor, contract.id, _plan(session, posting, bid))
    record_contract(session, posting, contract.id)
    publish(session, "posting.awarded", studio_id=posting.studio_id, project_id=posting.project_id, bid_id=bid.id)
    return contract


def _plan(session: Session, posting: Posting, bid: Bid) -> list[PlannedMilestone]:
    content = BidContent.model_validate(bid.sent)
    lines: Sequence[dict[str, Any]] = (bid.sent or {})["lines"]
    labels = {line["key"]: line["label"] for line in posting.lines}
    due_on = content.to_on or posting.work_to_on
    asked = [
        PlannedMilestone(
            labels[line["key"]],
            amount_minor(line),
            due_on,
            cues=[PlannedCue(cue_id) for cue_id in asked_cue_ids(session, posting, [line["key"]])],
        )
        for line in lines
        if line["kind"] == BidLineKind.ASKED and line["key"] in labels
    ]
    extras = [
        PlannedMilestone(line["key"] or line["kind"].capitalize(), amount_minor(line), due_on)
        for line in lines
        if line["kind"] != BidLineKind.ASKED
    ]
    return asked + extras
