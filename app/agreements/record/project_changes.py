"""Changes of list, questions and delivery spec under running contracts, written into the contracts' records."""

from collections.abc import Mapping
from itertools import groupby
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.agreements.drafts.documents import sha256_of
from app.agreements.models import Contract
from app.agreements.plan import queries as plan_queries
from app.agreements.record import service as record
from app.agreements.record.sealed_facts import sealed
from app.agreements.rules import ORDERS
from app.briefs.kick_off.queries import decisions_of
from app.core import clock
from app.core.recorded_rows import TABLES, RowChanges
from app.projects.models import Project
from app.projects.queries import spec_version
from app.sound_lists.models import Question
from app.sound_lists.rules import label


def record_list_revision(session: Session, event: Mapping[str, Any]) -> None:
    """Write a revision of the sound list into the record of each running contract whose cues it changes."""
    project_id, number = UUID(event["project_id"]), event["revision"]
    prefix = session.get_one(Project, project_id).cue_prefix
    changes = plan_queries.covered_changes(session, project_id, number)
    for contract_id, of_contract in groupby(changes, key=lambda row: row.contract_id):
        rows = list(of_contract)
        facts = {
            "revision": number,
            "cues": [f"{label(prefix, row.number)} {row.name}" for row in rows],
            "sha256": {str(row.cue_id): sealed(row.after) for row in rows},
        }
        record.append(session, contract_id, "list_revised", facts, by=UUID(event["actor_id"]))


def record_question(session: Session, event: Mapping[str, Any]) -> None:
    """Write a question on a cue into the record of each running contract that it belongs to."""
    question = session.get_one(Question, UUID(event["question_id"]))
    rows = RowChanges().add(question)
    _record_on_cue(session, question, "question_asked", {"text": question.text}, question.asked_by, rows)


def record_answer(session: Session, event: Mapping[str, Any]) -> None:
    """Write the answer to a question into the record of each running contract that it belongs to."""
    question = session.get_one(Question, UUID(event["question_id"]))
    rows = RowChanges()
    rows.change(question, TABLES[Question].facts(question))  # whole: it may have been asked before the contract
    facts = {"text": question.text, "answer": question.answer}
    _record_on_cue(session, question, "question_answered", facts, question.answered_by, rows)


def _record_on_cue(
    session: Session, question: Question, kind: str, facts: Mapping[str, Any], by: UUID | None, rows: RowChanges
) -> None:
    prefix = session.get_one(Project, question.project_id).cue_prefix
    for covered in plan_queries.contracts_for_question(session, question):
        cue = f"{label(prefix, covered.cue.number)} {covered.cue.name}"
        on_cue = {"cue": cue, "cue_id": str(covered.cue_id), "question_id": str(question.id), **facts}
        record.append(session, covered.contract_id, kind, on_cue, by=by, rows=rows)


def record_spec_version(session: Session, event: Mapping[str, Any]) -> None:
    """Write a new version of the delivery spec into the record of each running contract of its project."""
    project_id, version = UUID(event["project_id"]), event["version"]
    spec = spec_version(session, project_id, version)
    facts = {"spec_version": version, "toml_sha256": sha256_of(spec.toml) if spec else ""}
    for contract_id in plan_queries.running_contracts(session, project_id):
        record.append(session, contract_id, "spec_changed", facts, by=UUID(event["person_id"]))


def record_decisions(session: Session, event: Mapping[str, Any]) -> None:
    """Write the decisions of the talks before a contract that was signed into its record; they change no more."""
    contract = session.get_one(Contract, UUID(event["contract_id"]))
    decisions = decisions_of(session, contract.project_id)
    if contract.kind not in ORDERS or not decisions:
        return
    for decision in decisions:
        decision.signed_at = decision.signed_at or clock.now()
    facts = [
        {"decided_on": decision.decided_on.isoformat(), "attended": decision.attended, "text": decision.text}
        for decision in decisions
    ]
    record.append(session, contract.id, "kick_off", {"decisions": facts}, by=UUID(event["person_id"]))
