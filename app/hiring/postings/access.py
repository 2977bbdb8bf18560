"""Viewers of a posting: those who act for the studio, and candidates as far as an NDA lets them."""

from dataclasses import dataclass, replace
from datetime import date
from uuid import UUID
from zoneinfo import ZoneInfo

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.core import clock
from app.core.db import bypass_row_policies, set_access_scope
from app.hiring import queries
from app.hiring.errors import BidNotFound, BidNotSent, PostingNotFound
from app.hiring.models import Bid, Posting
from app.hiring.rules import BidState
from app.projects.errors import DesignerNeeded, NdaNeeded, ProjectNotFound, TeamNeeded
from app.projects.queries import any_engagement_of
from app.projects.service import ProjectAccess, project_access
from app.projects.visibility import nda_is_pending


@dataclass(frozen=True)
class PostingAccess:
    """A caller's place at one posting: `team` is None for a candidate."""

    posting: Posting
    actor: Actor
    team: ProjectAccess | None
    nda_open: bool

    def ensure_team(self) -> ProjectAccess:
        """Return the caller's access to the project; raise TeamNeeded unless they act for the studio."""
        if self.team is None:
            raise TeamNeeded("only a producer or an audio lead of this project can do this")
        self.team.ensure_may_speak()
        return self.team

    def ensure_candidate(self) -> None:
        """Raise DesignerNeeded for the studio's own people, NdaNeeded while an NDA comes first."""
        if self.team is not None:
            raise DesignerNeeded("only a designer who was asked can do this")
        self.ensure_after_nda()

    def ensure_after_nda(self) -> None:
        """Raise NdaNeeded while an NDA comes first for the caller."""
        if self.nda_open:
            raise NdaNeeded(
                "this posting shows what it asks for once the project's non-disclosure agreement is signed",
                fix="the studio sends it to you; you find it under Contract & money",
            )


def posting_access(session: Session, actor: Actor, posting_id: UUID) -> PostingAccess:
    """Return the caller's place at a posting; raise PostingNotFound if they may not see it."""
    with bypass_row_policies(session):  # a candidate is not engaged, so their reach does not show the project
        posting = queries.posting_for(session, actor, posting_id)
    if posting is None:
        raise PostingNotFound(f"no posting {posting_id}")
    if actor.roles_in(posting.studio_id):
        try:
            access = project_access(session, actor, posting.project_id)
        except ProjectNotFound:  # a member who is not in the project
            raise PostingNotFound(f"no posting {posting_id}") from None
        return PostingAccess(posting, actor, access, nda_open=False)
    set_access_scope(session, replace(actor.reach, project_id=posting.project_id))
    return PostingAccess(posting, actor, None, nda_open=is_nda_open(session, posting, actor.person))


def is_nda_open(session: Session, posting: Posting, person_id: UUID) -> bool:
    """Whether a candidate has yet to sign the NDA that the project asks for."""
    if not posting.project.nda_needed:
        return False
    engagement = any_engagement_of(session, posting.project_id, person_id)
    return engagement is None or engagement.ended_at is not None or nda_is_pending(posting.project, engagement)


def posting_for_team(session: Session, actor: Actor, posting_id: UUID) -> Posting:
    """Return a posting, locked, for those who act for the studio."""
    access = posting_access(session, actor, posting_id)
    access.ensure_team()
    queries.lock_posting(session, posting_id)
    return posting_access(session, actor, posting_id).posting


def bid_for_team(session: Session, actor: Actor, bid_id: UUID) -> Bid:
    """Return a bid that was sent, for those who act for the studio; its own designer gets TeamNeeded."""
    bid = queries.bid_for(session, actor, bid_id)
    if bid is None:
        raise BidNotFound(f"no bid {bid_id}")
    posting_access(session, actor, bid.posting_id).ensure_team()
    if bid.state is not BidState.SENT:
        raise BidNotSent("this bid was withdrawn")
    return bid


def today_of(posting: Posting) -> date:
    """Return the day that it is now for the studio."""
    return clock.now().astimezone(ZoneInfo(posting.project.studio.time_zone)).date()
