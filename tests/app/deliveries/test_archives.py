"""A ZIP becomes takes, one for each sound; what is hostile in it is said in words and harms nothing."""

import io
import stat
import struct
import zipfile
import zlib
from pathlib import Path
from typing import Any
from uuid import UUID

import pytest

from app.core import kill_points
from app.core.db import new_id
from app.deliveries.errors import ArchiveRefused
from app.deliveries.jobs import unpack_archive
from app.deliveries.models import Archive
from app.deliveries.rules import ArchiveState
from app.deliveries.uploads import unzip
from tests.support.deliver import add_cues, open_delivery, upload
from tests.support.server import World

Files = dict[str | zipfile.ZipInfo, bytes]


def packed(files: Files, method: int = zipfile.ZIP_DEFLATED) -> bytes:
    """Return a ZIP."""
    whole = io.BytesIO()
    with zipfile.ZipFile(whole, "w", method) as archive:
        for name, content in files.items():
            archive.writestr(name, content, compress_type=method)
    return whole.getvalue()


def send(world: World, content: bytes, name: str = "all.zip") -> dict[str, Any]:
    """Deliver a ZIP, and return what happened to it."""
    delivery_id = open_delivery(world)
    upload_id = upload(world, delivery_id, name, content)
    body = {"upload_id": upload_id, "file_name": name}
    path = f"/v1/deliveries/{delivery_id}/archives"
    sent = [world.designer.post(path, json=body) for _ in range(2)]
    assert [answer.status_code for answer in sent] == [201, 201]
    assert sent[0].json()["id"] == sent[1].json()["id"]  # an upload is one archive
    world.server.wait_for_jobs()
    shown = world.designer.get(f"/v1/deliveries/{delivery_id}").json()
    [archive] = shown["archives"]
    return dict(archive) | {"takes": shown["takes"]}


def entries_of(archive: dict[str, Any]) -> dict[str, str | None]:
    """Return why each file was left out; None where it was taken."""
    return {entry["path"]: None if entry["taken"] else entry["reason"] for entry in archive["entries"]}


@pytest.mark.slow
def test_each_sound_becomes_a_take(world: World) -> None:
    add_cues(world, {"name": "Laser fire", "variations": 2}, {"name": "Shield hit"})
    archive = send(
        world,
        packed(
            {
                "weapons/laser_fire_01.wav": b"one",
                "weapons/laser_fire_02.WAV": b"two",
                "shield_hit.wav": b"three",
                "shield/": b"",
                "../../shield_hit.wav": b"four",
                "C:\\windows\\stray.wav": b"five",
            }
        ),
    )
    assert (archive["state"], archive["message"]) == ("unpacked", "")
    assert {(take["cue"] and take["cue"]["name"], take["variation"], take["number"]) for take in archive["takes"]} == {
        ("Laser fire", 1, 1),
        ("Laser fire", 2, 1),
        ("Shield hit", 1, 1),
        ("Shield hit", 1, 2),
        (None, 1, None),
    }
    assert [entry["take_id"] for entry in archive["entries"]] == [take["id"] for take in archive["takes"]]
    assert {take["state"] for take in archive["takes"]} == {"returned"}  # they are not sounds, and were judged


@pytest.mark.slow
def test_entries_left_out_are_listed(world: World) -> None:
    link = zipfile.ZipInfo("link.wav")
    link.create_system, link.external_attr = 3, (stat.S_IFLNK | 0o777) << 16
    archive = send(
        world,
        packed(
            {
                "laser.wav": b"sound",
                link: b"/etc/passwd",
                "inner.zip": packed({"a.wav": b"x"}),
                "readme.txt": b"hello",
                "__MACOSX/._laser.wav": b"litter",
                ".DS_Store": b"litter",
            }
        ),
    )
    reported = entries_of(archive)
    assert reported.pop("laser.wav") is None
    assert "link" in str(reported.pop("link.wav"))
    assert "archive inside" in str(reported.pop("inner.zip"))
    assert "not a sound file" in str(reported.pop("readme.txt"))
    assert all("written by the system" in str(reason) for reason in reported.values())
    assert len(archive["takes"]) == 1


