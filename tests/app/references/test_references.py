"""The board: who puts what on it, pins, versions, and who sees it."""

import re
from collections.abc import Callable
from typing import Any

import pytest
from sqlalchemy.orm import Session

from app.accounts.quotas.service import QuotaKind, set_limit
from app.core import clock
from app.projects.models import Engagement, Project
from app.references import endpoints
from app.sound_lists.models import Cue
from tests.support.deliver import TUS, add_cues, metadata, open_delivery
from tests.support.references import add, added, begin_upload, board, opened, picture, uploaded
from tests.support.server import World
from tests.support.waves import sine, wav_bytes

WAV = wav_bytes(sine(hz=440, seconds=0.1), rate=48_000, bits=16)
LINK = "https://example.test/watch?v=1"


def change(world: World, reference: dict[str, Any], **body: Any) -> dict[str, Any]:
    answer = world.producer.patch(f"/v1/references/{reference['id']}", json=body)
    assert answer.status_code == 200, answer.text
    return dict(answer.json())


@pytest.mark.slow
def test_a_file_is_pinned_to_a_cue_with_caption_terms_and_range(world: World) -> None:
    [cue] = add_cues(world, {"name": "Splash", "category": "impact"})
    made = added(
        world, "splash.wav", WAV, cue_id=cue["id"], caption=" Like this, but deeper ", terms="Licensed original: may "
        "not be shipped", start_s=0.02, end_s=0.08,
    )  # fmt: skip
    assert (made["caption"], made["terms"]) == (
        "Like this, but deeper", "Licensed original: may not be shipped",
    )  # fmt: skip
    assert (made["start_s"], made["end_s"], made["category"], made["may_change"]) == (0.02, 0.08, None, True)
    assert made["cue"] == {"id": cue["id"], "number": 1, "name": "Splash"}
    version = made["version"]
    assert (version["kind"], version["media_type"], version["number"]) == ("audio", "audio/wav", 1)
    assert (version["file_name"], version["file_bytes"], version["preview"]) == ("splash.wav", len(WAV), "none")
    assert version["added_by"]["name"] == "Producer"
    [seen] = board(world, world.designer)
    assert seen == {**made, "may_change": False}
    answer = opened(world, made, by=world.designer)
    assert (answer.status_code, answer.content) == (200, WAV)


@pytest.mark.slow
def test_an_approver_adds_and_a_reviewer_only_looks(world: World) -> None:
    assert add(world, world.approver, url=LINK).status_code == 201
    for client in (world.reviewer, world.designer):
        refused = add(world, client, url=LINK)
        assert (refused.status_code, refused.json()["code"]) == (403, "team-needed")
        assert begin_upload(world, "a.wav", WAV, client).status_code == 403
    [reference] = board(world, world.reviewer)
    assert reference["may_change"] is False
    for client in (world.reviewer, world.designer):
        url = f"/v1/references/{reference['id']}"
        assert client.patch(url, json={"caption": "x"}).status_code == 403
        assert client.delete(url).status_code == 403
        assert client.post(f"{url}/versions", json={"url": LINK}).status_code == 403
    assert add(world, world.stranger, url=LINK).status_code == 404
    assert begin_upload(world, "a.wav", WAV, world.other_designer).status_code == 404


def test_a_link_is_kept_as_it_is_and_shown_by_its_host(world: World) -> None:
    made = add(world, url=LINK, caption="The walkway", start_s=41.2, end_s=43).json()
    version = made["version"]
    assert (version["kind"], version["file_name"], version["url"]) == ("link", "example.test", LINK)
    assert version["file_bytes"] is None
    assert opened(world, made).status_code == 404


