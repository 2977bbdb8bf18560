"""Where each phase stands: its cues, the gate before it, what is missing and who must act."""

from collections import Counter
from collections.abc import Mapping
from uuid import UUID

from sqlalchemy import or_
from sqlalchemy.orm import Session

from app.accounts.queries import people_by_id
from app.accounts.rules import Actor
from app.dashboards.phases import queries
from app.dashboards.phases.rules import PhaseAct, PhaseCount, act_for, open_phases
from app.dashboards.phases.schemas import PhaseAwaited, PhaseRead, PhasesRead
from app.dashboards.progress.queries import ListRow, list_rows
from app.dashboards.progress.service import status_of
from app.dashboards.rules import CueStatus
from app.projects.approval.service import approval_rights
from app.projects.service import ProjectAccess, project_access
from app.reviews.palette_approvals.queries import newest_approval
from app.reviews.palette_approvals.schemas import PaletteApprovalRead
from app.sound_lists.models import Cue
from app.sound_lists.rules import CueState, Phase


def phases(session: Session, actor: Actor, project_id: UUID) -> PhasesRead:
    """Return the phases that have cues, in order; a designer reads the same figures, and of people the approver."""
    access = project_access(session, actor, project_id)
    in_phases = or_(Cue.phase.is_not(None), Cue.palette)
    rows = [
        row
        for row in list_rows(session, project_id, access.project.studio_id, only=in_phases)
        if row.state is not CueState.CUT
    ]
    if not any(row.phase for row in rows):  # a palette alone makes no phases
        rows = []
    statuses = {row.id: status_of(row) for row in rows}
    of_phase = {phase: [row for row in rows if _phase_of(row) is phase] for phase in Phase}
    palette = [row for row in rows if row.palette]
    approval = newest_approval(session, project_id)
    is_complete = bool(palette) and all(statuses[row.id] is CueStatus.ACCEPTED for row in palette)
    is_approved = approval is not None and is_complete and {str(row.id) for row in palette} <= set(approval.cue_ids)
    counts = [
        PhaseCount(
            phase,
            len(phase_rows),
            sum(statuses[row.id] is CueStatus.ACCEPTED for row in phase_rows),
            waits_for_approval=phase is Phase.PALETTE and bool(palette) and not is_approved,
        )
        for phase, phase_rows in of_phase.items()
        if phase_rows
    ]
    opened = open_phases(counts)
    awaited = _Awaited(session, access, statuses)
    return PhasesRead(
        phases=[
            PhaseRead(
                phase=count.phase,
                cues=count.cues,
                accepted=count.accepted,
                is_open=count.phase in opened,
                is_done=count.is_done,
                awaited=awaited.of_phase(
                    of_phase[count.phase], approves_palette=count.waits_for_approval and is_complete
                ),
            )
            for count in counts
        ],
        palette_approval=PaletteApprovalRead.model_validate(approval) if is_approved else None,
        may_approve_palette=is_complete and not is_approved and awaited.is_approver(actor.person_id),
        closed_cue_ids=[row.id for count in counts if count.phase not in opened for row in of_phase[count.phase]],
    )


def _phase_of(row: ListRow) -> Phase | None:
    return Phase.PALETTE if row.palette else row.phase


class _Awaited:
    """The people who must act on cues, in words."""

    def __init__(self, session: Session, access: ProjectAccess, statuses: Mapping[UUID, CueStatus]) -> None:
        self._statuses = statuses
        self._rights = approval_rights(session, access.project)
        self._is_team = access.is_team
        approvers = {self._rights.approver_id, *self._rights.by_category.values()}
        self._names = {id_: person.name for id_, person in people_by_id(session, approvers).items()}
        self._designers = queries.designers_of_cues(session, access.project.id)
        self._only_designer_id = access.only_designer_id

    def is_approver(self, person_id: UUID | None) -> bool:
        """Whether a person may approve the palette today."""
        return self._is_team and person_id in self._rights.people_for("")

    def of_phase(self, rows: list[ListRow], *, approves_palette: bool) -> list[PhaseAwaited]:
        """Return the people whose acts the cues of a phase wait for, the most first."""
        acts: Counter[tuple[str | None, PhaseAct]] = Counter()
        for row in rows:
            act = act_for(self._statuses[row.id])
            if act is not None:
                acts[self._who(row, act), act] += 1
        if approves_palette:
            acts[self._names[self._rights.approver_id], PhaseAct.APPROVE_PALETTE] = 1
        return [PhaseAwaited(who=who, act=act, count=count) for (who, act), count in acts.most_common()]

    def _who(self, row: ListRow, act: PhaseAct) -> str | None:
        if act is not PhaseAct.DELIVER:
            return self._names[self._rights.approver_of(row.category)]
        designer_id, name = self._designers.get(row.id, (None, None))
        is_hidden = self._only_designer_id not in (None, designer_id)
        return None if is_hidden else name
