"""The server's entries in a contract: names, the list, open questions, and the plan of milestones."""

from collections.abc import Collection, Mapping, Sequence
from datetime import date
from typing import Protocol
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.queries import people_by_id
from app.agreements.clauses.rules import Clause, names_in
from app.agreements.clauses.text import Marker, literal, unmarked
from app.agreements.errors import BriefOpen
from app.agreements.joint.parts import parts_of, price_minor, table_of
from app.agreements.models import Contract, ContractCue, Milestone
from app.agreements.plan.queries import cues_of as covered_cues
from app.agreements.plan.queries import milestones_of
from app.agreements.rules import ContractKind, ReleaseClause
from app.briefs.service import OpenAnswer, answers_in_words, open_answers
from app.core.errors import FieldProblem
from app.core.money import money, percent
from app.projects.approval.service import approval_rights
from app.projects.models import Project
from app.projects.queries import current_spec
from app.sound_lists.models import Cue
from app.sound_lists.queries import cues_of, questions_of, revision_number
from app.sound_lists.rules import CueState, label, length_in_words

RELEASE_SENTENCES = {
    ReleaseClause.PER_CUE: "Each cue's share is due when the cue is accepted.",
    ReleaseClause.ON_COMPLETION: "A milestone is due when the last of its cues is accepted.",
}
DEPOSIT_SENTENCE = "Of it {} is a deposit, due when this is agreed."
HOLDBACK_SENTENCE = "Of each share {} is held back, and due when all cues are accepted."
OPEN_QUESTIONS = "open_questions"
STATED = ("platforms", "playback", "effects", "player", "quality", "loudness", "music_style", "similar")  # of the brief
NONE_YET = "None has been written down yet."


class PaymentTerms(Protocol):
    """The terms of a contract, or of a draft that is not saved yet, on its payment."""

    currency: str
    release_clause: ReleaseClause
    holdback_bp: int


def facts_of(
    session: Session,
    contract: Contract,
    terms: Mapping[str, object],
    priced: PaymentTerms | None = None,
    mark: Marker = unmarked,
) -> dict[str, str]:
    """Return the value of every variable that the server fills in, as Markdown, priced as it is or otherwise.

    `mark` marks the figures of the plan: `total`, `deposit`, and `milestone.POSITION` for what a milestone pays.
    """
    priced = priced or contract
    project = contract.project
    milestones, covered = milestones_of(session, contract.id), covered_cues(session, contract.id)
    prices = {each.cue_id: each.price_minor for each in covered}
    listed_cues = [cue for cue in cues_of(session, project.id) if cue.state is not CueState.CUT]
    cues = [cue for cue in listed_cues if cue.id in prices] if prices else listed_cues
    total_minor = price_minor(milestones, terms)
    deposit_minor = sum(milestone.amount_minor for milestone in milestones if milestone.is_deposit)
    return {
        "studio": literal(project.studio.name),
        "designer": literal(contract.designer.name),
        "project": literal(project.name),
        "approver": _approver(session, project),
        "currency": priced.currency,
        "list_revision": str(revision_number(session, project.id)),
        "spec_version": str(current_spec(session, project.id).version),
        "cue_count": str(len(cues)),
        "file_count": str(sum(cue.variations for cue in cues)),
        "cues": _cue_table(cues, prices, project.cue_prefix, priced.currency),
        "brief_answers": _brief_answers(session, project.id),
        OPEN_QUESTIONS: _questions(session, contract, {cue.id for cue in cues}),
        "milestones": _milestone_table(milestones, covered, project.cue_prefix, priced.currency, mark),
        "total": mark("total", money(total_minor, priced.currency)),
        "joint_work": _joint_work(session, contract, terms, priced.currency),
        "deposit_sentence": DEPOSIT_SENTENCE.format(mark("deposit", money(deposit_minor, priced.currency)))
        if deposit_minor
        else "",
        "holdback_sentence": HOLDBACK_SENTENCE.format(percent(priced.holdback_bp)) if priced.holdback_bp else "",
        "release_sentence": RELEASE_SENTENCES[priced.release_clause],
        **_framework(session, contract),
    }


def _approver(session: Session, project: Project) -> str:
    """Return the project's approver, and the approvers of categories with an approver of their own."""
    rights = approval_rights(session, project)
    people = people_by_id(session, {rights.approver_id, *rights.by_category.values()})
    name = literal(people[rights.approver_id].name)
    by_category = [
        f"for {literal(category)} {literal(people[approver_id].name)}"
        for category, approver_id in rights.by_category.items()
    ]
    return f"{name} ({', '.join(by_category)})" if by_category else name


