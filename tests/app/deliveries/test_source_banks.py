"""The source bank of a take: its designer's, the studio's by contract, in the handover and never in a pack."""

import io
import zipfile
from typing import Any
from uuid import UUID

import numpy as np
import pytest
from sqlalchemy import select
from sqlalchemy.orm import Session

from app.deliveries.rules import SourceFileKind, source_file_kind
from app.projects.models import Engagement
from app.projects.rules import EngagementKind
from tests.app.builds.approved import approve
from tests.app.builds.test_handover import Half
from tests.app.money.agreed import Agreed, milestone
from tests.app.reviews.making import Stage, body_of, refused
from tests.support.deliver import add_cues, deliver, open_delivery
from tests.support.rooms import hits
from tests.support.server import World
from tests.support.waves import wav_bytes

SESSION, LAYER = b"<REAPER_PROJECT 0.1", b"RIFF of a layer"
RECIPE = {"plug_ins": ["Pro-Q 3.21"], "recipe": "Two bowls, pitched down 7 semitones."}


@pytest.fixture
def stage(world: World) -> Stage:
    return Stage(world)


def give(world: World, take_id: UUID, content: bytes = SESSION, name: str = "laser.rpp") -> dict[str, Any]:
    """Upload a source file beside a take, and keep it with the take."""
    delivery_id = body_of(world.designer.get(f"/v1/takes/{take_id}"))["delivery_id"]
    where = {"delivery_id": delivery_id, "file_name": name, "take_id": str(take_id)}
    sent = world.designer.put("/v1/uploads", params=where, content=content)
    assert sent.status_code == 201, sent.text
    kept = world.designer.post(f"/v1/takes/{take_id}/source-files", json={"upload_id": sent.json()["upload_id"]})
    assert kept.status_code == 201, kept.text
    file: dict[str, Any] = kept.json()
    return file


def bank(by: Any, take_id: UUID) -> dict[str, Any]:
    return body_of(by.get(f"/v1/takes/{take_id}/source-bank"))


def test_audio_is_a_layer_and_anything_else_the_session() -> None:
    assert source_file_kind("Kick 01.WAV") is SourceFileKind.LAYER
    assert source_file_kind("laser.rpp") is SourceFileKind.SESSION
    assert source_file_kind("laser.zip") is SourceFileKind.SESSION


def test_it_is_kept_with_the_take_and_shown_to_its_designer_alone(stage: Stage) -> None:
    world, take = stage.world, stage.take(stage.cue())
    closed = world.designer.post(f"/v1/deliveries/{stage.delivery_id}/close")
    assert closed.status_code == 200, "a closed delivery still takes source files"
    session, layer = give(world, take), give(world, take, LAYER, "bowl.wav")
    body_of(world.designer.put(f"/v1/takes/{take}/source-bank", json=RECIPE))
    own = bank(world.designer, take)
    assert (own["is_shown"], own["plug_ins"], own["recipe"]) == (True, *RECIPE.values())
    assert [(file["kind"], file["file_name"]) for file in own["files"]] == [
        ("session", "laser.rpp"),
        ("layer", "bowl.wav"),
    ]
    assert world.designer.get(f"/v1/source-files/{session['id']}").content == SESSION
    for by in (world.producer, world.approver, world.reviewer):
        seen = bank(by, take)
        assert (seen["is_shown"], seen["plug_ins"], seen["recipe"], seen["files"]) == (False, [], "", [])
        assert refused(by.get(f"/v1/source-files/{session['id']}")) == (404, "source-file-not-found")
        assert refused(by.put(f"/v1/takes/{take}/source-bank", json=RECIPE)) == (403, "own-designer-needed")
    assert refused(world.stranger.get(f"/v1/takes/{take}/source-bank")) == (404, "take-not-found")
    assert world.designer.delete(f"/v1/source-files/{layer['id']}").status_code == 204
    assert [file["file_name"] for file in bank(world.designer, take)["files"]] == ["laser.rpp"]


def test_the_same_upload_is_one_file(stage: Stage) -> None:
    world, take = stage.world, stage.take(stage.cue())
    where = {"delivery_id": str(stage.delivery_id), "file_name": "laser.rpp"}
    upload_id = world.designer.put("/v1/uploads", params=where, content=SESSION).json()["upload_id"]
    kept = [
        world.designer.post(f"/v1/takes/{take}/source-files", json={"upload_id": upload_id}).json()["id"]
        for _ in range(2)
    ]
    assert kept[0] == kept[1]


@pytest.mark.parametrize("source_files", ["handed_over", "kept"])
def test_an_approved_takes_bank_is_the_studios_where_the_contract_says_so(world: World, source_files: str) -> None:
    agreed = Agreed(world, terms={"source_files": source_files})
    cue = agreed.cue()
    agreed.agree(milestone("Alpha", cue, amount_minor=18_000))
    take = agreed.take(cue)
    file = give(world, take)
    assert world.designer.put(f"/v1/takes/{take}/source-bank", json=RECIPE).status_code == 200
    assert bank(world.producer, take)["is_shown"] is False, "not before the approval"
    agreed.approve(take)
    is_handed_over = source_files == "handed_over"
    assert bank(world.producer, take)["is_shown"] is is_handed_over
    assert world.producer.get(f"/v1/source-files/{file['id']}").status_code == (200 if is_handed_over else 404)
    recipe = world.designer.put(f"/v1/takes/{take}/source-bank", json=RECIPE)
    assert (recipe.status_code, recipe.json().get("code")) == (
        (409, "source-bank-handed-over") if is_handed_over else (200, None)
    )
    removed = world.designer.delete(f"/v1/source-files/{file['id']}")
    assert removed.status_code == (409 if is_handed_over else 204)


