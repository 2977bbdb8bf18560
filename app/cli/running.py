"""Commands that run the server: web processes, workers, the demo, and the tables they need."""

import json
import socket
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Annotated

import typer

from app import logs
from app.cli.groups import cli
from app.cli.opening import opened, read_settings_or_exit, ready_to_serve, refusal
from app.kit.runtime import Runtime
from app.settings import Settings

STOP_WITHIN_S = 15  # what is being answered then may finish
StopWithInput = Annotated[bool, typer.Option(help="Stop once standard input ends, for a parent that may be killed.")]


@cli.command()
def serve(
    host: Annotated[str, typer.Option(help="Address to listen on.")] = "127.0.0.1",
    port: Annotated[int, typer.Option(help="Port to listen on.")] = 8000,
    stop_with_input: StopWithInput = False,
) -> None:
    """Serve the web application; run `soundlist migrate` first and `soundlist worker` in parallel."""
    from app.kit import memory, processes

    if stop_with_input:
        processes.stop_with_input()
    from app.main import create_app  # noqa: F401  before processes are forked, so that they share what it loads

    memory.return_free_memory()
    settings = read_settings_or_exit(serving=True)
    logs.configure(settings.log_level)
    logs.report_confinement()
    if settings.demo and host != "127.0.0.1":
        raise refusal(["the demo listens on 127.0.0.1 only, since it needs no sign-in"])
    if settings.web_processes == 1:
        runtime = ready_to_serve(settings)
        _print_setup_code(runtime)
        _serve(runtime, lambda: processes.listener(host, port))
        return
    # Problems are reported once, by a process whose threads and connections are not inherited.
    if code := processes.run_in_subprocess(lambda: _apart(lambda: _try_to_serve(settings))):
        raise typer.Exit(code)
    try:
        kept = processes.listener(host, port, shared=True)
    except processes.PortTaken as error:
        raise refusal([str(error)]) from None

    def serve_beside(place: int) -> None:
        _apart(lambda: _serve(opened(settings), lambda: processes.shared_listener(kept), place=place))

    raise typer.Exit(processes.PreforkSupervisor(serve_beside, settings.web_processes).run())


def _try_to_serve(settings: Settings) -> None:
    runtime = ready_to_serve(settings)
    _print_setup_code(runtime)
    runtime.close()


def _print_setup_code(runtime: Runtime) -> None:
    from app.accounts.setup_codes import needs_setup_code, setup_code

    with runtime.database.reading() as session:
        if needs_setup_code(session, runtime.settings):
            typer.echo(
                f"This server has no account yet. Set-up code of the first one: {setup_code(runtime.settings)}\n"
                f"Enter it at {runtime.settings.base_url}/sign-up, or run: soundlist accounts add ADDRESS"
            )


def _apart(work: Callable[[], None]) -> None:
    """Run a part of a command in a forked process, and exit with its code if it fails."""
    try:
        work()
    except typer.Exit as end:
        raise SystemExit(end.exit_code) from None


def _serve(runtime: Runtime, listening: Callable[[], socket.socket], *, place: int = 0) -> None:
    from app.kit import metrics, processes, serving
    from app.main import create_app
    from app.operations.figures import web_collectors

    settings = runtime.settings
    try:
        with metrics.listening(settings, web_collectors(runtime), place=place):
            serving.serve(create_app(runtime), listening(), drain_s=settings.drain_s, finish_s=STOP_WITHIN_S)
    except (metrics.CannotListen, processes.PortTaken) as error:
        raise refusal([str(error)]) from None


@cli.command()
def worker(stop_with_input: StopWithInput = False) -> None:
    """Run jobs until stopped."""
    from app.kit import memory, metrics, processes

    if stop_with_input:
        processes.stop_with_input()
    from app.kit.workers import engine_connections
    from app.operations.figures import process_collectors
    from app.worker import run

    memory.return_free_memory()
    settings = read_settings_or_exit(serving=True)
    logs.configure(settings.log_level)
    logs.report_confinement()
    runtime = ready_to_serve(settings, engine_connections=engine_connections(settings.worker_jobs))
    try:
        with metrics.listening(settings, process_collectors(runtime)):
            run(runtime)
    except metrics.CannotListen as error:
        raise refusal([str(error)]) from None


@cli.command()
def migrate() -> None:
    """Bring the database to the tables of this version."""
    from app.migrate import CannotUpgrade, login_warning
    from app.migrate import migrate as bring_up_to_date
    from app.row_security import CannotGuardRows

    runtime = opened(read_settings_or_exit())
    try:
        bring_up_to_date(runtime.database)
    except (CannotGuardRows, CannotUpgrade) as error:
        raise refusal([str(error)]) from None
    if warning := login_warning(runtime.database):
        typer.echo(warning, err=True)
    runtime.close()


@cli.command()
def demo(
    port: Annotated[int, typer.Option(help="Port on 127.0.0.1.")] = 8000,
) -> None:
    """Serve the product with a demo project on the embedded database; no sign-in is needed."""
    typer.echo("\n  Soundlist starts. Ctrl C stops it.")  # what follows is loaded for some seconds
    settings = read_settings_or_exit()
    logs.configure(settings.log_level)
    from app.demo.run import run_demo

    raise typer.Exit(run_demo(port))


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
