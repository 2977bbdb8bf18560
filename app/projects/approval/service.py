"""Approvers of sounds: the project's approver, approvers of categories, and deputies from one day to another."""

from collections import defaultdict
from collections.abc import Collection, Mapping, Sequence
from datetime import date, timedelta
from uuid import UUID
from zoneinfo import ZoneInfo

from sqlalchemy.orm import Session

from app.accounts.calendars.service import time_zones_of
from app.accounts.queries import membership, people_by_id, studio_locked
from app.accounts.rules import Actor, Role
from app.core import clock
from app.core.db import bypass_row_policies
from app.projects import queries
from app.projects.approval import queries as approval_queries
from app.projects.errors import ApproverNeeded, DeputyNotFound
from app.projects.members.service import ensure_member
from app.projects.models import CategoryApprover, Deputy, Project
from app.projects.rules import NO_CUE, ApprovalRights, ApprovalScope, ensure_can_approve, ensure_deputy
from app.projects.service import ProjectAccess, project_access

EARLIEST = timedelta(days=1)  # somewhere it is still yesterday, counted from UTC


def approval_rights(session: Session, project: Project) -> ApprovalRights:
    """Return the approval rights in a project today."""
    return approval_rights_of(session, {project.id: queries.approver_of(session, project)})[project.id]


def approval_rights_of(session: Session, approver_ids: Mapping[UUID, UUID]) -> dict[UUID, ApprovalRights]:
    """Return today's approval rights in each project, given their approvers."""
    by_category: defaultdict[UUID, dict[str, UUID]] = defaultdict(dict)
    named = approval_queries.category_approvers(session, approver_ids)
    deputies_and_zones = _deputies(session, approver_ids)
    in_studio = _members(session, named, [named_deputy for named_deputy, _ in deputies_and_zones])
    for category in named:
        if category.person_id is not None and (category.studio_id, category.person_id) in in_studio:
            by_category[category.project_id][category.category] = category.person_id
    deputies: defaultdict[UUID, defaultdict[UUID, list[UUID]]] = defaultdict(lambda: defaultdict(list))
    for deputy, time_zone in deputies_and_zones:
        is_today = deputy.from_on <= today_in(time_zone) <= deputy.until_on
        of_person = deputies[deputy.project_id][deputy.person_id]
        if is_today and _are_members(deputy, in_studio) and deputy.deputy_id not in of_person:
            of_person.append(deputy.deputy_id)
    return {
        project_id: ApprovalRights(approver_id, by_category[project_id], deputies[project_id])
        for project_id, approver_id in approver_ids.items()
    }


def _deputies(session: Session, project_ids: Collection[UUID]) -> list[tuple[Deputy, str]]:
    earliest = clock.now().date() - EARLIEST
    return [(deputy, zone) for deputy, zone in approval_queries.deputies(session, project_ids, until=earliest)]


def _members(
    session: Session, named: Sequence[CategoryApprover], deputies: Sequence[Deputy]
) -> Collection[tuple[UUID, UUID]]:
    """Return studio and person of those who are named and may approve with the roles they have in their studio."""
    people = {approver.person_id for approver in named if approver.person_id is not None}
    people |= {person_id for deputy in deputies for person_id in (deputy.person_id, deputy.deputy_id)}
    if not people:
        return ()
    studios = {approver.studio_id for approver in named} | {deputy.studio_id for deputy in deputies}
    with bypass_row_policies(session):  # a designer does not see the members of the studio
        return approval_queries.leads(session, studios, people)


def _are_members(deputy: Deputy, in_studio: Collection[tuple[UUID, UUID]]) -> bool:
    return (deputy.studio_id, deputy.deputy_id) in in_studio and (deputy.studio_id, deputy.person_id) in in_studio


def today_in(time_zone: str) -> date:
    """Return the day that it is in a time zone."""
    return clock.now().astimezone(ZoneInfo(time_zone)).date()


def approval_scope(session: Session, access: ProjectAccess) -> ApprovalScope:
    """Return the cues that the caller approves today."""
    if not access.is_team:
        return NO_CUE
    return approval_rights(session, access.project).scope_of(access.actor.person)


