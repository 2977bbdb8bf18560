"""A dry stem beside a take: given, delivered by its name, used by the check, withdrawn; hostile until it is read."""

import io
import zipfile
from typing import Any
from uuid import UUID

import numpy as np
import pytest

import audio_checks
from app.core.db import new_id
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from tests.support.deliver import BYTES, TUS, add_cues, checked, deliver, metadata, open_delivery, upload
from tests.support.rooms import hits, in_a_room
from tests.support.server import World
from tests.support.waves import noise, wav_bytes

DRY = wav_bytes(hits(seconds=1.0))
WET = wav_bytes(in_a_room(hits(seconds=1.0), rt60_s=0.8))
OTHER = wav_bytes(noise(seconds=1.0, seed=5, dbfs=-20))


@pytest.fixture
def cue(world: World) -> dict[str, Any]:
    """A cue of a project whose game adds reverb."""
    path = f"/v1/projects/{world.project_id}/spec"
    now = world.producer.get(path).json()
    toml = f'{now["toml"]}\n[categories.warp]\nengine = {{ adds = ["reverb"] }}\n'
    saved = world.producer.put(path, json={"toml": toml, "note": "", "based_on_version": now["version"]})
    assert saved.status_code == 200, saved.text
    return add_cues(world, {"name": "Warp in", "category": "warp"})[0]


def heard(check: dict[str, Any]) -> list[str]:
    """Return what is found of reverb."""
    return [one["message"] for one in check["findings"] if one["code"] == "baked-reverb:heard"]


def give(world: World, take: dict[str, Any], content: bytes, name: str = "bounce 7.wav") -> Any:
    """Upload a dry stem and give it to a take."""
    sent = world.designer.put(
        "/v1/uploads",
        params={"delivery_id": take["delivery_id"], "file_name": name, "take_id": take["id"]},
        content=content,
    )
    assert sent.status_code == 201, sent.text
    return world.designer.put(f"/v1/takes/{take['id']}/dry-stem", json={"upload_id": sent.json()["upload_id"]})


def post_take(world: World, delivery_id: str, name: str, content: bytes) -> Any:
    """Send a file into a delivery, and return the answer to what it becomes."""
    upload_id = upload(world, delivery_id, name, content)
    return world.designer.post(f"/v1/deliveries/{delivery_id}/takes", json={"upload_id": upload_id, "file_name": name})


@pytest.mark.slow
@pytest.mark.usefixtures("cue")
def test_what_was_added_to_the_stem_is_the_judgement(world: World) -> None:
    take = deliver(world, "warp_in.wav", WET)
    alone = checked(world, take["id"])
    assert alone["dry_stem"] is None
    given = give(world, take, DRY)
    assert (given.status_code, given.json()["take_ids"], given.json()["stem"]) == (200, [take["id"]], "warp_in")
    beside = checked(world, take["id"])
    reverb = beside["judgements"]["reverb"]
    assert (reverb["verdict"], reverb["beside"], reverb["stem"]["name"]) == ("reverb", "bounce 7.wav", "bounce 7.wav")
    assert reverb["stem"]["rt60_s"] == pytest.approx(0.8, rel=0.1)
    assert reverb["stem"]["wet_db"] == pytest.approx(-6, abs=1)
    assert (beside["dry_stem"]["file_name"], beside["is_newest_stem"]) == ("bounce 7.wav", True)
    assert "added to bounce 7.wav" in heard(beside)[0]


@pytest.mark.slow
@pytest.mark.usefixtures("cue")
def test_where_nothing_was_added_the_finding_goes_and_comes_back_with_the_stem_withdrawn(world: World) -> None:
    take = deliver(world, "warp_in.wav", WET)
    assert heard(checked(world, take["id"]))
    give(world, take, WET)
    beside = checked(world, take["id"])
    assert (beside["judgements"]["reverb"]["verdict"], heard(beside)) == ("dry", [])
    withdrawn = world.designer.delete(f"/v1/takes/{take['id']}/dry-stem")
    assert (withdrawn.status_code, withdrawn.content) == (204, b"")
    alone = checked(world, take["id"])
    assert heard(alone)
    assert (alone["dry_stem"], "stem" in alone["judgements"]["reverb"]) == (None, False)
    assert world.designer.get(f"/v1/takes/{take['id']}/dry-stem").status_code == 404
    assert world.designer.delete(f"/v1/takes/{take['id']}/dry-stem").status_code == 204  # as often as one likes


