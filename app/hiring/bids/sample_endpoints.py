"""The endpoints of samples that come with bids."""

from uuid import UUID

from fastapi import APIRouter, Request, Response

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.storage import BlobMissing
from app.core.web.blob_response import WHILE_ASKED, blob_response
from app.core.web.bodies import LARGE_BODY_BYTES, accepts_body
from app.core.web.downloads import downloads
from app.core.web.http import CurrentRuntime, DbSession, problems
from app.hiring.bids import samples
from app.hiring.errors import (
    BidNotSent,
    NoSound,
    PostingClosed,
    PostingNotFound,
    SampleInvalid,
    SampleNotFound,
    SamplesFull,
)
from app.hiring.postings.reads import posting_read
from app.hiring.schemas import PostingRead, SampleAdd
from app.projects.errors import DesignerNeeded, NdaNeeded, TeamNeeded

router = APIRouter(prefix="/v1", tags=["postings"])
LOCKED = {"Content-Security-Policy": "default-src 'none'; sandbox", "X-Content-Type-Options": "nosniff"}


@router.post(
    "/postings/{posting_id}/bid/samples",
    status_code=201,
    responses=problems(
        PostingNotFound, DesignerNeeded, NdaNeeded, PostingClosed, BidNotSent, SamplesFull, SampleInvalid, NoSound
    ),
)
@accepts_body(LARGE_BODY_BYTES)
def add_bid_sample(
    posting_id: UUID,
    body: SampleAdd,
    session: DbSession,
    runtime: CurrentRuntime,
    actor: Actor = allows(Audience.DESIGNER),
) -> PostingRead:
    """Add a sound to one's bid and have it checked by the project's spec; the studio hears it once the bid is sent."""
    samples.add_sample(session, actor, posting_id, **body.model_dump(), store=runtime.store)
    return posting_read(session, actor, posting_id)


@router.delete(
    "/bid-samples/{bid_sample_id}",
    responses=problems(SampleNotFound, DesignerNeeded, NdaNeeded, PostingClosed, TeamNeeded),
)
def remove_bid_sample(bid_sample_id: UUID, session: DbSession, actor: Actor = allows(Audience.DESIGNER)) -> PostingRead:
    """Take a sound off one's bid."""
    return posting_read(session, actor, samples.remove_sample(session, actor, bid_sample_id))


@router.get(
    "/bid-samples/{bid_sample_id}/file",
    **downloads("application/octet-stream", SampleNotFound, TeamNeeded, BlobMissing),
)
def get_bid_sample(
    bid_sample_id: UUID,
    request: Request,
    session: DbSession,
    runtime: CurrentRuntime,
    actor: Actor = allows(Audience.PERSON),
) -> Response:
    """Send a sound of a bid as it came, parts of it by Range: to its designer and, once sent, to the team."""
    sample = samples.sample_heard(session, actor, bid_sample_id)
    headers = LOCKED | {"Cache-Control": WHILE_ASKED}
    return blob_response(
        request, runtime.store, sample.studio_id, sample.sha256, media_type=sample.media_type, headers=headers
    )
