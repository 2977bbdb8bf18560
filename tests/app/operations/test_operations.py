"""Who sees which jobs and what is kept, and that a failed job runs again on request."""

import threading
from collections.abc import Callable
from typing import Any
from uuid import UUID, uuid4

import pytest
from httpx import Response
from httpx2 import Client

from app.accounts.models import Operator
from app.builds.models import PackedFile, PlaceholderFile, SealedPack
from app.builds.rules import FileKind
from app.conformance.models import Fix
from app.conformance.rules import FixState
from app.core.jobs import queue
from app.core.runtime import Runtime
from app.references.models import Reference, ReferenceVersion
from app.references.rules import PreviewState, ReferenceKind
from app.renders.models import MasterExport, Picture, Reel, Render
from app.renders.rules import RenderState
from tests.app.core.test_queue import until
from tests.app.reviews.making import Stage
from tests.support.server import World

broken = {"is": True}
ran: list[str] = []
steps: dict[str, threading.Event] = {}
A_DAY_S = 86_400.0


@queue.job("operations_tests.work")
def work(_runtime: Runtime, payload: queue.Payload) -> None:
    if broken["is"]:
        raise OSError(f"/srv/soundlist/{payload['word']} is full")
    ran.append(payload["word"])


@queue.job("operations_tests.hold")
def hold(_runtime: Runtime, _payload: queue.Payload) -> None:
    steps["held"].set()
    assert steps["let_go"].wait(20), "nobody let go of this job within 20 s"


