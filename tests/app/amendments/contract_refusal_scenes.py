"""Refusals of contracts, each followed by the act that its text advises."""

from typing import Any

from tests.app.agreements.conftest import Contracts
from tests.app.amendments.refusal_parties import ENDED, Parties, advised, granted, scene
from tests.app.money.agreed import milestone


@scene("agreements.access.contract_for_producer ProducerNeeded")
def _only_producers(parties: Parties) -> None:
    sent = parties.sent()
    advised(parties.post(parties.designer, sent, "recall", reason="A slip"), "producer-needed", "only a producer")
    granted(parties.post(parties.producer, sent, "recall", reason="A slip"))


@scene("agreements.drafts.lifecycle.save_draft WrongState", "agreements.drafts.lifecycle._sendable WrongState")
def _a_draft_is_changed_and_sent(parties: Parties) -> None:
    contract = parties.sent()

    def save() -> Any:
        body = Contracts.draft_of(contract, title="Other") | {"based_on_version": contract["version"]["number"]}
        return parties.producer.put(f"/v1/contracts/{contract['id']}/draft", json=body)

    for refused in (save(), parties.post(parties.producer, contract, "send")):
        advised(refused, "wrong-state", "recall it first; then change it and send it again")
    granted(parties.post(parties.producer, contract, "recall", reason="A slip"))
    saved = granted(save())
    sent = parties.contracts.send(saved)
    for by in (parties.designer, parties.producer):
        parties.contracts.accept(sent, by, "N. N.")
    for refused in (save(), parties.post(parties.producer, contract, "send")):
        advised(refused, "wrong-state", "propose a change order")
    granted(parties.propose(contract, parties.extra_work(contract)))
    parties.end(contract)
    for refused in (save(), parties.post(parties.producer, contract, "send")):
        advised(refused, "wrong-state", "this is final", ENDED)
    parties.begins_another()


@scene("agreements.rules.ensure_state WrongState")
def _an_agreed_nda_is_ended_for_another_one(parties: Parties) -> None:
    agreed = parties.contracts.agree(parties.nda())
    refused = parties.post(parties.producer, agreed, "send")
    advised(refused, "wrong-state", "end it on its page; then the studio begins another contract")
    granted(parties.post(parties.producer, agreed, "end", reason="Another text"))
    granted(parties.post(parties.producer, parties.nda(), "send"))


@scene("agreements.drafts.lifecycle.save_draft DraftChanged")
def _another_saved_meanwhile(parties: Parties) -> None:
    begun = parties.planned()
    parties.contracts.save(begun, title="Other")
    body = Contracts.draft_of(begun, title="Mine") | {"based_on_version": 1}
    advised(
        parties.producer.put(f"/v1/contracts/{begun['id']}/draft", json=body),
        "draft-changed",
        "then save what you still want",
    )
    granted(parties.producer.put(f"/v1/contracts/{begun['id']}/draft", json=body | {"based_on_version": 2}))


@scene("agreements.drafts.lifecycle.recall WrongState")
def _only_a_sent_contract_is_recalled(parties: Parties) -> None:
    begun = parties.planned()
    refused = parties.post(parties.producer, begun, "recall", reason="A slip")
    advised(refused, "wrong-state", "edit the draft, then send it")
    saved = parties.contracts.save(begun, title="Other")
    agreed = parties.contracts.agree(saved)
    refused = parties.post(parties.producer, agreed, "recall", reason="A slip")
    advised(refused, "wrong-state", "propose a change order")
    granted(parties.propose(agreed, parties.extra_work(agreed)))


@scene(
    "agreements.drafts.lifecycle.request_change NotYourContract",
    "agreements.redlines.service._to_propose NotYourContract",
)
def _a_producer_edits_instead_of_asking(parties: Parties) -> None:
    sent = parties.sent()
    refused = parties.post(parties.producer, sent, "ask-change", text="Three rounds")
    advised(refused, "not-your-contract", "a producer recalls and edits it")
    granted(parties.post(parties.producer, sent, "recall", reason="A slip"))
    parties.contracts.save(sent, title="Other")


@scene("agreements.drafts.lifecycle.request_change WrongState")
def _a_change_is_requested_of_a_sent_text(parties: Parties) -> None:
    sent = parties.sent()
    granted(parties.post(parties.designer, sent, "ask-change", text="Three rounds"))
    refused = parties.post(parties.designer, sent, "ask-change", text="Three rounds")
    advised(refused, "wrong-state", "wait until the studio sends it again")
    sent = parties.contracts.send(sent)
    granted(parties.post(parties.designer, sent, "ask-change", text="Three rounds"))
    agreed = parties.contracts.agree(sent)
    refused = parties.post(parties.designer, agreed, "ask-change", text="Three rounds")
    advised(refused, "wrong-state", "propose a change order")
    granted(parties.propose(agreed, parties.extra_work(agreed), by=parties.designer))


@scene("agreements.drafts.lifecycle.end WrongState")
def _an_end_is_final(parties: Parties) -> None:
    begun = parties.planned()
    granted(parties.post(parties.producer, begun, "end", reason="Given up"))
    refused = parties.post(parties.producer, begun, "end", reason="Given up")
    advised(refused, "wrong-state", "this is final", "its text and record stay readable")
    granted(parties.producer.get(f"/v1/contracts/{begun['id']}"))
    granted(parties.producer.get(f"/v1/contracts/{begun['id']}/record"))


@scene("agreements.rules.ensure_ends_without_settlement NoticeNeeded")
def _what_orders_work_ends_by_notice(parties: Parties) -> None:
    agreed = parties.agreed()
    for by in (parties.designer, parties.producer):
        advised(parties.post(by, agreed, "end", reason="Shelved"), "notice-needed", "give notice", "it ends at once")
    parties.end(agreed)


