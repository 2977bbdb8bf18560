"""Memory use of a target's game files: counted from files that are there, forecast from the sound list."""

import math
from collections.abc import Iterable
from dataclasses import asdict, dataclass
from functools import cache
from typing import Any

from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec, Target

PLAYED_BITS = 16  # of the samples that engines make of what a lossy codec keeps
MOST_LIKELY_CHANNELS = 2  # where neither target nor spec says it


@dataclass(frozen=True)
class SoundSize:
    """A number of game files of one length.

    Attributes
    ----------
    category : str or None
        Decides codec, streaming and budget where the spec says so for it.
    duration_s : float or None
        Of each file; None if no length is specified yet.
    channels : int or None
        Of the master; None takes the most that the spec accepts. A target of stated channels has those.
    files : int
        How many: the variations of a cue.
    """

    category: str | None
    duration_s: float | None
    channels: int | None = None
    files: int = 1


@dataclass(frozen=True)
class MemoryUse:
    """Memory use of some of a target's files.

    Attributes
    ----------
    category : str or None
        None for the files of no category, and in the total.
    files, unknown_files : int
        Counted, and left out because their length is not known.
    pcm_bytes : int
        As the renders are.
    disk_bytes : int
        As the engine's codec makes them.
    memory_bytes : int
        What is resident: the same, or only a buffer of what is streamed.
    budget_bytes : int or None
        What they may take; None where the spec sets nothing.
    """

    category: str | None
    files: int
    unknown_files: int
    pcm_bytes: int
    disk_bytes: int
    memory_bytes: int
    budget_bytes: int | None = None

    @property
    def over_bytes(self) -> int | None:
        """Return the excess over the budget; negative is room left, None without a budget."""
        return None if self.budget_bytes is None else self.memory_bytes - self.budget_bytes

    def to_dict(self) -> dict[str, Any]:
        """Return the figures as plain values."""
        return asdict(self) | {"over_bytes": self.over_bytes}


@dataclass(frozen=True)
class Memory:
    """A target's memory use: all of it, and by category in the order of first appearance."""

    target: str
    total: MemoryUse
    categories: tuple[MemoryUse, ...]

    def to_dict(self) -> dict[str, Any]:
        """Return the figures as plain values."""
        categories = [category.to_dict() for category in self.categories]
        return {"target": self.target, "total": self.total.to_dict(), "categories": categories}


def requested_sizes(cues: Iterable[CueFacts]) -> list[SoundSize]:
    """Return the game files that a sound list asks for; those of cut cues are none."""
    return [SoundSize(cue.category, cue.duration_s, files=cue.variations) for cue in cues if cue.state != "cut"]


def memory_use(spec: DeliverySpec, target: str, sounds: Iterable[SoundSize]) -> Memory:
    """Count the memory that sounds take once they are game files of a target.

    Parameters
    ----------
    spec : DeliverySpec
        The whole spec, not a category's view.
    target : str
        One of its targets. `budget_bytes`, `codec_ratio`, `streamed` and `stream_buffer_bytes` are its
        numbers; a category may state others, and its own budget.
    sounds : iterable of SoundSize
        Existing sounds, or required ones.

    Returns
    -------
    Memory
        Zeros for no sounds.

    Raises
    ------
    SpecError
        The spec names no such target.
    """
    base = spec.for_target(target)
    uses: dict[str | None, MemoryUse] = {}
    view_of = cache(spec.for_category)
    for sound in sounds:
        view = view_of(sound.category)
        category_use = uses.get(sound.category) or MemoryUse(
            sound.category, 0, 0, 0, 0, 0, _own_budget(spec, target, sound.category)
        )
        uses[sound.category] = _plus(category_use, _use(sound, view, view.targets[target]))
    total = MemoryUse(None, 0, 0, 0, 0, 0, base.targets[target].budget_bytes)
    for use in uses.values():
        total = _plus(total, use)
    return Memory(target, total, tuple(uses.values()))


def _use(sound: SoundSize, view: DeliverySpec, target: Target) -> MemoryUse:
    if sound.duration_s is None:
        return MemoryUse(sound.category, 0, sound.files, 0, 0, 0)
    channels = sound.channels or max(view.accept.channels or (MOST_LIKELY_CHANNELS,))
    if target.channels != "master":
        channels = target.channels
    frames = math.ceil(sound.duration_s * target.sample_rate_hz - 1e-6)  # 0.1 s of 44,100 Hz is 4,410 frames
    pcm = frames * channels * (PLAYED_BITS if target.is_lossy else target.bit_depth) // 8
    coded = math.ceil(pcm / target.codec_ratio)
    resident = min(target.stream_buffer_bytes, coded) if target.streamed else coded
    count = sound.files
    return MemoryUse(sound.category, count, 0, count * pcm, count * coded, count * resident)


def _plus(memory: MemoryUse, other: MemoryUse) -> MemoryUse:
    return MemoryUse(
        memory.category,
        memory.files + other.files,
        memory.unknown_files + other.unknown_files,
        memory.pcm_bytes + other.pcm_bytes,
        memory.disk_bytes + other.disk_bytes,
        memory.memory_bytes + other.memory_bytes,
        memory.budget_bytes,
    )


def _own_budget(spec: DeliverySpec, target: str, category: str | None) -> int | None:
    """Return the budget that the spec states for a category alone: the target's own is for all of them together."""
    own_table = spec.tables.get("categories", {}).get(category, {}).get("targets", {}).get(target, {})
    budget = own_table.get("budget_bytes")
    return budget if isinstance(budget, int) else None
