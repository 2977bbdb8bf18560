"""Revisions of the list, compared."""

from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.projects.service import ProjectAccess
from app.sound_lists import queries
from app.sound_lists.errors import RevisionNotFound
from app.sound_lists.models import Cue
from app.sound_lists.people.rules import KnownPeople
from app.sound_lists.people.service import known_people
from app.sound_lists.rules import NEW_CUE, PEOPLE, CueState, Facts, label
from app.sound_lists.schemas import CueDifference, FieldChange, ListComparison


def compare_revisions(session: Session, access: ProjectAccess, first: int, last: int) -> ListComparison:
    """Return the additions, changes and cuts after revision `first`, up to revision `last`."""
    newest = queries.revision_number(session, access.project.id)
    for number in (first, last):
        if not 0 <= number <= newest:
            raise RevisionNotFound(f"the list has no revision {number}; its newest is {newest}")
    if first > last:
        raise RevisionNotFound(f"revision {first} is newer than {last}; name the older one first")
    people = known_people(session, access)
    cues: dict[UUID, Cue] = {}
    before: dict[UUID, Facts] = {}
    after: dict[UUID, Facts] = {}
    new: set[UUID] = set()
    for change, cue in queries.changes_between(session, access.project.id, first, last):
        if cue.id not in cues and not change.before:
            new.add(cue.id)
        cues[cue.id] = cue
        for fact, value in change.before.items():
            before.setdefault(cue.id, {}).setdefault(fact, value)
        after.setdefault(cue.id, {}).update(change.after)
    compared = ListComparison(from_revision=first, to_revision=last, added=[], changed=[], cut=[])
    for cue_id, cue in sorted(cues.items(), key=lambda item: (item[1].position, item[1].number)):
        facts = after[cue_id]
        old = dict(NEW_CUE) if cue_id in new else before.get(cue_id, {})
        changes = [
            shown
            for fact, value in facts.items()
            if fact in NEW_CUE and value != old.get(fact)
            if (shown := _change(fact, None if cue_id in new else old.get(fact), value, people))
        ]
        is_cut = facts.get("state") == CueState.CUT
        if not (changes or cue_id in new):
            continue  # changed and changed back
        group = compared.cut if is_cut and cue_id not in new else compared.added if cue_id in new else compared.changed
        group.append(
            CueDifference(
                id=cue.id,
                number=cue.number,
                label=label(access.project.cue_prefix, cue.number),
                name=facts.get("name", cue.name),
                changes=changes,
                cut_reason=facts.get("cut_reason"),
            )
        )
    return compared


def _change(fact: str, before: Any, after: Any, people: KnownPeople) -> FieldChange | None:
    """Return a change as the caller may see it, None for one of people whom they may not know."""
    if fact in PEOPLE.values():
        before, after = (
            people.text_of(UUID(person_id)) or None if person_id else None for person_id in (before, after)
        )
        if before == after:
            return None
    return FieldChange(field=fact, before=before, after=after)
