"""Compares the files of a build with the approved sounds of a manifest."""

from __future__ import annotations

import os
from collections import defaultdict
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from pathlib import PurePosixPath

from audio_checks.audit.heard import Heard, listen
from audio_checks.audit.likeness import Likeness, Waves, likeness
from audio_checks.audit.report import Audit, Entry, Match
from audio_checks.audit.search import Search, cells_of
from audio_checks.audit.statuses import became
from audio_checks.processes import in_processes

SHORT_S = 0.1  # a sound as short may be too short to tell
ALIKE = 0.5  # what agrees so far may be the same sound, where it is short
EXACT = Likeness(1.0, 0.0, 0.0, 0.0, 0.0, 0.0)


def listen_to(
    files: Iterable[tuple[str, str]], *, jobs: int = 1, done: Callable[[Heard], None] | None = None
) -> list[Heard]:
    """Return what is known of the sound of each file, in order.

    Parameters
    ----------
    files : iterable of (path, shown)
        What to read, and what to call it.
    jobs : int
        The number of processes, 0 for one a core.
    done : callable, optional
        Hears of each as it is finished.
    """
    tasks = list(files)
    jobs = jobs or os.cpu_count() or 1
    if jobs > 1 and len(tasks) > 1:
        return in_processes(_listen_to_all, tasks, workers=min(jobs, len(tasks)), size=_bytes_of, died=_died, done=done)
    heard = []
    for task in tasks:
        heard.append(listen(*task))
        if done:
            done(heard[-1])
    return heard


def audit_build(approved: Sequence[Heard], built: Sequence[Heard]) -> Audit:
    """Say of each file of a build what became of the approved sound it holds, and which approved ones are missing.

    Parameters
    ----------
    approved : sequence of Heard
        Of a manifest, or of the approved files themselves.
    built : sequence of Heard
        Of the build's files; see `listen_to`.

    Returns
    -------
    Audit
        An entry for each file of the build, in order, then one for each approved sound that none of them holds.

    Notes
    -----
    The approved sound that a file is held to is that of its path, or of its path with another ending; else the one
    most like it. The first file that holds a sound from elsewhere stands for it, where its own place is empty;
    all others are duplicates.
    """
    alike = _all_alike(approved, built)
    places = _places(approved)
    taken: set[int] = set()  # approved sounds whose place has a file
    held: dict[int, str] = {}  # and the first file that holds their sound
    entries: list[Entry | None] = [None] * len(built)
    for at, one in enumerate(built):  # first what stands at an approved path
        place = places.get(one.path, places.get(_stem(one.path)))
        if place is not None and place not in taken:
            taken.add(place)
            entries[at] = entry = _in_place(one, approved[place], alike[at].get(place), _matches(approved, alike[at]))
            if entry.gain_db is not None:
                held[place] = one.path
    for at, one in enumerate(built):
        if entries[at] is None:
            entries[at] = _elsewhere(one, approved, alike[at], held)
    found = [entry for entry in entries if entry is not None]
    missing = [_missing(one, found) for place, one in enumerate(approved) if place not in taken and place not in held]
    return Audit((*found, *missing))


def _listen_to_all(tasks: list[tuple[str, str]]) -> list[Heard]:
    return [listen(*task) for task in tasks]


def _bytes_of(task: tuple[str, str]) -> int:
    try:
        return os.stat(task[0]).st_size
    except (OSError, ValueError):
        return 0


def _died(task: tuple[str, str], error: BaseException) -> Heard:
    return Heard(task[1], trouble=f"the process that read it died: {error}")


def _stem(path: str) -> str:
    return str(PurePosixPath(path).with_suffix(""))


def _places(approved: Sequence[Heard]) -> dict[str, int]:
    """Return where in the list each approved sound stands, by its path and by its path without the ending."""
    stems: dict[str, int] = {}
    for place, one in enumerate(approved):
        stems.setdefault(_stem(one.path), place)
    return {**stems, **{one.path: place for place, one in enumerate(approved)}}


def _all_alike(approved: Sequence[Heard], built: Sequence[Heard]) -> list[dict[int, Likeness]]:
    """Return for each file of a build how it lies in approved sounds, by their places: the worthwhile ones."""
    by_sound: dict[str, list[int]] = defaultdict(list)
    for place, one in enumerate(approved):
        if one.pcm_sha256 is not None and one.frames:
            by_sound[one.pcm_sha256].append(place)
    places = _places(approved)
    alike: list[dict[int, Likeness]] = [
        {place: EXACT for place in by_sound.get(one.pcm_sha256 or "", ()) if _has_format_of(one, approved[place])}
        for one in built
    ]
    waves = _Kept()
    known = [place for place, one in enumerate(approved) if one.fingerprint is not None]
    asked = [at for at, one in enumerate(built) if one.fingerprint is not None]
    if not (known and asked):
        return alike
    search = Search([cells_of(waves.of(approved[place]).wave) for place in known])
    found = search.found([cells_of(waves.of(built[at]).wave) for at in asked])
    for at, candidates in zip(asked, found, strict=True):
        own = places.get(built[at].path, places.get(_stem(built[at].path)))
        wanted = {known[candidate] for candidate in candidates} | ({own} if own in known else set())
        mine = Waves(built[at].fingerprint or b"")
        for place in sorted(wanted - set(alike[at])):
            if (like := likeness(waves.of(approved[place]), mine)) is not None:
                alike[at][place] = like
    return alike


