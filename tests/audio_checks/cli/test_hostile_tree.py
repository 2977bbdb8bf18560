"""A tree that is judged is never code: every command runs in it, and nothing that lies there is imported or started."""

import json
import os
import stat
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest

import audio_checks
from audio_checks import cli
from audio_checks.spec.delivery_spec import new_spec
from tests.support.flacs import flac_bytes
from tests.support.waves import sine, write_wav

BIN = Path(sys.executable).parent
HOSTILE = (
    "audio_checks/__init__.py",
    "audio_checks/cli/__init__.py",
    "encodings/__init__.py",
    "json.py",
    "multiprocessing/__init__.py",
    "numpy.py",
    "pickle.py",
    "sitecustomize.py",
    "soundfile.py",
    "usercustomize.py",
    ".local/lib/python3/site-packages/usercustomize.py",
)
PROGRAMS = ("git", "espeak-ng", "python", "python3")
APPROVED = json.dumps({"schema_version": 1, "fingerprint_version": audio_checks.FINGERPRINT_VERSION, "files": []})
COMMANDS = {
    "check": ["check", "good.wav", "packed.flac", "--no-cache"],
    "check -j 1": ["check", "-j", "1", ".", "--no-cache"],
    "check -j 2": ["check", "-j", "2", ".", "--no-cache"],
    "check -j 0": ["check", "-j", "0", ".", "--no-cache"],
    "check --fix": ["check", "--fix", "good.wav", "--no-cache"],
    "check --changed-since": ["check", "--changed-since", "HEAD", "good.wav", "--no-cache"],
    "measure": ["measure", "good.wav", "packed.flac"],
    "render": ["render", "good.wav", "--target", "handheld", "--out", "rendered"],
    "mend": ["fix", "good.wav", "--out", "fixed"],
    "export-master": ["export-master", "good.wav", "--out", "exported"],
    "placeholders": ["placeholders", "--list", "sounds.csv", "--spec", "spec.toml", "--out", "placeholders"],
    "memory": ["memory", "--list", "sounds.csv", "--spec", "spec.toml"],
    "manifest": ["manifest", ".", "--out", "manifest.json"],
    "audit": ["audit", "--manifest", "approved.json", ".", "-j", "2"],
    "explain": ["explain", "true-peak"],
    "list": ["list"],
    "new-spec": ["new-spec"],
    "schema": ["schema", "report"],
    "completion": ["completion", "bash"],
}


@pytest.fixture
def marker(tmp_path):
    return tmp_path / "executed"


@pytest.fixture
def tree(tmp_path, marker):
    """A game with sounds, a spec, a list, and files that write a marker when they are executed."""
    tree = tmp_path / "game"
    tree.mkdir()
    evidence = f"open({str(marker)!r}, 'a').write(__file__ + '\\n')\n"
    for name in HOSTILE:
        path = tree / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(evidence)
    (tree / "x.pth").write_text(f"import os; open({str(marker)!r}, 'a').write('x.pth\\n')\n")
    for name in PROGRAMS:
        program = tree / name
        program.write_text(f"#!/bin/sh\necho {name} >> {marker}\n")
        program.chmod(0o755)
    bare = tree / "good"  # a folder that Git takes for a bare repository, whose configuration names a program
    for folder in ("objects", "refs"):
        (bare / folder).mkdir(parents=True)
    (bare / "HEAD").write_text("ref: refs/heads/main\n")
    (bare / "config").write_text(f"[core]\nbare = false\nworktree = .\nfsmonitor = echo git >> {marker}; false\n")
    write_wav(bare / "inner.wav", sine(hz=440, dbfs=-6, seconds=0.1))
    for name, hz in (("good.wav", 997), ("other.wav", 440)):
        write_wav(tree / name, sine(hz=hz, dbfs=-6, seconds=0.3))
    (tree / "packed.flac").write_bytes(flac_bytes(sine(hz=300, dbfs=-6, seconds=0.3)))
    (tree / "audio-checks.toml").write_text(new_spec())
    (tree / "spec.toml").write_text(new_spec())
    (tree / "approved.json").write_text(APPROVED)
    (tree / "sounds.csv").write_text("number,file_name,duration_s\n1,good,0.3\n2,lacking,0.2\n")
    return tree


