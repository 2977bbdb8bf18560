"""Contracts within the caller's reach: those who act for the studio see its contracts, a designer their own.

A price is between two parties. Reviewers, implementers and other designers see none of it.
"""

from collections.abc import Collection, Sequence
from uuid import UUID

from sqlalchemy import ColumnElement, String, cast, delete, exists, func, or_, select
from sqlalchemy.orm import Session, joinedload

from app.accounts.rules import LEAD_ROLES, Actor, Role
from app.agreements.models import (
    Contract,
    ContractAcceptance,
    ContractCue,
    ContractEvent,
    ContractSigner,
    ContractTemplate,
    ContractVersion,
    Milestone,
    Seal,
    SigningCode,
)
from app.agreements.rules import ORDERS, ContractKind, ContractState
from app.agreements.signing.rules import Signature, SigningOrder, Turn
from app.core.db import Base, bypass_row_policies
from app.core.recorded_rows import declare
from app.projects.models import ApproverChange, CategoryApprover, Deputy, Liaison, Project, Spec

WHOLE = (joinedload(Contract.project).joinedload(Project.studio), joinedload(Contract.designer))


NOTICE_GIVEN, NOTICE_WITHDRAWN = "notice_given", "notice_withdrawn"  # kinds of entries of the record


def in_reach(actor: Actor) -> ColumnElement[bool]:
    """Return the contracts a caller may see: a producer the studio's, a liaison the project's, a designer their own.

    Only the studio sees a contract before it is first sent.
    """
    produces = [studio_id for studio_id, roles in actor.roles.items() if Role.PRODUCER in roles]
    named = exists().where(Liaison.project_id == Contract.project_id, Liaison.person_id == actor.person_id)
    speaks = or_(Contract.studio_id.in_(produces), Contract.studio_id.in_(actor.studios_with(LEAD_ROLES)) & named)
    was_sent = exists().where(ContractVersion.contract_id == Contract.id, ContractVersion.sent_at.is_not(None))
    is_shown = or_(Contract.agreed_at.is_not(None), was_sent)
    return or_(speaks, (Contract.designer_id == actor.person_id) & is_shown)


def contract_for(session: Session, actor: Actor, contract_id: UUID) -> Contract | None:
    """Return a contract that the caller may see, with project, studio and designer."""
    return session.scalar(select(Contract).where(Contract.id == contract_id, in_reach(actor)).options(*WHOLE))


def contract_by_id(session: Session, contract_id: UUID) -> Contract:
    """Return any contract with project, studio and designer; for the server's own jobs."""
    return session.scalars(select(Contract).where(Contract.id == contract_id).options(*WHOLE)).one()


def contract_by_id_or_none(session: Session, contract_id: UUID) -> Contract | None:
    """Return any contract, None where there is none; for the server's own commands."""
    return session.get(Contract, contract_id)


def contracts_in(session: Session, actor: Actor, project_id: UUID) -> Sequence[Contract]:
    """Return the contracts of a project that the caller may see, the oldest first."""
    return session.scalars(
        select(Contract)
        .where(Contract.project_id == project_id, in_reach(actor))
        .options(*WHOLE)
        .order_by(Contract.number)
    ).all()


def agreed_in(session: Session, actor: Actor, project_id: UUID) -> Sequence[Contract]:
    """Return the agreed and ended contracts about work in a project that the caller may see, the oldest first."""
    return session.scalars(
        select(Contract)
        .where(
            Contract.project_id == project_id,
            Contract.agreed_at.is_not(None),
            Contract.state.in_((ContractState.AGREED, ContractState.ENDED)),
            Contract.kind.in_((ContractKind.SINGLE, ContractKind.STATEMENT_OF_WORK)),
            in_reach(actor),
        )
        .options(*WHOLE)
        .order_by(Contract.number)
    ).all()


def last_sent(
    session: Session, actor: Actor, studio_id: UUID, kind: ContractKind, designer_id: UUID
) -> Contract | None:
    """Return a studio's last contract of a kind that was sent once: with this designer, else with any."""
    was_sent = exists().where(ContractVersion.contract_id == Contract.id, ContractVersion.sent_at.is_not(None))
    return session.scalar(
        select(Contract)
        .where(Contract.studio_id == studio_id, Contract.kind == kind, was_sent, in_reach(actor))
        .options(*WHOLE)
        .order_by((Contract.designer_id == designer_id).desc(), Contract.id.desc())
        .limit(1)
    )


