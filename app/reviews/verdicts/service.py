"""Verdicts on takes and sets, their undoing, and cuts."""

from collections.abc import Collection, Sequence
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.core import clock, kill_points
from app.core.db import new_id
from app.core.events import publish, send
from app.deliveries.models import Take
from app.deliveries.rules import TakeState, shown_name, undecided_groups
from app.deliveries.service import take_for
from app.deliveries.take_states import restore_state
from app.deliveries.tray.service import open_take_of
from app.projects.approval.service import approval_rights, ensure_may_approve
from app.projects.errors import ProducerNeeded
from app.projects.service import ProjectAccess
from app.reviews import queries
from app.reviews.errors import (
    AlreadyAccepted,
    NoteNeeded,
    NothingToUndo,
    NotOfThisCue,
    NotReviewable,
    SetIncomplete,
    VerdictSince,
    VersionsUndecided,
)
from app.reviews.listened.service import heard_now_or_before
from app.reviews.models import ChangeRequest, Verdict
from app.reviews.queue.service import change_request_read
from app.reviews.reasons.rules import ensure_distinct
from app.reviews.reasons.service import forget_reasons
from app.reviews.rounds.mentions import mentions_in
from app.reviews.rules import (
    SEND_AFTER,
    STATE_WORDS,
    UNDO_WITHIN,
    VerdictKind,
    ensure_range,
    ensure_seen,
    ensure_undoable,
    missing_variations,
)
from app.reviews.schemas import (
    ChangeRequestRead,
    SetAccepted,
    TakeStateRead,
    VerdictGiven,
    VerdictUndone,
)
from app.reviews.signals import CueCut
from app.reviews.verdicts.approval_blocks import ensure_nothing_open
from app.reviews.verdicts.decisions import STATE_AFTER, Decision, decide_cue, new_verdict
from app.sound_lists.errors import CueIsCut
from app.sound_lists.models import Cue
from app.sound_lists.queries import lock_list
from app.sound_lists.rules import CueState
from app.sound_lists.service import cut_cue as cut_from_list
from app.sound_lists.service import visible_cue


def give_verdict(
    session: Session,
    actor: Actor,
    take_id: UUID,
    *,
    kind: VerdictKind,
    note: str = "",
    reasons: Sequence[str] = (),
    start_s: float | None = None,
    end_s: float | None = None,
    seen_state: TakeState = TakeState.CONFORMING,
    mentions: Sequence[UUID] = (),
    heard: bool = False,
    sends: bool = False,
) -> VerdictGiven:
    """Record the approver's verdict on a take; a requested change stays a draft until it is sent, here by itself.

    Whoever repeats their own decision is answered as the first time, and nothing changes.
    """
    take, access = take_for(session, actor, take_id)
    for_whom = _ensure_may_approve(session, access, take)
    cue = _cue_to_judge(session, take)
    standing = _own_decision(session, actor, take)
    if standing is not None and (standing.kind, standing.note, standing.reasons) == (kind, note, list(reasons)):
        return _given_before(session, take, cue, standing)
    if standing is None:
        ensure_seen(take.state, seen_state)
    ensure_distinct(reasons, "reasons")
    if kind is VerdictKind.REQUEST_CHANGE:
        named = mentions_in(session, take, note, mentions)
        return _draft_change(
            session,
            access,
            take,
            cue,
            text=note,
            reasons=list(reasons),
            start_s=start_s,
            end_s=end_s,
            mentions=named,
            sends=sends,
        )
    decision = Decision(session, actor.person, note, reasons=reasons, on_behalf_of=for_whom)
    if kind is VerdictKind.APPROVE:
        ensure_nothing_open(session, cue, [take])
        heard_takes = heard_now_or_before(session, actor.person, [take.id], [take.id] if heard else [])
        decision.approve(take, without_listening=take.id not in heard_takes)
    else:
        decision.set_aside(take)
    accepted = decision.finish(cue)
    kill_points.point("reviews.before_commit")
    return VerdictGiven(
        take_id=take.id,
        state=take.state,
        set_aside=decision.superseded_take_ids,
        draft=None,
        cue_id=cue.id,
        cue_accepted=accepted,
        undo_until=clock.now() + UNDO_WITHIN,
    )


def _own_decision(session: Session, actor: Actor, take: Take) -> Verdict | None:
    """Return the caller's verdict that put a take where it stands; None where another's did, or none."""
    last = next(reversed(queries.effective_verdicts(session, [take.id])), None)
    is_own = last is not None and last.given_by == actor.person and STATE_AFTER.get(last.kind) is take.state
    return last if is_own else None


