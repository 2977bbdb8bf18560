"""A short siege of a real server on each database; `make attack` lays a long one."""

from pathlib import Path

import pytest

from tests.attack.siege import lay_siege, table
from tests.kill.processes import Zygote
from tests.support.postgres import running_postgres

pytestmark = [pytest.mark.slow, pytest.mark.timeout(300)]
SECONDS = 12.0  # more where the machine is slow: each attack runs once


@pytest.mark.parametrize("database", ["sqlite", "postgres"])
def test_a_server_holds_out(database: str, tmp_path: Path):
    zygote = Zygote()
    try:
        if database == "sqlite":
            siege = lay_siege(zygote, tmp_path, seconds=SECONDS)
        else:
            with running_postgres() as server:
                url = server.new_database("attacked")
                siege = lay_siege(zygote, tmp_path, seconds=SECONDS, database_url=url)
    finally:
        zygote.close()
    assert siege.faults == [], table(siege)
