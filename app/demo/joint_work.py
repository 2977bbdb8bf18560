"""The demo's joint work: the voice lines, whose draft contract a second designer shares."""

from collections.abc import Callable
from datetime import timedelta
from typing import Any

from app.core import clock
from app.demo import voice
from app.demo.hiring import ADDRESSES, link_to
from app.demo.visitors import Visitor

TITLE = "Voice lines"
PRICE_MINOR = 4_500  # of one line in one language
DUE_IN_DAYS = 45
NOTE = "The German lines, beside the English ones of the first designer."


def divide_voice_lines(
    producer: Visitor,
    second: Visitor,
    studio_id: str,
    project_id: str,
    cue_ids: dict[str, str],
    wait_for: Callable[[Callable[[], Any]], Any],
) -> None:
    """Have a second designer join, and divide a draft over the voice lines by language, once."""
    project = f"/projects/{project_id}"
    if any(contract["title"] == TITLE for contract in producer.ask("GET", f"{project}/contracts")):
        return
    _invite(producer, second, studio_id, project, wait_for)
    engagements = producer.ask("GET", project)["engagements"]
    ids = {engagement["designer"]["name"]: engagement["id"] for engagement in engagements}
    body = {"engagement_id": ids["Sound designer"], "kind": "single", "title": TITLE, "currency": "USD"}
    draft = producer.ask("POST", f"{project}/contracts", json=body)
    to_make = {name for name in cue_ids if name.startswith(("en_", "de_"))} - {*voice.APPROVED}
    lines = {name: cue_ids[name] for name in sorted(to_make)}
    milestone = {
        "name": TITLE,
        "due_on": (clock.now().date() + timedelta(days=DUE_IN_DAYS)).isoformat(),
        "cues": [{"cue_id": cue_id, "price_minor": PRICE_MINOR} for cue_id in lines.values()],
    }
    producer.ask("PUT", f"/contracts/{draft['id']}/milestones", json={"milestones": [milestone]})
    german = [cue_id for name, cue_id in lines.items() if name.startswith("de_")]
    shared = {"engagement_id": ids["Second designer"], "cue_ids": german}
    producer.ask("POST", f"/contracts/{draft['id']}/joint", json=shared)


def _invite(
    producer: Visitor, second: Visitor, studio_id: str, project: str, wait_for: Callable[[Callable[[], Any]], Any]
) -> None:
    if len(producer.ask("GET", project)["engagements"]) > 1:
        return
    body = {"email": ADDRESSES[1], "kind": "contract", "note": NOTE}
    path = f"{project}/invitations"
    if ADDRESSES[1] not in {invitation["email"] for invitation in producer.ask("GET", path)}:
        producer.ask("POST", path, json=body)
    link = wait_for(lambda: link_to(producer, studio_id, ADDRESSES[1], "/invitation/"))
    second.ask("POST", f"/invitations/{link.rsplit('/', 1)[1]}/accept", json={})
