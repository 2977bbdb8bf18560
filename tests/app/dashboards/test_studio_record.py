"""The record of a studio as bidders see it: figures from three cases on, and nothing to strangers."""

import pytest

from tests.app.hiring.test_postings import join, opened
from tests.app.money.agreed import Agreed, day, milestone
from tests.support.server import World


@pytest.mark.slow
@pytest.mark.both_databases
def test_bidders_see_how_the_studio_answers_and_pays(world: World) -> None:
    agreed = Agreed(world, terms={"bonus_minor": 5_000, "bonus_when": "on_time"})
    cues = [agreed.cue(f"cue_{number}") for number in range(3)]
    posting = opened(world)
    address = f"/v1/postings/{posting['id']}/studio-record"
    assert world.other_designer.get(address).status_code == 404
    join(world, posting, world.other_designer)
    empty = world.other_designer.get(address).json()
    assert {empty[name] for name in ("review_hours", "answer_hours", "days_to_pay", "rounds_per_cue")} == {None}
    agreed.agree(milestone("Alpha", *cues, amount_minor=30_000, due_on=day(9)))
    for cue in cues:
        asked = world.designer.post(f"/v1/cues/{cue}/questions", json={"text": "When?"}).json()
        world.producer.post(f"/v1/questions/{asked['id']}/answer", json={"text": "Now."})
        agreed.approve(agreed.take(cue))
        invoice = agreed.invoice()
        agreed.pay(invoice, invoice["open_minor"])
    record = world.other_designer.get(address).json()
    assert record["answer_hours"] == pytest.approx(0, abs=0.1)
    assert (record["days_to_pay"], record["rounds_per_cue"]) == (0, 0)
    assert (record["bonuses_promised"], record["bonuses_earned"]) == (1, 1)
    assert world.producer.get(address).json() == record
    assert world.stranger.get(address).status_code == 404
