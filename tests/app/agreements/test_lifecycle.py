"""From a template to a text that both accepted."""

from hashlib import sha256
from typing import Any
from uuid import UUID

import pytest

from app.accounts.models import Membership, Person
from app.accounts.rules import Role
from app.agreements.drafts.documents import TextPdf, pdf_of, sha256_of
from app.agreements.models import ContractVersion
from app.core import typesetting
from app.projects.models import Engagement
from app.projects.rules import EngagementKind
from audio_checks import Sandbox
from tests.app.agreements.conftest import Contracts, words_of
from tests.app.sound_lists.lists import add
from tests.support.server import World


def strike(contract: dict[str, Any], key: str) -> list[dict[str, Any]]:
    return [{**row, "stands": False} if row["key"] == key else row for row in contract["version"]["clauses"]]


@pytest.mark.slow
def test_the_text_shows_list_spec_and_open_questions(world: World, contracts: Contracts):
    cues = add(
        world, {"name": "Shield | hit", "duration_s": 1.5, "variations": 4}, {"name": "Radar *ping*", "loop": True}
    )
    world.designer.post(f"/v1/cues/{cues[0]['id']}/questions", json={"text": "What {hits} it?"})
    said = words_of(contracts.begin())
    assert "SW-001 · Shield | hit · 4 · 1.50 s" in said
    assert "SW-002 · Radar *ping* (loop) · 1 · " in said
    assert "They are 2 cues with 5 files." in said
    assert "as revision 1 of the sound list and version 1 of the delivery spec" in said
    assert "SW-001 Shield | hit: What {hits} it?" in said
    assert "between Test studio (the studio) and Sound designer (the designer)" in said
    assert "no legal advice" in said
    assert "soundtrack" not in said


def test_music_is_a_variant(contracts: Contracts):
    assert "released as a soundtrack" in words_of(contracts.begin(with_music=True))


@pytest.mark.slow
def test_toggled_edited_versioned(world: World, contracts: Contracts):
    begun = contracts.begin()
    struck = contracts.save(
        begun, clauses=strike(begun, "about"), terms={**begun["version"]["terms"], "rounds_included": 3}
    )
    said = words_of(struck)
    assert "no legal advice" not in said
    assert "1. Parties" in said
    assert "includes 3 rounds" in said
    assert struck["version"]["number"] == 2
    again = contracts.save(struck)
    assert again["version"]["number"] == 2, "the same text is the same version"
    listed = contracts.ask(world.producer, "GET", f"/contracts/{begun['id']}/versions")
    assert [each["number"] for each in listed] == [2, 1]


@pytest.mark.slow
def test_a_draft_is_looked_at_before_it_is_saved(world: World, contracts: Contracts):
    begun = contracts.begin()
    body = contracts.draft_of(begun, title="Other", terms={**begun["version"]["terms"], "rounds_included": 99})
    shown = contracts.ask(world.producer, "POST", f"/contracts/{begun['id']}/preview", json=body)
    assert shown["blocks"][0]["spans"][0]["text"] == "Other"
    assert shown["problems"] == [{"where": "terms.rounds_included", "message": "99; wanted 0 to 20"}]
    after = contracts.ask(world.producer, "GET", f"/contracts/{begun['id']}")
    assert (after["title"], after["version"]["number"]) == ("Effects for Alpha", 1)
    refused = world.producer.put(f"/v1/contracts/{begun['id']}/draft", json={**body, "based_on_version": 1})
    assert (refused.status_code, refused.json()["code"]) == (422, "bad-draft")


