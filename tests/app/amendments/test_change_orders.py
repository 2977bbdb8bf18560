"""Change orders: proposed by either party, read as a difference, in force when both have accepted the text."""

from datetime import timedelta
from typing import Any
from uuid import UUID, uuid4

import pytest

from app.agreements.queries import events_of
from app.amendments.rules import Difference, Planned, changed_plan, warnings_of
from app.deliveries.rules import TakeState
from tests.app.agreements.conftest import Contracts
from tests.app.money.agreed import TODAY, Agreed, day, deposit, milestone
from tests.app.reviews.making import body_of, refused
from tests.support.pdfs import text_of
from tests.support.server import World


class Order(Agreed):
    """A stage with two milestones under contract, whose parties propose and accept changes."""

    def __post_init__(self) -> None:
        self.terms = {"notice_days": 14, "rush_days": 3, "rush_bp": 3_000, **self.terms}
        super().__post_init__()
        self.cues = [self.cue(name) for name in ("radar_ping", "dock_clamp", "mine_arm", "missile_launch")]
        self.agree(
            deposit(25_000),
            milestone("Alpha", *self.cues[:2], amount_minor=36_000, due_on=day(14)),
            milestone("Beta", *self.cues[2:], amount_minor=63_000, due_on=day(28)),
        )
        plan = body_of(self.world.producer.get(f"/v1/contracts/{self.contract_id}/milestones"))
        self.milestones = {one["name"]: one["id"] for one in plan["milestones"]}

    @property
    def path(self) -> str:
        return f"/v1/contracts/{self.contract_id}/change-orders"

    def propose(self, *changes: dict[str, Any], by: Any = None, **more: Any) -> Any:
        body = {"reason": "The level grew", "changes": list(changes), **more}
        return (by or self.world.producer).post(self.path, json=body)

    def read(self, by: Any = None) -> dict[str, Any]:
        return body_of((by or self.world.producer).get(self.path))

    def accept(self, by: Any, name: str = "A. Name", number: int = 0) -> Any:
        order = self.read()["orders"][number - 1]
        body = {"name": name, "text_sha256": order["text_sha256"]}
        return by.post(f"{self.path}/{order['number']}/accept", json=body)

    def in_force(self, *changes: dict[str, Any]) -> dict[str, Any]:
        """Propose changes and have both accept them; return the order."""
        answer = self.propose(*changes)
        assert answer.status_code == 201, answer.text
        body_of(self.accept(self.world.designer, "N. Designer"))
        return body_of(self.accept(self.world.producer, "P. Producer"))["orders"][-1]

    def plan_now(self) -> list[tuple[str, int, str | None]]:
        plan = body_of(self.world.designer.get(f"/v1/contracts/{self.contract_id}/milestones"))
        return [(one["name"], one["amount_minor"], one["due_on"]) for one in plan["milestones"]]

    def entries(self) -> list[str]:
        return self.world.server.in_database(
            lambda session: [entry.kind for entry in events_of(session, self.contract_id)]
        )


@pytest.fixture
def order(world: World) -> Order:
    return Order(world)


def add(order: Order, cue_id: UUID, price_minor: int = 22_500, to: str = "Beta") -> dict[str, Any]:
    return {"kind": "add_cue", "cue_id": str(cue_id), "milestone_id": order.milestones[to], "price_minor": price_minor}


def about(kind: str, cue_id: UUID, **more: Any) -> dict[str, Any]:
    return {"kind": kind, "cue_id": str(cue_id), **more}


def move(order: Order, name: str, due_on: str) -> dict[str, Any]:
    return {"kind": "move_date", "milestone_id": order.milestones[name], "due_on": due_on}


