"""Mends: offered by what the check found, made in a job, and taken by the sound's own designer."""

from dataclasses import dataclass
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

import audio_checks
from app.accounts.models import Person
from app.accounts.rules import Actor
from app.accounts.schemas import PersonBrief
from app.conformance import queries
from app.conformance.errors import MendNotMade, NothingToMend
from app.conformance.models import CheckRun, Mend
from app.conformance.rules import MENDABLE_STATES, MendState, is_enough, mend_offers
from app.conformance.schemas import LeftRead, MendedFrom, MendOffer, MendRead, RepairRead, SpotRead
from app.conformance.service import resolved_spec
from app.deliveries import queries as deliveries
from app.deliveries.dry_stems import carry_to_mend
from app.deliveries.models import Take
from app.deliveries.schemas import CueBrief
from app.deliveries.service import add_mended_take, check_name, ensure_maker, take_for
from app.kit import clock
from app.kit.events import publish
from app.projects.service import Standing, standing_in
from app.sound_lists.rules import label
from app.sound_lists.service import cue_facts

MOST_OFFERED = 200
OUR_FAULT = "Our mender failed three times on this file. That is our fault; send your own, or ask again later."


@dataclass(frozen=True)
class MendOrder:
    """What is to be mended, as of one moment."""

    mend_id: UUID
    studio_id: UUID
    master_sha256: str
    master_bytes: int
    name: str
    spec: audio_checks.DeliverySpec
    cue: audio_checks.CueFacts | None


@dataclass(frozen=True)
class _Chance:
    """What a mend would do about a take, going by its newest check."""

    run: CheckRun
    offers: list[audio_checks.Offer]
    is_open: bool  # the take is matched, and not decided upon
    is_enough: bool  # it would not come back for what no mend answers

    @property
    def says(self) -> str:
        """What the mend does, or why there is none, in a sentence."""
        if not self.run.report["findings"]:
            return "Nothing was found in it."
        if not any(self.offers):
            return "Nothing that was found in it can be put right in the finished file."
        if not self.is_open:
            return "A mend is made of a version that has a cue and is not decided upon."
        told = audio_checks.mend_in_words(self.offers)
        if not self.is_enough:
            return f"A mend that {told} would not be enough: the rest is put right in the session."
        return f"{told[0].upper()}{told[1:]}."


def _chance(session: Session, take: Take, run: CheckRun) -> _Chance:
    offers = mend_offers(run.report, resolved_spec(queries.spec_of(session, run), take))
    return _Chance(
        run=run,
        offers=offers,
        is_open=take.cue_id is not None and take.state in MENDABLE_STATES,
        is_enough=is_enough(run.report, offers),
    )


def make_ready(session: Session, take_id: UUID) -> None:
    """Ask for the mended copy of a take that came back, where a mend is enough: its designer finds it on the desk."""
    take = deliveries.take_by_id(session, take_id)
    run = queries.current_run(session, take_id)
    if take is None or run is None or run.verdict == "conforming":
        return
    chance = _chance(session, take, run)
    if chance.is_open and chance.is_enough:
        _asked(session, take, run, asked_by=None)


def ask_for_mend(session: Session, actor: Actor, take_id: UUID) -> MendRead:
    """Ask for a mended copy to see and to hear; the same copy is made once."""
    take, standing = take_for(session, actor, take_id, locked=True)
    ensure_maker(standing, take)
    run = queries.current_run(session, take.id)
    chance = _chance(session, take, run) if run else None
    if run is None or chance is None or not (chance.is_open and chance.is_enough):
        raise NothingToMend(
            chance.says if chance else "this version has not been checked yet",
            fix="send your own version; what was found says what to do",
        )
    _asked(session, take, run, asked_by=actor.person)
    return read_mend(session, take)


