"""Who may approve: the project's approver, approvers of categories, and deputies from one day to another."""

from collections.abc import Callable
from datetime import datetime, time, timedelta
from typing import Any
from uuid import UUID, uuid4
from zoneinfo import ZoneInfo

import pytest
from httpx2 import Client
from sqlalchemy import select, update
from sqlalchemy.orm import joinedload

from app.agreements.clauses.facts import facts_of
from app.agreements.models import Contract
from app.conformance.models import CheckRun
from app.core import clock
from app.notifications import jobs
from app.notifications.models import Mail
from app.projects.models import Project
from tests.app.money.agreed import Agreed
from tests.app.reviews.making import Stage, body_of, refused
from tests.support.server import World

ZONE = ZoneInfo("Pacific/Auckland")  # far from UTC: there it is another day for half of each day
FIRST = clock.now().date() + timedelta(days=3)
LAST = FIRST + timedelta(days=2)
SECOND = timedelta(seconds=1)


@pytest.fixture
def stage(world: World) -> Stage:
    """A project whose composer may be an approver too."""
    assert world.producer.put(path(world, f"/liaisons/{world.reviewer_id}")).status_code == 200
    return Stage(world)


def path(world: World, rest: str) -> str:
    return f"/v1/projects/{world.project_id}{rest}"


def name_for(world: World, category: str, person_id: UUID | None) -> dict[str, Any]:
    """Name the approver of a category, and return the project."""
    body = {"category": category, "person_id": str(person_id) if person_id else None}
    return body_of(world.producer.put(path(world, "/category-approvers"), json=body))


def days_of(person_id: UUID, deputy_id: UUID, from_on: Any = FIRST, until_on: Any = LAST) -> dict[str, str]:
    return {
        "person_id": str(person_id),
        "deputy_id": str(deputy_id),
        "from_on": str(from_on),
        "until_on": str(until_on),
    }


def name_deputy(world: World, person_id: UUID, deputy_id: UUID, *days: Any) -> str:
    """Name a deputy, by default for some days to come, and return the id."""
    answer = world.producer.post(path(world, "/deputies"), json=days_of(person_id, deputy_id, *days))
    assert answer.status_code == 201, answer.text
    deputy_id_: str = answer.json()["id"]
    return deputy_id_


def today_and_on(world: World) -> tuple[Any, Any]:
    """Return days that begin before any zone's today, and end after it; their first is not refused."""
    return clock.now().date() - timedelta(days=2), clock.now().date() + timedelta(days=2)


def approves(client: Client, take_id: UUID) -> bool:
    """Whether a person's approval is taken."""
    answer = client.post(f"/v1/takes/{take_id}/verdict", json={"kind": "approve"})
    if answer.status_code != 200:
        assert refused(answer) == (403, "approver-needed"), answer.text
    return answer.status_code == 200


def moment(monkeypatch: pytest.MonkeyPatch, at: datetime) -> None:
    monkeypatch.setattr(clock, "now", lambda: at)


def local(day: Any, *, days: int = 0) -> datetime:
    """Return when a day begins in the studio's time zone, or so many days later."""
    return datetime.combine(day + timedelta(days=days), time(), ZONE).astimezone(ZoneInfo("UTC"))


@pytest.mark.slow
def test_a_category_has_its_own_approver_and_the_others_keep_the_projects(stage: Stage) -> None:
    world = stage.world
    project = name_for(world, "UI", world.reviewer_id)
    named = [(one["category"], one["approver"]["name"]) for one in project["category_approvers"]]
    assert (named, project["approver"]["name"]) == ([("ui", "Composer")], "Audio director")
    click, shot, bare = (stage.take(stage.cue(name, category=name)) for name in ("ui", "weapon", ""))

    answer = world.approver.post(f"/v1/takes/{click}/verdict", json={"kind": "approve"})
    assert refused(answer) == (403, "approver-needed")
    assert answer.json()["detail"] == "Composer decides on sounds of the category ui; add a comment instead"
    assert not approves(world.reviewer, shot)
    assert not approves(world.producer, click)
    assert approves(world.reviewer, click)
    assert approves(world.approver, shot)
    assert approves(world.approver, bare)
    assert refused(world.approver.delete(f"/v1/takes/{click}/verdict")) == (403, "approver-needed")
    assert world.reviewer.delete(f"/v1/takes/{click}/verdict").status_code == 200

    assert name_for(world, "ui", None)["category_approvers"] == []
    assert not approves(world.reviewer, click)
    assert approves(world.approver, click)


