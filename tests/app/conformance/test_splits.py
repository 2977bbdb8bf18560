"""One file of several sounds is split when its designer says so: the parts become variations, the file is kept."""

import struct
from typing import Any

import pytest

from app.conformance import jobs
from app.conformance.splits import OUR_FAULT
from tests.support.deliver import add_cues, checked, deliver
from tests.support.server import World
from tests.support.waves import chunk, join, silence, sine, swelling, wav_bytes

RATE = 48_000
STEP, GAP = 9_600, 48_000  # frames


def steps(count: int = 3, *, markers: bool = False, gap: int = GAP) -> bytes:
    """A file of steps with silence between them, marked where each begins if that is wanted."""
    sounds = []
    for number in range(count):
        tone = sine(hz=300 + 100 * number, dbfs=-6.0, seconds=STEP / RATE, phase=1.0)
        sounds += [swelling(tone, 48), silence(seconds=gap / RATE)]
    starts = [number * (STEP + gap) for number in range(count)] if markers else []
    rows = b"".join(struct.pack("<II4sIII", at, at, b"data", 0, 0, at) for at in starts)
    after = [chunk(b"cue ", struct.pack("<I", len(starts)) + rows)] if markers else []
    return wav_bytes(join(*sounds[:-1]), after=after)


def delivered(world: World, content: bytes, name: str = "step_01.wav") -> dict[str, Any]:
    take = deliver(world, name, content)
    world.server.wait_for_jobs()
    return take


def split_of(world: World, take: dict[str, Any], by: Any = None) -> dict[str, Any]:
    answer = (by or world.designer).get(f"/v1/takes/{take['id']}/split")
    assert answer.status_code == 200, answer.text
    return dict(answer.json())


def found(world: World, take: dict[str, Any], **asked: Any) -> dict[str, Any]:
    answer = world.designer.post(f"/v1/takes/{take['id']}/split", json=asked)
    assert (answer.status_code, answer.json().get("state")) == (202, "making"), answer.text
    world.server.wait_for_jobs()
    return split_of(world, take)


def used(world: World, take: dict[str, Any], **given: Any) -> dict[str, Any]:
    answer = world.designer.post(f"/v1/takes/{take['id']}/split/use", json=given)
    assert answer.status_code == 201, answer.text
    world.server.wait_for_jobs()
    return dict(answer.json())


def of_cue(world: World, cue: dict[str, Any]) -> list[dict[str, Any]]:
    """Return the takes of a cue by variation."""
    takes = world.designer.get(f"/v1/projects/{world.project_id}/takes", params={"limit": 200}).json()["items"]
    matched = [version for version in takes if version["cue"] and version["cue"]["id"] == cue["id"]]
    return sorted(matched, key=lambda version: version["variation"])


@pytest.fixture
def cue(world: World) -> dict[str, Any]:
    return add_cues(world, {"name": "Step", "variations": 3})[0]


@pytest.mark.parametrize("markers", [False, True])
def test_parts_become_variations_sample_for_sample(world: World, cue: dict[str, Any], *, markers: bool) -> None:
    content = steps(markers=markers)
    take = delivered(world, content)
    [offer] = world.designer.get(f"/v1/projects/{world.project_id}/splits").json()
    assert (offer["take_id"], offer["variations"]) == (take["id"], 3)
    assert offer["says"].startswith("It has 3 markers" if markers else "3 sounds with silence between them")
    assert split_of(world, take)["state"] == "offered"
    assert [version["id"] for version in of_cue(world, cue)] == [take["id"]]  # nothing is done unasked

    split = found(world, take)
    assert (split["state"], split["found_by"]) == ("made", "markers" if markers else "silence")
    starts = [part["start_s"] for part in split["parts"]]
    assert starts == pytest.approx([0.0, 1.2, 2.4], abs=0.003)
    assert [part["duration_s"] for part in split["parts"]] == pytest.approx([0.22, 0.22, 0.2], abs=0.003)

    action = used(world, take)
    assert (action["kind"], len(action["take_ids"])) == ("split", 4)
    parts = of_cue(world, cue)
    assert [(version["variation"], version["file_name"], version["number"]) for version in parts] == [
        (1, "step_01.wav", 2),
        (2, "step_02.wav", 1),
        (3, "step_03.wav", 1),
    ]
    whole = content[content.index(b"data") + 8 :]
    for version, part in zip(parts, split["parts"], strict=True):
        assert checked(world, version["id"])["verdict"] == "conforming"
        origin = split_of(world, version, by=world.approver)["split_from"]
        assert (origin["take_id"], origin["file_name"]) == (take["id"], "step_01.wav")
        assert origin["start_s"] == pytest.approx(part["start_s"])
        master = world.designer.get(f"/v1/takes/{version['id']}/master").content
        data = master[master.index(b"data") + 8 :][: 3 * (origin["end_frame"] - origin["first_frame"])]
        assert data == whole[3 * origin["first_frame"] : 3 * origin["end_frame"]]
        history = world.approver.get(f"/v1/takes/{version['id']}/history").json()
        assert f"frames {origin['first_frame']} to {origin['end_frame']} of step_01.wav" in history[0]["text"]
    assert world.designer.get(f"/v1/takes/{take['id']}/master").content == content  # what was received is kept
    assert split_of(world, take)["state"] == "used"
    assert world.designer.get(f"/v1/projects/{world.project_id}/splits").json() == []


