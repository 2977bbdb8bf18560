"""Check runs and waivers, read from the database; callers have checked access."""

from collections.abc import Collection, Sequence
from datetime import datetime
from functools import cache
from typing import Any, NamedTuple
from uuid import UUID

from sqlalchemy import (
    ColumnElement,
    Row,
    Select,
    String,
    Update,
    and_,
    bindparam,
    cast,
    exists,
    func,
    select,
    text,
    tuple_,
    update,
)
from sqlalchemy.orm import Session, aliased, joinedload, selectinload
from sqlalchemy.sql.functions import aggregate_strings

import audio_checks
from app.conformance.models import CheckRun, Fix, Split, Waiver
from app.conformance.rules import FIXABLE_STATES
from app.core.in_array import in_array
from app.deliveries.models import DryStem, Take
from app.deliveries.rules import CHECKABLE, TakeState
from app.projects.models import Spec
from app.sound_lists.models import Cue, Stem

STANDING = (TakeState.CONFORMING, TakeState.RETURNED, TakeState.APPROVED)  # in a set: neither refused nor set aside

TAKES_AT_ONCE = 500  # SQLite takes 32,766 variables in a statement, older ones 999


def current_run(session: Session, take_id: UUID) -> CheckRun | None:
    """Return the newest check of a take."""
    return session.scalar(select(CheckRun).where(CheckRun.take_id == take_id, CheckRun.is_current))


def run_with_key(session: Session, studio_id: UUID, key: str) -> CheckRun | None:
    """Return a check of the studio whose result a new one with this key would have."""
    return session.scalar(_run_with_key(), {"studio_id": studio_id, "key": key})


@cache  # what every check of a take asks for is built once: that takes as long as to run it
def _run_with_key() -> Select[CheckRun]:
    of_key = (CheckRun.studio_id == bindparam("studio_id"), CheckRun.key == bindparam("key"))
    return select(CheckRun).where(*of_key, CheckRun.verdict != "unjudged").order_by(CheckRun.id.desc()).limit(1)


class ToCheck(NamedTuple):
    """A take with its cue, and what its check depends on, as of one moment."""

    take: Take
    spec: Spec
    stem: str | None  # that the list gives it
    has_dry_stems: bool  # its delivery, of whatever name


def take_to_check(session: Session, take_id: UUID) -> ToCheck | None:
    """Return a take, the newest spec of its project and what the list calls it; None once its master is deleted."""
    row = session.execute(_to_check(), {"take_id": take_id}).one_or_none()
    return ToCheck._make(row) if row else None


@cache
def _to_check() -> Select[Take, Spec, str, bool]:
    later = aliased(Spec)
    newest = select(later.id).where(later.project_id == Take.project_id).order_by(later.version.desc()).limit(1)
    stems = exists().where(DryStem.delivery_id == Take.delivery_id)
    return (
        select(Take, Spec, Stem.stem, stems)
        .select_from(Take)
        .join(Spec, Spec.id == newest.scalar_subquery())
        .outerjoin(Stem, and_(Stem.cue_id == Take.cue_id, Stem.variation == Take.variation))
        .where(Take.id == bindparam("take_id"), Take.master_deleted_at.is_(None))
        .options(joinedload(Take.cue))
    )


def take_to_judge(session: Session, take_id: UUID) -> tuple[Take, bool] | None:
    """Return a locked take, and whether it was checked before.

    A check that ran while this one waited for the lock has changed the state or the edition too.
    """
    row = session.execute(_to_judge(), {"take_id": take_id}).one_or_none()
    return (row[0], row[1]) if row else None


@cache
def _to_judge() -> Select[Take, bool]:
    checked = exists().where(CheckRun.take_id == Take.id, CheckRun.is_current)
    locked = select(Take, checked).where(Take.id == bindparam("take_id")).with_for_update(of=Take, key_share=True)
    return locked.execution_options(populate_existing=True)


def retire_runs(session: Session, take_id: UUID) -> None:
    """Make room for a new current run."""
    session.execute(_retired(), {"of_take": take_id}, execution_options={"synchronize_session": False})


@cache
def _retired() -> Update:
    current = (CheckRun.take_id == bindparam("of_take"), CheckRun.is_current)
    return update(CheckRun).where(*current).values(is_current=False)