@pytest.mark.parametrize("method", [zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA])
def test_methods_that_cannot_be_bounded_are_not_unpacked(world: World, method: int) -> None:
    archive = send(world, packed({"laser.wav": b"sound"}, method))
    assert "method" in str(entries_of(archive)["laser.wav"])


@pytest.mark.slow
def test_a_damaged_file_does_not_spoil_the_others(world: World) -> None:
    content = packed({"bad.wav": b"damaged here", "good.wav": b"whole"}, zipfile.ZIP_STORED)
    archive = send(world, content.replace(b"damaged here", b"damaged HERE"))
    reported = entries_of(archive)
    assert "CRC" in str(reported["bad.wav"])
    assert reported["good.wav"] is None


@pytest.mark.slow
def test_a_locked_file_is_named(world: World) -> None:
    content = bytearray(packed({"laser.wav": b"sound"}, zipfile.ZIP_STORED))
    for mark, at in ((b"PK\x03\x04", 6), (b"PK\x01\x02", 8)):
        content[content.index(mark) + at] |= 1
    assert "password" in str(entries_of(send(world, bytes(content)))["laser.wav"])


def test_names_in_utf8_that_do_not_say_so_are_read(world: World) -> None:
    content = packed({"schild_h\u00fclle.wav": b"sound"}, zipfile.ZIP_STORED)
    plain = bytearray(content)
    for mark, at in ((b"PK\x03\x04", 7), (b"PK\x01\x02", 9)):
        plain[plain.index(mark) + at] &= ~0x08  # the flag that says UTF-8
    assert list(entries_of(send(world, bytes(plain)))) == ["schild_h\u00fclle.wav"]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("content", "word"),
    [
        (b"", "not a ZIP"),
        (b"this is not a ZIP", "not a ZIP"),
        (packed({"laser.wav": b"sound"})[:-30], "not a ZIP"),
        (packed({f"{place}.wav": b"" for place in range(5_001)}), "5001 entries"),
    ],
    ids=["empty", "not a ZIP", "cut off", "too many"],
)
def test_a_zip_that_cannot_be_unpacked_is_refused_with_a_reason(world: World, content: bytes, word: str) -> None:
    archive = send(world, content)
    assert archive["state"] == "refused"
    assert word in archive["message"]
    assert archive["takes"] == []


def lying(content: bytes, field: int, value: int) -> bytes:
    """Return a ZIP whose directory says something else of its first file."""
    at = content.index(b"PK\x01\x02") + field
    return content[:at] + struct.pack("<I", value) + content[at + 4 :]


def refusal(tmp_path: Path, content: bytes) -> str:
    """Return why an archive is refused."""
    path = tmp_path / "hostile.zip"
    path.write_bytes(content)
    with pytest.raises(ArchiveRefused) as refused, unzip.opened(path):
        pass
    return str(refused.value)


def test_a_zip_bomb_is_refused_before_it_is_unpacked(tmp_path: Path, world: World) -> None:
    bomb = packed({"1.wav": bytes(1 << 20)})  # 1 MiB in 1 KiB, of which it promises 1 GiB
    bomb = lying(bomb, 24, 1 << 30)
    assert len(bomb) < 1 << 20
    assert "grow" in refusal(tmp_path, bomb)
    archive = send(world, bomb)
    assert (archive["state"], archive["takes"]) == ("refused", [])


def test_a_directory_that_promises_too_much_is_refused(tmp_path: Path) -> None:
    content = packed({f"{place}.wav": b"x" for place in range(5)})
    for _ in range(5):
        content = lying(content, 24, 0xF0000000).replace(b"PK\x01\x02", b"QK\x01\x02", 1)
    assert "unpack to" in refusal(tmp_path, content.replace(b"QK\x01\x02", b"PK\x01\x02"))


