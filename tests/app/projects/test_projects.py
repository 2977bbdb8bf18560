from uuid import uuid4

import pytest
import sqlalchemy as sa
from httpx import Response

from app.accounts.queries import actor_for_person
from app.projects.service import create_project
from tests.support.links import secret_for
from tests.support.server import RunningServer, World

PASSWORD = "four-unrelated-words"


def address() -> str:
    return f"{uuid4().hex}@example.test"


def project_path(world: World, rest: str = "") -> str:
    return f"/v1/projects/{world.project_id}{rest}"


def add_project(world: World, **changes: object) -> Response:
    body = {"studio_id": str(world.studio_id), "name": "Deep Station", "cue_prefix": "DS"} | changes
    return world.producer.post("/v1/projects", json=body)


def test_a_project_opens_with_a_spec_and_an_approver(world: World) -> None:
    project = add_project(world, description="A station under the ice.", preset="48k").json()
    assert (project["name"], project["cue_prefix"], project["spec_version"]) == ("Deep Station", "DS", 1)
    assert project["studio"] == {"id": str(world.studio_id), "name": "Test studio"}
    assert project["approver"]["name"] == "Producer"  # the person who opened it, until another is named
    assert project["mine"] == {
        "is_team": True,
        "is_producer": True,
        "is_liaison": False,
        "is_approver": True,
        "engagement_kind": None,
        "nda_open": False,
    }
    spec = world.producer.get(f"/v1/projects/{project['id']}/spec").json()
    assert spec["resolved"]["accept"]["sample_rates_hz"] == [48_000, 96_000]
    assert list(spec["resolved"]["targets"]) == ["game"]


@pytest.mark.parametrize(
    ("field", "value"),
    [
        ("name", ""),
        ("name", "Two\nlines"),
        ("cue_prefix", "sw"),
        ("cue_prefix", "TOOLONGPREFIX"),
        ("cue_prefix", "1A"),
        ("preset", "8k"),
        ("studio_id", "no id"),
        ("description", "x" * 5_001),
    ],
)
def test_what_is_wrong_with_a_project_is_reported_at_its_field(world: World, field: str, value: str) -> None:
    problem = add_project(world, **{field: value}).json()
    assert (problem["status"], problem["errors"][0]["where"]) == (422, field)


def test_only_producers_of_the_studio_open_projects(world: World) -> None:
    body = {"studio_id": str(world.studio_id), "name": "Deep Station", "cue_prefix": "DS"}
    assert world.reviewer.post("/v1/projects", json=body).json()["code"] == "producer-needed"
    assert world.stranger.post("/v1/projects", json=body).json()["code"] == "studio-not-found"
    assert world.nobody.post("/v1/projects", json=body).status_code == 401


def test_the_designer_sees_the_project_and_no_other_designer(world: World) -> None:
    project = world.designer.get(project_path(world)).json()
    assert project["mine"]["engagement_kind"] == "contract"
    assert project["mine"]["is_team"] is False
    assert [engagement["designer"]["name"] for engagement in project["engagements"]] == ["Sound designer"]
    world.server.in_database(lambda session: engage(session, world, world.other_designer_id))
    assert len(world.producer.get(project_path(world)).json()["engagements"]) == 2
    assert len(world.designer.get(project_path(world)).json()["engagements"]) == 1


def engage(session: sa.orm.Session, world: World, person_id: object) -> None:
    from app.projects.models import Engagement
    from app.projects.rules import EngagementKind

    session.add(
        Engagement(
            studio_id=world.studio_id,
            project_id=world.project_id,
            designer_id=person_id,
            kind=EngagementKind.ADVISORY,
        )
    )


@pytest.mark.slow
def test_those_without_sight_learn_nothing(world: World) -> None:
    for browser in (world.stranger, world.other_designer):
        answer = browser.get(project_path(world))
        missing = browser.get(f"/v1/projects/{uuid4()}")
        assert answer.status_code == missing.status_code == 404
        assert answer.json()["code"] == missing.json()["code"] == "project-not-found"
        assert browser.get("/v1/projects").json() == {"items": [], "next": None}
    assert world.nobody.get(project_path(world)).status_code == 401


