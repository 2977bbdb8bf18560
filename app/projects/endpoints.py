"""The endpoints of projects."""

from collections.abc import Sequence
from typing import Annotated
from uuid import UUID

from fastapi import APIRouter, Query, Request, Response

from app.accounts.authentication import sha256_of
from app.accounts.calendars.service import calendar_of
from app.accounts.errors import (
    BadAddress,
    NameNeeded,
    PasswordTooWeak,
    RecentSignInNeeded,
    SignInNeeded,
    StudioNotFound,
    TooManyAttempts,
)
from app.accounts.models import Person, Token
from app.accounts.rules import Actor, Audience
from app.accounts.schemas import CalendarRead, InvitationAccept, PersonBrief, PersonRead, StudioBrief
from app.accounts.web.browser_sign_ins import sign_in_browser
from app.accounts.web.policies import allows
from app.accounts.web.request_limits import (
    DeferredSession,
    ensure_invitation_allowed,
    ensure_sign_in_allowed,
)
from app.core.web.http import (
    CurrentRuntime,
    DbSession,
    Page,
    cursor_of,
    problems,
    uuid_cursor,
)
from app.core.web.idempotency import UNSAVED
from app.projects import engagements, overviews, queries, schemas, service, tokens
from app.projects.approval import approvers
from app.projects.errors import (
    AlreadyEngaged,
    CannotApprove,
    EngagementNotFound,
    InvitationNotFound,
    LiaisonIsApprover,
    LiaisonNotFound,
    ProducerNeeded,
    ProjectNotFound,
    TeamNeeded,
    TokenNotFound,
)
from app.projects.models import ApproverChange, Engagement, ProjectInvitation
from app.projects.rules import audio_leads_warning
from app.projects.visibility import nda_is_pending

PAGE_ROWS = 50
router = APIRouter(prefix="/v1", tags=["projects"])
_unsaved_router = APIRouter(dependencies=UNSAVED)


def project_read(view: overviews.ProjectOverview) -> schemas.ProjectRead:
    """Return a project as its page's header shows it."""
    project, own = view.project, view.own_engagement
    return schemas.ProjectRead(
        id=project.id,
        name=project.name,
        description=project.description,
        cue_prefix=project.cue_prefix,
        created_at=project.created_at,
        archived_at=project.archived_at,
        nda_needed=project.nda_needed,
        designers_hear=project.designers_hear,
        studio=StudioBrief.model_validate(project.studio),
        approver=PersonBrief.model_validate(view.approver),
        category_approvers=[
            schemas.CategoryApproverRead(category=category, approver=PersonBrief.model_validate(person))
            for category, person in view.category_approvers.items()
        ],
        liaisons=[PersonBrief.model_validate(person) for person in view.liaisons],
        audio_leads_warning=audio_leads_warning(len(view.liaisons)) if view.roles else None,
        engagements=[schemas.EngagementRead.model_validate(engagement) for engagement in view.engagements],
        mine=schemas.Mine(
            is_team=bool(view.roles),
            is_producer=view.is_producer,
            is_liaison=view.is_liaison,
            is_approver=view.is_approver,
            engagement_kind=own.kind if own else None,
            nda_open=own is not None and not view.roles and nda_is_pending(project, own),
        ),
        spec_version=view.spec_version,
    )


@router.get("/projects")
def list_projects(
    session: DbSession,
    cursor: str | None = None,
    archived: Annotated[bool, Query(description="Archived projects instead of the running ones.")] = False,
    actor: Actor = allows(Audience.PERSON),
) -> Page[schemas.ProjectRead]:
    """Return the projects of the caller's studios and engagements, newest first."""
    projects = queries.projects_seen(session, actor, before=uuid_cursor(cursor), limit=PAGE_ROWS + 1, archived=archived)
    shown = projects[:PAGE_ROWS]
    items = [project_read(view) for view in overviews.overviews(session, actor, shown)]
    return Page(items=items, next=cursor_of(shown[-1].id) if len(projects) > PAGE_ROWS else None)


