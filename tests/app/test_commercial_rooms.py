"""A server without contracts, money and hiring: SOUNDLIST_COMMERCIAL=no."""

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from app import commercial, registry
from app.routers import BASE_ROUTERS, COMMERCIAL_ROUTERS
from tests.house.routes import api_routes

ROOT = Path(__file__).parents[2]
COMMERCIAL = {"agreements", "amendments", "hiring", "money"}


@pytest.fixture(scope="module")
def walked(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    ran = subprocess.run(
        [sys.executable, "-m", "tests.app.without_contracts", str(tmp_path_factory.mktemp("data"))],
        cwd=ROOT, capture_output=True, text=True, timeout=600,
    )  # fmt: skip
    assert ran.returncode == 0, ran.stderr[-4000:]
    answer: dict[str, Any] = json.loads(ran.stdout.splitlines()[-1])
    return answer


@pytest.mark.slow
def test_a_sound_goes_from_upload_to_pack(walked: dict[str, Any]):
    assert walked["masters"] == ["laser_fire_01", "laser_fire_02", "ui_confirm"]
    assert walked["packed"] == [f"{stem}.wav" for stem in walked["masters"]]


@pytest.mark.slow
def test_routes_and_jobs_are_gone(walked: dict[str, Any]):
    assert walked["has_contracts"] is False
    assert walked["contracts_status"] == 404
    words = ("contract", "invoices", "posting", "roster", "milestone", "money", "change-order", "bids")
    assert [path for path in walked["paths"] if any(word in path for word in words)] == []
    assert COMMERCIAL.isdisjoint(walked["job_rooms"])


def test_all_of_the_commercial_rooms_is_listed_apart():
    """What another room's list holds would run although they are off."""
    rooms = registry.rooms_in_use(is_commercial=False)
    followers = [*sum(rooms.handlers.values(), ()), *sum(rooms.receivers.values(), ())]
    assert [follower for follower in followers if follower.__module__.split(".")[1] in COMMERCIAL] == []
    jobs = [*rooms.chores, *sum(rooms.subscribers.values(), ())]
    assert [job for job in jobs if job.split(".")[0] in COMMERCIAL] == []
    assert [module for module in rooms.job_modules if module.split(".")[1] in COMMERCIAL] == []
    endpoints = [route.endpoint for router in BASE_ROUTERS for route in api_routes(router.routes)]
    assert [endpoint for endpoint in endpoints if endpoint.__module__.split(".")[1] in COMMERCIAL] == []
    assert len(COMMERCIAL_ROUTERS) > 10
    assert registry.rooms_in_use(is_commercial=True).subscribers.keys() > rooms.subscribers.keys()
    assert commercial.SUBSCRIBERS.keys().isdisjoint(registry.SUBSCRIBERS)
