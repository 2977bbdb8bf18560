"""What other systems start: the hooks, the action and the examples parse, and their commands do what they say.

That GitHub, GitLab, pre-commit or a Perforce server really starts them is not tested.
"""

import os
import re
import stat
import subprocess
import sys
import tomllib
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest
import yaml

from audio_checks.spec.delivery_spec import new_spec
from audio_checks.spec.sound_names import AUDIO_SUFFIXES
from tests.support.waves import sine, write_wav

pytestmark = pytest.mark.slow

ROOT = Path(__file__).resolve().parents[2]
BIN = Path(sys.executable).parent
GOOD = sine(hz=997, dbfs=-6, seconds=0.2)
LOUD = sine(hz=997, dbfs=0.0, seconds=0.2)
ACTION = yaml.safe_load((ROOT / "action.yml").read_text())
GITLAB = yaml.safe_load((ROOT / "integrations/gitlab/audio-checks.gitlab-ci.yml").read_text())["audio-checks"]
RELEASE = yaml.safe_load((ROOT / ".github/workflows/release.yml").read_text())["jobs"]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())
TEXTS = [
    path
    for path in (*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md"), *ROOT.glob("integrations/**/*"), ROOT / "action.yml")
    if path.is_file() and path.suffix != ".pyc"
]
HOOKS = yaml.safe_load((ROOT / ".pre-commit-hooks.yaml").read_text())


@pytest.fixture
def tree(tmp_path):
    """A game with a spec, one good sound and one that is too loud."""
    assets = tmp_path / "game" / "assets"
    assets.mkdir(parents=True)
    (assets.parent / "audio-checks.toml").write_text(new_spec())
    write_wav(assets / "good.wav", GOOD)
    write_wav(assets / "loud one.wav", LOUD)
    return assets.parent


def run_in(folder, command, **environment):
    """Run a command as a fresh machine would: with the tool on its PATH, and nothing remembered."""
    whole = {
        **os.environ,
        "PATH": f"{BIN}:{os.environ['PATH']}",
        "PYTHONPATH": str(ROOT),
        "AUDIO_CHECKS_CACHE_DIR": str(folder.parent / "verdicts"),
        **environment,
    }
    return subprocess.run(command, cwd=folder, env=whole, capture_output=True, text=True)


@pytest.mark.parametrize(
    ("schema", "path"),
    [
        ("vendor.github-actions", "action.yml"),
        ("vendor.gitlab-ci", "integrations/gitlab/audio-checks.gitlab-ci.yml"),
        ("vendor.github-workflows", ".github/workflows/release.yml"),
        ("vendor.github-issue-config", ".github/ISSUE_TEMPLATE/config.yml"),
        *(("vendor.github-issue-forms", f".github/ISSUE_TEMPLATE/{form}.yml") for form in ("bug", "idea", "verdict")),
    ],
)
def test_the_files_are_what_their_services_take(schema, path):
    command = [sys.executable, "-m", "check_jsonschema", "--builtin-schema", schema, str(ROOT / path)]
    said = subprocess.run(command, capture_output=True, text=True)
    assert said.returncode == 0, said.stdout + said.stderr


class TestAction:
    def run_check(self, tree, **inputs):
        (step,) = [step for step in ACTION["runs"]["steps"] if step["name"] == "Check"]
        given = {name: inputs.pop(name.replace("-", "_"), one["default"]) for name, one in ACTION["inputs"].items()}
        assert not inputs
        environment = {
            name: re.sub(r"\$\{\{ inputs\.([a-z-]+) \}\}", lambda found: given[found[1]], value)
            for name, value in step["env"].items()
            if "inputs." in value
        }
        summary = tree.parent / "summary.md"
        done = run_in(tree, ["bash", "-e", "-c", step["run"]], GITHUB_STEP_SUMMARY=str(summary), **environment)
        return done, summary.read_text() if summary.exists() else ""

    def test_it_annotates_the_files(self, tree):
        done, summary = self.run_check(tree, paths="assets\n", sarif="found.sarif")
        assert done.returncode == 1, done.stderr
        assert "::error file=assets/loud one.wav,title=naming%3Apattern in loud one.wav::name " in done.stdout
        assert "2 files: 1 conforming, 1 rejected" in done.stdout
        assert "| assets/loud one.wav | rejected |" in summary
        assert (tree / "found.sarif").exists()

    def test_every_input_reaches_the_command(self, tree):
        (tree / "sounds.csv").write_text("number,file_name\n1,good\n")
        (tree / "baseline.json").write_text('{"format": 1, "waived": []}')
        done, _ = self.run_check(tree, paths="assets/good.wav", list="sounds.csv", baseline="baseline.json")
        assert done.returncode == 0, done.stderr
        done, _ = self.run_check(tree, paths="assets/good.wav", spec="audio-checks.toml", target="handheld")
        assert done.returncode == 1
        assert "sample-rate:not-accepted" in done.stdout
        done, _ = self.run_check(tree, changed_since="HEAD")
        assert (done.returncode, "in no Git repository" in done.stderr) == (2, True)
        done, _ = self.run_check(tree, fail_level="note")
        assert done.returncode == 2

    def test_what_an_input_holds_is_never_a_command(self):
        for step in ACTION["runs"]["steps"]:
            assert "${{" not in step.get("run", ""), step["name"]

    def test_a_sound_without_a_spec_fails_unless_that_is_allowed(self, tree):
        (tree / "audio-checks.toml").unlink()
        done, _ = self.run_check(tree, paths="assets/good.wav")
        assert (done.returncode, "no delivery spec" in done.stderr) == (2, True)
        done, _ = self.run_check(tree, paths="assets/good.wav", require_spec="false")
        assert done.returncode == 0, done.stderr

    def test_what_it_installs_is_known_by_hashes(self):
        (step,) = [step for step in ACTION["runs"]["steps"] if step["name"].startswith("Install")]
        first, second = step["run"].strip().splitlines()
        assert '--require-hashes -r "$GITHUB_ACTION_PATH/integrations/requirements.txt"' in first
        assert "--no-deps --no-build-isolation" in second


class TestInstalling:
    def test_a_build_installs_the_version_that_it_names(self):
        """The newest one may judge a file differently from the one of yesterday."""
        for path in TEXTS:
            unpinned = re.findall(r"pip install[^\n]*\baudio-checks\b(?! @|==)[^\n]*", path.read_text())
            assert not unpinned, f"{path}: {unpinned}"

    def test_every_dependency_has_its_hashes(self):
        text = (ROOT / "integrations/requirements.txt").read_text()
        entries = re.split(r"^(?=[a-z])", text, flags=re.MULTILINE)[1:]
        assert all("--hash=sha256:" in entry for entry in entries)
        needed = [*PROJECT["project"]["dependencies"], *PROJECT["build-system"]["requires"]]
        assert {entry.partition("==")[0] for entry in entries} >= {name.partition(">")[0] for name in needed}

    def test_their_versions_are_those_that_are_tested(self):
        packages = tomllib.loads((ROOT / "uv.lock").read_text())["package"]
        locked = {(package["name"], package.get("version")) for package in packages}
        pinned = re.findall(r"^([a-z-]+)==([\w.]+)", (ROOT / "integrations/requirements.txt").read_text(), re.MULTILINE)
        assert set(pinned) <= locked

    def test_a_tag_that_is_another_commit_is_not_installed(self, tmp_path):
        git = ["git", "-C", str(tmp_path / "source"), "-c", "user.name=x", "-c", "user.email=x@example.com"]
        (tmp_path / "source").mkdir()
        for command in (
            ["init", "-q"],
            ["commit", "-q", "--allow-empty", "-m", "x"],
            ["tag", GITLAB["variables"]["AUDIO_CHECKS_TAG"]],
        ):
            assert subprocess.run([*git, *command]).returncode == 0
        commit = subprocess.run([*git, "rev-parse", "HEAD"], capture_output=True, text=True).stdout.strip()
        clone, guard, *_ = GITLAB["before_script"]
        for expected, code in ((commit, 0), ("0" * 40, 1), ("", 1)):
            place = tmp_path / f"clone of {expected}"
            done = run_in(
                tmp_path,
                ["sh", "-e", "-c", f"{clone}\n{guard}"],
                AUDIO_CHECKS_REPOSITORY=f"file://{tmp_path}/source",
                AUDIO_CHECKS_TAG=GITLAB["variables"]["AUDIO_CHECKS_TAG"],
                AUDIO_CHECKS_COMMIT=expected,
                AUDIO_CHECKS_SOURCE=str(place),
            )
            assert done.returncode == code, done.stderr

    def test_a_release_is_published_by_trusted_publishing(self):
        assert set(RELEASE["attest"]["needs"]) == set(RELEASE) - {"attest", "publish", "announce"}
        publish = RELEASE["publish"]
        assert (publish["needs"], publish["permissions"]) == ("attest", {"id-token": "write"})
        (step,) = [step for step in publish["steps"] if "gh-action-pypi-publish" in step.get("uses", "")]
        assert "with" not in step, "no password, no token"

    def test_action_hooks_and_job_are_of_one_tag(self):
        """The newest release in the changelog is the tag that the job and the documents name."""
        newest = re.findall(r"^## (\d+\.\d+\.\d+)", (ROOT / "CHANGELOG.md").read_text(), re.MULTILINE)[0]
        assert GITLAB["variables"]["AUDIO_CHECKS_TAG"] == f"v{newest}"
        referred = re.compile(
            r"(?:--branch |rev: |soundlist\.git@|IMAGE_TAG=|audio-checks==|soundlist==)v?(\d+\.\d+\.\d+)"
        )
        named = {path: set(referred.findall(path.read_text())) for path in [*TEXTS, ROOT / "deploy/env.example"]}
        assert set.union(*named.values()) == {newest}, {path: tags for path, tags in named.items() if tags - {newest}}


class TestGitLab:
    def run_script(self, folder, **environment):
        (script,) = GITLAB["script"]
        return run_in(folder, ["sh", "-e", "-c", script], AUDIO_PATHS=GITLAB["variables"]["AUDIO_PATHS"], **environment)

    def test_it_reports_what_the_job_collects(self, tree):
        done = self.run_script(tree)
        assert done.returncode == 1, done.stderr
        collected = [GITLAB["artifacts"]["reports"]["junit"], *GITLAB["artifacts"]["paths"]]
        assert all((tree / path).exists() for path in collected)
        suite = ET.parse(tree / collected[0]).getroot()  # noqa: S314 - it is our own
        assert (suite.get("tests"), suite.get("failures")) == ("2", "1")

    def test_a_merge_request_is_judged_by_what_it_touches(self, tree):
        git = ["git", "-c", "user.name=x", "-c", "user.email=x@example.com"]
        for command in ([*git, "init", "-q"], [*git, "add", "."], [*git, "commit", "-qm", "before"]):
            assert run_in(tree, command).returncode == 0
        base = run_in(tree, ["git", "rev-parse", "HEAD"]).stdout.strip()
        write_wav(tree / "assets" / "new.wav", GOOD)
        done = self.run_script(tree, CI_MERGE_REQUEST_DIFF_BASE_SHA=base)
        assert done.returncode == 0, done.stdout + done.stderr
        assert "1 file: 1 conforming" in done.stdout


class TestPreCommit:
    @pytest.mark.parametrize("hook", HOOKS, ids=lambda hook: hook["id"])
    def test_every_audio_file_is_asked_about_and_nothing_else(self, hook):
        pattern = re.compile(hook["files"])
        assert all(pattern.search(f"a/b{suffix}") and pattern.search(f"B{suffix.upper()}") for suffix in AUDIO_SUFFIXES)
        assert not any(pattern.search(name) for name in ("a.py", "wav", "a.wav.meta", "audio-checks.toml"))
        assert hook["files"].count("|") == len(AUDIO_SUFFIXES) - 1
        assert hook["require_serial"]  # several processes at once would hinder each other, and fix the same names

    @pytest.mark.parametrize(("name", "code"), [("good.wav", 0), ("loud one.wav", 1)])
    def test_its_command_judges_the_files_of_a_commit(self, tree, name, code):
        entry = HOOKS[0]["entry"].split()
        assert run_in(tree, [*entry, f"assets/{name}"]).returncode == code

    @pytest.mark.parametrize("hook", HOOKS, ids=lambda hook: hook["id"])
    def test_a_sound_without_a_spec_is_an_error(self, tree, hook):
        (tree / "audio-checks.toml").unlink()
        done = run_in(tree, [*hook["entry"].split(), "assets/good.wav"])
        assert (done.returncode, "no delivery spec" in done.stderr) == (2, True)

    def test_the_other_puts_names_right(self, tree):
        (tree / "assets" / "good.wav").rename(tree / "assets" / "Good One.WAV")
        done = run_in(tree, [*HOOKS[1]["entry"].split(), "assets/Good One.WAV"])
        assert done.returncode == 0, done.stdout + done.stderr
        assert (tree / "assets" / "good_one.wav").exists()


P4 = """#!{python}
import marshal, pathlib, shutil, sys
depot = pathlib.Path({depot!r})
arguments = sys.argv[1:]
assert arguments.pop(0) == "-G"
def answer(**facts):
    sys.stdout.buffer.write(marshal.dumps({{key.encode(): value.encode() for key, value in facts.items()}}, 0))
if arguments[0] == "files":
    if not arguments[1].endswith("@=1234"):
        answer(code="error", data=arguments[1] + " - no such changelist.\\n", severity="3")
        sys.exit(1)
    for path in sorted(depot.rglob("*")):
        if path.is_file():
            place = "//" + str(path.relative_to(depot)).replace("@", "%40").replace("#", "%23")
            action = "delete" if path.stat().st_size == 0 else "edit"
            answer(code="stat", depotFile=place, rev="2", action=action, change="1234", type="binary+l")
else:
    assert arguments[:3] == ["print", "-q", "-o"]
    place, _, revision = arguments[4].rpartition("@")
    assert revision == "=1234"
    shutil.copy(depot / place.removeprefix("//").replace("%40", "@").replace("%23", "#"), arguments[3])
    answer(code="stat", depotFile=place)
"""


class TestPerforce:
    @pytest.fixture
    def submit(self, tree):
        """Ask the trigger about what lies in a depot."""
        depot, programs = tree.parent / "depot", tree.parent / "programs"
        (depot / "game").mkdir(parents=True)
        programs.mkdir()
        stand_in = programs / "p4"
        stand_in.write_text(P4.format(python=sys.executable, depot=str(depot)))
        stand_in.chmod(stand_in.stat().st_mode | stat.S_IXUSR)

        def submit(*, change="1234", spec=tree / "audio-checks.toml"):
            trigger = [
                sys.executable,
                str(ROOT / "integrations/perforce/change_content.py"),
                "--spec",
                str(spec),
                change,
            ]
            return run_in(tree, trigger, PATH=f"{programs}:{os.environ['PATH']}")

        return depot / "game", submit

    def test_sounds_that_conform_are_let_in(self, submit):
        depot, ask = submit
        write_wav(depot / "good.wav", GOOD)
        (depot / "notes.txt").write_text("not a sound")
        done = ask()
        assert (done.returncode, done.stdout) == (0, ""), done.stdout + done.stderr

    def test_others_are_refused_with_a_reason(self, submit):
        depot, ask = submit
        write_wav(depot / "loud@home.wav", LOUD)
        done = ask()
        assert done.returncode == 1
        assert "./game/loud@home.wav  rejected" in done.stdout
        assert "fix: lower the level by 0.10 dB or more" in done.stdout

    def test_a_deleted_sound_is_not_judged(self, submit):
        depot, ask = submit
        (depot / "gone.wav").touch()
        assert ask().returncode == 0

    def test_a_fault_is_distinguished_from_a_finding(self, submit):
        depot, ask = submit
        write_wav(depot / "good.wav", GOOD)
        done = ask(spec="none.toml")
        assert (done.returncode, "not their fault" in done.stdout) == (1, True)
        done = ask(change="99")
        assert (done.returncode, "no such changelist" in done.stderr) == (1, True)
