"""`make attack`: a real server under attack; the result of each attack, and exit code 1 if one succeeded."""

import argparse
import sys
import tempfile
from contextlib import ExitStack
from pathlib import Path

from tests.attack.siege import lay_siege, table
from tests.kill.processes import Zygote
from tests.support.postgres import running_postgres


def main() -> int:
    """Attack a server of the named kind for so many seconds."""
    parser = argparse.ArgumentParser(prog="python -m tests.attack", description=__doc__)
    parser.add_argument("--seconds", type=float, default=300)
    parser.add_argument("--database", choices=("sqlite", "postgres"), default="sqlite")
    asked = parser.parse_args()
    with ExitStack() as stack:
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="soundlist-attack-")))
        url = stack.enter_context(running_postgres()).new_database("attacked") if asked.database == "postgres" else ""
        zygote = Zygote()
        stack.callback(zygote.close)
        siege = lay_siege(
            zygote,
            folder,
            seconds=asked.seconds,
            database_url=url,
            report=lambda line: print(line, flush=True),  # noqa: T201
        )
    sys.stdout.write(f"\nAll of it:\n\n{table(siege)}\n\n")
    sys.stdout.writelines(f"FAILED {fault}\n" for fault in siege.faults)
    return 1 if siege.faults else 0


if __name__ == "__main__":
    sys.exit(main())