@pytest.mark.slow
@pytest.mark.usefixtures("cue")
def test_of_another_sound_the_judgement_without_it_stands(world: World) -> None:
    take = deliver(world, "warp_in.wav", WET)
    alone = checked(world, take["id"])["judgements"]["reverb"]
    give(world, take, OTHER)
    reverb = checked(world, take["id"])["judgements"]["reverb"]
    assert reverb.pop("stem")["why"] == "the two are not the same sound"
    assert reverb == alone


@pytest.mark.slow
@pytest.mark.usefixtures("cue")
def test_one_that_cannot_be_read_is_refused_in_words(world: World) -> None:
    take = deliver(world, "warp_in.wav", WET)
    give(world, take, b"ID3 " + bytes(100))
    check = checked(world, take["id"])
    stem = check["judgements"]["reverb"]["stem"]
    assert stem["verdict"] == "unreadable"
    assert "not WAV, whatever its name ends in" in stem["why"]
    assert (check["is_newest_stem"], len(heard(check))) == (True, 1)
    give(world, take, WET)  # the next one counts
    assert heard(checked(world, take["id"])) == []


@pytest.mark.slow
@pytest.mark.usefixtures("cue")
def test_a_comparison_that_breaks_leaves_the_take_judged_and_is_tried_again(
    world: World, monkeypatch: pytest.MonkeyPatch
) -> None:
    take = deliver(world, "warp_in.wav", WET)
    world.server.wait_for_jobs()

    def breaking(child: audio_checks.SandboxChild, work: Any, *given: Any, **options: Any) -> Any:
        if options.get("dry"):
            raise audio_checks.SandboxCrashed("the child was killed by signal 9")
        return call(child, work, *given, **options)

    call = audio_checks.SandboxChild.call
    with monkeypatch.context() as patched:
        patched.setattr(audio_checks.SandboxChild, "call", breaking)
        give(world, take, WET)
        broken = checked(world, take["id"])
    assert (broken["state"], broken["judgements"]["reverb"]["stem"]["verdict"]) == ("conforming", "failed")
    assert world.designer.post(f"/v1/takes/{take['id']}/recheck").status_code == 202
    assert heard(checked(world, take["id"])) == []


@pytest.mark.slow
@pytest.mark.usefixtures("cue")
@pytest.mark.parametrize("order", [("warp_in__dry.wav", "warp_in.wav"), ("warp_in.wav", "warp_in__dry.wav")])
def test_a_delivery_brings_it_by_its_name_before_or_after_the_take(world: World, order: tuple[str, str]) -> None:
    delivery_id = open_delivery(world)
    answers = {name: post_take(world, delivery_id, name, WET) for name in order}
    kept, take = answers["warp_in__dry.wav"], answers["warp_in.wav"].json()
    assert kept.status_code == 202
    assert kept.json()["take_ids"] == ([take["id"]] if order[0] == "warp_in.wav" else [])
    again = post_take(world, delivery_id, "warp_in__dry.wav", WET).json()
    assert again["id"] == kept.json()["id"]
    check = checked(world, take["id"])
    assert (check["judgements"]["reverb"]["beside"], heard(check)) == ("warp_in__dry.wav", [])
    delivery = world.designer.get(f"/v1/deliveries/{delivery_id}").json()
    assert [one["id"] for one in delivery["takes"]] == [take["id"]]  # none of its own
    assert [(one["file_name"], one["take_ids"]) for one in delivery["dry_stems"]] == [
        ("warp_in__dry.wav", [take["id"]])
    ]
    tray = world.designer.get(f"/v1/projects/{world.project_id}/takes", params={"unmatched": True}).json()
    assert tray["items"] == []


