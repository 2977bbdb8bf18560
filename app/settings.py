"""Settings of an operator: environment variables named SOUNDLIST_…, checked at start with clear messages."""

import difflib
import os
import re
from dataclasses import dataclass
from functools import cached_property
from ipaddress import ip_network
from pathlib import Path
from typing import Annotated, Literal, Self
from urllib.parse import parse_qsl, urlsplit

from pydantic import Field, SecretStr, ValidationError, field_validator, model_validator
from pydantic_settings import BaseSettings, NoDecode, SettingsConfigDict
from sqlalchemy.engine import make_url

PREFIX = "SOUNDLIST_"
# Names that are read elsewhere: by the lines for a game's CI, and by the tests that kill processes.
NOT_SETTINGS = frozenset({"SOUNDLIST_TOKEN", "SOUNDLIST_KILL_AT", "SOUNDLIST_KILL_MARKER", "SOUNDLIST_KILL_PID"})
SECRET_KEY_LENGTH = 16


class SettingsWrong(Exception):
    """Settings that cannot be used: each line says what was found, what was wanted and how to fix it."""

    def __init__(self, lines: list[str]) -> None:
        super().__init__("\n".join(lines))
        self.lines = lines


@dataclass(frozen=True)
class BucketAddress:
    """A part of a bucket, and where its server is: as this process reaches it, and as browsers do."""

    bucket: str
    prefix: str
    region: str
    endpoint: str
    public_endpoint: str


