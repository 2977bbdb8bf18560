"""The standing of a take: its place in the list, its state, and the contract's record of both."""

from collections.abc import Mapping, Sequence
from datetime import datetime
from uuid import UUID

from sqlalchemy.orm import Session

from app.core import clock
from app.core.events import publish, send
from app.core.jobs.queue import NORMAL
from app.core.recorded_rows import RowChanges
from app.deliveries import queries
from app.deliveries.cue_counts.service import update_take_counts
from app.deliveries.models import Take
from app.deliveries.rules import ReviewClock, TakeState, ensure_may_become
from app.deliveries.signals import WorkDone
from app.deliveries.slots import Slot


def place_take(session: Session, take: Take, slot: Slot, *, by: UUID) -> None:
    """Give a take its place in the list; it gets a number there and is checked again as that cue."""
    ensure_may_become(take.state, TakeState.RECEIVED)
    number = queries.next_number(session, slot.cue.id, slot.variation)
    note_moved_away(session, take, by=by)
    take.conforming_since = take.returned_since = None
    update_take_counts(session, slot.cue.id)
    take.cue_id, take.variation, take.number = slot.cue.id, slot.variation, number
    take.alternate = slot.alternate
    session.flush()
    session.refresh(take, ["cue"])
    note_delivered(session, take, by=by)
    start_recheck(session, take, by=by)


def note_moved_away(session: Session, take: Take, *, by: UUID) -> None:
    """Record that a take leaves its cue, if it has one, and have the cue's sums worked out without it."""
    rows = RowChanges().remove(take)
    note_take(session, take, "moved_away", {"file": take.file_name}, by=by, on_behalf_of=take.designer_id, rows=rows)
    update_take_counts(session, take.cue_id)


def note_delivered(session: Session, take: Take, *, by: UUID) -> None:
    """Record that a take is delivered for its cue."""
    facts: dict[str, object] = {"file": take.file_name, "sha256": take.master_sha256}
    if take.split_of_id is not None:
        facts["cut_from"] = queries.master_of(session, take.split_of_id)
        facts |= {"first_frame": take.split_first_frame, "end_frame": take.split_end_frame}
    rows = RowChanges().add(take)
    note_take(session, take, "delivered", facts, by=by, on_behalf_of=take.designer_id, rows=rows)


def note_take(
    session: Session,
    take: Take,
    kind: str,
    facts: Mapping[str, object],
    *,
    by: UUID | None,
    on_behalf_of: UUID | None = None,
    rows: RowChanges | None = None,
) -> None:
    """Record a take's new state in the contract that covers its cue, if there is one."""
    if take.cue_id is not None and take.number is not None:
        entry = {"variation": take.variation, "version": take.number, **facts}
        send(session, WorkDone(take.cue_id, take.designer_id, kind, entry, by, on_behalf_of, rows))


def start_recheck(session: Session, take: Take, *, by: UUID | None, priority: int = NORMAL) -> None:
    """Set a take back to received, and schedule its check; the result of a running check no longer counts.

    `by` is the person whose act asks for it; None: the server.
    """
    change_state(session, take, TakeState.RECEIVED)
    take.edition += 1
    take.rechecked_by = by
    session.flush()
    publish(session, "take.received", studio_id=take.studio_id, priority=priority, take_id=take.id)


def change_state(session: Session, take: Take, wanted: TakeState, *, reasons: Sequence[str] = ()) -> None:
    """Take a take from state to state, for the reasons of its verdict; raise WrongState where that cannot be."""
    ensure_may_become(take.state, wanted)
    now = clock.now()
    _run_review_clock(session, take, wanted, now)
    restore_state(session, take, wanted, now, reasons=reasons)


def _run_review_clock(session: Session, take: Take, wanted: TakeState, now: datetime) -> None:
    of = take
    if wanted is TakeState.CONFORMING and take.conforming_since is None and take.cue_id is not None:
        of = queries.same_bytes_beside(session, take) or take
    review_clock = ReviewClock(of.conforming_since, of.returned_since).at(wanted, now)
    take.conforming_since, take.returned_since = review_clock.conforming_since, review_clock.returned_since


def restore_state(
    session: Session, take: Take, state: TakeState, since: datetime, *, reasons: Sequence[str] = ()
) -> None:
    """Restore a take to an earlier state, with the reasons that its verdict had then."""
    take.state, take.state_since, take.verdict_reasons = state, since, list(reasons)
    session.flush()
    update_take_counts(session, take.cue_id)
