"""Finished uploads become takes: matched by name or on a cue, numbered once, never refused."""

import hashlib
from concurrent.futures import ThreadPoolExecutor
from typing import Any
from uuid import UUID

import pytest
from sqlalchemy import select

from app.core import clock
from app.core.db import new_id
from app.core.uploads import Upload
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.deliveries.take_states import change_state
from app.projects.models import Engagement
from app.projects.rules import EngagementKind
from tests.support.deliver import add_cues, checked, deliver, open_delivery, upload
from tests.support.server import World
from tests.support.waves import chunk, fmt, riff, sine, wav_bytes

SOUND = wav_bytes(sine(hz=440, dbfs=-6, seconds=0.1))


def another(seed: int) -> bytes:
    """A file unlike the others, of which the checker makes short work."""
    return f"no sound, number {seed}".encode()


def engage(world: World) -> None:
    """Engage the other designer as well."""
    world.server.in_database(
        lambda session: session.add(
            Engagement(
                studio_id=world.studio_id,
                project_id=world.project_id,
                designer_id=world.other_designer_id,
                kind=EngagementKind.CONTRACT,
            )
        )
    )


def become(world: World, take_id: str, *states: TakeState) -> None:
    """Take a take through states by the service that jobs and verdicts use."""

    def work(session: Any) -> None:
        take = session.scalar(select(Take).where(Take.id == UUID(take_id)))
        for state in states:
            change_state(session, take, state)

    world.server.in_database(work)


def slot(take: dict[str, Any]) -> tuple[str | None, int, int | None, int | None]:
    """Return the name of the cue, the variation, the number and the alternate of a take."""
    return (take["cue"] and take["cue"]["name"], take["variation"], take["number"], take["alternate"])


@pytest.mark.slow
def test_a_name_finds_its_cue_and_variation(world: World) -> None:
    add_cues(world, {"name": "Laser fire", "variations": 4}, {"name": "Shield hit"})
    delivery_id = open_delivery(world)
    names = ["laser_fire_03.wav", "shield_hit.wav", "folder/shield_hit_altB.wav", "shield_hit__alt3.wav",
             "shield_hit_v07.wav", "Laser_Fire_03.wav", "laser_fire.wav"]  # fmt: skip
    takes = [deliver(world, name, another(seed), delivery_id=delivery_id) for seed, name in enumerate(names)]
    assert [slot(take) for take in takes] == [
        ("Laser fire", 3, 1, None),
        ("Shield hit", 1, 1, None),
        ("Shield hit", 1, 2, 2),
        ("Shield hit", 1, 3, 3),
        ("Shield hit", 1, 4, None),
        ("Laser fire", 3, 2, None),
        (None, 1, None, None),  # a set has no file without a number
    ]
    assert takes[0]["cue"]["label"] == "SW-001"
    assert {take["state"] for take in takes} == {"received"}


@pytest.mark.slow
def test_a_file_dropped_on_a_cue_is_for_it(world: World) -> None:
    steps, laser = add_cues(world, {"name": "Deck walk", "variations": 3}, {"name": "Laser fire"})
    for seed, (name, cue, variation, expected) in enumerate(
        [
            ("whatever.wav", laser, None, ("Laser fire", 1)),
            ("my step 2.wav", steps, None, ("Deck walk", 2)),
            ("my step.wav", steps, None, ("Deck walk", 1)),
            ("my next step.wav", steps, None, ("Deck walk", 3)),
            ("my other step.wav", steps, None, ("Deck walk", 1)),
            ("laser_fire.wav", steps, 2, ("Deck walk", 2)),
        ]
    ):
        take = deliver(world, name, another(seed), cue_id=cue["id"], variation=variation)
        assert slot(take)[:2] == expected, name


@pytest.mark.slow
def test_a_variation_that_the_cue_lacks_is_refused(world: World) -> None:
    [cue] = add_cues(world, {"name": "Deck walk", "variations": 3})
    delivery_id = open_delivery(world)
    body = {"upload_id": upload(world, delivery_id, "a.wav", SOUND), "file_name": "a.wav", "cue_id": cue["id"]}
    refused = world.designer.post(f"/v1/deliveries/{delivery_id}/takes", json=body | {"variation": 4})
    assert (refused.status_code, refused.json()["code"]) == (422, "variation-unknown")
    assert "the cue has 3 variations" in refused.json()["detail"]
    refused = world.designer.post(f"/v1/deliveries/{delivery_id}/takes", json=body | {"cue_id": str(new_id())})
    assert (refused.status_code, refused.json()["code"]) == (404, "cue-not-found")
    assert world.designer.post(f"/v1/deliveries/{delivery_id}/takes", json=body).status_code == 201


