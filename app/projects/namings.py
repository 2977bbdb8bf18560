"""The rights of a membership in the projects of a studio, and their end with the membership or with its roles."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from datetime import timedelta
from typing import Any
from uuid import UUID

from sqlalchemy import delete
from sqlalchemy.orm import Session

from app.accounts.errors import CannotTakeOver, HandOverNeeded
from app.accounts.queries import membership, people_by_id
from app.accounts.rules import LEAD_ROLES, MemberChange, Role
from app.core import clock
from app.core.errors import FieldProblem
from app.core.plural import counted
from app.projects import queries
from app.projects.approval import queries as approval_queries
from app.projects.members import queries as member_queries
from app.projects.members import service as members
from app.projects.models import ApproverChange, CategoryApprover, Deputy, Liaison, Project, ProjectInvitation

A_DAY = timedelta(days=1)  # somewhere it is still yesterday, counted from UTC


@dataclass(frozen=True)
class Namings:
    """Namings of a person in the projects of a studio that some roles there do not allow."""

    approves: Sequence[Project]
    leads: Sequence[Project]
    categories: Sequence[CategoryApprover]
    deputies: Sequence[Deputy]
    invitations: Sequence[ProjectInvitation]  # of designers, not accepted yet


def namings_ending(session: Session, studio_id: UUID, person_id: UUID, roles: frozenset[Role]) -> Namings:
    """Return the namings that end for a member whose roles become these; without roles, all."""
    if Role.PRODUCER in roles:
        return Namings((), (), (), (), ())
    led = queries.projects_led_by(session, studio_id, person_id)
    goes_on = {project.id for project in led} if Role.LIAISON in roles else set()
    categories = approval_queries.category_approvers(session, approval_queries.project_ids_of(session, studio_id))
    yesterday = clock.now().date() - A_DAY
    deputies = approval_queries.deputies_with(session, studio_id, person_id, until=yesterday)
    invitations = [] if roles & LEAD_ROLES else queries.open_invitations_by(session, studio_id, person_id)
    return Namings(
        approves=[
            project
            for project in queries.projects_approved_by(session, studio_id, person_id)
            if project.id not in goes_on
        ],
        leads=[project for project in led if project.id not in goes_on],
        categories=[row for row in categories if row.person_id == person_id and row.project_id not in goes_on],
        deputies=[deputy for deputy in deputies if deputy.project_id not in goes_on],
        invitations=invitations,
    )


def end_namings(session: Session, payload: Mapping[str, Any]) -> None:
    """End the namings of a member who left or has other roles now: a handler of `member.changed`.

    Raises HandOverNeeded while they approve a project and nobody takes over, CannotTakeOver for who may not approve.
    """
    change = MemberChange.of(payload)
    namings = namings_ending(session, change.studio_id, change.person_id, change.roles)
    if namings.approves:
        _hand_approval_over(session, change, namings.approves)
    session.execute(
        delete(Liaison).where(
            Liaison.person_id == change.person_id, Liaison.project_id.in_([project.id for project in namings.leads])
        )
    )
    for named in namings.categories:
        session.add(
            CategoryApprover(
                studio_id=named.studio_id,
                project_id=named.project_id,
                category=named.category,
                person_id=None,
                named_by=change.changed_by,
            )
        )
    for deputy in namings.deputies:
        deputy.withdrawn_at = clock.now()
    for invitation in namings.invitations:
        invitation.revoked_at = clock.now()
    session.flush()
    members.end_membership(session, change)


def _hand_approval_over(session: Session, change: MemberChange, projects: Sequence[Project]) -> None:
    name = people_by_id(session, {change.person_id})[change.person_id].name
    if change.hand_over_to is None:
        seen = [project for project in projects if member_queries.is_open_to(session, project, change.changed_by)]
        names = [project.name for project in seen]
        if len(seen) < len(projects):
            names.append(
                counted(len(projects) - len(seen), "project that you are not in", "projects that you are not in")
            )
        raise HandOverNeeded(
            f"{name} is the approver of {', '.join(names)}",
            errors=[
                FieldProblem(where=f"projects.{project.id}", message=f"the approver of {project.name}")
                for project in seen
            ],
            fix="say who takes over as hand_over_to, or name another approver in each of these projects",
        )
    successor = membership(session, change.studio_id, change.hand_over_to)
    is_other = change.hand_over_to != change.person_id
    if successor is None or LEAD_ROLES.isdisjoint(successor.roles) or not is_other:
        message = "choose another person, who is a producer or an audio lead of the studio"
        raise CannotTakeOver(message, errors=[FieldProblem(where="hand_over_to", message=message)])
    why = "left the studio" if change.has_left else "has another role now"
    for project in projects:
        is_liaison = queries.is_liaison(session, project.id, successor.person_id)
        if Role.PRODUCER not in successor.roles and not is_liaison:
            session.add(Liaison(project_id=project.id, person_id=successor.person_id, studio_id=change.studio_id))
        session.add(
            ApproverChange(
                studio_id=change.studio_id,
                project_id=project.id,
                person_id=successor.person_id,
                reason=f"takes over from {name}, who {why}",
                changed_by=change.changed_by,
            )
        )
        members.ensure_member(session, project, successor.person_id)
