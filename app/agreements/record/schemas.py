"""Answers about a file that may be a sealed contract."""

from datetime import datetime
from typing import Literal

from pydantic import Field

from app.agreements.rules import ContractKind, Party
from app.core.web.http import Schema


class BoundSignatureRead(Schema):
    """A signature under a sealed text."""

    party: Party
    name: str
    signed_at: datetime


class BoundRead(Schema):
    """A sealed file's text, and those bound by it."""

    title: str
    kind: ContractKind
    version: int
    text_sha256: str
    studio_name: str
    designer_name: str
    agreed_at: datetime | None
    sealed_at: datetime
    is_timestamped: bool
    signatures: list[BoundSignatureRead]


class VerifiedRead(Schema):
    """The verdict on a file, compared with the seals of this server."""

    verdict: Literal["untouched", "changed", "not_ours"]
    file_sha256: str
    binds: BoundRead | None = Field(description="What it binds; null unless it is untouched.")
