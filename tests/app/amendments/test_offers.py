"""Change orders that are offered: what changed since both signed, until a change order or a dismissal settles it."""

from datetime import datetime, timedelta
from typing import Any
from uuid import UUID

import pytest
from sqlalchemy import update

from app.agreements.models import Contract
from app.amendments import verification
from app.deliveries.rules import TakeState
from app.sound_lists.models import Question
from tests.app.amendments.test_change_orders import Order, about, add
from tests.app.money.agreed import TODAY, day
from tests.app.reviews.making import body_of, refused
from tests.support.server import World


@pytest.fixture
def order(world: World) -> Order:
    return Order(world)


def offers(order: Order, by: Any = None) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = order.read(by)["offers"]
    return found


def kinds(order: Order, by: Any = None) -> list[str]:
    return [offer["kind"] for offer in offers(order, by)]


def edit(order: Order, cue_id: UUID, **facts: Any) -> None:
    """Change a cue on the list as the producer."""
    edition = body_of(order.world.producer.get(f"/v1/cues/{cue_id}"))["edition"]
    body_of(order.world.producer.patch(f"/v1/cues/{cue_id}", json={"edition": edition, **facts}))


def dismiss(order: Order, offer: str, by: Any = None) -> Any:
    path = f"/v1/contracts/{order.contract_id}/change-offers/dismiss"
    return (by or order.world.producer).post(path, json={"offer": offer, "reason": "The price covers it"})


def completed(order: Order, offer: dict[str, Any], **more: Any) -> dict[str, Any]:
    """Return the change that the form begins with, with what the party adds."""
    return {name: value for name, value in (offer["change"] | more).items() if value not in (None, "")}


def settle(order: Order, offer: dict[str, Any], **more: Any) -> None:
    """Propose the change order that is offered, and have both accept it."""
    answer = order.propose(completed(order, offer, **more), offers=[offer["offer"]])
    assert answer.status_code == 201, answer.text
    assert offer["offer"] not in [one["offer"] for one in offers(order)], "it is proposed"
    number = order.read()["orders"][-1]["number"]
    body_of(order.accept(order.world.designer, number=number))
    body_of(order.accept(order.world.producer, number=number))
    assert offer["offer"] not in [one["offer"] for one in offers(order)], "it is agreed"


def send_rounds(order: Order, cue_id: UUID, count: int) -> None:
    for _ in range(count):
        order.draft(order.take(cue_id))
        order.send()


@pytest.mark.slow
def test_nothing_is_offered_where_nothing_changed(order: Order) -> None:
    send_rounds(order, order.cues[0], 2)
    assert offers(order) == []


@pytest.mark.slow
@pytest.mark.both_databases
def test_a_round_beyond_those_included(order: Order) -> None:
    send_rounds(order, order.cues[0], 3)
    (offer,) = offers(order, order.world.designer)
    assert "Round 3 of" in offer["text"]
    assert "the price includes 2" in offer["text"]
    assert (offer["who"], offer["change"]["kind"]) == ("Audio director", "add_round")
    settle(order, offer)
    path = f"/v1/contracts/{order.contract_id}/extra-rounds"
    (round_,) = order.world.producer.get(path).json()
    assert (round_["state"], order.owed()[-1]) == ("agreed", ("extra_round", 4_500))


@pytest.mark.slow
def test_a_round_that_money_settled_is_offered_no_more(order: Order) -> None:
    send_rounds(order, order.cues[0], 3)
    send_rounds(order, order.cues[1], 3)
    path = f"/v1/contracts/{order.contract_id}/extra-rounds"
    first, second = order.world.producer.get(path).json()
    assert kinds(order) == ["round", "round"]
    body_of(order.world.producer.post(f"/v1/extra-rounds/{first['id']}/agree"))
    body_of(order.world.designer.post(f"/v1/extra-rounds/{second['id']}/drop"))
    assert offers(order) == []


