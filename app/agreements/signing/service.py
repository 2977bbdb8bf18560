"""Signing the text that was sent: who is named for it, in which order, and what is kept of each signature."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from datetime import datetime
from functools import partial
from typing import Any, TypeVar
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.errors import HandOverNeeded
from app.accounts.models import Person
from app.accounts.queries import members
from app.accounts.rules import PROOF_WORDS, Actor, MemberChange, Role, SecondFactorUse
from app.accounts.second_factors.requirements import ensure_second_factor_for
from app.agreements import queries
from app.agreements.access import contract_to_change, party_of, visible_contract
from app.agreements.clauses.text_faults import ensure_text_whole
from app.agreements.drafts.versions import newest_of
from app.agreements.errors import AlreadyAccepted, NotASigner, NotYourContract, NotYourTurn
from app.agreements.joint.parts import facts_of_split
from app.agreements.joint.queries import other_contract
from app.agreements.models import Acceptance, Contract, ContractAcceptance, ContractSigner, ContractVersion
from app.agreements.plan.service import activate_plan
from app.agreements.record import service as record
from app.agreements.rules import (
    ContractKind,
    ContractState,
    Party,
    ensure_address_proven,
    ensure_another_person,
    ensure_same_text,
    ensure_state,
)
from app.agreements.signing.codes import CodeCheck, use
from app.agreements.signing.drawn_signatures import drawing_sha256
from app.agreements.signing.rules import (
    BY_CODE,
    CONSENT,
    WITHOUT_CODE,
    Signature,
    SigningOrder,
    Turn,
    ensure_signers_fit,
)
from app.core import clock
from app.core.db import bypass_row_policies
from app.core.errors import FieldProblem
from app.core.events import publish
from app.core.plural import counted
from app.projects.engagements import record_nda
from app.projects.members.queries import is_open_to
from app.projects.members.service import ensure_member
from app.projects.models import Project
from app.projects.signals import NeededPeople

AnyAcceptance = TypeVar("AnyAcceptance", bound=Acceptance)


@dataclass(frozen=True)
class SignatureRequest:
    """A person's request to sign: the name typed and drawn, the text seen, the origin, and the code."""

    name: str
    text_sha256: str
    address: str
    agent: str
    code: CodeCheck | None  # None where mail is off
    drawing: list[list[list[int]]] | None = None  # the name as it was drawn; it has passed `ensure_drawing_fits`


def order_of(session: Session, contract: Contract) -> SigningOrder:
    """Return a contract's signers for the studio, in order, and the party that is first."""
    return SigningOrder([signer.person_id for signer in queries.signers_of(session, contract.id)], contract.signs_first)


def amendment_order_of(session: Session, contract: Contract) -> SigningOrder:
    """Return the studio's signers of a change order or a statement: its signers who are producers still.

    Either party may be first. Where none of the signers is left, any producer signs.
    """
    with bypass_row_policies(session):  # a designer does not see who is in the studio, and the order is the same
        producers = _producers(session, contract)
    return SigningOrder([signer for signer in order_of(session, contract).signers if signer in producers])


def yeses(acceptances: Sequence[Acceptance]) -> list[Signature]:
    """Return the signatures, as the rules on order take them."""
    return [Signature(acceptance.party, acceptance.person_id) for acceptance in acceptances]


def may_sign(session: Session, actor: Actor, contract: Contract, acceptances: Sequence[ContractAcceptance]) -> bool:
    """Whether it is the caller's turn to sign the text that was sent."""
    party = party_of(actor, contract)
    if party is None or contract.state is not ContractState.SENT:
        return False
    try:
        order_of(session, contract).ensure_turn(party, actor.person, yeses(acceptances))
    except (AlreadyAccepted, NotASigner, NotYourTurn):
        return False
    return True


def set_signers(
    session: Session, actor: Actor, contract_id: UUID, *, person_ids: Sequence[UUID], first: Party | None
) -> None:
    """Name the producers who sign a draft for the studio, in order, and which party signs first."""
    contract = contract_to_change(session, actor, contract_id)
    is_sent = contract.state is ContractState.SENT
    fix = "recall it first; then name the signers and send it again" if is_sent else "this is final: who signed stays"
    ensure_state(contract.state, {ContractState.DRAFT}, fix)
    producers = _producers(session, contract) - {contract.designer_id}
    ensure_signers_fit(person_ids, producers)
    queries.drop_signers(session, contract.id)
    project = session.get_one(Project, contract.project_id)
    for position, person_id in enumerate(person_ids, start=1):
        session.add(
            ContractSigner(
                studio_id=contract.studio_id,
                project_id=contract.project_id,
                contract_id=contract.id,
                person_id=person_id,
                position=position,
            )
        )
        ensure_member(session, project, person_id)
    contract.signs_first = first
    session.flush()


