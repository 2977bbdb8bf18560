"""Parts of uploads, and signed links to what is stored, over HTTP: the bucket is reached without the server."""

import hashlib
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import pytest
from anyio.from_thread import start_blocking_portal
from httpx2 import Client

from app.core.runtime import Runtime
from app.core.storage import BucketStore, multipart
from app.core.storage.retry_policy import RetryPolicy
from app.main import create_app
from app.migrate import migrate
from app.settings import Settings
from tests.support.deliver import TUS, metadata, open_delivery
from tests.support.s3 import KEY, FaultyLine, S3Server, faulty_line
from tests.support.server import RunningServer, World

pytestmark = pytest.mark.both_databases

CONTENT = bytes(range(256)) * 30_000  # 7.7 MB: two parts
PART_BYTES = 5 << 20  # the least that S3 takes
SECRET_KEY = "only for tests, and only here"


@pytest.fixture(scope="module")
def direct(s3: S3Server, tmp_path_factory: pytest.TempPathFactory) -> Iterator[RunningServer]:
    """A web process whose bucket browsers may reach; no worker runs beside it."""
    settings = s3.settings(store_direct=True, data_dir=tmp_path_factory.mktemp("direct"), secret_key=SECRET_KEY)
    runtime = Runtime.of(Settings(**settings))
    migrate(runtime.database)
    with start_blocking_portal() as portal:
        yield RunningServer(runtime, create_app(runtime), portal)
    runtime.close()


@pytest.fixture
def world(direct: RunningServer, monkeypatch: pytest.MonkeyPatch) -> World:
    monkeypatch.setattr(multipart, "PART_BYTES", PART_BYTES)
    return World(direct)


def begun(world: World, length: int = len(CONTENT), by: Client | None = None) -> str:
    names = metadata(delivery_id=open_delivery(world), file_name="ambience.wav")
    headers = TUS | {"Upload-Length": str(length), "Upload-Metadata": names}
    return str((by or world.designer).post("/v1/uploads", headers=headers).headers["location"])


def named(number: int) -> dict[str, Any]:
    part = CONTENT[(number - 1) * PART_BYTES : number * PART_BYTES]
    return {"number": number, "sha256": hashlib.sha256(part).hexdigest()}


def sent(world: World, s3: S3Server, location: str, numbers: list[int]) -> list[int]:
    """Send parts as a browser does; return those that are there then."""
    asked = world.designer.post(f"{location}/parts", json={"parts": [named(number) for number in numbers]})
    assert asked.status_code == 200, asked.text
    for link in asked.json()["links"]:
        part = CONTENT[link["start"] : link["start"] + link["length"]]
        assert s3.client.put(link["url"], content=part, headers=link["headers"]).status_code == 200
    here: list[int] = world.designer.post(f"{location}/parts", json={}).json()["here"]
    return here


@pytest.mark.slow
def test_a_store_that_takes_parts_says_so(direct: RunningServer, server: RunningServer):
    reported = direct.browser().options("/v1/uploads").headers["tus-extension"].split(",")
    assert "soundlist-parts" in reported
    assert {"creation", "checksum"} < set(reported)
    assert "soundlist-parts" not in server.browser().options("/v1/uploads").headers["tus-extension"]


def test_a_store_without_multipart_uploads_says_so(server: RunningServer):
    world = World(server)
    location = begun(world)
    answer = world.designer.post(f"{location}/parts", json={"parts": [named(1)]})
    assert (answer.status_code, answer.json()["code"]) == (409, "parts-not-taken")
    assert answer.json()["fix"] == "send its bytes to the server"
    assert world.designer.post(f"{location}/finish").json()["code"] in ("upload-unfinished", "parts-not-taken")


