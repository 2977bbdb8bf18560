"""The server's command line: what runs it, keeps it, and looks into it."""

import json
import socket
import sys
import tempfile
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated
from uuid import UUID

import typer
from rich.console import Console
from rich.table import Table

from app import logs
from app.kit.errors import Refused
from app.kit.permissions import keep_new_files_private, tighten
from app.kit.runtime import Runtime
from app.settings import Settings, SettingsWrong, read_settings

if TYPE_CHECKING:
    from app.backup import Copied

cli = typer.Typer(
    no_args_is_help=True, add_completion=False, pretty_exceptions_enable=False, help="The Soundlist server."
)
jobs_cli = typer.Typer(no_args_is_help=True, help="Durable jobs: what waits, runs and keeps failing.")
cli.add_typer(jobs_cli, name="jobs")
operators_cli = typer.Typer(no_args_is_help=True, help="Operators: the people who see the whole server.")
cli.add_typer(operators_cli, name="operators")
console = Console()
STOP_WITHIN_S = 15  # what is being answered then may finish


def main() -> None:
    """Run the command line."""
    keep_new_files_private()
    cli()


def _settings(*, serving: bool = False) -> Settings:
    try:
        return read_settings(serving=serving)
    except SettingsWrong as error:
        raise _refusal(error.lines) from None


def _refusal(lines: Iterable[str]) -> typer.Exit:
    for line in lines:
        typer.echo(line, err=True)
    return typer.Exit(2)


def _tighten(paths: Iterable[Path]) -> None:
    for line in tighten(paths):
        typer.echo(line, err=True)


def _opened(settings: Settings) -> Runtime:
    _tighten(settings.private_paths)
    try:
        return Runtime.of(settings)
    except OSError as error:
        raise _refusal(
            [
                f"SOUNDLIST_DATA_DIR is {settings.data_dir}, and {error.filename} cannot be used ({error.strerror}); "
                "name a folder that this user may write to"
            ]
        ) from None


def _ready_to_serve(settings: Settings) -> Runtime:
    """Return an open runtime whose database and store can be used; leave with everything that is wrong otherwise."""
    from app.kit import health
    from app.migrate import ensure_at_head

    runtime = _opened(settings)
    states = [health.tried(probe, runtime) for probe in (health.database, ensure_at_head, health.store)]
    if wrong := [state for state in states if state != "ok"]:
        runtime.close()
        raise _refusal(wrong)
    return runtime


@cli.command()
def serve(
    host: Annotated[str, typer.Option(help="Address to listen on.")] = "127.0.0.1",
    port: Annotated[int, typer.Option(help="Port to listen on.")] = 8000,
) -> None:
    """Serve the web application; run `soundlist migrate` first and `soundlist worker` in parallel."""
    from app.kit import memory, processes
    from app.main import create_app  # noqa: F401  before processes are forked, so that they share what it loads

    memory.return_free_memory()
    settings = _settings(serving=True)
    logs.configure(settings.log_level)
    logs.report_confinement()
    if settings.demo and host != "127.0.0.1":
        raise _refusal(["the demo listens on 127.0.0.1 only, since it needs no sign-in"])
    if settings.web_processes == 1:
        _serve(_ready_to_serve(settings), lambda: processes.listener(host, port))
        return
    # Problems are reported once, by a process whose threads and connections are not inherited.
    if code := processes.run_in_subprocess(lambda: _apart(lambda: _ready_to_serve(settings).close())):
        raise typer.Exit(code)
    try:
        kept = processes.listener(host, port, shared=True)
    except processes.PortTaken as error:
        raise _refusal([str(error)]) from None

    def serve_beside(place: int) -> None:
        _apart(lambda: _serve(_opened(settings), lambda: processes.shared_listener(kept), place=place))

    raise typer.Exit(processes.PreforkSupervisor(serve_beside, settings.web_processes).run())


def _apart(work: Callable[[], None]) -> None:
    """Run a part of a command in a forked process, and exit with its code if it fails."""
    try:
        work()
    except typer.Exit as end:
        raise SystemExit(end.exit_code) from None


def _serve(runtime: Runtime, listening: Callable[[], socket.socket], *, place: int = 0) -> None:
    from app.kit import metrics, processes, serving
    from app.main import create_app

    settings = runtime.settings
    try:
        with metrics.listening(settings, metrics.collectors(runtime), place=place):
            serving.serve(create_app(runtime), listening(), drain_s=settings.drain_s, finish_s=STOP_WITHIN_S)
    except (metrics.CannotListen, processes.PortTaken) as error:
        raise _refusal([str(error)]) from None


