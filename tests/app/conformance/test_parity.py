"""A server behind a socket, the command line and Python say the same of a sound, to the last digit.

`make parity` asks them more.
"""

import datetime as dt
from copy import deepcopy
from pathlib import Path

import pytest

from tests.app.conformance.parity import compared
from tests.support.parity import Server, differences, said_by_python, world_over_tcp, write_sounds
from tests.support.server import RunningServer

SOUNDS, SPECS = 40, ("44k1", "everything", "reverb")
WEEK = dt.datetime.now(dt.UTC).isocalendar()
FIRST = 1_000_000 + (WEEK.year * 53 + WEEK.week) * 1_000  # other sounds each week


@pytest.mark.slow
@pytest.mark.timeout(600)
def test_server_command_line_and_python_say_the_same(server: RunningServer, tmp_path: Path) -> None:
    paths = write_sounds(tmp_path / "sounds", range(FIRST, FIRST + SOUNDS), longest_s=2.0)
    with world_over_tcp(server) as world:
        asked = Server(world, paths)
        found = [f"{spec}: {one}" for spec in SPECS for one in compared(asked, paths, spec)]
    assert not found, "\n".join(found)


def test_a_difference_is_seen(tmp_path: Path) -> None:
    said = said_by_python(write_sounds(tmp_path / "sounds", [FIRST], longest_s=0.5), 'format = 1\nname = "x"\n')
    (name,) = said
    for key, value in (("verdict", "unjudged"), ("findings", [{}]), ("measurements", {"sample_peak_dbfs": 7.0})):
        other = deepcopy(said)
        other[name][key] = value
        mine = deepcopy(said)
        mine[name]["measurements"]["sample_peak_dbfs"] = -1.0
        assert list(differences(mine, other)), key
    assert not list(differences(said, deepcopy(said)))
