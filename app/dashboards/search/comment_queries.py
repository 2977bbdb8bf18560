"""Queries of the search: versions with a reason or a label that holds the words that a person typed."""

from collections.abc import Sequence
from dataclasses import dataclass
from uuid import UUID

from sqlalchemy import ColumnElement, or_, select
from sqlalchemy.orm import InstrumentedAttribute, Session, joinedload

from app.accounts.models import Person
from app.accounts.rules import Actor
from app.core.icontains import icontains
from app.core.in_array import in_array
from app.deliveries.models import Take
from app.projects.models import Project
from app.projects.visibility import visible_work
from app.reviews.models import ChangeRequest, GivenReason, Verdict
from app.reviews.reasons.rules import ReasonKind
from app.sound_lists.models import Cue

Table = type[GivenReason] | type[Take]


@dataclass(frozen=True)
class InProject:
    """Work in one project; of one designer where one is given."""

    project_id: UUID
    designer_id: UUID | None

    def conditions(self, table: Table) -> list[ColumnElement[bool]]:
        """Admit rows of this work."""
        of_designer = [] if self.designer_id is None else [table.designer_id == self.designer_id]
        return [table.project_id == self.project_id, *of_designer]


@dataclass(frozen=True)
class Elsewhere:
    """Work that a person sees in some projects."""

    actor: Actor
    project_ids: Sequence[UUID]

    def conditions(self, table: Table) -> list[ColumnElement[bool]]:
        """Admit rows of this work."""
        is_visible = visible_work(
            self.actor, studio_id=table.studio_id, project_id=table.project_id, designer_id=table.designer_id
        )
        return [in_array(table.project_id, self.project_ids), is_visible]


@dataclass(frozen=True)
class FoundReason:
    """A verdict that gave a reason, and where in the sound a change was meant."""

    verdict: Verdict
    take: Take
    cue: Cue
    project: Project
    kind: ReasonKind
    start_s: float | None


@dataclass(frozen=True)
class FoundLabel:
    """A take that has a label, and who set it last."""

    take: Take
    cue: Cue
    project: Project
    by: Person | None


def find_reasons(
    session: Session, reach: InProject | Elsewhere, words: Sequence[str], *, limit: int
) -> list[FoundReason]:
    """Return the newest verdicts of which a reason holds every word."""
    newest = (
        select(GivenReason.verdict_id, GivenReason.kind, GivenReason.change_request_id)
        .distinct()
        .where(*reach.conditions(GivenReason))
        .where(*(_holds(GivenReason.reason, word) for word in words))
        .order_by(GivenReason.verdict_id.desc())
        .limit(limit)
        .subquery()
    )
    rows = session.execute(
        select(Verdict, Take, Cue, Project, newest.c.kind, ChangeRequest.start_s)
        .join(newest, newest.c.verdict_id == Verdict.id)
        .join(Take, Take.id == Verdict.take_id)
        .join(Cue, Cue.id == Verdict.cue_id)
        .join(Project, Project.id == Verdict.project_id)
        .outerjoin(ChangeRequest, ChangeRequest.id == newest.c.change_request_id)
        .options(joinedload(Verdict.author), joinedload(Verdict.represented))
        .order_by(Verdict.id.desc())
    )
    return [FoundReason(*row) for row in rows]


def find_labels(
    session: Session, reach: InProject | Elsewhere, words: Sequence[str], *, limit: int
) -> list[FoundLabel]:
    """Return the newest takes on a cue of which the label holds every word."""
    take_ids = (  # an index of the takes with a label has all that it looks at
        select(Take.id)
        .where(Take.label.is_not(None), *(_holds(Take.label, word) for word in words))
        .where(Take.cue_id.is_not(None), *reach.conditions(Take))
        .order_by(Take.id.desc())
        .limit(limit)
    )
    rows = session.execute(
        select(Take, Cue, Project, Person)
        .join(Cue, Cue.id == Take.cue_id)
        .join(Project, Project.id == Take.project_id)
        .outerjoin(Person, Person.id == Take.labelled_by)
        .where(Take.id.in_(take_ids))
        .order_by(Take.id.desc())
    )
    return [FoundLabel(*row) for row in rows]


def _holds(text: InstrumentedAttribute[str] | InstrumentedAttribute[str | None], word: str) -> ColumnElement[bool]:
    """Admit texts that contain a word, whichever apostrophe it was typed with."""
    spellings = {word, word.replace("'", "’"), word.replace("’", "'")}
    return or_(*(icontains(text, spelling) for spelling in sorted(spellings)))
