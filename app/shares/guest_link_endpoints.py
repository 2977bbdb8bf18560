"""The endpoints by which a team makes guest links and sees who heard what."""

from uuid import UUID

from fastapi import APIRouter

from app.accounts.errors import PasswordTooWeak, RecentSignInNeeded
from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.runtime import Runtime
from app.core.web.http import BadCursor, CurrentRuntime, DbSession, Page, cursor_of, problems, uuid_cursor
from app.core.web.idempotency import UNSAVED
from app.projects.errors import ProjectNotFound, TeamNeeded
from app.shares import guest_links
from app.shares.errors import GuestLinkInvalid, GuestLinkNotFound, NothingToShare, PlaylistNotFound
from app.shares.schemas import (
    GuestLinkAdd,
    GuestLinkAddress,
    GuestLinkChange,
    GuestLinkMade,
    GuestLinkRead,
    GuestVisitRead,
)

router = APIRouter(prefix="/v1", tags=["guest-links"])
_unsaved_router = APIRouter(dependencies=UNSAVED)
TEAM: Actor = allows(Audience.TEAM)
PAGE = 50


@router.get("/projects/{project_id}/guest-links", responses=problems(ProjectNotFound, TeamNeeded, BadCursor))
def list_guest_links(
    project_id: UUID, session: DbSession, cursor: str | None = None, actor: Actor = TEAM
) -> Page[GuestLinkRead]:
    """Return the guest links of a project, those that open nothing any more included, newest first."""
    links = guest_links.links_of(session, actor, project_id, before=uuid_cursor(cursor), limit=PAGE + 1)
    return Page(items=links[:PAGE], next=cursor_of(links[PAGE - 1].id) if len(links) > PAGE else None)


@_unsaved_router.post(
    "/projects/{project_id}/guest-links",
    status_code=201,
    responses=problems(
        ProjectNotFound,
        TeamNeeded,
        RecentSignInNeeded,
        GuestLinkInvalid,
        PasswordTooWeak,
        NothingToShare,
        PlaylistNotFound,
    ),
)
def add_guest_link(
    project_id: UUID,
    body: GuestLinkAdd,
    session: DbSession,
    runtime: CurrentRuntime,
    actor: Actor = allows(Audience.TEAM, recent_sign_in=True),
) -> GuestLinkMade:
    """Make a link by which people without an account hear what it names as it is now."""
    link, secret = guest_links.make_link(session, actor, project_id, body, server_key=_key(runtime))
    return GuestLinkMade(link=link, url=_address(runtime, secret))


@router.patch("/guest-links/{guest_link_id}", responses=problems(GuestLinkNotFound, TeamNeeded))
def change_guest_link(
    guest_link_id: UUID, body: GuestLinkChange, session: DbSession, actor: Actor = TEAM
) -> GuestLinkRead:
    """Change until when and how often a link opens, and whether guests may comment."""
    return guest_links.change_link(session, actor, guest_link_id, body.model_dump(exclude_unset=True))


@router.post("/guest-links/{guest_link_id}/revoke", responses=problems(GuestLinkNotFound, TeamNeeded))
def revoke_guest_link(guest_link_id: UUID, session: DbSession, actor: Actor = TEAM) -> GuestLinkRead:
    """Let a link open nothing any more, at once and for good, visits that began included."""
    return guest_links.revoke_link(session, actor, guest_link_id)


@router.get("/guest-links/{guest_link_id}/address", responses=problems(GuestLinkNotFound, TeamNeeded))
def get_guest_link_address(
    guest_link_id: UUID, session: DbSession, runtime: CurrentRuntime, actor: Actor = TEAM
) -> GuestLinkAddress:
    """Show the address of a link again, to the person who made it."""
    secret = guest_links.secret_of(session, actor, guest_link_id, server_key=_key(runtime))
    return GuestLinkAddress(url=_address(runtime, secret))


@router.get("/guest-links/{guest_link_id}/visits", responses=problems(GuestLinkNotFound, TeamNeeded, BadCursor))
def list_guest_visits(
    guest_link_id: UUID, session: DbSession, cursor: str | None = None, actor: Actor = TEAM
) -> Page[GuestVisitRead]:
    """Return the visits by a link: person, time, and plays of each sound, newest first."""
    visits = guest_links.visits_of(session, actor, guest_link_id, before=uuid_cursor(cursor), limit=PAGE + 1)
    return Page(items=visits[:PAGE], next=cursor_of(visits[PAGE - 1].id) if len(visits) > PAGE else None)


def _key(runtime: Runtime) -> str:
    return runtime.settings.secret_key.get_secret_value()


def _address(runtime: Runtime, secret: str) -> str:
    return f"{runtime.settings.base_url}/listen/{secret}"


router.include_router(_unsaved_router)
