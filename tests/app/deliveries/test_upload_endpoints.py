"""Bytes on their way in: tus and PUT, permissions before a byte is stored, refusals in words."""

import base64
import hashlib
from datetime import timedelta
from typing import Any
from uuid import UUID

import pytest
from httpx2 import Client

from app.accounts.authentication import SESSION_COOKIE
from app.accounts.models import Token
from app.accounts.rules import Scope
from app.core import clock
from app.core.db import new_id
from app.projects.models import Engagement
from app.projects.rules import EngagementKind
from tests.support.deliver import BYTES, TUS, metadata, open_delivery
from tests.support.server import RunningServer, World

CONTENT = b"RIFF" + bytes(range(256)) * 1_000
SHA256 = hashlib.sha256(CONTENT).hexdigest()


def begin(client: Client, delivery_id: str, length: int | str = len(CONTENT), **more: Any) -> Any:
    names = {"file_name": "laser.wav"} | more.pop("names", {})
    headers = {"Upload-Length": str(length), "Upload-Metadata": metadata(delivery_id=delivery_id, **names)}
    return client.post("/v1/uploads", headers=TUS | headers | more.pop("headers", {}), **more)


def patch(client: Client, location: str, offset: int | str, content: bytes, **headers: str) -> Any:
    return client.patch(location, headers=TUS | BYTES | {"Upload-Offset": str(offset)} | headers, content=content)


def b64(digest: bytes) -> str:
    return base64.b64encode(digest).decode()


def staged(server: RunningServer, studio_id: UUID) -> list[str]:
    return [path.name for path in server.runtime.store.staging_root.glob(f"{studio_id}/.uploads/*")]


@pytest.mark.slow
def test_a_file_comes_in_pieces(world: World) -> None:
    location = begin(world.designer, open_delivery(world)).headers["location"]
    for start in range(0, len(CONTENT), 100_000):
        seen = world.designer.head(location, headers=TUS)
        assert (seen.headers["upload-offset"], seen.headers["upload-length"]) == (str(start), str(len(CONTENT)))
        assert seen.headers["upload-expires"].endswith("GMT")
        assert seen.headers["cache-control"] == "no-store"
        sent = patch(world.designer, location, start, CONTENT[start : start + 100_000])
        assert sent.status_code == 204
        assert sent.headers["tus-resumable"] == "1.0.0"
    assert "upload-expires" not in world.designer.head(location, headers=TUS).headers
    assert world.server.runtime.store.read(world.studio_id, SHA256) == CONTENT


def test_the_first_bytes_may_come_with_the_creation(world: World) -> None:
    begun = begin(world.designer, open_delivery(world), headers=BYTES, content=CONTENT[:500])
    assert (begun.status_code, begun.headers["upload-offset"]) == (201, "500")
    assert patch(world.designer, begun.headers["location"], 500, CONTENT[500:]).status_code == 204
    assert world.server.runtime.store.read(world.studio_id, SHA256) == CONTENT


def test_the_server_says_what_it_speaks(world: World) -> None:
    reported = world.nobody.options("/v1/uploads")
    assert reported.status_code == 204
    assert reported.headers["tus-version"] == "1.0.0"
    assert set(reported.headers["tus-extension"].split(",")) >= {"creation", "checksum", "termination", "expiration"}
    assert "sha256" in reported.headers["tus-checksum-algorithm"]


def test_an_unfinished_upload_can_be_given_up(world: World) -> None:
    location = begin(world.designer, open_delivery(world)).headers["location"]
    assert world.designer.delete(location, headers=TUS).status_code == 204
    assert world.designer.head(location, headers=TUS).status_code == 404
    assert staged(world.server, world.studio_id) == []


def test_checksums_are_proven(world: World) -> None:
    location = begin(world.designer, open_delivery(world)).headers["location"]
    right = f"sha256 {b64(hashlib.sha256(CONTENT).digest())}"
    wrong = patch(world.designer, location, 0, CONTENT[::-1], **{"Upload-Checksum": right})
    assert (wrong.status_code, wrong.json()["code"]) == (460, "checksum-mismatch")
    assert world.designer.head(location, headers=TUS).headers["upload-offset"] == "0"
    assert patch(world.designer, location, 0, CONTENT, **{"Upload-Checksum": right}).status_code == 204


def test_a_whole_file_other_than_announced_is_refused(world: World) -> None:
    location = begin(world.designer, open_delivery(world), names={"sha256": SHA256}).headers["location"]
    wrong = patch(world.designer, location, 0, CONTENT[::-1])
    assert (wrong.status_code, wrong.json()["code"]) == (460, "checksum-mismatch")
    assert SHA256 in wrong.json()["detail"]
    assert patch(world.designer, location, 0, CONTENT).status_code == 204


