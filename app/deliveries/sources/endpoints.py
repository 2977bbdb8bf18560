"""The endpoints of what takes were made from."""

from uuid import UUID

from fastapi import APIRouter

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.web.http import DbSession, problems
from app.deliveries.errors import DeliveryNotFound, NoSourceNamed, OwnDesignerNeeded, SourcesFixed, TakeNotFound
from app.deliveries.schemas import DeliverySources, Sources, TakeSources
from app.deliveries.sources import service as sources
from app.projects.errors import DesignerNeeded

router = APIRouter()


@router.get("/deliveries/{delivery_id}/sources", response_model=DeliverySources, responses=problems(DeliveryNotFound))
def see_delivery_sources(
    delivery_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> DeliverySources:
    """Show the sources of a delivery; its designer also sees their last statement."""
    return sources.delivery_sources(session, actor, delivery_id)


@router.put(
    "/deliveries/{delivery_id}/sources",
    response_model=DeliverySources,
    responses=problems(DeliveryNotFound, DesignerNeeded, NoSourceNamed),
)
def state_delivery_sources(
    delivery_id: UUID, body: Sources, session: DbSession, actor: Actor = allows(Audience.DESIGNER)
) -> DeliverySources:
    """State the sources of the takes of a delivery; a take can have a statement of its own."""
    return sources.state_delivery_sources(session, actor, delivery_id, body)


@router.get("/takes/{take_id}/sources", response_model=TakeSources, responses=problems(TakeNotFound))
def see_take_sources(take_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> TakeSources:
    """Show the sources of a take."""
    return sources.take_sources(session, actor, take_id)


@router.put(
    "/takes/{take_id}/sources",
    response_model=TakeSources,
    responses=problems(TakeNotFound, OwnDesignerNeeded, SourcesFixed, NoSourceNamed),
)
def state_take_sources(
    take_id: UUID, body: Sources, session: DbSession, actor: Actor = allows(Audience.DESIGNER)
) -> TakeSources:
    """State the sources of one take; once it is approved and nothing is open, that is final."""
    return sources.state_take_sources(session, actor, take_id, body)
