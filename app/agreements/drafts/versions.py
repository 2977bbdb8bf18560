"""The versions of a contract's text: added, and read by those who may see them."""

from collections.abc import Sequence

from sqlalchemy.orm import Session

from app.accounts.models import Person
from app.accounts.rules import Actor
from app.agreements import queries
from app.agreements.clauses.facts import facts_of
from app.agreements.clauses.rules import Clause, Terms, render, terms_in_force
from app.agreements.drafts.documents import sha256_of
from app.agreements.errors import (
    ContractVersionNotFound,
)
from app.agreements.models import Contract, ContractVersion


def visible_versions(session: Session, actor: Actor, contract: Contract) -> Sequence[ContractVersion]:
    """Return the versions that the caller may see, the newest first: the designer sees what was sent."""
    is_team = bool(actor.roles_in(contract.studio_id))
    return [version for version in queries.versions_of(session, contract.id) if is_team or version.sent_at is not None]


def visible_version(session: Session, actor: Actor, contract: Contract, number: int) -> ContractVersion:
    """Return one version that the caller may see; raise ContractVersionNotFound for any other."""
    version = queries.version_by_number(session, contract.id, number)
    if version is None or not (actor.roles_in(contract.studio_id) or version.sent_at is not None):
        raise ContractVersionNotFound(f"this contract has no version {number}")
    return version


def newest_of(session: Session, contract: Contract) -> ContractVersion:
    """Return the newest version of a contract's text; raise ContractVersionNotFound where it has none."""
    newest = queries.newest_version(session, contract.id)
    if newest is None:
        raise ContractVersionNotFound("this contract has no text")
    return newest


def add_version(
    session: Session,
    actor: Actor,
    contract: Contract,
    clauses: Sequence[Clause],
    terms: Terms,
    *,
    note: str,
    is_needed: bool = False,
) -> ContractVersion:
    """Add the text as a version; a text equal to the newest version's is that version, unless a new one `is_needed`."""
    session.flush()
    text = text_now(session, contract, clauses, terms)
    newest = queries.newest_version(session, contract.id)
    rows = [clause.as_row() for clause in clauses]
    if newest and not is_needed and (newest.text, newest.clauses, newest.terms) == (text, rows, terms):
        return newest
    version = ContractVersion(
        studio_id=contract.studio_id,
        project_id=contract.project_id,
        contract_id=contract.id,
        number=newest.number + 1 if newest else 1,
        clauses=rows,
        terms=dict(terms),
        text=text,
        text_sha256=sha256_of(text),
        note=note,
        created_by=actor.person,
        author=session.get_one(Person, actor.person),
    )
    session.add(version)
    session.flush()
    return version


def text_now(session: Session, contract: Contract, clauses: Sequence[Clause], terms: Terms) -> str:
    """Return the text as it reads with the facts of today."""
    facts = facts_of(session, contract, terms_in_force(clauses, terms))
    return render(contract.title, clauses, terms, facts, contract.currency)
