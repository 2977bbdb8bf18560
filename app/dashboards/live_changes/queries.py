"""Of whose changes a person may know: of the projects that they see, and of no more rooms of them than they see."""

from collections import defaultdict
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from uuid import UUID

from sqlalchemy import select

from app.accounts.models import Membership, SignIn, Studio
from app.accounts.queries import IDLE_FOR
from app.accounts.rules import LEAD_ROLES, MembersSee, Role
from app.core import clock
from app.core.change_feed import Viewer
from app.core.changes import Scope
from app.core.db import Database
from app.projects.models import Engagement, Liaison, Project, ProjectMember
from app.projects.visibility import engaged_with_nda_accepted

BEFORE_NDA = frozenset({"projects", "agreements"})  # what a designer sees before the project's NDA is accepted
GRANTING = frozenset({"accounts", "projects", "agreements"})  # where roles, engagements and NDAs are written
STUDIOS_OWN = frozenset({"accounts", "notifications"})  # of a studio outside its projects: people and mails
PARTIES_ONLY = frozenset({"agreements", "money"})  # contracts and money: members of the studio who act for it


@dataclass
class PersonsSight:
    """The studios and projects of one person."""

    roles: dict[UUID, frozenset[Role]] = field(default_factory=dict)  # by studio
    limited_in: set[UUID] = field(default_factory=set)  # studios of which they see only the projects that they are in
    own_projects: set[UUID] = field(default_factory=set)
    speaks_in: set[UUID] = field(default_factory=set)  # projects
    engaged_in: dict[UUID, bool] = field(default_factory=dict)  # by project: whether the NDA is behind them

    def visible_rooms(self, scope: Scope, rooms: Collection[str]) -> set[str]:
        """Return the rooms of a project, or of a studio outside its projects, that the person sees."""
        seen = set(rooms)
        if (roles := self.roles.get(scope.studio_id)) is not None and not self._is_closed(scope):
            if Role.PRODUCER in roles:
                return seen
            if scope.project_id is None:
                return seen & STUDIOS_OWN
            speaks = scope.project_id in self.speaks_in and not roles.isdisjoint(LEAD_ROLES)
            return seen if speaks else seen - PARTIES_ONLY
        if scope.project_id not in self.engaged_in:
            return set()
        return seen if self.engaged_in[scope.project_id] else seen & BEFORE_NDA

    def _is_closed(self, scope: Scope) -> bool:
        is_own = scope.project_id is None or scope.project_id in self.own_projects | self.engaged_in.keys()
        return scope.studio_id in self.limited_in and not is_own


def sights_of(database: Database, viewers: Collection[Viewer]) -> Mapping[Viewer, PersonsSight]:
    """Return the sight of each viewer; viewers who are signed out, or visitors of no demo, are left out."""
    people = {viewer.person_id for viewer in viewers}
    hashes = {viewer.session_sha256 for viewer in viewers if viewer.session_sha256 is not None}
    sights: dict[UUID, PersonsSight] = defaultdict(PersonsSight)
    with database.reading() as session:
        now = clock.now()
        signed_in = set(
            session.scalars(
                select(SignIn.secret_sha256).where(
                    SignIn.secret_sha256.in_(hashes), SignIn.expires_at > now, SignIn.last_seen_at > now - IDLE_FOR
                )
            )
        )
        members = (
            select(Membership.person_id, Membership.studio_id, Membership.roles, Studio.is_demo, Studio.members_see)
            .join(Studio)
            .where(Membership.person_id.in_(people))
        )
        in_demo: set[UUID] = set()
        for person_id, studio_id, roles, is_demo, members_see in session.execute(members):
            sights[person_id].roles[studio_id] = frozenset(map(Role, roles))
            if members_see is MembersSee.OWN:
                sights[person_id].limited_in.add(studio_id)
            if is_demo:
                in_demo.add(person_id)
        memberships = select(ProjectMember.person_id, ProjectMember.project_id).where(
            ProjectMember.person_id.in_(people)
        )
        for person_id, project_id in session.execute(memberships):
            sights[person_id].own_projects.add(project_id)
        speaking = select(Liaison.person_id, Liaison.project_id).where(Liaison.person_id.in_(people))
        for person_id, project_id in session.execute(speaking):
            sights[person_id].speaks_in.add(project_id)
        engaged = (
            select(Engagement.designer_id, Engagement.project_id, engaged_with_nda_accepted(), Studio.is_demo)
            .join(Project, Project.id == Engagement.project_id)
            .join(Studio, Studio.id == Project.studio_id)
            .where(Engagement.designer_id.in_(people), Engagement.ended_at.is_(None))
        )
        for person_id, project_id, is_past_nda, is_demo in session.execute(engaged):
            engaged_in = sights[person_id].engaged_in
            engaged_in[project_id] = engaged_in.get(project_id, False) or bool(is_past_nda)
            if is_demo:
                in_demo.add(person_id)
    return {
        viewer: sights[viewer.person_id]
        for viewer in viewers
        if (viewer.person_id in in_demo if viewer.session_sha256 is None else viewer.session_sha256 in signed_in)
    }