@pytest.mark.slow
@pytest.mark.both_databases
def test_it_holds_when_both_have_accepted(order: Order) -> None:
    shield = order.cue("shield_down")
    changes = [add(order, shield), about("add_round", order.cues[3]), move(order, "Beta", day(32))]
    assert order.propose(*changes, by=order.world.designer).status_code == 201
    (proposed,) = order.read()["orders"]
    difference = proposed["difference"]
    assert (difference["cues_before"], difference["cues_after"]) == (4, 5)
    assert difference["price_after_minor"] - difference["price_before_minor"] == 22_500 + 7_875
    assert [one["amount_after_minor"] for one in difference["milestones"]] == [25_000, 36_000, 85_500]
    assert [one["due_after"] for one in difference["milestones"]][1:] == [day(14), day(32)]
    assert difference["warnings"] == []
    before = order.owed()
    body_of(order.accept(order.world.designer, "N. Designer"))
    assert (order.owed(), order.plan_now()[2]) == (before, ("Beta", 63_000, day(28)))
    agreed = body_of(order.accept(order.world.producer, "P. Producer"))["orders"][0]
    assert (agreed["state"], [one["party"] for one in agreed["signed"]]) == ("agreed", ["designer", "studio"])
    assert order.plan_now()[2] == ("Beta", 85_500, day(32))
    assert order.owed() == [*before, ("extra_round", 7_875)]
    assert order.entries()[-6:] == [
        "change_proposed", "change_accepted", "change_accepted", "changed", "due", "planned",
    ]  # fmt: skip
    order.approve(order.take(shield))
    assert order.owed()[-1] == ("accepted", 22_500)
    figures = order.figures()
    assert figures["agreed_minor"] == 25_000 + 36_000 + 85_500 + 7_875


@pytest.mark.slow
def test_a_cue_in_work_is_taken_out_at_its_kill_fee(order: Order) -> None:
    order.take(order.cues[2], state=TakeState.RETURNED)
    order.propose(about("cut_cue", order.cues[2]))
    (proposed,) = order.read()["orders"]
    difference = proposed["difference"]
    assert difference["price_after_minor"] - difference["price_before_minor"] == -15_750
    order.take(order.cues[2], state=TakeState.CONFORMING)  # the state counts when both have agreed
    body_of(order.accept(order.world.designer))
    body_of(order.accept(order.world.producer))
    assert order.owed()[-1] == ("cut", 23_625)
    listed = body_of(order.world.producer.get(f"/v1/cues/{order.cues[2]}"))
    assert listed["state"] != "cut", "the list keeps it, for another contract"


@pytest.mark.slow
def test_a_price_is_changed_and_its_milestone_with_it(order: Order) -> None:
    order.in_force(about("reprice_cue", order.cues[0], price_minor=20_000))
    assert order.plan_now()[1] == ("Alpha", 38_000, day(14))
    order.approve(order.take(order.cues[0]))
    assert order.owed()[-1] == ("accepted", 20_000)


@pytest.mark.slow
def test_work_beside_the_cues_is_due_when_both_agree(order: Order) -> None:
    body = {"milestone_id": order.milestones["Alpha"], "text": "Voice session, two hours", "amount_minor": 50_000}
    order.in_force({"kind": "add_work", **body})
    assert order.owed()[-1] == ("extra_work", 50_000)
    figures = order.figures()
    assert (figures["agreed_minor"], figures["due_minor"]) == (25_000 + 99_000 + 50_000, 75_000)
    lines = order.invoice()["lines"]
    assert lines[-1] == {"text": "Work by a change order (Alpha)", "amount_minor": 50_000, "tax_bp": None}


@pytest.mark.slow
def test_a_round_agreed_beforehand_is_not_proposed_again(order: Order) -> None:
    cue = order.cues[0]
    order.in_force(about("add_round", cue))
    for _ in range(3):
        order.draft(order.take(cue))
        order.send()
    rounds = shown_list(order.world.producer.get(f"/v1/contracts/{order.contract_id}/extra-rounds"))
    assert [(one["number"], one["state"]) for one in rounds] == [(3, "agreed")]
    assert order.owed().count(("extra_round", 4_500)) == 1


@pytest.mark.slow
def test_a_third_round_is_offered_by_itself_and_a_change_order_agrees_to_it(order: Order) -> None:
    cue = order.cues[0]
    for _ in range(3):
        order.draft(order.take(cue))
        order.send()
    order.in_force(about("add_round", cue))
    rounds = shown_list(order.world.producer.get(f"/v1/contracts/{order.contract_id}/extra-rounds"))
    assert [(one["number"], one["state"]) for one in rounds] == [(3, "agreed")]


def shown_list(answer: Any) -> list[dict[str, Any]]:
    assert answer.status_code == 200, answer.text
    body: list[dict[str, Any]] = answer.json()
    return body


