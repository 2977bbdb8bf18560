"""The joining screens over HTTP: who sees what, and that a longer list costs no more queries."""

import pytest
from httpx2 import Client

from tests.support.deliver import add_cues, deliver
from tests.support.server import World
from tests.support.waves import noise, sine, wav_bytes

pytestmark = pytest.mark.slow

GOOD = wav_bytes(noise(dbfs=-20, seconds=0.2))
LOUD = wav_bytes(sine(hz=997, dbfs=0.0, seconds=0.2))


def screen(world: World, name: str, by: str = "producer") -> dict:
    answer = getattr(world, by).get(f"/v1/projects/{world.project_id}/{name}")
    assert answer.status_code == 200, answer.text
    return dict(answer.json())


@pytest.fixture
def begun(world: World) -> World:
    """A list on which something of each kind stands."""
    cues = add_cues(
        world,
        {"name": "laser_fire", "variations": 2, "palette": True},
        {"name": "airlock_cycle"},
        {"name": "coolant_splash"},
        {"name": "alarm_red_alert", "placeholder": True},
        {"name": "warp_in"},
    )
    deliver(world, "laser_fire_01.wav", GOOD)
    deliver(world, "airlock_cycle.wav", LOUD)
    deliver(world, "who knows.wav", GOOD + b"another")
    world.designer.post(f"/v1/cues/{cues[2]['id']}/questions", json={"text": "A drop, a tool, a person?"})
    world.server.wait_for_jobs()
    return world


def test_where_every_cue_stands(begun: World):
    progress = screen(begun, "sound-list/progress")
    assert [cue["status"] for cue in progress["cues"]] == [
        "to_review", "returned", "question", "placeholder", "to_make",
    ]  # fmt: skip
    laser, airlock, coolant, *_ = progress["cues"]
    assert [each["status"] for each in laser["variations"]] == ["to_review", "to_make"]
    assert laser["newest_take"]["thumb"]["points"] > 0
    assert airlock["worst_finding"]["code"] == "sample-peak:over"
    assert coolant["open_question"] == "A drop, a tool, a person?"
    counts = screen(begun, "sound-list/counts")
    assert counts["files_to_review"] == 1
    assert counts["counts"] == dict.fromkeys(("to_review", "returned", "question", "placeholder", "to_make"), 1)


def test_today_and_the_desk(begun: World):
    today = screen(begun, "today", by="approver")
    assert [question["text"] for question in today["questions"]] == ["A drop, a tool, a person?"]
    assert {(each["file_name"], each["status"]) for each in today["with_others"]} == {
        ("airlock_cycle.wav", "returned"),
        ("who knows.wav", "unmatched"),
    }
    assert today["placeholders"] == 1
    desk = screen(begun, "desk", by="designer")
    (back,) = desk["came_back"]
    assert (back["cue"]["name"], back["status"], back["limit_dbfs"]) == ("airlock_cycle", "returned", -0.1)
    assert back["findings"][0]["fix"]
    assert desk["unmatched"] == 1
    assert {each["cue"]["name"] for each in desk["to_make"]} == {"coolant_splash", "alarm_red_alert", "warp_in"}


def test_the_project_at_one_glance(begun: World):
    overview = screen(begun, "overview")
    assert [step["cue"]["label"] for step in overview["steps"]] == [f"SW-00{number}" for number in range(1, 6)]
    assert {happening["kind"] for happening in overview["lately"]} >= {"delivery", "returned"}
    of_list = {cue["cue_id"]: cue["newest_take"] for cue in screen(begun, "sound-list/progress")["cues"]}
    assert overview["palette"], "the palette has a sound"
    assert all(one["take_id"] == of_list[one["cue"]["id"]]["id"] for one in overview["palette"])