@pytest.mark.slow
def test_a_cue_of_another_project_is_not_there(world: World) -> None:
    [foreign] = add_cues(World(world.server), {"name": "Laser fire"})
    delivery_id = open_delivery(world)
    body = {"upload_id": upload(world, delivery_id, "a.wav", SOUND), "file_name": "a.wav", "cue_id": foreign["id"]}
    assert world.designer.post(f"/v1/deliveries/{delivery_id}/takes", json=body).status_code == 404
    take = deliver(world, "b.wav", another(1))
    matched = world.designer.put(f"/v1/takes/{take['id']}/match", json={"cue_id": foreign["id"]})
    assert matched.status_code == 404


@pytest.mark.slow
def test_an_upload_is_one_take_however_often_it_is_posted(world: World) -> None:
    add_cues(world, {"name": "Laser fire"})
    delivery_id = open_delivery(world)
    body = {"upload_id": upload(world, delivery_id, "laser_fire.wav", SOUND), "file_name": "laser_fire.wav"}
    made = [world.designer.post(f"/v1/deliveries/{delivery_id}/takes", json=body) for _ in range(2)]
    assert [answer.status_code for answer in made] == [201, 201]
    assert made[0].json()["id"] == made[1].json()["id"]


@pytest.mark.slow
def test_the_same_file_again_is_the_take_that_is_there(world: World) -> None:
    [laser, shield] = add_cues(world, {"name": "Laser fire"}, {"name": "Shield hit"})
    first, again = deliver(world, "laser_fire.wav", SOUND), deliver(world, "laser_fire.wav", SOUND)
    assert (first["already_here"], again["already_here"]) == (False, True)
    assert again["id"] == first["id"]
    elsewhere = deliver(world, "shield_hit.wav", SOUND)  # under another name
    assert (elsewhere["id"], elsewhere["cue"]["id"], elsewhere["already_here"]) == (first["id"], laser["id"], True)
    meant = deliver(world, "shield_hit.wav", SOUND, cue_id=shield["id"])  # a person says that it is for both
    assert (meant["id"] != first["id"], meant["already_here"]) == (True, False)
    engage(world)
    delivery_id = open_delivery(world, by=world.other_designer)
    upload_id = upload(world, delivery_id, "laser_fire.wav", SOUND, by=world.other_designer)
    theirs = world.other_designer.post(
        f"/v1/deliveries/{delivery_id}/takes", json={"upload_id": upload_id, "file_name": "laser_fire.wav"}
    ).json()
    assert (theirs["already_here"], theirs["number"]) == (False, 2)
    assert theirs["cue"]["id"] == laser["id"]


@pytest.mark.slow
def test_takes_that_arrive_together_get_numbers_of_their_own(world: World) -> None:
    add_cues(world, {"name": "Laser fire"})
    delivery_id = open_delivery(world)
    bodies = [
        {"upload_id": upload(world, delivery_id, "laser_fire.wav", another(seed)), "file_name": "laser_fire.wav"}
        for seed in range(12)
    ]
    with ThreadPoolExecutor(6) as pool:
        made = list(
            pool.map(lambda body: world.designer.post(f"/v1/deliveries/{delivery_id}/takes", json=body), bodies)
        )
    assert {answer.status_code for answer in made} == {201}
    assert sorted(answer.json()["number"] for answer in made) == list(range(1, 13))


