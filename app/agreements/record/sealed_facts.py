"""The hash by which the record names facts that it does not hold in full."""

import hashlib
from collections.abc import Mapping
from typing import Any

from app.core.record import canonical


def sealed(facts: Mapping[str, Any]) -> str:
    """Return the SHA-256 of facts, as hex digits."""
    return hashlib.sha256(canonical(facts).encode()).hexdigest()