def test_what_opens_by_payment_is_closed_until_it_is_paid(world: World) -> None:
    agreed = Agreed(world, terms={"source_files": "handed_over", "downloads_open": "when_paid"})
    cue = agreed.cue()
    agreed.agree(milestone("Alpha", cue, amount_minor=18_000))
    take = agreed.take(cue)
    file = give(world, take)
    agreed.approve(take)
    assert refused(world.producer.get(f"/v1/source-files/{file['id']}")) == (403, "download-unpaid")
    assert agreed.pay(agreed.invoice(), 18_000).status_code == 201
    assert world.producer.get(f"/v1/source-files/{file['id']}").content == SESSION


@pytest.mark.slow
@pytest.mark.parametrize("source_files", ["handed_over", "kept"])
def test_the_handover_has_the_source_files_of_approved_takes_by_contract(world: World, source_files: str) -> None:
    half = Half(world, source_files=source_files)
    for take in half.takes:  # the second is not approved
        give(world, take, SESSION, "a:b/laser?.rpp")
        give(world, take, LAYER, "laser?.rpp")
        body_of(world.designer.put(f"/v1/takes/{take}/source-bank", json=RECIPE))
    half.end()
    with zipfile.ZipFile(io.BytesIO(half.pack().content)) as archive:
        assert archive.testzip() is None
        names, read_me = archive.namelist(), archive.read("README.md").decode()
        sources = {name: archive.read(name) for name in names if name.startswith("source_files/")}
        sums = archive.read("SHA256SUMS").decode()
    if source_files == "kept":
        assert sources == {}
        assert RECIPE["recipe"] not in read_me
    else:
        assert sources == {
            "source_files/laser/01_laser_.rpp": SESSION,
            "source_files/laser/02_laser_.rpp": LAYER,
        }
        assert all(name in sums for name in sources)
        assert f"- Plug-ins: Pro-Q 3.21\n\n{RECIPE['recipe']}" in read_me


def test_who_is_named_an_employee_later_keeps_what_they_made_before(stage: Stage) -> None:
    world = stage.world
    before = stage.take(stage.cue("before"))
    session = give(world, before)
    stage.approve(before)
    page = f"/v1/projects/{world.project_id}"
    engagement_id = body_of(world.producer.get(page))["engagements"][0]["id"]
    body_of(world.producer.patch(f"{page}/engagements/{engagement_id}", json={"kind": "in-house"}))
    assert refused(world.producer.get(f"/v1/source-files/{session['id']}")) == (404, "source-file-not-found")
    after = stage.take(stage.cue("after"))
    layer = give(world, after, LAYER, "bowl.wav")
    stage.approve(after)
    assert world.producer.get(f"/v1/source-files/{layer['id']}").content == LAYER


@pytest.mark.slow
def test_an_employees_bank_is_the_studios_and_in_no_pack(world: World) -> None:
    cues = add_cues(world, {"name": "UI confirm", "file_name": "ui_confirm"})
    delivery_id = open_delivery(world)
    approve(world, cues, delivery_id=delivery_id)
    (take,) = body_of(world.designer.get(f"/v1/deliveries/{delivery_id}"))["takes"]
    file = give(world, take["id"], LAYER, "layer.wav")

    def employ(session: Session) -> None:
        of_designer = Engagement.designer_id == world.designer_id
        session.scalars(select(Engagement).where(of_designer)).one().kind = EngagementKind.IN_HOUSE

    world.server.in_database(employ)
    assert world.producer.get(f"/v1/source-files/{file['id']}").content == LAYER
    for masters in (False, True):
        path = f"/v1/projects/{world.project_id}/pack.zip"
        packed = world.producer.get(path, params={"target": "game", "masters": masters})
        assert packed.status_code == 200, packed.text
        with zipfile.ZipFile(io.BytesIO(packed.content)) as archive:
            assert "ui_confirm.wav" in archive.namelist()
            assert all(archive.read(name) != LAYER for name in archive.namelist())


@pytest.mark.slow
def test_a_fix_keeps_the_bank_and_its_bytes_are_counted_once(world: World) -> None:
    add_cues(world, {"name": "Airlock cycle", "file_name": "airlock_cycle"})
    late = wav_bytes(np.concatenate([np.zeros((2_400, 1)), hits(seconds=1.0)]))
    take = deliver(world, "airlock_cycle.wav", late)
    give(world, take["id"])
    body_of(world.designer.put(f"/v1/takes/{take['id']}/source-bank", json=RECIPE))
    world.server.wait_for_jobs()
    assert world.designer.post(f"/v1/takes/{take['id']}/fix").status_code == 202
    world.server.wait_for_jobs()
    used = world.designer.post(f"/v1/takes/{take['id']}/fix/use")
    assert used.status_code == 201, used.text
    fixed = bank(world.designer, used.json()["id"])
    assert ([file["file_name"] for file in fixed["files"]], fixed["recipe"]) == (["laser.rpp"], RECIPE["recipe"])
    storage = body_of(world.producer.get(f"/v1/studios/{world.studio_id}/storage"))
    assert {kept["kind"]: kept["size_bytes"] for kept in storage["kept"]}["source_files"] == len(SESSION)
