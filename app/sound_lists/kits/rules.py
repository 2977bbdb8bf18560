"""Starter kits: cues of a kind of game, read from files beside this module, under names that a spec asks for."""

import csv
import tomllib
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from io import StringIO
from typing import Any, Protocol

FOLDER = files("app.sound_lists.kits") / "kit_files"
NUMBER_TOKENS = ("variation", "number", "take")  # their digits are added for each variation of a set


class Token(Protocol):
    """One part of a name, as a spec has it."""

    @property
    def name(self) -> str:
        """Return its name."""

    @property
    def one_of(self) -> tuple[str, ...]:
        """The only words it may be; empty for any."""

    @property
    def digits(self) -> int | None:
        """It is a number of so many digits."""

    @property
    def case(self) -> str:
        """The case of its letters."""

    @property
    def optional(self) -> bool:
        """Whether it may be left out."""

    @property
    def repeats(self) -> bool:
        """Whether more of its kind may follow."""


@dataclass(frozen=True)
class KitCue:
    """One cue of a kit, under no name of a file yet."""

    name: str
    parts: tuple[str, ...]  # what it is, then details
    category: str
    duration_s: float
    loop: bool
    variations: int
    use: str
    description: str


@dataclass(frozen=True)
class Kit:
    """Cues to start a list of one kind of game from; the ranges are guesses."""

    key: str
    name: str
    about: str
    cues: tuple[KitCue, ...]
    usual_cues: tuple[int, int]
    usual_hours: tuple[int, int]
    usual_memory_mb: tuple[int, int]


@cache
def all_kits() -> Sequence[Kit]:
    """Return every kit, by name."""
    heads = tomllib.loads((FOLDER / "kits.toml").read_text(encoding="utf-8"))
    return sorted((_kit(key, head) for key, head in heads.items()), key=lambda kit: kit.name)


def kit_of(key: str) -> Kit | None:
    """Return a kit by its key."""
    return next((kit for kit in all_kits() if kit.key == key), None)


def _kit(key: str, head: dict[str, Any]) -> Kit:
    lines = (FOLDER / f"{key}.csv").read_text(encoding="utf-8").splitlines()
    return Kit(
        key=key,
        name=head["name"],
        about=head["about"],
        cues=tuple(_cue(row) for row in csv.DictReader(lines, delimiter=";")),
        usual_cues=tuple(head["cues"]),
        usual_hours=tuple(head["hours"]),
        usual_memory_mb=tuple(head["memory_mb"]),
    )


def _cue(row: dict[str, str]) -> KitCue:
    return KitCue(
        name=row["name"],
        parts=tuple(row["file"].split()),
        category=row["category"],
        duration_s=float(row["duration_s"]),
        loop=row["loop"] == "yes",
        variations=int(row["variations"]),
        use=row["use"],
        description=f"{row['description']}.",
    )


def csv_of(kit: Kit) -> str:
    """Return a kit as CSV that an import reads."""
    written = StringIO()
    table = csv.writer(written, lineterminator="\n")
    table.writerow(["name", "file_name", "category", "duration_s", "loop", "variations", "use", "description"])
    for cue in kit.cues:
        facts = (cue.category, cue.duration_s, "yes" if cue.loop else "no", cue.variations, cue.use, cue.description)
        table.writerow([cue.name, file_name_of(cue, (), "_"), *facts])
    return written.getvalue()


def file_name_of(cue: KitCue, tokens: Sequence[Token], separator: str) -> str:
    """Return a cue's file name without its ending, built from the parts of a spec; joined by `_` where it has none.

    The number of a variation is left out, since each variation of a set gets its own.
    """
    if not tokens:
        return "_".join(cue.parts)
    words = list(cue.parts)
    named: list[str] = []
    letters = [token for token in tokens if not token.one_of and token.digits is None and token.name != "category"]
    for token in tokens:
        if token.digits is not None:
            if not token.optional and token.name not in NUMBER_TOKENS:
                named.append("1".zfill(token.digits))
        elif token.one_of:
            named.extend(_word_of(token, cue.category))
        elif token.name == "category":
            named.append(_cased(cue.category.replace("-", ""), token.case))
        elif words:
            is_last = token is letters[-1]
            taken = words if is_last else words[:1]
            words = words[len(taken) :]
            cased = [_cased(word, token.case) for word in taken]
            named.extend(cased if token.repeats else ["".join(cased)])
        elif not token.optional:
            named.append(_cased(cue.category.replace("-", ""), token.case))
    return separator.join(named)


def _word_of(token: Token, category: str) -> list[str]:
    fitting = [word for word in token.one_of if category.startswith(word.lower()) or word.lower().startswith(category)]
    if fitting:
        return fitting[:1]
    return [] if token.optional else [token.one_of[0]]


def _cased(word: str, case: str) -> str:
    return word.upper() if case == "upper" else word.capitalize() if case == "capital" else word
