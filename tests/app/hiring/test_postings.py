"""Postings: written, opened to invited people or by a link, seen as far as an NDA lets."""

from datetime import timedelta
from typing import Any

import pytest
from httpx import Response
from httpx2 import Client
from sqlalchemy import select

from app.core import clock
from app.hiring.models import Candidate
from app.notifications.models import Mail
from app.projects.models import Engagement, Project
from app.projects.rules import EngagementKind
from app.sound_lists.models import Cue
from app.sound_lists.rules import CueState
from tests.support.server import World

DAY = timedelta(days=1)


def add_cues(world: World) -> list[str]:
    """Add three footsteps, a click of the interface and one sound that was cut."""
    rows = [("footsteps", 4), ("footsteps", 4), ("footsteps", 2), ("ui", 1)]

    def add(session: Any) -> list[str]:
        of = {"studio_id": world.studio_id, "project_id": world.project_id}
        cues = [
            Cue(**of, number=n, position=n, name=f"Cue {n}", file_name=f"cue_{n}", category=category, variations=files)
            for n, (category, files) in enumerate(rows, start=1)
        ]
        cues.append(Cue(**of, number=9, position=9, name="Cut", file_name="cut", category="ui", state=CueState.CUT))
        cues[-1].cut_at = clock.now()
        session.add_all(cues)
        session.flush()
        return [str(cue.id) for cue in cues]

    return list(world.server.in_database(add))


def create(world: World, by: Client | None = None, **fields: Any) -> Response:
    body = {"title": "Effects for Alpha", **fields}
    return (by or world.producer).post(f"/v1/projects/{world.project_id}/postings", json=body)


def opened(world: World, **fields: Any) -> dict[str, Any]:
    posting = create(world, **fields).json()
    answer = world.producer.post(f"/v1/postings/{posting['id']}/open")
    assert answer.status_code == 200, answer.text
    return dict(answer.json())


def link_of(world: World, posting: dict[str, Any]) -> str:
    answer = world.producer.post(f"/v1/postings/{posting['id']}/link")
    assert answer.status_code == 201, answer.text
    return str(answer.json()["url"]).rpartition("/")[2]


def join(world: World, posting: dict[str, Any], by: Client) -> str:
    """Let a person come by the posting's link."""
    secret = link_of(world, posting)
    answer = by.post(f"/v1/posting-links/{secret}/join")
    assert answer.status_code == 200, answer.text
    assert answer.json() == {"posting_id": posting["id"]}
    return secret


def ask_for_nda(world: World, *, accepted_by: Any = None) -> None:
    def change(session: Any) -> None:
        session.get_one(Project, world.project_id).nda_needed = True
        if accepted_by is not None:
            session.add(
                Engagement(
                    studio_id=world.studio_id,
                    project_id=world.project_id,
                    designer_id=accepted_by,
                    kind=EngagementKind.ADVISORY,
                    nda_accepted_at=clock.now(),
                    nda_sha256="0" * 64,
                )
            )

    world.server.in_database(change)


def test_what_is_asked_for_is_counted_from_the_list(world: World) -> None:
    cues = add_cues(world)
    everything = create(world).json()
    assert everything["lines"] == [
        {"key": "footsteps", "label": "Footsteps", "cues": 3, "files": 10, "concepts": 0},
        {"key": "ui", "label": "UI", "cues": 1, "files": 1, "concepts": 0},
    ]
    one_category = create(world, scope="categories", categories=["ui"]).json()
    assert one_category["lines"] == [{"key": "ui", "label": "UI", "cues": 1, "files": 1, "concepts": 0}]
    chosen = create(world, scope="cues", cue_ids=[cues[0], cues[3]]).json()
    assert [(line["key"], line["files"]) for line in chosen["lines"]] == [("footsteps", 4), ("ui", 1)]
    assert everything["state"] == "draft"
    assert everything["headings"][0] == "Quality of work"


@pytest.mark.slow
def test_a_posting_is_in_the_projects_currency_unless_it_names_one(world: World) -> None:
    assert create(world).json()["currency"] == "USD", "nobody has named a currency yet"
    assert create(world, currency="JPY").json()["currency"] == "JPY"
    assert create(world).json()["currency"] == "JPY", "the last one of the project"
    budget = {"currency": "EUR", "amount_minor": 500_000}
    assert world.producer.put(f"/v1/projects/{world.project_id}/budget", json=budget).status_code == 200
    posting = create(world).json()
    assert posting["currency"] == "EUR", "that of the budget"
    change = {"title": "Effects", "revision": posting["revision"], "currency": None}
    kept = world.producer.put(f"/v1/postings/{posting['id']}", json=change)
    assert (kept.status_code, kept.json()["currency"]) == (200, "EUR")


