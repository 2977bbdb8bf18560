"""Joins what the rooms know into the screens that people start from."""

from collections import defaultdict
from collections.abc import Collection, Sequence
from datetime import datetime
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

import audio_checks
from app.accounts.models import Person
from app.accounts.rules import Actor, Role
from app.accounts.schemas import PersonBrief
from app.builds.models import Build
from app.conformance.models import CheckRun
from app.dashboards import queries, schemas, standing_queries
from app.dashboards.rules import CueStatus
from app.dashboards.standing import WholeList, counted, preview_url, worst_in
from app.dashboards.standing_queries import ListRow
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.deliveries.schemas import CueBrief
from app.projects.models import Project
from app.projects.queries import current_spec, deciders_of
from app.projects.service import Standing, nda_is_open, standing_in
from app.renders.models import Picture
from app.reviews.silence import last_days
from app.sound_lists.models import Cue
from app.sound_lists.rules import label

UNFINISHED = frozenset(
    {CueStatus.TO_MAKE, CueStatus.PLACEHOLDER, CueStatus.QUESTION, CueStatus.PARTLY_ACCEPTED}
)  # what a designer could begin now


def me(session: Session, actor: Actor, *, operators: Collection[str]) -> schemas.Me:
    """Return who is signed in, and everything they can open."""
    person = session.get_one(Person, actor.person)
    engagements = {each.project_id: each for each in queries.my_engagements(session, person.id)}
    liaisons = queries.my_liaisons(session, person.id)
    projects = queries.my_projects(session, person.id, list(actor.roles))
    studios = {project.studio_id: project.studio.name for project in projects}
    deciders = deciders_of(session, [project for project in projects if project.studio_id in actor.roles])
    named = queries.studio_names(session, list(actor.roles))
    return schemas.Me(
        person=PersonBrief(id=person.id, name=person.name),
        email=person.email,
        is_operator=person.email in operators,
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
                is_decider=project.id in deciders and deciders[project.id].id == person.id,
                engagement_kind=engagements[project.id].kind if project.id in engagements else None,
                nda_open=(
                    project.studio_id not in actor.roles
                    and project.id in engagements
                    and nda_is_open(project, engagements[project.id])
                ),
            )
            for project in projects
        ],
    )


def _brief(project: Project, cue: Cue | ListRow) -> CueBrief:
    return CueBrief(id=cue.id, label=label(project.cue_prefix, cue.number), name=cue.name)


def _peaks_url(picture: Picture | None) -> str | None:
    return f"/v1/sounds/{picture.id}/peaks.json" if picture else None


def today(session: Session, actor: Actor, project_id: UUID) -> schemas.Today:
    """Return what waits for the team today, beside the review queue."""
    standing = standing_in(session, actor, project_id)
    standing.ensure_team()
    project = standing.project
    return schemas.Today(
        questions=_questions(session, project, only_open=True),
        with_others=_with_others(session, project),
        builds=[_build(build) for build in queries.builds(session, project_id)],
        counts=counted(session, standing),
        draft_changes=queries.draft_changes(session, project_id),
        placeholders=queries.placeholders(session, project_id),
        unsent_mails=queries.unsent_mails(session, project.studio_id) if standing.is_producer else 0,
    )


def _with_others(session: Session, project: Project) -> list[schemas.WithOthers]:
    """Return what waits for somebody but the decider, the oldest first."""

    def waits(take: Take, cue: CueBrief | None, status: Any, who: str) -> schemas.WithOthers:
        return schemas.WithOthers(cue=cue, file_name=take.file_name, status=status, who=who, since=take.state_since)

    unmatched = [waits(take, None, "unmatched", who) for take, who in queries.unmatched_takes(session, project.id)]
    back = [
        waits(take, _brief(project, cue), take.state.value, who)
        for take, cue, who in queries.takes_with_designers(session, project.id)
    ]
    return sorted([*unmatched, *back], key=lambda each: each.since)[: queries.WITH_OTHERS]


def _questions(
    session: Session, project: Project, *, only_open: bool, asked_by: UUID | None = None
) -> list[schemas.AskedQuestion]:
    return [
        schemas.AskedQuestion(
            id=question.id,
            cue=_brief(project, cue),
            text=question.text,
            asked_by=PersonBrief(id=asker.id, name=asker.name),
            asked_at=question.asked_at,
            answer=question.answer,
            answered_at=question.answered_at,
        )
        for question, cue, asker in queries.questions(session, project.id, asked_by=asked_by, only_open=only_open)
    ]