def _given_before(session: Session, take: Take, cue: Cue, standing: Verdict) -> VerdictGiven:
    """Return the answer to a decision again, for a person who repeats it."""
    approved = queries.approved_variations(session, [cue.id]).get(cue.id, [])
    return VerdictGiven(
        take_id=take.id,
        state=take.state,
        set_aside=_superseded_take_ids(session, standing),
        draft=None,
        cue_id=cue.id,
        cue_accepted=not missing_variations(cue.variations, approved),
        undo_until=standing.created_at + UNDO_WITHIN,
    )


def _superseded_take_ids(session: Session, approval: Verdict) -> list[UUID]:
    decided = queries.action_verdicts(session, approval.action_id)
    return [
        verdict.take_id
        for verdict in decided
        if verdict.kind is VerdictKind.SET_ASIDE and verdict.take_id != approval.take_id
    ]


def _ensure_may_approve(session: Session, access: ProjectAccess, take: Take) -> UUID | None:
    return ensure_may_approve(session, access, take.cue.category if take.cue else "")


def _cue_to_judge(session: Session, take: Take) -> Cue:
    """Return a take's cue, locked; both current, even if another decision is made at the same moment."""
    if take.cue is None:
        raise NotReviewable("this file has no cue yet; choose its cue first")
    cue = take.cue
    session.refresh(cue, ["state"], with_for_update={"key_share": True})
    session.refresh(take, ["state", "state_since"], with_for_update={"key_share": True})
    if cue.state is CueState.CUT:
        raise CueIsCut(f"{cue.name} was cut, so it can't be reviewed")
    return cue


def _draft_change(
    session: Session,
    access: ProjectAccess,
    take: Take,
    cue: Cue,
    *,
    text: str,
    reasons: list[str],
    start_s: float | None,
    end_s: float | None,
    mentions: dict[str, str],
    sends: bool,
) -> VerdictGiven:
    if take.state not in (TakeState.CONFORMING, TakeState.APPROVED):
        raise NotReviewable(f"this version {STATE_WORDS[take.state]}, so no change can be asked of it")
    if not text.strip():
        raise NoteNeeded("write what to change", errors=[{"where": "note", "message": "write what to change"}])
    ensure_range(start_s, end_s, queries.duration_of(session, take))
    draft = queries.draft_of(session, take.id)
    if draft is None:
        draft = ChangeRequest(
            studio_id=take.studio_id,
            project_id=take.project_id,
            cue_id=cue.id,
            take_id=take.id,
            text=text,
            written_by=access.actor.person,
        )
        session.add(draft)
    draft.reasons = reasons
    draft.cue_id, draft.text, draft.start_s, draft.end_s, draft.mentions = cue.id, text, start_s, end_s, mentions
    draft.written_by = access.actor.person
    draft.created_at = clock.now()
    draft.sends_at = draft.created_at + SEND_AFTER if sends else None
    session.flush()
    if sends:
        publish(
            session,
            "change.requested",
            studio_id=draft.studio_id,
            delay_s=SEND_AFTER.total_seconds(),
            change_request_id=draft.id,
        )
    session.expire(draft)
    approved = queries.approved_variations(session, [cue.id]).get(cue.id, [])
    return VerdictGiven(
        take_id=take.id,
        state=take.state,
        set_aside=[],
        draft=_shown(session, draft.id, access),
        cue_id=cue.id,
        cue_accepted=not missing_variations(cue.variations, approved),
        undo_until=None,
    )


def _shown(session: Session, change_request_id: UUID, access: ProjectAccess) -> ChangeRequestRead:
    request = queries.change_request_by_id(session, change_request_id)
    if request is None:
        raise AssertionError("it was just written")
    return change_request_read(request, access.project.cue_prefix)


