"""Guest links: what they share, until when and how often, who heard what, and comments without an account."""

import io
import json
import wave
from datetime import timedelta
from uuid import UUID

import numpy as np
import pytest
from sqlalchemy.orm import Session

from app.accounts.rate_limits import GUEST_VISITS_FROM_NETWORK
from app.core import clock
from app.deliveries.models import Take
from app.renders.models import Picture
from app.shares.models import GuestLink
from audio_checks import true_peak_dbtp
from tests.app.accounts.test_limits import behind_proxy
from tests.app.renders.making import deliver_sound
from tests.app.shares.making import approve, links, made, make, open_link, opened, play, sound
from tests.support.server import World
from tests.support.waves import sine

GONE = "This link does not open anything any more."


def master_of(world: World, take_id: str) -> bytes:
    def read(session: Session) -> bytes:
        take = session.get_one(Take, UUID(take_id))
        return b"".join(world.server.runtime.store.stream(take.studio_id, take.master_sha256))

    return bytes(world.server.in_database(read))


def frames_of(content: bytes) -> np.ndarray:
    with wave.open(io.BytesIO(content)) as file:
        return np.frombuffer(file.readframes(file.getnframes()), "<i2")


@pytest.mark.slow
def test_a_guest_hears_the_preview_and_the_producer_sees_who_heard_what_how_often(world: World) -> None:
    cue_id, take_id = sound(world)
    link, secret = made(world, cue_ids=[cue_id])
    assert (link["state"], link["sounds"], link["openings"], link["plays"]) == ("open", 1, 0, 0)
    assert world.nobody.get(f"/v1/guest-access/{secret}").json() == {"needs_password": False}
    visit, room = opened(world, secret, "  Ada\nLovelace ")
    assert (room["title"], room["guest_name"], room["may_comment"]) == ("For the composer", "Ada Lovelace", False)
    [one] = room["sounds"]
    assert (one["place"], one["name"], one["variation"], one["is_ready"]) == (1, "laser", None, True)
    assert "Designer" not in str(room)
    assert play(world, visit).status_code == 200
    heard = play(world, visit)
    assert heard.headers["content-type"] == "audio/wav"
    assert "no-cache" in heard.headers["cache-control"]
    assert heard.content != master_of(world, take_id)
    opened(world, secret, "Ben")
    [seen] = links(world)
    assert (seen["openings"], seen["plays"]) == (2, 2)
    ben, ada = world.producer.get(f"/v1/guest-links/{link['id']}/visits").json()["items"]
    assert (ben["guest_name"], ben["played"]) == ("Ben", [])
    assert (ada["guest_name"], ada["played"][0]["cue_name"], ada["played"][0]["plays"]) == ("Ada Lovelace", "laser", 2)


@pytest.mark.slow
def test_what_plays_itself_is_copied_for_guests_without_its_metadata(world: World) -> None:
    cue_id, take_id = sound(world, bits=16)

    def plays_itself(session: Session) -> bool:
        take = session.get_one(Take, UUID(take_id))
        picture = session.query(Picture).filter_by(sound_sha256=take.master_sha256).one()
        return bool(picture.preview_sha256 == take.master_sha256)

    assert world.server.in_database(plays_itself)
    _, secret = made(world, cue_ids=[cue_id])
    visit, _ = opened(world, secret)
    heard, master = play(world, visit).content, master_of(world, take_id)
    assert heard[:4] == b"RIFF"
    assert np.array_equal(frames_of(heard), frames_of(master))
    assert len(heard) == 44 + 2 * len(frames_of(master))  # the header and the frames: nothing else


@pytest.mark.slow
def test_beeps_are_mixed_in_for_the_link_that_wants_them_alone(world: World) -> None:
    cue_id, _ = sound(world)
    (_, plain), (link, beeped) = made(world, cue_ids=[cue_id]), made(world, cue_ids=[cue_id], has_beeps=True)
    assert link["has_beeps"] is True
    without = frames_of(play(world, opened(world, plain)[0]).content)
    with_beeps = frames_of(play(world, opened(world, beeped)[0]).content)
    assert len(without) == len(with_beeps)
    assert not np.array_equal(without, with_beeps)
    assert true_peak_dbtp(with_beeps[:, np.newaxis] / 32_768, 48_000) <= -1.0


