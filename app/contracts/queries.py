"""Contracts within the caller's reach: the studio's team sees all of the studio's, a designer their own."""

from collections.abc import Iterator, Sequence
from uuid import UUID

from sqlalchemy import ColumnElement, func, or_, select
from sqlalchemy.orm import Session, joinedload

from app.accounts.rules import Actor
from app.contracts.models import Contract, ContractAcceptance, ContractEvent, ContractVersion
from app.contracts.rules import ContractKind, ContractState
from app.projects.models import Project

WHOLE = (joinedload(Contract.project).joinedload(Project.studio), joinedload(Contract.designer))


def in_reach(actor: Actor) -> ColumnElement[bool]:
    """Return which contracts a caller may see; a draft is the studio's until it was sent once."""
    was_sent = or_(Contract.state != ContractState.DRAFT, Contract.record_length > 0)
    return or_(Contract.studio_id.in_(actor.roles), (Contract.designer_id == actor.person_id) & was_sent)


def contract_for(session: Session, actor: Actor, contract_id: UUID) -> Contract | None:
    """Return a contract that the caller may see, with project, studio and designer."""
    return session.scalar(select(Contract).where(Contract.id == contract_id, in_reach(actor)).options(*WHOLE))


def contracts_in(session: Session, actor: Actor, project_id: UUID) -> Sequence[Contract]:
    """Return the contracts of a project that the caller may see, the oldest first."""
    return session.scalars(
        select(Contract)
        .where(Contract.project_id == project_id, in_reach(actor))
        .options(*WHOLE)
        .order_by(Contract.number)
    ).all()


def lock_contract(session: Session, contract_id: UUID) -> Contract:
    """Return a contract as it stands now; nobody else changes it until the transaction ends."""
    return session.scalars(
        select(Contract)
        .where(Contract.id == contract_id)
        .with_for_update(key_share=True)
        .execution_options(populate_existing=True)
    ).one()


def next_number(session: Session, project_id: UUID) -> int:
    """Return the number of a project's next contract."""
    return (session.scalar(select(func.max(Contract.number)).where(Contract.project_id == project_id)) or 0) + 1


def agreed_contracts(session: Session, project_id: UUID, designer_id: UUID) -> Sequence[Contract]:
    """Return what a designer works under in a project: agreed, and about work; the oldest first."""
    return session.scalars(
        select(Contract)
        .where(
            Contract.project_id == project_id,
            Contract.designer_id == designer_id,
            Contract.state == ContractState.AGREED,
            Contract.kind.in_((ContractKind.SINGLE, ContractKind.STATEMENT_OF_WORK)),
        )
        .order_by(Contract.number)
    ).all()


def newest_version(session: Session, contract_id: UUID) -> ContractVersion | None:
    """Return the text as it was saved last, with its author."""
    return session.scalar(
        select(ContractVersion)
        .where(ContractVersion.contract_id == contract_id)
        .options(joinedload(ContractVersion.author))
        .order_by(ContractVersion.number.desc())
        .limit(1)
    )


def version_by_number(session: Session, contract_id: UUID, number: int) -> ContractVersion | None:
    """Return one version of a contract's text, with its author."""
    return session.scalar(
        select(ContractVersion)
        .where(ContractVersion.contract_id == contract_id, ContractVersion.number == number)
        .options(joinedload(ContractVersion.author))
    )


def versions_of(session: Session, contract_id: UUID) -> Sequence[ContractVersion]:
    """Return the versions of a contract's text, the newest first, with their authors."""
    return session.scalars(
        select(ContractVersion)
        .where(ContractVersion.contract_id == contract_id)
        .options(joinedload(ContractVersion.author))
        .order_by(ContractVersion.number.desc())
    ).all()


def acceptances_of(session: Session, version_id: UUID) -> Sequence[ContractAcceptance]:
    """Return who said yes to a version, in order."""
    return session.scalars(
        select(ContractAcceptance).where(ContractAcceptance.version_id == version_id).order_by(ContractAcceptance.id)
    ).all()


def events_of(session: Session, contract_id: UUID) -> Sequence[ContractEvent]:
    """Return the record of a contract, in order."""
    return session.scalars(
        select(ContractEvent).where(ContractEvent.contract_id == contract_id).order_by(ContractEvent.seq)
    ).all()


def every_contract(session: Session) -> Iterator[Contract]:
    """Yield every contract of every studio; for the server's own commands."""
    yield from session.scalars(select(Contract).order_by(Contract.id).execution_options(yield_per=200))