def test_a_name_that_the_list_has_whole_is_a_take(world: World) -> None:
    add_cues(world, {"name": "Shot"}, {"name": "Dry shot", "file_name": "shot__dry"})
    made = post_take(world, open_delivery(world), "shot__dry.wav", DRY)
    assert (made.status_code, made.json()["cue"]["name"]) == (201, "Dry shot")


@pytest.mark.slow
@pytest.mark.usefixtures("cue")
def test_a_zip_brings_it_too(world: World) -> None:
    whole = io.BytesIO()
    with zipfile.ZipFile(whole, "w") as archive:
        archive.writestr("stems/warp_in__dry.wav", WET)
        archive.writestr("warp_in.wav", WET)
    delivery_id = open_delivery(world)
    upload_id = upload(world, delivery_id, "all.zip", whole.getvalue())
    world.designer.post(f"/v1/deliveries/{delivery_id}/archives", json={"upload_id": upload_id, "file_name": "all.zip"})
    world.server.wait_for_jobs()
    delivery = world.designer.get(f"/v1/deliveries/{delivery_id}").json()
    [take] = delivery["takes"]
    reported = {entry["path"]: (entry["taken"], entry["reason"]) for entry in delivery["archives"][0]["entries"]}
    assert reported["stems/warp_in__dry.wav"] == (True, "not a version: the dry stem of warp_in")
    assert heard(checked(world, take["id"])) == []


@pytest.mark.slow
@pytest.mark.usefixtures("cue")
def test_it_is_given_back_byte_for_byte_to_those_who_hear_the_take(world: World) -> None:
    take = deliver(world, "warp_in.wav", WET)
    give(world, take, DRY)
    path = f"/v1/takes/{take['id']}/dry-stem"
    for who in (world.designer, world.approver, world.reviewer):
        got = who.get(path)
        assert (got.status_code, got.content) == (200, DRY)
        assert got.headers["content-disposition"] == 'attachment; filename="bounce 7.wav"'
    give(world, take, WET)
    assert world.designer.get(path).content == WET  # the newest, and no copy of the one before


@pytest.mark.slow
@pytest.mark.usefixtures("cue")
def test_who_may_not(world: World) -> None:
    take = deliver(world, "warp_in.wav", WET)
    give(world, take, DRY)
    path, body = f"/v1/takes/{take['id']}/dry-stem", {"upload_id": str(new_id())}
    for stranger in (world.stranger, world.other_designer):
        assert [stranger.get(path).status_code, stranger.delete(path).status_code] == [404, 404]
        assert stranger.put(path, json=body).status_code == 404
    for seeing in (world.producer, world.approver):
        refused = [seeing.put(path, json=body), seeing.delete(path)]
        assert [(one.status_code, one.json()["code"]) for one in refused] == [(403, "own-designer-needed")] * 2
    assert world.designer.put(path, json=body).json()["code"] == "upload-not-found"
    elsewhere = upload(world, open_delivery(world), "x.wav", DRY)
    assert world.designer.put(path, json={"upload_id": elsewhere}).json()["code"] == "upload-not-found"
    assert world.designer.get(path).content == DRY


