"""The progress of cues: a page of the list in detail, the whole list with one word for each cue."""

from collections import Counter, defaultdict
from collections.abc import Sequence
from datetime import timedelta
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.conformance.models import CheckRun
from app.conformance.set_findings import findings_of_sets
from app.core import clock
from app.dashboards import schemas
from app.dashboards.progress import queries as progress_queries
from app.dashboards.progress.queries import CueGroup, ListRow, NeedGroup, ShownTake
from app.dashboards.rules import CueStatus, cue_status, statuses_of, variation_status
from app.deliveries.cue_counts.rules import VariationFact
from app.deliveries.schemas import CueBrief
from app.projects.queries import current_spec
from app.projects.service import ProjectAccess, project_access
from app.renders.thumb_queries import thumbs
from app.sound_lists.models import Cue
from app.sound_lists.queries import stems_by_cue
from app.sound_lists.rules import CueState, Need, label
from app.sound_lists.service import page_of

LATELY = timedelta(days=7)
JUDGED = 6
Finding = dict[str, Any]


def viewer_of(access: ProjectAccess) -> UUID:
    """Return the owner of the sums that the caller sees: a designer's own, else the studio's."""
    return access.only_designer_id or access.project.studio_id


def status_of(row: ListRow | CueGroup) -> CueStatus:
    """Return the one word for a cue, or for cues that are alike."""
    variations = statuses_of(row.facts, row.variations)
    return cue_status(row.state, variations, is_asked=row.is_asked, placeholder=row.placeholder)


def counted(likes: Sequence[CueGroup]) -> dict[CueStatus, int]:
    """Return the number of cues for each state."""
    counts: Counter[CueStatus] = Counter()
    for like in likes:
        counts[status_of(like)] += like.cues
    return dict(counts)


def completion(groups: Sequence[NeedGroup]) -> list[schemas.NeedCompletion]:
    """Return the number of accepted cues of each need, the most needed first; a need without cues is left out."""
    cues: Counter[Need] = Counter()
    accepted: Counter[Need] = Counter()
    for group in groups:
        cues[group.need] += group.cues
        if all(status is CueStatus.ACCEPTED for status in statuses_of(group.facts, group.variations)):
            accepted[group.need] += group.cues
    return [schemas.NeedCompletion(need=need, accepted=accepted[need], cues=cues[need]) for need in Need if cues[need]]


def list_counts(session: Session, actor: Actor, project_id: UUID) -> schemas.ListCounts:
    """Return the number of cues of the list in each state."""
    access = project_access(session, actor, project_id)
    return schemas.ListCounts(
        counts=counted(progress_queries.cue_groups(session, project_id, viewer_of(access))),
        files_to_review=progress_queries.waiting_files(session, project_id, access.only_designer_id),
    )


def list_progress(
    session: Session, actor: Actor, project_id: UUID, *, cursor: str | None, limit: int
) -> schemas.ListProgress:
    """Return the states of the cues of one page of the list."""
    access = project_access(session, actor, project_id)
    cues, following = page_of(session, project_id, "list", cursor=cursor, limit=limit)
    page = _Page(session, access, cues)
    return schemas.ListProgress(cues=[page.progress_of(cue) for cue in cues], next=following)


def recent_verdicts(session: Session, actor: Actor, project_id: UUID) -> list[schemas.RecentVerdict]:
    """Return the cues that were decided upon within a week and stand as decided, the newest first."""
    access = project_access(session, actor, project_id)
    access.ensure_team()
    decided = progress_queries.decided_cues(session, project_id, since=clock.now() - LATELY)
    status = Statuses(session, access, [cue for cue, _ in decided]).status
    return [
        schemas.RecentVerdict(
            cue=CueBrief(id=cue.id, label=label(access.project.cue_prefix, cue.number), name=cue.name),
            status=status[cue.id],
            since=since,
        )
        for cue, since in decided
        if status[cue.id] in (CueStatus.ACCEPTED, CueStatus.CHANGE_REQUESTED)
    ][:JUDGED]