def problems_of(order: Order, *changes: dict[str, Any]) -> list[str]:
    """Return what a preview says is wrong, which a proposal is refused for."""
    path = f"/v1/contracts/{order.contract_id}/change-order-preview"
    previewed = body_of(order.world.producer.post(path, json={"changes": list(changes)}))
    if previewed["problems"]:
        assert previewed["difference"] is None
        assert refused(order.propose(*changes)) == (422, "bad-change-order")
    return previewed["problems"]


@pytest.mark.slow
def test_what_is_refused_and_the_act_that_works(order: Order) -> None:
    """Each refusal names an act; the act is done, and works."""
    accepted, cut = order.cues[:2]
    order.approve(order.take(accepted))
    order.in_force(about("cut_cue", cut))
    beta = order.cues[2]
    (said,) = problems_of(order, about("reprice_cue", accepted, price_minor=1))
    assert "add work to its milestone instead" in said
    work = {"kind": "add_work", "milestone_id": order.milestones["Alpha"], "text": "Polish", "amount_minor": 1}
    assert problems_of(order, work) == []
    assert "sign another contract for it" in problems_of(order, about("add_round", cut))[0]
    assert "change its price instead" in problems_of(order, add(order, beta))[0]
    assert problems_of(order, about("reprice_cue", beta, price_minor=1)) == []
    assert "name a milestone that is open" in problems_of(order, add(order, order.cue("new"), to="Alpha"))[0]
    assert problems_of(order, add(order, order.cue("newer"))) == []
    assert "give Beta a day to come" in problems_of(order, move(order, "Beta", day(-1)))[0]
    assert "put it on the sound list first" in problems_of(order, add(order, uuid4()))[0]
    twice = problems_of(order, about("add_round", beta), about("cut_cue", beta))
    assert twice == ["one cue, date or cap is named by two changes; leave one of them out"]


@pytest.mark.slow
def test_without_a_price_of_rounds_none_is_invented(world: World) -> None:
    order = Order(world, terms={"extra_round_bp": 0})
    (said,) = problems_of(order, about("add_round", order.cues[0]))
    assert "the contract names no price of a further round" in said
    assert problems_of(order, about("reprice_cue", order.cues[0], price_minor=20_000)) == []


@pytest.mark.slow
def test_an_order_that_no_longer_fits_is_not_agreed(order: Order) -> None:
    cue = order.cues[0]
    order.propose(about("reprice_cue", cue, price_minor=20_000))
    body_of(order.accept(order.world.designer))
    order.approve(order.take(cue))
    assert refused(order.accept(order.world.producer)) == (409, "change-order-stale")
    (shown,) = order.read()["orders"]
    assert (shown["may"]["agree"], len(shown["problems"])) == (False, 1)
    body_of(order.world.producer.post(f"{order.path}/1/withdraw", json={"reason": "It is accepted"}))
    again = {"kind": "add_work", "milestone_id": order.milestones["Alpha"], "text": "Polish", "amount_minor": 2_000}
    order.in_force(again)
    assert order.owed()[-1] == ("extra_work", 2_000)


@pytest.mark.slow
def test_two_orders_on_one_milestone(order: Order) -> None:
    order.propose(about("reprice_cue", order.cues[0], price_minor=20_000))
    order.propose(about("reprice_cue", order.cues[1], price_minor=21_000))
    body_of(order.accept(order.world.designer, number=1))
    body_of(order.accept(order.world.designer, number=2))
    body_of(order.accept(order.world.producer, number=1))
    assert refused(order.accept(order.world.producer, number=2)) == (409, "change-order-stale")


@pytest.mark.slow
def test_refused_or_withdrawn_by_the_right_party(order: Order) -> None:
    order.propose(about("add_round", order.cues[0]), by=order.world.designer)
    reason = {"json": {"reason": "Too dear"}}
    assert refused(order.world.designer.post(f"{order.path}/1/refuse", **reason)) == (409, "own-change-order")
    assert refused(order.world.producer.post(f"{order.path}/1/withdraw", **reason)) == (409, "not-own-change-order")
    closed = body_of(order.world.producer.post(f"{order.path}/1/refuse", **reason))["orders"][0]
    assert (closed["state"], closed["close_reason"]) == ("refused", "Too dear")
    assert refused(order.accept(order.world.designer)) == (409, "change-order-closed")
    assert order.entries()[-1] == "change_refused"
    assert refused(order.world.producer.post(f"{order.path}/2/refuse", **reason)) == (404, "change-order-not-found")