@pytest.mark.slow
def test_a_round_without_a_price_in_the_text_is_offered_as_another_price(world: World) -> None:
    order = Order(world, terms={"extra_round_bp": 0})
    send_rounds(order, order.cues[0], 3)
    (offer,) = offers(order)
    assert offer["change"]["kind"] == "reprice_cue"
    settle(order, offer, price_minor=20_000)


@pytest.mark.slow
@pytest.mark.both_databases
def test_a_cue_described_differently_after_work_began(order: Order) -> None:
    cue = order.cues[0]
    edit(order, cue, duration_s=0.8)
    assert offers(order) == [], "no work had begun"
    order.take(cue, state=TakeState.RETURNED)
    edit(order, cue, duration_s=2.0, description="A ping with a long tail")
    (offer,) = offers(order)
    assert offer["kind"] == "described"
    assert "description, length 2 s instead of 0.8 s" in offer["text"]
    assert offer["who"] == "Producer"
    assert offers(order, order.world.designer) == [offer], "both sides read the same"
    settle(order, offer, price_minor=20_000)
    edit(order, cue, loop=True)
    (again,) = offers(order)
    assert "loop yes instead of no" in again["text"]
    assert "length" not in again["text"], "only what changed since the change order"


@pytest.mark.slow
def test_what_is_changed_and_changed_back_is_not_offered(order: Order) -> None:
    cue = order.cues[0]
    order.take(cue)
    edit(order, cue, variations=4)
    assert kinds(order) == ["described"]
    edit(order, cue, variations=1)
    edit(order, cue, playback_priority=3)
    assert offers(order) == []


@pytest.mark.slow
def test_an_accepted_cue_described_differently_is_offered_as_work_beside_it(order: Order) -> None:
    cue = order.cues[0]
    order.approve(order.take(cue))
    edit(order, cue, description="Another sound")
    (offer,) = offers(order)
    assert (offer["change"]["kind"], offer["change"]["milestone_id"]) == ("add_work", order.milestones["Alpha"])
    settle(order, offer, amount_minor=9_000)


@pytest.mark.slow
def test_a_change_order_written_by_hand_settles_it_too(order: Order) -> None:
    order.take(order.cues[0])
    edit(order, order.cues[0], loop=True)
    order.in_force(about("reprice_cue", order.cues[0], price_minor=20_000))
    assert offers(order) == []


@pytest.mark.slow
def test_a_refused_change_order_settles_nothing(order: Order) -> None:
    order.take(order.cues[0])
    edit(order, order.cues[0], loop=True)
    (offer,) = offers(order)
    order.propose(completed(order, offer, price_minor=20_000), offers=[offer["offer"]])
    assert offers(order) == []
    body_of(order.world.designer.post(f"{order.path}/1/refuse", json={"reason": "Too cheap"}))
    assert offers(order) == [offer]


@pytest.mark.slow
def test_a_cue_needed_earlier(order: Order) -> None:
    edit(order, order.cues[0], due_on=day(20))
    assert offers(order) == [], "its milestone is earlier"
    edit(order, order.cues[0], due_on=day(5))
    (offer,) = offers(order)
    assert (offer["kind"], offer["change"]["due_on"]) == ("needed", day(5))
    settle(order, offer)
    assert order.plan_now()[1][2] == day(5)


@pytest.mark.slow
@pytest.mark.both_databases
def test_another_delivery_spec(order: Order) -> None:
    write_spec(order, "-3.0")
    (offer,) = offers(order)
    assert offer["text"] == (
        "Version 2 of the delivery spec asks something else of 4 cues of this contract than version 1."
    )
    assert offer["change"]["text"] == "Work for version 2 of the delivery spec"
    settle(order, offer, amount_minor=5_000)
    write_spec(order, "-4.0")
    (again,) = offers(order)
    assert "than version 2." in again["text"]
    write_spec(order, "-3.0")
    assert offers(order) == [], "as it was agreed"


@pytest.mark.slow
def test_a_spec_of_other_categories_is_not_offered(order: Order) -> None:
    save_spec(order, f"{newest_toml(order)}\n[categories.dragon.limits]\ntrue_peak_dbtp = -6.0\n")
    assert offers(order) == []


