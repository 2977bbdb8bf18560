"""Compares the files of a build with the approved sounds of a manifest."""

from __future__ import annotations

import os
from collections import defaultdict
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from pathlib import PurePosixPath

from audio_checks.audit.fingerprinted import FingerprintedFile, fingerprint_file
from audio_checks.audit.likeness import Likeness, Waves, likeness
from audio_checks.audit.report import Audit, Entry, Match
from audio_checks.audit.search import Search, cells_of
from audio_checks.audit.statuses import compare
from audio_checks.run.processes import in_processes

SHORT_S = 0.1  # a sound as short may be too short to compare
ALIKE = 0.5  # what agrees so far may be the same sound, where it is short
EXACT = Likeness(1.0, 0.0, 0.0, 0.0, 0.0, 0.0)


def fingerprint_files(
    files: Iterable[tuple[str, str]], *, jobs: int = 1, done: Callable[[FingerprintedFile], None] | None = None
) -> list[FingerprintedFile]:
    """Return the facts, levels and fingerprint of each file, in order.

    Parameters
    ----------
    files : iterable of (path, shown)
        What to read, and what to call it.
    jobs : int
        The number of processes, 0 for one a core.
    done : callable, optional
        Called with each result as it is finished.
    """
    tasks = list(files)
    jobs = jobs or os.cpu_count() or 1
    if jobs > 1 and len(tasks) > 1:
        return in_processes(
            _fingerprint_all, tasks, workers=min(jobs, len(tasks)), size=_bytes_of, died=_died, done=done
        )
    fingerprinted = []
    for task in tasks:
        fingerprinted.append(fingerprint_file(*task))
        if done:
            done(fingerprinted[-1])
    return fingerprinted


def audit_build(
    approved: Sequence[FingerprintedFile], built: Sequence[FingerprintedFile], *, by_ends: bool = False
) -> Audit:
    """Return the comparison of each file of a build with its approved sound, and the missing approved ones.

    Parameters
    ----------
    approved : sequence of FingerprintedFile
        Of a manifest, or of the approved files themselves.
    built : sequence of FingerprintedFile
        Of the build's files; see `fingerprint_files`.
    by_ends : bool
        A file also stands at the path of an approved sound if its path ends in it, and that of no other file does:
        projects of middleware keep sounds in folders of their own.

    Returns
    -------
    Audit
        An entry for each file of the build, in order, then one for each approved sound that none of them holds.

    Notes
    -----
    The approved sound that a file belongs to is that of its path, or of its path with another ending; else the one
    most like it. The first file that holds a sound from elsewhere counts as its file, if its own path is empty;
    all others are duplicates.
    """
    places = _places(approved)
    place_of = [places.get(built_file.path, places.get(_stem(built_file.path))) for built_file in built]
    if by_ends:
        place_of = _with_ends(place_of, places, built)
    alike = _all_alike(approved, built, place_of)
    taken: set[int] = set()  # approved sounds whose place has a file
    held: dict[int, str] = {}  # and the first file that holds their sound
    entries: list[Entry | None] = [None] * len(built)
    for at, file in enumerate(built):  # first what stands at an approved path
        approved_index = place_of[at]
        if approved_index is not None and approved_index not in taken:
            taken.add(approved_index)
            entries[at] = entry = _in_place(
                file, approved[approved_index], alike[at].get(approved_index), _matches(approved, alike[at])
            )
            if entry.gain_db is not None:
                held[approved_index] = file.path
    for at, file in enumerate(built):
        if entries[at] is None:
            entries[at] = _elsewhere(file, approved, alike[at], held)
    built_entries = [entry for entry in entries if entry is not None]
    missing = [
        _missing(file, built_entries) for index, file in enumerate(approved) if index not in taken and index not in held
    ]
    return Audit((*built_entries, *missing))


def _fingerprint_all(tasks: list[tuple[str, str]]) -> list[FingerprintedFile]:
    return [fingerprint_file(*task) for task in tasks]


def _bytes_of(task: tuple[str, str]) -> int:
    try:
        return os.stat(task[0]).st_size
    except (OSError, ValueError):
        return 0


