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
    for file, text in files.texts(one for one in files.ending(".xml") if one.startswith("Metadata/")):
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
            one = _Object(element.get("id", ""), element.get("class", ""), file)
            for property_ in element.iterfind("property"):
                one.properties[property_.get("name", "")] = (property_.findtext("value") or "").strip()
            for relation in element.iterfind("relationship"):
                ids = tuple((destination.text or "").strip() for destination in relation.iterfind("destination"))
                one.relations[relation.get("name", "")] = ids
            if len(self._objects) >= MOST_OBJECTS:
                raise NotRead(f"the project has more than {MOST_OBJECTS:,} objects")
            if one.id and one.id not in self._objects:
                self._objects[one.id] = one
                self._by_kind.setdefault(one.kind, []).append(one)

    def _link(self) -> None:
        for one in self._objects.values():
            for name in ("sounds", "modules"):
                if name == "modules" and not one.kind.endswith("Track"):
                    continue  # timelines and parameters list the same instruments once more
                for id_ in one.relations.get(name, ()):
                    self._holders.setdefault(id_, []).append(one)
            for id_ in one.relations.get("masters", ()):  # its VCAs, where the strip names them
                if (vca := self._objects.get(id_)) is not None and vca.kind == "MixerVCA":
                    self._strips.setdefault(one.id, []).append(vca)
            if one.kind == "EventSound":
                self._nested.setdefault(one.first("event"), []).append(one)
            elif one.kind == "Event":
                self._events.setdefault(one.file, one)
            elif one.kind == "SnapshotProperty" and one.properties.get("propertyName") == "volume":
                name = self._snapshot_of(one)
                moved = Dependency("", "volume", "state", f'snapshot "{name}"')
                self._moved.setdefault(one.first("automatableObject"), []).append(moved)
            elif one.kind == "MixerVCA":
                for ids in one.relations.values():
                    for id_ in ids:
                        self._strips.setdefault(id_, []).append(one)

    def _snapshot_of(self, moved: _Object) -> str:
        snapshots = [one for one in self._by_kind.get("Snapshot", ()) if one.file == moved.file]
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
        event = next((one for one in reversed(route) if one.kind == "Event"), None)
        for one in route:
            place = self._place(one, asset)
            more = self._bus(one.id, place) if one.kind.startswith("Mixer") else self._own(one, place)
            parts, depends = parts + more[0], depends + more[1]
            looped = looped or (one.kind in ("SingleSound", "MultiSound") and one.properties.get("looping") == "true")
        heard = event is not None and bool(event.relations.get("banks"))
        name = self._event_path(event) if event is not None else ""
        return PlayedSound(
            f"Assets/{asset.properties['assetPath']}".replace("\\", "/"), self._place(sound, asset), parts,
            tuple(dict.fromkeys(depends)), (), (name,) if heard else (), heard, True, looped,
            asset.properties.get("isStreaming") == "true", self._random_set(route),
        )  # fmt: skip

    def _random_set(self, route: tuple[_Object, ...]) -> str:
        """Return the place of the instrument that plays one of its sounds: the event, where it is alone there."""
        multi = next((one for one in route if one.kind == "MultiSound"), None)
        event = self._events.get(multi.file) if multi is not None else None
        if multi is None or event is None:
            return ""
        others = [one.id for one in self._by_kind["MultiSound"] if one.file == multi.file]
        if len(others) == 1:
            return self._event_path(event)
        return f"{self._event_path(event)}/{multi.properties.get('name') or f'part {others.index(multi.id) + 1}'}"

    def _routes(self, sound: _Object, most: int) -> Iterator[tuple[_Object, ...]]:
        """Yield the objects from an instrument to the master bus, for each event that plays it."""
        waiting: list[tuple[_Object, ...]] = [(sound,)]
        found = 0
        while waiting and found < most:
            route = waiting.pop()
            last = route[-1]
            above: list[_Object] = []
            if len(route) <= MOST_STEPS:
                above = [one for one in self._above(last) if one not in route]
            if above:
                waiting += [(*route, one) for one in above]
            else:
                found += 1
                yield route

    def _above(self, one: _Object) -> list[_Object]:
        if one.kind == "Event":
            plays = self._nested.get(one.id, [])
            own = self._objects.get(one.first("mixerInput"))
            return [*plays, *([own] if own is not None and (one.relations.get("banks") or not plays) else [])]
        if one.kind == "EventMixerMaster":
            event = self._events.get(one.file)
            return [event] if event is not None else []
        if one.kind.endswith("Track"):
            ids = (one.first("mixerGroup"),)
        elif one.kind == "EventMixerGroup" or one.kind.startswith("Mixer"):
            ids = (one.first("output"),)
        else:
            return self._holders.get(one.id, [])
        return [self._objects[id_] for id_ in ids if id_ in self._objects]

    def _place(self, one: _Object, asset: _Object) -> str:
        """Return an object's place, for people."""
        name = one.properties.get("name", "")
        if one.kind == "Event":
            return self._event_path(one)
        if one.kind == "MixerMaster":
            return "bus:/"
        if one.kind.startswith("Mixer") and one.kind != "MixerInput":
            return f"bus:/{self._bus_name(one)}"
        event = self._events.get(one.file)
        path = self._event_path(event) if event is not None else one.file
        if one.kind == "SingleSound":
            return f"{path}/{name or asset.properties['assetPath'].rpartition('/')[2]}"
        if one.kind == "EventMixerMaster":
            return f"{path}/Master"
        return f"{path}/{name or one.kind}" if one.kind != "MixerInput" else path

    def _bus_name(self, bus: _Object) -> str:
        names: list[str] = []
        one: _Object | None = bus
        for _ in range(MOST_STEPS):
            if one is None or one.kind == "MixerMaster":
                break
            names.append(one.properties.get("name", ""))
            one = self._objects.get(one.first("output"))
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

    def _bus(self, id_: str, place: str) -> Found:
        if id_ not in self._buses:
            self._buses[id_] = self._own(self._objects[id_], place)
        return self._buses[id_]

    def _own(self, one: _Object, place: str) -> Found:
        parts = gain(place, "volume", number(one.properties.get("volume")), one.file, _anchor(one))
        depends = [Dependency(place, "volume", by.on, by.what) for by in self._moved.get(one.id, ())]
        for vca in {vca.id: vca for vca in self._strips.get(one.id, ())}.values():
            depends += self._automated(vca, "volume", f"vca:/{vca.properties.get('name', '')}")
            vca_place = f"vca:/{vca.properties.get('name', '')}"
            parts += gain(vca_place, "volume", number(vca.properties.get("volume")), vca.file, _anchor(vca))
        depends += self._automated(one, "volume", place)
        chain = self._objects.get(one.first("effectChain"))
        for effect in (self._objects.get(id_) for id_ in (chain.relations.get("effects", ()) if chain else ())):
            if effect is None or effect.properties.get("bypass") == "true":
                continue
            if effect.kind == "GainEffect":
                name = f"{place}: gain effect"
                parts += gain(name, "gain", number(effect.properties.get("gain")), effect.file, _anchor(effect))
                depends += self._automated(effect, "gain", name)
            elif effect.kind in DISTANCE:
                depends.append(Dependency(place, "effect", "distance", "spatialiser"))
            elif effect.kind not in PASSIVE:
                depends.append(Dependency(place, "effect", "effect", effect.kind))
        return parts, tuple(depends)

    def _automated(self, one: _Object, name: str, place: str) -> list[Dependency]:
        found = []
        for kind, key in AUTOMATED:
            for id_ in one.relations.get(kind, ()):
                by = self._objects.get(id_)
                if by is not None and by.properties.get(key) == name:
                    on: DependsOn = "random" if by.kind == "RandomizerModulator" else "state"
                    found.append(Dependency(place, name, on, self._automating(by)))
        return found

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


def _anchor(one: _Object) -> str:
    return f'id="{one.id}"'
