"""How long a store far away is waited for, and how often it is asked again."""

import random
import time
from dataclasses import dataclass

import structlog

log = structlog.get_logger(__name__)


@dataclass(frozen=True)
class Patience:
    """Tries with growing pauses between; a pause is drawn at random, so that many do not come back at once."""

    tries: int = 5
    first_pause_s: float = 0.2
    longest_pause_s: float = 5.0
    connect_s: float = 5.0
    silence_s: float = 60.0  # of an answer that does not come, or does not go on

    def pause(self, failures: int, why: object) -> bool:
        """Wait before the next try; False where there is none, after so many failures."""
        if failures >= self.tries:
            return False
        longest_s = min(self.longest_pause_s, self.first_pause_s * 2 ** (failures - 1))
        log.warning("the store is asked again", failures=failures, why=str(why).splitlines()[0][:300])
        time.sleep(random.uniform(longest_s / 2, longest_s))
        return True
