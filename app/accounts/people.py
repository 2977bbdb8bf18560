"""Accounts of people: making one, proving to be one, and the passwords in between."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts import passwords, queries
from app.accounts.addresses import account_proof, verify
from app.accounts.authentication import sha256_of
from app.accounts.errors import AddressTaken, NameNeeded, NotInDemo, ResetNotFound, SignInNeeded, WrongPassword
from app.accounts.models import MailedLink, Person
from app.accounts.rules import Actor, AddressProof, ensure_address, ensure_strong_password, normalised_email
from app.accounts.second_factors import queries as second_factor_queries
from app.core import clock
from app.core.access_scope import AccessScope
from app.core.db import Database, bypass_row_policies, set_access_scope
from app.core.events import publish


def create_person(
    session: Session,
    *,
    email: str,
    name: str,
    password: str | None = None,
    studio_name: str = "",
    demo_part: str | None = None,
) -> Person:
    """Make an account; raise AddressTaken when the address has one.

    Without a password the demo or a sign-in provider lets it in.
    """
    address = ensure_address(email)
    if queries.has_account(session, address):
        raise AddressTaken(
            f"{address} already has an account",
            fix="sign in, or ask for a new password",
            errors=[{"where": "email", "message": "this email already has an account: sign in"}],
        )
    password_hash = None
    if password is not None:
        password_hash = passwords.hash_of(ensure_strong_password(password, address, name, studio_name))
    person = Person(email=address, name=name, password_hash=password_hash, demo_part=demo_part)
    session.add(person)
    session.flush()
    return person


def person_with_password(database: Database, email: str, password: str) -> UUID | None:
    """Return the person of an address and password. Takes as long for an unknown address, and no transaction waits."""
    with database.reading() as session:
        person = queries.person_by_email(session, normalised_email(email))
        person_id, password_hash = (person.id, person.password_hash) if person else (None, None)
    return person_id if passwords.matches(password, password_hash) else None


def person_by_link(
    session: Session,
    actor: Actor,
    address: str,
    link: MailedLink,
    *,
    name: str | None,
    password: str | None,
    studio_name: str = "",
) -> Person:
    """Return the person of an invitation's address: the account's holder, or a new account's.

    A link that was only mailed verifies the address. Raises SignInNeeded when the address has an account and the
    caller has not shown to be its holder.
    """
    person = queries.person_by_email(session, address)
    if person is None:
        if not name:
            message = "enter your name"
            raise NameNeeded(message, errors=[{"where": "name", "message": message}])
        person = create_person(session, email=address, name=name, password=password or "", studio_name=studio_name)
    elif actor.person_id != person.id and not (password and passwords.matches(password, person.password_hash)):
        raise SignInNeeded(
            f"{address} has an account; this link is for its holder",
            fix=f"sign in as {address}, or give its password",
            errors=[{"where": "password", "message": "this is not the account's password"}] if password else [],
        )
    elif actor.person_id != person.id:
        _ensure_no_second_factor(session, person)
    if link.is_sent_by_mail_only:
        verify(session, person, AddressProof.MAIL)
    return person


def _ensure_no_second_factor(session: Session, person: Person) -> None:
    with bypass_row_policies(session):  # the password identifies the caller
        if not second_factor_queries.has_second_factor(session, person.id):
            return
    message = "this account asks for a second factor: sign in first, then open the link again"
    raise SignInNeeded(message, errors=[{"where": "password", "message": message}])


def rename(session: Session, actor: Actor, name: str) -> Person:
    """Change the caller's own name."""
    person = session.get_one(Person, actor.person)
    person.name = name
    return person


def request_reset(session: Session, email: str) -> None:
    """Have a link for a new password mailed, if the address has an account; to find out is left to the job."""
    publish(session, "password.reset_asked", studio_id=None, recipient=normalised_email(email))


def may_enter_by_link(session: Session, person: Person) -> bool:
    """Whether a mailed link that set a password signs in too: not where a second factor is asked for."""
    return not second_factor_queries.has_second_factor(session, person.id)


def reset_password(session: Session, secret: str, password: str) -> Person:
    """Set a new password by a mailed link, once, and end every sign-in and desk token.

    Raise ResetNotFound for a link past use. The link was the account's own, so it verifies the address too.
    """
    with bypass_row_policies(session):  # only the secret identifies the link
        reset = queries.open_reset(session, sha256_of(secret))
    if reset is None:
        raise ResetNotFound("this link was used already or is older than an hour", fix="ask for a new one")
    set_access_scope(session, AccessScope(person_id=reset.person_id))
    person = session.get_one(Person, reset.person_id)
    person.password_hash = passwords.hash_of(_strong(session, person, password))
    reset.used_at = clock.now()
    session.flush()
    verify(session, person, account_proof(reset))
    queries.drop_resets(session, person.id)
    queries.end_sign_ins(session, person.id)
    queries.end_desk_tokens(session, person.id)
    publish(session, "password.changed", studio_id=None, person_id=person.id)
    return person


def change_password(session: Session, actor: Actor, *, current: str, new: str, kept_secret: str | None) -> None:
    """Change the caller's password, and end every desk token, and every sign-in but the one it is changed from."""
    person = session.get_one(Person, actor.person)
    if person.demo_part is not None:
        raise NotInDemo("the people of the demo have no password")
    if person.password_hash is None:
        raise WrongPassword(
            "your account has no password: you sign in by your studio's provider",
            fix="to have one too, ask for a link under “Forgot password?”",
        )
    if not passwords.matches(current, person.password_hash):
        message = "this is not your current password"
        raise WrongPassword(message, errors=[{"where": "current", "message": message}])
    person.password_hash = passwords.hash_of(_strong(session, person, new))
    queries.drop_resets(session, person.id)
    queries.end_sign_ins(session, person.id, except_sha256=sha256_of(kept_secret) if kept_secret else None)
    queries.end_desk_tokens(session, person.id)
    publish(session, "password.changed", studio_id=None, person_id=person.id)


def _strong(session: Session, person: Person, password: str) -> str:
    with bypass_row_policies(session):  # names of their studios alone
        studios = queries.names_of_studios(session, person.id)
    return ensure_strong_password(password, person.email, person.name, *studios)
