"""Playlists: made of a filter or by hand, put in order, left where one stopped, shared with guests."""

from typing import Any
from uuid import UUID

import pytest
from httpx2 import Client

from app.deliveries.models import Take
from app.projects.models import Engagement
from app.projects.rules import EngagementKind
from tests.app.shares.making import approve, made, opened, sound
from tests.support.server import World


def add(world: World, client: Client | None = None, **body: Any) -> Any:
    wanted = {"name": "Combat", **body}
    return (client or world.producer).post(f"/v1/projects/{world.project_id}/playlists", json=wanted)


def playlist(world: World, *take_ids: str) -> dict[str, Any]:
    answer = add(world, take_ids=list(take_ids))
    assert answer.status_code == 201, answer.text
    return dict(answer.json())


def order(found: dict[str, Any]) -> list[str]:
    return [one["take_id"] for one in found["takes"]]


@pytest.mark.slow
def test_a_playlist_of_cues_has_the_version_that_is_heard_of_each_in_list_order(world: World) -> None:
    laser, first = sound(world)
    door, second = sound(world, "door")
    answer = add(world, cue_ids=[door, laser])
    assert answer.status_code == 201, answer.text
    made_list = answer.json()
    assert order(made_list) == [first, second]
    one = made_list["takes"][0]
    assert (one["cue_name"], one["cue_id"], one["variation"], one["state"]) == ("laser", laser, None, "conforming")
    assert world.producer.get(one["preview_url"]).status_code == 200
    assert made_list["may_share"] is True
    [brief] = world.reviewer.get(f"/v1/projects/{world.project_id}/playlists").json()
    assert (brief["name"], brief["takes"], brief["made_by"]["name"]) == ("Combat", 2, "Producer")


@pytest.mark.slow
def test_the_answer_says_who_may_approve(world: World) -> None:
    _, take_id = sound(world)
    url = f"/v1/playlists/{playlist(world, take_id)['id']}"
    may = {
        client: client.get(url).json()["takes"][0]["may_approve"]
        for client in (world.approver, world.reviewer, world.producer)
    }
    assert list(may.values()) == [True, False, False]


@pytest.mark.slow
def test_an_order_is_replaced_whole_and_two_editors_notice_each_other(world: World) -> None:
    takes = [sound(world, name)[1] for name in ("laser", "door", "steps")]
    found = playlist(world, *takes)
    url = f"/v1/playlists/{found['id']}"
    turned = world.approver.patch(url, json={"edition": 1, "take_ids": takes[::-1]})
    assert (order(turned.json()), turned.json()["edition"]) == (takes[::-1], 2)
    late = world.producer.patch(url, json={"edition": 1, "take_ids": takes})
    assert (late.status_code, late.json()["code"]) == (409, "playlist-changed")
    renamed = world.producer.patch(url, json={"edition": 2, "name": "Boss fight"}).json()
    assert (renamed["name"], order(renamed)) == ("Boss fight", takes[::-1])
    for wrong in ([takes[0], takes[0]], ["0197f8f0-0000-7000-8000-000000000000"]):
        refused = world.producer.patch(url, json={"edition": 3, "take_ids": wrong})
        assert (refused.status_code, refused.json()["code"]) == (422, "playlist-invalid")
    assert order(world.producer.get(url).json()) == takes[::-1]


@pytest.mark.slow
def test_each_person_goes_on_where_they_stopped(world: World) -> None:
    takes = [sound(world, name)[1] for name in ("laser", "door")]
    url = f"/v1/playlists/{playlist(world, *takes)['id']}"
    assert world.producer.get(url).json()["position"] is None
    for at_s in (0.2, 0.4):
        assert world.producer.put(f"{url}/position", json={"take_id": takes[1], "at_s": at_s}).status_code == 204
    assert world.producer.get(url).json()["position"] == {"take_id": takes[1], "at_s": 0.4}
    assert world.approver.get(url).json()["position"] is None
    _, elsewhere = sound(world, "steps")
    refused = world.producer.put(f"{url}/position", json={"take_id": elsewhere, "at_s": 0})
    assert refused.json()["code"] == "playlist-invalid"


