"""Every test begins with no tries counted: they all come from one place."""

import pytest

from app.accounts import rate_limits


@pytest.fixture(autouse=True)
def _no_tries_yet() -> None:
    rate_limits.forget_all()
