"""`audio-checks new-spec`: a commented spec to start from."""

import argparse

from audio_checks.cli.arguments import OK
from audio_checks.spec import target_presets
from audio_checks.spec.delivery_spec import new_spec
from audio_checks.spec.presets import PRESETS

LOWEST_ACCEPTED_HZ = 44_100  # of the preset 44k1


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Take the name of a preset, and those of engines."""
    parser.add_argument("--preset", choices=PRESETS, help="what it accepts and renders to")
    parser.add_argument(
        "--targets",
        metavar="NAME",
        action="append",
        default=[],
        choices=tuple(target_presets.TARGET_PRESETS),
        help=f"render for {', '.join(target_presets.TARGET_PRESETS)}; may be repeated",
    )


def run(options: argparse.Namespace) -> int:
    """Print the spec."""
    rates = [target_presets.TARGET_PRESETS[one].sample_rate_hz for one in options.targets]
    fitting = "48k" if max(rates, default=0) > LOWEST_ACCEPTED_HZ else "44k1"  # nothing is converted up
    print(new_spec(options.preset or fitting, targets=options.targets), end="")
    return OK
