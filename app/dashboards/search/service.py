"""Search in one project or all: cues, files, people, contracts, and what was said, as far as the caller sees them."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.accounts.schemas import PersonBrief
from app.agreements.queries import contracts_in
from app.core.web.http import number_in
from app.dashboards.search import comment_queries, queries, schemas
from app.dashboards.search.comment_queries import Elsewhere, FoundLabel, FoundReason, InProject
from app.dashboards.steps.questions import brief
from app.deliveries.models import Take
from app.projects.models import Project
from app.projects.service import ProjectAccess, project_access
from app.reviews.reasons.rules import ReasonKind
from app.sound_lists.models import Cue

OF_A_KIND = 6  # hits of each kind but cues


def search(session: Session, actor: Actor, project_id: UUID, typed: str) -> schemas.FindResult:
    """Return matches of the typed words: cues first, then files, people, contracts and remarks.

    No kind has more hits than `OF_A_KIND`; cues have as many as are left of `HITS`.
    """
    access = project_access(session, actor, project_id)
    words = typed.split()
    if not words:
        return schemas.FindResult(hits=[])
    phrase = typed.strip()
    others = [
        *_files(session, access, words),
        *_people(session, access, phrase),
        *_contracts(session, access, phrase),
        *(hit for _, hit in _reasons_and_labels(session, InProject(access.project.id, access.only_designer_id), words)),
        *_said(session, access, phrase),
    ]
    cues = _cues(session, access, words, phrase)
    return schemas.FindResult(hits=[*cues[: max(OF_A_KIND, queries.HITS - len(others))], *others])


def find_elsewhere(
    session: Session, actor: Actor, typed: str, *, except_in: UUID | None
) -> schemas.FindElsewhereResult:
    """Return cues, files, reasons and labels that hold the words, in all projects that the caller sees but one."""
    words = typed.split()
    projects = queries.projects_elsewhere(session, actor, except_in=except_in) if words else []
    if not projects:
        return schemas.FindElsewhereResult(hits=[])
    files = [
        _elsewhere(project, _file(project, take, cue))
        for take, cue, project in queries.find_files_elsewhere(session, actor, projects, words, limit=OF_A_KIND)
    ]
    cues = [
        _elsewhere(project, _cue(project, cue))
        for cue, project in queries.find_cues_elsewhere(session, projects, words)
    ]
    reasons_and_labels = _reasons_and_labels(session, Elsewhere(actor, projects), words)
    return schemas.FindElsewhereResult(
        hits=[
            *cues[: queries.HITS - len(files)],
            *files,
            *(_elsewhere(project, hit) for project, hit in reasons_and_labels),
        ]
    )


def _elsewhere(project: Project, hit: schemas.Found) -> schemas.FoundElsewhere:
    return schemas.FoundElsewhere(**hit.model_dump(), project_id=project.id, project_name=project.name)


def _cue(project: Project, cue: Cue) -> schemas.Found:
    return schemas.Found(kind="cue", title=cue.name, cue=brief(project, cue), text=cue.use or cue.description)


def _file(project: Project, take: Take, cue: Cue | None) -> schemas.Found:
    return schemas.Found(
        kind="file",
        title=take.file_name,
        text=take.state.value,
        cue=brief(project, cue) if cue else None,
        take_id=take.id,
    )


def _cues(session: Session, access: ProjectAccess, words: Sequence[str], phrase: str) -> list[schemas.Found]:
    project = access.project
    nearest = _by_nearness(queries.find_cues(session, project.id, words), phrase)
    number = number_in(phrase.upper().removeprefix(f"{project.cue_prefix.upper()}-"))
    if number is not None and (cue := queries.cue_by_number(session, project.id, number)):
        nearest = [cue, *(other for other in nearest if other.id != cue.id)]
    return [_cue(project, cue) for cue in nearest]


def _by_nearness(cues: Sequence[Cue], phrase: str) -> list[Cue]:
    return sorted(cues, key=lambda cue: (not cue.name.lower().startswith(phrase.lower()), cue.number))


def _files(session: Session, access: ProjectAccess, words: Sequence[str]) -> list[schemas.Found]:
    rows = queries.find_files(session, access.project.id, access.only_designer_id, words, limit=OF_A_KIND)
    return [_file(access.project, take, cue) for take, cue in rows]


def _people(session: Session, access: ProjectAccess, phrase: str) -> list[schemas.Found]:
    if not access.is_team:
        return []
    project = access.project
    rows = queries.find_people(session, project.studio_id, project.id, phrase, limit=OF_A_KIND)
    return [schemas.Found(kind="person", title=person.name, text=person.email) for person in rows]


def _contracts(session: Session, access: ProjectAccess, phrase: str) -> list[schemas.Found]:
    sought = phrase.casefold()
    return [
        schemas.Found(kind="contract", title=contract.title, text=contract.designer.name, contract_id=contract.id)
        for contract in contracts_in(session, access.actor, access.project.id)
        if sought in contract.title.casefold() or sought in contract.designer.name.casefold()
    ][:OF_A_KIND]


def _reasons_and_labels(
    session: Session, reach: InProject | Elsewhere, words: Sequence[str]
) -> list[tuple[Project, schemas.Found]]:
    reasons = comment_queries.find_reasons(session, reach, words, limit=OF_A_KIND)
    labels = comment_queries.find_labels(session, reach, words, limit=OF_A_KIND)
    return [
        *((reason.project, _reason(reason)) for reason in reasons),
        *((label.project, _label(label)) for label in labels),
    ]


def _reason(reason: FoundReason) -> schemas.Found:
    verdict = reason.verdict
    return schemas.Found(
        kind="change_reason" if reason.kind is ReasonKind.CHANGE else "pick_reason",
        title=reason.cue.name,
        text=", ".join(verdict.reasons),
        cue=brief(reason.project, reason.cue),
        take_id=reason.take.id,
        start_s=reason.start_s,
        said=schemas.VersionFeedback(
            variation=reason.take.variation,
            number=reason.take.number,
            by=verdict.author and PersonBrief.model_validate(verdict.author),
            on_behalf_of=verdict.represented and PersonBrief.model_validate(verdict.represented),
            at=verdict.created_at,
        ),
    )


def _label(label: FoundLabel) -> schemas.Found:
    take = label.take
    return schemas.Found(
        kind="label",
        title=label.cue.name,
        text=take.label or "",
        cue=brief(label.project, label.cue),
        take_id=take.id,
        said=schemas.VersionFeedback(
            variation=take.variation,
            number=take.number,
            by=label.by and PersonBrief.model_validate(label.by),
            on_behalf_of=None,
            at=take.labelled_at,
        ),
    )


def _said(session: Session, access: ProjectAccess, phrase: str) -> list[schemas.Found]:
    project = access.project
    comments = queries.find_comments(session, project.id, access.only_designer_id, phrase, limit=OF_A_KIND)
    questions = queries.find_questions(session, project.id, phrase, limit=OF_A_KIND)
    return [
        *(
            schemas.Found(
                kind="comment",
                title=cue.name,
                text=comment.text,
                cue=brief(project, cue),
                take_id=comment.take_id,
                start_s=comment.start_s,
            )
            for comment, cue in comments
        ),
        *(
            schemas.Found(kind="question", title=cue.name, text=question.text, cue=brief(project, cue))
            for question, cue in questions
        ),
    ]
