"""The queue: who sees what waits, in which order, and at what price."""

from datetime import UTC, date, datetime, timedelta
from typing import Any

import pytest
import sqlalchemy as sa

from app.core import clock
from app.deliveries.queries import take_by_id
from app.deliveries.rules import TakeState
from app.projects.queries import current_spec
from app.renders.models import Render
from app.renders.queries import wanted_recipes
from app.reviews.queue.service import PAGE_CUES
from app.sound_lists.rules import CueState
from tests.app.renders.making import add_cue, deliver_sound
from tests.app.reviews.making import Stage, add_take, body_of, refused
from tests.support.server import World
from tests.support.waves import sine


@pytest.fixture
def stage(world: World) -> Stage:
    return Stage(world)


@pytest.mark.slow
def test_a_real_take_waits_with_all_that_its_card_shows(world: World) -> None:
    cue = add_cue(world, "beep", description="the bridge answers", use="every menu")
    take_id = deliver_sound(world, "beep.wav", sine(hz=997, dbfs=-6, rate=96_000, seconds=0.5))
    (item,) = body_of(world.reviewer.get("/v1/review-queue"))["items"]
    assert item["cue"]["label"] == cue["label"] == "SW-001"
    assert item["cue"]["description"] == "the bridge answers"
    assert (item["kind"], item["rounds_so_far"], item["approved_variations"]) == ("single", 0, [])
    (take,) = item["takes"]
    assert take["id"] == take_id
    assert take["sample_peak_dbfs"] == pytest.approx(-6.0, abs=0.01)
    # BS.1770: a 997 Hz tone at full scale in one channel reads -3.01.
    assert take["loudness_lufs"] == pytest.approx(-9.0, abs=0.1)
    assert take["thumb"]["points"] == 160
    for address in (take["preview_url"], take["peaks_url"], take["spectrum_url"]):
        assert world.reviewer.get(address).status_code == 200
    assert [one["thumb"] for one in take["renders"]] == [None, None]
    assert [(one["target"], one["state"]) for one in take["renders"]] == [("game", "made"), ("handheld", "made")]
    assert all(world.reviewer.get(one["preview_url"]).status_code == 200 for one in take["renders"])
    assert [one["loudness_lufs"] for one in take["renders"]] == pytest.approx([-9.0, -9.0], abs=0.1)
    assert [one["true_peak_dbtp"] for one in take["renders"]] == pytest.approx([-6.0, -6.0], abs=0.1)


def test_oldest_first_and_grouped_by_cue(stage: Stage) -> None:
    start = datetime(2026, 11, 20, tzinfo=UTC)
    young, old = stage.cue("young"), stage.cue("old", variations=2)
    stage.take(young, state_since=start + timedelta(hours=2))
    stage.take(old, 2, state_since=start + timedelta(hours=3))
    stage.take(old, 1, state_since=start + timedelta(hours=1))
    items = stage.queue()
    assert [item["cue"]["name"] for item in items] == ["old", "young"]
    assert [take["variation"] for take in items[0]["takes"]] == [1, 2]
    assert items[0]["kind"] == "set"
    assert datetime.fromisoformat(items[0]["waiting_since"]) == start + timedelta(hours=1)
    assert items[0]["worst_finding"]["code"] == "true-peak:over"
    assert items[0]["findings_count"] == 2
    assert items[0]["takes"][0]["loudness_lufs"] == -14.2
    assert items[0]["takes"][0]["delivery_note"] == "three bowls, struck"


def test_alternates_stand_side_by_side(stage: Stage) -> None:
    cue = stage.cue()
    takes = {str(stage.take(cue, alternate=alternate)) for alternate in (None, 2, 3)}
    (item,) = stage.queue()
    assert item["kind"] == "alternates"
    assert {take["id"] for take in item["takes"]} == takes


@pytest.mark.parametrize(
    "facts",
    [{"state": state} for state in TakeState if state is not TakeState.CONFORMING]
    + [{"is_drawn": False}, {"is_rendered": False}],
)
def test_what_does_not_wait(stage: Stage, facts: dict[str, Any]) -> None:
    stage.take(stage.cue(), **facts)
    assert stage.queue() == []


def test_a_cut_cue_and_an_unmatched_take_do_not_wait(stage: Stage) -> None:
    stage.take(stage.cue(state=CueState.CUT, cut_at=datetime.now(UTC)))
    stage.world.server.in_database(
        lambda session: add_take(session, stage.world, stage.delivery_id, cue_id=None, variation=1)
    )
    assert stage.queue() == []


def test_renders_of_an_older_edition_or_spec_keep_a_take_away(stage: Stage) -> None:
    take = stage.take(stage.cue())
    assert stage.waiting() == {str(take)}
    server = stage.world.server
    server.in_database(lambda session: session.execute(sa.text("update renders_sets set edition = edition + 1")))
    assert stage.waiting() == set()