def undo_verdict(session: Session, actor: Actor, take_id: UUID) -> VerdictUndone:
    """Undo the last click's decision on a take, within a minute and while nothing later depends on it."""
    take, access = take_for(session, actor, take_id)
    for_whom = _ensure_may_approve(session, access, take)
    cue = _cue_to_judge(session, take)
    draft = queries.draft_of(session, take.id)
    if draft is not None:
        ensure_undoable(draft.created_at, clock.now())
        session.delete(draft)
        return VerdictUndone(takes=[_standing_of(take)], draft_dropped=True)
    effective_verdicts = queries.effective_verdicts(session, [take.id])
    if not effective_verdicts:
        raise NothingToUndo("there is no decision on this version")
    last = effective_verdicts[-1]
    if last.kind is VerdictKind.REQUEST_CHANGE:
        raise NothingToUndo("the change request was sent to the designer and can't be undone")
    if last.adoption_id is not None:
        raise NothingToUndo("this version was adopted with its folder", fix="request a change, or undo the adoption")
    ensure_undoable(last.created_at, clock.now())
    decided = queries.action_verdicts(session, last.action_id)
    takes = queries.takes_by_id(session, [verdict.take_id for verdict in decided])
    _ensure_nothing_since(session, decided, takes)
    restored = _take_back(session, access, decided, takes, for_whom)
    decide_cue(session, cue, person_id=actor.person)
    return VerdictUndone(takes=restored, draft_dropped=False)


def _ensure_nothing_since(session: Session, decided: Sequence[Verdict], takes: dict[UUID, Take]) -> None:
    last = {verdict.take_id: verdict.id for verdict in queries.effective_verdicts(session, takes)}
    drafts = {draft.take_id: draft.created_at for draft in queries.open_drafts(session, takes)}
    for verdict in decided:
        take = takes[verdict.take_id]
        is_last = last.get(take.id) == verdict.id and take.state is STATE_AFTER[verdict.kind]
        if not is_last or drafts.get(take.id, verdict.created_at) > verdict.created_at:
            raise VerdictSince(
                f"version {take.number} of variation {take.variation} was reviewed again since; nothing was undone"
            )


def _take_back(
    session: Session,
    access: ProjectAccess,
    decided: Sequence[Verdict],
    takes: dict[UUID, Take],
    on_behalf_of: UUID | None,
) -> list[TakeStateRead]:
    action_id = new_id()
    forget_reasons(session, decided)
    reasons = _reasons_before(session, decided)
    # Approvals first: a former pick comes back only where there is none.
    for verdict in sorted(decided, key=lambda candidate: candidate.kind is not VerdictKind.APPROVE):
        take = takes[verdict.take_id]
        back = new_verdict(
            session,
            access.actor.person,
            take,
            VerdictKind.WITHDRAW,
            "",
            action_id,
            on_behalf_of=on_behalf_of,
            withdraws_id=verdict.id,
        )
        session.add(back)
        restore_state(session, take, verdict.state_before, verdict.since_before, reasons=reasons.get(take.id, ()))
        if verdict.dropped_draft:
            session.add(
                ChangeRequest(
                    studio_id=take.studio_id,
                    project_id=take.project_id,
                    cue_id=verdict.cue_id,
                    take_id=take.id,
                    written_by=access.actor.person,
                    **verdict.dropped_draft,
                )
            )
        session.flush()
    return [_standing_of(take) for take in takes.values()]


def _reasons_before(session: Session, decided: Sequence[Verdict]) -> dict[UUID, Sequence[str]]:
    """Return the reasons of the picks that come back when decisions are undone."""
    undone = {verdict.id for verdict in decided}
    were_picked = {verdict.take_id for verdict in decided if verdict.state_before is TakeState.APPROVED}
    standing = queries.effective_verdicts(session, were_picked) if were_picked else []
    return {verdict.take_id: verdict.reasons for verdict in standing if verdict.id not in undone}


def _standing_of(take: Take) -> TakeStateRead:
    return TakeStateRead(id=take.id, variation=take.variation, state=take.state)


