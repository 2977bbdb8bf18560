"""A designer's desk: what came back, what is to be made, what waits for the approver; each list in pages."""

from collections import defaultdict
from collections.abc import Sequence
from typing import Any
from uuid import UUID

from sqlalchemy import ColumnElement
from sqlalchemy.orm import Session

import audio_checks
from app.accounts.rules import Actor
from app.agreements.deemed_acceptance.cues import last_days
from app.core.web.http import Page, cursor_of, instant_cursor, place_cursor
from app.dashboards import queries, schemas
from app.dashboards.desk import queries as desk_queries
from app.dashboards.progress import queries as progress_queries
from app.dashboards.progress.queries import CueGroup, ListRow
from app.dashboards.progress.service import counted, preview_url, status_of
from app.dashboards.rules import CAME_BACK, UNFINISHED, CueStatus, statuses_of
from app.dashboards.steps.questions import asked_questions, brief
from app.deliveries.models import Take
from app.deliveries.queries import unmatched_count
from app.deliveries.rules import TakeState
from app.projects.models import Project
from app.projects.queries import current_spec
from app.projects.service import project_access
from app.reviews.queue.service import comment_read
from app.reviews.schemas import CommentRead
from app.sound_lists.models import Cue

WAITING = frozenset({CueStatus.TO_REVIEW})
BACK_CUES = 20  # of which takes that came back are answered at once, each with its findings
CUES = 50
FIRST_STRETCH, STRETCH = 100, 400  # of the list, read at once