def lock_contract(session: Session, contract_id: UUID) -> Contract:
    """Return a current contract, locked until the transaction ends."""
    return session.scalars(
        select(Contract)
        .where(Contract.id == contract_id)
        .options(*WHOLE)
        .with_for_update(key_share=True, of=Contract)
        .execution_options(populate_existing=True)
    ).one()


def lock_together(session: Session, contract: Contract) -> Contract:
    """Return a current contract, locked until the transaction ends with the other one of its joint work, if any."""
    if contract.joint_id is not None:
        with bypass_row_policies(session):  # a designer writes their own contract only, and what is done holds for both
            session.scalars(
                select(Contract)
                .where(Contract.joint_id == contract.joint_id)
                .order_by(Contract.id)  # one order for all, so that no two wait for each other
                .with_for_update(key_share=True)
                .execution_options(populate_existing=True)
            ).all()
    return lock_contract(session, contract.id)


def lock_contracts_of(session: Session, project_id: UUID) -> None:
    """Lock the numbering of contracts in this project until the transaction ends."""
    session.execute(select(Project.id).where(Project.id == project_id).with_for_update(key_share=True))


def next_number(session: Session, project_id: UUID) -> int:
    """Return the number of a project's next contract."""
    return (session.scalar(select(func.max(Contract.number)).where(Contract.project_id == project_id)) or 0) + 1


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
    """Return the acceptances of a version, in order."""
    return session.scalars(
        select(ContractAcceptance).where(ContractAcceptance.version_id == version_id).order_by(ContractAcceptance.id)
    ).all()


def templates_of(session: Session, studio_id: UUID) -> Sequence[ContractTemplate]:
    """Return a studio's own templates by name."""
    return session.scalars(
        select(ContractTemplate).where(ContractTemplate.studio_id == studio_id).order_by(ContractTemplate.name)
    ).all()


def template_by_id(session: Session, studio_id: UUID, template_id: UUID) -> ContractTemplate | None:
    """Return one of a studio's own templates."""
    return session.scalar(
        select(ContractTemplate).where(ContractTemplate.studio_id == studio_id, ContractTemplate.id == template_id)
    )


def template_by_name(session: Session, studio_id: UUID, name: str) -> ContractTemplate | None:
    """Return a studio's own template of that name."""
    return session.scalar(
        select(ContractTemplate).where(ContractTemplate.studio_id == studio_id, ContractTemplate.name == name)
    )


def turns_to_sign(session: Session, contracts: Collection[Contract]) -> dict[UUID, Turn]:
    """Return the turn to sign the newest text of each contract, as if each had been sent."""
    ids = [contract.id for contract in contracts]
    newest = (
        select(ContractVersion.contract_id, func.max(ContractVersion.number).label("number"))
        .where(ContractVersion.contract_id.in_(ids))
        .group_by(ContractVersion.contract_id)
        .subquery()
    )
    given: dict[UUID, list[Signature]] = {contract_id: [] for contract_id in ids}
    for contract_id, party, person_id in session.execute(
        select(ContractAcceptance.contract_id, ContractAcceptance.party, ContractAcceptance.person_id)
        .join(ContractVersion, ContractVersion.id == ContractAcceptance.version_id)
        .join(
            newest, (newest.c.contract_id == ContractVersion.contract_id) & (newest.c.number == ContractVersion.number)
        )
    ):
        given[contract_id].append(Signature(party, person_id))
    signers: dict[UUID, list[UUID]] = {contract_id: [] for contract_id in ids}
    for contract_id, person_id in session.execute(
        select(ContractSigner.contract_id, ContractSigner.person_id)
        .where(ContractSigner.contract_id.in_(ids))
        .order_by(ContractSigner.position)
    ):
        signers[contract_id].append(person_id)
    return {
        contract.id: SigningOrder(signers[contract.id], contract.signs_first).turn(given[contract.id])
        for contract in contracts
    }


def signers_of(session: Session, contract_id: UUID) -> Sequence[ContractSigner]:
    """Return the named signers of a contract for the studio, in order, with the people."""
    return session.scalars(
        select(ContractSigner)
        .where(ContractSigner.contract_id == contract_id)
        .options(joinedload(ContractSigner.person))
        .order_by(ContractSigner.position)
    ).all()


