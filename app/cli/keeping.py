"""Commands that keep what the server holds: backups, and proof that records are whole."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from app.cli.groups import cli
from app.cli.opening import opened, read_settings_or_exit, refusal, tighten_permissions
from app.core.errors import Refused

if TYPE_CHECKING:
    from app.backup import Copied


@cli.command()
def backup(
    folder: Annotated[Path, typer.Argument(help="Where the copies go; blobs that are there are not copied again.")],
    keep: Annotated[int, typer.Option(min=1, help="How many copies of the database stay, the newest.")] = 14,
) -> None:
    """Copy database and blobs into a folder, while the server runs."""
    from app.backup import BackupRefused, back_up

    runtime = opened(read_settings_or_exit())
    tighten_permissions([folder, *folder.glob("database-*")])
    try:
        _report_copied("backed up", back_up(runtime, folder, keep=keep))
    except (BackupRefused, Refused) as error:
        raise refusal([str(error)]) from None
    finally:
        runtime.close()


@cli.command()
def restore(
    folder: Annotated[Path, typer.Argument(help="A folder that `soundlist backup` wrote to.")],
    database: Annotated[Path | None, typer.Option(help="A copy of the database in it; the newest if left out.")] = None,
    sounds: Annotated[
        bool, typer.Option("--sounds", help="Leave the database, and store again what is missing or altered.")
    ] = False,
) -> None:
    """Fill an empty database and a store, whichever the settings name, from a backup."""
    from app.backup import BackupRefused, restore_sounds
    from app.backup import restore as restore_backup

    runtime = opened(read_settings_or_exit())
    try:
        if sounds:
            restored = restore_sounds(runtime, folder)
            typer.echo(f"restored: {restored.blobs} blobs of {restored.size_bytes} bytes; {restored.whole} were whole")
            _report_blobs("not in the backup, or damaged there", restored.damaged)
            return
        _report_copied("restored", restore_backup(runtime, folder, database))
    except (BackupRefused, Refused) as error:
        raise refusal([str(error)]) from None
    finally:
        runtime.close()


def _report_copied(done: str, copied: "Copied") -> None:
    typer.echo(
        f"{done}: {copied.database.name}, {copied.blobs} blobs of {copied.size_bytes} bytes; "
        f"{copied.there_before} were there before"
    )
    for blob in copied.healed:
        typer.echo(f"was damaged in the backup, and is copied again: {blob}", err=True)
    for blob in copied.lost:
        typer.echo(f"named by the database, and neither in the store nor in the backup: {blob}", err=True)
    _report_blobs("left out, for its bytes are not what its name says", copied.damaged)
    if copied.lost:
        raise typer.Exit(1)


def _report_blobs(fault: str, blobs: list[str]) -> None:
    for blob in blobs:
        typer.echo(f"{fault}: {blob}", err=True)
    if blobs:
        raise typer.Exit(1)


@cli.command()
def scrub(
    rate: Annotated[float, typer.Option(min=0, help="MiB that are read a second at most; 0: no limit.")] = 64,
    delete_orphans: Annotated[
        bool, typer.Option("--delete-orphans", help="Delete files older than a day that nothing names.")
    ] = False,
) -> None:
    """Read every stored file, compare it with its hash, and name what is missing, altered or orphaned."""
    from app.operations.scrubbing import service as scrubbing

    runtime = opened(read_settings_or_exit())
    try:
        pass_ = scrubbing.begin(runtime.database)
        limit = scrubbing.RateLimit(rate * (1 << 20))
        damages = []
        for damage in scrubbing.run(runtime, pass_, rate=limit):
            damages.append(damage)
            typer.echo(str(damage), err=True)
        orphans = scrubbing.delete_orphans(runtime) if delete_orphans else scrubbing.orphans(runtime)
        sizes_bytes = []
        for studio_id, blob in orphans:
            sizes_bytes.append(blob.size_bytes)
            typer.echo(f"{'deleted' if delete_orphans else 'orphaned'}: {studio_id}/{blob.sha256}")
        typer.echo(
            f"scrubbed: {pass_.blobs} files of {pass_.size_bytes} bytes, {pass_.missing} missing, "
            f"{pass_.altered} altered, {len(sizes_bytes)} orphaned of {sum(sizes_bytes)} bytes"
        )
    except Refused as error:
        raise refusal([str(error)]) from None
    finally:
        runtime.close()
    if damages:
        typer.echo("upload the same files again, or run: soundlist restore FOLDER --sounds", err=True)
        raise typer.Exit(1)


@cli.command()
def verify(
    copies: Annotated[
        list[Path] | None, typer.Argument(help="Records that a party has kept, and PDFs of contracts, to compare.")
    ] = None,
    head: Annotated[
        list[Path] | None, typer.Option(help="A signed head that a party has kept, or the mail with it.")
    ] = None,
    offline: Annotated[bool, typer.Option(help="Read PDFs by their seals alone, without a server's data.")] = False,
) -> None:
    """Look whether the records of contracts, their texts, PDFs and tables are the ones that were written."""
    from app.cli import verifying

    if offline:
        wrong = sum(verifying.report_seal(path) for path in copies or [])
        raise typer.Exit(1 if wrong else 0)
    runtime = opened(read_settings_or_exit())
    try:
        wrong = verifying.report_all(runtime, copies or [], head or [])
    finally:
        runtime.close()
    if wrong:
        raise typer.Exit(1)
