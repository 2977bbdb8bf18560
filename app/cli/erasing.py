"""Commands that erase for good: a person, a project, a studio."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Annotated
from uuid import UUID

import typer
from sqlalchemy.orm import Session

from app.cli.groups import erase_cli
from app.cli.opening import opened, read_settings_or_exit, refusal
from app.core.errors import Refused

if TYPE_CHECKING:
    from app.operations.erasure.service import Erased

Yes = Annotated[bool, typer.Option("--yes", help="Erase without asking.")]


@erase_cli.command("person")
def erase_person(address: Annotated[str, typer.Argument(help="The address of an account.")], yes: Yes = False) -> None:
    """Delete an account; what law and contracts require stays under a pseudonym, and is listed."""
    from app.operations.erasure import service as erasure

    _erase(address, lambda session: erasure.erase_person(session, address), yes=yes)


@erase_cli.command("project")
def erase_project(project_id: Annotated[UUID, typer.Argument(help="Id of the project.")], yes: Yes = False) -> None:
    """Delete a project without signed contracts: its list, sounds and reviews."""
    from app.operations.erasure import service as erasure

    _erase(f"the project {project_id}", lambda session: erasure.erase_project(session, project_id), yes=yes)


@erase_cli.command("studio")
def erase_studio(studio_id: Annotated[UUID, typer.Argument(help="Id of the studio.")], yes: Yes = False) -> None:
    """Delete a studio without signed contracts, with all its projects."""
    from app.operations.erasure import service as erasure

    _erase(f"the studio {studio_id}", lambda session: erasure.erase_studio(session, studio_id), yes=yes)


def _erase(what: str, erase: "Callable[[Session], Erased]", *, yes: bool) -> None:
    if not yes and not typer.confirm(f"Erase {what} for good?"):
        raise typer.Exit(1)
    import app.tables  # noqa: F401  what is erased is looked for in every table

    runtime = opened(read_settings_or_exit())
    try:
        with runtime.database.writing() as session:
            erased = erase(session)
    except Refused as error:
        raise refusal([error.message + (f"; {error.fix}" if error.fix else "")]) from None
    finally:
        runtime.close()
    typer.echo(f"erased: {erased.name}, {erased.rows} rows")
    for kept in erased.kept:
        typer.echo(f"kept: {kept}")