def test_entries_that_share_their_bytes_are_refused(tmp_path: Path) -> None:
    content = packed({"a.wav": bytes(100), "b.wav": b"x"}, zipfile.ZIP_STORED)
    assert "overlap" in refusal(tmp_path, lying(content, 20, len(content)))


def test_a_file_that_unpacks_to_more_than_it_says_is_left_out(tmp_path: Path) -> None:
    path = tmp_path / "lies.zip"
    path.write_bytes(lying(packed({"a.wav": bytes(1_000_000)}), 24, 10))
    with unzip.opened(path) as archive, pytest.raises(unzip.EntryBroken):
        list(archive.content(archive.entries[0]))


def test_an_enormous_directory_is_not_read(tmp_path: Path) -> None:
    path = tmp_path / "huge.zip"
    size = unzip.MAX_READ_BYTES + 1
    end = struct.pack("<4s4H2LH", b"PK\x05\x06", 0, 0, 9_999, 9_999, size, 0, 0)
    with path.open("wb") as file:
        file.truncate(size)
        file.seek(size)
        file.write(end)
    with pytest.raises(ArchiveRefused, match="directory"), unzip.opened(path):
        pass


class Killed(BaseException):
    """Simulates SIGKILL."""


@pytest.mark.slow
def test_a_second_run_goes_on_where_the_first_was_killed(world: World, monkeypatch: pytest.MonkeyPatch) -> None:
    delivery_id = open_delivery(world)
    files: Files = {f"{place}.wav": f"sound {place}".encode() for place in range(5)}
    content = packed(files)
    upload_id = upload(world, delivery_id, "all.zip", content)
    runtime = world.server.runtime
    seen: list[str] = []

    def die(name: str) -> None:
        seen.append(name)
        if seen.count("deliveries.entry_unpacked") == 3:
            raise Killed

    row = Archive(
        studio_id=world.studio_id,
        project_id=world.project_id,
        delivery_id=UUID(delivery_id),
        upload_id=UUID(upload_id),
        file_name="all.zip",
        sha256=runtime.store.put(world.studio_id, [content]).sha256,
        archive_bytes=len(content),
    )
    world.server.in_database(lambda session: session.add(row))
    payload = {"archive_id": str(row.id), "event_id": str(new_id())}
    with monkeypatch.context() as patched:
        patched.setattr(kill_points, "point", die)
        with pytest.raises(Killed):
            unpack_archive(runtime, payload)
    for _ in range(2):
        unpack_archive(runtime, payload)
    shown = world.designer.get(f"/v1/deliveries/{delivery_id}").json()
    assert sorted(take["file_name"] for take in shown["takes"]) == sorted(str(name) for name in files)
    assert shown["archives"][0]["state"] == ArchiveState.UNPACKED
    assert [entry["taken"] for entry in shown["archives"][0]["entries"]] == [True] * 5


@pytest.mark.parametrize(
    ("raw", "path"),
    [("ドア_開く.wav".encode("cp932"), "ドア_開く.wav"), ("tür_auf.wav".encode("cp850"), "tür_auf.wav"),
     ("tür_auf.wav".encode(), "tür_auf.wav")],
)  # fmt: skip
def test_names_in_other_code_pages_are_read(raw: bytes, path: str) -> None:
    info = zipfile.ZipInfo("x.wav")
    info.filename = info.orig_filename = raw.decode("cp437")
    assert unzip.paths_of([info]) == [path]


def test_the_unicode_path_field_names_the_file() -> None:
    info = zipfile.ZipInfo("x.wav")
    info.filename = info.orig_filename = "t_r_auf.wav"
    told = "tür_auf.wav".encode()
    body = b"\x01" + zlib.crc32(b"t_r_auf.wav").to_bytes(4, "little") + told
    info.extra = b"up" + len(body).to_bytes(2, "little") + body
    assert unzip.paths_of([info]) == ["tür_auf.wav"]
    info.orig_filename = "renamed.wav"  # the field is of another name, and no longer holds
    info.filename = "renamed.wav"
    assert unzip.paths_of([info]) == ["renamed.wav"]
