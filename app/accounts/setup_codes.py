"""The set-up code of an empty server: who opens its first account has read what `soundlist serve` printed."""

import base64
import hmac

from sqlalchemy.orm import Session

from app.accounts import queries
from app.accounts.errors import SetupCodeNeeded, SignUpClosed
from app.accounts.second_factors.rules import plain_code
from app.core.server_keys import derived
from app.settings import Settings

CODE_BYTES = 10  # 80 bits, in 16 characters of base32
GROUP_LENGTH = 4


def setup_code(settings: Settings) -> str:
    """Return the set-up code, which follows from the secret key and is stored nowhere."""
    text = base64.b32encode(derived(settings.secret_key.get_secret_value(), "set-up code", CODE_BYTES)).decode()
    return "-".join(text[start : start + GROUP_LENGTH] for start in range(0, len(text), GROUP_LENGTH))


def needs_setup_code(session: Session, settings: Settings) -> bool:
    """Whether the next account is the first one of a server that takes people by invitation only."""
    return settings.sign_up == "invited" and not settings.demo and not queries.has_people(session)


def ensure_sign_up_allowed(session: Session, settings: Settings, code: str) -> None:
    """Raise SignUpClosed where people come by invitation only, SetupCodeNeeded for a first person without the code."""
    if settings.sign_up == "open":
        return
    if queries.has_people(session):
        raise SignUpClosed(
            "sign-up on this server is by invitation only",
            fix="ask a studio for an invitation, or the operator of this server to set SOUNDLIST_SIGN_UP=open",
        )
    if not settings.demo:
        _ensure_right_code(settings, code)


def _ensure_right_code(settings: Settings, code: str) -> None:
    given, expected = plain_code(code), plain_code(setup_code(settings))
    if hmac.compare_digest(given, expected):
        return
    message = "this is not the set-up code of this server" if given else "the first account needs the set-up code"
    fix = (
        "enter the code that soundlist serve printed when it started, or make the account on the command line: "
        "soundlist accounts add ADDRESS"
    )
    raise SetupCodeNeeded(message, fix=fix, errors=[{"where": "setup_code", "message": f"{message}: {fix}"}])
