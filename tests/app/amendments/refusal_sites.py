"""Every refusal of the rooms of contracts, found by reading their modules."""

import ast
import importlib
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

from app.core.errors import NotFound, Refused

APP = Path(__file__).resolve().parents[3] / "app"
PLACES = ("agreements", "amendments", "money", "deliveries/downloads.py")  # rooms and files
# Functions that refuse for their caller.
CALLS = {"ensure_state": "WrongState", "not_agreed": "NotAgreed", "_details_missing": "InvoiceDetailsMissing"}


def refusal_sites() -> list[str]:
    """Return each place that refuses, as `room.module.function Error`, numbered where a function has several.

    What does not exist, or may not be seen, is left out: its text has nothing to advise.
    """
    found: list[str] = []
    for place in PLACES:
        for path in sorted((APP / place).rglob("*.py")) or [APP / place]:
            name = ".".join(path.relative_to(APP).with_suffix("").parts)
            module = importlib.import_module(f"app.{name}")
            found += [f"{name}.{site}" for site in _sites(module, ast.parse(path.read_text()))]
    times = Counter(found)
    seen: Counter[str] = Counter()
    numbered = []
    for site in found:
        seen[site] += 1
        numbered.append(f"{site} {seen[site]}" if times[site] > 1 else site)
    return numbered


def _sites(module: ModuleType, tree: ast.AST, function: str = "") -> Iterator[str]:
    for node in ast.iter_child_nodes(tree):
        inside = node.name if isinstance(node, ast.FunctionDef) else function
        if isinstance(node, ast.Raise) and isinstance(node.exc, ast.Call):
            yield from _raised(module, node.exc, function)
        elif isinstance(node, ast.Call) and _name(node) == "ensure_state":
            yield f"{function} WrongState"
        elif isinstance(node, ast.Return) and _is_problem(module, function, node.value):
            yield f"{function} BadChangeOrder"
        yield from _sites(module, node, inside)


def _raised(module: ModuleType, call: ast.Call, function: str) -> Iterator[str]:
    name = _name(call)
    error = getattr(module, name, None)
    if name in CALLS:
        yield f"{function} {CALLS[name]}"
    elif isinstance(error, type) and issubclass(error, Refused) and not issubclass(error, NotFound):
        yield f"{function} {name}"


def _name(call: ast.Call) -> str:
    return call.func.id if isinstance(call.func, ast.Name) else ""


def _is_problem(module: ModuleType, function: str, value: ast.expr | None) -> bool:
    is_review = module.__name__.endswith(("change_order_review", ".caps"))
    if not is_review or not function.startswith(("_problems", "problems")):
        return False
    return isinstance(value, ast.ListComp) or (isinstance(value, ast.List) and bool(value.elts))
