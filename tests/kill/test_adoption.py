"""A folder is adopted whole or not at all, though the server is killed in between."""

from typing import Any

import httpx
import pytest

from app.deliveries.models import Adoption, Take
from app.reviews.models import Verdict
from app.sound_lists.models import Cue
from tests.kill.effects import is_idle, jobs_written, nothing_failed, rows
from tests.kill.processes import ProcessServer, SomeOf, wait_until
from tests.support.adoptions import sent
from tests.support.server import World
from tests.support.waves import sine, wav_bytes

pytestmark = [pytest.mark.kill, pytest.mark.slow]
FILES = {f"ui/click_0{place}.wav": wav_bytes(sine(hz=440 * place, dbfs=-6, seconds=0.2)) for place in (1, 2)}


@pytest.mark.killed_on("sqlite")
def test_a_folder_is_adopted_once(server: ProcessServer, world: World, some_of: SomeOf) -> None:
    """Killed before the commit nothing is there; after it, all of it, and the second press is refused."""
    adoption_id = sent(world, FILES)
    url = f"/v1/adoptions/{adoption_id}/adopt"
    press: dict[str, Any] = {"headers": {"Idempotency-Key": "one press"}}
    for point in some_of(("reviews.before_adopted", "http.after_commit"), 2):
        made = int(point == "http.after_commit")
        web = server.serve(point)
        with pytest.raises(httpx.TransportError):
            world.signed_in(world.producer_id).post(url, **press)
        server.wait_for_death(web, point)
        assert [rows(server, table) for table in (Cue, Take, Verdict)] == [made, 2 * made, 2 * made]
    server.serve()
    again = world.signed_in(world.producer_id).post(url)
    assert again.status_code in (200, 409), again.text
    server.work()
    wait_until(lambda: is_idle(server))
    assert [rows(server, table) for table in (Adoption, Cue, Take, Verdict)] == [1, 1, 2, 2]
    assert jobs_written(server, "reviews.check_adopted_takes") == 1
    assert nothing_failed(server)