def test_what_does_not_fit_is_refused_with_a_reason(world: World) -> None:
    location = begin(world.designer, open_delivery(world)).headers["location"]
    refused = {
        "offset-mismatch": patch(world.designer, location, 7, CONTENT),
        "upload-too-long": patch(world.designer, location, 0, CONTENT + b"x"),
        "bad-upload-header": patch(world.designer, location, "seven", CONTENT),
        "wrong-content-type": world.designer.patch(location, headers=TUS | {"Upload-Offset": "0"}, content=CONTENT),
        "unknown-tus-version": patch(world.designer, location, 0, CONTENT, **{"Tus-Resumable": "0.2.2"}),
    }
    assert {code: answer.json()["code"] for code, answer in refused.items()} == {code: code for code in refused}
    assert [answer.status_code for answer in refused.values()] == [409, 413, 400, 415, 412]
    assert {answer.headers["tus-resumable"] for answer in refused.values()} == {"1.0.0"}
    assert refused["unknown-tus-version"].headers["tus-version"] == "1.0.0"
    assert world.designer.head(location, headers=TUS).headers["upload-offset"] == "0"


@pytest.mark.parametrize(
    "headers",
    [
        {"Upload-Length": "-1"},
        {"Upload-Length": "ten"},
        {"Upload-Length": "9" * 40},
        {"Upload-Metadata": "delivery_id notbase64!,file_name bGFzZXI="},
        {"Upload-Metadata": "delivery_id /w==,file_name bGFzZXI="},
        {"Upload-Metadata": f"delivery_id {b64(b'no id')},file_name bGFzZXI="},
        {"Upload-Metadata": f"delivery_id {b64(str(new_id()).encode())}"},
        {"Upload-Metadata": ""},
        {"Upload-Checksum": "crc32 AAAA"},
        {"Upload-Checksum": "sha256 %%"},
    ],
)
def test_a_bad_header_is_refused_with_a_reason(world: World, headers: dict[str, str]) -> None:
    answer = begin(world.designer, open_delivery(world), headers=headers)
    assert (answer.status_code, answer.json()["code"]) == (400, "bad-upload-header")
    assert staged(world.server, world.studio_id) == []


def test_how_long_a_file_may_be(world: World) -> None:
    delivery_id = open_delivery(world)
    assert begin(world.designer, delivery_id, (2 << 30) + 1).status_code == 413
    assert begin(world.designer, delivery_id, (5 << 30) + 1, names={"file_name": "all.zip"}).status_code == 413
    for length, name in ((2 << 30, "laser.wav"), (5 << 30, "all.ZIP")):
        begun = begin(world.designer, delivery_id, length, names={"file_name": name})
        assert begun.status_code == 201
        assert world.designer.delete(begun.headers["location"], headers=TUS).status_code == 204


@pytest.mark.parametrize(
    ("who", "status"),
    [("nobody", 401), ("stranger", 404), ("other_designer", 404), ("approver", 403), ("producer", 403)],
)
def test_only_the_designer_may_send_a_byte(world: World, who: str, status: int) -> None:
    delivery_id = open_delivery(world)
    client = getattr(world, who)
    assert begin(client, delivery_id).status_code == status
    sent = client.put("/v1/uploads", params={"delivery_id": delivery_id, "file_name": "laser.wav"}, content=CONTENT)
    assert sent.status_code == status
    assert staged(world.server, world.studio_id) == []
    location = begin(world.designer, delivery_id).headers["location"]
    for answer in (
        client.head(location, headers=TUS),
        patch(client, location, 0, CONTENT),
        client.delete(location, headers=TUS),
    ):
        assert answer.status_code == (401 if who == "nobody" else 404)
    assert world.designer.head(location, headers=TUS).headers["upload-offset"] == "0"


def test_another_engaged_designer_does_not_learn_that_it_exists(world: World) -> None:
    world.server.in_database(
        lambda session: session.add(
            Engagement(
                studio_id=world.studio_id,
                project_id=world.project_id,
                designer_id=world.other_designer_id,
                kind=EngagementKind.CONTRACT,
            )
        )
    )
    delivery_id = open_delivery(world)
    assert begin(world.other_designer, delivery_id).status_code == 404
    location = begin(world.designer, delivery_id).headers["location"]
    assert patch(world.other_designer, location, 0, CONTENT).status_code == 404


def test_whose_engagement_ended_sends_nothing_more(world: World) -> None:
    location = begin(world.designer, open_delivery(world)).headers["location"]

    def end(session: Any) -> None:
        engagement = session.query(Engagement).filter_by(designer_id=world.designer_id).one()
        engagement.ended_at = clock.now()

    world.server.in_database(end)
    assert patch(world.designer, location, 0, CONTENT).status_code == 404


