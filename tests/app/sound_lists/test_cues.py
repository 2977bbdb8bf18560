"""Typed rows, changes, names that cues own, order, flags, and who may."""

from uuid import UUID, uuid4

import pytest
import sqlalchemy as sa
from httpx2 import Client

import audio_checks
from app.core import events
from app.sound_lists import save_edits, service
from tests.app.sound_lists.lists import add, cut, page_of, the_list
from tests.support.server import World


def test_cues_are_numbered_and_own_their_names(world: World) -> None:
    laser, confirm = add(
        world,
        {"name": "Laser fire", "variations": 3, "duration_s": 0.8, "category": "Weapon"},
        {"name": "UI confirm", "file_name": "ui_confirm.wav"},
    )
    assert (laser["label"], confirm["label"]) == ("SW-001", "SW-002")
    assert laser["stems"] == ["laser_fire_01", "laser_fire_02", "laser_fire_03"]
    assert confirm["stems"] == ["ui_confirm"]
    assert laser["category"] == "weapon"
    listed = the_list(world)
    assert listed["revision"] == 1
    assert [cue["label"] for cue in listed["cues"]] == ["SW-001", "SW-002"]


def test_a_cue_without_a_name_is_called_after_its_file(world: World) -> None:
    (cue,) = add(world, {"file_name": "dock_clamp.wav"})
    assert cue["name"] == "dock_clamp"


@pytest.mark.parametrize(
    ("row", "field"),
    [
        ({}, "name"),
        ({"name": "!!!"}, "file_name"),
        ({"name": "x" * 201}, "name"),
        ({"name": "a", "file_name": "sfx/a.wav"}, "file_name"),
        ({"name": "a", "file_name": "..\\a.wav"}, "file_name"),
        ({"name": "a", "file_name": "=cmd.wav"}, "file_name"),
        ({"name": "a", "file_name": "CON.wav"}, "file_name"),
        ({"name": "a", "category": "sci fi!"}, "category"),
        ({"name": "a", "variations": 0}, "variations"),
        ({"name": "a", "variations": 100}, "variations"),
        ({"name": "a", "duration_s": 0}, "duration_s"),
        ({"name": "a", "duration_s": 1e9}, "duration_s"),
        ({"name": "a", "frame_rate_fps": -1}, "frame_rate_fps"),
        ({"name": "a", "playback_priority": 1001}, "playback_priority"),
        ({"name": "a", "description": "x" * 10_001}, "description"),
        ({"name": "a", "extra": {"Mood": "x" * 2001}}, "Mood"),
    ],
)
def test_a_wrong_row_is_named_and_nothing_is_saved(world: World, row: dict[str, object], field: str) -> None:
    answer = world.producer.post(
        f"/v1/projects/{world.project_id}/cues", json={"cues": [{"name": "Fine"}, {"name": "Also"}, row]}
    )
    assert answer.status_code == 422
    problem = answer.json()
    assert problem["code"] == "rows-invalid"
    assert problem["errors"][0]["where"] == f"row 3: {field}"
    assert the_list(world) == {"revision": 0, "cues": []}


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ({"name": "Laser"}, {"name": "laser"}),  # the same slug
        ({"name": "a", "file_name": "Laser_A"}, {"name": "b", "file_name": "laser_a"}),  # capitals only
        ({"name": "a", "file_name": "caf\u00e9"}, {"name": "b", "file_name": "cafe\u0301"}),  # composition only
        ({"name": "a", "file_name": "hit", "variations": 2}, {"name": "b", "file_name": "hit_02"}),
    ],
)
def test_two_cues_cannot_own_one_name(world: World, first: dict[str, object], second: dict[str, object]) -> None:
    url = f"/v1/projects/{world.project_id}/cues"
    together = world.producer.post(url, json={"cues": [first, second]})
    assert together.status_code == 422
    assert "row 1" in together.json()["errors"][0]["message"]
    add(world, first)
    later = world.producer.post(url, json={"cues": [second]})
    assert later.status_code == 422
    assert "SW-001" in later.json()["errors"][0]["message"]


def test_the_database_refuses_twins_by_itself(world: World) -> None:
    one, two = add(world, {"name": "One"}, {"name": "Two"})
    twin = sa.text("update sound_lists_stems set stem = 'ONE', folded = 'one' where cue_id = :cue")
    with pytest.raises(sa.exc.IntegrityError):
        world.server.in_database(lambda session: session.execute(twin, {"cue": UUID(str(two["id"])).hex}))
    assert one["stems"] == ["one"]


