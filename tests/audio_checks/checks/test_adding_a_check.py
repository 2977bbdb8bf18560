"""A check is one file: put beside the others, it is in the spec, the lists, the reports, the fixes and the pages."""

import json
from pathlib import Path

import pytest

from tests.support.added_check import copy_with_check, run
from tests.support.waves import sine, write_wav

pytestmark = pytest.mark.slow

SPEC = 'format = 1\n[limits]\ncrest_db = 2.0\n[checks]\nlong-crest = "error"\n'


@pytest.fixture(scope="module")
def tree(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the package with one file more."""
    tree = copy_with_check(tmp_path_factory.mktemp("tree"))
    (tree / "spec.toml").write_text(SPEC)
    write_wav(tree / "tone.wav", sine(hz=997, dbfs=-6))
    return tree


def test_the_command_line_knows_it(tree: Path):
    listed = run(tree, "-m", "audio_checks.cli", "list").stdout
    assert "long-crest" in listed
    assert "warning" in next(line for line in listed.splitlines() if line.startswith("long-crest"))
    assert "use a limiter" in run(tree, "-m", "audio_checks.cli", "explain", "long-crest").stdout.lower()


def test_its_limit_and_its_severity_are_the_specs(tree: Path):
    checked = run(tree, "-m", "audio_checks.cli", "check", "--spec", "spec.toml", "--format", "json", "tone.wav")
    assert checked.returncode == 1, checked.stderr
    (finding,) = json.loads(checked.stdout)["files"][0]["findings"]
    assert (finding["code"], finding["severity"]) == ("long-crest:over", "error")
    assert finding["measured"] == pytest.approx(3.01, abs=0.01), "of a sine"
    (tree / "high.toml").write_text(SPEC.replace("2.0", "61.0"))
    refused = run(tree, "-m", "audio_checks.cli", "check", "--spec", "high.toml", "tone.wav")
    assert refused.returncode == 2
    assert "limits.crest_db" in refused.stderr


def test_its_page_and_its_answer_to_fixes_come_with_it(tree: Path):
    run(tree, "-m", "audio_checks.cli.pages", "pages")
    assert "tall peaks" in (tree / "pages" / "long-crest.md").read_text()
    assert "[long-crest](long-crest.md)" in (tree / "pages" / "README.md").read_text()
    fixed = run(tree, "-m", "audio_checks.cli", "fix", "--spec", "spec.toml", "--out", "fixed", "tone.wav")
    assert "its designer's choice" in fixed.stdout + fixed.stderr


def test_the_schema_of_a_spec_has_its_keys(tree: Path):
    schema = run(tree, "-m", "audio_checks.cli", "schema", "spec").stdout
    assert "crest_db" in schema
    assert "long-crest" in schema