def test_a_closed_delivery_takes_no_new_upload_but_the_rest_of_one(world: World) -> None:
    delivery_id = open_delivery(world)
    location = begin(world.designer, delivery_id).headers["location"]
    assert world.designer.post(f"/v1/deliveries/{delivery_id}/close").status_code == 200
    assert begin(world.designer, delivery_id).json()["code"] == "delivery-closed"
    assert patch(world.designer, location, 0, CONTENT).status_code == 204


def test_a_cookie_without_our_token_sends_nothing(world: World) -> None:
    delivery_id = open_delivery(world)
    forged = world.server.browser()
    forged.cookies.set(SESSION_COOKIE, world.designer.cookies[SESSION_COOKIE])
    assert begin(forged, delivery_id).json()["code"] == "csrf-mismatch"


class TestPut:
    def put(self, world: World, content: Any = CONTENT, **headers: str) -> Any:
        params = {"delivery_id": open_delivery(world), "file_name": "laser.wav"}
        return world.designer.put("/v1/uploads", params=params, content=content, headers=headers)

    @pytest.mark.parametrize(
        "headers",
        [
            {},
            {"X-Content-SHA256": SHA256.upper()},
            {"Repr-Digest": f"sha-256=:{b64(bytes.fromhex(SHA256))}:"},
            {"Repr-Digest": f"sha-512=:AAAA:, sha-256=:{b64(bytes.fromhex(SHA256))}:"},
        ],
    )
    def test_a_whole_file(self, world: World, headers: dict[str, str]) -> None:
        sent = self.put(world, **headers)
        assert sent.status_code == 201
        assert {**sent.json(), "upload_id": ""} == {
            "upload_id": "",
            "offset": len(CONTENT),
            "length": len(CONTENT),
            "sha256": SHA256,
        }
        assert world.server.runtime.store.read(world.studio_id, SHA256) == CONTENT

    @pytest.mark.parametrize(
        ("headers", "code"),
        [
            ({"X-Content-SHA256": "0" * 64}, "checksum-mismatch"),
            ({"Repr-Digest": f"sha-256=:{b64(bytes(32))}:"}, "checksum-mismatch"),
            ({"X-Content-SHA256": "abc"}, "bad-upload-header"),
            ({"Repr-Digest": "sha-256=:AAAA:"}, "bad-upload-header"),
        ],
    )
    def test_other_bytes_than_announced_leave_nothing_behind(
        self, world: World, headers: dict[str, str], code: str
    ) -> None:
        assert self.put(world, **headers).json()["code"] == code
        assert staged(world.server, world.studio_id) == []

    def test_a_file_of_unknown_length_is_refused(self, world: World) -> None:
        assert self.put(world, iter([CONTENT])).json()["code"] == "length-required"

    def test_a_build_delivers_for_the_one_in_house_designer(self, world: World) -> None:
        token = "slt_of_this_test"
        world.server.in_database(
            lambda session: session.add(
                Token(
                    studio_id=world.studio_id,
                    project_id=world.project_id,
                    name="render farm",
                    secret_sha256=hashlib.sha256(f"{token}{world.project_id}".encode()).hexdigest(),
                    scopes=[Scope.DELIVERIES_WRITE],
                    created_by=world.producer_id,
                    expires_at=clock.now() + timedelta(days=1),
                )
            )
        )
        build = world.server.browser()
        build.headers["Authorization"] = f"Bearer {token}{world.project_id}"
        opened = build.post(f"/v1/projects/{world.project_id}/deliveries", json={})
        assert (opened.status_code, opened.json()["code"]) == (403, "in-house-designer-needed")
        world.server.in_database(
            lambda session: session.add(
                Engagement(
                    studio_id=world.studio_id,
                    project_id=world.project_id,
                    designer_id=world.other_designer_id,
                    kind=EngagementKind.IN_HOUSE,
                )
            )
        )
        delivery_id = open_delivery(world, by=build)
        params = {"delivery_id": delivery_id, "file_name": "laser.wav"}
        sent = build.put("/v1/uploads", params=params, content=CONTENT)
        assert sent.status_code == 201, sent.text
        made = build.post(
            f"/v1/deliveries/{delivery_id}/takes",
            json={"upload_id": sent.json()["upload_id"], "file_name": "laser.wav"},
        )
        assert made.status_code == 201
        assert made.json()["designer"]["id"] == str(world.other_designer_id)
        params["delivery_id"] = open_delivery(world)  # of the contracted designer
        assert build.put("/v1/uploads", params=params, content=CONTENT).status_code == 404
