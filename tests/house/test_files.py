"""What lies beside the code: containers, commands, documents and the OpenAPI document say what is true."""

import json
import re
import shutil
import subprocess
import tomllib
from importlib.util import find_spec
from pathlib import Path

import pytest
from pydantic import SecretStr
from typer.testing import CliRunner

from app.cli import cli
from app.settings import Settings

pytestmark = pytest.mark.lint

ROOT = Path(__file__).resolve().parents[2]
DOCUMENTS = [
    *sorted(ROOT.glob("*.md")),
    *sorted((ROOT / "docs").rglob("*.md")),
    *(ROOT / folder / "README.md" for folder in ("frontend", "training")),
]
DECISIONS = sorted((ROOT / "docs" / "decisions").glob("[0-9]*.md"))
SERVER_COMMANDS = {
    "adopt",
    "ci",
    "desk",
    "serve",
    "worker",
    "migrate",
    "backup",
    "restore",
    "scrub",
    "move",
    "export",
    "import",
    "verify",
    "brief",
    "fmod",
    "kits",
    "postings",
    "demo",
    "token",
    "pull",
    "why",
    "openapi",
    "mails",
    "quota",
    "sign-out",
}


def test_every_setting_that_the_documents_name_is_one():
    known = {f"SOUNDLIST_{name.upper()}" for name in Settings.model_fields} | {"SOUNDLIST_LOG_LEVEL", "SOUNDLIST_TOKEN"}
    for path in [ROOT / "README.md", *(ROOT / "docs").rglob("*.md")]:
        named = set(re.findall(r"SOUNDLIST_[A-Z_]+[A-Z]", path.read_text()))
        assert named <= known, path


def test_the_page_of_settings_lists_each_with_its_default():
    rows = re.findall(
        r"^\| `([A-Z_]+)` \| .+ \| (?:`(.+)`|none\b.*) \|$",
        (ROOT / "docs/reference/settings.md").read_text(),
        re.MULTILINE,
    )
    own = {"demo", "frontend_dir"}  # set by `soundlist demo`, and by where the checkout is
    fields = {
        str(field.validation_alias or f"SOUNDLIST_{name.upper()}"): field.default
        for name, field in Settings.model_fields.items()
        if name not in own
    }
    assert dict(rows) == {name: in_the_environment(default) for name, default in fields.items()}
    assert len(rows) == len(fields)


def in_the_environment(default: object) -> str:
    """Return a default as an operator would set it; nothing for none."""
    if isinstance(default, bool):
        return str(default).lower()
    if isinstance(default, float):
        return f"{default:g}"
    if isinstance(default, SecretStr):
        return default.get_secret_value()
    return "" if default in (None, ()) else str(default)


def test_the_command_line_has_the_commands_it_promises():
    assert {command.name or command.callback.__name__ for command in cli.registered_commands} == SERVER_COMMANDS
    groups = {
        group.name: {command.name for command in group.typer_instance.registered_commands}
        for group in cli.registered_groups
    }
    assert groups == {
        "jobs": {"list", "retry"},
        "operators": {"add", "remove", "list"},
        "accounts": {"add", "bind-domain", "remove-second-factor", "unbind-domain"},
        "erase": {"person", "project", "studio"},
    }


def commands_in_documents(program: str) -> set[str]:
    """The commands that the documents show, from the program's name to the end of the code or a comment."""
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
    groups = {"jobs", "operators", "erase", "accounts"}
    assert {command.split()[0] for command in named} == SERVER_COMMANDS - {"openapi"} | groups
    for command in named:
        words = [word for word in command.split() if re.fullmatch(r"[a-z][a-z-]*", word)]
        has_action = words[0] in groups or words[:2] in (["desk", "add"], ["desk", "remove"])
        shown = CliRunner().invoke(cli, [*words[: 2 if has_action else 1], "--help"])
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


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: str(path.relative_to(ROOT)))
def test_links_between_documents_lead_somewhere(document: Path):
    for link, anchor in re.findall(r"\]\(([^)#\s]*)#?([^)\s]*)\)", without_code(document.read_text())):
        if "://" in link:
            continue
        target = document.parent / link if link else document
        assert target.exists(), link
        if anchor:
            assert anchor in anchors(target), f"{link}#{anchor}"


def without_code(text: str) -> str:
    """Return Markdown without its fenced code."""
    return re.sub(r"^```.*?^```", "", text, flags=re.MULTILINE | re.DOTALL)


def anchors(document: Path) -> set[str]:
    """Return the anchors of a document's headings, as forges make them."""
    names: list[str] = []
    for heading in re.findall(r"^#+ (.+?) *$", without_code(document.read_text()), re.MULTILINE):
        words = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading).lower()
        name = re.sub(r"[^\w\- ]", "", words).replace(" ", "-")
        names.append(f"{name}-{names.count(name)}" if name in names else name)
    return set(names)


def test_anchors_are_those_of_forges(tmp_path: Path):
    page = tmp_path / "page.md"
    page.write_text(
        "# What it *costs*\n## A take: `check`, and its [cue](x.md)\n```\n# no heading\n```\n## Limits\n## Limits\n"
    )
    assert anchors(page) == {"what-it-costs", "a-take-check-and-its-cue", "limits", "limits-1"}


def test_decisions_are_numbered_once():
    numbers = [decision.name[:4] for decision in DECISIONS]
    assert sorted(set(numbers)) == numbers


def test_the_openapi_document_is_the_servers():
    reported = subprocess.run(
        [str(ROOT / ".venv/bin/python"), "-m", "app", "openapi"], cwd=ROOT, capture_output=True, text=True, check=True
    )
    assert json.loads(reported.stdout) == json.loads((ROOT / "frontend/openapi.json").read_text())


def test_make_lists_the_commands_of_every_day_and_contributing_the_others():
    makefile = (ROOT / "Makefile").read_text()
    listed = set(re.findall(r"^([a-z0-9-]+):.*## ", makefile, re.MULTILINE))
    assert "run" in listed
    assert len(listed) <= 15
    targets = set(re.findall(r"^([a-z0-9-]+):", makefile, re.MULTILINE))
    named = {
        target
        for code in re.findall(r"```.*?```|`[^`\n]+`", (ROOT / "CONTRIBUTING.md").read_text(), re.DOTALL)
        for target in re.findall(r"[a-z][a-z0-9-]+", code)
    }
    assert targets - named == set()


def test_no_version_is_written_down():
    """It is that of the tag, in whatever is built from it."""
    for path in ("pyproject.toml", "packages/soundlist/pyproject.toml"):
        project = tomllib.loads((ROOT / path).read_text())["project"]
        assert (project["dynamic"], "version" in project) == (["version"], False)
    assert json.loads((ROOT / "frontend/package.json").read_text())["version"] == "0.0.0"  # never published


def test_the_lock_files_name_no_mirror():
    """Every package comes from uv's default index, so the lock works wherever that can be reached."""
    sources = {
        package["source"].get("registry") for package in tomllib.loads((ROOT / "uv.lock").read_text())["package"]
    }
    assert len(sources - {None}) == 1  # None: this workspace itself
    assert "index" not in tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["uv"]
    assert '"resolved"' not in (ROOT / "frontend/package-lock.json").read_text()


def test_scripts_parse():
    for script in (script for script in (ROOT / ".ci").iterdir() if script.suffix != ".py"):
        shell = shutil.which("bash")
        assert shell
        subprocess.run([shell, "-n", str(script)], check=True)
