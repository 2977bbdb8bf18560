"""Refusals of change orders and early ends, each followed by the act that its text advises."""

from typing import Any
from uuid import UUID

from tests.app.amendments.refusal_parties import ENDED, Parties, advised, granted, scene
from tests.app.money.agreed import day, milestone


@scene("amendments.signing.locked_for_party NotYourContract", "amendments.change_orders.preview NotYourContract")
def _a_party_changes_a_contract(parties: Parties) -> None:
    agreed = parties.agreed()
    work = parties.extra_work(agreed)
    advice = "only a producer of the studio and the contract's designer change it"
    for what, given in (("change-orders", {"reason": "More"}), ("change-order-preview", {})):
        refused = parties.post(parties.world.approver, agreed, what, changes=[work], **given)
        advised(refused, "not-your-contract", advice)
        for by in (parties.producer, parties.designer):
            granted(parties.post(by, agreed, what, changes=[work], **given))


@scene("amendments.change_orders.accept ChangeOrderStale")
def _a_stale_order_is_withdrawn_or_refused(parties: Parties) -> None:
    agreed = parties.agreed()
    cut = {"kind": "cut_cue", "cue_id": str(parties.cues[0])}
    for _ in range(2):
        granted(parties.propose(agreed, cut))
    parties.accept_cue(parties.cues[0])
    for number in (1, 2):
        refused = parties.accept_order(agreed, number, parties.designer)
        advised(refused, "change-order-stale", "withdraws it and proposes another, the other party refuses it")
    granted(parties.post(parties.producer, agreed, "change-orders/1/withdraw", reason="Stale"))
    granted(parties.post(parties.designer, agreed, "change-orders/2/refuse", reason="Stale"))
    granted(parties.propose(agreed, parties.extra_work(agreed)))


@scene("amendments.change_orders.refuse OwnChangeOrder", "amendments.change_orders.withdraw NotOwnChangeOrder")
def _who_proposed_withdraws(parties: Parties) -> None:
    agreed = parties.agreed()
    for _ in range(2):
        granted(parties.propose(agreed, parties.extra_work(agreed)))
    refused = parties.post(parties.producer, agreed, "change-orders/1/refuse", reason="No")
    advised(refused, "own-change-order", "withdraw it; the other party can refuse it")
    granted(parties.post(parties.producer, agreed, "change-orders/1/withdraw", reason="No"))
    refused = parties.post(parties.designer, agreed, "change-orders/2/withdraw", reason="No")
    advised(refused, "not-own-change-order", "refuse it")
    granted(parties.post(parties.designer, agreed, "change-orders/2/refuse", reason="No"))


@scene("amendments.change_orders._open ChangeOrderClosed")
def _a_closed_order_is_followed_by_another(parties: Parties) -> None:
    agreed = parties.agreed()
    granted(parties.propose(agreed, parties.extra_work(agreed)))
    granted(parties.post(parties.designer, agreed, "change-orders/1/refuse", reason="No"))
    advised(parties.accept_order(agreed, 1, parties.designer), "change-order-closed", "propose another one")
    granted(parties.propose(agreed, parties.extra_work(agreed)))
    parties.end(agreed)
    advised(parties.accept_order(agreed, 2, parties.designer), "change-order-closed", "this is final", ENDED)
    parties.begins_another()


@scene("amendments.change_orders._ensure_in_force NotInForce 1")
def _a_text_without_work_has_no_change_orders(parties: Parties) -> None:
    work = {"kind": "add_work", "milestone_id": str(UUID(int=1)), "text": "Rush", "amount_minor": 100}
    nda = parties.contracts.agree(parties.nda())
    advised(parties.propose(nda, work), "not-in-force", "end it on its page; then the studio begins another contract")
    granted(parties.post(parties.designer, nda, "end", reason="Over"))
    advised(parties.propose(nda, work), "not-in-force", "this is final", ENDED)
    parties.begins_another()
    framework = parties.contracts.begin("framework")
    advised(parties.propose(framework, work), "not-in-force", "edit the draft, then send it")
    framework = parties.contracts.agree(framework)
    advised(parties.propose(framework, work), "not-in-force", "propose it to the batch that has the cues")
    batch = parties.contracts.begin("statement_of_work", framework_id=framework["id"])
    granted(parties.plan(batch, milestone("Batch", parties.cue(), amount_minor=100)))
    batch = parties.contracts.agree(batch)
    granted(parties.propose(batch, parties.extra_work(batch, "Batch")))