@pytest.mark.slow
def test_the_text_says_how_the_price_comes_about(world: World, contracts: Contracts):
    (cue,) = add(world, {"name": "Radar ping"})
    begun = contracts.begin(currency="EUR")
    plan = [
        {"name": "Deposit", "amount_minor": 10_000, "is_deposit": True},
        {"name": "Alpha", "amount_minor": 0, "tax_bp": 700, "cues": [{"cue_id": cue["id"]}]},
    ]
    contracts.ask(world.producer, "PUT", f"/contracts/{begun['id']}/milestones", json={"milestones": plan})
    by_day = {"price_mode": "day_rate", "day_rate_minor": 40_000, "days_cap": 12, "tax_bp": 1_900}
    said = words_of(contracts.save(begun, terms={**begun["version"]["terms"], **by_day}))
    assert "The price is EUR 4,900.00. Of it EUR 100.00 is a deposit" in said, "the deposit and all the days"
    assert "a day of work costs EUR 400.00" in said
    assert "adds tax of 19 % to each invoice" in said
    assert "Alpha ·  · SW-001 · EUR 0.00 · 7 %" in said


def test_a_preview_marks_every_figure_in_its_clause(world: World, contracts: Contracts):
    (cue,) = add(world, {"name": "Radar ping"})
    begun = contracts.begin(currency="EUR")
    plan = [
        {"name": "Deposit", "amount_minor": 10_000, "is_deposit": True},
        {"name": "Alpha", "amount_minor": 40_000, "cues": [{"cue_id": cue["id"]}]},
    ]
    contracts.ask(world.producer, "PUT", f"/contracts/{begun['id']}/milestones", json={"milestones": plan})
    body = contracts.draft_of(begun, clauses=strike(begun, "about"))
    shown = contracts.ask(world.producer, "POST", f"/contracts/{begun['id']}/preview", json=body)

    def figures(key: str) -> dict[str, str]:
        (clause,) = [clause for clause in shown["clauses"] if clause["key"] == key]
        own = shown["blocks"][clause["first_block"] : clause["first_block"] + clause["block_count"]]
        lines = [line for block in own for line in (block["spans"], *(cell for row in block["rows"] for cell in row))]
        return {span["field"]: span["text"] for line in lines for span in line if span["field"]}

    assert [(clause["number"], clause["key"]) for clause in shown["clauses"]][:1] == [(1, "parties")]
    assert figures("rounds") == {"rounds_included": "2"}
    assert figures("payment_plan") == {
        "total": "EUR 500.00",
        "deposit": "EUR 100.00",
        "milestone.1": "EUR 100.00",
        "milestone.2": "EUR 400.00",
    }
    assert figures("parties") == {}, "names are no figures"
    saved = contracts.ask(world.producer, "GET", f"/contracts/{begun['id']}")
    assert "\x00" not in str(saved), "marks are in no text that is kept"


def test_a_mistyped_term_is_refused_with_a_reason(world: World, contracts: Contracts):
    begun = contracts.begin()
    terms = {**begun["version"]["terms"], "price_mode": "by_day"}
    body = contracts.draft_of(begun, terms=terms)
    shown = contracts.ask(world.producer, "POST", f"/contracts/{begun['id']}/preview", json=body)
    message = "'by_day'; wanted flat or per_cue or day_rate"
    assert [each["message"] for each in shown["problems"]] == [message]
    refused = world.producer.put(f"/v1/contracts/{begun['id']}/draft", json={**body, "based_on_version": 1})
    assert (refused.status_code, refused.json()["errors"][0]["message"]) == (422, message)


@pytest.mark.slow
def test_two_editors_notice_each_other(world: World, contracts: Contracts):
    begun = contracts.begin()
    contracts.save(begun, title="Mine")
    body = contracts.draft_of(begun, title="Yours") | {"based_on_version": 1}
    refused = world.producer.put(f"/v1/contracts/{begun['id']}/draft", json=body)
    assert (refused.status_code, refused.json()["code"]) == (409, "draft-changed")