def run_in(tree, command):
    """Run a command as a CI does: in the tree, with the tree's folder first on PATH as `.`."""
    environment = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    environment |= {"PATH": f".:{os.environ['PATH']}", "HOME": str(tree)}
    return subprocess.run(command, cwd=tree, env=environment, capture_output=True, text=True, timeout=300)


def test_every_command_is_tried():
    assert {command[0] for command in COMMANDS.values()} == set(cli.COMMANDS)


@pytest.mark.slow
@pytest.mark.parametrize("command", COMMANDS.values(), ids=COMMANDS)
def test_no_command_runs_what_lies_in_the_tree(tree, marker, command):
    done = run_in(tree, [str(BIN / "audio-checks"), *command])
    assert not marker.exists(), marker.read_text()
    assert "Traceback" not in done.stderr
    assert "fault of the tool" not in done.stderr
    assert "usage:" not in done.stderr, done.stderr


@pytest.mark.slow
def test_nor_does_the_module_in_isolated_mode(tree, marker):
    done = run_in(tree, [sys.executable, "-I", "-m", "audio_checks.cli", "check", "-j", "2", "good.wav", "other.wav"])
    assert not marker.exists(), marker.read_text()
    assert "2 files" in done.stdout


@pytest.mark.slow
def test_git_starts_nothing_of_a_repository_inside_the_tree(tree, marker):
    run_in(tree, [str(BIN / "audio-checks"), "check", "--changed-since", "HEAD", "good/inner.wav"])
    assert not marker.exists(), marker.read_text()


@pytest.mark.slow
def test_the_sandbox_of_a_server_runs_nothing_of_it(tree, marker, tmp_path):
    script = tmp_path / "elsewhere" / "caller.py"
    script.parent.mkdir()
    script.write_text(
        textwrap.dedent("""
            import sys
            from audio_checks import Sandbox, rehearse_check
            from audio_checks.audio.sandbox import calls

            for forks in (calls.CAN_FORK, False):
                calls.CAN_FORK = forks
                box = Sandbox(preload=("numpy", "soundfile", "audio_checks"), rehearsal=rehearse_check)
                print(box.call(len, "four"))
                box.close()
        """)
    )
    done = run_in(tree, [sys.executable, str(script)])
    assert not marker.exists(), marker.read_text()
    assert done.stdout.split() == ["4", "4"], done.stderr


@pytest.mark.slow
@pytest.mark.parametrize("place", ["/etc/passwd", "/dev/zero", "/proc/self/environ", "no/such/file", "fifo", "huge"])
def test_a_spec_that_is_something_else_is_refused_with_a_reason(tree, place):
    os.mkfifo(tree / "fifo")
    with open(tree / "huge", "wb") as file:
        file.truncate(1 << 40)
    (tree / "audio-checks.toml").unlink()
    (tree / "audio-checks.toml").symlink_to(place)
    done = run_in(tree, [str(BIN / "audio-checks"), "check", "good.wav"])
    assert done.returncode == 2
    assert "audio-checks.toml" in done.stderr
    assert any(why in done.stderr for why in ("is not TOML", "not a regular file", "cannot be read", "is larger than"))
    assert "root:" not in done.stdout + done.stderr
    assert "HOME=" not in done.stdout + done.stderr
    assert "fault of the tool" not in done.stderr


@pytest.mark.slow
@pytest.mark.parametrize("option", ["--baseline", "--spec", "--list"])
def test_so_is_any_other_text_file(tree, option):
    (tree / "endless").symlink_to("/dev/zero")
    assert stat.S_ISCHR((tree / "endless").stat().st_mode)
    done = run_in(tree, [str(BIN / "audio-checks"), "check", "good.wav", option, "endless"])
    assert (done.returncode, "is not a regular file" in done.stderr) == (2, True), done.stderr
