"""The command line and its groups of commands, which the modules beside this one fill."""

import typer
from rich.console import Console

PROGRAM = "soundlist"

cli = typer.Typer(no_args_is_help=True, add_completion=False, pretty_exceptions_enable=False)
jobs_cli = typer.Typer(no_args_is_help=True, help="Durable jobs: what waits, runs and keeps failing.")
operators_cli = typer.Typer(no_args_is_help=True, help="Operators: the people who see the whole server.")
accounts_cli = typer.Typer(no_args_is_help=True, help="Accounts: what their holders cannot do themselves.")
cli.add_typer(accounts_cli, name="accounts")
erase_cli = typer.Typer(no_args_is_help=True, help="Erasure: a person, a project or a studio, for good.")
cli.add_typer(erase_cli, name="erase")
cli.add_typer(jobs_cli, name="jobs")
cli.add_typer(operators_cli, name="operators")
console = Console()
