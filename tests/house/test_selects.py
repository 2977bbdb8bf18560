"""A SELECT is in a module of the layer of queries, where reviewers look for the caller's reach in its WHERE."""

import ast
import tomllib
from pathlib import Path

import pytest

pytestmark = pytest.mark.lint
ROOT = Path(__file__).resolve().parents[2]
ELSEWHERE = {
    "app/accounts/rate_limits.py": "one statement counts and reads a try; what it answers is read beside it",
    "app/deliveries/cue_sums.py": "a materialized count: locks, reads and writes its rows when the transaction ends",
}


def modules_of_queries() -> set[str]:
    """Return the files of the layer of queries, as the import contracts list them."""
    contracts = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["importlinter"]["contracts"]
    inside = [contract for contract in contracts if contract["id"].startswith("inside-")]
    layers = [(contract["containers"][0], layer.split(" : ")) for contract in inside for layer in contract["layers"]]
    return {
        f"{container.replace('.', '/')}/{module}.py"
        for container, modules in layers
        if "queries" in modules
        for module in modules
    }


def selects(source: str) -> bool:
    """Whether code builds a SELECT."""
    return any(
        isinstance(node, ast.Call)
        and (
            (isinstance(node.func, ast.Name) and node.func.id == "select")
            or (isinstance(node.func, ast.Attribute) and node.func.attr in ("select", "query"))
        )
        for node in ast.walk(ast.parse(source))
    )


def test_only_queries_select() -> None:
    rooms = {path.parent for path in ROOT.glob("app/*/errors.py")} | {ROOT / "app/dashboards"}
    files = {path for room in rooms - {ROOT / "app/kit"} for path in room.glob("*.py")}
    found = {str(path.relative_to(ROOT)) for path in files if selects(path.read_text())}
    assert len(found) > 20
    assert found - modules_of_queries() == set(ELSEWHERE)


def test_the_test_sees_it() -> None:
    assert selects("rows = session.scalars(select(Cue))")
    assert selects("row = session.scalar(sa.select(Cue))")
    assert not selects("session.execute(delete(Cue))")
