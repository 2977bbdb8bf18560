"""What an erasure meets: contracts, memberships, and rows that stay."""

from collections.abc import Sequence
from datetime import datetime
from uuid import UUID

from sqlalchemy import func, select, update
from sqlalchemy.orm import Session

from app.accounts.models import Membership, Operator, Person, Studio
from app.accounts.rules import normalised_email
from app.agreements.models import Contract, ContractAcceptance
from app.agreements.rules import ContractState
from app.deliveries.models import Take
from app.hiring.models import RosterEntry
from app.kit.plural import counted
from app.money.models import Invoice
from app.projects.models import Engagement, Project
from app.reviews.models import Comment, Verdict

SIGNED = (ContractState.AGREED, ContractState.ENDED)


def project(session: Session, project_id: UUID) -> Project | None:
    """Return a project by its id."""
    return session.get(Project, project_id)


def studio(session: Session, studio_id: UUID) -> Studio | None:
    """Return a studio by its id."""
    return session.get(Studio, studio_id)


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


def reasons_to_stay(session: Session, person_id: UUID) -> list[str]:
    """Return why a person cannot be erased now, and what ends it."""
    studios = select(Studio.name).join(Membership).where(Membership.person_id == person_id).order_by(Studio.name)
    reasons = [f"is a member of {name}: a producer removes them first" for name in session.scalars(studios)]
    if session.get(Operator, person_id) is not None:
        reasons.append("is an operator of this server: run soundlist operators remove first")
    running = select(Contract.title).where(
        Contract.designer_id == person_id, Contract.state.in_((ContractState.SENT, ContractState.AGREED))
    )
    reasons += [f"is a party of the running contract {title}: end it first" for title in session.scalars(running)]
    return reasons


def kept_of_person(session: Session, person_id: UUID) -> list[str]:
    """Return what of a person stays under the pseudonym, each with its reason."""
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
            kept.append(f"{counted(count, noun)} ({reason})")
    roster = select(Studio.name).join(RosterEntry, RosterEntry.studio_id == Studio.id)
    roster = roster.join(Person, Person.email == RosterEntry.email).where(Person.id == person_id)
    kept += [f"the entry on the roster of {name} (that studio's own file; ask it)" for name in session.scalars(roster)]
    return kept


def end_engagements(session: Session, person_id: UUID, now: datetime) -> None:
    """End a person's engagements."""
    running = update(Engagement).where(Engagement.designer_id == person_id, Engagement.ended_at.is_(None))
    session.execute(running.values(ended_at=now))
