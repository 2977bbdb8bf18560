"""Sessions: one playhead for all, keys that one person holds, hands over, and loses ten seconds after they are gone."""

from datetime import timedelta
from typing import Any
from uuid import UUID, uuid4

import pytest
from httpx2 import Client

from app.core import clock
from app.core.changes import ChangedRooms
from app.shares.models import LiveListener
from tests.app.shares.making import sound
from tests.app.shares.test_playlists import playlist
from tests.support.server import World

pytestmark = pytest.mark.slow


class Live:
    """The session of a playlist of two sounds."""

    def __init__(self, world: World) -> None:
        self.world = world
        self.takes = [sound(world, name)[1] for name in ("laser", "door")]
        self.playlist_id = playlist(world, *self.takes)["id"]

    def put(self, client: Client, what: str, **body: Any) -> Any:
        return client.put(f"/v1/playlists/{self.playlist_id}/live/{what}", json=body)

    def join(self, *clients: Client) -> None:
        for client in clients:
            assert self.put(client, "presence").status_code == 200

    def read(self, client: Client) -> dict[str, Any]:
        return dict(client.get(f"/v1/playlists/{self.playlist_id}/live").json())

    def move(self, client: Client, **body: Any) -> Any:
        state = {"take_id": self.takes[0], "is_playing": True, "position_s": 0.0, **body}
        return self.put(client, "playhead", sequence=self.read(client)["sequence"], **state)

    def take_keys(self, client: Client) -> Any:
        return self.put(client, "keys", act="take")

    def silence(self, person_id: UUID, seconds: float) -> None:
        """Let a person's page have reported so long ago."""

        def write(session: Any) -> None:
            session.get_one(LiveListener, (UUID(self.playlist_id), person_id)).seen_at -= timedelta(seconds=seconds)

        self.world.server.in_database(write)


@pytest.fixture
def live(world: World) -> Live:
    return Live(world)


def test_all_hear_the_playhead_of_the_holder_and_late_joiners_catch_up(world: World, live: Live) -> None:
    live.join(world.producer, world.approver)
    assert live.take_keys(world.producer).json()["is_holder"] is True
    moved = live.move(world.producer, take_id=live.takes[1], position_s=0.25).json()
    at_ms = moved["server_ms"]
    live.join(world.reviewer)
    seen = live.read(world.reviewer)
    assert (seen["take_id"], seen["is_playing"], seen["is_holder"]) == (live.takes[1], True, False)
    assert seen["position_s"] == pytest.approx(0.25 + (seen["server_ms"] - at_ms) / 1000, abs=0.005)
    assert [one["name"] for one in seen["present"]] == ["Audio director", "Composer", "Producer"]
    assert seen["holder"]["name"] == "Producer"
    paused = live.move(world.producer, is_playing=False, position_s=0.5).json()
    assert (paused["position_s"], live.read(world.reviewer)["position_s"]) == (0.5, 0.5)


def test_who_starts_a_session_holds_its_keys(world: World, live: Live) -> None:
    live.join(world.producer, world.approver)
    assert live.read(world.producer)["is_holder"] is True
    assert live.read(world.approver)["holder"]["name"] == "Producer"
    assert live.move(world.producer).status_code == 200
    for client in (world.producer, world.approver):
        live.put(client, "presence", leaves=True)
    live.join(world.approver)
    again = live.read(world.approver)
    assert (again["is_holder"], again["take_id"], again["is_playing"]) == (True, None, False)


def test_who_comes_back_after_a_pause_takes_no_keys(world: World, live: Live) -> None:
    live.join(world.producer, world.approver)
    live.silence(world.producer_id, 11)
    live.silence(world.approver_id, 11)
    live.join(world.approver)  # the same page, which the browser had put to sleep
    assert live.read(world.approver)["holder"] is None
    live.join(world.producer)
    assert live.read(world.producer)["is_holder"] is True


def test_one_person_holds_the_keys_and_hands_them_over(world: World, live: Live) -> None:
    live.join(world.producer, world.approver)
    live.put(world.producer, "keys", act="drop")
    assert live.move(world.producer).json()["code"] == "control-taken"
    live.take_keys(world.producer)
    for refused in (
        live.take_keys(world.approver),
        live.move(world.approver),
        live.put(world.approver, "keys", act="drop"),
    ):
        assert (refused.status_code, refused.json()["code"]) == (409, "control-taken")
    absent = live.put(world.producer, "keys", act="give", person_id=str(world.designer_id))
    assert (absent.status_code, absent.json()["code"]) == (404, "listener-not-found")
    given = live.put(world.producer, "keys", act="give", person_id=str(world.approver_id)).json()
    assert (given["holder"]["name"], given["is_holder"]) == ("Audio director", False)
    assert live.move(world.producer).status_code == 409
    assert live.move(world.approver).status_code == 200
    assert live.put(world.approver, "keys", act="drop").json()["holder"] is None


def test_the_keys_fall_free_when_the_holder_is_gone_for_ten_seconds(world: World, live: Live) -> None:
    live.join(world.producer, world.approver)
    live.take_keys(world.producer)
    live.silence(world.producer_id, 9)
    assert live.take_keys(world.approver).status_code == 409
    live.silence(world.producer_id, 1.5)
    seen = live.read(world.approver)
    assert (seen["holder"], [one["name"] for one in seen["present"]]) == (None, ["Audio director"])
    assert live.take_keys(world.approver).json()["is_holder"] is True
    live.join(world.producer)
    assert live.move(world.producer).status_code == 409


