"""The next step of each person in a project, and for whom they wait."""

from collections.abc import Iterator, Sequence
from datetime import UTC, datetime, time
from uuid import UUID

from sqlalchemy import ColumnElement, and_
from sqlalchemy.orm import Session

from app.accounts.models import Person
from app.accounts.queries import people_by_id
from app.accounts.rules import Actor
from app.agreements import queries as agreements
from app.agreements.access import party_of
from app.agreements.models import Contract
from app.agreements.redlines.rules import RETURNS, TURNS
from app.agreements.reminders import near_days
from app.agreements.rules import ContractKind, ContractState, Party
from app.agreements.signing.rules import Turn
from app.amendments.waiting import Amendment, waiting_amendments
from app.briefs import queries as briefs
from app.builds.audits.game_states import cues_in_build
from app.core import clock
from app.dashboards import queries
from app.dashboards.progress import queries as progress_queries
from app.dashboards.progress.service import counted
from app.dashboards.rules import CAME_BACK, STEP_ORDER, UNFINISHED, AwaitedKind, CueStatus, NextStepKind
from app.dashboards.steps import queries as named_queries
from app.dashboards.steps.schemas import Awaited, NextStep, NextSteps
from app.deliveries.models import Take
from app.hiring import queries as hiring
from app.hiring.rules import PostingState
from app.money import queries as money
from app.money.ledger.rules import LineKind
from app.money.ledger.service import load_ledger_book
from app.projects.approval.service import approval_rights
from app.projects.models import Engagement
from app.projects.queries import engagements_of, invitations
from app.projects.rules import ApprovalRights, ApprovalScope
from app.projects.service import ProjectAccess, project_access
from app.projects.visibility import nda_is_pending
from app.reviews.queue import queries as queue_queries
from app.reviews.queue.service import COUNTED_CUES

STEP_OF_AMENDMENT = {
    Amendment.CHANGE_ORDER: NextStepKind.SIGN_CHANGE_ORDER,
    Amendment.STATEMENT: NextStepKind.AGREE_STATEMENT,
    Amendment.OFFERS: NextStepKind.PROPOSE_CHANGES,
}


def next_steps(session: Session, actor: Actor, project_id: UUID, *, has_contracts: bool) -> NextSteps:
    """Return the caller's next steps in a project, the first thing first, and the people they wait for."""
    access = project_access(session, actor, project_id, before_nda=True)
    steps = _Steps(session, access, has_contracts=has_contracts)
    if access.is_team:
        steps.of_team()
    else:
        steps.of_designer()
    return NextSteps(
        steps=sorted(steps.steps, key=lambda step: STEP_ORDER[step.kind]),
        awaited=sorted(steps.awaited, key=lambda awaited: awaited.since or clock.now()),
    )


