"""The endpoint by which anyone can ask whether a PDF is a sealed contract, untouched."""

from uuid import UUID

from fastapi import APIRouter, Depends, Request
from sqlalchemy.orm import Session
from starlette.concurrency import run_in_threadpool

from app.accounts import rate_limits
from app.accounts.errors import TooManyAttempts
from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.accounts.web.request_limits import ensure_within_limits, network_of
from app.agreements.drafts.documents import PDF
from app.agreements.errors import BadPdf
from app.agreements.record.schemas import BoundRead, BoundSignatureRead, VerifiedRead
from app.agreements.signing import seals
from app.agreements.signing.seal_files import PDF_BEGINS, sealing_key
from app.core.access_scope import NOBODY
from app.core.db import bypass_row_policies
from app.core.parsing_queue import ParsingBusy, parse_request
from app.core.web.bodies import LARGE_BODY_BYTES, accepts_body
from app.core.web.http import CurrentRuntime, database_of, problems, set_reach

router = APIRouter(prefix="/v1", tags=["contracts"])
PDF_BODY = {"requestBody": {"content": {PDF: {"schema": {"type": "string", "format": "binary"}}}, "required": True}}
ANY = UUID(int=0)


def _anyone(_session: Session, _actor: Actor, _whose: UUID) -> None:
    """Permit anyone to have a file read; how often is limited by network."""


async def _sent(request: Request) -> tuple[bytes, str]:
    """Return the file that was sent and the key that it was sealed by, read in a child where that is not known."""
    limit = (rate_limits.VERIFICATIONS_FROM_NETWORK, network_of(request))
    await run_in_threadpool(ensure_within_limits, request, limit)
    body = await request.body()
    if not body.startswith(PDF_BEGINS) or await run_in_threadpool(_is_known, request, body):
        return body, ""
    set_reach(request, NOBODY)  # all who are not signed in share one caller's part of the queue
    return body, await parse_request(request, sealing_key, body, refusal=BadPdf, permit=_anyone, whose=ANY)


def _is_known(request: Request, body: bytes) -> bool:
    with database_of(request).reading() as session, bypass_row_policies(session):
        return seals.is_known(session, body)


@router.post(
    "/verify",
    openapi_extra=PDF_BODY,
    responses=problems(BadPdf, ParsingBusy, TooManyAttempts),
)
@accepts_body(LARGE_BODY_BYTES)
def verify_pdf(
    runtime: CurrentRuntime,
    _actor: Actor = allows(Audience.ANYONE),
    sent: tuple[bytes, str] = Depends(_sent),
) -> VerifiedRead:
    """Say of a PDF whether it is a contract that was signed and sealed here, and whether it is untouched.

    An untouched one says what it binds. A file that was changed, or is not from here, says nothing of any contract.
    """
    body, key_sha256 = sent
    with runtime.database.reading() as session, bypass_row_policies(session):  # the file itself is what is known
        verified = seals.verify(session, body, key_sha256)
        return VerifiedRead(verdict=verified.verdict.value, file_sha256=verified.file_sha256, binds=_bound(verified))


def _bound(verified: seals.Verified) -> BoundRead | None:
    if verified.seal is None:
        return None
    contract, version = verified.seal.contract, verified.seal.version
    return BoundRead(
        title=contract.title,
        kind=contract.kind,
        version=version.number,
        text_sha256=version.text_sha256,
        studio_name=contract.project.studio.name,
        designer_name=contract.designer.name,
        agreed_at=contract.agreed_at,
        sealed_at=verified.seal.sealed_at,
        is_timestamped=verified.seal.is_timestamped,
        signatures=[
            BoundSignatureRead(party=acceptance.party, name=acceptance.name, signed_at=acceptance.accepted_at)
            for acceptance in verified.acceptances
        ],
    )
