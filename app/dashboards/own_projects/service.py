"""The projects of a designer: credit, people and playlists, as long as they are engaged."""

from contextlib import suppress

from sqlalchemy.orm import Session

from app.accounts.queries import people_by_id
from app.accounts.rules import Actor
from app.accounts.schemas import PersonBrief
from app.agreements.clauses.named_term_queries import named_terms
from app.agreements.queries import agreed_in
from app.dashboards import queries
from app.dashboards.credits.rules import CreditRole
from app.dashboards.credits.service import project_credits
from app.dashboards.own_projects.schemas import Colleague, OwnProject
from app.deliveries.handoffs.queries import partners_of
from app.projects.errors import NdaNeeded, ProjectNotFound
from app.projects.models import Project
from app.projects.queries import approver_of, liaisons_of
from app.projects.service import project_access
from app.shares.playlists import playlists_of


def own_projects(session: Session, actor: Actor) -> list[OwnProject]:
    """Return the projects that the caller is engaged on, the newest first; those behind an NDA are left out."""
    projects = list[Project]()
    for engagement in reversed(queries.my_engagements(session, actor.person)):
        with suppress(NdaNeeded, ProjectNotFound):
            projects.append(project_access(session, actor, engagement.project_id).project)
    studio_names = queries.studio_names(session, {project.studio_id for project in projects})
    return [_read(session, actor, project, studio_names[project.studio_id]) for project in projects]


def _read(session: Session, actor: Actor, project: Project, studio_name: str) -> OwnProject:
    listed = project_credits(session, actor, project.id)
    own_credits = [credit for credit in listed.credits if credit.person_id == actor.person]
    contracts = [contract for contract in agreed_in(session, actor, project.id) if contract.designer_id == actor.person]
    shown_from = [terms["reel_from"] for terms in named_terms(session, contracts).values() if terms.get("reel_from")]
    return OwnProject(
        project_id=project.id,
        project_name=project.name,
        studio_name=studio_name,
        credit_name=listed.my_name or listed.my_account_name,
        is_left_out=listed.am_left_out,
        credit_roles=[credit.role for credit in own_credits],
        agreed_line=next((credit.agreed_line for credit in own_credits if credit.agreed_line), ""),
        shown_from=str(shown_from[-1]) if shown_from else "",
        people=_people(session, actor, project),
        playlists=playlists_of(session, actor, project.id),
    )


def _people(session: Session, actor: Actor, project: Project) -> list[Colleague]:
    """Return approver and liaisons, whom every designer of a project sees, and the partners of hand-offs."""
    approver_id = approver_of(session, project)
    roles = {liaison.person_id: CreditRole.AUDIO_LEAD for liaison in liaisons_of(session, [project.id])}
    roles |= dict.fromkeys(partners_of(session, project.id, actor.person), CreditRole.SOUND_DESIGN)
    roles[approver_id] = CreditRole.AUDIO_DIRECTION
    people = people_by_id(session, roles.keys() - {actor.person})
    return [
        Colleague(person=PersonBrief.model_validate(people[person_id]), role=role.value)
        for person_id, role in roles.items()
        if person_id in people
    ]
