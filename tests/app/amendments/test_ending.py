"""Ending an agreed contract: notice, the statement that both see, and its settlement in one step."""

import io
from datetime import timedelta
from typing import Any
from uuid import UUID

import pytest
import sqlalchemy as sa
from pypdf import PdfReader

from app import commercial
from app.agreements.models import Contract
from app.agreements.queries import events_of
from app.agreements.rules import ContractState, ReleaseClause
from app.amendments import jobs
from app.amendments.errors import NoticeTooShort
from app.amendments.models import Notice
from app.amendments.rules import end_of_notice, is_over
from app.core import clock
from app.deliveries.rules import TakeState
from tests.app.agreements.conftest import Contracts
from tests.app.money.agreed import TODAY, Agreed, day, deposit, milestone
from tests.app.reviews.making import body_of, refused
from tests.support.server import World

TERMS = {"notice_days": 14}
REASON = "The game is shelved."


def pages_of(pdf: bytes) -> list[str]:
    """Return the words of each page, without the line below them."""
    texts = (" ".join(page.extract_text().split()) for page in PdfReader(io.BytesIO(pdf)).pages)
    return [text.partition("SHA-256 of the text")[0] for text in texts]


@pytest.fixture
def agreed(world: World) -> Agreed:
    return Agreed(world, terms=TERMS)


def half_way(agreed: Agreed) -> list[UUID]:
    """Agree on a deposit and five cues; accept one, and leave the others not begun, in work, delivered and cut."""
    names = ("radar_ping", "dock_clamp", "mine_arm", "missile_launch", "warp_in")
    cues = [agreed.cue(name) for name in names]
    agreed.agree(
        deposit(144_000),
        milestone("Alpha", *cues[:2], amount_minor=36_000),
        milestone("Beta", *cues[2:], amount_minor=94_500),
    )
    agreed.approve(agreed.take(cues[0]))
    agreed.take(cues[2], state=TakeState.RETURNED)
    agreed.take(cues[3], state=TakeState.CONFORMING)
    agreed.take(cues[4], state=TakeState.RETURNED)
    body_of(agreed.world.producer.post(f"/v1/cues/{cues[4]}/cut", json={"reason": "Left the game"}))
    return cues


def ending(agreed: Agreed, by: Any = None) -> dict[str, Any]:
    return body_of((by or agreed.world.producer).get(f"/v1/contracts/{agreed.contract_id}/ending"))


def give_notice(agreed: Agreed, by: Any = None, **more: Any) -> Any:
    body = {"reason": REASON, **more}
    return (by or agreed.world.producer).post(f"/v1/contracts/{agreed.contract_id}/ending/notice", json=body)


def agree(agreed: Agreed, by: Any, name: str, sha256: str | None = None) -> Any:
    body = {"name": name, "text_sha256": sha256 or ending(agreed)["statement_sha256"]}
    return by.post(f"/v1/contracts/{agreed.contract_id}/ending/agree", json=body)


def both_agree(agreed: Agreed) -> dict[str, Any]:
    body_of(agree(agreed, agreed.world.designer, "N. Designer"))
    return body_of(agree(agreed, agreed.world.producer, "P. Producer"))


def entries(agreed: Agreed) -> list[str]:
    return agreed.world.server.in_database(
        lambda session: [entry.kind for entry in events_of(session, agreed.contract_id)]
    )


def state_of(agreed: Agreed) -> str:
    return body_of(agreed.world.producer.get(f"/v1/contracts/{agreed.contract_id}"))["state"]


@pytest.mark.slow
def test_before_a_notice_it_is_a_forecast(agreed: Agreed) -> None:
    half_way(agreed)
    said = ending(agreed)
    assert (said["state"], said["statement_sha256"], said["signed"]) == ("forecast", None, [])
    assert [(cue["cue"]["name"], cue["state"], cue["part_bp"], cue["owed_minor"]) for cue in said["cues"]] == [
        ("radar_ping", "accepted", 10_000, 18_000),
        ("dock_clamp", "not_begun", 0, 0),
        ("mine_arm", "in_work", 5_000, 15_750),
        ("missile_launch", "delivered", 7_500, 23_625),
        ("warp_in", "in_work", 5_000, 15_750),
    ]
    assert [cue["was_cut"] for cue in said["cues"]] == [False] * 4 + [True]
    assert (said["cues_minor"], said["deposit_minor"]) == (73_125, 144_000)
    assert said["figures"] == {
        "agreed_minor": 274_500,
        "accepted_minor": 217_125,
        "paid_minor": 0,
        "due_minor": 217_125,
        "open_minor": 0,
        "saved_minor": 57_375,
    }
    assert said["due_now_minor"] == 144_000 + 18_000 + 15_750
    assert said["earliest_ends_on"] == day(14)
    assert agreed.figures()["open_minor"] > 0, "a forecast changes nothing"


