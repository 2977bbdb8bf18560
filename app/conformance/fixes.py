"""Fixes: offered by what the check found, made in a job, and taken by the sound's own designer."""

from dataclasses import dataclass
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

import audio_checks
from app.accounts.models import Person
from app.accounts.rules import Actor
from app.accounts.schemas import PersonBrief
from app.conformance import queries
from app.conformance.errors import FixNotReady, NothingToFix
from app.conformance.models import CheckRun, Fix
from app.conformance.rules import FIXABLE_STATES, FixState, fix_offers, is_enough
from app.conformance.schemas import FixedFrom, FixOffer, FixRead, LeftRead, RepairRead, SpotRead
from app.conformance.service import resolved_spec
from app.core import clock
from app.core.events import publish
from app.deliveries import queries as deliveries
from app.deliveries.dry_stems import copy_to_fix
from app.deliveries.models import Take
from app.deliveries.rules import ensure_master_kept
from app.deliveries.schemas import CueBrief
from app.deliveries.service import add_fixed_take, check_name, ensure_own_designer, take_for
from app.deliveries.source_banks.service import copy_bank
from app.projects.service import ProjectAccess, project_access
from app.sound_lists.rules import label
from app.sound_lists.service import cue_facts

MAX_OFFERED = 200
OUR_FAULT = "The auto-fix failed three times. That is our fault; upload your own version, or try again later."


@dataclass(frozen=True)
class FixOrder:
    """The inputs of a fix, read at one moment."""

    fix_id: UUID
    studio_id: UUID
    master_sha256: str
    master_bytes: int
    name: str
    spec: audio_checks.DeliverySpec
    cue: audio_checks.CueFacts | None


@dataclass(frozen=True)
class _FixOutlook:
    """The expected effect of a fix on a take, by its newest check."""

    run: CheckRun
    offers: list[audio_checks.Offer]
    is_open: bool  # the take is matched, and not decided upon
    is_enough: bool  # it would not come back for what no fix answers

    @property
    def says(self) -> str:
        """The effect of the fix, or why there is none, as a sentence."""
        if not self.run.report["findings"]:
            return "It has no findings."
        if not any(self.offers):
            return "None of its findings can be fixed in the finished file."
        if not self.is_open:
            return "Only a version that has a cue and is not reviewed yet can be fixed."
        effect = audio_checks.fix_in_words(self.offers)
        if not self.is_enough:
            return f"A fix that {effect} would not be enough: fix the rest in the session."
        return f"{effect[0].upper()}{effect[1:]}."


def _fix_outlook(session: Session, take: Take, run: CheckRun) -> _FixOutlook:
    offers = fix_offers(run.report, resolved_spec(queries.spec_of(session, run), take))
    return _FixOutlook(
        run=run,
        offers=offers,
        is_open=take.cue_id is not None and take.state in FIXABLE_STATES,
        is_enough=is_enough(run.report, offers),
    )


def prepare_fix(session: Session, take_id: UUID) -> None:
    """Schedule the fixed copy of a returned take if a fix is enough: its designer finds it on the desk."""
    take = deliveries.take_by_id(session, take_id)
    run = queries.current_run(session, take_id)
    if take is None or run is None or run.verdict == "conforming":
        return
    chance = _fix_outlook(session, take, run)
    if chance.is_open and chance.is_enough:
        _asked(session, take, run, asked_by=None)


def request_fix(session: Session, actor: Actor, take_id: UUID) -> FixRead:
    """Request a fixed copy to see and play; the same copy is made once."""
    take, access = take_for(session, actor, take_id, locked=True)
    ensure_own_designer(access, take)
    ensure_master_kept(take.master_deleted_at)
    run = queries.current_run(session, take.id)
    chance = _fix_outlook(session, take, run) if run else None
    if run is None or chance is None or not (chance.is_open and chance.is_enough):
        raise NothingToFix(
            chance.says if chance else "this version has not been checked yet",
            fix="upload your own version; the findings say what to do",
        )
    _asked(session, take, run, asked_by=actor.person)
    return read_fix(session, take)