def test_changing_a_cue_renames_its_files_and_keeps_a_revision(world: World) -> None:
    (cue,) = add(world, {"name": "Door", "variations": 2})
    answer = world.approver.patch(f"/v1/cues/{cue['id']}", json={"edition": 1, "name": "Airlock", "variations": 3})
    assert answer.status_code == 200, answer.text
    assert answer.json()["stems"] == ["airlock_01", "airlock_02", "airlock_03"]
    assert answer.json()["edition"] == 2
    compared = world.designer.get(
        f"/v1/projects/{world.project_id}/sound-list/revisions/compare", params={"from": 1, "to": 2}
    ).json()
    assert compared["added"] == []
    (changed,) = compared["changed"]
    assert {(one["field"], one["before"], one["after"]) for one in changed["changes"]} == {
        ("name", "Door", "Airlock"),
        ("variations", 2, 3),
    }


def test_two_editors_notice_each_other(world: World) -> None:
    (cue,) = add(world, {"name": "Door"})
    url = f"/v1/cues/{cue['id']}"
    assert world.producer.patch(url, json={"edition": 1, "use": "level 1"}).status_code == 200
    stale = world.approver.patch(url, json={"edition": 1, "use": "level 2"})
    assert stale.status_code == 409
    assert stale.json()["code"] == "cue-changed"
    assert world.producer.get(url).json()["use"] == "level 1"


@pytest.mark.slow
def test_a_change_that_changes_nothing_is_no_revision(world: World) -> None:
    (cue,) = add(world, {"name": "Door", "duration_s": 1.5})
    answer = world.producer.patch(f"/v1/cues/{cue['id']}", json={"edition": 1, "duration_s": 1.5})
    assert answer.json()["edition"] == 1
    assert the_list(world)["revision"] == 1


@pytest.mark.slow
def test_names_can_be_swapped_in_two_steps_and_are_free_after_a_rename(world: World) -> None:
    one, two = add(world, {"name": "One"}, {"name": "Two"})
    taken = world.producer.patch(f"/v1/cues/{one['id']}", json={"edition": 1, "name": "Two"})
    assert taken.status_code == 422
    assert taken.json()["errors"][0]["where"] == "name"
    assert world.producer.patch(f"/v1/cues/{two['id']}", json={"edition": 1, "name": "Three"}).status_code == 200
    assert world.producer.patch(f"/v1/cues/{one['id']}", json={"edition": 1, "name": "Two"}).status_code == 200


@pytest.mark.slow
def test_events_say_what_changed(world: World, monkeypatch: pytest.MonkeyPatch) -> None:
    reported: list[tuple[str, dict[str, object]]] = []

    def publish(session: sa.orm.Session, event: str, **facts: object) -> object:
        reported.append((event, facts))
        return events.publish(session, event, **facts)

    monkeypatch.setattr(save_edits, "publish", publish)
    (cue,) = add(world, {"name": "Door"})
    studio = {"studio_id": world.studio_id, "project_id": world.project_id}
    whole = {**studio, "actor_id": world.producer_id}
    assert reported == [("list.revised", {**whole, "revision": 1, "added": 1, "changed": 0, "cut": 0})]
    url = f"/v1/cues/{cue['id']}"
    world.producer.patch(url, json={"edition": 1, "description": "a heavy door"})  # which no check reads
    assert [event for event, _ in reported] == ["list.revised"] * 2
    world.producer.patch(url, json={"edition": 2, "duration_s": 2.0})
    assert reported[2:] == [
        ("cue.changed", {**studio, "person_id": world.producer_id, "cue_ids": [cue["id"]]}),
        ("list.revised", {**whole, "revision": 3, "added": 0, "changed": 1, "cut": 0}),
    ]


@pytest.mark.slow
def test_the_list_comes_in_pages_in_its_own_order(world: World) -> None:
    names = [cue["name"] for cue in add(world, *({"name": f"Sound {place}"} for place in range(7)))]
    ids = [cue["id"] for cue in the_list(world)["cues"]]
    moved = [ids[6], *ids[:6]]
    answer = world.producer.post(f"/v1/projects/{world.project_id}/cues/order", json={"cue_ids": moved})
    assert answer.status_code == 204
    pages, cursor = [], None
    while not pages or cursor:
        page = page_of(world, limit=3, cursor=cursor)
        pages.append([cue["name"] for cue in page["cues"]])
        cursor = page["next"]
    assert pages == [[names[6], *names[:2]], names[2:5], names[5:6]]


