"""The files of "Shield Wing", as its sound designer would deliver them.

All conform to the 44.1 kHz defaults but where the demo needs something to show: `airlock_cycle`
begins with silence and is too loud, `shield_hit` peaks between its samples, one thruster stands out,
`warp_in` comes with the hall that the game adds anyway, and with its dry stem, `drone_swarm_loop` has
nothing over 11 kHz though its file could hold 48, and `vo_oath` is spoken backwards.
"""

import io
import wave
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np

from app.demo import questioned_sounds, recipes
from app.demo.synth import Clock, Signal


@dataclass(frozen=True)
class DemoSound:
    """One file to deliver: its name, its format, and how it is made."""

    file_name: str
    sample_rate_hz: int
    bit_depth: int
    duration_s: float
    seed: int
    make: Callable[[Clock], Signal]

    def samples(self) -> Signal:
        """Return the sound, shape (frames, channels), full scale ±1.0."""
        return self.make(Clock(self.sample_rate_hz, self.duration_s, self.seed))

    def wav_bytes(self) -> bytes:
        """Return the whole WAV file, the same bytes each time."""
        samples = self.samples()
        full = 1 << (self.bit_depth - 1)
        draws = np.random.Generator(np.random.PCG64([self.seed, 9_999])).random((2, *samples.shape))
        dither = draws[0] - draws[1] if self.bit_depth == 16 else 0.0
        steps = np.clip(np.floor(samples * full + np.where(samples == 0.0, 0.0, dither) + 0.5), -full, full - 1)
        raw = steps.astype("<i4").view(np.uint8).reshape(-1, 4)[:, : self.bit_depth // 8].tobytes()
        file = io.BytesIO()
        with wave.open(file, "wb") as writer:
            writer.setnchannels(samples.shape[1])
            writer.setsampwidth(self.bit_depth // 8)
            writer.setframerate(self.sample_rate_hz)
            writer.writeframes(raw)
        return file.getvalue()

    def write(self, folder: Path) -> Path:
        """Write the file into a folder under its name, and return its path."""
        path = folder / self.file_name
        path.write_bytes(self.wav_bytes())
        return path


def demo_sounds() -> dict[str, DemoSound]:
    """Return every sound by its key: the stem of its file, and `suit_hit_take2` for a second take of that name."""
    sounds = [
        DemoSound(
            "ui_confirm.wav", 48_000, 24, 0.13, 101, partial(recipes.two_notes, first_hz=880.0, second_hz=1318.5)
        ),
        DemoSound("ui_back.wav", 48_000, 24, 0.13, 102, partial(recipes.two_notes, first_hz=987.8, second_hz=659.3)),
        *_set("laser_fire", 4, 96_000, 0.30, 110, recipes.laser_fire),
        DemoSound("engine_idle_loop.wav", 48_000, 24, 4.00, 120, recipes.engine_idle),
        DemoSound("amb_bridge_loop.wav", 44_100, 16, 24.00, 121, recipes.bridge),
        *_set("hull_impact", 3, 96_000, 0.90, 130, recipes.hull_impact),
        DemoSound("shield_hit.wav", 96_000, 24, 0.84, 140, recipes.shield_glass),
        DemoSound("shield_hit_altB.wav", 96_000, 24, 0.91, 141, recipes.shield_deep),
        DemoSound("shield_hit_altC.wav", 96_000, 24, 0.78, 142, recipes.shield_crackle),
        *_set("foot_deck_walk", 6, 48_000, 0.40, 150, recipes.step_on_deck),
        DemoSound("airlock_cycle.wav", 48_000, 24, 2.412, 160, recipes.airlock_cycle),
        DemoSound("suit_hit.wav", 48_000, 24, 0.50, 170, partial(recipes.suit_hit, clank_db=None)),
        *_thrusters(),
        DemoSound("final_FINAL_sting2.wav", 96_000, 24, 3.02, 190, recipes.victory_sting),
        DemoSound("alarm_red_alert.wav", 44_100, 16, 2.00, 195, recipes.alarm),
        DemoSound("mine_arm.wav", 44_100, 16, 0.50, 196, recipes.mine_arm),
        DemoSound("radar_ping.wav", 48_000, 24, 0.60, 200, recipes.radar_ping),
        DemoSound("dock_clamp.wav", 48_000, 24, 0.80, 210, recipes.dock_clamp),
        DemoSound("explosion_far.wav", 48_000, 24, 2.50, 220, recipes.explosion_far),
        DemoSound("missile_launch.wav", 96_000, 24, 1.40, 230, partial(recipes.missile_launch, thrust_s=0.50)),
        DemoSound("warp_in.wav", 48_000, 24, 2.15, 198, questioned_sounds.warp_in),
        DemoSound("drone_swarm_loop.wav", 96_000, 24, 6.00, 240, questioned_sounds.drone_swarm),
        DemoSound("vo_oath.wav", 48_000, 24, 4.87, 250, questioned_sounds.oath_backwards),
    ]
    by_key = {Path(sound.file_name).stem: sound for sound in sounds}
    by_key["suit_hit_take2"] = DemoSound(
        "suit_hit.wav", 48_000, 24, 0.50, 170, partial(recipes.suit_hit, clank_db=-9.0)
    )
    for number, thrust_s in ((2, 0.45), (3, 0.40)):
        by_key[f"missile_launch_take{number}"] = DemoSound(
            "missile_launch.wav", 96_000, 24, 1.40, 230, partial(recipes.missile_launch, thrust_s=thrust_s)
        )
    return by_key


def warp_in_stem() -> DemoSound:
    """Return the dry stem that comes with `warp_in`."""
    return DemoSound("warp_in__dry.wav", 48_000, 24, 2.15, 198, questioned_sounds.warp_in_dry)


def _thrusters() -> list[DemoSound]:
    return _set("thruster_burst", 4, 48_000, 0.80, 180, recipes.thruster_burst)


def thrusters_in_one_file() -> DemoSound:
    """Return the four thrusters in one file, a second of silence between them."""

    def in_one_file(clock: Clock) -> Signal:
        sounds = [burst.samples() for burst in _thrusters()]
        pause = np.zeros((clock.sample_rate_hz, sounds[0].shape[1]))
        return np.concatenate([part for sound in sounds for part in (sound, pause)][:-1])

    return DemoSound("thruster_burst.wav", 48_000, 24, 6.20, 180, in_one_file)


def _set(
    stem: str, count: int, sample_rate_hz: int, duration_s: float, seed: int, make: Callable[..., Signal]
) -> list[DemoSound]:
    return [
        DemoSound(
            f"{stem}_{number:02d}.wav", sample_rate_hz, 24, duration_s, seed + number, partial(make, variation=number)
        )
        for number in range(1, count + 1)
    ]