def test_who_leaves_drops_the_keys_at_once(world: World, live: Live) -> None:
    live.join(world.producer, world.approver)
    live.take_keys(world.producer)
    left = live.put(world.producer, "presence", leaves=True).json()
    assert (left["holder"], [one["name"] for one in left["present"]]) == (None, ["Audio director"])


def test_a_move_after_another_is_refused(world: World, live: Live) -> None:
    live.join(world.producer)
    live.take_keys(world.producer)
    state = {"take_id": live.takes[0], "is_playing": True, "position_s": 0.0}
    sequence = live.read(world.producer)["sequence"]
    assert live.put(world.producer, "playhead", sequence=sequence, **state).status_code == 200
    late = live.put(world.producer, "playhead", sequence=sequence, **state)
    assert (late.status_code, late.json()["code"]) == (409, "playhead-moved")
    _, elsewhere = sound(world, "steps")
    assert live.move(world.producer, take_id=elsewhere).json()["code"] == "playlist-invalid"


def test_a_move_is_announced_to_open_pages_and_a_report_is_not(world: World, live: Live) -> None:
    def announced() -> int:
        def count(session: Any) -> int:
            rows = session.query(ChangedRooms).filter(ChangedRooms.project_id == world.project_id)
            return sum("shares" in row.rooms for row in rows)

        return int(world.server.in_database(count))

    live.join(world.producer)
    live.take_keys(world.producer)
    before = announced()
    live.join(world.producer)
    live.join(world.producer)
    assert announced() == before
    live.move(world.producer)
    assert announced() == before + 1


def test_designers_and_strangers_are_not_in_it(world: World, live: Live) -> None:
    for client, status in ((world.designer, 403), (world.stranger, 404)):  # the designer's sound is in it
        assert live.put(client, "presence").status_code == status
        assert client.get(f"/v1/playlists/{live.playlist_id}/live").status_code == status
    assert clock.now().timestamp() * 1000 - live.read(world.producer)["server_ms"] < 5_000


def on_page(live: Live, client: Client, page_id: UUID) -> dict[str, Any]:
    return dict(client.get(f"/v1/playlists/{live.playlist_id}/live", params={"page_id": str(page_id)}).json())


def test_one_of_two_pages_of_a_person_holds_the_keys_until_the_other_takes_them(world: World, live: Live) -> None:
    first, second = uuid4(), uuid4()
    live.put(world.producer, "presence", page_id=str(first))
    live.put(world.producer, "keys", act="take", page_id=str(first))
    joined = live.put(world.producer, "presence", page_id=str(second)).json()
    assert (joined["is_holder"], joined["is_elsewhere"], len(joined["present"])) == (False, True, 1)
    assert on_page(live, world.producer, first)["is_holder"] is True
    for refused in (
        live.move(world.producer, page_id=str(second)),
        live.put(world.producer, "keys", act="drop", page_id=str(second)),
    ):
        assert (refused.status_code, refused.json()["fix"]) == (409, "take control here first")
    assert live.move(world.producer, page_id=str(first)).status_code == 200

    taken = live.put(world.producer, "keys", act="take", page_id=str(second)).json()
    assert (taken["is_holder"], taken["is_elsewhere"], taken["is_playing"]) == (True, False, True)
    old = live.put(world.producer, "presence", page_id=str(first)).json()
    assert (old["is_holder"], old["is_elsewhere"], old["holder"]["name"]) == (False, True, "Producer")
    assert live.move(world.producer, page_id=str(first)).json()["code"] == "control-taken"
    assert live.move(world.producer, page_id=str(second)).status_code == 200


def test_a_page_that_does_not_play_leaves_without_the_keys(world: World, live: Live) -> None:
    first, second = uuid4(), uuid4()
    live.put(world.producer, "presence", page_id=str(first))
    live.put(world.producer, "keys", act="take", page_id=str(first))
    left = live.put(world.producer, "presence", page_id=str(second), leaves=True).json()
    assert left["holder"]["name"] == "Producer"
    live.put(world.producer, "presence", page_id=str(first), leaves=True)
    goes_on = live.put(world.producer, "presence", page_id=str(second)).json()
    assert (goes_on["is_holder"], goes_on["is_elsewhere"]) == (True, False), "it starts the session again"


def test_a_listener_goes_on_hearing_on_another_page(world: World, live: Live) -> None:
    first, second = uuid4(), uuid4()
    live.join(world.approver)
    live.take_keys(world.approver)
    live.put(world.producer, "presence", page_id=str(first))
    before = live.read(world.approver)["sequence"]
    heard = live.put(world.producer, "presence", page_id=str(second), takes_over=True).json()
    assert (heard["is_elsewhere"], heard["holder"]["name"]) == (False, "Audio director")
    assert heard["sequence"] > before  # so that the first page hears of it
    assert on_page(live, world.producer, first)["is_elsewhere"] is True
    live.silence(world.producer_id, 11)
    back = live.put(world.producer, "presence", page_id=str(first)).json()
    assert back["is_elsewhere"] is False
