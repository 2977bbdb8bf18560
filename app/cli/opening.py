"""The start of every command: the settings, and the server's database and store."""

from collections.abc import Iterable
from pathlib import Path

import typer

from app.core.permissions import tighten
from app.core.runtime import Runtime
from app.settings import Settings, SettingsWrong, read_settings


def read_settings_or_exit(*, serving: bool = False) -> Settings:
    """Return the settings; leave with every line that is wrong in them."""
    try:
        return read_settings(serving=serving)
    except SettingsWrong as error:
        raise refusal(error.lines) from None


def refusal(lines: Iterable[str]) -> typer.Exit:
    """Print a command's reasons to refuse, and return the exit to raise."""
    for line in lines:
        typer.echo(line, err=True)
    return typer.Exit(2)


def tighten_permissions(paths: Iterable[Path]) -> None:
    """Take from others what they may read of our files, and print what was changed."""
    for line in tighten(paths):
        typer.echo(line, err=True)


def opened(settings: Settings, *, engine_connections: int = 0) -> Runtime:
    """Return the open database and store; leave where the data folder cannot be used."""
    tighten_permissions(settings.private_paths)
    try:
        return Runtime.of(settings, engine_connections=engine_connections)
    except OSError as error:
        raise refusal(
            [
                f"SOUNDLIST_DATA_DIR is {settings.data_dir}, and {error.filename} cannot be used ({error.strerror}); "
                "name a folder that this user may write to"
            ]
        ) from None


def ready_to_serve(settings: Settings, *, engine_connections: int = 0) -> Runtime:
    """Return an open runtime whose database and store can be used; leave with everything that is wrong otherwise."""
    from app.core.web import health
    from app.migrate import ensure_at_head

    runtime = opened(settings, engine_connections=engine_connections)
    states = [health.tried(probe, runtime) for probe in (health.database, ensure_at_head, health.store)]
    if wrong := [state for state in states if state != "ok"]:
        runtime.close()
        raise refusal(wrong)
    return runtime
