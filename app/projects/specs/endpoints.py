"""The endpoints of delivery specs; they are saved in sound_lists, whose names a spec may refuse."""

from typing import Annotated
from uuid import UUID

from fastapi import APIRouter, Depends, Header, Path, Request, Response
from fastapi.responses import PlainTextResponse
from starlette.concurrency import run_in_threadpool

import audio_checks
from app.accounts.rules import Actor, Audience, Scope
from app.accounts.web.policies import allows
from app.core.parsing_queue import ParsingBusy, parse_request
from app.core.typesetting import DocumentTooLarge, TypesettingBusy
from app.core.web.bodies import LARGE_BODY_BYTES, accepts_body
from app.core.web.downloads import content_disposition, downloads, file_response
from app.core.web.http import BadCursor, DbSession, Page, cursor_of, number_cursor, problems
from app.core.web.per_user_limit import PerUserLimit, TooManyAtOnce
from app.projects import schemas, service
from app.projects.errors import BadSpec, ProjectNotFound, SpecVersionNotFound
from app.projects.models import Spec
from app.projects.service import project_access
from app.projects.specs import service as specs
from app.projects.specs.pdf import spec_pdf

PAGE_ROWS = 50
PDFS = PerUserLimit(1, "PDF")  # of the two that a process has in hand
router = APIRouter(prefix="/v1", tags=["projects"])


def _checked_draft(toml: str, spec: audio_checks.DeliverySpec) -> schemas.SpecDraftChecked:
    return schemas.SpecDraftChecked(
        toml=toml,
        sha256=spec.sha256,
        tables=spec.tables,
        resolved=schemas.ResolvedSpec.model_validate(spec),
        warnings=list(spec.warnings),
    )


def spec_read(spec: Spec) -> schemas.SpecRead:
    """Return a version of the spec with its text and what it resolves to."""
    tried = _checked_draft(spec.toml, specs.read_spec(spec.toml))
    brief = schemas.SpecBrief.model_validate(spec)
    return schemas.SpecRead.model_validate(tried.model_dump() | brief.model_dump())


@router.get("/projects/{project_id}/spec", responses=problems(ProjectNotFound))
def read_spec(
    project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT, build=Scope.SPEC_READ)
) -> schemas.SpecRead:
    """Return the delivery spec that holds now."""
    return spec_read(service.spec_in_force(session, actor, project_id))


@router.get(
    "/projects/{project_id}/spec.toml",
    response_class=PlainTextResponse,
    responses=problems(ProjectNotFound) | {304: {"description": "the copy that was named in If-None-Match is good"}},
)
def download_spec(
    project_id: UUID,
    session: DbSession,
    if_none_match: Annotated[str | None, Header()] = None,
    actor: Actor = allows(Audience.PROJECT, build=Scope.SPEC_READ),
) -> Response:
    """Return the delivery spec as the file that audio-checks reads."""
    spec = service.spec_in_force(session, actor, project_id)
    etag = specs.etag_of(spec)
    known = [tag.strip().removeprefix("W/") for tag in (if_none_match or "").split(",")]
    headers = {"ETag": etag, "Cache-Control": "private, no-cache"}
    if etag in known or "*" in known:
        return Response(status_code=304, headers=headers)
    headers["Content-Disposition"] = content_disposition(specs.FILE_NAME, inline=True)
    return PlainTextResponse(spec.toml, headers=headers)


@router.get(
    "/projects/{project_id}/spec.pdf",
    **downloads("application/pdf", ProjectNotFound, DocumentTooLarge, TypesettingBusy, TooManyAtOnce),
)
def download_spec_pdf(project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> Response:
    """Return the delivery spec as a page to read and to print."""
    spec = service.spec_in_force(session, actor, project_id)
    title = project_access(session, actor, project_id).project.name
    with PDFS.of(actor.person):
        content = spec_pdf(specs.read_spec(spec.toml), title=title, version=spec.version)
    return file_response(content, "application/pdf", "spec.pdf", inline=True)


@router.get("/projects/{project_id}/spec/versions", responses=problems(ProjectNotFound, BadCursor))
def list_spec_versions(
    project_id: UUID, session: DbSession, cursor: str | None = None, actor: Actor = allows(Audience.PROJECT)
) -> Page[schemas.SpecBrief]:
    """Return the versions of the spec, newest first."""
    below = number_cursor(cursor)
    versions = service.spec_versions(session, actor, project_id, below=below, limit=PAGE_ROWS + 1)
    shown = versions[:PAGE_ROWS]
    items = [schemas.SpecBrief.model_validate(spec) for spec in shown]
    return Page(items=items, next=cursor_of(shown[-1].version) if len(versions) > PAGE_ROWS else None)


@router.get("/projects/{project_id}/spec/versions/{version}", responses=problems(ProjectNotFound, SpecVersionNotFound))
def read_spec_version(
    project_id: UUID,
    version: Annotated[int, Path(ge=1, le=2**31 - 1)],
    session: DbSession,
    actor: Actor = allows(Audience.PROJECT),
) -> schemas.SpecRead:
    """Return one version of the spec."""
    return spec_read(service.spec_version(session, actor, project_id, version))


async def ensure_readable(request: Request, project_id: UUID, toml: str, *, saves: bool) -> None:
    """Raise BadSpec unless a text is a delivery spec, parsed in a process of its own."""
    specs.ensure_short(toml)
    permit = service.ensure_speaks_in if saves else service.project_access
    try:
        await parse_request(request, audio_checks.parse_spec, toml, refusal=BadSpec, permit=permit, whose=project_id)
    except audio_checks.SpecError as error:
        raise specs.refusal_of(error) from None


async def _readable_draft(request: Request, project_id: UUID, body: schemas.SpecDraftCheck) -> str:
    toml = body.toml if body.toml is not None else await run_in_threadpool(specs.toml_of_form, body.tables or {})
    await ensure_readable(request, project_id, toml, saves=False)
    return toml


@router.post(
    "/projects/{project_id}/spec/check-toml",
    responses=problems(ProjectNotFound, BadSpec, ParsingBusy),
)
@accepts_body(LARGE_BODY_BYTES)
def check_spec_draft(
    project_id: UUID,
    actor: Annotated[Actor, allows(Audience.PROJECT)],
    toml: Annotated[str, Depends(_readable_draft)],
    session: DbSession,
) -> schemas.SpecDraftChecked:
    """Return the resolved spec of a text or a form's tables, and their errors; nothing is saved."""
    service.project_access(session, actor, project_id)
    return _checked_draft(toml, specs.read_spec(toml))
