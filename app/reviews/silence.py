"""Which cues wait under a clause on silence, and until when."""

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from datetime import date, datetime
from uuid import UUID

from sqlalchemy import ColumnElement
from sqlalchemy.orm import Session

from app.contracts.models import Contract
from app.contracts.money_queries import agreed_terms
from app.contracts.silence import Silence
from app.deliveries.models import Take
from app.kit.among import among
from app.projects.models import Project
from app.reviews import queries, queue_queries
from app.reviews.rules import missing_variations
from app.sound_lists.models import Cue


@dataclass(frozen=True)
class SilentCue:
    """A cue that waits whole, and will be accepted when nobody says anything: the versions picked then, since when."""

    cue: Cue
    project: Project
    contract: Contract
    silence: Silence
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
        """How many reminders are due by now."""
        return self.silence.reminders(self.since, now)


def silent_cues(session: Session, reach: ColumnElement[bool]) -> list[SilentCue]:
    """Return the cues that wait under a clause on silence.

    The newest version of each variation counts, and the cue waits since the last of them does, or since it was agreed:
    a designer who delivers anew gives the studio its days anew. What is approved already is not picked again.
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
    clauses: dict[UUID, Silence | None] = {}
    found: list[SilentCue] = []
    for cue_id, takes in by_cue.items():
        contract, project = contracts[cue_id]
        if contract.id not in clauses:
            clauses[contract.id] = Silence.of(agreed_terms(session, contract))
        silence, cue = clauses[contract.id], takes[0].cue
        newest = {take.variation: take for take in reversed(takes)}
        if silence is None or cue is None or contract.agreed_at is None:
            continue
        missing = missing_variations(cue.variations, approved.get(cue_id, []))
        picks = [newest[variation] for variation in missing if variation in newest]
        if missing and len(picks) == len(missing):
            since = max(contract.agreed_at, *(take.conforming_since or take.state_since for take in picks))
            found.append(SilentCue(cue, project, contract, silence, picks, since))
    return found


def last_days(session: Session, cue_ids: Collection[UUID]) -> dict[UUID, date]:
    """Return by cue the day after which it is accepted when nobody says anything; others are left out."""
    owed = queue_queries.cues_under_contract(session, cue_ids)
    return {one.cue.id: one.last_day for one in silent_cues(session, among(Take.cue_id, owed))} if owed else {}
