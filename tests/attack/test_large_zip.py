"""A ZIP goes through a real server in constant memory; `make large-zip` sends one of 5 GiB."""

from pathlib import Path

import pytest

from tests.attack.large_zip import pass_through
from tests.kill.processes import Zygote

pytestmark = [pytest.mark.slow, pytest.mark.timeout(300)]


def test_a_zip_of_300_mib_becomes_takes(tmp_path: Path):
    zygote = Zygote()
    try:
        passage = pass_through(zygote, tmp_path, 300 << 20, sound_bytes=24 << 20)
    finally:
        zygote.close()
    assert passage.sounds > 10
    assert passage.faults == [], str(passage)
