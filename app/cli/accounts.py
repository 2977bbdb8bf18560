"""Commands about people and studios: tokens, limits, mails, sign-ins, operators."""

import sys
from collections.abc import Callable
from typing import TYPE_CHECKING, Annotated
from uuid import UUID

import typer
from rich.table import Table

from app.cli.groups import accounts_cli, cli, console, operators_cli
from app.cli.opening import opened, read_settings_or_exit, refusal
from app.core.errors import Refused

if TYPE_CHECKING:
    from sqlalchemy.orm import Session

    from app.accounts.models import Person


@cli.command()
def token(
    project: Annotated[UUID, typer.Argument(help="Id of the project.")],
    name: Annotated[str, typer.Option(help="What the token is for.")] = "CI",
    scope: Annotated[list[str] | None, typer.Option(help="A scope; repeat for several.")] = None,
    days: Annotated[int, typer.Option(min=1, max=365, help="How long the token works.")] = 365,
) -> None:
    """Make a token for a project's build and print it, once."""
    from app.accounts.rules import Scope
    from app.projects.tokens import issue_token

    scopes = [Scope(name) for name in scope] if scope else [Scope.SPEC_READ, Scope.LIST_READ, Scope.CHECKS_WRITE]
    runtime = opened(read_settings_or_exit())
    with runtime.database.writing() as session:
        typer.echo(issue_token(session, project, name=name, scopes=scopes, days=days))
    runtime.close()


@cli.command()
def quota(
    studio: Annotated[UUID, typer.Argument(help="Id of the studio.")],
    limit: Annotated[
        list[str] | None, typer.Option("--set", help="KIND=NUMBER, or KIND=default; repeat for several.")
    ] = None,
) -> None:
    """Show a studio's use of its limits, and set them."""
    from app.accounts.quotas.service import QuotaKind, set_limit
    from app.operations.quotas import quotas_of

    runtime = opened(read_settings_or_exit())
    with runtime.database.writing() as session:
        for assignment in limit or []:
            kind, _, most = assignment.partition("=")
            if kind not in set(QuotaKind) or not (most == "default" or (most.isascii() and most.isdigit())):
                kinds = ", ".join(QuotaKind)
                raise refusal([f"--set {assignment}: write KIND=NUMBER or KIND=default, KIND being one of {kinds}"])
            if most != "default" and int(most) >= 1 << 63:
                raise refusal([f"--set {assignment}: a limit has at most 18 digits"])
            set_limit(session, studio, QuotaKind(kind), None if most == "default" else int(most))
        table = Table("kind", "used", "limit", "default")
        for row in quotas_of(session, studio):
            table.add_row(row.kind.value, f"{row.used:,}", f"{row.limit:,}", f"{row.default:,}")
    console.print(table)
    runtime.close()


@cli.command()
def mails(
    address: Annotated[str | None, typer.Argument(help="Only mails to this address.")] = None,
) -> None:
    """Print mails that wait, with their links: how accounts are verified on a server without a mail server."""
    from app.accounts.rules import normalised_email
    from app.notifications.queries import pending_for

    runtime = opened(read_settings_or_exit())
    with runtime.database.reading() as session:
        for mail in pending_for(session, normalised_email(address) if address else None):
            typer.echo(f"{mail.recipient}\t{mail.subject}\t{mail.link or 'its link is made when it is sent'}")
    runtime.close()


@cli.command("sign-out")
def sign_out(address: Annotated[str, typer.Argument(help="The address of an account.")]) -> None:
    """End every sign-in of an account, as after a theft; its password stays."""
    from app.accounts import operators

    _change_account(operators.sign_out, address, "is signed out everywhere")


@accounts_cli.command("add")
def add_account(
    address: Annotated[str, typer.Argument(help="The address to sign in with.")],
    name: Annotated[str, typer.Option(prompt="Name", help="The person's name.")],
    studio: Annotated[str, typer.Option(help="The name of a studio to open, which the person produces for.")] = "",
) -> None:
    """Make an account, as the first one of an empty server; asks for its password, or reads it from a pipe."""
    from app.accounts import operators

    if sys.stdin.isatty():
        password = typer.prompt("Password", hide_input=True, confirmation_prompt=True)
    else:
        password = sys.stdin.readline().rstrip("\r\n")
    _change_account(
        lambda session, email: operators.add_account(session, email, name, password, studio), address, "has an account"
    )


@accounts_cli.command("remove-second-factor")
def remove_second_factor(address: Annotated[str, typer.Argument(help="The address of an account.")]) -> None:
    """Take a lost second factor away, and sign the account out everywhere; its password stays."""
    from app.accounts import operators

    _change_account(
        operators.remove_second_factor, address, "has no second factor any more, and is signed out everywhere"
    )


@accounts_cli.command("bind-domain")
def bind_domain(
    studio: Annotated[UUID, typer.Argument(help="Id of the studio, which you know to own the domain.")],
    domain: Annotated[str, typer.Argument(help="What follows the @ of its addresses.")],
) -> None:
    """Let a studio's sign-in provider sign in whoever it says has an address of a domain."""
    from app.accounts.providers import service as providers

    def bind(session: "Session") -> str:
        bound_to = providers.bind_domain(session, studio, domain)
        return f"{domain} is bound to {bound_to.name}"

    _change(bind)


@accounts_cli.command("unbind-domain")
def unbind_domain(domain: Annotated[str, typer.Argument(help="The domain.")]) -> None:
    """End a binding by bind-domain; sign-ins that are open stay open."""
    from app.accounts.providers import service as providers

    def unbind(session: "Session") -> str:
        providers.unbind_domain(session, domain)
        return f"{domain} is bound to no studio any more"

    _change(unbind)


@operators_cli.command("add")
def add_operator(address: Annotated[str, typer.Argument(help="The verified address of an account.")]) -> None:
    """Let a person see every studio's jobs and storage."""
    from app.accounts import operators

    _change_account(operators.add_operator, address, "is an operator now")


@operators_cli.command("remove")
def remove_operator(address: Annotated[str, typer.Argument(help="The address of an operator.")]) -> None:
    """Remove a person's operator rights."""
    from app.accounts import operators

    _change_account(operators.remove_operator, address, "is no longer an operator")


def _change_account(change: "Callable[[Session, str], Person]", address: str, done: str) -> None:
    _change(lambda session: f"{change(session, address).email} {done}")


def _change(change: "Callable[[Session], str]") -> None:
    """Make a change in a transaction and print its sentence, or the refusal."""
    runtime = opened(read_settings_or_exit())
    try:
        with runtime.database.writing() as session:
            typer.echo(change(session))
    except Refused as error:
        raise refusal(["; ".join(filter(None, (error.message, error.fix)))]) from None
    finally:
        runtime.close()


@operators_cli.command("list")
def list_operators() -> None:
    """List people who see the whole server."""
    from app.accounts.queries import operators

    runtime = opened(read_settings_or_exit())
    with runtime.database.reading() as session:
        for operator in operators(session):
            typer.echo(f"{operator.person.email}\t{operator.person.name}\tsince {operator.named_at:%Y-%m-%d}")
    runtime.close()
