"""Open pages hear of changes at once, of their own projects only, on every web process."""

import threading
import time
from collections.abc import Iterator
from contextlib import ExitStack
from typing import Any

import httpx
import pytest

from app.core import change_feed
from app.core.changes import KEPT_FOR, instant_id
from app.core.db import Base
from app.dashboards.live_changes.queries import BEFORE_NDA, GRANTING, PARTIES_ONLY, STUDIOS_OWN
from app.main import create_app
from app.projects.models import Engagement, Project
from tests.support.event_stream import Listener, listening_for_changes
from tests.support.listening import listening
from tests.support.server import RunningServer, World
from tests.support.waiting import until

pytestmark = pytest.mark.both_databases


@pytest.fixture
def web(server: RunningServer) -> Iterator[str]:
    with listening(create_app(server.runtime), lifespan="off") as port:
        yield f"http://127.0.0.1:{port}"


def add_cue(world: World, name: str = "Radar ping") -> None:
    answer = world.producer.post(f"/v1/projects/{world.project_id}/cues", json={"cues": [{"name": name}]})
    assert answer.is_success, answer.text


def heard(listener: Listener, project_id: Any, room: str) -> None:
    until(lambda: room in listener.rooms_of(project_id))


def test_changes_are_looked_for_several_times_a_second():
    assert change_feed.READ_EVERY_S <= 0.25  # what passes from an act to another page, benchmarks.live measures


@pytest.mark.slow
def test_two_people_on_two_processes_hear_of_a_change(server: RunningServer, web: str, world: World):
    with (
        listening(create_app(server.runtime), lifespan="off") as port,
        listening_for_changes(web, world.designer.cookies) as designer,
        listening_for_changes(f"http://127.0.0.1:{port}", world.reviewer.cookies) as reviewer,
    ):
        add_cue(world)
        heard(designer, world.project_id, "sound_lists")
        heard(reviewer, world.project_id, "sound_lists")
        assert designer.events[0].name == "open"
        named = {key for event in designer.events if event.name == "change" for key in event.data}
        assert named == {"studio_id", "project_id", "rooms"}, "nothing of what changed is sent"


@pytest.mark.slow
def test_nobody_hears_of_projects_that_they_do_not_see(web: str, world: World):
    with (
        listening_for_changes(web, world.stranger.cookies) as stranger,
        listening_for_changes(web, world.other_designer.cookies) as other,
        listening_for_changes(web, world.reviewer.cookies) as reviewer,
    ):
        add_cue(world)
        heard(reviewer, world.project_id, "sound_lists")
        reported = [event.data for event in (*stranger.events, *other.events) if event.name == "change"]
        assert str(world.studio_id) not in {data["studio_id"] for data in reported}, "of their own studio they hear"


@pytest.mark.slow
def test_before_the_nda_a_designer_hears_of_contracts_only(server: RunningServer, web: str, world: World):
    server.in_database(lambda session: setattr(session.get(Project, world.project_id), "nda_needed", True))
    with (
        listening_for_changes(web, world.designer.cookies) as designer,
        listening_for_changes(web, world.producer.cookies) as producer,
    ):
        add_cue(world)
        heard(producer, world.project_id, "sound_lists")
        assert "sound_lists" not in designer.rooms_of(world.project_id)


@pytest.mark.slow
def test_contracts_reach_parties_only(web: str, world: World):
    with (
        listening_for_changes(web, world.designer.cookies) as designer,
        listening_for_changes(web, world.reviewer.cookies) as reviewer,
    ):
        project = f"/v1/projects/{world.project_id}"
        engagement = world.producer.get(project).json()["engagements"][0]
        body = {"engagement_id": engagement["id"], "kind": "single", "title": "Effects for Alpha"}
        contract = world.producer.post(f"{project}/contracts", json=body).json()
        assert world.producer.post(f"/v1/contracts/{contract['id']}/send", json={}).is_success
        add_cue(world)
        heard(reviewer, world.project_id, "sound_lists")
        heard(designer, world.project_id, "agreements")
        assert "agreements" not in reviewer.rooms_of(world.project_id)


def test_sight_names_rooms_that_exist():
    named = BEFORE_NDA | GRANTING | PARTIES_ONLY | STUDIOS_OWN
    assert {mapper.class_.__module__.split(".")[1] for mapper in Base.registry.mappers} >= named


