"""The client as one file that Python runs: what `soundlist pull` and `soundlist why` need, and nothing else."""

import io
import zipfile
from functools import cache
from pathlib import Path

import app.client

NAME = "soundlist.pyz"
OLDEST = (1980, 1, 1, 0, 0, 0)  # the same bytes on every server of a version
START = """\
import sys

if sys.version_info < (3, 11):
    sys.exit("soundlist needs Python 3.11 or newer")

from app.client.commands import main

sys.exit(main(sys.argv[1:]))
"""


@cache
def client_program() -> bytes:
    """Return a ZIP that Python runs."""
    folder = Path(app.client.__file__).parent
    files = {f"app/client/{path.name}": path.read_text(encoding="utf-8") for path in sorted(folder.glob("*.py"))}
    target = io.BytesIO(b"#!/usr/bin/env python3\n")
    target.seek(0, io.SEEK_END)
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in {"__main__.py": START, "app/__init__.py": "", **files}.items():
            archive.writestr(zipfile.ZipInfo(name, OLDEST), text, zipfile.ZIP_DEFLATED)
    return target.getvalue()
