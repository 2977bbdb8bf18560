"""Money is seen by those between whom it changes hands: those who act for the studio, and the designer who earns it."""

from typing import Any

import pytest
from httpx2 import Client

from app.accounts.models import Membership
from app.accounts.rules import Role
from tests.app.accounts.test_second_factor_requirements import REQUIRED, require_second_factor, set_up_totp
from tests.app.money.agreed import TODAY, Agreed, day, milestone
from tests.app.reviews.making import body_of, refused
from tests.support.calendars import calendar_of, events_at, events_of
from tests.support.server import World


@pytest.fixture
def invoiced(world: World) -> tuple[Agreed, dict[str, Any]]:
    """Return a contract with an invoice over its one cue, which was accepted four days late."""
    agreed = Agreed(world)
    cue = agreed.cue("radar_ping")
    agreed.agree(milestone("Alpha", cue, amount_minor=18_000, due_on=day(-4)))
    agreed.approve(agreed.take(cue))
    return agreed, agreed.invoice()


@pytest.fixture
def deputy(world: World) -> Client:
    """Sign in another producer of the studio."""
    world.server.in_database(
        lambda session: setattr(
            session.get_one(Membership, (world.studio_id, world.approver_id)), "roles", [Role.LIAISON, Role.PRODUCER]
        )
    )
    return world.approver


@pytest.mark.slow
def test_no_sight_is_no_contract_and_no_invoice(invoiced: tuple[Agreed, dict[str, Any]]) -> None:
    agreed, invoice = invoiced
    world, contract = agreed.world, f"/v1/contracts/{agreed.contract_id}"
    paths = [
        contract,
        *(f"{contract}/{what}" for what in ("milestones", "ledger", "invoices", "extra-rounds", "estimates")),
        f"/v1/invoices/{invoice['id']}",
        f"/v1/invoices/{invoice['id']}/invoice.pdf",
    ]
    for path in paths:
        for outsider in (world.stranger, world.other_designer, world.reviewer):
            assert outsider.get(path).status_code == 404, path
    body = {"amount_minor": 1, "reference": "T", "paid_on": TODAY.isoformat()}
    by_reviewer = world.reviewer.post(f"/v1/invoices/{invoice['id']}/payments", json=body)
    assert refused(by_reviewer) == (404, "invoice-not-found")


def test_sight_is_not_yet_a_right(invoiced: tuple[Agreed, dict[str, Any]]) -> None:
    agreed, invoice = invoiced
    world = agreed.world
    body = {"amount_minor": 1, "reference": "T", "paid_on": TODAY.isoformat()}
    for looker in (world.designer, world.approver):
        assert body_of(looker.get(f"/v1/invoices/{invoice['id']}"))["total_minor"] == 18_000
        paid = looker.post(f"/v1/invoices/{invoice['id']}/payments", json=body)
        assert refused(paid) == (403, "producer-needed")
    mine = world.producer.post(f"/v1/contracts/{agreed.contract_id}/invoices", json={"seller": "me"})
    assert refused(mine) == (403, "other-party-needed")


def test_a_studio_requires_a_second_factor_of_who_pays(invoiced: tuple[Agreed, dict[str, Any]], deputy: Client) -> None:
    agreed, invoice = invoiced
    world, path = agreed.world, f"/v1/invoices/{invoice['id']}"
    set_up_totp(world.producer)
    assert require_second_factor(world, "paying").status_code == 200
    body = {"amount_minor": 18_000, "reference": "T", "paid_on": TODAY.isoformat()}
    shipped = {"shipped_on": TODAY.isoformat()}
    assert refused(deputy.post(f"{path}/payments", json=body)) == REQUIRED
    assert refused(deputy.post(f"/v1/contracts/{agreed.contract_id}/shipped", json=shipped)) == REQUIRED
    assert body_of(deputy.get(path))["payments"] == []
    payment = world.producer.post(f"{path}/payments", json=body).json()["payments"][0]
    back = body | {"amount_minor": 1}
    assert refused(deputy.post(f"/v1/payments/{payment['id']}/refunds", json=back)) == REQUIRED
    set_up_totp(deputy)
    assert deputy.post(f"/v1/payments/{payment['id']}/refunds", json=back).status_code == 201


@pytest.mark.slow
def test_who_only_reviews_sees_the_project_and_none_of_its_money(invoiced: tuple[Agreed, dict[str, Any]]) -> None:
    agreed, _ = invoiced
    world, project = agreed.world, f"/v1/projects/{agreed.world.project_id}"
    for path in (f"{project}/money", f"{project}/contracts"):
        assert refused(world.reviewer.get(path)) == (403, "team-needed")
        assert world.approver.get(path).status_code == 200
        assert world.stranger.get(path).status_code == 404
    assert events_of(world, world.reviewer) == []
    assert len(events_of(world, world.approver)) == 2
    (cue,) = body_of(world.producer.get(f"/v1/contracts/{agreed.contract_id}/milestones"))["milestones"][0]["cues"]
    assert world.reviewer.get(f"/v1/cues/{cue['cue']['id']}/money").json() is None
    assert body_of(world.approver.get(f"/v1/cues/{cue['cue']['id']}/money"))["milestone"] == "Alpha"


@pytest.mark.slow
def test_how_late_a_designer_is_the_two_parties_see_alone(invoiced: tuple[Agreed, dict[str, Any]]) -> None:
    world = invoiced[0].world
    for party in (world.producer, world.designer):
        (contract,) = body_of(party.get(f"/v1/projects/{world.project_id}/money"))["contracts"]
        assert [slip["days"] for slip in contract["slips"]] == [4]
    (seen,) = body_of(world.approver.get(f"/v1/projects/{world.project_id}/money"))["contracts"]
    assert (seen["slips"], seen["slip_growth_days"]) == ([], None)
    assert seen["figures"]["due_minor"] == 18_000


@pytest.mark.slow
def test_a_calendar_is_empty_once_its_holder_no_longer_acts_for_the_team(
    invoiced: tuple[Agreed, dict[str, Any]],
) -> None:
    world = invoiced[0].world
    path = calendar_of(world, world.approver)
    assert len(events_at(world, path)) == 2  # the milestone and the invoice
    why = {"person_id": str(world.producer_id), "reason": "The audio director left."}
    assert world.producer.put(f"/v1/projects/{world.project_id}/approver", json=why).is_success
    gone = world.producer.delete(f"/v1/projects/{world.project_id}/liaisons/{world.approver_id}")
    assert gone.is_success, gone.text
    assert events_at(world, path) == []
