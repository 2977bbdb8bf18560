"""The next step of each role, from an empty list to the last payment; and the mails that say so."""

from typing import Any

import pytest
from httpx2 import Client

from tests.app.agreements.conftest import Contracts
from tests.app.amendments.test_change_orders import Order, about
from tests.app.money.agreed import Agreed, deposit, milestone
from tests.app.reviews.making import body_of
from tests.support.deliver import add_cues, deliver
from tests.support.links import secret_for
from tests.support.server import World
from tests.support.waves import noise, sine, wav_bytes

GOOD = wav_bytes(noise(dbfs=-20, seconds=0.2))
LOUD = wav_bytes(sine(hz=997, dbfs=0.0, seconds=0.2))


def asked(by: Client, project_id: Any) -> dict[str, Any]:
    answer = by.get(f"/v1/projects/{project_id}/next-steps")
    assert answer.status_code == 200, answer.text
    return dict(answer.json())


def steps(world: World, by: str = "producer") -> list[tuple[str, int]]:
    found = asked(getattr(world, by), world.project_id)["steps"]
    return [(one["kind"], one["count"]) for one in found]


def awaited(world: World, by: str = "producer") -> list[tuple[str, str]]:
    return [(one["kind"], one["who"]) for one in asked(getattr(world, by), world.project_id)["awaited"]]


def mails(world: World) -> list[tuple[str, str]]:
    world.server.wait_for_jobs()
    found = world.producer.get(f"/v1/studios/{world.studio_id}/outbox").json()["mails"]
    return [(mail["recipient"], mail["subject"]) for mail in found]


@pytest.fixture
def contracts(world: World) -> Contracts:
    return Contracts(world)


@pytest.mark.slow
def test_a_new_project_asks_for_cues_then_a_designer_then_an_approver(world: World) -> None:
    body = {"studio_id": str(world.studio_id), "name": "Deep Field", "cue_prefix": "DF"}
    project_id = world.producer.post("/v1/projects", json=body).json()["id"]

    def kinds() -> list[str]:
        return [one["kind"] for one in asked(world.producer, project_id)["steps"]]

    assert kinds() == ["add_cues", "write_brief", "name_approver"]
    body = {"revision": 0, "answers": {"genre": {"is_unknown": True}}}
    assert world.producer.patch(f"/v1/projects/{project_id}/brief", json=body).status_code == 200
    assert kinds() == ["add_cues", "name_approver"]
    world.producer.post(f"/v1/projects/{project_id}/cues", json={"cues": [{"name": "airlock"}]})
    assert kinds() == ["invite_designer", "name_approver"]
    invitation = {"email": "maker@example.test", "kind": "contract"}
    world.producer.post(f"/v1/projects/{project_id}/invitations", json=invitation)
    assert kinds() == ["name_approver"]
    found = asked(world.producer, project_id)["awaited"]
    assert [(one["kind"], one["who"]) for one in found] == [("join", "maker@example.test")]
    world.producer.post(f"/v1/projects/{project_id}/approver-invitations", json={"email": "director@example.test"})
    assert kinds() == ["name_approver"]  # until the invited one joins


@pytest.mark.slow
def test_a_follow_up_on_the_brief_is_answered_by_the_team(world: World) -> None:
    add_cues(world, {"name": "airlock"})
    asked = {"question": "naming", "text": "Which separator?"}
    follow_up = world.designer.post(f"/v1/projects/{world.project_id}/brief/follow-ups", json=asked).json()
    assert ("answer_follow_ups", 1) in steps(world)
    assert ("answer_follow_ups", 1) in steps(world, "approver")
    assert "answer_follow_ups" not in dict(steps(world, "reviewer"))
    world.approver.post(f"/v1/brief-follow-ups/{follow_up['id']}/answer", json={"text": "An underscore."})
    assert "answer_follow_ups" not in dict(steps(world))


