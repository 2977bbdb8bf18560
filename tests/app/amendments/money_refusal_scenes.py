"""Refusals about money, each followed by the act that its text advises."""

from datetime import timedelta
from typing import Any
from uuid import UUID

from app.money.models import Invoice
from tests.app.amendments.refusal_parties import ENDED, Parties, advised, granted, scene
from tests.app.money.agreed import TODAY, day, deposit, milestone

BY_DAY = {"price_mode": "day_rate", "day_rate_minor": 40_000, "days_cap": 1}
BY_HOUR = {"hour_rate_minor": 6_000, "hours_cap": 2, "hours_month_cap": 2}


def invoice(parties: Parties, contract: dict[str, Any], **more: Any) -> Any:
    return parties.post(parties.designer, contract, "invoices", seller="Sound designer", **more)


def pay(parties: Parties, bill: dict[str, Any], amount_minor: int, by: Any = None, on: str = day(0)) -> Any:
    body = {"amount_minor": amount_minor, "reference": "T-1", "paid_on": on}
    return (by or parties.producer).post(f"/v1/invoices/{bill['id']}/payments", json=body)


def with_deposit(parties: Parties, **terms: Any) -> dict[str, Any]:
    return parties.agreed(deposit(10_000), milestone("Alpha", parties.cue(), amount_minor=20_000), **terms)


def log(parties: Parties, contract: dict[str, Any], by: Any = None, on: str = day(-1), **work: Any) -> Any:
    return parties.post(by or parties.designer, contract, "worked-days", worked_on=on, note="Directing", **work)


def judge(by: Any, entry: dict[str, Any], how: str) -> Any:
    body = {"reason": "It was cancelled"} if how == "refuse" else None
    return by.post(f"/v1/worked-days/{entry['id']}/{how}", json=body)


def by_hour(parties: Parties) -> dict[str, Any]:
    return parties.agreed(milestone("Alpha", parties.cue(), amount_minor=20_000), **BY_HOUR)


def by_day(parties: Parties) -> dict[str, Any]:
    return parties.agreed(milestone("Alpha", parties.cue(), amount_minor=0), **BY_DAY)


@scene(
    "money.work.service.log_work OtherPartyNeeded",
    "money.work.service.correct_work OtherPartyNeeded",
    "money.work.service.drop_day OtherPartyNeeded",
    "money.work.service._ensure_producer ProducerNeeded",
    "money.work.service._ensure_not_refused DayRefused",
    "money.work.service._ensure_not_agreed DayAgreed",
)
def _work_is_logged_by_one_party_and_agreed_to_by_the_other(parties: Parties) -> None:
    contract, producer, designer = by_hour(parties), parties.producer, parties.designer
    advised(log(parties, contract, by=producer, minutes=60), "other-party-needed", "ask the designer to log them")
    entry = granted(log(parties, contract, minutes=60))
    path, body = f"/v1/worked-days/{entry['id']}", {"worked_on": day(-1), "minutes": 30, "note": "Casting"}
    advised(producer.put(path, json=body), "other-party-needed", "refuse it and say why; the designer corrects it")
    advised(producer.delete(path), "other-party-needed", "refuse it and say why")
    for how in ("agree", "refuse"):
        refused = judge(parties.world.approver, entry, how)
        advised(refused, "producer-needed", "only a producer of the studio")
    granted(judge(producer, entry, "refuse"))
    for how in ("agree", "refuse"):
        advised(judge(producer, entry, how), "day-refused", "wait until the designer corrects it")
    granted(designer.put(path, json=body))
    granted(judge(producer, entry, "agree"))
    for refused in (designer.put(path, json=body), designer.delete(path), judge(producer, entry, "refuse")):
        advised(refused, "day-agreed", "what was agreed to stands; log what is missing on another day")
    granted(log(parties, contract, on=day(-2), minutes=30))


