"""Stores the reports of the game's CI, and answers them with the approver's waivers."""

from collections.abc import Iterator, Sequence
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.builds import queries
from app.builds.errors import BuildNotFound
from app.builds.models import Build
from app.builds.packs.service import ensure_team_or_build
from app.builds.rules import ensure_storable, is_refused, warnings_in
from app.builds.schemas import WaivedSound
from app.conformance.models import CheckRun
from app.conformance.queries import runs_of, waivers_in
from app.conformance.set_findings import findings_of_sets
from app.core.events import publish
from app.deliveries.models import Take
from app.projects.errors import ProjectNotFound
from app.projects.queries import current_spec
from app.projects.service import project_access
from app.reviews.queries import accepted_takes
from app.sound_lists.rules import label

ACCEPTED_WITH_WARNINGS = "it was approved with this warning"


def save_report(
    session: Session, actor: Actor, project_id: UUID, *, label: str, commit: str, target: str, report: dict[str, Any]
) -> Build:
    """Keep the report of one build, counted by us."""
    access = project_access(session, actor, project_id)
    ensure_team_or_build(access)
    ensure_storable(report)
    build = Build(
        studio_id=access.project.studio_id,
        project_id=project_id,
        label=label,
        commit=commit,
        target=target,
        files=len(report["files"]),
        rejected=sum(is_refused(entry) for entry in report["files"]),
        warnings=sum(warnings_in(entry) for entry in report["files"]),
        report=report,
        token_id=actor.token_id,
    )
    session.add(build)
    session.flush()
    publish(session, "build.posted", studio_id=build.studio_id, build_id=build.id)
    return build


def builds_in(session: Session, actor: Actor, project_id: UUID, *, before: UUID | None, limit: int) -> Sequence[Build]:
    """Return builds of a project without their reports, the newest first."""
    project_access(session, actor, project_id).ensure_team()
    return queries.builds_of(session, project_id, before=before, limit=limit)


def visible_build(session: Session, actor: Actor, build_id: UUID) -> Build:
    """Return a build with its report; raise BuildNotFound without sight of it."""
    build = queries.build_by_id(session, build_id)
    if build is None:
        raise BuildNotFound(f"no build {build_id}")
    try:
        access = project_access(session, actor, build.project_id)
    except ProjectNotFound:
        raise BuildNotFound(f"no build {build_id}") from None
    access.ensure_team()
    return build


def waived_sounds(session: Session, actor: Actor, project_id: UUID) -> list[WaivedSound]:
    """Return the approver's waivers, by the samples of each master and of each game file made of it.

    That is what was waived, and the warnings that approved versions had.
    """
    access = project_access(session, actor, project_id)
    only = access.only_designer_id
    let_through = [
        (set(waiver.codes), waiver.reason, run, take)
        for waiver, run, take in waivers_in(session, project_id)
        if only in (None, take.designer_id)
    ]
    let_through += [
        (codes, ACCEPTED_WITH_WARNINGS, run, take) for codes, run, take in _accepted_warnings(session, project_id, only)
    ]
    renders = queries.render_hashes(session, {take.id for _, _, _, take in let_through})
    return [
        WaivedSound(
            pcm_sha256=pcm_sha256,
            codes=sorted(codes),
            reason=reason,
            cue=label(access.project.cue_prefix, take.cue.number) if take.cue else None,
            file_name=take.file_name,
        )
        for codes, reason, run, take in let_through
        for pcm_sha256 in dict.fromkeys([run.pcm_sha256, *renders[take.id]])
        if pcm_sha256
    ]


def _accepted_warnings(
    session: Session, project_id: UUID, designer_id: UUID | None
) -> Iterator[tuple[set[str], CheckRun, Take]]:
    """Yield the codes of the warnings that each approved version had, over its set too."""
    takes = [take for _, _, take in accepted_takes(session, project_id) if designer_id in (None, take.designer_id)]
    cues = {take.cue.id: take.cue for take in takes if take.cue}
    over_sets = findings_of_sets(
        session, cues.values(), {project_id: current_spec(session, project_id)}, designer_id=designer_id
    )
    runs = {take.id: run for run, take, _ in runs_of(session, [take.id for take in takes])}
    for take in takes:
        run, over_set = runs.get(take.id), over_sets.get(take.id)
        if run is None:
            continue
        findings = [*run.report["findings"], *(over_set.findings if over_set else ())]
        if codes := {str(finding["code"]) for finding in findings if finding["severity"] == "warning"}:
            yield codes, run, take
