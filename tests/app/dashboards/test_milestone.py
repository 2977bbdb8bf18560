"""The page of one milestone: its cues, its lateness, its estimates, and every line of its money."""

from typing import Any

import pytest

from tests.app.money.agreed import TODAY, Agreed, day, deposit, milestone
from tests.app.reviews.making import body_of, refused
from tests.support.server import World


@pytest.fixture
def agreed(world: World) -> Agreed:
    """Return a contract of two milestones: the first is four days late and done, the second is to come."""
    agreed = Agreed(world)
    ping, clamp, oath = (agreed.cue(name) for name in ("radar_ping", "dock_clamp", "vo_oath"))
    first = milestone("Palette", amount_minor=30_000, due_on=day(-4))
    first["cues"] = [{"cue_id": str(cue), "estimate_min": 60} for cue in (ping, clamp)]
    agreed.agree(deposit(10_000), first, milestone("Alpha", oath, amount_minor=50_000, due_on=day(9)))
    agreed.approve(agreed.take(ping))
    agreed.approve(agreed.take(clamp))
    agreed.take(oath)
    return agreed


def sheet(agreed: Agreed, name: str, by: Any = None) -> dict[str, Any]:
    plan = body_of(agreed.world.producer.get(f"/v1/contracts/{agreed.contract_id}/milestones"))["milestones"]
    (found,) = [one for one in plan if one["name"] == name]
    return body_of((by or agreed.world.producer).get(f"/v1/milestones/{found['id']}"))


def test_cues_stand_with_state_and_share(agreed: Agreed) -> None:
    palette, alpha = sheet(agreed, "Palette"), sheet(agreed, "Alpha")
    stands = [(cue["cue"]["name"], cue["status"], cue["amount_minor"], cue["owed_minor"]) for cue in palette["cues"]]
    assert stands == [("radar_ping", "accepted", 15_000, 15_000), ("dock_clamp", "accepted", 15_000, 15_000)]
    (oath,) = alpha["cues"]
    assert (oath["status"], oath["amount_minor"], oath["owed_minor"]) == ("to_review", 50_000, 0)
    assert (palette["contract_title"], palette["currency"], palette["release"]) == ("Effects", "USD", "per_cue")


@pytest.mark.slow
def test_its_lines_and_the_invoices_that_hold_them(agreed: Agreed) -> None:
    invoice = agreed.invoice()
    agreed.pay(invoice, 12_000)
    palette, alpha = sheet(agreed, "Palette"), sheet(agreed, "Alpha")
    assert [(line["kind"], line["amount_minor"]) for line in palette["lines"]] == [
        ("accepted", 15_000), ("accepted", 15_000), ("paid", 2_000),
    ]  # fmt: skip
    assert [(one["number"], one["open_minor"]) for one in palette["invoices"]] == [(1, 28_000)]
    assert palette["lines"][0]["invoice_id"] == invoice["id"]
    assert (alpha["lines"], alpha["invoices"]) == ([], [])


@pytest.mark.slow
def test_lateness_and_estimates_for_the_two_parties(agreed: Agreed) -> None:
    (cue, _) = sheet(agreed, "Palette")["cues"]
    log = {"cue_id": cue["cue"]["id"], "minutes": 90, "worked_on": TODAY.isoformat()}
    assert agreed.world.designer.post(f"/v1/contracts/{agreed.contract_id}/work-logs", json=log).status_code == 204
    for party in (agreed.world.producer, agreed.world.designer):
        palette = sheet(agreed, "Palette", party)
        assert (palette["slip"]["days"], len(palette["slips"])) == (4, 1)
        (estimate,) = [one for one in palette["estimates"]["cues"] if one["about_id"] == cue["cue"]["id"]]
        assert (estimate["estimate"], estimate["so_far"], estimate["error_percent"]) == (60, 90, 50)
        assert sheet(agreed, "Alpha", party)["slip"] is None  # its day is still to come
    seen = sheet(agreed, "Palette", agreed.world.approver)
    assert (seen["slip"], seen["slips"], seen["slip_growth_days"], seen["estimates"]) == (None, [], None, None)
    assert seen["milestone"]["owed_minor"] == 30_000


@pytest.mark.slow
def test_a_question_that_blocks_a_cue_blocks_its_milestone(agreed: Agreed) -> None:
    world = agreed.world
    (oath,) = sheet(agreed, "Alpha")["cues"]
    address = f"/v1/cues/{oath['cue']['id']}/questions"
    assert world.designer.post(address, json={"text": "Which mood?"}).status_code == 201
    body = {"text": "Who speaks?", "blocks": True, "due_on": day(2)}
    blocking = world.designer.post(address, json=body).json()
    owned = world.producer.patch(f"/v1/questions/{blocking['id']}", json={"owner_id": str(world.approver_id)})
    assert owned.status_code == 200, owned.text
    for party in (world.producer, world.designer):
        (waits,) = sheet(agreed, "Alpha", party)["blocked_by"]
        assert (waits["text"], waits["due_on"], waits["owner"]["name"]) == (
            "Who speaks?", day(2), "Audio director",
        )  # fmt: skip
    assert sheet(agreed, "Palette")["blocked_by"] == []
    assert world.approver.post(f"/v1/questions/{blocking['id']}/answer", json={"text": "Mara."}).is_success
    assert sheet(agreed, "Alpha")["blocked_by"] == []


@pytest.mark.slow
def test_a_cut_cue_says_in_which_state(agreed: Agreed) -> None:
    (oath,) = sheet(agreed, "Alpha")["cues"]
    cut = agreed.world.producer.post(f"/v1/cues/{oath['cue']['id']}/cut", json={"reason": "No voices"})
    assert cut.is_success, cut.text
    alpha = sheet(agreed, "Alpha")
    assert (alpha["cues"][0]["status"], alpha["cues"][0]["cut_in"]) == ("cut", "delivered")
    assert alpha["milestone"]["left_minor"] == alpha["milestone"]["owed_minor"] == 37_500


@pytest.mark.slow
def test_out_of_sight_it_is_not_there(agreed: Agreed) -> None:
    address = f"/v1/milestones/{sheet(agreed, 'Palette')['milestone']['id']}"
    for outsider in (agreed.world.stranger, agreed.world.other_designer, agreed.world.reviewer):
        assert refused(outsider.get(address)) == (404, "milestone-not-found")