def use_mend(session: Session, actor: Actor, take_id: UUID) -> tuple[Take, bool, Standing]:
    """Make the mended copy a take, with its designer's consent; return it, and whether it was there before.

    The take it came from stays as it is, and no round counts.
    """
    take, standing = take_for(session, actor, take_id, locked=True)
    ensure_maker(standing, take)
    run = queries.current_run(session, take.id)
    mend = queries.mend_with_key(session, take.id, run.key) if run else None
    if mend is not None and mend.new_take_id is not None:
        made = deliveries.take_by_id(session, mend.new_take_id)
        if made is None:
            raise LookupError(f"mend {mend.id} has no take")
        return made, True, standing
    if take.state not in MENDABLE_STATES:
        raise NothingToMend(f"a {take.state} version is decided upon", fix="send your own version")
    if mend is None or mend.sha256 is None or mend.mended_bytes is None:
        raise MendNotMade(
            mend.refusal if mend and mend.refusal else "the mended copy is not made yet",
            fix="ask for it first, and listen to it once it is made",
        )
    made, already_here = add_mended_take(session, take, mend.sha256, mend.mended_bytes, _file_name(take, mend))
    carry_to_mend(session, take, made)
    mend.used_by, mend.used_at, mend.new_take_id = actor.person, clock.now(), made.id
    session.flush()
    return made, already_here, standing


def mend_for(session: Session, actor: Actor, take_id: UUID) -> MendRead:
    """Return what a mend can do, or did, about a take within the caller's sight."""
    take, _ = take_for(session, actor, take_id)
    return read_mend(session, take)


def mends_offered(session: Session, actor: Actor, project_id: UUID) -> list[MendOffer]:
    """Return the takes of a project of which a mend would be enough, longest waiting first; a designer's own."""
    standing = standing_in(session, actor, project_id)
    found = queries.takes_with_findings(session, project_id, designer_id=standing.only_designer_id, limit=MOST_OFFERED)
    mends = queries.mends_of(session, [take.id for take, _ in found])
    offered = []
    for take, run in found:
        chance, mend = _chance(session, take, run), mends.get((take.id, run.key))
        state = _state(chance, mend)
        if take.cue is None or state not in ("offered", "making", "made"):
            continue
        name = label(standing.project.cue_prefix, take.cue.number)
        offered.append(
            MendOffer(
                take_id=take.id,
                cue=CueBrief(id=take.cue.id, label=name, name=take.cue.name),
                variation=take.variation,
                number=take.number or 0,
                take_state=take.state,
                state=state,
                says=_says(chance, mend),
            )
        )
    return offered


def _asked(session: Session, take: Take, run: CheckRun, *, asked_by: UUID | None) -> Mend:
    mend = queries.mend_with_key(session, take.id, run.key)
    if mend is not None and not (mend.refusal == OUR_FAULT and asked_by is not None):
        return mend
    if mend is None:
        mend = Mend(studio_id=take.studio_id, project_id=take.project_id, take_id=take.id, key=run.key)
        session.add(mend)
    mend.state, mend.refusal, mend.asked_by = MendState.MAKING, None, asked_by
    session.flush()
    publish(session, "mend.asked", studio_id=take.studio_id, mend_id=mend.id)
    return mend


def order_mend(session: Session, mend_id: UUID) -> MendOrder | None:
    """Return what is to be mended; None where it is made, or its take was checked against something else meanwhile."""
    mend = queries.mend_by_id(session, mend_id)
    if mend is None or mend.state is not MendState.MAKING:
        return None
    take = deliveries.take_by_id(session, mend.take_id)
    run = queries.current_run(session, mend.take_id)
    if take is None or run is None or run.key != mend.key:
        return None
    return MendOrder(
        mend_id=mend.id,
        studio_id=mend.studio_id,
        master_sha256=take.master_sha256,
        master_bytes=take.master_bytes,
        name=check_name(session, take),
        spec=resolved_spec(queries.spec_of(session, run), take),
        cue=cue_facts(take.cue) if take.cue else None,
    )


def record_mend(session: Session, mend_id: UUID, made: dict[str, Any], blob: tuple[str, int] | None) -> bool:
    """Write down what came of a mend, once; `blob` is the stored copy. Return whether it was written."""
    mend = queries.mend_by_id(session, mend_id, locked=True)
    if mend is None or mend.state is not MendState.MAKING:
        return False
    mend.made_at = clock.now()
    mend.made = {key: value for key, value in made.items() if key != "file"}
    if blob is not None and made["conforms"]:
        mend.state = MendState.MADE
        mend.sha256, mend.mended_bytes = blob
        publish(session, "mend.made", studio_id=mend.studio_id, mend_id=mend.id)
    else:
        mend.state = MendState.REFUSED
        whys = " ".join(dict.fromkeys(one["why"] for one in made["left"] if one["severity"] == "error"))
        mend.refusal = f"Even mended it would come back. {whys}".strip()
    session.flush()
    return True


