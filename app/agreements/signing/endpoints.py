"""The data sent to sign a text, and the codes that are mailed for it."""

from uuid import UUID

from fastapi import APIRouter, Request
from starlette.concurrency import run_in_threadpool

from app.accounts.errors import SecondFactorRequired, TooManyAttempts
from app.accounts.rules import Actor, Audience, device_of
from app.accounts.web.policies import allows, client_address
from app.accounts.web.request_limits import ensure_signing_code_allowed
from app.agreements import schemas
from app.agreements.errors import (
    AddressNotProven,
    AlreadyAccepted,
    BadDrawing,
    ContractNotFound,
    NoSigningCode,
    NotYourContract,
    SamePersonOnBothSides,
    SigningCodeNeeded,
    SigningCodeOver,
    TextChanged,
    WrongSigningCode,
)
from app.agreements.signing import codes as signing_codes
from app.agreements.signing.drawn_signatures import ensure_drawing_fits
from app.agreements.signing.rules import AGENT_LENGTH, CODE_TRIES
from app.agreements.signing.service import SignatureRequest
from app.core.web.http import CurrentRuntime, DbSession, problems, runtime_of

router = APIRouter(prefix="/v1", tags=["contracts"])
SIGNING = (
    AddressNotProven,
    AlreadyAccepted,
    BadDrawing,
    SamePersonOnBothSides,
    SecondFactorRequired,
    SigningCodeNeeded,
    SigningCodeOver,
    TextChanged,
    WrongSigningCode,
)


async def signature_sent(request: Request, contract_id: UUID, body: schemas.AcceptAdd) -> SignatureRequest:
    """Return the caller's request to sign; the code is tried before the request's transaction, so each try counts."""
    return await run_in_threadpool(_signature, request, contract_id, body)


def _signature(request: Request, contract_id: UUID, body: schemas.AcceptAdd) -> SignatureRequest:
    if body.drawing is not None:
        ensure_drawing_fits(body.drawing)
    runtime, agent = runtime_of(request), request.headers.get("user-agent", "")
    check = None
    if runtime.settings.smtp_url:
        actor = request.state.actor
        check = signing_codes.check(runtime.database, actor, contract_id, body.text_sha256, body.code)
    return SignatureRequest(
        name=body.name,
        text_sha256=body.text_sha256,
        address=client_address(request),
        agent=device_of(agent)[:AGENT_LENGTH] if agent else "",
        code=check,
        drawing=body.drawing,
    )


@router.post(
    "/contracts/{contract_id}/signing-codes",
    status_code=201,
    responses=problems(
        ContractNotFound, NotYourContract, SecondFactorRequired, AddressNotProven, NoSigningCode, TooManyAttempts
    ),
)
def request_signing_code(
    contract_id: UUID,
    body: schemas.SigningCodeAdd,
    runtime: CurrentRuntime,
    session: DbSession,
    actor: Actor = allows(Audience.PROJECT),
) -> schemas.SigningCodeRead:
    """Mail the caller a code to sign a text of a contract with: the contract's own, a change order's, a statement's."""
    ensure_signing_code_allowed(session, actor)
    code, email = signing_codes.request_code(
        session, actor, contract_id, body.text_sha256, is_mail_on=bool(runtime.settings.smtp_url)
    )
    return schemas.SigningCodeRead(email=email, expires_at=code.expires_at, tries=CODE_TRIES)
