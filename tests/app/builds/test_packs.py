"""The approved pack: what the game expects, under the names it expects, and never silently short."""

import csv
import hashlib
import io
import zipfile
from pathlib import Path
from typing import Any

import httpx
import pytest
import python_calamine
import sqlalchemy as sa
from httpx2 import Client

import audio_checks
from app.accounts.authentication import SESSION_COOKIE
from app.builds.packs import service as packs
from app.renders.models import Render
from tests.app.builds.approved import accepted_list, approve, sound
from tests.support.blobs import blob_file
from tests.support.deliver import add_cues, open_delivery, upload
from tests.support.listening import listening
from tests.support.server import World

SOUNDS = ["laser_fire_01.wav", "laser_fire_02.wav", "ui_confirm.wav"]
KEY = ["documentation-key.csv", "documentation-key.xlsx", "documentation-key.pdf", "SHA256SUMS"]
FORMULAS = ("=", "+", "-", "@", "\t", "\r")


def download(world: World, by: Client | None = None, **params: Any) -> bytes:
    answer = (by or world.producer).get(f"/v1/projects/{world.project_id}/pack.zip", params={"target": "game"} | params)
    assert answer.status_code == 200, answer.text
    assert int(answer.headers["content-length"]) == len(answer.content)
    return answer.content


@pytest.mark.slow
def test_the_pack_holds_what_the_game_expects(world: World, tmp_path: Path) -> None:
    masters = accepted_list(world)
    reported = world.producer.get(f"/v1/projects/{world.project_id}/pack", params={"target": "game"}).json()
    assert (reported["files"], reported["cues_accepted"], reported["cues_wanted"], reported["missing"]) == (3, 2, 3, [])
    assert reported["masters_bytes"] == sum(len(master) for master in masters.values())
    whole = download(world, masters=True)
    with zipfile.ZipFile(io.BytesIO(whole)) as archive:
        assert archive.testzip() is None
        assert archive.namelist() == SOUNDS + [f"masters/{stem}.wav" for stem in masters] + KEY
        assert sum(archive.getinfo(name).file_size for name in SOUNDS) == reported["bytes"]
        for stem, master in masters.items():
            assert archive.read(f"masters/{stem}.wav") == master
        archive.extractall(tmp_path)
    spec = audio_checks.parse_spec(world.producer.get(f"/v1/projects/{world.project_id}/spec.toml").text)
    report = audio_checks.check_files([tmp_path / name for name in SOUNDS], spec, target="game")
    assert [entry.verdict for entry in report.files] == ["conforming"] * 3
    assert download(world, masters=True) == whole  # the same again, byte by byte
    with zipfile.ZipFile(io.BytesIO(download(world))) as archive:
        assert archive.namelist() == SOUNDS + KEY


@pytest.mark.slow
def test_a_dry_stem_is_in_no_pack(world: World) -> None:
    cues = add_cues(world, {"name": "UI confirm", "file_name": "ui_confirm"})
    delivery_id = open_delivery(world)
    upload_id = upload(world, delivery_id, "ui_confirm__dry.wav", sound(7))
    body = {"upload_id": upload_id, "file_name": "ui_confirm__dry.wav"}
    assert world.designer.post(f"/v1/deliveries/{delivery_id}/takes", json=body).status_code == 202
    approve(world, cues, delivery_id=delivery_id)
    kept = world.designer.get(f"/v1/deliveries/{delivery_id}").json()
    assert [len(stem["take_ids"]) for stem in kept["dry_stems"]] == [1]
    for masters in (False, True):
        with zipfile.ZipFile(io.BytesIO(download(world, masters=masters))) as archive:
            held = archive.namelist()
            assert held == ["ui_confirm.wav"] + ["masters/ui_confirm.wav"] * masters + KEY
            assert all(archive.read(name) != sound(7) for name in held)