@pytest.mark.slow
def test_a_file_goes_to_the_bucket_and_becomes_a_take(world: World, s3: S3Server):
    delivery_id = open_delivery(world)
    names = metadata(delivery_id=delivery_id, file_name="ambience.wav")
    headers = TUS | {"Upload-Length": str(len(CONTENT)), "Upload-Metadata": names}
    location = world.designer.post("/v1/uploads", headers=headers).headers["location"]
    assert sent(world, s3, location, [2]) == [2]
    assert world.designer.head(location, headers=TUS).headers["upload-offset"] == "0"
    body = {"upload_id": location.rpartition("/")[2], "file_name": "ambience.wav"}
    assert world.designer.post(f"{location}/finish").json()["code"] == "upload-unfinished"
    early = world.designer.post(f"/v1/deliveries/{delivery_id}/takes", json=body)
    assert (early.status_code, early.json()["code"]) == (409, "upload-unfinished")
    assert sent(world, s3, location, [1]) == [1, 2]
    finished = world.designer.post(f"{location}/finish")
    assert finished.status_code == 200, finished.text
    made = world.designer.post(f"/v1/deliveries/{delivery_id}/takes", json=body)
    assert (made.status_code, made.json()["master_sha256"]) == (201, finished.json()["sha256"])
    assert world.server.runtime.store.read(world.studio_id, finished.json()["sha256"]) == CONTENT


def test_through_the_server_it_goes_on_working(world: World):
    params = {"delivery_id": open_delivery(world), "file_name": "laser.wav"}
    put = world.designer.put("/v1/uploads", params=params, content=CONTENT)
    assert put.status_code == 201, put.text
    assert world.server.runtime.store.read(world.studio_id, put.json()["sha256"]) == CONTENT


@pytest.mark.parametrize(("who", "status"), [("nobody", 401), ("stranger", 404), ("other_designer", 404)])
def test_no_one_else_gets_a_link(world: World, who: str, status: int):
    location, client = begun(world), getattr(world, who)
    assert client.post(f"{location}/parts", json={"parts": [named(1)]}).status_code == status
    assert client.post(f"{location}/finish").status_code == status


@pytest.mark.parametrize(
    "parts", [[named(0)], [named(3)], [named(1)] * 101, [{"number": 1}], [{"number": 1, "sha256": "abc"}]]
)
def test_parts_that_are_none_are_refused(world: World, parts: list[Any]):
    answer = world.designer.post(f"{begun(world)}/parts", json={"parts": parts})
    assert answer.status_code == 422


def test_bytes_for_the_server_are_refused_once_parts_are_sent(world: World, s3: S3Server):
    location = begun(world)
    sent(world, s3, location, [1])
    headers = TUS | {"Upload-Offset": str(PART_BYTES), "Content-Type": "application/offset+octet-stream"}
    answer = world.designer.patch(location, headers=headers, content=CONTENT[PART_BYTES:])
    assert (answer.status_code, answer.json()["code"]) == (409, "sent-in-parts")


def test_given_up_is_gone(world: World, s3: S3Server):
    location = begun(world)
    sent(world, s3, location, [1])
    assert world.designer.delete(location, headers=TUS).status_code == 204
    assert world.designer.post(f"{location}/parts", json={}).status_code == 404


@pytest.mark.slow
def test_a_master_is_fetched_by_a_link_that_expires(world: World, s3: S3Server, tmp_path: Path):
    delivery_id = open_delivery(world)
    params = {"delivery_id": delivery_id, "file_name": "Bö laser.wav"}
    upload_id = world.designer.put("/v1/uploads", params=params, content=CONTENT).json()["upload_id"]
    body = {"upload_id": upload_id, "file_name": "Bö laser.wav"}
    take = world.designer.post(f"/v1/deliveries/{delivery_id}/takes", json=body).json()
    sent_on = world.designer.get(f"/v1/takes/{take['id']}/master", follow_redirects=False)
    assert sent_on.status_code == 307
    assert sent_on.headers["cache-control"] == "private, max-age=300"
    url = sent_on.headers["location"]
    assert url.startswith(s3.endpoint)
    assert "X-Amz-Expires=900" in url
    whole = s3.client.get(url)
    assert (whole.content, whole.headers["content-type"]) == (CONTENT, "application/octet-stream")
    named = "attachment; filename=\"B_ laser.wav\"; filename*=UTF-8''B%C3%B6%20laser.wav"
    assert whole.headers["content-disposition"] == named
    part = s3.client.get(url, headers={"Range": "bytes=100-199"})
    assert (part.status_code, part.content) == (206, CONTENT[100:200])
    assert world.stranger.get(f"/v1/takes/{take['id']}/master", follow_redirects=False).status_code == 404