@pytest.mark.slow
def test_a_set_a_waiver_a_cut_and_a_comment_ask_the_same_rule(stage: Stage) -> None:
    world = stage.world
    name_for(world, "ui", world.reviewer_id)
    cue, other = stage.cue("click", category="ui"), stage.cue("shot", category="weapon")
    take = stage.take(cue)
    assert refused(world.approver.post(f"/v1/cues/{cue}/accept-set", json={})) == (403, "approver-needed")
    assert refused(world.approver.post(f"/v1/takes/{take}/waiver", json={"reason": "Fine."})) == (
        403,
        "approver-needed",
    )
    assert refused(world.approver.post(f"/v1/cues/{cue}/cut", json={"reason": "Gone."})) == (403, "producer-needed")
    said = [
        client.post(f"/v1/takes/{take}/comments", json={"text": "Bright."}).json()["decides"]
        for client in (world.approver, world.reviewer)
    ]
    assert said == [False, True]
    assert world.reviewer.post(f"/v1/cues/{cue}/accept-set", json={}).status_code == 200
    assert world.approver.post(f"/v1/cues/{other}/cut", json={"reason": "Gone."}).status_code == 200
    assert world.reviewer.post(f"/v1/cues/{cue}/cut", json={"reason": "Gone."}).status_code == 200


def test_the_contract_names_the_approvers_of_categories(world: World) -> None:
    agreed = Agreed(world)

    def approver() -> str:
        with_names = (joinedload(Contract.project).joinedload(Project.studio), joinedload(Contract.designer))
        found = select(Contract).where(Contract.id == agreed.contract_id).options(*with_names)
        return world.server.in_database(lambda session: facts_of(session, session.scalars(found).one(), {})["approver"])

    assert approver() == "Audio director"
    name_for(world, "ui", world.producer_id)
    assert approver() == "Audio director (for ui Producer)"


@pytest.mark.parametrize("outsider", ["designer_id", "stranger_id"])
def test_who_is_not_of_the_studio_neither_approves_nor_stands_in(stage: Stage, outsider: str) -> None:
    world = stage.world
    person_id = getattr(world, outsider)
    body = {"category": "ui", "person_id": str(person_id)}
    assert refused(world.producer.put(path(world, "/category-approvers"), json=body)) == (422, "cannot-approve")
    for people in ((world.approver_id, person_id), (person_id, world.approver_id)):
        answer = world.producer.post(path(world, "/deputies"), json=days_of(*people))
        assert refused(answer) == (422, "cannot-approve")
    assert answer.json()["errors"][0]["where"] == "person_id"


def test_who_only_reviews_is_made_an_audio_lead_first(world: World) -> None:
    body = days_of(world.approver_id, world.reviewer_id)
    answer = world.producer.post(path(world, "/deputies"), json=body)
    assert refused(answer) == (422, "cannot-approve")
    assert answer.json()["errors"][0] == {
        "where": "deputy_id",
        "message": "a deputy must be an audio lead of this project or a producer of the studio; "
        "make them an audio lead first",
    }
    assert world.producer.put(path(world, f"/liaisons/{world.reviewer_id}")).status_code == 200
    assert world.producer.post(path(world, "/deputies"), json=body).status_code == 201
    removing = world.producer.delete(path(world, f"/liaisons/{world.reviewer_id}"))
    assert refused(removing) == (409, "liaison-is-approver")


@pytest.mark.slow
def test_the_approver_of_a_category_stays_an_audio_lead(stage: Stage) -> None:
    world = stage.world
    name_for(world, "ui", world.reviewer_id)
    lead = path(world, f"/liaisons/{world.reviewer_id}")
    assert refused(world.producer.delete(lead)) == (409, "liaison-is-approver")
    name_for(world, "ui", None)
    assert world.producer.delete(lead).status_code == 200


@pytest.mark.slow
def test_producers_name_and_the_team_reads(stage: Stage) -> None:
    world = stage.world
    deputy = name_deputy(world, world.approver_id, world.producer_id)
    acts: list[Callable[[Client], Any]] = [
        lambda client: client.put(path(world, "/category-approvers"), json={"category": "ui", "person_id": None}),
        lambda client: client.post(path(world, "/deputies"), json=days_of(world.approver_id, world.producer_id)),
        lambda client: client.delete(path(world, f"/deputies/{deputy}")),
    ]
    for act in acts:
        assert refused(act(world.approver)) == (403, "producer-needed")
        assert act(world.designer).status_code == 403
        assert refused(act(world.stranger)) == (404, "project-not-found")
    found = body_of(world.reviewer.get(path(world, "/deputies")))
    (read,) = found["deputies"]
    assert found["time_zone"] == "UTC"
    assert (read["person"]["name"], read["deputy"]["name"]) == ("Audio director", "Producer")
    assert (read["from_on"], read["until_on"]) == (str(FIRST), str(LAST))
    assert refused(world.designer.get(path(world, "/deputies"))) == (403, "team-needed")
    assert refused(world.stranger.get(path(world, "/deputies"))) == (404, "project-not-found")


