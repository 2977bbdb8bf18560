"""A check without the judgements. Every child that opens a sound imports this: keep it light."""

import os
from typing import Any

from audio_checks import FileReport, check_file


def check_without_judgements(path: str | os.PathLike[str], *spec: Any, **more: Any) -> FileReport:
    """Check as the server does, and compute only the figures that the spec asks for."""
    return check_file(path, *spec, **more | {"all_figures": False})
