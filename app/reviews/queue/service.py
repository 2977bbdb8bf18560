"""The review room: the queue, one cue with everything said of it, the history of a take."""

import re
from collections import ChainMap, defaultdict
from collections.abc import Collection, Iterable, Mapping
from datetime import datetime
from typing import Any
from uuid import UUID

from sqlalchemy import ColumnElement, and_
from sqlalchemy.orm import Session

from app.accounts.queries import people_by_id
from app.accounts.rules import Actor
from app.accounts.schemas import PersonBrief
from app.conformance.schemas import FindingRead
from app.conformance.service import findings_read, resolved_spec
from app.conformance.set_findings import SetFinding, findings_of_sets, with_set_finding
from app.core import clock
from app.core.events import send
from app.core.in_array import in_array
from app.core.web.http import Page, bad_cursor, cursor_of, instant_cursor
from app.deliveries.rules import TakeState, undecided_groups
from app.deliveries.tray.service import open_take_of
from app.projects.approval.service import approval_rights, approval_scope, approval_scopes
from app.projects.errors import TeamNeeded
from app.projects.models import Spec
from app.projects.service import project_access
from app.renders.service import sound_places
from app.reviews import queries
from app.reviews.checklists.schemas import BlockedTake
from app.reviews.checklists.service import cue_checklist
from app.reviews.models import ChangeRequest, Comment, Verdict
from app.reviews.queue import queries as queue_queries
from app.reviews.queue import take_queries
from app.reviews.queue.filter_queries import filtered
from app.reviews.queue.queries import CueOnReview, QueuePlace
from app.reviews.queue.take_queries import TakeOnReview
from app.reviews.rules import EVERYTHING, QueueFilter, missing_variations, queue_kind
from app.reviews.schemas import (
    ChangeRequestRead,
    CommentRead,
    CueReviewRead,
    MentionRead,
    QueueCount,
    QueueItem,
    ReviewCue,
    ReviewRender,
    ReviewTake,
    RoundRead,
    VerdictRead,
)
from app.reviews.signals import LastDay, LastDaysAsked
from app.reviews.verdicts.approval_blocks import blocked_takes
from app.reviews.verdicts.carried_notes import carried_notes
from app.sound_lists.models import Cue
from app.sound_lists.rules import CueState, label
from app.sound_lists.service import visible_cue

PAGE_CUES = 16  # as many lines as a tall screen shows
COUNTED_CUES = 99  # more is shown as "99+"


def review_queue(
    session: Session,
    actor: Actor,
    *,
    project_id: UUID | None,
    is_own: bool,
    wanted: QueueFilter = EVERYTHING,
    cursor: str | None,
) -> Page[QueueItem]:
    """Return the review queue with all that its cards show; `is_own`: only cues that the caller approves."""
    reach = _wanted(_reach(session, actor, project_id, is_own=is_own), wanted, actor.person)
    waiting = queue_queries.queued_cues(
        session, reach, clock.now().date(), after=_place_of(cursor), limit=PAGE_CUES + 1
    )
    shown = [cue for _, cue in waiting[:PAGE_CUES]]
    urgent = {queue_place.cue_id for queue_place, _ in waiting if queue_place.is_urgent}
    by_cue: dict[UUID, list[TakeOnReview]] = defaultdict(list)
    cues: list[Cue] = []
    take_ids = [take_id for cue in shown for take_id in cue.take_ids]
    for take in take_queries.takes_on_review(session, actor.person, take_ids):
        if take.take.cue is not None:
            by_cue[take.take.cue.id].append(take)
            cues.append(take.take.cue)
    facts = queue_queries.cues_on_review(session, by_cue)
    blocked = blocked_takes(session, {cue: [on_review.take for on_review in by_cue[cue.id]] for cue in cues})
    changed = [cue_id for cue_id, of_cue in facts.items() if of_cue.is_changed]
    changes = queue_queries.last_changes(session, changed) if changed else {}
    words = findings_of_sets(session, cues, _specs_of(on_review for takes in by_cue.values() for on_review in takes))
    last = _last_days(session, list(facts))
    items = [
        _queue_item(
            takes,
            cue.since,
            facts[cue.id],
            words,
            is_urgent=cue.id in urgent,
            last_change=changes.get(cue.id),
            last_day=last.get(cue.id),
            blocked=blocked.get(cue.id, []),
        )
        for cue in shown
        if (takes := by_cue.get(cue.id))
    ]
    return Page(items=items, next=_cursor_at(waiting[PAGE_CUES - 1][0]) if len(waiting) > PAGE_CUES else None)


