"""A designer's owed work in all of their projects and studios."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.models import Person
from app.accounts.rules import Actor
from app.accounts.schemas import PersonBrief
from app.core.web.http import cursor_of, day_cursor
from app.dashboards.desk import own_desk_queries as queries
from app.dashboards.desk.own_desk_queries import NO_DAY, OwedRow, Said
from app.dashboards.desk.own_desk_schemas import LatestComment, OwedCue, OwnDesk
from app.dashboards.rules import CAME_BACK, UNFINISHED, cue_status, statuses_of
from app.deliveries.schemas import CueBrief
from app.projects.models import Project
from app.sound_lists.rules import CueState, label

CUES = 200
OWED = CAME_BACK | UNFINISHED


def own_desk(session: Session, actor: Actor, cursor: str | None) -> OwnDesk:
    """Return a page of the cues that wait for the caller in all projects, what is due soonest first."""
    projects = {project.id: project for project in queries.engaged_projects(session, actor.person)}
    pairs = queries.kept_facts(session, projects, actor.person)
    rows = queries.owed_cues(
        session,
        projects,
        actor.person,
        owed=[(facts, variations) for facts, variations in pairs if _is_owed(facts, variations)],
        after=day_cursor(cursor),
        limit=CUES + 1,
    )
    page = rows[:CUES]
    comments_by_cue = _latest_comments(session, [row.id for row in page], actor.person)
    return OwnDesk(
        person=PersonBrief.model_validate(session.get_one(Person, actor.person)),
        projects=len(projects),
        items=[_owed(projects[row.project_id], row, comments_by_cue.get(row.id)) for row in page],
        next=cursor_of((page[-1].due_on or NO_DAY).isoformat(), page[-1].id) if len(rows) > CUES else None,
    )


def _is_owed(facts: str, variations: int) -> bool:
    statuses = statuses_of(facts, variations)
    return cue_status(CueState.LOCKED, statuses, is_asked=False, placeholder=False) in OWED


def _owed(project: Project, row: OwedRow, comment: Said | None) -> OwedCue:
    statuses = statuses_of(row.facts, row.variations)
    return OwedCue(
        cue=CueBrief(id=row.id, label=label(project.cue_prefix, row.number), name=row.name),
        project_id=project.id,
        project_name=project.name,
        studio_name=project.studio.name,
        status=cue_status(row.state, statuses, is_asked=row.is_asked, placeholder=row.placeholder),
        due_on=row.due_on,
        latest_comment=LatestComment(text=comment.text, by=comment.by, at=comment.at) if comment else None,
    )


def _latest_comments(session: Session, cue_ids: Sequence[UUID], designer_id: UUID) -> dict[UUID, Said]:
    """Return the last words on each cue: a comment, a change request, an answer, or the check's first finding."""
    comments = [
        *queries.comments(session, cue_ids, designer_id),
        *queries.changes(session, cue_ids, designer_id),
        *queries.answers(session, cue_ids, designer_id),
    ]
    for take, run in queries.returned(session, cue_ids, designer_id):
        errors = [finding["message"] for finding in run.report.get("findings", []) if finding["severity"] == "error"]
        if take.cue_id is not None and errors:
            comments.append(Said(take.cue_id, take.state_since, errors[0], None))
    return {comment.cue_id: comment for comment in sorted(comments, key=lambda comment: comment.at)}
