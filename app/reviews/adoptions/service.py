"""A folder of shipped files is adopted: its cues, takes and approvals, all at once; and undone, all at once."""

from collections.abc import Iterator, Mapping, Sequence
from pathlib import PurePosixPath
from typing import Any
from uuid import UUID

from sqlalchemy import delete, insert, update
from sqlalchemy.orm import Session

import audio_checks
from app.accounts.rules import Actor
from app.conformance.rules import Report
from app.core import clock, kill_points
from app.core.db import new_id
from app.core.events import publish
from app.core.in_array import in_array
from app.core.plural import counted, verb
from app.deliveries.adoptions import queries as opened
from app.deliveries.adoptions.game_projects import levels_in_words, plays_by_path
from app.deliveries.adoptions.schemas import Adopted, AdoptedSound, AdoptionProgress, SkippedFileRead
from app.deliveries.adoptions.service import (
    adoption_for,
    adoption_read,
    ensure_may_adopt,
    missing_files,
    plan_for,
    scope_of,
)
from app.deliveries.cue_counts.service import update_take_counts
from app.deliveries.errors import AdoptionClosed, AlreadyUndone
from app.deliveries.models import Adoption, Delivery, Take, TakeCounts
from app.deliveries.queries import next_delivery_number
from app.deliveries.rules import TakeState, stored_name
from app.projects.service import ProjectAccess
from app.reviews.adoptions import queries
from app.reviews.errors import AdoptionInUse, FilesMissing, NothingToAdopt, NothingToUndo
from app.reviews.models import GameLevel, Verdict
from app.reviews.rules import VerdictKind
from app.sound_lists.models import Cue
from app.sound_lists.queries import lock_list
from app.sound_lists.rules import TEXTS, label
from app.sound_lists.service import add_cues
from app.sound_lists.undo import undo_addition

Plays = dict[str, list[dict[str, Any]]]  # how the game plays each path
ODD_SHOWN = 200
MESSAGES_SHOWN = 3
UNDONE = "the adoption of its folder was undone"
NO_MONEY = "in use, so adopted without a review, a round or a contract"


def adopt(session: Session, actor: Actor, adoption_id: UUID) -> Adopted:
    """Make cues, takes and approvals of an opened folder, by the list as it is now, and schedule the takes' checks.

    A cue that is in the list already keeps what it has, and so no contract's work is touched.
    """
    adoption, access = adoption_for(session, actor, adoption_id, locked=True)
    ensure_may_adopt(access)
    if adoption.adopted_at is not None:
        raise AdoptionClosed("this folder is adopted already")
    lock_list(session, adoption.project_id)
    plan = plan_for(session, access.project, adoption.files, adoption.game)
    if not plan.cues:
        raise NothingToAdopt("no file of this folder becomes a cue", fix="the plan says why for each file")
    uploaded = opened.finished_uploads(session, adoption.studio_id, scope_of(adoption))
    if missing := missing_files(plan, adoption, uploaded):
        raise FilesMissing(
            f"{counted(len(missing), 'file')} {verb(len(missing), 'is', 'are')} not uploaded yet, "
            f"the first is {missing[0]}",
            fix="upload them, then adopt",
        )
    rows = [
        {"name": cue.name, "file_name": cue.file_name, "category": cue.category, "variations": len(cue.paths)}
        | {"loop": cue.loop, "trigger": _trigger(cue.events)}
        for cue in plan.cues
    ]
    cues = add_cues(session, actor, adoption.project_id, rows)
    placed = list(_placed(plan, adoption, cues))
    plays = plays_by_path(adoption.game, [path for _, _, path, _ in placed]) if adoption.game else {}
    takes = _add_takes(session, access, adoption, placed, uploaded, plays)
    _add_levels(session, adoption, placed, plays)
    adoption.adopted_by, adoption.adopted_at = actor.person, clock.now()
    session.flush()
    session.refresh(adoption, ["adopter"])
    update_take_counts(session, *(cue.id for cue in cues))
    publish(session, "folder.adopted", studio_id=adoption.studio_id, adoption_id=adoption.id)
    kill_points.point("reviews.before_adopted")
    return Adopted(
        **adoption_read(adoption).model_dump(),
        cues=len(cues),
        takes=takes,
        skipped=[SkippedFileRead(**skipped_file._asdict()) for skipped_file in plan.skipped],
    )


