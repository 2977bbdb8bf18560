"""Writes what the server says of its checks, for the tests of pages: python -m tests.support.described_checks FILE."""

import json
import sys
from pathlib import Path

from app.conformance.endpoints import list_checks


def described() -> str:
    """Return the answer of `/v1/checks`."""
    checks = [check.model_dump(mode="json") for check in list_checks()]
    return json.dumps(checks, indent=2, ensure_ascii=False) + "\n"


if __name__ == "__main__":
    Path(sys.argv[1]).write_text(described(), encoding="utf-8")