class _Steps:
    """Collects the steps of one caller."""

    def __init__(self, session: Session, access: ProjectAccess, *, has_contracts: bool) -> None:
        self._session = session
        self._has_contracts = has_contracts
        self._access = access
        self._project = access.project
        self.steps: list[NextStep] = []
        self.awaited: list[Awaited] = []

    def of_team(self) -> None:
        """Collect the steps of a member of the studio in their roles."""
        session, access, project = self._session, self._access, self._project
        counts = counted(progress_queries.cue_groups(session, project.id, project.studio_id))
        speaks = access.is_producer or access.is_liaison or access.is_approver
        postings = hiring.waiting_postings(session, project.id) if speaks and self._has_contracts else []
        if access.is_producer:
            self._hires(has_cues=sum(counts.values()) > 0, is_posted=bool(postings))
        if speaks:
            self._postings(postings)
            self._contracts()
            self._counted(
                NextStepKind.ANSWER_QUESTIONS, queries.questions_open_since(session, project.id, asked_by=None)
            )
            self._counted(NextStepKind.ANSWER_FOLLOW_UPS, briefs.open_follow_ups(session, project.id))
        self._verdicts()
        self._named()
        back_since = queries.back_since(session, project.id, project.studio_id)
        self._await(AwaitedKind.FIXES, "", (sum(counts.get(status, 0) for status in CAME_BACK), back_since))

    def of_designer(self) -> None:
        """Collect the steps of a designer; before the NDA the one step is signing it."""
        session, access, project = self._session, self._access, self._project
        self._contracts()
        engagement = access.engagement
        if engagement is not None and nda_is_pending(project, engagement):
            if not self.steps and not self.awaited:  # no NDA is with either side yet
                self._await(AwaitedKind.NDA, project.name, (1, engagement.created_at))
            return
        designer_id = access.actor.person
        counts = counted(progress_queries.cue_groups(session, project.id, designer_id))
        back_since = queries.back_since(session, project.id, designer_id)
        self._counted(NextStepKind.FIX, (sum(counts.get(status, 0) for status in CAME_BACK), back_since))
        self._counted(NextStepKind.MATCH, queries.tray_since(session, project.id, designer_id))
        self._counted(NextStepKind.MAKE, (sum(counts.get(status, 0) for status in UNFINISHED), None))
        self._named()
        rights = approval_rights(session, project)
        if rights.by_category:
            self._await_verdicts(rights, Take.designer_id == designer_id)
        else:
            since = queries.conforming_takes_since(session, project.id, designer_id)
            waiting = counts.get(CueStatus.TO_REVIEW, 0), since
            self._await(AwaitedKind.VERDICTS, self._acting_for(rights, rights.approver_id), waiting)
        asked = queries.questions_open_since(session, project.id, asked_by=designer_id)
        self._await(AwaitedKind.ANSWER, project.name, asked)

    def _counted(self, kind: NextStepKind, count_and_since: tuple[int, datetime | None]) -> None:
        count, since = count_and_since
        if count:
            self.steps.append(NextStep(kind=kind, count=count, since=since))

    def _await(self, kind: AwaitedKind, who: Person | str, count_and_since: tuple[int, datetime | None]) -> None:
        count, since = count_and_since
        if not count:
            return
        if isinstance(who, str):
            awaited = Awaited(kind=kind, who=who, count=count, since=since)
        else:
            awaited = Awaited(kind=kind, who=who.name, person_id=who.id, picture=who.picture, count=count, since=since)
        self.awaited.append(awaited)

    def _named(self) -> None:
        """Add the cues that name the caller: those to record, and accepted ones that are not in the build."""
        session, project_id, person_id = self._session, self._project.id, self._access.actor.person
        self._counted(NextStepKind.RECORD, (named_queries.cues_to_record(session, project_id, person_id), None))
        accepted = named_queries.accepted_for_implementer(session, project_id, person_id)
        if accepted:
            in_build = cues_in_build(session, project_id)
            waiting = [since for cue_id, since in accepted.items() if cue_id not in in_build]
            self._counted(NextStepKind.IMPLEMENT, (len(waiting), min(waiting, default=None)))

    def _verdicts(self) -> None:
        session, project, person_id = self._session, self._project, self._access.actor.person
        rights = approval_rights(session, project)
        scope = rights.scope_of(person_id)
        if scope.is_any:
            self._counted(NextStepKind.SEND_CHANGES, queries.drafts_since(session, project.id, scope))
            self._counted(NextStepKind.REVIEW, self._waiting(scope))
        if not scope.is_all:
            self._await_verdicts(rights)

    def _waiting(self, scope: ApprovalScope, *of_takes: ColumnElement[bool]) -> tuple[int, datetime | None]:
        """Return the number of cues of a scope awaiting a verdict, and the first wait's start."""
        reach = and_(queue_queries.in_scope(self._project.id, scope), *of_takes)
        waiting = queue_queries.waiting_cues(self._session, reach, after=None, limit=COUNTED_CUES)
        return len(waiting), waiting[0].since if waiting else None

    def _await_verdicts(self, rights: ApprovalRights, *of_takes: ColumnElement[bool]) -> None:
        """Add each approver for whom cues wait, except those that the caller may approve."""
        person_id = self._access.actor.person
        for approver_id in dict.fromkeys((rights.approver_id, *rights.by_category.values())):
            if person_id == approver_id or person_id in rights.deputies.get(approver_id, ()):
                continue
            scope = rights.scope_of(approver_id, as_deputy=False)
            self._await(AwaitedKind.VERDICTS, self._acting_for(rights, approver_id), self._waiting(scope, *of_takes))

    def _acting_for(self, rights: ApprovalRights, approver_id: UUID) -> Person:
        """Return an approver, or the deputy who stands in for them today."""
        acting_id = next(iter(rights.deputies.get(approver_id, ())), approver_id)
        return people_by_id(self._session, {acting_id})[acting_id]

    def _postings(self, postings: list[hiring.WaitingPosting]) -> None:
        for posting in postings:
            for kind, count, since in (
                (NextStepKind.ANSWER_CANDIDATES, posting.questions, posting.first_asked_at),
                (NextStepKind.COMPARE_BIDS, posting.bids, posting.first_bid_at),
            ):
                if count:
                    self.steps.append(
                        NextStep(kind=kind, count=count, since=since, subject=posting.title, posting_id=posting.id)
                    )
            if posting.state is PostingState.OPEN and not posting.bids:
                waiting = Awaited(kind=AwaitedKind.BIDS, who="", subject=posting.title, since=posting.opened_at)
                self.awaited.append(waiting)

    def _hires(self, *, has_cues: bool, is_posted: bool) -> None:
        session, project, access = self._session, self._project, self._access
        if not has_cues:
            self.steps.append(NextStep(kind=NextStepKind.ADD_CUES, since=project.created_at))
            if briefs.brief_of(session, project.id) is None:
                self.steps.append(NextStep(kind=NextStepKind.WRITE_BRIEF, since=project.created_at))
        engaged = [engagement for engagement in engagements_of(session, [project.id]) if engagement.ended_at is None]
        invited = [
            listed_invitation
            for listed_invitation in invitations(session, project.id)
            if listed_invitation.accepted_at is None
        ]
        pending = [invited_person for invited_person in invited if invited_person.expires_at > clock.now()]
        for invitation in pending:
            self.awaited.append(Awaited(kind=AwaitedKind.JOIN, who=invitation.email, since=invitation.created_at))
        if has_cues and not engaged and not pending and not is_posted:
            self.steps.append(NextStep(kind=NextStepKind.INVITE_DESIGNER))
        if (
            access.is_approver
            and project.created_by == access.actor.person
            and not queries.has_verdicts(session, project.id)
        ):
            self.steps.append(NextStep(kind=NextStepKind.NAME_APPROVER))
        self._ndas([engagement for engagement in engaged if nda_is_pending(project, engagement)])

    def _ndas(self, pending: list[Engagement]) -> None:
        if not pending:
            return
        sent = {
            contract.designer_id
            for contract in agreements.contracts_in(self._session, self._access.actor, self._project.id)
            if contract.kind is ContractKind.NDA and contract.state is ContractState.SENT
        }
        self.steps += [
            NextStep(kind=NextStepKind.SEND_NDA, who=engagement.designer.name, since=engagement.created_at)
            for engagement in pending
            if engagement.designer_id not in sent
        ]

    def _contracts(self) -> None:
        if not self._has_contracts:
            return
        session, actor = self._session, self._access.actor
        contracts = agreements.contracts_in(session, actor, self._project.id)
        turns = agreements.turns_to_sign(session, contracts)
        for contract in contracts:
            party = party_of(actor, contract)
            if party is None:
                continue
            match contract.state:
                case ContractState.SENT:
                    self._signature(contract, party, turns[contract.id])
                case ContractState.DRAFT if party is Party.STUDIO:
                    self._draft(contract)
                case ContractState.AGREED | ContractState.ENDED if contract.kind in (
                    ContractKind.SINGLE,
                    ContractKind.STATEMENT_OF_WORK,
                ):
                    self._money(contract, party)
                    self._amendments(contract, party)

        self._days([contract for contract in contracts if party_of(actor, contract) is not None])

    def _days(self, contracts: Sequence[Contract]) -> None:
        for contract, named in near_days(self._session, contracts, clock.now().date()):
            self.steps.append(
                NextStep(
                    kind=NextStepKind.THINK_OF_DAY,
                    subject=contract.title,
                    what=named.words,
                    day=named.day,
                    contract_id=contract.id,
                )
            )

    def _signature(self, contract: Contract, party: Party, turn: Turn) -> None:
        event = agreements.newest_event(self._session, contract.id)
        since = event.at if event else contract.created_at
        is_mine = turn.is_of(party, self._access.actor.person)
        if is_mine:
            self.steps.append(
                NextStep(
                    kind=NextStepKind.SIGN_CONTRACT,
                    subject=contract.title,
                    who=_other_side(contract, party),
                    since=since,
                    contract_id=contract.id,
                )
            )
        if not is_mine or any(other is not party for other in turn.parties):
            self.awaited.append(
                Awaited(
                    kind=AwaitedKind.SIGNATURE,
                    who=_other_side(contract, party),
                    person_id=contract.designer_id if party is Party.STUDIO else None,
                    subject=contract.title,
                    since=since,
                    contract_id=contract.id,
                )
            )

    def _amendments(self, contract: Contract, party: Party) -> None:
        of_contract = {"subject": contract.title, "who": _other_side(contract, party), "contract_id": contract.id}
        for waiting_amendment in waiting_amendments(self._session, self._access.actor, contract, party):
            if waiting_amendment.is_mine:
                kind = STEP_OF_AMENDMENT[waiting_amendment.what]
                self.steps.append(
                    NextStep(kind=kind, count=waiting_amendment.count, since=waiting_amendment.since, **of_contract)
                )
            else:
                person_id = contract.designer_id if party is Party.STUDIO else None
                awaited = AwaitedKind(waiting_amendment.what.value)
                self.awaited.append(
                    Awaited(kind=awaited, person_id=person_id, since=waiting_amendment.since, **of_contract)
                )

    def _draft(self, contract: Contract) -> None:
        event = agreements.newest_event_of(self._session, contract.id, TURNS)
        is_returned = event is not None and event.kind in RETURNS
        self.steps.append(
            NextStep(
                kind=NextStepKind.CHANGE_CONTRACT if is_returned else NextStepKind.SEND_CONTRACT,
                subject=contract.title,
                who=contract.designer.name,
                since=event.at if event and is_returned else contract.created_at,
                contract_id=contract.id,
            )
        )

    def _money(self, contract: Contract, party: Party) -> None:
        session = self._session
        book = load_ledger_book(session, contract)
        of_contract = {"contract_id": contract.id, "currency": contract.currency, "who": _other_side(contract, party)}
        for invoice in money.invoices_of(session, contract.id):
            if (open_minor := book.open_minor(invoice.id)) <= 0:
                continue
            if party is Party.STUDIO:
                self.steps.append(
                    NextStep(
                        kind=NextStepKind.PAY_INVOICE,
                        subject=invoice.full_number,
                        since=invoice.created_at,
                        amount_minor=open_minor,
                        **of_contract,
                    )
                )
            else:
                self.awaited.append(
                    Awaited(
                        kind=AwaitedKind.PAYMENT,
                        who=_other_side(contract, party),
                        subject=invoice.full_number,
                        since=invoice.created_at,
                        contract_id=contract.id,
                    )
                )
        billable = book.billable
        due_minor = sum(line.amount_minor for line in billable)
        is_deposit = due_minor > 0 and all(line.kind is LineKind.DEPOSIT for line in billable)
        if due_minor > 0 and party is Party.DESIGNER:
            self.steps.append(
                NextStep(
                    kind=NextStepKind.INVOICE_DEPOSIT if is_deposit else NextStepKind.INVOICE_DUE,
                    subject=contract.title,
                    since=contract.agreed_at if is_deposit else None,
                    amount_minor=due_minor,
                    **of_contract,
                )
            )
        elif due_minor > 0:
            self.awaited.append(
                Awaited(
                    kind=AwaitedKind.INVOICE,
                    who=contract.designer.name,
                    person_id=contract.designer_id,
                    subject=contract.title,
                    since=contract.agreed_at,
                    contract_id=contract.id,
                )
            )
        if is_deposit and party is Party.STUDIO:
            self.steps.append(
                NextStep(
                    kind=NextStepKind.DEPOSIT_DUE,
                    subject=contract.title,
                    since=contract.agreed_at,
                    amount_minor=due_minor,
                    **of_contract,
                )
            )
        if party is Party.STUDIO:
            self.steps += self._to_agree(contract)
        elif contract.state is ContractState.AGREED:
            refused = [
                worked_day.refused_at
                for worked_day in money.worked_days_of(session, contract.id)
                if worked_day.refused_at
            ]
            self._counted(NextStepKind.CORRECT_WORK, (len(refused), min(refused, default=None)))

    def _to_agree(self, contract: Contract) -> Iterator[NextStep]:
        of_contract = {"who": contract.designer.name, "contract_id": contract.id}
        for kind, logged in (
            (NextStepKind.AGREE_DAYS, money.waiting_work(self._session, contract.id, "quarters")),
            (NextStepKind.AGREE_HOURS, money.waiting_work(self._session, contract.id, "minutes")),
        ):
            if logged:
                since = datetime.combine(logged[0].worked_on, time(), UTC)
                yield NextStep(kind=kind, count=len(logged), since=since, **of_contract)
        for extra_round in money.extra_rounds_of(self._session, contract.id):
            if extra_round.agreed_at is None and extra_round.dropped_at is None:
                yield NextStep(
                    kind=NextStepKind.AGREE_ROUND,
                    subject=extra_round.cue.name,
                    since=extra_round.proposed_at,
                    **of_contract,
                )


def _other_side(contract: Contract, party: Party) -> str:
    return contract.designer.name if party is Party.STUDIO else contract.project.studio.name