def desk(session: Session, actor: Actor, project_id: UUID) -> schemas.Desk:
    """Return a designer's work in one project."""
    standing = standing_in(session, actor, project_id)
    standing.ensure_designer()
    own = Standing(
        standing.project, actor, frozenset(), is_liaison=False, is_decider=False, engagement=standing.engagement
    )
    project, spec = standing.project, audio_checks.parse_spec(current_spec(session, project_id).toml)
    the_list = WholeList(session, own)
    cues = queries.cues_by_id(session, project_id)
    takes = queries.take_counts(session, project_id, actor.person)
    waiting = [row for row in the_list.rows if the_list.status[row.id] is CueStatus.TO_REVIEW]
    last = last_days(session, [row.id for row in waiting])
    return schemas.Desk(
        came_back=_came_back(session, the_list, spec, actor.person),
        to_make=[
            _to_make(project, cues[row.id], the_list) for row in the_list.rows if the_list.status[row.id] in UNFINISHED
        ],
        with_approver=[
            schemas.WithApprover(**_brief(project, row).model_dump(), accepted_after=last.get(row.id))
            for row in waiting
        ],
        with_approver_files=takes.get((TakeState.CONFORMING, True), 0),
        accepted=the_list.counts.get(CueStatus.ACCEPTED, 0),
        cues=len(the_list.rows) - the_list.counts.get(CueStatus.CUT, 0),
        unmatched=sum(count for (_, is_matched), count in takes.items() if not is_matched),
        checking=takes.get((TakeState.RECEIVED, True), 0),
        questions=_questions(session, project, only_open=False, asked_by=actor.person),
    )


def _to_make(project: Project, cue: Cue, the_list: WholeList) -> schemas.ToMake:
    return schemas.ToMake(
        cue=_brief(project, cue),
        use=cue.use,
        category=cue.category,
        duration_s=cue.duration_s,
        loop=cue.loop,
        variations=cue.variations,
        missing=sum(status is CueStatus.TO_MAKE for status in the_list.variations[cue.id]),
        state=cue.state,
        status=the_list.status[cue.id],
    )


def _came_back(
    session: Session, the_list: WholeList, spec: audio_checks.DeliverySpec, designer_id: UUID
) -> list[schemas.CameBack]:
    project = the_list.project
    back = [
        (take, cue)
        for take, cue in queries.takes_back(session, project.id, designer_id)
        if the_list.status[cue.id] is not CueStatus.ACCEPTED
    ]
    ids = [take.id for take, _ in back]
    pictures = standing_queries.pictures(session, project.studio_id, [take.master_sha256 for take, _ in back])
    runs = queries.current_runs(session, ids)
    changes: dict[UUID, list[dict[str, Any]]] = defaultdict(list)
    rounds: dict[UUID, int | None] = {}
    for change, number in queries.sent_changes(session, ids):
        changes[change.take_id].append({"text": change.text, "start_s": change.start_s, "end_s": change.end_s})
        rounds[change.take_id] = number
    return [
        schemas.CameBack(
            take_id=take.id,
            cue=_brief(project, cue),
            number=take.number,
            variation=take.variation,
            file_name=take.file_name,
            status=take.state.value,
            since=take.state_since,
            duration_s=picture.duration_s if (picture := pictures.get(take.master_sha256)) else None,
            thumb=picture.thumb if picture else None,
            preview_url=preview_url(picture),
            peaks_url=_peaks_url(picture),
            findings=runs[take.id].report.get("findings", []) if take.id in runs else [],
            changes=changes[take.id],
            round=rounds.get(take.id),
            limit_dbfs=_peak_limit(spec, cue.category),
        )
        for take, cue in back
    ]


def _peak_limit(spec: audio_checks.DeliverySpec, category: str | None) -> float | None:
    known = category if category in spec.categories else None
    return spec.for_category(known).limits.sample_peak_dbfs


