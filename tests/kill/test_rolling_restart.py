"""Web processes are replaced one after the other while people work, and nobody sees an error."""

import signal
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack
from pathlib import Path
from uuid import UUID, uuid4

import httpx
import pytest
from fastapi.testclient import TestClient

from app.accounts.authentication import SESSION_COOKIE
from app.deliveries.models import Delivery
from tests.kill.effects import rows
from tests.kill.processes import ProcessServer, free_port, wait_until
from tests.kill.proxy import CADDY, running_caddy, running_proxy
from tests.support.server import World

pytestmark = [pytest.mark.kill, pytest.mark.slow]
PEOPLE = 4  # shared out among the proxies
PAUSE_S = 0.05
DRAIN_S = 1.0  # a health check comes round several times in it


@pytest.mark.killed_on("sqlite")
def test_nobody_sees_a_rolling_restart(server: ProcessServer, world: World, tmp_path: Path) -> None:
    signed_in: TestClient = world.designer
    ports = [free_port(), free_port()]
    webs = [server.serve(port=port, drain_s=DRAIN_S) for port in ports]
    server.work()
    wait_until(lambda: all(is_ready(port) for port in ports))
    over = threading.Event()
    opened: list[str] = []
    refused: list[str] = []

    def work(proxy_port: int) -> int:
        requests = 0
        with httpx.Client(
            base_url=f"http://127.0.0.1:{proxy_port}", timeout=60,
            cookies={SESSION_COOKIE: signed_in.cookies[SESSION_COOKIE]},
            headers={"X-CSRF-Token": signed_in.headers["x-csrf-token"]},
        ) as browser:  # fmt: skip
            while not over.is_set():
                deliveries = f"/v1/projects/{world.project_id}/deliveries"
                for answer in (
                    browser.get(f"/v1/projects/{world.project_id}"),
                    browser.post(deliveries, json={"note": "one more"}, headers={"Idempotency-Key": str(uuid4())}),
                    browser.get(f"/v1/projects/{world.project_id}/sound-list"),
                ):
                    requests += 1
                    if not answer.is_success:
                        refused.append(f"{answer.request.method} {answer.status_code}: {answer.text[:300]}")
                    elif answer.status_code == 201:
                        opened.append(answer.json()["id"])
                time.sleep(PAUSE_S)
        return requests

    with ExitStack() as proxies, ThreadPoolExecutor(PEOPLE) as people:
        doors = [proxies.enter_context(running_proxy(ports))]
        if CADDY.exists():
            doors.append(proxies.enter_context(running_caddy(ports, tmp_path)))
        working = [people.submit(work, doors[each % len(doors)]) for each in range(PEOPLE)]
        try:
            for place, port in enumerate(ports):
                webs[place].send(signal.SIGTERM)
                wait_until(lambda place=place: webs[place].poll() is not None)
                webs[place] = server.serve(port=port, drain_s=DRAIN_S)
                wait_until(lambda port=port: is_ready(port))
        finally:
            over.set()
        requests = sum(one.result(60) for one in working)
    assert refused == []
    assert requests > 50
    assert len(set(opened)) == len(opened)
    assert sum(rows(server, Delivery, id=UUID(each)) for each in opened) == len(opened)
    assert rows(server, Delivery) == len(opened), "nothing was sent twice"


def is_ready(port: int) -> bool:
    return httpx.get(f"http://127.0.0.1:{port}/readyz", timeout=10).status_code == 200