def _placed(
    plan: audio_checks.AdoptionPlan, adoption: Adoption, cues: Sequence[Cue]
) -> Iterator[tuple[Cue, int, str, str]]:
    """Yield cue, variation, path and SHA-256 of each adopted file."""
    hashes = {file["path"]: file["sha256"] for file in adoption.files}
    for planned, cue in zip(plan.cues, cues, strict=True):
        for variation, path in enumerate(planned.paths, start=1):
            yield cue, variation, path, hashes[path]


def _add_takes(
    session: Session,
    access: ProjectAccess,
    adoption: Adoption,
    placed: Sequence[tuple[Cue, int, str, str]],
    uploaded: dict[str, tuple[UUID, int]],
    plays: Plays,
) -> int:
    """Add approved takes in one closed delivery, with the verdict on each; return how many."""
    person_id, now = access.actor.person, clock.now()
    of = {"studio_id": adoption.studio_id, "project_id": adoption.project_id}
    delivery = Delivery(
        **of,
        designer_id=person_id,
        number=next_delivery_number(session, adoption.project_id),
        note=f"Adopted from {adoption.folder}",
        closed_at=now,
    )
    session.add(delivery)
    session.flush()
    adoption.delivery_id, action_id = delivery.id, new_id()
    takes: list[dict[str, Any]] = []
    verdicts: list[dict[str, Any]] = []
    used: set[UUID] = set()  # an upload is one take; more files with its bytes are takes without one
    for cue, variation, path, sha256 in placed:
        upload_id, size_bytes = uploaded[sha256]
        take_id = new_id()
        takes.append(
            {**of, "id": take_id, "delivery_id": delivery.id, "designer_id": person_id}
            | {"upload_id": None if upload_id in used else upload_id, "cue_id": cue.id, "variation": variation}
            | {"number": 1, "state": TakeState.APPROVED, "file_name": stored_name(PurePosixPath(path).name)}
            | {"note": _note(path, plays.get(path, [])), "master_sha256": sha256, "master_bytes": size_bytes}
            | {"received_at": now, "state_since": now}
        )
        used.add(upload_id)
        verdicts.append(
            {**of, "id": new_id(), "cue_id": cue.id, "take_id": take_id, "action_id": action_id}
            | {"kind": VerdictKind.APPROVE, "note": NO_MONEY, "state_before": TakeState.RECEIVED}
            | {"since_before": now, "given_by": person_id, "adoption_id": adoption.id, "created_at": now}
        )
    session.execute(insert(Take), takes)
    session.execute(insert(Verdict), verdicts)
    return len(takes)


def _trigger(events: Sequence[str]) -> str:
    """Return the events that begin a sound, as many as the list's field holds."""
    kept = ", ".join(events)
    return kept if len(kept) <= TEXTS["trigger"] else kept[: TEXTS["trigger"] - 1] + "…"


def _note(path: str, plays: Sequence[Mapping[str, Any]]) -> str:
    level = levels_in_words(plays)
    return f"In the game as {path}, played {level}" if level else f"In the game as {path}"


def _add_levels(
    session: Session, adoption: Adoption, placed: Sequence[tuple[Cue, int, str, str]], plays: Plays
) -> None:
    """Record the level at which the game plays each sound: it counts as approved, in manifests for audits."""
    of = {"studio_id": adoption.studio_id, "project_id": adoption.project_id}
    levels = [
        {**of, "cue_id": cue.id, "variation": variation, "plays": plays[path]}
        for cue, variation, path, _ in placed
        if path in plays
    ]
    if levels:
        session.execute(insert(GameLevel), levels)