def newest_toml(order: Order) -> str:
    toml: str = order.world.producer.get(f"/v1/projects/{order.world.project_id}/spec.toml").text
    return toml


def save_spec(order: Order, toml: str) -> None:
    path = f"/v1/projects/{order.world.project_id}/spec"
    version = body_of(order.world.producer.get(path))["version"]
    saved = order.world.producer.put(path, json={"toml": toml, "note": "", "based_on_version": version})
    assert saved.is_success, saved.text


def write_spec(order: Order, true_peak_dbtp: str) -> None:
    """Save a version with another limit of the true peak."""
    lines = [line for line in newest_toml(order).splitlines() if not line.startswith("true_peak_dbtp")]
    at = next(place for place, line in enumerate(lines) if line.startswith("[limits]"))
    save_spec(order, "\n".join([*lines[: at + 1], f"true_peak_dbtp = {true_peak_dbtp}", *lines[at + 1 :]]))


@pytest.mark.slow
def test_an_answer_after_the_day_of_the_work(order: Order) -> None:
    cue = order.cues[0]
    asked = order.world.designer.post(f"/v1/cues/{cue}/questions", json={"text": "How deep is the water?"})
    question_id = asked.json()["id"]

    def asked_long_ago(session: Any) -> None:
        due_on = datetime.fromisoformat(f"{day(-3)}T12:00:00+00:00")
        session.execute(update(Question).where(Question.id == UUID(question_id)).values(asked_at=due_on))

    edit(order, cue, due_on=day(-1))
    order.world.server.in_database(asked_long_ago)
    order.take(cue)
    answered = {"text": "Two metres.", "joins": True}
    assert order.world.producer.post(f"/v1/questions/{question_id}/answer", json=answered).is_success
    found = {offer["kind"]: offer for offer in offers(order)}
    assert set(found) == {"answered", "needed"}, "what an answer adds to a description is no other description"
    assert found["answered"]["change"]["due_on"] == (TODAY + timedelta(days=2)).isoformat()
    settle(order, found["answered"])
    assert offers(order) == [], "the date that both agreed to settles the earlier day too"


@pytest.mark.slow
@pytest.mark.both_databases
def test_a_cue_that_the_list_gained_in_the_categories_of_the_contract(order: Order) -> None:
    path = f"/v1/projects/{order.world.project_id}/cues"
    rows = [{"name": "shield_down"}, {"name": "growl", "category": "creature"}]
    added = order.world.producer.post(path, json={"cues": rows})
    assert added.status_code == 201, added.text
    (offer,) = offers(order)
    assert "shield_down was added to the list." in offer["text"]
    assert (offer["who"], offer["change"]["milestone_id"]) == ("Producer", order.milestones["Alpha"])
    settle(order, offer, price_minor=22_500)


@pytest.mark.slow
def test_a_change_order_for_an_added_cue_written_by_hand_settles_it(order: Order) -> None:
    cue = order.cue("shield_down")
    assert kinds(order) == ["added"]
    order.propose(add(order, cue))
    assert offers(order) == []


@pytest.mark.slow
def test_a_cue_cut_in_work_where_no_clause_says_what_it_owes(world: World) -> None:
    order = Order(world, terms={"kill_fee_in_work_bp": 0})
    order.take(order.cues[0], state=TakeState.RETURNED)
    for cue in order.cues[:2]:
        cut = world.producer.post(f"/v1/cues/{cue}/cut", json={"reason": "Left the game"})
        assert cut.status_code == 200, cut.text
    (offer,) = offers(order)
    assert (offer["kind"], offer["change"]["kind"]) == ("cut", "add_work")
    settle(order, offer, amount_minor=9_000)


@pytest.mark.slow
def test_a_cut_that_a_clause_settles_is_not_offered(order: Order) -> None:
    order.take(order.cues[0], state=TakeState.RETURNED)
    order.world.producer.post(f"/v1/cues/{order.cues[0]}/cut", json={"reason": "Left the game"})
    assert (order.owed()[-1], offers(order)) == (("cut", 9_000), [])