@pytest.mark.slow
def test_one_person_does_not_sign_for_both(order: Order) -> None:
    order.propose(about("add_round", order.cues[0]))
    body_of(order.accept(order.world.producer))
    assert refused(order.accept(order.world.producer)) == (409, "already-accepted")


@pytest.mark.slow
def test_an_end_lapses_what_is_proposed(order: Order, contracts: Contracts) -> None:
    order.propose(about("add_round", order.cues[0]))
    contracts.end({"id": str(order.contract_id)})
    (shown,) = order.read()["orders"]
    assert shown["state"] == "lapsed"
    assert refused(order.propose(about("add_round", order.cues[0]))) == (409, "not-in-force")


@pytest.mark.slow
def test_only_batches_of_a_framework_are_changed(world: World, contracts: Contracts) -> None:
    framework = contracts.agree(contracts.begin("framework"))
    body = {"reason": "More", "changes": [{"kind": "cut_cue", "cue_id": str(uuid4())}]}
    answer = world.producer.post(f"/v1/contracts/{framework['id']}/change-orders", json=body)
    assert refused(answer) == (409, "not-in-force")
    assert answer.json()["fix"] == "propose it to the batch that has the cues"


@pytest.mark.slow
def test_who_sees_and_who_proposes(order: Order) -> None:
    world = order.world
    order.propose(about("add_round", order.cues[0]))
    for client in (world.reviewer, world.other_designer, world.stranger):
        assert client.get(order.path).status_code == 404
        assert client.get(f"{order.path}/1/change-order.pdf").status_code == 404
    assert world.approver.get(order.path).status_code == 200
    assert refused(order.propose(about("add_round", order.cues[0]), by=world.approver)) == (403, "not-your-contract")


@pytest.mark.slow
def test_the_text_says_what_changes_and_nothing_else(order: Order) -> None:
    order.propose(about("reprice_cue", order.cues[0], price_minor=20_000), begins_at_once=True)
    (shown,) = order.read()["orders"]
    words = " ".join("".join(span["text"] for span in block["spans"]) for block in shown["blocks"])
    assert "radar_ping costs USD 200.00 instead of USD 180.00." in words
    assert "Work may begin before both have agreed, at the risk of the studio." in words
    (table,) = [block["rows"] for block in shown["blocks"] if block["rows"]]
    assert ["".join(span["text"] for span in row[0]) for row in table] == ["Milestone", "Alpha"]


@pytest.mark.slow
def test_the_order_as_pdf(order: Order) -> None:
    order.propose(about("add_round", order.cues[0]))
    first = order.world.designer.get(f"{order.path}/1/change-order.pdf")
    (change,) = order.read()["orders"][-1]["difference"]["changes"]
    assert change in text_of(first.content)
    assert first.content == order.world.producer.get(f"{order.path}/1/change-order.pdf").content


ALPHA, BETA = (Planned(uuid4(), name, 36_000, TODAY + timedelta(days=30), 2) for name in ("Alpha", "Beta"))


def warned(*differences: Difference, days: int = 0) -> list[str]:
    plan = [ALPHA, BETA]
    after = changed_plan(plan, differences)
    said = warnings_of(plan, after, TODAY + timedelta(days=days), rush_days=3, rush_bp=3_000)
    return [one.code for one in said]


