"""The verdict: what a check needs to know, and what its report makes of a take."""

from collections.abc import Collection
from dataclasses import dataclass, replace
from uuid import UUID

from sqlalchemy import event
from sqlalchemy.orm import Session

import audio_checks
from app.accounts.rules import Actor
from app.accounts.schemas import PersonBrief
from app.conformance import queries
from app.conformance.errors import CheckNotFound, NothingToWaive
from app.conformance.models import CheckRun, Waiver
from app.conformance.queries import ToCheck
from app.conformance.rules import (
    Report,
    asked_of,
    awaits_check,
    error_codes,
    fix_offers,
    has_failed_comparison,
    parsed_spec,
    run_key,
    state_after,
    with_offers,
    with_waived,
)
from app.conformance.schemas import CheckRead, ComparedStemRead, FindingRead, WaiverRead
from app.conformance.set_findings import findings_of_sets, same_sounds, with_set_finding
from app.core import clock
from app.core.events import publish
from app.core.jobs.queue import BULK
from app.deliveries import queries as deliveries
from app.deliveries.models import Take
from app.deliveries.rules import CHECKABLE, TakeState, base_name, shown_name
from app.deliveries.service import name_checked, take_for
from app.deliveries.take_states import change_state, note_take, start_recheck
from app.projects.approval.service import ensure_may_approve
from app.projects.models import Spec
from app.projects.queries import current_spec
from app.sound_lists.models import Cue
from app.sound_lists.service import cue_facts

NOTIFY_EVERY_S = 5.0
COMMITTED_WITHIN_S = 1.0  # a check that commits later is notified with the next ones, or by the periodic job
_asked_for: dict[UUID, int] = {}  # by project: the last window with a notification that this process committed


@dataclass(frozen=True)
class TakeBefore:
    """An earlier take of the same sound, for comparison."""

    take_id: UUID
    number: int
    master_sha256: str


@dataclass(frozen=True)
class ComparedStem:
    """The dry stem that a take is compared with."""

    name: str
    sha256: str
    file_bytes: int


@dataclass(frozen=True)
class CheckOrder:
    """All that a check of one take needs to know, as of one moment."""

    take_id: UUID
    delivery_id: UUID
    edition: int
    studio_id: UUID
    master_sha256: str
    master_bytes: int
    name: str
    spec_id: UUID
    spec: audio_checks.DeliverySpec
    cue: audio_checks.CueFacts | None
    before: TakeBefore | None
    stem: ComparedStem | None
    shipped: bool  # adopted as the game ships it, so that a codec may keep it
    key: str


def order_check(session: Session, to_check: ToCheck) -> CheckOrder:
    """Return the order for a take's check."""
    take, spec, stem_named, has_dry_stems = to_check
    cue = cue_facts(take.cue) if take.cue else None
    resolved = resolved_spec(spec, take)
    name = name_checked(take, stem_named)
    stem = deliveries.dry_stem_of(session, take) if has_dry_stems else None
    shipped = take.state is TakeState.APPROVED
    return CheckOrder(
        take_id=take.id,
        delivery_id=take.delivery_id,
        edition=take.edition,
        studio_id=take.studio_id,
        master_sha256=take.master_sha256,
        master_bytes=take.master_bytes,
        name=name,
        spec_id=spec.id,
        spec=resolved,
        cue=cue,
        before=_before(session, take),
        stem=ComparedStem(shown_name(base_name(stem.file_name)), stem.sha256, stem.file_bytes) if stem else None,
        shipped=shipped,
        key=run_key(take.master_sha256, resolved, cue, name, stem.sha256 if stem else None, shipped=shipped),
    )


def _before(session: Session, take: Take) -> TakeBefore | None:
    before = queries.take_before(session, take)
    if before is None or before.number is None or before.master_sha256 == take.master_sha256:
        return None
    return TakeBefore(before.id, before.number, before.master_sha256)


def resolved_spec(spec: Spec, take: Take) -> audio_checks.DeliverySpec:
    """Return the demands of a version of the spec on one take."""
    return spec_for(parsed_spec(spec.toml), take.cue, take.file_name)