@pytest.mark.slow
def test_a_split_is_undone_and_done_again(world: World, cue: dict[str, Any]) -> None:
    take = delivered(world, steps())
    found(world, take)
    action = used(world, take)
    undone = world.designer.post(f"/v1/tray-actions/{action['id']}/undo").json()
    assert (undone["moved_back"], undone["left"]) == (4, 0)
    world.server.wait_for_jobs()
    assert [(version["id"], version["variation"]) for version in of_cue(world, cue)] == [(take["id"], 1)]
    split = split_of(world, take)
    assert (split["state"], split["tray_action_id"]) == ("made", None)
    used(world, take)
    assert [version["variation"] for version in of_cue(world, cue)] == [1, 2, 3]


def test_an_unmatched_file_goes_to_the_cue_that_is_chosen_in_part(world: World, cue: dict[str, Any]) -> None:
    take = delivered(world, steps(4), "everything i recorded.wav")
    assert take["cue"] is None
    found(world, take)
    refused = world.designer.post(f"/v1/takes/{take['id']}/split/use", json={})
    assert (refused.status_code, refused.json()["code"]) == (422, "parts-misplaced")
    too_many = world.designer.post(f"/v1/takes/{take['id']}/split/use", json={"cue_id": cue["id"]})
    assert (too_many.status_code, too_many.json()["code"]) == (422, "variation-unknown")
    assert of_cue(world, cue) == []  # all or none
    used(world, take, cue_id=cue["id"], places=[{"part": 4, "variation": 1}, {"part": 2, "variation": 3}])
    placed = [(version["variation"], version["file_name"]) for version in of_cue(world, cue)]
    assert placed == [(1, "step_01.wav"), (3, "step_03.wav")]


@pytest.mark.slow
def test_parts_and_variations_are_named_once(world: World, cue: dict[str, Any]) -> None:
    take = delivered(world, steps())
    found(world, take)
    for places, words in (
        ([(1, 1), (1, 2)], "part 1 is named 2 times"),
        ([(1, 2), (2, 2)], "variation 2 is named 2 times"),
        ([(9, 1)], "there is no part 9: the file has 3 parts"),
    ):
        given = [{"part": part, "variation": variation} for part, variation in places]
        refused = world.designer.post(f"/v1/takes/{take['id']}/split/use", json={"places": given})
        assert (refused.status_code, refused.json()["detail"]) == (422, words)
    assert len(of_cue(world, cue)) == 1


@pytest.mark.slow
def test_shorter_silence_parts_where_it_is_asked_for(world: World, cue: dict[str, Any]) -> None:
    take = delivered(world, steps(gap=14_400))
    assert split_of(world, take)["state"] == "none"
    refused = found(world, take)
    assert refused["state"] == "refused"
    assert refused["says"].startswith("Not split: it holds one sound: no silence of 0.6 s or more inside")
    not_ready = world.designer.post(f"/v1/takes/{take['id']}/split/use", json={})
    assert (not_ready.status_code, not_ready.json()["code"]) == (409, "split-not-ready")
    assert len(found(world, take, shortest_pause_s=0.2)["parts"]) == 3


@pytest.mark.slow
def test_only_its_own_designer_splits_it(world: World, cue: dict[str, Any]) -> None:
    take = delivered(world, steps())
    for client, status, sees in (
        (world.approver, 403, 200),
        (world.producer, 403, 200),
        (world.reviewer, 403, 200),
        (world.other_designer, 404, 404),
        (world.stranger, 404, 404),
        (world.nobody, 401, 401),
    ):
        for path in ("split", "split/use"):
            assert client.post(f"/v1/takes/{take['id']}/{path}", json={}).status_code == status
        assert client.get(f"/v1/takes/{take['id']}/split").status_code == sees
    for client in (world.other_designer, world.stranger):
        assert client.get(f"/v1/projects/{world.project_id}/splits").status_code == 404


@pytest.mark.slow
def test_what_is_decided_upon_or_discarded_is_not_split(world: World, cue: dict[str, Any]) -> None:
    take = delivered(world, steps())
    found(world, take)
    world.designer.post(f"/v1/projects/{world.project_id}/takes/discard", json={"take_ids": [take["id"]]})
    refused = world.designer.post(f"/v1/takes/{take['id']}/split/use", json={"cue_id": cue["id"]})
    assert (refused.status_code, refused.json()["detail"]) == (409, "this file was discarded")
    other = delivered(world, steps(2), "step_02.wav")
    approved = world.approver.post(f"/v1/takes/{other['id']}/verdict", json={"kind": "approve"})
    assert approved.status_code in (200, 201), approved.text
    refused = world.designer.post(f"/v1/takes/{other['id']}/split", json={})
    assert (refused.status_code, refused.json()["detail"]) == (409, "this version is approved")


@pytest.mark.slow
def test_a_split_that_fails_is_our_fault_and_asked_for_again(
    world: World, cue: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    take = delivered(world, steps())
    with monkeypatch.context() as broken:
        broken.setattr(jobs, "_split", lambda *_: OUR_FAULT)
        refused = found(world, take)
        assert (refused["state"], refused["says"], refused["is_our_fault"]) == ("refused", OUR_FAULT, True)
    assert found(world, take)["state"] == "made"
