"""Postings: written, opened, closed, and who is asked."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import date, timedelta
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.authentication import new_secret, sha256_of
from app.accounts.rules import AccessKind, Actor, MemberChange, ensure_address
from app.core import clock
from app.core.db import bypass_row_policies
from app.core.errors import FieldProblem
from app.core.events import publish
from app.hiring import queries
from app.hiring.errors import (
    CandidateNotFound,
    PostingChanged,
    PostingInvalid,
    PostingNotFound,
    WrongPostingState,
)
from app.hiring.models import Candidate, Posting
from app.hiring.postings.access import PostingAccess, posting_access, posting_for_team, today_of
from app.hiring.rules import (
    AskedScope,
    PostingPhase,
    PostingState,
    asked_lines,
    ensure_can_open,
    ensure_dates_in_order,
)
from app.projects.budgets.queries import latest_budget_currency
from app.projects.models import Project
from app.projects.service import project_access
from app.sound_lists.models import Cue

DEFAULT_CURRENCY = "USD"  # of a studio that has named none
LINK_LIFETIME = timedelta(days=90)


@dataclass(frozen=True)
class PostingFields:
    """The content of a posting."""

    title: str
    text: str
    equipment: str
    phase: PostingPhase
    currency: str | None  # None: as it is; of a new posting the usual one of its project
    price_minor: int | None
    budget_minor: int | None
    is_budget_shown: bool
    rate_floor_minor: int | None
    scope: AskedScope
    categories: Sequence[str]
    cue_ids: Sequence[UUID]
    headings: Sequence[str]
    bids_until_on: date | None
    work_from_on: date | None
    work_to_on: date | None


FIXED_ONCE_OPEN = ("phase", "currency", "scope", "categories", "cue_ids")  # what bids are made on


def postings_of(session: Session, actor: Actor, project_id: UUID) -> Sequence[Posting]:
    """Return the postings of a project, newest first, for those who act for the studio."""
    project_access(session, actor, project_id).ensure_may_speak()
    return queries.postings_in(session, project_id)


def create_posting(session: Session, actor: Actor, project_id: UUID, fields: PostingFields) -> UUID:
    """Begin a posting as a draft, its lines counted from the list."""
    access = project_access(session, actor, project_id)
    access.ensure_may_speak()
    posting = Posting(
        studio_id=access.project.studio_id, project_id=project_id, state=PostingState.DRAFT, created_by=actor.person
    )
    if fields.currency is None:
        fields = replace(fields, currency=usual_currency(session, access.project))
    _put(session, posting, fields)
    session.add(posting)
    session.flush()
    return posting.id


def usual_currency(session: Session, project: Project) -> str:
    """Return the currency of a project's budget, else the last one of its postings, else the studio's, else USD."""
    return (
        latest_budget_currency(session, project.studio_id, project.id)
        or queries.last_currency(session, project.studio_id, project.id)
        or latest_budget_currency(session, project.studio_id)
        or queries.last_currency(session, project.studio_id)
        or DEFAULT_CURRENCY
    )


def change_posting(session: Session, actor: Actor, posting_id: UUID, fields: PostingFields, *, revision: int) -> None:
    """Change a posting; what bids are made on is fixed once it is open."""
    posting = posting_for_team(session, actor, posting_id)
    if fields.currency is None:
        fields = replace(fields, currency=posting.currency)
    if posting.revision != revision:
        raise PostingChanged("someone changed this posting since you read it", fix="read it again, then save yours")
    if posting.state is PostingState.AWARDED:
        raise WrongPostingState("this posting is awarded")
    if posting.state is not PostingState.DRAFT:
        new = _as_stored(fields)
        moved = [name for name in FIXED_ONCE_OPEN if new[name] != getattr(posting, name)]
        if moved:
            message = "is fixed once the posting is open, since bids are made on it"
            errors = [FieldProblem(where=name, message=message) for name in moved]
            raise PostingInvalid(f"{moved[0]} {message}", errors=errors, fix="write another posting for other sounds")
    _put(session, posting, fields)
    posting.revision += 1
    session.flush()


def _as_stored(fields: PostingFields) -> dict[str, Any]:
    stored = vars(fields) | {"headings": list(dict.fromkeys(fields.headings))}
    stored["categories"] = sorted(set(fields.categories)) if fields.scope is AskedScope.CATEGORIES else []
    stored["cue_ids"] = sorted({str(cue_id_) for cue_id_ in fields.cue_ids}) if fields.scope is AskedScope.CUES else []
    return stored


def _put(session: Session, posting: Posting, fields: PostingFields) -> None:
    errors = ensure_dates_in_order(fields.work_from_on, fields.work_to_on, names=("work_from_on", "work_to_on"))
    if errors:
        raise PostingInvalid("; ".join(f"{error['where']} {error['message']}" for error in errors), errors=errors)
    for name, value in _as_stored(fields).items():
        setattr(posting, name, value)
    if posting.state is PostingState.DRAFT:
        posting.lines = _count(session, posting)


def _count(session: Session, posting: Posting) -> list[dict[str, Any]]:
    cues = queries.counted_cues(session, posting.project_id)
    if posting.scope is AskedScope.CATEGORIES:
        cues = [cue for cue in cues if cue.category in posting.categories]
    elif posting.scope is AskedScope.CUES:
        chosen = set(posting.cue_ids)
        cues = [cue for cue in cues if cue.id in chosen]
    return asked_lines(cues)


def asked_cue_ids(session: Session, posting: Posting, keys: Sequence[str]) -> list[UUID]:
    """Return the cues of a posting whose lines have these keys, in list order."""
    chosen = set(posting.cue_ids) if posting.scope is AskedScope.CUES else None
    return [
        UUID(cue.id)
        for cue in queries.counted_cues(session, posting.project_id)
        if cue.category in keys and (chosen is None or cue.id in chosen)
    ]


def asked_cues(session: Session, actor: Actor, posting_id: UUID) -> list[Cue]:
    """Return the cues that a posting asks for as the list has them now: to the team, and to candidates after an NDA."""
    access = posting_seen(session, actor, posting_id)
    access.ensure_after_nda()
    posting = access.posting
    chosen = set(posting.cue_ids) if posting.scope is AskedScope.CUES else None
    cues = queries.cues_of_lines(session, posting.project_id, [line["key"] for line in posting.lines])
    return [cue for cue in cues if chosen is None or str(cue.id) in chosen]


def open_posting(session: Session, actor: Actor, posting_id: UUID) -> None:
    """Take bids from now on, and mail those who were asked; a closed posting opens again."""
    posting = posting_for_team(session, actor, posting_id)
    is_first = posting.state is PostingState.DRAFT
    if is_first:
        posting.lines = _count(session, posting)
    ensure_can_open(
        posting.state,
        lines=len(posting.lines),
        phase=posting.phase,
        until=posting.bids_until_on,
        today=today_of(posting),
    )
    posting.state, posting.closed_at = PostingState.OPEN, None
    posting.opened_at = posting.opened_at or clock.now()
    posting.revision += 1
    session.flush()
    if is_first:
        for candidate in queries.candidates_of(session, posting_id):
            if candidate.invited_by is not None:
                mail_link(session, posting, candidate)


def close_posting(session: Session, actor: Actor, posting_id: UUID) -> None:
    """Take no more bids."""
    posting = posting_for_team(session, actor, posting_id)
    if posting.state is not PostingState.OPEN:
        raise WrongPostingState(f"this posting is {posting.state.value}")
    posting.state, posting.closed_at = PostingState.CLOSED, clock.now()
    posting.revision += 1
    session.flush()


def invite(session: Session, actor: Actor, posting_id: UUID, email: str) -> None:
    """Ask a person for a bid: by mail at once, or when the posting opens."""
    posting = posting_for_team(session, actor, posting_id)
    if posting.state is PostingState.AWARDED:
        raise WrongPostingState("this posting is awarded")
    address = ensure_address(email)
    candidate = queries.candidate_by_address(session, posting_id, address)
    if candidate is None:
        candidate = Candidate(
            studio_id=posting.studio_id, project_id=posting.project_id, posting_id=posting_id, email=address
        )
        session.add(candidate)
    candidate.invited_by, candidate.revoked_at = actor.person, None
    candidate.expires_at = clock.now() + LINK_LIFETIME
    session.flush()
    if posting.state is not PostingState.DRAFT:
        mail_link(session, posting, candidate)


def mail_link(session: Session, posting: Posting, candidate: Candidate) -> None:
    """Have a personal link mailed; an earlier one of theirs stops working."""
    publish(
        session,
        "posting.shared",
        studio_id=posting.studio_id,
        project_id=posting.project_id,
        recipient=candidate.email,
        link_id=candidate.id,
        subject_name=posting.title,
        from_name=posting.project.studio.name,
    )


def withdraw_invitation(session: Session, actor: Actor, posting_id: UUID, candidate_id: UUID) -> None:
    """Take a person off the posting: their link shows nothing any more, and they see the posting no longer."""
    posting = posting_for_team(session, actor, posting_id)
    for candidate in queries.candidates_of(session, posting.id):
        if candidate.id == candidate_id:
            candidate.revoked_at = clock.now()
            session.flush()
            return
    raise CandidateNotFound(f"no candidate {candidate_id} of this posting")


def make_link(session: Session, actor: Actor, posting_id: UUID) -> str:
    """Return the secret of a new link for everyone; an earlier one stops working."""
    posting = posting_for_team(session, actor, posting_id)
    secret = new_secret()
    posting.secret_sha256, posting.link_made_by = sha256_of(secret), actor.person
    session.flush()
    return secret


def revoke_link(session: Session, actor: Actor, posting_id: UUID) -> None:
    """Withdraw the link for everyone; who came by it stays."""
    _drop_link(posting_for_team(session, actor, posting_id))
    session.flush()


def end_links_of_member(session: Session, payload: Mapping[str, Any]) -> None:
    """Revoke the links of who left the studio, or keep them in another name: a handler of `member.changed`."""
    change = MemberChange.of(payload)
    if not change.has_left:
        return
    for posting in queries.postings_linked_by(session, change.studio_id, change.person_id):
        if AccessKind.POSTING_LINKS in change.kept:
            posting.link_made_by = change.changed_by
        else:
            _drop_link(posting)
    session.flush()


def _drop_link(posting: Posting) -> None:
    posting.secret_sha256 = posting.link_made_by = None


def candidate_postings(session: Session, actor: Actor) -> Sequence[Posting]:
    """Return the postings that the caller may bid on, newest first."""
    with bypass_row_policies(session):  # candidates are not engaged; the query keeps to the caller's own
        return queries.postings_of_candidate(session, actor.person)


def posting_seen(session: Session, actor: Actor, posting_id: UUID) -> PostingAccess:
    """Return the caller's place at a posting: those who act for the studio, and candidates once it is open."""
    access = posting_access(session, actor, posting_id)
    if access.team is not None:
        access.ensure_team()
    elif access.posting.state is PostingState.DRAFT:
        raise PostingNotFound(f"no posting {posting_id}")
    return access
