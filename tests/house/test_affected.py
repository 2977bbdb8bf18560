"""Which tests `make quick` runs for a change."""

import subprocess
from pathlib import Path

import pytest

from tests.affected import affected, changed_files


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    """A small project: a server of two packages, and tests of each."""
    for name, source in {
        "app/main.py": "from app.money import endpoints\nfrom app.reviews import endpoints as reviews",
        "app/money/rules.py": "",
        "app/money/endpoints.py": "from app.money.rules import total",
        "app/reviews/endpoints.py": "def late():\n    import app.money.rules",
        "tests/support/server.py": "from app.main import create_app",
        "tests/support/sums.py": "from app.money import rules",
        "tests/app/money/conftest.py": "",
        "tests/app/money/test_rules.py": "from app.money.rules import total",
        "tests/app/money/test_invoices.py": "from tests.support.server import World",
        "tests/app/reviews/test_late.py": "from app.reviews import endpoints",
        "tests/app/hiring/test_bids.py": "from tests.support.server import World",
        "tests/house/test_sums.py": "from tests.support.sums import add",
    }.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(source)
    return tmp_path


@pytest.mark.parametrize(
    ("changed", "tests"),
    [
        (
            "app/money/rules.py",
            [
                "tests/app/money/test_rules.py",
                "tests/app/money/test_invoices.py",  # beside it
                "tests/app/reviews/test_late.py",
                "tests/house/test_sums.py",
            ],
        ),
        ("tests/app/hiring/test_bids.py", ["tests/app/hiring/test_bids.py"]),
        ("tests/app/money/conftest.py", ["tests/app/money/test_invoices.py", "tests/app/money/test_rules.py"]),
        ("tests/support/server.py", ["tests/app/hiring/test_bids.py", "tests/app/money/test_invoices.py"]),
        ("docs/explanation/contracts-and-money.md", []),
    ],
)
def test_the_nearest_come_first_and_the_whole_server_is_no_way(tree: Path, changed: str, tests: list[str]):
    assert affected(tree, {changed}) == tests


def test_a_change_is_what_is_not_committed_or_what_differs_from_a_revision(tree: Path):
    def git(*command: str) -> None:
        who = ("-c", "user.name=Test", "-c", "user.email=test@example.test")
        subprocess.run(["git", *who, *command], cwd=tree, check=True, capture_output=True)  # noqa: S607

    git("init", "--initial-branch=main")
    git("add", ".")
    git("commit", "-m", "Begin")
    (tree / "app/main.py").write_text("")
    git("commit", "-am", "Change")
    (tree / "app/new one.py").write_text("")
    assert changed_files(tree, "HEAD") == {"app/new one.py"}
    assert changed_files(tree, "HEAD~1") == {"app/new one.py", "app/main.py"}