def _died(task: tuple[str, str], error: BaseException) -> FingerprintedFile:
    return FingerprintedFile(task[1], trouble=f"the process that read it died: {error}")


def _stem(path: str) -> str:
    return str(PurePosixPath(path).with_suffix(""))


def _places(approved: Sequence[FingerprintedFile]) -> dict[str, int]:
    """Return each approved sound's place in the list, by its path and by its path without the ending."""
    stems: dict[str, int] = {}
    for index, file in enumerate(approved):
        stems.setdefault(_stem(file.path), index)
    return {**stems, **{file.path: index for index, file in enumerate(approved)}}


def _with_ends(
    place_of: list[int | None], places: Mapping[str, int], built: Sequence[FingerprintedFile]
) -> list[int | None]:
    """Return the places of files, with those that only the end of a path names."""
    claims: dict[int, list[int]] = defaultdict(list)
    for at, file in enumerate(built):
        if place_of[at] is None:
            names = PurePosixPath(_stem(file.path)).parts
            ends = ("/".join(names[begin:]) for begin in range(1, len(names)))
            approved_index = next((places[end] for end in ends if end in places), None)
            if approved_index is not None:
                claims[approved_index].append(at)
    taken = set(place_of)
    indices = list(place_of)
    for index, claimants in claims.items():
        if len(claimants) == 1 and index not in taken:
            indices[claimants[0]] = index
    return indices


def _all_alike(
    approved: Sequence[FingerprintedFile], built: Sequence[FingerprintedFile], place_of: Sequence[int | None]
) -> list[dict[int, Likeness]]:
    """Return for each file of a build its likeness to approved sounds, by their places: the candidates only."""
    by_sound: dict[str, list[int]] = defaultdict(list)
    for index, file in enumerate(approved):
        if file.pcm_sha256 is not None and file.frames:
            by_sound[file.pcm_sha256].append(index)
    alike: list[dict[int, Likeness]] = [
        {
            approved_index: EXACT
            for approved_index in by_sound.get(file.pcm_sha256 or "", ())
            if _has_format_of(file, approved[approved_index])
        }
        for file in built
    ]
    waves = _Pool()
    fingerprinted = [approved_index for approved_index, file in enumerate(approved) if file.fingerprint is not None]
    asked = [at for at, file in enumerate(built) if file.fingerprint is not None]
    if not (fingerprinted and asked):
        return alike
    search = Search([cells_of(waves.of(approved[approved_index]).wave) for approved_index in fingerprinted])
    candidate_lists = search.found([cells_of(waves.of(built[at]).wave) for at in asked])
    for at, candidates in zip(asked, candidate_lists, strict=True):
        own_index = place_of[at]
        candidate_indices = {fingerprinted[candidate] for candidate in candidates} | (
            {own_index} if own_index in fingerprinted else set()
        )
        mine = Waves(built[at].fingerprint or b"")
        for index in sorted(candidate_indices - set(alike[at])):
            if (like := likeness(waves.of(approved[index]), mine)) is not None:
                alike[at][index] = like
    return alike


def _has_format_of(file: FingerprintedFile, other: FingerprintedFile) -> bool:
    """Whether two files of the same bytes also have the same rate and channels: only then they sound the same."""
    return (file.sample_rate_hz, file.channels, file.bit_depth) == (
        other.sample_rate_hz,
        other.channels,
        other.bit_depth,
    )


class _Pool:
    """The waves of the sounds that were compared last."""

    MOST = 256

    def __init__(self) -> None:
        self._waves: dict[bytes, Waves] = {}

    def of(self, fingerprinted: FingerprintedFile) -> Waves:
        packed = fingerprinted.fingerprint or b""
        waves = self._waves.pop(packed, None) or Waves(packed)
        self._waves[packed] = waves
        if len(self._waves) > self.MOST:
            del self._waves[next(iter(self._waves))]
        return waves


def _matches(approved: Sequence[FingerprintedFile], alike: Mapping[int, Likeness]) -> tuple[Match, ...]:
    held = [(index, like) for index, like in alike.items() if like.is_same_sound or like is EXACT]
    held.sort(key=lambda pair: (-pair[1].score, approved[pair[0]].path))
    return tuple(
        Match(approved[index].cue, approved[index].take, approved[index].path, round(like.score, 3))
        for index, like in held
    )