@cli.command()
def worker() -> None:
    """Run jobs until stopped."""
    from app.kit import memory, metrics
    from app.worker import run

    memory.return_free_memory()
    settings = _settings(serving=True)
    logs.configure(settings.log_level)
    logs.report_confinement()
    runtime = _ready_to_serve(settings)
    try:
        with metrics.listening(settings, [metrics.PoolFigures(runtime.database)]):
            run(runtime)
    except metrics.CannotListen as error:
        raise _refusal([str(error)]) from None


@cli.command()
def migrate() -> None:
    """Bring the database to the tables of this version."""
    from app.migrate import login_warning
    from app.migrate import migrate as bring_up_to_date
    from app.row_security import CannotGuardRows

    runtime = _opened(_settings())
    try:
        bring_up_to_date(runtime.database)
    except CannotGuardRows as error:
        raise _refusal([str(error)]) from None
    if warning := login_warning(runtime.database):
        typer.echo(warning, err=True)
    runtime.close()


@cli.command()
def backup(
    folder: Annotated[Path, typer.Argument(help="Where the copies go; blobs that are there are not copied again.")],
    keep: Annotated[int, typer.Option(min=1, help="How many copies of the database stay, the newest.")] = 14,
) -> None:
    """Copy database and blobs into a folder, while the server runs."""
    from app.backup import BackupRefused, back_up

    runtime = _opened(_settings())
    _tighten([folder, *folder.glob("database-*")])
    try:
        _notify_copied("backed up", back_up(runtime, folder, keep=keep))
    except (BackupRefused, Refused) as error:
        raise _refusal([str(error)]) from None
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

    runtime = _opened(_settings())
    try:
        _notify_copied("restored", restore_backup(runtime, folder, database))
    except (BackupRefused, Refused) as error:
        raise _refusal([str(error)]) from None
    finally:
        runtime.close()


def _notify_copied(done: str, copied: "Copied") -> None:
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
        list[Path] | None, typer.Argument(help="Records that a party has kept, to hold ours against.")
    ] = None,
) -> None:
    """Look whether the records of contracts, their texts, PDFs and tables are the ones that were written."""
    from app.agreements import record
    from app.amendments import verification

    runtime = _opened(_settings())
    records = entries = wrong = 0
    with runtime.database.reading() as session:
        for contract, faults in verification.faults_of_all(session, runtime.store):
            records, entries, wrong = records + 1, entries + contract.record_length, wrong + bool(faults)
            for fault in faults:
                typer.echo(f"{contract.id} {contract.title}: {fault}", err=True)
        for path in copies or []:
            try:
                contract_id, kept = record.read_document(path.read_text(encoding="utf-8"))
                faults = list(record.faults_beside(session, contract_id, kept))
            except (OSError, UnicodeDecodeError, record.NoRecord) as error:
                faults = [str(error)]
            wrong += bool(faults)
            for fault in faults:
                typer.echo(f"{path}: {fault}", err=True)
    runtime.close()
    typer.echo(
        f"{records} records with {entries} entries and {len(copies or [])} copies looked at; {wrong} are not whole"
    )
    if wrong:
        raise typer.Exit(1)


@cli.command()
def demo(
    port: Annotated[int, typer.Option(help="Port on 127.0.0.1.")] = 8000,
) -> None:
    """Serve the product with a demo project on the embedded database; no sign-in is needed."""
    from app.demo.run import run_demo

    settings = _settings()
    logs.configure(settings.log_level)
    raise typer.Exit(run_demo(port))


@cli.command()
def token(
    project: Annotated[UUID, typer.Argument(help="Id of the project.")],
    name: Annotated[str, typer.Option(help="What the token is for.")] = "CI",
    scope: Annotated[list[str] | None, typer.Option(help="A scope; repeat for several.")] = None,
) -> None:
    """Make a token for a project's build and print it, once."""
    from app.accounts.rules import Scope
    from app.projects.service import issue_token

    scopes = [Scope(each) for each in scope] if scope else [Scope.SPEC_READ, Scope.LIST_READ, Scope.CHECKS_WRITE]
    runtime = _opened(_settings())
    with runtime.database.writing() as session:
        typer.echo(issue_token(session, project, name=name, scopes=scopes))
    runtime.close()


