"""Email addresses, and the links by which their holders verify them."""

from datetime import timedelta
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts import queries
from app.accounts.authentication import new_secret, sha256_of
from app.accounts.errors import AlreadyVerified, NotInDemo, VerificationNotFound
from app.accounts.models import EmailVerification, MailedLink, PasswordReset, Person, SignUp
from app.accounts.rules import Actor, AddressProof
from app.core import clock
from app.core.db import bypass_row_policies
from app.core.events import publish

RESET_LIFETIME = timedelta(hours=1)
VERIFICATION_LIFETIME = timedelta(days=1)
SIGN_UP_LIFETIME = timedelta(days=1)


def renew_secret(link: MailedLink, *, is_sent_by_mail_only: bool) -> str:
    """Give a link a new secret and return it; earlier links stop working.

    `is_sent_by_mail_only` means that the link is sent by mail and never shown here, so that its user
    has read that mail.
    """
    secret = new_secret()
    link.secret_sha256, link.is_sent_by_mail_only = sha256_of(secret), is_sent_by_mail_only
    return secret


def account_proof(link: MailedLink) -> AddressProof:
    """Return the proof that an account's own link gives; only the command line shows such a link."""
    return AddressProof.MAIL if link.is_sent_by_mail_only else AddressProof.OPERATOR


def verify(session: Session, person: Person, proof: AddressProof) -> None:
    """Keep that a person reads the mail of their address; a proof by mail replaces a weaker one."""
    if person.email_proof is AddressProof.MAIL or person.email_proof is proof:
        return
    with bypass_row_policies(session):  # the link identifies the caller before the transaction has their reach
        person.email_verified_at, person.email_proof = clock.now(), proof
        session.flush()


def request_verification(session: Session, actor: Actor) -> None:
    """Mail the caller a link that verifies their address; links mailed before lose their worth."""
    person = session.get_one(Person, actor.person)
    if person.demo_part is not None:
        raise NotInDemo("the people of the demo have no address to verify")
    if person.email_proof is AddressProof.MAIL:
        raise AlreadyVerified(f"{person.email} is verified already")
    queries.drop_verifications(session, person.id)
    asked = EmailVerification(person_id=person.id, expires_at=clock.now() + VERIFICATION_LIFETIME)
    session.add(asked)
    session.flush()
    publish(session, "address.verification_asked", studio_id=None, recipient=person.email, link_id=asked.id)


def verify_by_link(session: Session, actor: Actor, secret: str) -> Person:
    """Verify the caller's address by the link mailed to it, once.

    The caller is signed in: an account opened with another person's address must not be verified by that
    person's click. Raises VerificationNotFound for an expired or used link, and for one of another account.
    """
    asked = queries.open_verification(session, sha256_of(secret), actor.person)
    if asked is None:
        raise VerificationNotFound(
            "this link was used already, is older than a day, or belongs to another account",
            fix="sign in with the account that asked for it, or ask for a new link on the page Account",
        )
    person = session.get_one(Person, actor.person)
    asked.used_at = clock.now()
    session.flush()
    verify(session, person, account_proof(asked))
    return person


def begin_reset(session: Session, address: str) -> UUID | None:
    """Return the id of a new link to set a password, None where the address has no account that could use one."""
    person = queries.person_by_email(session, address)
    if person is None or person.demo_part is not None:
        return None
    reset = PasswordReset(person_id=person.id, expires_at=clock.now() + RESET_LIFETIME)
    session.add(reset)
    session.flush()
    return reset.id


def begin_sign_up(session: Session, address: str) -> UUID | None:
    """Return the id of a new link to open an account, None where the address has one."""
    if queries.has_account(session, address):
        return None
    queries.drop_sign_ups(session, address)
    begun = SignUp(email=address, expires_at=clock.now() + SIGN_UP_LIFETIME)
    session.add(begun)
    session.flush()
    return begun.id
