"""Packs that are handed out: numbered, always the same bytes, and distinct from the one before."""

import hashlib
import io
import subprocess
import zipfile
from pathlib import Path
from typing import Any
from uuid import UUID

import pytest
import sqlalchemy as sa
from sqlalchemy.orm import Session

from app.builds.models import PackedFile
from app.builds.rules import FileKind, changes_between, sums
from app.core.db import new_id
from app.renders.models import Render
from tests.app.builds.approved import accepted_list, approve, sound
from tests.app.builds.test_builds import token
from tests.support.blobs import blob_file
from tests.support.deliver import add_cues, deliver
from tests.support.server import World

SOUNDS = ["laser_fire_01.wav", "laser_fire_02.wav", "ui_confirm.wav"]


def seal(world: World, **body: Any) -> dict[str, Any]:
    asked = world.reviewer.post(f"/v1/projects/{world.project_id}/packs", json={"target": "game"} | body)
    assert asked.status_code == 201, asked.text
    world.server.wait_for_jobs()
    answer: dict[str, Any] = world.reviewer.get(f"/v1/packs/{asked.json()['id']}").json()
    return answer


def fetch(world: World, pack: dict[str, Any]) -> zipfile.ZipFile:
    answer = world.reviewer.get(f"/v1/packs/{pack['id']}/pack.zip")
    assert answer.status_code == 200, answer.text
    return zipfile.ZipFile(io.BytesIO(answer.content))


def reported(changes: dict[str, Any]) -> dict[str, set[str]]:
    found: dict[str, set[str]] = {"new": set(), "changed": set(), "gone": set()}
    for change in changes["paths"]:
        found[change["kind"]].add(change["path"])
    return found


def test_what_changed_is_reported_by_path() -> None:
    found = changes_between({"a": "1", "b": "1", "c": "1"}, {"b": "2", "c": "1", "d": "1"})
    assert (found.new, found.changed, found.gone, found.same) == (["d"], ["b"], ["a"], 1)


@pytest.mark.slow
def test_a_sealed_pack_stays_as_it_was_and_its_sums_hold(world: World, tmp_path: Path) -> None:
    accepted_list(world)
    pack = seal(world, note="for the alpha", masters=True)
    assert (pack["number"], pack["state"], pack["files"], pack["sealed_by"]) == (1, "sealed", 3, "Composer")
    first = world.reviewer.get(f"/v1/packs/{pack['id']}/pack.zip").content
    with fetch(world, pack) as archive:
        assert archive.testzip() is None
        assert archive.read("documentation-key.pdf").startswith(b"%PDF-")
        archive.extractall(tmp_path)
    assert len(list((tmp_path / "masters").iterdir())) == 3
    checked = subprocess.run(
        ["/usr/bin/sha256sum", "--check", "--strict", "SHA256SUMS"], cwd=tmp_path, capture_output=True, text=True
    )
    assert (checked.returncode, checked.stdout.count(": OK")) == (0, 9), checked.stdout + checked.stderr
    approve(world, add_cues(world, {"name": "Siren"}))
    assert world.reviewer.get(f"/v1/packs/{pack['id']}/pack.zip").content == first
    second = seal(world)
    assert (second["number"], second["files"], second["changes"]["since"]) == (2, 4, 1)
    assert reported(second["changes"]) == {"new": {"siren.wav"}, "changed": set(), "gone": set()}


@pytest.mark.slow
def test_the_current_pack_says_what_changed_since_the_last(world: World) -> None:
    accepted_list(world)
    url = f"/v1/projects/{world.project_id}/pack"
    before = world.producer.get(url, params={"target": "game"}).json()["changes"]
    assert (before["since"], before["new"]) == (None, 3)
    seal(world)
    assert world.producer.get(url, params={"target": "game"}).json()["changes"]["same"] == 3
    assert world.producer.get(url, params={"target": "handheld"}).json()["changes"]["since"] is None
    cues = world.producer.get(f"/v1/projects/{world.project_id}/sound-list").json()["cues"]
    laser = next(cue for cue in cues if cue["name"] == "Laser fire")
    take = deliver(world, "laser_fire_01.wav", sound(77))
    world.server.wait_for_jobs()
    assert world.approver.post(f"/v1/takes/{take['id']}/verdict", json={"kind": "approve"}).status_code == 200
    confirm = next(cue for cue in cues if cue["name"] == "UI confirm")
    cut = world.approver.post(f"/v1/cues/{confirm['id']}/cut", json={"reason": "no longer needed"})
    assert cut.status_code in (200, 204), cut.text
    world.server.wait_for_jobs()
    assert laser["variations"] == 2
    changes = world.producer.get(url, params={"target": "game"}).json()["changes"]
    assert reported(changes) == {"new": set(), "changed": {"laser_fire_01.wav"}, "gone": {"ui_confirm.wav"}}
    assert changes["same"] == 1