def unsigned_contracts_of_signer(session: Session, studio_id: UUID, person_id: UUID) -> Sequence[Contract]:
    """Return the contracts of a studio that a person is named to sign and that are not agreed, with their projects."""
    named = exists().where(ContractSigner.contract_id == Contract.id, ContractSigner.person_id == person_id)
    return session.scalars(
        select(Contract)
        .where(Contract.studio_id == studio_id, Contract.state.in_((ContractState.DRAFT, ContractState.SENT)), named)
        .options(joinedload(Contract.project))
        .order_by(Contract.id)
    ).all()


def signers_awaited(session: Session, project_id: UUID) -> Sequence[UUID]:
    """Return the people who are named to sign contracts of a project that are not agreed."""
    unsigned = Contract.project_id == project_id, Contract.state.in_((ContractState.DRAFT, ContractState.SENT))
    signers = select(ContractSigner.person_id).join(Contract, Contract.id == ContractSigner.contract_id)
    return session.scalars(signers.where(*unsigned).distinct()).all()


def drop_signer(session: Session, contract_id: UUID, person_id: UUID) -> None:
    """Delete one person from those who are named to sign a contract for the studio."""
    named = ContractSigner.contract_id == contract_id, ContractSigner.person_id == person_id
    session.execute(delete(ContractSigner).where(*named))


def drop_signers(session: Session, contract_id: UUID) -> None:
    """Delete the named signers of a contract for the studio."""
    session.execute(delete(ContractSigner).where(ContractSigner.contract_id == contract_id))


def drop_signing_codes(session: Session, contract_id: UUID, person_id: UUID) -> None:
    """Delete a person's codes for the texts of a contract, so that only the next one counts."""
    session.execute(
        delete(SigningCode).where(SigningCode.contract_id == contract_id, SigningCode.person_id == person_id)
    )


def signing_code_locked(session: Session, contract_id: UUID, person_id: UUID, text_sha256: str) -> SigningCode | None:
    """Return a person's code for a text, locked until this transaction ends."""
    return session.scalar(
        select(SigningCode)
        .where(
            SigningCode.contract_id == contract_id,
            SigningCode.person_id == person_id,
            SigningCode.text_sha256 == text_sha256,
        )
        .with_for_update()
    )


def newest_event(session: Session, contract_id: UUID) -> ContractEvent | None:
    """Return the last entry of a contract's record."""
    return session.scalar(
        select(ContractEvent)
        .where(ContractEvent.contract_id == contract_id)
        .order_by(ContractEvent.seq.desc())
        .limit(1)
    )


def newest_event_of(session: Session, contract_id: UUID, kinds: Collection[str]) -> ContractEvent | None:
    """Return the last entry of some kinds of a contract's record."""
    return session.scalar(
        select(ContractEvent)
        .where(ContractEvent.contract_id == contract_id, ContractEvent.kind.in_(kinds))
        .order_by(ContractEvent.seq.desc())
        .limit(1)
    )


def notices_in_effect(session: Session, contract_ids: Collection[UUID]) -> dict[UUID, ContractEvent]:
    """Return by contract the notice in its record that was not withdrawn since."""
    entries = session.scalars(
        select(ContractEvent)
        .where(ContractEvent.contract_id.in_(contract_ids), ContractEvent.kind.in_((NOTICE_GIVEN, NOTICE_WITHDRAWN)))
        .order_by(ContractEvent.contract_id, ContractEvent.seq)
    )
    newest = {entry.contract_id: entry for entry in entries}
    return {contract_id: entry for contract_id, entry in newest.items() if entry.kind == NOTICE_GIVEN}


def events_of_kinds(session: Session, contract_id: UUID, kinds: Collection[str]) -> Sequence[ContractEvent]:
    """Return the entries of some kinds of a contract's record, in order."""
    return session.scalars(
        select(ContractEvent)
        .where(ContractEvent.contract_id == contract_id, ContractEvent.kind.in_(kinds))
        .order_by(ContractEvent.seq)
    ).all()


