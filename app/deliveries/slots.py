"""The cue and variation of a file: as given, as its name says, or the first empty one."""

import dataclasses
from collections.abc import Sequence
from dataclasses import dataclass
from uuid import UUID

from sqlalchemy.orm import Session

from app.deliveries import queries
from app.deliveries.models import Take
from app.deliveries.rules import alternate_of, base_name, ensure_variation, named_for, stems_to_try, variation_for_name
from app.deliveries.schemas import CueGuess
from app.projects.service import ProjectAccess
from app.sound_lists import service as sound_lists
from app.sound_lists.models import Cue
from app.sound_lists.names.matching import ListNames, MatchedCue, list_names


@dataclass(frozen=True)
class Slot:
    """The place in the list that a file is for."""

    cue: Cue
    variation: int
    alternate: int | None


def slot_given(session: Session, access: ProjectAccess, cue_id: UUID, variation: int | None, file_name: str) -> Slot:
    """Return the given place; without a variation the one in the file's name, else the first empty one."""
    cue = sound_lists.cue_for(session, access, cue_id)
    if variation is None:
        variation = variation_for_name(file_name, cue.variations, queries.filled_variations(session, [cue.id])[cue.id])
    ensure_variation(variation, cue.variations)
    return Slot(cue, variation, alternate_of(file_name))


def slot_of_stem(session: Session, project_id: UUID, file_name: str) -> Slot | None:
    """Return the place whose name a file has letter for letter, but for its alternate and typed version."""
    for stem, alternate in stems_to_try(file_name):
        if (matched := sound_lists.slot_by_stem(session, project_id, stem)) is not None:
            return Slot(*matched, alternate)
    return None


def slot_named(session: Session, project_id: UUID, file_name: str, designer: str) -> Slot | None:
    """Return the place given by a file's name; None if it is in any doubt."""
    if base_name(file_name) == file_name:  # a folder in the path may name another cue
        slot = slot_of_stem(session, project_id, file_name)
        if slot is not None:
            return slot
    sure = list_names(session, project_id).sure(file_name, [designer])
    if sure is None or sure.variation is None:
        return None
    return Slot(session.get_one(Cue, sure.cue_id), sure.variation, sure.alternate)


@dataclass(frozen=True)
class Matching:
    """The places by the names of files in a tray, each in the context of the others."""

    names: ListNames
    prefixes: frozenset[str]

    def sure(self, take: Take) -> MatchedCue | None:
        """Return the one cue and variation that a take is for by its name; None in any doubt."""
        return self.names.sure(take.file_name, [take.designer.name], self.prefixes)

    def guesses(self, take: Take) -> list[CueGuess]:
        """Return up to three cues that a take may be for, the likeliest first."""
        likely_slots = self.names.guesses(take.file_name, [take.designer.name], self.prefixes)
        return [guess_slot(take, slot) for slot in likely_slots]


def matching_for(session: Session, project_id: UUID, designer_id: UUID | None) -> Matching:
    """Return the matching for the names in a project's tray, with the prefixes that they share."""
    names = list_names(session, project_id)
    return Matching(names, names.index.shared_prefixes(queries.tray_names(session, project_id, designer_id)))


def guess_slot(take: Take, match: MatchedCue) -> CueGuess:
    """Return a match as it is answered, with the name that the file is going to have."""
    becomes = named_for(take.file_name, match.stem) if match.variation is not None else None
    facts = dataclasses.asdict(match)
    return CueGuess(**{name: facts[name] for name in facts.keys() & CueGuess.model_fields.keys()}, becomes=becomes)


def stems_of_slots(session: Session, slots: Sequence[Slot]) -> list[str | None]:
    """Return the stems that the list gives to places, in their order; None for a cut cue, which has none."""
    owned = sound_lists.stems_by_cue(session, {slot.cue.id for slot in slots})
    stems = {cue_id: dict(of_cue) for cue_id, of_cue in owned.items()}
    return [stems.get(slot.cue.id, {}).get(slot.variation) for slot in slots]
