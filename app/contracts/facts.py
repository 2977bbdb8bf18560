"""What the server fills into a contract: names, the list, open questions, and the plan of milestones."""

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from datetime import date
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.models import Person
from app.contracts import money_queries
from app.contracts.models import Contract
from app.contracts.rules import ReleaseClause
from app.contracts.text import literal
from app.kit.money import money, percent
from app.projects.queries import current_spec, decider_of
from app.sound_lists.models import Cue
from app.sound_lists.queries import cues_of, questions_of, revision_number
from app.sound_lists.rules import CueState, label

RELEASE_SENTENCES = {
    ReleaseClause.PER_CUE: "Each cue's share is due when the cue is accepted.",
    ReleaseClause.ON_COMPLETION: "A milestone is due when the last of its cues is accepted.",
}
DEPOSIT_SENTENCE = "Of it {} is a deposit, due when this is agreed."
HOLDBACK_SENTENCE = "Of each share {} is held back, and due when all cues are accepted."
NONE_YET = "None has been written down yet."


@dataclass(frozen=True)
class PlannedMilestone:
    """One milestone as a contract's text tells it."""

    name: str
    due_on: date | None
    cue_ids: Collection[UUID]
    amount_minor: int


def plan_of(session: Session, contract: Contract) -> Sequence[PlannedMilestone]:
    """Return the milestones of a contract, in order."""
    cues = money_queries.cues_of(session, contract.id)
    return [
        PlannedMilestone(
            name=milestone.name,
            due_on=milestone.due_on,
            cue_ids=[cue.cue_id for cue in cues if cue.milestone_id == milestone.id],
            amount_minor=milestone.amount_minor,
        )
        for milestone in money_queries.milestones_of(session, contract.id)
    ]


def facts_of(session: Session, contract: Contract) -> dict[str, str]:
    """Return the value of every variable that the server fills in, as Markdown."""
    project = contract.project
    plan = plan_of(session, contract)
    of_plan = {cue_id for milestone in plan for cue_id in milestone.cue_ids}
    wanted = [cue for cue in cues_of(session, project.id) if cue.state is not CueState.CUT]
    cues = [cue for cue in wanted if cue.id in of_plan] if of_plan else wanted
    decider = session.get_one(Person, decider_of(session, project))
    planned_minor = sum(milestone.amount_minor for milestone in plan)
    return {
        "studio": literal(project.studio.name),
        "designer": literal(contract.designer.name),
        "project": literal(project.name),
        "decider": literal(decider.name),
        "currency": contract.currency,
        "list_revision": str(revision_number(session, project.id)),
        "spec_version": str(current_spec(session, project.id).version),
        "cue_count": str(len(cues)),
        "file_count": str(sum(cue.variations for cue in cues)),
        "cues": _cue_table(cues, project.cue_prefix),
        "open_questions": _questions(session, contract, {cue.id for cue in cues}),
        "milestones": _milestone_table(plan, cues, contract),
        "total": money(planned_minor, contract.currency),
        "deposit_sentence": DEPOSIT_SENTENCE.format(percent(contract.deposit_bp)) if contract.deposit_bp else "",
        "holdback_sentence": HOLDBACK_SENTENCE.format(percent(contract.holdback_bp)) if contract.holdback_bp else "",
        "release_sentence": RELEASE_SENTENCES[contract.release_clause],
        **_framework(session, contract),
    }


def in_words(day: date) -> str:
    """Return a day as texts write it: Friday 20 November 2026."""
    return f"{day:%A} {day.day} {day:%B %Y}"


def _framework(session: Session, contract: Contract) -> dict[str, str]:
    if contract.framework_id is None:
        return {"framework_title": "", "framework_agreed_on": ""}
    framework = session.get_one(Contract, contract.framework_id)
    agreed = in_words(framework.agreed_at.date()) if framework.agreed_at else ""
    return {"framework_title": literal(framework.title), "framework_agreed_on": agreed}


def _cue_table(cues: Sequence[Cue], cue_prefix: str) -> str:
    if not cues:
        return NONE_YET
    rows = ["| Number | Sound | Files | Length |", "| --- | --- | --- | --- |"]
    for cue in cues:
        length = f"{cue.duration_s:.2f} s" if cue.duration_s else ""
        kind = " (loop)" if cue.loop else ""
        rows.append(f"| {label(cue_prefix, cue.number)} | {literal(cue.name)}{kind} | {cue.variations} | {length} |")
    return "\n".join(rows)


def _questions(session: Session, contract: Contract, cue_ids: Collection[UUID]) -> str:
    prefix = contract.project.cue_prefix
    lines = [
        f"- {label(prefix, question.cue.number)} {literal(question.cue.name)}: {literal(question.text)}"
        for question in questions_of(session, contract.project_id, only_open=True)
        if question.cue_id in cue_ids
    ]
    return "\n".join(lines) or "No question is open."


def _milestone_table(plan: Sequence[PlannedMilestone], cues: Sequence[Cue], contract: Contract) -> str:
    if not plan:
        return NONE_YET
    numbers = {cue.id: label(contract.project.cue_prefix, cue.number) for cue in cues}
    rows = ["| Milestone | Date | Cues | Amount |", "| --- | --- | --- | --- |"]
    for milestone in plan:
        named = ", ".join(numbers[cue_id] for cue_id in numbers if cue_id in milestone.cue_ids)
        day = in_words(milestone.due_on) if milestone.due_on else ""
        rows.append(
            f"| {literal(milestone.name)} | {day} | {named} | {money(milestone.amount_minor, contract.currency)} |"
        )
    return "\n".join(rows)
