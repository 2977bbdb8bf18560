"""People who do the main job over HTTP, each in a browser of their own."""

import base64
from typing import Any
from uuid import uuid4

from httpx2 import Client

from app.accounts.authentication import CSRF_COOKIE, CSRF_HEADER
from tests.support.links import secret_for
from tests.support.server import RunningServer

PASSWORD = "a long and quiet password"
TUS_CHUNK_BYTES = 150_000


class Person:
    """A person with a browser."""

    def __init__(self, server: RunningServer) -> None:
        self.server = server
        self.browser: Client = server.browser()
        self.address = f"{uuid4()}@example.test"
        self.browser.get("/v1/session")

    def ask(self, method: str, path: str, **more: Any) -> Any:
        """Send a request that must succeed and return its body."""
        self.browser.headers[CSRF_HEADER] = self.browser.cookies.get(CSRF_COOKIE, "")
        answer = self.browser.request(method, f"/v1{path}", **more)
        assert answer.is_success, f"{method} {path}: {answer.status_code} {answer.text}"
        return answer.json() if "json" in answer.headers.get("content-type", "") else answer.content

    def refused(self, method: str, path: str, **more: Any) -> dict[str, Any]:
        """Send a request that must be refused and return the problem."""
        answer = self.browser.request(method, f"/v1{path}", **more)
        assert 400 <= answer.status_code < 500, f"{method} {path}: {answer.status_code} {answer.text}"
        problem: dict[str, Any] = answer.json()
        return problem


class Team(Person):
    """A member of the studio."""

    def sign_up(self, studio: str) -> str:
        """Open an account and a studio; return the studio's id."""
        body = {"email": self.address, "name": "Producer", "password": PASSWORD, "studio_name": studio}
        self.ask("POST", "/sign-up", json=body)
        studio_id: str = self.ask("GET", "/me")["studios"][0]["id"]
        return studio_id

    def join(self, name: str) -> str:
        """Follow the mailed link into the studio; return the person's id."""
        secret = secret_for(self.server, self.address)
        self.ask("POST", f"/studio-invitations/{secret}/accept", json={"name": name, "password": PASSWORD})
        person_id: str = self.ask("GET", "/me")["person"]["id"]
        return person_id


class Designer(Person):
    """A sound designer whom a link invited."""

    def look(self) -> dict[str, Any]:
        """Open the mailed link without an account."""
        self.secret = secret_for(self.server, self.address)
        shown: dict[str, Any] = self.ask("GET", f"/invitations/{self.secret}")
        return shown

    def accept(self) -> None:
        """Make the account that the first upload asks for."""
        self.ask("POST", f"/invitations/{self.secret}/accept", json={"name": "Sound designer", "password": PASSWORD})

    def open_delivery(self, project: str, note: str = "") -> str:
        """Open a delivery and return its id."""
        delivery_id: str = self.ask("POST", f"/projects/{project}/deliveries", json={"note": note})["id"]
        return delivery_id

    def deliver(self, delivery: str, name: str, content: bytes) -> dict[str, Any]:
        """Send a file by tus in chunks, as the browser does, and make it a take."""
        metadata = {"delivery_id": delivery, "file_name": name}
        headers = {
            "Tus-Resumable": "1.0.0",
            "Upload-Length": str(len(content)),
            "Upload-Metadata": ",".join(
                f"{key} {base64.b64encode(value.encode()).decode()}" for key, value in metadata.items()
            ),
        }
        self.browser.headers[CSRF_HEADER] = self.browser.cookies.get(CSRF_COOKIE, "")
        created = self.browser.post("/v1/uploads", headers=headers)
        assert created.status_code == 201, created.text
        address = created.headers["location"]
        for offset in range(0, len(content), TUS_CHUNK_BYTES):
            sent = self.browser.patch(
                address,
                content=content[offset : offset + TUS_CHUNK_BYTES],
                headers={
                    "Tus-Resumable": "1.0.0",
                    "Upload-Offset": str(offset),
                    "Content-Type": "application/offset+octet-stream",
                },
            )
            assert sent.status_code == 204, sent.text
        body = {"upload_id": address.rstrip("/").rpartition("/")[2], "file_name": name}
        take: dict[str, Any] = self.ask("POST", f"/deliveries/{delivery}/takes", json=body)
        return take
