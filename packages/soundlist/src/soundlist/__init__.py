"""The installed server: `app`, `migrations` and the page lie in this folder as they lie in a checkout."""

import os
import sys
from pathlib import Path

FOLDER = str(Path(__file__).parent)


def main() -> None:
    """Run the command line of the server."""
    sys.path.insert(0, FOLDER)
    inherited = os.environ.get("PYTHONPATH")  # of the processes that this one starts
    os.environ["PYTHONPATH"] = os.pathsep.join([FOLDER, inherited] if inherited else [FOLDER])
    os.environ["PYTHONSAFEPATH"] = "1"  # for them too, a folder `app` where the command was typed is not this one
    import app.__main__  # noqa: F401  runs the command