def _in_place(
    file: FingerprintedFile, approved_here: FingerprintedFile, like: Likeness | None, matches: tuple[Match, ...]
) -> Entry:
    """Report the fate of the approved sound whose place a file has."""
    if (entry := _unreadable(file)) is not None:
        return replace(entry, approved=approved_here.path)
    entry = Entry(file.path, "changed", matches=matches, approved=approved_here.path)
    if like is EXACT:
        return replace(entry, status="same", gain_db=0.0, offset_s=0.0, message="the same samples")
    if like is not None and like.is_same_sound:
        compared = compare(approved_here, file, like)
        return replace(
            entry,
            status=compared.status,
            gain_db=compared.gain_db,
            offset_s=compared.offset_s,
            message=compared.message,
        )
    if why := _why_undecided(file, approved_here, like):
        return replace(entry, status="unknown", message=f"its samples differ; {why}")
    other = f"; it is that of {matches[0].path}" if matches else ""
    return replace(entry, message=f"another sound than the approved one{other}")


def _elsewhere(
    file: FingerprintedFile, approved: Sequence[FingerprintedFile], alike: Mapping[int, Likeness], held: dict[int, str]
) -> Entry:
    """Report the status of a file whose path no approved sound has."""
    if (entry := _unreadable(file)) is not None:
        return entry
    matches = _matches(approved, alike)
    if not matches:
        why = _why_undecided(file, None, None)
        return Entry(file.path, "unknown", message=why or "like no approved sound")
    by_path = {approved[approved_index].path: approved_index for approved_index in alike}
    free = [match for match in matches if by_path[match.path] not in held]
    best = (free or matches)[0]
    index = by_path[best.path]
    like = alike[index]
    entry = Entry(file.path, "duplicate", like.gain_db, like.offset_s, matches, approved=best.path)
    if not free:
        return replace(entry, message=f"holds {best.path} once more, as well as {held[index]}")
    held[index] = file.path
    if like is EXACT:
        return replace(entry, status="same", message=f"the same samples as {best.path}, under another name")
    compared = compare(approved[index], file, like)
    return replace(
        entry,
        status=compared.status,
        gain_db=compared.gain_db,
        offset_s=compared.offset_s,
        message=f"{best.path} under another name: {compared.message}",
    )


def _unreadable(file: FingerprintedFile) -> Entry | None:
    if file.trouble:
        return Entry(file.path, "unknown", message=file.trouble)
    if file.is_placeholder:
        return Entry(file.path, "placeholder", message="a placeholder, not the sound itself")
    return None


def _why_undecided(file: FingerprintedFile, approved_here: FingerprintedFile | None, like: Likeness | None) -> str:
    """Return the obstacle to a comparison of a file's sound; empty without one."""
    if file.sample_peak_dbfs is None and (approved_here is None or approved_here.sample_peak_dbfs is None):
        return "there is nothing but silence in it"
    for what, fingerprinted in (("it", file), ("the approved one", approved_here)):
        if (
            fingerprinted is not None
            and fingerprinted.fingerprint is None
            and fingerprinted.sample_peak_dbfs is not None
        ):
            return f"{what} has next to nothing between 60 Hz and 3.8 kHz to know it by"
    if approved_here is None:
        return (
            f"too short to compare ({1000 * file.duration_s:.0f} ms), and like no approved sound"
            if _is_short(file)
            else ""
        )
    if like is not None and like.score >= ALIKE and (_is_short(file) or _is_short(approved_here)):
        return f"too short to compare ({1000 * min(file.duration_s, approved_here.duration_s):.0f} ms)"
    return ""


def _is_short(fingerprinted: FingerprintedFile) -> bool:
    return fingerprinted.duration_s < SHORT_S


def _missing(file: FingerprintedFile, entries: Sequence[Entry]) -> Entry:
    holders = [entry.path for entry in entries if any(match.path == file.path for match in entry.matches)]
    where = f"; its sound is in {holders[0]}" if holders else ""
    return Entry(file.path, "missing", message=f"the build has no file for it{where}", approved=file.path)
