"""Commands about durable jobs."""

from typing import Annotated

import typer
from rich.table import Table

from app.cli.groups import console, jobs_cli
from app.cli.opening import opened, read_settings_or_exit


@jobs_cli.command("list")
def list_jobs(
    failed: Annotated[bool, typer.Option("--failed", help="Only jobs that gave up.")] = False,
) -> None:
    """List jobs that wait, run or gave up."""
    runtime = opened(read_settings_or_exit())
    table = Table("id", "job", "state", "tries", "since")
    for job in runtime.queue.unfinished(only_failed=failed):
        table.add_row(job.id, job.name, job.state, str(job.tries), job.since.isoformat(timespec="seconds"))
    console.print(table)
    runtime.close()


@jobs_cli.command("retry")
def retry_job(job_id: Annotated[str, typer.Argument(help="Id from `soundlist jobs list --failed`.")]) -> None:
    """Run a job again that gave up."""
    runtime = opened(read_settings_or_exit())
    is_found = runtime.queue.retry(job_id)
    runtime.close()
    if not is_found:
        typer.echo(f"no job {job_id} gave up; `soundlist jobs list --failed` lists those that did", err=True)
        raise typer.Exit(1)
    typer.echo(f"{job_id} waits for a worker")