def _has_format_of(one: Heard, other: Heard) -> bool:
    """Whether two files of the same bytes also have the same rate and channels: only then they sound the same."""
    return (one.sample_rate_hz, one.channels, one.bit_depth) == (
        other.sample_rate_hz,
        other.channels,
        other.bit_depth,
    )


class _Kept:
    """The waves of the sounds that were compared last."""

    MOST = 256

    def __init__(self) -> None:
        self._waves: dict[bytes, Waves] = {}

    def of(self, heard: Heard) -> Waves:
        packed = heard.fingerprint or b""
        waves = self._waves.pop(packed, None) or Waves(packed)
        self._waves[packed] = waves
        if len(self._waves) > self.MOST:
            del self._waves[next(iter(self._waves))]
        return waves


def _matches(approved: Sequence[Heard], alike: Mapping[int, Likeness]) -> tuple[Match, ...]:
    held = [(place, like) for place, like in alike.items() if like.is_same_sound or like is EXACT]
    held.sort(key=lambda one: (-one[1].score, approved[one[0]].path))
    return tuple(
        Match(approved[place].cue, approved[place].take, approved[place].path, round(like.score, 3))
        for place, like in held
    )


def _in_place(one: Heard, own: Heard, like: Likeness | None, matches: tuple[Match, ...]) -> Entry:
    """Say what became of the approved sound whose place a file has."""
    if (entry := _unheard(one)) is not None:
        return replace(entry, approved=own.path)
    entry = Entry(one.path, "changed", matches=matches, approved=own.path)
    if like is EXACT:
        return replace(entry, status="same", gain_db=0.0, offset_s=0.0, message="the same samples")
    if like is not None and like.is_same_sound:
        told = became(own, one, like)
        return replace(entry, status=told.status, gain_db=told.gain_db, offset_s=told.offset_s, message=told.message)
    if why := _why_untold(one, own, like):
        return replace(entry, status="unknown", message=f"its samples differ; {why}")
    other = f"; it is that of {matches[0].path}" if matches else ""
    return replace(entry, message=f"another sound than the approved one{other}")


def _elsewhere(one: Heard, approved: Sequence[Heard], alike: Mapping[int, Likeness], held: dict[int, str]) -> Entry:
    """Say what a file is whose path no approved sound has."""
    if (entry := _unheard(one)) is not None:
        return entry
    matches = _matches(approved, alike)
    if not matches:
        why = _why_untold(one, None, None)
        return Entry(one.path, "unknown", message=why or "like no approved sound")
    by_path = {approved[place].path: place for place in alike}
    free = [match for match in matches if by_path[match.path] not in held]
    best = (free or matches)[0]
    place = by_path[best.path]
    like = alike[place]
    entry = Entry(one.path, "duplicate", like.gain_db, like.offset_s, matches, approved=best.path)
    if not free:
        return replace(entry, message=f"holds {best.path} once more, beside {held[place]}")
    held[place] = one.path
    if like is EXACT:
        return replace(entry, status="same", message=f"the same samples as {best.path}, under another name")
    told = became(approved[place], one, like)
    return replace(
        entry,
        status=told.status,
        gain_db=told.gain_db,
        offset_s=told.offset_s,
        message=f"{best.path} under another name: {told.message}",
    )


def _unheard(one: Heard) -> Entry | None:
    if one.trouble:
        return Entry(one.path, "unknown", message=one.trouble)
    if one.is_placeholder:
        return Entry(one.path, "placeholder", message="a stand-in, not the sound itself")
    return None


def _why_untold(one: Heard, own: Heard | None, like: Likeness | None) -> str:
    """Return why the sound of a file tells nothing; empty where it does."""
    if one.sample_peak_dbfs is None and (own is None or own.sample_peak_dbfs is None):
        return "there is nothing but silence in it"
    for what, heard in (("it", one), ("the approved one", own)):
        if heard is not None and heard.fingerprint is None and heard.sample_peak_dbfs is not None:
            return f"{what} has next to nothing between 60 Hz and 3.8 kHz to know it by"
    if own is None:
        return (
            f"too short to tell ({1000 * one.duration_s:.0f} ms), and like no approved sound" if _is_short(one) else ""
        )
    if like is not None and like.score >= ALIKE and (_is_short(one) or _is_short(own)):
        return f"too short to tell ({1000 * min(one.duration_s, own.duration_s):.0f} ms)"
    return ""


def _is_short(heard: Heard) -> bool:
    return heard.duration_s < SHORT_S


def _missing(one: Heard, found: Sequence[Entry]) -> Entry:
    holders = [entry.path for entry in found if any(match.path == one.path for match in entry.matches)]
    told = f"; its sound is in {holders[0]}" if holders else ""
    return Entry(one.path, "missing", message=f"no file of the build stands for it{told}", approved=one.path)