@pytest.mark.slow
def test_a_posting_waits_for_bids_then_for_those_who_compare_them(world: World) -> None:
    body = {"studio_id": str(world.studio_id), "name": "Deep Field", "cue_prefix": "DF"}
    project_id = world.producer.post("/v1/projects", json=body).json()["id"]
    world.producer.post(f"/v1/projects/{project_id}/cues", json={"cues": [{"name": "airlock"}]})
    fields = {"title": "Effects for Alpha", "currency": "USD", "scope": "all"}
    posting = world.producer.post(f"/v1/projects/{project_id}/postings", json=fields).json()

    def steps_and_awaited() -> tuple[list[tuple[str, int]], list[str]]:
        found = asked(world.producer, project_id)
        return [(one["kind"], one["count"]) for one in found["steps"]], [one["kind"] for one in found["awaited"]]

    assert steps_and_awaited()[0][-2:] == [("invite_designer", 1), ("name_approver", 1)]
    path = f"/v1/postings/{posting['id']}"
    assert world.producer.post(f"{path}/open").status_code == 200
    assert steps_and_awaited() == ([("name_approver", 1)], ["bids"])
    secret = world.producer.post(f"{path}/link").json()["url"].rpartition("/")[2]
    assert world.other_designer.post(f"/v1/posting-links/{secret}/join").status_code == 200
    assert world.other_designer.post(f"{path}/questions", json={"text": "In mono?"}).status_code == 201
    line = {
        "key": posting["lines"][0]["key"],
        "kind": "asked",
        "unit": "flat",
        "quantity_hundredths": 100,
        "price_minor": 10_000,
    }
    bid = world.other_designer.put(f"{path}/bid", json={"revision": 0, "lines": [line]})
    assert bid.status_code == 200, bid.text
    assert ("compare_bids", 1) not in steps_and_awaited()[0], "a draft is not sent"
    sent = world.other_designer.post(f"{path}/bid/send", json={"revision": 1})
    assert sent.status_code == 200, sent.text
    found, awaited = steps_and_awaited()
    assert (found[:2], awaited) == ([("answer_candidates", 1), ("compare_bids", 1)], [])
    step = asked(world.producer, project_id)["steps"][1]
    assert (step["subject"], step["posting_id"]) == ("Effects for Alpha", posting["id"])
    assert asked(world.reviewer, project_id)["steps"] == []


@pytest.mark.slow
def test_an_nda_is_somebodys_next_step_until_it_is_signed(world: World, contracts: Contracts) -> None:
    add_cues(world, {"name": "airlock"})
    world.producer.patch(f"/v1/projects/{world.project_id}", json={"nda_needed": True})
    assert ("send_nda", 1) in steps(world)
    assert steps(world, "designer") == []
    assert [kind for kind, _ in awaited(world, "designer")] == ["nda"]
    sent = contracts.send(contracts.begin("nda", title="NDA"))
    assert steps(world, "designer") == [("sign_contract", 1)]
    assert ("sign_contract", 1) in steps(world)
    assert ("send_nda", 1) not in steps(world)
    contracts.accept(sent, world.designer, "N. Designer")
    assert steps(world, "designer") == []
    assert [kind for kind, _ in awaited(world, "designer")] == ["signature"]
    assert ("sign_contract", 1) in steps(world)
    signing = [recipient for recipient, subject in mails(world) if subject.endswith("a contract needs your signature")]
    assert len(set(signing)) == 2  # the designer when it was sent, the producer when the designer had signed
    contracts.accept(sent, world.producer, "P. Producer")
    assert ("sign_contract", 1) not in steps(world)
    assert steps(world, "designer") == [("make", 1)]


@pytest.mark.slow
def test_a_change_that_the_designer_wants_is_the_producers(world: World, contracts: Contracts) -> None:
    sent = contracts.send(contracts.begin())
    body = {"text": "Two rounds are too few."}
    contracts.ask(world.designer, "POST", f"/contracts/{sent['id']}/ask-change", json=body)
    assert ("change_contract", 1) in steps(world)
    assert steps(world, "designer") == []


