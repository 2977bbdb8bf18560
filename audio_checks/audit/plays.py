"""The level at which a game plays its sounds, against the level that was approved."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from audio_checks.audit.changelists import Changelist
from audio_checks.middleware.values import Part, PlayedSound

LEAST_DB = 0.05  # of a part that has moved; factors are written with some digits


@dataclass(frozen=True)
class ApprovedPlayback:
    """One object's playback of a sound when it was approved.

    Attributes
    ----------
    object_path : str
        In the project's tree.
    gain_db : float or None
        None where a script set it.
    parts : tuple of (str, str, float)
        Object, property and gain of each part other than 0 dB.
    """

    object_path: str
    gain_db: float | None
    parts: tuple[tuple[str, str, float], ...] = ()


@dataclass(frozen=True)
class MovedPart:
    """A gain that is another than when the sound was approved."""

    object_path: str
    name: str
    approved_db: float
    gain_db: float
    file: str = ""
    anchor: str = ""
    changelist: Changelist | None = None

    @property
    def by_db(self) -> float:
        """Return its present rise in level."""
        return self.gain_db - self.approved_db

    def to_dict(self) -> dict[str, Any]:
        """Return the part as JSON has it."""
        return {
            "object": self.object_path,
            "property": self.name,
            "file": self.file,
            "approved_db": round(self.approved_db, 2) + 0.0,
            "gain_db": round(self.gain_db, 2) + 0.0,
            "changelist": None if self.changelist is None else self.changelist.to_dict(),
        }


@dataclass(frozen=True)
class Play:
    """One way in which the game plays a sound, held to the approved one.

    Attributes
    ----------
    sound : PlayedSound
        As the project plays it.
    approved_db : float or None
        The gain that was approved; None where a script set it, now or then.
    moved : tuple of MovedPart
        What makes the difference.
    """

    sound: PlayedSound
    approved_db: float | None = 0.0
    moved: tuple[MovedPart, ...] = ()

    @property
    def drift_db(self) -> float | None:
        """Return the excess of the game's level over the approved one; None where that is not known."""
        gain_db = self.sound.gain_db
        return None if gain_db is None or self.approved_db is None else gain_db - self.approved_db

    @property
    def state(self) -> tuple[str, ...]:
        """The names of what changes the level with the game's state."""
        return tuple(
            dict.fromkeys(depend.what for depend in self.sound.depends if depend.on in ("state", "script", "loudness"))
        )

    def to_dict(self) -> dict[str, Any]:
        """Return the play as JSON has it."""
        drift_db = self.drift_db
        return {
            **self.sound.to_dict(),
            "approved_db": None if self.approved_db is None else round(self.approved_db, 2) + 0.0,
            "drift_db": None if drift_db is None else round(drift_db, 2) + 0.0,
            "moved": [part.to_dict() for part in self.moved],
        }


def approved_plays(sounds: Iterable[PlayedSound]) -> tuple[ApprovedPlayback, ...]:
    """Return the present playbacks of a sound, to be kept as approved; those that nothing begins are left out."""
    return tuple(
        ApprovedPlayback(
            sound.object_path,
            sound.gain_db,
            tuple((part.object_path, part.property, part.gain_db) for part in sound.parts),
        )
        for sound in sounds
        if sound.is_used is not False
    )


def held_to(sounds: Sequence[PlayedSound], approved: Sequence[ApprovedPlayback] | None) -> tuple[Play, ...]:
    """Return each way in which a sound is played with the approved one beside it.

    Parameters
    ----------
    sounds : sequence of PlayedSound
        Of one file.
    approved : sequence of ApprovedPlayback or None
        None where no levels were kept: the sound was then approved as its file is, at 0 dB. A way that was not there is
        held to the nearest approved one.
    """
    plays: list[Play] = []
    free: dict[str, list[ApprovedPlayback]] = defaultdict(list)
    for playback in approved or ():
        free[playback.object_path].append(playback)
    for sound in sounds:
        if not approved:
            was = ApprovedPlayback("", 0.0)
        elif own_play := free.get(sound.object_path):
            was = own_play.pop(0) if len(own_play) > 1 else own_play[0]
        else:
            was = min(approved, key=lambda playback: abs((playback.gain_db or 0.0) - (sound.gain_db or 0.0)))
        plays.append(Play(sound, was.gain_db if sound.gain_db is not None else None, _moved(sound.parts, was.parts)))
    return tuple(plays)


def _moved(now: Sequence[Part], was: Sequence[tuple[str, str, float]]) -> tuple[MovedPart, ...]:
    gains: dict[tuple[str, str], list[float]] = {}
    places: dict[tuple[str, str], tuple[str, str]] = {}
    for part in now:
        gains.setdefault((part.object_path, part.property), [0.0, 0.0])[0] += part.gain_db
        places[part.object_path, part.property] = part.file, part.anchor
    for object_path, name, gain_db in was:
        gains.setdefault((object_path, name), [0.0, 0.0])[1] += gain_db
    return tuple(
        MovedPart(*key, approved_db, gain_db, *places.get(key, ("", "")))
        for key, (gain_db, approved_db) in gains.items()
        if abs(gain_db - approved_db) >= LEAST_DB
    )
