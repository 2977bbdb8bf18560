"""Mails of this room's tests do not wait for a digest, so that no job is left over."""

import pytest

from tests.support.server import RunningServer


@pytest.fixture(autouse=True)
def _without_digests(server: RunningServer, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(server.runtime.settings, "digest_delay_s", 0.0)