@pytest.mark.slow
def test_the_documentation_key_says_what_each_file_is(world: World) -> None:
    masters = accepted_list(world)
    with zipfile.ZipFile(io.BytesIO(download(world))) as archive:
        text = archive.read("documentation-key.csv")
        book = archive.read("documentation-key.xlsx")
        hashes = {name: hashlib.sha256(archive.read(name)).hexdigest() for name in SOUNDS}
    rows = list(csv.DictReader(io.StringIO(text.decode("utf-8-sig"))))
    assert [(row["file"], row["cue"], row["variation"], row["variations"]) for row in rows] == [
        ("laser_fire_01.wav", "SW-001", "1", "2"),
        ("laser_fire_02.wav", "SW-001", "2", "2"),
        ("ui_confirm.wav", "SW-002", "1", "1"),
    ]
    assert {row["file"]: row["file_sha256"] for row in rows} == hashes
    assert rows[2]["master_sha256"] == hashlib.sha256(masters["ui_confirm"]).hexdigest()
    assert (rows[0]["sample_rate_hz"], rows[0]["bit_depth"], rows[0]["channels"]) == ("44100", "16", "1")
    assert rows[0]["description"] == "'=bright, thin"
    designer = world.designer.get("/v1/me").json()["person"]["name"]
    assert {(row["originator"], row["contract"], row["state"]) for row in rows} == {(designer, "", "approved")}
    cells = [cell for row in rows for cell in row.values()]
    assert not [cell for cell in cells if cell.startswith(FORMULAS)]
    sheet = python_calamine.CalamineWorkbook.from_filelike(io.BytesIO(book)).get_sheet_by_index(0).to_python()
    assert [str(cell) for cell in sheet[0]] == list(rows[0])
    assert [line[0] for line in sheet[1:]] == [row["file"] for row in rows]
    with zipfile.ZipFile(io.BytesIO(book)) as archive:
        assert b"<f>" not in archive.read("xl/worksheets/sheet1.xml")
    url = f"/v1/projects/{world.project_id}/documentation-key"
    assert world.producer.get(f"{url}.csv").content == text
    assert world.producer.get(f"{url}.xlsx").content == book


@pytest.mark.slow
def test_a_set_is_packed_only_when_it_is_whole(world: World) -> None:
    (laser, confirm) = add_cues(world, {"name": "Laser fire", "variations": 2}, {"name": "UI confirm"})
    approve(world, [{**laser, "stems": laser["stems"][:1]}, confirm])
    with zipfile.ZipFile(io.BytesIO(download(world))) as archive:
        assert archive.namelist() == ["ui_confirm.wav", *KEY]


def test_nothing_accepted_and_no_such_target(world: World) -> None:
    url = f"/v1/projects/{world.project_id}/pack"
    empty = world.producer.get(f"{url}.zip", params={"target": "game"})
    assert (empty.status_code, empty.json()["code"]) == (409, "nothing-accepted")
    assert world.producer.get(url).json()["files"] == 0
    unknown = world.producer.get(f"{url}.zip", params={"target": "toaster"})
    assert (unknown.status_code, unknown.json()["code"]) == (422, "target-unknown")
    assert "handheld" in unknown.json()["detail"]


@pytest.mark.slow
def test_an_accepted_sound_without_a_game_file_is_never_left_out_unsaid(world: World) -> None:
    accepted_list(world)
    spec = world.producer.get(f"/v1/projects/{world.project_id}/spec").json()
    toml = spec["toml"] + "\n[targets.film]\nsample_rate_hz = 48000\nbit_depth = 24\n"
    saved = world.producer.put(
        f"/v1/projects/{world.project_id}/spec", json={"toml": toml, "based_on_version": spec["version"]}
    )
    assert saved.status_code == 200, saved.text
    world.server.wait_for_jobs()
    url = f"/v1/projects/{world.project_id}/pack"
    missing = world.producer.get(url, params={"target": "film"}).json()["missing"]
    assert [one["file_name"] for one in missing] == SOUNDS
    assert "48" in missing[0]["reason"]
    refused = world.producer.get(f"{url}.zip", params={"target": "film"})
    assert (refused.status_code, refused.json()["code"]) == (409, "pack-incomplete")
    assert [one["where"] for one in refused.json()["errors"]] == SOUNDS
    with zipfile.ZipFile(io.BytesIO(download(world, target="film", allow_missing=True, masters=True))) as archive:
        assert [name for name in archive.namelist() if "/" not in name] == KEY
        rows = list(csv.DictReader(io.StringIO(archive.read("documentation-key.csv").decode("utf-8-sig"))))
        assert [row["file"] for row in rows] == ["", "", ""]
        assert all("48" in row["note"] for row in rows)