class Settings(BaseSettings):
    """Every knob of the server, with the embedded default in place of each."""

    model_config = SettingsConfigDict(env_prefix="SOUNDLIST_", extra="ignore", validate_by_name=True)

    data_dir: Path = Field(Path("data"), description="Folder of the embedded database, masters, renders and uploads.")
    database_url: str = Field("", description="SQLAlchemy URL; empty means SQLite inside data_dir.")
    store_url: str = Field(
        "",
        description="Where masters and renders live: file:///folder or s3://bucket/prefix?endpoint=…&region=…; "
        "empty means a folder inside data_dir.",
    )
    store_direct: bool = Field(
        False, description="Let browsers send to and fetch from the bucket by signed links; its CORS rules must agree."
    )
    database_connections: int = Field(
        16,
        ge=16,
        le=1_000,
        description="Connections to PostgreSQL that one web process or worker has at most.",
    )
    aws_access_key_id: str = Field("", validation_alias="AWS_ACCESS_KEY_ID", description="For a store on S3.")
    aws_secret_access_key: SecretStr = Field(
        SecretStr(""), validation_alias="AWS_SECRET_ACCESS_KEY", description="For a store on S3."
    )
    aws_session_token: SecretStr = Field(
        SecretStr(""), validation_alias="AWS_SESSION_TOKEN", description="For a store on S3 by temporary keys."
    )
    smtp_url: str = Field("", description="smtp://user:password@host:port; empty keeps mails in the outbox.")
    mail_from: str = "Soundlist <soundlist@localhost>"
    digest_delay_s: float = Field(60.0, ge=0, description="How long a mail waits for more news of its kind.")
    base_url: str = "http://127.0.0.1:8000"
    secret_key: SecretStr = SecretStr("")
    demo: bool = Field(False, description="Only `soundlist demo` sets this: the demo studio needs no sign-in.")
    worker_silent_s: float = Field(
        15.0, ge=1, le=18, description="How long a worker is silent before others take its jobs over."
    )
    drain_s: float = Field(
        0.0, ge=0, le=60, description="How long a stopping web process goes on, so that proxies stop sending to it."
    )
    web_processes: int = Field(1, ge=1, le=64, description="Processes that `soundlist serve` answers by.")
    worker_jobs: int = Field(4, ge=1, le=64, description="Jobs that one worker process runs at once.")
    seal_certificate: Path | None = Field(
        None, description="PEM file of the certificate that seals contracts, with its chain; empty: one of our own."
    )
    seal_key: Path | None = Field(None, description="PEM file of that certificate's private key.")
    timestamp_url: str = Field("", description="An RFC 3161 timestamp server for seals; empty seals without one.")
    webhook_localhost: bool = Field(
        False,
        description="Let webhooks and sign-in providers be at http://localhost and https://localhost, to try them out.",
    )
    sign_up: Literal["open", "invited"] = Field(
        "invited", description="Whether anyone may open an account and a studio, or only invited people."
    )
    commercial: bool = Field(
        True, description="Whether this server has contracts, money and hiring; no: their pages, API and jobs are gone."
    )
    studios_per_account: int = Field(
        10, ge=1, le=100_000, description="How many studios one account may open; each has quotas of its own."
    )
    trusted_proxies: Annotated[tuple[str, ...], NoDecode] = Field(
        (), description="Networks, with commas between, of proxies whose X-Forwarded-For says who visits."
    )
    disk_reserve: int = Field(
        1 << 30, ge=0, description="Bytes of the disk that uploads leave free, for the database and for what is made."
    )
    reference_max_bytes: int = Field(
        2 << 30, ge=1, description="Bytes that one file of a reference may have: a picture, a clip, a document."
    )
    upload_min_rate: int = Field(
        1 << 10, ge=0, description="Bytes a second that an upload sends at least, on average over each window."
    )
    upload_window_s: float = Field(60.0, gt=0, description="The window of that average.")
    metrics_token: SecretStr = Field(SecretStr(""), description="The bearer token that Prometheus sends to /metrics.")
    metrics_port: int | None = Field(None, ge=1, le=65_535, description="A separate port for /metrics.")
    metrics_host: str = Field("127.0.0.1", description="The address that the port for /metrics listens on.")
    log_level: Literal["DEBUG", "INFO", "WARNING", "ERROR"] = "INFO"
    frontend_dir: Path = Path(__file__).resolve().parent.parent / "frontend" / "dist"

    @field_validator("base_url")
    @classmethod
    def _is_an_address(cls, value: str) -> str:
        parts = urlsplit(value)
        if parts.scheme not in ("http", "https") or not parts.netloc:
            raise ValueError(
                f"SOUNDLIST_BASE_URL is {value!r}; give the address people open, as https://sounds.example"
            )
        return value.rstrip("/")

    @field_validator("smtp_url")
    @classmethod
    def _is_an_smtp_server(cls, value: str) -> str:
        parts = urlsplit(value)
        if value and (parts.scheme not in ("smtp", "smtps") or not parts.hostname):
            raise ValueError(
                f"SOUNDLIST_SMTP_URL begins with {parts.scheme or 'nothing'}:// and names the host "
                f"{parts.hostname or 'nothing'}; write smtp://user:password@host:587 or smtps://user:password@host:465"
            )
        return value

    @field_validator("database_url")
    @classmethod
    def _is_a_database_we_know(cls, value: str) -> str:
        kind = value.partition("://")[0].partition("+")[0]
        if value and kind not in ("sqlite", "postgresql", "postgres"):
            raise ValueError(
                f"SOUNDLIST_DATABASE_URL begins with {kind}://; write postgresql://user:password@host/name, "
                "or leave it out for SQLite in SOUNDLIST_DATA_DIR"
            )
        return value

    @field_validator("trusted_proxies", mode="before")
    @classmethod
    def _are_networks(cls, value: object) -> object:
        if not isinstance(value, str):
            return value
        networks = [part.strip() for part in value.split(",") if part.strip()]
        for network in networks:
            try:
                ip_network(network)
            except ValueError as error:
                raise ValueError(
                    f"SOUNDLIST_TRUSTED_PROXIES holds {network!r} ({error}); write networks such as "
                    "10.0.0.0/24,192.0.2.7,fd00::/64"
                ) from None
        return tuple(networks)

    @field_validator("store_url")
    @classmethod
    def _is_a_store_we_have(cls, value: str) -> str:
        if value.startswith("s3://"):
            bucket_address(value)
        elif value and not value.startswith("file:///"):
            kind = value.partition("://")[0]
            raise ValueError(
                f"SOUNDLIST_STORE_URL begins with {kind}://; write file:///absolute/folder or "
                "s3://bucket/prefix?endpoint=https://s3.example&region=eu-central-1"
            )
        return value

    @model_validator(mode="after")
    def _has_keys_for_its_bucket(self) -> Self:
        if self.bucket and not (self.aws_access_key_id and self.aws_secret_access_key.get_secret_value()):
            raise ValueError(
                "SOUNDLIST_STORE_URL names a bucket, and AWS_ACCESS_KEY_ID or AWS_SECRET_ACCESS_KEY is not set; "
                "set both to a key that may read, write, list and delete there"
            )
        return self

    @field_validator("timestamp_url")
    @classmethod
    def _is_a_web_address(cls, value: str) -> str:
        parts = urlsplit(value)
        if value and (parts.scheme not in ("http", "https") or not parts.netloc):
            raise ValueError(f"SOUNDLIST_TIMESTAMP_URL is {value!r}; give an address, as https://timestamps.example")
        return value

    @model_validator(mode="after")
    def _has_key_and_certificate(self) -> Self:
        if (self.seal_key is None) != (self.seal_certificate is None):
            raise ValueError(
                "one of SOUNDLIST_SEAL_CERTIFICATE and SOUNDLIST_SEAL_KEY is set; set both, to PEM files, or neither"
            )
        return self

    @model_validator(mode="after")
    def _has_metrics_per_process(self) -> Self:
        if self.web_processes > 1 and self.metrics_token.get_secret_value() and self.metrics_port is None:
            raise ValueError(
                f"SOUNDLIST_WEB_PROCESSES is {self.web_processes}, and a request for /metrics on one port reaches any "
                "of them; set SOUNDLIST_METRICS_PORT to the first of as many ports that are free"
            )
        return self

    @model_validator(mode="after")
    def _has_connections_for_its_jobs(self) -> Self:
        needed = 2 * self.worker_jobs + 8  # one each to work on, one each to write its progress, and the worker's own
        if needed > self.database_connections and self.resolved_database_url.startswith("postgres"):
            raise ValueError(
                f"SOUNDLIST_WORKER_JOBS is {self.worker_jobs}, and so many jobs at once need {needed} connections; "
                f"SOUNDLIST_DATABASE_CONNECTIONS is {self.database_connections}: raise it, or run more workers instead"
            )
        return self

    @cached_property
    def bucket(self) -> BucketAddress | None:
        """The bucket that is the store, if one is."""
        return bucket_address(self.store_url) if self.store_url.startswith("s3://") else None

    @cached_property
    def resolved_database_url(self) -> str:
        """The database in use: the one set, or SQLite in the data folder."""
        return self.database_url or f"sqlite:///{(self.data_dir / 'soundlist.sqlite').resolve()}"

    @cached_property
    def blob_dir(self) -> Path:
        """The folder that holds masters and everything derived from them."""
        return Path(urlsplit(self.store_url).path) if self.store_url else self.data_dir / "blobs"

    @property
    def private_paths(self) -> list[Path]:
        """Return the folders and files of this server that no other user may read; some may not exist."""
        paths = [self.data_dir, self.data_dir / "secret_key"]
        if not self.database_url or self.database_url.startswith("sqlite"):
            database = Path(make_url(self.resolved_database_url).database or "")
            paths += [database, *(database.with_name(database.name + end) for end in ("-wal", "-shm"))]
        if self.bucket is None:
            paths.append(self.blob_dir)
        return paths

    @property
    def is_https(self) -> bool:
        """Whether people reach us over TLS, so cookies can demand it."""
        return self.base_url.startswith("https://")


