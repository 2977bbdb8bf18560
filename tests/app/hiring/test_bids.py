"""Bids: drafts, sent ones, the comparison with the team's scores, and the award that opens a draft contract."""

from typing import Any

import pytest
from httpx import Response
from httpx2 import Client
from sqlalchemy import select, update

from app.hiring.roster import service as roster
from app.notifications.models import Mail
from app.projects.models import Engagement
from app.sound_lists.models import Cue
from app.sound_lists.rules import CueState
from tests.app.hiring.test_postings import add_cues, join, mails_to, opened
from tests.app.sound_lists.lists import add
from tests.support.server import World

DATES = {"work_from_on": "2027-01-04", "work_to_on": "2027-03-31"}


def line(key: str, price_minor: int, quantity: int, **more: Any) -> dict[str, Any]:
    return {
        "key": key,
        "kind": "asked",
        "unit": "per_cue",
        "quantity_hundredths": 100 * quantity,
        "price_minor": price_minor,
        **more,
    }


WHOLE = [line("footsteps", 27_000, 3), line("ui", 15_000, 1)]


def save(by: Client, posting: dict[str, Any], lines: list[dict[str, Any]], **more: Any) -> Response:
    body = {"lines": lines, "revision": 0, **more}
    return by.put(f"/v1/postings/{posting['id']}/bid", json=body)


def send(world: World, posting: dict[str, Any], by: Client, lines: list[dict[str, Any]], **more: Any) -> dict[str, Any]:
    """Join, save and send; return the posting as its candidate sees it."""
    join(world, posting, by)
    saved = save(by, posting, lines, **more)
    assert saved.status_code == 200, saved.text
    sent = by.post(f"/v1/postings/{posting['id']}/bid/send", json={"revision": saved.json()["own_bid"]["revision"]})
    assert sent.status_code == 200, sent.text
    return dict(sent.json())


def compared(world: World, posting: dict[str, Any], by: Client | None = None) -> dict[str, Any]:
    answer = (by or world.producer).get(f"/v1/postings/{posting['id']}/bids")
    assert answer.status_code == 200, answer.text
    return dict(answer.json())


@pytest.fixture
def posting(world: World) -> dict[str, Any]:
    """An open posting for three footsteps and a click."""
    add_cues(world)
    return opened(world, budget_minor=90_000, rate_floor_minor=4_000, **DATES)


@pytest.mark.slow
@pytest.mark.both_databases
def test_the_studio_sees_a_bid_once_it_is_sent_and_as_it_was_sent(world: World, posting: dict[str, Any]) -> None:
    join(world, posting, world.other_designer)
    draft = save(world.other_designer, posting, WHOLE, hours_hundredths=2_400).json()["own_bid"]
    assert (draft["state"], draft["total_minor"], draft["missing"]) == ("draft", 96_000, [])
    assert compared(world, posting)["bids"] == []
    path = f"/v1/postings/{posting['id']}/bid"
    sent = world.other_designer.post(f"{path}/send", json={"revision": 1}).json()["own_bid"]
    assert (sent["state"], sent["differs"]) == ("sent", False)
    typed = save(world.other_designer, posting, WHOLE[:1], revision=1).json()["own_bid"]
    assert (typed["differs"], typed["total_minor"], typed["missing"]) == (True, 81_000, ["UI"])
    (bid,) = compared(world, posting)["bids"]
    assert (bid["total_minor"], bid["amounts_minor"], bid["missing"]) == (96_000, [81_000, 15_000], [])
    assert (bid["hourly_rate_minor"], bid["is_below_floor"], bid["over_budget_minor"]) == (4_000, False, 6_000)
    world.other_designer.post(f"{path}/send", json={"revision": 2})
    (bid,) = compared(world, posting)["bids"]
    assert (bid["total_minor"], bid["missing"], bid["resent_at"] is not None) == (81_000, ["UI"], True)
    withdrawn = world.other_designer.post(f"{path}/withdraw").json()["own_bid"]
    assert (withdrawn["state"], withdrawn["total_minor"]) == ("withdrawn", 81_000)
    assert compared(world, posting)["bids"] == []
    assert world.other_designer.post(f"{path}/withdraw").json()["code"] == "bid-not-sent"


