"""The rooms' facts, joined into the screens that people start from."""

from datetime import datetime
from typing import Any
from uuid import UUID

from sqlalchemy import and_
from sqlalchemy.orm import Session

from app.accounts import queries as accounts
from app.accounts.models import Person
from app.accounts.rules import Actor, Role
from app.accounts.schemas import PersonBrief
from app.accounts.second_factors import queries as second_factor_queries
from app.builds.models import Build
from app.conformance.models import CheckRun
from app.dashboards import queries, schemas
from app.dashboards.progress import queries as progress_queries
from app.dashboards.progress.service import completion, counted, preview_url, status_of, viewer_of, worst_in
from app.dashboards.rules import CueStatus
from app.dashboards.steps.questions import asked_questions, brief
from app.deliveries.models import Take
from app.deliveries.schemas import CueBrief
from app.projects.approval.service import approval_rights_of
from app.projects.models import Project
from app.projects.queries import approvers_of
from app.projects.rules import EVERY_CUE
from app.projects.service import ProjectAccess, project_access
from app.projects.visibility import nda_is_pending
from app.renders.thumb_queries import thumbs
from app.sound_lists.models import Cue
from app.sound_lists.rules import CueState

STEPS = 500  # cues of which the project page shows one by one where they stand


def me(session: Session, actor: Actor, *, has_contracts: bool) -> schemas.Me:
    """Return the person signed in, and everything they can open."""
    person = session.get_one(Person, actor.person)
    engagements = {
        my_engagement.project_id: my_engagement for my_engagement in queries.my_engagements(session, person.id)
    }
    liaisons = queries.my_liaisons(session, actor)
    required_by = second_factor_queries.studios_waiting_for_factor(
        session, person.id, except_studio_id=actor.second_factor_studio_id
    )
    # Nothing opens before it is set up.
    projects = [] if required_by else queries.my_projects(session, person.id, list(actor.roles))
    studios = {project.studio_id: project.studio.name for project in projects}
    approvers = approvers_of(session, [project for project in projects if project.studio_id in actor.roles])
    rights = approval_rights_of(session, {project_id: approver.id for project_id, approver in approvers.items()})
    scopes = {project_id: of_project.scope_of(person.id) for project_id, of_project in rights.items()}
    named = queries.studio_names(session, list(actor.roles))
    return schemas.Me(
        person=PersonBrief.model_validate(person),
        email=person.email,
        email_verified_at=person.email_verified_at,
        is_operator=accounts.is_operator(session, person.id),
        has_contracts=has_contracts,
        second_factor_required_by=required_by,
        studios=[
            schemas.MyStudio(id=studio_id, name=named[studio_id], roles=sorted(roles))
            for studio_id, roles in actor.roles.items()
        ],
        projects=[
            schemas.MyProject(
                id=project.id,
                name=project.name,
                studio_id=project.studio_id,
                studio_name=studios[project.studio_id],
                cue_prefix=project.cue_prefix,
                part="team" if project.studio_id in actor.roles else "designer",
                is_producer=Role.PRODUCER in actor.roles_in(project.studio_id),
                is_liaison=project.id in liaisons,
                is_approver=project.id in scopes and scopes[project.id].is_any,
                approves_all=project.id in scopes and scopes[project.id].is_all,
                engagement_kind=engagements[project.id].kind if project.id in engagements else None,
                nda_open=(
                    project.studio_id not in actor.roles
                    and project.id in engagements
                    and nda_is_pending(project, engagements[project.id])
                ),
                is_sample=project.is_sample,
            )
            for project in projects
        ],
    )


def today(session: Session, actor: Actor, project_id: UUID) -> schemas.Today:
    """Return the matters that wait for the team today, besides the review queue."""
    access = project_access(session, actor, project_id)
    access.ensure_team()
    project = access.project
    likes = progress_queries.cue_groups(session, project_id, project.studio_id)
    return schemas.Today(
        questions=asked_questions(project, queries.open_questions(session, project_id)),
        with_others=_with_others(session, project),
        builds=[_build(build) for build in queries.builds(session, project_id)],
        counts=counted(likes),
        draft_changes=queries.drafts_since(session, project_id, EVERY_CUE)[0],
        placeholders=sum(like.cues for like in likes if like.placeholder and like.state is not CueState.CUT),
        unsent_mails=queries.unsent_mails(session, project.studio_id) if access.is_producer else 0,
    )