def mark_notified(session: Session, project_id: UUID) -> Sequence[UUID]:
    """Mark a project's checks as notified, and return the takes of which they are the newest."""
    notified = (
        update(CheckRun)
        .where(CheckRun.project_id == project_id, text("needs_notification"))  # as its index says it
        .values(needs_notification=False)
        .returning(CheckRun.take_id, CheckRun.is_current)
    )
    rows = session.execute(notified, execution_options={"synchronize_session": False})
    return [take_id for take_id, is_current in rows if is_current]


def projects_to_notify(session: Session, before: datetime) -> Sequence[UUID]:
    """Return the projects that have checks made before an instant and not notified yet."""
    unnotified = select(CheckRun.project_id).where(text("needs_notification"), CheckRun.created_at < before)
    return session.scalars(unnotified.distinct()).all()


def runs_of(session: Session, take_ids: Collection[UUID]) -> Sequence[Row[CheckRun, Take, Cue | None]]:
    """Return the newest checks of takes, in the order of their making, with the takes and their cues."""
    return session.execute(
        select(CheckRun, Take, Cue)
        .join(Take, Take.id == CheckRun.take_id)
        .outerjoin(Cue, Cue.id == Take.cue_id)
        .where(in_array(CheckRun.take_id, take_ids), CheckRun.is_current)
        .order_by(CheckRun.id)
    ).all()


def waiver_of(session: Session, take_id: UUID) -> Waiver | None:
    """Return the newest waiver of a take, with who gave it."""
    return session.scalar(
        select(Waiver)
        .where(Waiver.take_id == take_id)
        .options(joinedload(Waiver.approver))
        .order_by(Waiver.id.desc())
        .limit(1)
    )


def take_before(session: Session, take: Take) -> Take | None:
    """Return the newest earlier take by the same designer for the same place, if a check could read it."""
    if take.number is None or take.number == 1:
        return None
    return session.scalar(
        select(Take)
        .join(CheckRun, and_(CheckRun.take_id == Take.id, CheckRun.is_current))
        .where(
            *(Take.studio_id == take.studio_id, Take.cue_id == take.cue_id, Take.variation == take.variation),
            *(Take.designer_id == take.designer_id, Take.alternate.is_not_distinct_from(take.alternate)),
            *(Take.number < take.number, CheckRun.verdict.in_(("conforming", "rejected"))),
        )
        .order_by(Take.number.desc())
        .limit(1)
    )


def spec_of(session: Session, run: CheckRun) -> Spec:
    """Return the version of the spec that a check was made by."""
    return session.get_one(Spec, run.spec_id)


def spec_version_of(session: Session, spec_id: UUID) -> int:
    """Return the version of a spec by its id."""
    return session.get_one(Spec, spec_id).version


def checkable_takes(session: Session, project_id: UUID, cue_ids: Sequence[UUID] | None) -> Sequence[UUID]:
    """Return the takes that are not yet decided upon; those of some cues where they are given."""
    query = select(Take.id).where(Take.project_id == project_id, Take.state.in_(CHECKABLE))
    if cue_ids is not None:
        query = query.where(in_array(Take.cue_id, cue_ids))
    return session.scalars(query.order_by(Take.id)).all()


class AnalysedTake(NamedTuple):
    """A take with what checks over files together read of its newest report."""

    id: UUID
    cue_id: UUID | None
    variation: int
    alternate: int | None
    number: int | None
    state: TakeState
    file_name: str
    category: str | None  # of its cue; None, or empty, where there is none
    pcm_sha256: str | None
    facts: dict[str, Any] | None
    findings: list[dict[str, Any]]
    likeness_print: str | None
    integrated_lufs: float | None
    short_loudness_lufs: float | None

    @property
    def report(self) -> audio_checks.FileReport:
        """The report, as far as those checks read it."""
        return audio_checks.FileReport(
            path=self.file_name,
            verdict="conforming",
            pcm_sha256=self.pcm_sha256,
            facts=self.facts,
            measurements={"integrated_lufs": self.integrated_lufs, "short_loudness_lufs": self.short_loudness_lufs},
            findings=tuple(audio_checks.Finding.from_dict(finding) for finding in self.findings),
            likeness_print=self.likeness_print,
        )