def approval_scopes(session: Session, actor: Actor) -> dict[UUID, ApprovalScope]:
    """Return the cues that a person approves today, by project, of the running projects of their studios."""
    projects = queries.running_projects(session, actor.roles)
    approver_ids = {project_id: person.id for project_id, person in queries.approvers_of(session, projects).items()}
    rights = approval_rights_of(session, approver_ids)
    return {project_id: project_rights.scope_of(actor.person) for project_id, project_rights in rights.items()}


def ensure_may_approve(session: Session, access: ProjectAccess, category: str) -> UUID | None:
    """Raise ApproverNeeded unless the caller may approve in a category today; return for whom, if as a deputy."""
    rights = approval_rights(session, access.project)
    if access.is_team and access.actor.person in rights.people_for(category):
        return rights.on_behalf_of(access.actor.person, category)
    if category not in rights.by_category:
        raise ApproverNeeded("only the project's approver decides; add a comment instead")
    approver_id = rights.approver_of(category)
    name = people_by_id(session, {approver_id})[approver_id].name
    raise ApproverNeeded(f"{name} decides on sounds of the category {category}; add a comment instead")


def name_category_approver(
    session: Session, actor: Actor, project_id: UUID, *, category: str, person_id: UUID | None
) -> None:
    """Give a category an approver of its own, or with None the project's."""
    access = project_access(session, actor, project_id)
    access.ensure_producer()
    if person_id is not None:
        _ensure_can_approve(session, access.project, person_id, where="person_id")
    session.add(
        CategoryApprover(
            studio_id=access.project.studio_id,
            project_id=project_id,
            category=category,
            person_id=person_id,
            named_by=actor.person,
        )
    )
    session.flush()


def _ensure_can_approve(session: Session, project: Project, person_id: UUID, *, where: str) -> None:
    studio_locked(session, project.studio_id)  # nobody leaves between the look and the naming
    member = membership(session, project.studio_id, person_id)
    ensure_can_approve(
        is_liaison=member is not None and queries.is_liaison(session, project.id, person_id),
        is_producer=member is not None and Role.PRODUCER in member.roles,
        where=where,
    )
    ensure_member(session, project, person_id)


def deputies_named(session: Session, actor: Actor, project_id: UUID) -> tuple[str, list[Deputy]]:
    """Return the studio's time zone, and the deputies of today and of later days."""
    access = project_access(session, actor, project_id)
    access.ensure_team()
    time_zone = _time_zone(session, access.project)
    today = today_in(time_zone)
    named_deputies = [deputy for deputy, _ in _deputies(session, [project_id]) if deputy.until_on >= today]
    in_studio = _members(session, (), named_deputies)
    return time_zone, [deputy for deputy in named_deputies if _are_members(deputy, in_studio)]


def name_deputy(
    session: Session,
    actor: Actor,
    project_id: UUID,
    *,
    person_id: UUID,
    deputy_id: UUID,
    from_on: date,
    until_on: date,
) -> Deputy:
    """Name a deputy for a person from one day to another, both included, in the studio's time zone."""
    access = project_access(session, actor, project_id)
    access.ensure_producer()
    _ensure_can_approve(session, access.project, person_id, where="person_id")
    _ensure_can_approve(session, access.project, deputy_id, where="deputy_id")
    today = today_in(_time_zone(session, access.project))
    ensure_deputy(person_id, deputy_id, from_on=from_on, until_on=until_on, today=today)
    deputy = Deputy(
        studio_id=access.project.studio_id,
        project_id=project_id,
        person_id=person_id,
        deputy_id=deputy_id,
        from_on=from_on,
        until_on=until_on,
        named_by=actor.person,
    )
    session.add(deputy)
    session.flush()
    session.refresh(deputy, ["person", "deputy"])
    return deputy


def withdraw_deputy(session: Session, actor: Actor, project_id: UUID, deputy_id: UUID) -> None:
    """End the right of a deputy at once."""
    project_access(session, actor, project_id).ensure_producer()
    deputy = approval_queries.deputy_by_id(session, project_id, deputy_id)
    if deputy is None:
        raise DeputyNotFound(f"no deputy {deputy_id} in this project")
    deputy.withdrawn_at = clock.now()
    session.flush()


def _time_zone(session: Session, project: Project) -> str:
    return time_zones_of(session, {project.studio_id})[project.studio_id]
