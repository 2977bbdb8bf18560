"""The browser of the tests: it asks the application in one hand-over to the thread of the event loop."""

from typing import Any

from anyio.from_thread import BlockingPortal
from httpx2 import ASGITransport, BaseTransport, ByteStream, Client, Request, Response

ADDRESS = "http://127.0.0.1:8000"
FROM = ("testclient", 50_000)


class ApplicationTransport(BaseTransport):
    """Answers requests by an application on the event loop of a portal.

    Starlette's TestClient goes to the loop and back seven times for each request, which costs more than the answer.
    """

    def __init__(self, application: Any, portal: BlockingPortal, client: tuple[str, int]) -> None:
        self._portal = portal
        self._application = ASGITransport(application, raise_app_exceptions=False, client=client)

    def handle_request(self, request: Request) -> Response:
        """Return the whole answer."""
        request.read()
        return self._portal.call(self._answer, request)

    async def _answer(self, request: Request) -> Response:
        answer = await self._application.handle_async_request(request)
        content = b"".join([part async for part in answer.stream])
        return Response(answer.status_code, headers=answer.headers, stream=ByteStream(content))


def browser(application: Any, portal: BlockingPortal, client: tuple[str, int] = FROM) -> Client:
    """Return a client without credentials; all of a portal share one event loop."""
    transport = ApplicationTransport(application, portal, client)
    return Client(transport=transport, base_url=ADDRESS, headers={"User-Agent": "testclient"}, follow_redirects=True)
