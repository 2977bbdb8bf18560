"""The references of the demo project, all made here: a picture, a sound, a clip and a page of the story."""

import base64
import io
import wave
from dataclasses import dataclass

import numpy as np
from PIL import Image, ImageDraw

from app.demo.clip import warp_in_clip
from app.demo.synth import Clock, fall, noise, struck

SIZE = (1_280, 720)
STORY = """Scene 14, the oath.

The crew stands in the dark of the lower deck. Only the red lamp is on. The captain speaks quietly, as if the ship could
hear it; the others answer one after the other, and the last voice breaks.

Nothing else sounds. Then the pumps start again.
"""


@dataclass(frozen=True)
class DemoReference:
    """One file, with the cue that it is pinned to."""

    cue: str
    file_name: str
    content: bytes
    caption: str
    terms: str = ""
    words: str = ""
    start_s: float | None = None
    end_s: float | None = None

    def metadata(self, project_id: str) -> str:
        """Return an upload's metadata of the file."""
        values = {"project_id": project_id, "file_name": self.file_name}
        return ",".join(f"{key} {base64.b64encode(value.encode()).decode()}" for key, value in values.items())


def demo_references() -> list[DemoReference]:
    """Return the references of four cues."""
    return [
        DemoReference("vo_oath", "scene_14.txt", STORY.encode(), "The page of the story that it belongs to"),
        DemoReference(
            "shield_hit", "low_thump.wav", _thump(), "The weight of this, not its colour",
            terms="For reference only: may not be shipped", words="heavy, weight", start_s=0.2, end_s=0.9,
        ),
        DemoReference("coolant_splash", "tank.png", _tank(), "The tank on the lower deck, seen from the walkway"),
        DemoReference(
            "warp_in", "warp_in.webm", warp_in_clip(), "The ship is there at 2 s", start_s=1.0, end_s=4.0
        ),
    ]  # fmt: skip


def _tank() -> bytes:
    """Draw a tank of coolant between steel walls."""
    width, height = SIZE
    picture = Image.new("RGB", SIZE, "#22303a")
    draw = ImageDraw.Draw(picture)
    draw.polygon([(0, 0), (width, 0), (900, 230), (380, 230)], fill="#2c3c47")
    draw.polygon([(380, 230), (900, 230), (900, 420), (380, 420)], fill="#1a252d")
    draw.polygon([(380, 420), (900, 420), (width, height), (0, height)], fill="#39505c")
    draw.polygon([(430, 450), (850, 450), (1_060, 640), (220, 640)], fill="#4f9b9b")
    for ring, colour in ((150, "#6fb6b3"), (95, "#8fd0cb"), (40, "#c5ece8")):
        box = [640 - ring, 545 - ring // 4, 640 + ring, 545 + ring // 4]
        draw.ellipse(box, outline=colour, width=6)
    for x in range(80, width, 160):
        draw.line([(x, 0), (int(640 + (x - 640) * 0.42), 230)], fill="#1e2a33", width=5)
    draw.rectangle([520, 40, 760, 66], fill="#cfd8d6")
    out = io.BytesIO()
    picture.save(out, "PNG")
    return out.getvalue()


def _thump() -> bytes:
    """Return a low, dry thump as a WAV."""
    clock = Clock(sample_rate_hz=44_100, duration_s=1.4, seed=1_407)
    times = clock.times(0.2)
    body = np.sin(2 * np.pi * np.cumsum(fall(times, 140.0, 46.0, 0.09)) / clock.sample_rate_hz)
    sound = struck(times, 0.002, 0.24) * body + 0.25 * struck(times, 0.001, 0.03) * noise(clock, 1, 200.0, 2_400.0)
    samples = np.rint(sound / np.max(np.abs(sound)) * 0.6 * 32_767).astype("<i2")
    out = io.BytesIO()
    with wave.open(out, "wb") as file:
        file.setnchannels(1)
        file.setsampwidth(2)
        file.setframerate(clock.sample_rate_hz)
        file.writeframes(samples.tobytes())
    return out.getvalue()