@pytest.mark.slow
@pytest.mark.both_databases
def test_a_designer_sees_their_own_bid_only(world: World, posting: dict[str, Any]) -> None:
    send(world, posting, world.other_designer, WHOLE)
    mine = send(world, posting, world.designer, WHOLE[:1])
    assert mine["own_bid"]["total_minor"] == 81_000
    assert (mine["bids"], mine["candidates"]) == (None, [])
    (theirs,) = [one for one in compared(world, posting)["bids"] if one["total_minor"] == 96_000]
    for by in (world.designer, world.other_designer):
        assert by.get(f"/v1/postings/{posting['id']}/bids").status_code == 403
    assert world.designer.put(f"/v1/bids/{theirs['id']}/shortlist", json={"is_shortlisted": True}).status_code == 404
    assert world.producer.put(f"/v1/postings/{posting['id']}/bid", json={"lines": [], "revision": 0}).status_code == 403


@pytest.mark.slow
def test_what_does_not_fit_is_refused_with_its_place(world: World, posting: dict[str, Any]) -> None:
    join(world, posting, world.other_designer)
    wrong = [WHOLE[0], WHOLE[0], line("weapons", 1, 1)]
    refused = save(world.other_designer, posting, wrong, from_on="2027-02-01", to_on="2027-01-01")
    assert refused.status_code == 422
    assert [one["where"] for one in refused.json()["errors"]] == ["lines.1", "lines.2", "to_on"]
    empty = save(world.other_designer, posting, [], note="Later.")
    assert empty.status_code == 200
    path = f"/v1/postings/{posting['id']}/bid/send"
    unsent = world.other_designer.post(path, json={"revision": 1})
    assert (unsent.status_code, unsent.json()["code"]) == (422, "bid-invalid")
    stale = save(world.other_designer, posting, WHOLE)
    assert (stale.status_code, stale.json()["code"]) == (409, "bid-changed")
    assert world.other_designer.post(path, json={"revision": 7}).json()["code"] == "bid-changed"


@pytest.mark.slow
def test_a_bid_says_exclusivity_other_work_and_equipment(world: World) -> None:
    add_cues(world)
    posting = opened(world, equipment="A contact microphone", **DATES)
    said = {"exclusivity": "several", "other_work": "A film until May", "equipment": "Two of them"}
    seen = send(world, posting, world.other_designer, WHOLE, **said)
    assert seen["equipment"] == "A contact microphone"
    (bid,) = compared(world, posting)["bids"]
    assert {name: bid["content"][name] for name in said} == said
    later = {"revision": seen["own_bid"]["revision"], "exclusivity": "never"}
    assert save(world.other_designer, posting, WHOLE, **later).status_code == 422


@pytest.mark.slow
def test_a_closed_posting_takes_no_bids_and_keeps_drafts(world: World, posting: dict[str, Any]) -> None:
    join(world, posting, world.other_designer)
    save(world.other_designer, posting, WHOLE)
    world.producer.post(f"/v1/postings/{posting['id']}/close")
    refused = world.other_designer.post(f"/v1/postings/{posting['id']}/bid/send", json={"revision": 1})
    assert (refused.status_code, refused.json()["code"]) == (409, "posting-closed")
    seen = world.other_designer.get(f"/v1/postings/{posting['id']}").json()
    assert seen["own_bid"]["total_minor"] == 96_000


def test_extras_and_hours_are_summed_and_rounded_once(world: World, posting: dict[str, Any]) -> None:
    voice = line("Oath", 3_333, 0, kind="voice", unit="per_hour", quantity_hundredths=150)
    send(world, posting, world.other_designer, [*WHOLE, voice], hours_hundredths=3_000, to_on="2027-04-21")
    (bid,) = compared(world, posting)["bids"]
    assert bid["amounts_minor"] == [81_000, 15_000, 5_000]  # 1.5 × 33.33 is 49.995
    assert (bid["hourly_rate_minor"], bid["is_below_floor"], bid["days_late"]) == (3_367, True, 21)


