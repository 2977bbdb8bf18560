"""Operators of the server, and what they do to accounts: on its command line only."""

from sqlalchemy.orm import Session

from app.accounts import people, queries, service
from app.accounts.errors import AddressNotVerified, OperatorNotFound
from app.accounts.models import Operator, Person
from app.accounts.rules import normalised_email
from app.accounts.second_factors import service as second_factors
from app.core.db import insert_if_absent


def add_operator(session: Session, address: str) -> Person:
    """Make an account's holder an operator; raise AddressNotVerified unless they have verified their address."""
    person = _person(session, address)
    if person.email_verified_at is None:
        raise AddressNotVerified(
            f"{person.email} is not verified, so the account may belong to another person",
            fix="have its holder ask for a link on the page Account and follow it; without a mail server, "
            f"soundlist mails {person.email} prints the link",
        )
    insert_if_absent(session, Operator, {"person_id": person.id}, unique=("person_id",))
    return person


def add_account(session: Session, address: str, name: str, password: str, studio_name: str) -> Person:
    """Make an account and, where a name of one is given, the studio it produces for."""
    if studio_name:
        return service.sign_up(session, email=address, name=name, password=password, studio_name=studio_name)
    return people.create_person(session, email=address, name=name, password=password)


def remove_operator(session: Session, address: str) -> Person:
    """Remove an operator; raise OperatorNotFound if the person is none."""
    person = _person(session, address)
    operator = session.get(Operator, person.id)
    if operator is None:
        raise OperatorNotFound(f"{person.email} is not an operator", fix="soundlist operators list names those who are")
    session.delete(operator)
    return person


def sign_out(session: Session, address: str) -> Person:
    """End every sign-in and desk token of an account, as when a device or a password was stolen."""
    person = _person(session, address)
    queries.end_sign_ins(session, person.id)
    queries.end_desk_tokens(session, person.id)
    return person


def remove_second_factor(session: Session, address: str) -> Person:
    """Take every second factor of an account away, as when the device was lost, and end its sign-ins."""
    person = _person(session, address)
    second_factors.remove_all(session, person.id)
    return person


def _person(session: Session, address: str) -> Person:
    person = queries.person_by_email(session, normalised_email(address))
    if person is None:
        raise OperatorNotFound(f"no account has the address {address}", fix="have them sign up first")
    return person
