"""What one studio may keep on the server: refused in words and numbers, before a byte is stored or a row is written."""

from collections.abc import Callable, Iterator
from typing import Any

import pytest
from sqlalchemy.orm import Session
from typer.testing import CliRunner

from app.accounts.models import Operator, Studio
from app.accounts.quotas.service import DEFAULTS, QuotaKind, set_limit
from app.accounts.rules import Role
from app.cli import accounts, cli
from app.deliveries.uploads import quotas as upload_quotas
from app.operations.quotas import PAGE_STUDIOS
from tests.app.deliveries.test_source_banks import SESSION, give
from tests.support.deliver import TUS, add_cues, deliver, metadata, open_delivery, upload
from tests.support.references import begin_upload
from tests.support.server import World

SOUND = b"no sound, but bytes"


@pytest.fixture(autouse=True)
def _counted_again(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.setattr(upload_quotas, "COUNTED_EVERY_S", -1.0)
    yield
    upload_quotas._counted.clear()


def limit(world: World, kind: QuotaKind, most: int | None) -> None:
    world.server.in_database(lambda session: set_limit(session, world.studio_id, kind, most))


def send(world: World) -> Any:
    query = {"delivery_id": open_delivery(world), "file_name": "a.wav"}
    return world.designer.put("/v1/uploads", params=query, content=SOUND)


def begin(world: World) -> Any:
    said = metadata(delivery_id=open_delivery(world), filename="a.wav", file_name="a.wav")
    headers = {**TUS, "Upload-Length": "10", "Upload-Metadata": said}
    return world.designer.post("/v1/uploads", headers=headers)


def send_reference(world: World) -> Any:
    return begin_upload(world, "a.png", SOUND)


def add_cue(world: World) -> Any:
    return world.producer.post(f"/v1/projects/{world.project_id}/cues", json={"cues": [{"name": "Door"}]})


def create_project(world: World) -> Any:
    body = {"studio_id": str(world.studio_id), "name": "Next", "cue_prefix": "NX"}
    return world.producer.post("/v1/projects", json=body)


def invite(world: World) -> Any:
    body = {"email": "new@example.test", "roles": [Role.REVIEWER.value]}
    return world.producer.post(f"/v1/studios/{world.studio_id}/invitations", json=body)


def token(world: World) -> Any:
    body = {"name": "CI", "scopes": ["spec:read"]}
    return world.producer.post(f"/v1/projects/{world.project_id}/tokens", json=body)


ACTS: list[tuple[QuotaKind, Callable[[World], Any], int, int]] = [
    (QuotaKind.MASTER_BYTES, send, len(SOUND) - 1, 507),
    (QuotaKind.OPEN_UPLOADS, begin, 0, 409),
    (QuotaKind.REFERENCE_BYTES, send_reference, len(SOUND) - 1, 507),
    (QuotaKind.CUES, add_cue, 0, 409),
    (QuotaKind.PROJECTS, create_project, 1, 409),
    (QuotaKind.PEOPLE, invite, 3, 409),
    (QuotaKind.TOKENS, token, 0, 409),
]


@pytest.mark.parametrize(("kind", "act", "most", "status"), ACTS, ids=[kind.value for kind, *_ in ACTS])
def test_what_is_over_a_limit_is_refused_in_numbers(
    world: World, kind: QuotaKind, act: Callable[[World], Any], most: int, status: int
) -> None:
    limit(world, kind, most)
    refused = act(world)
    assert (refused.status_code, f"may have {most:,}" in refused.json()["detail"]) == (status, True), refused.text
    limit(world, kind, None)
    granted = act(world)
    assert granted.status_code in (200, 201), granted.text


def test_what_is_finished_is_never_refused(world: World) -> None:
    delivery_id = open_delivery(world)
    upload_id = upload(world, delivery_id, "a.wav", SOUND)
    limit(world, QuotaKind.MASTER_BYTES, 0)
    body = {"upload_id": upload_id, "file_name": "a.wav"}
    assert world.designer.post(f"/v1/deliveries/{delivery_id}/takes", json=body).status_code == 201
    assert send(world).status_code == 507


def test_source_files_count_with_the_masters(world: World) -> None:
    add_cues(world, {"name": "Door"})
    take = deliver(world, "a.wav", SOUND)
    give(world, take["id"], SESSION)
    assert give(world, take["id"], SOUND, "a.wav")["file_name"] == "a.wav"
    shown = world.producer.get(f"/v1/studios/{world.studio_id}/quotas").json()
    used = next(quota["used"] for quota in shown if quota["kind"] == "master_bytes")
    assert used == len(SOUND) + len(SESSION), "the same bytes count once"
    limit(world, QuotaKind.MASTER_BYTES, len(SOUND) + len(SESSION))
    assert send(world).status_code == 507


@pytest.mark.slow
def test_the_producer_sees_use_and_limit(world: World) -> None:
    add_cues(world, {"name": "Door"}, {"name": "Gate"})
    deliver(world, "a.wav", SOUND)
    limit(world, QuotaKind.CUES, 7)
    url = f"/v1/studios/{world.studio_id}/quotas"
    shown = {one["kind"]: (one["used"], one["limit"]) for one in world.producer.get(url).json()}
    assert shown == {
        "master_bytes": (len(SOUND), DEFAULTS[QuotaKind.MASTER_BYTES]),
        "cues": (2, 7),
        "projects": (1, DEFAULTS[QuotaKind.PROJECTS]),
        "people": (3, DEFAULTS[QuotaKind.PEOPLE]),
        "tokens": (0, DEFAULTS[QuotaKind.TOKENS]),
        "open_uploads": (0, DEFAULTS[QuotaKind.OPEN_UPLOADS]),
        "reference_bytes": (0, DEFAULTS[QuotaKind.REFERENCE_BYTES]),
        "reel_bytes": (0, DEFAULTS[QuotaKind.REEL_BYTES]),
    }
    assert (world.reviewer.get(url).status_code, world.stranger.get(url).status_code) == (403, 404)


@pytest.mark.slow
def test_the_operator_sees_who_is_near(world: World) -> None:
    add_cues(world, {"name": "Door"}, {"name": "Gate"})
    limit(world, QuotaKind.CUES, 2)
    operator = world.signed_in(world.approver_id)
    assert operator.get("/v1/operations/quotas").status_code == 403
    world.server.in_database(lambda session: session.add(Operator(person_id=world.approver_id)))
    with world.server.counted_selects() as selects:
        page = operator.get("/v1/operations/quotas").json()
    assert len(selects) <= 20, "however many studios there are"
    shown = page["items"]
    while page["next"]:
        page = operator.get("/v1/operations/quotas", params={"cursor": page["next"]}).json()
        shown += page["items"]
    assert len({studio["studio_id"] for studio in shown}) == len(shown)
    (own,) = [studio for studio in shown if studio["studio_id"] == str(world.studio_id)]
    assert own["quotas"][0] == {"kind": "cues", "used": 2, "limit": 2, "default": DEFAULTS[QuotaKind.CUES]}
    assert {one["kind"] for one in own["quotas"]} == set(QuotaKind)
    nearest = [one["used"] / one["limit"] if one["limit"] else 1e9 for one in (studio["quotas"][0] for studio in shown)]
    assert nearest == sorted(nearest, reverse=True)
    assert len(shown) > 1, "studios of which the operator is not a member"


def test_one_page_of_the_operator_costs_no_more_for_many_studios(world: World) -> None:
    def add_studios(session: Session) -> None:
        studios = [Studio(name=f"Studio {number:03}") for number in range(2 * PAGE_STUDIOS)]
        session.add_all(studios)
        session.flush()
        for studio in studios[:-1]:
            set_limit(session, studio.id, QuotaKind.PEOPLE, 0)  # no one may join: the nearest to a limit

    world.server.in_database(add_studios)
    operator = world.signed_in(world.approver_id)
    world.server.in_database(lambda session: session.add(Operator(person_id=world.approver_id)))
    with world.server.counted_selects() as selects:
        page = operator.get("/v1/operations/quotas").json()
    assert (len(page["items"]), len(selects) <= 20) == (PAGE_STUDIOS, True)
    assert page["items"][0]["quotas"][0]["kind"] == "people"
    following = operator.get("/v1/operations/quotas", params={"cursor": page["next"]}).json()["items"]
    assert not {studio["studio_id"] for studio in following} & {studio["studio_id"] for studio in page["items"]}
    assert operator.get("/v1/operations/quotas", params={"cursor": "second"}).json()["code"] == "bad-cursor"


@pytest.mark.slow
def test_uploads_leave_the_reserve_of_the_disk_and_the_database_goes_on(
    world: World, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(world.server.runtime.settings, "disk_reserve", 1 << 60)
    refused = send(world)
    assert (refused.status_code, refused.json()["code"]) == (507, "store-full")
    assert "are kept for the database" in refused.json()["detail"]
    assert add_cue(world).status_code == 201
    monkeypatch.setattr(world.server.runtime.settings, "disk_reserve", 0)
    assert send(world).status_code == 201


def test_the_command_says_and_sets(world: World, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(accounts, "read_settings_or_exit", lambda: world.server.runtime.settings)
    monkeypatch.setattr(accounts, "opened", lambda _: world.server.runtime)
    monkeypatch.setattr(type(world.server.runtime), "close", lambda _: None)
    said = CliRunner().invoke(cli, ["quota", str(world.studio_id), "--set", "cues=7"])
    assert said.exit_code == 0, said.output
    (cues,) = [line for line in said.output.splitlines() if " cues " in line]
    assert [word for word in cues.split() if word.isdigit()] == ["0", "7"]
    wrong = CliRunner().invoke(cli, ["quota", str(world.studio_id), "--set", "sounds=many"])
    assert wrong.exit_code == 2
