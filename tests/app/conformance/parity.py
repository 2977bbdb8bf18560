"""Asks the server, the command line and Python about many sounds by all specs: `make parity`."""

import argparse
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

from tests.support.parity import (
    SPECS,
    Server,
    differences,
    remembered,
    said_by_command,
    said_by_python,
    world_over_tcp,
    write_sounds,
)
from tests.support.server import run_server


def main() -> int:
    """Run, print every difference, and return 1 when there is any."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--sounds", type=int, default=1_000)
    parser.add_argument("--specs", type=int, default=len(SPECS))
    parser.add_argument("--first", type=int, default=0, help="the first seed")
    arguments = parser.parse_args()
    found = 0
    with (
        tempfile.TemporaryDirectory() as name,
        run_server(Path(name, "data")) as server,
        world_over_tcp(server) as world,
    ):
        seeds = range(arguments.first, arguments.first + arguments.sounds)
        paths = write_sounds(Path(name, "sounds"), seeds, longest_s=20.0)
        asked = Server(world, paths)
        for spec in list(SPECS)[: arguments.specs]:
            for one in compared(asked, paths, spec):
                found += 1
                sys.stdout.write(f"{spec}: {one}\n")
            sys.stdout.write(f"{spec}: {len(paths)} sounds, {found} differences until now\n")
            sys.stdout.flush()
    return 1 if found else 0


def compared(asked: Server, paths: list[Path], spec: str) -> Iterator[str]:
    """Yield where Python, the command line by one process, by two and from its memory, and the server differ."""
    toml, folder = SPECS[spec], paths[0].parent
    cache = folder.with_name(f"cache-{spec}")
    by_python = said_by_python(paths, toml)
    others = {
        "-j 1": said_by_command(folder, toml, "-j", "1", "--cache-dir", str(cache)),
        "-j 2": said_by_command(folder, toml, "-j", "2", "--no-cache"),
        "from the cache": said_by_command(folder, toml, "--cache-dir", str(cache)),
        "server": asked.said(toml),
    }
    if remembered(cache) != len(paths):
        yield f"the cache holds {remembered(cache)} verdicts of {len(paths)}"
    for other, said in others.items():
        yield from (f"Python and {other}: {difference}" for difference in differences(by_python, said))


if __name__ == "__main__":
    sys.exit(main())