def undo(session: Session, actor: Actor, adoption_id: UUID) -> Adoption:
    """Remove the cues and approvals that an adoption made; its takes are kept as discarded, with their masters.

    Raises AdoptionInUse once something was built on it: another revision of the list, a verdict, a take or a note.
    """
    adoption, access = adoption_for(session, actor, adoption_id, locked=True)
    ensure_may_adopt(access)
    if adoption.adopted_at is None:
        raise NothingToUndo("this folder was not adopted")
    if adoption.undone_at is not None:
        raise AlreadyUndone("this adoption was undone before")
    lock_list(session, adoption.project_id)
    takes = queries.adopted_takes(session, adoption.id)
    cue_ids = sorted({take.cue_id for take in takes if take.cue_id is not None})
    _ensure_unused(session, adoption, takes, cue_ids)
    take_ids, now = [take.id for take in takes], clock.now()
    _withdraw(session, actor, adoption)
    session.execute(delete(GameLevel).where(in_array(GameLevel.cue_id, cue_ids)))
    session.execute(delete(TakeCounts).where(in_array(TakeCounts.cue_id, cue_ids)))
    session.execute(
        update(Take)
        .where(in_array(Take.id, take_ids))
        .values(
            cue_id=None,
            number=None,
            variation=1,
            state=TakeState.RECEIVED,
            state_since=now,
            discarded_at=now,
            edition=Take.edition + 1,
        )
        .execution_options(synchronize_session=False)
    )
    session.expire_all()
    undo_addition(session, actor, adoption.project_id, cue_ids)
    adoption.undone_by, adoption.undone_at = actor.person, now
    session.flush()
    session.refresh(adoption, ["adopter"])
    return adoption


def _withdraw(session: Session, actor: Actor, adoption: Adoption) -> None:
    """Withdraw the approvals of an adoption; the verdicts stay on record, though their cues go."""
    of: dict[str, Any] = {"studio_id": adoption.studio_id, "project_id": adoption.project_id, "action_id": new_id()}
    withdrawals = [
        {**of, "id": new_id(), "cue_id": verdict.cue_id, "take_id": verdict.take_id, "withdraws_id": verdict.id}
        | {"kind": VerdictKind.WITHDRAW, "note": UNDONE, "state_before": TakeState.APPROVED}
        | {"since_before": verdict.created_at, "given_by": actor.person_id, "created_at": clock.now()}
        for verdict in queries.verdicts_of(session, adoption.id)
    ]
    session.execute(insert(Verdict), withdrawals)


def _ensure_unused(session: Session, adoption: Adoption, takes: Sequence[Take], cue_ids: Sequence[UUID]) -> None:
    fix = "cut the cues that the game does not have instead"
    decided = queries.later_verdicts(session, adoption.id) + sum(take.state is not TakeState.APPROVED for take in takes)
    if decided:
        raise AdoptionInUse("a verdict was given on an adopted sound since", fix=fix)
    if others := queries.other_takes(session, adoption.id, cue_ids):
        files = counted(others, "more file was", "more files were")
        raise AdoptionInUse(f"{files} delivered for adopted cues since", fix=fix)


def progress(session: Session, actor: Actor, adoption_id: UUID) -> AdoptionProgress:
    """Return the progress of the checks of adopted sounds, and the odd ones out."""
    adoption, access = adoption_for(session, actor, adoption_id)
    access.ensure_team()
    counts = queries.counts_of(session, adoption.id)
    odd = queries.checks_to_show(session, adoption.id, ODD_SHOWN)
    prefix = access.project.cue_prefix
    return AdoptionProgress(
        **adoption_read(adoption).model_dump(),
        **counts._asdict(),
        odd=[
            AdoptedSound(
                cue_id=cue_id,
                take_id=take_id,
                label=label(prefix, number),
                file_name=file_name,
                verdict=verdict,
                messages=_messages(report),
            )
            for cue_id, number, take_id, file_name, verdict, report in odd
        ],
    )


def _messages(report: Report) -> list[str]:
    return [str(finding["message"]) for finding in report.get("findings") or []][:MESSAGES_SHOWN]
