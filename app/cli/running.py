"""Commands that run the server: web processes, workers, the demo, and the tables they need."""

import gc
import io
import json
import os
import signal
import sys
import tempfile
import threading
import time
from concurrent.futures import ProcessPoolExecutor
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from app import logs
from app.cli.groups import cli
from app.cli.opening import opened, read_settings_or_exit, ready_to_serve, refusal
from app.core.runtime import Runtime
from app.settings import Settings

if TYPE_CHECKING:
    from starlette.types import ASGIApp

STOP_WITHIN_S = 15  # what is being answered then may finish
KILL_AFTER_S = 20.0  # from the request to stop
StopWithInput = Annotated[bool, typer.Option(help="Stop once standard input ends, for a parent that may be killed.")]


@cli.command()
def serve(
    host: Annotated[str, typer.Option(help="Address to listen on.")] = "127.0.0.1",
    port: Annotated[int, typer.Option(help="Port to listen on.")] = 8000,
    stop_with_input: StopWithInput = False,
) -> None:
    """Serve the web application; run `soundlist migrate` first and `soundlist worker` in parallel."""
    if stop_with_input:
        stop_when_input_ends()
    gc.disable()  # what modules load is never freed: to look through it again and again takes a fifth of the start
    from app import main  # noqa: F401  before processes are forked, so that they share what it loads
    from app.core.web import serving

    gc.enable()
    settings = read_settings_or_exit(serving=True)
    logs.configure(settings.log_level)
    logs.report_confinement()
    if settings.demo and host != "127.0.0.1":
        raise refusal(["the demo listens on 127.0.0.1 only, since it needs no sign-in"])
    with ProcessPoolExecutor(1) as apart:  # no thread and no connection of it is inherited by a web process
        code, printed, reasons = apart.submit(_try_to_open).result()
    typer.echo(printed, nl=False)
    typer.echo(reasons, nl=False, err=True)
    if code:
        raise typer.Exit(code)
    try:
        serving.serve(
            "app.cli.running:web_application", host, port,
            processes=settings.web_processes, drain_s=settings.drain_s, finish_s=STOP_WITHIN_S,
        )  # fmt: skip
    except serving.PortTaken as error:
        raise refusal([str(error)]) from None


def _try_to_open() -> tuple[int, str, str]:
    """Open a web process's resources, and close them; return an exit code and the output."""
    from app.core import metrics

    code, printed, reasons = 0, io.StringIO(), io.StringIO()
    with redirect_stdout(printed), redirect_stderr(reasons):
        try:
            settings = read_settings_or_exit(serving=True)
            runtime = ready_to_serve(settings)
            _print_setup_code(runtime)
            runtime.close()
            with metrics.listening(settings, []):
                pass
        except metrics.CannotListen as error:
            code = refusal([str(error)]).exit_code
        except typer.Exit as end:
            code = end.exit_code
    return code, printed.getvalue(), reasons.getvalue()


def _print_setup_code(runtime: Runtime) -> None:
    from app.accounts.setup_codes import needs_setup_code, setup_code

    with runtime.database.reading() as session:
        if needs_setup_code(session, runtime.settings):
            typer.echo(
                f"This server has no account yet. Set-up code of the first one: {setup_code(runtime.settings)}\n"
                f"Enter it at {runtime.settings.base_url}/sign-up, or run: soundlist accounts add ADDRESS"
            )


def web_application() -> "ASGIApp":
    """Return the application of one web process, by the settings of its environment."""
    from app.core import metrics
    from app.core.web import serving
    from app.main import create_app
    from app.operations.figures import web_collectors

    settings = read_settings_or_exit(serving=True)
    logs.configure(settings.log_level)
    runtime = opened(settings)
    metrics.listen_beside_others(settings, web_collectors(runtime))
    return serving.Draining(create_app(runtime))


def stop_when_input_ends() -> None:
    """Stop this process once its standard input ends, as SIGTERM would: its parent is gone, however that ended.

    What does not stop in time is killed.
    """

    def stop() -> None:
        while os.read(sys.stdin.fileno(), 1024):
            pass
        os.kill(os.getpid(), signal.SIGTERM)
        time.sleep(KILL_AFTER_S)
        os.kill(os.getpid(), signal.SIGKILL)

    threading.Thread(target=stop, name="end of input", daemon=True).start()


@cli.command()
def worker(stop_with_input: StopWithInput = False) -> None:
    """Run jobs until stopped."""
    from app.core import metrics

    if stop_with_input:
        stop_when_input_ends()
    gc.disable()  # as in serve
    from app.core.jobs.workers import engine_connections
    from app.operations.figures import process_collectors
    from app.worker import run

    gc.enable()
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