def _last_days(session: Session, cue_ids: Collection[UUID]) -> Mapping[UUID, LastDay]:
    """Return by cue the day after which it is deemed accepted, as higher rooms know."""
    return ChainMap(*send(session, LastDaysAsked(cue_ids)))


def _cursor_at(queue_place: QueuePlace) -> str:
    ranks = "-".join(map(str, (queue_place.urgency, queue_place.need, queue_place.priority)))
    return cursor_of(ranks, queue_place.since.isoformat(), queue_place.cue_id)


def _place_of(cursor: str | None) -> QueuePlace | None:
    if cursor is None:
        return None
    ranks, _, rest = cursor.partition(".")
    read = re.fullmatch(r"([01])-(\d)-(\d{1,4})", ranks, re.ASCII)
    since_and_cue = instant_cursor(rest)
    if read is None or since_and_cue is None:
        raise bad_cursor(cursor)
    return QueuePlace(int(read[1]), int(read[2]), int(read[3]), *since_and_cue)


def _wanted(reach: ColumnElement[bool], queue_filter: QueueFilter, person_id: UUID) -> ColumnElement[bool]:
    return reach if queue_filter == EVERYTHING else and_(reach, filtered(queue_filter, person_id))


def queue_count(
    session: Session, actor: Actor, *, project_id: UUID | None, is_own: bool, wanted: QueueFilter = EVERYTHING
) -> QueueCount:
    """Return the number of cues awaiting review, counted up to a bound so that it costs the same however many do."""
    reach = _wanted(_reach(session, actor, project_id, is_own=is_own), wanted, actor.person)
    waiting = queue_queries.waiting_cues(session, reach, after=None, limit=COUNTED_CUES + 1)
    return QueueCount(cues=min(len(waiting), COUNTED_CUES), is_all=len(waiting) <= COUNTED_CUES)


def _reach(session: Session, actor: Actor, project_id: UUID | None, *, is_own: bool) -> ColumnElement[bool]:
    if project_id is not None:
        access = project_access(session, actor, project_id)
        access.ensure_team()
        if is_own:
            return queue_queries.in_scope(project_id, approval_scope(session, access))
        return queue_queries.in_project(project_id)
    if not actor.roles:
        raise TeamNeeded("only a game team has a review queue")
    return queue_queries.in_scopes(approval_scopes(session, actor)) if is_own else queue_queries.in_studios(actor.roles)


def _queue_item(
    waiting: list[TakeOnReview],
    since: datetime,
    facts: CueOnReview,
    words: dict[UUID, SetFinding],
    *,
    is_urgent: bool,
    last_change: str | None,
    last_day: LastDay | None,
    blocked: list[BlockedTake],
) -> QueueItem:
    cue = waiting[0].take.cue
    if cue is None:
        raise AssertionError("only matched takes wait")
    undecided = _undecided(waiting)
    takes = [review_take(queued, facts.prefix, words, undecided) for queued in waiting]
    findings = [finding for take in takes for finding in take.findings]
    return QueueItem(
        cue=review_cue(cue, facts.prefix),
        kind=queue_kind(cue.variations, [take.variation for take in takes]),
        waiting_since=since,
        is_urgent=is_urgent,
        rounds_so_far=facts.rounds,
        last_change=last_change,
        open_notes=facts.open_requests + facts.open_comments,
        approved_variations=facts.approved,
        accepted_after=last_day.day if last_day else None,
        silence_paused_by=last_day.paused_by if last_day else None,
        findings_count=len(findings),
        worst_finding=min(findings, key=lambda finding: finding.severity != "error", default=None),
        takes=takes,
        blocked=blocked,
    )


