"""The demands of a brief's answers on the delivery spec: the tables as they would be, and each difference."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from copy import deepcopy
from dataclasses import dataclass
from typing import Any

import audio_checks
from app.briefs.questions import BY_KEY, EVERYTHING, SMALL_PLATFORMS
from app.briefs.rules import Answers, is_answered

Tables = dict[str, Any]
BYTES_IN_A_MB = 1_000_000
ACCEPTED = {
    "44k1": {"sample_rates_hz": [44_100, 48_000, 96_000], "bit_depths": [16, 24]},
    "48k": {"sample_rates_hz": [48_000, 96_000], "bit_depths": [24]},
}
CHANNELS = {"stereo": (1, 2), "5.1": (6,), "7.1": (8,), "ambisonic": (4,)}
HANDHELD = {"sample_rate_hz": 22_050, "bit_depth": 16, "channels": 1}
KINDS = {
    "ambience": "ambience",
    "foley": "event",
    "ui": "event",
    "weapon": "natural-decay",
    "impact": "natural-decay",
    "music": "music",
    "vo": "voice",
    "narration": "voice",
}


@dataclass(frozen=True)
class SpecChange:
    """One key of the spec that an answer changes."""

    place: str  # dotted, as in `engine.adds`
    before: Any  # None: it was absent
    after: Any  # None: it goes
    question: str


def proposal(present: Mapping[str, Any], answers: Answers) -> tuple[Tables, Sequence[SpecChange]]:
    """Return the tables of a spec with what the answers ask for, and what differs from the present ones."""
    draft = _Draft(present)
    for key, write in _WRITERS.items():
        if is_answered(BY_KEY[key], answers):
            write(draft, answers[key]["value"], answers)
    return draft.tables, draft.changes


class _Draft:
    """Tables that answers are written into, one key after the other."""

    def __init__(self, present: Mapping[str, Any]) -> None:
        self.tables: Tables = deepcopy(dict(present))
        self.changes: list[SpecChange] = []

    def at(self, *path: str) -> Any:
        """Return the value at a place, None where there is none."""
        node: Any = self.tables
        for key in path:
            node = node.get(key) if isinstance(node, dict) else None
        return node

    def put(self, question: str, path: Sequence[str], value: Any) -> None:
        """Write a value, or remove what is there for None; what is equal is not a change."""
        before = self.at(*path)
        if before == value:
            return
        *tables, key = path
        table = self.tables
        for name in tables:
            table = table.setdefault(name, {})
        if value is None:
            del table[key]
        else:
            table[key] = deepcopy(value)
        self.changes.append(SpecChange(".".join(path), before, value, question))


def _write_categories(draft: _Draft, value: list[str], _answers: Answers) -> None:
    for category in value:
        if draft.at("categories", category) is None:
            kind = KINDS.get(category)
            draft.put("categories", ("categories", category), {"kind": kind} if kind else {})


def _write_player(draft: _Draft, value: str, _answers: Answers) -> None:
    preset = audio_checks.TARGET_PRESETS[value]
    if draft.at("targets", preset.name) is None:
        table = audio_checks.parse_spec(f"format = 1\n{preset.to_toml()}").tables["targets"][preset.name]
        draft.put("player", ("targets", preset.name), table)


def _write_platforms(draft: _Draft, value: list[str], _answers: Answers) -> None:
    wanted = bool(SMALL_PLATFORMS.intersection(value))
    present = draft.at("targets", "handheld")
    if wanted and present is None:
        draft.put("platforms", ("targets", "handheld"), HANDHELD)
    elif not wanted and present == HANDHELD and len(draft.at("targets")) > 1:  # as the preset made it
        draft.put("platforms", ("targets", "handheld"), None)


def _write_memory(draft: _Draft, value: float, _answers: Answers) -> None:
    targets = draft.at("targets") or {}
    smallest = "handheld" if "handheld" in targets else next(iter(targets), None)
    if smallest is not None:
        draft.put("memory", ("targets", smallest, "budget_bytes"), round(value * BYTES_IN_A_MB))


def _write_quality(draft: _Draft, value: str, _answers: Answers) -> None:
    for key, accepted in ACCEPTED[value].items():
        draft.put("quality", ("accept", key), accepted)


def _write_surround(draft: _Draft, value: list[str], _answers: Answers) -> None:
    channels = sorted({1, 2}.union(*(CHANNELS[key] for key in value)))
    draft.put("surround", ("accept", "channels"), channels)


def _write_effects(draft: _Draft, value: dict[str, list[str]], _answers: Answers) -> None:
    everything = value.get(EVERYTHING)
    if everything is not None:
        draft.put("effects", ("engine", "adds"), everything)
    overall = draft.at("engine", "adds") or []
    for category, adds in value.items():
        if category == EVERYTHING:
            continue
        stated = draft.at("categories", category, "engine", "adds")
        if (overall if stated is None else stated) != adds:
            draft.put("effects", ("categories", category, "engine", "adds"), adds)


def _write_naming(draft: _Draft, value: dict[str, Any], _answers: Answers) -> None:
    for other_rule in ("pattern", "grammar", "ucs_ids"):
        if draft.at("naming", other_rule) is not None:
            draft.put("naming", ("naming", other_rule), None)
    for key in ("tokens", "separator", "extension"):
        draft.put("naming", ("naming", key), value[key])


_WRITERS: Mapping[str, Callable[[_Draft, Any, Answers], None]] = {
    "categories": _write_categories,
    "platforms": _write_platforms,
    "player": _write_player,
    "memory": _write_memory,
    "quality": _write_quality,
    "surround": _write_surround,
    "effects": _write_effects,
    "naming": _write_naming,
}


def lines_of(change: SpecChange) -> Iterator[str]:
    """Yield a change as lines of TOML: the table's head where it is one, and `key = value`."""
    yield from audio_checks.DeliverySpec(tables=_nested(change.place, change.after)).to_toml().strip().splitlines()


def _nested(path: str, value: Any) -> Tables:
    for key in reversed(path.split(".")):
        value = {key: value}
    return dict(value)
