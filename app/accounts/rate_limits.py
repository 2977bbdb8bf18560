"""Limits on repeated tries: guesses at passwords, mails sent to strangers. All processes count together.

Each limit is a bucket (GCRA): so many tries at once, then one in each interval. A try that is refused costs nothing,
so waiting always helps. Guesses at one account from one place are held tighter than guesses at it from
everywhere, so that one attacker uses up neither; a browser that has signed in to the account before has
a separate bucket (`authentication.device_for`).
"""

import hashlib
import time
from dataclasses import dataclass
from functools import cache
from math import ceil
from typing import Any

import sqlalchemy as sa
from sqlalchemy.dialects import postgresql, sqlite
from sqlalchemy.orm import Session

from app.accounts.errors import TooManyAttempts
from app.accounts.models import RateLimit


@dataclass(frozen=True)
class Limit:
    """A limit: `burst` tries at once, then one every `interval_s`."""

    name: str
    burst: int
    interval_s: float


SIGN_INS_FROM_DEVICE = Limit("guesses at an account from a browser that signed in to it", 10, 60)
SIGN_INS_TO_ACCOUNT_FROM_NETWORK = Limit("guesses at an account from one place", 10, 60)
SIGN_INS_TO_ACCOUNT = Limit("guesses at an account", 50, 30)
SIGN_INS_FROM_NETWORK = Limit("guesses from one place", 100, 5)
PROVIDER_LOOKUPS_FROM_NETWORK = Limit("look-ups of a sign-in provider from one place", 100, 2)
SECOND_FACTORS_OF_ACCOUNT = Limit("guesses at an account's second factor", 10, 300)
SIGN_UPS_FROM_NETWORK = Limit("sign-ups from one place", 30, 120)
MAILS_TO_ADDRESS = Limit("account mails to an address", 5, 720)
MAILS_FROM_NETWORK = Limit("account mails asked for from one place", 30, 120)
SIGNING_CODES_BY_PERSON = Limit("codes to sign with, mailed to a person", 5, 120)
VERIFICATIONS_FROM_NETWORK = Limit("files verified from one place", 30, 10)
GUEST_COMMENTS_FROM_NETWORK = Limit("comments of guests from one place", 60, 10)
WEBHOOK_MESSAGES_OF_STUDIO = Limit("tests and repeated messages of a studio's webhooks", 60, 10)
GUEST_VISITS_FROM_NETWORK = Limit("visits of guests from one place", 60, 10)
GUESSES_AT_LINK_FROM_NETWORK = Limit("guesses at a guest link's password from one place", 10, 60)
INVITATIONS_TO_MAILBOX = Limit("invitations to a mailbox, whoever sends them", 20, 720)
INVITATIONS_BY_PERSON = Limit("invitations by a person", 60, 60)


def count_attempt(session: Session, limit: Limit, whom: str) -> None:
    """Count one try, or raise TooManyAttempts; the transaction must be one that commits although the try fails."""
    now_s = time.time()
    ahead_s = now_s + (limit.burst - 1) * limit.interval_s
    values = {
        "key": _key(limit, whom),
        "now_s": now_s,
        "interval_s": limit.interval_s,
        "ahead_s": ahead_s,
        "first_s": now_s + limit.interval_s,
    }
    if session.execute(_counted(session.get_bind().dialect.name), values).first() is None:
        free_at_s = session.execute(sa.select(RateLimit.free_at_s).where(RateLimit.key == values["key"])).scalar_one()
        raise TooManyAttempts(max(1, ceil(free_at_s - ahead_s)))


def reset(session: Session, limit: Limit, whom: str) -> None:
    """Delete the counted tries of a key after a success."""
    session.execute(sa.delete(RateLimit).where(RateLimit.key == _key(limit, whom)))


def delete_expired(session: Session) -> None:
    """Delete counts that no longer limit anything."""
    session.execute(sa.delete(RateLimit).where(RateLimit.free_at_s < time.time()))


def _key(limit: Limit, whom: str) -> str:
    return hashlib.sha256(f"{limit.name}\0{whom}".encode("utf-8", "surrogatepass")).hexdigest()


@cache
def _counted(dialect: str) -> Any:
    """Return the one statement that counts a try; it returns no row where the bucket is empty."""
    insert = (postgresql if dialect == "postgresql" else sqlite).insert(RateLimit)
    now_s, interval_s, ahead_s = (sa.bindparam(name, type_=sa.Float()) for name in ("now_s", "interval_s", "ahead_s"))
    begun = sa.case((RateLimit.free_at_s > now_s, RateLimit.free_at_s), else_=now_s)
    return (
        insert.values(key=sa.bindparam("key"), free_at_s=sa.bindparam("first_s", type_=sa.Float()))
        .on_conflict_do_update(
            index_elements=["key"], set_={"free_at_s": begun + interval_s}, where=RateLimit.free_at_s <= ahead_s
        )
        .returning(RateLimit.free_at_s)
    )
