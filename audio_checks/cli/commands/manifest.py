"""`audio-checks manifest`: write down what approved sounds are known by, for audits of game builds."""

import argparse
import sys
from dataclasses import replace

from audio_checks.audit.build import fingerprint_files
from audio_checks.audit.fingerprinted import FingerprintedFile
from audio_checks.audit.manifest import manifest_text, write_manifest
from audio_checks.audit.played import with_plays
from audio_checks.cli.arguments import FOUND, OK, add_paths, add_run, found_files, progress_over
from audio_checks.cli.named_list import named_list
from audio_checks.cli.terminal import say
from audio_checks.middleware.project import read_project
from audio_checks.report.findings import printable
from audio_checks.run.workload import process_count
from audio_checks.spec.sound_list import SoundList
from audio_checks.system.plural import counted


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Take folders of approved sounds, and where the manifest goes."""
    add_paths(parser)
    parser.add_argument("--out", metavar="FILE", required=True, help="where the manifest goes; - is stdout")
    parser.add_argument("--list", metavar="CSV", dest="sound_list", help="sound list, to name the cue of each file")
    parser.add_argument(
        "--project", metavar="PATH", help="the game's project: keep the level at which it plays each sound now"
    )
    add_run(parser)


def run(options: argparse.Namespace) -> int:
    """Listen to the sounds and write the manifest; 1 when one could not be read, and is left out."""
    sound_list = named_list(options.sound_list) if options.sound_list else None
    heard = fingerprints_below(options)
    for file in heard:
        if file.trouble:
            say(f"{file.path}: left out: {file.trouble}")
    kept = [_with_cue(file, sound_list) for file in heard if not file.trouble]
    if options.project is not None:
        kept = with_plays(kept, read_project(options.project))
    if options.out == "-":
        sys.stdout.write(manifest_text(kept))
        return FOUND if len(kept) < len(heard) else OK
    write_manifest(options.out, kept)
    if not options.quiet:
        print(printable(f"{options.out}: {counted(len(kept), 'sound')}"))
    return FOUND if len(kept) < len(heard) else OK


def fingerprints_below(options: argparse.Namespace) -> list[FingerprintedFile]:
    """Return the facts of every sound below the paths that were given, by its place below them."""
    masters = found_files(options)
    jobs = process_count([master.path for master in masters]) if options.jobs is None else options.jobs
    files = [(master.path, master.relative.replace("\\", "/")) for master in masters]
    with progress_over(len(files), options) as progress:
        return fingerprint_files(files, jobs=jobs, done=lambda file: progress.step(file.path))


def _with_cue(file: FingerprintedFile, sound_list: SoundList | None) -> FingerprintedFile:
    slot = sound_list.slot_of_file(file.path) if sound_list else None
    return file if slot is None else replace(file, cue=slot[0].number)