def spec_for(whole: audio_checks.DeliverySpec, cue: Cue | None, file_name: str) -> audio_checks.DeliverySpec:
    """Return a spec's demands on a file that is for a cue, or for none yet."""
    resolved = whole.for_category((cue.category if cue else "") or whole.category_of(file_name))
    if cue is None:  # it is named for its cue once it is matched
        return replace(resolved, checks=resolved.checks | {"naming": "off"})
    return resolved


def known_report(session: Session, order: CheckOrder) -> Report | None:
    """Return the report of an earlier check with the same key."""
    run = queries.run_with_key(session, order.studio_id, order.key)
    return run.report if run and not has_failed_comparison(run.report) else None


def record_check(session: Session, order: CheckOrder, report: Report) -> TakeState | None:
    """Write a report and what it makes of its take, and return that; None, and nothing, where the take moved on.

    An adopted take stays approved, whatever the report says.
    """
    take, was_checked = queries.take_to_judge(session, order.take_id) or (None, False)
    if take is None or take.edition != order.edition or not awaits_check(take.state, is_checked=was_checked):
        return None
    is_adopted = take.state is TakeState.APPROVED
    if was_checked:
        queries.retire_runs(session, take.id)
    session.add(
        CheckRun(
            studio_id=take.studio_id,
            project_id=take.project_id,
            take_id=take.id,
            spec_id=order.spec_id,
            key=order.key,
            verdict=report["verdict"],
            pcm_sha256=report["pcm_sha256"],
            report=report,
            tool_version=audio_checks.TOOL_VERSION,
            needs_notification=not is_adopted,
        )
    )
    if is_adopted:
        return take.state
    waived = _codes_waived(session, take) if report["verdict"] == "rejected" else []
    was_returned = take.returned_since is not None
    change_state(session, take, state_after(report, waived))
    if (take.returned_since is not None) != was_returned:  # the clock of deemed acceptance pauses, or continues
        kind = "conforms_again" if was_returned else "returned"
        version = queries.spec_version_of(session, order.spec_id)
        facts = {"spec_version": version, "verdict": report["verdict"]}
        note_take(session, take, kind, facts, by=take.rechecked_by)
    schedule_notification(session, take)
    if take.state is TakeState.RETURNED:
        publish(session, "take.returned", studio_id=take.studio_id, take_id=take.id)
    elif take.state is TakeState.CONFORMING and take.cue_id is not None:
        publish(session, "take.in_review", studio_id=take.studio_id, take_id=take.id)
    return take.state


