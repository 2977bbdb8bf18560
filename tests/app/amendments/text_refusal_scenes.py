"""Refusals of redlines and signatures, each followed by the act that its text advises."""

from typing import Any

from tests.app.amendments.refusal_parties import ENDED, Parties, advised, granted, scene


def redline(parties: Parties, contract: dict[str, Any], text: str = "Own work alone.", version: int = 0) -> Any:
    change = {"kind": "replace", "clause_key": "warranty", "title": "Originality", "text": text}
    number = version or contract["version"]["number"]
    return parties.post(parties.designer, contract, "redlines", version=number, changes=[change])


def answer(parties: Parties, contract: dict[str, Any], how: str, **more: Any) -> Any:
    return parties.post(parties.producer, contract, "redlines/1/answer", answer=how, **more)


@scene("agreements.redlines.service._sent_version WrongState")
def _redlines_are_of_a_text_that_is_sent(parties: Parties) -> None:
    sent = parties.sent()
    granted(parties.post(parties.designer, sent, "ask-change", text="Three rounds"))
    advised(redline(parties, sent), "wrong-state", "wait until the studio sends it again")
    sent = parties.contracts.send(sent)
    granted(redline(parties, sent))
    granted(answer(parties, sent, "refused", comment="Two are enough"))
    agreed = parties.contracts.agree(sent)
    advised(redline(parties, agreed), "wrong-state", "propose a change order")
    granted(parties.propose(agreed, parties.extra_work(agreed), by=parties.designer))
    parties.end(agreed)
    advised(redline(parties, agreed), "wrong-state", "this is final", ENDED)
    parties.begins_another()


@scene("agreements.redlines.service.propose TextChanged", "agreements.redlines.service.propose BadRedlines")
def _redlines_fit_the_text(parties: Parties) -> None:
    sent = parties.sent()
    advised(redline(parties, sent, version=99), "text-changed", "reload the page and read what changed")
    typo = redline(parties, sent, "{rounds_includd} rounds.")
    advised(typo, "bad-redlines", "is it {rounds_included}?")
    granted(redline(parties, sent, "{rounds_included} rounds."))


@scene(
    "agreements.redlines.service.answer BadRedlines 1",
    "agreements.redlines.service.answer WrongState",
    "agreements.redlines.service.ensure_answered RedlinesOpen 1",
    "agreements.redlines.service.ensure_answered RedlinesOpen 2",
)
def _redlines_are_answered_before_the_next_version(parties: Parties) -> None:
    sent = parties.sent()
    granted(redline(parties, sent))

    def send() -> Any:
        return parties.post(parties.producer, sent, "send")

    advised(send(), "redlines-open", "accept, refuse or counter each")
    advised(answer(parties, sent, "refused"), "bad-redlines", "say why it is refused")
    granted(answer(parties, sent, "refused", comment="Two are enough"))
    granted(answer(parties, sent, "accepted"))
    drafted = granted(parties.producer.get(f"/v1/contracts/{sent['id']}"))
    rows = drafted["version"]["clauses"]
    clauses = [row | ({"text": "Any work."} if row["key"] == "warranty" else {}) for row in rows]
    parties.contracts.save(drafted, clauses=clauses)
    advised(send(), "redlines-open", "answer it again on the page Redlines")
    granted(answer(parties, sent, "accepted"))
    granted(send())
    advised(answer(parties, sent, "accepted"), "wrong-state", "recall it first; then change it and send it again")
    granted(parties.post(parties.producer, sent, "recall", reason="A slip"))
    drafted = granted(parties.producer.get(f"/v1/contracts/{sent['id']}"))
    parties.contracts.send(parties.contracts.save(drafted, title="Other"))


@scene("agreements.rules.ensure_same_text TextChanged")
def _the_text_that_stands_is_signed(parties: Parties) -> None:
    sent = parties.sent()
    body = {"name": "N. N.", "text_sha256": "0" * 64}
    advised(parties.post(parties.designer, sent, "accept", **body), "text-changed", "read what changed, then sign")
    read = granted(parties.designer.get(f"/v1/contracts/{sent['id']}"))
    parties.contracts.accept(read, parties.designer, "N. N.")


@scene("agreements.rules.ensure_needs_contract NoContractNeeded")
def _a_contractor_needs_a_contract(parties: Parties) -> None:
    project = f"/v1/projects/{parties.world.project_id}"
    tie = parties.contracts.engagement_id()
    granted(parties.producer.patch(f"{project}/engagements/{tie}", json={"kind": "in-house"}))
    body = {"engagement_id": tie, "kind": "single", "title": "Effects"}
    refused = parties.producer.post(f"{project}/contracts", json=body)
    advised(refused, "no-contract-needed", "change their engagement to contractor first")
    granted(parties.producer.patch(f"{project}/engagements/{tie}", json={"kind": "contract"}))
    granted(parties.producer.post(f"{project}/contracts", json=body))