def test_a_posting_opens_closes_and_opens_again(world: World) -> None:
    empty = create(world).json()
    refused = world.producer.post(f"/v1/postings/{empty['id']}/open")
    assert (refused.status_code, refused.json()["errors"]) == (
        422,
        [{"where": "scope", "message": "asks for no cue of the list"}],
    )
    add_cues(world)
    posting = opened(world)
    assert (posting["state"], posting["takes_bids"]) == ("open", True)
    path = f"/v1/postings/{posting['id']}"
    assert world.producer.post(f"{path}/open").json()["code"] == "wrong-posting-state"
    closed = world.approver.post(f"{path}/close").json()
    assert (closed["state"], closed["takes_bids"]) == ("closed", False)
    assert closed["closed_at"] is not None
    assert world.producer.post(f"{path}/close").status_code == 409
    again = world.producer.post(f"{path}/open").json()
    assert (again["state"], again["closed_at"]) == ("open", None)


@pytest.mark.slow
def test_its_last_day_closes_it_and_a_day_that_is_over_cannot_open_it(world: World) -> None:
    add_cues(world)
    today = clock.now().date()
    past = create(world, bids_until_on=str(today - 2 * DAY)).json()
    refused = world.producer.post(f"/v1/postings/{past['id']}/open")
    assert refused.json()["errors"] == [{"where": "bids_until_on", "message": "is over"}]
    assert opened(world, bids_until_on=str(today + DAY))["takes_bids"]
    backwards = create(world, work_from_on=str(today), work_to_on=str(today - DAY))
    assert (backwards.status_code, backwards.json()["errors"][0]["where"]) == (422, "work_to_on")


def test_what_bids_are_made_on_is_fixed_once_open_and_the_rest_changes(world: World) -> None:
    add_cues(world)
    posting = opened(world)
    path = f"/v1/postings/{posting['id']}"
    body = {"title": "Effects", "text": "For Alpha.", "revision": posting["revision"]}
    changed = world.producer.put(path, json=body)
    assert (changed.status_code, changed.json()["text"]) == (200, "For Alpha.")
    stale = world.producer.put(path, json=body)
    assert (stale.status_code, stale.json()["code"]) == (409, "posting-changed")
    body |= {"revision": changed.json()["revision"], "scope": "categories", "categories": ["ui"]}
    moved = world.producer.put(path, json=body)
    assert (moved.status_code, {one["where"] for one in moved.json()["errors"]}) == (422, {"scope", "categories"})


@pytest.mark.slow
def test_invited_people_are_mailed_once_it_is_open(world: World) -> None:
    add_cues(world)
    posting = create(world).json()
    path = f"/v1/postings/{posting['id']}"
    asked = world.producer.post(f"{path}/candidates", json={"email": "First@Example.test"})
    assert asked.status_code == 201, asked.text
    assert [one["email"] for one in asked.json()["candidates"]] == ["first@example.test"]
    world.server.wait_for_jobs()
    assert mails_to(world, "first@example.test") == []
    world.producer.post(f"{path}/open")
    second = world.producer.post(f"{path}/candidates", json={"email": "second@example.test"}).json()
    world.server.wait_for_jobs()
    (mail,) = mails_to(world, "second@example.test")
    assert mail.subject == "Test studio asks you for a bid: Effects for Alpha"
    assert len(mails_to(world, "first@example.test")) == 1
    secret = str(mail.link).rpartition("/")[2]
    assert world.nobody.get(f"/v1/posting-links/{secret}").json()["title"] == "Effects for Alpha"
    taken = world.other_designer.post(f"/v1/posting-links/{secret}/join")
    assert taken.status_code == 200
    assert world.designer.post(f"/v1/posting-links/{secret}/join").json()["code"] == "link-taken"
    withdrawn = world.producer.delete(f"{path}/candidates/{second['candidates'][1]['id']}")
    assert withdrawn.status_code == 204
    assert world.nobody.get(f"/v1/posting-links/{secret}").status_code == 404
    assert world.other_designer.get(path).status_code == 404


def mails_to(world: World, address: str) -> list[Mail]:
    found = select(Mail).where(Mail.recipient == address, Mail.studio_id == world.studio_id)
    return list(world.server.in_database(lambda session: session.scalars(found).all()))


