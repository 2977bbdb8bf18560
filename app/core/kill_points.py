"""Named points at which a test may SIGKILL this process or another; without its variables nothing happens."""

import os
import signal
from pathlib import Path

POINT = "SOUNDLIST_KILL_AT"
MARKER = "SOUNDLIST_KILL_MARKER"
VICTIM = "SOUNDLIST_KILL_PID"  # of another process, such as the database; without it this one dies


def point(name: str) -> None:
    """Kill here if the environment names this point, once: the marker file says that it was hit."""
    if os.environ.get(POINT) != name:
        return
    try:
        with Path(os.environ[MARKER]).open("x") as marker:
            marker.write(name)
    except FileExistsError:
        return
    os.kill(int(os.environ.get(VICTIM) or os.getpid()), signal.SIGKILL)
