"""Commands about what projects begin with: their briefs, kits for their lists, and postings."""

from enum import StrEnum
from typing import Annotated
from uuid import UUID

import typer
from rich.table import Table

from app.cli.groups import cli, console
from app.cli.opening import opened, read_settings_or_exit, refusal


class DocumentFormat(StrEnum):
    """The format of a document."""

    MD = "md"
    JSON = "json"


@cli.command()
def brief(
    project: Annotated[UUID, typer.Argument(help="Id of the project.")],
    format_: Annotated[DocumentFormat, typer.Option("--format", help="Markdown or JSON.")] = DocumentFormat.MD,
) -> None:
    """Print a project's brief: every question, its answer, and what is open."""
    from app.briefs import documents, queries
    from app.projects.queries import project_by_id

    runtime = opened(read_settings_or_exit())
    try:
        with runtime.database.reading() as session:
            stored_project = project_by_id(session, project)
            if stored_project is None:
                raise refusal([f"no project {project}"])
            answers = queries.answers_of(session, project)
            if format_ is DocumentFormat.JSON:
                typer.echo(documents.answers_read(session, answers).model_dump_json(indent=2))
            else:
                version = queries.newest_version(session, project)
                typer.echo(documents.markdown_of(stored_project.name, answers, version=version), nl=False)
    finally:
        runtime.close()


@cli.command()
def postings(project: Annotated[UUID, typer.Argument(help="Id of the project.")]) -> None:
    """Print a project's postings and the bids on them, as Markdown."""
    from app.hiring import queries
    from app.hiring.postings import documents
    from app.projects.queries import project_by_id

    runtime = opened(read_settings_or_exit())
    try:
        with runtime.database.reading() as session:
            stored_project = project_by_id(session, project)
            if stored_project is None:
                raise refusal([f"no project {project}"])
            shown = [
                (posting, queries.sent_bids(session, posting.id)) for posting in queries.postings_in(session, project)
            ]
            typer.echo(documents.markdown_of(stored_project.name, shown), nl=False)
    finally:
        runtime.close()


@cli.command()
def kits(
    kit: Annotated[str, typer.Argument(help="A kit, to print its cues as CSV; left out: all kits.")] = "",
) -> None:
    """List the kinds of game that a sound list can be started from, or print the cues of one as CSV."""
    from app.sound_lists.kits.rules import all_kits, csv_of, kit_of

    if not kit:
        table = Table("kit", "cues", "usual cues", "usual hours", "usual MB", "about")
        for listed_kit in all_kits():
            ranges = (
                f"{low}–{high}"
                for low, high in (listed_kit.usual_cues, listed_kit.usual_hours, listed_kit.usual_memory_mb)
            )
            table.add_row(listed_kit.key, str(len(listed_kit.cues)), *ranges, listed_kit.about)
        console.print(table)
        return
    chosen_kit = kit_of(kit)
    if chosen_kit is None:
        raise refusal([f'no kit "{kit}"; there are: {", ".join(known_kit.key for known_kit in all_kits())}'])
    typer.echo(csv_of(chosen_kit), nl=False)
