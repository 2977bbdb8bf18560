"""Reads a Wwise project: `.wproj` and work units (`.wwu`) of 2016.1 to 2025.1.

All gains are in dB and add up: of the source, of the sound and what holds it, and of the buses up to the master. A
property at its default is not written. Of a value for each platform the one without a platform counts, else the first.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from xml.etree import ElementTree as ET

from audio_checks.middleware.reading import (
    MOST_DEPTH,
    MOST_OBJECTS,
    MOST_STEPS,
    NotRead,
    ProjectFiles,
    at_most,
    xml_root,
)
from audio_checks.middleware.values import Conversion, Dependency, Part, PlayedSound, Project, gain, in_order, number
from audio_checks.middleware.wwise_text import (
    GAINS,
    changes_of,
    curves_of,
    effects_of,
    harms_of,
    properties_of,
    states_of,
    value_of,
)

CATEGORIES = (
    "AudioObjects", "Containers", "InteractiveMusic", "Busses", "Events", "Conversions", "DynamicDialogue",
)  # fmt: skip
OBJECT_GAINS = ("Volume", "MakeUpGain", "OutputBusVolume")
BUS_GAINS = ("BusVolume", "Volume", "OutputBusVolume")
BUSES = ("Bus", "AuxBus")
PLAY = "1"  # the type of an action that plays; also the default
SEQUENCE = "0"  # a container's mode; the default, random, is not written
MOST_EVENTS_DEEP = 8  # that play one another
MASTER = ("Master Audio Bus", "{1514A4D8-1DA6-412A-A17E-75CA0C2149F3}")  # of every project


@dataclass(slots=True)
class _Object:
    id: str
    tag: str
    name: str
    file: str
    parent: str
    gains: dict[str, float] = field(default_factory=dict)
    settings: dict[str, str] = field(default_factory=dict)
    references: dict[str, tuple[str, str]] = field(default_factory=dict)  # the name and the id of what is meant
    depends: list[Dependency] = field(default_factory=list)
    sources: list[_Source] = field(default_factory=list)
    active: set[str] = field(default_factory=set)
    path: str = ""  # of a work unit that stands by itself


@dataclass(slots=True)
class _Source:
    id: str
    name: str
    language: str
    audio_file: str
    offset_db: float


def read_wwise(project: Path, texts: Mapping[str, str] | None = None) -> Project:
    """Return a Wwise project's facts on its sounds.

    Parameters
    ----------
    project : Path
        The `.wproj` file.
    texts : mapping of str to str, optional
        See `ProjectFiles`.
    """
    files = ProjectFiles(
        project.parent, skipped=lambda name: name.startswith(".") or name == "GeneratedSoundBanks", texts=texts
    )
    reading = _Reading(files)
    version = reading.read_project_file(project.name)
    for file, text in files.texts(files.ending(".wwu")):
        if any(f"<{category}" in text[:4_096] for category in CATEGORIES):
            try:
                reading.read_unit(file, text)
            except NotRead as error:
                files.leave_out(file, str(error), error.line)
    return Project(
        "wwise", str(project.parent), version, in_order(at_most(reading.played(), files.leave_out)), tuple(files.unread)
    )


class _Reading:
    def __init__(self, files: ProjectFiles) -> None:
        self._files = files
        self._objects: dict[str, _Object] = {}
        self._references: dict[str, str] = {}  # the parents of units, where only a place-holder names them
        self._targets: dict[str, list[str]] = {}  # what events play, with the events' names
        self._events: dict[str, tuple[str, list[str]]] = {}  # names and what they play, which may be another event
        self._set_by: dict[str, list[Dependency]] = {}  # objects whose level an action changes
        self._conversions: dict[str, tuple[Conversion, ...]] = {}
        self._originals = "Originals"
        self._by_lower = {file.lower(): file for file in files.files}
        self._chains: dict[str, tuple[tuple[Part, ...], tuple[Dependency, ...]]] = {}

    def read_project_file(self, file: str) -> str:
        """Return the version that the project file names."""
        for _, text in self._files.texts([file]):
            try:
                root = xml_root(text)
            except NotRead as error:
                self._files.leave_out(file, str(error), error.line)
                return ""
            for entry in root.iter("MiscSettingEntry"):
                if entry.get("Name") == "Originals" and entry.text:
                    self._originals = entry.text.replace("\\", "/").strip("/")
            return root.get("WwiseVersion", "")[:64]
        return ""

    def read_unit(self, file: str, text: str) -> None:
        """Take the objects of one work unit."""
        root = xml_root(text)
        if root.tag != "WwiseDocument":
            raise NotRead(f"is a <{root.tag[:64]}> document; wanted <WwiseDocument>")
        for category in root:
            for unit in category.iter("WorkUnit"):
                mode = unit.get("PersistMode")
                id_ = unit.get("ID", "")
                if mode == "Reference":
                    continue
                owner = unit.get("OwnerID", "") if mode == "Nested" else ""
                path = "" if owner else "\\" + file.removesuffix(".wwu").replace("/", "\\")
                self._add(_Object(id_, "WorkUnit", unit.get("Name", ""), file, owner, path=path))
                self._children(unit, id_, file, 0)
                break  # the one unit of the file

    def _add(self, wwise_object: _Object) -> None:
        if wwise_object.id and len(self._objects) < MOST_OBJECTS:
            self._objects.setdefault(wwise_object.id, wwise_object)

    def _children(self, element: ET.Element, parent: str, file: str, depth: int) -> None:
        if depth > MOST_DEPTH // 2:
            raise NotRead(f"objects lie more than {MOST_DEPTH // 2} deep in one another")
        for list_ in element.iterfind("ChildrenList"):
            for child in list_:
                id_ = child.get("ID", "")
                if child.tag == "WorkUnit":
                    self._references[id_] = parent
                elif child.tag == "Event":
                    self._event(child)
                elif child.tag == "Conversion":
                    self._conversions[id_] = harms_of(child, file)
                elif child.tag == "DialogueEvent":
                    for target in child.iter("ObjectRef"):
                        self._targets.setdefault(target.get("ID", ""), []).append(child.get("Name", ""))
                elif child.tag == "AudioFileSource":
                    self._source(child, parent)
                elif id_:
                    self._add(_object(child, parent, file))
                    self._children(child, id_, file, depth + 1)

    def _source(self, element: ET.Element, parent: str) -> None:
        audio_file = (element.findtext("AudioFile") or "").strip()
        holder = self._objects.get(parent)
        if holder is None or not audio_file:
            return
        offset_db = 0.0
        for name, property_ in properties_of(element):
            if name == "VolumeOffset":
                offset_db = number(value_of(property_)) or 0.0
        language = (element.findtext("Language") or "SFX").strip()
        holder.sources.append(_Source(element.get("ID", ""), element.get("Name", ""), language, audio_file, offset_db))

    def _event(self, event: ET.Element) -> None:
        name = event.get("Name", "")
        _, plays = self._events.setdefault(event.get("ID", ""), (name, []))
        for action in event.iterfind("ChildrenList/Action"):
            properties = dict(properties_of(action))
            kind = value_of(properties["ActionType"]) if "ActionType" in properties else PLAY
            target = action.find("ReferenceList/Reference[@Name='Target']/ObjectRef")
            if target is None:
                continue
            id_ = target.get("ID", "")
            if kind == PLAY:
                plays.append(id_)
            elif any("Volume" in property_name for property_name in properties):
                self._set_by.setdefault(id_, []).append(
                    Dependency("", "Volume", "state", f'an action of event "{name}"')
                )

    def _link_events(self) -> None:
        for name, plays in self._events.values():
            ids = dict.fromkeys(plays)
            for _ in range(MOST_EVENTS_DEEP):
                more = [
                    event for id_ in ids if id_ in self._events for event in self._events[id_][1] if event not in ids
                ]
                if not more:
                    break
                ids.update(dict.fromkeys(more))
            for id_ in ids:
                self._targets.setdefault(id_, []).append(name)

    def played(self) -> Iterator[PlayedSound]:
        """Yield a sound for each file that an object plays."""
        self._link_events()
        for wwise_object in self._objects.values():
            for source in _active(wwise_object):
                yield self._sound(wwise_object, source)

    def _sound(self, wwise_object: _Object, source: _Source) -> PlayedSound:
        path = self._path(wwise_object.id)
        parts, depends = self._chain(wwise_object)
        offset = gain(
            f"{path}\\{source.name}", "VolumeOffset", source.offset_db, wwise_object.file, f'ID="{source.id}"'
        )
        events: dict[str, None] = {}
        looped, streamed = None, None
        conversion: tuple[Conversion, ...] = ()
        converted = False
        for holder in self._holders(wwise_object):
            events.update(dict.fromkeys(self._targets.get(holder.id, ())))
            has_own = holder.settings.get("OverrideConversion") == "True" or self._is_top(holder)
            if not converted and has_own and "Conversion" in holder.references:
                converted = True
                conversion = self._conversions.get(holder.references["Conversion"][1], ())
        if wwise_object.tag == "Sound":
            looped = wwise_object.settings.get("IsLoopingEnabled") == "True"
            streamed = wwise_object.settings.get("IsStreamingEnabled") == "True"
        return PlayedSound(
            self._file_of(source), path, offset + parts, depends, conversion,
            tuple(events), bool(events), True, looped, streamed, self._random_set(wwise_object),
        )  # fmt: skip

    def _random_set(self, wwise_object: _Object) -> str:
        """Return the nearest container that plays its sounds at random; one that plays a sequence is none."""
        for holder in self._holders(wwise_object):
            if holder.tag == "RandomSequenceContainer":
                return "" if holder.settings.get("RandomOrSequence") == SEQUENCE else self._path(holder.id)
        return ""

    def _file_of(self, source: _Source) -> str:
        folder = "SFX" if source.language == "SFX" else f"Voices/{source.language}"
        path = f"{self._originals}/{folder}/{source.audio_file}".replace("\\", "/")
        return self._by_lower.get(path.lower(), path)

    def _parent(self, wwise_object: _Object) -> _Object | None:
        return self._objects.get(wwise_object.parent or self._references.get(wwise_object.id, ""))

    def _holders(self, wwise_object: _Object) -> Iterator[_Object]:
        """Yield an object and all that hold it, up to its work unit."""
        holder: _Object | None = wwise_object
        for _ in range(MOST_STEPS):
            if holder is None:
                return
            yield holder
            holder = self._parent(holder)

    def _is_top(self, wwise_object: _Object) -> bool:
        """Whether nothing with properties of its own holds an object."""
        return all(holder.tag in ("WorkUnit", "Folder") for holder in list(self._holders(wwise_object))[1:])

    def _path(self, id_: str) -> str:
        names: list[str] = []
        for holder in self._holders(self._objects[id_]):
            if holder.path:
                names.append(holder.path)
                break
            names.append(holder.name)
        else:
            names.append("")
        return "\\".join(reversed(names))

    def _chain(self, wwise_object: _Object) -> tuple[tuple[Part, ...], tuple[Dependency, ...]]:
        """Return the gains of an object and all above it, and what else changes them."""
        parts, depends = self._own(wwise_object, OBJECT_GAINS)
        routed = None
        distance = False
        for holder in list(self._holders(wwise_object))[1:]:
            if holder.tag in ("WorkUnit", "Folder"):
                continue
            more = self._own(holder, OBJECT_GAINS)
            parts, depends = parts + more[0], depends + more[1]
        for holder in self._holders(wwise_object):
            top = self._is_top(holder)
            if routed is None and (top or holder.settings.get("OverrideOutput") == "True"):
                routed = holder.references.get("OutputBus", MASTER if top else None)
            if not distance and (top or holder.settings.get("OverridePositioning") == "True"):
                if "Attenuation" in holder.references:
                    name = holder.references["Attenuation"][0]
                    depends += (Dependency(self._path(holder.id), "Attenuation", "distance", f'attenuation "{name}"'),)
                distance = True
            if top and holder.tag not in ("WorkUnit", "Folder"):
                break
        if routed is not None and routed[1] in self._objects:
            more = self._bus_chain(routed[1])
            parts, depends = parts + more[0], depends + more[1]
        return parts, tuple(dict.fromkeys(depends))

    def _own(self, wwise_object: _Object, names: tuple[str, ...]) -> tuple[tuple[Part, ...], tuple[Dependency, ...]]:
        if not (wwise_object.gains or wwise_object.depends or wwise_object.id in self._set_by):
            return (), ()
        path = self._path(wwise_object.id)
        parts = tuple(
            part
            for name in names
            if name in wwise_object.gains
            for part in gain(path, name, wwise_object.gains[name], wwise_object.file, f'ID="{wwise_object.id}"')
        )
        set_by = [Dependency(path, by.property, by.on, by.what) for by in self._set_by.get(wwise_object.id, ())]
        return parts, (*(Dependency(path, by.property, by.on, by.what) for by in wwise_object.depends), *set_by)

    def _bus_chain(self, id_: str) -> tuple[tuple[Part, ...], tuple[Dependency, ...]]:
        if id_ not in self._chains:
            parts: tuple[Part, ...] = ()
            depends: tuple[Dependency, ...] = ()
            for bus in self._holders(self._objects[id_]):
                if bus.tag in BUSES:
                    more = self._own(bus, BUS_GAINS)
                    parts, depends = parts + more[0], depends + more[1]
            self._chains[id_] = parts, depends
        return self._chains[id_]


def _object(element: ET.Element, parent: str, file: str) -> _Object:
    wwise_object = _Object(element.get("ID", ""), element.tag, element.get("Name", ""), file, parent)
    for name, property_ in properties_of(element):
        if name in GAINS:
            if (value := number(value_of(property_))) is not None:
                wwise_object.gains[name] = value
            wwise_object.depends += changes_of(name, property_)
        elif name in (
            "OverrideOutput", "OverrideConversion", "OverridePositioning", "IsLoopingEnabled", "IsStreamingEnabled",
            "RandomOrSequence",
        ):  # fmt: skip
            wwise_object.settings[name] = value_of(property_)
        elif name == "EnableLoudnessNormalization" and value_of(property_) == "True":
            wwise_object.depends.append(Dependency("", name, "loudness", "loudness normalization of the source"))
        elif name == "HdrEnable" and value_of(property_) == "True":
            wwise_object.depends.append(Dependency("", name, "state", "the HDR window"))
    for reference in element.iterfind("ReferenceList/Reference"):
        meant = reference.find("ObjectRef")
        name = reference.get("Name", "")
        if meant is not None:
            wwise_object.references[name] = (meant.get("Name", ""), meant.get("ID", ""))
        if name.startswith("Effect") and name[6:].isdigit():
            what = meant.get("Name", "") if meant is not None else reference.get("PluginName", "")
            wwise_object.depends.append(Dependency("", name, "effect", f'effect "{what}"'))
    wwise_object.depends += [*states_of(element), *curves_of(element), *effects_of(element)]
    for track in element.iterfind("BlendTrackList/BlendTrack"):
        for name, property_ in properties_of(track):
            if name in GAINS:
                wwise_object.depends += changes_of(name, property_)
    for duck in element.iter("DuckInfo") if element.tag in BUSES else ():
        wwise_object.depends.append(Dependency("", "Ducking", "state", f'ducked buses "{duck.get("Name", "")}"'))
    wwise_object.active = {source.get("ID", "") for source in element.iterfind("ActiveSourceList/ActiveSource")}
    return wwise_object


def _active(wwise_object: _Object) -> list[_Source]:
    """Return the sources that are played: of each language the active ones, else all."""
    chosen = [source for source in wwise_object.sources if source.id in wwise_object.active]
    covered = {source.language for source in chosen}
    return [source for source in wwise_object.sources if source in chosen or source.language not in covered]
