"""The browsers by which the demo plays its parts."""

from typing import Any
from uuid import UUID

import httpx

from app.accounts.authentication import CSRF_HEADER, DEMO_COOKIE, DEMO_SECRET, SESSION_COOKIE, csrf_token
from app.accounts.sign_ins import start_sign_in
from app.core.runtime import Runtime
from app.demo.references import DemoReference
from app.settings import Settings


class Visitor:
    """One part's browser."""

    def __init__(self, settings: Settings, part: str, *, cookie: str = DEMO_COOKIE, secret: str = DEMO_SECRET) -> None:
        self._client = httpx.Client(
            base_url=settings.base_url,
            cookies={cookie: part},
            headers={CSRF_HEADER: csrf_token(settings, secret)},
            timeout=60,
        )

    def ask(self, method: str, path: str, *, once: str | None = None, **more: Any) -> Any:
        """Send a request and return its body; with `once`, a second run of the demo does not repeat it.

        Return None for a request whose answer was lost when the demo was killed.
        """
        headers = {"Idempotency-Key": once} if once else {}
        answer = self._client.request(method, f"/v1{path}", headers=headers, **more)
        if once and answer.status_code == httpx.codes.CONFLICT and answer.json()["code"] == "already-processed":
            return None
        if answer.is_error:
            raise RuntimeError(f"{method} {path}: {answer.status_code} {answer.text}")
        if not answer.content:
            return None
        return answer.json() if "json" in answer.headers.get("content-type", "") else answer.content

    def send_reference(self, project_id: str, reference: DemoReference) -> str:
        """Send a file for the board of a project, and return the id of its upload."""
        headers = {
            "Tus-Resumable": "1.0.0",
            "Content-Type": "application/offset+octet-stream",
            "Upload-Length": str(len(reference.content)),
            "Upload-Metadata": reference.metadata(project_id),
        }
        sent = self._client.post("/v1/uploads", headers=headers, content=reference.content).raise_for_status()
        return str(sent.headers["location"].rpartition("/")[2])

    def close(self) -> None:
        """Close the connections."""
        self._client.close()


def signed_in_visitor(runtime: Runtime, person_id: str) -> Visitor:
    """Return the browser of a person who plays no part that a visitor can choose."""
    with runtime.database.writing() as session:
        secret = start_sign_in(session, UUID(person_id))
    return Visitor(runtime.settings, secret, cookie=SESSION_COOKIE, secret=secret)
