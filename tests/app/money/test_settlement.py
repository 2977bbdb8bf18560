"""What verdicts, cuts and rounds do to a contract's money, over HTTP and in their own transactions."""

from typing import Any
from uuid import UUID

import pytest
import sqlalchemy as sa

from app.accounts.models import Studio
from app.agreements.models import ContractCue
from app.agreements.queries import events_of
from app.agreements.rules import ReleaseClause
from app.deliveries.rules import TakeState
from tests.app.money.agreed import Agreed, deposit, milestone
from tests.app.reviews.making import body_of, refused
from tests.support.server import World


@pytest.fixture
def agreed(world: World) -> Agreed:
    return Agreed(world)


def two_milestones(agreed: Agreed) -> list[UUID]:
    """Agree on a deposit and two milestones of two cues each; return the cues."""
    cues = [agreed.cue(name) for name in ("radar_ping", "dock_clamp", "mine_arm", "missile_launch")]
    agreed.agree(
        deposit(144_000),
        milestone("Alpha", *cues[:2], amount_minor=36_000),
        milestone("Beta", *cues[2:], amount_minor=63_000),
    )
    return cues


@pytest.mark.slow
def test_at_signing_the_deposit_is_due_and_prices_are_fixed(agreed: Agreed) -> None:
    two_milestones(agreed)
    assert agreed.owed() == [("deposit", 144_000)]
    assert agreed.figures() == {
        "agreed_minor": 243_000,
        "accepted_minor": 144_000,
        "paid_minor": 0,
        "due_minor": 144_000,
        "open_minor": 99_000,
        "saved_minor": 0,
    }
    plan = body_of(agreed.world.designer.get(f"/v1/contracts/{agreed.contract_id}/milestones"))
    assert [[cue["amount_minor"] for cue in one["cues"]] for one in plan["milestones"]] == [
        [],
        [18_000, 18_000],
        [31_500, 31_500],
    ]


def test_an_odd_cent_goes_to_the_largest_remainder(agreed: Agreed) -> None:
    cues = [agreed.cue(f"cue_{number}") for number in range(3)]
    agreed.agree(milestone("Alpha", *cues, amount_minor=100))
    plan = body_of(agreed.world.producer.get(f"/v1/contracts/{agreed.contract_id}/milestones"))
    assert [cue["amount_minor"] for cue in plan["milestones"][0]["cues"]] == [34, 33, 33]


@pytest.mark.slow
def test_the_last_approval_of_a_set_makes_its_share_due(agreed: Agreed) -> None:
    steps = agreed.cue("steps", variations=2)
    agreed.agree(milestone("Alpha", steps, amount_minor=18_000))
    first, second = agreed.take(steps), agreed.take(steps, 2)
    agreed.approve(first)
    assert agreed.owed() == []
    agreed.approve(second)
    (line,) = agreed.ledger()["lines"]
    assert (line["kind"], line["amount_minor"], line["clause"]) == ("accepted", 18_000, "acceptance")
    assert (line["cue"]["name"], line["milestone"], line["by"]) == ("steps", "Alpha", "Audio director")


@pytest.mark.slow
def test_picking_another_take_owes_nothing_more(agreed: Agreed) -> None:
    cue, *_ = two_milestones(agreed)
    first, second = agreed.take(cue), agreed.take(cue, state=TakeState.CONFORMING)
    agreed.approve(first)
    agreed.verdict(second, "approve")
    assert agreed.owed()[1:] == [("accepted", 18_000)]


@pytest.mark.slow
def test_an_undone_verdict_takes_its_share_back_by_a_reversing_line(agreed: Agreed) -> None:
    cue, *_ = two_milestones(agreed)
    take = agreed.take(cue)
    agreed.approve(take)
    body_of(agreed.undo(take))
    assert agreed.owed()[1:] == [("accepted", 18_000), ("reversed", -18_000)]
    agreed.approve(take)
    assert agreed.figures()["due_minor"] == 162_000


