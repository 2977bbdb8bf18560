"""The cues that wait under a deemed-acceptance clause, and until when."""

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from datetime import date, datetime
from uuid import UUID
from zoneinfo import ZoneInfo

from sqlalchemy import ColumnElement
from sqlalchemy.orm import Session

from app.accounts.calendars.service import holidays_of, time_zones_of
from app.agreements.clauses.deemed_acceptance import DeemedAcceptance, Pause, Wait, WorkCalendar
from app.agreements.clauses.terms import MoneyTerms, SourcesNeeded
from app.agreements.deemed_acceptance.queries import clock_pauses, cues_under_contract, waiting_under_contract
from app.agreements.models import Contract
from app.agreements.plan.queries import agreed_terms
from app.core import clock
from app.core.in_array import in_array
from app.deliveries.models import Take
from app.deliveries.rules import undecided_groups
from app.deliveries.sources.queries import source_statements
from app.deliveries.sources.service import sources_in
from app.deliveries.sources.statements import open_points
from app.deliveries.tray.service import open_take_of
from app.projects.models import Project
from app.reviews import queries
from app.reviews.rules import PausedBy, missing_variations
from app.reviews.signals import LastDay, LastDaysAsked
from app.sound_lists.models import Cue


@dataclass(frozen=True)
class DeemedCue:
    """A complete cue that will be deemed accepted without a decision: the versions picked then, and its wait."""

    cue: Cue
    project: Project
    contract: Contract
    picks: Sequence[Take]
    wait: Wait
    undecided: Sequence[Sequence[Take]] = ()  # files of one delivery for one place, between which nobody chose

    def paused_by(self, now: datetime) -> PausedBy | None:
        """Return the pause of the acceptance at a moment; None where there is none."""
        return "undecided_versions" if self.undecided else self.wait.paused_by(now)

    def is_over(self, now: datetime) -> bool:
        """Whether the cue counts as accepted; nobody's silence chooses between two files."""
        return not self.undecided and self.wait.is_over(now)

    def reminders(self, now: datetime) -> int:
        """Return the number of reminders due by now, one more where only a choice between files is missing."""
        return self.wait.reminders(now) + (bool(self.undecided) and self.wait.is_over(now))


@dataclass(frozen=True)
class _Terms:
    """A contract's terms on silence and on sources."""

    silence: DeemedAcceptance
    wants_sources: bool


@dataclass(frozen=True)
class _Waiting:
    """A complete cue before it is known what stops its count."""

    cue: Cue
    project: Project
    contract: Contract
    terms: _Terms
    picks: Sequence[Take]
    undecided: Sequence[Sequence[Take]]


def deemed_cues(session: Session, reach: ColumnElement[bool]) -> list[DeemedCue]:
    """Return the cues that wait under a deemed-acceptance clause.

    The newest version of each variation counts, and the cue waits since the last of them does, or since it was agreed:
    a new delivery restarts the studio's days. Approved versions are not picked again. A cue whose sources the contract
    wants first waits since they were stated. One with two files of a delivery for one place is not accepted while
    nobody chose between them.
    """
    by_cue: dict[UUID, list[Take]] = {}
    contracts: dict[UUID, tuple[Contract, Project]] = {}
    for take, contract, project in waiting_under_contract(session, reach):
        if take.cue_id is not None:
            by_cue.setdefault(take.cue_id, []).append(take)
            contracts[take.cue_id] = contract, project
    if not by_cue:
        return []
    approved = queries.approved_variations(session, by_cue)
    clauses: dict[UUID, _Terms | None] = {}
    waiting: list[_Waiting] = []
    for cue_id, takes in by_cue.items():
        contract, project = contracts[cue_id]
        if contract.id not in clauses:
            clauses[contract.id] = _terms_of(session, contract)
        terms, cue = clauses[contract.id], takes[0].cue
        newest = {take.variation: take for take in reversed(takes)}
        if terms is None or cue is None:
            continue
        missing = missing_variations(cue.variations, approved.get(cue_id, []))
        picks = [newest[variation] for variation in missing if variation in newest]
        if missing and len(picks) == len(missing):
            waiting.append(_Waiting(cue, project, contract, terms, picks, _undecided(takes, missing)))
    return _with_waits(session, waiting)


def _undecided(takes: Sequence[Take], variations: Collection[int]) -> list[list[Take]]:
    """Return the files of a cue between which nobody chose, of the variations that are not approved."""
    by_id = {take.id: take for take in takes if take.variation in variations}
    return [[by_id[take.id] for take in group] for group in undecided_groups(map(open_take_of, by_id.values()))]


