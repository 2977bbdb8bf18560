"""Libraries that take seconds or much memory for rare work, which web process and worker do not load at start."""

import subprocess
import sys

import pytest

HEAVY = {"Crypto", "alembic", "icalendar", "librosa", "mako", "numba", "pydub", "scipy", "shtab", "stream_zip"}


@pytest.mark.slow
def test_web_and_worker_start_without_them():
    code = (
        "import sys, app.main, app.worker; app.main.registry.rooms_in_use(is_commercial=True);"
        f"print(sorted({HEAVY!r} & set(sys.modules)))"
    )
    answer = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert answer.stdout == "[]\n"