def _analysed_takes(session: Session, *where: ColumnElement[bool]) -> list[AnalysedTake]:
    """Return takes in the order in which they came; a few columns, for a page of the queue reads hundreds of them."""
    report = CheckRun.report
    query = (
        select(
            *(Take.id, Take.cue_id, Take.variation, Take.alternate, Take.number, Take.state, Take.file_name),
            Cue.category,
            CheckRun.pcm_sha256,
            report["facts"],
            report["findings"],
            report["likeness_print"].as_string(),
            report[("measurements", "integrated_lufs")].as_float(),
            report[("measurements", "short_loudness_lufs")].as_float(),
        )
        .join(CheckRun, and_(CheckRun.take_id == Take.id, CheckRun.is_current))
        .join(Cue, Cue.id == Take.cue_id, isouter=True)
        .where(*where)
        .order_by(Take.received_at, Take.id)
    )
    return [AnalysedTake._make(row) for row in session.execute(query)]


def analysed_takes(session: Session, take_ids: Collection[UUID]) -> list[AnalysedTake]:
    """Return some takes with what checks over files together read."""
    return _analysed_takes(session, in_array(Take.id, take_ids)) if take_ids else []


def sets_of_takes(session: Session, cue_ids: Collection[UUID], designer_id: UUID | None) -> dict[UUID, str]:
    """Return, for each cue, a text that identifies the checked takes of its sets and all that may change of them.

    A newer check changes the text; reports never change. The database joins the parts, since a page of the list
    asks for a thousand takes, and nearly always for the same as before.
    """
    given = {"cue_ids": cue_ids, "designer_id": designer_id}
    rows = session.execute(_sets_of_takes(designer_id is not None), given)
    return {cue_id: takes for cue_id, takes in rows if cue_id is not None}


def takes_in(takes: str) -> list[UUID]:
    """Return the ids of the takes of a set, from its text."""
    return [UUID(take.partition(" ")[0]) for take in takes.split(",")]


@cache
def _sets_of_takes(is_own: bool) -> Select[UUID | None, str]:
    facts_text: ColumnElement[str] = cast(Take.id, String)
    for fact in (Take.variation, Take.alternate, Take.number, Take.state, CheckRun.id):
        facts_text = facts_text + " " + func.coalesce(cast(fact, String), "")
    access = (
        select(Take.cue_id, facts_text.label("said"))
        .join(CheckRun, and_(CheckRun.take_id == Take.id, CheckRun.is_current))
        .where(in_array(Take.cue_id, "cue_ids"), Take.state.in_(STANDING))
        .order_by(Take.cue_id, Take.id)
    )
    if is_own:
        access = access.where(Take.designer_id == bindparam("designer_id"))
    checks = access.subquery()
    return select(checks.c.cue_id, aggregate_strings(checks.c.said, ",")).group_by(checks.c.cue_id)


def same_sounds(session: Session, take: Take, pcm_sha256: str) -> list[AnalysedTake]:
    """Return a take after those of its delivery that came before with the same samples, and are for another place."""
    analysed = _analysed_takes(
        session,
        Take.delivery_id == take.delivery_id,
        CheckRun.pcm_sha256 == pcm_sha256,
        tuple_(Take.received_at, Take.id) <= tuple_(take.received_at, take.id),
    )
    here = (take.cue_id, take.variation)
    return [
        analysed_take
        for analysed_take in analysed
        if analysed_take.id == take.id
        or analysed_take.cue_id is None
        or (analysed_take.cue_id, analysed_take.variation) != here
    ]


def waivers_in(session: Session, project_id: UUID) -> Sequence[tuple[Waiver, CheckRun, Take]]:
    """Return the waivers of a project with the checks they waived and their takes with cues, the oldest first."""
    rows = session.execute(
        select(Waiver, CheckRun, Take)
        .join(CheckRun, CheckRun.id == Waiver.check_run_id)
        .join(Take, Take.id == Waiver.take_id)
        .where(Waiver.project_id == project_id)
        .options(joinedload(Take.cue))
        .order_by(Waiver.id)
    )
    return [(waiver, run, take) for waiver, run, take in rows]


