"""Remembers verdicts by content, so that files which did not change are not measured again.

A file is known by its place, size, times and inode, which identify its bytes as long as none of
them changes; and its bytes by their hash, which identifies the verdict under one resolved spec, cue,
name and version of the tool. So a file that was only moved, copied or checked out again is read once,
and not measured. Everything is kept in one SQLite database; one that is damaged, locked or of
another make is ignored: the files are simply judged again.
"""

import contextlib
import hashlib
import json
import os
import sqlite3
import stat
import sys
import time
from collections.abc import Iterator, Sequence
from dataclasses import fields
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

from audio_checks import version
from audio_checks.report.findings import FileReport
from audio_checks.run.runner import Task, printable_path
from audio_checks.system.windows import reachable
from audio_checks.version import TOOL_VERSION

FORMAT = 1
READ_BYTES = 1 << 20
KEPT_DAYS = 30
WAIT_S = 1.0  # for another run that is writing
SETTLED_NS = 50_000_000  # a file touched this recently may change again within one tick of its clock
COARSE_NS = 2_000_000_000  # a tick where times are kept in whole or even seconds, as on FAT
DAY_S = 86_400
PASSING = ("SQLITE_BUSY", "SQLITE_LOCKED", "SQLITE_CANTOPEN", "SQLITE_READONLY", "SQLITE_FULL", "SQLITE_IOERR")
MAPPED_BYTES = 256 << 20
CODE_SUFFIXES = frozenset({".py", ".so", ".pyd", ".json"})
NEVER_KEPT = frozenset({"container:cannot-open", "container:not-a-file"})  # facts of the moment, not of the bytes
TABLES = (
    "CREATE TABLE seen (place BLOB PRIMARY KEY, size INT, mtime INT, ctime INT, inode INT, sha256 BLOB) WITHOUT ROWID",
    "CREATE TABLE verdicts (key BLOB PRIMARY KEY, context BLOB, size INT, entry BLOB, used_on INT, mark BLOB)"
    " WITHOUT ROWID",
    "CREATE INDEX sizes ON verdicts (context, size)",
)


class _Print(NamedTuple):
    """The key of a file's bytes, valid as long as nothing of it changes."""

    size: int
    mtime: int
    ctime: int
    inode: int


def default_folder() -> Path:
    """Return the folder for verdicts: AUDIO_CHECKS_CACHE_DIR, or the user's folder for such things."""
    if named := os.environ.get("AUDIO_CHECKS_CACHE_DIR"):
        return Path(named)
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA") or Path.home() / "AppData" / "Local", "audio-checks", "Cache")
    if sys.platform == "darwin":
        return Path.home() / "Library" / "Caches" / "audio-checks"
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache", "audio-checks")