@scene("money.work.service.correct_work DayLogged")
def _a_day_is_corrected_and_the_other_removed(parties: Parties) -> None:
    contract = by_day(parties)
    first = granted(log(parties, contract, quarters=4))
    second = granted(log(parties, contract, on=day(-2), quarters=4))
    body = {"worked_on": day(-1), "quarters": 2}
    refused = parties.designer.put(f"/v1/worked-days/{second['id']}", json=body)
    advised(refused, "day-logged", "correct that day, and remove this one")
    granted(parties.designer.put(f"/v1/worked-days/{first['id']}", json=body))
    granted(parties.designer.delete(f"/v1/worked-days/{second['id']}"))


@scene("money.work.service._entry_of_day CapExceeded")
def _days_beyond_the_cap_are_a_change_order(parties: Parties) -> None:
    contract = by_day(parties)
    entries = [granted(log(parties, contract, on=on, quarters=4)) for on in (day(-1), day(-2))]
    granted(judge(parties.producer, entries[0], "agree"))
    refused = judge(parties.producer, entries[1], "agree")
    advised(refused, "cap-exceeded", "change order that raises the cap of days; agree to this day once it holds")
    parties.change(contract, {"kind": "set_caps", "days_cap": 2})
    granted(judge(parties.producer, entries[1], "agree"))
    third = granted(log(parties, contract, on=day(-3), quarters=4))
    advised(judge(parties.producer, third, "agree"), "cap-exceeded", "or refuse it")
    granted(judge(parties.producer, third, "refuse"))


@scene("money.work.worked_hours.ensure_paid CapExceeded")
def _hours_beyond_the_cap_are_a_change_order(parties: Parties) -> None:
    contract = by_hour(parties)
    granted(log(parties, contract, minutes=90))
    refused = log(parties, contract, minutes=60)
    advised(refused, "cap-exceeded", "log up to 30 min, and propose a change order that raises the caps of hours")
    granted(log(parties, contract, minutes=30))
    parties.change(contract, {"kind": "set_caps", "hours_cap": 3, "hours_month_cap": 3})
    granted(log(parties, contract, minutes=60))
    parties.end(contract)
    bare = parties.agreed(deposit(100), **BY_HOUR)
    refused = log(parties, bare, minutes=150)
    advised(refused, "cap-exceeded", "log up to 2 h, and propose a change order that raises the caps of hours")
    parties.change(bare, {"kind": "set_caps", "hours_cap": 4, "hours_month_cap": 3})
    granted(log(parties, bare, minutes=150))
    parties.end(bare)
    retainer = {"retainer_minor": 90_000, "retainer_hours": 1, "retainer_months": 2}
    retained = parties.agreed(deposit(100), **retainer)
    refused = log(parties, retained, minutes=90)
    advised(refused, "cap-exceeded", "log up to 1 h, and sign another contract for it")
    granted(log(parties, retained, minutes=60))
    parties.begins_another()


@scene("money.work.worked_hours.ensure_paid NotHourly", "money.work.service._ensure_loggable NotDayRate")
def _work_is_logged_in_the_unit_of_the_contract(parties: Parties) -> None:
    daily, hourly = by_day(parties), by_hour(parties)
    advised(log(parties, daily, minutes=60), "not-hourly", "log days instead")
    granted(log(parties, daily, quarters=1))
    advised(log(parties, hourly, quarters=1), "not-day-rate", "log hours instead")
    granted(log(parties, hourly, minutes=60))
    flat = with_deposit(parties)
    advice = "propose a change order that adds the work at its price"
    advised(log(parties, flat, minutes=60), "not-hourly", advice)
    advised(log(parties, flat, quarters=1), "not-day-rate", advice)
    parties.change(flat, parties.extra_work(flat))


