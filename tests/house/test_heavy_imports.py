"""Libraries that take seconds or much memory for rare work, which web process and worker do not load at start."""

import subprocess
import sys

import pytest

HEAVY = {"Crypto", "librosa", "numba", "pydub", "scipy", "shtab", "stream_zip"}


@pytest.mark.slow
def test_web_and_worker_start_without_them():
    code = f"import sys, app.main, app.worker; print(sorted({HEAVY!r} & set(sys.modules)))"
    answer = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert answer.stdout == "[]\n"
