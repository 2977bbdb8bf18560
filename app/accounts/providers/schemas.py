"""Bodies and answers of sign-in providers."""

from typing import Annotated
from uuid import UUID

from pydantic import Field, StringConstraints

from app.accounts.providers.rules import MAX_URL_CHARS
from app.accounts.schemas import Line
from app.core.web.http import Schema

_TOKEN_CHARS = 4_000
Url = Annotated[str, StringConstraints(strip_whitespace=True, min_length=1, max_length=MAX_URL_CHARS)]
AnswerText = Annotated[str, StringConstraints(min_length=1, max_length=_TOKEN_CHARS)]


class ProviderSave(Schema):
    """The OpenID Connect provider by which the people of a studio sign in."""

    issuer: Url = Field(examples=["https://login.studio.example"], description="Exactly as the provider writes it.")
    client_id: Line
    client_secret: Annotated[str, StringConstraints(min_length=1, max_length=500)] = Field(
        description="Kept encrypted and never shown."
    )


class ProviderRead(Schema):
    """The sign-in provider of a studio, without its client secret."""

    issuer: str | None = Field(description="Null: the studio has no provider.")
    client_id: str | None
    domains: list[str] = Field(description="Whose addresses sign in by it; bound by the operator of the server.")
    redirect_uri: str = Field(description="The address to enter at the provider.")


class ProviderOfDomain(Schema):
    """Whether a domain's people sign in by the provider of a studio."""

    studio_id: UUID | None = Field(description="Null: they do not.")
    studio_name: str | None


class ProviderSignInStart(Schema):
    """Whose provider to sign in by, and the page to go on to."""

    studio_id: UUID
    next_path: str = Field("/", max_length=MAX_URL_CHARS, description="A path of this site.")


class ProviderRedirect(Schema):
    """The provider's page to open."""

    url: str


class ProviderAnswer(Schema):
    """The content of the provider's redirect."""

    code: AnswerText
    state: AnswerText
    iss: AnswerText | None = Field(None, description="The issuer (RFC 9207), where the provider names it.")


class ProviderCode(Schema):
    """The code of the person's own second factor."""

    code: str = Field(max_length=100)


class ProviderSignInDone(Schema):
    """The page to go on to, signed in; or that a code is asked for first."""

    second_factor_needed: bool
    next_path: str
