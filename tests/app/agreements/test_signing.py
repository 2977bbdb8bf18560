"""Who signs in which order, and the code that shows that a signature is the person's."""

import json
import re
from collections.abc import Iterator
from datetime import timedelta
from typing import Any
from uuid import UUID

import pytest
import sqlalchemy as sa
from httpx2 import Client

from app.accounts.models import Membership, Person
from app.accounts.rules import AddressProof, Role
from app.agreements.models import ContractAcceptance, SigningCode
from app.agreements.rules import Party
from app.agreements.signing.rules import CODE_TRIES, CONSENT, Signature, SigningOrder
from app.core import clock
from app.core.db import new_id
from tests.app.accounts.test_second_factor_requirements import REQUIRED, require_second_factor, set_up_totp
from tests.app.agreements.conftest import Contracts
from tests.app.money.agreed import milestone
from tests.app.reviews.making import Stage
from tests.support.server import World
from tests.support.smtp import MailServer, mail_server

ONE, TWO, DESIGNER = new_id(), new_id(), new_id()
STUDIO_ONE, STUDIO_TWO = Signature(Party.STUDIO, ONE), Signature(Party.STUDIO, TWO)
DESIGNERS = Signature(Party.DESIGNER, DESIGNER)


@pytest.mark.parametrize(
    ("order", "given", "parties", "signer"),
    [
        (SigningOrder(), [], [Party.STUDIO, Party.DESIGNER], None),
        (SigningOrder(), [STUDIO_ONE], [Party.DESIGNER], None),
        (SigningOrder([ONE, TWO]), [], [Party.STUDIO, Party.DESIGNER], ONE),
        (SigningOrder([ONE, TWO]), [STUDIO_ONE], [Party.STUDIO, Party.DESIGNER], TWO),
        (SigningOrder([ONE, TWO]), [STUDIO_ONE, STUDIO_TWO], [Party.DESIGNER], None),
        (SigningOrder([ONE, TWO], Party.STUDIO), [STUDIO_ONE], [Party.STUDIO], TWO),
        (SigningOrder([], Party.DESIGNER), [], [Party.DESIGNER], None),
        (SigningOrder([], Party.DESIGNER), [DESIGNERS], [Party.STUDIO], None),
        (SigningOrder([ONE, TWO], Party.STUDIO), [STUDIO_ONE, STUDIO_TWO, DESIGNERS], [], None),
    ],
)
def test_whose_turn_it_is(
    order: SigningOrder, given: list[Signature], parties: list[Party], signer: UUID | None
) -> None:
    turn = order.turn(given)
    assert (list(turn.parties), turn.signer) == (parties, signer)


@pytest.fixture
def second(world: World) -> UUID:
    """Another producer of the studio."""
    person_id = new_id()
    world.server.in_database(
        lambda session: session.add_all(
            [Person(id=person_id, email=f"{person_id}@example.test", name="Executive producer")]
        )
    )
    membership = Membership(studio_id=world.studio_id, person_id=person_id, roles=[Role.PRODUCER])
    world.server.in_database(lambda session: session.add(membership))
    return person_id


def name_signers(world: World, contract: dict[str, Any], *people: UUID, first: str | None = None) -> Any:
    body = {"person_ids": [str(person) for person in people], "first": first}
    return world.producer.put(f"/v1/contracts/{contract['id']}/signers", json=body)


def sign(by: Client, contract: dict[str, Any], code: str | None = None, name: str = "Full Name") -> Any:
    body = {"name": name, "text_sha256": contract["version"]["text_sha256"]}
    return by.post(f"/v1/contracts/{contract['id']}/accept", json=body | ({"code": code} if code else {}))


def refusal(answer: Any) -> tuple[int, str]:
    return answer.status_code, answer.json()["code"]


@pytest.mark.slow
def test_two_named_signers_sign_in_their_order(world: World, contracts: Contracts, second: UUID) -> None:
    draft = contracts.begin()
    named = name_signers(world, draft, world.producer_id, second, first="studio").json()
    assert [one["name"] for one in named["signers"]] == ["Producer", "Executive producer"]
    sent, other = contracts.send(draft), world.signed_in(second)
    assert sent["waits_for"] == ["studio"]
    assert refusal(sign(world.designer, sent)) == (409, "not-your-turn")
    assert refusal(sign(other, sent)) == (409, "not-your-turn")
    half = sign(world.producer, sent).json()
    assert (half["state"], half["waits_for"], half["may"]["accept"]) == ("sent", ["studio"], False)
    assert refusal(sign(world.producer, sent)) == (409, "already-accepted")
    assert sign(other, sent).json()["waits_for"] == ["designer"]
    agreed = sign(world.designer, sent).json()
    assert agreed["state"] == "agreed"
    assert [one["party"] for one in agreed["acceptances"]] == ["studio", "studio", "designer"]
    entries = contracts.entries(agreed)
    assert entries[0]["payload"]["signers"] == ["Producer", "Executive producer"]
    assert entries[0]["payload"]["signs_first"] == "studio"


