"""Names of the people of a list, written into cells and read from them."""

from collections import Counter
from collections.abc import Sequence
from typing import NamedTuple
from uuid import UUID

from app.sound_lists.rules import folded, tidy_line
from audio_checks import EMPTY


class ProjectPerson(NamedTuple):
    """A member of the studio, or a designer of the project."""

    id: UUID
    name: str
    email: str
    is_designer: bool


class KnownPeople:
    """The people that a caller may see in a list."""

    def __init__(self, people: Sequence[ProjectPerson]) -> None:
        self._by_id = {person.id: person for person in people}
        self._named = Counter(_key(person.name) for person in people)

    def text_of(self, person_id: UUID | None) -> str:
        """Return a person as a cell has them: the name, or the address where the name is not theirs alone."""
        person = self._by_id.get(person_id) if person_id else None
        if person is None:
            return ""
        key = _key(person.name)
        is_plain = self._named[key] == 1 and key not in EMPTY
        return person.name if is_plain else person.email

    def id_of(self, text: str) -> UUID | None:
        """Return the person that a cell names, None for an empty one; raise ValueError where it is not one person."""
        key = _key(text)
        if key in EMPTY:
            return None
        by_address = [person for person in self._by_id.values() if key in (person.email.casefold(), str(person.id))]
        people = by_address or [person for person in self._by_id.values() if _key(person.name) == key]
        if len(people) > 1:
            raise ValueError(f'{len(people)} people are called "{text[:40]}"; write the email address')
        if not people:
            raise ValueError(f'wanted the name or email address of a person in this project, found "{text[:40]}"')
        return people[0].id


def _key(text: str) -> str:
    return folded(tidy_line(text))