def bucket_address(url: str) -> BucketAddress:
    """Read s3://bucket/prefix?endpoint=…&region=…&public_endpoint=…; raise ValueError in words."""
    parts = urlsplit(url)
    given = dict(parse_qsl(parts.query, keep_blank_values=True))
    if parts.username or parts.password:
        raise ValueError("SOUNDLIST_STORE_URL holds a key; take it out, and set AWS_ACCESS_KEY_ID and its secret")
    if not re.fullmatch(r"[a-z0-9][a-z0-9.-]{1,61}[a-z0-9]", parts.netloc):
        raise ValueError(f"SOUNDLIST_STORE_URL names the bucket {parts.netloc!r}; write s3://bucket/prefix")
    if not re.fullmatch(r"[A-Za-z0-9._/-]*", parts.path):
        raise ValueError(f"SOUNDLIST_STORE_URL has the prefix {parts.path!r}; use letters, digits, dots, - and / only")
    if unknown := sorted(given.keys() - {"endpoint", "region", "public_endpoint"}):
        raise ValueError(f"SOUNDLIST_STORE_URL has {unknown[0]}=; it may have endpoint=, region= and public_endpoint=")
    region = given.get("region") or os.environ.get("AWS_REGION") or "us-east-1"
    endpoint = given.get("endpoint") or os.environ.get("AWS_ENDPOINT_URL") or f"https://s3.{region}.amazonaws.com"
    public_endpoint = given.get("public_endpoint") or endpoint
    for name, address in (("endpoint", endpoint), ("public_endpoint", public_endpoint)):
        if not re.fullmatch(r"https?://[^/?#@]+/?", address):
            raise ValueError(f"SOUNDLIST_STORE_URL has {name}={address}; write {name}=https://s3.example")
    return BucketAddress(parts.netloc, parts.path.strip("/"), region, endpoint.rstrip("/"), public_endpoint.rstrip("/"))


def read_settings(*, serving: bool = False) -> Settings:
    """Return the settings of the environment; raise SettingsWrong with everything that is wrong, at once."""
    lines = _unknown_names()
    try:
        settings = Settings()
    except ValidationError as error:
        raise SettingsWrong([*lines, *(_in_words(wrong["loc"], wrong["msg"]) for wrong in error.errors())]) from None
    secret = settings.secret_key.get_secret_value()
    if serving and len(secret) < SECRET_KEY_LENGTH:
        fault = (
            f"has {len(secret)} character{'' if len(secret) == 1 else 's'}; {SECRET_KEY_LENGTH} or more are wanted"
            if secret
            else "is not set"
        )
        lines.append(f"SOUNDLIST_SECRET_KEY {fault}. Make one with: openssl rand -hex 32")
    if lines:
        raise SettingsWrong(lines)
    return settings


def _unknown_names() -> list[str]:
    setting_names = {name.upper() for name in Settings.model_fields}
    lines = []
    for name in sorted(os.environ.keys() - NOT_SETTINGS):
        bare = name.removeprefix(PREFIX)
        if bare != name and bare not in setting_names:
            near = difflib.get_close_matches(bare, setting_names, n=1, cutoff=0.7)
            hint = f"is it {PREFIX}{near[0]}?" if near else "docs/reference/settings.md lists them"
            lines.append(f"{name} is not a setting; {hint}")
    return lines


def _in_words(keys: tuple[int | str, ...], message: str) -> str:
    name = PREFIX + "_".join(str(part) for part in keys).upper()
    text = message.removeprefix("Value error, ")
    return text if PREFIX in text else f"{name}: {text}"
