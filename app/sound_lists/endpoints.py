"""The endpoints of this room."""

import base64
from typing import Annotated, Any, TypeAlias
from uuid import UUID

from fastapi import APIRouter, Depends, Query, Request, Response

from app.accounts.queries import has_account
from app.accounts.rules import Actor, Audience, Scope
from app.accounts.web.policies import allows
from app.core.parsing_queue import ParsingBusy, parse_request
from app.core.web.bodies import LARGE_BODY_BYTES, accepts_body
from app.core.web.downloads import downloads, file_response
from app.core.web.http import LARGEST_NUMBER, BadCursor, DbSession, Page, cursor_of, problems, uuid_cursor
from app.projects.errors import InvitationNotFound, ProjectNotFound, TeamNeeded
from app.projects.queries import current_spec
from app.projects.rules import EngagementKind
from app.projects.schemas import ResolvedSpec
from app.projects.service import ensure_speaks_in, invitation_by_secret, project_access
from app.projects.specs.service import read_spec
from app.sound_lists import queries, questions, revisions, service
from app.sound_lists.clarity.endpoints import router as clarity_router
from app.sound_lists.errors import (
    ColumnUnknown,
    CueChanged,
    CueIsCut,
    CueNotFound,
    OrderInvalid,
    QuestionAnswered,
    QuestionNotFound,
    QuestionOwnerUnknown,
    RevisionNotFound,
    RowsInvalid,
    SheetUnreadable,
)
from app.sound_lists.names import service as naming
from app.sound_lists.people.service import known_people
from app.sound_lists.rules import MAX_PAGE, PAGE, CueOrdering
from app.sound_lists.schemas import (
    AnswerAdd,
    CategoryCount,
    CueDetail,
    CueOrder,
    CuePatch,
    CueRead,
    CuesAdd,
    ImportAsk,
    ImportRead,
    InvitationPreview,
    ListComparison,
    PaletteSet,
    PlaceholderSet,
    PreviewProject,
    QuestionAdd,
    QuestionPatch,
    QuestionRead,
    RevisionRead,
    SoundListRead,
)
from app.sound_lists.sheets import workbook
from app.sound_lists.sheets.imports import import_sheet
from app.sound_lists.sheets.rules import Sheet, SheetOptions, parse_bytes, parse_text
from audio_checks import known_heads_in

router = APIRouter(prefix="/v1", tags=["sound-lists"])
router.include_router(clarity_router)
REVISIONS_AT_ONCE = QUESTIONS_AT_ONCE = 50
SentSheet: TypeAlias = tuple[ImportAsk, Sheet]
PageLength = Annotated[int, Query(ge=1, le=MAX_PAGE, description="How many cues to answer at most.")]


@router.get(
    "/projects/{project_id}/sound-list",
    response_model=SoundListRead,
    responses=problems(ProjectNotFound, BadCursor),
)
def get_sound_list(
    project_id: UUID,
    session: DbSession,
    cursor: str | None = None,
    limit: PageLength = PAGE,
    order: Annotated[
        CueOrdering, Query(description="The list's own order, or by playback priority: 0 first, cues without one last.")
    ] = "list",
    actor: Actor = allows(Audience.PROJECT, build=Scope.LIST_READ),
) -> SoundListRead:
    """Return one page of the project's cues, in list order or by playback priority, cut ones too."""
    access = project_access(session, actor, project_id)
    cues, following = service.page_of(session, project_id, order, cursor=cursor, limit=limit)
    return SoundListRead(
        revision=queries.revision_number(session, project_id),
        cues=naming.with_refusals(session, project_id, service.cues_read(session, access, cues)),
        next=following,
    )


@router.get("/projects/{project_id}/categories", responses=problems(ProjectNotFound))
def list_categories(
    project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> list[CategoryCount]:
    """Return the categories of the list by name, with the number of their cues."""
    project_access(session, actor, project_id)
    return [
        CategoryCount(category=category, cues=cues) for category, cues in queries.category_counts(session, project_id)
    ]


@router.get(
    "/projects/{project_id}/sound-list.xlsx",
    **downloads(workbook.MEDIA_TYPE, ProjectNotFound),
)
def export_workbook(
    project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT, build=Scope.LIST_READ)
) -> Response:
    """Return the list as a workbook with every field and column, which an import reads back without a difference."""
    access = project_access(session, actor, project_id)
    columns = queries.own_columns(session, project_id)
    people, prefix = known_people(session, access), access.project.cue_prefix
    content = workbook.sound_list_workbook(queries.cues_of(session, project_id), columns, people, prefix)
    return file_response(content, workbook.MEDIA_TYPE, "sounds.xlsx")


