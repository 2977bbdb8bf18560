"""Commands of the server, run on the database of a test's own server."""

from types import ModuleType, SimpleNamespace

import pytest

from tests.support.server import World


def use_server_of(world: World, commands: ModuleType, monkeypatch: pytest.MonkeyPatch) -> None:
    """Let the commands of a module read the database of the running server, and leave it open."""
    runtime = world.server.runtime
    kept_open = SimpleNamespace(database=runtime.database, close=lambda: None)
    monkeypatch.setattr(commands, "read_settings_or_exit", lambda: runtime.settings)
    monkeypatch.setattr(commands, "opened", lambda _: kept_open)
