"""Completion of `soundlist`, asked of the shells themselves."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
import typer

from app.cli import cli
from app.cli.completion import Shell
from tests.support import shells

pytestmark = pytest.mark.slow

ROOT = Path(__file__).parents[3]


def printed(*arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-P", "-m", "app", *arguments],
        capture_output=True, text=True, check=False, env=os.environ | {"PYTHONPATH": str(ROOT)},
    )  # fmt: skip


@pytest.fixture(scope="module")
def scripts(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """What `soundlist --show-completion` prints for each shell, in a file."""
    folder, files = tmp_path_factory.mktemp("completion"), {}
    for shell in Shell:
        answer = printed("--show-completion", shell)
        assert (answer.returncode, answer.stderr) == (0, "")
        files[shell.value] = folder / shell.value
        files[shell.value].write_text(answer.stdout)
    return files


def needs(shell: str) -> pytest.MarkDecorator:
    return pytest.mark.skipif(not shells.installed(shell), reason=f"{shell} is not installed")


LINES = [
    ("soundlist de", {"demo", "desk"}),
    ("soundlist jobs ", {"list", "retry"}),
    ("soundlist operators r", {"remove"}),
    ("soundlist desk ", {"add", "list", "remove"}),
    ("soundlist serve --p", {"--port"}),
    ("soundlist pull --no", {"--no-placeholders"}),
    ("soundlist desk --page page.html --serv", {"--server"}),
    ("soundlist why --format ", {"text", "json"}),
    ("soundlist brief --format j", {"json"}),
    ("soundlist --show-completion ", {"bash", "zsh", "fish"}),
    ("soundlist backup z", {"zsh"}),  # a file of the folder
    ("soundlist why --folder z", {"zsh"}),
    ("soundlist ", set(typer.main.get_command(cli).commands)),
]


@pytest.mark.parametrize(("line", "wanted"), LINES)
def test_bash(scripts: dict[str, Path], line: str, wanted: set[str]) -> None:
    assert shells.offered_by_bash(scripts["bash"], line, "_shtab_soundlist") == wanted


def test_bash_completes_the_program_by_that_function(scripts: dict[str, Path]) -> None:
    said = shells.run("bash", f"source {scripts['bash']}; complete -p soundlist", folder=scripts["bash"].parent)
    assert said == "complete -o bashdefault -F _shtab_soundlist soundlist\n"


@needs("fish")
@pytest.mark.parametrize(("line", "wanted"), LINES)
def test_fish(scripts: dict[str, Path], line: str, wanted: set[str]) -> None:
    assert shells.offered_by_fish(scripts["fish"], line) == wanted


@needs("zsh")
def test_zsh(scripts: dict[str, Path]) -> None:
    with shells.zsh(scripts["zsh"], os.environ["PATH"]) as terminal:
        for typed, completed in (
            ("soundlist oper\t", "operators"),
            ("rem\t", "remove"),
            ("\x15soundlist serve --po\t", "--port"),
            ("\x15soundlist why --form\t", "--format"),
            ("js\t", "json"),
        ):
            shells.complete(terminal, typed, completed)


def test_another_shell_is_refused_with_those_that_there_are() -> None:
    answer = printed("--show-completion", "tcsh")
    assert answer.returncode == 2
    assert all(shell in answer.stderr for shell in ("tcsh", "bash", "zsh", "fish"))


def test_the_help_names_the_program() -> None:
    assert "Usage: soundlist" in printed("--help").stdout
