"""Decisions on takes: their verdicts, and what gives way to them; the rest follows from the signals that they send."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy.orm import Session

from app.core import clock
from app.core.db import new_id
from app.core.events import publish, send
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.deliveries.sources.service import record_sources
from app.deliveries.take_states import change_state
from app.reviews import queries
from app.reviews.errors import NotReviewable
from app.reviews.models import ChangeRequest, Feedback, Verdict
from app.reviews.rules import VerdictKind, missing_variations
from app.reviews.signals import CueDecided, GivenVerdict, TakeJudged, VerdictsOnFile
from app.sound_lists.models import Cue

SUPERSEDED = "another version was picked"
STATE_AFTER = {VerdictKind.APPROVE: TakeState.APPROVED, VerdictKind.SET_ASIDE: TakeState.SET_ASIDE}


class Decision:
    """The decisions of one click, or of deemed acceptance, so that they can be undone together."""

    def __init__(
        self,
        session: Session,
        person_id: UUID | None,
        note: str,
        *,
        reasons: Sequence[str] = (),
        on_behalf_of: UUID | None = None,
        deemed_by_contract_id: UUID | None = None,
    ) -> None:
        self._session = session
        self._person_id = person_id
        self._on_behalf_of = on_behalf_of
        self._note = note
        self._reasons = reasons
        self._silence_contract_id = deemed_by_contract_id
        self.action_id = new_id()
        self.approved: list[Take] = []
        self.superseded_take_ids: list[UUID] = []

    def approve(self, take: Take, *, without_listening: bool = False) -> None:
        """Pick a take; what else waits or was picked for its variation gives way."""
        if take.cue_id is None:
            raise AssertionError("only matched takes are judged")
        for other in queries.open_takes(self._session, take.cue_id, variation=take.variation):
            if other.id != take.id:
                self._record(other, VerdictKind.SET_ASIDE, SUPERSEDED, keeps_draft=True)
                self.superseded_take_ids.append(other.id)
        self._session.flush()  # the former pick gives way first: there is never more than one
        verdict = self._record(
            take, VerdictKind.APPROVE, self._note, reasons=self._reasons, without_listening=without_listening
        )
        self._session.flush()
        send(self._session, VerdictsOnFile(VerdictKind.APPROVE, [GivenVerdict(verdict, take)]))
        record_sources(self._session, take)
        self.approved.append(take)

    def set_aside(self, take: Take) -> None:
        """Put a waiting take away."""
        if take.state is TakeState.APPROVED:
            raise NotReviewable(
                "this version is approved", fix="approve another version in its place, or request a change"
            )
        self._record(take, VerdictKind.SET_ASIDE, self._note)
        self._session.flush()

    def finish(self, cue: Cue) -> bool:
        """Send and publish what was decided, and return whether the cue is accepted now."""
        is_deemed = self._silence_contract_id is not None
        accepted = decide_cue(self._session, cue, person_id=self._person_id, is_deemed=is_deemed)
        for take in () if is_deemed else self.approved:
            publish(self._session, "take.approved", studio_id=take.studio_id, take_id=take.id, cue_accepted=accepted)
        return accepted

    def _record(
        self,
        take: Take,
        kind: VerdictKind,
        note: str,
        *,
        reasons: Sequence[str] = (),
        keeps_draft: bool = False,
        without_listening: bool = False,
    ) -> Verdict:
        verdict = new_verdict(
            self._session,
            self._person_id,
            take,
            kind,
            note,
            self.action_id,
            reasons=reasons,
            on_behalf_of=self._on_behalf_of,
            deemed_by_contract_id=self._silence_contract_id,
            without_listening=without_listening,
        )
        change_state(self._session, take, STATE_AFTER[kind], reasons=reasons)
        draft = queries.draft_of(self._session, take.id)
        if draft is not None and not keeps_draft:
            kept = ("text", "reasons", "start_s", "end_s", "mentions")
            verdict.dropped_draft = {name: getattr(draft, name) for name in kept}
            self._session.delete(draft)
        self._session.add(verdict)
        return verdict


def decide_cue(session: Session, cue: Cue, *, person_id: UUID | None, is_deemed: bool = False) -> bool:
    """Send whether a cue is accepted now, to all that follows from it, and return it."""
    approved = queries.approved_takes(session, cue.id)
    is_accepted = not missing_variations(cue.variations, [take.variation for take in approved])
    send(session, CueDecided(cue, is_accepted, approved, person_id, is_deemed))
    return is_accepted


def new_verdict(
    session: Session,
    person_id: UUID | None,
    take: Take,
    kind: VerdictKind,
    note: str,
    action_id: UUID,
    *,
    reasons: Sequence[str] = (),
    on_behalf_of: UUID | None = None,
    deemed_by_contract_id: UUID | None = None,
    without_listening: bool = False,
    withdraws_id: UUID | None = None,
    sent_with: Sequence[Feedback | ChangeRequest] = (),
) -> Verdict:
    """Return a verdict to add before the take moves, and send it."""
    verdict = Verdict(
        id=new_id(),
        studio_id=take.studio_id,
        project_id=take.project_id,
        cue_id=take.cue_id,
        take_id=take.id,
        action_id=action_id,
        kind=kind,
        note=note,
        reasons=list(reasons),
        state_before=take.state,
        since_before=take.state_since,
        given_by=person_id,
        on_behalf_of=on_behalf_of,
        deemed_by_contract_id=deemed_by_contract_id,
        without_listening=without_listening,
        withdraws_id=withdraws_id,
        created_at=clock.now(),
    )
    send(session, TakeJudged(verdict, take, sent_with))
    return verdict
