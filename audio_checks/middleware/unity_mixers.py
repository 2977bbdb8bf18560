"""The mixers of a Unity project: gains of groups in the snapshot they start with, and what changes them."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

from audio_checks.middleware.reading import MOST_STEPS
from audio_checks.middleware.unity_text import Document, documents, flow, value
from audio_checks.middleware.values import Dependency, Part, decibels, gain, number

PASSIVE = ("Attenuation", "Send", "Receive")
_CHILD = re.compile(r"^  - \{fileID: (-?\d{1,20})\}$", re.MULTILINE)
_FLOAT = re.compile(r"^    ([0-9a-f]{32}): ([^\n]{1,64})$", re.MULTILINE)
_EXPOSED = re.compile(r"^  - guid: ([0-9a-f]{32})\n    name: ([^\n]{0,256})$", re.MULTILINE)


@dataclass(slots=True)
class _Mixer:
    file: str
    groups: dict[str, Document] = field(default_factory=dict)
    effects: dict[str, Document] = field(default_factory=dict)
    parents: dict[str, str] = field(default_factory=dict)
    start: str = ""
    snapshots: dict[str, tuple[str, dict[str, float]]] = field(default_factory=dict)
    exposed: dict[str, str] = field(default_factory=dict)
    output: tuple[str, str] = ("", "")  # a group of another mixer


class Mixers:
    """All mixers, by their guids."""

    def __init__(self) -> None:
        self._mixers: dict[str, _Mixer] = {}
        self._chains: dict[tuple[str, str], tuple[tuple[Part, ...], tuple[Dependency, ...]]] = {}

    def read(self, guid: str, file: str, text: str) -> None:
        """Take one mixer."""
        mixer = _Mixer(file)
        for document in documents(text):
            if document.kind == "AudioMixerController":
                mixer.start = flow(document.text, "m_StartSnapshot")[0]
                mixer.output = flow(document.text, "m_OutputGroup")[::-1]
                mixer.exposed = {match[1]: match[2] for match in _EXPOSED.finditer(document.text)}
            elif document.kind == "AudioMixerGroupController":
                mixer.groups[document.id] = document
                for child in _children(document.text, "m_Children"):
                    mixer.parents[child] = document.id
            elif document.kind == "AudioMixerEffectController":
                mixer.effects[document.id] = document
            elif document.kind == "AudioMixerSnapshotController":
                values = {match[1]: number(match[2]) or 0.0 for match in _FLOAT.finditer(document.text)}
                mixer.snapshots[document.id] = value(document.text, "m_Name"), values
        self._mixers[guid] = mixer

    def chain(self, guid: str, id_: str) -> tuple[tuple[Part, ...], tuple[Dependency, ...]]:
        """Return the gains from a group to the output, and what else changes them; nothing for no group."""
        key = (guid, id_)
        if key not in self._chains:
            self._chains[key] = self._chain_of(guid, id_)
        return self._chains[key]

    def _chain_of(self, guid: str, id_: str) -> tuple[tuple[Part, ...], tuple[Dependency, ...]]:
        parts: tuple[Part, ...] = ()
        depends: list[Dependency] = []
        for _ in range(MOST_STEPS):
            mixer = self._mixers.get(guid)
            group = mixer.groups.get(id_) if mixer is not None else None
            if mixer is None or group is None:
                break
            more, others = _group(mixer, group)
            parts, depends = parts + more, depends + others
            if id_ in mixer.parents:
                id_ = mixer.parents[id_]
            elif mixer.output[0] != guid:
                guid, id_ = mixer.output
            else:
                break
        return parts, tuple(dict.fromkeys(depends))


def _group(mixer: _Mixer, group: Document) -> tuple[tuple[Part, ...], list[Dependency]]:
    group_path = f"{mixer.file}: {value(group.text, 'm_Name')}"
    volume = value(group.text, "m_Volume")
    _, started = mixer.snapshots.get(mixer.start, ("", {}))
    own_db = started.get(volume, 0.0)
    parts = gain(group_path, "m_Volume", own_db, mixer.file, f"{volume}:" if volume else "")
    if value(group.text, "m_Mute") == "1":
        parts += gain(group_path, "m_Mute", decibels(0), mixer.file, f"&{group.id}")
    depends = [
        Dependency(group_path, "m_Volume", "state", f'snapshot "{name}", {values.get(volume, 0.0):g} dB')
        for id_, (name, values) in mixer.snapshots.items()
        if id_ != mixer.start and values.get(volume, 0.0) != own_db
    ]
    if volume in mixer.exposed:
        depends.append(Dependency(group_path, "m_Volume", "script", f'exposed parameter "{mixer.exposed[volume]}"'))
    for id_ in _children(group.text, "m_Effects"):
        effect = mixer.effects.get(id_)
        name = value(effect.text, "m_EffectName") if effect is not None else ""
        if effect is None or name in PASSIVE or value(effect.text, "m_Bypass") == "1":
            continue
        depends.append(Dependency(group_path, "m_Effects", "state" if name == "Duck Volume" else "effect", name))
    return parts, depends


def _children(text: str, key: str) -> list[str]:
    """Return the ids of a list of references."""
    begin = text.find(f"\n  {key}:\n")
    if begin < 0:
        return []
    children = []
    at = begin + len(key) + 5
    while (match := _CHILD.match(text, at)) is not None:
        children.append(match[1])
        at = match.end() + 1
    return children
