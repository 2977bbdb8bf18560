"""From a draft to a text that both parties accepted."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.models import Person
from app.accounts.rules import Actor
from app.agreements import queries
from app.agreements.access import contract_for_producer, contract_to_change, party_of, visible_contract
from app.agreements.clauses import rules as clause_rules
from app.agreements.clauses.facts import ensure_open_answers_are_said, facts_of
from app.agreements.clauses.rules import Clause, Terms, terms_in_force
from app.agreements.clauses.text import Block, blocks_of, head, marked
from app.agreements.clauses.text_faults import ensure_text_whole, text_faults
from app.agreements.drafts.documents import TextPdf
from app.agreements.drafts.previous_contract import copied_terms
from app.agreements.drafts.versions import add_version, newest_of, text_now
from app.agreements.errors import (
    AmountsNeeded,
    BadDraft,
    DraftChanged,
    FrameworkNeeded,
    NotYourContract,
    TemplateNotFound,
)
from app.agreements.joint.parts import facts_of_split
from app.agreements.joint.queries import other_contract
from app.agreements.joint.rules import CLAUSE as JOINT_CLAUSE
from app.agreements.joint.rules import ensure_one_currency
from app.agreements.joint.states import part_from_other, take_back_other
from app.agreements.models import Contract, ContractVersion
from app.agreements.plan.queries import milestones_of
from app.agreements.plan.service import enter_amounts
from app.agreements.record import service as record
from app.agreements.redlines.service import ensure_answered
from app.agreements.rules import (
    KIND_WORDS,
    ContractKind,
    ContractState,
    Party,
    ReleaseClause,
    ensure_another_person,
    ensure_ends_without_settlement,
    ensure_needs_contract,
    ensure_state,
    ensure_under_framework,
    next_action_hint,
)
from app.agreements.signing.service import signing_facts
from app.core import clock
from app.core.db import Database
from app.core.errors import FieldProblem, Refused
from app.core.events import publish
from app.core.money import money
from app.core.storage import Store
from app.projects.errors import EngagementNotFound
from app.projects.queries import engagement_by_id
from app.projects.rules import EngagementKind
from app.projects.service import project_access


@dataclass
class Draft:
    """The parts of a contract that a producer may change before it is sent."""

    title: str
    clauses: Sequence[Clause]
    terms: Terms
    currency: str
    release_clause: ReleaseClause
    holdback_bp: int


@dataclass(frozen=True)
class PreviewedClause:
    """A clause that stands in a draft, and where its text is among the blocks of the whole."""

    key: str
    number: int
    title: str
    first_block: int
    block_count: int


def contracts_of(session: Session, actor: Actor, project_id: UUID) -> Sequence[Contract]:
    """Return the contracts of a project that the caller may see, the oldest first."""
    project_access(session, actor, project_id, before_nda=True).ensure_party()
    return queries.contracts_in(session, actor, project_id)


def create_contract(
    session: Session,
    actor: Actor,
    project_id: UUID,
    *,
    engagement_id: UUID,
    kind: ContractKind,
    title: str,
    currency: str,
    template_id: UUID | None = None,
    framework_id: UUID | None = None,
    same_as_id: UUID | None = None,
    with_music: bool = False,
) -> Contract:
    """Begin a draft with one designer: from the library, from a template of the studio, or like another contract."""
    access = project_access(session, actor, project_id)
    access.ensure_producer()
    engagement = engagement_by_id(session, project_id, engagement_id)
    if engagement is None or engagement.ended_at is not None:
        raise EngagementNotFound(f"no running engagement {engagement_id} in this project")
    ensure_another_person(
        actor.person,
        session.get_one(Person, actor.person).email,
        [(engagement.designer_id, engagement.designer.email)],
    )
    ensure_needs_contract(is_in_house=engagement.kind is EngagementKind.IN_HOUSE)
    ensure_under_framework(kind, has_framework=framework_id is not None)
    if framework_id is not None:
        _ensure_framework(session, actor, framework_id, access.project.studio_id, engagement.designer_id)
    clauses, terms = clause_rules.default_clauses(kind, with_music=with_music)
    if template_id is not None:
        template = queries.template_by_id(session, access.project.studio_id, template_id)
        if template is None or template.kind is not kind:
            raise TemplateNotFound(f"the studio has no template {template_id} for a {KIND_WORDS[kind]}")
        clauses, terms = [Clause.of(row) for row in template.clauses], dict(template.terms)
    same_as = None
    if same_as_id is not None:
        same_as, clauses, terms = copied_terms(
            session,
            actor,
            same_as_id,
            studio_id=access.project.studio_id,
            kind=kind,
            designer_id=engagement.designer_id,
        )
    clauses = [replace(clause, stands=False) if clause.key == JOINT_CLAUSE else clause for clause in clauses]
    queries.lock_contracts_of(session, project_id)
    contract = Contract(
        studio_id=access.project.studio_id,
        project_id=project_id,
        engagement_id=engagement.id,
        designer_id=engagement.designer_id,
        framework_id=framework_id,
        number=queries.next_number(session, project_id),
        title=title,
        kind=kind,
        currency=currency,
        created_by=actor.person,
    )
    note = f"Begun as a {KIND_WORDS[kind]}"
    if same_as is not None:
        contract.release_clause, contract.holdback_bp = same_as.release_clause, same_as.holdback_bp
        contract.deposit_bp = same_as.deposit_bp
        note = f"Begun like {same_as.title}"
    session.add(contract)
    session.flush()
    whole = visible_contract(session, actor, contract.id)
    add_version(session, actor, whole, clauses, terms, note=note)
    return whole


def _ensure_framework(session: Session, actor: Actor, framework_id: UUID, studio_id: UUID, designer_id: UUID) -> None:
    framework = queries.contract_for(session, actor, framework_id)
    fits = (
        framework is not None
        and framework.kind is ContractKind.FRAMEWORK
        and framework.state is ContractState.AGREED
        and framework.studio_id == studio_id
        and framework.designer_id == designer_id
    )
    if not fits:
        message = "there is no framework agreement with that id that this designer has signed"
        raise FrameworkNeeded(
            message,
            errors=[{"where": "framework_id", "message": message}],
            fix="sign a framework agreement first, or use a single contract",
        )


def save_draft(
    session: Session,
    actor: Actor,
    contract_id: UUID,
    draft: Draft,
    *,
    based_on_version: int,
    note: str = "",
    amounts: Mapping[UUID, int] | None = None,
) -> ContractVersion:
    """Save a draft as its next version; the same text again is the version that it was.

    Another currency converts nothing: `amounts` are those of the plan's milestones in the new one. Raises AmountsNeeded
    where they are left out.
    """
    contract = contract_to_change(session, actor, contract_id)
    ensure_state(contract.state, {ContractState.DRAFT}, next_action_hint(contract.state, contract.kind))
    newest = newest_of(session, contract)
    if newest.number != based_on_version:
        raise DraftChanged(
            f"{newest.author.name} saved version {newest.number}; yours began from version {based_on_version}",
            fix=f"compare with version {newest.number}, then save what you still want",
        )
    _ensure_whole(session, contract, draft)
    if draft.currency != contract.currency:
        _ensure_amounts_entered(session, contract, draft, amounts)
        enter_amounts(session, contract, amounts or {})
    _put(contract, draft)
    return add_version(session, actor, contract, draft.clauses, draft.terms, note=note)


def preview(
    session: Session, actor: Actor, contract_id: UUID, draft: Draft
) -> tuple[list[Block], list[PreviewedClause], list[FieldProblem]]:
    """Return the text that a draft would have, its clauses in it, and what is wrong with it; nothing is saved."""
    contract = contract_for_producer(session, actor, contract_id)
    facts = facts_of(session, contract, terms_in_force(draft.clauses, draft.terms), draft, marked)
    fill = clause_rules.filler(draft.terms, facts, draft.currency, marked)
    blocks, clauses = [head(draft.title, 1)], list[PreviewedClause]()
    for number, clause in clause_rules.numbered(draft.clauses):
        blocks.append(head(f"{number}. {clause.title}", 2))
        clause_blocks = blocks_of(fill(clause.text).strip())
        clauses.append(PreviewedClause(clause.key, number, clause.title, len(blocks), len(clause_blocks)))
        blocks += clause_blocks
    problems = text_faults(session, contract, draft.clauses, draft.terms, holdback_bp=draft.holdback_bp)
    return blocks, clauses, problems


def pdfs_to_send(database: Database, actor: Actor, contract_id: UUID) -> dict[UUID, TextPdf]:
    """Return by contract the PDF of a draft as it would be sent now, and of the other draft of its joint work.

    They are made outside of any transaction, as it may take long.
    """
    titles: dict[UUID, str] = {}
    texts: dict[UUID, str] = {}
    with database.reading(actor.reach) as session:
        contract = contract_for_producer(session, actor, contract_id)
        for part in _with_other(session, contract):
            try:
                newest, clauses = _sendable(session, part)
            except Refused as refusal:
                if part is not contract:
                    refusal.message = f"{part.title}: {refusal.message}"
                raise
            titles[part.id], texts[part.id] = part.title, text_now(session, part, clauses, newest.terms)
    return {part_id: TextPdf.of(titles[part_id], text) for part_id, text in texts.items()}


def send(
    session: Session, store: Store, actor: Actor, contract_id: UUID, *, pdfs: Mapping[UUID, TextPdf], note: str = ""
) -> None:
    """Put the text before both parties as it reads now, and with it that of the other contract of its joint work.

    Raises DraftChanged where a PDF is of another text.
    """
    contract = contract_to_change(session, actor, contract_id)
    for part in _with_other(session, contract):
        _send(session, store, actor, part, pdf=pdfs.get(part.id), note=note)


def _with_other(session: Session, contract: Contract) -> list[Contract]:
    """Return a contract, with the other one of its joint work; raise BadDraft where their currencies differ."""
    other = other_contract(session, contract)
    if other is None:
        return [contract]
    ensure_one_currency(contract.currency, other.currency)
    return [contract, other]


def _send(session: Session, store: Store, actor: Actor, contract: Contract, *, pdf: TextPdf | None, note: str) -> None:
    newest, clauses = _sendable(session, contract)
    version = add_version(
        session, actor, contract, clauses, newest.terms, note="As sent", is_needed=newest.sent_at is not None
    )
    if pdf is None or version.text_sha256 != pdf.text_sha256:
        raise DraftChanged("the text changed while its PDF was made", fix="read it again, then send it")
    stored = store.put(contract.studio_id, [pdf.content])
    version.sent_at, version.pdf_sha256, version.pdf_bytes = clock.now(), stored.sha256, stored.size_bytes
    contract.state = ContractState.SENT
    session.flush()
    facts = {"note": note, **signing_facts(session, contract), **facts_of_split(session, contract)}
    record.append_by(session, actor, contract, "sent", version, **facts)
    publish(session, "contract.sent", studio_id=contract.studio_id, contract_id=contract.id, version=version.number)


def _sendable(session: Session, contract: Contract) -> tuple[ContractVersion, list[Clause]]:
    ensure_state(contract.state, {ContractState.DRAFT}, next_action_hint(contract.state, contract.kind))
    newest = newest_of(session, contract)
    clauses = [Clause.of(row) for row in newest.clauses]
    ensure_text_whole(session, contract, newest, "nothing was sent")
    ensure_open_answers_are_said(session, contract, clauses)
    ensure_answered(session, contract, (clauses, newest.terms))
    return newest, clauses


def recall(session: Session, actor: Actor, contract_id: UUID, *, reason: str) -> None:
    """Make a sent contract a draft again, for the studio to change; its acceptances no longer count."""
    contract = contract_to_change(session, actor, contract_id)
    ensure_state(contract.state, {ContractState.SENT}, next_action_hint(contract.state, contract.kind))
    contract.state = ContractState.DRAFT
    record.append_by(session, actor, contract, "taken_back", reason=reason)
    take_back_other(session, actor, contract)


def request_change(
    session: Session, actor: Actor, contract_id: UUID, *, text: str, clause_key: str | None = None
) -> None:
    """Send a contract back to the studio with what its designer wants otherwise."""
    contract = visible_contract(session, actor, contract_id)
    if party_of(actor, contract) is not Party.DESIGNER:
        raise NotYourContract("only the contract's designer requests a change; a producer recalls and edits it")
    contract = queries.lock_together(session, contract)
    ensure_state(contract.state, {ContractState.SENT}, next_action_hint(contract.state, contract.kind, Party.DESIGNER))
    contract.state = ContractState.DRAFT
    record.append_by(session, actor, contract, "change_requested", text=text, clause=clause_key or "")
    take_back_other(session, actor, contract)
    publish(session, "contract.change_requested", studio_id=contract.studio_id, contract_id=contract.id, text=text)


def end(session: Session, actor: Actor, contract_id: UUID, *, reason: str) -> None:
    """End a contract that orders no work, or give up a draft; either party may, and the reason is kept.

    Raises NoticeNeeded for an agreed contract that orders work.
    """
    contract = visible_contract(session, actor, contract_id)
    if party_of(actor, contract) is None:
        raise NotYourContract("only a producer of the studio and the contract's designer end it")
    contract = queries.lock_together(session, contract)
    running = {ContractState.DRAFT, ContractState.SENT, ContractState.AGREED}
    ensure_state(
        contract.state, running, "this is final: there is nothing left to end, and its text and record stay readable"
    )
    ensure_ends_without_settlement(contract.kind, contract.state)
    part_from_other(session, actor, contract, reason=reason)
    mark_ended(session, contract, reason=reason)
    record.append_by(session, actor, contract, "ended", reason=reason)


def mark_ended(session: Session, contract: Contract, *, reason: str) -> None:
    """Put a locked contract into its last state; callers record why."""
    contract.state, contract.ended_at, contract.end_reason = ContractState.ENDED, clock.now(), reason
    session.flush()


def _ensure_amounts_entered(
    session: Session, contract: Contract, draft: Draft, amounts: Mapping[UUID, int] | None
) -> None:
    """Raise AmountsNeeded unless every amount was entered again in the currency that a draft is to have.

    The plan's amounts are given beside the draft; with them, those among the terms count as entered again.
    """
    named = clause_rules.names_in([clause for clause in draft.clauses if clause.stands])
    library = clause_rules.known_terms()
    before = newest_of(session, contract).terms
    missing = [
        FieldProblem(
            where=f"milestones.{milestone.id}",
            message=f"{milestone.name}: {money(milestone.amount_minor, contract.currency)}",
        )
        for milestone in milestones_of(session, contract.id)
        if milestone.amount_minor and milestone.id not in (amounts or {})
    ]
    if amounts is None:
        missing += [
            FieldProblem(
                where=f"terms.{name}",
                message=f"{library[name].label if name in library else name}: {money(value, contract.currency)}",
            )
            for name, value in draft.terms.items()
            if name.endswith("_minor") and isinstance(value, int) and value and name in named
            if before.get(name) == value and not (name in library and library[name].default == value)
        ]
    if missing:
        listed = "; ".join(problem["message"] for problem in missing[:5])
        more = f" and {len(missing) - 5} more" if len(missing) > 5 else ""
        raise AmountsNeeded(
            f"the currency becomes {draft.currency}, and nothing is converted: {listed}{more}",
            errors=missing,
            fix=f"enter each amount again in {draft.currency}, or keep {contract.currency}",
        )


def _put(contract: Contract, draft: Draft) -> None:
    contract.title, contract.currency, contract.release_clause = draft.title, draft.currency, draft.release_clause
    contract.holdback_bp = draft.holdback_bp


def _ensure_whole(session: Session, contract: Contract, draft: Draft) -> None:
    problems = text_faults(session, contract, draft.clauses, draft.terms, holdback_bp=draft.holdback_bp)
    if problems:
        first = problems[0]
        raise BadDraft(f"nothing was saved; {first['where']}: {first['message']}", errors=problems)
