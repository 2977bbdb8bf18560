"""The private parts of DBOS that we use are those of the one version that is pinned, and nothing else touches any."""

import inspect
import re
import tomllib
from collections.abc import Callable
from importlib.metadata import version
from pathlib import Path
from typing import Any

import dbos
import pytest
import sqlalchemy as sa
from dbos import DBOS
from dbos._core import execute_dequeued_workflow
from dbos._serialization import DefaultSerializer
from dbos._sys_db import SystemDatabase

from app.kit import dbos_internals
from tests.support.server import RunningServer

pytestmark = pytest.mark.both_databases
ROOT = Path(__file__).parents[3]
PRIVATE = re.compile(r"from dbos\._|_sys_db|DBOS\._|_active_workflows_set|\"workflow_status\"")
CLAIM = ("queue", "executor_id", "app_version", "queue_partition_key", "local_running_count")
USED: dict[Callable[..., Any], tuple[str, ...]] = {  # and the parameters that are passed
    execute_dequeued_workflow: ("dbos", "status", "owner_xid"),
    SystemDatabase.start_queued_workflows: (*CLAIM, "owner_xid", "is_latest_version"),
    SystemDatabase.get_workflow_statuses: ("workflow_ids",),
    SystemDatabase.reenqueue_for_recovery: ("workflow_id", "executor_ids", "recovery_queue_name"),
    DBOS._recover_pending_workflows: ("executor_ids",),
}


def test_one_exact_version_is_pinned_and_installed():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    assert f"dbos=={version('dbos')}" in project["optional-dependencies"]["server"]


@pytest.mark.parametrize("used", USED, ids=lambda used: used.__qualname__)
def test_each_takes_the_parameters_that_we_pass(used: Callable[..., Any]):
    known = [name for name in inspect.signature(used).parameters if name not in ("self", "cls")]
    assert [name for name in known if name in USED[used]] == list(USED[used])


def test_nothing_else_touches_private_parts():
    touching = [
        str(path.relative_to(ROOT))
        for path in (ROOT / "app").rglob("*.py")
        if PRIVATE.search(path.read_text(encoding="utf-8"))
    ]
    assert touching == ["app/kit/dbos_internals.py"]


def test_the_table_of_jobs_has_the_columns_and_indexes_that_we_read(server: RunningServer):
    runtime = server.runtime
    table = dbos_internals.workflows(is_sqlite=runtime.database.is_sqlite)
    found = sa.inspect(runtime.database.engine)
    schema = None if runtime.database.is_sqlite else "dbos"
    assert {column.name for column in table.columns} <= {
        column["name"] for column in found.get_columns(table.name, schema=schema)
    }
    options = [index.get("dialect_options", {}) for index in found.get_indexes(table.name, schema=schema)]
    conditions = "; ".join(str(value) for each in options for value in each.values())
    for states in dbos_internals.INDEXED_CONDITIONS.values():
        assert all(f"'{state}'" in conditions for state in states), states


def test_the_jobs_that_this_process_runs_are_listed(server: RunningServer):
    assert server.worker is not None
    assert isinstance(dbos_internals.running_jobs(server.worker._dbos), set)


def test_every_pickle_that_dbos_reads_is_read_by_ours():
    package = Path(dbos.__file__).parent
    importing = [path.name for path in package.rglob("*.py") if re.search(r"import (c?pickle|dill)", path.read_text())]
    assert importing == ["_serialization.py"]
    assert (package / "_serialization.py").read_text().count("pickle.load") == 1
    assert "pickle.loads" in inspect.getsource(DefaultSerializer)
    assert DefaultSerializer.deserialize is dbos_internals._read
