"""The list leaves as the CSV that spreadsheets, CI and our own import read."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from datetime import date
from uuid import UUID

import audio_checks
from app.sound_lists.models import Cue
from app.sound_lists.own_columns.rules import Column, key_of
from app.sound_lists.people.rules import KnownPeople
from app.sound_lists.rules import NEW_CUE, PEOPLE, label, spreadsheet_safe
from app.sound_lists.service import cue_facts

OWN_COLUMNS = (
    "need",
    "phase",
    "playback_priority",
    "due_on",
    "placeholder",
    "palette",
)  # in the export, besides those that every tool knows

LANGUAGE = "language"  # of voice lines


def sound_list_csv(
    cues: Sequence[Cue],
    columns: Sequence[Column],
    people: KnownPeople,
    cue_prefix: str,
    languages: Mapping[UUID, str],
) -> str:
    """Return the list as the CSV that spreadsheets, CI and our own import read; no cell is a formula.

    `languages` are those of cues that are voice lines: their files have a folder of the language in the game.
    """
    own = [column for column in OWN_COLUMNS if any(getattr(cue, column) != NEW_CUE[column] for cue in cues)]
    named = {
        column: texts
        for column, fact in PEOPLE.items()
        if any(texts := [people.text_of(getattr(cue, fact)) for cue in cues])
    }
    extras = value_columns(cues, columns)
    if languages:  # a column of the project's own that is called so keeps its values of other cues
        extras = {key: LANGUAGE if name.lower() == LANGUAGE else name for key, name in extras.items()}
    return audio_checks.write_sound_list(
        _exported(
            cue,
            cue_prefix,
            own,
            {column: texts[at] for column, texts in named.items()},
            extras,
            languages.get(cue.id, ""),
        )
        for at, cue in enumerate(cues)
    )


def value_columns(cues: Sequence[Cue], columns: Sequence[Column]) -> dict[str, str]:
    """Return the columns that cues have values in, the project's own first: each name by its `key_of`."""
    names = {key_of(column.name): column.name for column in columns}
    for name in (name for cue in cues for name in cue.extra):
        names.setdefault(key_of(name), name)
    return names


def values_by_key(cue: Cue) -> dict[str, str]:
    """Return a cue's values by the `key_of` their columns."""
    return {key_of(name): text for name, text in cue.extra.items()}


def _exported(
    cue: Cue,
    cue_prefix: str,
    own: Sequence[str],
    named: Mapping[str, str],
    extras: Mapping[str, str],
    language: str,
) -> audio_checks.CueFacts:
    more = {"description": cue.description, "use": cue.use, "trigger": cue.trigger}
    more |= {column: _plain(getattr(cue, column)) for column in own}
    more.update(named)
    values = values_by_key(cue)
    more |= {column: values.get(key, "") for key, column in extras.items()}
    if language:
        more[LANGUAGE] = language
    return replace(
        cue_facts(cue),
        number=label(cue_prefix, cue.number),
        name=spreadsheet_safe(cue.name),
        more={spreadsheet_safe(column): spreadsheet_safe(text) for column, text in more.items()},
    )


def _plain(value: bool | int | date | str | None) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    return "" if value is None else str(value)
