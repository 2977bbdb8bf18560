"""The client's requests to a server. The token goes to that server only: never along with a redirect elsewhere."""

import http.client
import json
import time
import urllib.error
import urllib.request
from base64 import b64encode
from collections.abc import Mapping, Sequence
from typing import Any
from urllib.parse import quote, urlencode, urljoin, urlsplit

from app.client.errors import Refusal, ServerUnreachable
from app.client.settings import Source

TIMEOUT_S = 30
RETRY_DELAYS_S = (0.5, 2.0, 5.0)
MAX_WAIT_S = 30.0  # of what a server asks to wait
MAX_JSON_BYTES = 64 << 20
REDIRECTS = (301, 302, 303, 307, 308)
MAX_REDIRECTS = 3
BUSY = (429, 502, 503, 504)
CUT = (OSError, http.client.HTTPException)  # urllib's errors are OSError too


class _NoRedirects(urllib.request.HTTPRedirectHandler):
    """Redirects are followed here, because urllib sends every header along."""

    def redirect_request(self, *_: Any) -> None:
        """Follow none."""


class Server:
    """One server and project."""

    def __init__(
        self, source: Source, *, retry_delays_s: Sequence[float] | None = None, redirects: bool = True
    ) -> None:
        self.source = source
        self._retry_delays_s = retry_delays_s
        self._redirects = redirects
        self._opener = urllib.request.build_opener(_NoRedirects())

    def of_person(self, path: str, **params: str | None) -> Any:
        """Return an answer about the person whose token this is."""
        given = {name: value for name, value in params.items() if value is not None}
        query = f"?{urlencode(given)}" if given else ""
        return self._json(self._read(f"{self.source.server}/v1/me/{path}{query}"))

    def of_project(self, path: str, **params: str | None) -> Any:
        """Return an answer of the project's API."""
        given = {name: value for name, value in params.items() if value is not None}
        query = f"?{urlencode(given)}" if given else ""
        url = f"{self.source.server}/v1/projects/{quote(self.source.project)}/{path}{query}"
        return self._json(self._read(url))

    def file_of_project(self, path: str, **params: str) -> bytes:
        """Return a file that the project's API exports."""
        query = f"?{urlencode(params)}" if params else ""
        content = self._read(f"{self.source.server}/v1/projects/{quote(self.source.project)}/{path}{query}")
        if len(content) > MAX_JSON_BYTES:
            raise Refusal(f"{path} of {self.source.server} is larger than {MAX_JSON_BYTES >> 20} MiB")
        return content

    def send_to_project(self, path: str, body: Any) -> Any:
        """Send JSON to the project's API, and return the answer."""
        url = f"{self.source.server}/v1/projects/{quote(self.source.project)}/{path}"
        content = json.dumps(body).encode()
        return self._json(self._read(url, {"Content-Type": "application/json"}, content))

    def upload(self, content: bytes, metadata: Mapping[str, str]) -> None:
        """Send a whole file to where its metadata says."""
        named = ",".join(f"{name} {b64encode(value.encode()).decode()}" for name, value in metadata.items())
        headers = {"Tus-Resumable": "1.0.0", "Upload-Length": str(len(content)), "Upload-Metadata": named}
        headers["Content-Type"] = "application/offset+octet-stream"
        self._read(f"{self.source.server}/v1/uploads", headers, content)

    def _json(self, content: bytes) -> Any:
        if len(content) > MAX_JSON_BYTES:
            raise Refusal(f"the answer of {self.source.server} is too large to be a list of sounds")
        try:
            return json.loads(content)
        except ValueError:
            raise Refusal(f"{self.source.server} did not answer as Soundlist does; is the address right?") from None

    def _read(self, url: str, headers: Mapping[str, str] | None = None, body: bytes | None = None) -> bytes:
        delays_s = RETRY_DELAYS_S if self._retry_delays_s is None else self._retry_delays_s
        for delay_s in (*delays_s, None):
            try:
                with self.open(url, headers, body) as answer:
                    return answer.read(MAX_JSON_BYTES + 1)
            except (ServerUnreachable, *CUT) as error:
                if delay_s is None:
                    raise ServerUnreachable(_reason(error)) from None
                wait(delay_s, error)
        raise AssertionError("the last try returns or raises")

    def open(
        self, url: str, headers: Mapping[str, str] | None = None, body: bytes | None = None
    ) -> http.client.HTTPResponse:
        """Return an open answer, to a POST where there is a body.

        Raise Refusal where the server refuses, ServerUnreachable where it does not answer.
        """
        origin = _origin(self.source.server)
        for _ in range(MAX_REDIRECTS + 1):
            own_headers = {"Authorization": f"Bearer {self.source.token}"} if _origin(url) == origin else {}
            request = urllib.request.Request(url, body, headers={**(headers or {}), **own_headers})  # noqa: S310 - http or https
            try:
                answer: http.client.HTTPResponse = self._opener.open(request, timeout=TIMEOUT_S)
                return answer
            except urllib.error.HTTPError as error:
                with error:
                    if error.code not in REDIRECTS or "location" not in error.headers:
                        raise _refused(error) from None
                    if body is not None or not self._redirects:  # the named server is asked, and no other
                        raise Refusal(f"{self.source.server} redirects what is sent; name the other address") from None
                    url = _next(url, error.headers["location"])
            except CUT as error:
                raise ServerUnreachable(_reason(error)) from None
        raise Refusal(f"{self.source.server} redirects too often")


class Busy(ServerUnreachable):
    """The server asks to come back later."""

    def __init__(self, message: str, wait_s: float) -> None:
        super().__init__(message)
        self.wait_s = wait_s


def wait(delay_s: float, error: BaseException) -> None:
    """Wait before the next try, as long as a busy server asks."""
    time.sleep(max(delay_s, error.wait_s) if isinstance(error, Busy) else delay_s)


def _origin(url: str) -> tuple[str, str | None, int | None]:
    parts = urlsplit(url)
    return parts.scheme, parts.hostname, parts.port


def _next(url: str, location: str) -> str:
    target_url = urljoin(url, location)
    scheme = urlsplit(target_url).scheme
    if scheme not in ("https", "http") or (scheme == "http" and urlsplit(url).scheme == "https"):
        raise Refusal(f"the server redirects from {urlsplit(url).scheme} to {scheme}, which is not followed")
    return target_url


def _reason(error: BaseException) -> str:
    reason = getattr(error, "reason", None) or error
    return str(reason) or type(reason).__name__


def _refused(error: urllib.error.HTTPError) -> Exception:
    problem = _problem(error)
    if error.code in BUSY:
        wait = error.headers.get("retry-after", "")
        return Busy(problem or f"it answered {error.code}", min(float(wait) if wait.isdigit() else 0.0, MAX_WAIT_S))
    if error.code == 401:
        return Refusal("the server does not know this token (401); it may have been revoked. Create another")
    if error.code == 416:
        return RangeRefused("the range is not there")
    return Refusal(problem or f"the server answered {error.code}; is the address right?")


class RangeRefused(Refusal):
    """The part of a file that was asked for is not there."""


def _problem(error: urllib.error.HTTPError) -> str:
    """Return the server's words on a refusal, in one sentence; empty where it is not an answer of Soundlist."""
    try:
        document = json.loads(error.read(1 << 20))
        detail, fix = str(document["detail"]), document.get("fix")
    except (ValueError, KeyError, TypeError, *CUT):
        return ""
    return f"{detail}; {fix}" if fix else detail