@router.post(
    "/projects/{project_id}/cues",
    status_code=201,
    response_model=list[CueRead],
    responses=problems(ProjectNotFound, TeamNeeded, RowsInvalid),
)
@accepts_body(LARGE_BODY_BYTES)
def add_cues(
    project_id: UUID, body: CuesAdd, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> list[CueRead]:
    """Add typed rows to the end of the list: all of them, or none."""
    added = service.add_cues(session, actor, project_id, [cue.model_dump() for cue in body.cues])
    access = project_access(session, actor, project_id)
    cues = queries.cues_by_id(session, project_id, [cue.id for cue in added])
    return naming.with_refusals(session, project_id, [service.cue_read(access, cues[cue.id]) for cue in added])


@router.get("/cues/{cue_id}", response_model=CueDetail, responses=problems(CueNotFound))
def get_cue(cue_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> CueDetail:
    """Return one cue with what was asked about it."""
    access, cue = service.visible_cue(session, actor, cue_id)
    asked = queries.questions_of(session, cue.project_id, cue_id=cue.id)
    still_open = sum(question.answered_at is None for question in asked)
    [read] = naming.with_refusals(session, cue.project_id, [service.cue_read(access, cue, still_open)])
    return CueDetail(
        **read.model_dump(),
        project_id=cue.project_id,
        questions=[questions.question_read(question, access) for question in asked],
    )


@router.patch(
    "/cues/{cue_id}",
    response_model=CueRead,
    responses=problems(CueNotFound, TeamNeeded, CueChanged, CueIsCut, RowsInvalid),
)
def change_cue(cue_id: UUID, body: CuePatch, session: DbSession, actor: Actor = allows(Audience.TEAM)) -> CueRead:
    """Change some facts of a cue; the edition that was read must still be the newest."""
    changes = body.model_dump(exclude_unset=True)
    del changes["edition"]
    return _changed(session, actor, cue_id, body.edition, changes)


@router.put("/cues/{cue_id}/placeholder", response_model=CueRead, responses=problems(CueNotFound, TeamNeeded, CueIsCut))
def flag_placeholder(
    cue_id: UUID, body: PlaceholderSet, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> CueRead:
    """Set whether the game plays a placeholder file until the sound comes."""
    return _changed(session, actor, cue_id, None, {"placeholder": body.placeholder})


@router.put("/cues/{cue_id}/palette", response_model=CueRead, responses=problems(CueNotFound, TeamNeeded, CueIsCut))
def flag_palette(cue_id: UUID, body: PaletteSet, session: DbSession, actor: Actor = allows(Audience.TEAM)) -> CueRead:
    """Set whether the cue belongs to the palette that new sounds are compared with."""
    return _changed(session, actor, cue_id, None, {"palette": body.palette})


def _changed(
    session: DbSession, actor: Actor, cue_id: UUID, edition: int | None, changes: dict[str, object]
) -> CueRead:
    cue = service.change_cue(session, actor, cue_id, edition, changes)
    access = project_access(session, actor, cue.project_id)
    open_questions = queries.open_question_counts(session, cue.project_id)
    read = service.cue_read(access, cue, open_questions.get(cue.id, 0))
    return naming.with_refusals(session, cue.project_id, [read])[0]


@router.post(
    "/projects/{project_id}/cues/order",
    status_code=204,
    responses=problems(ProjectNotFound, TeamNeeded, OrderInvalid),
)
@accepts_body(LARGE_BODY_BYTES)
def order_cues(project_id: UUID, body: CueOrder, session: DbSession, actor: Actor = allows(Audience.TEAM)) -> None:
    """Put cues in another order; those left out keep their places."""
    service.order_cues(session, actor, project_id, body.cue_ids)


async def _parsed(project_id: UUID, body: ImportAsk, request: Request) -> SentSheet:
    if body.text is not None:
        arguments: tuple[Any, ...] = (parse_text, body.text, body.format == "paste")
        if body.tab is not None:
            raise SheetUnreadable("this is text, which has no tabs; leave out the tab")
    elif body.content_base64 is None:
        raise SheetUnreadable("nothing was sent; give text or content_base64")
    else:
        try:
            options = SheetOptions(body.tab, body.encoding, body.fill_down, body.keep_hidden)
            arguments = (parse_bytes, base64.b64decode(body.content_base64, validate=True), known_heads_in, options)
        except ValueError:
            raise SheetUnreadable("content_base64 is not base64") from None
    parsed = await parse_request(
        request, *arguments, refusal=SheetUnreadable, permit=ensure_speaks_in, whose=project_id
    )
    return body, Sheet(*parsed)


@router.post(
    "/projects/{project_id}/sound-list/import",
    response_model=ImportRead,
    responses=problems(ProjectNotFound, TeamNeeded, SheetUnreadable, ColumnUnknown, ParsingBusy),
)
@accepts_body(LARGE_BODY_BYTES)
def import_sound_list(
    project_id: UUID,
    actor: Annotated[Actor, allows(Audience.TEAM)],
    sent: Annotated[SentSheet, Depends(_parsed)],
    session: DbSession,
) -> ImportRead:
    """Read a spreadsheet into the list; rows with an error are left out, and every guess is named."""
    body, sheet = sent
    return import_sheet(session, actor, project_id, sheet, body)


@router.get(
    "/projects/{project_id}/sound-list/revisions",
    response_model=Page[RevisionRead],
    responses=problems(ProjectNotFound),
)
def list_revisions(
    project_id: UUID,
    session: DbSession,
    cursor: Annotated[int | None, Query(ge=1, le=LARGEST_NUMBER)] = None,
    actor: Actor = allows(Audience.PROJECT),
) -> Page[RevisionRead]:
    """Return the saved changes of the list, the newest first."""
    project = project_access(session, actor, project_id).project
    revisions = queries.revisions_of(session, project.id, before=cursor, limit=REVISIONS_AT_ONCE + 1)
    return Page(
        items=[RevisionRead.model_validate(revision) for revision in revisions[:REVISIONS_AT_ONCE]],
        next=cursor_of(revisions[-2].number) if len(revisions) > REVISIONS_AT_ONCE else None,
    )


@router.get(
    "/projects/{project_id}/sound-list/revisions/compare",
    response_model=ListComparison,
    responses=problems(ProjectNotFound, RevisionNotFound),
)
def compare_revisions(
    project_id: UUID,
    session: DbSession,
    first: Annotated[int, Query(alias="from", ge=0, le=LARGEST_NUMBER)],
    last: Annotated[int, Query(alias="to", ge=0, le=LARGEST_NUMBER)],
    actor: Actor = allows(Audience.PROJECT),
) -> ListComparison:
    """Return the additions, changes and cuts between two revisions; `from=0` is the empty list."""
    return revisions.compare_revisions(session, project_access(session, actor, project_id), first, last)


@router.get("/projects/{project_id}/questions", response_model=Page[QuestionRead], responses=problems(ProjectNotFound))
def list_questions(
    project_id: UUID,
    session: DbSession,
    only_open: bool = False,
    cursor: str | None = None,
    actor: Actor = allows(Audience.PROJECT),
) -> Page[QuestionRead]:
    """Return the questions on the project's cues, the oldest first."""
    access = project_access(session, actor, project_id)
    page = queries.questions_of(
        session, project_id, only_open=only_open, after=uuid_cursor(cursor), limit=QUESTIONS_AT_ONCE + 1
    )
    return Page(
        items=[questions.question_read(question, access) for question in page[:QUESTIONS_AT_ONCE]],
        next=cursor_of(page[-2].id) if len(page) > QUESTIONS_AT_ONCE else None,
    )


@router.post("/cues/{cue_id}/questions", status_code=201, response_model=QuestionRead, responses=problems(CueNotFound))
def ask_question(
    cue_id: UUID, body: QuestionAdd, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> QuestionRead:
    """Ask the team what it means by a cue."""
    access, question = questions.ask_question(session, actor, cue_id, body.text, due_on=body.due_on, blocks=body.blocks)
    return questions.question_read(question, access)


@router.patch(
    "/questions/{question_id}",
    response_model=QuestionRead,
    responses=problems(QuestionNotFound, TeamNeeded, QuestionAnswered, QuestionOwnerUnknown),
)
def change_question(
    question_id: UUID, body: QuestionPatch, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> QuestionRead:
    """Set who is to answer a question, by which day, and whether work on its cue waits for it."""
    access, question = questions.change_question(session, actor, question_id, body.model_dump(exclude_unset=True))
    return questions.question_read(question, access)


@router.post(
    "/questions/{question_id}/answer",
    response_model=QuestionRead,
    responses=problems(QuestionNotFound, TeamNeeded, QuestionAnswered),
)
def answer_question(
    question_id: UUID, body: AnswerAdd, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> QuestionRead:
    """Answer a question; the answer joins the cue's description unless the request says otherwise."""
    access, question = questions.answer_question(session, actor, question_id, body.text, joins=body.joins)
    return questions.question_read(question, access)


@router.get("/invitations/{secret}", response_model=InvitationPreview, responses=problems(InvitationNotFound))
def preview_invitation(
    secret: str,
    session: DbSession,
    actor: Actor = allows(Audience.ANYONE),  # noqa: ARG001  the link is the credential
) -> InvitationPreview:
    """Show the invitation of a mailed link: the project and, unless an NDA comes first, its list and its spec."""
    invitation = invitation_by_secret(session, secret)
    project = invitation.project
    closed = project.nda_needed and invitation.kind is not EngagementKind.IN_HOUSE
    return InvitationPreview(
        project=PreviewProject(
            name=project.name, description="" if closed else project.description, cue_prefix=project.cue_prefix
        ),
        studio_name=project.studio.name,
        kind=invitation.kind,
        note=invitation.note,
        email=invitation.email,
        invited_by_name=invitation.inviter.name,
        has_account=has_account(session, invitation.email),
        expires_at=invitation.expires_at,
        accepted=invitation.accepted_at is not None,
        nda_needed=closed,
        cues=[] if closed else service.preview_cues(queries.cues_of(session, project.id), project.cue_prefix),
        spec=None if closed else ResolvedSpec.model_validate(read_spec(current_spec(session, project.id).toml)),
    )
