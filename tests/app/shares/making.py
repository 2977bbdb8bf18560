"""Links and visits for tests, made over HTTP as people make them."""

from typing import Any
from uuid import UUID

from httpx2 import Client

from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from tests.app.renders.making import add_cue, deliver_sound, sound_list
from tests.support.server import World
from tests.support.waves import sine


def sound(world: World, name: str = "laser", *, bits: int = 24, **facts: Any) -> tuple[str, str]:
    """Put a cue with a drawn take on the list; return both ids."""
    cue = add_cue(world, name, **facts)
    tone = sine(hz=300 + 40 * len(sound_list(world)), dbfs=-6, rate=48_000, seconds=1)  # equal masters are found equal
    return cue["id"], deliver_sound(world, f"{name}.wav", tone, rate=48_000, bits=bits)


def approve(world: World, take_id: str) -> None:
    """Approve a take, past what its check found."""

    def write(session: Any) -> None:
        session.get_one(Take, UUID(take_id)).state = TakeState.APPROVED

    world.server.in_database(write)


def make(world: World, client: Client | None = None, **body: Any) -> Any:
    """Ask for a guest link."""
    wanted = {"kind": "cues", "title": "For the composer", **body}
    return (client or world.producer).post(f"/v1/projects/{world.project_id}/guest-links", json=wanted)


def made(world: World, **body: Any) -> tuple[dict[str, Any], str]:
    """Return a guest link just made, and the secret of its address."""
    answer = make(world, **body)
    assert answer.status_code == 201, answer.text
    found = answer.json()
    world.server.wait_for_jobs()
    return found["link"], found["url"].rpartition("/listen/")[2]


def open_link(world: World, secret: str, name: str = "Ada", **body: Any) -> Any:
    """Open a link as a guest."""
    return world.nobody.post(f"/v1/guest-access/{secret}/visits", json={"guest_name": name, **body})


def opened(world: World, secret: str, name: str = "Ada", **body: Any) -> tuple[str, dict[str, Any]]:
    """Return the secret of a visit that began, and what it shows."""
    answer = open_link(world, secret, name, **body)
    assert answer.status_code == 201, answer.text
    found = answer.json()
    return found["visit"], found["room"]


def play(world: World, visit: str, place: int = 1) -> Any:
    """Play a sound as a guest: record it, then fetch it."""
    answer = world.nobody.post(f"/v1/guest-visits/{visit}/sounds/{place}/plays")
    if answer.status_code != 204:
        return answer
    return world.nobody.get(f"/v1/guest-visits/{visit}/sounds/{place}/preview")


def links(world: World) -> list[dict[str, Any]]:
    """Return the guest links of the project."""
    answer = world.producer.get(f"/v1/projects/{world.project_id}/guest-links")
    assert answer.status_code == 200, answer.text
    items: list[dict[str, Any]] = answer.json()["items"]
    return items
