"""Where a project asks for an NDA, brief, list and spec open with the designer's yes to it."""

from typing import Any

import pytest
from httpx2 import Client
from sqlalchemy import select

from app.projects.models import Engagement
from tests.app.agreements.conftest import Contracts
from tests.app.sound_lists.lists import add
from tests.support.links import secret_for
from tests.support.server import World

CLOSED = (
    "sound-list",
    "sound-list.csv",
    "sound-list/progress",
    "spec",
    "spec.toml",
    "questions",
    "desk",
    "takes",
    "deliveries",
    "overview",
    "find?q=radar",
)


def request_nda(world: World) -> None:
    answer = world.producer.patch(f"/v1/projects/{world.project_id}", json={"nda_needed": True})
    assert answer.json()["nda_needed"] is True


def listed_open(caller: Client) -> bool:
    (project,) = caller.get("/v1/me").json()["projects"]
    return bool(project["nda_open"])


@pytest.mark.slow
def test_what_is_closed_opens_with_the_nda(world: World, contracts: Contracts):
    (cue,) = add(world, {"name": "Radar ping"})
    request_nda(world)
    closed = [f"/v1/projects/{world.project_id}/{path}" for path in CLOSED] + [f"/v1/cues/{cue['id']}"]
    for path in closed:
        refused = world.designer.get(path)
        assert (refused.status_code, refused.json()["code"]) == (403, "nda-needed"), path
        assert "nda-needed" not in world.reviewer.get(path).text, path
    delivered = world.designer.post(f"/v1/projects/{world.project_id}/deliveries", json={"note": ""})
    assert delivered.json()["code"] == "nda-needed"
    headed = world.designer.get(f"/v1/projects/{world.project_id}").json()
    assert headed["mine"]["nda_open"] is True
    assert [listed_open(each) for each in (world.designer, world.producer)] == [True, False]
    nda = contracts.begin("nda", title="NDA")
    agreed = contracts.agree(nda)
    assert world.designer.get(f"/v1/projects/{world.project_id}").json()["mine"]["nda_open"] is False
    assert listed_open(world.designer) is False
    for path in closed:
        assert world.designer.get(path).status_code == 200, path

    def kept(session: Any) -> Engagement:
        return session.scalars(select(Engagement).where(Engagement.project_id == world.project_id)).one()

    engagement = world.server.in_database(kept)
    assert engagement.nda_sha256 == agreed["version"]["pdf_sha256"]
    assert engagement.nda_accepted_at is not None


def test_half_an_nda_opens_nothing(world: World, contracts: Contracts):
    request_nda(world)
    sent = contracts.send(contracts.begin("nda", title="NDA"))
    contracts.accept(sent, world.producer, "P. Producer")
    assert world.designer.get(f"/v1/projects/{world.project_id}/sound-list").status_code == 403
    contracts.accept(sent, world.designer, "N. Designer")
    assert world.designer.get(f"/v1/projects/{world.project_id}/sound-list").status_code == 200


@pytest.mark.slow
def test_a_link_shows_no_list_before_the_nda(world: World):
    add(world, {"name": "Radar ping"})
    request_nda(world)
    body = {"email": "someone.new@example.test", "kind": "contract"}
    assert world.producer.post(f"/v1/projects/{world.project_id}/invitations", json=body).status_code == 201
    shown = world.nobody.get(f"/v1/invitations/{secret_for(world.server, body['email'])}").json()
    assert (shown["nda_needed"], shown["cues"], shown["spec"]) == (True, [], None)


@pytest.mark.slow
def test_mails_name_no_cue_before_the_nda(world: World, contracts: Contracts):
    request_nda(world)
    (cue,) = add(world, {"name": "Radar ping"})
    assert world.producer.post(f"/v1/cues/{cue['id']}/cut", json={"reason": "Not needed."}).status_code == 200
    world.server.wait_for_jobs()
    mails = contracts.ask(world.producer, "GET", f"/studios/{world.studio_id}/outbox")["mails"]
    assert mails == []
