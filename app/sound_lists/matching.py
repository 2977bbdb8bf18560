"""The names of a project's list, ready to match files against: built once for each revision of the list."""

from collections import OrderedDict
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from threading import Lock
from uuid import UUID

from sqlalchemy.orm import Session

import audio_checks
from app.projects.models import Project
from app.sound_lists import queries
from app.sound_lists.rules import label

INDEXES_KEPT = 8  # of some 20 MB for 10,000 cues


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

    def sure(self, file_name: str, people: Sequence[str], prefixes: Collection[str] = ()) -> MatchedCue | None:
        """Return the one cue and variation that a file is for by its name; None in any doubt."""
        found = self.index.sure(file_name, people, prefixes)
        if found is None:
            return None
        return self._matched(UUID(str(found.cue)), found.variation, "the name fits no other", found.alternate)

    def guesses(self, file_name: str, people: Sequence[str], prefixes: Collection[str] = ()) -> list[MatchedCue]:
        """Return up to three cues that a file may be for, the likeliest first."""
        return [
            self._matched(UUID(str(guess.cue)), guess.variation, guess.why, None)
            for guess in self.index.guesses(file_name, people, prefixes)
        ]

    def _matched(self, cue_id: UUID, variation: int | None, reason: str, alternate: int | None) -> MatchedCue:
        cue = self.cues[cue_id]
        stems = audio_checks.stems_of(cue.name, cue.file_name, cue.variations)
        stem = stems[(variation or 1) - 1]
        return MatchedCue(cue_id, cue.label, cue.name, stem, variation, cue.variations, reason, alternate)


class _Kept:
    """The least recently used list is dropped first; threads may share it."""

    def __init__(self) -> None:
        self._lock = Lock()
        self._names: OrderedDict[tuple[object, ...], ListNames] = OrderedDict()

    def get(self, key: tuple[object, ...]) -> ListNames | None:
        with self._lock:
            if key in self._names:
                self._names.move_to_end(key)
            return self._names.get(key)

    def put(self, key: tuple[object, ...], names: ListNames) -> None:
        with self._lock:
            self._names[key] = names
            while len(self._names) > INDEXES_KEPT:
                self._names.popitem(last=False)


_kept = _Kept()


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
        _kept.put(key, names)
    return names
