"""What journeys hear: real recordings, where there are any."""

import os
from pathlib import Path

import pytest


@pytest.fixture
def real_masters() -> list[Path]:
    """Real recordings, 44.1 kHz and 16 bit, from the folder that SOUNDS_DIR names."""
    folder = os.environ.get("SOUNDS_DIR", "")
    masters = sorted(Path(folder, "masters").glob("*.wav")) if folder else []
    if not masters:
        pytest.skip("SOUNDS_DIR does not name a folder of real recordings")
    return masters
