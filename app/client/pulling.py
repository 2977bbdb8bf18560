"""`soundlist pull`: makes a folder equal to what is approved, and writes only what changed."""

import argparse
from collections.abc import Sequence
from pathlib import Path

from app.client.downloads import Downloads, remove_old_parts
from app.client.errors import DONE, NOT_AS_APPROVED, UNREACHABLE, Refusal, ServerUnreachable
from app.client.lock import Entry, Lock, read_lock, write_lock
from app.client.paths import LOCK_NAME, content_sha256, is_read_only, place_of
from app.client.planning import Gone, Lacking, Listing, Plan, listing_of, plan_of
from app.client.server import Server
from app.client.settings import ensure_fits, read_source
from app.client.source_control import LfsLocks, Perforce
from app.client.terminal import Progress, counted, say, shown, warn


def pull(options: argparse.Namespace) -> int:
    """Pull into a folder; return the exit code."""
    root: Path = options.folder
    if not root.is_dir():
        raise Refusal(f"{root} is no folder; create it first")
    root = root.resolve()
    lock = read_lock(root)
    source = read_source(
        root, lock, server=options.server, project=options.project, target=options.target, allow_http=options.allow_http
    )
    ensure_fits(lock, source)
    perforce = Perforce(root) if options.p4 and not options.dry_run else None
    lfs = LfsLocks(root) if options.lfs_lock and not options.dry_run else None
    server = Server(source)
    try:
        listing = listing_of(server.of_project("game-files", target=source.target))
    except ServerUnreachable as error:
        return _without_server(root, lock, f"{source.server} (named by {source.named_by}): {error}")
    if listing.project_id != source.project or (source.target or listing.target) != listing.target:
        raise Refusal("the server answered for another project or target than was asked for")
    opens = options.p4 or options.lfs_lock
    plan = plan_of(root, lock, listing, force=options.force, opens_read_only=opens)
    if options.no_placeholders and (refused := _gate(listing, plan, prune=options.prune)):
        return refused
    pull_ = _Pull(root, lock, listing, plan, options)
    return pull_.rehearse() if options.dry_run else pull_.run(server, perforce, lfs)


def _gate(listing: Listing, plan: Plan, *, prune: bool) -> int:
    """Print the obstacles to a game's release; return 0 where there are none."""
    open_files: list[Lacking] = [*listing.placeholders, *listing.missing]
    left = (
        []
        if prune
        else [Lacking(gone_file.entry.path, gone_file.entry.cue, "no longer approved") for gone_file in plan.gone]
    )
    open_files += left
    if not open_files:
        return DONE
    for file in open_files:
        say(f"not final  {shown(file.path)}  {shown(file.cue)}: {shown(file.reason)}")
    warn(
        f"{len(open_files)} of the game's files {'is' if len(open_files) == 1 else 'are'} not the final sound "
        "(--no-placeholders). Nothing was written"
    )
    return NOT_AS_APPROVED


def _without_server(root: Path, lock: Lock | None, reason: str) -> int:
    """Compare a folder with its lock alone, and print what could not be renewed."""
    warn(f"The server cannot be reached: {shown(reason)}")
    entries = sorted(lock.entries.values(), key=lambda locked: locked.path) if lock else []
    whole = 0
    for entry in entries:
        content = content_sha256(place_of(root, entry.path))
        whole += content == entry.sha256
        if content is None:
            say(f"not renewed  {shown(entry.path)}  {shown(entry.cue)}: it is not here")
        elif content != entry.sha256:
            say(f"not renewed  {shown(entry.path)}  {shown(entry.cue)}: it was changed here")
    warn(
        f"{whole} of {counted(len(entries), 'file')} {'is' if whole == 1 else 'are'} here as pulled; "
        "what was approved since is not known"
    )
    return UNREACHABLE