@pytest.mark.parametrize(
    ("body", "where"),
    [
        ({}, "url"),
        ({"url": LINK, "upload_id": "0197f8f0-0000-7000-8000-000000000000"}, "url"),
        ({"url": "http://example.test"}, "url"),
        ({"url": LINK, "start_s": 3, "end_s": 2}, "end_s"),
        ({"url": LINK, "end_s": 2}, "start_s"),
        ({"url": LINK, "category": "weather"}, "category"),
    ],
)
def test_what_cannot_be_is_refused_by_its_field(world: World, body: dict[str, Any], where: str) -> None:
    refused = add(world, **body)
    assert (refused.status_code, refused.json()["code"]) == (422, "reference-invalid")
    assert [error["where"] for error in refused.json()["errors"]] == [where]
    assert board(world) == []


@pytest.mark.slow
def test_a_pin_is_one_cue_of_this_project_or_one_category_of_its_list(world: World) -> None:
    [cue] = add_cues(world, {"name": "Splash", "category": "impact"})
    assert add(world, url=LINK, cue_id=cue["id"], category="impact").status_code == 422
    elsewhere = World(world.server)
    [foreign] = add_cues(elsewhere, {"name": "Door"})
    refused = add(world, url=LINK, cue_id=foreign["id"])
    assert (refused.status_code, refused.json()["code"]) == (404, "cue-not-found")
    reference = add(world, url=LINK).json()
    assert change(world, reference, cue_id=cue["id"])["cue"]["name"] == "Splash"
    moved = change(world, reference, category="impact")
    assert (moved["cue"], moved["category"]) == (None, "impact")
    back = change(world, reference, cue_id=None, category=None)
    assert (back["cue"], back["category"]) == (None, None)


@pytest.mark.slow
def test_a_cue_shows_its_own_references_and_those_of_its_category(world: World) -> None:
    splash, door = add_cues(world, {"name": "Splash", "category": "impact"}, {"name": "Door"})
    own = add(world, url=LINK, cue_id=splash["id"]).json()
    of_category = add(world, url=LINK, category="impact").json()
    add(world, url=LINK)
    of_door = add(world, url=LINK, cue_id=door["id"]).json()
    ids = {reference["id"] for reference in board(world, world.designer, cue_id=splash["id"])}
    assert ids == {own["id"], of_category["id"]}
    assert [reference["id"] for reference in board(world, cue_id=door["id"])] == [of_door["id"]]
    assert len(board(world)) == 4


def test_changes_touch_only_what_is_sent(world: World) -> None:
    reference = add(world, url=LINK, caption="Old", terms="Not to be shipped", start_s=1, end_s=2).json()
    changed = change(world, reference, caption="New")
    assert (changed["caption"], changed["terms"], changed["start_s"]) == ("New", "Not to be shipped", 1)
    refused = world.producer.patch(f"/v1/references/{reference['id']}", json={"end_s": 0.5})
    assert refused.status_code == 422
    assert board(world)[0]["end_s"] == 2
    assert change(world, reference, start_s=None, end_s=None)["start_s"] is None


@pytest.mark.slow
def test_a_new_version_replaces_the_file_and_the_old_one_stays(world: World) -> None:
    first = added(world, "splash.wav", WAV, caption="Splash")
    text = b"A heavy tool falls into deep water."
    upload_id = uploaded(world, "splash.txt", text)
    answer = world.producer.post(f"/v1/references/{first['id']}/versions", json={"upload_id": upload_id})
    assert answer.status_code == 201, answer.text
    second = answer.json()
    assert (second["id"], second["caption"]) == (first["id"], "Splash")
    assert (second["version"]["number"], second["version"]["kind"]) == (2, "text")
    assert second["version"]["excerpt"] == text.decode()
    assert [one["version"]["number"] for one in board(world)] == [2]
    listed = world.designer.get(f"/v1/references/{first['id']}/versions").json()
    assert [version["number"] for version in listed] == [2, 1]
    assert listed[1] == first["version"]
    assert opened(world, first, by=world.designer).content == WAV
    assert opened(world, second, by=world.designer).content == text