@pytest.mark.parametrize(
    ("differences", "days", "codes"),
    [
        ([Difference(ALPHA.milestone_id, 1_000, cues=1)], 0, []),
        ([Difference(ALPHA.milestone_id, due_on=TODAY + timedelta(days=20))], 0, []),
        ([Difference(ALPHA.milestone_id, 1_000, 1, TODAY + timedelta(days=20))], 0, ["earlier-and-more"]),
        ([Difference(ALPHA.milestone_id, due_on=TODAY + timedelta(days=40))], 0, []),
        ([Difference(ALPHA.milestone_id, 1_000, cues=1)], 29, ["rush"]),
        ([Difference(ALPHA.milestone_id, cues=-1)], 29, []),
    ],
)
def test_less_time_for_more_work_is_pointed_out(differences: list[Difference], days: int, codes: list[str]) -> None:
    assert warned(*differences, days=days) == codes


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["add_work", "add_round"])
def test_work_beside_the_cues_is_more_work_too(order: Order, kind: str) -> None:
    work = {"kind": "add_work", "milestone_id": order.milestones["Alpha"], "text": "Voice session", "amount_minor": 900}
    added = work if kind == "add_work" else about("add_round", order.cues[0])
    body = {"changes": [added, move(order, "Alpha", day(10))]}
    preview = body_of(order.world.producer.post(f"/v1/contracts/{order.contract_id}/change-order-preview", json=body))
    assert preview["problems"] == []
    assert [one["code"] for one in preview["difference"]["warnings"]] == ["earlier-and-more"]
    body = {"changes": [added, move(order, "Alpha", day(20))]}
    later = body_of(order.world.producer.post(f"/v1/contracts/{order.contract_id}/change-order-preview", json=body))
    assert later["difference"]["warnings"] == []


@pytest.mark.slow
def test_only_what_a_change_adds_or_worsens_is_warned_of(world: World) -> None:
    order = Order(world)
    # Its plan has warnings of its own: the last milestone holds more than half back.
    before = body_of(world.producer.get(f"/v1/contracts/{order.contract_id}/milestones"))["advice"]
    assert [one["code"] for one in before] == ["too-much-held-back"]
    moved = {"changes": [move(order, "Beta", day(40))]}
    difference = body_of(world.producer.post(f"/v1/contracts/{order.contract_id}/change-order-preview", json=moved))[
        "difference"
    ]
    assert (difference["advice"], difference["advice_gone"]) == ([], [])
    dearer = {"changes": [add(order, order.cue("shield_down"), 40_000)]}
    difference = body_of(world.producer.post(f"/v1/contracts/{order.contract_id}/change-order-preview", json=dearer))[
        "difference"
    ]
    assert [one["code"] for one in difference["advice"]] == ["deposit-low", "too-much-held-back"]
    assert difference["advice_gone"] == []
    evened = {"changes": [add(order, order.cue("hatch"), 30_000, to="Alpha")]}
    difference = body_of(world.producer.post(f"/v1/contracts/{order.contract_id}/change-order-preview", json=evened))[
        "difference"
    ]
    assert [one["code"] for one in difference["advice_gone"]] == ["too-much-held-back"]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("Mixing, USD 2,000", "“USD 2,000” is typed"),
        ("Mixing for 2,000 dollars", "is typed"),
        ("Three further rounds for the UI", "the contract counts 2"),
    ],
)
def test_a_change_order_types_no_figure_that_it_does_not_set(order: Order, text: str, words: str) -> None:
    work = {"kind": "add_work", "milestone_id": order.milestones["Beta"], "text": text, "amount_minor": 50_000}
    unproposed = order.propose(work)
    assert refused(unproposed) == (422, "bad-change-order")
    assert words in unproposed.json()["detail"]
    fine = work | {"text": "Mixing, USD 500"}
    because = order.propose(fine, reason="The price now includes 4 rounds.")
    assert refused(because) == (422, "bad-change-order")
    assert [one["where"] for one in because.json()["errors"]] == ["reason"]
    assert order.propose(fine).status_code == 201


@pytest.mark.slow
def test_a_contract_under_notice_says_when_it_ends(order: Order) -> None:
    world, path = order.world, f"/v1/contracts/{order.contract_id}"
    assert body_of(world.producer.get(path))["notice"] is None
    body_of(world.producer.post(f"{path}/ending/notice", json={"reason": "The game was cancelled."}))
    read = body_of(world.producer.get(path))
    assert (read["state"], read["notice"]["ends_on"]) == ("agreed", day(14))
    for by in (world.producer, world.designer):
        (listed,) = body_of(by.get(f"/v1/projects/{world.project_id}/contracts"))
        assert (listed["state"], listed["notice"]) == ("agreed", read["notice"])
    body_of(world.producer.post(f"{path}/ending/withdraw", json={}))
    assert body_of(world.producer.get(path))["notice"] is None
