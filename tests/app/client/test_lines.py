"""What happens to a pull when the line is cut, bytes are altered, or the server cannot be reached."""

import json
from pathlib import Path
from typing import Any

import pytest

from app.client.lock import read_lock
from tests.app.client.served import PATHS, Client, files_in, states_of
from tests.app.client.test_pull import packed
from tests.support.listening import listening


def parts_in(folder: Path) -> list[int]:
    """The sizes of downloads that are not whole."""
    return [path.stat().st_size for path in sorted(folder.rglob("*.part"))]


def only_the_last_file(said: dict[str, Any]) -> None:
    del said["files"][:2]


@pytest.mark.slow
def test_a_cut_download_goes_on_where_it_stopped(client: Client, game: Path) -> None:
    client.line.change_listing = only_the_last_file
    client.line.cut_after = [5_000, 3_000]
    assert client.pull(game) == 0, client.out
    assert client.line.downloads == ["", "bytes=5000-", "bytes=8000-"]
    assert files_in(game) == {PATHS[2]: packed(client.world)[PATHS[2]]}


@pytest.mark.slow
def test_what_arrived_before_the_line_was_lost_is_kept_for_the_next_pull(client: Client, game: Path) -> None:
    client.line.change_listing = only_the_last_file
    client.line.cut_after = [5_000, 0, 0, 0, 0]
    assert client.pull(game) == 3
    assert f"not renewed  {PATHS[2]}  SW-002: the download was cut again and again" in client.out
    assert not (game / PATHS[2]).exists()
    assert parts_in(game) == [5_000]
    client.line.cut_after.clear()
    assert client.pull(game) == 0
    assert client.line.downloads[-1] == "bytes=5000-"
    assert parts_in(game) == []
    assert files_in(game) == {PATHS[2]: packed(client.world)[PATHS[2]]}


@pytest.mark.slow
def test_a_rest_that_does_not_fit_is_downloaded_from_the_start(client: Client, game: Path) -> None:
    client.line.change_listing = only_the_last_file
    client.line.cut_after = [5_000, 0, 0, 0, 0]
    client.pull(game)
    (part,) = game.glob("*.part")
    part.write_bytes(b"x" * 5_000)
    client.line.cut_after.clear()
    assert client.pull(game) == 0
    assert client.line.downloads[-2:] == ["bytes=5000-", ""]
    assert files_in(game) == {PATHS[2]: packed(client.world)[PATHS[2]]}


@pytest.mark.slow
def test_altered_bytes_never_reach_their_place(client: Client, game: Path) -> None:
    client.pull(game)
    (game / PATHS[0]).unlink()
    lock = (game / "soundlist.lock").read_bytes()
    client.line.change_file = lambda body: body[:-1] + bytes([body[-1] ^ 1]) if body else body
    assert client.pull(game) == 1
    assert f"not renewed  {PATHS[0]}  SW-001: what the server sent is not the approved file" in client.out
    assert set(files_in(game)) == set(PATHS[1:])
    assert (game / "soundlist.lock").read_bytes() == lock


@pytest.mark.slow
def test_an_older_file_stays_while_the_new_one_cannot_be_had(client: Client, game: Path) -> None:
    client.pull(game)
    before = states_of(game)
    client.line.change_listing = lambda said: said["files"][0].update(sha256="0" * 64, sound="0" * 16)
    assert client.pull(game) == 1
    assert states_of(game) == before


def test_a_file_that_is_longer_than_it_should_be_is_not_read_on(client: Client, game: Path) -> None:
    client.line.change_listing = lambda said: said["files"][0].update(bytes=100)
    assert client.pull(game) == 1
    assert "the server sent more than the 100 bytes of the approved file" in client.out
    assert set(files_in(game)) == set(PATHS[1:])


