"""The endpoints of postings."""

from uuid import UUID

from fastapi import APIRouter, Request, Response

from app.accounts.authentication import sha256_of
from app.accounts.errors import (
    BadAddress,
    NameNeeded,
    PasswordTooWeak,
    RecentSignInNeeded,
    SignInNeeded,
    TooManyAttempts,
)
from app.accounts.models import Person
from app.accounts.rules import Actor, Audience, normalised_email
from app.accounts.schemas import InvitationAccept, PersonRead
from app.accounts.web.browser_sign_ins import sign_in_browser
from app.accounts.web.policies import allows
from app.accounts.web.request_limits import (
    DeferredSession,
    ensure_invitation_allowed,
    ensure_mail_allowed,
    ensure_sign_in_allowed,
)
from app.core.web.http import CurrentRuntime, DbSession, problems
from app.core.web.idempotency import UNSAVED
from app.hiring import queries
from app.hiring.errors import (
    CandidateNotFound,
    LinkTaken,
    OwnPosting,
    PersonalLinkNeeded,
    PostingChanged,
    PostingClosed,
    PostingInvalid,
    PostingNotFound,
    WrongPostingState,
)
from app.hiring.postings import links
from app.hiring.postings import service as postings
from app.hiring.postings.reads import posting_read, preview, summary
from app.hiring.schemas import (
    AskedCue,
    CandidateAdd,
    PostingAdd,
    PostingChange,
    PostingJoined,
    PostingLink,
    PostingPreview,
    PostingRead,
    PostingSummary,
)
from app.projects.errors import NdaNeeded, ProjectNotFound, TeamNeeded
from app.sound_lists.rules import CueState

router = APIRouter(prefix="/v1", tags=["postings"])
_unsaved_router = APIRouter(dependencies=UNSAVED)


def _fields(body: PostingAdd) -> postings.PostingFields:
    return postings.PostingFields(**{name: getattr(body, name) for name in PostingAdd.model_fields})


@router.get("/projects/{project_id}/postings", responses=problems(ProjectNotFound, TeamNeeded))
def list_postings(project_id: UUID, session: DbSession, actor: Actor = allows(Audience.TEAM)) -> list[PostingSummary]:
    """Return the postings of a project, newest first."""
    postings_shown = postings.postings_of(session, actor, project_id)
    counts = queries.counts_of_bids(session, [posting.id for posting in postings_shown])
    return [summary(posting, sent=counts.get(posting.id, 0), own=None) for posting in postings_shown]


