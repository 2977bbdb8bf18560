"""The endpoints of this room."""

from typing import Annotated
from uuid import UUID

from fastapi import APIRouter, Path, Query

from app.accounts.rules import Actor, Audience
from app.accounts.schemas import PersonBrief
from app.accounts.web.policies import allows
from app.briefs import follow_ups, queries, service, spec_answers
from app.briefs.documents import document_of, version_brief, version_read
from app.briefs.errors import (
    AnswerChanged,
    AnswerInvalid,
    BriefVersionNotFound,
    FollowUpAnswered,
    FollowUpNotFound,
    NothingProposed,
    NothingToPublish,
    QuestionUnknown,
)
from app.briefs.rules import differences, in_words, number_of
from app.briefs.schemas import (
    BriefChange,
    BriefComparison,
    BriefDifference,
    BriefDocument,
    BriefVersionAdd,
    BriefVersionRead,
    BriefVersionSummary,
    FollowUpAdd,
    FollowUpAnswer,
    FollowUpRead,
    LastReadRead,
    SpecApplied,
    SpecProposal,
    SpecProposalApply,
)
from app.core.web.http import LARGEST_NUMBER, BadCursor, DbSession, Page, cursor_of, number_cursor, problems
from app.projects.errors import BadSpec, DesignerNeeded, ProjectNotFound, SpecChanged, TeamNeeded
from app.projects.service import project_access

router = APIRouter(prefix="/v1", tags=["briefs"])
VERSIONS_AT_ONCE = 50
VersionNumber = Annotated[int, Path(ge=1, le=LARGEST_NUMBER)]