def schedule_notification(session: Session, take: Take) -> None:
    """Schedule one notification for all checks of a project in the same few seconds."""
    now_s = clock.now().timestamp()
    window = int(now_s // NOTIFY_EVERY_S)
    if _asked_for.get(take.project_id) == window:
        return
    publish(
        session,
        "takes.checked",
        studio_id=take.studio_id,
        delay_s=(window + 1) * NOTIFY_EVERY_S + COMMITTED_WITHIN_S - now_s,
        once=f"{take.project_id}@{window}",
        project_id=take.project_id,
    )
    # The event is certain only after the commit: a rollback removes it.
    event.listen(session, "after_commit", lambda _: _asked_for.update({take.project_id: window}), once=True)


def recheck(session: Session, actor: Actor, take_id: UUID) -> Take:
    """Have a take checked again; a report that would be the same is not computed again."""
    take, _ = take_for(session, actor, take_id, locked=True)
    start_recheck(session, take, by=actor.person)
    return take


def recheck_if_changed(session: Session, take_id: UUID, *, by: UUID | None, priority: int = BULK) -> None:
    """Have a take checked again where spec, list or dry stem, changed by a person, now ask something else of it."""
    take = deliveries.take_by_id(session, take_id, locked=True)
    if take is None or take.state not in CHECKABLE:
        return
    if (to_check := queries.take_to_check(session, take_id)) is None:
        return
    order = order_check(session, to_check)
    run = queries.current_run(session, take.id)
    if take.state is not TakeState.RECEIVED and run is not None and run.key == order.key:
        run.spec_id = order.spec_id  # the new version asks the same of this take
        return
    start_recheck(session, take, by=by, priority=priority)


def waive(session: Session, actor: Actor, take_id: UUID, reason: str) -> CheckRead:
    """Let a returned take through with its findings; only the approver may."""
    take, access = take_for(session, actor, take_id, locked=True)
    for_whom = ensure_may_approve(session, access, take.cue.category if take.cue else "")
    run = queries.current_run(session, take.id)
    if take.state is not TakeState.RETURNED or run is None:
        raise NothingToWaive(f"only a returned version can be waived; this one is {take.state}")
    if run.verdict != "rejected":
        raise NothingToWaive("this file cannot be read, so no game file could be made of it")
    session.add(
        Waiver(
            studio_id=take.studio_id,
            project_id=take.project_id,
            take_id=take.id,
            check_run_id=run.id,
            master_sha256=take.master_sha256,
            codes=error_codes(run.report),
            reason=reason,
            waived_by=actor.person,
        )
    )
    change_state(session, take, TakeState.CONFORMING)
    facts = {"reason": reason, "codes": error_codes(run.report)}
    note_take(session, take, "waived", facts, by=actor.person, on_behalf_of=for_whom)
    publish(session, "take.waived", studio_id=take.studio_id, take_id=take.id)
    return read_check(session, take)


def check_for(session: Session, actor: Actor, take_id: UUID) -> CheckRead:
    """Return the newest check of a take that the caller may see."""
    take, access = take_for(session, actor, take_id)
    return read_check(session, take, designer_id=access.only_designer_id)


def read_check(session: Session, take: Take, *, designer_id: UUID | None = None) -> CheckRead:
    """Return the newest check of a take and the findings of its set, among the takes of one designer if given."""
    run = queries.current_run(session, take.id)
    if run is None:
        raise CheckNotFound("this take has not been checked yet", fix="ask again in a few seconds")
    waiver = queries.waiver_of(session, take.id)
    if waiver is not None and waiver.master_sha256 != take.master_sha256:
        waiver = None
    spec, newest = queries.spec_of(session, run), current_spec(session, take.project_id)
    resolved = resolved_spec(spec, take)
    specs = {take.project_id: newest}
    word = findings_of_sets(session, [take.cue] if take.cue else [], specs, designer_id=designer_id).get(take.id)
    same = same_sounds(session, take, run.pcm_sha256, newest)
    stem = deliveries.dry_stem_of(session, take)
    report = with_set_finding(run.report, word.findings if word else (), same)
    return CheckRead(
        take_id=take.id,
        state=take.state,
        verdict=run.report["verdict"],
        spec_version=spec.version,
        is_newest_spec=spec.id == newest.id
        or asked_of(resolved_spec(spec, take)) == asked_of(resolved_spec(newest, take)),
        tool_version=run.tool_version,
        created_at=run.created_at,
        facts=run.report["facts"],
        measurements=run.report["measurements"],
        judgements=run.report["judgements"],
        dry_stem=ComparedStemRead.model_validate(stem) if stem else None,
        is_newest_stem=run.report.get("stem_sha256") == (stem.sha256 if stem else None),
        findings=findings_read(report, resolved, waiver.codes if waiver else []),
        waiver=waiver and _waiver_read(waiver),
    )


def findings_read(report: Report, spec: audio_checks.DeliverySpec, codes_waived: Collection[str]) -> list[FindingRead]:
    """Return a report's findings as they are shown: whether they were let through, and what a fix does about each."""
    findings = with_waived(report["findings"], codes_waived)
    return [FindingRead.model_validate(with_offer) for with_offer in with_offers(findings, fix_offers(report, spec))]


def _waiver_read(waiver: Waiver) -> WaiverRead:
    return WaiverRead(
        id=waiver.id,
        codes=waiver.codes,
        reason=waiver.reason,
        waived_by=PersonBrief.model_validate(waiver.approver),
        created_at=waiver.created_at,
    )


def _codes_waived(session: Session, take: Take) -> list[str]:
    waiver = queries.waiver_of(session, take.id)
    return waiver.codes if waiver and waiver.master_sha256 == take.master_sha256 else []
