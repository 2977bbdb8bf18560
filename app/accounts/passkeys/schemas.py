"""Bodies and answers of passkeys."""

from datetime import datetime
from typing import Any
from uuid import UUID

from pydantic import Field

from app.accounts.schemas import Line
from app.core.web.http import Schema


class PasskeyOptions(Schema):
    """A browser's options to make or to ask for a passkey, as WebAuthn Level 3 writes them in JSON."""

    public_key: dict[str, Any] = Field(
        description="For `PublicKeyCredential.parseCreationOptionsFromJSON` or `parseRequestOptionsFromJSON`."
    )


class PasskeyAdd(Schema):
    """A passkey that a browser made, and what its owner calls it."""

    name: Line
    credential: dict[str, Any] = Field(description="`toJSON()` of what `navigator.credentials.create` returned.")


class PasskeySignIn(Schema):
    """The answer of a passkey."""

    credential: dict[str, Any] = Field(description="`toJSON()` of what `navigator.credentials.get` returned.")


class PasskeyRead(Schema):
    """One of the caller's passkeys."""

    id: UUID
    name: str
    created_at: datetime
    last_used_at: datetime | None = Field(description="When it last signed in; null: never.")


class PasskeyMade(PasskeyRead):
    """A new passkey, with recovery codes where it is the account's first second factor."""

    recovery_codes: list[str] = Field(description="Shown this once; empty where the account has some already.")
