"""The voice lines of the demo project: six lines in two languages, and three takes by our own generator of vowels."""

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from app.demo.questioned_sounds import VOWELS
from app.demo.sounds import DemoSound
from app.demo.synth import Clock, Signal, at_true_peak, faded, mono, noise, rumble_off, struck, tone

SCRIPT = """Line ID,Character,Scene,Direction,English,German
captain_010,Captain,"Scene 14, lower deck",quietly,By the light of a hundred suns.,Beim Licht von hundert Sonnen.
mate_010,First mate,,joining in,We hold the line.,Wir halten die Stellung.
captain_020,Captain,,after a breath,And if it breaks?,Und wenn sie bricht?
mate_020,First mate,,,Then we hold what is left.,"Dann halten wir, was bleibt."
captain_030,Captain,"Scene 15, bridge",over the alarm,All hands!,Alle Mann!
mate_030,First mate,,out of breath,The mines are gone.,Die Minen sind weg.
"""
APPROVED = ("en_captain_010", "en_captain_020")
CHANGED = ("captain_010", "en", "By the light of a thousand suns.")  # after its take was approved
CASTINGS = (  # character, language, performer, who directs, who casts
    ("Captain", "en", "The captain's voice", "Audio director", "Producer"),
    ("First mate", "en", "The mate's voice", "Audio director", "Producer"),
)


Ask = Callable[..., Any]  # sends a request as one part, and returns its body


def add_script(ask: Ask, path: str) -> None:
    """Import the script as the producer, and name who speaks; what is there already stays."""
    if ask("GET", f"{path}/voice-script")["lines"]:
        return
    ask("POST", f"{path}/voice-lines/import", json={"format": "csv", "text": SCRIPT, "dry_run": False})
    characters = {character["name"]: character["id"] for character in ask("GET", f"{path}/voice-script")["characters"]}
    for name, language, performer, directed_by, cast_by in CASTINGS:
        body = {"performer": performer, "directed_by": directed_by, "cast_by": cast_by}
        ask("PUT", f"/voice-characters/{characters[name]}/castings/{language}", json=body)


def change_text(ask: Ask, path: str) -> None:
    """Change a text after its take was approved, once, so that the next session has a line to record again."""
    key, language, text = CHANGED
    lines = ask("GET", f"{path}/voice-lines", params={"language": language})["lines"]
    line = next(candidate for candidate in lines if candidate["key"] == key)
    if line["text_version"] == 1:
        ask("PUT", f"/voice-lines/{line['id']}/texts/{language}", json={"text": text, "text_version": 1})


def voice_takes() -> list[DemoSound]:
    """Return two English takes, and a German one that is a fifth longer than its original."""
    return [
        DemoSound("en_captain_010.wav", 48_000, 24, 2.6, 260, partial(spoken, vowels="aioaeao", hz=118)),
        DemoSound("en_captain_020.wav", 48_000, 24, 1.5, 261, partial(spoken, vowels="aiei", hz=116)),
        DemoSound("de_captain_020.wav", 48_000, 24, 1.8, 262, partial(spoken, vowels="oeiai", hz=116)),
    ]


def spoken(clock: Clock, vowels: str, hz: float) -> Signal:
    """Return syllables of a low voice, one after the other over the whole length."""
    total, each_s = np.zeros(clock.frames), (clock.duration_s - 0.25) / len(vowels)
    for syllable, vowel in enumerate(vowels):
        times = clock.times(0.002 + syllable * each_s)
        pitch_hz = (hz - 2 * syllable) * (1 - 0.2 * np.clip(times / 0.6, 0.0, 1.0))
        voice = np.zeros(clock.frames)
        for harmonic in range(1, 33):
            level = sum(1 / (1 + ((hz * harmonic - formant) / 90.0) ** 2) for formant in VOWELS[vowel])
            decay_s = 0.5 * each_s / (1 + harmonic / 16)  # highs die first
            voice += level / harmonic**0.3 * tone(clock, harmonic * pitch_hz) * struck(times, 0.004, decay_s)
        consonant = 0.9 * noise(clock, 10 + syllable, 1_500, 12_000) * struck(times, 0.0005, 0.025)
        total += voice + consonant
    return at_true_peak(mono(faded(rumble_off(total, clock, 70.0), clock, 0.10)), -3.0)
