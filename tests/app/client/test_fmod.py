"""`soundlist fmod` over a real socket, to a substitute that evaluates the lines it is sent; never to FMOD Studio."""

import re
import socket
import subprocess
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from app.client import fmod_studio
from app.client.commands import main
from tests.app.builds.handed import CUES, LASER
from tests.app.builds.test_handoff_fmod import NODE, STUDIO, unpack


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A project of FMOD Studio with a pack beside it."""
    unpack(tmp_path, CUES)
    (tmp_path / "Game.fspro").write_text("<objects/>")
    return tmp_path


@contextmanager
def studio(folder: Path) -> Iterator[str]:
    """Run the substitute with the project of a folder open, and give its port."""
    command = [NODE, str(STUDIO), "listen", str(folder)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout
        yield process.stdout.readline().strip()
        process.kill()


@contextmanager
def answering(answer: Callable[[bytes], bytes] | None) -> Iterator[str]:
    """Listen once, and answer what comes; without an answer say nothing."""
    with socket.create_server(("127.0.0.1", 0)) as listening:

        def serve() -> None:
            client, _ = listening.accept()
            with client:
                said = b""
                while not said.endswith(b"\n"):
                    said += client.recv(1 << 16)
                if answer is None:
                    client.recv(1)
                else:
                    client.sendall(answer(said))

        threading.Thread(target=serve, daemon=True).start()
        yield str(listening.getsockname()[1])


def test_the_pack_is_imported_and_a_second_time_changes_nothing(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with studio(folder) as port:
        assert main(["fmod", str(folder), "--port", port]) == 0
        first = capsys.readouterr().out
        assert main(["fmod", str(folder), "--port", port]) == 0
        second = capsys.readouterr().out
    assert first.startswith("3 events and 3 folders made, 4 files imported, 0 variations added.\n")
    assert "Nothing was saved" in first
    assert second.startswith("0 events and 0 folders made, 0 files imported, 0 variations added.\n")


def test_a_sound_that_is_lost_is_named_and_the_exit_code_says_so(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / LASER.files[0].path).unlink()
    with studio(folder) as port:
        assert main(["fmod", str(folder), "--port", port]) == 1
    assert "Not imported: " in capsys.readouterr().out


def test_another_project_that_is_open_is_left_alone(
    folder: Path, tmp_path_factory: pytest.TempPathFactory, capsys: pytest.CaptureFixture[str]
) -> None:
    other = tmp_path_factory.mktemp("other")
    with studio(other) as port:
        assert main(["fmod", str(folder), "--port", port]) == 2
    assert f"FMOD Studio has {other}/Game.fspro open" in capsys.readouterr().err


def test_nobody_listens(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = str(taken.getsockname()[1])
    assert main(["fmod", str(folder), "--port", port]) == 3
    said = capsys.readouterr().err
    assert f"no FMOD Studio listens on port {port}" in said
    assert "switch the script server on" in said


@pytest.mark.parametrize(
    ("answer", "words"),
    [
        (lambda _: b"HTTP/1.1 400 Bad Request\r\n\r\n", "did not answer as FMOD Studio does: HTTP/1.1 400"),
        (lambda line: line, "did not answer as FMOD Studio does"),
        (lambda _: b"x" * (5 << 20), "did not answer as FMOD Studio does"),
        (
            lambda line: b"soundlist-" + re.findall(rb"'soundlist-'\+\"([0-9a-f]+)\"", line)[0] + b":%7Bno;",
            "cannot be read",
        ),
    ],
)
def test_what_is_no_fmod_studio_is_refused(
    folder: Path, capsys: pytest.CaptureFixture[str], answer: Callable[[bytes], bytes], words: str
) -> None:
    with answering(answer) as port:
        assert main(["fmod", str(folder), "--port", port]) == 2
    assert words in capsys.readouterr().err


def test_one_that_says_nothing_is_given_up(folder: Path) -> None:
    with answering(None) as port, pytest.raises(fmod_studio.Refusal, match="did not answer"):
        fmod_studio.answer_of("", folder / "Game.fspro", port=int(port), answer_s=0.3)


@pytest.mark.parametrize("missing", ["Game.fspro", "Scripts/soundlist_import.js", "soundlist-handoff.json"])
def test_what_is_missing_beside_the_project_is_named(
    folder: Path, capsys: pytest.CaptureFixture[str], missing: str
) -> None:
    (folder / missing).unlink()
    assert main(["fmod", str(folder)]) == 2
    assert (".fspro" if missing == "Game.fspro" else missing) in capsys.readouterr().err