@pytest.mark.slow
def test_a_link_opens_as_often_as_it_may_and_a_visit_goes_on(world: World) -> None:
    cue_id, _ = sound(world)
    _, secret = made(world, cue_ids=[cue_id], max_openings=1)
    visit, _ = opened(world, secret)
    refused = open_link(world, secret)
    assert (refused.status_code, refused.json()["detail"]) == (404, GONE)
    assert play(world, visit).status_code == 200
    assert links(world)[0]["state"] == "full"
    more = world.producer.patch(f"/v1/guest-links/{links(world)[0]['id']}", json={"max_openings": 2})
    assert (more.json()["state"], more.json()["may_comment"]) == ("open", False)
    opened(world, secret)


@pytest.mark.slow
def test_unknown_expired_full_and_revoked_links_are_answered_alike(world: World) -> None:
    cue_id, _ = sound(world)
    link, secret = made(world, cue_ids=[cue_id])
    visit, _ = opened(world, secret)
    revoked = world.producer.post(f"/v1/guest-links/{link['id']}/revoke").json()
    assert revoked["state"] == "revoked"
    _, old = made(world, cue_ids=[cue_id], expires_at=(clock.now() + timedelta(days=1)).isoformat())
    old_visit, _ = opened(world, old)

    def expire(session: Session) -> None:
        for one in session.query(GuestLink).filter(GuestLink.expires_at.is_not(None)):
            one.expires_at = clock.now() - timedelta(seconds=1)

    world.server.in_database(expire)
    answers = []
    for gone in (secret, old, "unknown", "%ED%A0%80", "x" * 5_000):
        answers += [world.nobody.get(f"/v1/guest-access/{gone}"), open_link(world, gone)]
    for gone in (visit, old_visit, "unknown", secret):
        answers += [
            world.nobody.get(f"/v1/guest-visits/{gone}"),
            play(world, gone),
            world.nobody.get(f"/v1/guest-visits/{gone}/sounds/1/preview"),
            world.nobody.post(f"/v1/guest-visits/{gone}/sounds/1/comments", json={"text": "x"}),
        ]
    assert {(answer.status_code, answer.json()["detail"]) for answer in answers} == {(404, GONE)}


@pytest.mark.slow
def test_the_password_opens_it_and_guesses_are_limited_by_network(world: World) -> None:
    cue_id, _ = sound(world)
    link, secret = made(world, cue_ids=[cue_id], password="four unrelated words")
    assert link["has_password"] is True
    assert "four" not in str(link)
    assert world.nobody.get(f"/v1/guest-access/{secret}").json() == {"needs_password": True}
    statuses = [open_link(world, secret, password=f"guess {at}").status_code for at in range(11)]
    assert statuses == [403] * 10 + [429]
    elsewhere = behind_proxy(world.server, "198.51.100.77")  # who guesses shuts nobody else out
    body = {"guest_name": "Ada", "password": "four unrelated words"}
    assert elsewhere.post(f"/v1/guest-access/{secret}/visits", json=body).status_code == 201
    world.server.forget_tries()
    refused = open_link(world, secret)
    assert (refused.status_code, refused.json()["code"]) == (403, "guest-password-wrong")
    opened(world, secret, password="four unrelated words")
    assert links(world)[0]["openings"] == 2

    def stored(session: Session) -> str:
        return str(session.get_one(GuestLink, UUID(link["id"])).password_hash)

    assert world.server.in_database(stored).startswith("$argon2id$")


@pytest.mark.slow
def test_the_address_is_shown_again_to_its_maker_alone(world: World) -> None:
    cue_id, _ = sound(world)
    link, secret = made(world, cue_ids=[cue_id])
    url = f"/v1/guest-links/{link['id']}/address"
    assert world.producer.get(url).json()["url"].endswith(f"/listen/{secret}")
    assert world.approver.get(url).status_code == 404

    def in_the_database(session: Session) -> bool:
        row = session.get_one(GuestLink, UUID(link["id"]))
        return secret in str(vars(row))

    assert not world.server.in_database(in_the_database)


