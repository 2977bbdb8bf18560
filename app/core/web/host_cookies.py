"""Cookies that are bound to this host by their name, where people reach us over TLS.

Browsers take a cookie whose name begins with `__Host-` only from the host itself, over TLS, for every path: neither a
neighbour's subdomain nor anyone on the way can set one. The application reads and sets cookies by their plain names.
"""

import re

from starlette.datastructures import Headers, MutableHeaders
from starlette.types import ASGIApp, Message, Receive, Scope, Send

PREFIX = "__Host-"
OWN = re.compile(rf"^(?:{PREFIX})?(?=soundlist_)")


class HostCookies:
    """Gives our cookies the prefix on their way out; what comes back without it was set by someone else."""

    def __init__(self, app: ASGIApp) -> None:
        self._app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer, with our cookies under the names that browsers hold to this host."""
        if scope["type"] != "http":
            await self._app(scope, receive, send)
            return

        async def send_bound(message: Message) -> None:
            if message["type"] == "http.response.start":
                headers = MutableHeaders(scope=message)
                given = headers.getlist("set-cookie")
                del headers["set-cookie"]
                for cookie in given:
                    headers.append("set-cookie", bound(cookie))
            await send(message)

        headers = [(name, value) for name, value in scope["headers"] if name != b"cookie"]
        kept = "; ".join(map(unbound, Headers(scope=scope).getlist("cookie")))
        if kept:
            headers.append((b"cookie", kept.encode("latin-1")))
        await self._app({**scope, "headers": headers}, receive, send_bound)


def bound(cookie: str) -> str:
    """Return a Set-Cookie value with its name bound to the host."""
    if not OWN.match(cookie):
        return cookie
    is_secure = any(part.strip().lower() == "secure" for part in cookie.split(";"))
    return OWN.sub(PREFIX, cookie, count=1) + ("" if is_secure else "; Secure")


def unbound(cookies: str) -> str:
    """Return a Cookie value with the names that the application knows, without those that browsers did not hold to."""
    kept = []
    for cookie in (part.strip() for part in cookies.split(";")):
        if cookie.startswith(f"{PREFIX}soundlist_"):
            kept.append(cookie.removeprefix(PREFIX))
        elif not cookie.startswith("soundlist_"):
            kept.append(cookie)
    return "; ".join(part for part in kept if part)
