"""Refusals at signing, each followed by the act that its text advises."""

from typing import Any
from uuid import UUID

import pytest
import sqlalchemy as sa

from app.accounts.models import Membership, Person
from app.accounts.rules import AddressProof, Role
from app.agreements.errors import SigningCodeOver
from app.agreements.signing.codes import CodeCheck, use
from app.core import clock
from app.core.db import new_id
from tests.app.agreements.test_signing import code_for, name_signers, sign
from tests.app.amendments.refusal_parties import Parties, advised, granted, scene
from tests.support.smtp import mail_server

RULES = "agreements.signing.rules"


def second_producer(parties: Parties) -> UUID:
    """Add a producer to the studio."""
    world, person_id = parties.world, new_id()

    def add(session: Any) -> None:
        session.add(Person(id=person_id, email=f"{person_id}@example.test", name="Executive producer"))
        session.flush()
        session.add(Membership(studio_id=world.studio_id, person_id=person_id, roles=[Role.PRODUCER]))

    world.server.in_database(add)
    return person_id


@scene(
    "agreements.signing.service.set_signers WrongState",
    f"{RULES}.ensure_signers_fit TooManySigners",
    f"{RULES}.ensure_signers_fit NotASigner 1",
    f"{RULES}.ensure_signers_fit NotASigner 2",
)
def _signers_are_named_on_a_draft(parties: Parties) -> None:
    world, second = parties.world, second_producer(parties)
    draft = parties.planned()
    advised(name_signers(world, draft, world.producer_id, second, new_id()), "too-many-signers", "name 2 or fewer")
    advised(name_signers(world, draft, second, second), "not-a-signer", "name two people, or one")
    words = "name producers of the studio who are not the contract's designer"
    advised(name_signers(world, draft, world.designer_id), "not-a-signer", words)
    granted(name_signers(world, draft, second, world.producer_id))
    granted(name_signers(world, draft, second))
    sent = parties.contracts.send(draft)
    words = "recall it first; then name the signers and send it again"
    advised(name_signers(world, sent, world.producer_id), "wrong-state", words)
    granted(parties.post(parties.producer, sent, "recall", reason="Another signer"))
    granted(name_signers(world, sent, world.producer_id))
    agreed = parties.contracts.agree(sent)
    advised(name_signers(world, agreed, second), "wrong-state", "this is final: who signed stays")


@scene(*(f"{RULES}.ensure_turn {one}" for one in ("AlreadyAccepted", "NotASigner", "NotYourTurn 1", "NotYourTurn 2")))
def _each_signs_in_turn(parties: Parties) -> None:
    world, second = parties.world, second_producer(parties)
    executive = world.signed_in(second)
    draft = parties.planned()
    granted(name_signers(world, draft, world.producer_id, second, first="studio"))
    sent = parties.contracts.send(draft)
    advised(sign(parties.designer, sent), "not-your-turn", "you are mailed once it is your turn")
    advised(sign(executive, sent), "not-your-turn", "you are mailed once it is your turn")
    granted(sign(parties.producer, sent))
    advised(
        sign(parties.producer, sent), "already-accepted", "you have signed", "wait until the others have signed it too"
    )
    granted(sign(executive, sent))
    words = ("the studio has signed this text already", "wait until the others have signed it too")
    advised(sign(parties.producer, sent), "already-accepted", *words)
    assert granted(sign(parties.designer, sent))["state"] == "agreed"
    other = parties.contracts.begin("nda")
    granted(name_signers(world, other, second))
    other = parties.contracts.send(other)
    advised(sign(parties.producer, other), "not-a-signer", "have one of them sign; the contract's page names them")
    assert [one["name"] for one in other["signers"]] == ["Executive producer"]
    granted(sign(executive, other))


@scene(
    "agreements.signing.service.accept NotYourContract",
    "agreements.signing.service.accept WrongState",
    "agreements.signing.codes.request_code NotYourContract",
    "agreements.signing.codes.request_code NoSigningCode",
)
def _a_party_signs_what_was_sent(parties: Parties) -> None:
    draft = parties.planned()
    advised(sign(parties.producer, draft), "wrong-state", "a contract can be signed once it was sent")
    sent = parties.contracts.send(draft)
    of_text = {"text_sha256": sent["version"]["text_sha256"]}
    words = "only a producer of the studio and the contract's designer"
    advised(sign(parties.world.approver, sent), "not-your-contract", words)
    advised(parties.post(parties.world.approver, sent, "signing-codes", **of_text), "not-your-contract", words)
    advised(parties.post(parties.designer, sent, "signing-codes", **of_text), "no-signing-code", "sign without one")
    for by in (parties.producer, parties.designer):
        granted(sign(by, sent))


@scene("agreements.signing.codes.use SigningCodeOver")
def _a_code_that_is_over_is_followed_by_another(parties: Parties) -> None:
    world = parties.world
    with pytest.raises(SigningCodeOver, match="is no longer valid") as refused:  # the second of two at once
        world.server.in_database(lambda session: use(session, CodeCheck(new_id())))
    assert refused.value.fix == "ask for another code"
    sent, other = parties.contracts.send(parties.planned()), parties.contracts.send(parties.nda())
    verified = sa.update(Person).values(email_verified_at=clock.now(), email_proof=AddressProof.MAIL)
    world.server.in_database(lambda session: session.execute(verified))
    with mail_server(world.server) as mails:
        advised(sign(parties.designer, sent), "signing-code-needed", "ask for the code, then type it")
        code = code_for(world, mails, sent, parties.designer, world.designer_id)
        wrong = f"{(int(code) + 1) % 1_000_000:06}"
        advised(sign(parties.designer, sent, wrong), "wrong-signing-code", "type the code of the newest mail")
        granted(sign(parties.designer, sent, code))
        advised(sign(parties.designer, other, code), "signing-code-over", "ask for another code")
        another = code_for(world, mails, other, parties.designer, world.designer_id)
        granted(sign(parties.designer, other, another))