@router.post(
    "/projects/{project_id}/postings",
    status_code=201,
    responses=problems(ProjectNotFound, TeamNeeded, PostingInvalid),
)
def create_posting(
    project_id: UUID, body: PostingAdd, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> PostingRead:
    """Begin a posting as a draft, its lines counted from the sound list."""
    posting_id = postings.create_posting(session, actor, project_id, _fields(body))
    return posting_read(session, actor, posting_id)


@router.get("/postings")
def list_my_postings(session: DbSession, actor: Actor = allows(Audience.PERSON)) -> list[PostingSummary]:
    """Return the postings that the caller may bid on, newest first."""
    postings_shown = postings.candidate_postings(session, actor)
    own = queries.own_bids(session, actor.person, [posting.id for posting in postings_shown])
    return [
        summary(posting, sent=None, own=own.get(posting.id), is_closed=posting.project.nda_needed)
        for posting in postings_shown
    ]


@router.get("/postings/{posting_id}", responses=problems(PostingNotFound, TeamNeeded))
def read_posting(posting_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> PostingRead:
    """Return a posting: whole for those who act for the studio, as far as it concerns them for candidates."""
    return posting_read(session, actor, posting_id)


@router.get("/postings/{posting_id}/cues", responses=problems(PostingNotFound, TeamNeeded, NdaNeeded))
def list_asked_cues(posting_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> list[AskedCue]:
    """Return the cues that the lines of a posting count: to the team, and to candidates after an NDA."""
    return [
        AskedCue(
            id=cue.id,
            line=cue.category,
            name=cue.name,
            variations=cue.variations,
            duration_s=cue.duration_s,
            duration_min_s=cue.duration_min_s,
            duration_max_s=cue.duration_max_s,
            loop=cue.loop,
            is_concept=cue.state is CueState.CONCEPT,
        )
        for cue in postings.asked_cues(session, actor, posting_id)
    ]


@router.put(
    "/postings/{posting_id}",
    responses=problems(PostingNotFound, TeamNeeded, PostingInvalid, PostingChanged, WrongPostingState),
)
def change_posting(
    posting_id: UUID, body: PostingChange, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> PostingRead:
    """Change a posting; what bids are made on is fixed once it is open."""
    postings.change_posting(session, actor, posting_id, _fields(body), revision=body.revision)
    return posting_read(session, actor, posting_id)


@router.post(
    "/postings/{posting_id}/open",
    responses=problems(PostingNotFound, TeamNeeded, PostingInvalid, WrongPostingState),
)
def open_posting(posting_id: UUID, session: DbSession, actor: Actor = allows(Audience.TEAM)) -> PostingRead:
    """Take bids from now on, and mail those who were asked; a closed posting opens again."""
    postings.open_posting(session, actor, posting_id)
    return posting_read(session, actor, posting_id)


@router.post("/postings/{posting_id}/close", responses=problems(PostingNotFound, TeamNeeded, WrongPostingState))
def close_posting(posting_id: UUID, session: DbSession, actor: Actor = allows(Audience.TEAM)) -> PostingRead:
    """Take no more bids."""
    postings.close_posting(session, actor, posting_id)
    return posting_read(session, actor, posting_id)


@router.post(
    "/postings/{posting_id}/candidates",
    status_code=201,
    responses=problems(PostingNotFound, TeamNeeded, BadAddress, TooManyAttempts, WrongPostingState),
)
def invite_candidate(
    posting_id: UUID, body: CandidateAdd, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> PostingRead:
    """Ask a person for a bid: by mail at once, or when the posting opens."""
    postings.posting_seen(session, actor, posting_id).ensure_team()
    ensure_invitation_allowed(session, actor, body.email)
    postings.invite(session, actor, posting_id, body.email)
    return posting_read(session, actor, posting_id)


@router.delete(
    "/postings/{posting_id}/candidates/{candidate_id}",
    status_code=204,
    responses=problems(PostingNotFound, TeamNeeded, CandidateNotFound),
)
def withdraw_candidate(
    posting_id: UUID, candidate_id: UUID, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> None:
    """Take a person off the posting."""
    postings.withdraw_invitation(session, actor, posting_id, candidate_id)


@_unsaved_router.post(
    "/postings/{posting_id}/link",
    status_code=201,
    responses=problems(PostingNotFound, TeamNeeded, RecentSignInNeeded),
)
def make_posting_link(
    posting_id: UUID,
    session: DbSession,
    runtime: CurrentRuntime,
    actor: Actor = allows(Audience.TEAM, recent_sign_in=True),
) -> PostingLink:
    """Make a link that shows the posting without an invitation; an earlier one stops working."""
    secret = postings.make_link(session, actor, posting_id)
    return PostingLink(url=f"{runtime.settings.base_url}/posting/{secret}")


@router.delete("/postings/{posting_id}/link", status_code=204, responses=problems(PostingNotFound, TeamNeeded))
def revoke_posting_link(posting_id: UUID, session: DbSession, actor: Actor = allows(Audience.TEAM)) -> None:
    """Withdraw the link; who came by it stays."""
    postings.revoke_link(session, actor, posting_id)


@router.get("/posting-links/{secret}", responses=problems(PostingNotFound))
def preview_posting(
    secret: str, session: DbSession, runtime: CurrentRuntime, actor: Actor = allows(Audience.ANYONE)
) -> PostingPreview:
    """Show a posting to everyone who has its link: all of it, or title, dates and studio while an NDA comes first."""
    posting, candidate, is_closed = links.preview(session, actor, secret)
    return preview(session, posting, candidate, is_closed=is_closed, sends_mail=bool(runtime.settings.smtp_url))


@_unsaved_router.post(
    "/posting-links/{secret}/ask",
    status_code=202,
    responses=problems(PostingNotFound, BadAddress, PostingClosed, TooManyAttempts),
)
def ask_for_posting_link(
    secret: str, body: CandidateAdd, request: Request, begin: DeferredSession, _actor: Actor = allows(Audience.ANYONE)
) -> None:
    """Mail a link of one's own, by which a person makes an account and bids; the same answer for every address."""
    ensure_mail_allowed(request, normalised_email(body.email))
    with begin() as session:
        links.ask_for_link(session, secret, body.email)


@_unsaved_router.post(
    "/posting-links/{secret}/account",
    response_model=PersonRead,
    responses=problems(PostingNotFound, PersonalLinkNeeded, SignInNeeded, NameNeeded, PasswordTooWeak, TooManyAttempts),
)
def open_account_by_posting_link(
    secret: str,
    body: InvitationAccept,
    request: Request,
    response: Response,
    runtime: CurrentRuntime,
    begin: DeferredSession,
    actor: Actor = allows(Audience.ANYONE),
) -> Person:
    """Sign in as the person whose personal link it is, with an account made now if the address has none."""
    ensure_sign_in_allowed(request, sha256_of(secret))
    with begin() as session:
        person = links.account_by_link(session, actor, secret, name=body.name, password=body.password)
        if actor.person_id != person.id:
            sign_in_browser(session, runtime.settings, request, response, person)
    return person


@router.post("/posting-links/{secret}/join", responses=problems(PostingNotFound, LinkTaken, OwnPosting))
def join_posting(secret: str, session: DbSession, actor: Actor = allows(Audience.PERSON)) -> PostingJoined:
    """Let the caller bid on the posting behind a link."""
    return PostingJoined(posting_id=links.join(session, actor, secret))


router.include_router(_unsaved_router)