@scene("agreements.drafts.lifecycle._ensure_whole BadDraft")
def _a_draft_is_corrected_where_it_says(parties: Parties) -> None:
    begun = parties.planned()
    body = Contracts.draft_of(begun) | {"based_on_version": 1}
    path = f"/v1/contracts/{begun['id']}/draft"
    refused = parties.producer.put(path, json=body | {"terms": body["terms"] | {"rounds_included": -1}})
    advised(refused, "bad-draft", "terms.rounds_included", "wanted 0 to")
    granted(parties.producer.put(path, json=body | {"terms": body["terms"] | {"rounds_included": 0}}))


@scene(
    "agreements.drafts.lifecycle._ensure_framework FrameworkNeeded",
    "agreements.rules.ensure_under_framework FrameworkNeeded",
)
def _a_batch_names_a_framework(parties: Parties) -> None:
    path = f"/v1/projects/{parties.world.project_id}/contracts"
    body = {"engagement_id": parties.contracts.engagement_id(), "title": "Batch", "kind": "statement_of_work"}
    advice = "sign a framework agreement first, or use a single contract"
    advised(parties.producer.post(path, json=body), "framework-needed", advice)
    draft = parties.contracts.begin("framework")
    advised(parties.producer.post(path, json=body | {"framework_id": draft["id"]}), "framework-needed", advice)
    parties.contracts.agree(draft)
    granted(parties.producer.post(path, json=body | {"framework_id": draft["id"]}))
    granted(parties.producer.post(path, json=body | {"kind": "single"}))
    stray = parties.producer.post(path, json=body | {"kind": "single", "framework_id": draft["id"]})
    advised(stray, "framework-needed", "leave the framework out")


@scene("agreements.plan.service.save_plan PlanLocked 1")
def _a_plan_is_free_in_a_draft(parties: Parties) -> None:
    contract = parties.sent()
    plan = milestone("Gamma", parties.cues[0], amount_minor=100)
    advised(parties.plan(contract, plan), "plan-locked", "recall it first")
    granted(parties.post(parties.producer, contract, "recall", reason="A slip"))
    granted(parties.plan(contract, plan))
    agreed = parties.contracts.agree(contract)
    advised(parties.plan(agreed, plan), "plan-locked", "propose a change order")
    granted(parties.propose(agreed, parties.extra_work(agreed, "Gamma")))
    parties.end(agreed)
    advised(parties.plan(agreed, plan), "plan-locked", "this is final", ENDED)
    parties.begins_another()


@scene("agreements.plan.service.save_plan PlanLocked 2")
def _an_nda_has_no_plan(parties: Parties) -> None:
    advised(parties.plan(parties.nda()), "plan-locked", "plan the contract that orders the work")
    parties.planned()


@scene("agreements.plan.service.save_plan BadPlan")
def _a_plan_is_corrected_where_it_says(parties: Parties) -> None:
    begun, cue = parties.planned(), parties.cue()
    wrong = milestone("Gamma", cue, amount_minor=100)
    wrong["cues"] = [{"cue_id": str(cue), "price_minor": 90}]
    advised(parties.plan(begun, wrong), "bad-plan", "add up to USD 0.90", "leave one of them out")
    granted(parties.plan(begun, wrong | {"amount_minor": None}))


@scene("agreements.plan.service.activate_plan UnderContract")
def _a_cue_is_under_one_contract(parties: Parties) -> None:
    first = parties.agreed()
    shared = parties.cues[0]
    second = parties.sent(milestone("Gamma", shared, parties.cue(), amount_minor=100))
    parties.contracts.accept(second, parties.designer, "N. N.")
    body = {"name": "N. N.", "text_sha256": second["version"]["text_sha256"]}
    refused = parties.post(parties.producer, second, "accept", **body)
    advised(refused, "under-contract", "recalls this one and takes these cues out of its plan, or ends the other one")
    granted(parties.post(parties.producer, second, "recall", reason="A slip"))
    granted(parties.plan(second, milestone("Gamma", parties.cues[-1], amount_minor=100)))
    assert parties.contracts.agree(second)["state"] == "agreed"
    third = parties.planned(milestone("Delta", shared, amount_minor=100))
    parties.end(first)
    assert parties.contracts.agree(third)["state"] == "agreed"


@scene("agreements.plan.amounts.split NothingToSplit")
def _an_amount_has_cues(parties: Parties) -> None:
    sent = parties.sent(milestone("Gamma", amount_minor=100))
    parties.contracts.accept(sent, parties.designer, "N. N.")
    body = {"name": "N. N.", "text_sha256": sent["version"]["text_sha256"]}
    refused = parties.post(parties.producer, sent, "accept", **body)
    advised(refused, "nothing-to-split", "the studio recalls the contract and puts cues into the milestone")
    granted(parties.post(parties.producer, sent, "recall", reason="A slip"))
    granted(parties.plan(sent, milestone("Gamma", parties.cue(), amount_minor=100)))
    assert parties.contracts.agree(sent)["state"] == "agreed"


@scene("agreements.drafts.lifecycle.end NotYourContract")
def _a_party_ends_a_contract(parties: Parties) -> None:
    nda = parties.contracts.agree(parties.nda())
    refused = parties.post(parties.world.approver, nda, "end", reason="Over")
    advised(refused, "not-your-contract", "only a producer of the studio and the contract's designer end it")
    granted(parties.post(parties.designer, nda, "end", reason="Over"))
