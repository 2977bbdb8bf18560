"""Timeouts and retries for a remote store."""

import random
import time
from dataclasses import dataclass

import structlog

log = structlog.get_logger(__name__)


@dataclass(frozen=True)
class RetryPolicy:
    """Retries with exponential backoff and jitter, so that many clients do not retry at once."""

    tries: int = 5
    first_delay_s: float = 0.2
    max_delay_s: float = 5.0
    connect_timeout_s: float = 5.0
    read_timeout_s: float = 60.0  # of an answer that does not come, or does not go on

    def pause(self, failures: int, why: object) -> bool:
        """Wait before the next try; False where there is none, after so many failures."""
        if failures >= self.tries:
            return False
        longest_s = min(self.max_delay_s, self.first_delay_s * 2 ** (failures - 1))
        log.warning("the store is retried", failures=failures, why=str(why).splitlines()[0][:300])
        time.sleep(random.uniform(longest_s / 2, longest_s))
        return True