def _specs_of(takes: Iterable[TakeOnReview]) -> dict[UUID, Spec]:
    return {take.take.project_id: take.spec for take in takes}


def review_cue(cue: Cue, prefix: str) -> ReviewCue:
    """Return a cue as the review room shows it."""
    facts = {name: getattr(cue, name) for name in ReviewCue.model_fields if name != "label"}
    return ReviewCue(**facts, label=label(prefix, cue.number))


def _undecided(takes: Iterable[TakeOnReview]) -> dict[UUID, list[UUID]]:
    """Return for takes between which nobody chose the others, by take."""
    waiting = [taken.take for taken in takes if taken.take.state is TakeState.CONFORMING]
    groups = undecided_groups(map(open_take_of, waiting))
    return {take.id: [other.id for other in group if other is not take] for group in groups for take in group}


def review_take(
    on_review: TakeOnReview,
    prefix: str,
    words: dict[UUID, SetFinding],
    undecided: Mapping[UUID, list[UUID]] | None = None,
) -> ReviewTake:
    """Return a take with what is needed to play and judge it, and the findings of its set."""
    take, word = on_review.take, words.get(on_review.take.id)
    report = with_set_finding(on_review.report, word.findings if word else ()) if on_review.report else {}
    measurements = report.get("measurements") or {}
    findings = _findings(on_review, report)
    return ReviewTake(
        **sound_places(on_review.picture, on_review.thumb),
        id=take.id,
        variation=take.variation,
        number=take.number or 0,
        alternate=take.alternate,
        label=take.label,
        file_name=take.file_name,
        state=take.state,
        state_since=take.state_since,
        received_at=take.received_at,
        late=take.late,
        note=take.note,
        delivery_number=take.delivery.number,
        delivery_note=take.delivery.note,
        designer=PersonBrief.model_validate(take.delivery.designer),
        facts=report.get("facts") or {},
        loudness_lufs=_first(measurements.get("integrated_lufs"), measurements.get("short_loudness_lufs")),
        away_from_set_lu=word.away_lu if word else None,
        sample_peak_dbfs=measurements.get("sample_peak_dbfs"),
        true_peak_dbtp=measurements.get("true_peak_dbtp"),
        measurements=measurements,
        findings=findings,
        waived=any(finding.waived for finding in findings),
        waiver_reason=on_review.waiver.reason if on_review.waiver else None,
        fix_of_id=take.fix_of_id,
        renders=[
            ReviewRender(
                **sound_places(render.picture if render else None, None),
                id=render.id if render else None,
                target=target,
                state=render.state.value if render else "waiting",
                refusal=render.refusal if render else None,
                attenuation_db=render.attenuation_db if render else None,
                loudness_lufs=_first(render.integrated_lufs, render.short_loudness_lufs) if render else None,
                true_peak_dbtp=render.true_peak_dbtp if render else None,
            )
            for target, render in on_review.renders.items()
        ],
        draft_change=change_request_read(on_review.draft, prefix) if on_review.draft else None,
        open_comments=on_review.open_comments,
        is_heard=on_review.heard_at is not None,
        heard_at=on_review.heard_at,
        undecided_with=(undecided or {}).get(take.id, []),
    )


def _findings(on_review: TakeOnReview, report: dict[str, Any]) -> list[FindingRead]:
    waiver = on_review.waiver
    codes = waiver.codes if waiver and waiver.master_sha256 == on_review.take.master_sha256 else []
    return findings_read(report, resolved_spec(on_review.spec, on_review.take), codes) if report.get("findings") else []


def _first(*figures: float | None) -> float | None:
    return next((figure for figure in figures if figure is not None), None)