@pytest.mark.slow
def test_both_accept_the_same_text(world: World, contracts: Contracts):
    begun = contracts.begin()
    path = f"/contracts/{begun['id']}"
    assert world.designer.get(f"/v1{path}").status_code == 404, "a draft is the studio's"
    sent = contracts.send(begun)
    assert (sent["state"], sent["waits_for"]) == ("sent", ["studio", "designer"])
    seen = contracts.ask(world.designer, "GET", path)
    assert seen["version"]["text_sha256"] == sent["version"]["text_sha256"]
    half = contracts.accept(seen, world.designer, "N. Designer")
    assert (half["state"], half["waits_for"], half["may"]["accept"]) == ("sent", ["studio"], False)
    agreed = contracts.accept(sent, world.producer, "P. Producer")
    assert (agreed["state"], agreed["waits_for"]) == ("agreed", [])
    assert [(each["party"], each["name"]) for each in agreed["acceptances"]] == [
        ("designer", "N. Designer"),
        ("studio", "P. Producer"),
    ]
    entries = contracts.entries(agreed, world.designer)
    assert [entry["kind"] for entry in entries] == ["sent", "accepted_by", "accepted_by", "agreed"]
    yes = entries[1]["payload"]
    assert (yes["name"], yes["party"], yes["address"]) == ("N. Designer", "designer", "testclient")
    assert yes["email"] == world.server.in_database(lambda session: session.get_one(Person, world.designer_id).email)
    assert yes["text_sha256"] == sent["version"]["text_sha256"]


@pytest.mark.slow
def test_the_pdf_is_kept_and_can_be_made_again(world: World, contracts: Contracts):
    sent = contracts.send(contracts.begin())
    path = f"/contracts/{sent['id']}/versions/{sent['version']['number']}"
    kept = contracts.ask(world.designer, "GET", f"{path}/contract.pdf")
    assert sha256(kept).hexdigest() == sent["version"]["pdf_sha256"]

    def again(session: Any) -> bytes:
        text = (
            session.query(ContractVersion)
            .filter_by(contract_id=UUID(sent["id"]), pdf_sha256=sent["version"]["pdf_sha256"])
            .one()
            .text
        )
        return pdf_of(sent["title"], text)

    assert world.server.in_database(again) == kept


@pytest.mark.slow
def test_nobody_accepts_what_they_did_not_read(world: World, contracts: Contracts):
    sent = contracts.send(contracts.begin())
    body = {"name": "N. Designer", "text_sha256": "0" * 64}
    refused = world.designer.post(f"/v1/contracts/{sent['id']}/accept", json=body)
    assert (refused.status_code, refused.json()["code"]) == (409, "text-changed")
    contracts.accept(sent, world.designer, "N. Designer")
    body["text_sha256"] = sent["version"]["text_sha256"]
    twice = world.designer.post(f"/v1/contracts/{sent['id']}/accept", json=body)
    assert (twice.status_code, twice.json()["code"]) == (409, "already-accepted")
    looks_on = world.approver.post(f"/v1/contracts/{sent['id']}/accept", json=body)
    assert (looks_on.status_code, looks_on.json()["code"]) == (403, "not-your-contract")


@pytest.mark.slow
def test_the_designer_asks_for_a_change(world: World, contracts: Contracts):
    begun = contracts.begin()
    sent = contracts.send(begun)
    contracts.accept(sent, world.producer, "P. Producer")
    ask = {"text": "Three rounds are too many for this price.", "clause_key": "rounds"}
    back = contracts.ask(world.designer, "POST", f"/contracts/{sent['id']}/ask-change", json=ask)
    assert back["state"] == "draft"
    draft = contracts.ask(world.producer, "GET", f"/contracts/{sent['id']}")
    assert draft["change_requested"]["text"] == ask["text"]
    assert draft["change_requested"]["clause"] == "rounds"
    changed = contracts.save(draft, terms={**draft["version"]["terms"], "rounds_included": 1})
    still = contracts.ask(world.designer, "GET", f"/contracts/{sent['id']}")
    assert still["version"]["number"] == sent["version"]["number"], "the designer reads what was sent"
    resent = contracts.send(changed)
    assert resent["acceptances"] == [], "a yes to the text before is none to this one"
    assert resent["change_requested"] is None
    query = {"from_version": sent["version"]["number"], "to_version": resent["version"]["number"]}
    compared = contracts.ask(world.designer, "GET", f"/contracts/{sent['id']}/comparison", params=query)
    changed_lines = [line for line in compared["lines"] if line["change"] != "same"]
    (rounds,) = changed_lines
    assert [run["text"] for run in rounds["runs"] if run["is_in"] == "earlier"] == ["2"]
    assert [run["text"] for run in rounds["runs"] if run["is_in"] == "later"] == ["1"]