@pytest.mark.slow
@pytest.mark.both_databases
def test_a_link_shows_it_to_everyone_until_it_is_revoked(world: World) -> None:
    add_cues(world)
    draft = create(world).json()
    assert world.nobody.get(f"/v1/posting-links/{link_of(world, draft)}").status_code == 404
    posting = opened(world, text="Three months.", budget_minor=800_000, rate_floor_minor=4_000)
    secret = link_of(world, posting)
    seen = world.nobody.get(f"/v1/posting-links/{secret}").json()
    assert (seen["text"], seen["budget_minor"], len(seen["lines"])) == ("Three months.", None, 2)
    assert world.nobody.post(f"/v1/posting-links/{secret}/join").status_code == 401
    assert world.other_designer.get(f"/v1/postings/{posting['id']}").status_code == 404
    assert world.other_designer.post(f"/v1/posting-links/{secret}/join").status_code == 200
    whole = world.other_designer.get(f"/v1/postings/{posting['id']}").json()
    assert (whole["is_team"], whole["lines"], whole["budget_minor"]) == (False, posting["lines"], None)
    assert (whole["rate_floor_minor"], whole["candidates"], whole["headings"]) == (None, [], [])
    (listed,) = world.other_designer.get("/v1/postings").json()
    assert (listed["title"], listed["own_bid"], listed["bids"]) == ("Effects for Alpha", None, None)
    assert world.producer.post(f"/v1/posting-links/{secret}/join").json()["code"] == "own-posting"
    assert world.producer.delete(f"/v1/postings/{posting['id']}/link").status_code == 204
    assert world.nobody.get(f"/v1/posting-links/{secret}").status_code == 404
    assert world.other_designer.get(f"/v1/postings/{posting['id']}").status_code == 200


@pytest.mark.slow
@pytest.mark.both_databases
def test_who_came_by_the_link_asks_for_their_own_and_makes_an_account_by_it(world: World) -> None:
    add_cues(world)
    posting = opened(world)
    secret = link_of(world, posting)
    shown = world.nobody.get(f"/v1/posting-links/{secret}").json()
    assert (shown["email"], shown["has_account"]) == (None, False)
    fields = {"name": "Ada Tones", "password": "quiet reactor hum"}
    for_all = world.nobody.post(f"/v1/posting-links/{secret}/account", json=fields)
    assert (for_all.status_code, for_all.json()["code"]) == (409, "personal-link-needed")
    asked = world.nobody.post(f"/v1/posting-links/{secret}/ask", json={"email": "Ada@Tones.example"})
    assert (asked.status_code, asked.json()) == (202, None)
    world.server.wait_for_jobs()
    own = own_secret(world, "ada@tones.example")
    shown = world.nobody.get(f"/v1/posting-links/{own}").json()
    assert (shown["title"], shown["email"], shown["has_account"]) == ("Effects for Alpha", "ada@tones.example", False)
    browser = world.server.browser()
    nameless = browser.post(f"/v1/posting-links/{own}/account", json={"password": "quiet reactor hum"})
    assert [one["where"] for one in nameless.json()["errors"]] == ["name"]
    made = browser.post(f"/v1/posting-links/{own}/account", json=fields)
    assert (made.status_code, made.json()["name"]) == (200, "Ada Tones")
    assert browser.get("/v1/me").json()["studios"] == []
    guess = world.nobody.post(f"/v1/posting-links/{own}/account", json=fields | {"password": "a guess"})
    assert (guess.status_code, guess.json()["code"]) == (403, "sign-in-needed")
    browser.headers["X-CSRF-Token"] = browser.cookies["soundlist_csrf"]
    joined = browser.post(f"/v1/posting-links/{own}/join")
    assert joined.json() == {"posting_id": posting["id"]}, joined.text
    assert browser.get(f"/v1/postings/{posting['id']}").json()["takes_bids"]
    (candidate,) = world.producer.get(f"/v1/postings/{posting['id']}").json()["candidates"]
    assert (candidate["email"], candidate["is_invited"]) == ("ada@tones.example", False)
    world.producer.delete(f"/v1/postings/{posting['id']}/candidates/{candidate['id']}")
    again = world.nobody.post(f"/v1/posting-links/{secret}/ask", json={"email": "ada@tones.example"})
    assert (again.status_code, again.json()) == (202, None)
    world.server.wait_for_jobs()
    assert len(mails_to(world, "ada@tones.example")) == 1, "who was taken off gets no link"
    world.producer.post(f"/v1/postings/{posting['id']}/close")
    late = world.nobody.post(f"/v1/posting-links/{secret}/ask", json={"email": "late@tones.example"})
    assert (late.status_code, late.json()["code"]) == (409, "posting-closed")