@scene(
    "money.work.service._ensure_loggable NotAgreed",
    "money.estimates.service.log_work NotAgreed",
    "money.invoices.service._for_designer NotAgreed",
)
def _work_and_invoices_follow_the_signatures(parties: Parties) -> None:
    contract = parties.sent(deposit(10_000), milestone("Alpha", parties.cue(), amount_minor=20_000), **BY_HOUR)
    time = {"cue_id": str(parties.cues[-1]), "minutes": 5, "worked_on": day(0)}

    def acts() -> list[Any]:
        logged = parties.post(parties.designer, contract, "work-logs", **time)
        return [log(parties, contract, minutes=5), logged]

    for refused in (*acts(), invoice(parties, contract)):
        advised(refused, "not-agreed", "sign the contract first")
    for by in (parties.designer, parties.producer):
        parties.contracts.accept(contract, by, "N. N.")
    for answer in (*acts(), invoice(parties, contract)):
        granted(answer)
    parties.end(contract)
    for refused in acts():
        advised(refused, "not-agreed", "this contract has ended", "this is final", ENDED)
    parties.begins_another()


@scene("money.work.service._ensure_loggable WorkNotNamed", "money.ledger.rules.ensure_not_ahead DayInFuture")
def _work_says_what_and_when_it_was(parties: Parties) -> None:
    contract = by_hour(parties)
    work = {"worked_on": day(0), "minutes": 30}
    refused = parties.post(parties.designer, contract, "worked-days", **work)
    advised(refused, "work-not-named", "choose a cue, or say what they were for")
    granted(parties.post(parties.designer, contract, "worked-days", **work, cue_id=str(parties.cues[0])))
    granted(parties.post(parties.designer, contract, "worked-days", **work, note="Directing"))
    advised(log(parties, contract, on=day(5), minutes=30), "day-in-future", "give the day on which it happened")
    granted(log(parties, contract, on=day(0), minutes=30))


@scene("money.estimates.service.log_work OtherPartyNeeded", "money.estimates.service.estimates ProducerNeeded")
def _time_is_the_parties_own(parties: Parties) -> None:
    contract = parties.agreed()
    time = {"cue_id": str(parties.cues[0]), "minutes": 5, "worked_on": day(0)}
    refused = parties.post(parties.producer, contract, "work-logs", **time)
    advised(refused, "other-party-needed", "ask the designer to log it")
    granted(parties.post(parties.designer, contract, "work-logs", **time))
    path = f"/v1/contracts/{contract['id']}/estimates"
    refused = parties.world.approver.get(path)
    advised(refused, "producer-needed", "seen by that designer and the studio's producers only")
    for by in (parties.designer, parties.producer):
        granted(by.get(path))


@scene(
    "money.invoices.service._for_designer OtherPartyNeeded",
    "money.invoices.service.issue_invoice InvoiceNumberTaken",
    "money.ledger.book.tax_entries NothingToInvoice",
)
def _the_designer_invoices_what_is_due(parties: Parties) -> None:
    contract = with_deposit(parties)
    refused = parties.post(parties.producer, contract, "invoices", seller="Us")
    advised(refused, "other-party-needed", "ask the designer for it")
    granted(invoice(parties, contract, full_number="A-1"))
    advised(invoice(parties, contract, full_number="A-2"), "nothing-to-invoice", "wait until a cue is accepted")
    parties.accept_cue(parties.cues[-1])
    advised(invoice(parties, contract, full_number="A-1"), "invoice-number-taken", "the next one is A-2")
    granted(invoice(parties, contract, full_number="A-2"))


@scene(
    "money.invoices.service.charge_late_interest OtherPartyNeeded",
    "money.invoices.service.charge_late_interest NoInterestDue",
)
def _interest_grows_day_by_day(parties: Parties) -> None:
    contract = with_deposit(parties)
    bill = granted(invoice(parties, contract))
    path = f"/v1/invoices/{bill['id']}/late-interest"
    advised(parties.designer.post(path), "no-interest-due", "wait until the page shows more of it")

    def grow(session: Any) -> None:
        found = session.get_one(Invoice, UUID(bill["id"]))
        found.due_on = TODAY - timedelta(days=30)

    parties.world.server.in_database(grow)
    advised(parties.producer.post(path), "other-party-needed", "ask the designer for it")
    granted(parties.designer.post(path))