def answer_needed_people(session: Session, asked: NeededPeople) -> dict[UUID, str]:
    """Return the people who are named to sign a contract of a project that is not agreed yet."""
    return dict.fromkeys(queries.signers_awaited(session, asked.project_id), "is named to sign a contract here")


def contracts_to_sign(session: Session, studio_id: UUID, person_id: UUID) -> list[Contract]:
    """Return the contracts that were sent and that wait for this person, by name, to sign for the studio."""
    return [
        contract
        for contract in queries.unsigned_contracts_of_signer(session, studio_id, person_id)
        if contract.state is ContractState.SENT
        and person_id
        not in {acceptance.person_id for acceptance in queries.acceptances_of(session, newest_of(session, contract).id)}
    ]


def end_signers_of_member(session: Session, payload: Mapping[str, Any]) -> None:
    """Take former producers off drafts that they were to sign: a handler of `member.changed`.

    Raises HandOverNeeded while a contract that was sent waits for them: no other producer can sign it.
    """
    change = MemberChange.of(payload)
    if Role.PRODUCER in change.roles:
        return
    if waiting := contracts_to_sign(session, change.studio_id, change.person_id):
        seen = [contract for contract in waiting if is_open_to(session, contract.project, change.changed_by)]
        names = [contract.title for contract in seen]
        if hidden := len(waiting) - len(seen):
            names.append(
                counted(
                    hidden, "contract in a project that you are not in", "contracts in projects that you are not in"
                )
            )
        raise HandOverNeeded(
            f"they are named to sign {', '.join(names)}",
            errors=[
                FieldProblem(
                    where=f"contracts.{contract.id}",
                    message=f"signs {contract.title} of {contract.project.name} for the studio",
                )
                for contract in seen
            ],
            fix="recall each of these contracts, name other signers and send it again",
        )
    for contract in queries.unsigned_contracts_of_signer(session, change.studio_id, change.person_id):
        if contract.state is ContractState.DRAFT:
            queries.drop_signer(session, contract.id, change.person_id)


def signing_facts(session: Session, contract: Contract) -> dict[str, Any]:
    """Return, in words for the record, who is to sign in which order; empty where any producer may, at any time."""
    facts: dict[str, Any] = {}
    if signers := queries.signers_of(session, contract.id):
        facts["signers"] = [signer.person.name for signer in signers]
    if contract.signs_first is not None:
        facts["signs_first"] = contract.signs_first.value
    return facts


def _proof_of(session: Session, person: Person, signature: SignatureRequest) -> datetime | None:
    """Check address and code of who signs, and return when the code was entered; None where mail is off."""
    if signature.code is None:
        return None
    ensure_address_proven(person.email_proof, person.email)
    use(session, signature.code)
    return clock.now()


def _facts_of_signature(person: Person, party: Party, signature: SignatureRequest) -> dict[str, Any]:
    """Return the facts of a signature for the record."""
    drawn = {"drawing_sha256": drawing_sha256(signature.drawing)} if signature.drawing is not None else {}
    return drawn | {
        "party": party.value,
        "name": signature.name,
        "email": person.email,
        "email_proof": PROOF_WORDS[person.email_proof],
        "address": signature.address,
        "agent": signature.agent,
        "code": BY_CODE if signature.code else WITHOUT_CODE,
        "consent": CONSENT,
    }


