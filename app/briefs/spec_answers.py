"""Answers write the delivery spec: what they ask for, shown beside the spec in force, and saved in one act."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.briefs import queries
from app.briefs.errors import AnswerChanged, NothingProposed
from app.briefs.questions import BY_KEY
from app.briefs.rules import number_of
from app.briefs.schemas import SpecChangeRead, SpecProposal
from app.briefs.spec_proposal import lines_of, proposal
from app.projects.errors import BadSpec
from app.projects.models import Spec
from app.projects.queries import current_spec, lock_project
from app.projects.service import project_access, save_spec
from app.projects.specs.service import read_spec, toml_of_form


def proposed_spec(session: Session, actor: Actor, project_id: UUID) -> SpecProposal:
    """Return the delivery spec as the answers ask for it; without a difference it is the spec in force."""
    project_access(session, actor, project_id)
    spec = current_spec(session, project_id)
    brief = queries.brief_of(session, project_id)
    tables, changes = proposal(read_spec(spec.toml).tables, brief.answers if brief else {})
    toml, errors = spec.toml, []
    if changes:
        try:
            toml = toml_of_form(tables)
            read_spec(toml)
        except BadSpec as refusal:
            errors = [refusal.message]
    return SpecProposal(
        based_on_version=spec.version,
        brief_revision=brief.revision if brief else 0,
        toml=toml,
        changes=[
            SpecChangeRead(
                place=change.place,
                before=change.before,
                after=change.after,
                question=change.question,
                number=number_of(BY_KEY[change.question]),
                lines=list(lines_of(change)),
            )
            for change in changes
        ],
        errors=errors,
    )


def apply_proposal(
    session: Session, actor: Actor, project_id: UUID, *, based_on_version: int, brief_revision: int
) -> Spec:
    """Save the proposed spec as a version, as if it had been typed; affected takes are checked again."""
    access = project_access(session, actor, project_id)
    access.ensure_may_speak()
    lock_project(session, project_id)
    proposed = proposed_spec(session, actor, project_id)
    if proposed.brief_revision != brief_revision:
        raise AnswerChanged("an answer was changed since the proposal was shown", fix="look at it again")
    if not proposed.changes:
        raise NothingProposed("the spec has what the answers ask for")
    numbers = sorted({change.number for change in proposed.changes})
    note = f"From the brief: {'question' if len(numbers) == 1 else 'questions'} {', '.join(map(str, numbers))}"
    return save_spec(session, actor, project_id, toml=proposed.toml, based_on_version=based_on_version, note=note)
