"""The changes to a master, and the findings that they answer."""

from dataclasses import dataclass, field, replace
from typing import Literal

from audio_checks.fixing import offers
from audio_checks.fixing.names import valid_name
from audio_checks.fixing.offers import RepairKind, fix_offer
from audio_checks.report.findings import FileReport, Finding
from audio_checks.spec.delivery_spec import DeliverySpec


@dataclass(frozen=True)
class Plan:
    """Changes to the sound, and the findings that they answer."""

    name: str
    gain_db: float = 0.0
    cut_head: int = 0
    cut_tail: int = 0
    silent_head: int = 0  # frames of silence that stay, in which a fade may lie
    silent_tail: int = 0
    depth: int | None = None
    rewrites_header: bool = False  # with correct sizes
    removes_offset: bool = False
    keeps_offset: str = ""  # why it stays, as a sentence
    answers: dict[RepairKind, tuple[Finding, ...]] = field(default_factory=dict)

    @property
    def does_something(self) -> bool:
        """Whether any finding is answered."""
        return bool(self.answers)

    def extended(self, report: FileReport, view: DeliverySpec) -> "Plan":
        """Return the plan with what a report, of the master or of the last copy, asks in addition."""
        plan = self
        gains = [0.0]
        for finding in report.findings:
            offer = fix_offer(finding, report, view)
            if offer.repair is None or (offer.repair == "offset" and self.keeps_offset):
                continue
            plan = plan._with(offer.repair, finding)
            if offer.repair == "gain":
                gains.append(-offers.excess_db(finding))
            elif offer.repair == "head":
                plan = plan._trimmed("head", finding, report)
            elif offer.repair == "tail":
                plan = plan._trimmed("tail", finding, report)
            elif offer.repair == "depth":
                plan = replace(plan, depth=offers.accepted_depth(report, view))
            elif offer.repair == "offset":
                plan = replace(plan, removes_offset=True)
            elif offer.repair == "name":
                plan = replace(plan, name=valid_name(plan.name, view) or plan.name)
            else:
                plan = replace(plan, rewrites_header=True)
        lowest = min(gains)
        return replace(plan, gain_db=plan.gain_db + (lowest if lowest < 0 else max(gains)))

    def without_offset(self, why: str) -> "Plan":
        """Return the plan that leaves the offset as it is, for a reason."""
        answers: dict[RepairKind, tuple[Finding, ...]] = {
            kind: findings for kind, findings in self.answers.items() if kind != "offset"
        }
        return replace(self, removes_offset=False, keeps_offset=why, answers=answers)

    def _with(self, kind: RepairKind, finding: Finding) -> "Plan":
        answers = self.answers.get(kind, ())
        if any(known_finding.code == finding.code for known_finding in answers):
            return self
        return replace(self, answers={**self.answers, kind: (*answers, finding)})

    def _trimmed(self, end: Literal["head", "tail"], finding: Finding, report: FileReport) -> "Plan":
        over = offers.frames_over(finding, report)
        rate = (report.facts or {})["sample_rate_hz"]
        stays = round((finding.measured or 0.0) * rate / 1000) - over
        if end == "head":
            return replace(self, cut_head=self.cut_head + over, silent_head=stays)
        return replace(self, cut_tail=self.cut_tail + over, silent_tail=stays)