def test_the_page_may_reach_the_bucket_and_nothing_else(direct: RunningServer, server: RunningServer, s3: S3Server):
    policy = direct.browser().get("/healthz").headers["content-security-policy"]
    assert f"connect-src 'self' {s3.endpoint};" in policy
    assert urlsplit(s3.endpoint).netloc not in server.browser().get("/healthz").headers["content-security-policy"]


@pytest.fixture(scope="module")
def on_a_bad_line(s3: S3Server, tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[RunningServer, FaultyLine]]:
    """A web process at the end of a line to its store that can be made to fail."""
    settings = s3.settings(data_dir=tmp_path_factory.mktemp("faulty"), secret_key=SECRET_KEY)
    with faulty_line(s3) as line, start_blocking_portal() as portal:
        settings["store_url"] = settings["store_url"].replace(s3.endpoint, line.endpoint)
        runtime = Runtime.of(Settings(**settings))
        hasty = RetryPolicy(tries=2, first_delay_s=0.01, connect_timeout_s=1.0, read_timeout_s=1.0)
        assert runtime.settings.bucket is not None
        store = BucketStore(runtime.settings.bucket, KEY, runtime.store.staging_root, patience=hasty)
        runtime = replace(runtime, store=store)
        migrate(runtime.database)
        yield RunningServer(runtime, create_app(runtime), portal), line
        runtime.close()


@pytest.mark.slow
def test_a_store_that_does_not_answer_is_reported_and_nothing_is_half_kept(
    on_a_bad_line: tuple[RunningServer, FaultyLine],
):
    server, line = on_a_bad_line
    world = World(server)
    location = begun(world, 5)
    bytes_of = TUS | {"Upload-Offset": "0", "Content-Type": "application/offset+octet-stream"}
    line.fail("503", times=2, method="PUT")
    reported = world.designer.patch(location, headers=bytes_of, content=b"sound")
    assert (reported.status_code, reported.json()["code"]) == (503, "store-unavailable")
    assert int(reported.headers["retry-after"]) > 0
    assert list(server.runtime.store.blobs()) == []
    standing = world.designer.head(location, headers=TUS)  # all bytes are here: the next request finishes it
    assert (standing.status_code, standing.headers["upload-offset"]) == (200, "5")
    assert [blob.size_bytes for _, blob in server.runtime.store.blobs()] == [5]


@pytest.mark.slow
def test_a_put_that_the_store_does_not_take_leaves_nothing_behind(on_a_bad_line: tuple[RunningServer, FaultyLine]):
    server, line = on_a_bad_line
    world = World(server)
    line.fail("refused", times=2, method="PUT")
    params = {"delivery_id": open_delivery(world), "file_name": "laser.wav"}
    reported = world.designer.put("/v1/uploads", params=params, content=b"another sound")
    assert (reported.status_code, reported.json()["code"]) == (503, "store-unavailable")
    assert list(server.runtime.store.staging_root.glob(f"{world.studio_id}/.uploads/*")) == []
    assert world.designer.put("/v1/uploads", params=params, content=b"another sound").status_code == 201


@pytest.mark.slow
def test_a_master_that_cannot_be_read_now_is_reported_before_a_byte_is_sent(
    on_a_bad_line: tuple[RunningServer, FaultyLine],
):
    server, line = on_a_bad_line
    world = World(server)
    delivery_id = open_delivery(world)
    params = {"delivery_id": delivery_id, "file_name": "laser.wav"}
    upload = world.designer.put("/v1/uploads", params=params, content=b"a third sound").json()
    body = {"upload_id": upload["upload_id"], "file_name": "laser.wav"}
    take = world.designer.post(f"/v1/deliveries/{delivery_id}/takes", json=body).json()
    line.fail("503", times=2, method="HEAD")
    reported = world.designer.get(f"/v1/takes/{take['id']}/master")
    assert (reported.status_code, reported.json()["code"]) == (503, "store-unavailable")
    assert world.designer.get(f"/v1/takes/{take['id']}/master").content == b"a third sound"