@pytest.mark.slow
def test_sounds_go_from_one_to_the_other(world: World) -> None:
    add_cues(world, {"name": "laser_fire"}, {"name": "airlock"}, {"name": "splash"})
    deliver(world, "laser_fire.wav", GOOD)
    deliver(world, "airlock.wav", LOUD)
    deliver(world, "who knows.wav", GOOD + b"another")
    world.server.wait_for_jobs()
    assert steps(world, "designer") == [("fix", 1), ("match", 1), ("make", 1)]
    assert [kind for kind, _ in awaited(world, "designer")] == ["verdicts"]
    assert ("review", 1) in steps(world, "approver")
    assert "review" not in dict(steps(world))
    assert {kind for kind, _ in awaited(world)} == {"verdicts", "fixes"}
    assert "review" not in dict(steps(world, "reviewer"))


@pytest.mark.slow
def test_money_is_the_designers_then_the_producers_step(world: World) -> None:
    agreed = Agreed(world, terms={})
    cue = agreed.cue()
    agreed.agree(deposit(30_000), milestone("Alpha", cue, amount_minor=70_000))
    (first, *_) = asked(world.designer, world.project_id)["steps"]
    assert (first["kind"], first["amount_minor"], first["currency"]) == ("invoice_deposit", 30_000, "USD")
    assert "invoice" in dict(awaited(world))
    agreed.invoice()
    assert "invoice_deposit" not in dict(steps(world, "designer"))
    assert "payment" in dict(awaited(world, "designer"))
    (pay,) = [one for one in asked(world.producer, world.project_id)["steps"] if one["kind"] == "pay_invoice"]
    assert pay["amount_minor"] == 30_000
    assert any(subject.endswith("an invoice to pay") for _, subject in mails(world))
    assert "pay_invoice" not in dict(steps(world, "reviewer"))


@pytest.mark.slow
def test_a_second_invoice_costs_no_more_statements_and_what_is_paid_waits_no_more(world: World) -> None:
    agreed = Agreed(world, terms={})
    cue = agreed.cue()
    agreed.agree(deposit(30_000), milestone("Alpha", cue, amount_minor=70_000))

    def statements() -> int:
        with world.server.counted_selects() as selects:
            asked(world.producer, world.project_id)
        return len(selects)

    def waiting() -> list[int]:
        return [
            step["amount_minor"]
            for step in asked(world.producer, world.project_id)["steps"]
            if step["kind"] == "pay_invoice"
        ]

    first = agreed.invoice()
    agreed.approve(agreed.take(cue))
    for_one = statements()
    second = agreed.invoice()
    assert sorted(waiting()) == sorted([first["open_minor"], second["open_minor"]])
    assert statements() <= for_one
    agreed.pay(first, 10_000)
    assert sorted(waiting()) == sorted([first["open_minor"] - 10_000, second["open_minor"]])
    agreed.pay(first, first["open_minor"] - 10_000)
    assert waiting() == [second["open_minor"]]