@pytest.mark.slow
def test_the_shortlist_comes_first_then_who_sent_first_whatever_the_price(
    world: World, posting: dict[str, Any]
) -> None:
    send(world, posting, world.designer, WHOLE)
    send(world, posting, world.other_designer, [line("footsteps", 1, 3), line("ui", 1, 1)])
    first, second = compared(world, posting)["bids"]
    assert (first["total_minor"], second["total_minor"]) == (96_000, 4)
    after = world.approver.put(f"/v1/bids/{second['id']}/shortlist", json={"is_shortlisted": True}).json()
    assert [one["id"] for one in after["bids"]] == [second["id"], first["id"]]


@pytest.mark.slow
@pytest.mark.both_databases
def test_the_others_scores_are_shown_after_ones_own(world: World, posting: dict[str, Any]) -> None:
    send(world, posting, world.other_designer, WHOLE)
    (bid,) = compared(world, posting)["bids"]
    path = f"/v1/bids/{bid['id']}/scores"
    whole = dict.fromkeys(posting["headings"], 4)
    assert world.producer.put(path, json={"scores": whole, "note": "Fast."}).status_code == 200
    (seen,) = compared(world, posting, world.approver)["bids"]
    assert (seen["own_scores"], seen["others"], seen["scored_by"]) == (None, None, 1)
    part = dict(list(whole.items())[:2])
    (seen,) = world.approver.put(path, json={"scores": part}).json()["bids"]
    assert (seen["own_scores"]["scores"], seen["others"]) == (part, None)
    (seen,) = world.approver.put(path, json={"scores": whole}).json()["bids"]
    assert [(one["person"]["name"], one["scores"], one["note"]) for one in seen["others"]] == [
        ("Producer", whole, "Fast.")
    ]
    unknown = world.approver.put(path, json={"scores": {"Price": 5}})
    assert (unknown.status_code, unknown.json()["code"]) == (422, "scores-invalid")
    assert world.approver.put(path, json={"scores": {posting["headings"][0]: 6}}).status_code == 422
    assert world.reviewer.put(path, json={"scores": whole}).status_code == 403


def test_notes_of_calls_and_interviews_are_the_teams(world: World, posting: dict[str, Any]) -> None:
    send(world, posting, world.other_designer, WHOLE)
    (bid,) = compared(world, posting)["bids"]
    path = f"/v1/bids/{bid['id']}/notes"
    note = {"kind": "interview", "held_on": "2026-12-01", "text": "Would start in January."}
    added = world.producer.post(path, json=note)
    assert added.status_code == 201, added.text
    (seen,) = compared(world, posting, world.approver)["bids"][0]["notes"]
    assert ({name: seen[name] for name in note}, seen["author"]["name"]) == (note, "Producer")
    assert note["text"] not in world.other_designer.get(f"/v1/postings/{posting['id']}").text
    for by, status in (
        (world.other_designer, 403),
        (world.designer, 404),
        (world.stranger, 404),
        (world.reviewer, 403),
    ):
        assert by.post(path, json=note).status_code == status
    assert world.approver.delete(f"{path}/{seen['id']}").json()["code"] == "bid-note-not-found", "only one's own"
    (left,) = world.producer.delete(f"{path}/{seen['id']}").json()["bids"]
    assert left["notes"] == []


@pytest.mark.slow
def test_questions_are_answered_for_all_or_for_one(world: World, posting: dict[str, Any]) -> None:
    for by in (world.designer, world.other_designer):
        join(world, posting, by)
    path = f"/v1/postings/{posting['id']}/questions"
    world.designer.post(path, json={"text": "Is there a build?"})
    asked = world.designer.post(path, json={"text": "May I bring a friend?"}).json()["questions"]
    assert world.other_designer.get(f"/v1/postings/{posting['id']}").json()["questions"] == []
    for question, is_for_all in zip(asked, (True, False), strict=True):
        body = {"text": "Yes.", "is_for_all": is_for_all}
        assert world.approver.post(f"/v1/posting-questions/{question['id']}/answer", json=body).status_code == 200
        again = world.approver.post(f"/v1/posting-questions/{question['id']}/answer", json=body)
        assert again.json()["code"] == "posting-question-answered"
    (seen,) = world.other_designer.get(f"/v1/postings/{posting['id']}").json()["questions"]
    assert (seen["text"], seen["answer"], seen["asked_by"]) == ("Is there a build?", "Yes.", None)
    assert len(world.designer.get(f"/v1/postings/{posting['id']}").json()["questions"]) == 2
    world.server.wait_for_jobs()
    assert len(mails_to(world, f"{world.other_designer_id}@example.test")) == 1


