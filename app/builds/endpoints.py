"""The endpoints of this room."""

from collections.abc import Sequence
from typing import Annotated
from uuid import UUID

from fastapi import APIRouter, Query, Request, Response
from fastapi.responses import StreamingResponse

from app.accounts.rules import Actor, Audience, Scope
from app.accounts.web.policies import allows
from app.accounts.web.recorded_downloads import record_download
from app.builds import service
from app.builds.audits import service as audits
from app.builds.engine_export import exported_cues as handed_cues
from app.builds.engine_export.cues import Handoff
from app.builds.errors import (
    BlobDamaged,
    BuildNotFound,
    NothingAccepted,
    PackIncomplete,
    PackNotFound,
    PackNotSealed,
    PlaceholderAccepted,
    ReportInvalid,
)
from app.builds.packs import placeholders, sealing, targets
from app.builds.packs import service as packs
from app.builds.packs.documentation_key import key_csv, key_xlsx
from app.builds.packs.key_pdf import key_pdf
from app.builds.packs.zip_stream import Entry, zip_bytes, zip_length
from app.builds.rules import ci_command, ci_lines
from app.builds.schemas import (
    Baseline,
    BuildAdd,
    BuildRead,
    BuildSummary,
    CiLines,
    PackAdd,
    PackRead,
    PlaceholderCountdown,
    PlaceholderRegister,
    PlaceholdersAdd,
    SealedPackRead,
    SealedPackSummary,
    TargetsRead,
)
from app.core.typesetting import DocumentTooLarge, TypesettingBusy
from app.core.web.bodies import REPORT_BODY_BYTES, accepts_body
from app.core.web.downloads import content_disposition, downloads, file_response
from app.core.web.http import CurrentRuntime, DbSession, Page, cursor_of, problems, uuid_cursor
from app.core.web.per_user_limit import PerUserLimit, TooManyAtOnce
from app.deliveries.errors import MasterDeleted
from app.projects.errors import ProjectNotFound, TeamNeeded
from app.renders.errors import TargetUnknown

router = APIRouter(prefix="/v1", tags=["builds"])
PAGE = 50
XLSX = "application/vnd.openxmlformats-officedocument.spreadsheetml.sheet"
Target = Annotated[str | None, Query(description="A target of the spec; its first when left out.")]
PDFS = PerUserLimit(1, "PDF")  # of the two that a process has in hand
BINARY = {"schema": {"type": "string", "format": "binary"}}


@router.get(
    "/projects/{project_id}/pack",
    response_model=PackRead,
    responses=problems(ProjectNotFound, TeamNeeded, TargetUnknown),
)
def get_pack(
    project_id: UUID,
    session: DbSession,
    target: Target = None,
    actor: Actor = allows(Audience.TEAM, build=Scope.MANIFEST_READ),
) -> PackRead:
    """Return the content of the approved pack of a target, and what is missing."""
    return packs.pack_read(packs.visible_pack(session, actor, project_id, target))


@router.get(
    "/projects/{project_id}/pack.zip",
    response_class=StreamingResponse,
    responses={
        **problems(
            ProjectNotFound,
            TeamNeeded,
            TargetUnknown,
            MasterDeleted,
            NothingAccepted,
            PackIncomplete,
            PlaceholderAccepted,
            BlobDamaged,
            DocumentTooLarge,
            TypesettingBusy,
        ),
        200: {"content": {"application/zip": BINARY}},
    },
)
def download_pack(
    project_id: UUID,
    request: Request,
    session: DbSession,
    runtime: CurrentRuntime,
    target: Target = None,
    masters: bool = False,
    allow_missing: Annotated[
        bool, Query(description="Leave out accepted sounds that have no game file; the key says why.")
    ] = False,
    with_placeholders: Annotated[
        bool,
        Query(
            alias="placeholders", description="Put marked placeholder files in for the sounds that are not accepted."
        ),
    ] = False,
    handoff: Annotated[Handoff, Query(description="The engine whose import files go with the sounds.")] = Handoff.NONE,
    actor: Actor = allows(Audience.TEAM, build=Scope.MANIFEST_READ),
) -> StreamingResponse:
    """Stream the approved pack; an answer shorter than its Content-Length is a broken one."""
    pack = packs.visible_pack(session, actor, project_id, target)
    if with_placeholders:
        pack = placeholders.with_placeholder_files(session, pack)
    files = packs.pack_files(
        runtime.store,
        pack,
        masters=masters,
        allow_missing=allow_missing,
        placeholders=with_placeholders,
        handoff=handed_cues.handoff_entries(session, pack, handoff),
    )
    name, entries = f"{pack.project.name} {pack.target}.zip", [file.entry for file in files]
    record_download(request, session, actor, pack.project.studio_id, pack.project.id, name)
    return stream_zip(name, entries)


def stream_zip(name: str, entries: Sequence[Entry]) -> StreamingResponse:
    """Return a ZIP under a name, its length known beforehand."""
    return StreamingResponse(
        zip_bytes(entries),
        media_type="application/zip",
        headers={"Content-Length": str(zip_length(entries)), "Content-Disposition": content_disposition(name)},
    )


