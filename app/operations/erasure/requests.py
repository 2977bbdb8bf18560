"""Erasures that people request in the browser: their own account at once, a project or a studio after some days."""

from collections.abc import Iterable
from datetime import timedelta
from uuid import UUID

import sqlalchemy as sa
from sqlalchemy.orm import Session

from app.accounts.errors import NotInDemo
from app.accounts.models import Person
from app.accounts.rules import Actor
from app.accounts.service import ensure_producer_of
from app.core import clock
from app.core.db import bypass_row_policies, new_id
from app.core.plural import counted, day_in_words
from app.notifications import queries as notification_queries
from app.notifications import service as notifications
from app.operations.erasure import queries as erasure_queries
from app.operations.erasure import scope_queries as scopes
from app.operations.erasure import service as erasure
from app.operations.erasure.queries import Kept
from app.operations.errors import ConfirmationMismatch, ErasureRefused
from app.operations.models import Erasure
from app.operations.schemas import ErasureRead, KeptItem
from app.projects.service import project_access

GRACE = timedelta(days=7)  # nothing changes before, so that a mistake is undone by one click
KEPT_IN_BACKUPS = Kept("copies in backups", "until newer ones replace them; the operator says how many are kept")
KEPT_BY_PROJECT = (
    Kept("the studio, its people, roster and templates", "they belong to the studio, not to the project"),
    KEPT_IN_BACKUPS,
)
KEPT_BY_STUDIO = (
    Kept("the accounts of its people and designers", "they belong to each person, who may erase their own"),
    KEPT_IN_BACKUPS,
)


def read_my_erasure(session: Session, actor: Actor) -> ErasureRead:
    """Return the plan of erasing the caller's account: deleted rows, kept rows and obstacles."""
    person = session.get_one(Person, actor.person)
    with bypass_row_policies(session):  # what stays is in projects that the caller may have left
        obstacles = erasure_queries.obstacles_of_person(session, person.id)
        kept = erasure_queries.kept_of_person(session, person.id)
        deleted = erasure_queries.deleted_counts(session, erasure.of_person(person.id))
    return ErasureRead(
        name=person.name,
        confirmation=person.email,
        obstacles=[f"Your account {obstacle}" for obstacle in obstacles],
        deleted=["your name, address, password and picture", *deleted],
        kept=_read([*kept, KEPT_IN_BACKUPS]),
        grace_days=0,
        due_at=None,
        requested_by=None,
    )


def erase_me(session: Session, actor: Actor, confirmation: str, *, base_url: str) -> None:
    """Erase the caller's account, and tell the producers of the studios that engaged them."""
    person = session.get_one(Person, actor.person)
    if person.demo_part is not None:
        raise NotInDemo("the people of the demo cannot be erased")
    _ensure_confirmed(confirmation, person.email)
    with bypass_row_policies(session):  # rows of studios that the caller may have left name them
        erasure.erase_person(session, person.email)
        for studio_id in erasure_queries.studios_of_designer(session, person.id):
            for recipient in sorted(notification_queries.producer_addresses(session, studio_id)):
                _mail(
                    session,
                    recipient,
                    studio_id,
                    "An account was erased",
                    f"A sound designer whom you engaged has erased their account. They are {person.name} from now on. "
                    "Contracts, invoices and delivered versions stay.",
                    link=f"{base_url}/studio",
                )


def read_project_erasure(session: Session, actor: Actor, project_id: UUID) -> ErasureRead:
    """Return the plan of erasing a project: deleted rows, kept rows and obstacles."""
    access = project_access(session, actor, project_id)
    access.ensure_producer()
    project = access.project
    obstacle = erasure.obstacle_of_contracts(session, f"The project {project.name}", project_id=project_id)
    return _plan(session, project.name, project.studio_id, project_id, obstacle)


def read_studio_erasure(session: Session, actor: Actor, studio_id: UUID) -> ErasureRead:
    """Return the plan of erasing a studio: deleted rows, kept rows and obstacles."""
    studio = ensure_producer_of(session, actor, studio_id)
    with bypass_row_policies(session):  # contracts of projects that the producer is not in count too
        obstacle = erasure.obstacle_of_contracts(session, f"The studio {studio.name}", studio_id=studio_id)
    return _plan(session, studio.name, studio_id, None, obstacle)


def request_project_erasure(
    session: Session, actor: Actor, project_id: UUID, confirmation: str, *, base_url: str
) -> ErasureRead:
    """Let a project be erased after the days of grace, and mail those concerned."""
    plan = read_project_erasure(session, actor, project_id)
    studio_id = project_access(session, actor, project_id).project.studio_id
    _request(session, actor, plan, confirmation, studio_id, project_id, base_url)
    return read_project_erasure(session, actor, project_id)


def request_studio_erasure(
    session: Session, actor: Actor, studio_id: UUID, confirmation: str, *, base_url: str
) -> ErasureRead:
    """Let a studio be erased after the days of grace, and mail those concerned."""
    plan = read_studio_erasure(session, actor, studio_id)
    _request(session, actor, plan, confirmation, studio_id, None, base_url)
    return read_studio_erasure(session, actor, studio_id)


def cancel_project_erasure(session: Session, actor: Actor, project_id: UUID) -> None:
    """Keep a project that was to be erased, and mail those concerned."""
    access = project_access(session, actor, project_id)
    access.ensure_producer()
    _cancel(session, actor, access.project.name, access.project.studio_id, project_id)


