"""Findings over files together: looked up when shown. They inform the approver, and return no take."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from uuid import UUID

from sqlalchemy.orm import Session

import audio_checks
from app.conformance import queries
from app.conformance.queries import AnalysedTake
from app.conformance.rules import MemberFact, Report, members_of_set, parsed_spec
from app.core.lru_cache import LRUCache
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.projects.models import Spec
from app.sound_lists.models import Cue
from app.sound_lists.service import cue_facts

Findings = tuple[dict[str, object], ...]
Judged = tuple[str, audio_checks.CueFacts, str]  # spec, cue, takes: nothing else is looked at
# Takes go by their cue's name here, so no two of them are twins.
OVER_A_CUE = ("variation-set", "duplicate", "reverb-set")


@dataclass(frozen=True)
class SetFinding:
    """The findings of a cue's set for one take, and how much louder it is than the other variations."""

    cue_id: UUID
    findings: Findings
    away_lu: float | None


def findings_of_sets(
    session: Session, cues: Iterable[Cue], specs: Mapping[UUID, Spec], *, designer_id: UUID | None = None
) -> dict[UUID, SetFinding]:
    """Return the findings over the sets of some cues by take, by the newest specs of their projects.

    With a designer, only for that designer's takes.
    """
    sets = {cue.id: cue for cue in cues if cue.variations > 1}
    if not sets:
        return {}
    judged = {
        cue_id: (specs[sets[cue_id].project_id].toml, cue_facts(sets[cue_id]), takes)
        for cue_id, takes in queries.sets_of_takes(session, sets, designer_id).items()
    }
    words = {cue_id: _remembered.get(judged[cue_id]) for cue_id in judged}
    unknown: dict[UUID, list[AnalysedTake]] = {cue_id: [] for cue_id, known in words.items() if known is None}
    for take in queries.analysed_takes(
        session, [id_ for cue_id in unknown for id_ in queries.takes_in(judged[cue_id][-1])]
    ):
        if take.cue_id is not None:
            unknown[take.cue_id].append(take)
    for cue_id, takes in unknown.items():
        toml, facts, _ = judged[cue_id]
        words[cue_id] = _remembered.keep(judged[cue_id], _of_one_set(cue_id, takes, parsed_spec(toml), facts))
    return {take_id: word for known in words.values() if known for take_id, word in known.items()}


_remembered: LRUCache[Judged, dict[UUID, SetFinding]] = LRUCache(4_000)  # some 2 kB each


def _of_one_set(
    cue_id: UUID, takes: Sequence[AnalysedTake], spec: audio_checks.DeliverySpec, facts: audio_checks.CueFacts
) -> dict[UUID, SetFinding]:
    chosen = set(
        members_of_set(
            MemberFact(take.id, take.variation, take.alternate, take.number or 0, take.state is TakeState.APPROVED)
            for take in takes
        )
    )
    members = [take for take in takes if take.id in chosen]
    judged = [_judged(take, spec, facts) for take in members]
    finding_sets, away = audio_checks.set_findings(judged), audio_checks.offset_from_set_lu(judged)
    return {
        take.id: SetFinding(cue_id, _plain(findings), off)
        for take, findings, off in zip(members, finding_sets, away, strict=True)
    }


def _judged(
    take: AnalysedTake, spec: audio_checks.DeliverySpec, cue: audio_checks.CueFacts | None
) -> audio_checks.JudgedFile:
    view = spec.for_category(take.category or spec.category_of(take.file_name))
    return audio_checks.JudgedFile(take.report, view, cue, take.variation, is_alternate=take.alternate is not None)


def _plain(findings: Iterable[audio_checks.Finding]) -> Findings:
    return tuple(finding.to_dict() for finding in findings if finding.check in OVER_A_CUE)


def same_sounds(session: Session, take: Take, pcm_sha256: str | None, spec: Spec) -> Findings:
    """Return the finding on a take whose samples came with its delivery before, for another place."""
    if pcm_sha256 is None:
        return ()
    whole = parsed_spec(spec.toml)
    judged = [_judged(same_sound, whole, None) for same_sound in queries.same_sounds(session, take, pcm_sha256)]
    finding_sets = audio_checks.set_findings(judged)
    return _plain(finding_sets[-1]) if finding_sets else ()


def with_set_finding(report: Report, *more: Findings) -> Report:
    """Return a report with what is found over files together, behind its own findings of the same weight."""
    findings = [*report["findings"], *(finding for findings in more for finding in findings)]
    return report | {"findings": sorted(findings, key=lambda finding: finding["severity"] != "error")}
