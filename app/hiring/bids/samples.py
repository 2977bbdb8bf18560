"""Sounds that a designer adds to a bid: kept apart from deliveries, checked by a job, heard by the two parties."""

import base64
import binascii
from collections.abc import Sequence
from datetime import datetime
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.core import clock
from app.core.db import bypass_row_policies
from app.core.errors import FieldProblem
from app.core.events import publish
from app.core.storage import Store
from app.hiring import queries
from app.hiring.errors import BidNotSent, NoSound, PostingNotFound, SampleInvalid, SampleNotFound, SamplesFull
from app.hiring.models import Bid, Posting, Sample
from app.hiring.postings.access import posting_access, today_of
from app.hiring.rules import MAX_SAMPLES, BidState, ensure_takes_bids, sample_is_open
from app.hiring.schemas import SampleFinding, SampleRead
from app.references.rules import HEAD_BYTES, ReferenceKind, type_of
from app.sound_lists.rules import tidy_line


def add_sample(
    session: Session,
    actor: Actor,
    posting_id: UUID,
    *,
    line_key: str,
    file_name: str,
    content_base64: str,
    store: Store,
) -> None:
    """Add a sound to the caller's bid while the posting takes bids, and have it checked."""
    posting, bid = _own_bid(session, actor, posting_id)
    if line_key not in {line["key"] for line in posting.lines}:
        raise _invalid("line_key", "choose a line of this posting")
    if len(queries.samples_of(session, [bid.id])) >= MAX_SAMPLES:
        raise SamplesFull(f"a bid has {MAX_SAMPLES} samples at most", fix="remove one first")
    try:
        content = base64.b64decode(content_base64, validate=True)
    except (ValueError, binascii.Error):
        raise _invalid("content_base64", "this is not base64") from None
    media_type = type_of(content[:HEAD_BYTES])
    if media_type.kind is not ReferenceKind.AUDIO:
        message = "this is not a sound that browsers play; wanted WAV, FLAC, MP3, Ogg or M4A"
        raise NoSound(message, errors=[FieldProblem(where="content_base64", message=message)])
    stored = store.put(posting.studio_id, [content])
    sample = Sample(
        studio_id=posting.studio_id,
        project_id=posting.project_id,
        bid_id=bid.id,
        designer_id=actor.person,
        line_key=line_key,
        file_name=tidy_line(file_name) or "sample",
        media_type=media_type.media_type,
        sha256=stored.sha256,
        file_bytes=stored.size_bytes,
    )
    session.add(sample)
    session.flush()
    publish(
        session, "sample.added", studio_id=posting.studio_id, project_id=posting.project_id, sample_id=str(sample.id)
    )


def remove_sample(session: Session, actor: Actor, sample_id: UUID) -> UUID:
    """Take a sound off the caller's bid while the posting takes bids; return the posting."""
    sample, bid = _seen(session, actor, sample_id)
    _own_bid(session, actor, bid.posting_id)  # refuses the studio's own people; no other designer got here
    session.delete(sample)
    session.flush()
    return bid.posting_id


def sample_heard(session: Session, actor: Actor, sample_id: UUID) -> Sample:
    """Return a sample that the caller may hear now."""
    sample, bid = _seen(session, actor, sample_id)
    if not is_open(bid.posting, bid):
        raise SampleNotFound("this bid was refused, and its samples are no longer kept")
    return sample


def _own_bid(session: Session, actor: Actor, posting_id: UUID) -> tuple[Posting, Bid]:
    access = posting_access(session, actor, posting_id)
    access.ensure_candidate()
    posting = access.posting
    queries.lock_posting(session, posting_id)
    ensure_takes_bids(posting.state, posting.bids_until_on, today_of(posting))
    bid = queries.own_bid(session, posting_id, actor.person)
    if bid is None:
        raise BidNotSent("there is no bid to add a sample to", fix="save a draft first")
    return posting, bid


def _seen(session: Session, actor: Actor, sample_id: UUID) -> tuple[Sample, Bid]:
    """Return a sample and its bid: the designer's own, or one that was sent to the caller's studio."""
    missing = SampleNotFound(f"no sample {sample_id}")
    with bypass_row_policies(session):  # a candidate is not engaged, so their reach does not show the posting
        sample = queries.sample_for(session, actor, sample_id)
        bid = queries.bid_for(session, actor, sample.bid_id) if sample else None
    if sample is None or bid is None:
        raise missing
    if bid.designer_id != actor.person:
        if bid.state is not BidState.SENT:
            raise missing
        try:
            posting_access(session, actor, bid.posting_id).ensure_team()
        except PostingNotFound:
            raise missing from None
    return sample, bid


def is_open(posting: Posting, bid: Bid, now: datetime | None = None) -> bool:
    """Whether the samples of a bid can be played."""
    is_lost = posting.awarded_bid_id is not None and posting.awarded_bid_id != bid.id
    return sample_is_open(now or clock.now(), is_refused=is_lost, refused_at=posting.awarded_at)


def samples_read(posting: Posting, bid: Bid, samples: Sequence[Sample]) -> list[SampleRead]:
    """Return the samples of a bid in the order of the posting's lines, then as they were added."""
    line_order = {line["key"]: at for at, line in enumerate(posting.lines)}
    can_play = is_open(posting, bid)
    return [
        SampleRead(
            id=sample.id,
            line_key=sample.line_key,
            file_name=sample.file_name,
            file_bytes=sample.file_bytes,
            state=sample.state,
            spec_version=sample.spec_version,
            findings=[SampleFinding.model_validate(finding) for finding in sample.findings],
            problem=sample.problem,
            is_open=can_play,
        )
        for sample in sorted(samples, key=lambda sample: (line_order.get(sample.line_key, len(line_order)), sample.id))
    ]


def _invalid(where: str, message: str) -> SampleInvalid:
    return SampleInvalid(message, errors=[FieldProblem(where=where, message=message)])
