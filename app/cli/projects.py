"""Commands that print what a project says: its brief."""

from enum import StrEnum
from typing import Annotated
from uuid import UUID

import typer

from app.cli.groups import cli
from app.cli.opening import opened, read_settings_or_exit, refusal


class DocumentFormat(StrEnum):
    """How a document is written."""

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
            found = project_by_id(session, project)
            if found is None:
                raise refusal([f"no project {project}"])
            answers = queries.answers_of(session, project)
            if format_ is DocumentFormat.JSON:
                typer.echo(documents.answers_read(session, answers).model_dump_json(indent=2))
            else:
                version = queries.newest_version(session, project)
                typer.echo(documents.markdown_of(found.name, answers, version=version), nl=False)
    finally:
        runtime.close()