def use_fix(session: Session, actor: Actor, take_id: UUID) -> tuple[Take, bool, ProjectAccess]:
    """Make the fixed copy a take, with its designer's consent; return it, and whether it was there before.

    The take it came from stays as it is, and no round counts.
    """
    take, access = take_for(session, actor, take_id, locked=True)
    ensure_own_designer(access, take)
    run = queries.current_run(session, take.id)
    fix = queries.fix_with_key(session, take.id, run.key) if run else None
    if fix is not None and fix.new_take_id is not None:
        made = deliveries.take_by_id(session, fix.new_take_id)
        if made is None:
            raise LookupError(f"fix {fix.id} has no take")
        return made, True, access
    if take.state not in FIXABLE_STATES:
        raise NothingToFix(f"a {take.state} version is reviewed already", fix="upload your own version")
    if fix is None or fix.sha256 is None or fix.fixed_bytes is None:
        raise FixNotReady(
            fix.refusal if fix and fix.refusal else "the fixed copy is not made yet",
            fix="ask for it first, and listen to it once it is made",
        )
    made, already_here = add_fixed_take(session, take, fix.sha256, fix.fixed_bytes, _file_name(take, fix))
    copy_to_fix(session, take, made)
    copy_bank(session, take, made)
    fix.used_by, fix.used_at, fix.new_take_id = actor.person, clock.now(), made.id
    session.flush()
    return made, already_here, access


def fix_for(session: Session, actor: Actor, take_id: UUID) -> FixRead:
    """Return a fix's possible or past effect on a take within the caller's sight."""
    take, _ = take_for(session, actor, take_id)
    return read_fix(session, take)


def fixes_offered(session: Session, actor: Actor, project_id: UUID) -> list[FixOffer]:
    """Return the takes of a project of which a fix would be enough, longest waiting first; a designer's own."""
    access = project_access(session, actor, project_id)
    checked_takes = queries.takes_with_findings(
        session, project_id, designer_id=access.only_designer_id, limit=MAX_OFFERED
    )
    fixes = queries.fixes_of(session, [take.id for take, _ in checked_takes])
    offered = []
    for take, run in checked_takes:
        chance, fix = _fix_outlook(session, take, run), fixes.get((take.id, run.key))
        state = _state(chance, fix)
        if take.cue is None or state not in ("offered", "making", "made"):
            continue
        name = label(access.project.cue_prefix, take.cue.number)
        offered.append(
            FixOffer(
                take_id=take.id,
                cue=CueBrief(id=take.cue.id, label=name, name=take.cue.name),
                variation=take.variation,
                number=take.number or 0,
                take_state=take.state,
                state=state,
                says=_says(chance, fix),
            )
        )
    return offered


def _asked(session: Session, take: Take, run: CheckRun, *, asked_by: UUID | None) -> Fix:
    fix = queries.fix_with_key(session, take.id, run.key)
    if fix is not None and not (fix.refusal == OUR_FAULT and asked_by is not None):
        return fix
    if fix is None:
        fix = Fix(studio_id=take.studio_id, project_id=take.project_id, take_id=take.id, key=run.key)
        session.add(fix)
    fix.state, fix.refusal, fix.asked_by = FixState.MAKING, None, asked_by
    session.flush()
    publish(session, "fix.asked", studio_id=take.studio_id, fix_id=fix.id)
    return fix


def order_fix(session: Session, fix_id: UUID) -> FixOrder | None:
    """Return the order for a fix; None where it is made, or its take was checked against something else meanwhile."""
    fix = queries.fix_by_id(session, fix_id)
    if fix is None or fix.state is not FixState.MAKING:
        return None
    take = deliveries.take_by_id(session, fix.take_id)
    run = queries.current_run(session, fix.take_id)
    if take is None or run is None or run.key != fix.key:
        return None
    return FixOrder(
        fix_id=fix.id,
        studio_id=fix.studio_id,
        master_sha256=take.master_sha256,
        master_bytes=take.master_bytes,
        name=check_name(session, take),
        spec=resolved_spec(queries.spec_of(session, run), take),
        cue=cue_facts(take.cue) if take.cue else None,
    )