@pytest.mark.slow
def test_the_queue_can_be_ones_own(stage: Stage) -> None:
    world = stage.world
    name_for(world, "ui", world.reviewer_id)
    click, shot = (stage.take(stage.cue(name, category=name)) for name in ("ui", "weapon"))
    of_project = {"project_id": str(world.project_id)}
    for where in (of_project, {}):
        for client, own in ((world.reviewer, {click}), (world.approver, {shot}), (world.producer, {click, shot})):
            asked = where | {"own": "true"}
            items = body_of(client.get("/v1/review-queue", params=asked))["items"]
            assert {take["id"] for item in items for take in item["takes"]} == {str(one) for one in own}
            assert body_of(client.get("/v1/review-queue/count", params=asked))["cues"] == len(own)
        assert len(body_of(world.approver.get("/v1/review-queue", params=where))["items"]) == 2
    mine = [
        (one["is_approver"], one["approves_all"])
        for client in (world.approver, world.reviewer, world.producer)
        for one in client.get("/v1/me").json()["projects"]
    ]
    assert mine == [(True, False), (True, False), (False, False)]
    name_for(world, "ui", None)
    assert [one["approves_all"] for one in world.approver.get("/v1/me").json()["projects"]] == [True]


def next_steps(client: Client, world: World) -> tuple[dict[str, int], list[tuple[str, int]]]:
    """Return a person's steps with their numbers, and for whose verdicts they wait."""
    found = body_of(client.get(path(world, "/next-steps")))
    awaited = [(one["who"], one["count"]) for one in found["awaited"] if one["kind"] == "verdicts"]
    return {one["kind"]: one["count"] for one in found["steps"]}, awaited


@pytest.mark.slow
def test_each_approver_is_shown_their_own_sounds_and_waits_for_the_others(stage: Stage) -> None:
    world = stage.world
    name_for(world, "ui", world.reviewer_id)
    for name, category in (("click", "ui"), ("hover", "ui"), ("shot", "weapon")):
        stage.take(stage.cue(name, category=category))
    steps, awaited = next_steps(world.approver, world)
    assert (steps["review"], awaited) == (1, [("Composer", 2)])
    steps, awaited = next_steps(world.reviewer, world)
    assert (steps["review"], awaited) == (2, [("Audio director", 1)])
    for client in (world.producer, world.designer):
        steps, awaited = next_steps(client, world)
        assert ("review" in steps, sorted(awaited)) == (False, [("Audio director", 1), ("Composer", 2)])

    name_deputy(world, world.reviewer_id, world.producer_id, *today_and_on(world))
    steps, awaited = next_steps(world.producer, world)
    assert (steps["review"], awaited) == (2, [("Audio director", 1)])
    assert sorted(next_steps(world.designer, world)[1]) == [("Audio director", 1), ("Producer", 2)]


@pytest.mark.slow
def test_each_approver_sends_their_own_drafts(stage: Stage) -> None:
    world = stage.world
    name_for(world, "ui", world.reviewer_id)
    click, shot = (stage.take(stage.cue(name, category=name)) for name in ("ui", "weapon"))
    for client, take in ((world.reviewer, click), (world.approver, shot)):
        body = {"kind": "request_change", "note": "Duller."}
        assert client.post(f"/v1/takes/{take}/verdict", json=body).status_code == 200
    assert next_steps(world.approver, world)[0]["send_changes"] == 1
    assert refused(world.producer.post(path(world, "/feedback"), json={})) == (403, "approver-needed")
    sent = stage.send()
    assert [one["take_id"] for one in sent["change_requests"]] == [str(shot)]
    assert sent["held_back"] == []
    assert stage.states(click, shot) == ["conforming", "change_requested"]
    assert refused(world.approver.post(path(world, "/feedback"), json={})) == (409, "nothing-to-send")
    (draft,) = world.reviewer.get(path(world, "/change-requests"), params={"state": "draft"}).json()["items"]
    assert refused(world.approver.delete(f"/v1/change-requests/{draft['id']}")) == (403, "approver-needed")
    assert world.reviewer.post(path(world, "/feedback"), json={}).status_code == 201


def test_mails_of_sounds_to_review_go_to_who_may_approve_them(stage: Stage) -> None:
    world = stage.world
    name_for(world, "ui", world.reviewer_id)
    name_deputy(world, world.reviewer_id, world.producer_id, *today_and_on(world))
    takes = [stage.take(stage.cue(name, category=category)) for name, category in (("click", "ui"), ("shot", "weapon"))]
    world.server.in_database(
        lambda session: session.execute(
            update(CheckRun).where(CheckRun.take_id.in_(takes)).values(needs_notification=True)
        )
    )
    jobs.notify_checks(world.server.runtime, {"project_id": str(world.project_id), "event_id": str(uuid4())})
    mails = world.server.in_database(
        lambda session: {
            mail.recipient: " ".join(mail.lines)
            for mail in session.scalars(select(Mail).where(Mail.studio_id == world.studio_id))
            if "to review" in mail.subject
        }
    )
    about = {recipient.split("@")[0]: ("click" in text, "shot" in text) for recipient, text in mails.items()}
    assert about == {
        str(world.reviewer_id): (True, False),
        str(world.producer_id): (True, False),
        str(world.approver_id): (False, True),
    }
