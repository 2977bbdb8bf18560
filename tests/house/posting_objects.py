"""An open posting with a bid, as part of one of everything."""

from datetime import timedelta
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.authentication import sha256_of
from app.core import clock
from app.core.uploads import Upload
from app.hiring.models import Bid, BidNote, Candidate, Posting, PostingQuestion, Sample
from app.hiring.rules import AskedScope, BidNoteKind, BidState, PostingPhase, PostingState, SampleState


def add_posting(
    session: Session,
    *,
    studio_id: UUID,
    project_id: UUID,
    secret: str,
    made_by: UUID,
    designer_id: UUID,
    sample: Upload,
) -> dict[str, UUID]:
    """Add a posting that the designer was asked for, with a bid that was sent and a question; return ids by name."""
    of = {"studio_id": studio_id, "project_id": project_id}
    posting = Posting(
        **of,
        title="Effects",
        phase=PostingPhase.PRODUCTION,
        state=PostingState.OPEN,
        currency="USD",
        scope=AskedScope.ALL,
        categories=[],
        cue_ids=[],
        lines=[{"key": "", "label": "Other sounds", "cues": 1, "files": 1}],
        headings=["Quality of work"],
        secret_sha256=sha256_of(secret),
        created_by=made_by,
    )
    session.add(posting)
    session.flush()
    of_it = {**of, "posting_id": posting.id}
    candidate = Candidate(
        **of_it, email="asked@example.test", person_id=designer_id, expires_at=clock.now() + timedelta(days=1)
    )
    line = {
        "key": "",
        "kind": "asked",
        "unit": "per_cue",
        "quantity_hundredths": 100,
        "price_minor": 18_000,
        "note": "",
    }
    content = {"lines": [line], "hours_hundredths": None, "from_on": None, "to_on": None, "note": ""}
    bid = Bid(**of_it, designer_id=designer_id, content=content, sent=content, state=BidState.SENT)
    bid.sent_at, bid.revision = clock.now(), 1
    question = PostingQuestion(**of_it, text="Is there a build?", asked_by=designer_id)
    session.add_all([candidate, bid, question])
    session.flush()
    sound = Sample(
        **of,
        bid_id=bid.id,
        designer_id=designer_id,
        line_key="",
        file_name="shield_hit.wav",
        media_type="audio/wav",
        sha256=sample.sha256,
        file_bytes=sample.length,
        state=SampleState.CONFORMING,
    )
    bid_note = BidNote(
        **of,
        bid_id=bid.id,
        kind=BidNoteKind.CALL,
        held_on=clock.now().date(),
        text="Clear answers.",
        written_by=made_by,
    )
    session.add_all([sound, bid_note])
    session.flush()
    return {
        "posting_id": posting.id,
        "candidate_id": candidate.id,
        "bid_id": bid.id,
        "bid_note_id": bid_note.id,
        "bid_sample_id": sound.id,
        "posting_question_id": question.id,
    }