@pytest.fixture(autouse=True)
def _no_second_tries(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(queue, "RETRY_DELAYS_S", ())
    broken["is"] = True
    ran.clear()


@pytest.fixture
def operator(world: World) -> Client:
    """The browser of an operator who is a member of no studio."""
    world.server.in_database(lambda session: session.add(Operator(person_id=world.other_designer_id)))
    return world.other_designer


def enqueue(
    world: World,
    *,
    studio_id: UUID | None,
    delay_s: float = 0,
    priority: int = queue.NORMAL,
    job: str = "operations_tests.work",
) -> str:
    key = str(uuid4())
    runtime = world.server.runtime
    with runtime.database.writing() as session:
        runtime.queue.enqueue(
            session, job, {"word": key}, key=key, studio_id=studio_id, delay_s=delay_s, priority=priority
        )
    return key


def parked(world: World, *, studio_id: UUID | None) -> str:
    key = enqueue(world, studio_id=studio_id)
    until(lambda: (job := world.server.runtime.queue.unfinished_job(key)) and job.state == "parked")
    return key


def body_of(answer: Response) -> dict[str, Any]:
    assert answer.status_code == 200, answer.text
    return dict(answer.json())


def of_studio(world: World, what: str = "operations") -> str:
    return f"/v1/studios/{world.studio_id}/{what}"


@pytest.mark.slow
def test_a_producer_sees_what_gave_up_and_lets_it_run_again(world: World) -> None:
    key = parked(world, studio_id=world.studio_id)
    (job,) = body_of(world.producer.get(of_studio(world, "jobs"), params={"state": "parked"}))["items"]
    assert (job["id"], job["job"], job["studio_name"]) == (key, "operations_tests.work", "Test studio")
    assert job["reason"] == "OSError"  # the rest may name what is not the studio's
    assert job["tries"] == 1
    (count,) = body_of(world.producer.get(of_studio(world)))["counts"]
    assert (count["job"], count["state"], count["jobs"]) == ("operations_tests.work", "parked", 1)
    broken["is"] = False
    assert body_of(world.producer.post(of_studio(world, f"jobs/{key}/retry")))["state"] == "waiting"
    until(lambda: key in ran)
    until(lambda: not body_of(world.producer.get(of_studio(world, "jobs")))["items"])
    assert body_of(world.producer.get(of_studio(world)))["counts"] == []


@pytest.mark.slow
def test_nobody_sees_or_moves_another_studios_jobs(world: World) -> None:
    key = parked(world, studio_id=world.studio_id)
    own = next(iter(body_of(world.stranger.get("/v1/me"))["studios"]))["id"]
    assert body_of(world.stranger.get(f"/v1/studios/{own}/jobs"))["items"] == []
    assert body_of(world.stranger.get(f"/v1/studios/{own}/operations"))["counts"] == []
    answer = world.stranger.post(f"/v1/studios/{own}/jobs/{key}/retry")
    assert (answer.status_code, answer.json()["code"]) == (404, "job-not-found")
    broken["is"] = False
    assert body_of(world.producer.post(of_studio(world, f"jobs/{key}/retry")))


def test_work_for_no_person_is_the_operators_alone(world: World, operator: Client) -> None:
    key = parked(world, studio_id=None)
    assert world.producer.post(of_studio(world, f"jobs/{key}/retry")).status_code == 404
    broken["is"] = False
    job = body_of(operator.post(f"/v1/operations/jobs/{key}/retry"))
    assert (job["studio_id"], job["studio_name"]) == (None, None)
    until(lambda: key in ran)


def test_an_operator_sees_every_studios_jobs_with_the_whole_reason(world: World, operator: Client) -> None:
    key = parked(world, studio_id=world.studio_id)
    jobs: list[dict[str, Any]] = []
    page: dict[str, Any] = {"next": ""}
    while page["next"] is not None:
        asked = {"state": "parked", **({"cursor": page["next"]} if page["next"] else {})}
        page = body_of(operator.get("/v1/operations/jobs", params=asked))
        jobs += page["items"]
    (job,) = [each for each in jobs if each["id"] == key]
    assert (job["studio_name"], job["reason"]) == ("Test studio", f"OSError: /srv/soundlist/{key} is full")
    server = body_of(operator.get("/v1/operations"))
    assert [each["is_alive"] for each in server["workers"] if each["id"] == world.server.worker.id] == [True]
    assert any(each["job"] == "operations_tests.work" and each["state"] == "parked" for each in server["counts"])
    broken["is"] = False
    body_of(operator.post(f"/v1/operations/jobs/{key}/retry"))


@pytest.mark.slow
def test_those_who_do_not_run_the_server_are_refused(world: World, operator: Client) -> None:
    key = enqueue(world, studio_id=world.studio_id, delay_s=A_DAY_S)
    for who in (world.producer, world.approver, world.designer, world.stranger):
        for answer in (
            who.get("/v1/operations"),
            who.get("/v1/operations/storage"),
            who.get("/v1/operations/jobs"),
            who.post(f"/v1/operations/jobs/{key}/retry"),
        ):
            assert (answer.status_code, answer.json()["code"]) == (403, "operator-needed")
    assert body_of(operator.get("/v1/me"))["is_operator"] is True
    assert body_of(world.producer.get("/v1/me"))["is_operator"] is False


def test_without_operators_nobody_is_one(world: World) -> None:
    answer = world.producer.get("/v1/operations")
    assert answer.status_code == 403
    assert "soundlist operators add ADDRESS" in answer.json()["fix"]


@pytest.mark.parametrize(
    ("who", "status"), [("approver", 403), ("reviewer", 403), ("designer", 404), ("stranger", 404)]
)
def test_only_a_producer_sees_a_studios_operations(world: World, who: str, status: int) -> None:
    client: Client = getattr(world, who)
    for path in ("operations", "storage", "jobs"):
        assert client.get(of_studio(world, path)).status_code == status
    assert client.post(of_studio(world, "jobs/any/retry")).status_code == status


def test_lanes_say_whose_work_waits_and_how_soon_it_is_wanted(
    world: World, operator: Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("app.operations.service.LANES_SHOWN", 10_000)  # other tests leave lanes behind
    for priority, times in ((queue.URGENT, 1), (queue.BULK, 3)):
        for _ in range(times):
            enqueue(world, studio_id=world.studio_id, delay_s=A_DAY_S, priority=priority)
    enqueue(world, studio_id=None, delay_s=A_DAY_S)
    lanes = body_of(world.producer.get(of_studio(world)))["lanes"]
    assert [(each["urgency"], each["delayed"], each["waiting"], each["running"]) for each in lanes] == [
        ("bulk", 3, 0, 0),
        ("urgent", 1, 0, 0),
    ]
    assert {each["studio_name"] for each in lanes} == {"Test studio"}
    server = body_of(operator.get("/v1/operations"))["lanes"]
    assert [each for each in server if each["studio_id"] == str(world.studio_id)] == lanes
    assert any(each["studio_id"] is None and each["delayed"] for each in server)


@pytest.mark.slow
def test_a_lane_says_what_runs_and_since_when_the_rest_waits(world: World, operator: Client) -> None:
    held, let_go = threading.Event(), threading.Event()
    steps["held"], steps["let_go"] = held, let_go
    at_once = world.server.runtime.settings.worker_jobs
    try:
        for _ in range(at_once + 2):  # more than this worker runs at once
            enqueue(world, studio_id=world.studio_id, job="operations_tests.hold")
        assert held.wait(10), "no job was begun within 10 s"
        until(lambda: body_of(world.producer.get(of_studio(world)))["lanes"][0]["running"] == at_once)
        (lane,) = body_of(world.producer.get(of_studio(world)))["lanes"]
        assert (lane["urgency"], lane["waiting"], lane["running"]) == ("normal", 2, at_once)
        assert lane["oldest_at"] is not None
        (worker,) = [
            each for each in body_of(operator.get("/v1/operations"))["workers"] if each["id"] == world.server.worker.id
        ]
        assert worker["running"] == at_once
        (one, *_) = body_of(world.producer.get(of_studio(world, "jobs"), params={"state": "running"}))["items"]
        assert body_of(world.producer.get(of_studio(world, "jobs"), params={"state": "waiting"}))["next"] is None
        assert one["state"] == "running"
    finally:
        let_go.set()
    until(lambda: body_of(world.producer.get(of_studio(world)))["lanes"] == [])


def test_a_job_is_let_run_again_once(world: World) -> None:
    key = parked(world, studio_id=world.studio_id)
    jobs = world.server.runtime.queue
    broken["is"] = False
    assert jobs.retry(key) is True
    until(lambda: key in ran)
    assert jobs.retry(key) is False
    assert ran.count(key) == 1


def test_only_what_gave_up_can_be_tried_again(world: World) -> None:
    key = enqueue(world, studio_id=world.studio_id, delay_s=A_DAY_S)
    answer = world.producer.post(of_studio(world, f"jobs/{key}/retry"))
    assert (answer.status_code, answer.json()["code"]) == (409, "job-not-parked")
    assert "delayed" in answer.json()["detail"]
    assert world.producer.post(of_studio(world, "jobs/never/retry")).status_code == 404


def test_jobs_come_in_pages_oldest_first(world: World, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("app.operations.service.PAGE_JOBS", 2)
    keys = [enqueue(world, studio_id=world.studio_id, delay_s=A_DAY_S) for _ in range(5)]
    pages, cursor = [], None
    while not pages or cursor:
        page = body_of(world.producer.get(of_studio(world, "jobs"), params={"cursor": cursor} if cursor else {}))
        pages.append([job["id"] for job in page["items"]])
        cursor = page["next"]
    assert [len(page) for page in pages] == [2, 2, 1]
    assert sorted(key for page in pages for key in page) == sorted(keys)
    (count,) = body_of(world.producer.get(of_studio(world)))["counts"]
    assert (count["state"], count["jobs"]) == ("delayed", 5)


@pytest.mark.parametrize("cursor", ["here", "1", ".x", "x.y", "9" * 30 + ".x"])
def test_a_cursor_that_is_none_is_refused(world: World, cursor: str) -> None:
    answer = world.producer.get(of_studio(world, "jobs"), params={"cursor": cursor})
    assert (answer.status_code, answer.json()["code"]) == (422, "bad-cursor")


@pytest.fixture
def kept(world: World) -> Callable[[], dict[str, Any]]:
    return lambda: body_of(world.producer.get(of_studio(world, "storage")))


def kinds(storage: dict[str, Any]) -> dict[str, tuple[int, int]]:
    return {each["kind"]: (each["files"], each["size_bytes"]) for each in storage["kept"]}


@pytest.mark.slow
def test_what_is_delivered_twice_is_kept_once(
    world: World, operator: Client, kept: Callable[[], dict[str, Any]]
) -> None:
    stage = Stage(world)
    cue_id, same = stage.cue("shield_hit"), "a" * 64
    for sha256 in (same, same, "b" * 64):
        stage.take(cue_id, master_sha256=sha256, is_drawn=False)  # 1,000 bytes each
    take_id = stage.take(cue_id, is_drawn=False)
    tenant = {"studio_id": world.studio_id, "project_id": world.project_id}

    def render(session: Any) -> None:
        for target, sha256 in (("game", "c" * 64), ("handheld", "c" * 64), ("trailer", None)):
            session.add(
                Render(
                    **tenant,
                    take_id=take_id,
                    target=target,
                    key=target,
                    state=RenderState.MADE if sha256 else RenderState.REFUSED,
                    refusal=None if sha256 else "the master is at 22050 Hz",
                    sha256=sha256,
                    file_bytes=400 if sha256 else None,
                )
            )

    world.server.in_database(render)
    assert kinds(kept()) == {"masters": (3, 3_000), "game_files": (1, 400)}
    assert kept()["size_bytes"] == 3_400
    server = body_of(operator.get("/v1/operations/storage"))
    assert [each for each in server["studios"] if each["studio_id"] == str(world.studio_id)] == [kept()]
    is_on_disk = world.server.runtime.settings.bucket is None
    assert (server["free_bytes"] is not None and server["free_bytes"] > 0) == is_on_disk


def test_every_kind_of_file_is_counted(world: World, kept: Callable[[], dict[str, Any]]) -> None:
    stage = Stage(world)
    cue_id = stage.cue("shield_hit")
    take_id, fixed_id = stage.take(cue_id, is_drawn=False), stage.take(cue_id, is_drawn=False)
    tenant = {"studio_id": world.studio_id, "project_id": world.project_id}
    letters = iter("bcdefghijk")

    def add(session: Any) -> None:
        def file(size_bytes: int) -> dict[str, Any]:
            return {"sha256": next(letters) * 64, "file_bytes": size_bytes}

        def fix(key: str, size_bytes: int, **used: Any) -> Fix:
            sha256 = next(letters) * 64
            return Fix(**tenant, take_id=take_id, key=key, state=FixState.MADE, sha256=sha256,
                        fixed_bytes=size_bytes, **used)  # fmt: skip

        session.add(Picture(studio_id=world.studio_id, sound_sha256="x", drawn_bytes=70))
        session.add(Picture(studio_id=world.studio_id, sound_sha256="y", drawn_bytes=None))  # drawn before it was noted
        session.add(fix("waits", 50))
        session.add(fix("used", 60, used_by=world.designer_id, new_take_id=fixed_id))
        session.add(Reel(**tenant, cue_id=cue_id, key="reel", gap_ms=0, crossfade_ms=0, with_slates=False,
                         file_name="reel.wav", **file(40)))  # fmt: skip
        session.add(PlaceholderFile(**tenant, cue_id=cue_id, variation=1, target="game", key="k", **file(30)))
        session.add(MasterExport(**tenant, take_id=take_id, key="k", provenance={}, file_name="m.wav", **file(20)))
        reference = Reference(**tenant, caption="", terms="", newest_number=1, added_by=world.producer_id)
        session.add(reference)
        session.flush()
        shown = file(15)
        session.add(ReferenceVersion(**tenant, reference_id=reference.id, number=1, kind=ReferenceKind.PICTURE,
                                     media_type="image/png", file_name="a.png", excerpt="", preview=PreviewState.MADE,
                                     thumb_sha256="t" * 64, thumb_bytes=2, view_sha256="v" * 64, view_bytes=3,
                                     added_by=world.producer_id, **shown))  # fmt: skip
        pack = SealedPack(**tenant, target="game", number=1, sealed_by=world.producer_id)
        session.add(pack)
        session.flush()
        for place, kind in enumerate((FileKind.KEY, FileKind.GAME)):
            session.add(PackedFile(pack_id=pack.id, place=place, studio_id=world.studio_id, path=f"{place}", kind=kind,
                                   sha256=next(letters) * 64, size_bytes=10))  # fmt: skip

    world.server.in_database(add)
    assert kinds(kept()) == {
        "masters": (2, 2_000),
        "drawings": (1, 70),
        "fixes": (1, 50),
        "reels": (1, 40),
        "exports": (1, 20),
        "placeholder_files": (1, 30),
        "references": (3, 20),
        "documents": (1, 10),
    }


def test_a_studio_that_keeps_nothing_is_shown_so(kept: Callable[[], dict[str, Any]]) -> None:
    assert (kept()["kept"], kept()["size_bytes"]) == ([], 0)
