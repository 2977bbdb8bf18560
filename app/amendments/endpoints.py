"""The endpoints of what changes an agreed contract."""

from typing import Annotated
from uuid import UUID

from fastapi import APIRouter, Depends, Path, Response

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.agreements.drafts.documents import PDF
from app.agreements.errors import (
    ContractNotFound,
    NotYourContract,
)
from app.agreements.signing.endpoints import SIGNING, signature_sent
from app.agreements.signing.service import SignatureRequest
from app.amendments import change_orders, ending, schemas
from app.amendments.errors import (
    AlreadyEnded,
    BadChangeOrder,
    ChangeOrderClosed,
    ChangeOrderNotFound,
    ChangeOrderStale,
    NoNotice,
    NoticeGiven,
    NoticeTooShort,
    NotInForce,
    NotOwnChangeOrder,
    OfferSettled,
    OwnChangeOrder,
)
from app.core.typesetting import DocumentTooLarge, TypesettingBusy
from app.core.web.downloads import downloads, file_response
from app.core.web.http import DbSession, problems

router = APIRouter(prefix="/v1", tags=["amendments"])
OrderNumber = Annotated[int, Path(ge=1, le=2**31 - 1)]
ORDER_REFUSALS = (ContractNotFound, NotYourContract, ChangeOrderNotFound, ChangeOrderClosed)