@pytest.mark.slow
@pytest.mark.both_databases
def test_when_both_agree_the_ledger_has_it_in_one_step(agreed: Agreed) -> None:
    half_way(agreed)
    body_of(give_notice(agreed))
    before = agreed.owed()
    statement = ending(agreed, agreed.world.designer)
    assert (statement["state"], statement["notice"]["ends_on"]) == ("notice", day(14))
    one = body_of(agree(agreed, agreed.world.designer, "N. Designer"))
    assert agreed.owed() == before
    assert (state_of(agreed), [each["party"] for each in one["signed"]]) == ("agreed", ["designer"])
    settled = body_of(agree(agreed, agreed.world.producer, "P. Producer"))
    assert agreed.owed() == [*before, ("cut", 15_750), ("cut", 23_625)]
    assert (settled["state"], settled["figures"]) == ("settled", statement["figures"])
    assert settled["statement_sha256"] == statement["statement_sha256"]
    assert [cue["owed_minor"] for cue in settled["cues"]] == [cue["owed_minor"] for cue in statement["cues"]]
    assert [cue["was_cut"] for cue in settled["cues"]] == [False] * 4 + [True]
    assert (agreed.figures(), state_of(agreed)) == (statement["figures"], "ended")
    said = ["notice_given", "statement_accepted", "statement_accepted", "settled", "due", "due", "ended"]
    assert entries(agreed)[-7:] == said
    contract = body_of(agreed.world.producer.get(f"/v1/contracts/{agreed.contract_id}"))
    assert contract["end_reason"] == REASON


@pytest.mark.slow
def test_cutting_a_settled_cue_owes_nothing_twice(agreed: Agreed) -> None:
    cues = half_way(agreed)
    body_of(give_notice(agreed))
    both_agree(agreed)
    before = agreed.owed()
    body_of(agreed.world.producer.post(f"/v1/cues/{cues[2]}/cut", json={"reason": "Left the game"}))
    assert agreed.owed() == before


@pytest.mark.slow
def test_what_is_settled_is_invoiced_and_paid(agreed: Agreed) -> None:
    half_way(agreed)
    paid = agreed.invoice()
    assert agreed.pay(paid, paid["total_minor"]).status_code == 201
    body_of(give_notice(agreed))
    assert ending(agreed)["figures"]["due_minor"] == 15_750 + 23_625
    both_agree(agreed)
    last = agreed.invoice()
    assert last["total_minor"] == 15_750 + 23_625
    assert agreed.pay(last, last["total_minor"]).status_code == 201
    assert (agreed.figures()["due_minor"], agreed.figures()["open_minor"]) == (0, 0)


@pytest.mark.slow
def test_approval_of_an_outdated_state_no_longer_counts(agreed: Agreed) -> None:
    cues = half_way(agreed)
    body_of(give_notice(agreed))
    seen = ending(agreed)["statement_sha256"]
    body_of(agree(agreed, agreed.world.designer, "N. Designer"))
    agreed.take(cues[1], state=TakeState.RETURNED)  # begun since
    answer = agree(agreed, agreed.world.producer, "P. Producer", seen)
    assert refused(answer) == (409, "text-changed")
    now = ending(agreed)
    assert (now["signed"], now["may"]["agree"]) == ([], True)
    both_agree(agreed)
    assert state_of(agreed) == "ended"


@pytest.mark.slow
def test_one_party_agrees_once(agreed: Agreed) -> None:
    half_way(agreed)
    body_of(give_notice(agreed))
    body_of(agree(agreed, agreed.world.designer, "N. Designer"))
    assert refused(agree(agreed, agreed.world.designer, "N. Designer")) == (409, "already-accepted")
    assert ending(agreed, agreed.world.designer)["may"] == {"give_notice": False, "withdraw": False, "agree": False}


def end_yesterday(agreed: Agreed) -> None:
    yesterday = TODAY - timedelta(days=1)
    agreed.world.server.in_database(
        lambda session: session.execute(
            sa.update(Notice).where(Notice.contract_id == agreed.contract_id).values(ends_on=yesterday)
        )
    )