@scene("amendments.change_orders._ensure_in_force NotInForce 2")
def _a_text_that_is_not_signed_is_changed_itself(parties: Parties) -> None:
    sent = parties.sent()
    work = parties.extra_work(sent)
    advised(parties.propose(sent, work), "not-in-force", "recall it first; then change it and send it again")
    advised(parties.propose(sent, work, by=parties.designer), "not-in-force", "request a change while it needs your")
    granted(parties.post(parties.designer, sent, "ask-change", text="Rush"))
    advised(parties.propose(sent, work, by=parties.designer), "not-in-force", "wait until the studio sends it again")
    advised(parties.propose(sent, work), "not-in-force", "edit the draft, then send it")
    agreed = parties.contracts.agree(parties.contracts.save(sent, title="Other"))
    granted(parties.propose(agreed, parties.extra_work(agreed)))
    parties.end(agreed)
    advised(parties.propose(agreed, work), "not-in-force", "this contract has ended", ENDED)
    parties.begins_another()


@scene("amendments.ending.give_notice NoticeGiven", "amendments.ending.withdraw_notice NotYourContract")
def _one_notice_stands(parties: Parties) -> None:
    agreed = parties.agreed()
    granted(parties.notice(agreed))
    refused = parties.notice(agreed, by=parties.designer)
    advised(refused, "notice-given", "agree to its statement; who gave the notice can withdraw it")
    refused = parties.post(parties.designer, agreed, "ending/withdraw")
    advised(refused, "not-your-contract", "agree to the statement, or wait until the notice is over or withdrawn")
    granted(parties.agree_ending(agreed, parties.designer))
    granted(parties.post(parties.producer, agreed, "ending/withdraw"))
    granted(parties.notice(agreed, by=parties.designer))


@scene("amendments.ending.statement_pdf NoNotice", "amendments.ending._open_notice NoNotice")
def _a_statement_follows_a_notice(parties: Parties) -> None:
    agreed = parties.agreed()
    pdf = f"/v1/contracts/{agreed['id']}/ending/statement.pdf"
    advised(parties.producer.get(pdf), "no-notice", "give notice first")
    advised(parties.agree_ending(agreed, parties.designer), "no-notice", "give notice; the statement is made from it")
    granted(parties.notice(agreed, by=parties.designer))
    granted(parties.producer.get(pdf))
    granted(parties.agree_ending(agreed, parties.designer))


@scene("amendments.ending._ensure_unsettled AlreadyEnded 1")
def _what_owes_nothing_is_ended_on_its_page(parties: Parties) -> None:
    nda, begun = parties.contracts.agree(parties.nda()), parties.planned()
    for contract in (nda, begun):
        pdf = parties.producer.get(f"/v1/contracts/{contract['id']}/ending/statement.pdf")
        for refused in (parties.notice(contract), parties.agree_ending(contract, parties.producer), pdf):
            advised(refused, "already-ended", "end it on the contract's page")
        granted(parties.post(parties.producer, contract, "end", reason="Over"))
        advised(parties.notice(contract), "already-ended", "this is final", ENDED)
    parties.begins_another()


@scene("amendments.ending._ensure_unsettled AlreadyEnded 2", "amendments.ending._open_notice AlreadyEnded")
def _a_settlement_is_final(parties: Parties) -> None:
    agreed = parties.agreed()
    parties.end(agreed)
    refused = parties.agree_ending(agreed, parties.designer)
    advised(refused, "already-ended", "this is final: read the statement on its page")
    granted(parties.designer.get(f"/v1/contracts/{agreed['id']}/ending"))
    granted(parties.designer.get(f"/v1/contracts/{agreed['id']}/ending/statement.pdf"))
    advised(parties.notice(agreed), "already-ended", "this is final", ENDED)
    parties.begins_another()


@scene("amendments.rules.end_of_notice NoticeTooShort 1", "amendments.rules.end_of_notice NoticeTooShort 2")
def _a_notice_is_long_enough(parties: Parties) -> None:
    agreed = parties.agreed(notice_days=14)
    refused = parties.notice(agreed, ends_on=day(3))
    advised(refused, "notice-too-short", f"give notice for {day(14)}; it ends at once when both agree")
    granted(parties.notice(agreed, ends_on=day(14)))
    for by in (parties.designer, parties.producer):
        granted(parties.agree_ending(agreed, by))
    begun = parties.planned(milestone("Gamma", parties.cue(), amount_minor=100))
    clauses = [one | ({"stands": False} if one["key"] == "termination" else {}) for one in begun["version"]["clauses"]]
    without = parties.contracts.agree(parties.contracts.save(begun, clauses=clauses))
    advised(parties.notice(without, ends_on=day(30)), "notice-too-short", "give notice without a day")
    granted(parties.notice(without))


