"""Headers of every answer: what a page may load and do, and what caches may keep."""

from collections.abc import Mapping

from starlette.datastructures import MutableHeaders
from starlette.types import ASGIApp, Message, Receive, Scope, Send

PRIVATE = ("/v1/", "/healthz", "/readyz", "/metrics")  # never kept, unless an endpoint says for how long
HASHED = "/assets/"  # named after what is in them
IMMUTABLE = "public, max-age=31536000, immutable"
NO_STORE = "no-store"
ASK_AGAIN = "no-cache"
API = "/v1/"
# No page is drawn of what the API answers or of a script, and browsers read no policy of a page there. Sent with every
# answer, the page's own would be a tenth of what a first visit loads.
API_POLICY = "default-src 'none'; frame-ancestors 'none'"
ASSET_POLICY = "default-src 'self'; frame-ancestors 'none'"  # a worker is held to the policy of its script
OF_PAGES = ("content-security-policy", "cross-origin-opener-policy", "permissions-policy")
UNUSED = ("accelerometer", "camera", "display-capture", "geolocation", "gyroscope", "payment", "usb")
OWN = ("microphone",)  # placeholders are said into it


def content_security_policy(store_origin: str | None) -> str:
    """Return a page's permitted loads; from the store, if browsers are sent there, sounds and nothing else."""
    store = f" {store_origin}" if store_origin else ""
    return (
        f"default-src 'self'; script-src 'self'; connect-src 'self'{store}; img-src 'self' data: blob:; "
        f"media-src 'self' blob:{store}; style-src 'self' 'unsafe-inline'; object-src 'none'; frame-src 'none'; "
        "base-uri 'none'; frame-ancestors 'none'; form-action 'self'"
    )


def security_headers(store_origin: str | None, *, is_https: bool) -> dict[str, str]:
    """Return the headers of every answer, unless it says something stricter itself."""
    headers = {
        "Content-Security-Policy": content_security_policy(store_origin),
        "X-Content-Type-Options": "nosniff",
        "X-Frame-Options": "DENY",
        "Referrer-Policy": "same-origin",
        "Cross-Origin-Opener-Policy": "same-origin",
        "Cross-Origin-Resource-Policy": "same-origin",
        "Permissions-Policy": ", ".join(
            [f"{feature}=()" for feature in UNUSED] + [f"{feature}=(self)" for feature in OWN]
        ),
    }
    if is_https:
        headers["Strict-Transport-Security"] = "max-age=31536000"
    return headers


def policy_of(path: str) -> str | None:
    """Return the permitted loads of an answer that is no page; None for pages, which have a policy of their own."""
    if path.startswith(HASHED):
        return ASSET_POLICY
    return API_POLICY if path.startswith(API) else None


def caching(path: str, status: int) -> str:
    """Return caches' permissions for an answer that does not state them itself."""
    if path.startswith(PRIVATE) or status >= 400:
        return NO_STORE
    return IMMUTABLE if path.startswith(HASHED) else ASK_AGAIN


class WithResponseHeaders:
    """Adds them to every answer of an application."""

    def __init__(self, app: ASGIApp, headers: Mapping[str, str]) -> None:
        self._app = app
        self._of_pages = _encoded(headers)
        everywhere = {name: value for name, value in headers.items() if name.lower() not in OF_PAGES}
        self._of_policy = {
            policy: _encoded({"Content-Security-Policy": policy} | everywhere) for policy in (API_POLICY, ASSET_POLICY)
        }

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer, with the headers."""

        async def send_with_headers(message: Message) -> None:
            if message["type"] == "http.response.start":
                given = message.setdefault("headers", [])
                names = {name.lower() for name, _ in given}
                policy = policy_of(scope["path"])
                headers = self._of_pages if policy is None else self._of_policy[policy]
                message["headers"] = [*given, *(header for header in headers if header[0] not in names)]
                if b"cache-control" not in names:
                    MutableHeaders(scope=message)["Cache-Control"] = caching(scope["path"], message["status"])
            await send(message)

        await self._app(scope, receive, send_with_headers)


def _encoded(headers: Mapping[str, str]) -> list[tuple[bytes, bytes]]:
    return [(name.lower().encode(), value.encode()) for name, value in headers.items()]
