"""Joins what the rooms know into the screens that people start from."""

from collections import Counter, defaultdict
from collections.abc import Sequence
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
from app.dashboards import queries, schemas
from app.dashboards.rules import CueStatus, TakeFact, cue_status, variation_status
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.deliveries.schemas import CueBrief
from app.projects.models import Project
from app.projects.queries import current_spec, decider_of
from app.projects.service import Standing, standing_in
from app.renders.models import Picture
from app.sound_lists.models import Cue
from app.sound_lists.rules import label

UNFINISHED = frozenset(
    {CueStatus.TO_MAKE, CueStatus.PLACEHOLDER, CueStatus.QUESTION, CueStatus.PARTLY_ACCEPTED}
)  # what a designer could begin now


def me(session: Session, actor: Actor) -> schemas.Me:
    """Return who is signed in, and everything they can open."""
    person = session.get_one(Person, actor.person)
    engagements = {each.project_id: each for each in queries.my_engagements(session, person.id)}
    liaisons = queries.my_liaisons(session, person.id)
    projects = queries.my_projects(session, person.id, list(actor.roles))
    studios = {project.studio_id: project.studio.name for project in projects}
    named = queries.studio_names(session, list(actor.roles))
    return schemas.Me(
        person=PersonBrief(id=person.id, name=person.name),
        email=person.email,
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
                is_decider=project.studio_id in actor.roles and decider_of(session, project) == person.id,
                engagement_kind=engagements[project.id].kind if project.id in engagements else None,
            )
            for project in projects
        ],
    )


def _brief(project: Project, cue: Cue) -> CueBrief:
    return CueBrief(id=cue.id, label=label(project.cue_prefix, cue.number), name=cue.name)


def _preview_url(picture: Picture | None) -> str | None:
    return f"/v1/sounds/{picture.id}/preview" if picture else None


def _peaks_url(picture: Picture | None) -> str | None:
    return f"/v1/sounds/{picture.id}/peaks.json" if picture else None


def _worst(run: CheckRun | None) -> dict[str, Any] | None:
    findings: list[dict[str, Any]] = run.report.get("findings", []) if run else []
    return min(findings, key=lambda finding: finding.get("severity") != "error", default=None)


class ListOnTable:
    """A project's list with the takes that the caller sees, read once and laid out by cue."""

    def __init__(self, session: Session, standing: Standing) -> None:
        self.project = standing.project
        self.cues = queries.cues(session, self.project.id)
        self.takes = queries.takes(session, self.project.id, standing.only_designer_id)
        self.by_cue: dict[UUID, list[Take]] = defaultdict(list)
        for take in self.takes:
            if take.cue_id is not None:
                self.by_cue[take.cue_id].append(take)
        self.open_questions: dict[UUID, list[str]] = defaultdict(list)
        for question, cue, _asker in queries.questions(session, self.project.id, only_open=True):
            self.open_questions[cue.id].append(question.text)
        self.variations = {cue.id: self._variations(cue) for cue in self.cues}
        self.status = {
            cue.id: cue_status(
                cue.state,
                self.variations[cue.id],
                open_questions=len(self.open_questions[cue.id]),
                placeholder=cue.placeholder,
            )
            for cue in self.cues
        }
        self.counts = dict(Counter(self.status.values()))

    def _variations(self, cue: Cue) -> list[CueStatus]:
        facts: dict[int, list[TakeFact]] = defaultdict(list)
        for take in self.by_cue[cue.id]:
            facts[take.variation].append(TakeFact(take.variation, take.number or 0, take.state))
        return [variation_status(facts[variation]) for variation in range(1, cue.variations + 1)]

    def shown_take(self, cue: Cue) -> Take | None:
        """Return the take that stands for the cue in a list: the approved one, else the newest."""
        takes = self.by_cue[cue.id]
        approved = [take for take in takes if take.state is TakeState.APPROVED]
        return approved[0] if approved and self.status[cue.id] is CueStatus.ACCEPTED else takes[-1] if takes else None


def list_standing(session: Session, actor: Actor, project_id: UUID) -> schemas.ListStanding:
    """Return where every cue of the list stands."""
    standing = standing_in(session, actor, project_id)
    table = ListOnTable(session, standing)
    shown = {cue.id: table.shown_take(cue) for cue in table.cues}
    takes = [take for take in shown.values() if take is not None]
    pictures = queries.pictures(session, table.project.studio_id, {take.master_sha256 for take in takes})
    runs = queries.current_runs(session, {take.id for take in table.takes if take.state is not TakeState.SET_ASIDE})
    waived = queries.waived_takes(session, project_id)
    rounds = queries.rounds_by_cue(session, project_id)
    spec_id = current_spec(session, project_id).id
    return schemas.ListStanding(
        cues=[
            _standing(table, cue, shown[cue.id], pictures, runs, waived, rounds.get(cue.id, 0), spec_id)
            for cue in table.cues
        ],
        counts=table.counts,
        files_to_review=sum(take.state is TakeState.CONFORMING for take in table.takes if take.cue_id),
    )