@scene("amendments.offers.dismiss OfferSettled")
def _what_is_offered_no_more_is_proposed(parties: Parties) -> None:
    agreed = parties.agreed()
    refused = parties.post(parties.producer, agreed, "change-offers/dismiss", offer="no-such-offer", reason="No")
    advised(refused, "offer-settled", "propose a change order yourself where one is needed")
    granted(parties.propose(agreed, parties.extra_work(agreed)))


REVIEW = "amendments.change_order_review"


@scene("amendments.change_orders.propose BadChangeOrder", f"{REVIEW}._problems BadChangeOrder 1")
def _a_change_names_what_is_there(parties: Parties) -> None:
    agreed = parties.agreed()
    work = parties.extra_work(agreed)
    stray = parties.propose(agreed, work | {"milestone_id": str(UUID(int=1))})
    advised(
        stray, "bad-change-order", "name one that is not a deposit", "change what the message names, and propose it"
    )
    granted(parties.propose(agreed, work))
    cut = {"kind": "cut_cue", "cue_id": str(parties.cues[0])}
    advised(parties.propose(agreed, cut, cut), "bad-change-order", "leave one of them out")
    granted(parties.propose(agreed, cut))


@scene(f"{REVIEW}._problems BadChangeOrder 2")
def _a_complete_milestone_takes_no_cue(parties: Parties) -> None:
    agreed = parties.agreed()
    names = parties.milestones(agreed)
    parties.accept_cue(parties.cues[2])

    def add(name: str) -> Any:
        body = {"kind": "add_cue", "cue_id": str(parties.cue()), "milestone_id": names[name], "price_minor": 10}
        return parties.propose(agreed, body)

    advised(add("Beta"), "bad-change-order", "Beta is complete; name a milestone that is open")
    granted(add("Alpha"))
    for cue_id in parties.cues[:2]:
        parties.accept_cue(cue_id)
    advised(add("Alpha"), "bad-change-order", "Alpha is complete; sign another contract for more cues")
    parties.begins_another()


@scene(f"{REVIEW}._problems BadChangeOrder 3")
def _a_cue_outside_is_added(parties: Parties) -> None:
    agreed, cue = parties.agreed(), str(parties.cue())
    refused = parties.propose(agreed, {"kind": "cut_cue", "cue_id": cue})
    advised(refused, "bad-change-order", "the contract does not cover that cue; add it instead")
    milestone_id = parties.milestones(agreed)["Alpha"]
    body = {"kind": "add_cue", "cue_id": cue, "milestone_id": milestone_id, "price_minor": 10}
    granted(parties.propose(agreed, body))


@scene(
    f"{REVIEW}._problems BadChangeOrder 4",
    f"{REVIEW}._problems_of_added BadChangeOrder 2",
    f"{REVIEW}._problems_of_added BadChangeOrder 3",
)
def _a_cut_cue_is_for_another_contract_or_a_new_cue(parties: Parties) -> None:
    agreed = parties.agreed()
    alpha, beta = parties.milestones(agreed)["Alpha"], parties.milestones(agreed)["Beta"]
    by_order, by_list = (str(cue_id) for cue_id in parties.cues[:2])
    parties.change(agreed, {"kind": "cut_cue", "cue_id": by_order})
    for change in (
        {"kind": "reprice_cue", "cue_id": by_order, "price_minor": 10},
        {"kind": "add_cue", "cue_id": by_order, "milestone_id": alpha, "price_minor": 10},
    ):
        advised(parties.propose(agreed, change), "bad-change-order", "sign another contract for it")
    assert parties.agreed(milestone("Gamma", UUID(by_order), amount_minor=100))["state"] == "agreed"
    granted(parties.producer.post(f"/v1/cues/{by_list}/cut", json={"reason": "Left the game"}))
    for change in (
        {"kind": "reprice_cue", "cue_id": by_list, "price_minor": 10},
        {"kind": "add_cue", "cue_id": by_list, "milestone_id": beta, "price_minor": 10},
    ):
        advised(parties.propose(agreed, change), "bad-change-order", "put a new cue on it instead")
    cue = str(parties.cue())
    granted(parties.propose(agreed, {"kind": "add_cue", "cue_id": cue, "milestone_id": beta, "price_minor": 10}))


