"""One of each thing that the story of the demo does not need, so that a visitor finds no empty page."""

from datetime import timedelta
from typing import Any
from uuid import NAMESPACE_URL, uuid5

from app.core import clock
from app.demo import cues
from app.demo.visitors import Visitor

PLAYLIST = "Palette, for the kick-off"
BED, BED_LEVEL_DB = "amb_bridge_loop", -12.0
WEBHOOK = {
    "url": "https://chat.soundlist.example/hooks/shield-wing",
    "events": ["changes.requested", "take.approved", "pack.made"],
}
# Heard in the second build: which cue, as what, and by how much it is off.
HEARD: tuple[tuple[str, dict[str, Any]], ...] = (
    (cues.FOOTSTEPS, {"said": "too-loud", "amount_db": -6.0, "text": "Steps cover the voices on the bridge."}),
    ("radar_ping", {"said": "good", "text": "Reads over the engine."}),
)
REDLINE = {
    "kind": "insert",
    "after_key": "rounds",
    "title": "Listening together",
    "text": "Before each milestone {designer} and the studio listen to its sounds together once.",
    "comment": "An hour together saves a round.",
}


RECIPE = {
    "plug_ins": ["Convolution reverb 2.1", "Pitch shifter 4.0"],
    "recipe": "Two metal bowls, pitched down seven semitones; the clank is a gate hinge at -9 dB, 40 ms later.",
}
OWN_TIME = {"minutes": 90, "note": "The bid: read the brief, and tried two hulls."}
HANDED_OFF = {"done_percent": 75, "missing": "The tail in the hangar, and a duller clank."}


def propose_redline(designer: Visitor, contract: dict[str, Any]) -> None:
    """Insert a clause into the text that was sent."""
    body = {"version": contract["version"]["number"], "changes": [REDLINE], "note": "One addition; the rest is fine."}
    designer.ask("POST", f"/contracts/{contract['id']}/redlines", json=body)


def add_extras(producer: Visitor, studio_id: str, project_id: str, cue_ids: dict[str, str]) -> None:
    """Add a roster entry, a playlist, a bed, a webhook that is off and a listening pass, each once."""
    project = f"/projects/{project_id}"
    _add_to_roster(producer, f"/studios/{studio_id}/roster")
    if not producer.ask("GET", f"{project}/playlists"):
        body = {"name": PLAYLIST, "cue_ids": [cue_ids[name] for name in cues.PALETTE]}
        producer.ask("POST", f"{project}/playlists", json=body)
    if not producer.ask("GET", f"/studios/{studio_id}/webhooks")["items"]:
        webhook = producer.ask("POST", f"/studios/{studio_id}/webhooks", json=WEBHOOK | {"project_id": project_id})
        producer.ask("PATCH", f"/webhooks/{webhook['id']}", json={"enabled": False})
    approved = producer.ask("GET", f"{project}/takes", params={"state": "approved", "limit": "200"})["items"]
    take = next(take for take in approved if take["cue"] and take["cue"]["name"] == BED)
    bed = {"role": "ambience", "take_id": take["id"], "level_db": BED_LEVEL_DB}
    producer.ask("PUT", f"{project}/beds", json=bed)
    _listen(producer, project)


def hand_off_newest(designer: Visitor, project_id: str) -> None:
    """Keep the recipe of the designer's newest take with a cue, and hand that cue off unfinished, once."""
    takes = designer.ask("GET", f"/projects/{project_id}/takes", params={"limit": "50"})["items"]
    take = next(take for take in takes if take["cue"] and take["state"] != "approved")
    designer.ask("PUT", f"/takes/{take['id']}/source-bank", json=RECIPE)
    handoffs = f"/cues/{take['cue']['id']}/handoffs"
    if not designer.ask("GET", handoffs):
        designer.ask("POST", handoffs, json=HANDED_OFF)


def add_own_time(designer: Visitor, project_id: str) -> None:
    """Log what the designer's bid took them, once; nobody else sees it."""
    path = f"/projects/{project_id}/own-time"
    if not designer.ask("GET", path)["times"]:
        designer.ask("POST", path, json={"worked_on": clock.now().date().isoformat()} | OWN_TIME)


def _add_to_roster(producer: Visitor, path: str) -> None:
    address = "second.designer@soundlist.example"
    if address in {entry["email"] for entry in producer.ask("GET", path)["items"]}:
        return
    entry = producer.ask(
        "POST",
        path,
        json={
            "name": "Second designer",
            "email": address,
            "specialities": ["ambience", "footsteps"],
            "services": ["field_recording"],
            "languages": ["English"],
            "equipment": "A hall of 400 m², a pair of omnis, contact microphones.",
            "weekly_hours": 20,
            "available_from_on": (clock.now().date() + timedelta(days=30)).isoformat(),
            "notes": "Bid on the effects; the recordings were fine, the price was over the budget.",
            "rate": {"amount_minor": 6_000, "currency": "USD", "unit": "hour"},
        },
    )
    today = clock.now().date()
    due_on = today + timedelta(days=30)
    loan = {"item": "Field recorder", "lent_on": today.isoformat(), "due_on": due_on.isoformat()}
    producer.ask("PUT", f"/roster/{entry['id']}/loans", json={"loans": [loan]})


def _listen(producer: Visitor, project: str) -> None:
    listening = producer.ask("GET", f"{project}/listening-pass")["listening_pass"]
    listening = listening or producer.ask("POST", f"{project}/listening-passes")["listening_pass"]
    ids = {heard["cue"]["name"]: heard["cue"]["id"] for heard in listening["cues"]}
    for name, heard in HEARD:
        note_id = str(uuid5(NAMESPACE_URL, f"{listening['id']}/{name}"))  # a note that is sent again is the same note
        body = {"note_id": note_id, "cue_id": ids[name]} | heard
        producer.ask("POST", f"/listening-passes/{listening['id']}/notes", json=body)