def accept_set(
    session: Session,
    actor: Actor,
    cue_id: UUID,
    *,
    note: str = "",
    reasons: Sequence[str] = (),
    take_ids: Sequence[UUID] = (),
    heard_take_ids: Sequence[UUID] = (),
) -> SetAccepted:
    """Approve one take of every variation of a cue at once: those named, else the newest that waits.

    Where the caller approved them all before, the answer says so, and nothing changes.
    """
    access, cue = visible_cue(session, actor, cue_id)
    for_whom = ensure_may_approve(session, access, cue.category)
    ensure_distinct(reasons, "reasons")
    queries.lock_cue(session, cue.id)
    session.refresh(cue, ["state"])
    if cue.state is CueState.CUT:
        raise CueIsCut(f"{cue.name} was cut, so it can't be reviewed")
    picks = _picks(session, cue, take_ids)
    new = [take for take in picks if take.state is not TakeState.APPROVED]
    if not new:
        last = queries.effective_verdicts(session, [take.id for take in picks])[-1:]
        if not last or last[0].given_by != actor.person:
            raise AlreadyAccepted(f"{cue.name} is accepted, and no newer version waits")
        return SetAccepted(
            cue_id=cue.id,
            cue_accepted=True,
            approved=[_standing_of(take) for take in picks],
            set_aside=_superseded_take_ids(session, last[0]),
            undo_until=last[0].created_at + UNDO_WITHIN,
        )
    ensure_nothing_open(session, cue, new)
    decision = Decision(session, actor.person, note, reasons=reasons, on_behalf_of=for_whom)
    heard_takes = heard_now_or_before(session, actor.person, [take.id for take in new], heard_take_ids)
    for take in new:
        decision.approve(take, without_listening=take.id not in heard_takes)
    accepted = decision.finish(cue)
    return SetAccepted(
        cue_id=cue.id,
        cue_accepted=accepted,
        approved=[_standing_of(take) for take in picks],
        set_aside=decision.superseded_take_ids,
        undo_until=clock.now() + UNDO_WITHIN,
    )


def ensure_decided(cue: Cue, waiting: Sequence[Take], *, named: Collection[int]) -> None:
    """Raise VersionsUndecided where a variation that is not named has files between which nobody chose."""
    for group in undecided_groups(map(open_take_of, waiting)):
        variation = group[0].variation
        if variation not in named:
            names = " and ".join(f'version {take.number}, "{shown_name(take.file_name)}"' for take in group)
            raise VersionsUndecided(
                f"for variation {variation} of {cue.name} one delivery has {names}, and nobody chose; "
                "nothing was approved",
                fix="name the version that you mean in take_ids, or have the designer decide on the desk",
            )


def _picks(session: Session, cue: Cue, take_ids: Sequence[UUID]) -> list[Take]:
    """Return one take for each variation: the one named, else the newest that waits, else the approved one."""
    picks: dict[int, Take] = {}
    named = queries.takes_by_id(session, take_ids)
    for take_id in take_ids:
        take = named.get(take_id)
        if take is None or take.cue_id != cue.id or take.variation in picks:
            raise NotOfThisCue(f"{take_id} is no version of this cue, or its variation is named twice")
        if take.state not in (TakeState.CONFORMING, TakeState.APPROVED):
            raise NotReviewable(
                f"version {take.number} of variation {take.variation} {STATE_WORDS[take.state]}; nothing was approved"
            )
        picks[take.variation] = take
    waiting: dict[int, Take] = {}
    approved: dict[int, Take] = {}
    waiting_takes: list[Take] = []
    for take in queries.open_takes(session, cue.id):
        if take.state is TakeState.CONFORMING:
            waiting_takes.append(take)
        (approved if take.state is TakeState.APPROVED else waiting).setdefault(take.variation, take)
    ensure_decided(cue, waiting_takes, named=picks)
    picks = approved | waiting | picks
    if missing := missing_variations(cue.variations, picks):
        numbers = ", ".join(str(variation) for variation in missing)
        raise SetIncomplete(
            f"{cue.name} is a set of {cue.variations}, and no conforming version is there for {numbers}; "
            "nothing was approved"
        )
    return [picks[variation] for variation in range(1, cue.variations + 1)]


def cut_cue(session: Session, actor: Actor, cue_id: UUID, *, reason: str) -> Cue:
    """Cut a cue with a reason: it stays on record with its takes, and leaves list, queue and drafts."""
    access, cue = visible_cue(session, actor, cue_id)
    approvers = approval_rights(session, access.project).people_for(cue.category)
    if not (access.is_producer or (access.is_team and actor.person in approvers)):
        raise ProducerNeeded("only a producer or the cue's approver can cut a cue")
    lock_list(session, cue.project_id)  # before the cue, as in every change of the list
    queries.lock_cue(session, cue.id)
    session.refresh(cue, ["state", "edition"])
    if cue.state is CueState.CUT:
        raise CueIsCut("this cue is already cut")
    for draft in queries.change_requests_of(
        session, ChangeRequest.cue_id == cue.id, ChangeRequest.feedback_id.is_(None)
    ):
        session.delete(draft)
    send(session, CueCut(cue, actor.person))
    cut_from_list(session, actor, cue, reason)
    publish(session, "cue.cut", studio_id=cue.studio_id, cue_id=cue.id)
    return cue