def overview(session: Session, actor: Actor, project_id: UUID) -> schemas.Overview:
    """Return a project at one glance."""
    standing = standing_in(session, actor, project_id)
    project, the_list = standing.project, WholeList(session, standing)
    palette = [row for row in the_list.rows if row.palette]
    shown = standing_queries.shown_takes(
        session,
        [row.id for row in palette],
        standing.only_designer_id,
        accepted=[row.id for row in palette if the_list.status[row.id] is CueStatus.ACCEPTED],
    )
    loops = queries.loops(session, [row.id for row in palette])
    pictures = standing_queries.pictures(session, project.studio_id, [take.master_sha256 for take in shown.values()])
    runs = queries.current_runs(session, [take.id for take in shown.values()])
    builds = queries.builds(session, project_id) if standing.is_team else []
    return schemas.Overview(
        steps=[
            schemas.Step(cue=_brief(project, row), palette=row.palette, status=the_list.status[row.id])
            for row in the_list.rows
        ],
        counts=the_list.counts,
        builds=[_build(build) for build in builds],
        palette=[
            schemas.PaletteSound(
                cue=_brief(project, row),
                loop=row.id in loops,
                thumb=picture.thumb if (picture := pictures.get(shown[row.id].master_sha256)) else None,
                preview_url=preview_url(picture),
                loudness_lufs=_loudness(runs.get(shown[row.id].id)),
            )
            for row in palette
            if row.id in shown
        ],
        lately=_lately(session, standing),
        reviewers=queries.team_size(session, project.studio_id),
    )


def _loudness(run: CheckRun | None) -> float | None:
    measured = run.report.get("measurements", {}) if run else {}
    value = measured.get("integrated_lufs")
    return value if value is not None else measured.get("short_loudness_lufs")


def _lately(session: Session, standing: Standing) -> list[schemas.Happening]:
    project, designer_id = standing.project, standing.only_designer_id
    happened: list[schemas.Happening] = []

    def tell(at: datetime, kind: Any, who: str, text: str) -> None:
        happened.append(schemas.Happening(at=at, kind=kind, who=who, text=text))

    for delivery, designer, files, unmatched in queries.latest_deliveries(session, project.id, designer_id):
        without = f"; {unmatched} without a cue" if unmatched else ""
        tell(delivery.created_at, "delivery", designer.name, f"delivered {_files(files)}{without}")
    for take, cue, run in queries.latest_returns(session, project.id, designer_id):
        worst = worst_in(run)
        name = cue.name if cue else take.file_name
        tell(take.state_since, "returned", "The check", f"{name} returned: {worst['message'] if worst else 'unread'}")
    for verdict, cue, take, decider in queries.latest_approvals(session, project.id, designer_id):
        tell(verdict.created_at, "approved", decider.name, f"approved {cue.name}, version {take.number}")
    if standing.is_team:
        for build in queries.builds(session, project.id)[: queries.LATELY]:
            said = f"refused, {_files(build.rejected)}" if build.rejected else "passed"
            tell(build.created_at, "build", "The game", f"Build {build.label} {said}")
        for sending, decider, count in queries.latest_sendings(session, project.id):
            noun = "change" if count == 1 else "changes"
            tell(sending.created_at, "changes", decider.name, f"requested {count} {noun}")
    happened.sort(key=lambda each: each.at, reverse=True)
    return happened[: queries.LATELY]


def _build(build: Build) -> schemas.BuildBrief:
    return schemas.BuildBrief.model_validate(build)


def _files(count: int) -> str:
    return f"{count} {'file' if count == 1 else 'files'}"


def find(session: Session, actor: Actor, project_id: UUID, typed: str) -> schemas.FindResult:
    """Return the cues, then what was said, that hold the typed words."""
    standing = standing_in(session, actor, project_id)
    project = standing.project
    words = [_escaped(word) for word in typed.split()]
    if not words:
        return schemas.FindResult(hits=[])
    number = typed.strip().upper().removeprefix(f"{project.cue_prefix.upper()}-")
    hits = [
        schemas.Found(kind="cue", cue=_brief(project, cue), text=cue.use or cue.description, take_id=None)
        for cue in _by_nearness(queries.find_cues(session, project_id, words), typed)
    ]
    if number.isdigit() and (cue := queries.cue_by_number(session, project_id, int(number))):
        hits.insert(0, schemas.Found(kind="cue", cue=_brief(project, cue), text=cue.use, take_id=None))
    phrase = _escaped(typed.strip())
    if standing.is_team:
        hits += [
            schemas.Found(kind="comment", cue=_brief(project, cue), text=comment.text, take_id=comment.take_id)
            for comment, cue in queries.find_comments(session, project_id, phrase)
        ]
    hits += [
        schemas.Found(kind="question", cue=_brief(project, cue), text=question.text, take_id=None)
        for question, cue in queries.find_questions(session, project_id, phrase)
    ]
    return schemas.FindResult(hits=hits[: queries.HITS])


def _escaped(word: str) -> str:
    return word.replace("\\", "\\\\").replace("%", "\\%").replace("_", "\\_")


def _by_nearness(cues: Sequence[Cue], typed: str) -> list[Cue]:
    return sorted(cues, key=lambda cue: (not cue.name.lower().startswith(typed.strip().lower()), cue.number))