def own_secret(world: World, address: str) -> str:
    (mail,) = mails_to(world, address)
    return str(mail.link).rpartition("/")[2]


@pytest.mark.both_databases
def test_a_bidder_sees_the_cues_that_each_line_counts(world: World) -> None:
    ids = add_cues(world)
    change = {"edition": 1, "duration_s": 2.5, "loop": True}
    assert world.producer.patch(f"/v1/cues/{ids[0]}", json=change).is_success
    posting = opened(world, scope="cues", cue_ids=[ids[0], ids[3]])
    path = f"/v1/postings/{posting['id']}/cues"
    assert world.other_designer.get(path).status_code == 404
    join(world, posting, world.other_designer)
    shown = world.other_designer.get(path).json()
    facts = ("line", "name", "variations", "duration_s", "loop", "is_concept")
    assert [tuple(cue[fact] for fact in facts) for cue in shown] == [
        ("footsteps", "Cue 1", 4, 2.5, True, False),
        ("ui", "Cue 4", 1, None, False, False),
    ]
    assert shown[0].keys() == {"id", *facts, "duration_min_s", "duration_max_s"}
    assert world.producer.get(path).json() == shown
    assert world.stranger.get(path).status_code == 404
    ask_for_nda(world)
    refused = world.other_designer.get(path)
    assert (refused.status_code, refused.json()["code"]) == (403, "nda-needed")
    ask_for_nda(world, accepted_by=world.other_designer_id)
    assert world.other_designer.get(path).json() == shown


@pytest.mark.both_databases
def test_behind_the_nda_only_title_dates_and_studio_are_shown(world: World) -> None:
    add_cues(world)
    ask_for_nda(world)
    posting = opened(world, text="Secret.", budget_minor=1, is_budget_shown=True, work_from_on="2027-01-04")
    secret = join(world, posting, world.other_designer)
    for seen in (
        world.nobody.get(f"/v1/posting-links/{secret}").json(),
        world.other_designer.get(f"/v1/posting-links/{secret}").json(),
        world.other_designer.get(f"/v1/postings/{posting['id']}").json(),
    ):
        assert (seen["title"], seen["work_from_on"]) == ("Effects for Alpha", "2027-01-04")
        assert (seen["studio_name"], seen["project_name"], seen["text"]) == ("Test studio", "", "")
        assert (seen["lines"], seen["budget_minor"]) == ([], None)
    asked = world.other_designer.post(f"/v1/postings/{posting['id']}/questions", json={"text": "What is it?"})
    assert (asked.status_code, asked.json()["code"]) == (403, "nda-needed")
    ask_for_nda(world, accepted_by=world.other_designer_id)
    whole = world.other_designer.get(f"/v1/postings/{posting['id']}").json()
    assert (whole["text"], whole["nda_open"], whole["budget_minor"]) == ("Secret.", False, 1)


def test_who_only_reviews_writes_and_sees_no_posting(world: World) -> None:
    add_cues(world)
    posting = opened(world)
    assert create(world, world.reviewer).status_code == 403
    assert world.reviewer.get(f"/v1/postings/{posting['id']}").status_code == 403
    assert world.reviewer.get(f"/v1/projects/{world.project_id}/postings").status_code == 403
    assert world.stranger.get(f"/v1/postings/{posting['id']}").status_code == 404
    (listed,) = world.producer.get(f"/v1/projects/{world.project_id}/postings").json()
    assert (listed["state"], listed["bids"]) == ("open", 0)


def test_the_only_link_of_a_posting_is_the_newest(world: World) -> None:
    add_cues(world)
    posting = opened(world)
    first, second = link_of(world, posting), link_of(world, posting)
    assert world.nobody.get(f"/v1/posting-links/{first}").status_code == 404
    assert world.nobody.get(f"/v1/posting-links/{second}").status_code == 200
    join(world, posting, world.other_designer)
    candidates = select(Candidate).where(Candidate.person_id == world.other_designer_id)
    kept = world.server.in_database(lambda session: session.scalars(candidates).all())
    assert len(kept) == 1
    join(world, posting, world.other_designer)