def blob_of(world: World, name: str) -> Path:
    with zipfile.ZipFile(io.BytesIO(download(world))) as archive:
        sha256 = hashlib.sha256(archive.read(name)).hexdigest()
    return blob_file(world.server.runtime.store, world.studio_id, sha256)


@pytest.mark.slow
def test_a_lost_blob_is_said_before_anything_is_sent(world: World) -> None:
    accepted_list(world)
    blob_of(world, "laser_fire_02.wav").unlink()
    answer = world.producer.get(f"/v1/projects/{world.project_id}/pack.zip", params={"target": "game"})
    assert (answer.status_code, answer.json()["code"]) == (500, "blob-damaged")
    assert "laser_fire_02.wav" in answer.json()["detail"]


def rot(blob: Path) -> None:
    """Change one bit of a stored file."""
    content = bytearray(blob.read_bytes())
    content[-1] ^= 1
    blob.chmod(0o640)
    blob.write_bytes(content)


@pytest.mark.slow
@pytest.mark.on_folder
def test_a_blob_that_rotted_is_said_before_anything_is_sent(world: World) -> None:
    accepted_list(world)
    rot(blob_of(world, "laser_fire_02.wav"))
    answer = world.producer.get(f"/v1/projects/{world.project_id}/pack.zip", params={"target": "game"})
    assert (answer.status_code, answer.json()["code"]) == (500, "blob-damaged")
    assert "laser_fire_02.wav" in answer.json()["detail"]
    assert "upload the same file again" in answer.json()["fix"]


@pytest.mark.slow
def test_a_blob_that_rotted_beyond_the_first_gib_breaks_off_the_download(
    world: World, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(packs, "VERIFIED_AHEAD_BYTES", 0)
    accepted_list(world)
    rot(blob_of(world, "laser_fire_02.wav"))
    parts: list[bytes] = []
    cookies = {SESSION_COOKIE: str(world.producer.cookies[SESSION_COOKIE])}
    with (
        listening(world.server.application, lifespan="off", log_level="critical") as port,
        httpx.Client(base_url=f"http://127.0.0.1:{port}", cookies=cookies) as client,
    ):
        path = f"/v1/projects/{world.project_id}/pack.zip"
        with client.stream("GET", path, params={"target": "game"}) as answer:
            promised = int(answer.headers["content-length"])
            with pytest.raises(httpx.RemoteProtocolError):
                parts.extend(answer.iter_bytes())
    received = b"".join(parts)
    assert b"laser_fire_01.wav" in received
    assert b"laser_fire_02.wav" not in received
    assert len(received) < promised
    assert not zipfile.is_zipfile(io.BytesIO(received))


@pytest.mark.slow
def test_a_render_that_names_no_file_of_its_size_is_damage(world: World) -> None:
    accepted_list(world)
    grow = sa.update(Render).where(Render.project_id == world.project_id).values(file_bytes=Render.file_bytes + 1)
    world.server.in_database(lambda session: session.execute(grow))
    answer = world.producer.get(f"/v1/projects/{world.project_id}/pack.zip", params={"target": "game"})
    assert answer.json()["code"] == "blob-damaged"


@pytest.mark.parametrize(
    ("who", "status"), [("stranger", 404), ("other_designer", 404), ("designer", 403), ("nobody", 401)]
)
def test_who_may_not(world: World, who: str, status: int) -> None:
    client: Client = getattr(world, who)
    key = tuple(f"documentation-key.{ending}" for ending in ("csv", "xlsx", "pdf"))
    for path in ("pack", "pack.zip", *key, "builds", "ci", "packs"):
        assert client.get(f"/v1/projects/{world.project_id}/{path}").status_code == status, path


@pytest.mark.slow
def test_packs_and_journals_that_left_are_in_the_security_log(world: World) -> None:
    accepted_list(world)
    name = world.producer.get(f"/v1/projects/{world.project_id}").json()["name"]
    download(world)
    assert world.producer.get(f"/v1/projects/{world.project_id}/journal.csv").status_code == 200
    lines = world.producer.get(f"/v1/studios/{world.studio_id}/security-events", params={"kind": "export"}).json()[
        "items"
    ]
    assert [line["summary"] for line in lines] == [f"downloaded the journal of {name}", f"downloaded {name} game.zip"]
    assert {line["person"]["id"] for line in lines} == {str(world.producer_id)}
    assert all(line["network"] for line in lines)