def event_sha256(session: Session, contract_id: UUID, seq: int) -> str | None:
    """Return the hash of one entry of a contract's record; None where there is no such entry."""
    of_it = ContractEvent.contract_id == contract_id
    return session.scalar(select(ContractEvent.sha256).where(of_it, ContractEvent.seq == seq))


def events_of(session: Session, contract_id: UUID) -> Sequence[ContractEvent]:
    """Return the record of a contract, in order."""
    return session.scalars(
        select(ContractEvent).where(ContractEvent.contract_id == contract_id).order_by(ContractEvent.seq)
    ).all()


def seal_of(session: Session, version_id: UUID) -> Seal | None:
    """Return the seal of a version of a text; None before all have signed it, and until it is made."""
    return session.scalar(select(Seal).where(Seal.version_id == version_id))


def sealed_versions(session: Session, contract_id: UUID) -> dict[UUID, Seal]:
    """Return the seals of a contract by version."""
    return {seal.version_id: seal for seal in session.scalars(select(Seal).where(Seal.contract_id == contract_id))}


def seal_by_file(session: Session, file_sha256: str) -> Seal | None:
    """Return the seal of a file of any studio, with its text, contract and parties."""
    contract = joinedload(Seal.contract)
    return session.scalar(
        select(Seal)
        .where(Seal.file_sha256 == file_sha256)
        .options(
            joinedload(Seal.version),
            contract.joinedload(Contract.project).joinedload(Project.studio),
            contract.joinedload(Contract.designer),
        )
        .limit(1)
    )


def has_seal(session: Session, ids: Collection[UUID]) -> bool:
    """Whether one of these is a seal of this server."""
    return session.scalar(select(Seal.id).where(Seal.id.in_(ids)).limit(1)) is not None


def has_sealed_by(session: Session, key_sha256: str) -> bool:
    """Whether this server has sealed by this key."""
    return session.scalar(select(Seal.id).where(Seal.key_sha256 == key_sha256).limit(1)) is not None


def unsealed_contracts(session: Session) -> Sequence[UUID]:
    """Return the contracts that all have signed and whose newest text has no seal."""
    sealed = exists().where(Seal.contract_id == Contract.id)
    return session.scalars(select(Contract.id).where(Contract.agreed_at.is_not(None), ~sealed).limit(100)).all()


def rows_as_sent(session: Session, contract: Contract) -> list[Base]:
    """Return the rows that a contract is agreed on: itself, the version that is sent, signers, and the plan."""
    of_plan = [
        session.scalars(select(table).where(table.contract_id == contract.id)).all()
        for table in (ContractSigner, Milestone, ContractCue)
    ]
    sent = newest_version(session, contract.id)
    return [contract, *([sent] if sent else []), *(row for rows in of_plan for row in rows)]


def rows_on_approval(session: Session, project_id: UUID) -> list[Base]:
    """Return the rows that say who may approve in a project, and the delivery spec in force."""
    tables = (ApproverChange, CategoryApprover, Deputy)
    of_people = [session.scalars(select(table).where(table.project_id == project_id)).all() for table in tables]
    spec = session.scalars(select(Spec).where(Spec.project_id == project_id).order_by(Spec.version.desc())).first()
    return [*(row for rows in of_people for row in rows), *([spec] if spec else [])]


def in_force(session: Session, project_id: UUID) -> Sequence[UUID]:
    """Return the contracts of a project that order work and are in force."""
    return session.scalars(
        select(Contract.id)
        .where(
            Contract.project_id == project_id,
            Contract.state == ContractState.AGREED,
            Contract.kind.in_(ORDERS),
        )
        .order_by(Contract.id)
    ).all()


def contract_ids(session: Session) -> Sequence[str]:
    """Return the id of every contract of every studio as text, which any value has; for the server's own commands."""
    return session.scalars(select(cast(Contract.id, String)).order_by(Contract.id)).all()


def _contracts_in_force(session: Session, row: ApproverChange | CategoryApprover | Deputy | Spec) -> Sequence[UUID]:
    return in_force(session, row.project_id)


# Who may approve, and by which spec, is on record in the contracts that are in force then.
for model, name in (
    (ApproverChange, "approver"),
    (CategoryApprover, "approver of a category"),
    (Deputy, "deputy of an approver"),
    (Spec, "delivery spec"),
):
    declare(model, name, owners=_contracts_in_force, digested=("reason", "note", "toml"))
