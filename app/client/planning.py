"""The changes of a pull to a folder: decided before anything is written."""

import re
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from app.client.errors import Refusal
from app.client.lock import CUE, PROJECT, SHA256, SOUND, TAKE, TARGET, Entry, Lock
from app.client.paths import content_sha256, ensure_distinct, ensure_harmless, folded, is_read_only, place_of

MAX_FILES = 200_000
MAX_FILE_BYTES = 8 << 30
URL = re.compile(r"/[\x21-\x7e]{1,2000}")
OTHER_SOUND = "0" * 16  # of an adopted file that is not the approved sound


@dataclass(frozen=True)
class Wanted:
    """One approved game file, as the server names it."""

    entry: Entry
    size_bytes: int
    cue_name: str
    url: str
    adopted_sha256: str | None = None  # of the file that was adopted for it
    is_adopted_sound: bool = False  # that file has the same samples

    @property
    def path(self) -> str:
        """Its path in the folder."""
        return self.entry.path

    @property
    def adopted(self) -> Entry | None:
        """The file that was adopted, as if it had been pulled; the game had it before its first pull."""
        if self.adopted_sha256 is None:
            return None
        sound = self.entry.sound if self.is_adopted_sound else OTHER_SOUND
        return replace(self.entry, sha256=self.adopted_sha256, sound=sound)


@dataclass(frozen=True)
class Lacking:
    """A file that the game has no final sound for."""

    path: str
    cue: str
    reason: str


@dataclass(frozen=True)
class Listing:
    """The server's listing of a target."""

    project_id: str
    project: str
    target: str
    files: list[Wanted]
    missing: list[Lacking]
    placeholders: list[Lacking]


@dataclass(frozen=True)
class Write:
    """A file to be written."""

    wanted: Wanted
    place: Path
    is_new: bool
    copy_of: Path | None = None  # the folder has these bytes at another place


@dataclass(frozen=True)
class Kept:
    """A file that is left as it is, and why."""

    path: str
    reason: str


@dataclass(frozen=True)
class Gone:
    """A file that was pulled before and is not approved any more."""

    entry: Entry
    place: Path
    is_edited: bool
    is_read_only: bool


@dataclass
class Plan:
    """The actions of a pull."""

    writes: list[Write] = field(default_factory=list)
    kept: list[Kept] = field(default_factory=list)
    gone: list[Gone] = field(default_factory=list)
    waiting: list[Kept] = field(default_factory=list)  # approved, and not to be downloaded yet
    entries: dict[str, Entry] = field(default_factory=dict)  # of the lock without what is written
    same: int = 0


def listing_of(answer: Any) -> Listing:
    """Return the server's answer; raise Refusal for anything that is not a list of game files."""
    try:
        files = [_wanted(entry) for entry in answer["files"]]
        listing = Listing(
            project_id=_matched(PROJECT, answer["project_id"]),
            project=str(answer["project"]),
            target=_matched(TARGET, answer["target"]),
            files=files,
            missing=[
                Lacking(str(missing["path"]), str(missing["cue"]), str(missing["reason"]))
                for missing in answer["missing"]
            ],
            placeholders=[
                Lacking(str(placeholder["path"]), str(placeholder["cue"]), str(placeholder["reason"]))
                for placeholder in answer["placeholders"]
            ],
        )
    except (KeyError, TypeError, ValueError) as error:
        raise Refusal(
            f"the server's list of game files is not understood ({error}); is this program too old?"
        ) from None
    if len(files) > MAX_FILES:
        raise Refusal(f"the server names {len(files):,} files; at most {MAX_FILES:,} are pulled")
    ensure_distinct(file.path for file in files)
    return listing


