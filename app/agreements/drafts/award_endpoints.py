"""The endpoint that awards a posting and opens a draft contract."""

from uuid import UUID

from fastapi import APIRouter

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.agreements.drafts.awards import award
from app.agreements.errors import NoContractNeeded, SamePersonOnBothSides
from app.core.web.http import DbSession, problems
from app.hiring.errors import BidNotFound, BidNotSent, WrongPostingState
from app.hiring.schemas import PostingAwarded
from app.projects.errors import ProducerNeeded, TeamNeeded

router = APIRouter(prefix="/v1", tags=["postings"])


@router.post(
    "/bids/{bid_id}/award",
    status_code=201,
    responses=problems(
        BidNotFound, TeamNeeded, ProducerNeeded, BidNotSent, WrongPostingState, NoContractNeeded, SamePersonOnBothSides
    ),
)
def award_posting(bid_id: UUID, session: DbSession, actor: Actor = allows(Audience.PRODUCER)) -> PostingAwarded:
    """Award a posting to a bid: its designer is engaged, a draft contract is opened, and the others are thanked."""
    awarded = award(session, actor, bid_id)
    contract = awarded.contract
    return PostingAwarded(contract_id=contract.id, project_id=contract.project_id, is_on_roster=awarded.is_on_roster)