@pytest.mark.slow  # the time in which a stream looks again at what its viewer may see
def test_an_engaged_designer_is_notified_at_once_and_one_who_left_is_not(server: RunningServer, web: str, world: World):
    def engage(session: Any) -> None:
        facts = {"studio_id": world.studio_id, "project_id": world.project_id, "designer_id": world.other_designer_id}
        session.add(Engagement(**facts, kind="in_house"))

    def end(session: Any) -> None:
        engagement = session.query(Engagement).filter_by(designer_id=world.designer_id).one()
        engagement.ended_at = engagement.created_at

    with (
        listening_for_changes(web, world.other_designer.cookies) as newcomer,
        listening_for_changes(web, world.designer.cookies) as leaver,
    ):
        server.in_database(engage)
        heard(newcomer, world.project_id, "projects")
        server.in_database(end)
        time.sleep(2 * change_feed.READ_EVERY_S)
        add_cue(world)
        heard(newcomer, world.project_id, "sound_lists")
        assert "sound_lists" not in leaver.rooms_of(world.project_id)


@pytest.mark.slow
def test_signing_out_closes_the_stream(monkeypatch: pytest.MonkeyPatch, web: str, world: World):
    monkeypatch.setattr(change_feed, "CHECK_SIGHT_EVERY_S", 0.2)
    with listening_for_changes(web, world.designer.cookies) as designer:
        assert world.designer.post("/v1/sign-out").is_success
        until(lambda: designer.is_over)


@pytest.mark.slow
def test_what_was_missed_is_sent_again_and_what_is_too_old_is_said_to_be(web: str, world: World):
    with listening_for_changes(web, world.designer.cookies) as designer:
        last_id = designer.events[-1].id
    add_cue(world)
    with listening_for_changes(web, world.designer.cookies, **{"Last-Event-ID": last_id}) as designer:
        assert designer.events[0].data == {"resumed": True}
        heard(designer, world.project_id, "sound_lists")
    too_old = str(instant_id(time.time() - KEPT_FOR.total_seconds()))
    for unknown in (too_old, "nonsense", ""):
        with listening_for_changes(web, world.designer.cookies, **{"Last-Event-ID": unknown}) as designer:
            assert designer.events[0].data == {"resumed": False}


@pytest.mark.slow
def test_a_person_has_so_many_streams_and_gets_them_back(monkeypatch: pytest.MonkeyPatch, web: str, world: World):
    monkeypatch.setattr(change_feed, "MAX_STREAMS_OF_ONE_PERSON", 1)
    cookies = dict(world.designer.cookies)
    with listening_for_changes(web, cookies):
        refused = httpx.get(f"{web}/v1/events?seconds=0", cookies=cookies)
        assert (refused.status_code, refused.json()["code"]) == (429, "too-many-streams")
        assert refused.headers["retry-after"] == "60"
        assert httpx.get(f"{web}/v1/events?seconds=0", cookies=dict(world.producer.cookies)).status_code == 200
    until(lambda: httpx.get(f"{web}/v1/events?seconds=0", cookies=cookies).status_code == 200)


@pytest.mark.slow
def test_an_unchanged_connection_beats(monkeypatch: pytest.MonkeyPatch, web: str, world: World):
    monkeypatch.setattr("app.dashboards.live_changes.endpoints.BEAT_S", 0.05)
    with listening_for_changes(web, world.designer.cookies) as designer:
        until(lambda: [event.name for event in designer.events].count("beat") > 2)


@pytest.mark.slow
def test_open_pages_hold_no_thread_and_no_connection(server: RunningServer, web: str, world: World):
    with ExitStack() as pages:
        pages.enter_context(listening_for_changes(web, world.designer.cookies))
        before = {thread.ident for thread in threading.enumerate() if "AnyIO" in thread.name}
        for _ in range(15):
            pages.enter_context(listening_for_changes(web, world.designer.cookies))
        time.sleep(2 * change_feed.READ_EVERY_S)
        assert len({thread.ident for thread in threading.enumerate() if "AnyIO" in thread.name} - before) <= 2
        assert server.runtime.database.engine.pool.checkedout() <= 2
        add_cue(world)


@pytest.mark.slow
def test_a_transaction_that_is_undone_says_nothing(server: RunningServer, web: str, world: World):
    with listening_for_changes(web, world.producer.cookies) as producer:
        add_cue(world, "Before")
        heard(producer, world.project_id, "sound_lists")
        reported = len([event for event in producer.events if "projects" in event.data.get("rooms", ())])
        with server.runtime.database.writing() as session:
            session.get_one(Project, world.project_id).name = "Never"
            session.flush()
            session.rollback()
        before = len(producer.events)
        add_cue(world)
        until(lambda: len(producer.events) > before)
        assert len([event for event in producer.events if "projects" in event.data.get("rooms", ())]) == reported