@scene(f"{REVIEW}._problems BadChangeOrder 5", f"{REVIEW}._problems_of_added BadChangeOrder 4")
def _an_accepted_cue_keeps_its_price(parties: Parties) -> None:
    agreed = parties.agreed()
    cue = str(parties.cues[2])
    parties.accept_cue(parties.cues[2])
    refused = parties.propose(agreed, {"kind": "reprice_cue", "cue_id": cue, "price_minor": 10})
    advised(refused, "bad-change-order", "add work to its milestone instead")
    milestone_id = parties.milestones(agreed)["Alpha"]
    add = {"kind": "add_cue", "cue_id": cue, "milestone_id": milestone_id, "price_minor": 10}
    advised(parties.propose(agreed, add), "bad-change-order", "which is accepted; add work to its milestone instead")
    granted(parties.propose(agreed, parties.extra_work(agreed, "Beta")))


@scene(f"{REVIEW}._problems_of_added BadChangeOrder 5")
def _a_covered_cue_is_priced_again(parties: Parties) -> None:
    agreed = parties.agreed()
    cue, milestone_id = str(parties.cues[0]), parties.milestones(agreed)["Beta"]
    add = {"kind": "add_cue", "cue_id": cue, "milestone_id": milestone_id, "price_minor": 10}
    advised(parties.propose(agreed, add), "bad-change-order", "already; change its price instead")
    granted(parties.propose(agreed, {"kind": "reprice_cue", "cue_id": cue, "price_minor": 10}))


@scene(f"{REVIEW}._problems BadChangeOrder 6")
def _a_round_without_a_price_is_priced_with_the_cue(parties: Parties) -> None:
    agreed = parties.agreed(extra_round_bp=0)
    cue = str(parties.cues[0])
    refused = parties.propose(agreed, {"kind": "add_round", "cue_id": cue})
    advised(refused, "bad-change-order", "change the price of the cue instead")
    granted(parties.propose(agreed, {"kind": "reprice_cue", "cue_id": cue, "price_minor": 90_000}))


@scene(f"{REVIEW}._problems_of_date BadChangeOrder 1", f"{REVIEW}._problems_of_date BadChangeOrder 2")
def _a_date_is_moved_ahead(parties: Parties) -> None:
    agreed = parties.agreed()
    move = {"kind": "move_date", "milestone_id": parties.milestones(agreed)["Alpha"]}
    refused = parties.propose(agreed, move | {"due_on": day(-3)})
    advised(refused, "bad-change-order", "give Alpha a day to come")
    granted(parties.propose(agreed, move | {"due_on": day(0)}))
    advised(parties.propose(agreed, move | {"due_on": day(14)}), "bad-change-order", "already; give it another day")
    granted(parties.propose(agreed, move | {"due_on": day(20)}))


@scene(f"{REVIEW}._problems_of_added BadChangeOrder 1")
def _a_cue_is_put_on_the_list_first(parties: Parties) -> None:
    agreed = parties.agreed()
    milestone_id = parties.milestones(agreed)["Alpha"]
    add = {"kind": "add_cue", "cue_id": str(UUID(int=1)), "milestone_id": milestone_id, "price_minor": 10}
    advised(parties.propose(agreed, add), "bad-change-order", "put it on the sound list first")
    granted(parties.propose(agreed, add | {"cue_id": str(parties.cue())}))


@scene(f"{REVIEW}._problems_of_added BadChangeOrder 6")
def _a_cue_of_another_contract_is_taken_out_there(parties: Parties) -> None:
    first = parties.agreed()
    other = parties.agreed(milestone("Gamma", parties.cue(), amount_minor=100))
    cue = str(parties.cues[0])
    add = {"kind": "add_cue", "cue_id": cue, "milestone_id": parties.milestones(other)["Gamma"], "price_minor": 10}
    advised(parties.propose(other, add), "bad-change-order", "take it out of that one first")
    parties.change(first, {"kind": "cut_cue", "cue_id": cue})
    granted(parties.propose(other, add))


@scene(*(f"amendments.caps.problems BadChangeOrder {number}" for number in (1, 2, 3)))
def _caps_are_of_what_is_paid_and_not_below_it(parties: Parties) -> None:
    hourly = {"hour_rate_minor": 6_000, "hours_cap": 5, "hours_month_cap": 4}
    contract = parties.agreed(milestone("Alpha", parties.cue(), amount_minor=100), **hourly)
    log = {"worked_on": day(-1), "minutes": 150, "note": "Directing"}
    granted(parties.post(parties.designer, contract, "worked-days", **log))

    def caps(**more: int) -> Any:
        return parties.propose(contract, {"kind": "set_caps", **more})

    advised(caps(days_cap=2), "bad-change-order", "does not pay by the day; add work to a milestone instead")
    granted(parties.propose(contract, parties.extra_work(contract)))
    advised(caps(hours_cap=5), "bad-change-order", "these caps hold already; give another number")
    advised(caps(hours_cap=2), "bad-change-order", "the cap can be 3 hours or more")
    granted(caps(hours_cap=3))