class _Pull:
    """One pull whose plan is made."""

    def __init__(
        self, root: Path, lock: Lock | None, listing: Listing, plan: Plan, options: argparse.Namespace
    ) -> None:
        self._root, self._lock, self._listing, self._plan, self._options = root, lock, listing, plan, options
        self._removed = [gone_file for gone_file in plan.gone if self._is_removed(gone_file)] if options.prune else []

    def rehearse(self) -> int:
        """Print the planned actions."""
        for write in self._plan.writes:
            say(self._line("would add" if write.is_new else "would change", write.wanted.entry, write.wanted.cue_name))
        for gone in self._removed:
            say(self._line("would remove", gone.entry))
        self._report_left()
        self._report_description()
        return NOT_AS_APPROVED if self._plan.writes or self._removed or self._plan.kept else DONE

    def run(self, server: Server, perforce: Perforce | None, lfs: LfsLocks | None) -> int:
        """Carry out the plan, the lock file last."""
        writes, plan = self._plan.writes, self._plan
        changed = [write.place for write in writes if not write.is_new] + self._opened_lock()
        if not (perforce or lfs) and (self._root / LOCK_NAME) in changed and is_read_only(self._root / LOCK_NAME):
            raise Refusal(f"{LOCK_NAME} is read-only; --p4 or --lfs-lock opens it. Nothing was written")
        if lfs:
            lfs.lock([*changed, *(gone_file.place for gone_file in self._removed)])
        added = self._opened_in(perforce, changed) if perforce else []
        progress = Progress(len(writes), sum(write.wanted.size_bytes for write in writes))
        failed: list[Exception] = []
        for write, error in Downloads(server, self._root, progress).run(writes):
            entry = write.wanted.entry
            if error is None:
                plan.entries[entry.path] = entry
                say(self._line("added" if write.is_new else "changed", entry, write.wanted.cue_name))
            else:
                failed.append(error)
                say(f"{self._line('not renewed', entry)}: {shown(str(error))}")
        progress.end()
        self._remove(perforce)
        if not failed:
            remove_old_parts(self._root, {write.place.parent for write in writes})
        is_lock_new = not (self._root / LOCK_NAME).exists()
        write_lock(self._root, Lock(self._listing.project_id, self._listing.target, plan.entries))
        if perforce:
            new = [write.place for write in writes if write.is_new and write.place.exists()]
            perforce.add([*added, *new, *([self._root / LOCK_NAME] if is_lock_new else [])])
        self._report_left()
        if not perforce:
            self._report_description()
        elif perforce.change:
            say(f"changelist {perforce.change}")
        self._report_sum(len(failed))
        if any(isinstance(error, ServerUnreachable) for error in failed):
            return UNREACHABLE
        return NOT_AS_APPROVED if failed or plan.kept else DONE

    def _opened_lock(self) -> list[Path]:
        """Return the lock file where source control has to open it: it is here, and will change."""
        path = self._root / LOCK_NAME
        entries = dict(self._plan.entries)
        entries |= {write.wanted.path: write.wanted.entry for write in self._plan.writes}
        for gone in self._removed:
            entries.pop(gone.entry.path, None)
        will_be = Lock(self._listing.project_id, self._listing.target, entries)
        return [path] if path.exists() and will_be != self._lock else []

    def _opened_in(self, perforce: Perforce, changed: Sequence[Path]) -> list[Path]:
        """Open in Perforce what will change; return files that it does not have yet."""
        if not self._plan.writes and not self._removed and not changed:
            return []
        if self._options.changelist:
            perforce.new_change(self._description())
        unknown = perforce.edit(changed)
        if closed := [path for path in changed if path not in unknown and is_read_only(path)]:
            raise Refusal(f"p4 edit left {closed[0]} read-only; nothing was written")
        return unknown

    def _is_removed(self, gone: Gone) -> bool:
        is_closed = gone.is_read_only and not (self._options.p4 or self._options.lfs_lock)
        return (self._options.force or not gone.is_edited) and not is_closed and gone.place.is_file()

    def _remove(self, perforce: Perforce | None) -> None:
        if perforce:
            perforce.delete([gone.place for gone in self._removed])
        for gone in self._removed:
            gone.place.unlink(missing_ok=True)
            del self._plan.entries[gone.entry.path]
            say(self._line("removed", gone.entry))

    def _report_left(self) -> None:
        """Print the files left as they are, with reasons."""
        for kept in self._plan.kept:
            say(f"kept  {shown(kept.path)}: {kept.reason}")
        for gone in self._plan.gone:
            if gone in self._removed:
                continue
            why = "--prune removes it"
            if gone.is_edited:
                why = "it was changed here; --prune --force removes it"
            elif self._options.prune:
                why = "it is read-only; --p4 or --lfs-lock opens it"
            say(f"{self._line('left', gone.entry)}: no longer approved; {why}")
        for kept_file in self._plan.waiting:
            say(f"waiting  {shown(kept_file.path)}: {shown(kept_file.reason)}")

    def _report_description(self) -> None:
        if self._options.changelist and (self._plan.writes or self._removed):
            say()
            say(self._description())

    def _report_sum(self, failed: int) -> None:
        plan = self._plan
        counts = {
            "added": sum(write.is_new for write in plan.writes),
            "changed": sum(not write.is_new for write in plan.writes),
            "removed": len(self._removed),
            "kept": len(plan.kept),
            "failed": failed,
        }
        words = [f"{count} {word}" for word, count in counts.items() if count]
        if failed:
            words = [word for word in words if not word.endswith((" added", " changed"))]
            words.insert(0, f"{len(plan.writes) - failed} written")
        files = counted(len(self._listing.files), "approved file")
        head = f"{shown(self._listing.project)}, {shown(self._listing.target)}: {files}"
        say(f"{head}, {', '.join([*words, f'{plan.same} unchanged'])}")

    def _description(self) -> str:
        """Return the text of a changelist: the cues, each with its files."""
        by_cue: dict[str, list[str]] = {}
        names: dict[str, str] = {}
        for write in self._plan.writes:
            entry = write.wanted.entry
            names[entry.cue] = write.wanted.cue_name
            by_cue.setdefault(entry.cue, []).append(f"{'add' if write.is_new else 'change'} {shown(entry.path)}")
        for gone in self._removed:
            by_cue.setdefault(gone.entry.cue, []).append(f"remove {shown(gone.entry.path)}")
        count = len(self._plan.writes) + len(self._removed)
        lines = [
            f"Soundlist: {counted(count, 'file')} of {shown(self._listing.project)} for {shown(self._listing.target)}"
        ]
        for cue in sorted(by_cue):
            lines += ["", f"{shown(cue)} {shown(names.get(cue, ''))}".rstrip(), *(f"  {file}" for file in by_cue[cue])]
        return "\n".join(lines)

    @staticmethod
    def _line(word: str, entry: Entry, name: str = "") -> str:
        return f"{word}  {shown(entry.path)}  {shown(entry.cue)}{f' {shown(name)}' if name else ''}"
