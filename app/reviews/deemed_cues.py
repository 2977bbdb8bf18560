"""The cues that wait under a deemed-acceptance clause, and until when."""

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from datetime import date, datetime
from uuid import UUID

from sqlalchemy import ColumnElement
from sqlalchemy.orm import Session

from app.agreements.deemed_acceptance import DeemedAcceptance
from app.agreements.models import Contract
from app.agreements.plan_queries import agreed_terms
from app.deliveries.models import Take
from app.kit.in_array import in_array
from app.projects.models import Project
from app.reviews import queries, queue_queries
from app.reviews.rules import missing_variations
from app.sound_lists.models import Cue


@dataclass(frozen=True)
class DeemedCue:
    """A complete cue that will be deemed accepted without a decision: the versions picked then, waiting since when."""

    cue: Cue
    project: Project
    contract: Contract
    silence: DeemedAcceptance
    picks: Sequence[Take]
    since: datetime

    @property
    def last_day(self) -> date:
        """The day that must pass without a verdict."""
        return self.silence.last_day(self.since)

    def is_over(self, now: datetime) -> bool:
        """Whether that day has passed."""
        return self.silence.is_over(self.since, now)

    def reminders(self, now: datetime) -> int:
        """Return the number of reminders due by now."""
        return self.silence.reminders(self.since, now)


def deemed_cues(session: Session, reach: ColumnElement[bool]) -> list[DeemedCue]:
    """Return the cues that wait under a deemed-acceptance clause.

    The newest version of each variation counts, and the cue waits since the last of them does, or since it was agreed:
    a new delivery restarts the studio's days. Approved versions are not picked again.
    """
    by_cue: dict[UUID, list[Take]] = {}
    contracts: dict[UUID, tuple[Contract, Project]] = {}
    for take, contract, project in queue_queries.waiting_under_contract(session, reach):
        if take.cue_id is not None:
            by_cue.setdefault(take.cue_id, []).append(take)
            contracts[take.cue_id] = contract, project
    if not by_cue:
        return []
    approved = queries.approved_variations(session, by_cue)
    clauses: dict[UUID, DeemedAcceptance | None] = {}
    found: list[DeemedCue] = []
    for cue_id, takes in by_cue.items():
        contract, project = contracts[cue_id]
        if contract.id not in clauses:
            clauses[contract.id] = DeemedAcceptance.of(agreed_terms(session, contract))
        silence, cue = clauses[contract.id], takes[0].cue
        newest = {take.variation: take for take in reversed(takes)}
        if silence is None or cue is None or contract.agreed_at is None:
            continue
        missing = missing_variations(cue.variations, approved.get(cue_id, []))
        picks = [newest[variation] for variation in missing if variation in newest]
        if missing and len(picks) == len(missing):
            since = max(contract.agreed_at, *(take.conforming_since or take.state_since for take in picks))
            found.append(DeemedCue(cue, project, contract, silence, picks, since))
    return found


def last_days(session: Session, cue_ids: Collection[UUID]) -> dict[UUID, date]:
    """Return by cue the day after which it is deemed accepted; others are left out."""
    owed = queue_queries.cues_under_contract(session, cue_ids)
    return {one.cue.id: one.last_day for one in deemed_cues(session, in_array(Take.cue_id, owed))} if owed else {}