@router.get("/projects/{project_id}/brief", responses=problems(ProjectNotFound))
def read_brief(project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> BriefDocument:
    """Return the questions of the brief with their answers, and how complete they are."""
    return document_of(session, project_access(session, actor, project_id))


@router.patch(
    "/projects/{project_id}/brief",
    responses=problems(ProjectNotFound, TeamNeeded, AnswerChanged, AnswerInvalid, QuestionUnknown),
)
def change_brief(
    project_id: UUID, body: BriefChange, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> BriefDocument:
    """Save answers; two people collide only where both changed the same one."""
    changes = {
        key: service.NewAnswer(answer.value, answer.is_unknown, answer.note) for key, answer in body.answers.items()
    }
    service.change_answers(session, actor, project_id, revision=body.revision, changes=changes)
    return document_of(session, project_access(session, actor, project_id))


@router.get("/projects/{project_id}/brief/versions", responses=problems(ProjectNotFound, BadCursor))
def list_brief_versions(
    project_id: UUID, session: DbSession, cursor: str | None = None, actor: Actor = allows(Audience.PROJECT)
) -> Page[BriefVersionSummary]:
    """Return the published versions of the brief, newest first."""
    project_access(session, actor, project_id)
    below = number_cursor(cursor)
    versions = queries.versions_of(session, project_id, below=below, limit=VERSIONS_AT_ONCE + 1)
    shown = versions[:VERSIONS_AT_ONCE]
    items = [version_brief(version) for version in shown]
    return Page(items=items, next=cursor_of(shown[-1].number) if len(versions) > VERSIONS_AT_ONCE else None)


@router.post(
    "/projects/{project_id}/brief/versions",
    status_code=201,
    responses=problems(ProjectNotFound, TeamNeeded, NothingToPublish, AnswerChanged),
)
def publish_brief_version(
    project_id: UUID, body: BriefVersionAdd, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> BriefVersionSummary:
    """Keep the answers as a version that never changes."""
    return version_brief(service.publish_version(session, actor, project_id, revision=body.revision, note=body.note))


@router.get(
    "/projects/{project_id}/brief/versions/{version}", responses=problems(ProjectNotFound, BriefVersionNotFound)
)
def read_brief_version(
    project_id: UUID, version: VersionNumber, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> BriefVersionRead:
    """Return one published version with its answers."""
    access = project_access(session, actor, project_id)
    return version_read(session, service.version_seen(session, access, version))


@router.put(
    "/projects/{project_id}/brief/versions/{version}/read",
    status_code=204,
    responses=problems(ProjectNotFound, DesignerNeeded, BriefVersionNotFound),
)
def record_brief_read(
    project_id: UUID, version: VersionNumber, session: DbSession, actor: Actor = allows(Audience.DESIGNER)
) -> None:
    """Record that the calling designer opened a version, which the team sees."""
    service.record_read(session, actor, project_id, version)


@router.get("/projects/{project_id}/brief/reads", responses=problems(ProjectNotFound, TeamNeeded))
def list_brief_reads(project_id: UUID, session: DbSession, actor: Actor = allows(Audience.TEAM)) -> list[LastReadRead]:
    """Return the version that each engaged designer opened last."""
    return [
        LastReadRead(
            designer=PersonBrief.model_validate(last.engagement.designer),
            version=last.read.version.number if last.read else None,
            read_at=last.read.read_at if last.read else None,
            behind=last.behind,
        )
        for last in service.last_reads(session, actor, project_id)
    ]


@router.get("/projects/{project_id}/brief/compare", responses=problems(ProjectNotFound, BriefVersionNotFound))
def compare_brief_versions(
    project_id: UUID,
    session: DbSession,
    first: Annotated[int, Query(alias="from", ge=0, le=LARGEST_NUMBER)] = 0,
    last: Annotated[
        int | None, Query(alias="to", ge=1, le=LARGEST_NUMBER, description="Left out: the brief as it stands.")
    ] = None,
    actor: Actor = allows(Audience.PROJECT),
) -> BriefComparison:
    """Return the answers that differ between two versions; version 0 is the empty brief."""
    access = project_access(session, actor, project_id)
    before, after = (service.answers_at(session, access, number) for number in (first, last))
    differing = [
        BriefDifference(
            question=question.key,
            number=number_of(question),
            text=question.text,
            before=in_words(question, before.get(question.key)),
            after=in_words(question, after.get(question.key)),
        )
        for question in differences(before, after)
    ]
    return BriefComparison(from_version=first, to_version=last, differences=differing)


@router.get("/projects/{project_id}/brief/spec", responses=problems(ProjectNotFound))
def propose_spec(project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> SpecProposal:
    """Return the delivery spec as the answers ask for it, and each difference to the one in force."""
    return spec_answers.proposed_spec(session, actor, project_id)


@router.post(
    "/projects/{project_id}/brief/spec",
    responses=problems(ProjectNotFound, TeamNeeded, AnswerChanged, NothingProposed, SpecChanged, BadSpec),
)
def apply_spec_proposal(
    project_id: UUID, body: SpecProposalApply, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> SpecApplied:
    """Save the answers' demands as a version of the delivery spec; affected takes are checked again."""
    spec = spec_answers.apply_proposal(
        session,
        actor,
        project_id,
        based_on_version=body.based_on_version,
        brief_revision=body.brief_revision,
    )
    return SpecApplied(version=spec.version)


@router.post(
    "/projects/{project_id}/brief/follow-ups",
    status_code=201,
    responses=problems(ProjectNotFound, DesignerNeeded, QuestionUnknown),
)
def ask_follow_up(
    project_id: UUID, body: FollowUpAdd, session: DbSession, actor: Actor = allows(Audience.DESIGNER)
) -> FollowUpRead:
    """Ask the team about a question of the brief."""
    return follow_ups.ask(session, actor, project_id, question=body.question, text=body.text)


@router.post(
    "/brief-follow-ups/{follow_up_id}/answer",
    responses=problems(FollowUpNotFound, TeamNeeded, FollowUpAnswered),
)
def answer_follow_up(
    follow_up_id: UUID, body: FollowUpAnswer, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> FollowUpRead:
    """Answer a designer's follow-up, once."""
    return follow_ups.answer(session, actor, follow_up_id, body.text)