def test_without_the_server_the_folder_is_compared_with_its_lock(client: Client, game: Path) -> None:
    client.pull(game)
    (game / PATHS[0]).unlink()
    (game / PATHS[1]).write_bytes(b"louder")
    before = states_of(game)
    client.source[1] = "http://127.0.0.1:9"  # the discard port, where nothing listens
    assert client.pull(game) == 3
    assert "The server cannot be reached" in client.err
    assert "1 of 3 files is here as pulled" in client.err
    assert client.out.splitlines() == [
        f"not renewed  {PATHS[0]}  SW-001: it is not here",
        f"not renewed  {PATHS[1]}  SW-001: it was changed here",
    ]
    assert client.pull(game, "--no-placeholders") == 3
    assert states_of(game) == before


@pytest.mark.parametrize(
    "path",
    [
        "../laser.wav", "/etc/laser.wav", "a/../../laser.wav", "a//laser.wav", "./laser.wav", "", "a/", "C:/laser.wav",
        "C:laser.wav", "\\\\host\\share\\laser.wav", "a\\..\\laser.wav", "nul", "COM1.wav", "a/aux.tar.wav", "con ",
        "laser.wav.", "laser.wav ", " laser.wav", "laser.wav:stream", "la\x00ser.wav", "la\nser.wav", "la\x1bser.wav",
        "\u202egnp.wav", "soundlist.lock", "Soundlist.Lock", ".git/hooks/post-checkout", ".GIT/config", "a/.git/config",
        ".soundlist-1234.part", "*.wav", "a?.wav", "x" * 256, "com\u00b9.wav", "\ud800.wav", "a/" * 600 + "b.wav",
    ],
)  # fmt: skip
def test_a_path_that_leads_elsewhere_stops_the_pull(client: Client, game: Path, path: str) -> None:
    client.line.change_listing = lambda said: said["files"][1].update(path=path)
    assert client.pull(game, "--force", "--prune") == 2
    assert client.err.startswith("soundlist pull: ")
    assert "\x1b" not in client.err
    assert list(game.parent.rglob("*")) == [game]
    assert client.line.downloads == []


@pytest.mark.parametrize(
    ("first", "second"), [("a.wav", "A.WAV"), ("caf\u00e9.wav", "cafe\u0301.wav"), ("a.wav", "a.wav/b.wav")]
)
def test_two_paths_that_are_one_file_stop_the_pull(client: Client, game: Path, first: str, second: str) -> None:
    def rename(said: dict[str, Any]) -> None:
        said["files"][0]["path"], said["files"][1]["path"] = first, second

    client.line.change_listing = rename
    assert client.pull(game) == 2
    assert files_in(game) == {}


def test_a_link_out_of_the_folder_is_not_followed(client: Client, game: Path) -> None:
    outside = game.parent / "outside"
    outside.mkdir()
    (game / "weapon").symlink_to(outside)
    (game / PATHS[2]).symlink_to(outside / "passwords")
    client.line.change_listing = lambda said: said["files"][0].update(path="weapon/laser.wav")
    assert client.pull(game, "--force") == 2
    assert "leads out of" in client.err
    client.line.change_listing = None
    assert client.pull(game, "--force") == 1
    assert f"kept  {PATHS[2]}: it is a link or a folder, and is never overwritten" in client.out
    assert list(outside.iterdir()) == []


def test_a_link_to_another_folder_of_the_game_is_followed(client: Client, game: Path) -> None:
    (game / "Content").mkdir()
    (game / "weapon").symlink_to(game / "Content")
    client.line.change_listing = lambda said: said["files"][0].update(path="weapon/laser.wav")
    assert client.pull(game) == 0
    assert (game / "Content" / "laser.wav").read_bytes() == packed(client.world)[PATHS[0]]


@pytest.mark.parametrize(
    "change",
    [
        lambda said: said.pop("files"),
        lambda said: said["files"][0].pop("sha256"),
        lambda said: said["files"][0].update(sha256="../../x"),
        lambda said: said["files"][0].update(bytes=-1),
        lambda said: said["files"][0].update(bytes=10**15),
        lambda said: said["files"][0].update(bytes="12"),
        lambda said: said["files"][0].update(cue="SW-001\tx"),
        lambda said: said["files"][0].update(url="http://elsewhere.example/x"),
        lambda said: said.update(project_id="0198c0de-0000-7000-8000-000000000000"),
        lambda said: said.update(target="other\nline"),
        lambda said: said.update(target="other"),
    ],
)
def test_an_answer_that_is_no_list_of_game_files_stops_the_pull(client: Client, game: Path, change: Any) -> None:
    client.line.change_listing = change
    assert client.pull(game, "--target", "game") == 2
    assert files_in(game) == {}
    assert not (game / "soundlist.lock").exists()


