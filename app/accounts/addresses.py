"""Mail addresses, and the links by which their holders show that they read them."""

from datetime import timedelta
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts import queries
from app.accounts.doors import new_secret, sha256_of
from app.accounts.errors import AlreadyVerified, NotInDemo, VerificationNotFound
from app.accounts.models import EmailVerification, MailedLink, PasswordReset, Person, SignUp
from app.accounts.rules import Actor, AddressProof
from app.kit import clock
from app.kit.db import beyond_reach
from app.kit.events import publish

RESET_LASTS = timedelta(hours=1)
VERIFICATION_LASTS = timedelta(days=1)
SIGN_UP_LASTS = timedelta(days=1)


def renew_secret(link: MailedLink, *, is_only_mailed: bool) -> str:
    """Give a link a new secret and return it; whatever link there was before is worthless from now on.

    `is_only_mailed` says that the link goes out by mail and is shown to nobody here, so that whoever follows it
    reads that mail.
    """
    secret = new_secret()
    link.secret_sha256, link.is_only_mailed = sha256_of(secret), is_only_mailed
    return secret


def account_proof(link: MailedLink) -> AddressProof:
    """Return what following an account's own link shows; only the command line shows such a link to anybody."""
    return AddressProof.MAIL if link.is_only_mailed else AddressProof.OPERATOR


def verify(session: Session, person: Person, proof: AddressProof) -> None:
    """Keep that a person reads the mail of their address; a proof by mail replaces a weaker one."""
    if person.email_proof is AddressProof.MAIL or person.email_proof is proof:
        return
    with beyond_reach(session):  # the link says who comes, before the transaction is theirs
        person.email_verified_at, person.email_proof = clock.now(), proof
        session.flush()


def ask_verification(session: Session, actor: Actor) -> None:
    """Mail the caller a link that verifies their address; links mailed before lose their worth."""
    person = session.get_one(Person, actor.person)
    if person.demo_part is not None:
        raise NotInDemo("the people of the demo have no address to verify")
    if person.email_proof is AddressProof.MAIL:
        raise AlreadyVerified(f"{person.email} is verified already")
    queries.drop_verifications(session, person.id)
    asked = EmailVerification(person_id=person.id, expires_at=clock.now() + VERIFICATION_LASTS)
    session.add(asked)
    session.flush()
    publish(session, "address.verification_asked", studio_id=None, recipient=person.email, link_id=asked.id)


def verify_by_link(session: Session, actor: Actor, secret: str) -> Person:
    """Verify the caller's address by the link mailed to it, once.

    The caller is signed in: whoever opened an account with somebody else's address must not have it verified by that
    somebody's click. Raises VerificationNotFound for a link past use, and for one of another account.
    """
    asked = queries.open_verification(session, sha256_of(secret), actor.person)
    if asked is None:
        raise VerificationNotFound(
            "this link is used, older than a day, or for another account",
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
    reset = PasswordReset(person_id=person.id, expires_at=clock.now() + RESET_LASTS)
    session.add(reset)
    session.flush()
    return reset.id


def begin_sign_up(session: Session, address: str) -> UUID | None:
    """Return the id of a new link to open an account, None where the address has one."""
    if queries.has_account(session, address):
        return None
    queries.drop_sign_ups(session, address)
    begun = SignUp(email=address, expires_at=clock.now() + SIGN_UP_LASTS)
    session.add(begun)
    session.flush()
    return begun.id