def test_find_by_name_number_and_what_was_said(begun: World):
    def found(typed: str) -> list[tuple[str, str]]:
        answer = begun.producer.get(f"/v1/projects/{begun.project_id}/find", params={"q": typed})
        return [(hit["kind"], hit["title"]) for hit in answer.json()["hits"]]

    assert found("laser") == [("cue", "laser_fire"), ("file", "laser_fire_01.wav")]
    assert found("who knows") == [("file", "who knows.wav")]
    assert found("producer")[0][0] == "person"
    assert found("sw-005") == [("cue", "warp_in")]
    assert found("drop") == [("question", "coolant_splash")]
    assert found("100%") == []
    assert [hit for hit in found("_") if hit[0] == "cue"] == [("cue", name) for name in
                          ("laser_fire", "airlock_cycle", "coolant_splash", "alarm_red_alert", "warp_in")]  # fmt: skip


def test_a_search_shows_a_designer_no_people_and_no_work_of_others(begun: World):
    found = begun.designer.get(f"/v1/projects/{begun.project_id}/find", params={"q": "laser"}).json()["hits"]
    assert [hit["kind"] for hit in found] == ["cue", "file"]
    people = begun.designer.get(f"/v1/projects/{begun.project_id}/find", params={"q": "producer"}).json()["hits"]
    assert people == []


def elsewhere(client: Client, typed: str, **more: str) -> set[tuple[str, str, str]]:
    hits = client.get("/v1/find", params={"q": typed, **more}).json()["hits"]
    return {(hit["kind"], hit["title"], hit["project_id"]) for hit in hits}


def test_a_search_through_all_projects_that_one_may_see(begun: World):
    here = ("cue", "laser_fire", str(begun.project_id))
    file = ("file", "laser_fire_01.wav", str(begun.project_id))
    assert elsewhere(begun.producer, "laser") == {here, file}
    assert elsewhere(begun.designer, "LASER fire") == {here, file}
    assert elsewhere(begun.producer, "laser", except_in=str(begun.project_id)) == set()
    for client in (begun.stranger, begun.other_designer):
        assert elsewhere(client, "laser") == set()
    assert elsewhere(begun.producer, "   ") == set()
    assert begun.nobody.get("/v1/find?q=laser").status_code == 401


def test_a_search_shows_no_project_whose_nda_is_open(begun: World):
    begun.producer.patch(f"/v1/projects/{begun.project_id}", json={"nda_needed": True}).raise_for_status()
    assert elsewhere(begun.designer, "laser") == set()
    assert elsewhere(begun.producer, "laser") != set()


def test_a_designer_sees_their_own_takes_only(begun: World):
    mine = screen(begun, "sound-list/progress", by="designer")
    assert mine["cues"][0]["status"] == "to_review"
    path = f"/v1/projects/{begun.project_id}"
    assert begun.designer.get(f"{path}/today").status_code == 403
    assert begun.producer.get(f"{path}/desk").status_code == 403
    for name in ("today", "desk", "overview", "sound-list/progress", "find?q=laser"):
        assert begun.stranger.get(f"{path}/{name}").status_code == 404
        assert begun.other_designer.get(f"{path}/{name}").status_code == 404
        assert begun.nobody.get(f"{path}/{name}").status_code == 401


def test_what_i_can_open(begun: World):
    me = begun.designer.get("/v1/me").json()
    assert [(project["name"], project["part"]) for project in me["projects"]] == [("Shield Wing", "designer")]
    me = begun.approver.get("/v1/me").json()
    assert [(project["part"], project["is_approver"], project["is_producer"]) for project in me["projects"]] == [
        ("team", True, False)
    ]


@pytest.mark.parametrize("name", ["sound-list/progress", "today", "overview"])
def test_a_longer_list_costs_no_more_queries(begun: World, name: str):
    def selects() -> int:
        with begun.server.counted_selects() as counted:
            screen(begun, name)
        return len(counted)

    before = selects()
    add_cues(begun, *({"name": f"further_{number}"} for number in range(20)))
    deliver(begun, "further_1.wav", GOOD + b"1")
    deliver(begun, "further_2.wav", LOUD + b"2")
    begun.server.wait_for_jobs()
    assert 0 < selects() <= before