@pytest.mark.slow
def test_a_producer_who_is_not_named_does_not_sign(world: World, contracts: Contracts, second: UUID) -> None:
    draft = contracts.begin()
    name_signers(world, draft, second)
    sent = contracts.send(draft)
    assert sent["may"]["accept"] is False
    assert refusal(sign(world.producer, sent)) == (403, "not-a-signer")
    sign(world.designer, sent)
    assert sign(world.signed_in(second), sent).json()["state"] == "agreed"


@pytest.mark.slow
def test_each_signer_is_mailed_when_it_is_their_turn(
    world: World, contracts: Contracts, second: UUID, mails: MailServer
) -> None:
    draft = contracts.begin()
    name_signers(world, draft, world.producer_id, second, first="studio")
    sent = contracts.send(draft)
    needs = "needs your signature"
    assert any(needs in text for text in mails.texts_for(f"{world.producer_id}@example.test"))
    assert not any(needs in text for text in mails.texts_for(f"{second}@example.test"))
    assert not any(needs in text for text in mails.texts_for(f"{world.designer_id}@example.test"))
    sign(world.producer, sent, code_for(world, mails, sent, world.producer, world.producer_id))
    assert any(needs in text for text in mails.texts_for(f"{second}@example.test"))
    sign(world.signed_in(second), sent, code_for(world, mails, sent, world.signed_in(second), second))
    assert any(needs in text for text in mails.texts_for(f"{world.designer_id}@example.test"))


@pytest.mark.parametrize("who", ["thrice", "designer", "reviewer", "twice"])
def test_only_producers_are_named_and_two_at_most(world: World, contracts: Contracts, second: UUID, who: str) -> None:
    people = {
        "thrice": [world.producer_id, second, new_id()],
        "designer": [world.designer_id],
        "reviewer": [world.reviewer_id],
        "twice": [second, second],
    }[who]
    answer = name_signers(world, contracts.begin(), *people)
    assert refusal(answer) == ((422, "too-many-signers") if who == "thrice" else (403, "not-a-signer"))


@pytest.mark.slow
def test_signers_stand_once_it_is_sent(world: World, contracts: Contracts) -> None:
    sent = contracts.send(contracts.begin())
    assert refusal(name_signers(world, sent, world.producer_id)) == (409, "wrong-state")


@pytest.mark.slow
def test_who_signed_an_agreed_contract_is_final(world: World, contracts: Contracts) -> None:
    agreed = contracts.agree(contracts.begin())
    answer = name_signers(world, agreed, world.producer_id)
    assert refusal(answer) == (409, "wrong-state")
    assert answer.json()["fix"].startswith("this is final")


@pytest.fixture
def mails(world: World) -> Iterator[MailServer]:
    verified = sa.update(Person).values(email_verified_at=clock.now(), email_proof=AddressProof.MAIL)
    world.server.in_database(lambda session: session.execute(verified))
    with mail_server(world.server) as box:
        yield box


def code_for(world: World, mails: MailServer, contract: dict[str, Any], by: Client, person_id: UUID) -> str:
    body = {"text_sha256": contract["version"]["text_sha256"]}
    asked = by.post(f"/v1/contracts/{contract['id']}/signing-codes", json=body)
    assert asked.status_code == 201, asked.text
    address = f"{person_id}@example.test"
    assert (asked.json()["email"], asked.json()["tries"]) == (address, CODE_TRIES)
    codes = re.findall(r"^(\d{6})\r?$", "\n".join(mails.texts_for(address)), re.MULTILINE)
    return str(codes[-1])


