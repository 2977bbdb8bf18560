"""What a terminal shows, and what a pipe gets: progress, colour, encoding, interruption."""

import io
import os
import re
import subprocess
import sys

import pytest

from audio_checks.cli import main, progress, terminal
from audio_checks.cli.progress import Progress
from audio_checks.run import runner, workload
from tests.support.waves import sine, write_wav

GOOD = sine(hz=997, dbfs=-6, seconds=0.1)
LOUD = sine(hz=997, dbfs=0.0, seconds=0.1)
SPEC = ("--spec", "../spec.toml")
CODES = re.compile(r"\x1b\[[0-9;]*[mK]")


class Terminal(io.TextIOWrapper):
    """A terminal of an encoding."""

    def __init__(self, encoding="utf-8"):
        super().__init__(io.BytesIO(), encoding=encoding, errors="backslashreplace", write_through=True)

    def isatty(self):
        return True

    @property
    def lines(self):
        """What was drawn, one drawing after the other."""
        drawn = self.buffer.getvalue().decode(self.encoding)
        return [CODES.sub("", one) for one in drawn.split("\r") if CODES.sub("", one)]


@pytest.fixture
def columns(monkeypatch):
    def columns(count):
        monkeypatch.setenv("COLUMNS", str(count))
        return count

    return columns


class TestProgress:
    def draw(self, monkeypatch, *, encoding="utf-8", total=200, steps=100, every_s=1.0, name="sounds/laser.wav"):
        screen, now_s = Terminal(encoding), [0.0]
        monkeypatch.setattr("sys.stderr", screen)
        monkeypatch.setattr(progress.time, "monotonic", lambda: now_s[0])
        with Progress(total, shown=True) as line:
            for _ in range(steps):
                now_s[0] += every_s
                line.step(name)
        return screen

    def test_it_counts_and_says_what_is_left(self, monkeypatch, columns):
        columns(100)
        screen = self.draw(monkeypatch)
        assert screen.lines[-1] == f"{'█' * 12}{'░' * 12} 100/200  1 min 40 s left  sounds/laser.wav"
        assert screen.buffer.getvalue().endswith(b"\r\x1b[K")

    def test_it_is_drawn_twenty_times_a_second_at_most(self, monkeypatch, columns):
        columns(100)
        assert len(self.draw(monkeypatch, every_s=0.001).lines) == 2

    @pytest.mark.parametrize("count", [10, 30, 40, 60, 200])
    def test_it_never_fills_more_than_a_line(self, monkeypatch, columns, count):
        columns(count)
        screen = self.draw(monkeypatch, name="a/very/long/path/" * 10 + "laser.wav")
        assert max(map(len, screen.lines)) < max(count, len("100/200  1 min 40 s left") + 1)
        assert screen.lines[-1].endswith(".wav") is (count >= 60)

    def test_a_terminal_without_blocks_gets_signs(self, monkeypatch, columns):
        columns(100)
        assert self.draw(monkeypatch, encoding="ascii").lines[-1].startswith("############............ 100/200")

    def test_an_interrupted_run_leaves_no_line(self, folder, monkeypatch):
        for name in ("a.wav", "b.wav"):
            write_wav(folder / name, GOOD)
        screen = Terminal()
        monkeypatch.setattr("sys.stderr", screen)

        def interrupt(tasks, *, jobs, done):
            done(runner.FileReport("a.wav", "conforming"))
            raise KeyboardInterrupt

        monkeypatch.setattr(runner, "judge", interrupt)
        assert main(["check", "--no-cache", "."]) == 130
        assert screen.buffer.getvalue().endswith(b"\r\x1b[K")

    def test_a_pipe_gets_none(self, folder, run):
        for name in ("a.wav", "b.wav"):
            write_wav(folder / name, GOOD)
        err = run("check", *SPEC, "--no-cache", ".")[2]
        assert err.startswith("audio-checks: no sound list (--list)")
        assert err.count("\n") == 1  # said once, and no progress


@pytest.mark.parametrize(
    ("variables", "tty", "coloured"),
    [
        ({}, True, True),
        ({}, False, False),
        ({"NO_COLOR": "1"}, True, False),
        ({"NO_COLOR": ""}, True, True),
        ({"FORCE_COLOR": "1"}, False, True),
        ({"NO_COLOR": "1", "FORCE_COLOR": "1"}, True, False),
        ({"TERM": "dumb"}, True, False),
    ],
)
def test_colour_is_for_terminals_unless_asked_otherwise(monkeypatch, variables, tty, coloured):
    for name in ("NO_COLOR", "FORCE_COLOR"):
        monkeypatch.delenv(name, raising=False)
    for name, value in {"TERM": "xterm", **variables}.items():
        monkeypatch.setenv(name, value)
    assert terminal.in_colour(Terminal() if tty else io.StringIO()) is coloured


@pytest.mark.slow
@pytest.mark.parametrize("form", ["text", "junit", "github"])
def test_a_pipe_is_utf_8_whatever_the_machine_speaks(folder, form):
    write_wav(folder / "Tür_Größe.wav", LOUD)
    command = [sys.executable, "-m", "audio_checks.cli", "check", *SPEC, "--format", form, "."]
    environment = {**os.environ, "PYTHONIOENCODING": "latin-1"}
    said = subprocess.run(command, capture_output=True, env=environment)
    assert "Tür_Größe.wav" in said.stdout.decode("utf-8")


@pytest.mark.parametrize(
    ("files", "size", "wanted"),
    [(1, 1 << 30, 1), (2, 1000, 1), (2, 40 << 20, 7), (workload.MANY_FILES, 1000, 7)],
)
def test_processes_are_started_for_work_that_is_worth_them(tmp_path, monkeypatch, files, size, wanted):
    monkeypatch.setattr(workload, "CORES", 7)
    path = tmp_path / "a.wav"
    with path.open("wb") as file:
        file.truncate(size)
    assert workload.process_count([str(path)] * files) == wanted