@cli.command()
def quota(
    studio: Annotated[UUID, typer.Argument(help="Id of the studio.")],
    limit: Annotated[
        list[str] | None, typer.Option("--set", help="KIND=NUMBER, or KIND=default; repeat for several.")
    ] = None,
) -> None:
    """Show what a studio uses of its limits, and set them."""
    from app.accounts.quotas import QuotaKind, set_limit
    from app.operations.quotas import quotas_of

    runtime = _opened(_settings())
    with runtime.database.writing() as session:
        for each in limit or []:
            kind, _, most = each.partition("=")
            if kind not in set(QuotaKind) or not (most == "default" or (most.isascii() and most.isdigit())):
                kinds = ", ".join(QuotaKind)
                raise _refusal([f"--set {each}: write KIND=NUMBER or KIND=default, KIND being one of {kinds}"])
            if most != "default" and int(most) >= 1 << 63:
                raise _refusal([f"--set {each}: a limit has at most 18 digits"])
            set_limit(session, studio, QuotaKind(kind), None if most == "default" else int(most))
        table = Table("kind", "used", "limit", "default")
        for row in quotas_of(session, studio):
            table.add_row(row.kind.value, f"{row.used:,}", f"{row.limit:,}", f"{row.default:,}")
    console.print(table)
    runtime.close()


@cli.command()
def openapi(
    out: Annotated[Path | None, typer.Argument(help="File to write; standard output if left out.")] = None,
) -> None:
    """Print the OpenAPI document."""
    from app.main import create_app

    with tempfile.TemporaryDirectory() as folder:
        runtime = Runtime.of(Settings(data_dir=Path(folder)))
        document = json.dumps(create_app(runtime).openapi(), indent=1, ensure_ascii=False) + "\n"
        runtime.close()
    if out is None:
        sys.stdout.write(document)
    else:
        out.write_text(document, encoding="utf-8")


@cli.command()
def mails(
    address: Annotated[str | None, typer.Argument(help="Only mails to this address.")] = None,
) -> None:
    """Print mails that wait, with their links: how accounts are verified on a server without a mail server."""
    from app.accounts.rules import normalised_email
    from app.notifications.queries import pending_for

    runtime = _opened(_settings())
    with runtime.database.reading() as session:
        for mail in pending_for(session, normalised_email(address) if address else None):
            typer.echo(f"{mail.recipient}\t{mail.subject}\t{mail.link or 'its link is made when it is sent'}")
    runtime.close()


@cli.command("sign-out")
def sign_out(address: Annotated[str, typer.Argument(help="The address of an account.")]) -> None:
    """End every sign-in of an account, as after a theft; its password stays."""
    _change_account("sign_out", address, "is signed out everywhere")


@operators_cli.command("add")
def add_operator(address: Annotated[str, typer.Argument(help="The verified address of an account.")]) -> None:
    """Let a person see every studio's jobs and storage."""
    _change_account("add_operator", address, "is an operator now")


@operators_cli.command("remove")
def remove_operator(address: Annotated[str, typer.Argument(help="The address of an operator.")]) -> None:
    """Remove a person's operator rights."""
    _change_account("remove_operator", address, "is no operator any more")


def _change_account(change: str, address: str, done: str) -> None:
    from app.accounts import operators

    runtime = _opened(_settings())
    try:
        with runtime.database.writing() as session:
            person = getattr(operators, change)(session, address)
            typer.echo(f"{person.email} {done}")
    except Refused as error:
        raise _refusal([f"{error.message}; {error.fix}"]) from None
    finally:
        runtime.close()


@operators_cli.command("list")
def list_operators() -> None:
    """List who sees the whole server."""
    from app.accounts.queries import operators

    runtime = _opened(_settings())
    with runtime.database.reading() as session:
        for operator in operators(session):
            typer.echo(f"{operator.person.email}\t{operator.person.name}\tsince {operator.named_at:%Y-%m-%d}")
    runtime.close()


@jobs_cli.command("list")
def list_jobs(
    failed: Annotated[bool, typer.Option("--failed", help="Only jobs that gave up.")] = False,
) -> None:
    """List jobs that wait, run or gave up."""
    runtime = _opened(_settings())
    table = Table("id", "job", "state", "tries", "since")
    for job in runtime.queue.unfinished(only_failed=failed):
        table.add_row(job.id, job.name, job.state, str(job.tries), job.since.isoformat(timespec="seconds"))
    console.print(table)
    runtime.close()


@jobs_cli.command("retry")
def retry_job(job_id: Annotated[str, typer.Argument(help="Id from `soundlist jobs list --failed`.")]) -> None:
    """Run a job again that gave up."""
    runtime = _opened(_settings())
    is_found = runtime.queue.retry(job_id)
    runtime.close()
    if not is_found:
        typer.echo(f"no job {job_id} gave up; `soundlist jobs list --failed` lists those that did", err=True)
        raise typer.Exit(1)
    typer.echo(f"{job_id} waits for a worker")