def _standing(
    table: ListOnTable,
    cue: Cue,
    take: Take | None,
    pictures: dict[str, Picture],
    runs: dict[UUID, CheckRun],
    waived: set[UUID],
    rounds: int,
    spec_id: UUID,
) -> schemas.Standing:
    variations = table.variations[cue.id]
    takes = table.by_cue[cue.id]
    waiting = Counter(each.variation for each in takes if each.state is TakeState.CONFORMING)
    standing_takes = [each for each in takes if each.state not in (TakeState.SET_ASIDE, TakeState.CHANGE_REQUESTED)]
    findings = [
        worst for each in standing_takes if table.status[cue.id] is not CueStatus.ACCEPTED
        if (worst := _worst(runs.get(each.id)))
    ]  # fmt: skip
    picture = pictures.get(take.master_sha256) if take else None
    approved = [each for each in takes if each.state is TakeState.APPROVED]
    return schemas.Standing(
        cue_id=cue.id,
        status=table.status[cue.id],
        since=max((each.state_since for each in takes), default=cue.cut_at),
        accepted=sum(status is CueStatus.ACCEPTED for status in variations),
        wanted=cue.variations,
        alternates=max(waiting.values(), default=0),
        versions=max((each.number or 0 for each in takes), default=0),
        rounds=rounds,
        variations=[
            schemas.VariationStanding(variation=stem.variation, stem=stem.stem, status=variations[stem.variation - 1])
            for stem in sorted(cue.stems, key=lambda each: each.variation)
        ],
        newest_take=_newest(take, picture) if take else None,
        worst_finding=min(findings, key=lambda finding: finding.get("severity") != "error", default=None),
        open_question=table.open_questions[cue.id][0] if table.open_questions[cue.id] else None,
        waived=any(each.id in waived for each in takes if each.state in (TakeState.CONFORMING, TakeState.APPROVED)),
        not_to_spec=any(each.id in runs and runs[each.id].spec_id != spec_id for each in approved),
    )


def _newest(take: Take, picture: Picture | None) -> schemas.NewestTake:
    return schemas.NewestTake(
        id=take.id,
        number=take.number or 0,
        variation=take.variation,
        state=take.state,
        file_name=take.file_name,
        received_at=take.received_at,
        duration_s=picture.duration_s if picture else None,
        thumb=picture.thumb if picture else None,
        preview_url=_preview_url(picture),
    )


def today(session: Session, actor: Actor, project_id: UUID) -> schemas.Today:
    """Return what waits for the team today, beside the review queue."""
    standing = standing_in(session, actor, project_id)
    standing.ensure_team()
    table = ListOnTable(session, standing)
    cues = {cue.id: cue for cue in table.cues}
    names = queries.people(session, {take.designer_id for take in table.takes})
    return schemas.Today(
        questions=_questions(session, table.project, only_open=True),
        with_others=_with_others(table, cues, names),
        builds=[_build(build) for build in queries.builds(session, project_id)],
        counts=table.counts,
        draft_changes=queries.draft_changes(session, project_id),
        placeholders=sum(cue.placeholder and cue.cut_at is None for cue in table.cues),
        unsent_mails=queries.unsent_mails(session, table.project.studio_id) if standing.is_producer else 0,
    )


def _with_others(table: ListOnTable, cues: dict[UUID, Cue], names: dict[UUID, Person]) -> list[schemas.WithOthers]:
    waiting: list[schemas.WithOthers] = []
    for take in table.takes:
        cue = cues.get(take.cue_id) if take.cue_id else None
        is_newest = cue is None or take is table.by_cue[cue.id][-1]
        if cue is None:
            status: Any = "unmatched"
        elif take.state in (TakeState.RETURNED, TakeState.CHANGE_REQUESTED, TakeState.UNJUDGED):
            status = take.state.value
        else:
            continue
        if not is_newest or (cue is not None and table.status[cue.id] in (CueStatus.ACCEPTED, CueStatus.CUT)):
            continue
        waiting.append(
            schemas.WithOthers(
                cue=_brief(table.project, cue) if cue else None,
                file_name=take.file_name,
                status=status,
                who=names[take.designer_id].name,
                since=take.state_since,
            )
        )
    return sorted(waiting, key=lambda each: each.since)


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
    table = ListOnTable(session, own)
    cues = {cue.id: cue for cue in table.cues}
    spec = audio_checks.parse_spec(current_spec(session, project_id).toml)
    with_approver = [cue for cue in table.cues if table.status[cue.id] is CueStatus.TO_REVIEW]
    return schemas.Desk(
        came_back=_came_back(session, table, cues, spec),
        to_make=[_to_make(table, cue) for cue in table.cues if table.status[cue.id] in UNFINISHED],
        with_approver=[_brief(table.project, cue) for cue in with_approver],
        with_approver_files=sum(take.state is TakeState.CONFORMING for take in table.takes if take.cue_id),
        accepted=sum(status is CueStatus.ACCEPTED for status in table.status.values()),
        cues=sum(status is not CueStatus.CUT for status in table.status.values()),
        unmatched=sum(take.cue_id is None for take in table.takes),
        checking=sum(take.state is TakeState.RECEIVED for take in table.takes if take.cue_id),
        questions=_questions(session, table.project, only_open=False, asked_by=actor.person),
    )


