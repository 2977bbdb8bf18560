"""Adds to an audit of files what the game's project makes of them: the level they play at, and who set it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from audio_checks.audit.changelists import Changelist, Changelists
from audio_checks.audit.fingerprinted import FingerprintedFile
from audio_checks.audit.plays import MovedPart, Play, approved_plays, held_to
from audio_checks.audit.report import Audit, Entry
from audio_checks.audit.statuses import Status
from audio_checks.middleware.by_path import NOT_PLAYED, sounds_by_path
from audio_checks.middleware.values import PlayedSound, Project
from audio_checks.system.plural import verb

LIMIT_DB = 0.1  # a level that differs by as much is another
SHOWN_PARTS = 3


def with_project(
    audit: Audit, approved: Sequence[FingerprintedFile], project: Project, *, limit_db: float = LIMIT_DB
) -> Audit:
    """Return an audit with the level at which the game plays each file.

    Parameters
    ----------
    audit : Audit
        Of the build's files; see `audit_build`.
    approved : sequence of FingerprintedFile
        Of the manifest. Levels are held to the plays that it lists; a sound without any is held to its file at 0 dB.
    project : Project
        What the game plays; see `read_project`.
    limit_db : float
        How far a level may be from the approved one.

    Returns
    -------
    Audit
        With the project; `unapproved`, `converted`, `unused` and `depends` are among its statuses.
    """
    there = sounds_by_path(project, (entry.path for entry in audit.entries if entry.status != "missing"))
    placed = {sound.file for sounds in there.values() for sound in sounds}
    rest = replace(project, played=tuple(sound for sound in project.played if sound.file not in placed))
    gone = sounds_by_path(rest, (entry.path for entry in audit.entries if entry.status == "missing"))
    by_path = {file.path: file for file in approved}
    entries = [
        _missing(entry, gone.get(entry.path, ()))
        if entry.status == "missing"
        else _played(entry, there.get(entry.path, ()), by_path, project, limit_db)
        for entry in audit.entries
    ]
    changelists = Changelists(project.root)
    return Audit(tuple(_with_changelists(entry, changelists, limit_db) for entry in entries), project)


def with_plays(approved: Sequence[FingerprintedFile], project: Project) -> list[FingerprintedFile]:
    """Return approved sounds with the level at which a project plays each of them, to be kept in a manifest."""
    sounds = sounds_by_path(project, (file.path for file in approved))
    return [replace(file, plays=approved_plays(sounds.get(file.path, ()))) for file in approved]


def _missing(entry: Entry, sounds: Sequence[PlayedSound]) -> Entry:
    names = _names(sounds)
    return replace(entry, message=f"{entry.message}; {_play_it(names)}") if names else entry


def _played(
    entry: Entry,
    sounds: Sequence[PlayedSound],
    by_path: Mapping[str, FingerprintedFile],
    project: Project,
    limit_db: float,
) -> Entry:
    used = [sound for sound in sounds if sound.is_used is not False]
    if entry.approved is None:
        if entry.status != "unknown" or not used:
            return entry
        plays = held_to(used, None)
        return replace(entry, status="unapproved", plays=plays, message=f"{_play_it(_names(used))}; {entry.message}")
    plays = held_to(sounds, by_path[entry.approved].plays)
    return _judged(replace(entry, plays=plays), project, limit_db)


def _judged(entry: Entry, project: Project, limit_db: float) -> Entry:
    used = [play for play in entry.plays if play.sound.is_used is not False]
    if not used:
        return _joined(entry, "unused", NOT_PLAYED[project.engine], None)
    drifted = [play for play in used if abs(play.drift_db or 0.0) >= limit_db]
    harms = list(
        dict.fromkeys(
            f"{conversion.setting}: {conversion.harm}" for play in used for conversion in play.sound.conversions
        )
    )
    state = list(dict.fromkeys(what for play in used for what in play.state))
    if drifted:
        worst = max(drifted, key=lambda play: abs(play.drift_db or 0.0))
        more = f" (and {len(drifted) - 1} more of {len(used)} that play it)" if len(drifted) > 1 else ""
        message = "; ".join([f"{_louder(worst)}{more}", *harms])
        return _joined(entry, "gain", message, worst.drift_db)
    if harms:
        return _joined(entry, "converted", "; ".join(harms), None)
    if state:
        return _joined(entry, "depends", f"its level depends on {_listed(state)}", None)
    return _joined(entry, "same", "plays as approved", None)


def _joined(entry: Entry, status: Status, message: str, drift_db: float | None) -> Entry:
    """Return an entry with what is said of its level beside what is said of its file."""
    gain_db = entry.gain_db
    if drift_db is not None and gain_db is not None:
        gain_db = round(gain_db + drift_db, 2)
    joined = replace(entry, played_status=status, played_message=message, gain_db=gain_db)
    if status == "same":
        return joined
    return replace(
        joined,
        status=status if entry.status == "same" else entry.status,
        message=f"{entry.message}; {message}" if entry.message else message,
    )


def _with_changelists(entry: Entry, changelists: Changelists, limit_db: float) -> Entry:
    if entry.played_status != "gain":
        return entry
    plays = tuple(
        replace(play, moved=tuple(_with_changelist(part, changelists) for part in play.moved))
        if abs(play.drift_db or 0.0) >= limit_db
        else play
        for play in entry.plays
    )
    known_changelists = {part.changelist for play in plays for part in play.moved if part.changelist is not None}
    if not known_changelists:
        return replace(entry, plays=plays)
    words = ", ".join(sorted(_in_words(changelist) for changelist in known_changelists)[:SHOWN_PARTS])
    return replace(
        entry,
        plays=plays,
        message=f"{entry.message} ({words})",
        played_message=f"{entry.played_message} ({words})",
    )


def _in_words(changelist: Changelist) -> str:
    if not changelist.id:
        return changelist.subject
    return f"{changelist.id} of {changelist.on}" if changelist.on else changelist.id


def _with_changelist(part: MovedPart, changelists: Changelists) -> MovedPart:
    return replace(part, changelist=changelists.of(part.file, part.anchor, part.name))


def _louder(play: Play) -> str:
    drift_db = play.drift_db or 0.0
    moved = sorted(play.moved, key=lambda part: -abs(part.by_db))[:SHOWN_PARTS]
    parts = ", ".join(
        f"{part.object_path} {part.name} {part.approved_db + 0.0:+.1f} to {part.gain_db + 0.0:+.1f} dB"
        for part in moved
    )
    where = f": {parts}" if parts else f": {play.sound.object_path}"
    return f"the game plays it {abs(drift_db):.1f} dB {'louder' if drift_db > 0 else 'quieter'}{where}"


def _names(sounds: Sequence[PlayedSound]) -> list[str]:
    """Return the names of what begins the sounds; none where nothing does."""
    return list(dict.fromkeys(name for sound in sounds for name in (sound.events or (sound.object_path,))))


def _play_it(names: Sequence[str]) -> str:
    return f"{_listed(names)} {verb(len(names), 'plays', 'play')} it"


def _listed(names: Sequence[str]) -> str:
    more = f" and {len(names) - SHOWN_PARTS} more" if len(names) > SHOWN_PARTS else ""
    return ", ".join(names[:SHOWN_PARTS]) + more
