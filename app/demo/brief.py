"""The brief of the demo project, which its designer read before making the first sound."""

from typing import Any

ANSWERS: dict[str, Any] = {
    "genre": "A tactical game of fleets: the player commands shield ships from a bridge; a battle lasts ten minutes.",
    "feel": "Heavy and close: steel, pressure, machines that strain. Nothing cheerful, nothing that chirps.",
    "similar": ["submarine films: the hull that groans", "naval radio, for everything that is spoken"],
    "categories": ["ui", "weapon", "impact", "foley", "ambience", "creature", "vehicle", "vo", "music"],
    "platforms": ["pc", "handheld"],
    "playback": "headphones",
    "scenes": [
        {"scene": "Bridge", "ambience": "hum of screens, muffled engines, quiet voices", "music": True},
        {"scene": "Engine room", "ambience": "pumps and turbines, close and loud", "music": False},
        {"scene": "Lower deck", "ambience": "creaking hull, dripping coolant", "music": False},
    ],
    "silence": "some",
    "music_style": "Low strings and brass, slow; drums in battle only.",
    "music_ducks": "voice",
    "priority": ["shield hit", "red alert", "missile launch", "the oath"],
    "voice": "calls",
    "voice_people": "The studio writes and casts; the sound designer records and directs.",
    "narration": "no",
    "effects": {"everything": ["reverb"]},
    "player": "wwise",
    "quality": "44k1",
    "memory": 8,
    "loudness": "game",
    "licensed": "no",
    "surround": ["stereo"],
    "implementer": "The gameplay programmer, within two days of an approval.",
}
DECISION = {
    "attended": "Producer, Audio director",
    "text": "The palette comes first; nothing of the alpha begins before it is approved as a set.",
}
NAMES = {
    "separator": "_",
    "extension": ".wav",
    "tokens": [
        {"name": "what", "case": "lower"},
        {"name": "detail", "case": "lower", "optional": True, "repeats": True},
        {"name": "number", "digits": 2, "optional": True},
    ],
}
UNKNOWN = {"dates": "Alpha is in November; when the beta closes depends on the publisher."}


def changes() -> dict[str, dict[str, Any]]:
    """Return every answer as the API takes it."""
    answers = {key: {"value": value} for key, value in (ANSWERS | {"naming": NAMES}).items()}
    return answers | {key: {"is_unknown": True, "note": note} for key, note in UNKNOWN.items()}