@pytest.mark.slow
def test_what_matches_nothing_waits_with_three_guesses(world: World) -> None:
    names = ["Victory sting", "Mine arm", "Radar ping", "Void whale", "Dock clamp"]
    add_cues(world, *({"name": name} for name in names))
    made = deliver(world, "final_FINAL_sting2.wav", SOUND)
    assert slot(made)[0] is None
    assert "guesses" not in made  # the list is not read again for each of hundreds of files
    take = world.designer.get(f"/v1/takes/{made['id']}").json()
    assert take["guesses"][0]["name"] == "Victory sting"
    assert len(take["guesses"]) <= 3
    tray = world.approver.get(f"/v1/projects/{world.project_id}/takes", params={"unmatched": True}).json()["items"]
    assert [(one["id"], one["guesses"]) for one in tray] == [(take["id"], take["guesses"])]
    world.server.wait_for_jobs()
    body = {"cue_id": take["guesses"][0]["cue_id"], "variation": take["guesses"][0]["variation"]}
    matched = world.designer.put(f"/v1/takes/{take['id']}/match", json=body)
    assert matched.status_code == 200
    assert (slot(matched.json()), matched.json()["guesses"]) == (("Victory sting", 1, 1, None), [])
    assert matched.json()["state"] == "received"
    assert checked(world, take["id"])["state"] == "conforming"
    assert world.designer.get(f"/v1/projects/{world.project_id}/takes?unmatched=true").json()["items"] == []


@pytest.mark.slow
def test_a_take_can_be_rematched_until_it_has_a_verdict(world: World) -> None:
    laser, shield = add_cues(world, {"name": "Laser fire"}, {"name": "Shield hit"})
    deliver(world, "shield_hit.wav", another(1))
    take = deliver(world, "laser_fire.wav", SOUND)
    world.server.wait_for_jobs()
    moved = world.approver.put(f"/v1/takes/{take['id']}/match", json={"cue_id": shield["id"]}).json()
    assert (slot(moved), moved["state"]) == (("Shield hit", 1, 2, None), "received")
    world.server.wait_for_jobs()
    same = world.approver.put(f"/v1/takes/{take['id']}/match", json={"cue_id": shield["id"]}).json()
    assert (slot(same), same["state"]) == (("Shield hit", 1, 2, None), "conforming")
    become(world, take["id"], TakeState.APPROVED)
    refused = world.approver.put(f"/v1/takes/{take['id']}/match", json={"cue_id": laser["id"]})
    assert (refused.status_code, refused.json()["code"]) == (409, "wrong-state")


def test_what_finishes_after_its_delivery_closed_is_late_and_comes_in(world: World) -> None:
    delivery_id = open_delivery(world)
    upload_id = upload(world, delivery_id, "laser.wav", SOUND)
    closed = world.designer.post(f"/v1/deliveries/{delivery_id}/close").json()
    assert world.designer.post(f"/v1/deliveries/{delivery_id}/close").json()["closed_at"] == closed["closed_at"]
    body = {"upload_id": upload_id, "file_name": "laser.wav"}
    made = world.designer.post(f"/v1/deliveries/{delivery_id}/takes", json=body)
    assert (made.status_code, made.json()["late"]) == (201, True)


@pytest.mark.slow
def test_an_upload_of_another_delivery_is_not_there(world: World) -> None:
    upload_id = upload(world, open_delivery(world), "laser.wav", SOUND)
    body = {"upload_id": upload_id, "file_name": "laser.wav"}
    refused = world.designer.post(f"/v1/deliveries/{open_delivery(world)}/takes", json=body)
    assert (refused.status_code, refused.json()["code"]) == (404, "upload-not-found")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "shown"),
    [
        ("../../etc/passwd", "../../etc/passwd"),
        ("..\\..\\laser.wav", "..\\..\\laser.wav"),
        ("la\nser.wav", "la\\nser.wav"),
        ("laser\u202evaw.exe", "laser\\u202evaw.exe"),
        ("<img src=x>.wav", "<img src=x>.wav"),
        ("лазер.wav", "лазер.wav"),
        ("x" * 9_996 + ".wav", "x" * 230 + "…" + "x" * 20 + ".wav"),
    ],
)
def test_any_name_is_kept_and_none_is_a_path(world: World, name: str, shown: str) -> None:
    take = deliver(world, name, SOUND)
    assert take["file_name"] == shown
    assert len(take["file_name"]) <= 260
    assert checked(world, take["id"])["verdict"] in ("conforming", "rejected")
    master = world.designer.get(f"/v1/takes/{take['id']}/master")
    assert master.content == SOUND
    assert master.headers["content-disposition"].isascii()
    assert not any(mark in master.headers["content-disposition"] for mark in "/\\\n\r")


