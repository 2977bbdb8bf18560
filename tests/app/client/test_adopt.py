"""`soundlist adopt`: what is sent, what is printed, and who adopts it."""

import base64
import gzip
import io
import json
import re
import shutil
import zipfile
from collections.abc import Iterator
from pathlib import Path

import pytest

from app.client.errors import Refusal
from app.client.game_project import packed_project
from app.client.headers import UNREAD, Format, format_of
from app.client.zipped import _unpack
from audio_checks import read_project, read_project_texts
from benchmarks.audits.projects import KINDS
from tests.app.client.served import Client, client_of
from tests.support.adoptions import adopt
from tests.support.coded import coded_bytes
from tests.support.deliver import deliver
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
    """Five sounds in two folders, one of them twice, one that no one reads, a hidden one and a link."""
    for seed, path in enumerate(["ui/click.wav", "ui/open.wav", "steps/grass_01.wav", "steps/grass_02.wav"]):
        (game / path).parent.mkdir(exist_ok=True)
        (game / path).write_bytes(wav_bytes(noise(dbfs=-24, seconds=0.2, seed=seed), rate=RATE, bits=16))
    (game / "ui/again.wav").write_bytes((game / "ui/click.wav").read_bytes())
    (game / "theme.m4a").write_bytes(b"....ftyp")
    (game / ".hidden.wav").write_bytes(b"RIFF")
    (game / "ui/link.wav").symlink_to(game / "ui/click.wav")
    return game


def test_a_dry_run_prints_what_happens_to_each_file_and_sends_no_sound(client: Client, sounds: Path) -> None:
    assert client.adopt(sounds, "--dry-run") == 0, client.err
    lines = client.out.splitlines()
    assert lines[0] == "5 files become 4 cues in 2 categories, 1 of them a set"
    assert "  ui/again.wav: also ui/click.wav" in lines
    assert any(line.startswith("  theme.m4a: WAV, FLAC, Ogg, Opus and MP3 are adopted, found m4a") for line in lines)
    assert lines[-1] == "Nothing was sent."
    assert [path for path, _ in client.line.asked] == [f"/v1/projects/{client.world.project_id}/adoption-plan"]


@pytest.mark.slow
def test_files_are_sent_once_and_a_person_adopts_them(client: Client, sounds: Path) -> None:
    assert client.adopt(sounds) == 0, client.err
    assert "4 files were sent" in client.out
    adoption_id = re.search(r"adoption=([0-9a-f-]{36})$", client.out.strip())
    assert adoption_id
    answer = adopt(client.world, adoption_id[1], client.world.approver)
    assert answer.status_code == 200, answer.text
    assert (answer.json()["cues"], answer.json()["takes"]) == (4, 5)
    client.world.server.wait_for_jobs()


@pytest.mark.slow
def test_a_zip_is_sent_as_its_folder_is(client: Client, sounds: Path, tmp_path: Path) -> None:
    (sounds / "music.ogg").write_bytes(coded_bytes("ogg", rate=22_050))
    with zipfile.ZipFile(tmp_path / "Sounds.zip", "w") as archive:
        for path in sorted(sounds.rglob("*")):
            if path.is_file() and not path.is_symlink():
                archive.write(path, path.relative_to(sounds))
        archive.writestr("__MACOSX/ui/._click.wav", b"x")
    assert client.adopt(tmp_path / "Sounds.zip") == 0, client.err
    assert client.out.splitlines()[0] == "6 files become 5 cues in 3 categories, 1 of them a set"
    assert "5 files were sent" in client.out
    assert format_of((sounds / "music.ogg").read_bytes()) == Format(22_050, None)
    assert format_of(coded_bytes("opus", rate=48_000)) == Format(48_000, None)


@pytest.mark.slow
def test_a_file_that_was_adopted_counts_as_pulled(
    world: World, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], game: Path, tmp_path: Path
) -> None:
    shipped = wav_bytes(noise(dbfs=-24, seconds=0.3), rate=RATE, bits=16, before=[chunk(b"JUNK", b"left")])
    (game / "click.wav").write_bytes(shipped)
    shutil.copytree(game, tmp_path / "never pulled")
    shutil.copytree(game, tmp_path / "edited")
    (tmp_path / "edited" / "click.wav").write_bytes(shipped + b"  ")
    with client_of(world, monkeypatch, capsys, "deliveries:write", "manifest:read") as client:
        assert client.adopt(game) == 0, client.err
        adoption_id = re.search(r"adoption=([0-9a-f-]{36})$", client.out.strip())
        assert adoption_id
        assert adopt(world, adoption_id[1], world.approver).status_code == 200
        world.server.wait_for_jobs()
        for _ in range(2):
            assert client.pull(game) == 0, client.out
            assert client.out.splitlines() == ["Shield Wing, game: 1 approved file, 1 unchanged"]
        assert (game / "click.wav").read_bytes() == shipped
        take = deliver(world, "click.wav", wav_bytes(noise(dbfs=-24, seconds=0.3, seed=9), rate=RATE, bits=16))
        world.server.wait_for_jobs()
        assert world.approver.post(f"/v1/takes/{take['id']}/verdict", json={"kind": "approve"}).status_code == 200
        world.server.wait_for_jobs()
        for folder in (game, tmp_path / "never pulled"):
            assert client.pull(folder) == 0, client.out
            assert "changed  click.wav" in client.out
        assert client.pull(tmp_path / "edited") == 1
        assert "kept  click.wav: it was here before and is not from Soundlist" in client.out


@pytest.mark.parametrize("name", ["../out.wav", "/etc/out.wav", "a/../../out.wav", "con.wav", "a\\b.wav"])
def test_a_zip_that_leads_out_of_its_folder_is_refused(client: Client, tmp_path: Path, name: str) -> None:
    with zipfile.ZipFile(tmp_path / "bad.zip", "w") as archive:
        archive.writestr(name, b"RIFF")
    assert client.adopt(tmp_path / "bad.zip") == 2
    assert "is not a path for a game file" in client.err
    assert [path.name for path in tmp_path.rglob("out.wav")] == []


def test_a_zip_whose_packed_bytes_are_damaged_is_refused(client: Client, tmp_path: Path) -> None:
    with zipfile.ZipFile(tmp_path / "a.zip", "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("a.wav", bytes(range(256)) * 40)
    whole = bytearray((tmp_path / "a.zip").read_bytes())
    whole[40:60] = b"\xff" * 20
    (tmp_path / "a.zip").write_bytes(whole)
    assert client.adopt(tmp_path / "a.zip") == 2
    assert "cannot be unpacked" in client.err


def test_a_damaged_zip_and_one_that_unpacks_to_too_much_are_refused(client: Client, tmp_path: Path) -> None:
    with zipfile.ZipFile(tmp_path / "a.zip", "w") as archive:
        archive.writestr("a.wav", b"RIFF" * 100)
    whole = (tmp_path / "a.zip").read_bytes()
    (tmp_path / "a.zip").write_bytes(whole.replace(b"RIFFRIFF", b"RIFFROFF"))
    assert client.adopt(tmp_path / "a.zip") == 2
    assert "cannot be unpacked" in client.err
    entry = zipfile.ZipInfo("a.wav")
    entry.file_size = 64 << 30
    with zipfile.ZipFile(io.BytesIO(whole)) as opened, pytest.raises(Refusal, match="unpacks to 64 GiB"):
        _unpack(opened, [entry], tmp_path, 10)


@pytest.mark.slow
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


@pytest.mark.parametrize("name", ["missing.wproj", "theme.m4a", "."])
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
