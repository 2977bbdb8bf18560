"""The commands of a game team's machine, which `app.client` reads the options of."""

import typer

from app.cli.groups import cli
from app.client.commands import main

OPTIONS_OF_CLIENT = {"ignore_unknown_options": True, "allow_extra_args": True, "help_option_names": []}


@cli.command(context_settings=OPTIONS_OF_CLIENT)
def pull(context: typer.Context) -> None:
    """Write the approved sounds that changed into a folder of the game."""
    raise typer.Exit(main(["pull", *context.args]))


@cli.command(context_settings=OPTIONS_OF_CLIENT)
def ci(context: typer.Context) -> None:
    """Check and audit a game's sounds as its CI does, and post the reports."""
    raise typer.Exit(main(["ci", *context.args]))


@cli.command(context_settings=OPTIONS_OF_CLIENT)
def why(context: typer.Context) -> None:
    """Name the cue, approval, contract and sources of a file."""
    raise typer.Exit(main(["why", *context.args]))


@cli.command(context_settings=OPTIONS_OF_CLIENT)
def fmod(context: typer.Context) -> None:
    """Have the FMOD Studio that runs on this machine import an unpacked pack."""
    raise typer.Exit(main(["fmod", *context.args]))


@cli.command(context_settings=OPTIONS_OF_CLIENT)
def adopt(context: typer.Context) -> None:
    """Send a folder of shipped sounds, to become cues with approved takes."""
    raise typer.Exit(main(["adopt", *context.args]))


@cli.command(context_settings=OPTIONS_OF_CLIENT)
def desk(context: typer.Context) -> None:
    """List your owed work as a sound designer on all servers, the soonest due first."""
    raise typer.Exit(main(["desk", *context.args]))
