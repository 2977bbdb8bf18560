"""Commands that take everything along: a server to another database or store, a studio to another server."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any
from uuid import UUID

import typer
from pydantic import ValidationError

from app.cli.groups import cli
from app.cli.opening import opened, read_settings_or_exit, refusal
from app.core.errors import Refused
from app.core.runtime import Runtime
from app.settings import Settings

if TYPE_CHECKING:
    from app.transfers.studio_files import Transferred


@contextmanager
def _refusals() -> Iterator[None]:
    from app.transfers.refusal import TransferRefused

    try:
        yield
    except (TransferRefused, Refused) as error:
        raise refusal([str(error)]) from None


@cli.command()
def move(
    database_url: Annotated[str, typer.Option(help="An empty database, as SOUNDLIST_DATABASE_URL names it.")] = "",
    store_url: Annotated[str, typer.Option(help="A folder or bucket, as SOUNDLIST_STORE_URL names it.")] = "",
    data_dir: Annotated[
        Path | None, typer.Option(help="A data folder for SQLite and sounds, where no address of one is given.")
    ] = None,
) -> None:
    """Copy a stopped server to another database or store, and compare both; the old ones stay as they are."""
    from app.transfers.move import move as move_server

    settings = read_settings_or_exit(serving=True)
    if not (database_url or store_url or data_dir):
        raise refusal(["name where to: --database-url, --store-url or --data-dir"])
    moves_database, moves_store = bool(database_url or data_dir), bool(store_url or data_dir)
    changes: dict[str, Any] = {
        "data_dir": data_dir or settings.data_dir,
        "database_url": database_url if moves_database else settings.database_url,
        "store_url": store_url if moves_store else settings.store_url,
    }
    try:
        target_settings = Settings(**changes)
    except ValidationError as error:
        raise refusal([str(problem["msg"]) for problem in error.errors()]) from None
    source = opened(settings)
    target = Runtime.of(target_settings)
    try:
        with _refusals():
            moved = move_server(source, target, database=moves_database, store=moves_store)
    finally:
        target.close()
        source.close()
    if moves_database:
        typer.echo(f"moved: {moved.rows} rows of {moved.tables} tables, equal in both databases")
    if moves_store:
        typer.echo(
            f"moved: {moved.blobs} files of {moved.size_bytes} bytes, each equal; "
            f"{moved.there_before} were there before"
        )
    for job in moved.parked_jobs:
        typer.echo(f"failed before, and not moved: {job}", err=True)
    typer.echo("now let the settings name the new ones, run soundlist verify, then start the server")


@cli.command("export")
def export_studio(
    studio_id: Annotated[UUID, typer.Argument(help="Id of the studio, from its address on the page Jobs and storage.")],
    file: Annotated[Path, typer.Argument(help="The ZIP to write.")],
) -> None:
    """Write everything of a studio into one ZIP: sounds, lists, contracts, ledger and records."""
    from app.accounts.security_log.rules import SecurityEventKind
    from app.accounts.security_log.service import record
    from app.transfers.studio_files import export_studio as write_studio

    runtime = opened(read_settings_or_exit())
    try:
        with _refusals():
            exported = write_studio(runtime, studio_id, file)
            summary = "exported the whole studio into a file"
            with runtime.database.writing() as session:
                record(session, SecurityEventKind.EXPORT, summary, studio_ids=[studio_id], person_id=None)
            _report("exported", exported)
    finally:
        runtime.close()


@cli.command("import")
def import_studio(
    file: Annotated[Path, typer.Argument(help="A ZIP that `soundlist export` wrote.")],
    keep_apart: Annotated[
        bool, typer.Option("--keep-apart", help="Add people whose address has an account here beside that account.")
    ] = False,
) -> None:
    """Add a studio out of an export, all of it or nothing."""
    from app.transfers.studio_files import import_studio as read_studio

    runtime = opened(read_settings_or_exit())
    try:
        with _refusals():
            _report("imported", read_studio(runtime, file, keep_apart=keep_apart))
    finally:
        runtime.close()


def _report(done: str, transferred: "Transferred") -> None:
    typer.echo(
        f"{done}: {transferred.name}, {transferred.rows} rows, {transferred.people} people, "
        f"{transferred.blobs} files of {transferred.size_bytes} bytes"
    )
