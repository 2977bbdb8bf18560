"""Commands that keep what the server holds: backups, and proof that records are whole."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from app.cli.groups import cli
from app.cli.opening import opened, read_settings_or_exit, refusal, tighten_permissions
from app.kit.errors import Refused

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
) -> None:
    """Fill an empty database and a store, whichever the settings name, from a backup."""
    from app.backup import BackupRefused
    from app.backup import restore as restore_backup

    runtime = opened(read_settings_or_exit())
    try:
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
    for blob in copied.damaged:
        typer.echo(f"left out, for its bytes are not what its name says: {blob}", err=True)
    if copied.damaged:
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