@pytest.mark.slow
def test_the_list_is_paged_and_leaves_out_archived_projects(server: RunningServer, world: World) -> None:
    with server.runtime.database.writing() as session:
        actor = actor_for_person(session, world.producer_id)
        for number in range(60):
            create_project(session, actor, world.studio_id, name=f"Project {number}", cue_prefix="P")
    first = world.producer.get("/v1/projects").json()
    second = world.producer.get("/v1/projects", params={"cursor": first["next"]}).json()
    names = [project["name"] for project in first["items"] + second["items"]]
    assert names == [f"Project {number}" for number in reversed(range(60))] + ["Shield Wing"]
    assert second["next"] is None
    assert world.producer.get("/v1/projects", params={"cursor": "nonsense"}).json()["code"] == "bad-cursor"
    assert world.producer.patch(project_path(world), json={"archived": True}).json()["archived_at"] is not None
    assert (
        world.producer.get("/v1/projects", params={"cursor": first["next"]}).json()["items"][-1]["name"] == "Project 0"
    )
    away = world.producer.get("/v1/projects", params={"archived": "true"}).json()["items"]
    assert [project["name"] for project in away] == ["Shield Wing"]
    assert world.producer.patch(project_path(world), json={"archived": False}).json()["archived_at"] is None


def test_the_list_takes_as_many_selects_for_many_projects_as_for_one(server: RunningServer, world: World) -> None:
    with server.counted_selects() as for_one:
        world.producer.get("/v1/projects")
    with server.runtime.database.writing() as session:
        actor = actor_for_person(session, world.producer_id)
        for number in range(5):
            create_project(session, actor, world.studio_id, name=f"Project {number}", cue_prefix="P")
    with server.counted_selects() as for_six:
        assert len(world.producer.get("/v1/projects").json()["items"]) == 6
    assert 0 < len(for_six) == len(for_one)


def test_changing_a_project_is_the_producers(world: World) -> None:
    changed = world.producer.patch(project_path(world), json={"name": "Shield Wing II", "cue_prefix": "SW2"}).json()
    assert (changed["name"], changed["cue_prefix"], changed["description"]) == ("Shield Wing II", "SW2", "")
    assert world.approver.patch(project_path(world), json={"name": "X"}).json()["code"] == "producer-needed"
    assert world.designer.patch(project_path(world), json={"name": "X"}).status_code == 403
    assert world.stranger.patch(project_path(world), json={"name": "X"}).status_code == 404
    assert world.producer.patch(project_path(world), json={"studio_id": str(uuid4())}).status_code == 422


def test_more_than_two_audio_leads_are_accepted_with_a_warning(world: World) -> None:
    for person_id, warning in ((world.reviewer_id, None), (world.producer_id, "3 audio leads speak for the team")):
        answer = world.producer.put(project_path(world, f"/liaisons/{person_id}"))
        assert answer.status_code == 200, answer.text
        said = answer.json()["audio_leads_warning"]
        assert said is None if warning is None else said.startswith(warning)
    assert world.reviewer.get(project_path(world)).json()["audio_leads_warning"] == said
    assert world.designer.get(project_path(world)).json()["audio_leads_warning"] is None


def test_liaisons_come_from_the_studio(world: World) -> None:
    path = project_path(world, f"/liaisons/{world.reviewer_id}")
    for _ in range(2):  # naming twice is naming once
        project = world.producer.put(path).json()
        assert [person["name"] for person in project["liaisons"]] == ["Audio director", "Composer"]
    outsider = project_path(world, f"/liaisons/{world.designer_id}")
    assert world.producer.put(outsider).json()["code"] == "liaison-not-found"
    assert world.approver.put(path).status_code == 403
    assert [person["name"] for person in world.producer.delete(path).json()["liaisons"]] == ["Audio director"]
    assert world.producer.delete(path).status_code == 404


