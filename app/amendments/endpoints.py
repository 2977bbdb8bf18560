"""The endpoints of what changes an agreed contract."""

from typing import Any
from uuid import UUID

from fastapi import Request, Response

from app.accounts.policies import allows, client_address
from app.accounts.rules import Actor, Audience
from app.agreements.documents import PDF
from app.agreements.errors import (
    AddressNotProven,
    AlreadyAccepted,
    ContractNotFound,
    NotYourContract,
    SamePersonOnBothSides,
    TextChanged,
)
from app.agreements.schemas import AcceptAdd
from app.agreements.template_endpoints import attachment
from app.amendments import ending, schemas
from app.amendments.errors import AlreadyEnded, NoNotice, NoticeGiven, NoticeTooShort
from app.kit.http import CurrentRuntime, DbSession, Route, Router, problems
from app.kit.typesetting import DocumentTooLarge, TypesettingBusy

router = Router(prefix="/v1", tags=["amendments"], route_class=Route)
PDF_ANSWER: dict[int | str, dict[str, Any]] = {200: {"content": {PDF: {}}, "description": "The text as PDF"}}
SIGNING = (TextChanged, AlreadyAccepted, AddressNotProven, SamePersonOnBothSides)


@router.get("/contracts/{contract_id}/ending", responses=problems(ContractNotFound))
def read_ending(contract_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> schemas.EndingRead:
    """Return what a contract comes to if it ends early: a forecast, the statement of a notice, or what was settled."""
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
    body: AcceptAdd,
    request: Request,
    runtime: CurrentRuntime,
    session: DbSession,
    actor: Actor = allows(Audience.PROJECT),
) -> schemas.EndingRead:
    """Say yes to the statement for the caller's party; with the second yes the contract is settled and ends."""
    ending.agree_to_statement(
        session,
        actor,
        contract_id,
        name=body.name,
        text_sha256=body.text_sha256,
        address=client_address(request),
        proof_needed=bool(runtime.settings.smtp_url),
    )
    return ending.ending(session, actor, contract_id)


@router.get(
    "/contracts/{contract_id}/ending/statement.pdf",
    response_class=Response,
    responses=PDF_ANSWER | problems(ContractNotFound, NoNotice, DocumentTooLarge, TypesettingBusy),
)
def download_statement(contract_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> Response:
    """Return the statement as PDF; the same text is the same bytes."""
    pdf = ending.statement_pdf(session, actor, contract_id)
    return Response(pdf.content, media_type=PDF, headers=attachment("settlement.pdf"))