def give_up(session: Session, mend_id: UUID) -> None:
    """Say that a mend could not be made, by our fault."""
    mend = queries.mend_by_id(session, mend_id, locked=True)
    if mend is not None and mend.state is MendState.MAKING:
        mend.state, mend.refusal = MendState.REFUSED, OUR_FAULT
        session.flush()


def read_mend(session: Session, take: Take) -> MendRead:
    """Return what a mend can do, or did, about a take."""
    run = queries.current_run(session, take.id)
    chance = _chance(session, take, run) if run else None
    mend = queries.mend_with_key(session, take.id, run.key) if run else None
    used_by = session.get(Person, mend.used_by) if mend and mend.used_by else None
    made = mend.made if mend else {}
    cut_head_s, cut_tail_s = made.get("cut_s") or (0.0, 0.0)
    is_wanted = chance is not None and chance.is_open
    return MendRead(
        take_id=take.id,
        state=_state(chance, mend),
        says=_says(chance, mend),
        repairs=[RepairRead.model_validate(one) for one in made.get("repairs", [])],
        left=[LeftRead.model_validate(one) for one in made.get("left", [])],
        is_our_fault=mend is not None and mend.refusal == OUR_FAULT,
        before=made.get("before", {}),
        after=made.get("after", {}),
        cut_head_s=cut_head_s,
        cut_tail_s=cut_tail_s,
        duration_s=made.get("duration_s"),
        file_name=_file_name(take, mend) if mend and mend.sha256 else None,
        spots=[SpotRead.model_validate(one) for one in made.get("spots", [])],
        becomes=_becomes(session, take, mend) if is_wanted or (mend and mend.new_take_id) else None,
        new_take_id=mend.new_take_id if mend else None,
        used_by=PersonBrief.model_validate(used_by) if used_by else None,
        used_at=mend.used_at if mend else None,
        mended_from=_mended_from(session, take),
    )


def _state(chance: _Chance | None, mend: Mend | None) -> Any:
    if mend is not None and mend.new_take_id is not None:
        return "used"
    if chance is None or not chance.is_open:
        return "none"
    if mend is not None:
        return mend.state.value
    return "offered" if chance.is_enough else "none"


def _says(chance: _Chance | None, mend: Mend | None) -> str:
    if chance is None:
        return "It has not been checked yet."
    if mend is not None and mend.refusal is not None:
        return mend.refusal
    words = [one["words"] for one in mend.made.get("repairs", [])] if mend else []
    return f"{', '.join(words)[:1].upper()}{', '.join(words)[1:]}." if words else chance.says


def _becomes(session: Session, take: Take, mend: Mend | None) -> int | None:
    if mend is not None and mend.new_take_id is not None:
        made = deliveries.take_by_id(session, mend.new_take_id)
        return made.number if made else None
    return deliveries.last_number(session, take.cue_id, take.variation) + 1 if take.cue_id else None


def _mended_from(session: Session, take: Take) -> MendedFrom | None:
    mend = queries.mend_that_made(session, take.id)
    if mend is None or mend.used_by is None or mend.used_at is None:
        return None
    master = session.get_one(Take, mend.take_id)
    return MendedFrom(
        take_id=master.id,
        number=master.number,
        repairs=[RepairRead.model_validate(one) for one in mend.made.get("repairs", [])],
        used_by=PersonBrief.model_validate(session.get_one(Person, mend.used_by)),
        used_at=mend.used_at,
    )


def _file_name(take: Take, mend: Mend) -> str:
    """Return the name of the new take: as the designer named it, unless the name itself was put right."""
    is_renamed = any(one["kind"] == "name" for one in mend.made.get("repairs", []))
    return str(mend.made["name"]) if is_renamed else take.file_name
