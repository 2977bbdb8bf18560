"""How often the same may be tried in this web process: guesses at passwords, mails sent to strangers."""

from dataclasses import dataclass
from math import ceil
from time import time

from limits import RateLimitItem, parse
from limits.storage import MemoryStorage
from limits.strategies import MovingWindowRateLimiter

from app.accounts.errors import TooManyTries


@dataclass(frozen=True)
class Limit:
    """What is counted, and how often it may happen."""

    name: str
    rate: RateLimitItem


SIGN_INS_OF_ADDRESS = Limit("sign-ins of an address from one place", parse("10 per 5 minutes"))
SIGN_INS_FROM_PLACE = Limit("sign-ins from one place", parse("100 per 5 minutes"))
SIGN_UPS_FROM_PLACE = Limit("sign-ups from one place", parse("30 per hour"))
RESETS_OF_ADDRESS = Limit("resets of an address", parse("5 per hour"))
RESETS_FROM_PLACE = Limit("resets from one place", parse("30 per hour"))
INVITATIONS_BY_PERSON = Limit("invitations by a person", parse("60 per hour"))

_storage = MemoryStorage()
_limiter = MovingWindowRateLimiter(_storage)


def count_try(limit: Limit, who: str) -> None:
    """Count one try, or raise TooManyTries."""
    if not _limiter.hit(limit.rate, limit.name, who):
        reset_at = _limiter.get_window_stats(limit.rate, limit.name, who).reset_time
        raise TooManyTries(max(1, ceil(reset_at - time())))


def forgive(limit: Limit, who: str) -> None:
    """Forget the tries of somebody who has shown to be right."""
    _limiter.clear(limit.rate, limit.name, who)


def forget_all() -> None:
    """Forget every try."""
    _storage.reset()