@pytest.mark.slow
def test_a_name_that_is_no_text_is_refused_with_a_reason(world: World) -> None:
    delivery_id = open_delivery(world)
    upload_id = upload(world, delivery_id, "a.wav", SOUND)
    for name in (b'""', b'"\\ud800.wav"', b'"laser\\u0000.wav"', b"7"):
        body = b'{"upload_id": "%s", "file_name": %s}' % (upload_id.encode(), name)
        answer = world.designer.post(
            f"/v1/deliveries/{delivery_id}/takes", content=body, headers={"Content-Type": "application/json"}
        )
        assert answer.status_code == 422
        assert answer.json()["errors"]


@pytest.mark.parametrize(
    ("content", "code"),
    [
        (b"", "container:empty"),
        (b"ID3\x04" + bytes(400), "container:"),
        (b"\xff\xfb\x90\x64" + bytes(413), "container:"),
        (b"PK\x03\x04" + bytes(300), "container:"),
        (SOUND[:100], "structure:"),
    ],
    ids=["no bytes", "MP3 with ID3", "MP3", "ZIP", "cut off"],
)
def test_no_sound_named_wav_is_stored_and_judged(world: World, content: bytes, code: str) -> None:
    take = deliver(world, "laser.wav", content)
    found = checked(world, take["id"])
    assert (found["state"], found["verdict"]) == ("returned", "unreadable")
    [finding] = found["findings"]
    assert finding["code"].startswith(code)
    assert finding["fix"]
    assert world.designer.get(f"/v1/takes/{take['id']}/master").content == content


@pytest.mark.slow
@pytest.mark.on_folder  # a file with holes is made in place; sent to a bucket it would be 2 GB of zeros
@pytest.mark.parametrize("declared", [(2 << 30) + 100, (2 << 30) - 44], ids=["says more", "as said, and silent"])
def test_a_file_of_two_gigabytes_is_judged(world: World, declared: int) -> None:
    studio_id, store = world.studio_id, world.server.runtime.store
    delivery_id = open_delivery(world)
    sparse = store.root / str(studio_id) / f"sparse-{declared}"
    sparse.parent.mkdir(parents=True, exist_ok=True)
    header = riff(chunk(b"fmt ", fmt(bits=16)), chunk(b"data", b"", size=declared), size=min(declared + 36, 0xFFFFFFFF))
    with sparse.open("wb") as file:
        file.write(header if declared > 2 << 30 else bytes(44))
        file.truncate(2 << 30)
    with sparse.open("rb") as file:
        sha256 = hashlib.file_digest(file, "sha256").hexdigest()
    store.keep(studio_id, sparse, sha256)
    sparse.unlink()
    row = Upload(
        studio_id=studio_id,
        owner_id=world.designer_id,
        scope=delivery_id,
        file_name="huge.wav",
        length=2 << 30,
        sha256=sha256,
        finished_at=clock.now(),
    )
    world.server.in_database(lambda session: session.add(row))
    body = {"upload_id": str(row.id), "file_name": "huge.wav"}
    made = world.designer.post(f"/v1/deliveries/{delivery_id}/takes", json=body)
    assert (made.status_code, made.json()["master_bytes"]) == (201, 2 << 30)
    found = checked(world, made.json()["id"])
    assert (found["state"], found["verdict"]) == ("returned", "unreadable")
    ranged = world.designer.get(f"/v1/takes/{made.json()['id']}/master", headers={"Range": "bytes=2147483640-"})
    assert (ranged.status_code, len(ranged.content)) == (206, 8)


def test_masters_are_given_back_byte_for_byte(world: World) -> None:
    take = deliver(world, "laser.wav", SOUND)
    whole = world.approver.get(f"/v1/takes/{take['id']}/master")
    assert (whole.status_code, whole.content) == (200, SOUND)
    assert whole.headers["content-type"] == "application/octet-stream"
    part = world.approver.get(f"/v1/takes/{take['id']}/master", headers={"Range": "bytes=10-19"})
    assert (part.status_code, part.content) == (206, SOUND[10:20])


