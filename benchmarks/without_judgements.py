"""A check without the judgements. Every child that opens a sound imports this: keep it light."""

import os
from dataclasses import replace
from typing import Any

from audio_checks import DeliverySpec, FileReport, check_file


def check_without_judgements(path: str | os.PathLike[str], spec: DeliverySpec, **more: Any) -> FileReport:
    """Check as the server does, by a spec that asks for no dry sound, and compute only the figures that it wants."""
    spec = replace(spec, engine=replace(spec.engine, adds=()))
    return check_file(path, spec, **more | {"all_figures": False})