def cancel_studio_erasure(session: Session, actor: Actor, studio_id: UUID) -> None:
    """Keep a studio that was to be erased, and mail those concerned."""
    studio = ensure_producer_of(session, actor, studio_id)
    _cancel(session, actor, studio.name, studio_id, None)


def carry_out(session: Session, erasure_id: UUID) -> None:
    """Carry out an erasure that is due and was not cancelled, and mail those concerned; raise ErasureRefused."""
    due = erasure_queries.erasure(session, erasure_id)
    if due is None:
        return
    studio_id, project_id = due.studio_id, due.project_id
    recipients = erasure_queries.addresses_concerned(session, studio_id, project_id)
    if project_id is not None:
        erased = erasure.erase_project(session, project_id)
    else:
        erased = erasure.erase_studio(session, studio_id)
    for recipient in sorted(recipients):
        _mail(session, recipient, None, f"{erased.name} was erased", f"{erased.name} was erased with everything in it.")


def give_up(session: Session, erasure_id: UUID, reason: str) -> None:
    """Drop an erasure that something stands against, and mail those concerned."""
    pending = erasure_queries.erasure(session, erasure_id)
    if pending is None:
        return
    name, _ = erasure_queries.names_of_erasure(session, pending)
    for recipient in sorted(erasure_queries.addresses_concerned(session, pending.studio_id, pending.project_id)):
        _mail(
            session,
            recipient,
            pending.studio_id,
            f"{name} was not erased",
            f"{name} was not erased: {reason}.",
            project_id=pending.project_id,
        )
    session.delete(pending)


def _plan(session: Session, name: str, studio_id: UUID, project_id: UUID | None, obstacle: str | None) -> ErasureRead:
    def scope(table: sa.Table) -> sa.ColumnElement[bool] | None:
        return scopes.of_studio(table, studio_id) if project_id is None else scopes.of_project(table, project_id)

    pending = erasure_queries.pending_erasure(session, studio_id, project_id)
    with bypass_row_policies(session):  # rows of designers, which the caller need not see, go as well
        deleted = erasure_queries.deleted_counts(session, scope)
    return ErasureRead(
        name=name,
        confirmation=name,
        obstacles=[obstacle] if obstacle else [],
        deleted=deleted,
        kept=_read(KEPT_BY_STUDIO if project_id is None else KEPT_BY_PROJECT),
        grace_days=GRACE.days,
        due_at=pending and pending.due_at,
        requested_by=pending and erasure_queries.names_of_erasure(session, pending)[1],
    )


def _request(
    session: Session,
    actor: Actor,
    plan: ErasureRead,
    confirmation: str,
    studio_id: UUID,
    project_id: UUID | None,
    base_url: str,
) -> None:
    _ensure_confirmed(confirmation, plan.confirmation)
    if plan.obstacles:
        raise ErasureRefused("; ".join(plan.obstacles), fix="erase what has no signed contract")
    if plan.due_at is not None:
        return
    requested = Erasure(
        studio_id=studio_id, project_id=project_id, requested_by=actor.person, due_at=clock.now() + GRACE
    )
    session.add(requested)
    session.flush()
    name, person = erasure_queries.names_of_erasure(session, requested)
    day = day_in_words(requested.due_at)
    page = f"{base_url}/erase/{'studios' if project_id is None else 'projects'}/{project_id or studio_id}"
    for recipient in sorted(erasure_queries.addresses_concerned(session, studio_id, project_id)):
        _mail(
            session,
            recipient,
            studio_id,
            f"{name} will be erased on {day}",
            f"{person} has requested that {name} be erased with everything in it, {counted(GRACE.days, 'day')} from "
            "now. Download what you need before. Until then a producer can cancel it.",
            link=page,
            project_id=project_id,
        )


def _cancel(session: Session, actor: Actor, name: str, studio_id: UUID, project_id: UUID | None) -> None:
    pending = erasure_queries.pending_erasure(session, studio_id, project_id)
    if pending is None:
        return
    session.delete(pending)
    person = session.get_one(Person, actor.person)
    for recipient in sorted(erasure_queries.addresses_concerned(session, studio_id, project_id)):
        line = f"{person.name} has cancelled the erasure."
        _mail(session, recipient, studio_id, f"{name} will not be erased", line, project_id=project_id)


def _ensure_confirmed(typed: str, confirmation: str) -> None:
    if typed.strip() != confirmation:
        message = f"type {confirmation} to confirm; this was something else"
        raise ConfirmationMismatch(message, errors=[{"where": "confirmation", "message": message}])


def _mail(
    session: Session,
    recipient: str,
    studio_id: UUID | None,
    subject: str,
    line: str,
    *,
    link: str | None = None,
    project_id: UUID | None = None,
) -> None:
    event_id = str(new_id())
    notifications.write_mail(
        session,
        event_id=event_id,
        studio_id=studio_id,
        project_id=project_id,
        topic=f"erasure:{event_id}",
        recipient=recipient,
        subject=subject,
        lines=[line],
        link=link,
    )


def _read(kept: Iterable[Kept]) -> list[KeptItem]:
    return [KeptItem.model_validate(item) for item in kept]
