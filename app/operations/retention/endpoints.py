"""The endpoints of the retention of masters."""

from uuid import UUID

from fastapi import APIRouter

from app.accounts.errors import ProducerNeeded
from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.agreements.errors import ContractNotFound, SamePersonOnBothSides
from app.core.web.http import DbSession, problems
from app.operations.retention import service as retention
from app.operations.schemas import MasterRetentionRead, MasterRetentionSet

router = APIRouter(prefix="/v1/contracts/{contract_id}/master-retention", tags=["erasure"])


@router.get("", responses=problems(ContractNotFound))
def read_master_retention(
    contract_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> MasterRetentionRead:
    """Return the retention of the masters that a contract's designer delivered in its project."""
    return retention.read_retention(session, actor, contract_id)


@router.put("", responses=problems(ContractNotFound, ProducerNeeded, SamePersonOnBothSides))
def set_master_retention(
    contract_id: UUID, body: MasterRetentionSet, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> MasterRetentionRead:
    """Keep masters longer than the contracts ask, or no longer; the contracts' records name who did."""
    return retention.set_kept_longer(session, actor, contract_id, keep=body.keep)