@router.get(
    "/projects/{project_id}/documentation-key.csv",
    **downloads("text/csv", ProjectNotFound, TeamNeeded, TargetUnknown),
)
def get_documentation_key_csv(
    project_id: UUID,
    session: DbSession,
    target: Target = None,
    actor: Actor = allows(Audience.TEAM, build=Scope.MANIFEST_READ),
) -> Response:
    """Return the identity and purpose of each file of the pack, as CSV."""
    rows = packs.key_rows(packs.visible_pack(session, actor, project_id, target), masters=False)
    return file_response(key_csv(rows), "text/csv; charset=utf-8", packs.KEY_CSV)


@router.get(
    "/projects/{project_id}/documentation-key.xlsx",
    **downloads(XLSX, ProjectNotFound, TeamNeeded, TargetUnknown),
)
def get_documentation_key_xlsx(
    project_id: UUID,
    session: DbSession,
    target: Target = None,
    actor: Actor = allows(Audience.TEAM, build=Scope.MANIFEST_READ),
) -> Response:
    """Return the identity and purpose of each file of the pack, as a workbook."""
    rows = packs.key_rows(packs.visible_pack(session, actor, project_id, target), masters=False)
    return file_response(key_xlsx(rows), XLSX, packs.KEY_XLSX)


@router.get(
    "/projects/{project_id}/documentation-key.pdf",
    **downloads(
        "application/pdf", ProjectNotFound, TeamNeeded, TargetUnknown, DocumentTooLarge, TypesettingBusy, TooManyAtOnce
    ),
)
def get_documentation_key_pdf(
    project_id: UUID,
    session: DbSession,
    target: Target = None,
    actor: Actor = allows(Audience.TEAM, build=Scope.MANIFEST_READ),
) -> Response:
    """Return the identity and purpose of each file of the pack, to read and to print."""
    pack = packs.visible_pack(session, actor, project_id, target)
    with PDFS.of(actor.token_id or actor.person):
        content = key_pdf(packs.key_rows(pack, masters=False), title=packs.title_of(pack))
    return file_response(content, "application/pdf", packs.KEY_PDF)


@router.get(
    "/projects/{project_id}/targets", response_model=TargetsRead, responses=problems(ProjectNotFound, TeamNeeded)
)
def get_targets(
    project_id: UUID, session: DbSession, actor: Actor = allows(Audience.TEAM, build=Scope.MANIFEST_READ)
) -> TargetsRead:
    """Return the targets of game files, their size in memory, and the future size of the whole list."""
    return targets.visible_targets(session, actor, project_id)


@router.get(
    "/projects/{project_id}/placeholders",
    response_model=PlaceholderRegister,
    responses=problems(ProjectNotFound, TeamNeeded, TargetUnknown),
)
def get_placeholders(
    project_id: UUID,
    session: DbSession,
    target: Target = None,
    actor: Actor = allows(Audience.TEAM, build=Scope.MANIFEST_READ),
) -> PlaceholderRegister:
    """Return the slots for which the game has no accepted sound yet, and those with a placeholder file."""
    return placeholders.register(session, actor, project_id, target)


@router.get(
    "/projects/{project_id}/placeholders/countdown",
    response_model=PlaceholderCountdown,
    responses=problems(ProjectNotFound, TeamNeeded, TargetUnknown),
)
def get_placeholders_countdown(
    project_id: UUID,
    session: DbSession,
    target: Target = None,
    actor: Actor = allows(Audience.TEAM, build=Scope.MANIFEST_READ),
) -> PlaceholderCountdown:
    """Return the number of placeholders left, by category, and the next one to record."""
    return placeholders.countdown(session, actor, project_id, target)