def record_fix(session: Session, fix_id: UUID, made: dict[str, Any], blob: tuple[str, int] | None) -> bool:
    """Record the result of a fix, once; `blob` is the stored copy. Return whether it was recorded."""
    fix = queries.fix_by_id(session, fix_id, locked=True)
    if fix is None or fix.state is not FixState.MAKING:
        return False
    fix.made_at = clock.now()
    fix.made = {key: value for key, value in made.items() if key != "file"}
    if blob is not None and made["conforms"]:
        fix.state = FixState.MADE
        fix.sha256, fix.fixed_bytes = blob
        publish(session, "fix.made", studio_id=fix.studio_id, fix_id=fix.id)
    else:
        fix.state = FixState.REFUSED
        whys = " ".join(dict.fromkeys(unfixed["why"] for unfixed in made["left"] if unfixed["severity"] == "error"))
        fix.refusal = f"Even fixed it would be returned. {whys}".strip()
    session.flush()
    return True


def give_up(session: Session, fix_id: UUID) -> None:
    """Record that a fix failed by our fault."""
    fix = queries.fix_by_id(session, fix_id, locked=True)
    if fix is not None and fix.state is FixState.MAKING:
        fix.state, fix.refusal = FixState.REFUSED, OUR_FAULT
        session.flush()


def read_fix(session: Session, take: Take) -> FixRead:
    """Return a fix's possible or past effect on a take."""
    run = queries.current_run(session, take.id)
    chance = _fix_outlook(session, take, run) if run else None
    fix = queries.fix_with_key(session, take.id, run.key) if run else None
    used_by = session.get(Person, fix.used_by) if fix and fix.used_by else None
    made = fix.made if fix else {}
    cut_head_s, cut_tail_s = made.get("cut_s") or (0.0, 0.0)
    is_wanted = chance is not None and chance.is_open
    return FixRead(
        take_id=take.id,
        state=_state(chance, fix),
        says=_says(chance, fix),
        repairs=[RepairRead.model_validate(repair) for repair in made.get("repairs", [])],
        left=[LeftRead.model_validate(unfixed) for unfixed in made.get("left", [])],
        is_our_fault=fix is not None and fix.refusal == OUR_FAULT,
        before=made.get("before", {}),
        after=made.get("after", {}),
        cut_head_s=cut_head_s,
        cut_tail_s=cut_tail_s,
        duration_s=made.get("duration_s"),
        file_name=_file_name(take, fix) if fix and fix.sha256 else None,
        spots=[SpotRead.model_validate(spot) for spot in made.get("spots", [])],
        becomes=_becomes(session, take, fix) if is_wanted or (fix and fix.new_take_id) else None,
        new_take_id=fix.new_take_id if fix else None,
        used_by=PersonBrief.model_validate(used_by) if used_by else None,
        used_at=fix.used_at if fix else None,
        fixed_from=_fixed_from(session, take),
    )


def _state(chance: _FixOutlook | None, fix: Fix | None) -> Any:
    if fix is not None and fix.new_take_id is not None:
        return "used"
    if chance is None or not chance.is_open:
        return "none"
    if fix is not None:
        return fix.state.value
    return "offered" if chance.is_enough else "none"


def _says(chance: _FixOutlook | None, fix: Fix | None) -> str:
    if chance is None:
        return "It has not been checked yet."
    if fix is not None and fix.refusal is not None:
        return fix.refusal
    words = [repair["words"] for repair in fix.made.get("repairs", [])] if fix else []
    return f"{', '.join(words)[:1].upper()}{', '.join(words)[1:]}." if words else chance.says


def _becomes(session: Session, take: Take, fix: Fix | None) -> int | None:
    if fix is not None and fix.new_take_id is not None:
        made = deliveries.take_by_id(session, fix.new_take_id)
        return made.number if made else None
    return deliveries.last_number(session, take.cue_id, take.variation) + 1 if take.cue_id else None


def _fixed_from(session: Session, take: Take) -> FixedFrom | None:
    fix = queries.fix_that_made(session, take.id)
    if fix is None or fix.used_by is None or fix.used_at is None:
        return None
    master = session.get_one(Take, fix.take_id)
    return FixedFrom(
        take_id=master.id,
        number=master.number,
        repairs=[RepairRead.model_validate(repair) for repair in fix.made.get("repairs", [])],
        used_by=PersonBrief.model_validate(session.get_one(Person, fix.used_by)),
        used_at=fix.used_at,
    )


def _file_name(take: Take, fix: Fix) -> str:
    """Return the name of the new take: as the designer named it, unless the name itself was put right."""
    is_renamed = any(repair["kind"] == "name" for repair in fix.made.get("repairs", []))
    return str(fix.made["name"]) if is_renamed else take.file_name
