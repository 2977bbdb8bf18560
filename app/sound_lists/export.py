"""The list leaves as the CSV that spreadsheets, CI and our own import read."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from datetime import date

import audio_checks
from app.sound_lists.models import Cue
from app.sound_lists.rules import label, spreadsheet_safe
from app.sound_lists.service import cue_facts

OWN_COLUMNS = (
    "playback_priority",
    "due_on",
    "placeholder",
    "palette",
)  # in the export, besides those that every tool knows


def sound_list_csv(cues: Sequence[Cue], cue_prefix: str) -> str:
    """Return the list as the CSV that spreadsheets, CI and our own import read; no cell is a formula."""
    own = [column for column in OWN_COLUMNS if any(getattr(cue, column) for cue in cues)]
    extras: dict[str, str] = {}  # the first spelling of a column, by the one that readers compare
    for column in (column for cue in cues for column in cue.extra):
        extras.setdefault(column.lower(), column)
    return audio_checks.write_sound_list(_exported(cue, cue_prefix, own, extras) for cue in cues)


def _exported(cue: Cue, cue_prefix: str, own: Sequence[str], extras: Mapping[str, str]) -> audio_checks.CueFacts:
    more = {"description": cue.description, "use": cue.use, "trigger": cue.trigger}
    more |= {column: _plain(getattr(cue, column)) for column in own}
    values = {column.lower(): text for column, text in cue.extra.items()}
    more |= {column: values.get(key, "") for key, column in extras.items()}
    return replace(
        cue_facts(cue),
        number=label(cue_prefix, cue.number),
        name=spreadsheet_safe(cue.name),
        more={spreadsheet_safe(column): spreadsheet_safe(text) for column, text in more.items()},
    )


def _plain(value: bool | int | date | None) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    return "" if value is None else str(value)
