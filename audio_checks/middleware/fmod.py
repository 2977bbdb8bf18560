"""Reads an FMOD Studio project of 1.08 to 2.03: `.fspro` and the XML files below `Metadata`.

Volumes are in dB and add up: of the instrument and the playlist that holds it, of the tracks and the master track of
its event, and of the buses from the event's input to the master bus, with gain effects in their chains. A property at
its default is not written.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from audio_checks.middleware.reading import (
    MOST_OBJECTS,
    MOST_STEPS,
    NotRead,
    ProjectFiles,
    ProjectRefused,
    at_most,
    xml_root,
)
from audio_checks.middleware.values import Dependency, DependsOn, Part, PlayedSound, Project, gain, in_order, number

MOST_ROUTES = 64  # of one instrument, where events play events
DISTANCE = ("SpatialiserEffect", "ObjectSpatialiserEffect")
PASSIVE = ("MixerBusFader", "MixerSend", "LoudnessMeter", "GainEffect", *DISTANCE)  # change no level by themselves
AUTOMATED = (("automators", "nameOfPropertyBeingAutomated"), ("modulators", "nameOfPropertyBeingModulated"))
Found = tuple[tuple[Part, ...], tuple[Dependency, ...]]


@dataclass(slots=True)
class _Object:
    id: str
    kind: str
    file: str
    properties: dict[str, str] = field(default_factory=dict)
    relations: dict[str, tuple[str, ...]] = field(default_factory=dict)

    def first(self, name: str) -> str:
        """Return the first id of a relation, or nothing."""
        return next(iter(self.relations.get(name, ())), "")


def read_fmod(project: Path, texts: Mapping[str, str] | None = None) -> Project:
    """Return an FMOD Studio project's facts on its sounds.

    Parameters
    ----------
    project : Path
        The `.fspro` file.
    texts : mapping of str to str, optional
        See `ProjectFiles`.
    """
    files = ProjectFiles(project.parent, skipped=lambda name: name.startswith(".") or name == "Build", texts=texts)
    version = _model(files, project.name)
    reading = _Reading(files)
    for file, text in files.texts(path for path in files.ending(".xml") if path.startswith("Metadata/")):
        try:
            reading.read(file, text)
        except NotRead as error:
            files.leave_out(file, str(error), error.line)
    return Project(
        "fmod", str(project.parent), version, in_order(at_most(reading.played(), files.leave_out)), tuple(files.unread)
    )


def _model(files: ProjectFiles, file: str) -> str:
    for _, text in files.texts([file]):
        try:
            root = xml_root(text)
        except NotRead as error:
            raise ProjectRefused(f"{file}: {error}") from None
        return root.get("serializationModel", "").removeprefix("Studio.")[:64]
    return ""


class _Reading:
    def __init__(self, files: ProjectFiles) -> None:
        self._files = files
        self._objects: dict[str, _Object] = {}
        self._by_kind: dict[str, list[_Object]] = {}
        self._holders: dict[str, list[_Object]] = {}  # playlists and tracks by the ids of what they hold
        self._nested: dict[str, list[_Object]] = {}  # instruments that play an event, by its id
        self._events: dict[str, _Object] = {}  # by the file that holds them
        self._moved: dict[str, list[Dependency]] = {}  # what snapshots change, by the ids of buses
        self._strips: dict[str, list[_Object]] = {}  # VCAs by the ids of what they hold
        self._buses: dict[str, Found] = {}

    def read(self, file: str, text: str) -> None:
        """Take the objects of one file."""
        root = xml_root(text)
        if root.tag != "objects":
            raise NotRead(f"is a <{root.tag[:64]}> document; wanted <objects>")
        for element in root.iterfind("object"):
            fmod_object = _Object(element.get("id", ""), element.get("class", ""), file)
            for property_ in element.iterfind("property"):
                fmod_object.properties[property_.get("name", "")] = (property_.findtext("value") or "").strip()
            for relation in element.iterfind("relationship"):
                ids = tuple((destination.text or "").strip() for destination in relation.iterfind("destination"))
                fmod_object.relations[relation.get("name", "")] = ids
            if len(self._objects) >= MOST_OBJECTS:
                raise NotRead(f"the project has more than {MOST_OBJECTS:,} objects")
            if fmod_object.id and fmod_object.id not in self._objects:
                self._objects[fmod_object.id] = fmod_object
                self._by_kind.setdefault(fmod_object.kind, []).append(fmod_object)

    def _link(self) -> None:
        for fmod_object in self._objects.values():
            for name in ("sounds", "modules"):
                if name == "modules" and not fmod_object.kind.endswith("Track"):
                    continue  # timelines and parameters list the same instruments once more
                for id_ in fmod_object.relations.get(name, ()):
                    self._holders.setdefault(id_, []).append(fmod_object)
            for id_ in fmod_object.relations.get("masters", ()):  # its VCAs, where the strip names them
                if (vca := self._objects.get(id_)) is not None and vca.kind == "MixerVCA":
                    self._strips.setdefault(fmod_object.id, []).append(vca)
            if fmod_object.kind == "EventSound":
                self._nested.setdefault(fmod_object.first("event"), []).append(fmod_object)
            elif fmod_object.kind == "Event":
                self._events.setdefault(fmod_object.file, fmod_object)
            elif fmod_object.kind == "SnapshotProperty" and fmod_object.properties.get("propertyName") == "volume":
                name = self._snapshot_of(fmod_object)
                moved = Dependency("", "volume", "state", f'snapshot "{name}"')
                self._moved.setdefault(fmod_object.first("automatableObject"), []).append(moved)
            elif fmod_object.kind == "MixerVCA":
                for ids in fmod_object.relations.values():
                    for id_ in ids:
                        self._strips.setdefault(id_, []).append(fmod_object)

    def _snapshot_of(self, moved: _Object) -> str:
        snapshots = [snapshot for snapshot in self._by_kind.get("Snapshot", ()) if snapshot.file == moved.file]
        return snapshots[0].properties.get("name", "") if snapshots else ""

    def played(self) -> Iterator[PlayedSound]:
        """Yield a sound for each way in which an instrument reaches the output."""
        self._link()
        for sound in self._by_kind.get("SingleSound", ()):
            asset = self._objects.get(sound.first("audioFile"))
            if asset is not None and asset.properties.get("assetPath"):
                for route in self._routes(sound, MOST_ROUTES):
                    yield self._played(sound, asset, route)

    def _played(self, sound: _Object, asset: _Object, route: tuple[_Object, ...]) -> PlayedSound:
        parts: tuple[Part, ...] = ()
        depends: tuple[Dependency, ...] = ()
        looped = False
        event = next((candidate for candidate in reversed(route) if candidate.kind == "Event"), None)
        for step in route:
            object_path = self._place(step, asset)
            more = self._bus(step.id, object_path) if step.kind.startswith("Mixer") else self._own(step, object_path)
            parts, depends = parts + more[0], depends + more[1]
            looped = looped or (step.kind in ("SingleSound", "MultiSound") and step.properties.get("looping") == "true")
        heard = event is not None and bool(event.relations.get("banks"))
        name = self._event_path(event) if event is not None else ""
        return PlayedSound(
            f"Assets/{asset.properties['assetPath']}".replace("\\", "/"), self._place(sound, asset), parts,
            tuple(dict.fromkeys(depends)), (), (name,) if heard else (), heard, True, looped,
            asset.properties.get("isStreaming") == "true", self._random_set(route),
        )  # fmt: skip

    def _random_set(self, route: tuple[_Object, ...]) -> str:
        """Return the place of the instrument that plays one of its sounds: the event, where it is alone there."""
        multi = next((candidate for candidate in route if candidate.kind == "MultiSound"), None)
        event = self._events.get(multi.file) if multi is not None else None
        if multi is None or event is None:
            return ""
        others = [other.id for other in self._by_kind["MultiSound"] if other.file == multi.file]
        if len(others) == 1:
            return self._event_path(event)
        return f"{self._event_path(event)}/{multi.properties.get('name') or f'part {others.index(multi.id) + 1}'}"

    def _routes(self, sound: _Object, most: int) -> Iterator[tuple[_Object, ...]]:
        """Yield the objects from an instrument to the master bus, for each event that plays it."""
        waiting: list[tuple[_Object, ...]] = [(sound,)]
        route_count = 0
        while waiting and route_count < most:
            route = waiting.pop()
            last = route[-1]
            above: list[_Object] = []
            if len(route) <= MOST_STEPS:
                above = [holder for holder in self._above(last) if holder not in route]
            if above:
                waiting += [(*route, holder) for holder in above]
            else:
                route_count += 1
                yield route

    def _above(self, fmod_object: _Object) -> list[_Object]:
        if fmod_object.kind == "Event":
            plays = self._nested.get(fmod_object.id, [])
            own_input = self._objects.get(fmod_object.first("mixerInput"))
            return [
                *plays,
                *([own_input] if own_input is not None and (fmod_object.relations.get("banks") or not plays) else []),
            ]
        if fmod_object.kind == "EventMixerMaster":
            event = self._events.get(fmod_object.file)
            return [event] if event is not None else []
        if fmod_object.kind.endswith("Track"):
            ids = (fmod_object.first("mixerGroup"),)
        elif fmod_object.kind == "EventMixerGroup" or fmod_object.kind.startswith("Mixer"):
            ids = (fmod_object.first("output"),)
        else:
            return self._holders.get(fmod_object.id, [])
        return [self._objects[id_] for id_ in ids if id_ in self._objects]

    def _place(self, fmod_object: _Object, asset: _Object) -> str:
        """Return an object's place, for people."""
        name = fmod_object.properties.get("name", "")
        if fmod_object.kind == "Event":
            return self._event_path(fmod_object)
        if fmod_object.kind == "MixerMaster":
            return "bus:/"
        if fmod_object.kind.startswith("Mixer") and fmod_object.kind != "MixerInput":
            return f"bus:/{self._bus_name(fmod_object)}"
        event = self._events.get(fmod_object.file)
        path = self._event_path(event) if event is not None else fmod_object.file
        if fmod_object.kind == "SingleSound":
            return f"{path}/{name or asset.properties['assetPath'].rpartition('/')[2]}"
        if fmod_object.kind == "EventMixerMaster":
            return f"{path}/Master"
        return f"{path}/{name or fmod_object.kind}" if fmod_object.kind != "MixerInput" else path

    def _bus_name(self, bus: _Object) -> str:
        names: list[str] = []
        strip: _Object | None = bus
        for _ in range(MOST_STEPS):
            if strip is None or strip.kind == "MixerMaster":
                break
            names.append(strip.properties.get("name", ""))
            strip = self._objects.get(strip.first("output"))
        return "/".join(reversed(names))

    def _event_path(self, event: _Object) -> str:
        names = [event.properties.get("name", "")]
        folder = self._objects.get(event.first("folder"))
        for _ in range(MOST_STEPS):
            if folder is None or folder.kind == "MasterEventFolder":
                break
            names.append(folder.properties.get("name", ""))
            folder = self._objects.get(folder.first("folder"))
        return "event:/" + "/".join(reversed(names))

    def _bus(self, id_: str, object_path: str) -> Found:
        if id_ not in self._buses:
            self._buses[id_] = self._own(self._objects[id_], object_path)
        return self._buses[id_]

    def _own(self, fmod_object: _Object, object_path: str) -> Found:
        parts = gain(
            object_path, "volume", number(fmod_object.properties.get("volume")), fmod_object.file, _anchor(fmod_object)
        )
        depends = [Dependency(object_path, "volume", by.on, by.what) for by in self._moved.get(fmod_object.id, ())]
        for vca in {vca.id: vca for vca in self._strips.get(fmod_object.id, ())}.values():
            depends += self._automated(vca, "volume", f"vca:/{vca.properties.get('name', '')}")
            vca_place = f"vca:/{vca.properties.get('name', '')}"
            parts += gain(vca_place, "volume", number(vca.properties.get("volume")), vca.file, _anchor(vca))
        depends += self._automated(fmod_object, "volume", object_path)
        chain = self._objects.get(fmod_object.first("effectChain"))
        for effect in (self._objects.get(id_) for id_ in (chain.relations.get("effects", ()) if chain else ())):
            if effect is None or effect.properties.get("bypass") == "true":
                continue
            if effect.kind == "GainEffect":
                name = f"{object_path}: gain effect"
                parts += gain(name, "gain", number(effect.properties.get("gain")), effect.file, _anchor(effect))
                depends += self._automated(effect, "gain", name)
            elif effect.kind in DISTANCE:
                depends.append(Dependency(object_path, "effect", "distance", "spatialiser"))
            elif effect.kind not in PASSIVE:
                depends.append(Dependency(object_path, "effect", "effect", effect.kind))
        return parts, tuple(depends)

    def _automated(self, fmod_object: _Object, name: str, object_path: str) -> list[Dependency]:
        dependencies = []
        for kind, key in AUTOMATED:
            for id_ in fmod_object.relations.get(kind, ()):
                by = self._objects.get(id_)
                if by is not None and by.properties.get(key) == name:
                    on: DependsOn = "random" if by.kind == "RandomizerModulator" else "state"
                    dependencies.append(Dependency(object_path, name, on, self._automating(by)))
        return dependencies

    def _automating(self, by: _Object) -> str:
        if by.kind != "Automator":
            return by.kind
        for id_ in by.relations.get("automationCurves", ()):
            curve = self._objects.get(id_)
            parameter = self._objects.get(curve.first("parameter")) if curve is not None else None
            if parameter is not None:
                preset = self._objects.get(parameter.first("preset"))
                name = (preset or parameter).properties.get("name", "")
                return f'parameter "{name}"' if name else "the timeline"
        return "automation"


def _anchor(fmod_object: _Object) -> str:
    return f'id="{fmod_object.id}"'