@pytest.mark.slow
def test_a_name_counts_with_the_code_that_was_mailed(world: World, contracts: Contracts, mails: MailServer) -> None:
    sent = contracts.send(contracts.begin())
    assert refusal(sign(world.designer, sent)) == (403, "signing-code-needed")
    code = code_for(world, mails, sent, world.designer, world.designer_id)
    world.designer.headers["User-Agent"] = "Mozilla/5.0 (X11; Linux x86_64) Firefox/140.0"
    signed = sign(world.designer, sent, f"{code[:3]} {code[3:]}")
    assert signed.status_code == 200
    assert signed.json()["acceptances"][0]["code_entered_at"] is not None
    (entry,) = [one["payload"] for one in contracts.entries(sent) if one["kind"] == "accepted_by"]
    assert entry["code"] == "a code mailed to that address was typed"
    assert entry["consent"] == CONSENT
    assert entry["agent"].startswith("Firefox")


@pytest.mark.slow
def test_neither_database_nor_outbox_holds_the_code(world: World, contracts: Contracts, mails: MailServer) -> None:
    sent = contracts.send(contracts.begin())
    code = code_for(world, mails, sent, world.designer, world.designer_id)

    def everything(session: Any) -> str:
        tables = ("contracts_signing_codes", "notifications_mails", "workflow_status")
        dialect = session.get_bind().dialect.name
        names = [f"dbos.{name}" if name == "workflow_status" and dialect == "postgresql" else name for name in tables]
        selects = [sa.select(sa.text("*")).select_from(sa.text(name)) for name in names]
        return json.dumps([[list(map(str, row)) for row in session.execute(select)] for select in selects])

    assert not re.search(rf"(?<!\d){code}(?!\d)", world.server.in_database(everything))


@pytest.mark.slow
def test_a_code_is_for_one_text_one_person_and_one_time(world: World, contracts: Contracts, mails: MailServer) -> None:
    first, other = contracts.send(contracts.begin()), contracts.send(contracts.begin(title="Music"))
    code = code_for(world, mails, first, world.designer, world.designer_id)
    assert refusal(sign(world.designer, other, code)) == (409, "signing-code-over")
    assert refusal(sign(world.producer, first, code)) == (409, "signing-code-over")
    assert sign(world.designer, first, code).status_code == 200
    contracts.ask(world.producer, "POST", f"/contracts/{first['id']}/recall", json={"reason": "A word is missing."})
    again = contracts.send(first)
    assert refusal(sign(world.designer, again, code)) == (409, "signing-code-over")


def wrong(code: str) -> str:
    return f"{(int(code) + 1) % 1_000_000:06}"


@pytest.mark.slow
def test_a_code_is_tried_five_times(world: World, contracts: Contracts, mails: MailServer) -> None:
    sent = contracts.send(contracts.begin())
    code = code_for(world, mails, sent, world.designer, world.designer_id)
    for left in (4, 3, 2, 1, 0):
        answer = sign(world.designer, sent, wrong(code))
        assert refusal(answer) == (403, "wrong-signing-code")
        again = {1: "can be tried 1 more time", 0: "cannot be tried again"}.get(left, f"can be tried {left} more times")
        assert answer.json()["detail"] == f"this is not the code that was mailed; it {again}"
    assert refusal(sign(world.designer, sent, code)) == (409, "signing-code-over")
    assert sign(world.designer, sent, code_for(world, mails, sent, world.designer, world.designer_id)).is_success


@pytest.mark.slow
def test_a_code_ends_after_ten_minutes_and_with_the_next_one(
    world: World, contracts: Contracts, mails: MailServer
) -> None:
    sent = contracts.send(contracts.begin())
    first = code_for(world, mails, sent, world.designer, world.designer_id)

    def lifetime(session: Any) -> timedelta:
        expires_at = session.scalars(
            sa.select(SigningCode.expires_at).where(SigningCode.contract_id == UUID(sent["id"]))
        ).one()
        return expires_at - clock.now()

    assert timedelta(minutes=8) < world.server.in_database(lifetime) <= timedelta(minutes=10)
    second = code_for(world, mails, sent, world.designer, world.designer_id)
    if first != second:
        assert refusal(sign(world.designer, sent, first)) == (403, "wrong-signing-code")
    over = sa.update(SigningCode).values(expires_at=clock.now())
    world.server.in_database(lambda session: session.execute(over))
    assert refusal(sign(world.designer, sent, second)) == (409, "signing-code-over")
    assert (
        world.server.in_database(
            lambda session: session.scalars(
                sa.select(ContractAcceptance).where(ContractAcceptance.contract_id == UUID(sent["id"]))
            ).all()
        )
        == []
    )


