"""Bodies and answers of second factors."""

from datetime import datetime
from typing import Annotated

from pydantic import Field, StringConstraints

from app.accounts.rules import SecondFactorUse
from app.core.web.http import Schema

Code = Annotated[str, StringConstraints(strip_whitespace=True, max_length=40)]


class SecondFactorsRead(Schema):
    """The second factors of the caller's account."""

    totp_since: datetime | None = Field(description="Since when an authenticator app is asked; null: none is set up.")
    recovery_codes_left: int = Field(description="Each signs in once in place of the authenticator app.")


class SecondFactorRequirement(Schema):
    """The uses for which a studio requires a second factor."""

    required_for: list[SecondFactorUse] = Field(
        max_length=len(SecondFactorUse),
        description="`signing`: signing its contracts, change orders and statements, by either party. `paying`: "
        "recording payments and refunds, agreeing to the price of a round, saying that the game has shipped. "
        "`everything`: all that its members do, and both of these.",
    )


class TotpSetupRead(Schema):
    """The secret of an authenticator app; it is shown until the app's first code confirms it."""

    secret: str = Field(description="In base32, to be typed where no QR code can be read.")
    uri: str = Field(description="Of the scheme otpauth.")
    qr_svg: str = Field(description="The same as a QR code, an SVG document.")


class TotpConfirm(Schema):
    """The first code of an authenticator app."""

    code: Code = Field(min_length=1)


class RecoveryCodesMade(Schema):
    """Recovery codes, which are shown this once."""

    recovery_codes: list[str]
