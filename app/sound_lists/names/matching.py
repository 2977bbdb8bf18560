"""The names of a project's list, ready to match files against: built once for each revision of the list."""

from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, field
from typing import Any, TypeVar
from uuid import UUID

from sqlalchemy.orm import Session

import audio_checks
from app.core.lru_cache import LRUCache
from app.projects.models import Project
from app.sound_lists import queries
from app.sound_lists.rules import label

INDEXES_KEPT = 8  # of some 20 MB for 10,000 cues
ANSWERS_KEPT = 4_000  # of each; a tray is read again and again while a thousand files come

Found = TypeVar("Found")  # a match, or None; or guesses


@dataclass(frozen=True)
class MatchedCue:
    """A cue and variation that a file is for or may be for, and why; no variation where its name does not say which."""

    cue_id: UUID
    label: str
    name: str
    stem: str
    variation: int | None
    variations: int
    reason: str
    alternate: int | None = None


@dataclass(frozen=True)
class ListNames:
    """The names of one revision of a list."""

    index: audio_checks.NameIndex
    cues: dict[UUID, audio_checks.ListedCue]
    _answers: LRUCache[tuple[object, ...], tuple[Any]] = field(default_factory=lambda: LRUCache(ANSWERS_KEPT))

    def sure(self, file_name: str, people: Sequence[str], prefixes: Collection[str] = ()) -> MatchedCue | None:
        """Return the one cue and variation that a file is for by its name; None in any doubt."""
        return self._once(self._sure, file_name, tuple(people), frozenset(prefixes))

    def guesses(self, file_name: str, people: Sequence[str], prefixes: Collection[str] = ()) -> list[MatchedCue]:
        """Return up to three cues that a file may be for, the likeliest first."""
        return self._once(self._guesses, file_name, tuple(people), frozenset(prefixes))

    def stem(self, cue_id: UUID, variation: int) -> str:
        """Return the list's name for a variation of a cue."""
        cue = self.cues[cue_id]
        return audio_checks.stems_of(cue.name, cue.file_name, cue.variations)[variation - 1]

    def _once(self, find: Callable[..., Found], *given: object) -> Found:
        """Return the result for these names, from before where they were asked about before."""
        key = (find.__name__, *given)
        kept: tuple[Found] | None = self._answers.get(key)
        return (kept or self._answers.keep(key, (find(*given),)))[0]

    def _sure(self, file_name: str, people: Sequence[str], prefixes: Collection[str]) -> MatchedCue | None:
        match = self.index.sure(file_name, people, prefixes)
        if match is None:
            return None
        return self._matched(UUID(str(match.cue)), match.variation, "the name fits no other", match.alternate)

    def _guesses(self, file_name: str, people: Sequence[str], prefixes: Collection[str]) -> list[MatchedCue]:
        return [
            self._matched(UUID(str(guess.cue)), guess.variation, guess.why, None)
            for guess in self.index.guesses(file_name, people, prefixes)
        ]

    def _matched(self, cue_id: UUID, variation: int | None, reason: str, alternate: int | None) -> MatchedCue:
        cue = self.cues[cue_id]
        stem = self.stem(cue_id, variation or 1)
        return MatchedCue(cue_id, cue.label, cue.name, stem, variation, cue.variations, reason, alternate)


_kept: LRUCache[tuple[object, ...], ListNames] = LRUCache(INDEXES_KEPT)


def list_names(session: Session, project_id: UUID) -> ListNames:
    """Return the names of a project's list as it is now."""
    project = session.get_one(Project, project_id)
    revision = queries.revision_number(session, project_id)
    key = (project_id, revision, project.name, project.cue_prefix)
    names = _kept.get(key)
    if names is None:
        rows = queries.matchable_cues(session, project_id)
        cues = {
            row.id: audio_checks.ListedCue(
                key=row.id,
                name=row.name,
                file_name=row.file_name,
                category=row.category,
                variations=row.variations,
                label=label(project.cue_prefix, row.number),
            )
            for row in rows
        }
        index = audio_checks.NameIndex(cues.values(), [project.name, project.cue_prefix])
        names = ListNames(index, cues)
        _kept.keep(key, names)
    return names