@pytest.mark.slow
@pytest.mark.usefixtures("cue")
def test_a_closed_delivery_takes_a_stem_beside_its_take_and_nothing_else(world: World) -> None:
    take = deliver(world, "warp_in.wav", WET)
    assert world.designer.post(f"/v1/deliveries/{take['delivery_id']}/close").status_code == 200
    begun = {
        name: world.designer.post(
            "/v1/uploads",
            headers=TUS
            | BYTES
            | {"Upload-Length": str(len(DRY)), "Upload-Metadata": metadata(**bound, file_name="d.wav")},
            content=DRY,
        )
        for name, bound in {
            "beside": {"delivery_id": take["delivery_id"], "take_id": take["id"]},
            "alone": {"delivery_id": take["delivery_id"]},
            "beside none": {"delivery_id": take["delivery_id"], "take_id": str(new_id())},
            "beside what": {"delivery_id": take["delivery_id"], "take_id": "7"},
        }.items()
    }
    assert {name: answer.status_code for name, answer in begun.items()} == {
        "beside": 201, "alone": 409, "beside none": 404, "beside what": 400,
    }  # fmt: skip
    upload_id = begun["beside"].headers["location"].rpartition("/")[2]
    path = f"/v1/takes/{take['id']}/dry-stem"
    first, second = (world.designer.put(path, json={"upload_id": upload_id}) for _ in range(2))
    assert (first.status_code, second.status_code, first.json()["id"]) == (200, 200, second.json()["id"])
    world.designer.delete(path)
    assert world.designer.put(path, json={"upload_id": upload_id}).json()["id"] == first.json()["id"]  # back again


@pytest.mark.slow
@pytest.mark.usefixtures("cue")
def test_a_verdict_stands_on_what_it_went_by(world: World) -> None:
    take = deliver(world, "warp_in.wav", WET)
    world.server.wait_for_jobs()

    def approve(session: Any) -> None:
        session.get_one(Take, UUID(take["id"])).state = TakeState.APPROVED

    world.server.in_database(approve)
    refused = give(world, take, DRY)
    assert (refused.status_code, refused.json()["code"]) == (409, "wrong-state")
    assert "this version is approved" in refused.json()["detail"]
    post_take(world, take["delivery_id"], "warp_in__dry.wav", DRY)  # kept by its name, and compared with nothing
    check = checked(world, take["id"])
    assert (check["state"], check["dry_stem"]["file_name"], check["is_newest_stem"]) == (
        "approved",
        "warp_in__dry.wav",
        False,
    )


@pytest.mark.slow
@pytest.mark.usefixtures("cue")
def test_its_bytes_are_counted_once_it_is_withdrawn_too(world: World) -> None:
    take = deliver(world, "warp_in.wav", WET)
    give(world, take, DRY)
    world.designer.delete(f"/v1/takes/{take['id']}/dry-stem")
    world.server.wait_for_jobs()
    studio = world.producer.get(f"/v1/studios/{world.studio_id}/storage").json()
    kept = {one["kind"]: (one["files"], one["size_bytes"]) for one in studio["kept"]}
    assert kept["dry_stems"] == (1, len(DRY))
    assert kept["masters"] == (1, len(WET))


@pytest.mark.slow
def test_beside_a_master_that_cannot_be_read_nothing_is_compared(world: World) -> None:
    take = deliver(world, "warp_in.wav", b"RIFF no sound")
    give(world, take, DRY)
    check = checked(world, take["id"])
    assert (check["verdict"], check["is_newest_stem"], check["judgements"]) == ("unreadable", True, {})


@pytest.mark.slow
def test_a_fix_that_puts_the_name_right_keeps_the_stem(world: World) -> None:
    [cue] = add_cues(world, {"name": "Airlock cycle"})
    late = wav_bytes(np.concatenate([np.zeros((2_400, 1)), hits(seconds=1.0)]))
    take = deliver(world, "Bounce 7.WAV", late, cue_id=cue["id"])
    give(world, take, wav_bytes(hits(seconds=1.0)), "dry.wav")
    world.server.wait_for_jobs()
    assert world.designer.post(f"/v1/takes/{take['id']}/fix").status_code == 202
    world.server.wait_for_jobs()
    used = world.designer.post(f"/v1/takes/{take['id']}/fix/use")
    assert (used.status_code, used.json()["file_name"]) == (201, "airlock_cycle.wav")
    fixed = checked(world, used.json()["id"])
    assert (fixed["dry_stem"]["file_name"], fixed["is_newest_stem"]) == ("dry.wav", True)
