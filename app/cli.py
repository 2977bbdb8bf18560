"""The server's command line: serve, worker, migrate, demo, token, openapi, jobs."""

import json
import sys
import tempfile
from pathlib import Path
from typing import Annotated
from uuid import UUID

import typer
from pydantic import ValidationError
from rich.console import Console
from rich.table import Table

from app import logs
from app.kit.runtime import Runtime
from app.settings import Settings

cli = typer.Typer(
    no_args_is_help=True, add_completion=False, pretty_exceptions_enable=False, help="The Soundlist server."
)
jobs_cli = typer.Typer(no_args_is_help=True, help="Durable jobs: what waits, runs and keeps failing.")
cli.add_typer(jobs_cli, name="jobs")
console = Console()


def main() -> None:
    """Run the command line."""
    cli()


def _settings() -> Settings:
    try:
        return Settings()
    except ValidationError as error:
        for wrong in error.errors():
            name = "_".join(str(part) for part in wrong["loc"]).upper()
            message = str(wrong["msg"]).removeprefix("Value error, ")
            typer.echo(message if "SOUNDLIST_" in message else f"SOUNDLIST_{name}: {message}", err=True)
        raise typer.Exit(2) from None


def _serving_settings() -> Settings:
    settings = _settings()
    if not settings.secret_key.get_secret_value():
        typer.echo("SOUNDLIST_SECRET_KEY is not set. Make one with: openssl rand -hex 32", err=True)
        raise typer.Exit(2)
    return settings


@cli.command()
def serve(
    host: Annotated[str, typer.Option(help="Address to listen on.")] = "127.0.0.1",
    port: Annotated[int, typer.Option(help="Port to listen on.")] = 8000,
) -> None:
    """Serve the web application; run `soundlist migrate` before and `soundlist worker` beside it."""
    import uvicorn

    from app.main import create_app

    logs.configure()
    settings = _serving_settings()
    if settings.demo and host != "127.0.0.1":
        typer.echo("the demo listens on 127.0.0.1 only, since it asks nobody to sign in", err=True)
        raise typer.Exit(2)
    application = create_app(Runtime.of(settings))
    uvicorn.run(
        application, host=host, port=port, log_config=None, access_log=False, proxy_headers=False, server_header=False,
        timeout_graceful_shutdown=15,
    )  # fmt: skip


@cli.command()
def worker() -> None:
    """Run jobs until stopped."""
    from app.worker import run

    logs.configure()
    run(Runtime.of(_serving_settings()))


@cli.command()
def migrate() -> None:
    """Bring the database to the tables of this version."""
    from app.migrate import migrate as bring_up_to_date

    runtime = Runtime.of(_settings())
    bring_up_to_date(runtime.database)
    runtime.close()


@cli.command()
def demo(
    port: Annotated[int, typer.Option(help="Port on 127.0.0.1.")] = 8000,
) -> None:
    """Serve the product with a demo project on the embedded database; nobody needs to sign in."""
    from app.demo.run import run_demo

    logs.configure()
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
    runtime = Runtime.of(_settings())
    with runtime.database.writing() as session:
        typer.echo(issue_token(session, project, name=name, scopes=scopes))
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


@jobs_cli.command("list")
def list_jobs(
    failed: Annotated[bool, typer.Option("--failed", help="Only jobs that gave up.")] = False,
) -> None:
    """List jobs that wait, run or gave up."""
    runtime = Runtime.of(_settings())
    table = Table("id", "job", "state", "tries", "since")
    for job in runtime.queue.unfinished(only_failed=failed):
        table.add_row(job.id, job.name, job.state, str(job.recoveries), job.since.isoformat(timespec="seconds"))
    console.print(table)
    runtime.close()


@jobs_cli.command("retry")
def retry_job(job_id: Annotated[str, typer.Argument(help="Id from `soundlist jobs list --failed`.")]) -> None:
    """Run a job again that gave up."""
    runtime = Runtime.of(_settings())
    runtime.queue.retry(job_id)
    runtime.close()
    typer.echo(f"{job_id} waits for a worker")