@pytest.mark.slow
def test_sending_again_shows_the_list_of_that_moment(world: World, contracts: Contracts):
    begun = contracts.begin()
    add(world, {"name": "Radar ping"})
    sent = contracts.send(begun)
    assert "SW-001 · Radar ping" in words_of(sent)
    contracts.ask(world.producer, "POST", f"/contracts/{sent['id']}/recall", json={"reason": "A cue is missing."})
    again = contracts.send(sent)
    assert again["version"]["number"] > sent["version"]["number"], "each sending is a version of its own"
    assert again["acceptances"] == []


@pytest.mark.slow
def test_a_contract_too_large_for_a_pdf_stays_a_draft(
    world: World, contracts: Contracts, monkeypatch: pytest.MonkeyPatch
):
    small = Sandbox(timeout_s=0.01, preload=("app.core.typesetting", "typst"))
    monkeypatch.setattr(typesetting, "_sandbox", lambda: small)
    saved = contracts.begin()
    refused = world.producer.post(f"/v1/contracts/{saved['id']}/send", json={})
    small.close()
    assert (refused.status_code, refused.json()["code"]) == (422, "document-too-large")
    assert contracts.ask(world.producer, "GET", f"/contracts/{saved['id']}")["state"] == "draft"


@pytest.mark.slow
def test_the_pdf_of_another_text_is_not_sent(world: World, contracts: Contracts, monkeypatch: pytest.MonkeyPatch):
    draft = contracts.begin()

    def of_earlier(title: str, text: str) -> TextPdf:
        return TextPdf(sha256_of("an earlier text"), pdf_of(title, text))

    monkeypatch.setattr(TextPdf, "of", of_earlier)
    refused = world.producer.post(f"/v1/contracts/{draft['id']}/send", json={})
    assert (refused.status_code, refused.json()["code"]) == (409, "draft-changed")
    assert contracts.ask(world.producer, "GET", f"/contracts/{draft['id']}")["state"] == "draft"


@pytest.mark.slow
def test_agreed_is_agreed(world: World, contracts: Contracts):
    agreed = contracts.agree(contracts.begin())
    for path, by, body in (
        ("recall", world.producer, {"reason": "No."}),
        ("ask-change", world.designer, {"text": "No."}),
        ("send", world.producer, {}),
    ):
        refused = by.post(f"/v1/contracts/{agreed['id']}/{path}", json=body)
        assert (refused.status_code, refused.json()["code"]) == (409, "wrong-state"), path
    body = contracts.draft_of(agreed) | {"based_on_version": agreed["version"]["number"]}
    assert world.producer.put(f"/v1/contracts/{agreed['id']}/draft", json=body).status_code == 409
    refused = world.designer.post(f"/v1/contracts/{agreed['id']}/end", json={"reason": "Done early."})
    assert (refused.status_code, refused.json()["code"]) == (409, "notice-needed")


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["framework", "nda"])
def test_what_orders_no_work_ends_at_once(world: World, contracts: Contracts, kind: str):
    agreed = contracts.agree(contracts.begin(kind))
    ended = contracts.ask(world.designer, "POST", f"/contracts/{agreed['id']}/end", json={"reason": "Done early."})
    assert (ended["state"], ended["end_reason"]) == ("ended", "Done early.")


@pytest.mark.slow
def test_a_draft_that_was_never_sent_stays_unseen_when_it_ends(world: World, contracts: Contracts):
    begun = contracts.begin()
    contracts.ask(world.producer, "POST", f"/contracts/{begun['id']}/end", json={"reason": "Not needed."})
    assert world.designer.get(f"/v1/contracts/{begun['id']}").status_code == 404
    assert contracts.ask(world.designer, "GET", f"/projects/{world.project_id}/contracts") == []