def _wanted(fields: Any) -> Wanted:
    size_bytes = fields["bytes"]
    if type(size_bytes) is not int or not 0 <= size_bytes <= MAX_FILE_BYTES:
        raise ValueError(f"a size of {size_bytes!r}")
    entry = Entry(
        path=ensure_harmless(str(fields["path"])),
        sha256=_matched(SHA256, fields["sha256"]),
        cue=_matched(CUE, fields["cue"]),
        take=_matched(TAKE, fields["take_id"]),
        sound=_matched(SOUND, fields["sound"]),
    )
    adopted_sha256 = fields.get("adopted_sha256")
    return Wanted(
        entry,
        size_bytes,
        str(fields["cue_name"]),
        _matched(URL, fields["url"]),
        adopted_sha256=None if adopted_sha256 is None else _matched(SHA256, adopted_sha256),
        is_adopted_sound=fields.get("is_adopted_sound") is True,
    )


def _matched(pattern: re.Pattern[str], text: Any) -> str:
    if not isinstance(text, str) or not pattern.fullmatch(text) or not text.isprintable():
        raise ValueError(repr(text)[:100])
    return text


def plan_of(root: Path, lock: Lock | None, listing: Listing, *, force: bool, opens_read_only: bool) -> Plan:
    """Return a plan to make a folder equal to the approved files.

    `force` overwrites what was changed here; `opens_read_only`: source control opens read-only files first.
    """
    plan = Plan()
    locked = lock.entries if lock else {}
    places = {path: place_of(root, path) for path in {*locked, *(file.path for file in listing.files)}}
    hashes = {path: content_sha256(local_path) for path, local_path in places.items()}
    there = {sha256: places[path] for path, sha256 in hashes.items() if sha256 and path in locked}
    for listed in listing.files:
        entry, before, content = listed.entry, locked.get(listed.path), hashes[listed.path]
        target = places[listed.path]
        if before is None and listed.adopted and content == listed.adopted.sha256:
            before = listed.adopted
        if content == entry.sha256:
            plan.entries[listed.path] = entry
            plan.same += 1
            continue
        is_pulled = before is not None and content == before.sha256
        if is_pulled and before and before.sound == entry.sound:  # other bytes around the same sound
            plan.entries[listed.path] = replace(entry, sha256=before.sha256)
            plan.same += 1
            continue
        reason = _why_kept(content, before, is_pulled=is_pulled, force=force)
        if not reason and content is not None and not opens_read_only and is_read_only(target):
            reason = "it is read-only; --p4 or --lfs-lock opens it"
        if reason:
            plan.kept.append(Kept(listed.path, reason))
            if before:
                plan.entries[listed.path] = before
            continue
        copy_of = there.get(entry.sha256)
        if copy_of is not None and copy_of.stat().st_size != listed.size_bytes:  # a pointer of Git LFS
            copy_of = None
        plan.writes.append(Write(listed, target, is_new=content is None, copy_of=copy_of))
        if before:
            plan.entries[listed.path] = before
    _add_gone(plan, listing, locked, places, hashes)
    return plan


def _why_kept(content: str | None, before: Entry | None, *, is_pulled: bool, force: bool) -> str:
    if content is None or is_pulled:
        return ""
    if content == "":
        return "it is a link or a folder, and is never overwritten"
    if force:
        return ""
    if before is None:
        return "it was here before and is not from Soundlist; --force overwrites it"
    return "it was changed here since it was pulled; --force overwrites it"


def _add_gone(
    plan: Plan, listing: Listing, locked: dict[str, Entry], places: dict[str, Path], hashes: dict[str, str | None]
) -> None:
    approved = {file.path for file in listing.files}
    respelled = {folded(path): places[path] for path in approved}
    waiting = {lacking.path: lacking.reason for lacking in listing.missing}
    for path, entry in sorted(locked.items()):
        if path in approved or hashes[path] is None:
            continue
        if (same := respelled.get(folded(path))) and same.exists() and same.samefile(places[path]):
            continue  # only the case of its name changed, on a system that ignores case
        plan.entries[path] = entry
        if path not in waiting:
            is_edited = hashes[path] != entry.sha256
            plan.gone.append(Gone(entry, places[path], is_edited, is_read_only(places[path])))
    plan.waiting = [Kept(lacking.path, lacking.reason) for lacking in listing.missing]