class Statuses:
    """The one word for each of a few cues, as the caller sees their takes."""

    def __init__(self, session: Session, access: ProjectAccess, cues: Sequence[Cue]) -> None:
        self._ids = [cue.id for cue in cues]
        self._designer_id = access.only_designer_id
        self._facts: dict[UUID, dict[int, progress_queries.VariationRow]] = defaultdict(dict)
        for row in progress_queries.variation_rows(session, self._ids, self._designer_id):
            self._facts[row.cue_id][row.variation] = row
        self._questions = progress_queries.first_open_questions(session, access.project.id, self._ids)
        self._variations = {cue.id: self._variations_of(cue) for cue in cues}
        self.status = {cue.id: self._status_of(cue) for cue in cues}

    def _variations_of(self, cue: Cue) -> list[CueStatus]:
        facts = self._facts[cue.id]
        return [
            variation_status(VariationFact.unpacked(facts[variation].packed if variation in facts else 0))
            for variation in range(1, cue.variations + 1)
        ]

    def _status_of(self, cue: Cue) -> CueStatus:
        is_asked = cue.id in self._questions
        return cue_status(cue.state, self._variations[cue.id], is_asked=is_asked, placeholder=cue.placeholder)


class _Page(Statuses):
    """Everything that a row of the list shows of its cue's takes; each kind of fact is read once for the page."""

    def __init__(self, session: Session, access: ProjectAccess, cues: Sequence[Cue]) -> None:
        super().__init__(session, access, cues)
        ids, designer_id, project = self._ids, self._designer_id, access.project
        accepted = {id_ for id_ in ids if self.status[id_] is CueStatus.ACCEPTED}
        self._shown = progress_queries.shown_takes(session, ids, viewer_of(access), designer_id, accepted=accepted)
        self._thumbs = thumbs(session, [take.picture_id for take in self._shown.values() if take.picture_id])
        undecided = [id_ for id_ in ids if id_ not in accepted]
        self._findings = progress_queries.current_findings(session, undecided, designer_id)
        spec = current_spec(session, project.id)
        sets = [cue for cue in cues if cue.id not in accepted]
        self._of_sets: dict[UUID, list[Finding]] = defaultdict(list)
        for word in findings_of_sets(session, sets, {project.id: spec}, designer_id=designer_id).values():
            self._of_sets[word.cue_id] += word.findings
        self._review_facts = progress_queries.review_facts_of_cues(session, ids, designer_id, spec.id)
        self._stems = stems_by_cue(session, ids)
        self._unheard: dict[UUID, list[UUID]] = {}  # of designers nothing is recorded
        if access.is_team:
            live = [cue.id for cue in cues if cue.state is not CueState.CUT]
            self._unheard = progress_queries.unheard_takes(session, access.actor.person, live)

    def progress_of(self, cue: Cue) -> schemas.CueProgress:
        """Return the state of one cue of the page."""
        facts, variations = self._facts[cue.id].values(), self._variations[cue.id]
        take, review = self._shown.get(cue.id), self._review_facts[cue.id]
        return schemas.CueProgress(
            cue_id=cue.id,
            status=self.status[cue.id],
            since=max((row.since for row in facts), default=cue.cut_at),
            accepted=sum(status is CueStatus.ACCEPTED for status in variations),
            wanted=cue.variations,
            alternates=max((row.waiting for row in facts), default=0),
            versions=max((row.newest for row in facts), default=0),
            rounds=review.rounds,
            variations=[
                schemas.VariationProgress(variation=variation, stem=stem, status=variations[variation - 1])
                for variation, stem in self._stems[cue.id]
            ],
            newest_take=self._newest_take(take) if take else None,
            worst_finding=worst_of([*self._of_sets[cue.id], *self._findings.get(cue.id, [])]),
            open_question=self._questions.get(cue.id),
            waived=review.is_waived,
            not_to_spec=review.is_elsewhere,
            unheard_take_ids=self._unheard.get(cue.id, []),
        )

    def _newest_take(self, take: ShownTake) -> schemas.NewestTake:
        return schemas.NewestTake(
            id=take.id,
            number=take.number or 0,
            variation=take.variation,
            state=take.state,
            file_name=take.file_name,
            received_at=take.received_at,
            duration_s=take.duration_s,
            thumb=self._thumbs.get(take.picture_id) if take.picture_id else None,
            preview_url=preview_url(take.picture_id),
        )


def preview_url(picture_id: UUID | None) -> str | None:
    """Return the address of a sound's preview."""
    return f"/v1/sounds/{picture_id}/preview" if picture_id else None


def worst_of(findings: Sequence[Finding]) -> Finding | None:
    """Return the finding that a row shows: the first error, else the first."""
    return min(findings, key=lambda finding: finding.get("severity") != "error", default=None)


def worst_in(run: CheckRun | None) -> Finding | None:
    """Return the finding of one check that a line shows."""
    return worst_of(run.report.get("findings", []) if run else [])