def change_request_read(request: ChangeRequest, prefix: str) -> ChangeRequestRead:
    """Return a change request as it is shown; its cue, take, author and sending are loaded."""
    return ChangeRequestRead(
        id=request.id,
        take_id=request.take_id,
        cue_id=request.cue_id,
        cue_label=label(prefix, request.cue.number),
        cue_name=request.cue.name,
        variation=request.take.variation,
        number=request.take.number or 0,
        text=request.text,
        reasons=request.reasons,
        mentions=[MentionRead.model_validate(mention) for mention in request.mentioned],
        start_s=request.start_s,
        end_s=request.end_s,
        reverses=request.feedback_id is None and request.take.state is TakeState.APPROVED,
        written_by=PersonBrief.model_validate(request.author),
        created_at=request.created_at,
        feedback_id=request.feedback_id,
        sends_at=request.sends_at,
        sent_at=request.sending.created_at if request.sending else None,
    )


def comment_read(comment: Comment) -> CommentRead:
    """Return a comment as it is shown; its author and who has seen it are loaded."""
    return CommentRead.model_validate(comment)


def cue_review(session: Session, actor: Actor, cue_id: UUID) -> CueReviewRead:
    """Return everything of one cue that the review room shows."""
    access, cue = visible_cue(session, actor, cue_id)
    access.ensure_team()
    prefix = access.project.cue_prefix
    shown = take_queries.takes_of_cue(session, actor.person, cue.id)
    words = findings_of_sets(session, [cue], _specs_of(shown))
    undecided = _undecided(shown)
    takes = [review_take(on_review, prefix, words, undecided) for on_review in shown]
    ids = [take.id for take in takes]
    approved = queries.approved_variations(session, [cue.id]).get(cue.id, [])
    verdicts = queries.verdicts_on(session, Verdict.cue_id == cue.id)
    rights = approval_rights(session, access.project)
    approver_id, *deputy_ids = rights.people_for(cue.category)
    people = people_by_id(session, {approver_id, *deputy_ids})
    waiting = [take.variation for take in takes if take.state is TakeState.CONFORMING]
    last_day = _last_days(session, [cue.id]).get(cue.id)
    return CueReviewRead(
        cue=review_cue(cue, prefix),
        kind=queue_kind(cue.variations, waiting),
        accepted=cue.state is not CueState.CUT and not missing_variations(cue.variations, approved),
        approved_variations=approved,
        accepted_after=last_day.day if last_day else None,
        silence_paused_by=last_day.paused_by if last_day else None,
        approver=PersonBrief.model_validate(people[approver_id]),
        deputies=[PersonBrief.model_validate(people[deputy_id_]) for deputy_id_ in deputy_ids],
        may_approve=actor.person in (approver_id, *deputy_ids),
        on_behalf_of=PersonBrief.model_validate(people[approver_id]) if actor.person in deputy_ids else None,
        takes=takes,
        comments=[comment_read(comment) for comment in queries.comments_on(session, in_array(Comment.take_id, ids))],
        verdicts=list(_verdicts_read(verdicts)),
        change_requests=[
            change_request_read(change_request, prefix)
            for change_request in queries.change_requests_of(session, ChangeRequest.cue_id == cue.id)
        ],
        carried_notes=carried_notes(session, cue.id),
        checklist=cue_checklist(session, cue, takes),
        rounds=[RoundRead.model_validate(round_) for round_ in queries.rounds_of(session, cue.id)],
    )


def _verdicts_read(verdicts: Iterable[Verdict]) -> Iterable[VerdictRead]:
    verdicts = list(verdicts)
    withdrawn = {given_verdict.withdraws_id for given_verdict in verdicts if given_verdict.withdraws_id}
    for verdict in verdicts:
        yield VerdictRead(
            id=verdict.id,
            take_id=verdict.take_id,
            kind=verdict.kind,
            note=verdict.note,
            reasons=verdict.reasons,
            given_by=PersonBrief.model_validate(verdict.author) if verdict.author else None,
            on_behalf_of=PersonBrief.model_validate(verdict.represented) if verdict.represented else None,
            created_at=verdict.created_at,
            by_deemed_acceptance=verdict.deemed_by_contract_id is not None,
            by_adoption=verdict.adoption_id is not None,
            without_listening=verdict.without_listening,
            withdrawn=verdict.id in withdrawn,
        )
