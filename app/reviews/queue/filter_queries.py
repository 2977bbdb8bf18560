"""The cues of the review queue that a filter leaves, as conditions on the takes that wait for them."""

from typing import Any
from uuid import UUID

from sqlalchemy import ColumnElement, and_, exists, func, or_, select, true
from sqlalchemy.orm import aliased

from app.core.icontains import icontains
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.reviews.models import HeardTake
from app.reviews.rules import QueueFilter, QueueKind, VersionKind
from app.sound_lists.models import Cue


def filtered(queue_filter: QueueFilter, person_id: UUID) -> ColumnElement[bool]:
    """Admit the takes of cues that a filter leaves; all takes of a cue or none, so that the queue keeps its order."""
    of_cue: list[ColumnElement[bool]] = []
    if queue_filter.category is not None:
        of_cue.append(Cue.category == queue_filter.category)
    if queue_filter.need is not None:
        of_cue.append(Cue.need == queue_filter.need)
    if queue_filter.due_by is not None:
        of_cue.append(Cue.due_on <= queue_filter.due_by)
    of_cue += [
        or_(icontains(Cue.name, word), icontains(Cue.description, word), icontains(Cue.use, word))
        for word in queue_filter.text.split()
    ]
    if queue_filter.kind is not None:
        of_cue.append(Cue.variations > 1 if queue_filter.kind is QueueKind.SET else Cue.variations == 1)
    parts: list[ColumnElement[bool]] = []
    if of_cue:
        parts.append(exists().where(Cue.id == Take.cue_id, *of_cue).correlate(Take))
    other = aliased(Take)
    waits = (other.cue_id == Take.cue_id, other.state == TakeState.CONFORMING)
    if queue_filter.designer_id is not None:
        parts.append(exists().where(*waits, other.designer_id == queue_filter.designer_id).correlate(Take))
    if queue_filter.kind in (QueueKind.SINGLE, QueueKind.ALTERNATES):
        number = select(func.count()).select_from(other).where(*waits).correlate(Take).scalar_subquery()
        parts.append(number > 1 if queue_filter.kind is QueueKind.ALTERNATES else number == 1)
    if queue_filter.version is not None:
        answers = _answers_a_change(waits, other)
        parts.append(answers if queue_filter.version is VersionKind.NEW else ~answers)
    if queue_filter.unheard:
        heard = exists().where(HeardTake.take_id == other.id, HeardTake.person_id == person_id).correlate(other)
        parts.append(exists().where(*waits, ~heard).correlate(Take))
    return and_(true(), *parts)


def _answers_a_change(waits: tuple[ColumnElement[bool], ...], later: Any) -> ColumnElement[bool]:
    """Admit takes of cues of which a version waits that came after one for which a change was requested."""
    before = aliased(Take)
    asked = exists().where(
        before.cue_id == later.cue_id,
        before.variation == later.variation,
        before.number < later.number,
        before.state == TakeState.CHANGE_REQUESTED,
    )
    return exists().where(*waits, asked.correlate(later)).correlate(Take)