def takes_with_findings(
    session: Session, project_id: UUID, *, designer_id: UUID | None, limit: int
) -> list[tuple[Take, CheckRun]]:
    """Return the newest takes of each variation that are not decided upon and had findings, with their checks."""
    newer = aliased(Take)
    query = (
        select(Take, CheckRun)
        .join(CheckRun, and_(CheckRun.take_id == Take.id, CheckRun.is_current))
        .where(
            Take.project_id == project_id,
            Take.state.in_(FIXABLE_STATES),
            Take.cue_id.is_not(None),
            ~exists().where(newer.cue_id == Take.cue_id, newer.variation == Take.variation, newer.number > Take.number),
        )
        .options(joinedload(Take.cue))
        .order_by(Take.state_since)
        .limit(limit)
    )
    if designer_id is not None:
        query = query.where(Take.designer_id == designer_id)
    return [(take, run) for take, run in session.execute(query) if run.report["findings"]]


def fixes_of(session: Session, take_ids: Collection[UUID]) -> dict[tuple[UUID, str], Fix]:
    """Return the fixes of takes, by take and by the check that they answer."""
    fixes = session.scalars(select(Fix).where(in_array(Fix.take_id, take_ids)))
    return {(fix.take_id, fix.key): fix for fix in fixes}


def fix_with_key(session: Session, take_id: UUID, key: str) -> Fix | None:
    """Return the fix of a take that answers one check."""
    return session.scalar(select(Fix).where(Fix.take_id == take_id, Fix.key == key))


def fix_by_id(session: Session, fix_id: UUID, *, locked: bool = False) -> Fix | None:
    """Return a fix; locked where it is going to change."""
    query = select(Fix).where(Fix.id == fix_id)
    return session.scalar(query.with_for_update() if locked else query)


def fix_that_made(session: Session, take_id: UUID) -> Fix | None:
    """Return the fix that a take came from."""
    return session.scalar(select(Fix).where(Fix.new_take_id == take_id).order_by(Fix.id.desc()).limit(1))


def made_fix_of(session: Session, take_id: UUID) -> Fix | None:
    """Return the newest fixed copy of a take."""
    return session.scalar(
        select(Fix).where(Fix.take_id == take_id, Fix.sha256.is_not(None)).order_by(Fix.id.desc()).limit(1)
    )


def takes_with_finding(session: Session, take_ids: Collection[UUID], code: str) -> set[UUID]:
    """Return those of some takes that had a finding of this code in their newest check."""
    matching_ids: set[UUID] = set()
    ids = list(take_ids)
    has_code = CheckRun.report["findings"].as_string().contains(f'"{code}"')
    for start in range(0, len(ids), TAKES_AT_ONCE):
        of = CheckRun.take_id.in_(ids[start : start + TAKES_AT_ONCE])
        matching_ids |= set(session.scalars(select(CheckRun.take_id).where(of, CheckRun.is_current, has_code)))
    return matching_ids


def split_by_id(session: Session, split_id: UUID, *, locked: bool = False) -> Split | None:
    """Return a split; locked where it is going to change."""
    query = select(Split).where(Split.id == split_id)
    return session.scalar(query.with_for_update() if locked else query)


def split_with_pause(session: Session, take_id: UUID, shortest_pause_s: float) -> Split | None:
    """Return the split of a take at pauses of a length."""
    return session.scalar(select(Split).where(Split.take_id == take_id, Split.shortest_pause_s == shortest_pause_s))


def newest_split(session: Session, take_id: UUID) -> Split | None:
    """Return the split of a take that was asked for last, with its parts."""
    of_take = select(Split).where(Split.take_id == take_id).options(selectinload(Split.parts))
    return session.scalar(of_take.order_by(Split.asked_at.desc(), Split.id.desc()).limit(1))


def takes_of_several_sounds(
    session: Session, project_id: UUID, *, designer_id: UUID | None, limit: int
) -> list[tuple[Take, CheckRun]]:
    """Return the takes not decided upon whose newest check may have found several sounds, longest waiting first."""
    report = cast(CheckRun.report, String)
    query = (
        select(Take, CheckRun)
        .join(CheckRun, and_(CheckRun.take_id == Take.id, CheckRun.is_current))
        .where(
            Take.project_id == project_id,
            Take.state.in_(FIXABLE_STATES),
            Take.discarded_at.is_(None),
            report.contains('"internal-silence:pause"') | report.contains('"cue_points"'),
        )
        .options(joinedload(Take.cue))
        .order_by(Take.state_since)
        .limit(limit)
    )
    if designer_id is not None:
        query = query.where(Take.designer_id == designer_id)
    return [(take, run) for take, run in session.execute(query)]
