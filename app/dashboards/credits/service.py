"""The credits of a project: who worked on it by role, as each wants to be named."""

from collections.abc import Iterator
from dataclasses import dataclass
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.models import Person
from app.accounts.queries import members, people_by_id
from app.accounts.rules import Actor, Role
from app.agreements.clauses.named_term_queries import named_terms
from app.agreements.clauses.rules import filler
from app.agreements.queries import agreed_in
from app.dashboards import queries
from app.dashboards.credits.rules import Credit, CreditRole, in_order
from app.projects.approval.queries import category_approvers
from app.projects.credits.queries import credit_lines, credit_names
from app.projects.models import CreditName, Project
from app.projects.queries import approver_of, liaisons_of
from app.projects.service import project_access

Roles = list[tuple[CreditRole, UUID]]


@dataclass(frozen=True)
class ProjectCredits:
    """Credits as the caller sees them: the team all of them, a designer their own."""

    credits: list[Credit]
    left_out: int
    is_team: bool
    is_editor: bool
    my_name: str
    my_account_name: str
    am_left_out: bool


def project_credits(session: Session, actor: Actor, project_id: UUID) -> ProjectCredits:
    """Return the credits of a project, without the people who want to be left out."""
    access = project_access(session, actor, project_id)
    names = credit_names(session, project_id)
    roles = _roles_of_designers(session, project_id)
    if access.is_team:
        roles += _roles_of_team(session, access.project)
    else:
        roles = [(role, person_id) for role, person_id in roles if person_id == actor.person]
    people = people_by_id(session, {person_id for _, person_id in roles} | {actor.person})
    by_hand = credit_lines(session, project_id) if access.is_team else []
    shown = list(_named(roles, people, names, _agreed_lines(session, actor, project_id)))
    shown += [Credit(line.role, line.name, line_id=line.id) for line in by_hand]
    mine = names.get(actor.person)
    return ProjectCredits(
        credits=in_order(shown),
        left_out=len({person_id for _, person_id in roles if person_id in names and names[person_id].is_left_out}),
        is_team=access.is_team,
        is_editor=access.is_producer,
        my_name=mine.name if mine else "",
        my_account_name=people[actor.person].name,
        am_left_out=mine.is_left_out if mine else False,
    )


def credits_to_export(session: Session, actor: Actor, project_id: UUID) -> list[Credit]:
    """Return all credits of a project; raise TeamNeeded for a designer, who sees their own alone."""
    project_access(session, actor, project_id).ensure_team()
    return project_credits(session, actor, project_id).credits


def _roles_of_designers(session: Session, project_id: UUID) -> Roles:
    return [
        (CreditRole.SOUND_DESIGN, designer) for designer in queries.designers_with_approved_takes(session, project_id)
    ]


def _roles_of_team(session: Session, project: Project) -> Roles:
    approvers = {approver_of(session, project)}
    approvers |= {
        category_approver.person_id
        for category_approver in category_approvers(session, [project.id])
        if category_approver.person_id
    }
    liaisons = {liaison.person_id for liaison in liaisons_of(session, [project.id])} - approvers
    producers = {member.person_id for member in members(session, project.studio_id) if Role.PRODUCER in member.roles}
    return [
        *((CreditRole.AUDIO_DIRECTION, person_id) for person_id in approvers),
        *((CreditRole.AUDIO_LEAD, person_id) for person_id in liaisons),
        *((CreditRole.PRODUCTION, person_id) for person_id in producers),
    ]


def _named(
    roles: Roles, people: dict[UUID, Person], names: dict[UUID, CreditName], agreed_lines: dict[UUID, str]
) -> Iterator[Credit]:
    for role, person_id in roles:
        credit_name = names.get(person_id)
        if credit_name is None or not credit_name.is_left_out:
            name = (credit_name.name if credit_name else "") or people[person_id].name
            agreed = agreed_lines.get(person_id, "") if role is CreditRole.SOUND_DESIGN else ""
            yield Credit(role.value, name, person_id=person_id, agreed_line=agreed)


def _agreed_lines(session: Session, actor: Actor, project_id: UUID) -> dict[UUID, str]:
    """Return by designer the line in the credits that their contract names to the letter."""
    contracts = agreed_in(session, actor, project_id)
    terms = named_terms(session, contracts)
    lines = {}
    for contract in contracts:
        if line := terms[contract.id].get("credit_line"):
            facts = {"designer": contract.designer.name, "project": contract.project.name}
            facts["studio"] = contract.project.studio.name
            lines[contract.designer_id] = filler({}, facts, contract.currency)(str(line))
    return lines