class VerdictCache:
    """The verdicts of earlier runs.

    Parameters
    ----------
    folder : path
        Made where it is missing.
    threads : int
        How many files are read at once to learn their hashes.
    """

    def __init__(self, folder: str | os.PathLike[str], *, threads: int = 1) -> None:
        self._path = Path(folder) / "verdicts.sqlite"
        self._threads = threads
        self._today = int(time.time() // DAY_S)
        self._prints: dict[str, _Print] = {}  # as they were before the file was read, by path
        self._hashes: dict[str, bytes] = {}
        self._used: list[bytes] = []  # keys of verdicts not used yet today
        self._folders: dict[str, str] = {}  # as the system knows them, by how they were given
        self._database = self._opened()

    @property
    def usable(self) -> bool:
        """Whether there is a place to remember in."""
        return self._database is not None

    def recall(self, tasks: Sequence[Task]) -> list[FileReport | None]:
        """Return the report on each file under the same spec; None for those that must be judged."""
        if self._database is None:
            return [None] * len(tasks)
        try:
            return self._recalled(self._database, tasks)
        except (sqlite3.Error, ValueError, KeyError, TypeError) as error:
            self._give_up(error)
            return [None] * len(tasks)

    def remember(self, tasks: Sequence[Task], entries: Sequence[FileReport]) -> None:
        """Keep the reports on files that `recall` did not know."""
        if self._database is None:
            return
        try:
            self._keep(self._database, tasks, entries)
        except sqlite3.Error as error:
            self._give_up(error)

    def close(self) -> None:
        """Let go of the database."""
        if self._database is not None:
            self._database.close()
            self._database = None

    def _opened(self) -> sqlite3.Connection | None:
        with contextlib.suppress(OSError, sqlite3.Error):
            self._path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
            try:
                return _connected(self._path)
            except sqlite3.DatabaseError as error:
                if not _is_damage(error):
                    return None
                self._path.unlink(missing_ok=True)
                return _connected(self._path)
        return None

    def _give_up(self, error: Exception) -> None:
        """Work without a cache; delete a damaged one, so that the next run starts a new one."""
        self.close()
        if _is_damage(error):
            with contextlib.suppress(OSError):
                self._path.unlink(missing_ok=True)

    def _recalled(self, database: sqlite3.Connection, tasks: Sequence[Task]) -> list[FileReport | None]:
        recalled: list[FileReport | None] = [None] * len(tasks)
        unknown: list[tuple[int, Task]] = []
        noted: set[str] = set()
        for index, task in enumerate(tasks):
            printed = _print_of(task.path)
            if printed is None:
                continue
            self._prints[task.path] = printed
            row = database.execute(
                "SELECT sha256 FROM seen WHERE place = ? AND size = ? AND mtime = ? AND ctime = ? AND inode = ?",
                (self._place(task.path), *printed),
            ).fetchone()
            if row is not None:
                self._hashes[task.path] = row[0]
                noted.add(task.path)
                recalled[index] = self._verdict(database, task, row[0])
            elif _may_be_known(database, task, printed.size):
                unknown.append((index, task))
        if unknown:
            from concurrent.futures import ThreadPoolExecutor  # a first run, and one of few files, does without

            with ThreadPoolExecutor(self._threads) as pool:
                hashes = list(pool.map(_sha256, (task.path for _, task in unknown)))
            for (index, task), sha256 in zip(unknown, hashes, strict=True):
                if sha256 is not None:
                    self._hashes[task.path] = sha256
                    recalled[index] = self._verdict(database, task, sha256)
        if self._used:
            with _one_step(database):
                database.executemany(
                    "UPDATE verdicts SET used_on = ? WHERE key = ?", [(self._today, key) for key in self._used]
                )
        known_paths = (task.path for task, entry in zip(tasks, recalled, strict=True) if entry is not None)
        self._note(database, [path for path in known_paths if path not in noted])
        return recalled

    def _place(self, path: str) -> bytes:
        """Return a file's place, whatever folder it was named from."""
        folder, name = os.path.split(path)
        if folder not in self._folders:
            self._folders[folder] = os.path.abspath(folder)
        return os.fsencode(os.path.join(self._folders[folder], name))

    def _verdict(self, database: sqlite3.Connection, task: Task, sha256: bytes) -> FileReport | None:
        key = _key(task, sha256)
        row = database.execute("SELECT entry, used_on, mark FROM verdicts WHERE key = ?", (key,)).fetchone()
        if row is None:
            return None
        if row[2] != _mark(key, row[0]):
            raise ValueError("damaged")
        if row[1] != self._today:
            self._used.append(key)
        return FileReport.from_dict({**json.loads(row[0]), "path": printable_path(task.path)})

    def _keep(self, database: sqlite3.Connection, tasks: Sequence[Task], entries: Sequence[FileReport]) -> None:
        rows, kept = [], []
        for task, entry in zip(tasks, entries, strict=True):
            before = self._prints.get(task.path)
            if before is None or not _is_lasting(entry) or _print_of(task.path) != before:
                continue  # it changed while it was judged, or the verdict is not about its bytes
            digest = bytes.fromhex(entry.sha256) if entry.sha256 else self._hashes.get(task.path)
            sha256 = digest or _sha256(task.path)
            if sha256 is None:
                continue
            self._hashes[task.path] = sha256
            findings = [vars(finding) for finding in entry.findings]
            verdict_json = json.dumps({**vars(entry), "path": "", "findings": findings}).encode()  # -inf stays -inf
            key = _key(task, sha256)
            rows.append((key, _context(task), before.size, verdict_json, self._today, _mark(key, verdict_json)))
            kept.append(task.path)
        with _one_step(database):
            database.executemany("INSERT OR REPLACE INTO verdicts VALUES (?, ?, ?, ?, ?, ?)", rows)
            database.execute("DELETE FROM verdicts WHERE used_on < ?", (self._today - KEPT_DAYS,))
        self._note(database, kept)

    def _note(self, database: sqlite3.Connection, paths: Sequence[str]) -> None:
        """Note the bytes and places of files that have been left alone for a moment."""
        now = time.time_ns()
        rows = [
            (self._place(path), *self._prints[path], self._hashes[path])
            for path in paths
            if _is_settled(self._prints[path], now)
        ]
        if rows:
            with _one_step(database):
                database.executemany("INSERT OR REPLACE INTO seen VALUES (?, ?, ?, ?, ?, ?)", rows)


def _connected(path: Path) -> sqlite3.Connection:
    """Return the database, made if it is not there; sqlite3.DatabaseError when it is no good."""
    database = sqlite3.connect(path, timeout=WAIT_S, isolation_level=None)
    try:
        database.execute("PRAGMA synchronous = NORMAL")
        database.execute(f"PRAGMA mmap_size = {MAPPED_BYTES}")
        (made,) = database.execute("PRAGMA user_version").fetchone()
        if made == 0:
            with _one_step(database):
                for statement in TABLES:
                    database.execute(statement)
                database.execute(f"PRAGMA user_version = {FORMAT}")
        elif made != FORMAT:
            raise sqlite3.DatabaseError("of another make")
    except BaseException:
        database.close()
        raise
    return database


def _is_damage(error: Exception) -> bool:
    """Return whether a database is damaged, and not only unusable now: locked, full, read-only or unreachable."""
    name = getattr(error, "sqlite_errorname", None) or ""
    return not name.startswith(PASSING)


@contextlib.contextmanager
def _one_step(database: sqlite3.Connection) -> Iterator[None]:
    database.execute("BEGIN IMMEDIATE")
    try:
        yield
    except BaseException:
        database.execute("ROLLBACK")
        raise
    database.execute("COMMIT")


def _may_be_known(database: sqlite3.Connection, task: Task, size: int) -> bool:
    """Return whether any verdict in this context is on a file of this size: only then is its hash worth reading."""
    cursor = database.execute("SELECT 1 FROM verdicts WHERE context = ? AND size = ? LIMIT 1", (_context(task), size))
    return cursor.fetchone() is not None


def _print_of(path: str) -> _Print | None:
    try:
        status = os.stat(reachable(path))
    except (OSError, ValueError):
        return None
    if not stat.S_ISREG(status.st_mode):
        return None
    return _Print(status.st_size, status.st_mtime_ns, status.st_ctime_ns, status.st_ino)


def _is_settled(printed: _Print, now: int) -> bool:
    newest = max(printed.mtime, printed.ctime)
    tick = COARSE_NS if printed.mtime % 1_000_000_000 == 0 else SETTLED_NS
    return now - newest > tick


def _sha256(path: str) -> bytes | None:
    whole = hashlib.sha256()
    try:
        with open(reachable(path), "rb", buffering=0) as file:
            while block := file.read(READ_BYTES):
                whole.update(block)
    except OSError:
        return None
    return whole.digest()


def _is_lasting(entry: FileReport) -> bool:
    return entry.verdict != "unjudged" and not any(finding.code in NEVER_KEPT for finding in entry.findings)


def _key(task: Task, sha256: bytes) -> bytes:
    return hashlib.sha256(_context(task) + sha256).digest()


def _mark(key: bytes, entry: bytes) -> bytes:
    """Return the checksum of an entry, by which a damaged or misplaced one is detected."""
    return hashlib.sha256(key + entry).digest()[:8]


def _context(task: Task) -> bytes:
    """Return the hash of all that a verdict depends on besides the bytes."""
    spec, cue = task.spec, task.cue
    parts: list[Any] = [
        _tool(),
        os.path.basename(task.path),
        [spec.sha256, spec.category, spec.target.name if spec.target else None] if spec else None,
        [getattr(cue, field.name) for field in fields(cue) if field.compare] if cue else None,
        task.unlisted,
        task.listed_name,
    ]
    if task.dry is not None:
        stem = _sha256(os.fspath(task.dry.path))
        parts.append([task.dry.name, stem.hex() if stem else None])
    return hashlib.sha256(json.dumps(parts).encode()).digest()


@cache
def _tool() -> str:
    """Return the version of the tool, and the hash of its own files: code in work changes without a new version."""
    whole = hashlib.sha256(TOOL_VERSION.encode())
    for path in sorted(Path(version.__file__).parent.rglob("*")):
        if path.suffix in CODE_SUFFIXES:
            whole.update(path.read_bytes())
    return whole.hexdigest()