def _to_make(table: ListOnTable, cue: Cue) -> schemas.ToMake:
    missing = sum(status is CueStatus.TO_MAKE for status in table.variations[cue.id])
    return schemas.ToMake(
        cue=_brief(table.project, cue),
        use=cue.use,
        category=cue.category,
        duration_s=cue.duration_s,
        loop=cue.loop,
        variations=cue.variations,
        missing=missing,
        state=cue.state,
        status=table.status[cue.id],
    )


def _came_back(
    session: Session, table: ListOnTable, cues: dict[UUID, Cue], spec: audio_checks.DeliverySpec
) -> list[schemas.CameBack]:
    back = [take for take in table.takes if _is_with_designer(table, take)]
    pictures = queries.pictures(session, table.project.studio_id, {take.master_sha256 for take in back})
    runs = queries.current_runs(session, {take.id for take in back})
    changes: dict[UUID, list[dict[str, Any]]] = defaultdict(list)
    rounds: dict[UUID, int | None] = {}
    for change, number in queries.sent_changes(session, {take.id for take in back}):
        changes[change.take_id].append({"text": change.text, "start_s": change.start_s, "end_s": change.end_s})
        rounds[change.take_id] = number
    return [
        schemas.CameBack(
            take_id=take.id,
            cue=_brief(table.project, cues[take.cue_id]) if take.cue_id else None,
            number=take.number,
            variation=take.variation,
            file_name=take.file_name,
            status=take.state.value,
            since=take.state_since,
            duration_s=picture.duration_s if (picture := pictures.get(take.master_sha256)) else None,
            thumb=picture.thumb if picture else None,
            preview_url=_preview_url(picture),
            peaks_url=_peaks_url(picture),
            findings=runs[take.id].report.get("findings", []) if take.id in runs else [],
            changes=changes[take.id],
            round=rounds.get(take.id),
            limit_dbfs=_peak_limit(spec, cues[take.cue_id].category if take.cue_id else None),
        )
        for take in sorted(back, key=lambda each: each.state_since)
    ]


def _is_with_designer(table: ListOnTable, take: Take) -> bool:
    if take.state not in (TakeState.RETURNED, TakeState.CHANGE_REQUESTED, TakeState.UNJUDGED):
        return False
    if take.cue_id is None:
        return False
    if table.status[take.cue_id] in (CueStatus.ACCEPTED, CueStatus.CUT):
        return False
    later = (each.number or 0 for each in table.by_cue[take.cue_id] if each.variation == take.variation)
    return max(later) == take.number


def _peak_limit(spec: audio_checks.DeliverySpec, category: str | None) -> float | None:
    known = category if category in spec.categories else None
    return spec.for_category(known).limits.sample_peak_dbfs


def overview(session: Session, actor: Actor, project_id: UUID) -> schemas.Overview:
    """Return a project at one glance."""
    standing = standing_in(session, actor, project_id)
    table = ListOnTable(session, standing)
    project = table.project
    palette = [(cue, take) for cue in table.cues if cue.palette and (take := table.shown_take(cue))]
    pictures = queries.pictures(session, project.studio_id, {take.master_sha256 for _, take in palette})
    runs = queries.current_runs(session, {take.id for _, take in palette})
    builds = queries.builds(session, project_id) if standing.is_team else []
    return schemas.Overview(
        steps=[
            schemas.Step(cue=_brief(project, cue), palette=cue.palette, status=table.status[cue.id])
            for cue in table.cues
        ],
        counts=table.counts,
        builds=[_build(build) for build in builds],
        palette=[
            schemas.PaletteSound(
                cue=_brief(project, cue),
                loop=cue.loop,
                thumb=picture.thumb if (picture := pictures.get(take.master_sha256)) else None,
                preview_url=_preview_url(picture),
                loudness_lufs=_loudness(runs.get(take.id)),
            )
            for cue, take in palette
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
        worst = _worst(run)
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