@pytest.mark.slow
def test_only_who_acts_for_the_team_changes_one_and_no_stranger_sees_it(world: World) -> None:
    _, take_id = sound(world)
    url = f"/v1/playlists/{playlist(world, take_id)['id']}"
    assert world.reviewer.get(url).status_code == 200
    for client, of_project, status in (
        (world.reviewer, 403, 403), (world.designer, 403, 403), (world.stranger, 404, 404),
    ):  # fmt: skip
        assert add(world, client, take_ids=[take_id]).status_code == of_project
        assert client.patch(url, json={"edition": 1, "name": "x"}).status_code == status
        assert client.delete(url).status_code == status
    assert world.stranger.get(url).status_code == 404
    assert world.producer.delete(url).status_code == 204
    assert world.producer.get(url).status_code == 404
    assert world.producer.get(f"/v1/projects/{world.project_id}/playlists").json() == []


def of_another(world: World, name: str) -> str:
    """Put a cue on the list with a take of a second designer, who is engaged too; return the take's id."""
    take_id = UUID(sound(world, name)[1])

    def write(session: Any) -> None:
        of = {"studio_id": world.studio_id, "project_id": world.project_id}
        session.add(Engagement(**of, designer_id=world.other_designer_id, kind=EngagementKind.CONTRACT))
        session.get_one(Take, take_id).designer_id = world.other_designer_id

    world.server.in_database(write)
    return str(take_id)


def hear(world: World, choice: str) -> None:
    answer = world.producer.patch(f"/v1/projects/{world.project_id}", json={"designers_hear": choice})
    assert answer.status_code == 200, answer.text


@pytest.mark.slow
def test_a_designer_hears_of_a_playlist_with_a_sound_of_theirs_what_they_may_hear(world: World) -> None:
    (_, laser), (_, door) = sound(world), sound(world, "door")
    steps = of_another(world, "steps")
    found = playlist(world, laser, steps, door)
    url, listed = f"/v1/playlists/{found['id']}", f"/v1/projects/{world.project_id}/playlists"
    for choice, heard in (("own", [laser, door]), ("approved", [laser, door]), ("waiting", [laser, steps, door])):
        hear(world, choice)
        shown = world.designer.get(url).json()
        assert order(shown) == heard, choice
        assert [one["takes"] for one in world.designer.get(listed).json()] == [len(heard)]
        assert [world.designer.get(one["preview_url"]).status_code for one in shown["takes"]] == [200] * len(heard)
    assert (shown["may_share"], shown["may_join"], shown["takes"][0]["may_approve"]) == (False, False, False)
    approve(world, steps)
    hear(world, "approved")
    assert order(world.designer.get(url).json()) == [laser, steps, door]
    hear(world, "own")
    assert order(world.other_designer.get(url).json()) == [steps]
    assert world.reviewer.get(url).json()["may_join"] is True


@pytest.mark.slow
def test_the_team_sees_labels_and_a_designer_those_of_their_own(world: World) -> None:
    _, laser = sound(world)
    steps = of_another(world, "steps")
    hear(world, "waiting")
    for take_id, label in ((laser, "longer"), (steps, "wild")):
        answer = world.producer.put(f"/v1/takes/{take_id}/label", json={"label": label})
        assert answer.status_code == 200, answer.text
    url = f"/v1/playlists/{playlist(world, laser, steps)['id']}"

    def labels(client: Client) -> list[str | None]:
        return [one["label"] for one in client.get(url).json()["takes"]]

    assert labels(world.reviewer) == ["longer", "wild"]
    assert labels(world.designer) == ["longer", None]
    assert labels(world.other_designer) == [None, "wild"]


@pytest.mark.slow
def test_guests_see_no_labels(world: World) -> None:
    _, laser = sound(world)
    world.producer.put(f"/v1/takes/{laser}/label", json={"label": "longer"})
    _, secret = made(world, kind="playlist", playlist_id=playlist(world, laser)["id"])
    assert "longer" not in str(opened(world, secret)[1])