def test_the_list_comes_by_playback_priority_too(world: World) -> None:
    priorities = [None, 7, 0, None, 7]
    add(world, *({"name": f"S{place}", "playback_priority": value} for place, value in enumerate(priorities)))
    pages, cursor = [], None
    while not pages or cursor:
        page = page_of(world, limit=2, cursor=cursor, order="playback_priority")
        pages.append([cue["name"] for cue in page["cues"]])
        cursor = page["next"]
    assert pages == [["S2", "S1"], ["S4", "S0"], ["S3"]]


def test_a_page_that_just_fits_is_the_last(world: World) -> None:
    add(world, {"name": "A"}, {"name": "B"}, {"name": "C"})
    assert page_of(world, limit=3)["next"] is None


NO_PAGES = [
    {"limit": 0},
    {"limit": 501},
    *({"cursor": cursor} for cursor in ("here", "1", "-1.2", "1." + "9" * 40, "1.2.3")),
]


@pytest.mark.parametrize("query", NO_PAGES)
def test_a_page_that_cannot_be_is_refused(world: World, query: dict[str, object]) -> None:
    for path in ("sound-list", "sound-list/progress"):
        assert world.producer.get(f"/v1/projects/{world.project_id}/{path}", params=query).status_code == 422


def test_order(world: World) -> None:
    cues = add(world, {"name": "A"}, {"name": "B"}, {"name": "C"}, {"name": "D"})
    a, b, c, d = (cue["id"] for cue in cues)
    url = f"/v1/projects/{world.project_id}/cues/order"
    assert world.producer.post(url, json={"cue_ids": [d, b]}).status_code == 204
    assert [cue["id"] for cue in the_list(world)["cues"]] == [a, d, c, b]
    assert world.producer.post(url, json={"cue_ids": [a, a]}).status_code == 422
    assert world.producer.post(url, json={"cue_ids": [str(uuid4())]}).status_code == 422


def test_flags(world: World) -> None:
    (cue,) = add(world, {"name": "Alarm"})
    assert world.producer.put(f"/v1/cues/{cue['id']}/placeholder", json={"placeholder": True}).json()["placeholder"]
    assert world.producer.put(f"/v1/cues/{cue['id']}/palette", json={"palette": True}).json()["palette"]


def test_a_cut_cue_keeps_its_reason_and_frees_its_name(world: World) -> None:
    (cue,) = add(world, {"name": "Mine arm"})
    cut(world, cue["id"], "mines are gone")
    kept = world.designer.get(f"/v1/cues/{cue['id']}").json()
    assert (kept["state"], kept["cut_reason"], kept["stems"]) == ("cut", "mines are gone", [])
    refused = world.producer.patch(f"/v1/cues/{cue['id']}", json={"edition": kept["edition"], "use": "x"})
    assert refused.status_code == 409
    assert refused.json()["code"] == "cue-is-cut"
    add(world, {"name": "Mine arm"})
    compared = world.producer.get(
        f"/v1/projects/{world.project_id}/sound-list/revisions/compare", params={"from": 1, "to": 3}
    ).json()
    assert [one["label"] for one in compared["cut"]] == ["SW-001"]
    assert compared["cut"][0]["cut_reason"] == "mines are gone"
    assert [one["label"] for one in compared["added"]] == ["SW-002"]


@pytest.mark.slow
def test_changed_and_changed_back_is_no_difference(world: World) -> None:
    (cue,) = add(world, {"name": "Door", "use": "hall"})
    url = f"/v1/cues/{cue['id']}"
    world.producer.patch(url, json={"edition": 1, "use": "bridge"})
    world.producer.patch(url, json={"edition": 2, "use": "hall"})
    compare = f"/v1/projects/{world.project_id}/sound-list/revisions/compare"
    compared = world.producer.get(compare, params={"from": 1, "to": 3}).json()
    assert (compared["added"], compared["changed"], compared["cut"]) == ([], [], [])
    from_nothing = world.producer.get(compare, params={"from": 0, "to": 3}).json()
    assert [one["name"] for one in from_nothing["added"]] == ["Door"]
    assert world.producer.get(compare, params={"from": 0, "to": 4}).status_code == 404
    assert world.producer.get(compare, params={"from": 3, "to": 1}).status_code == 404


@pytest.mark.slow
def test_revisions_are_paged_newest_first(world: World) -> None:
    for number in range(52):
        add(world, {"name": f"Cue {number}"})
    url = f"/v1/projects/{world.project_id}/sound-list/revisions"
    first = world.designer.get(url).json()
    assert [one["number"] for one in first["items"]] == list(range(52, 2, -1))
    assert first["items"][0]["summary"] == "1 cue added"
    assert first["items"][0]["author"]["name"] == "Producer"
    rest = world.designer.get(url, params={"cursor": first["next"]}).json()
    assert ([one["number"] for one in rest["items"]], rest["next"]) == ([2, 1], None)


