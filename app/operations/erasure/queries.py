"""Facts that an erasure meets: contracts, memberships, and rows that stay."""

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import datetime
from uuid import UUID

from sqlalchemy import func, literal, not_, select, union_all, update
from sqlalchemy.orm import Session

from app.accounts.models import DeskToken, InvoiceDetails, Membership, Operator, Person, SignIn, Studio
from app.accounts.rules import normalised_email
from app.agreements.models import Contract, ContractAcceptance
from app.agreements.rules import ContractState
from app.builds.models import Build, SealedPack
from app.core.db import Base
from app.core.plural import counted
from app.deliveries.models import Take
from app.hiring.models import Posting, RosterEntry
from app.money.models import Invoice
from app.notifications.models import Notice
from app.operations.erasure import scope_queries as scopes
from app.operations.models import Erasure
from app.projects.models import Engagement, Project
from app.projects.visibility import is_closed_to
from app.references.models import ReferenceVersion
from app.reviews.models import Comment, Verdict
from app.shares.models import GuestLink, SavedView
from app.sound_lists.models import Cue

# What people know by name, in the order in which it is listed.
COUNTED: tuple[tuple[type[Base], str, str | None], ...] = (
    (Project, "project", None),
    (Cue, "sound", None),
    (Take, "delivered version", None),
    (Verdict, "verdict", None),
    (Comment, "comment", None),
    (ReferenceVersion, "reference", None),
    (Contract, "contract that nobody is bound by", "contracts that nobody is bound by"),
    (Posting, "posting", None),
    (SealedPack, "pack", None),
    (Build, "build", None),
    (GuestLink, "guest link", None),
    (Membership, "membership", None),
    (RosterEntry, "roster entry", "roster entries"),
    (SignIn, "sign-in", None),
    (DeskToken, "desk token", None),
    (Notice, "notice", None),
    (InvoiceDetails, "set of bank and tax details", "sets of bank and tax details"),
    (SavedView, "saved view", None),
)
SIGNED = (ContractState.AGREED, ContractState.ENDED)


def project(session: Session, project_id: UUID) -> Project | None:
    """Return a project by its id, locked: nobody adds a row to what is being erased."""
    return session.get(Project, project_id, with_for_update=True)


def studio(session: Session, studio_id: UUID) -> Studio | None:
    """Return a studio by its id, locked: nobody adds a row to what is being erased."""
    return session.get(Studio, studio_id, with_for_update=True)


def person(session: Session, address: str) -> Person | None:
    """Return the person of an address."""
    return session.scalar(select(Person).where(Person.email == normalised_email(address)))


def signed_contracts(
    session: Session, *, project_id: UUID | None = None, studio_id: UUID | None = None
) -> Sequence[Contract]:
    """Return the contracts of a project or studio that both parties signed."""
    contracts = select(Contract).where(Contract.state.in_(SIGNED)).order_by(Contract.id)
    if project_id is not None:
        contracts = contracts.where(Contract.project_id == project_id)
    if studio_id is not None:
        contracts = contracts.where(Contract.studio_id == studio_id)
    return session.scalars(contracts).all()


def obstacles_of_person(session: Session, person_id: UUID) -> list[str]:
    """Return the obstacles to erasing a person."""
    studios = select(Studio.name).join(Membership).where(Membership.person_id == person_id).order_by(Studio.name)
    reasons = [
        f"is a member of {name}: a producer removes them first, or erases the studio"
        for name in session.scalars(studios)
    ]
    if session.get(Operator, person_id) is not None:
        reasons.append("is an operator of this server: run soundlist operators remove first")
    running = select(Contract.title).where(
        Contract.designer_id == person_id, Contract.state.in_((ContractState.SENT, ContractState.AGREED))
    )
    reasons += [f"is a party of the running contract {title}: end it first" for title in session.scalars(running)]
    return reasons


@dataclass(frozen=True)
class Kept:
    """The remains of an erasure, and their reason."""

    name: str
    reason: str

    def __str__(self) -> str:
        return f"{self.name} ({self.reason})"