@pytest.mark.slow
def test_a_designer_without_a_sound_in_a_playlist_does_not_see_it(world: World) -> None:
    _, laser = sound(world)
    of_another(world, "steps")
    hear(world, "waiting")  # they would hear the sound itself
    url = f"/v1/playlists/{playlist(world, laser)['id']}"
    assert world.designer.get(url).status_code == 200
    for path in (url, f"{url}/live"):
        assert world.other_designer.get(path).json()["code"] == "playlist-not-found"
    assert world.other_designer.put(f"{url}/position", json={"take_id": laser, "at_s": 0}).status_code == 404
    assert world.other_designer.get(f"/v1/projects/{world.project_id}/playlists").json() == []


@pytest.mark.slow
def test_a_designer_only_hears_and_goes_on_where_they_stopped(world: World) -> None:
    _, laser = sound(world)
    steps = of_another(world, "steps")
    hear(world, "own")
    found = playlist(world, laser, steps)
    url = f"/v1/playlists/{found['id']}"
    assert world.designer.put(f"{url}/position", json={"take_id": laser, "at_s": 0.3}).status_code == 204
    assert world.designer.get(url).json()["position"] == {"take_id": laser, "at_s": 0.3}
    assert world.producer.get(url).json()["position"] is None
    unheard = world.designer.put(f"{url}/position", json={"take_id": steps, "at_s": 0})
    assert (unheard.status_code, unheard.json()["code"]) == (422, "playlist-invalid")
    for answer in (
        world.designer.patch(url, json={"edition": 1, "take_ids": [laser]}),
        world.designer.delete(url),
        world.designer.get(f"{url}/live"),
        world.designer.put(f"{url}/live/presence", json={}),
        world.designer.put(f"{url}/live/keys", json={"act": "take"}),
    ):
        assert (answer.status_code, answer.json()["code"]) == (403, "team-needed")
    assert order(world.producer.get(url).json()) == [laser, steps]


@pytest.mark.slow
def test_each_of_the_team_sees_what_they_have_not_heard_and_designers_nothing(world: World) -> None:
    takes = [sound(world, name)[1] for name in ("laser", "door")]
    url = f"/v1/playlists/{playlist(world, *takes)['id']}"

    def heard(client: Client) -> list[bool | None]:
        return [one["is_heard"] for one in client.get(url).json()["takes"]]

    recorded = world.approver.post(f"/v1/projects/{world.project_id}/heard-takes", json={"take_ids": takes[1:]})
    assert recorded.status_code == 204
    assert [heard(world.approver), heard(world.producer)] == [[False, True], [False, False]]
    assert heard(world.designer) == [None, None]


def test_versions_of_another_project_are_refused(world: World) -> None:
    _, foreign = sound(World(world.server))
    refused = add(world, take_ids=[foreign])
    assert (refused.status_code, refused.json()["code"]) == (422, "playlist-invalid")
    assert add(world).json()["code"] == "nothing-to-share"


@pytest.mark.slow
def test_a_playlist_is_shared_with_guests_in_its_order(world: World) -> None:
    takes = [sound(world, name)[1] for name in ("laser", "door")]
    found = playlist(world, *takes[::-1])
    _, secret = made(world, kind="playlist", playlist_id=found["id"])
    assert [one["name"] for one in opened(world, secret)[1]["sounds"]] == ["door", "laser"]
    world.producer.patch(f"/v1/playlists/{found['id']}", json={"edition": 1, "take_ids": takes})
    assert [one["name"] for one in opened(world, secret)[1]["sounds"]] == ["door", "laser"]
    elsewhere = World(world.server)
    refused = elsewhere.producer.post(
        f"/v1/projects/{elsewhere.project_id}/guest-links",
        json={"kind": "playlist", "title": "x", "playlist_id": found["id"]},
    )
    assert (refused.status_code, refused.json()["code"]) == (404, "playlist-not-found")