def _terms_of(session: Session, contract: Contract) -> _Terms | None:
    terms = agreed_terms(session, contract)
    silence = DeemedAcceptance.of(terms)
    if silence is None:
        return None
    return _Terms(silence, MoneyTerms.of(terms).sources_needed is SourcesNeeded.BEFORE_ACCEPTANCE)


def _with_waits(session: Session, waiting: Sequence[_Waiting]) -> list[DeemedCue]:
    by_calendar = [deemed for deemed in waiting if deemed.terms.silence.by_studio_calendar]
    calendars = _calendars(session, {deemed.project.studio_id for deemed in by_calendar})
    pauses = _pauses(session, by_calendar)
    stated = _stated(session, [take for deemed in waiting if deemed.terms.wants_sources for take in deemed.picks])
    deemed_cues = []
    for cue_waiting in waiting:
        moments = [take.conforming_since or take.state_since for take in cue_waiting.picks]
        if cue_waiting.terms.wants_sources:
            if any(take.id not in stated for take in cue_waiting.picks):
                continue
            moments += [stated[take.id] for take in cue_waiting.picks]
        if cue_waiting.contract.agreed_at is not None:
            since = max(cue_waiting.contract.agreed_at, *moments)
            calendar = calendars.get(cue_waiting.project.studio_id, WorkCalendar())
            wait = Wait.under(cue_waiting.terms.silence, since, calendar, pauses.get(cue_waiting.cue.id, ()))
            deemed_cues.append(
                DeemedCue(
                    cue_waiting.cue,
                    cue_waiting.project,
                    cue_waiting.contract,
                    cue_waiting.picks,
                    wait,
                    cue_waiting.undecided,
                )
            )
    return deemed_cues


def _calendars(session: Session, studio_ids: Collection[UUID]) -> dict[UUID, WorkCalendar]:
    holidays: dict[UUID, dict[date, datetime]] = {studio_id: {} for studio_id in studio_ids}
    for holiday in holidays_of(session, studio_ids):
        holidays[holiday.studio_id][holiday.day] = holiday.created_at
    zones = time_zones_of(session, studio_ids)
    return {studio_id: WorkCalendar(ZoneInfo(zones[studio_id]), holidays[studio_id]) for studio_id in studio_ids}


def _pauses(session: Session, waiting: Sequence[_Waiting]) -> Mapping[UUID, Iterable[Pause]]:
    """Return the pauses of each cue's count: questions of the contract's designer on it, and open change orders."""
    by_cue: dict[UUID, list[Pause]] = {deemed.cue.id: [] for deemed in waiting}
    contracts = {deemed.cue.id: deemed.contract for deemed in waiting}
    for question in queries.questions_on(session, by_cue):
        if question.asked_by == contracts[question.cue_id].designer_id:
            by_cue[question.cue_id].append(Pause("question", question.asked_at, question.answered_at))
    of_contracts: dict[UUID, list[Pause]] = {}
    for pause in clock_pauses(session, {contract.id for contract in contracts.values()}):
        change_order = Pause("change_order", pause.began_at, pause.ended_at)
        of_contracts.setdefault(pause.contract_id, []).append(change_order)
    return {cue_id: [*cue_pauses, *of_contracts.get(contracts[cue_id].id, [])] for cue_id, cue_pauses in by_cue.items()}


def _stated(session: Session, takes: Sequence[Take]) -> dict[UUID, datetime]:
    """Return the times of stating the sources of takes, of those of which nothing is open."""
    statements = source_statements(session, [take.id for take in takes])
    return {
        take_id: statement.stated_at
        for take_id, statement in statements.items()
        if not open_points(sources_in(statement))
    }


def answer_last_days(session: Session, asked: LastDaysAsked) -> dict[UUID, LastDay]:
    """Return the last days of cues to the room that asks for them."""
    return last_days(session, asked.cue_ids)


def last_days(session: Session, cue_ids: Collection[UUID]) -> dict[UUID, LastDay]:
    """Return by cue the day after which it is deemed accepted; others are left out."""
    owed, now = cues_under_contract(session, cue_ids), clock.now()
    if not owed:
        return {}
    return {
        deemed_cue.cue.id: LastDay(deemed_cue.wait.last_day(now), deemed_cue.paused_by(now))
        for deemed_cue in deemed_cues(session, in_array(Take.cue_id, owed))
    }