def sign_text(
    session: Session,
    actor: Actor,
    contract: Contract,
    party: Party,
    signature: SignatureRequest,
    *,
    order: SigningOrder,
    given: Sequence[Acceptance],
    new_acceptance: Callable[..., AnyAcceptance],
    put_on_record: Callable[[Mapping[str, Any]], object],
) -> tuple[AnyAcceptance, Turn]:
    """Record a person's yes to a text, under the contract's lock; return it, and whose turn it is next.

    Raises AlreadyAccepted, NotASigner or NotYourTurn by the order, SamePersonOnBothSides where the other party's yes is
    the same person's, and, where the server sends mail, AddressNotProven or what is wrong with the code.
    """
    order.ensure_turn(party, actor.person, yeses(given))
    ensure_second_factor_for(session, actor, contract.studio_id, SecondFactorUse.SIGNING)
    person = session.get_one(Person, actor.person)
    others = [(acceptance.person_id, acceptance.email) for acceptance in given if acceptance.party is not party]
    ensure_another_person(person.id, person.email, others)
    acceptance = new_acceptance(
        studio_id=contract.studio_id,
        project_id=contract.project_id,
        contract_id=contract.id,
        party=party,
        person_id=person.id,
        name=signature.name,
        email=person.email,
        email_proof=person.email_proof,
        address=signature.address,
        agent=signature.agent,
        code_entered_at=_proof_of(session, person, signature),
        drawing=signature.drawing,
    )
    session.add(acceptance)
    session.flush()
    put_on_record(_facts_of_signature(person, party, signature))
    return acceptance, order.turn([*yeses(given), Signature(party, person.id)])


def accept(session: Session, actor: Actor, contract_id: UUID, signature: SignatureRequest) -> ContractAcceptance:
    """Record a person's yes to the text that was sent; once all have given theirs, the contract is agreed.

    The two contracts of joint work are agreed together, once all have given theirs to both.

    Raises TextChanged unless the hash seen is that of the current text, BadDraft where that text contradicts a figure,
    AlreadyAccepted, NotASigner or NotYourTurn by
    the order that was set, SamePersonOnBothSides where the other party's yes is the same person's, and, where the
    server sends mail, AddressNotProven or what is wrong with the code.
    """
    contract = visible_contract(session, actor, contract_id)
    party = party_of(actor, contract)
    if party is None:
        raise NotYourContract("only a producer of the studio and the contract's designer can sign it")
    contract = queries.lock_together(session, contract)
    ensure_state(contract.state, {ContractState.SENT}, "a contract can be signed once it was sent")
    version = newest_of(session, contract)
    ensure_same_text(signature.text_sha256, version.text_sha256)
    ensure_text_whole(session, contract, version, "nothing was signed")
    acceptance, turn = sign_text(
        session,
        actor,
        contract,
        party,
        signature,
        order=order_of(session, contract),
        given=queries.acceptances_of(session, version.id),
        new_acceptance=partial(ContractAcceptance, version_id=version.id),
        put_on_record=lambda facts: record.append_by(session, actor, contract, "accepted_by", version, **facts),
    )
    other = other_contract(session, contract)
    if turn.parties:
        publish(
            session, "contract.signed_once", studio_id=contract.studio_id, contract_id=contract.id, party=party.value
        )
    elif other is None:
        _agree(session, actor, contract, version)
    elif is_signed(session, other):
        _agree(session, actor, contract, version)
        with bypass_row_policies(session):  # a designer who signs last does not write the other contract
            _agree(session, actor, other, newest_of(session, other))
    return acceptance


def is_signed(session: Session, contract: Contract) -> bool:
    """Whether all have signed the text that was sent, while it waits for the other contract of joint work."""
    given = yeses(queries.acceptances_of(session, newest_of(session, contract).id))
    return contract.state is ContractState.SENT and not order_of(session, contract).parties_left(given)


def _agree(session: Session, actor: Actor, contract: Contract, version: ContractVersion) -> None:
    contract.state, contract.agreed_at = ContractState.AGREED, clock.now()
    session.flush()
    record.append_by(session, actor, contract, "agreed", version, **facts_of_split(session, contract))
    if contract.kind is ContractKind.NDA:
        record_nda(session, contract.engagement_id, document_sha256=version.pdf_sha256 or "", at=contract.agreed_at)
    activate_plan(session, contract, person_id=actor.person)
    publish(
        session,
        "contract.agreed",
        studio_id=contract.studio_id,
        contract_id=contract.id,
        person_id=actor.person,
    )


def people_to_sign(session: Session, contract: Contract) -> list[UUID]:
    """Return the people who sign a sent contract next: people by name, all producers where none is named."""
    given = yeses(queries.acceptances_of(session, newest_of(session, contract).id))
    order = order_of(session, contract)
    people: list[UUID] = []
    for party in order.parties_left(given):
        if party is Party.DESIGNER:
            people.append(contract.designer_id)
        elif (signer := order.next_signer(given)) is not None:
            people.append(signer)
        else:
            people += _producers(session, contract)
    return people


def _producers(session: Session, contract: Contract) -> set[UUID]:
    return {member.person_id for member in members(session, contract.studio_id) if Role.PRODUCER in member.roles}
