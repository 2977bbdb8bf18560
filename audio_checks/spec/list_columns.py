"""The reading of a sound list's columns, by their heads and their cells, and the names that its rows give."""

import re
import unicodedata
from collections.abc import Sequence
from dataclasses import dataclass, replace

from audio_checks.spec.list_cells import (
    PLAIN,
    SAMPLED,
    CellContext,
    is_broken_formula,
    is_day_first,
    says_loop,
    says_need,
    unreadable,
)
from audio_checks.spec.list_heads import head_of
from audio_checks.spec.sound_names import AUDIO_SUFFIXES, slug, stems_of
from audio_checks.system.plural import counted, verb

SHOWN_CELLS = 3
ASSET_ENDINGS = frozenset({".uasset", ".asset", ".meta", ".wem", ".fsb", ".bank", ".import"})  # made of a sound
FIELD_WORDS = {
    **dict.fromkeys(("duration_s", "duration_min_s", "duration_max_s"), "lengths"),
    "frame_rate_fps": "frame rates",
    "variations": "whole numbers",
    "playback_priority": "whole numbers",
    "state": "concept, prototype, locked or cut",
    "reverb": "dry, designed-tail or separate-tail",
    "channels": "mono or stereo",
    "phase": "concept, palette, alpha, beta or gold",
    "need": "must, should or wish",
    "due_on": "days",
}


@dataclass(frozen=True)
class ColumnGuess:
    """The reading of a column."""

    field: str | None  # None: nothing that a list has a field for
    context: CellContext = PLAIN
    is_ours: bool = False  # its head is written exactly as we export it
    note: str = ""  # what was guessed beyond the head, or why the column is none of the field that its head names


def guess_column(name: str, cells: Sequence[str], rates: CellContext, *, has_rate_column: bool = False) -> ColumnGuess:
    """Return the reading of a column.

    Parameters
    ----------
    name : str
        Its head.
    cells : sequence of str
        Its cells, empty ones too.
    rates : CellContext
        The rates and the order of day and month that the caller knows.
    has_rate_column : bool
        Whether rows say their own frame rate.
    """
    head = head_of(name)
    day_first = rates.day_first if rates.day_first is not None else is_day_first(cells)
    context = replace(rates, unit_s=head.unit_s, counted=head.counted, day_first=day_first)
    field, note = head.field, head.note
    if field is None:
        return ColumnGuess(None, context, note=note)
    if head.is_ours:
        return ColumnGuess(field, context, is_ours=True)
    if field == "category" and says_loop(cells):
        field, note = "loop", "every cell says loop or one-shot"
    elif field == "playback_priority" and says_need(cells):
        field, note = "need", "its cells say how much a sound is needed, not which sound an engine drops first"
    elif field == "playback_priority":
        note = "numbers: which sound an engine drops first; map the column to need if they say what the game needs"
    if head.counted and not _has_rate(head.counted, rates, has_rate_column=has_rate_column):
        rate = "frame rate" if head.counted == "frames" else "sample rate"
        return ColumnGuess(None, context, note=f"a length in {head.counted}; say the {rate} to read it")
    if head.counted == "samples":
        note = f"{note} at {rates.sample_rate_hz:,g} Hz"
    filled = [cell for cell in cells if cell.strip() and not is_broken_formula(cell)][:SAMPLED]
    judged = replace(context, counted="") if has_rate_column else context
    wrong = unreadable(field, filled, judged)
    if 2 * len(wrong) > len(filled):
        shown = ", ".join(f'"{cell[:30]}"' for cell in dict.fromkeys(wrong[:SHOWN_CELLS]))
        words = FIELD_WORDS.get(field, "yes or no")
        not_read = f"{len(wrong)} of {counted(len(filled), 'cell')} {verb(len(wrong), 'is', 'are')}"
        return ColumnGuess(None, context, note=f"{not_read} not {words}: {shown}")
    return ColumnGuess(field, context, note=note)


def _has_rate(counted: str, rates: CellContext, *, has_rate_column: bool) -> bool:
    if counted == "frames":
        return bool(rates.frame_rate_fps) or has_rate_column
    return bool(rates.sample_rate_hz)


def _ending_of(file: str) -> str:
    """Return the ending of a sound file; empty for any other text."""
    ending = "." + file.strip().rpartition(".")[2].lower()
    return ending if ending in AUDIO_SUFFIXES else ""


def _stem_of(file: str) -> str:
    name = re.split(r"[/\\]", file.strip())[-1]
    return unicodedata.normalize("NFC", name[: -len(_ending_of(name))])


@dataclass(frozen=True)
class RowNames:
    """The names that a row gives its cue."""

    name: str
    file_name: str
    note: str = ""  # what was taken away, and from what
    variations: int | None = None  # where the row names several files, which are one numbered set


def names_in_row(name: str, file_name: str) -> RowNames:
    """Return the names of a row's cue: a name that is a file's names the file too, and no folder is part of a name.

    `laser.wav` in the column of names is the cue `laser`, whose file is `laser.wav`. `hit_01.wav, hit_02.wav` in the
    column of files are two variations of `hit`.

    Raises
    ------
    ValueError
        The row names several files that are no numbered set.
    """
    notes = []
    files = [part for part in re.split(r"[,;|\n]", file_name) if _ending_of(part)]
    if len(files) > 1:
        stems = [_stem_of(part) for part in files]
        base = re.sub(r"[_\s-]*\d+$", "", stems[0])
        if not base or stems != stems_of("", base, len(stems)):
            raise ValueError(
                f'"{file_name.strip()[:80]}" are {len(files)} files and no set such as hit_01.wav, hit_02.wav; '
                "give each a row of its own"
            )
        note = f"{len(files)} files are the variations of {base}"
        named = names_in_row(name, base)
        return RowNames(named.name, base, "; ".join(filter(None, (note, named.note))), len(files))
    bare_file = re.split(r"[/\\]", file_name.strip())[-1]
    if bare_file != file_name.strip() and bare_file:
        notes.append(f'"{file_name.strip()[:80]}" is read as {bare_file[:80]}; folders are not part of a name')
        file_name = bare_file
    asset, dot, ending = file_name.strip().rpartition(".")
    if asset and (dot + ending).lower() in ASSET_ENDINGS:
        notes.append(f'"{file_name.strip()[:80]}" is read as {asset[:80]}; the ending is that of an engine\'s asset')
        file_name = asset
    stem, dot, ending = name.strip().rpartition(".")
    if stem and (dot + ending).lower() in AUDIO_SUFFIXES | ASSET_ENDINGS:
        bare = unicodedata.normalize("NFC", re.split(r"[/\\]", stem)[-1]).strip()
        if bare:
            notes.append(f'"{name.strip()[:80]}" is read as {bare[:80]}; the ending is not part of a name')
            if not file_name.strip() and slug(bare) != bare:
                file_name = bare
            name = bare
    return RowNames(name, file_name, "; ".join(notes))