@pytest.mark.slow
def test_a_reversed_approval_takes_its_share_back_and_counts_no_round(agreed: Agreed) -> None:
    cue, *_ = two_milestones(agreed)
    take = agreed.take(cue)
    assert taken_back_minor(agreed, cue) == 0
    agreed.approve(take)
    assert taken_back_minor(agreed, cue) == 18_000, "said before it is sent"
    agreed.draft(take, seen_state="approved")
    agreed.send()
    assert agreed.owed()[1:] == [("accepted", 18_000), ("reversed", -18_000)]
    assert taken_back_minor(agreed, cue) == 0


def taken_back_minor(agreed: Agreed, cue_id: UUID) -> int:
    """Return what the approver is told that a change of an approved version takes back."""
    money: dict[str, Any] = body_of(agreed.world.approver.get(f"/v1/cues/{cue_id}/money"))
    minor: int = money["would_take_back_minor"]
    return minor


@pytest.mark.slow
def test_accepting_a_whole_set_in_one_click(agreed: Agreed) -> None:
    steps = agreed.cue("steps", variations=2)
    agreed.agree(milestone("Alpha", steps, amount_minor=18_000))
    agreed.take(steps)
    agreed.take(steps, 2)
    body_of(agreed.world.approver.post(f"/v1/cues/{steps}/accept-set", json={"note": "", "take_ids": []}))
    assert agreed.owed() == [("accepted", 18_000)]


@pytest.mark.slow
def test_with_release_on_completion_the_last_cue_releases_all(world: World) -> None:
    agreed = Agreed(world, release=ReleaseClause.ON_COMPLETION)
    cues = two_milestones(agreed)
    agreed.approve(agreed.take(cues[0]))
    assert agreed.owed()[1:] == []
    agreed.approve(agreed.take(cues[1]))
    assert agreed.owed()[1:] == [("accepted", 18_000), ("accepted", 18_000)]
    assert taken_back_minor(agreed, cues[0]) == 36_000, "the milestone is no longer whole"


def cut(agreed: Agreed, cue_id: UUID) -> Any:
    return agreed.world.producer.post(f"/v1/cues/{cue_id}/cut", json={"reason": "Mines left the game"})


@pytest.mark.slow
@pytest.mark.parametrize(
    ("state", "owed_minor"),
    [
        (None, 0),
        (TakeState.RETURNED, 15_750),
        (TakeState.CHANGE_REQUESTED, 15_750),
        (TakeState.CONFORMING, 23_625),  # three quarters
    ],
)
def test_a_cut_cue_is_owed_by_its_state(agreed: Agreed, state: TakeState | None, owed_minor: int) -> None:
    mine = two_milestones(agreed)[2]
    if state is not None:
        agreed.take(mine, state=state)
    assert cut(agreed, mine).status_code == 200
    figures = agreed.figures()
    assert figures["due_minor"] - 144_000 == owed_minor
    assert figures["saved_minor"] == 31_500 - owed_minor
    assert figures["open_minor"] == 99_000 - 31_500


@pytest.mark.slow
def test_takes_of_another_designer_are_no_work_under_this_contract(agreed: Agreed) -> None:
    mine = two_milestones(agreed)[2]
    agreed.take(mine, state=TakeState.CONFORMING, designer_id=agreed.world.other_designer_id)
    assert cut(agreed, mine).status_code == 200
    assert agreed.figures()["due_minor"] == 144_000, "only the deposit: its designer had not begun"


@pytest.mark.slow
def test_a_cut_cue_that_was_accepted_is_owed_whole(agreed: Agreed) -> None:
    mine = two_milestones(agreed)[2]
    agreed.approve(agreed.take(mine))
    cut(agreed, mine)
    assert agreed.owed()[1:] == [("accepted", 31_500)]


@pytest.mark.slow
def test_a_cue_is_cut_once(agreed: Agreed) -> None:
    mine = two_milestones(agreed)[2]
    agreed.take(mine, state=TakeState.RETURNED)
    cut(agreed, mine)
    assert refused(cut(agreed, mine))[0] == 409
    assert agreed.owed()[1:] == [("cut", 15_750)]