def _with_others(session: Session, project: Project) -> list[schemas.WithOthers]:
    """Return the matters that wait for others than the approver, the oldest first."""

    def waits(take: Take, cue: CueBrief | None, status: Any, who: Person) -> schemas.WithOthers:
        return schemas.WithOthers(
            cue=cue,
            file_name=take.file_name,
            status=status,
            who=who.name,
            person_id=who.id,
            picture=who.picture,
            since=take.state_since,
        )

    unmatched = [waits(take, None, "unmatched", who) for take, who in queries.unmatched_takes(session, project.id)]
    back = [
        waits(take, brief(project, cue), take.state.value, who)
        for take, cue, who in queries.takes_with_designers(session, project)
    ]
    return sorted([*unmatched, *back], key=lambda item: item.since)[: queries.WITH_OTHERS]


def overview(session: Session, actor: Actor, project_id: UUID) -> schemas.Overview:
    """Return a project at one glance."""
    access = project_access(session, actor, project_id)
    project, viewer_id = access.project, viewer_of(access)
    counts = counted(progress_queries.cue_groups(session, project_id, viewer_id))
    steps = progress_queries.list_rows(session, project_id, viewer_id, limit=STEPS)
    palette = progress_queries.list_rows(session, project_id, viewer_id, only=and_(Cue.palette))
    shown = progress_queries.shown_takes(
        session,
        [row.id for row in palette],
        viewer_id,
        access.only_designer_id,
        accepted=[row.id for row in palette if status_of(row) is CueStatus.ACCEPTED],
    )
    loops = queries.loops(session, [row.id for row in palette])
    drawn = thumbs(session, [take.picture_id for take in shown.values() if take.picture_id])
    runs = queries.current_runs(session, [take.id for take in shown.values()])
    builds = queries.builds(session, project_id) if access.is_team else []
    return schemas.Overview(
        steps=[schemas.Step(cue=brief(project, row), palette=row.palette, status=status_of(row)) for row in steps],
        cues=sum(counts.values()),
        counts=counts,
        needs=completion(progress_queries.need_groups(session, project_id, viewer_id)),
        builds=[_build(build) for build in builds],
        palette=[
            schemas.PaletteSound(
                cue=brief(project, row),
                take_id=shown[row.id].id,
                loop=row.id in loops,
                thumb=drawn.get(picture_id) if (picture_id := shown[row.id].picture_id) else None,
                preview_url=preview_url(picture_id),
                loudness_lufs=_loudness(runs.get(shown[row.id].id)),
            )
            for row in palette
            if row.id in shown
        ],
        lately=_lately(session, access),
        reviewers=queries.team_size(session, project.studio_id),
    )


def _loudness(run: CheckRun | None) -> float | None:
    measured = run.report.get("measurements", {}) if run else {}
    value = measured.get("integrated_lufs")
    return value if value is not None else measured.get("short_loudness_lufs")


def _lately(session: Session, access: ProjectAccess) -> list[schemas.Activity]:
    project, designer_id = access.project, access.only_designer_id
    happened: list[schemas.Activity] = []

    def add(at: datetime, kind: Any, who: str, text: str) -> None:
        happened.append(schemas.Activity(at=at, kind=kind, who=who, text=text))

    for delivery, designer, files, unmatched in queries.latest_deliveries(session, project.id, designer_id):
        without = f"; {unmatched} without a cue" if unmatched else ""
        add(delivery.created_at, "delivery", designer.name, f"delivered {_files(files)}{without}")
    for take, cue, run in queries.latest_returns(session, project.id, designer_id):
        worst = worst_in(run)
        name = cue.name if cue else take.file_name
        add(take.state_since, "returned", "The check", f"{name} returned: {worst['message'] if worst else 'unread'}")
    for verdict, cue, take, approver in queries.latest_approvals(session, project.id, designer_id):
        who = approver.name if approver else "The clause on silence"
        add(verdict.created_at, "approved", who, f"approved {cue.name}, version {take.number}")
    if access.is_team:
        for build in queries.builds(session, project.id)[: queries.LATELY]:
            verdict_text = f"refused, {_files(build.rejected)}" if build.rejected else "passed"
            add(build.created_at, "build", "The game", f"Build {build.label} {verdict_text}")
        for sending, approver, count in queries.latest_feedback(session, project.id):
            noun = "change" if count == 1 else "changes"
            add(sending.created_at, "changes", approver.name, f"requested {count} {noun}")
    happened.sort(key=lambda event: event.at, reverse=True)
    return happened[: queries.LATELY]


def _build(build: Build) -> schemas.BuildBrief:
    return schemas.BuildBrief.model_validate(build)


def _files(count: int) -> str:
    return f"{count} {'file' if count == 1 else 'files'}"
