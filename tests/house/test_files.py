"""What lies beside the code: containers, commands, documents and the OpenAPI document say what is true."""

import json
import re
import shutil
import subprocess
from importlib.util import find_spec
from pathlib import Path

from typer.testing import CliRunner

from app.cli import cli
from app.settings import Settings
from audio_checks.version import TOOL_VERSION

ROOT = Path(__file__).resolve().parents[2]
SERVER_COMMANDS = {
    "serve",
    "worker",
    "migrate",
    "backup",
    "restore",
    "verify",
    "demo",
    "token",
    "openapi",
    "mails",
    "quota",
}


def test_every_setting_that_the_documents_name_is_one():
    known = {f"SOUNDLIST_{name.upper()}" for name in Settings.model_fields} | {"SOUNDLIST_LOG_LEVEL", "SOUNDLIST_TOKEN"}
    for path in [ROOT / "README.md", *(ROOT / "docs").glob("*.md")]:
        named = set(re.findall(r"SOUNDLIST_[A-Z_]+[A-Z]", path.read_text()))
        assert named <= known, path


def test_the_guide_lists_every_setting():
    text = (ROOT / "docs/operate.md").read_text()
    table = text[text.index("## Settings") : text.index("## Watching it")]
    listed = set(re.findall(r"`((?:SOUNDLIST|AWS)_[A-Z_]+)`", "\n".join(re.findall(r"^\| [^|]+", table, re.MULTILINE))))
    own = {"demo", "frontend_dir"}  # set by `soundlist demo`, and by where the checkout is
    fields = {name: field for name, field in Settings.model_fields.items() if name not in own}
    assert listed == {str(field.validation_alias or f"SOUNDLIST_{name.upper()}") for name, field in fields.items()}


def test_the_command_line_has_the_commands_it_promises():
    assert {command.name or command.callback.__name__ for command in cli.registered_commands} == SERVER_COMMANDS
    groups = {
        group.name: {command.name for command in group.typer_instance.registered_commands}
        for group in cli.registered_groups
    }
    assert groups == {"jobs": {"list", "retry"}, "operators": {"add", "remove", "list"}}


def commands_in_documents(program: str) -> set[str]:
    """What the documents tell their readers to type, from the program's name to the end of the code or a comment."""
    documents = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *(ROOT / "docs").rglob("*.md")]
    typed = re.compile(rf"(?:`|^|[ /]){program} ([a-z][^`\n#]+)", re.MULTILINE)
    code = re.compile(r"```.*?```|`[^`\n]+`", re.DOTALL)
    return {
        command.strip().partition("  ")[0]
        for path in documents
        for part in code.findall(path.read_text())
        for command in typed.findall(part)
    }


def test_every_command_of_the_server_that_the_documents_name_is_one():
    named = commands_in_documents("soundlist")
    assert {command.split()[0] for command in named} == SERVER_COMMANDS - {"demo", "openapi"} | {"jobs", "operators"}
    for command in named:
        words = [word for word in command.split() if re.fullmatch(r"[a-z]+", word)]
        shown = CliRunner().invoke(cli, [*words[: 2 if words[0] in ("jobs", "operators") else 1], "--help"])
        assert shown.exit_code == 0, command
        assert all(flag in shown.output for flag in re.findall(r"--[a-z-]+", command)), command


def test_every_target_of_make_that_the_documents_name_is_one():
    named = {command.split()[0] for command in commands_in_documents("make")}
    assert {"run", "test", "kill", "bench"} <= named
    assert named <= set(re.findall(r"^([a-z0-9-]+):", (ROOT / "Makefile").read_text(), re.MULTILINE))


def test_every_module_that_the_documents_run_is_one():
    named = {command.split()[0] for command in commands_in_documents("python -m")}
    assert {"benchmarks.load", "benchmarks.scale", "benchmarks.throughput"} <= named
    assert all(find_spec(name) is not None for name in named)


def test_links_between_documents_lead_somewhere():
    documents = [*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md"), ROOT / "frontend" / "README.md"]
    for document in documents:
        for link in re.findall(r"\]\(([^)#\s]+)", document.read_text()):
            if "://" not in link:
                assert (document.parent / link).exists(), f"{document.name}: {link}"


def test_the_openapi_document_is_the_servers():
    told = subprocess.run(
        [str(ROOT / ".venv/bin/python"), "-m", "app", "openapi"], cwd=ROOT, capture_output=True, text=True, check=True
    )
    assert json.loads(told.stdout) == json.loads((ROOT / "frontend/openapi.json").read_text())


def test_the_library_is_the_version_that_the_package_says():
    assert f'version = "{TOOL_VERSION}"' in (ROOT / "pyproject.toml").read_text()


def test_the_lock_files_name_no_registry():
    for lock in ROOT.glob("constraints*.txt"):
        assert "://" not in lock.read_text(), lock.name
    assert '"resolved"' not in (ROOT / "frontend/package-lock.json").read_text()


def test_scripts_parse():
    for script in (ROOT / ".ci").iterdir():
        shell = shutil.which("bash")
        assert shell
        subprocess.run([shell, "-n", str(script)], check=True)
