"""Codes of authenticator apps (TOTP, RFC 6238) and recovery codes, as plain functions."""

import base64
import hmac
import io
import secrets
from datetime import datetime

ISSUER = "Soundlist"
STEP_S = 30
DRIFT_STEPS = 1  # a clock may be half a minute off, and typing takes time (RFC 6238, 5.2)
RECOVERY_CODES = 10
RECOVERY_CODE_BYTES = 10  # 80 bits, so that their hashes cannot be searched
RECOVERY_CODE_LENGTH = 16
GROUP_LENGTH = 4


def new_totp_secret() -> str:
    """Return a secret of 160 bits in base32, as authenticator apps take it."""
    import pyotp

    return pyotp.random_base32()


def provisioning_uri(secret: str, address: str) -> str:
    """Return the address from which an authenticator app reads a secret and whose it is."""
    import pyotp

    return pyotp.TOTP(secret, interval=STEP_S).provisioning_uri(name=address, issuer_name=ISSUER)


def qr_code_svg(text: str) -> str:
    """Return a QR code as an SVG document, dark on light whatever the page's colours."""
    import segno

    picture = io.BytesIO()
    segno.make(text, error="m").save(
        picture, kind="svg", xmldecl=False, scale=4, border=4, dark="#000", light="#fff", omitsize=True
    )
    return picture.getvalue().decode()


def accepted_step(secret: str, code: str, at: datetime, *, last_step: int) -> int | None:
    """Return the time step of a right code that is newer than the last one used; None for any other code."""
    import pyotp

    totp = pyotp.TOTP(secret, interval=STEP_S)
    present_step = int(at.timestamp()) // STEP_S
    for step in range(present_step - DRIFT_STEPS, present_step + DRIFT_STEPS + 1):
        if step > last_step and hmac.compare_digest(totp.generate_otp(step).encode(), code.encode()):
            return step
    return None


def plain_code(code: str) -> str:
    """Return a code as it is compared: without spaces and hyphens, in capitals."""
    return "".join(character for character in code.upper() if character.isascii() and character.isalnum())


def is_recovery_code(code: str) -> bool:
    """Whether a plain code has the length of a recovery code."""
    return len(code) == RECOVERY_CODE_LENGTH


def new_recovery_codes() -> list[str]:
    """Return fresh recovery codes in groups of four characters."""
    return [_new_recovery_code() for _ in range(RECOVERY_CODES)]


def _new_recovery_code() -> str:
    text = base64.b32encode(secrets.token_bytes(RECOVERY_CODE_BYTES)).decode()
    return "-".join(text[start : start + GROUP_LENGTH] for start in range(0, len(text), GROUP_LENGTH))
