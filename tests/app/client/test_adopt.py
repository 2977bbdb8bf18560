"""`soundlist adopt`: what is sent, what is printed, and who adopts it."""

import base64
import gzip
import json
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from app.client.game_project import packed_project
from app.client.headers import UNREAD, Format, format_of
from audio_checks import read_project, read_project_texts
from benchmarks.audits.projects import KINDS
from tests.app.client.served import Client, client_of
from tests.support.adoptions import adopt
from tests.support.flacs import flac_bytes
from tests.support.server import World
from tests.support.waves import chunk, noise, wav_bytes

RATE = 44_100


@pytest.fixture
def client(world: World, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Iterator[Client]:
    with client_of(world, monkeypatch, capsys, "deliveries:write") as made:
        yield made


@pytest.fixture
def sounds(game: Path) -> Path:
    """Five sounds in two folders, one of them twice, a coded one, a hidden one and a link."""
    for seed, path in enumerate(["ui/click.wav", "ui/open.wav", "steps/grass_01.wav", "steps/grass_02.wav"]):
        (game / path).parent.mkdir(exist_ok=True)
        (game / path).write_bytes(wav_bytes(noise(dbfs=-24, seconds=0.2, seed=seed), rate=RATE, bits=16))
    (game / "ui/again.wav").write_bytes((game / "ui/click.wav").read_bytes())
    (game / "theme.ogg").write_bytes(b"OggS")
    (game / ".hidden.wav").write_bytes(b"RIFF")
    (game / "ui/link.wav").symlink_to(game / "ui/click.wav")
    return game


def test_a_dry_run_prints_what_becomes_of_each_file_and_sends_no_sound(client: Client, sounds: Path) -> None:
    assert client.adopt(sounds, "--dry-run") == 0, client.err
    lines = client.out.splitlines()
    assert lines[0] == "5 files become 4 cues in 2 categories, 1 of them sets"
    assert "  ui/again.wav: also ui/click.wav" in lines
    assert any(line.startswith("  theme.ogg: masters are WAV or FLAC, found ogg") for line in lines)
    assert lines[-1] == "Nothing was sent."
    assert [path for path, _ in client.line.asked] == [f"/v1/projects/{client.world.project_id}/adoption-plan"]


def test_files_are_sent_once_and_a_person_adopts_them(client: Client, sounds: Path) -> None:
    assert client.adopt(sounds) == 0, client.err
    assert "4 files were sent" in client.out
    adoption_id = re.search(r"adoption=([0-9a-f-]{36})$", client.out.strip())
    assert adoption_id
    answer = adopt(client.world, adoption_id[1], client.world.approver)
    assert answer.status_code == 200, answer.text
    assert (answer.json()["cues"], answer.json()["takes"]) == (4, 5)
    client.world.server.wait_for_jobs()


def test_a_busy_server_is_asked_again(client: Client, sounds: Path) -> None:
    client.line.busy = 2
    assert client.adopt(sounds) == 0, client.err


def test_an_empty_folder_and_a_file_are_refused(client: Client, tmp_path: Path) -> None:
    (tmp_path / "empty").mkdir()
    assert client.adopt(tmp_path / "empty") == 2
    assert "holds no sounds" in client.err
    assert client.adopt(tmp_path / "nothing") == 2


@pytest.mark.parametrize(
    ("head", "found"),
    [
        (wav_bytes(noise(seconds=0.1), rate=48_000, bits=24), Format(48_000, 24)),
        (wav_bytes(noise(seconds=0.1), rate=8_000, bits=16, before=[]), Format(8_000, 16)),
        (b"RIFF\x00\x00\x00\x00WAVE" + chunk(b"JUNK", b"odd") + chunk(b"fmt ", bytes(16)), UNREAD),
        (b"RIFF\xff\xff\xff\xffWAVEdata\xff\xff\xff\xff", UNREAD),
        (b"", UNREAD),
        (b"OggS" * 20, UNREAD),
    ],
)
def test_a_header_says_rate_and_depth_or_nothing(head: bytes, found: Format) -> None:
    assert format_of(head) == found


def test_a_flac_says_rate_and_depth() -> None:
    assert format_of(flac_bytes(noise(seconds=0.1), rate=44_100, bits=16)) == Format(44_100, 16)


def project_of(folder: Path) -> Path:
    """A Godot project whose scene plays one of the sounds in a loop."""
    (folder / "project.godot").write_text("config_version=5\n")
    (folder / "ui/click.wav.import").write_text('[remap]\nimporter="wav"\n[params]\nedit/loop_mode=2\n')
    (folder / "main.tscn").write_text(
        '[gd_scene format=3]\n[ext_resource type="AudioStream" path="res://ui/click.wav" id="1"]\n'
        '[node name="Click" type="AudioStreamPlayer"]\nstream = ExtResource("1")\n'
    )
    return folder / "project.godot"


@pytest.mark.parametrize("names_the_folder", [False, True])
def test_the_project_of_the_game_is_sent_and_read(client: Client, sounds: Path, names_the_folder: bool) -> None:
    project = project_of(sounds)
    assert client.adopt(sounds, "--dry-run", "--game-project", str(sounds if names_the_folder else project)) == 0, (
        client.err
    )
    lines = client.out.splitlines()
    assert "project.godot plays 1 of them" in lines
    assert "  ui/open.wav: no scene or script plays it in the project" in lines


@pytest.mark.parametrize("name", ["missing.wproj", "theme.ogg", "."])
def test_what_is_no_project_is_refused_before_anything_is_sent(client: Client, sounds: Path, name: str) -> None:
    assert client.adopt(sounds, "--game-project", str(sounds / name)) == 2
    assert "name a .wproj of Wwise" in client.err
    assert client.line.asked == []


@pytest.mark.parametrize("engine", KINDS)
def test_the_texts_that_are_sent_say_what_the_folder_says(tmp_path: Path, engine: str) -> None:
    place = KINDS[engine].write(tmp_path, 6, {})
    sent = packed_project(place)
    texts = json.loads(gzip.decompress(base64.b64decode(sent["content_base64"])))
    assert read_project_texts(sent["path"], texts).to_dict() == read_project(place).to_dict()


def test_a_project_is_sent_without_what_is_no_text_of_sounds(tmp_path: Path) -> None:
    for path, text in {
        "ProjectSettings/ProjectVersion.txt": "m_EditorVersion: 6000.0.1f1\n",
        "Assets/click.wav.meta": "guid: 0\nAudioImporter:\n",
        "Assets/tree.png.meta": "guid: 1\nTextureImporter:\n",
        "Assets/tree.prefab": "%YAML 1.1\n--- !u!33 &1\nMeshFilter:\n",
        "Assets/bird.prefab": "%YAML 1.1\n--- !u!82 &1\nAudioSource:\n",
        "Library/cache.asset": "AudioSource",
    }.items():
        (tmp_path / path).parent.mkdir(exist_ok=True)
        (tmp_path / path).write_text(text)
    texts = json.loads(gzip.decompress(base64.b64decode(packed_project(tmp_path)["content_base64"])))
    assert set(texts) == {"ProjectSettings/ProjectVersion.txt", "Assets/click.wav.meta", "Assets/bird.prefab"}