@pytest.mark.slow
def test_comments_arrive_on_the_version_as_from_a_guest_and_the_designer_reads_them(world: World) -> None:
    cue_id, take_id = sound(world)
    _, secret = made(world, cue_ids=[cue_id], may_comment=True)
    visit, room = opened(world, secret)
    assert room["may_comment"] is True
    url = f"/v1/guest-visits/{visit}/sounds/1/comments"
    said = world.nobody.post(url, json={"text": "Too bright", "start_s": 0.2})
    assert (said.status_code, said.json()["text"]) == (201, "Too bright")
    assert world.nobody.post(url, json={"text": "Too long", "start_s": 2}).json()["code"] == "range-invalid"
    for client in (world.designer, world.reviewer):
        [comment] = client.get(f"/v1/takes/{take_id}/comments").json()
        assert comment["author"] == {"id": None, "name": "guest Ada", "picture": None}
        assert (comment["text"], comment["start_s"], comment["decides"]) == ("Too bright", 0.2, False)
    history = world.designer.get(f"/v1/takes/{take_id}/history").json()
    assert history[-1]["text"] == "guest Ada: Too bright"
    [shown] = world.approver.get(f"/v1/cues/{cue_id}/review").json()["comments"]
    answer = world.designer.post(f"/v1/takes/{take_id}/comments", json={"text": "Which?", "reply_to_id": shown["id"]})
    assert answer.status_code == 201
    assert world.reviewer.post(f"/v1/comments/{shown['id']}/resolve").status_code == 200


@pytest.mark.slow
def test_a_link_for_listening_takes_no_comments(world: World) -> None:
    cue_id, take_id = sound(world)
    _, secret = made(world, cue_ids=[cue_id])
    visit, _ = opened(world, secret)
    refused = world.nobody.post(f"/v1/guest-visits/{visit}/sounds/1/comments", json={"text": "x"})
    assert (refused.status_code, refused.json()["code"]) == (403, "comments-closed")
    assert world.designer.get(f"/v1/takes/{take_id}/comments").json() == []


@pytest.mark.slow
def test_a_guest_reaches_the_sounds_of_their_link_and_no_other(world: World) -> None:
    shared, _ = sound(world)
    other, other_take = sound(world, "door")
    _, secret = made(world, cue_ids=[shared])
    _, other_secret = made(world, cue_ids=[shared, other])
    visit, _ = opened(world, secret)
    assert play(world, visit, 2).status_code == 404
    assert play(world, opened(world, other_secret)[0], 2).status_code == 200
    for place in ("0", "-1", "501", "999999999999999999999", "x", other_take):
        answer = world.nobody.post(f"/v1/guest-visits/{visit}/sounds/{place}/plays")
        assert answer.status_code in (404, 422), place
    for path in (f"/v1/takes/{other_take}/sounds", f"/v1/takes/{other_take}/comments", f"/v1/cues/{shared}/review"):
        assert world.nobody.get(path).status_code == 401
        assert world.nobody.get(path, headers={"Authorization": f"Bearer {visit}"}).status_code == 401


@pytest.mark.slow
def test_nothing_is_sent_before_its_playing_is_on_record(world: World) -> None:
    cue_id, _ = sound(world)
    _, secret = made(world, cue_ids=[cue_id])
    visit, _ = opened(world, secret)
    preview = f"/v1/guest-visits/{visit}/sounds/1/preview"
    assert (world.nobody.get(preview).status_code, links(world)[0]["plays"]) == (409, 0)
    whole = play(world, visit).content
    for asked, status, part in (
        ("bytes=0-9", 206, whole[:10]),
        ("bytes=-5", 206, whole[-5:]),
        (f"bytes={len(whole)}-", 416, b""),
        ("bytes=9-2", 200, whole),
        ("bytes=0-99999999999999999999999", 200, whole),
    ):
        answer = world.nobody.get(preview, headers={"Range": asked})
        assert (answer.status_code, answer.content) == (status, part), asked


@pytest.mark.slow
def test_the_list_stays_as_it_was_when_the_link_was_made(world: World) -> None:
    cue_id, _ = sound(world)
    _, secret = made(world, cue_ids=[cue_id])
    before = play(world, opened(world, secret)[0]).content
    sound(world, "door")
    deliver_sound(world, "laser.wav", sine(hz=880, dbfs=-12, rate=48_000, seconds=0.5), rate=48_000)
    visit, room = opened(world, secret)
    assert len(room["sounds"]) == 1
    assert play(world, visit).content == before