def made_again(world: World, name: str, **facts: Any) -> bytes:
    """Let a later renderer have made a file again: the same samples with another chunk, as these facts say."""
    with zipfile.ZipFile(io.BytesIO(current(world))) as archive:
        content = archive.read(name)
    grown = content[:4] + (len(content) + 4).to_bytes(4, "little") + content[8:] + b"also" + (4).to_bytes(4, "little")
    grown += b"more"
    stored = world.server.runtime.store.put(world.studio_id, [grown])
    find = sa.select(Render).where(
        Render.project_id == world.project_id, Render.sha256 == hashlib.sha256(content).hexdigest()
    )

    def replace(session: Session) -> None:
        old = session.scalars(find).one()
        row = {column.key: getattr(old, column.key) for column in Render.__table__.columns}
        old.key = "of an earlier renderer"
        session.flush()
        row |= {"id": new_id(), "sha256": stored.sha256, "file_bytes": len(grown), "facts": old.facts | facts}
        session.add(Render(**row))

    world.server.in_database(replace)
    return content


def current(world: World) -> bytes:
    answer = world.producer.get(f"/v1/projects/{world.project_id}/pack.zip", params={"target": "game"})
    assert answer.status_code == 200, answer.text
    return answer.content


@pytest.mark.slow
def test_what_sounds_as_it_did_is_the_very_file_of_the_last_pack(world: World) -> None:
    accepted_list(world)
    seal(world)
    before = made_again(world, "ui_confirm.wav")
    looped = made_again(world, "laser_fire_01.wav", loop_points=[[0, 99]])
    with zipfile.ZipFile(io.BytesIO(current(world))) as archive:
        assert archive.read("ui_confirm.wav") == before
        assert archive.read("laser_fire_01.wav") != looped  # the same samples, and yet it plays in another way
    changes = seal(world)["changes"]
    assert reported(changes) == {"new": set(), "changed": {"laser_fire_01.wav"}, "gone": set()}


@pytest.mark.slow
def test_files_stand_in_the_folders_that_the_game_expects(world: World) -> None:
    accepted_list(world)
    spec = world.producer.get(f"/v1/projects/{world.project_id}/spec").json()
    toml = spec["toml"].replace("[targets.game]", '[targets.game]\nfolder = "Assets/Audio/{category}"')
    body = {"toml": toml, "based_on_version": spec["version"]}
    assert world.producer.put(f"/v1/projects/{world.project_id}/spec", json=body).status_code == 200
    world.server.wait_for_jobs()
    with fetch(world, seal(world)) as archive:
        game = [name for name in archive.namelist() if name.startswith("Assets")]
        key = archive.read("documentation-key.csv").decode("utf-8-sig")
    assert game == [
        "Assets/Audio/weapon/laser_fire_01.wav",
        "Assets/Audio/weapon/laser_fire_02.wav",
        "Assets/Audio/ui_confirm.wav",
    ]
    assert all(path in key for path in game)


@pytest.mark.slow
def test_a_lost_file_is_said_of_a_sealed_pack_too(world: World) -> None:
    accepted_list(world)
    pack = seal(world)
    find = sa.select(PackedFile.sha256).where(PackedFile.pack_id == UUID(pack["id"]), PackedFile.kind == FileKind.GAME)
    sha256 = world.server.in_database(lambda session: session.scalars(find).first())
    blob_file(world.server.runtime.store, world.studio_id, sha256).unlink()
    answer = world.reviewer.get(f"/v1/packs/{pack['id']}/pack.zip")
    assert (answer.status_code, answer.json()["code"]) == (500, "blob-damaged")
    refused = seal(world)
    assert (refused["state"], "lost or damaged" in refused["refusal"]) == ("refused", True)
    fetched = world.reviewer.get(f"/v1/packs/{refused['id']}/pack.zip")
    assert (fetched.status_code, fetched.json()["code"]) == (409, "pack-not-sealed")


def test_nothing_accepted_is_not_sealed(world: World) -> None:
    empty = world.reviewer.post(f"/v1/projects/{world.project_id}/packs", json={"target": "game"})
    assert (empty.status_code, empty.json()["code"]) == (409, "nothing-accepted")


@pytest.mark.slow
def test_a_build_fetches_what_was_sealed_by_its_token(world: World) -> None:
    accepted_list(world)
    pack = seal(world)
    build = token(world, "manifest:read")
    listed = build.get(f"/v1/projects/{world.project_id}/packs", params={"target": "game"}).json()["items"]
    assert [one["id"] for one in listed] == [pack["id"]]
    assert build.get(f"/v1/packs/{pack['id']}/pack.zip").status_code == 200
    assert build.post(f"/v1/projects/{world.project_id}/packs", json={"target": "game"}).status_code == 403
    assert token(world, "list:read").get(f"/v1/packs/{pack['id']}/pack.zip").status_code == 403


@pytest.mark.slow
@pytest.mark.parametrize(("who", "status"), [("designer", 403), ("stranger", 404), ("nobody", 401)])
def test_who_may_not(world: World, who: str, status: int) -> None:
    accepted_list(world)
    pack = seal(world)
    client = getattr(world, who)
    assert client.get(f"/v1/packs/{pack['id']}").status_code == status
    assert client.get(f"/v1/packs/{pack['id']}/pack.zip").status_code == status
    assert client.post(f"/v1/projects/{world.project_id}/packs", json={"target": "game"}).status_code == status


def test_sums_are_what_sha256sum_reads() -> None:
    assert sums({"a/b.wav": "0" * 64}) == b"0" * 64 + b"  a/b.wav\n"
