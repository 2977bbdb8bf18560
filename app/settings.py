"""What an operator sets: environment variables named SOUNDLIST_…, checked at start with words."""

from functools import cached_property
from pathlib import Path
from urllib.parse import urlsplit

from pydantic import Field, SecretStr, field_validator
from pydantic_settings import BaseSettings, SettingsConfigDict


class Settings(BaseSettings):
    """Every knob of the server, with the embedded default in place of each."""

    model_config = SettingsConfigDict(env_prefix="SOUNDLIST_", extra="ignore")

    data_dir: Path = Field(Path("data"), description="Folder of the embedded database, masters, renders and uploads.")
    database_url: str = Field("", description="SQLAlchemy URL; empty means SQLite inside data_dir.")
    store_url: str = Field("", description="Where masters and renders live; empty means a folder inside data_dir.")
    smtp_url: str = Field("", description="smtp://user:password@host:port; empty keeps mails in the outbox.")
    mail_from: str = "Soundlist <soundlist@localhost>"
    digest_delay_s: float = Field(60.0, ge=0, description="How long a mail waits for more news of its kind.")
    base_url: str = "http://127.0.0.1:8000"
    secret_key: SecretStr = SecretStr("")
    demo: bool = Field(False, description="Only `soundlist demo` sets this: the demo studio needs no sign-in.")
    worker_id: str = Field("worker-1", description="One id per worker process; two processes never share one.")
    worker_jobs: int = Field(2, ge=1, le=64, description="Jobs that one worker process runs at once.")
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

    @field_validator("store_url")
    @classmethod
    def _is_a_store_we_have(cls, value: str) -> str:
        if value and not value.startswith("file:///"):
            raise ValueError(
                f"SOUNDLIST_STORE_URL is {value!r}; this version stores in a folder: file:///absolute/path"
            )
        return value

    @cached_property
    def resolved_database_url(self) -> str:
        """The database in use: the one set, or SQLite in the data folder."""
        return self.database_url or f"sqlite:///{(self.data_dir / 'soundlist.sqlite').resolve()}"

    @cached_property
    def blob_dir(self) -> Path:
        """The folder that holds masters and everything derived from them."""
        return Path(urlsplit(self.store_url).path) if self.store_url else self.data_dir / "blobs"

    @property
    def is_https(self) -> bool:
        """Whether people reach us over TLS, so cookies can demand it."""
        return self.base_url.startswith("https://")