@pytest.mark.slow
def test_a_framework_once_then_a_batch(world: World, contracts: Contracts):
    alone = {"engagement_id": contracts.engagement_id(), "kind": "statement_of_work", "title": "Alpha"}
    path = f"/v1/projects/{world.project_id}/contracts"
    assert world.producer.post(path, json=alone).json()["code"] == "framework-needed"
    framework = contracts.begin("framework", title="Sound design framework")
    early = world.producer.post(path, json={**alone, "framework_id": framework["id"]})
    assert early.json()["code"] == "framework-needed", "a framework that is not agreed yet carries nothing"
    contracts.agree(framework)
    batch = contracts.begin("statement_of_work", title="Alpha", framework_id=framework["id"])
    assert "a batch under Sound design framework, agreed on " in words_of(batch)
    assert len(words_of(batch)) < len(words_of(framework)) / 2
    assert contracts.agree(batch)["state"] == "agreed"


@pytest.mark.slow
def test_a_framework_with_another_studio_carries_nothing(world: World, contracts: Contracts):
    framework = contracts.agree(contracts.begin("framework", title="Sound design framework"))
    elsewhere = World(world.server)

    def both_work_there_too(session: Any) -> None:
        of = {"studio_id": elsewhere.studio_id}
        session.add(Membership(**of, person_id=world.producer_id, roles=[Role.PRODUCER]))
        engagement = Engagement(
            **of, project_id=elsewhere.project_id, designer_id=world.designer_id, kind=EngagementKind.CONTRACT
        )
        session.add(engagement)

    world.server.in_database(both_work_there_too)
    project = world.producer.get(f"/v1/projects/{elsewhere.project_id}").json()
    (tie,) = [each for each in project["engagements"] if each["designer"]["id"] == str(world.designer_id)]
    body = {"engagement_id": tie["id"], "kind": "statement_of_work", "title": "Alpha", "framework_id": framework["id"]}
    refused = world.producer.post(f"/v1/projects/{elsewhere.project_id}/contracts", json=body)
    assert (refused.status_code, refused.json()["code"]) == (422, "framework-needed")


@pytest.mark.parametrize("kind", ["single", "nda"])
def test_the_studios_own_people_need_none(world: World, contracts: Contracts, kind: str):
    def bring_in(session: Any) -> None:
        session.query(Engagement).filter_by(project_id=world.project_id).one().kind = EngagementKind.IN_HOUSE

    world.server.in_database(bring_in)
    body = {"engagement_id": contracts.engagement_id(), "kind": kind, "title": "Effects"}
    refused = world.producer.post(f"/v1/projects/{world.project_id}/contracts", json=body)
    assert (refused.status_code, refused.json()["code"]) == (409, "no-contract-needed")


@pytest.mark.slow
def test_another_designer_sees_nothing_of_it(world: World, contracts: Contracts):
    agreed = contracts.agree(contracts.begin())
    for path in ("", "/versions", "/versions/1", "/record", "/record.json"):
        for outsider in (world.other_designer, world.stranger, world.reviewer):
            assert outsider.get(f"/v1/contracts/{agreed['id']}{path}").status_code == 404, path
        assert world.approver.get(f"/v1/contracts/{agreed['id']}{path}").status_code == 200, path


@pytest.mark.slow
def test_the_party_whose_step_is_next_is_notified_by_mail(world: World, contracts: Contracts):
    contracts.agree(contracts.begin())
    world.server.wait_for_jobs()
    mails = contracts.ask(world.producer, "GET", f"/studios/{world.studio_id}/outbox")["mails"]
    subjects = [mail["subject"] for mail in mails]
    needed = [mail["recipient"] for mail in mails if mail["subject"] == "Shield Wing: a contract needs your signature"]
    # The other party is notified after the first signature, unless its own comes before the job runs.
    assert needed.count(f"{world.designer_id}@example.test") == 1
    assert len(needed) == len(set(needed))
    assert subjects.count("Shield Wing: a contract is signed") == 2