def ensure_open_answers_are_said(session: Session, contract: Contract, clauses: Sequence[Clause]) -> None:
    """Raise BriefOpen for a contract on work with a needed answer of the brief open and not printed in its text."""
    if contract.kind not in (ContractKind.SINGLE, ContractKind.STATEMENT_OF_WORK):
        return
    if OPEN_QUESTIONS in names_in([clause for clause in clauses if clause.stands]):
        return
    needed = [answer for answer in open_answers(session, contract.project_id) if answer.required]
    if needed:
        counted = "a needed answer" if len(needed) == 1 else f"{len(needed)} needed answers"
        raise BriefOpen(
            f"{counted} of the brief {'is' if len(needed) == 1 else 'are'} open",
            errors=[FieldProblem(where=f"question {answer.number}", message=answer.text) for answer in needed],
            fix="answer in the brief, or put back the clause that prints the open questions",
        )


def _joint_work(session: Session, contract: Contract, terms: Mapping[str, object], currency: str) -> str:
    parts = parts_of(session, contract, terms, currency)
    return table_of(parts, contract.project.cue_prefix) if parts else "There is no other contract."


def format_long_date(day: date) -> str:
    """Return a day as texts write it: Friday 20 November 2026."""
    return f"{day:%A} {day.day} {day:%B %Y}"


def _framework(session: Session, contract: Contract) -> dict[str, str]:
    if contract.framework_id is None:
        return {"framework_title": "", "framework_agreed_on": ""}
    framework = session.get_one(Contract, contract.framework_id)
    agreed = format_long_date(framework.agreed_at.date()) if framework.agreed_at else ""
    return {"framework_title": literal(framework.title), "framework_agreed_on": agreed}


def _cue_table(cues: Sequence[Cue], prices: Mapping[UUID, int | None], cue_prefix: str, currency: str) -> str:
    if not cues:
        return NONE_YET
    heads = ["Number", "Sound", "Files", "Length", *(["Price"] if any(prices.values()) else [])]
    rows = [heads, ["---"] * len(heads)]
    for cue in cues:
        length = length_in_words(cue.duration_s, cue.duration_min_s, cue.duration_max_s)
        name = literal(cue.name) + (" (loop)" if cue.loop else "")
        price = prices.get(cue.id)
        cells = [label(cue_prefix, cue.number), name, str(cue.variations), length]
        rows.append([*cells, money(price, currency) if price is not None else ""][: len(heads)])
    return _table(rows)


def _table(rows: Sequence[Sequence[str]]) -> str:
    return "\n".join(f"| {' | '.join(cells)} |" for cells in rows)


def _questions(session: Session, contract: Contract, cue_ids: Collection[UUID]) -> str:
    prefix = contract.project.cue_prefix
    lines = [
        f"- {label(prefix, question.cue.number)} {literal(question.cue.name)}: {literal(question.text)}"
        for question in questions_of(session, contract.project_id, only_open=True)
        if question.cue_id in cue_ids
    ]
    lines += [_open_answer(answer) for answer in open_answers(session, contract.project_id)]
    return "\n".join(lines) or "No question is open."


def _brief_answers(session: Session, project_id: UUID) -> str:
    lines = [f"- {literal(text)} {literal(words)}" for text, words in answers_in_words(session, project_id, STATED)]
    return "\n".join(lines) or "The brief answers none of this yet."


def _open_answer(answer: OpenAnswer) -> str:
    needed = ", needed" if answer.required else ""
    note = f" {literal(answer.note)}" if answer.note else ""
    return f"- Brief, question {answer.number}{needed}: {literal(answer.text)}{note}"


def _milestone_table(
    milestones: Sequence[Milestone], covered: Sequence[ContractCue], cue_prefix: str, currency: str, mark: Marker
) -> str:
    if not milestones:
        return NONE_YET
    has_rates = any(milestone.tax_bp is not None for milestone in milestones)
    heads = ["Milestone", "Date", "Cues", "Amount", *(["Tax"] if has_rates else [])]
    rows = [heads, ["---"] * len(heads)]
    for milestone in milestones:
        labels = [label(cue_prefix, each.cue.number) for each in covered if each.milestone_id == milestone.id]
        day = "at signing" if milestone.is_deposit else format_long_date(milestone.due_on) if milestone.due_on else ""
        rate = percent(milestone.tax_bp) if milestone.tax_bp is not None else ""
        amount = mark(f"milestone.{milestone.position}", money(milestone.amount_minor, currency))
        cells = [literal(milestone.name), day, ", ".join(labels), amount, rate]
        rows.append(cells[: len(heads)])
    return _table(rows)
