"""Name the test files that a change can affect, nearest first: what `make quick` runs.

    python -m tests.affected [--since REVISION] [--files 25]

Without a revision the change is what is not committed yet. A test file is near when it imports a changed module, by
few steps, or lies in the folder of tests of the changed module's package. Modules that put the whole server together
import everything, so the search does not go through them: `make test` is what proves that nothing broke.
"""

import argparse
import ast
import subprocess
import sys
from collections import defaultdict, deque
from collections.abc import Iterable, Iterator, Mapping
from collections.abc import Set as AbstractSet
from pathlib import Path, PurePosixPath

ROOT = Path(__file__).resolve().parents[1]
PACKAGES = ("app", "audio_checks", "benchmarks", "tests", "training")
# These import every package of the server.
PUT_TOGETHER = {
    "app/commercial.py",
    "app/main.py",
    "app/registry.py",
    "app/tables.py",
    "app/worker.py",
    "tests/support/server.py",
}
NEIGHBOUR = 2  # steps to a test that lies in the folder of tests of the changed module's package


def changed_files(root: Path, since: str) -> set[str]:
    """Return the paths that differ from a revision, those that are not tracked yet too."""

    def paths(*command: str) -> list[str]:
        git = subprocess.run(["git", *command], cwd=root, capture_output=True, text=True, check=True)  # noqa: S607
        return git.stdout.split("\0")

    listed = paths("diff", "--name-only", "-z", since) + paths("ls-files", "--others", "--exclude-standard", "-z")
    return {path for path in listed if path}


def imported_names(source: str) -> Iterator[str]:
    """Yield the dotted names that a module imports, wherever it does."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
            yield from (f"{node.module}.{alias.name}" for alias in node.names)


def importers(root: Path) -> dict[str, set[str]]:
    """Return for each file of Python those that import it."""
    files = {str(path.relative_to(root)): path for name in PACKAGES for path in (root / name).rglob("*.py")}
    found = defaultdict(set)
    for file, path in files.items():
        for name in imported_names(path.read_text(encoding="utf-8")):
            place = name.replace(".", "/")
            module = place.rpartition("/")[0]
            for target in (f"{place}.py", f"{place}/__init__.py", f"{module}.py", f"{module}/__init__.py"):
                if target in files:
                    found[target].add(file)
                    break
    return found


def is_test(file: str) -> bool:
    """Whether pytest collects a file."""
    name = PurePosixPath(file).name
    return file.startswith("tests/") and name.startswith("test_") and name.endswith(".py")


def distances(changed: Iterable[str], imported_by: Mapping[str, AbstractSet[str]]) -> dict[str, int]:
    """Return the steps from the nearest changed file to each file that imports it."""
    steps = dict.fromkeys(changed, 0)
    waiting = deque(steps)
    while waiting:
        file = waiting.popleft()
        if steps[file] and file in PUT_TOGETHER:
            continue
        for importer in imported_by.get(file, ()):
            if importer not in steps:
                steps[importer] = steps[file] + 1
                waiting.append(importer)
    return steps


def beside(changed: str, tests: Iterable[str]) -> dict[str, int]:
    """Return the tests in the folder of a changed module's tests; one named after it is as near as an importer."""
    path = PurePosixPath(changed)
    if path.suffix != ".py":
        return {}
    folder = path.parent if path.name == "conftest.py" else PurePosixPath("tests") / path.parent
    near = [test for test in tests if PurePosixPath(test).is_relative_to(folder)] if len(folder.parts) > 2 else []
    return {test: 1 if PurePosixPath(test).stem.startswith(f"test_{path.stem}") else NEIGHBOUR for test in near}


def affected(root: Path, changed: AbstractSet[str]) -> list[str]:
    """Return the test files that a change can affect, nearest first."""
    tests = [str(path.relative_to(root)) for path in (root / "tests").rglob("test_*.py")]
    steps = {file: count for file, count in distances(changed, importers(root)).items() if is_test(file)}
    for file in changed:
        for test, count in beside(file, tests).items():
            steps[test] = min(count, steps.get(test, count))
    return sorted((test for test in steps if (root / test).exists()), key=lambda test: (steps[test], test))


def main() -> None:
    """Print the nearest test files, and on stderr how many were left out."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--since", default="HEAD", help="a revision; by default the last commit")
    parser.add_argument("--files", type=int, default=25, help="how many test files at most")
    options = parser.parse_args()
    tests = affected(ROOT, changed_files(ROOT, options.since or "HEAD"))
    sys.stdout.writelines(f"{test}\n" for test in tests[: options.files])
    if left_out := len(tests) - options.files:
        note = f"; {left_out} further ones are left to make test" if left_out > 0 else ""
        sys.stderr.write(f"{min(len(tests), options.files)} test files are near the change{note}\n")


if __name__ == "__main__":
    main()