@pytest.mark.parametrize(("who", "status"), [("stranger", 404), ("other_designer", 404), ("nobody", 401)])
def test_without_sight_there_is_no_list(world: World, who: str, status: int) -> None:
    (cue,) = add(world, {"name": "Door"})
    client: Client = getattr(world, who)
    project = f"/v1/projects/{world.project_id}"
    for path in (
        f"{project}/sound-list",
        f"{project}/sound-list.csv",
        f"{project}/questions",
        f"{project}/sound-list/revisions",
        f"/v1/cues/{cue['id']}",
    ):
        assert client.get(path).status_code == status, path
    assert client.patch(f"/v1/cues/{cue['id']}", json={"edition": 1}).status_code == status
    assert client.post(f"{project}/cues", json={"cues": [{"name": "x"}]}).status_code == status
    assert client.post(f"/v1/cues/{cue['id']}/questions", json={"text": "?"}).status_code == status
    ask = {"format": "paste", "text": "x", "dry_run": True}
    assert client.post(f"{project}/sound-list/import", json=ask).status_code == status


@pytest.mark.parametrize("who", ["designer", "reviewer"])
def test_only_those_who_act_for_the_team_change_the_list(world: World, who: str) -> None:
    (cue,) = add(world, {"name": "Door"})
    client: Client = getattr(world, who)
    project = f"/v1/projects/{world.project_id}"
    assert client.get(f"{project}/sound-list").status_code == 200
    for answer in (
        client.post(f"{project}/cues", json={"cues": [{"name": "x"}]}),
        client.patch(f"/v1/cues/{cue['id']}", json={"edition": 1, "name": "y"}),
        client.put(f"/v1/cues/{cue['id']}/palette", json={"palette": True}),
        client.post(f"{project}/cues/order", json={"cue_ids": [cue["id"]]}),
        client.post(f"{project}/sound-list/import", json={"format": "paste", "text": "x", "dry_run": True}),
    ):
        assert answer.status_code == 403


def test_a_cue_of_another_project_is_not_there(world: World) -> None:
    assert world.producer.get(f"/v1/cues/{uuid4()}").status_code == 404


def test_a_stem_finds_its_cue_exactly(world: World) -> None:
    laser, door = add(world, {"name": "Laser fire", "variations": 4}, {"name": "Door", "file_name": "t\u00fcr"})

    def slot(stem: str) -> tuple[str, int] | None:
        with world.server.runtime.database.reading() as session:
            found = service.slot_by_stem(session, world.project_id, stem)
            return (str(found[0].id), found[1]) if found else None

    assert slot("laser_fire_03") == (laser["id"], 3)
    assert slot("tu\u0308r") == (door["id"], 1)  # but for composition
    assert slot("Laser_Fire_03") is None
    assert slot("laser_fire") is None
    offline = audio_checks.read_sound_list(world.designer.get(f"/v1/projects/{world.project_id}/sound-list.csv").text)
    for stem in ("laser_fire_03", "tu\u0308r", "Laser_Fire_03", "laser_fire", "x"):  # the command line finds the same
        assert (offline.slot(stem) is None) == (slot(stem) is None), stem


def test_the_list_is_a_fixed_number_of_statements(world: World) -> None:
    def statements() -> int:
        count = 0

        def one_more(_connection: object, _cursor: object, statement: str, *_: object) -> None:
            nonlocal count
            count += "sound_lists_" in statement  # the worker speaks to the same database

        engine = world.server.runtime.database.engine
        sa.event.listen(engine, "before_cursor_execute", one_more)
        try:
            the_list(world)
        finally:
            sa.event.remove(engine, "before_cursor_execute", one_more)
        return count

    world.server.wait_for_jobs()
    add(world, {"name": "One"})
    few = statements()
    add(world, *({"name": f"Cue {number}", "variations": 3} for number in range(30)))
    assert statements() == few


def test_the_categories_of_the_list_are_counted_without_cut_cues(world: World) -> None:
    _, second, *_ = add(
        world,
        {"name": "Laser fire", "category": "Weapon"},
        {"name": "Laser hum", "category": "Weapon"},
        {"name": "UI confirm", "category": "ui"},
        {"name": "Airlock"},
    )
    cut(world, second["id"], "Not needed.")
    path = f"/v1/projects/{world.project_id}/categories"
    for client in (world.reviewer, world.designer):
        counted = [(one["category"], one["cues"]) for one in client.get(path).json()]
        assert counted == [("", 1), ("ui", 1), ("weapon", 1)]
    assert world.stranger.get(path).status_code == 404
