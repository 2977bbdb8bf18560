"""Invoices, payments and refunds over HTTP: numbers without gaps, tax by rate, and every cent laid out."""

import io
from typing import Any

import pytest
from pypdf import PdfReader

from tests.app.money.agreed import TODAY, Agreed, day, deposit, milestone
from tests.app.reviews.making import body_of, refused
from tests.support.server import World


@pytest.fixture
def agreed(world: World) -> Agreed:
    return Agreed(world)


def accept_alpha(agreed: Agreed, **more: Any) -> None:
    """Agree on a deposit of 100.00 and a cue of 180.00, and accept it."""
    cue = agreed.cue("radar_ping")
    agreed.agree(deposit(10_000), milestone("Alpha", cue, amount_minor=18_000, **more))
    agreed.approve(agreed.take(cue))


def refund(agreed: Agreed, payment_id: str, amount_minor: int) -> Any:
    body = {"amount_minor": amount_minor, "reference": "R-1", "paid_on": TODAY.isoformat()}
    return agreed.world.producer.post(f"/v1/payments/{payment_id}/refunds", json=body)


@pytest.mark.slow
def test_everything_due_is_invoiced_once(agreed: Agreed) -> None:
    accept_alpha(agreed)
    draft = body_of(agreed.world.designer.get(f"/v1/contracts/{agreed.contract_id}/invoice-draft"))
    assert (draft["number"], draft["total_minor"]) == (1, 28_000)
    issued = agreed.invoice(po_number="PO-77")
    assert [line["amount_minor"] for line in issued["lines"]] == [10_000, 18_000]
    assert issued["lines"][0]["text"] == "Deposit, due at signing"
    assert issued["lines"][1]["text"].endswith("radar_ping, accepted (Alpha)")
    assert (issued["number"], issued["po_number"], issued["due_on"]) == (1, "PO-77", day(14))
    assert (issued["total_minor"], issued["open_minor"], issued["state"]) == (28_000, 28_000, "open")
    again = agreed.world.designer.post(f"/v1/contracts/{agreed.contract_id}/invoices", json={"seller": "me"})
    assert refused(again) == (409, "nothing-to-invoice")


@pytest.mark.slow
def test_an_invoice_begins_with_the_purchase_order_that_was_agreed_on(world: World) -> None:
    agreed = Agreed(world, terms={"po_number": "PO-77"})
    accept_alpha(agreed)
    draft = body_of(agreed.world.designer.get(f"/v1/contracts/{agreed.contract_id}/invoice-draft"))
    assert draft["po_number"] == "PO-77"
    assert agreed.invoice()["po_number"] == "PO-77"


@pytest.mark.slow
def test_tax_of_each_rate_is_rounded_once(world: World) -> None:
    agreed = Agreed(world, terms={"tax_bp": 1_900}, currency="EUR")
    first, second = agreed.cue("radar_ping"), agreed.cue("vo_oath")
    agreed.agree(
        milestone("Alpha", first, amount_minor=10_003),
        milestone("Voice", second, amount_minor=10_050, tax_bp=700, due_on=day(30)),
    )
    agreed.approve(agreed.take(first))
    agreed.approve(agreed.take(second))
    issued = agreed.invoice()
    assert issued["taxes"] == [
        {"tax_bp": 700, "amount_minor": 704},  # 703.5, away from zero
        {"tax_bp": 1_900, "amount_minor": 1_901},  # 1900.57
    ]
    assert issued["total_minor"] == 10_003 + 10_050 + 704 + 1_901
    figures = agreed.figures()
    assert figures["due_minor"] == 20_053  # without tax, which the ledger keeps separate
    assert agreed.ledger()["open_tax_minor"] == 2_605


@pytest.mark.slow
def test_under_reverse_charge_no_tax_is_invoiced(world: World) -> None:
    agreed = Agreed(world, terms={"tax_bp": 1_900, "reverse_charge": True}, currency="EUR")
    accept_alpha(agreed, tax_bp=700)
    issued = agreed.invoice()
    assert (issued["reverse_charge"], issued["taxes"], issued["total_minor"]) == (True, [], 28_000)


