"""What lies beside the code: containers, commands, documents and the OpenAPI document say what is true."""

import json
import re
import shutil
import subprocess
from importlib.util import find_spec
from pathlib import Path

import pytest
from pydantic import SecretStr
from typer.testing import CliRunner

from app.cli import cli
from app.settings import Settings
from audio_checks.version import TOOL_VERSION

ROOT = Path(__file__).resolve().parents[2]
DOCUMENTS = [
    *sorted(ROOT.glob("*.md")),
    *sorted((ROOT / "docs").rglob("*.md")),
    *(ROOT / folder / "README.md" for folder in ("frontend", "training")),
]
PAGES = [path for path in sorted((ROOT / "docs").rglob("*.md")) if path.parent.name != "decisions"]
DECISIONS = sorted((ROOT / "docs" / "decisions").glob("[0-9]*.md"))
PARTS = ["Status", "Context", "Decision", "Consequences"]
MAX_WORDS = 1500  # of a page that is read from its beginning; figures in tables count
REFERENCE = {"domain.md", "security.md"}  # looked up row by row
MAX_LINES = 400
CODE = {".c", ".cs", ".css", ".h", ".js", ".mjs", ".py", ".sh", ".sql", ".ts", ".tsx"}
FOLDERS = ["app", "audio_checks", "benchmarks", "deploy", "frontend/e2e", "frontend/scripts", "frontend/src",
           "integrations", "migrations", "tests", "training"]  # fmt: skip
MAY_BE_LONGER = {
    "frontend/src/api/schema.gen.ts": "generated from the OpenAPI document",
    "migrations/versions/0027_tables_of_the_first_release.py": "all tables of a release, in the order of their keys",
}
SERVER_COMMANDS = {
    "adopt",
    "desk",
    "serve",
    "worker",
    "migrate",
    "backup",
    "restore",
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
    for path in [ROOT / "README.md", *(ROOT / "docs").glob("*.md")]:
        named = set(re.findall(r"SOUNDLIST_[A-Z_]+[A-Z]", path.read_text()))
        assert named <= known, path


def test_the_page_of_settings_lists_each_with_its_default():
    rows = re.findall(
        r"^\| `([A-Z_]+)` \| .+ \| (?:`(.+)`|none\b.*) \|$", (ROOT / "docs/settings.md").read_text(), re.MULTILINE
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
    assert groups == {"jobs": {"list", "retry"}, "operators": {"add", "remove", "list"}}


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


def too_long(root: Path, folder: str, most: int = MAX_LINES) -> dict[str, int]:
    """Return the files of code of a folder that have more lines than that, with their number."""
    files = [path for path in (root / folder).rglob("*") if path.suffix in CODE]
    assert files
    lines = {str(path.relative_to(root)): len(path.read_text().splitlines()) for path in files}
    return {name: count for name, count in lines.items() if count > most}


@pytest.mark.parametrize("folder", FOLDERS)
def test_no_file_is_too_long_to_read_at_once(folder: str):
    assert {name for name in too_long(ROOT, folder) if name not in MAY_BE_LONGER} == set()


def test_what_may_be_longer_is_there():
    assert [name for name in MAY_BE_LONGER if not (ROOT / name).is_file()] == []


def test_a_long_file_would_be_found(tmp_path: Path):
    (tmp_path / "pages").mkdir()
    for name, lines in {"short.py": 3, "long.py": 4, "long.css": 4, "long.md": 4}.items():
        (tmp_path / "pages" / name).write_text("\n" * lines)
    assert too_long(tmp_path, "pages", 3) == {"pages/long.py": 4, "pages/long.css": 4}


def test_every_command_of_the_server_that_the_documents_name_is_one():
    named = commands_in_documents("soundlist")
    assert {command.split()[0] for command in named} == SERVER_COMMANDS - {"demo", "openapi"} | {"jobs", "operators"}
    for command in named:
        words = [word for word in command.split() if re.fullmatch(r"[a-z][a-z-]*", word)]
        has_action = words[0] in ("jobs", "operators") or words[:2] in (["desk", "add"], ["desk", "remove"])
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


@pytest.mark.parametrize("page", sorted((ROOT / "docs").glob("*.md")), ids=lambda path: path.name)
def test_pages_are_short(page: Path):
    words = [word for word in page.read_text().split() if re.search(r"\w", word)]
    assert len(words) <= MAX_WORDS or page.name in REFERENCE


def beginning(page: str) -> str:
    """Return what a page has between its title and the first empty line after; "" for a heading, a table or code."""
    found = re.match(r"(?:<!--.*?-->\s*)?# [^\n]+\n\s*(.+?)(?:\n\s*\n|\Z)", page, re.DOTALL)
    return "" if found is None or found[1].startswith(("#", "|", "```", "<")) else found[1]


@pytest.mark.parametrize("page", PAGES, ids=lambda path: str(path.relative_to(ROOT)))
def test_pages_begin_with_a_sentence(page: Path):
    assert re.search(r"\w+ \w+.*[.:]", beginning(page.read_text()), re.DOTALL), "say first what one can do with it"


@pytest.mark.parametrize(
    ("page", "text"),
    [
        ("# Packs\n\n## Targets\nA target says what.\n", ""),
        ("# Packs\n\n| to | do |\n|---|---|\n| a | b |\n", ""),
        ("# Packs\n\n```\nmake it.\n```\n", ""),
        ("# Packs\n", ""),
        ("# Packs\n\nDownload\nfiles.\n\n## Targets\n", "Download\nfiles."),
        ("<!-- Made. -->\n\n# Packs\n\n- Download files.\n", "- Download files.\n"),
    ],
)
def test_the_beginning_of_a_page_is_its_first_paragraph(page: str, text: str):
    assert beginning(page) == text


@pytest.mark.parametrize("decision", DECISIONS, ids=lambda path: path.stem)
def test_decisions_have_status_context_decision_and_consequences(decision: Path):
    text = decision.read_text()
    title = re.match(r"# 0*(\d+)\b", text)
    assert title
    assert int(title[1]) == int(decision.name[:4])
    assert [part for part in re.findall(r"^\*\*(\w+)\.\*\*", text, re.MULTILINE) if part in PARTS] == PARTS


def test_decisions_are_numbered_once():
    numbers = [decision.name[:4] for decision in DECISIONS]
    assert sorted(set(numbers)) == numbers


def test_the_openapi_document_is_the_servers():
    reported = subprocess.run(
        [str(ROOT / ".venv/bin/python"), "-m", "app", "openapi"], cwd=ROOT, capture_output=True, text=True, check=True
    )
    assert json.loads(reported.stdout) == json.loads((ROOT / "frontend/openapi.json").read_text())


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
