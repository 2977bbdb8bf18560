"""The mailed link shows the list at once, to anyone who has it."""

import pytest

from tests.app.sound_lists.lists import add, cut
from tests.support.links import secret_for
from tests.support.server import World


@pytest.mark.slow
def test_the_link_shows_project_list_and_spec_without_an_account(world: World) -> None:
    _, gone = add(world, {"name": "Laser fire", "variations": 4, "category": "weapon"}, {"name": "Mine arm"})
    cut(world, gone["id"], "mines are gone")
    address = f"guest-{world.project_id}@example.test"
    invited = world.producer.post(
        f"/v1/projects/{world.project_id}/invitations",
        json={"email": address, "kind": "contract", "note": "Twelve weapons by May."},
    )
    assert invited.status_code == 201, invited.text
    shown = world.nobody.get(f"/v1/invitations/{secret_for(world.server, address)}")
    assert shown.status_code == 200, shown.text
    reported = shown.json()
    assert reported["project"]["name"] == "Shield Wing"
    assert (reported["studio_name"], reported["invited_by_name"], reported["kind"]) == (
        "Test studio",
        "Producer",
        "contract",
    )
    assert (reported["email"], reported["has_account"], reported["accepted"]) == (address, False, False)
    assert [(cue["label"], cue["variations"]) for cue in reported["cues"]] == [("SW-001", 4)]
    assert reported["spec"]["accept"]["sample_rates_hz"] == [44100, 48000, 96000]
    assert reported["spec"]["targets"]["game"]["sample_rate_hz"] == 44100


def test_a_link_that_we_never_mailed_shows_nothing(world: World) -> None:
    answer = world.nobody.get("/v1/invitations/not-a-secret-of-ours")
    assert answer.status_code == 404
    assert answer.json()["code"] == "invitation-not-found"