def test_a_target_of_the_server_cannot_add_lines_to_the_lock_file(client: Client, game: Path) -> None:
    client.line.change_listing = lambda said: said.update(target="game\nline")
    assert client.pull(game) == 2
    assert not (game / "soundlist.lock").exists()


def test_a_file_that_is_always_shorter_than_approved_is_given_up(client: Client, game: Path) -> None:
    def lengthen(said: dict[str, Any]) -> None:
        said["files"][0].update(bytes=said["files"][0]["bytes"] + 100, sha256="0" * 64)

    client.line.change_listing = lengthen
    assert client.pull(game) == 1
    assert f"not renewed  {PATHS[0]}  SW-001: what the server sends is shorter than the approved file" in client.out
    assert set(files_in(game)) == set(PATHS[1:])


def test_an_address_of_a_file_stays_on_the_server(client: Client, game: Path) -> None:
    client.line.change_listing = lambda said: said["files"][0].update(url="//elsewhere.example/x")
    assert client.pull(game) == 1
    assert any("elsewhere.example" in path for path, _ in client.line.asked)
    assert set(files_in(game)) == set(PATHS[1:])


def test_a_folder_that_cannot_be_written_is_named(client: Client, game: Path) -> None:
    (game / "soundlist.lock").mkdir()
    assert client.pull(game) == 2
    assert "soundlist.lock" in client.err
    assert "Traceback" not in client.err


def test_names_cannot_control_a_terminal(client: Client, game: Path) -> None:
    def name(said: dict[str, Any]) -> None:
        said["project"] = "\x1b]0;mine\x07"
        said["files"][0]["cue_name"] = "\x1b[2J\u202e"

    client.line.change_listing = name
    assert client.pull(game, "--changelist") == 0
    assert "\x1b" not in client.out
    assert "\u202e" not in client.out
    assert "\\x1b[2J\\u202e" in client.out


class Elsewhere:
    """A store of files that the server redirects to; it keeps what it was sent."""

    def __init__(self) -> None:
        self.headers: list[dict[str, str]] = []
        self.content = b""

    async def __call__(self, scope: Any, _receive: Any, send: Any) -> None:
        self.headers.append({name.decode(): value.decode() for name, value in scope["headers"]})
        await send({"type": "http.response.start", "status": 200, "headers": []})
        await send({"type": "http.response.body", "body": self.content})


def test_a_redirect_elsewhere_is_followed_without_the_token(client: Client, game: Path) -> None:
    store = Elsewhere()
    store.content = packed(client.world)[PATHS[2]]
    client.line.change_listing = only_the_last_file
    with listening(store, lifespan="off") as port:
        client.line.redirect_files_to = f"http://localhost:{port}/blob"
        assert client.pull(game) == 0, client.out
        client.line.redirect_files_to = "file:///etc/passwd"
        (game / PATHS[2]).unlink()
        assert client.pull(game) == 1
    assert files_in(game) == {}
    assert [sorted(headers.keys() & {"authorization", "host"}) for headers in store.headers] == [["host"]]


def test_a_busy_server_is_asked_again(client: Client, game: Path) -> None:
    client.line.busy = 2
    assert client.pull(game) == 0
    client.line.busy = 9
    assert client.pull(game) == 3


def test_an_address_that_is_no_soundlist_is_said_so(client: Client, game: Path) -> None:
    other = Elsewhere()
    other.content = b"<html>"
    with listening(other, lifespan="off") as port:
        client.source[1] = f"http://127.0.0.1:{port}"
        assert client.pull(game) == 2
    assert "did not answer as Soundlist does" in client.err
    assert json.dumps(client.out) == '""'
    assert read_lock(game) is None
