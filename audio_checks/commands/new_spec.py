"""`audio-checks new-spec`: a commented spec to start from."""

import argparse

from audio_checks.arguments import OK
from audio_checks.spec import new_spec
from audio_checks.spec_presets import PRESETS


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Take the name of a preset."""
    parser.add_argument("--preset", choices=PRESETS, default=PRESETS[0], help="what it accepts and renders to")


def run(options: argparse.Namespace) -> int:
    """Print the spec."""
    print(new_spec(options.preset), end="")
    return OK
