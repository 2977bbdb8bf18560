"""Links of postings: what they show, and how a person without an account comes to bid."""

from dataclasses import replace
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.authentication import sha256_of
from app.accounts.models import Person
from app.accounts.people import person_by_link
from app.accounts.rules import Actor, ensure_address
from app.core import clock
from app.core.db import bypass_row_policies, set_access_scope
from app.hiring import queries
from app.hiring.errors import LinkTaken, OwnPosting, PersonalLinkNeeded, PostingNotFound
from app.hiring.models import Candidate, Posting
from app.hiring.postings.access import is_nda_open, today_of
from app.hiring.postings.service import LINK_LIFETIME, mail_link
from app.hiring.rules import PostingState, ensure_takes_bids


def posting_by_link(session: Session, secret: str) -> tuple[Posting, Candidate | None]:
    """Return the posting behind a link, with its project and studio, and whose personal link it is.

    Raises PostingNotFound for a link that is unknown, withdrawn or too old, and for a draft.
    """
    with bypass_row_policies(session):  # only the secret identifies the posting
        posting_and_candidate = queries.posting_by_secret(session, sha256_of(secret))
    if posting_and_candidate is None or posting_and_candidate[0].state is PostingState.DRAFT:
        raise PostingNotFound("this link is unknown, withdrawn or expired", fix="ask the studio for a new one")
    return posting_and_candidate


def join(session: Session, actor: Actor, secret: str) -> UUID:
    """Let the caller bid on the posting behind a link; a personal link belongs to the first account that uses it."""
    posting, candidate = posting_by_link(session, secret)
    if actor.roles_in(posting.studio_id):
        raise OwnPosting("you are a member of the studio that posted this", fix="open it under People, Postings")
    with bypass_row_policies(session):  # the person who joins cannot see the project yet
        person = session.get_one(Person, actor.person)
        own = queries.candidate_by_person(session, posting.id, person.id)
        if own is not None and own.revoked_at is None:
            return posting.id
        if candidate is not None and candidate.person_id is not None:
            raise LinkTaken("another account has used this link", fix="sign in with that account, or ask the studio")
        if own is not None:
            raise PostingNotFound("the studio took you off this posting", fix="ask the studio")
        if candidate is None:
            candidate = queries.candidate_by_address(session, posting.id, person.email)
        if candidate is None or candidate.revoked_at is not None:
            candidate = candidate or Candidate(
                studio_id=posting.studio_id,
                project_id=posting.project_id,
                posting_id=posting.id,
                email=person.email,
                expires_at=clock.now() + LINK_LIFETIME,
            )
            if candidate.revoked_at is not None:
                raise PostingNotFound("the studio took you off this posting", fix="ask the studio")
            session.add(candidate)
        candidate.person_id, candidate.joined_at = person.id, clock.now()
        session.flush()
    return posting.id


def ask_for_link(session: Session, secret: str, email: str) -> None:
    """Mail a personal link to a person who came by the link for everyone; a person taken off gets nothing.

    Raises PostingClosed where the posting takes no bids.
    """
    posting, _ = posting_by_link(session, secret)
    ensure_takes_bids(posting.state, posting.bids_until_on, today_of(posting))
    address = ensure_address(email)
    with bypass_row_policies(session):  # nobody is signed in
        candidate = queries.candidate_by_address(session, posting.id, address)
        if candidate is None:
            candidate = Candidate(
                studio_id=posting.studio_id, project_id=posting.project_id, posting_id=posting.id, email=address
            )
            session.add(candidate)
        elif candidate.revoked_at is not None:
            return
        candidate.expires_at = clock.now() + LINK_LIFETIME
        session.flush()
        mail_link(session, posting, candidate)


def account_by_link(session: Session, actor: Actor, secret: str, *, name: str | None, password: str | None) -> Person:
    """Return the holder of the address that a personal link was mailed to, with an account made now if there is none.

    Raises PersonalLinkNeeded for the link for everyone, which proves no address.
    """
    _, candidate = posting_by_link(session, secret)
    if candidate is None:
        raise PersonalLinkNeeded(
            "this link is for everyone and belongs to no address", fix="ask for a link of your own, by email"
        )
    return person_by_link(session, actor, candidate.email, candidate, name=name, password=password)


def preview(session: Session, actor: Actor, secret: str) -> tuple[Posting, Candidate | None, bool]:
    """Return the posting behind a link, whose personal link it is, and whether an NDA keeps it from the caller."""
    posting, candidate = posting_by_link(session, secret)
    if actor.person_id is None:
        return posting, candidate, posting.project.nda_needed
    if actor.roles_in(posting.studio_id):
        return posting, candidate, False
    set_access_scope(session, replace(actor.reach, project_id=posting.project_id))
    return posting, candidate, is_nda_open(session, posting, actor.person_id)