@pytest.mark.slow
def test_codes_are_mailed_a_few_times_only(world: World, contracts: Contracts, mails: MailServer) -> None:
    sent = contracts.send(contracts.begin())
    path, body = f"/v1/contracts/{sent['id']}/signing-codes", {"text_sha256": sent["version"]["text_sha256"]}
    codes = [world.designer.post(path, json=body).status_code for _ in range(6)]
    assert codes == [201] * 5 + [429]


@pytest.mark.slow
def test_a_change_order_is_signed_with_a_code_too(world: World, contracts: Contracts, mails: MailServer) -> None:
    cue, begun = Stage(world).cue("radar_ping"), contracts.begin()
    plan = {"milestones": [milestone("Alpha", cue, amount_minor=36_000)]}
    contracts.ask(world.producer, "PUT", f"/contracts/{begun['id']}/milestones", json=plan)
    agreed = sent = contracts.send(begun)
    for by, person_id in ((world.designer, world.designer_id), (world.producer, world.producer_id)):
        agreed = sign(by, sent, code_for(world, mails, sent, by, person_id)).json()
    order = {"reason": "More", "changes": [{"kind": "add_round", "cue_id": str(cue)}]}
    path = f"/v1/contracts/{agreed['id']}/change-orders"
    text_sha256 = contracts.ask(world.producer, "POST", path.removeprefix("/v1"), json=order)["orders"][0][
        "text_sha256"
    ]
    body = {"name": "N. Designer", "text_sha256": text_sha256}
    assert refusal(world.designer.post(f"{path}/1/accept", json=body)) == (403, "signing-code-needed")
    code = code_for(world, mails, {"id": agreed["id"], "version": body}, world.designer, world.designer_id)
    assert world.designer.post(f"{path}/1/accept", json=body | {"code": code}).status_code == 200


@pytest.mark.slow
def test_without_mail_no_code_is_asked_for(world: World, contracts: Contracts) -> None:
    sent = contracts.send(contracts.begin())
    body = {"text_sha256": sent["version"]["text_sha256"]}
    answer = world.designer.post(f"/v1/contracts/{sent['id']}/signing-codes", json=body)
    assert refusal(answer) == (409, "no-signing-code")
    assert sign(world.designer, sent).status_code == 200
    (entry,) = [one["payload"] for one in contracts.entries(sent) if one["kind"] == "accepted_by"]
    assert entry["code"] == "none was asked for: this server sends no mail"


@pytest.mark.slow
def test_who_is_no_party_is_mailed_no_code(world: World, contracts: Contracts) -> None:
    sent = contracts.send(contracts.begin())
    body = {"text_sha256": sent["version"]["text_sha256"]}
    path = f"/v1/contracts/{sent['id']}/signing-codes"
    assert refusal(world.approver.post(path, json=body)) == (403, "not-your-contract")
    assert world.stranger.post(path, json=body).status_code == 404


@pytest.mark.slow
def test_a_second_factor_that_the_studio_requires_is_asked_of_either_party(world: World, contracts: Contracts) -> None:
    cue, begun = Stage(world).cue("radar_ping"), contracts.begin()
    plan = {"milestones": [milestone("Alpha", cue, amount_minor=36_000)]}
    contracts.ask(world.producer, "PUT", f"/contracts/{begun['id']}/milestones", json=plan)
    contract = contracts.send(begun)
    set_up_totp(world.producer)
    assert require_second_factor(world, "signing").status_code == 200
    refused = sign(world.designer, contract)
    assert refusal(refused) == REQUIRED
    assert refused.json()["detail"].startswith("Test studio requires a second factor of who signs its contracts")
    code = {"text_sha256": contract["version"]["text_sha256"]}
    assert refusal(world.designer.post(f"/v1/contracts/{contract['id']}/signing-codes", json=code)) == REQUIRED
    half = sign(world.producer, contract).json()
    assert [acceptance["party"] for acceptance in half["acceptances"]] == ["studio"]
    set_up_totp(world.designer)
    assert sign(world.designer, contract).json()["state"] == "agreed"
    assert world.designer.delete("/v1/me/totp").status_code == 204
    path = f"/v1/contracts/{contract['id']}/change-orders"
    order = {"reason": "More", "changes": [{"kind": "add_round", "cue_id": str(cue)}]}
    text_sha256 = world.producer.post(path, json=order).json()["orders"][0]["text_sha256"]
    signature = {"name": "Sound designer", "text_sha256": text_sha256}
    assert refusal(world.designer.post(f"{path}/1/accept", json=signature)) == REQUIRED