def test_a_version_must_fit_the_range_that_is_named(world: World) -> None:
    reference = added(world, "splash.wav", WAV, start_s=0, end_s=0.05)
    upload_id = uploaded(world, "splash.png", picture("PNG"))
    refused = world.producer.post(f"/v1/references/{reference['id']}/versions", json={"upload_id": upload_id})
    assert refused.status_code == 422
    assert board(world)[0]["version"]["number"] == 1


@pytest.mark.slow
def test_what_is_removed_is_off_the_board_for_all(world: World) -> None:
    reference = added(world, "splash.wav", WAV)
    assert opened(world, reference, by=world.designer).status_code == 200
    assert world.approver.delete(f"/v1/references/{reference['id']}").status_code == 204
    assert board(world) == board(world, world.designer) == []
    for client in (world.producer, world.designer):
        version = f"/v1/reference-versions/{reference['version']['id']}"
        assert client.get(f"{version}/file").status_code == 404
        assert client.post(f"{version}/openings").status_code == 404
        assert client.get(f"/v1/references/{reference['id']}/versions").status_code == 404
    assert world.producer.delete(f"/v1/references/{reference['id']}").status_code == 404


def test_pages_follow_one_another(world: World, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(endpoints, "PAGE", 2)
    made = [add(world, url=f"https://example.test/{number}").json()["id"] for number in range(5)]
    found: list[str] = []
    cursor: str | None = ""
    while cursor is not None:
        query = {"cursor": cursor} if cursor else {}
        page = world.designer.get(f"/v1/projects/{world.project_id}/references", params=query).json()
        found += [one["id"] for one in page["items"]]
        cursor = page["next"]
    assert found == made[::-1]


def accept(world: World, at: Any) -> Callable[[Session], None]:
    def do(session: Session) -> None:
        session.get_one(Project, world.project_id).nda_needed = True
        engagement = session.query(Engagement).filter_by(designer_id=world.designer_id).one()
        engagement.nda_accepted_at, engagement.nda_sha256 = at, "0" * 64 if at else None

    return do


@pytest.mark.slow
def test_before_the_nda_a_designer_sees_none_of_it(world: World) -> None:
    reference = added(world, "splash.png", picture("PNG"), caption="The secret tank")
    world.server.wait_for_jobs()
    world.server.in_database(accept(world, None))
    version = f"/v1/reference-versions/{reference['version']['id']}"
    addresses = [
        f"/v1/projects/{world.project_id}/references",
        f"/v1/references/{reference['id']}/versions",
        *(f"{version}/{part}" for part in ("file", "view", "thumb")),
    ]
    answers = [world.designer.get(address) for address in addresses] + [world.designer.post(f"{version}/openings")]
    assert [(answer.status_code, answer.json()["code"]) for answer in answers] == [(403, "nda-needed")] * 6
    assert all(b"secret" not in answer.content for answer in answers)
    world.server.in_database(accept(world, clock.now()))
    assert board(world, world.designer)[0]["caption"] == "The secret tank"
    assert opened(world, reference, by=world.designer).status_code == 200


def test_an_upload_goes_to_one_place(world: World) -> None:
    both = begin_upload(world, "a.wav", WAV, delivery_id=open_delivery(world))
    assert (both.status_code, both.json()["code"]) == (400, "bad-upload-header")
    of_a_take = world.producer.post(
        f"/v1/projects/{world.project_id}/references",
        json={"upload_id": uploaded(World(world.server), "a.wav", WAV)},
    )
    assert (of_a_take.status_code, of_a_take.json()["code"]) == (404, "upload-not-found")


def test_an_upload_resumes_where_it_stopped(world: World) -> None:
    said = metadata(project_id=str(world.project_id), file_name="a.wav")
    begun = world.producer.post("/v1/uploads", headers={**TUS, "Upload-Length": str(len(WAV)), "Upload-Metadata": said})
    place = begun.headers["location"]
    body = {**TUS, "Content-Type": "application/offset+octet-stream"}
    half = len(WAV) // 2
    sent = world.producer.patch(place, headers={**body, "Upload-Offset": "0"}, content=WAV[:half])
    assert (sent.status_code, sent.headers["upload-offset"]) == (204, str(half))
    unfinished = add(world, upload_id=place.rpartition("/")[2])
    assert (unfinished.status_code, unfinished.json()["code"]) == (409, "upload-unfinished")
    assert world.producer.head(place, headers=TUS).headers["upload-offset"] == str(half)
    assert world.producer.patch(place, headers={**body, "Upload-Offset": str(half)}, content=WAV[half:]).is_success
    assert opened(world, add(world, upload_id=place.rpartition("/")[2]).json()).content == WAV


def test_an_empty_file_is_refused(world: World) -> None:
    refused = add(world, upload_id=uploaded(world, "empty.png", b""))
    assert (refused.status_code, refused.json()["errors"][0]["where"]) == (422, "upload_id")


def test_size_and_quota_are_refused_in_numbers_before_a_byte_is_stored(
    world: World, monkeypatch: pytest.MonkeyPatch
) -> None:
    said = metadata(project_id=str(world.project_id), file_name="walkthrough.mp4")
    headers = {**TUS, "Upload-Length": str(4 << 30), "Upload-Metadata": said}
    refused = world.producer.post("/v1/uploads", headers=headers)
    assert refused.status_code == 413
    assert re.search(r"4294967296 bytes.*may have 2147483648", refused.json()["detail"])
    monkeypatch.setattr(world.server.runtime.settings, "reference_max_bytes", len(WAV) - 1)
    assert begin_upload(world, "a.wav", WAV).status_code == 413
    monkeypatch.undo()
    added(world, "a.wav", WAV)
    limit = len(WAV) + 1
    world.server.in_database(lambda session: set_limit(session, world.studio_id, QuotaKind.REFERENCE_BYTES, limit))
    full = begin_upload(world, "b.wav", WAV)
    assert (full.status_code, full.json()["code"]) == (507, "storage-quota-reached")
    quotas = world.producer.get(f"/v1/studios/{world.studio_id}/quotas").json()
    [used] = [quota for quota in quotas if quota["kind"] == "reference_bytes"]
    assert (used["used"], used["limit"]) == (len(WAV), limit)


@pytest.mark.slow
def test_what_is_kept_is_counted_once(world: World) -> None:
    for name in ("a.png", "b.png"):
        added(world, name, picture("PNG"))
    world.server.wait_for_jobs()
    storage = world.producer.get(f"/v1/studios/{world.studio_id}/storage").json()
    [kept] = [one for one in storage["kept"] if one["kind"] == "references"]
    assert kept["files"] == 3  # the file, and two previews
    assert kept["size_bytes"] > len(picture("PNG"))


def test_a_cue_that_is_cut_keeps_its_references(world: World) -> None:
    [cue] = add_cues(world, {"name": "Splash"})
    add(world, url=LINK, cue_id=cue["id"])

    def cut(session: Session) -> None:
        row = session.query(Cue).filter_by(name="Splash", project_id=world.project_id).one()
        row.state, row.cut_at = "cut", clock.now()

    world.server.in_database(cut)
    assert board(world)[0]["cue"]["name"] == "Splash"


def test_a_reference_stands_for_words_seen_by_those_who_see_the_board(world: World) -> None:
    made = added(world, "warm.wav", WAV, caption="Tape, not tube", words=" Warm,  soft pad ,warm")
    assert made["words"] == "warm, soft pad"
    added(world, "other.wav", WAV)
    path = f"/v1/projects/{world.project_id}/references"
    for client in (world.producer, world.reviewer, world.designer):
        [shown] = client.get(path, params={"words": True}).json()["items"]
        assert (shown["id"], shown["words"], shown["caption"]) == (made["id"], "warm, soft pad", "Tape, not tube")
    assert world.stranger.get(path, params={"words": True}).status_code == 404
    assert change(world, made, words="crunchy")["words"] == "crunchy"
    assert change(world, made, words="")["words"] == ""
    assert world.producer.get(path, params={"words": True}).json()["items"] == []