@scene(
    "money.ledger.book.allocate Overpayment",
    "money.ledger.book.refund RefundTooLarge",
    "money.payments._ensure_pays ProducerNeeded",
)
def _a_payment_is_what_is_open(parties: Parties) -> None:
    contract = with_deposit(parties)
    bill = granted(invoice(parties, contract))
    advised(pay(parties, bill, 100, by=parties.designer), "producer-needed", "only a producer of the studio")
    advised(pay(parties, bill, 15_000), "overpayment", "record that amount here, and the rest on another invoice")
    advised(pay(parties, bill, -1), "overpayment", "record up to USD 100.00")
    granted(pay(parties, bill, 10_000))
    advised(pay(parties, bill, 5_000), "overpayment", "nothing of it is to pay: record the payment on another invoice")
    parties.accept_cue(parties.cues[-1])
    payment = granted(pay(parties, granted(invoice(parties, contract)), 5_000))["payments"][0]

    def refund(amount_minor: int) -> Any:
        body = {"amount_minor": amount_minor, "reference": "R-1", "paid_on": day(0)}
        return parties.producer.post(f"/v1/payments/{payment['id']}/refunds", json=body)

    advised(refund(6_000), "refund-too-large", "record up to USD 50.00")
    granted(refund(5_000))
    advised(refund(1), "refund-too-large", "this is final: all of it is back")


@scene(
    "money.settlement.agree_extra_round OtherPartyNeeded",
    "money.settlement.agree_extra_round ProducerNeeded",
    "money.settlement.drop_extra_round OtherPartyNeeded",
    "money.settlement._proposal RoundAlreadySettled",
)
def _a_round_is_agreed_to_or_waived(parties: Parties) -> None:
    contract = parties.agreed(rounds_included=0)
    for cue_id in parties.cues[:2]:
        parties.stage.draft(parties.stage.take(cue_id))
        parties.stage.send()
    rounds = granted(parties.producer.get(f"/v1/contracts/{contract['id']}/extra-rounds"))
    first, second = (f"/v1/extra-rounds/{one['id']}" for one in rounds)
    advised(parties.world.approver.post(f"{first}/agree"), "producer-needed", "only a producer of the studio")
    advised(parties.producer.post(f"{first}/drop"), "other-party-needed", "agree to it, or ask for that")
    granted(parties.producer.post(f"{first}/agree"))
    advised(parties.designer.post(f"{second}/agree"), "other-party-needed", "waive it, or wait for the studio")
    granted(parties.designer.post(f"{second}/drop"))
    refused = parties.designer.post(f"{second}/drop")
    advised(refused, "round-already-settled", "this is final; a change order adds another round")
    parties.change(contract, {"kind": "add_round", "cue_id": str(parties.cues[0])})


@scene(
    "money.bonuses.shipping.say_shipped ProducerNeeded",
    "money.bonuses.shipping.say_shipped NoShippingBonus 1",
    "money.bonuses.shipping.say_shipped NoShippingBonus 2",
)
def _a_game_ships_once(parties: Parties) -> None:
    shipped = {"shipped_on": day(0)}
    flat = with_deposit(parties)
    refused = parties.post(parties.producer, flat, "shipped", **shipped)
    advised(refused, "no-shipping-bonus", "propose a change order that adds it as work")
    parties.change(flat, parties.extra_work(flat))
    bonus = {"bonus_minor": 100, "bonus_when": "shipped"}
    contract = parties.agreed(milestone("Gamma", parties.cue(), amount_minor=100), **bonus)
    refused = parties.post(parties.world.approver, contract, "shipped", **shipped)
    advised(refused, "producer-needed", "only a producer of the studio")
    granted(parties.post(parties.producer, contract, "shipped", **shipped))
    refused = parties.post(parties.producer, contract, "shipped", **shipped)
    advised(refused, "no-shipping-bonus", "this is final: the bonus is due since then")
