"""The worker of the server, but for the judgements: what they cost is measured by leaving them out."""

import audio_checks
from app.cli import cli
from benchmarks.without_judgements import check_without_judgements

COMMAND = ("-c", f"from {__name__} import work; work()")


def work() -> None:
    """Do what `soundlist worker` does, with its settings."""
    audio_checks.check_file = check_without_judgements
    cli(["worker"])
