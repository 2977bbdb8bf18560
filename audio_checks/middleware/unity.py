"""Reads a Unity project whose assets are text: `.meta` files, prefabs, scenes and mixers.

Unity writes a subset of YAML with tags of its own. It is read by patterns that take linear time; no YAML reader runs
over it, so there are neither tags nor aliases. A volume of a source is a factor, that of a mixer's group is in dB.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

from audio_checks.middleware.reading import SKIPPED_FOLDERS, NotRead, ProjectFiles, at_most
from audio_checks.middleware.unity_mixers import Mixers
from audio_checks.middleware.unity_text import Document, documents, flow, value
from audio_checks.middleware.values import (
    Conversion,
    Dependency,
    Part,
    PlayedSound,
    Project,
    decibels,
    gain,
    in_order,
    number,
)

AUDIO = (".wav", ".ogg", ".mp3", ".aif", ".aiff", ".flac", ".opus", ".it", ".mod", ".s3m", ".xm")
HOLDERS = (".unity", ".prefab", ".asset", ".playable", ".controller")
MOST_PREFABS_DEEP = 16
BY_NAME = ("/Resources/", "/StreamingAssets/")  # a script may load what is there by its name
CHANGED = ("m_Volume", "m_audioClip", "m_Resource", "OutputAudioMixerGroup", "Mute", "Loop")
LONGEST_FIELD = 1_024
_GUID = re.compile(r"^guid: ([0-9a-f]{32})$", re.MULTILINE)
MOST_STEPS_OF_PREFABS = 2_000_000  # of the search for sources that prefabs hold in prefabs
_CLIP = re.compile(r"\{fileID: 8300000, guid: ([0-9a-f]{32})")
_BLEND = re.compile(r"^  panLevelCustomCurve:\n(?:    .*\n)*?      value: ([^\n]{1,32})$", re.MULTILINE)


@dataclass(slots=True)
class _Source:
    """An AudioSource: what it plays, how loud, and through which group."""

    clip: str = ""
    resource: str = ""
    volume: float = 1.0
    volume_file: str = ""
    anchor: str = ""
    group: tuple[str, str] = ("", "")  # the mixer's guid and the group's id in it
    is_muted: bool = False
    is_looped: bool = False
    is_spatial: bool = False
    name: str = ""


@dataclass(slots=True)
class _Holder:
    """A scene, a prefab or another asset."""

    file: str
    documents: dict[str, Document] = field(default_factory=dict)
    instances: list[Document] = field(default_factory=list)


def read_unity(root: Path, texts: Mapping[str, str] | None = None) -> Project:
    """Return a Unity project's facts on its sounds.

    Parameters
    ----------
    root : Path
        The folder that holds `Assets` and `ProjectSettings`.
    texts : mapping of str to str, optional
        See `ProjectFiles`.
    """
    files = ProjectFiles(root, skipped=lambda name: name in SKIPPED_FOLDERS or name.endswith("~"), texts=texts)
    reading = _Reading(files)
    played = in_order(at_most(reading.played(), files.leave_out))
    return Project("unity", str(root), _version(files), played, tuple(files.unread))


def _version(files: ProjectFiles) -> str:
    try:
        text = files.text("ProjectSettings/ProjectVersion.txt")
    except NotRead:
        return ""  # it is only shown
    return value(text, "m_EditorVersion", indent=0)[:64]


class _Reading:
    def __init__(self, files: ProjectFiles) -> None:
        self._files = files
        self._file_of: dict[str, str] = {}  # assets by their guid
        self._conversions: dict[str, tuple[Conversion, ...]] = {}
        self._streamed: dict[str, bool] = {}
        self._holders: dict[str, _Holder] = {}  # by guid
        self._steps = 0
        self._resolved: dict[tuple[str, str], _Source | None] = {}
        self._containers: dict[str, list[tuple[str, tuple[Part, ...]]]] = {}
        self._read_metas()
        self.mixers = Mixers()
        guids = {file: guid for guid, file in self._file_of.items()}
        for file, text in files.texts(files.ending(".mixer")):
            self.mixers.read(guids.get(file, file), file, text)
        self._manager = self._manager_parts()
        self._scripted: dict[str, list[tuple[str, str]]] = {}  # clips in the fields of scripts: holder and field
        for file, text in files.texts(files.ending(*HOLDERS)):
            self._read_holder(guids.get(file, file), file, text)

    def _read_metas(self) -> None:
        for file, text in self._files.texts(self._files.ending(".meta")):
            if (match := _GUID.search(text)) is None:
                continue
            asset = file[: -len(".meta")]
            self._file_of[match[1]] = asset
            if asset.lower().endswith(AUDIO) and "\nAudioImporter:" in text:
                self._conversions[match[1]] = tuple(_harms(text, file))
                self._streamed[match[1]] = value(text, "loadType", indent=4) == "2"

    def _manager_parts(self) -> tuple[Part, ...]:
        file = "ProjectSettings/AudioManager.asset"
        for _, text in self._files.texts([file] if file in self._files.files else []):
            volume = number(value(text, "m_Volume"))
            return gain("AudioManager", "m_Volume", None if volume is None else decibels(volume), file, "AudioManager")
        return ()

    def _read_holder(self, guid: str, file: str, text: str) -> None:
        if not text.startswith("%YAML"):
            if file.endswith((".unity", ".prefab")):
                if "\0" in text[:4_096]:
                    what = "is binary; wanted text: Project Settings, Editor, Asset Serialization, Force Text"
                else:
                    what = "does not begin with %YAML; wanted a scene or a prefab as Unity writes it"
                self._files.leave_out(file, what)
            return
        if not any(word in text for word in ("AudioSource", "8300000", "PrefabInstance", "AudioRandomContainer")):
            return
        holder = _Holder(file)
        try:
            for document in documents(text):
                holder.documents[document.id] = document
                if document.kind == "PrefabInstance":
                    holder.instances.append(document)
        except NotRead as error:
            self._files.leave_out(file, str(error), error.line)
            return
        self._holders[guid] = holder
        for document in holder.documents.values():
            if document.kind == "MonoBehaviour" or (file.endswith(".playable") and document.kind != "AudioSource"):
                for match in _CLIP.finditer(document.text):
                    self._scripted.setdefault(match[1], []).append((file, _field_before(document.text, match.start())))
            elif document.kind == "AudioRandomContainer":
                self._containers[guid] = _container(holder, document)

    def played(self) -> Iterator[PlayedSound]:
        """Yield a sound for each source that plays a clip, and for each clip that only scripts know."""
        for guid, holder in self._holders.items():
            for document, source in self._sources(guid, holder):
                for clip, more in self._clips(source):
                    if clip in self._file_of:
                        yield self._sound(holder, document, source, clip, more)
        for clip, places in self._scripted.items():
            if clip in self._file_of:
                for holder_file, name in dict.fromkeys(places):
                    depends = (Dependency(f"{holder_file}: {name}", name, "script", "the script that plays it"),)
                    yield PlayedSound(
                        self._file_of[clip], f"{holder_file}: {name}", (), depends, self._conversions.get(clip, ()),
                        (holder_file,), True, False, None, self._streamed.get(clip),
                    )  # fmt: skip
        for clip, file in self._file_of.items():
            if clip in self._conversions and any(name in f"/{file}" for name in BY_NAME):
                depends = (Dependency(file, "", "script", "the script that loads it by its name"),)
                yield PlayedSound(
                    file, file, (), depends, self._conversions[clip], (), None, False, None, self._streamed.get(clip)
                )

    def _sources(self, guid: str, holder: _Holder) -> Iterator[tuple[Document, _Source]]:
        for document in holder.documents.values():
            if document.kind == "AudioSource" and not document.is_stripped:
                if (source := self._source(guid, document.id, 0)) is not None:
                    yield document, source
            elif document.kind == "PrefabInstance":
                for (id_, of), changes in document.modifications().items():
                    if any(name in CHANGED for name, _, _ in changes):
                        base = self._source(of, id_, 1)
                        if base is not None:
                            yield document, _with_changes(base, document, id_, of, holder.file)

    def _source(self, guid: str, id_: str, depth: int) -> _Source | None:
        """Return the source of an id in a prefab or scene, through prefabs that are held in it."""
        key = (guid, id_)
        if key in self._resolved:
            return self._resolved[key]
        self._resolved[key] = None  # ends a circle
        holder = self._holders.get(guid)
        if holder is None or depth > MOST_PREFABS_DEEP:
            return None
        document = holder.documents.get(id_)
        source: _Source | None = None
        if document is not None and document.is_stripped and document.kind == "AudioSource":
            base_id, base_guid = flow(document.text, "m_CorrespondingSourceObject")
            source = self._source(base_guid, base_id, depth + 1)
            instance = holder.documents.get(flow(document.text, "m_PrefabInstance")[0])
            if source is not None and instance is not None:
                source = _with_changes(source, instance, base_id, base_guid, holder.file)
        elif document is not None and document.kind == "AudioSource":
            source = self._read_source(holder, document)
        elif document is None and id_.lstrip("-").isdigit():
            for instance in holder.instances:
                self._steps += 1
                if self._steps > MOST_STEPS_OF_PREFABS:
                    break
                base_guid = instance.source_prefab()
                base_id = str((int(instance.id) ^ int(id_)) & 0x7FFFFFFFFFFFFFFF)
                base = self._source(base_guid, base_id, depth + 1)
                if base is not None:
                    source = _with_changes(base, instance, base_id, base_guid, holder.file)
                    break
        self._resolved[key] = source
        return source

    def _read_source(self, holder: _Holder, document: Document) -> _Source:
        text = document.text
        volume = number(value(text, "m_Volume"))
        group_id, group_guid = flow(text, "OutputAudioMixerGroup")
        blend = _BLEND.search(text)
        owner = holder.documents.get(flow(text, "m_GameObject")[0])
        return _Source(
            flow(text, "m_audioClip")[1], flow(text, "m_Resource")[1], 1.0 if volume is None else volume, holder.file,
            f"&{document.id}", (group_guid, group_id), value(text, "Mute") == "1", value(text, "Loop") == "1",
            blend is not None and bool(number(blend[1])), value(owner.text, "m_Name") if owner is not None else "",
        )  # fmt: skip

    def _clips(self, source: _Source) -> Iterator[tuple[str, tuple[Part, ...]]]:
        if source.resource in self._containers:
            yield from self._containers[source.resource]
        elif clip := source.resource or source.clip:
            yield clip, ()

    def _sound(
        self, holder: _Holder, document: Document, source: _Source, clip: str, more: tuple[Part, ...]
    ) -> PlayedSound:
        object_path = f"{holder.file}: {source.name or document.id}"
        parts = more + gain(object_path, "m_Volume", decibels(source.volume), source.volume_file, source.anchor)
        if source.is_muted:
            parts += gain(object_path, "Mute", decibels(0), holder.file, source.anchor)
        group_parts, depends = self.mixers.chain(*source.group)
        if source.is_spatial:
            depends += (Dependency(object_path, "panLevelCustomCurve", "distance", "3D sound"),)
        return PlayedSound(
            self._file_of[clip], object_path, parts + group_parts + self._manager, depends,
            self._conversions.get(clip, ()),
            (holder.file,), True, True, source.is_looped, self._streamed.get(clip), self._random_set(source),
        )  # fmt: skip

    def _random_set(self, source: _Source) -> str:
        file = self._holders[source.resource].file if source.resource in self._containers else ""
        return file.removesuffix(".asset")


def _with_changes(base: _Source, instance: Document, id_: str, of: str, file: str) -> _Source:
    """Return a source as an instance of its prefab changes it."""
    changed = replace(base)
    for name, text, reference in instance.modifications().get((id_, of), ()):
        if name == "m_Volume" and (volume := number(text)) is not None:
            changed.volume, changed.volume_file, changed.anchor = volume, file, f"fileID: {id_}, guid: {of}"
        elif name == "m_audioClip":
            changed.clip = reference[1]
        elif name == "m_Resource":
            changed.resource = reference[1]
        elif name == "OutputAudioMixerGroup":
            changed.group = (reference[1], reference[0])
        elif name == "Mute":
            changed.is_muted = text == "1"
        elif name == "Loop":
            changed.is_looped = text == "1"
    return changed


def _field_before(text: str, at: int) -> str:
    """Return the name of the field that holds what stands at a place; of a list, the list's."""
    begin = max(0, at - LONGEST_FIELD)
    for line in reversed(text[begin:at].split("\n")):
        name = line.strip().removeprefix("- ").partition(":")[0].strip()
        if name and name != "-" and "{" not in name:
            return name
    return ""