@router.post(
    "/projects/{project_id}/placeholders",
    status_code=202,
    response_class=Response,
    responses=problems(ProjectNotFound, TeamNeeded, TargetUnknown),
)
def make_placeholders(
    project_id: UUID, body: PlaceholdersAdd, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> Response:
    """Have a placeholder file made for everything that a target's pack lacks: to spec, by name, and marked."""
    placeholders.request_placeholder_files(session, actor, project_id, body.target)
    return Response(status_code=202)


@router.post(
    "/projects/{project_id}/packs",
    status_code=201,
    response_model=SealedPackSummary,
    responses=problems(
        ProjectNotFound, TeamNeeded, TargetUnknown, NothingAccepted, PackIncomplete, PlaceholderAccepted
    ),
)
def add_pack(
    project_id: UUID, body: PackAdd, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> SealedPackSummary:
    """Seal the sounds accepted now as a numbered pack, which never changes; the worker puts it together."""
    pack = sealing.request_pack(session, actor, project_id, body)
    (summary,) = sealing.summaries(session, [pack])
    return summary


@router.get(
    "/projects/{project_id}/packs",
    response_model=Page[SealedPackSummary],
    responses=problems(ProjectNotFound, TeamNeeded),
)
def list_packs(
    project_id: UUID,
    session: DbSession,
    target: Annotated[str | None, Query(description="Of one target only.")] = None,
    cursor: str | None = None,
    actor: Actor = allows(Audience.TEAM, build=Scope.MANIFEST_READ),
) -> Page[SealedPackSummary]:
    """Return the packs that were handed out, the newest first."""
    pack_rows = sealing.packs_in(session, actor, project_id, target=target, before=uuid_cursor(cursor), limit=PAGE + 1)
    return Page(
        items=sealing.summaries(session, pack_rows[:PAGE]),
        next=cursor_of(pack_rows[PAGE - 1].id) if len(pack_rows) > PAGE else None,
    )


@router.get("/packs/{pack_id}", response_model=SealedPackRead, responses=problems(PackNotFound, TeamNeeded))
def get_sealed_pack(
    pack_id: UUID, session: DbSession, actor: Actor = allows(Audience.TEAM, build=Scope.MANIFEST_READ)
) -> SealedPackRead:
    """Return a pack that was handed out, and what is not as it was in the one before."""
    return sealing.sealed_read(session, sealing.visible_sealed(session, actor, pack_id))


@router.get(
    "/packs/{pack_id}/pack.zip",
    response_class=StreamingResponse,
    responses={
        **problems(PackNotFound, TeamNeeded, PackNotSealed, BlobDamaged),
        200: {"content": {"application/zip": BINARY}},
    },
)
def download_sealed_pack(
    pack_id: UUID,
    request: Request,
    session: DbSession,
    runtime: CurrentRuntime,
    actor: Actor = allows(Audience.TEAM, build=Scope.MANIFEST_READ),
) -> StreamingResponse:
    """Stream a pack that was handed out, the same bytes each time."""
    pack = sealing.visible_sealed(session, actor, pack_id)
    name, entries = f"{pack.target} {pack.number}.zip", sealing.sealed_entries(session, runtime.store, pack)
    record_download(request, session, actor, pack.studio_id, pack.project_id, name)
    return stream_zip(name, entries)


@router.post(
    "/projects/{project_id}/builds",
    status_code=201,
    response_model=BuildSummary,
    responses=problems(ProjectNotFound, TeamNeeded, ReportInvalid),
)
@accepts_body(REPORT_BODY_BYTES)
def post_build(
    project_id: UUID,
    body: BuildAdd,
    session: DbSession,
    actor: Actor = allows(Audience.TEAM, build=Scope.CHECKS_WRITE),
) -> BuildSummary:
    """Store the report of audio-checks on one build of the game."""
    build = service.save_report(
        session,
        actor,
        project_id,
        label=body.label,
        commit=body.commit,
        target=body.target,
        report=body.report.model_dump(exclude_unset=True),
    )
    return BuildSummary.model_validate(build)


@router.get(
    "/projects/{project_id}/builds",
    response_model=Page[BuildSummary],
    responses=problems(ProjectNotFound, TeamNeeded),
)
def list_builds(
    project_id: UUID, session: DbSession, cursor: str | None = None, actor: Actor = allows(Audience.TEAM)
) -> Page[BuildSummary]:
    """Return the project's builds, the newest first."""
    builds = service.builds_in(session, actor, project_id, before=uuid_cursor(cursor), limit=PAGE + 1)
    return Page(
        items=[BuildSummary.model_validate(build) for build in builds[:PAGE]],
        next=cursor_of(builds[PAGE - 1].id) if len(builds) > PAGE else None,
    )


@router.get("/builds/{build_id}", response_model=BuildRead, responses=problems(BuildNotFound, TeamNeeded))
def get_build(build_id: UUID, session: DbSession, actor: Actor = allows(Audience.TEAM)) -> BuildRead:
    """Return one build with its whole report."""
    return BuildRead.model_validate(service.visible_build(session, actor, build_id))


@router.get("/projects/{project_id}/baseline.json", response_model=Baseline, responses=problems(ProjectNotFound))
def get_baseline(
    project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT, build=Scope.LIST_READ)
) -> Baseline:
    """Return the approver's waivers and the accepted drift, for `--baseline` of `audio-checks`."""
    waived = service.waived_sounds(session, actor, project_id)
    return Baseline(waived=waived, accepted=audits.accepted_sounds(session, project_id))


@router.get(
    "/projects/{project_id}/ci",
    response_model=CiLines,
    responses=problems(ProjectNotFound, TeamNeeded, TargetUnknown),
)
def get_ci_lines(
    project_id: UUID,
    session: DbSession,
    runtime: CurrentRuntime,
    target: Target = None,
    actor: Actor = allows(Audience.TEAM),
) -> CiLines:
    """Return the shell lines by which the game's CI checks its audio and posts the report."""
    pack = packs.visible_pack(session, actor, project_id, target)
    where = (runtime.settings.base_url, str(project_id), pack.target)
    return CiLines(command=ci_command(*where), lines=ci_lines(*where))