def three_rounds(agreed: Agreed, cue_id: UUID) -> str:
    """Ask for a change three times; return the id of the round beyond the two included."""
    for _ in range(3):
        agreed.draft(agreed.take(cue_id))
        agreed.send()
    (proposed,) = agreed.world.designer.get(f"/v1/contracts/{agreed.contract_id}/extra-rounds").json()
    assert (proposed["number"], proposed["included"], proposed["amount_minor"]) == (3, 2, 7_875)
    return str(proposed["id"])


@pytest.mark.slow
def test_a_round_too_many_is_priced_and_due_once_agreed(agreed: Agreed) -> None:
    missile = two_milestones(agreed)[3]
    extra = three_rounds(agreed, missile)
    assert agreed.owed()[1:] == []
    set_studio = sa.update(Studio).where(Studio.id == agreed.world.studio_id)
    agreed.world.server.in_database(lambda session: session.execute(set_studio.values(second_factor_for=["paying"])))
    agree = f"/v1/extra-rounds/{extra}/agree"
    assert refused(agreed.world.producer.post(agree)) == (403, "second-factor-required")
    assert agreed.owed()[1:] == []
    agreed.world.server.in_database(lambda session: session.execute(set_studio.values(second_factor_for=[])))
    answer = body_of(agreed.world.producer.post(agree))
    assert answer["state"] == "agreed"
    assert agreed.owed()[1:] == [("extra_round", 7_875)]
    assert agreed.figures()["agreed_minor"] == 243_000 + 7_875
    assert refused(agreed.world.producer.post(f"/v1/extra-rounds/{extra}/agree")) == (409, "round-already-settled")
    assert refused(agreed.world.designer.post(f"/v1/extra-rounds/{extra}/drop")) == (409, "round-already-settled")


@pytest.mark.slow
def test_a_round_whose_price_has_become_nothing_is_agreed_without_a_charge(agreed: Agreed) -> None:
    missile = two_milestones(agreed)[3]
    extra = three_rounds(agreed, missile)
    priced_again = sa.update(ContractCue).where(ContractCue.cue_id == missile).values(amount_minor=1)
    agreed.world.server.in_database(lambda session: session.execute(priced_again))
    assert body_of(agreed.world.producer.post(f"/v1/extra-rounds/{extra}/agree"))["state"] == "agreed"
    assert agreed.owed()[1:] == []


@pytest.mark.slow
def test_the_designer_may_let_a_round_go_and_not_agree_for_the_studio(agreed: Agreed) -> None:
    extra = three_rounds(agreed, two_milestones(agreed)[3])
    assert refused(agreed.world.designer.post(f"/v1/extra-rounds/{extra}/agree")) == (403, "other-party-needed")
    assert refused(agreed.world.stranger.post(f"/v1/extra-rounds/{extra}/agree"))[0] == 404
    assert body_of(agreed.world.designer.post(f"/v1/extra-rounds/{extra}/drop"))["state"] == "dropped"
    assert agreed.owed()[1:] == []


@pytest.mark.slow
def test_without_a_contract_nothing_is_owed(world: World) -> None:
    agreed = Agreed(world)
    cue = agreed.cue("radar_ping")
    agreed.approve(agreed.take(cue))
    assert agreed.owed() == []


@pytest.mark.slow
def test_another_designers_take_owes_this_designer_nothing(agreed: Agreed) -> None:
    cue, *_ = two_milestones(agreed)
    agreed.approve(agreed.take(cue, designer_id=agreed.world.other_designer_id))
    assert agreed.owed()[1:] == []


@pytest.mark.slow
def test_every_line_stands_in_the_record(agreed: Agreed) -> None:
    cue, *_ = two_milestones(agreed)
    agreed.approve(agreed.take(cue))
    notified_of = agreed.world.server.in_database(lambda session: list(events_of(session, agreed.contract_id)))
    assert [one.kind for one in notified_of] == ["planned", "due", "judged", "accepted", "due"]