@pytest.mark.slow
def test_what_one_offered_elsewhere_in_these_days_is_shown(world: World, posting: dict[str, Any]) -> None:
    elsewhere = World(world.server)
    add_cues(elsewhere)
    other = opened(elsewhere, title="Another game", work_from_on="2027-03-01", work_to_on="2027-05-01")
    later = opened(elsewhere, title="Later", work_from_on="2027-06-01", work_to_on="2027-07-01")
    for one in (other, later):
        send(elsewhere, one, world.other_designer, WHOLE)
    join(world, posting, world.other_designer)
    seen = world.other_designer.get(f"/v1/postings/{posting['id']}").json()
    assert seen["clashes"] == [
        {"title": "Another game", "is_awarded": False, "from_on": "2027-03-01", "to_on": "2027-05-01"}
    ]
    assert world.producer.get(f"/v1/postings/{posting['id']}").json()["clashes"] == []


def same(milestone: dict[str, Any]) -> dict[str, Any]:
    """Return a milestone as it is sent back unchanged."""
    cues = [{"cue_id": one["cue"]["id"], "price_minor": one["price_minor"]} for one in milestone["cues"]]
    return {name: milestone[name] for name in ("name", "amount_minor", "due_on")} | {"cues": cues}


@pytest.mark.slow
@pytest.mark.both_databases
def test_concepts_are_named_with_their_money(world: World) -> None:
    add_cues(world)
    (typed,) = add(world, {"name": "typed"})
    assert typed["state"] == "concept", "until the team says otherwise"
    cut = world.producer.post(f"/v1/cues/{typed['id']}/cut", json={"reason": "It was a try."})
    assert cut.is_success, cut.text
    concepts = update(Cue).where(Cue.state == CueState.PROTOTYPE).values(state=CueState.CONCEPT)
    world.server.in_database(lambda session: session.execute(concepts) and None)
    posting = opened(world, budget_minor=90_000, **DATES)
    send(world, posting, world.designer, WHOLE)
    (bid,) = compared(world, posting)["bids"]
    assert (bid["total_minor"], bid["concept_minor"]) == (96_000, 96_000)
    own = world.designer.get(f"/v1/postings/{posting['id']}").json()
    assert sum(one["concepts"] for one in own["lines"]) == sum(one["cues"] for one in own["lines"]) == 4
    assert own["own_bid"]["concept_minor"] == 96_000
    contract_id = world.producer.post(f"/v1/bids/{bid['id']}/award").json()["contract_id"]
    plan = world.producer.get(f"/v1/contracts/{contract_id}/milestones").json()
    deposit_minor = plan["price"]["deposit_minor"]
    assert plan["concepts"] == {"count": 4, "cues": 4, "amount_minor": 96_000 - deposit_minor}