class Desk:
    """The desk of one designer in one project, as they themselves see it."""

    def __init__(self, session: Session, actor: Actor, project_id: UUID) -> None:
        access = project_access(session, actor, project_id)
        access.ensure_designer()
        self._session = session
        self._project: Project = access.project
        self._designer_id = actor.person
        self._counted: list[CueGroup] | None = None

    def read(self) -> schemas.Desk:
        """Return the desk's contents: the number of everything, and the first page of each list."""
        session, project_id, designer_id = self._session, self._project.id, self._designer_id
        counts = counted(self._likes())
        takes = desk_queries.waiting_counts(session, project_id, designer_id)
        back, to_make, waiting = self.came_back(None), self.to_make(None), self.with_approver(None)
        asked = queries.own_questions(session, project_id, designer_id)
        return schemas.Desk(
            came_back=back.items,
            came_back_next=back.next,
            came_back_cues=sum(counts.get(status, 0) for status in CAME_BACK),
            to_make=to_make.items,
            to_make_next=to_make.next,
            to_make_cues=sum(counts.get(status, 0) for status in UNFINISHED),
            with_approver=waiting.items,
            with_approver_next=waiting.next,
            with_approver_cues=counts.get(CueStatus.TO_REVIEW, 0),
            with_approver_files=takes.get(TakeState.CONFORMING, 0),
            accepted=counts.get(CueStatus.ACCEPTED, 0),
            cues=sum(counts.values()) - counts.get(CueStatus.CUT, 0),
            unmatched=unmatched_count(session, project_id, designer_id),
            checking=takes.get(TakeState.RECEIVED, 0),
            questions=asked_questions(self._project, asked),
        )

    def _likes(self) -> list[CueGroup]:
        if self._counted is None:
            self._counted = progress_queries.cue_groups(self._session, self._project.id, self._designer_id)
        return self._counted

    def came_back(self, cursor: str | None) -> Page[schemas.CameBack]:
        """Return the takes that are with the designer again, by cue, those that wait longest first."""
        cues = desk_queries.back_cues(
            self._session, self._project.id, self._designer_id, after=instant_cursor(cursor), limit=BACK_CUES + 1
        )
        page = cues[:BACK_CUES]
        open_cue_ids = [cue.id for cue in page if not _is_accepted(cue.facts, cue.variations)]
        return Page(
            items=self._takes_back(open_cue_ids),
            next=cursor_of(page[-1].since.isoformat(), page[-1].id) if len(cues) > BACK_CUES else None,
        )

    def to_make(self, cursor: str | None) -> Page[schemas.ToMake]:
        """Return the cues that wait for a file, in list order."""
        rows, following = self._walked(cursor, UNFINISHED)
        cues = desk_queries.cues_by_id(self._session, [row.id for row in rows])
        return Page(items=[_to_make(self._project, cues[row.id], row) for row in rows], next=following)

    def with_approver(self, cursor: str | None) -> Page[schemas.WithApprover]:
        """Return the cues that wait for their verdict, in list order."""
        facts = {like.facts for like in self._likes() if status_of(like) in WAITING and like.facts is not None}
        waits = desk_queries.has_facts(self._project.id, self._designer_id, facts)
        rows, following = self._walked(cursor, WAITING, waits)
        last = last_days(self._session, [row.id for row in rows])
        items = [
            schemas.WithApprover(
                **brief(self._project, row).model_dump(),
                accepted_after=days.day if (days := last.get(row.id)) else None,
                silence_paused_by=days.paused_by if days else None,
            )
            for row in rows
        ]
        return Page(items=items, next=following)

    def _walked(
        self, cursor: str | None, statuses: frozenset[CueStatus], only: ColumnElement[bool] | None = None
    ) -> tuple[list[ListRow], str | None]:
        """Walk the list from a place in it until a page of cues is found that stand so."""
        walked: list[ListRow] = []
        after, limit = place_cursor(cursor), FIRST_STRETCH
        while len(walked) <= CUES:
            stretch = progress_queries.list_rows(
                self._session, self._project.id, self._designer_id, after=after, limit=limit, only=only
            )
            walked += [row for row in stretch if status_of(row) in statuses]
            if len(stretch) < limit:
                break
            after, limit = (stretch[-1].position, stretch[-1].number), STRETCH
        page = walked[:CUES]
        return page, cursor_of(page[-1].position, page[-1].number) if len(walked) > CUES else None

    def _takes_back(self, cue_ids: Sequence[UUID]) -> list[schemas.CameBack]:
        session, project = self._session, self._project
        of_cues: dict[UUID | None, list[tuple[Take, Cue]]] = defaultdict(list)
        for take, cue in desk_queries.takes_back(session, cue_ids, self._designer_id):
            of_cues[cue.id].append((take, cue))
        back = [of_cue for cue_id in cue_ids for of_cue in of_cues[cue_id]]
        ids = [take.id for take, _ in back]
        pictures = progress_queries.pictures(session, project.studio_id, [take.master_sha256 for take, _ in back])
        runs = queries.current_runs(session, ids)
        changes: dict[UUID, list[dict[str, Any]]] = defaultdict(list)
        rounds: dict[UUID, int | None] = {}
        for change, number in queries.sent_changes(session, ids):
            changes[change.take_id].append(
                {"id": str(change.id), "text": change.text, "start_s": change.start_s, "end_s": change.end_s}
            )
            rounds[change.take_id] = number
        comments_by_take: dict[UUID, list[CommentRead]] = defaultdict(list)
        for comment in queries.comments_of_takes(session, ids):
            comments_by_take[comment.take_id].append(comment_read(comment))
        spec = audio_checks.parse_spec(current_spec(session, project.id).toml)
        return [
            schemas.CameBack(
                take_id=take.id,
                cue=brief(project, cue),
                number=take.number,
                variation=take.variation,
                file_name=take.file_name,
                status=take.state.value,
                since=take.state_since,
                duration_s=picture.duration_s if (picture := pictures.get(take.master_sha256)) else None,
                thumb=picture.thumb if picture else None,
                preview_url=preview_url(picture.id if picture else None),
                peaks_url=f"/v1/sounds/{picture.id}/peaks.json" if picture else None,
                findings=runs[take.id].report.get("findings", []) if take.id in runs else [],
                changes=changes[take.id],
                comments=comments_by_take[take.id],
                round=rounds.get(take.id),
                limit_dbfs=_peak_limit(spec, cue.category),
            )
            for take, cue in back
        ]


def _is_accepted(facts: str, variations: int) -> bool:
    return all(status is CueStatus.ACCEPTED for status in statuses_of(facts, variations))


def _to_make(project: Project, cue: Cue, row: ListRow) -> schemas.ToMake:
    return schemas.ToMake(
        cue=brief(project, row),
        use=cue.use,
        category=cue.category,
        duration_s=cue.duration_s,
        duration_min_s=cue.duration_min_s,
        duration_max_s=cue.duration_max_s,
        loop=cue.loop,
        variations=cue.variations,
        missing=sum(status is CueStatus.TO_MAKE for status in statuses_of(row.facts, row.variations)),
        state=cue.state,
        status=status_of(row),
    )


def _peak_limit(spec: audio_checks.DeliverySpec, category: str | None) -> float | None:
    spec_category = category if category in spec.categories else None
    return spec.for_category(spec_category).limits.sample_peak_dbfs