def _container(holder: _Holder, document: Document) -> list[tuple[str, tuple[Part, ...]]]:
    """Return the clips of a random container, with the container's gain and each one's own, in dB."""
    name = f"{holder.file}: {value(document.text, 'm_Name')}"
    own_gain = _element_gain(holder, document, name)
    clips = []
    for element in holder.documents.values():
        if element.kind == "AudioContainerElement":
            element_gain = _element_gain(holder, element, f"{name}, element")
            clips.append((flow(element.text, "m_AudioClip")[1], element_gain + own_gain))
    return clips


def _element_gain(holder: _Holder, document: Document, name: str) -> tuple[Part, ...]:
    return gain(name, "m_Volume", number(value(document.text, "m_Volume")), holder.file, f"&{document.id}")


def _harms(text: str, file: str) -> Iterator[Conversion]:
    """Yield the import settings that change a sound's level, rate or last bit."""
    if value(text, "forceToMono") == "1":
        if value(text, "normalize") != "0":
            yield Conversion("forceToMono, normalize", "mixed to mono, and its peak is then raised to full scale", file)
        else:
            yield Conversion("forceToMono", "mixed to mono", file)
    for indent, where in ((4, ""), (6, " of a platform")):
        if value(text, "compressionFormat", indent=indent) == "2":
            yield Conversion(f"compressionFormat{where}", "ADPCM: 4 bits a sample undo the dither", file)
        rate = value(text, "sampleRateSetting", indent=indent)
        if rate == "1":
            yield Conversion(f"sampleRateSetting{where}", "resampled to what Unity takes for sufficient", file)
        elif rate == "2":
            hz = number(value(text, "sampleRateOverride", indent=indent)) or 0
            yield Conversion(f"sampleRateSetting{where}", f"resampled to {hz:,.0f} Hz", file)