@router.get("/contracts/{contract_id}/ending", responses=problems(ContractNotFound))
def read_ending(contract_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> schemas.EndingRead:
    """Return the outcome of a contract's early end: a forecast, the statement of a notice, or the settlement."""
    return ending.ending(session, actor, contract_id)


@router.post(
    "/contracts/{contract_id}/ending/notice",
    responses=problems(ContractNotFound, NotYourContract, AlreadyEnded, NoticeGiven, NoticeTooShort),
)
def give_notice(
    contract_id: UUID, body: schemas.NoticeAdd, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> schemas.EndingRead:
    """Give notice for the caller's party."""
    ending.give_notice(session, actor, contract_id, reason=body.reason, ends_on=body.ends_on)
    return ending.ending(session, actor, contract_id)


@router.post(
    "/contracts/{contract_id}/ending/withdraw",
    responses=problems(ContractNotFound, NotYourContract, AlreadyEnded, NoNotice),
)
def withdraw_notice(
    contract_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> schemas.EndingRead:
    """Take a notice back, as the party that gave it."""
    ending.withdraw_notice(session, actor, contract_id)
    return ending.ending(session, actor, contract_id)


@router.post(
    "/contracts/{contract_id}/ending/agree",
    responses=problems(ContractNotFound, NotYourContract, AlreadyEnded, NoNotice, *SIGNING),
)
def agree_to_statement(
    contract_id: UUID,
    actor: Annotated[Actor, allows(Audience.PROJECT)],
    signature: Annotated[SignatureRequest, Depends(signature_sent)],
    session: DbSession,
) -> schemas.EndingRead:
    """Say yes to the statement for the caller's party; with the second yes the contract is settled and ends."""
    ending.agree_to_statement(session, actor, contract_id, signature)
    return ending.ending(session, actor, contract_id)


@router.get(
    "/contracts/{contract_id}/ending/statement.pdf",
    **downloads(PDF, ContractNotFound, NoNotice, DocumentTooLarge, TypesettingBusy),
)
def download_statement(contract_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> Response:
    """Return the statement with its signatures as PDF; the same text and signatures are the same bytes."""
    pdf = ending.statement_pdf(session, actor, contract_id)
    return file_response(pdf.content, PDF, "settlement.pdf")


@router.get("/contracts/{contract_id}/change-orders", responses=problems(ContractNotFound))
def list_change_orders(
    contract_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> schemas.ChangeOrdersRead:
    """Return the change orders of a contract, the oldest first, and what one may name."""
    return change_orders.change_orders(session, actor, contract_id)


@router.post(
    "/contracts/{contract_id}/change-orders",
    status_code=201,
    responses=problems(ContractNotFound, NotYourContract, NotInForce, BadChangeOrder),
)
def propose_change_order(
    contract_id: UUID, body: schemas.ChangeOrderAdd, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> schemas.ChangeOrdersRead:
    """Propose a change order for the caller's party."""
    change_orders.propose(session, actor, contract_id, body)
    return change_orders.change_orders(session, actor, contract_id)


@router.post(
    "/contracts/{contract_id}/change-order-preview", responses=problems(ContractNotFound, NotYourContract, NotInForce)
)
def preview_change_order(
    contract_id: UUID, body: schemas.ChangesSet, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> schemas.ChangePreview:
    """Return the effects of changes on scope, price and dates; nothing is saved."""
    return change_orders.preview(session, actor, contract_id, body.changes)


@router.post(
    "/contracts/{contract_id}/change-offers/dismiss",
    responses=problems(ContractNotFound, NotYourContract, NotInForce, OfferSettled),
)
def dismiss_change_offer(
    contract_id: UUID, body: schemas.OfferDismiss, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> schemas.ChangeOrdersRead:
    """Dismiss an offered change order for the caller's party; the record keeps the reason."""
    change_orders.dismiss_offer(session, actor, contract_id, body.offer, reason=body.reason)
    return change_orders.change_orders(session, actor, contract_id)


@router.post(
    "/contracts/{contract_id}/change-orders/{change_order_number}/accept",
    responses=problems(*ORDER_REFUSALS, NotInForce, ChangeOrderStale, *SIGNING),
)
def accept_change_order(
    contract_id: UUID,
    change_order_number: OrderNumber,
    actor: Annotated[Actor, allows(Audience.PROJECT)],
    signature: Annotated[SignatureRequest, Depends(signature_sent)],
    session: DbSession,
) -> schemas.ChangeOrdersRead:
    """Say yes to a change order for the caller's party; with the second yes it is in force."""
    change_orders.accept(session, actor, contract_id, change_order_number, signature)
    return change_orders.change_orders(session, actor, contract_id)


@router.post(
    "/contracts/{contract_id}/change-orders/{change_order_number}/refuse",
    responses=problems(*ORDER_REFUSALS, OwnChangeOrder),
)
def refuse_change_order(
    contract_id: UUID,
    change_order_number: OrderNumber,
    body: schemas.ReasonGiven,
    session: DbSession,
    actor: Actor = allows(Audience.PROJECT),
) -> schemas.ChangeOrdersRead:
    """Refuse a change order that the other party proposed."""
    change_orders.refuse(session, actor, contract_id, change_order_number, reason=body.reason)
    return change_orders.change_orders(session, actor, contract_id)


@router.post(
    "/contracts/{contract_id}/change-orders/{change_order_number}/withdraw",
    responses=problems(*ORDER_REFUSALS, NotOwnChangeOrder),
)
def withdraw_change_order(
    contract_id: UUID,
    change_order_number: OrderNumber,
    body: schemas.ReasonGiven,
    session: DbSession,
    actor: Actor = allows(Audience.PROJECT),
) -> schemas.ChangeOrdersRead:
    """Take back a change order that the caller's party proposed."""
    change_orders.withdraw(session, actor, contract_id, change_order_number, reason=body.reason)
    return change_orders.change_orders(session, actor, contract_id)


@router.get(
    "/contracts/{contract_id}/change-orders/{change_order_number}/change-order.pdf",
    **downloads(PDF, ContractNotFound, ChangeOrderNotFound, DocumentTooLarge, TypesettingBusy),
)
def download_change_order(
    contract_id: UUID, change_order_number: OrderNumber, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> Response:
    """Return a change order with its signatures as PDF; the same text and signatures are the same bytes."""
    pdf = change_orders.change_order_pdf(session, actor, contract_id, change_order_number)
    return file_response(pdf.content, PDF, f"change order {change_order_number}.pdf")