@pytest.mark.slow
@pytest.mark.both_databases
def test_a_dismissal_is_of_one_party_and_stays_in_the_record(order: Order) -> None:
    cue, designer = order.cues[0], order.world.designer
    order.take(cue)
    edit(order, cue, loop=True)
    (offer,) = offers(order)
    body_of(dismiss(order, offer["offer"]))
    assert (offers(order), order.entries()[-1]) == ([], "offer_dismissed")
    assert refused(dismiss(order, offer["offer"])) == (409, "offer-settled")
    (shown,) = offers(order, designer)
    assert shown["dismissed"]["party"] == "studio"
    assert (shown["dismissed"]["by"], shown["dismissed"]["reason"]) == ("Producer", "The price covers it")
    edit(order, cue, variations=3)
    (again,) = offers(order)
    assert "variations 3 instead of 1" in again["text"]
    assert "loop" not in again["text"], "that was dismissed"
    (both,) = offers(order, designer)
    assert "loop yes instead of no, variations 3 instead of 1" in both["text"]
    body_of(dismiss(order, both["offer"], by=designer))
    assert offers(order, designer) == []

    def faults(session: Any) -> list[str]:
        return list(verification.table_faults(session, session.get_one(Contract, order.contract_id)))

    assert [one for one in order.world.server.in_database(faults) if "change order" in one] == []


@pytest.mark.slow
def test_only_the_two_parties_read_and_dismiss(order: Order) -> None:
    order.take(order.cues[0])
    edit(order, order.cues[0], loop=True)
    (offer,) = offers(order)
    world = order.world
    assert offers(order, world.approver) == []
    assert refused(dismiss(order, offer["offer"], by=world.approver)) == (403, "not-your-contract")
    for client in (world.reviewer, world.other_designer, world.stranger):
        assert dismiss(order, offer["offer"], by=client).status_code == 404


@pytest.mark.slow
def test_it_neither_blocks_nor_charges(order: Order) -> None:
    cue = order.cues[0]
    take = order.take(cue)
    edit(order, cue, description="A ping with a long tail")
    before = order.owed()
    assert len(offers(order)) == 1
    order.approve(take)
    assert order.owed() == [*before, ("accepted", 18_000)]


@pytest.mark.slow
def test_a_settled_offer_that_a_proposal_names_is_left_out(order: Order) -> None:
    order.take(order.cues[0])
    edit(order, order.cues[0], loop=True)
    (offer,) = offers(order)
    body_of(dismiss(order, offer["offer"]))
    answer = order.propose(about("add_round", order.cues[1]), offers=[offer["offer"], "spec:9"])
    assert answer.status_code == 201
    assert len(offers(order, order.world.designer)) == 1, "the designer's stands"


def refer(order: Order, **facts: Any) -> str:
    """Put a link on the board as the producer, and return the reference's id."""
    body = {"url": "https://example.com/clank", "caption": "The clank we mean", **facts}
    answer = order.world.producer.post(f"/v1/projects/{order.world.project_id}/references", json=body)
    assert answer.status_code == 201, answer.text
    return str(answer.json()["id"])


@pytest.mark.slow
@pytest.mark.both_databases
def test_a_reference_after_work_on_its_cue_began(order: Order) -> None:
    refer(order, cue_id=str(order.cues[0]))
    assert offers(order) == [], "work on the cue has not begun"
    order.take(order.cues[0])
    reference = refer(order, cue_id=str(order.cues[0]))
    (offer,) = offers(order, order.world.designer)
    assert "The reference The clank we mean was added after work on" in offer["text"]
    assert (offer["kind"], offer["who"], offer["change"]["kind"]) == ("reference", "Producer", "reprice_cue")
    settle(order, offer, price_minor=20_000)
    newer = {"url": "https://example.com/another"}
    added = order.world.producer.post(f"/v1/references/{reference}/versions", json=newer)
    assert added.status_code == 201, added.text
    assert kinds(order) == ["reference"], "a new version asks again"


def test_a_reference_for_the_project_or_another_category_offers_nothing(order: Order) -> None:
    order.take(order.cues[0])
    refer(order)
    assert offers(order) == []