@pytest.mark.slow
def test_an_award_says_when_a_full_roster_took_nobody(
    world: World, posting: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    send(world, posting, world.designer, WHOLE)
    monkeypatch.setattr(roster, "MAX_ENTRIES", 0)  # 5,000 people take a minute to add
    comparison = compared(world, posting)
    assert comparison["is_roster_full"]
    awarded = world.producer.post(f"/v1/bids/{comparison['bids'][0]['id']}/award").json()
    assert not awarded["is_on_roster"]
    on_file = world.producer.get(f"/v1/studios/{world.studio_id}/roster").json()
    assert (on_file["items"], on_file["total"]) == ([], 0), "the award stands without the roster"


@pytest.mark.slow
@pytest.mark.both_databases
def test_an_award_opens_a_draft_with_the_bids_figures(world: World, posting: dict[str, Any]) -> None:
    voice = line("Oath", 20_000, 1, kind="voice", unit="flat")
    send(world, posting, world.other_designer, [*WHOLE, voice], to_on="2027-03-01")
    send(world, posting, world.designer, WHOLE)
    chosen = compared(world, posting)["bids"][0]
    path = f"/v1/bids/{chosen['id']}/award"
    assert world.approver.post(path).status_code == 403
    awarded = world.producer.post(path)
    assert awarded.status_code == 201, awarded.text
    contract_id = awarded.json()["contract_id"]
    assert awarded.json()["is_on_roster"]
    contract = world.producer.get(f"/v1/contracts/{contract_id}").json()
    assert (contract["state"], contract["title"], contract["currency"]) == ("draft", "Effects for Alpha", "USD")
    assert contract["designer"]["id"] == str(world.other_designer_id)
    plan = world.producer.get(f"/v1/contracts/{contract_id}/milestones").json()
    deposit, *parts = plan["milestones"]
    assert (deposit["is_deposit"], deposit["amount_minor"]) == (True, 23_200), "a fifth of the price, and in it"
    assert sum(one["amount_minor"] for one in plan["milestones"]) == 81_000 + 15_000 + 20_000
    assert (parts[-1]["due_on"], sum(len(part["cues"]) for part in parts)) == ("2027-03-01", 4)
    assert len(parts) >= 3
    assert plan["advice"] == [], "our own check has nothing to say about it"
    assert plan["price"] == {
        "total_minor": 116_000,
        "deposit_minor": 23_200,
        "bid_minor": 116_000,
        "bid_currency": "USD",
        "above_bid_minor": 0,
    }
    more = {"name": "More", "amount_minor": 100_000, "is_deposit": True}
    checked = world.producer.post(
        f"/v1/contracts/{contract_id}/plan-check", json={"milestones": [more, *map(same, parts)]}
    )
    assert checked.json()["price"]["above_bid_minor"] == 100_000 - 23_200
    assert "above-bid" in [one["code"] for one in checked.json()["advice"]]
    engaged = select(Engagement).where(Engagement.designer_id == world.other_designer_id)
    assert world.server.in_database(lambda session: session.scalars(engaged).one()).kind == "contract"
    seen = world.producer.get(f"/v1/postings/{posting['id']}").json()
    assert (seen["state"], seen["contract_id"]) == ("awarded", contract_id)
    assert world.producer.post(path).json()["code"] == "wrong-posting-state"
    roster = world.producer.get(f"/v1/studios/{world.studio_id}/roster").json()["items"]
    assert [entry["name"] for entry in roster] == [chosen["designer"]["name"]]
    assert world.other_designer.get(f"/v1/postings/{posting['id']}").json()["own_bid"]["is_awarded"]
    lost = world.designer.get(f"/v1/postings/{posting['id']}").json()
    assert (lost["own_bid"]["is_awarded"], lost["contract_id"]) == (False, None)
    world.server.wait_for_jobs()
    (kind,) = mails_to(world, f"{world.designer_id}@example.test")
    assert kind.subject == "Effects for Alpha: another bid was chosen"
    assert "Thank you for your bid" in kind.lines[0]
    subjects = [mail.subject for mail in mails_to(world, f"{world.other_designer_id}@example.test")]
    assert "Effects for Alpha: your bid was chosen" in subjects


@pytest.mark.slow
def test_mails_about_bids_carry_no_figures(world: World, posting: dict[str, Any]) -> None:
    send(world, posting, world.other_designer, WHOLE)
    world.server.wait_for_jobs()
    found = select(Mail).where(Mail.studio_id == world.studio_id, Mail.topic.contains("bids:"))
    mails = world.server.in_database(lambda session: session.scalars(found).all())
    assert {mail.recipient for mail in mails} == {
        f"{world.producer_id}@example.test",
        f"{world.approver_id}@example.test",
    }
    assert all("960" not in each for mail in mails for each in mail.lines)