def test_a_liaison_becomes_the_approver_or_a_producer_takes_over(world: World) -> None:
    path = project_path(world, "/approver")
    reviewer = {"person_id": str(world.reviewer_id), "reason": "Knows the music."}
    assert world.producer.put(path, json=reviewer).json()["code"] == "cannot-approve"
    world.producer.put(project_path(world, f"/liaisons/{world.reviewer_id}"))
    assert world.producer.put(path, json=reviewer).json()["approver"]["name"] == "Composer"
    assert world.reviewer.get(project_path(world)).json()["mine"]["is_approver"] is True
    assert world.approver.get(project_path(world)).json()["mine"]["is_approver"] is False
    producer = {"person_id": str(world.producer_id), "reason": "The composer is away."}
    assert world.producer.put(path, json=producer).json()["approver"]["name"] == "Producer"
    history = world.reviewer.get(project_path(world, "/approver-history")).json()
    assert [(change["person"]["name"], change["reason"], change["changer"]["name"]) for change in history] == [
        ("Producer", "The composer is away.", "Producer"),
        ("Composer", "Knows the music.", "Producer"),
        ("Audio director", "named when the project opened", "Producer"),
    ]


def test_a_member_is_the_approver_in_one_step(world: World) -> None:
    path = project_path(world, "/approver-invitations")
    email = world.reviewer.get("/v1/me").json()["email"]
    answer = world.producer.post(path, json={"email": email.upper()})
    assert (answer.status_code, answer.json()["is_named"]) == (201, True)
    project = world.producer.get(project_path(world)).json()
    assert project["approver"]["name"] == "Composer"
    assert "Composer" in [person["name"] for person in project["liaisons"]]
    for client in (world.approver, world.reviewer):
        assert client.post(path, json={"email": email}).json()["code"] == "producer-needed"
    assert world.stranger.post(path, json={"email": email}).status_code == 404
    assert world.producer.post(path, json={"email": "no address"}).status_code == 422


@pytest.mark.slow
def test_an_invited_approver_is_named_on_joining(world: World, server: RunningServer) -> None:
    email = address()
    invited = world.producer.post(project_path(world, "/approver-invitations"), json={"email": email})
    assert (invited.status_code, invited.json()) == (201, {"email": email, "is_named": False})
    (waiting,) = world.producer.get(f"/v1/studios/{world.studio_id}/invitations").json()
    assert (waiting["email"], waiting["approves_project_id"]) == (email, str(world.project_id))
    assert world.producer.get(project_path(world)).json()["approver"]["name"] != "Ana"
    body = {"name": "Ana", "password": PASSWORD}
    path = f"/v1/studio-invitations/{secret_for(server, email)}/accept"
    assert server.browser().post(path, json=body).status_code == 200
    server.wait_for_jobs()
    project = world.producer.get(project_path(world)).json()
    assert (project["approver"]["name"], "Ana" in [one["name"] for one in project["liaisons"]]) == ("Ana", True)
    history = world.producer.get(project_path(world, "/approver-history")).json()
    assert (history[0]["reason"], history[0]["changer"]["name"]) == ("invited as the approver", "Producer")


def test_nobody_becomes_the_approver_without_right_or_reason(world: World) -> None:
    path = project_path(world, "/approver")
    body = {"person_id": str(world.approver_id), "reason": "Because."}
    assert world.approver.put(path, json=body).json()["code"] == "producer-needed"
    assert world.designer.put(path, json=body).status_code == 403
    assert world.producer.put(path, json=body | {"reason": "  "}).json()["errors"][0]["where"] == "reason"
    for outsider in (world.designer_id, world.stranger_id, uuid4()):
        answer = world.producer.put(path, json=body | {"person_id": str(outsider)})
        assert (answer.status_code, answer.json()["code"]) == (422, "cannot-approve")
    assert world.designer.get(project_path(world, "/approver-history")).json()["code"] == "team-needed"


def test_who_decides_stays_a_liaison(world: World) -> None:
    path = project_path(world, f"/liaisons/{world.approver_id}")
    assert world.producer.delete(path).json()["code"] == "liaison-is-approver"


def test_who_left_the_studio_no_longer_acts_for_it(world: World) -> None:
    body = {"person_id": str(world.producer_id), "reason": "The audio director leaves."}
    assert world.producer.put(project_path(world, "/approver"), json=body).json()["approver"]["name"] == "Producer"
    assert world.producer.delete(f"/v1/studios/{world.studio_id}/people/{world.approver_id}").status_code == 204
    assert world.producer.get(project_path(world)).json()["liaisons"] == []
    assert world.approver.get(project_path(world)).status_code == 404
