"""Runs the command line: `python -m audio_checks.cli`."""

import sys

from audio_checks.cli import main

sys.exit(main())
