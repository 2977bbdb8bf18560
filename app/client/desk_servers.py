"""The servers of a person's desk, each with its token, in a file that only its owner reads."""

import json
import os
import stat
import tempfile
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from app.client.errors import Refusal
from app.client.settings import Source, ensure_token, safe_address

FILE_NAME = "desk.json"
FORMAT = 1
MAX_BYTES = 1 << 20
OF_OTHERS = stat.S_IRWXG | stat.S_IRWXO


@dataclass(frozen=True)
class DeskServer:
    """A server, by the name that its owner gave it."""

    name: str
    address: str
    token: str

    @property
    def source(self) -> Source:
        """Return the place to ask, and its token."""
        return Source(self.address, project="", target=None, token=self.token, named_by=self.name)


def file_path() -> Path:
    """Return the file path of the servers: the user's folder for settings."""
    if os.name == "nt":
        folder = os.environ.get("APPDATA") or str(Path.home() / "AppData" / "Roaming")
    else:
        folder = os.environ.get("XDG_CONFIG_HOME") or str(Path.home() / ".config")
    return Path(folder) / "soundlist" / FILE_NAME


def read_servers() -> dict[str, DeskServer]:
    """Return the servers by name; none where no file is there. Raise Refusal where the file is damaged or open."""
    path = file_path()
    try:
        with path.open("rb") as file:
            if os.name != "nt" and os.fstat(file.fileno()).st_mode & OF_OTHERS:
                raise Refusal(f"{path} holds tokens, and other users may read it; run: chmod 600 {path}")
            content = file.read(MAX_BYTES + 1)
    except FileNotFoundError:
        return {}
    try:
        document = json.loads(content)
        if document["format"] != FORMAT:
            raise Refusal(f"{path} has format {document['format']}, and this program reads {FORMAT}; use a newer one")
        servers = [_server(str(name), fields) for name, fields in document["servers"].items()]
    except (ValueError, KeyError, TypeError, AttributeError):
        raise Refusal(f"{path} is damaged; delete it, and add the servers again") from None
    return {server.name: server for server in servers}


def _server(name: str, fields: Mapping[str, str]) -> DeskServer:
    ensure_token(fields["token"], f"the token of {name}")
    return DeskServer(name, safe_address(fields["address"], allow_http=False), fields["token"])


def write_servers(servers: Mapping[str, DeskServer]) -> None:
    """Replace the file, which is never open to others, and never half written."""
    path = file_path()
    path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
    kept = {name: {"address": server.address, "token": server.token} for name, server in sorted(servers.items())}
    handle, beside = tempfile.mkstemp(prefix=f".{FILE_NAME}-", dir=path.parent)  # mode 0600
    try:
        with os.fdopen(handle, "w", encoding="utf-8") as file:
            json.dump({"format": FORMAT, "servers": kept}, file, indent=2)
            file.flush()
            os.fsync(file.fileno())
        Path(beside).replace(path)
    except BaseException:
        Path(beside).unlink(missing_ok=True)
        raise
