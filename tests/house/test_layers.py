"""Inside a room the name of a module says its layer, and the layer says what the module may know.

A module is in a layer by its last word, `queries` and `cost_queries` alike. Other names are free: it counts as
what it imports, below endpoints and jobs. What a package `web` holds is for endpoints.
"""

import ast
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import grimp
import pytest

pytestmark = pytest.mark.lint
ROOT = Path(__file__).resolve().parents[2]
LAYERS = ("errors", "rules", "schemas", "models", "queries", "service", "endpoints")  # from the bottom
TOP = LAYERS.index("endpoints")
ALIKE = {"jobs": "endpoints", "web": "endpoints"}
NO_ROOMS = ("app.core", "app.cli", "app.client", "app.demo", "app.transfers")
MAY_KNOW = {
    "fastapi": ("endpoints",),
    "starlette": ("endpoints",),
    "pydantic": ("schemas", "endpoints"),
    "sqlalchemy": ("models", "queries", "service", "endpoints", None),
}
SELECTS_ELSEWHERE = {
    "app.accounts.rate_limits": "one statement counts and reads a try; what it answers is read beside it",
    "app.projects.members.limits": "restricts every SELECT of a member to their projects",
    "app.deliveries.cue_counts.service": "locks, reads and writes materialized counts when the transaction ends",
}


def layer_of(module: str) -> str | None:
    """Return the layer that a module's name says, or None where the name is free."""
    *_, package, name = module.split(".")
    for word in (name.rpartition("_")[2], package):
        if ALIKE.get(word, word) in LAYERS:
            return ALIKE.get(word, word)
    return None


def height_of(module: str) -> int:
    """Return the number of a module's layer from the bottom; a free name is below endpoints."""
    layer = layer_of(module)
    return TOP - 1 if layer is None else LAYERS.index(layer)


def room_of(module: str) -> str:
    """Return the room that a module is in."""
    return ".".join(module.split(".")[:2])


def modules_of_rooms(graph: grimp.ImportGraph) -> list[str]:
    """Return the modules inside rooms."""
    return sorted(name for name in graph.modules if name.count(".") >= 2 and room_of(name) not in NO_ROOMS)


def reached_from(graph: grimp.ImportGraph, module: str) -> Iterator[str]:
    """Yield the modules with a layer that a module of the same room imports, itself or through free names."""
    waiting, seen = [module], {module}
    while waiting:
        for name in graph.find_modules_directly_imported_by(waiting.pop()) - seen:
            if room_of(name) != room_of(module):
                continue
            seen.add(name)
            if layer_of(name) is None:
                waiting.append(name)
            else:
                yield name


def imports_upwards(graph: grimp.ImportGraph) -> list[str]:
    """Return each import of a higher layer by a lower one."""
    return [
        f"{module} -> {name}"
        for module in modules_of_rooms(graph)
        for name in sorted(reached_from(graph, module))
        if height_of(name) > height_of(module)
    ]


def imports_of_libraries(graph: grimp.ImportGraph) -> list[str]:
    """Return each import of a library by a module whose layer does not know it."""
    return [
        f"{module} -> {library}"
        for module in modules_of_rooms(graph)
        for library in sorted(graph.find_modules_directly_imported_by(module) & MAY_KNOW.keys())
        if layer_of(module) not in MAY_KNOW[library]
    ]


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


@cache
def graph_of_app() -> grimp.ImportGraph:
    """Return the imports of the server, without those that only types need."""
    return grimp.build_graph("app", include_external_packages=True, exclude_type_checking_imports=True, cache_dir=None)


def test_no_module_imports_a_higher_layer():
    assert imports_upwards(graph_of_app()) == []


def test_each_library_is_known_where_it_belongs():
    assert imports_of_libraries(graph_of_app()) == []


def test_only_queries_select() -> None:
    """A SELECT is where reviewers look for the caller's access in its WHERE."""
    sources = {path.relative_to(ROOT): path.read_text() for path in ROOT.glob("app/*/**/*.py")}
    selecting = {".".join(path.with_suffix("").parts) for path, source in sources.items() if selects(source)}
    in_rooms = {module for module in selecting if room_of(module) not in NO_ROOMS}
    assert len(in_rooms) > 20
    assert {module for module in in_rooms if layer_of(module) != "queries"} == set(SELECTS_ELSEWHERE)


def test_the_tests_see_what_they_look_for() -> None:
    graph = grimp.ImportGraph()
    for importer, imported in (
        ("app.money.rules", "app.money.amounts"),
        ("app.money.amounts", "app.money.due_queries"),
        ("app.money.service", "app.money.ledger.endpoints"),
        ("app.money.amounts", "app.money.jobs"),
        ("app.money.endpoints", "app.money.service"),
        ("app.money.web.cookies", "fastapi"),
        ("app.money.service", "fastapi"),
        ("app.money.rules", "pydantic"),
    ):
        graph.add_import(importer=importer, imported=imported)
    assert imports_upwards(graph) == [
        "app.money.amounts -> app.money.jobs",
        "app.money.rules -> app.money.due_queries",
        "app.money.rules -> app.money.jobs",
        "app.money.service -> app.money.ledger.endpoints",
    ]
    assert imports_of_libraries(graph) == ["app.money.rules -> pydantic", "app.money.service -> fastapi"]
    assert selects("rows = session.scalars(select(Cue))")
    assert selects("row = session.scalar(sa.select(Cue))")
    assert not selects("session.execute(delete(Cue))")