def test_a_refused_render_is_shown(stage: Stage) -> None:
    take_id = stage.take(stage.cue())

    def refuse(session: Any) -> None:
        take = take_by_id(session, take_id)
        assert take is not None
        recipe = wanted_recipes(current_spec(session, take.project_id), take)["game"]
        session.add(
            Render(
                studio_id=take.studio_id,
                project_id=take.project_id,
                take_id=take.id,
                target="game",
                key=recipe.key(take.master_sha256),
                state="refused",
                refusal="the master is at 22050 Hz",
            )
        )

    stage.world.server.in_database(refuse)
    renders = {one["target"]: one for one in stage.queue()[0]["takes"][0]["renders"]}
    assert (renders["game"]["state"], renders["game"]["refusal"]) == ("refused", "the master is at 22050 Hz")
    assert renders["handheld"]["state"] == "waiting"


def test_pages_follow_each_other_without_gap_or_repeat(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("app.reviews.queue.service.PAGE_CUES", 2)
    start = datetime(2026, 11, 20, tzinfo=UTC)
    for hours in (3, 1, 2, 1, 5):  # two cues since the same instant
        stage.take(stage.cue(f"cue_{hours}"), state_since=start + timedelta(hours=hours))
    seen, cursor = [], None
    while True:
        params = {"project_id": str(stage.world.project_id)} | ({"cursor": cursor} if cursor else {})
        page = body_of(stage.world.approver.get("/v1/review-queue", params=params))
        seen += [(item["waiting_since"], item["cue"]["id"]) for item in page["items"]]
        if (cursor := page["next"]) is None:
            break
    assert len(seen) == 5
    assert seen == sorted(set(seen))
    for nonsense in ("x", "2026-11-20T00:00:00.0", "2026-11-20T00:00:00." + str(stage.delivery_id)):
        answer = stage.world.approver.get("/v1/review-queue", params={"cursor": nonsense})
        assert refused(answer) == (422, "bad-cursor")


@pytest.mark.slow
def test_the_queue_costs_the_same_however_long_it_is(stage: Stage) -> None:
    server = stage.world.server
    server.wait_for_jobs()

    def fetch(expected: int) -> int:
        stage.waiting()
        with server.counted_selects() as selects:
            assert len(stage.waiting()) == expected
        return len(selects)

    stage.draft(stage.take(stage.cue("first", variations=2)))  # drafts are asked for where there are any
    for_one = fetch(1)
    for number in range(12):
        cue = stage.cue(f"cue_{number}", variations=2)
        for variation in (1, 2):
            stage.take(cue, variation)
            stage.draft(stage.take(cue, variation))
    assert fetch(49) == for_one
    assert for_one <= 24  # on PostgreSQL two of them set the caller


def test_cues_are_counted_and_not_takes_and_up_to_a_bound(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> None:
    def count() -> dict[str, Any]:
        named = {"project_id": str(stage.world.project_id)}
        return body_of(stage.world.reviewer.get("/v1/review-queue/count", params=named))

    monkeypatch.setattr("app.reviews.queue.service.COUNTED_CUES", 3)
    assert count() == {"cues": 0, "is_all": True}
    pair = stage.cue("pair", variations=2)
    for variation in (1, 2):
        stage.take(pair, variation)
    stage.take(stage.cue("not drawn"), is_drawn=False)
    assert count() == {"cues": 1, "is_all": True}
    for name in ("second", "third"):
        stage.take(stage.cue(name))
    assert count() == {"cues": 3, "is_all": True}
    stage.take(stage.cue("fourth"))
    assert count() == {"cues": 3, "is_all": False}
    stage.take(stage.cue("fifth"))
    assert count() == {"cues": 3, "is_all": False}


@pytest.mark.slow
def test_to_count_costs_the_same_however_many_wait(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("app.reviews.queue.service.COUNTED_CUES", 3)
    server, named = stage.world.server, {"project_id": str(stage.world.project_id)}

    def statements() -> int:
        with server.counted_selects() as selects:
            body_of(stage.world.reviewer.get("/v1/review-queue/count", params=named))
        return len(selects)

    stage.take(stage.cue())
    statements()
    for_one = statements()
    for number in range(20):
        stage.take(stage.cue(f"cue_{number}"))
    assert statements() == for_one
    assert for_one <= 9  # on PostgreSQL two of them set the caller


def test_who_may_count_the_queue(stage: Stage) -> None:
    world, address = stage.world, "/v1/review-queue/count"
    stage.take(stage.cue())
    named = {"project_id": str(world.project_id)}
    for who in (world.producer, world.approver, world.reviewer):
        assert body_of(who.get(address, params=named)) == body_of(who.get(address)) == {"cues": 1, "is_all": True}
    assert world.nobody.get(address).status_code == 401
    assert refused(world.designer.get(address, params=named)) == (403, "team-needed")
    assert refused(world.designer.get(address)) == (403, "team-needed")
    assert refused(world.stranger.get(address, params=named)) == (404, "project-not-found")
    assert body_of(world.stranger.get(address)) == {"cues": 0, "is_all": True}


@pytest.mark.slow
def test_who_sees_the_queue(stage: Stage) -> None:
    world = stage.world
    stage.take(stage.cue())
    named = {"project_id": str(world.project_id)}
    for who in (world.producer, world.approver, world.reviewer):
        assert len(body_of(who.get("/v1/review-queue", params=named))["items"]) == 1
        assert len(body_of(who.get("/v1/review-queue"))["items"]) == 1
    assert world.nobody.get("/v1/review-queue").status_code == 401
    assert refused(world.designer.get("/v1/review-queue", params=named)) == (403, "team-needed")
    assert refused(world.designer.get("/v1/review-queue")) == (403, "team-needed")
    assert refused(world.stranger.get("/v1/review-queue", params=named)) == (404, "project-not-found")
    assert refused(world.other_designer.get("/v1/review-queue", params=named)) == (404, "project-not-found")
    assert body_of(world.stranger.get("/v1/review-queue"))["items"] == []


def in_days(days: int) -> date:
    return clock.now().date() + timedelta(days=days)


def test_what_others_wait_for_comes_first(stage: Stage) -> None:
    start = datetime(2026, 11, 20, tzinfo=UTC)
    cues = [
        ("old", {}, 1, False),
        ("palette", {"palette": True}, 4, True),
        ("later", {"due_on": in_days(8)}, 2, False),
        ("soon", {"due_on": in_days(7)}, 5, True),
        ("overdue", {"due_on": in_days(-3)}, 3, True),
    ]
    for name, facts, hour, _ in cues:
        stage.take(stage.cue(name, **facts), state_since=start + timedelta(hours=hour))
    items = stage.queue()
    assert [item["cue"]["name"] for item in items] == ["overdue", "palette", "soon", "old", "later"]
    assert {item["cue"]["name"]: item["is_urgent"] for item in items} == {name: urgent for name, *_, urgent in cues}
    assert items[2]["cue"]["due_on"] == in_days(7).isoformat()


def test_need_then_playback_priority_order_what_is_equally_urgent(
    stage: Stage, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("app.reviews.queue.service.PAGE_CUES", 2)
    start = datetime(2026, 11, 20, tzinfo=UTC)
    cues = [
        ("a wish", {"need": "wish", "playback_priority": 0}, 1),
        ("no priority", {}, 2),
        ("no priority, younger", {}, 9),
        ("priority 7", {"playback_priority": 7}, 3),
        ("should", {"need": "should"}, 4),
        ("priority 1000", {"playback_priority": 1000}, 5),
        ("priority 0", {"playback_priority": 0}, 6),
        ("due, and only a wish", {"need": "wish", "due_on": in_days(3)}, 7),
        ("due, priority 3", {"playback_priority": 3, "due_on": in_days(5)}, 8),
    ]
    for name, facts, hour in cues:
        stage.take(stage.cue(name, **facts), state_since=start + timedelta(hours=hour))
    expected = ["due, priority 3", "due, and only a wish", "priority 0", "priority 7", "priority 1000"]
    expected += ["no priority", "no priority, younger", "should", "a wish"]
    names: list[str] = []
    cursor: str | None = None
    while cursor is not None or not names:
        page = body_of(stage.world.approver.get("/v1/review-queue", params={"cursor": cursor} if cursor else {}))
        names += [item["cue"]["name"] for item in page["items"]]
        cursor = page["next"]
    assert names == expected


@pytest.mark.slow
@pytest.mark.parametrize("urgent", [3, PAGE_CUES, PAGE_CUES + 3])
def test_pages_go_from_what_is_urgent_to_the_rest_and_repeat_nothing(stage: Stage, urgent: int) -> None:
    start, count = datetime(2026, 11, 20, tzinfo=UTC), 2 * PAGE_CUES + 5
    for number in range(count):
        facts = {"palette": True} if number >= count - urgent else {}
        stage.take(stage.cue(f"cue_{number:02}", **facts), state_since=start + timedelta(minutes=number))
    read: list[str] = []
    cursor = None
    while True:
        page = body_of(stage.world.approver.get("/v1/review-queue", params={"cursor": cursor} if cursor else {}))
        assert len(page["items"]) <= PAGE_CUES
        read += [item["cue"]["name"] for item in page["items"]]
        if (cursor := page["next"]) is None:
            break
    order = [*range(count - urgent, count), *range(count - urgent)]
    assert read == [f"cue_{number:02}" for number in order]


@pytest.mark.parametrize(
    "cursor",
    [
        "urgent.",
        "0-0-1001.",
        "0-0-1001.now.x",
        "0-0-1001.2026-11-20T00:00:00+00:00.x",
        "2-0-1.2026-11-20T00:00:00+00:00.x",
    ],
)
def test_a_cursor_that_is_none_is_refused(stage: Stage, cursor: str) -> None:
    assert refused(stage.world.approver.get("/v1/review-queue", params={"cursor": cursor}))[0] == 422