@pytest.mark.slow
def test_a_part_is_paid_then_the_rest(agreed: Agreed) -> None:
    accept_alpha(agreed)
    issued = agreed.invoice()
    part = agreed.pay(issued, 12_000).json()
    assert (part["paid_minor"], part["open_minor"], part["state"]) == (12_000, 16_000, "partly_paid")
    paid = [line for line in agreed.ledger()["lines"] if line["kind"] == "paid"]
    assert [(line["milestone"], line["amount_minor"]) for line in paid] == [("Deposit", 10_000), ("Alpha", 2_000)]
    assert refused(agreed.pay(issued, 16_001)) == (422, "overpayment")
    assert refused(agreed.pay(issued, 0)) == (422, "overpayment")
    whole = agreed.pay(issued, 16_000, "T-2").json()
    assert (whole["state"], whole["open_minor"], whole["days_to_pay"]) == ("paid", 0, 0)
    assert agreed.figures()["due_minor"] == 0


@pytest.mark.slow
def test_a_refund_is_reversing_lines(agreed: Agreed) -> None:
    accept_alpha(agreed)
    issued = agreed.pay(agreed.invoice(), 28_000).json()
    payment_id = issued["payments"][0]["id"]
    back = refund(agreed, payment_id, 5_000).json()
    assert (back["paid_minor"], back["open_minor"]) == (23_000, 5_000)
    assert [one["amount_minor"] for one in back["payments"]] == [28_000, -5_000]
    assert back["payments"][0]["left_minor"] == 23_000
    assert refused(refund(agreed, payment_id, 23_001)) == (422, "refund-too-large")
    assert refused(refund(agreed, back["payments"][1]["id"], 1)) == (404, "payment-not-found")
    assert agreed.owed()[-1] == ("refunded", -5_000)


@pytest.mark.slow
def test_what_lies_ahead_was_not_paid_yet(agreed: Agreed) -> None:
    accept_alpha(agreed)
    issued = agreed.invoice()
    body = {"amount_minor": 28_000, "reference": "T-1", "paid_on": day(2)}
    ahead = agreed.world.producer.post(f"/v1/invoices/{issued['id']}/payments", json=body)
    assert refused(ahead) == (422, "day-in-future")
    body["paid_on"] = day(1)  # somewhere it is tomorrow already
    paid = agreed.world.producer.post(f"/v1/invoices/{issued['id']}/payments", json=body).json()
    back = body | {"amount_minor": 1, "paid_on": day(2)}
    refund_ahead = agreed.world.producer.post(f"/v1/payments/{paid['payments'][0]['id']}/refunds", json=back)
    assert refused(refund_ahead) == (422, "day-in-future")


@pytest.mark.slow
def test_what_was_paid_and_taken_back_is_credited_on_the_next_invoice(agreed: Agreed) -> None:
    first, second = agreed.cue("radar_ping"), agreed.cue("dock_clamp")
    agreed.agree(milestone("Alpha", first, second, amount_minor=36_000))
    take = agreed.take(first)
    agreed.approve(take)
    agreed.pay(agreed.invoice(), 18_000)
    agreed.draft(take, seen_state="approved")
    agreed.send()
    assert agreed.figures()["due_minor"] == -18_000
    agreed.approve(agreed.take(second))
    credited = agreed.invoice()
    assert [line["amount_minor"] for line in credited["lines"]] == [-18_000, 18_000]
    assert (credited["number"], credited["total_minor"], credited["state"]) == (2, 0, "paid")


@pytest.mark.slow
def test_numbers_count_without_gaps_for_each_designer_of_a_studio(agreed: Agreed) -> None:
    cues = [agreed.cue(f"cue_{number}") for number in range(3)]
    agreed.agree(milestone("Alpha", *cues, amount_minor=30_000))
    numbers = []
    for cue in cues:
        agreed.approve(agreed.take(cue))
        numbers.append(agreed.invoice()["number"])
        agreed.world.designer.post(f"/v1/contracts/{agreed.contract_id}/invoices", json={"seller": "me"})  # nothing due
    assert numbers == [1, 2, 3]


@pytest.mark.slow
def test_the_pdf_is_the_same_each_time(agreed: Agreed) -> None:
    accept_alpha(agreed)
    invoice = agreed.invoice()
    address = f"/v1/invoices/{invoice['id']}/invoice.pdf"
    first, second = agreed.world.producer.get(address), agreed.world.designer.get(address)
    assert first.headers["content-type"] == "application/pdf"
    assert first.content == second.content
    text = PdfReader(io.BytesIO(first.content)).pages[0].extract_text()
    assert text.startswith(f"Invoice {invoice['full_number']}")
    for amount in ("100.00", "180.00", "280.00"):
        assert amount in text