@pytest.mark.slow
@pytest.mark.both_databases
def test_without_agreement_the_last_day_settles_it_once(agreed: Agreed) -> None:
    half_way(agreed)
    body_of(give_notice(agreed, agreed.world.designer))
    jobs.settle_ended(agreed.world.server.runtime, {})
    assert state_of(agreed) == "agreed"
    end_yesterday(agreed)
    forecast = ending(agreed)["figures"]
    for _ in range(2):
        jobs.settle_ended(agreed.world.server.runtime, {})
    assert (agreed.figures(), state_of(agreed)) == (forecast, "ended")
    assert agreed.owed()[-2:] == [("cut", 15_750), ("cut", 23_625)]
    assert entries(agreed).count("settled") == 1
    assert "amendments.settle_ended" in commercial.CHORES


@pytest.mark.slow
def test_only_who_gave_the_notice_withdraws_it(agreed: Agreed) -> None:
    half_way(agreed)
    path = f"/v1/contracts/{agreed.contract_id}/ending/withdraw"
    assert refused(agreed.world.producer.post(path)) == (409, "no-notice")
    body_of(give_notice(agreed))
    assert refused(give_notice(agreed, agreed.world.designer)) == (409, "notice-given")
    assert refused(agreed.world.designer.post(path)) == (403, "not-your-contract")
    assert body_of(agreed.world.producer.post(path))["state"] == "forecast"
    body_of(give_notice(agreed, agreed.world.designer))
    assert entries(agreed)[-3:] == ["notice_given", "notice_withdrawn", "notice_given"]
    both_agree(agreed)
    assert refused(agreed.world.designer.post(path)) == (409, "already-ended")
    assert refused(give_notice(agreed)) == (409, "already-ended")


@pytest.mark.slow
def test_notice_is_as_long_as_the_contract_says(agreed: Agreed) -> None:
    half_way(agreed)
    assert refused(give_notice(agreed, ends_on=day(13))) == (422, "notice-too-short")
    assert body_of(give_notice(agreed, ends_on=day(20)))["notice"]["ends_on"] == day(20)


def test_rules_of_notice() -> None:
    assert end_of_notice(TODAY, 0, None) == TODAY
    assert end_of_notice(TODAY, None, None) is None
    with pytest.raises(NoticeTooShort):
        end_of_notice(TODAY, None, TODAY)
    assert [is_over(one, TODAY) for one in (None, TODAY, TODAY - timedelta(days=1))] == [False, False, True]


@pytest.mark.slow
def test_without_the_clause_it_ends_only_when_both_agree(world: World) -> None:
    agreed = Agreed(world)
    half_way(agreed)
    assert refused(give_notice(agreed, ends_on=day(90))) == (422, "notice-too-short")
    assert body_of(give_notice(agreed))["notice"]["ends_on"] is None
    jobs.settle_ended(world.server.runtime, {})
    assert state_of(agreed) == "agreed"
    both_agree(agreed)
    assert state_of(agreed) == "ended"


@pytest.mark.slow
def test_a_deposit_that_is_set_off(world: World) -> None:
    agreed = Agreed(world, terms=TERMS | {"deposit_at_end": "set_off"})
    half_way(agreed)
    paid = agreed.invoice()
    assert agreed.pay(paid, paid["total_minor"]).status_code == 201
    body_of(give_notice(agreed))
    statement = ending(agreed)
    assert (statement["deposit_minor"], statement["figures"]["accepted_minor"]) == (0, 73_125)
    assert statement["figures"]["due_minor"] == 15_750 + 23_625 - 144_000
    both_agree(agreed)
    assert agreed.owed()[-3:] == [("cut", 15_750), ("cut", 23_625), ("reversed", -144_000)]
    assert agreed.figures() == statement["figures"]
    assert agreed.invoice()["total_minor"] == 15_750 + 23_625 - 144_000, "a credit note"


@pytest.mark.slow
def test_what_waited_for_a_whole_milestone_is_due(world: World) -> None:
    agreed = Agreed(world, terms=TERMS, release=ReleaseClause.ON_COMPLETION)
    half_way(agreed)
    assert agreed.owed()[1:] == [("cut", 15_750)], "the accepted cue waits for its milestone"
    body_of(give_notice(agreed))
    both_agree(agreed)
    assert sorted(agreed.owed()[1:]) == [("accepted", 18_000), ("cut", 15_750), ("cut", 15_750), ("cut", 23_625)]