@router.post("/projects", status_code=201, responses=problems(StudioNotFound, ProducerNeeded))
def create_project(
    body: schemas.ProjectAdd, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> schemas.ProjectRead:
    """Open a project with the field's default spec; its creator is the approver until another is named."""
    project = service.create_project(
        session,
        actor,
        body.studio_id,
        name=body.name,
        description=body.description,
        cue_prefix=body.cue_prefix,
        preset=body.preset,
    )
    return project_read(overviews.overview(session, actor, project.id))


@router.get("/projects/{project_id}", responses=problems(ProjectNotFound))
def read_project(project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> schemas.ProjectRead:
    """Return a project as its page heads it."""
    return project_read(overviews.overview(session, actor, project_id))


@router.get("/projects/{project_id}/studio-calendar", responses=problems(ProjectNotFound))
def get_project_calendar(project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> CalendarRead:
    """Return time zone and holidays of the project's studio, by which both sides count its working days."""
    return calendar_of(session, service.project_access(session, actor, project_id).project.studio_id)


@router.patch("/projects/{project_id}", responses=problems(ProjectNotFound, ProducerNeeded))
def change_project(
    project_id: UUID, body: schemas.ProjectChange, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> schemas.ProjectRead:
    """Change the name of a project, or put it away."""
    service.change_project(
        session,
        actor,
        project_id,
        name=body.name,
        description=body.description,
        cue_prefix=body.cue_prefix,
        archived=body.archived,
        nda_needed=body.nda_needed,
        designers_hear=body.designers_hear,
    )
    return project_read(overviews.overview(session, actor, project_id))


@router.put(
    "/projects/{project_id}/liaisons/{person_id}",
    responses=problems(ProjectNotFound, ProducerNeeded, LiaisonNotFound),
)
def add_liaison(
    project_id: UUID, person_id: UUID, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> schemas.ProjectRead:
    """Make a member of the studio a liaison of this project."""
    service.add_liaison(session, actor, project_id, person_id)
    return project_read(overviews.overview(session, actor, project_id))


@router.delete(
    "/projects/{project_id}/liaisons/{person_id}",
    responses=problems(ProjectNotFound, ProducerNeeded, LiaisonNotFound, LiaisonIsApprover),
)
def remove_liaison(
    project_id: UUID, person_id: UUID, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> schemas.ProjectRead:
    """Remove a liaison."""
    service.remove_liaison(session, actor, project_id, person_id)
    return project_read(overviews.overview(session, actor, project_id))


@router.put(
    "/projects/{project_id}/approver",
    responses=problems(ProjectNotFound, ProducerNeeded, CannotApprove),
)
def name_approver(
    project_id: UUID, body: schemas.ApproverAdd, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> schemas.ProjectRead:
    """Make a liaison the approver, or become it as a producer; the reason is kept."""
    service.name_approver(session, actor, project_id, person_id=body.person_id, reason=body.reason)
    return project_read(overviews.overview(session, actor, project_id))


@router.post(
    "/projects/{project_id}/approver-invitations",
    status_code=201,
    responses=problems(ProjectNotFound, ProducerNeeded, BadAddress, TooManyAttempts),
)
def invite_approver(
    project_id: UUID, body: schemas.ApproverInvite, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> schemas.ApproverInvited:
    """Invite an address into the studio as this project's approver; a member becomes it at once."""
    service.project_access(session, actor, project_id).ensure_producer()
    ensure_invitation_allowed(session, actor, body.email)
    is_named = approvers.invite_approver(session, actor, project_id, email=body.email)
    return schemas.ApproverInvited(email=body.email, is_named=is_named)


@router.get(
    "/projects/{project_id}/approver-history",
    response_model=list[schemas.ApproverChangeRead],
    responses=problems(ProjectNotFound, TeamNeeded),
)
def list_approver_changes(
    project_id: UUID, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> Sequence[ApproverChange]:
    """Return the project's approvers, newest first."""
    return service.approver_history(session, actor, project_id)


@router.post(
    "/projects/{project_id}/invitations",
    status_code=201,
    response_model=schemas.InvitationRead,
    responses=problems(ProjectNotFound, TeamNeeded, AlreadyEngaged, BadAddress, TooManyAttempts),
)
def invite_designer(
    project_id: UUID,
    body: schemas.InvitationAdd,
    session: DbSession,
    actor: Actor = allows(Audience.TEAM),
) -> ProjectInvitation:
    """Mail a designer a link that shows the list; the answer does not reveal whether the address has an account."""
    service.project_access(session, actor, project_id).ensure_may_speak()
    ensure_invitation_allowed(session, actor, body.email)
    return engagements.invite_designer(
        session,
        actor,
        project_id,
        email=body.email,
        kind=body.kind,
        note=body.note,
    )


@router.get(
    "/projects/{project_id}/invitations",
    response_model=list[schemas.InvitationRead],
    responses=problems(ProjectNotFound, TeamNeeded),
)
def list_invitations(
    project_id: UUID, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> Sequence[ProjectInvitation]:
    """Return the project's invitations, but for those withdrawn."""
    return engagements.invitations_of(session, actor, project_id)


@router.delete(
    "/projects/{project_id}/invitations/{invitation_id}",
    status_code=204,
    responses=problems(ProjectNotFound, TeamNeeded, InvitationNotFound),
)
def revoke_invitation(
    project_id: UUID, invitation_id: UUID, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> None:
    """Withdraw an invitation: its link shows nothing any more."""
    engagements.revoke_invitation(session, actor, project_id, invitation_id)


@_unsaved_router.post(
    "/invitations/{secret}/accept",
    responses=problems(InvitationNotFound, SignInNeeded, NameNeeded, PasswordTooWeak, TooManyAttempts),
)
def accept_invitation(
    secret: str,
    body: InvitationAccept,
    request: Request,
    response: Response,
    runtime: CurrentRuntime,
    begin: DeferredSession,
    actor: Actor = allows(Audience.ANYONE),
) -> schemas.InvitationAccepted:
    """Engage the invited designer with the address's account, made now if there is none, and sign in."""
    ensure_sign_in_allowed(request, sha256_of(secret))
    with begin() as session:
        engagement = engagements.accept_invitation(session, actor, secret, name=body.name, password=body.password)
        designer: Person = engagement.designer
        if actor.person_id != designer.id:
            sign_in_browser(session, runtime.settings, request, response, designer)
    return schemas.InvitationAccepted(
        person=PersonRead.model_validate(designer),
        project_id=engagement.project_id,
        engagement=schemas.EngagementRead.model_validate(engagement),
    )


@router.patch(
    "/projects/{project_id}/engagements/{engagement_id}",
    response_model=schemas.EngagementRead,
    responses=problems(ProjectNotFound, ProducerNeeded, EngagementNotFound),
)
def change_engagement(
    project_id: UUID,
    engagement_id: UUID,
    body: schemas.EngagementChange,
    session: DbSession,
    actor: Actor = allows(Audience.PRODUCER),
) -> Engagement:
    """Change a designer's tie, end it or take it up again."""
    return engagements.change_engagement(session, actor, project_id, engagement_id, kind=body.kind, ended=body.ended)


@router.get(
    "/projects/{project_id}/tokens",
    response_model=list[schemas.TokenRead],
    responses=problems(ProjectNotFound, ProducerNeeded),
)
def list_tokens(project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PRODUCER)) -> Sequence[Token]:
    """Return the keys of the project's builds, without their secrets."""
    return tokens.tokens_of(session, actor, project_id)


@_unsaved_router.post(
    "/projects/{project_id}/tokens",
    status_code=201,
    responses=problems(ProjectNotFound, ProducerNeeded, RecentSignInNeeded),
)
def create_token(
    project_id: UUID,
    body: schemas.TokenAdd,
    session: DbSession,
    actor: Actor = allows(Audience.PRODUCER, recent_sign_in=True),
) -> schemas.TokenMade:
    """Make a key for the project's builds; its secret is shown this once."""
    token, secret = tokens.create_token(session, actor, project_id, name=body.name, scopes=body.scopes, days=body.days)
    return schemas.TokenMade(**schemas.TokenRead.model_validate(token).model_dump(), secret=secret)


@router.delete(
    "/projects/{project_id}/tokens/{token_id}",
    status_code=204,
    responses=problems(ProjectNotFound, ProducerNeeded, TokenNotFound),
)
def revoke_token(
    project_id: UUID, token_id: UUID, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> None:
    """Revoke a token at once."""
    tokens.revoke_token(session, actor, project_id, token_id)


router.include_router(_unsaved_router)