@pytest.mark.slow
def test_a_plan_is_fixed_once_agreed_and_says_all_its_faults_before(agreed: Agreed) -> None:
    cue = agreed.cue("radar_ping")
    wrong = agreed.plan(
        {"name": "Alpha", "cues": [{"cue_id": str(cue), "price_minor": 100}], "amount_minor": 200},
        {"name": "Beta", "cues": [{"cue_id": str(cue)}]},
    )
    problem = wrong.json()
    assert refused(wrong) == (422, "bad-plan")
    assert [one["where"] for one in problem["errors"]] == ["milestones.0", "milestones.1", "milestones"]
    accept_alpha(agreed)
    assert refused(agreed.plan()) == (409, "plan-locked")
    by_designer = agreed.world.designer.put(f"/v1/contracts/{agreed.contract_id}/milestones", json={"milestones": []})
    assert refused(by_designer) == (403, "producer-needed")


@pytest.mark.slow
def test_estimates_are_for_the_two_parties(agreed: Agreed) -> None:
    cues = [agreed.cue(f"cue_{number}") for number in range(3)]
    planned = milestone("Alpha", amount_minor=30_000, due_on=day(10))
    planned["cues"] = [{"cue_id": str(cue), "estimate_min": 100} for cue in cues]
    agreed.agree(planned)
    for cue, minutes in zip(cues, (120, 140, 130), strict=True):
        body = {"cue_id": str(cue), "minutes": minutes, "worked_on": day(0)}
        answer = agreed.world.designer.post(f"/v1/contracts/{agreed.contract_id}/work-logs", json=body)
        assert answer.status_code == 204, answer.text
    for cue in cues[:2]:
        agreed.approve(agreed.take(cue))
    address = f"/v1/contracts/{agreed.contract_id}/estimates"
    assert body_of(agreed.world.producer.get(address))["cue_habit"]["habit"] == "unknown"  # two are too few
    agreed.approve(agreed.take(cues[2]))
    read = body_of(agreed.world.designer.get(address))
    assert read["cue_habit"]["mean_percent"] == pytest.approx(30)
    assert read["cue_habit"]["habit"] == "steady"
    assert read["pay"] == {
        "currency": "USD",
        "fee_minor": 30_000,
        "estimated_min": 300,
        "logged_min": 390,
        "own_min": 0,
        "by_estimate_minor": 6_000,
        "by_log_minor": 4_615,  # 300.00 of 6.5 hours
    }
    assert body_of(agreed.world.producer.get(address))["pay"] is None
    assert refused(agreed.world.approver.get(address)) == (403, "producer-needed")


@pytest.mark.slow
def test_a_steady_habit_forecasts_the_open_milestone(agreed: Agreed) -> None:
    cues = [agreed.cue(f"cue_{number}") for number in range(4)]
    alpha = milestone("Alpha", amount_minor=30_000, due_on=day(10))
    alpha["cues"] = [{"cue_id": str(cue), "estimate_min": 100} for cue in cues[:3]]
    agreed.agree(alpha, milestone("Beta", cues[3], amount_minor=30_000, due_on=day(20)))
    for cue in cues[:3]:
        body = {"cue_id": str(cue), "minutes": 150, "worked_on": day(0)}
        agreed.world.designer.post(f"/v1/contracts/{agreed.contract_id}/work-logs", json=body)
        agreed.approve(agreed.take(cue))
    read = body_of(agreed.world.producer.get(f"/v1/contracts/{agreed.contract_id}/estimates"))
    (forecast,) = read["forecasts"]
    assert (forecast["milestone"], forecast["due_on"], forecast["forecast_on"]) == ("Beta", day(20), day(30))


def test_the_project_page_sums_up(agreed: Agreed) -> None:
    accept_alpha(agreed, due_on=day(-4))
    other = body_of(agreed.world.producer.get(f"/v1/projects/{agreed.world.project_id}/money"))
    (contract,) = other["contracts"]
    assert other["totals"] == [{"currency": "USD", "figures": contract["figures"]}]
    assert contract["billable_minor"] == 28_000
    (slip,) = contract["slips"]
    assert (slip["days"], slip["designer_days"] + slip["studio_days"]) == (4, 4)
    assert agreed.world.stranger.get(f"/v1/projects/{agreed.world.project_id}/money").status_code == 404
