"""The server's command line: what runs it, keeps it, and looks into it."""

from app.cli import (  # noqa: F401  each adds its commands
    accounts,
    completion,
    erasing,
    jobs,
    keeping,
    projects,
    pulling,
    running,
    transferring,
)
from app.cli.groups import PROGRAM, cli
from app.core.permissions import keep_new_files_private


def main() -> None:
    """Run the command line."""
    keep_new_files_private()
    cli(prog_name=PROGRAM)  # not the name of the module that Python runs
