"""The list and the brief of the sample project."""

from typing import Any

PROJECT_NAME = "Sample project"
DESCRIPTION = "A sample to look around in: a small space game for PC and handheld. Delete it when you are done."
DELIVERY_NOTE = "First six sounds of the sample."
BRIEF: dict[str, Any] = {
    "genre": "A small space game: the player keeps a ship running, room by room.",
    "feel": "Close and mechanical, with a friendly interface.",
    "platforms": ["pc", "handheld"],
    "playback": "headphones",
    "music_style": "Slow synthesizers; none while an alarm sounds.",
}
_ROWS = (
    ("ui_confirm", "ui", 0.4, "A choice is confirmed", "Two short rising notes."),
    ("ui_back", "ui", 0.4, "A choice is left", "The confirm sound, falling."),
    ("ui_error", "ui", 0.5, "A choice is refused", "Dull and short; heard often."),
    ("coin_pickup", "ui", 0.6, "The player collects a coin", "Bright, satisfying, rising."),
    ("radar_ping", "ui", 1.2, "The radar finds a ship", "One ping with a short tail."),
    ("alarm_loop", "ui", 2.0, "The hull leaks, until it is repaired", "Urgent for ten seconds, bearable for a minute."),
    ("shield_hit", "weapon", 0.8, "A shot meets the shield", "Must read over laser fire."),
    ("laser_fire", "weapon", 0.3, "The ship's turret, five times a second", "Thin and bright, no low end."),
    ("missile_launch", "weapon", 1.4, "A missile leaves", "Release, ignition, departure."),
    ("mine_arm", "weapon", 0.6, "A mine wakes as a ship nears", "Three clicks and a hum."),
    ("hull_impact", "impact", 0.9, "Debris meets the hull", "A stone on plate steel, heard from inside."),
    ("explosion_far", "impact", 2.5, "A ship explodes far away", "Low and wide, without a crack."),
    ("door_open", "foley", 0.9, "A cabin door opens", "A servo, then a soft stop."),
    ("door_close", "foley", 0.9, "A cabin door closes", "A slide, then a bolt."),
    ("footstep_deck", "foley", 0.4, "The player walks on the deck", "Rubber soles on a steel grating."),
    ("tool_pickup", "foley", 0.5, "The player takes a tool", "Light metal, close."),
    ("repair_loop", "foley", 3.0, "While the player repairs", "A ratchet and small sparks."),
    ("bridge_loop", "ambience", 24.0, "On the bridge", "Air, distant relays; music plays over it."),
    ("engine_room_loop", "ambience", 24.0, "In the engine room", "Closer and hotter than the bridge."),
    ("cargo_loop", "ambience", 20.0, "In the cargo hold", "Chains, metal under load."),
    ("thruster_burst", "vehicle", 0.8, "A side thruster pushes", "A short jet of gas."),
    ("warp_in", "vehicle", 2.0, "The ship arrives", "Suction, then arrival."),
    ("victory_sting", "music", 3.0, "A sector is won", "Three rising chords."),
    ("game_over_sting", "music", 3.0, "The ship is lost", "The victory chords, falling and slower."),
)
_VARIATIONS = {"laser_fire": 4, "hull_impact": 3, "footstep_deck": 6, "thruster_burst": 4}


def sample_cues() -> list[dict[str, Any]]:
    """Return the cues of the sample as rows to add."""
    return [
        {
            "name": name,
            "category": category,
            "duration_s": duration_s,
            "use": use,
            "description": description,
            "loop": name.endswith("_loop"),
            "variations": _VARIATIONS.get(name, 1),
            "state": "locked",
        }
        for name, category, duration_s, use, description in _ROWS
    ]
