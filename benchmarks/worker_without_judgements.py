"""The worker of the server, but for the judgements: what they cost is measured by leaving them out."""

import os
from typing import Any

import audio_checks
from app.cli import cli
from audio_checks import FileReport, check_file

COMMAND = ("-c", f"from {__name__} import work; work()")  # so that a child finds the function below by its name


def check_without_judgements(path: str | os.PathLike[str], *spec: Any, **more: Any) -> FileReport:
    """Check as the server does, and compute only the figures that the spec asks for."""
    return check_file(path, *spec, **more | {"all_figures": False})


def work() -> None:
    """Do what `soundlist worker` does, with its settings."""
    audio_checks.check_file = check_without_judgements
    cli(["worker"])
