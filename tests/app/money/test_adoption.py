"""Work that was accepted before its contract is taken into it when both have agreed."""

from typing import Any
from uuid import UUID

import pytest

from app.agreements.models import ContractCue
from app.agreements.rules import AcceptedBy
from app.deliveries.rules import TakeState
from app.money import jobs
from tests.app.agreements.conftest import Contracts
from tests.app.money.agreed import day
from tests.app.reviews.making import Stage
from tests.support.server import World

pytestmark = pytest.mark.slow

APPROVED = {"state": TakeState.APPROVED}


@pytest.fixture
def stage(world: World) -> Stage:
    return Stage(world)


def agree(contracts: Contracts, *cue_ids: UUID, **more: Any) -> dict[str, Any]:
    """Agree on 180.00 for each cue, in one milestone, and wait for what follows."""
    begun = contracts.begin(**more)
    cues = [{"cue_id": str(cue_id), "price_minor": 18_000} for cue_id in cue_ids]
    plan = {"milestones": [{"name": "Alpha", "due_on": day(14), "cues": cues}]}
    contracts.ask(contracts.world.producer, "PUT", f"/contracts/{begun['id']}/milestones", json=plan)
    agreed = contracts.agree(begun)
    contracts.world.server.wait_for_jobs()
    return agreed


def owed(contracts: Contracts, contract: dict[str, Any]) -> list[tuple[str, int, str]]:
    ledger = contracts.ask(contracts.world.producer, "GET", f"/contracts/{contract['id']}/ledger")
    return [(line["kind"], line["amount_minor"], line["clause"]) for line in ledger["lines"]]


def how(world: World, cue_id: UUID) -> list[AcceptedBy | None]:
    def read(session: Any) -> list[AcceptedBy | None]:
        found = session.query(ContractCue).filter_by(cue_id=cue_id).order_by(ContractCue.id)
        return [covered.accepted_by for covered in found]

    return world.server.in_database(read)


def test_what_was_approved_before_is_due_with_the_agreement(world: World, stage: Stage, contracts: Contracts):
    before, waiting = stage.cue("radar_ping"), stage.cue("dock_clamp")
    stage.approve(stage.take(before))
    take = stage.take(waiting)
    agreed = agree(contracts, before, waiting)
    assert owed(contracts, agreed) == [("accepted", 18_000, "acceptance")]
    kinds = [entry["kind"] for entry in contracts.entries(agreed)]
    assert [kind for kind in kinds if kind != "sealed"][-3:] == ["planned", "adopted", "due"]
    [adopted] = [entry["payload"] for entry in contracts.entries(agreed) if entry["kind"] == "adopted"]
    reported = (adopted["by"], adopted["role"], adopted["approved_by"], adopted["cue"].endswith("radar_ping"))
    assert reported == ("Soundlist", "server", "Audio director", True)
    assert how(world, before) == [AcceptedBy.ADOPTION]
    stage.approve(take)
    assert how(world, waiting) == [AcceptedBy.VERDICT]


def test_adopting_again_doubles_nothing(world: World, stage: Stage, contracts: Contracts):
    cue = stage.cue()
    stage.approve(stage.take(cue))
    agreed = agree(contracts, cue)
    for _ in range(2):
        jobs.add_accepted_cues(world.server.runtime, {"contract_id": agreed["id"]})
    stage.verdict(stage.take(cue), "approve")  # another version is picked
    assert owed(contracts, agreed) == [("accepted", 18_000, "acceptance")]
    assert [entry["kind"] for entry in contracts.entries(agreed)].count("adopted") == 1


def test_the_last_of_a_milestone_waits_for_the_others(world: World, stage: Stage, contracts: Contracts):
    before, later = stage.cue("radar_ping"), stage.cue("dock_clamp")
    stage.approve(stage.take(before))
    begun = contracts.begin()
    cues = [{"cue_id": str(cue_id)} for cue_id in (before, later)]
    plan = {"milestones": [{"name": "Alpha", "amount_minor": 36_000, "cues": cues}]}
    contracts.ask(world.producer, "PUT", f"/contracts/{begun['id']}/milestones", json=plan)
    agreed = contracts.agree(contracts.save(begun, release_clause="on_completion"))
    world.server.wait_for_jobs()
    assert owed(contracts, agreed) == []
    stage.approve(stage.take(later))
    assert [amount for _, amount, _ in owed(contracts, agreed)] == [18_000, 18_000]


@pytest.mark.parametrize("missing", ["half a set", "another's work"])
def test_only_a_whole_cue_of_this_designer_is_adopted(world: World, stage: Stage, contracts: Contracts, missing: str):
    cue = stage.cue("steps", variations=2)
    first = {} if missing == "half a set" else {"designer_id": world.other_designer_id}
    stage.take(cue, **APPROVED, **first)
    if missing == "another's work":
        stage.take(cue, 2, **APPROVED, **first)
    assert owed(contracts, agree(contracts, cue)) == []


def test_what_another_contract_has_paid_for_is_not_owed_again(world: World, stage: Stage, contracts: Contracts):
    cue = stage.cue()
    stage.approve(stage.take(cue))
    first = agree(contracts, cue)
    contracts.end(first)
    second = agree(contracts, cue, title="Once more")
    assert owed(contracts, second) == []
    assert how(world, cue) == [AcceptedBy.ADOPTION, None]


def test_an_adopted_milestone_says_nothing_of_estimates(world: World, stage: Stage, contracts: Contracts):
    cue = stage.cue()
    stage.approve(stage.take(cue))
    agreed = agree(contracts, cue)
    estimates = contracts.ask(world.designer, "GET", f"/contracts/{agreed['id']}/estimates")
    assert estimates["milestones"] == []