@pytest.mark.slow
def test_palette_and_approved_sounds_are_those_that_were_approved(world: World) -> None:
    waiting, _ = sound(world, "waiting", palette=True)
    _, picked = sound(world, "picked", palette=True)
    _, plain = sound(world, "plain")
    assert make(world, kind="palette").json()["code"] == "nothing-to-share"
    for take_id in (picked, plain):
        approve(world, take_id)
    for kind, names in (("palette", ["picked"]), ("approved", ["picked", "plain"])):
        _, secret = made(world, kind=kind)
        assert [one["name"] for one in opened(world, secret)[1]["sounds"]] == names
    _, secret = made(world, cue_ids=[waiting])
    assert [one["name"] for one in opened(world, secret)[1]["sounds"]] == ["waiting"]


@pytest.mark.slow
def test_who_acts_for_the_team_makes_links_and_no_one_else(world: World) -> None:
    cue_id, _ = sound(world)
    assert make(world, world.approver, cue_ids=[cue_id]).status_code == 201
    for client in (world.reviewer, world.designer):
        assert make(world, client, cue_ids=[cue_id]).status_code == 403
    for client in (world.stranger, world.other_designer):
        assert make(world, client, cue_ids=[cue_id]).status_code == 404
    [link] = links(world)
    for client, status in ((world.designer, 404), (world.reviewer, 403), (world.stranger, 404)):
        assert client.get(f"/v1/guest-links/{link['id']}/visits").status_code == status
        assert client.post(f"/v1/guest-links/{link['id']}/revoke").status_code == status
        assert client.patch(f"/v1/guest-links/{link['id']}", json={"may_comment": True}).status_code == status


@pytest.mark.slow
def test_cues_of_another_project_are_not_shared(world: World) -> None:
    elsewhere = World(world.server)
    foreign, _ = sound(elsewhere)
    refused = make(world, cue_ids=[foreign])
    assert (refused.status_code, refused.json()["code"]) == (409, "nothing-to-share")


@pytest.mark.parametrize(
    ("body", "where"),
    [
        ({"cue_ids": []}, "cue_ids"),
        ({"kind": "playlist"}, "playlist_id"),
        ({"cue_ids": ["0197f8f0-0000-7000-8000-000000000000"], "expires_at": "2020-01-01T00:00:00Z"}, "expires_at"),
    ],
)
def test_what_cannot_be_is_refused_by_its_field(world: World, body: dict[str, object], where: str) -> None:
    refused = make(world, **body)
    assert (refused.status_code, refused.json()["code"]) == (422, "guest-link-invalid")
    assert [error["where"] for error in refused.json()["errors"]] == [where]


@pytest.mark.parametrize("password", ["x", "sesame", "1234567890", "For the composer"])
def test_a_password_that_is_easily_guessed_protects_no_link(world: World, password: str) -> None:
    cue_ids = ["0197f8f0-0000-7000-8000-000000000000"]
    refused = make(world, cue_ids=cue_ids, password=password)  # its title is "For the composer"
    assert (refused.status_code, refused.json()["code"]) == (422, "password-too-weak")
    assert [error["where"] for error in refused.json()["errors"]] == ["password"]


@pytest.mark.slow
def test_visits_from_one_place_are_limited_and_other_places_go_on(world: World) -> None:
    world.server.forget_tries()
    limit = GUEST_VISITS_FROM_NETWORK
    path = "/v1/guest-access/unknown/visits"
    statuses = {world.nobody.post(path, json={"guest_name": "Ada"}).status_code for _ in range(limit.burst)}
    assert statuses == {404}
    answer = world.nobody.post(path, json={"guest_name": "Ada"})
    assert (answer.status_code, int(answer.headers["Retry-After"]) <= limit.interval_s) == (429, True)
    elsewhere = behind_proxy(world.server, "198.51.100.78")
    assert elsewhere.post(path, json={"guest_name": "Ada"}).status_code == 404
    world.server.forget_tries()


@pytest.mark.slow
@pytest.mark.parametrize(
    "body",
    [
        {"guest_name": ""},
        {"guest_name": "x" * 81},
        {"guest_name": "a\0b"},
        {"guest_name": "\ud800"},
        {"guest_name": ["Ada"]},
        {},
    ],
)
def test_a_name_that_is_none_opens_nothing(world: World, body: dict[str, object]) -> None:
    cue_id, _ = sound(world)
    _, secret = made(world, cue_ids=[cue_id])
    answer = world.nobody.post(
        f"/v1/guest-access/{secret}/visits", content=json.dumps(body), headers={"Content-Type": "application/json"}
    )
    assert answer.status_code in (400, 422)
    assert links(world)[0]["openings"] == 0