@pytest.mark.slow
def test_a_deposit_is_announced_to_both_and_then_invoiced_and_paid(world: World, contracts: Contracts) -> None:
    [cue] = add_cues(world, {"name": "airlock"})
    draft = contracts.begin()
    plan = [deposit(30_000), milestone("Alpha", cue["id"], amount_minor=70_000)]
    contracts.ask(world.producer, "PUT", f"/contracts/{draft['id']}/milestones", json={"milestones": plan})
    contracts.agree(draft)
    reported = {recipient for recipient, subject in mails(world) if subject.endswith("the deposit is due")}
    assert len(reported) == 2  # who invoices it, and who pays it
    (step, *_) = asked(world.designer, world.project_id)["steps"]
    assert (step["kind"], step["amount_minor"]) == ("invoice_deposit", 30_000)
    (due,) = [one for one in asked(world.producer, world.project_id)["steps"] if one["kind"] == "deposit_due"]
    assert (due["who"], due["amount_minor"], due["currency"]) == ("Sound designer", 30_000, "USD")
    [waits] = [one for one in asked(world.producer, world.project_id)["awaited"] if one["kind"] == "invoice"]
    assert waits["person_id"] == str(world.designer_id)
    assert "deposit_due" not in dict(steps(world, "reviewer"))
    issued = world.designer.post(f"/v1/contracts/{draft['id']}/invoices", json={"seller": "me", "full_number": "SND-7"})
    assert issued.status_code == 201, issued.text
    assert any(subject.endswith("an invoice to pay") for _, subject in mails(world))
    (pay,) = [one for one in asked(world.producer, world.project_id)["steps"] if one["kind"] == "pay_invoice"]
    assert (pay["subject"], pay["amount_minor"]) == ("SND-7", 30_000)
    assert "deposit_due" not in dict(steps(world))
    assert "payment" in dict(awaited(world, "designer"))


@pytest.mark.slow
@pytest.mark.both_databases
def test_a_change_order_waits_for_each_party_until_it_has_signed(world: World) -> None:
    order = Order(world)
    order.propose(about("reprice_cue", order.cues[0], price_minor=20_000))
    assert ("sign_change_order", 1) in steps(world)
    assert ("sign_change_order", 1) in steps(world, "designer")
    body_of(order.accept(world.designer))
    assert ("sign_change_order", 1) not in steps(world, "designer")
    assert "change_order" in [kind for kind, _ in awaited(world, "designer")]
    body_of(order.accept(world.producer))
    assert "sign_change_order" not in dict(steps(world))


@pytest.mark.slow
@pytest.mark.both_databases
def test_what_changed_under_a_contract_is_a_step_of_both_until_it_is_settled(world: World) -> None:
    order = Order(world)
    order.take(order.cues[0])
    edition = body_of(world.producer.get(f"/v1/cues/{order.cues[0]}"))["edition"]
    body_of(world.producer.patch(f"/v1/cues/{order.cues[0]}", json={"edition": edition, "loop": True}))
    assert (dict(steps(world)).get("propose_changes"), dict(steps(world, "designer")).get("propose_changes")) == (1, 1)
    (offer,) = order.read()["offers"]
    path = f"/v1/contracts/{order.contract_id}/change-offers/dismiss"
    body = {"offer": offer["offer"], "reason": "The price covers it"}
    assert world.producer.post(path, json=body).status_code == 200
    assert "propose_changes" not in dict(steps(world))
    assert "propose_changes" not in dict(steps(world, "designer")), "the other party said why it needs none"


@pytest.mark.slow
def test_a_statement_waits_for_each_party_until_it_has_agreed(world: World) -> None:
    order = Order(world)
    path = f"/v1/contracts/{order.contract_id}/ending"
    body_of(world.designer.post(f"{path}/notice", json={"reason": "Another job"}))
    assert ("agree_statement", 1) in steps(world)
    assert ("agree_statement", 1) in steps(world, "designer")
    sha256 = body_of(world.designer.get(path))["statement_sha256"]
    body_of(world.designer.post(f"{path}/agree", json={"name": "N. Designer", "text_sha256": sha256}))
    assert "agree_statement" not in dict(steps(world, "designer"))
    assert "statement" in [kind for kind, _ in awaited(world, "designer")]


def test_who_joins_is_announced(world: World) -> None:
    assert not any(subject.endswith("a designer joined") for _, subject in mails(world))
    world.producer.post(
        f"/v1/projects/{world.project_id}/invitations", json={"email": "maker@example.test", "kind": "contract"}
    )
    secret = secret_for(world.server, "maker@example.test")
    accepted = {"name": "New Maker", "password": "correct horse battery"}
    assert world.nobody.post(f"/v1/invitations/{secret}/accept", json=accepted).is_success
    assert any(subject.endswith("a designer joined") for _, subject in mails(world))