@pytest.mark.slow
def test_who_sees_what(world: World) -> None:
    engage(world)
    take = deliver(world, "laser.wav", SOUND)
    paths = [
        f"/v1/deliveries/{take['delivery_id']}",
        f"/v1/takes/{take['id']}",
        f"/v1/takes/{take['id']}/master",
    ]
    for path in paths:
        statuses = {
            who: getattr(world, who).get(path).status_code
            for who in ("designer", "approver", "reviewer", "producer", "other_designer", "stranger", "nobody")
        }
        assert statuses == {
            "designer": 200, "approver": 200, "reviewer": 200, "producer": 200,
            "other_designer": 404, "stranger": 404, "nobody": 401,
        }  # fmt: skip
    for path in (f"/v1/projects/{world.project_id}/takes", f"/v1/projects/{world.project_id}/deliveries"):
        assert len(world.designer.get(path).json()["items"]) == 1
        assert len(world.reviewer.get(path).json()["items"]) == 1
        assert world.other_designer.get(path).json()["items"] == []
        assert world.stranger.get(path).status_code == 404
        assert world.nobody.get(path).status_code == 401


@pytest.mark.slow
def test_who_may_do_what(world: World) -> None:
    engage(world)
    [cue] = add_cues(world, {"name": "Laser fire"})
    take = deliver(world, "stray.wav", SOUND)
    delivery = f"/v1/deliveries/{take['delivery_id']}"
    body = {"upload_id": str(new_id()), "file_name": "laser.wav"}
    for who, status in (
        ("approver", 403),
        ("producer", 403),
        ("other_designer", 404),
        ("stranger", 404),
        ("nobody", 401),
    ):
        client = getattr(world, who)
        assert client.post(f"{delivery}/takes", json=body).status_code == status
        assert client.post(f"{delivery}/archives", json=body).status_code == status
        assert client.post(f"{delivery}/close").status_code == status
        assert client.patch(delivery, json={"note": "mine now"}).status_code == status
    for who, status in (("other_designer", 404), ("stranger", 404), ("nobody", 401)):
        answer = getattr(world, who).put(f"/v1/takes/{take['id']}/match", json={"cue_id": cue["id"]})
        assert answer.status_code == status
    for who, status in (("approver", 403), ("stranger", 404), ("nobody", 401)):
        opened = getattr(world, who).post(f"/v1/projects/{world.project_id}/deliveries", json={})
        assert opened.status_code == status


@pytest.mark.slow
def test_a_delivery_shows_what_came_in_it(world: World) -> None:
    delivery_id = open_delivery(world)
    takes = [deliver(world, f"{seed}.wav", another(seed), delivery_id=delivery_id) for seed in range(3)]
    changed = world.designer.patch(f"/v1/deliveries/{delivery_id}", json={"note": "the first three"})
    assert (changed.json()["note"], changed.json()["takes_count"]) == ("the first three", 3)
    shown = world.approver.get(f"/v1/deliveries/{delivery_id}").json()
    assert [take["id"] for take in shown["takes"]] == [take["id"] for take in takes]
    assert (shown["takes_count"], shown["note"], shown["archives"]) == (3, "the first three", [])


@pytest.mark.slow
def test_lists_come_in_pages(world: World) -> None:
    numbers = [int(world.designer.get(f"/v1/deliveries/{open_delivery(world)}").json()["number"]) for _ in range(5)]
    assert numbers == [1, 2, 3, 4, 5]
    path, cursor, seen = f"/v1/projects/{world.project_id}/deliveries", None, []
    while True:
        page = world.approver.get(path, params={"limit": 2} | ({"cursor": cursor} if cursor else {})).json()
        seen += [delivery["number"] for delivery in page["items"]]
        if (cursor := page["next"]) is None:
            break
    assert seen == [5, 4, 3, 2, 1]
    assert world.approver.get(path, params={"cursor": "rubbish"}).json()["code"] == "bad-cursor"


@pytest.mark.slow
def test_takes_are_found_by_state_and_cue(world: World) -> None:
    [laser] = add_cues(world, {"name": "Laser fire"})
    good = deliver(world, "laser_fire.wav", SOUND)
    stray = deliver(world, "stray.wav", another(1))
    bad = deliver(world, "other.wav", b"no sound")
    world.server.wait_for_jobs()
    path = f"/v1/projects/{world.project_id}/takes"
    found = {
        query: [take["id"] for take in world.approver.get(f"{path}?{query}").json()["items"]]
        for query in ("state=returned", f"cue_id={laser['id']}", "unmatched=false", "state=returned&state=conforming")
    }
    assert found["state=returned"] == [bad["id"], stray["id"]]
    assert found[f"cue_id={laser['id']}"] == found["unmatched=false"] == [good["id"]]
    assert len(found["state=returned&state=conforming"]) == 3
