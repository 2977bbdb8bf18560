"""Changes of an account's address, which its holder confirms from the old address and from the new one."""

from datetime import timedelta

from sqlalchemy.orm import Session

from app.accounts import queries
from app.accounts.addresses import account_proof
from app.accounts.authentication import sha256_of
from app.accounts.email_changes import queries as email_change_queries
from app.accounts.errors import AddressTaken, EmailChangeNotFound, NotInDemo, SameAddress
from app.accounts.models import EmailChange, Person
from app.accounts.rules import Actor, ensure_address
from app.core import clock
from app.core.db import bypass_row_policies
from app.core.events import publish

LIFETIME = timedelta(days=1)


def request_email_change(session: Session, actor: Actor, new_email: str) -> list[EmailChange]:
    """Have a link mailed to the caller's address and to the new one, and drop an earlier change; return both ends.

    Whether the new address has an account is shown only to who reads its mail.
    """
    person = session.get_one(Person, actor.person)
    if person.demo_part is not None:
        raise NotInDemo("the people of the demo have no address to change")
    address = ensure_address(new_email)
    if address == person.email:
        message = f"{address} is your email already"
        raise SameAddress(message, errors=[{"where": "email", "message": message}])
    email_change_queries.drop_email_changes(session, person.id)
    ends = [
        EmailChange(person_id=person.id, new_email=address, is_new_end=is_new_end, expires_at=clock.now() + LIFETIME)
        for is_new_end in (False, True)
    ]
    session.add_all(ends)
    session.flush()
    for end in ends:
        publish(
            session,
            "new_address.asked" if end.is_new_end else "old_address.asked",
            studio_id=None,
            recipient=address if end.is_new_end else person.email,
            link_id=end.id,
            subject_name=address,
        )
    return ends


def pending_email_change(session: Session, actor: Actor) -> list[EmailChange]:
    """Return both ends of the caller's change that waits, the old one first; empty where none does."""
    return email_change_queries.open_email_changes(session, actor.person)


def email_change_by_secret(session: Session, secret: str) -> EmailChange:
    """Return the end of a change whose link this is; raise EmailChangeNotFound for a link past use."""
    with bypass_row_policies(session):  # only the secret identifies the link
        end = email_change_queries.email_change_by_secret(session, sha256_of(secret))
    if end is None:
        raise EmailChangeNotFound(
            "this change of email was finished, stopped or not confirmed within a day",
            fix="look at the page Account, and ask for the change again there if you want it",
        )
    return end


def confirm_email_change(session: Session, actor: Actor, secret: str, *, kept_secret: str | None) -> Person:
    """Confirm one end of the caller's change by its mailed link; the second one changes the address.

    Raises EmailChangeNotFound for a link past use or of another account, AddressTaken where the new address has an
    account.
    """
    person = session.get_one(Person, actor.person, with_for_update=True)  # of two at once, the second sees the first
    confirmed = email_change_by_secret(session, secret)
    if confirmed.person_id != person.id:
        raise EmailChangeNotFound(
            "this link belongs to another account", fix="sign in with the account whose email changes"
        )
    if confirmed.is_new_end and queries.has_account(session, confirmed.new_email):
        raise AddressTaken(f"{confirmed.new_email} has an account already", fix="use another email")
    if confirmed.confirmed_at is None:
        confirmed.confirmed_at = clock.now()
        session.flush()
    ends = pending_email_change(session, actor)
    if all(end.confirmed_at is not None for end in ends):
        _change_address(session, person, next(end for end in ends if end.is_new_end), kept_secret)
    return person


def cancel_email_change(session: Session, actor: Actor) -> None:
    """Stop the caller's change; its links stop working."""
    email_change_queries.drop_email_changes(session, actor.person)


def stop_by_link(session: Session, secret: str) -> None:
    """Stop a change by the link mailed to either end."""
    end = email_change_by_secret(session, secret)
    with bypass_row_policies(session):  # its holder may be signed out
        email_change_queries.drop_email_changes(session, end.person_id)


def _change_address(session: Session, person: Person, new_end: EmailChange, kept_secret: str | None) -> None:
    """Give an account its new address, and end what the old one could still open."""
    if queries.has_account(session, new_end.new_email):
        raise AddressTaken(f"{new_end.new_email} has an account already", fix="use another email")
    publish(
        session,
        "address.changed",
        studio_id=None,
        person_id=person.id,
        old_email=person.email,
        new_email=new_end.new_email,
    )
    person.email = new_end.new_email
    person.email_verified_at, person.email_proof = clock.now(), account_proof(new_end)
    queries.drop_resets(session, person.id)
    queries.drop_verifications(session, person.id)
    queries.end_sign_ins(session, person.id, except_sha256=sha256_of(kept_secret) if kept_secret else None)
    email_change_queries.drop_email_changes(session, person.id)
    session.flush()