def kept_of_person(session: Session, person_id: UUID) -> list[Kept]:
    """Return the rows of a person that stay under the pseudonym, by kind, each with its reason."""
    counts = (
        (
            ContractAcceptance.person_id,
            ContractAcceptance,
            "signature",
            "evidence of a contract; with the name as signed",
        ),
        (Invoice.designer_id, Invoice, "invoice", "tax law; with the seller as issued"),
        (Take.designer_id, Take, "delivered version", "the studio's right to use it comes from the contract"),
        (Verdict.given_by, Verdict, "verdict", "money and rights depend on it"),
        (Comment.written_by, Comment, "comment", "part of the review of others' work"),
    )
    kept = []
    for column, table, noun, reason in counts:
        if count := session.scalar(select(func.count()).select_from(table).where(column == person_id)):
            kept.append(Kept(counted(count, noun), reason))
    roster = select(Studio.name).join(RosterEntry, RosterEntry.studio_id == Studio.id)
    roster = roster.join(Person, Person.email == RosterEntry.email).where(Person.id == person_id)
    kept += [
        Kept(f"the entry on the roster of {name}", "that studio's own file; ask it") for name in session.scalars(roster)
    ]
    return kept


def deleted_counts(session: Session, scope: scopes.Scope) -> list[str]:
    """Return the kinds of rows within a scope that people know by name, each with its number."""
    counts = []
    for index, (model, _, _) in enumerate(COUNTED):
        table = Base.metadata.tables[model.__tablename__]
        where = scope(table)
        if where is not None:
            counts.append(select(literal(index), func.count()).select_from(table).where(where))
    rows = session.execute(union_all(*counts)) if counts else ()
    return [
        counted(count, COUNTED[model_index][1], COUNTED[model_index][2]) for model_index, count in sorted(rows) if count
    ]


def pending_erasure(session: Session, studio_id: UUID, project_id: UUID | None) -> Erasure | None:
    """Return the erasure to come of a project, or of a studio."""
    return session.scalar(
        select(Erasure).where(Erasure.studio_id == studio_id, Erasure.project_id.is_not_distinct_from(project_id))
    )


def due_erasures(session: Session, now: datetime) -> Sequence[UUID]:
    """Return the erasures whose day has come, those of projects first."""
    due = select(Erasure.id).where(Erasure.due_at <= now)
    return session.scalars(due.order_by(Erasure.project_id.is_(None), Erasure.due_at)).all()


def erasure(session: Session, erasure_id: UUID) -> Erasure | None:
    """Return an erasure to come, locked until the transaction ends."""
    return session.get(Erasure, erasure_id, with_for_update=True)


def names_of_erasure(session: Session, erasure: Erasure) -> tuple[str, str]:
    """Return the name of what is to be erased, and of the person who requested it."""
    person = session.get_one(Person, erasure.requested_by)
    if erasure.project_id is not None:
        return session.get_one(Project, erasure.project_id).name, person.name
    return session.get_one(Studio, erasure.studio_id).name, person.name


def addresses_concerned(session: Session, studio_id: UUID, project_id: UUID | None) -> set[str]:
    """Return the addresses of a studio's members and of its engaged designers; of a project, those of who sees it."""
    members = select(Person.email).join(Membership, Membership.person_id == Person.id)
    designers = select(Person.email).join(Engagement, Engagement.designer_id == Person.id)
    designers = designers.where(Engagement.studio_id == studio_id, Engagement.ended_at.is_(None))
    if project_id is not None:
        designers = designers.where(Engagement.project_id == project_id)
        members = members.where(not_(is_closed_to(Person.id, studio_id=studio_id, project_id=project_id)))
    return set(session.scalars(members.where(Membership.studio_id == studio_id))) | set(session.scalars(designers))


def studios_of_designer(session: Session, person_id: UUID) -> Sequence[UUID]:
    """Return the studios that have engaged a person, those whose engagement has ended too."""
    return session.scalars(select(Engagement.studio_id).where(Engagement.designer_id == person_id).distinct()).all()


def end_engagements(session: Session, person_id: UUID, now: datetime) -> None:
    """End a person's engagements."""
    running = update(Engagement).where(Engagement.designer_id == person_id, Engagement.ended_at.is_(None))
    session.execute(running.values(ended_at=now))
