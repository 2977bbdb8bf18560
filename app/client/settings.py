"""The server, project and target of a folder's pull: options first, then soundlist.toml, then the lock."""

import os
import re
import tomllib
from dataclasses import dataclass
from ipaddress import ip_address
from pathlib import Path
from urllib.parse import urlsplit

from app.client.errors import Refusal
from app.client.lock import Lock

FILE_NAME = "soundlist.toml"
TOKEN = "SOUNDLIST_TOKEN"  # noqa: S105 - the name of the variable
KEYS = ("server", "project", "target")
PROJECT_ID = re.compile(r"[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}")
MAX_BYTES = 1 << 16


@dataclass(frozen=True)
class Source:
    """The origin of a folder's sounds."""

    server: str
    project: str
    target: str | None  # None: the first of the spec
    token: str
    named_by: str  # what named the server


def read_source(
    folder: Path, lock: Lock | None, *, server: str | None, project: str | None, target: str | None, allow_http: bool
) -> Source:
    """Return the origin of a folder's sounds; raise Refusal where something is not known, or is not safe."""
    path, stored = _settings_file(folder)
    address = server or stored.get("server", "")
    project = (project or stored.get("project") or (lock.project if lock else "")).lower()
    target = target or stored.get("target") or (lock.target if lock else None)
    if not address or not project:
        lacking = " and ".join(name for name, value in (("server", address), ("project", project)) if not value)
        raise Refusal(
            f"which {lacking}? Give --server URL and --project ID, or a file {FILE_NAME} in {folder} or above it, "
            'with the lines server = "https://..." and project = "..."'
        )
    if not PROJECT_ID.fullmatch(project):
        raise Refusal(f'"{project}" is not an id of a project; the page Packs has the command with it')
    token = os.environ.get(TOKEN, "").strip()
    if not token:
        raise Refusal(f"{TOKEN} is not set; a producer creates a token on the project's page Builds")
    ensure_token(token, TOKEN)
    return Source(
        safe_address(address, allow_http=allow_http), project, target, token, "--server" if server else str(path)
    )


def ensure_fits(lock: Lock | None, source: Source) -> None:
    """Raise Refusal where a folder holds the sounds of another project or target."""
    if lock is None:
        return
    if lock.project != source.project:
        raise Refusal(
            f"this folder holds sounds of project {lock.project}, not of {source.project}; use another folder"
        )
    if source.target is not None and lock.target != source.target:
        raise Refusal(
            f'this folder holds the sounds for "{lock.target}", not for "{source.target}"; use another folder for each'
        )


def _settings_file(folder: Path) -> tuple[Path | None, dict[str, str]]:
    for parent in (folder.resolve(), *folder.resolve().parents):
        path = parent / FILE_NAME
        if path.is_file():
            return path, _read(path)
    return None, {}


def _read(path: Path) -> dict[str, str]:
    try:
        with path.open("rb") as file:
            stored = tomllib.loads(file.read(MAX_BYTES).decode())
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise Refusal(f"{path} cannot be read: {error}") from None
    for key, value in stored.items():
        if key not in KEYS or not isinstance(value, str):
            raise Refusal(f'{path}: "{key}" is none of the settings {", ".join(KEYS)}, each a text')
    return {key: value.strip() for key, value in stored.items()}


def ensure_token(token: str, named: str) -> None:
    """Raise Refusal for what cannot be a token; it is not printed."""
    if not token.isascii() or not token.isprintable() or " " in token:
        raise Refusal(f"{named} is not a token: it has a space or a character that no token has")


def safe_address(address: str, *, allow_http: bool) -> str:
    """Return the address of a server; raise Refusal where a token would cross the network unencrypted."""
    try:
        parts = urlsplit(address)
        host, port = parts.hostname or "", parts.port
    except ValueError:
        host, port = "", None
    if not host or parts.scheme not in ("https", "http") or parts.query or parts.fragment or parts.username:
        raise Refusal(f'"{address}" is not an address of a server; it looks like https://sounds.example')
    if parts.scheme == "http" and not allow_http and not is_loopback(host):
        raise Refusal(f"{address}: the token would cross the network unencrypted; use https, or give --allow-http")
    shown_host = f"[{host}]" if ":" in host else host
    return f"{parts.scheme}://{shown_host}{f':{port}' if port else ''}{parts.path.rstrip('/')}"


def is_loopback(host: str) -> bool:
    """Whether a host is this machine."""
    try:
        return ip_address(host).is_loopback
    except ValueError:
        return host == "localhost"