@pytest.mark.slow
def test_days_count_that_the_studio_agreed_to(world: World) -> None:
    terms = TERMS | {"price_mode": "day_rate", "day_rate_minor": 40_000, "days_cap": 10}
    agreed = Agreed(world, terms=terms)
    agreed.agree(milestone("Month", agreed.cue("radar_ping"), amount_minor=0))
    for number, is_agreed in ((1, True), (2, False)):
        body = {"worked_on": day(-number), "quarters": 4, "note": ""}
        logged = world.designer.post(f"/v1/contracts/{agreed.contract_id}/worked-days", json=body).json()
        if is_agreed:
            body_of(world.producer.post(f"/v1/worked-days/{logged['id']}/agree"))
    body_of(give_notice(agreed))
    statement = ending(agreed)
    assert (statement["days_minor"], statement["figures"]["saved_minor"]) == (40_000, 360_000)
    assert [(one["kind"], one["amount_minor"]) for one in statement["open_points"]] == [("day", 40_000)]
    both_agree(agreed)
    body_of(world.producer.post(f"/v1/worked-days/{logged['id']}/agree"))
    figures = agreed.figures()
    assert (figures["accepted_minor"], figures["open_minor"], figures["saved_minor"]) == (80_000, 0, 320_000)


def test_another_designers_takes_are_not_this_ones_work(agreed: Agreed) -> None:
    cue = agreed.cue("radar_ping")
    agreed.agree(milestone("Alpha", cue, amount_minor=18_000))
    agreed.take(cue, state=TakeState.CONFORMING, designer_id=agreed.world.other_designer_id)
    (said,) = ending(agreed)["cues"]
    assert (said["state"], said["owed_minor"]) == ("not_begun", 0)


@pytest.mark.slow
def test_the_next_designer_may_be_contracted_for_what_was_left(agreed: Agreed, contracts: Contracts) -> None:
    cues = half_way(agreed)
    body_of(give_notice(agreed))
    both_agree(agreed)
    begun = contracts.begin()
    plan = {"milestones": [milestone("Beta", cues[1], cues[3], amount_minor=50_000)]}
    saved = body_of(agreed.world.producer.put(f"/v1/contracts/{begun['id']}/milestones", json=plan))
    assert "covered-elsewhere" not in {advice["code"] for advice in saved["advice"]}
    assert contracts.agree(begun)["state"] == "agreed"


@pytest.mark.slow
def test_a_contract_that_ended_without_settlement_is_settled_by_both(agreed: Agreed) -> None:
    """Before settlements existed, ending wrote no line; such a contract is settled where both agree."""
    half_way(agreed)
    ended = {"state": ContractState.ENDED, "ended_at": clock.now(), "end_reason": "Long ago"}
    agreed.world.server.in_database(
        lambda session: session.execute(sa.update(Contract).where(Contract.id == agreed.contract_id).values(ended))
    )
    assert body_of(give_notice(agreed))["notice"]["ends_on"] is None
    both_agree(agreed)
    assert agreed.owed()[-2:] == [("cut", 15_750), ("cut", 23_625)]


@pytest.mark.slow
def test_who_sees_and_who_acts(agreed: Agreed) -> None:
    half_way(agreed)
    world, path = agreed.world, f"/v1/contracts/{agreed.contract_id}/ending"
    for client in (world.reviewer, world.other_designer, world.stranger):
        assert client.get(path).status_code == 404
        assert client.post(f"{path}/notice", json={"reason": REASON}).status_code == 404
    assert world.approver.get(path).status_code == 200
    assert refused(world.approver.post(f"{path}/notice", json={"reason": REASON})) == (403, "not-your-contract")
    assert refused(world.producer.post(f"/v1/contracts/{agreed.contract_id}/end", json={"reason": REASON})) == (
        409,
        "notice-needed",
    )


@pytest.mark.slow
def test_the_statement_as_pdf(agreed: Agreed) -> None:
    half_way(agreed)
    path = f"/v1/contracts/{agreed.contract_id}/ending/statement.pdf"
    assert refused(agreed.world.designer.get(path)) == (409, "no-notice")
    body_of(give_notice(agreed))
    first = agreed.world.designer.get(path)
    assert (first.status_code, first.headers["content-type"]) == (200, "application/pdf")
    assert first.content == agreed.world.producer.get(path).content
    assert first.content[:5] == b"%PDF-"
    both_agree(agreed)
    signed = agreed.world.designer.get(path).content
    assert signed == agreed.world.producer.get(path).content
    *statement, signatures = pages_of(signed)
    assert statement == pages_of(first.content), "what both agreed to is what is kept"
    assert signatures.startswith("Signatures")


@pytest.mark.slow
def test_both_are_notified_by_mail(agreed: Agreed) -> None:
    half_way(agreed)
    body_of(give_notice(agreed))
    both_agree(agreed)
    agreed.world.server.wait_for_jobs()
    mails = body_of(agreed.world.producer.get(f"/v1/studios/{agreed.world.studio_id}/outbox"))["mails"]
    subjects = [mail["subject"] for mail in mails]
    assert subjects.count("Shield Wing: notice was given on a contract") == 2
    assert subjects.count("Shield Wing: a contract has ended") == 2
