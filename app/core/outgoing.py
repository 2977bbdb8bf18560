"""Requests to addresses that people typed: to public ones only, bounded in time and bytes, and never redirected."""

import asyncio
import ipaddress
import socket
import ssl
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from urllib.parse import urlsplit

import httpx

TIMEOUT_S = 10.0  # of the whole request: name, connection, answer
KEPT_BYTES = 1_000  # of the answer, where the caller needs no more
DOCUMENT_BYTES = 256_000  # of a document that is read whole
MAX_URL_CHARS = 2_000
LOCALHOST = frozenset({"localhost", "127.0.0.1", "::1"})
# Networks of IPv6 that lead to addresses of IPv4: NAT64, 6to4, Teredo, and IPv4-compatible ones.
CARRIERS = tuple(
    ipaddress.ip_network(network) for network in ("64:ff9b::/96", "64:ff9b:1::/48", "2002::/16", "2001::/32", "::/96")
)

Resolver = Callable[[str, int], Sequence[str]]


class AddressRefused(Exception):
    """The address is none that this server sends to; the message says why."""


class RequestFailed(Exception):
    """No answer came: the name is unknown, nothing listens, the certificate is wrong, or it took too long."""


@dataclass(frozen=True)
class Answer:
    """The status of an answer, and the beginning of its body as text."""

    status: int
    beginning: str


def ensure_address(url: str, *, may_be_localhost: bool = False) -> None:
    """Raise AddressRefused unless a URL is an https address without a password, of a host that may be public.

    `may_be_localhost` admits http to this machine too, for trying things out.
    """
    try:
        parts = urlsplit(url)
        host, _port = parts.hostname or "", parts.port
    except ValueError:
        raise AddressRefused("this is not an address") from None
    if len(url) > MAX_URL_CHARS or not url.isascii() or not url.isprintable() or " " in url or "\\" in url:
        raise AddressRefused(f"an address has at most {MAX_URL_CHARS:,} characters of ASCII, and no spaces")
    if "@" in parts.netloc:
        raise AddressRefused("an address with a name or password in it is not kept; remove what stands before the @")
    if may_be_localhost and host in LOCALHOST and parts.scheme in ("http", "https"):
        return
    if parts.scheme != "https" or not host:
        raise AddressRefused("the address must begin with https://")
    if host == "localhost" or host.endswith(".localhost"):
        raise AddressRefused("the address is this server itself")
    try:
        ipaddress.ip_address(host)
    except ValueError:
        return  # a name, which is looked up when something is sent
    if not is_public(host):
        raise AddressRefused(f"{host} is not a public address")


def is_public(address: str) -> bool:
    """Whether an IP address is reachable from anywhere, and does not embed an IPv4 address."""
    ip = ipaddress.ip_address(address)
    if isinstance(ip, ipaddress.IPv6Address) and (
        ip.scope_id or ip.ipv4_mapped or any(ip in network for network in CARRIERS)
    ):
        return False
    return ip.is_global and not (ip.is_multicast or ip.is_reserved or ip.is_unspecified)


def resolve(host: str, port: int) -> list[str]:
    """Return the IP addresses of a host, in the order to try them; raise OSError where it has none."""
    addresses = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)
    return list(dict.fromkeys(str(address[0]) for *_, address in addresses))


def post(
    url: str,
    body: bytes,
    headers: Mapping[str, str],
    *,
    max_bytes: int = KEPT_BYTES,
    resolver: Resolver = resolve,
    may_be_localhost: bool = False,
    trusted: ssl.SSLContext | None = None,
) -> Answer:
    """Send a body to an address and return the answer; raise AddressRefused or RequestFailed.

    The connection goes to the IP address that was looked up and found public, so that a name cannot lead elsewhere a
    moment later. The certificate must be the host's.
    """
    return _request("POST", url, body, headers, max_bytes, resolver, may_be_localhost, trusted)


def get(
    url: str,
    headers: Mapping[str, str],
    *,
    max_bytes: int = DOCUMENT_BYTES,
    resolver: Resolver = resolve,
    may_be_localhost: bool = False,
    trusted: ssl.SSLContext | None = None,
) -> Answer:
    """Fetch an address as `post` sends to one, and return the answer; raise AddressRefused or RequestFailed."""
    return _request("GET", url, None, headers, max_bytes, resolver, may_be_localhost, trusted)


def _request(
    method: str,
    url: str,
    body: bytes | None,
    headers: Mapping[str, str],
    max_bytes: int,
    resolver: Resolver,
    may_be_localhost: bool,
    trusted: ssl.SSLContext | None,
) -> Answer:
    ensure_address(url, may_be_localhost=may_be_localhost)
    try:
        return asyncio.run(_request_in_time(method, url, body, headers, max_bytes, resolver, may_be_localhost, trusted))
    except TimeoutError:
        raise RequestFailed(f"no answer within {TIMEOUT_S:g} s") from None
    except (httpx.HTTPError, httpx.InvalidURL, OSError, UnicodeError) as error:
        raise RequestFailed(str(error) or type(error).__name__) from None


async def _request_in_time(
    method: str,
    url: str,
    body: bytes | None,
    headers: Mapping[str, str],
    max_bytes: int,
    resolver: Resolver,
    may_be_localhost: bool,
    trusted: ssl.SSLContext | None,
) -> Answer:
    async with asyncio.timeout(TIMEOUT_S):
        target = httpx.URL(url)
        port = target.port or (443 if target.scheme == "https" else 80)
        is_local = may_be_localhost and target.host in LOCALHOST
        addresses = await _addresses_of(resolver, target.host, port, is_local=is_local)
        context = trusted or httpx.create_ssl_context(trust_env=False)
        async with httpx.AsyncClient(verify=context, trust_env=False, timeout=None) as client:  # noqa: S113  bounded above
            for last, address in enumerate(addresses, start=1):
                request = client.build_request(
                    method,
                    target.copy_with(host=address),
                    content=body,
                    headers={**headers, "Host": target.netloc.decode(), "Accept-Encoding": "identity"},
                    extensions={"sni_hostname": target.host},
                )
                try:
                    return await _answer(client, request, max_bytes)
                except httpx.ConnectError:
                    if last == len(addresses):
                        raise
        raise AssertionError("there is an address")


async def _addresses_of(resolver: Resolver, host: str, port: int, *, is_local: bool) -> Sequence[str]:
    """Return the addresses of a host; raise AddressRefused unless it has some, all public.

    The words are the same for a name that is unknown and for one that leads inside: they are shown to people outside.
    """
    try:
        addresses = await asyncio.to_thread(resolver, host, port)
    except (OSError, UnicodeError):
        addresses = []
    is_allowed = [
        ipaddress.ip_address(address).is_loopback if is_local else is_public(address) for address in addresses
    ]
    if not is_allowed or not all(is_allowed):
        raise AddressRefused(f"{host} has no public address")
    return addresses


async def _answer(client: httpx.AsyncClient, request: httpx.Request, max_bytes: int) -> Answer:
    response = await client.send(request, stream=True, follow_redirects=False)
    kept = bytearray()
    try:
        async for chunk in response.aiter_raw():
            kept += chunk
            if len(kept) >= max_bytes:
                break
    finally:
        await response.aclose()
    return Answer(response.status_code, kept[:max_bytes].decode("utf-8", "replace").replace("\x00", "�"))
