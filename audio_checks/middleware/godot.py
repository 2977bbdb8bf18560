"""Reads a Godot project of 3 and 4: scenes, resources, import files and the layout of buses.

Players and buses have their gains in dB. A scene may hold other scenes and change their players.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from audio_checks.middleware.godot_text import Section, reference, sections, text_of
from audio_checks.middleware.reading import MOST_STEPS, NotRead, ProjectFiles, at_most
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

AUDIO = (".wav", ".ogg", ".mp3")
PLAYERS = ("AudioStreamPlayer", "AudioStreamPlayer2D", "AudioStreamPlayer3D")
MOST_SCENES_DEEP = 16
MOST_STREAMS_DEEP = 8
PLAYED = frozenset({"stream", "volume_db", "bus", "autoplay", "unit_db"})
_STREAM = re.compile(r"(?:stream|clip|streams)_?/?\d{1,5}(?:/stream|/audio_stream|/0)?$")
_NAMED = re.compile(r"res://([^\"'\n]{1,1024}+)")


@dataclass(slots=True)
class _Node:
    name: str
    kind: str
    properties: dict[str, str]
    file: str
    anchor: str
    resources: _Resources
    set_in: dict[str, tuple[str, str]] = field(default_factory=dict)  # where a property is set: file and anchor


@dataclass(slots=True)
class _Resources:
    """The resources that a file names: of other files, and of its own."""

    external: dict[str, str] = field(default_factory=dict)  # paths by ids
    own: dict[str, Section] = field(default_factory=dict)
    main: Section | None = None
    file: str = ""


@dataclass(slots=True)
class _Scene:
    file: str
    resources: _Resources
    nodes: dict[str, _Node] = field(default_factory=dict)  # by their path from the root, which is "."
    instances: dict[str, str] = field(default_factory=dict)  # scenes that stand at a path
    animated: list[str] = field(default_factory=list)  # paths with a property, such as "Player:volume_db"


def read_godot(root: Path, texts: Mapping[str, str] | None = None) -> Project:
    """Return a Godot project's facts on its sounds.

    Parameters
    ----------
    root : Path
        The folder of `project.godot`.
    texts : mapping of str to str, optional
        See `ProjectFiles`.
    """
    files = ProjectFiles(root, texts=texts)
    reading = _Reading(files)
    return Project(
        "godot", str(root), reading.version, in_order(at_most(reading.played(), files.leave_out)), tuple(files.unread)
    )


class _Reading:
    def __init__(self, files: ProjectFiles) -> None:
        self._files = files
        self._known = set(files.files)
        self._conversions: dict[str, tuple[Conversion, ...]] = {}
        self._looped: dict[str, bool] = {}
        self._by_uid: dict[str, str] = {}
        self.version, layout = self._read_project()
        self._read_imports()
        self._scenes: dict[str, _Scene] = {}
        self._streams: dict[str, _Resources] = {}
        self._read_scenes()
        self._buses = _Buses(
            self._by_uid.get(layout, layout.removeprefix("res://")) or "default_bus_layout.tres", files
        )

    def _read_project(self) -> tuple[str, str]:
        version, layout = "", ""
        for _, text in self._files.texts(["project.godot"]):
            for line in text.split("\n"):
                if line.startswith("config/features="):
                    version = next(iter(re.findall(r'"(\d[\d.]{0,15})"', line[:1_024])), "")
                elif line.startswith(("buses/default_bus_layout=", "default_bus_layout=")):
                    layout = text_of(line.partition("=")[2])
        return version, layout

    def _read_imports(self) -> None:
        for file, text in self._files.texts(self._files.ending(".import")):
            if not file[: -len(".import")].lower().endswith(AUDIO):
                continue
            sound = file[: -len(".import")]
            values = dict(line.partition("=")[::2] for line in text.split("\n") if "=" in line[:256])
            self._by_uid[text_of(values.get("uid", ""))] = sound
            self._conversions[sound] = tuple(_harms(values, file))
            self._looped[sound] = values.get("loop") == "true" or values.get("edit/loop_mode", "0") in "234"

    def _read_scenes(self) -> None:
        for file, text in self._files.texts(self._files.ending(".tscn", ".tres", ".scn", ".res")):
            try:
                if file.endswith((".scn", ".res")) or text.startswith("RSRC"):
                    raise NotRead("is binary; wanted a scene saved as .tscn, a resource as .tres")
                self._read_scene(file, text)
            except NotRead as error:
                self._files.leave_out(file, str(error), error.line)

    def _read_scene(self, file: str, text: str) -> None:
        resources = _Resources(file=file)
        scene = _Scene(file, resources)
        for section in sections(text):
            kind = section.kind
            if kind in ("gd_scene", "gd_resource") and "uid" in section.header:
                self._by_uid[text_of(section.header["uid"])] = file
            elif kind == "ext_resource":
                path = text_of(section.header.get("path", "")).removeprefix("res://")
                resources.external[text_of(section.header.get("id", ""))] = path
            elif kind == "sub_resource":
                resources.own[text_of(section.header.get("id", ""))] = section
                if text_of(section.header.get("type", "")) == "Animation":
                    scene.animated += _animated(section)
            elif kind == "resource":
                resources.main = section
            elif kind == "node":
                self._read_node(scene, section)
        if file.endswith(".tscn"):
            self._scenes[file] = scene
        else:
            self._streams[file] = resources

    def _read_node(self, scene: _Scene, section: Section) -> None:
        name = text_of(section.header.get("name", ""))
        parent = text_of(section.header.get("parent", "")) if "parent" in section.header else None
        path = "." if parent is None else name if parent == "." else f"{parent}/{name}"
        if "instance" in section.header:
            scene.instances[path] = scene.resources.external.get(reference(section.header["instance"])[1], "")
        kind = text_of(section.header.get("type", ""))
        properties = section.properties
        if (
            kind in PLAYERS
            or PLAYED & properties.keys()
            or any("ExtResource" in property_text for property_text in properties.values())
        ):
            node = _Node(name, kind, properties, scene.file, section.line, scene.resources)
            node.set_in = dict.fromkeys(properties, (scene.file, section.line))
            scene.nodes[path] = node

    def played(self) -> Iterator[PlayedSound]:
        """Yield a sound for each player of a scene, each file that another node holds, and each that a script names."""
        for scene in self._scenes.values():
            for path, node in scene.nodes.items():
                player = node if node.kind in PLAYERS else self._changed(scene, path, node)
                if player is not None:
                    yield from self._of_player(scene, path, player)
                else:
                    yield from self._of_holder(scene, path, node)
        yield from self._of_scripts()

    def _changed(self, scene: _Scene, path: str, node: _Node) -> _Node | None:
        """Return the player of another scene that a node changes; None where it is none, or is not changed."""
        if node.kind or not (PLAYED & node.properties.keys()):
            return None
        base = self._node(scene.file, path, 0, own=False)
        return None if base is None or base.kind not in PLAYERS else _over(base, node)

    def _node(self, file: str, path: str, depth: int, *, own: bool = True) -> _Node | None:
        scene = self._scenes.get(file)
        if scene is None or depth > MOST_SCENES_DEEP:
            return None
        node = scene.nodes.get(path) if own else None
        if node is not None and node.kind:
            return node
        node_path = path
        for _ in range(MOST_STEPS):
            if node_path in scene.instances:
                inner = "." if node_path == path else path if node_path == "." else path[len(node_path) + 1 :]
                base = self._node(scene.instances[node_path], inner, depth + 1)
                if base is not None:
                    return base if node is None else _over(base, node)
            if node_path == ".":
                return None
            node_path = node_path.rpartition("/")[0] or "."
        return None

    def _of_player(self, scene: _Scene, path: str, node: _Node) -> Iterator[PlayedSound]:
        object_path = f"{scene.file}: {path if path != '.' else node.name}"
        parts: tuple[Part, ...] = ()
        for name in ("volume_db", "unit_db"):
            file, anchor = node.set_in.get(name, (node.file, node.anchor))
            parts += gain(object_path, name, number(node.properties.get(name)), file, anchor)
        depends: tuple[Dependency, ...] = ()
        if node.kind != "AudioStreamPlayer":
            depends += (Dependency(object_path, "attenuation", "distance", node.kind),)
        name = path.rpartition("/")[2] if path != "." else node.name
        if any(track.partition(":")[0].rpartition("/")[2] == name for track in scene.animated):
            depends += (Dependency(object_path, "volume_db", "state", "an animation"),)
        bus_parts, bus_depends = self._buses.chain(text_of(node.properties.get("bus", "Master").lstrip("&")))
        for sound, more, others, is_random in self._sounds(node.properties.get("stream", ""), node.resources, 0):
            yield PlayedSound(
                sound, object_path, more + parts + bus_parts, (*others, *depends, *bus_depends),
                self._conversions.get(sound, ()), (scene.file,), True, True, self._looped.get(sound), None,
                object_path if is_random else "",
            )  # fmt: skip

    def _sounds(
        self, stream: str, resources: _Resources, depth: int
    ) -> Iterator[tuple[str, tuple[Part, ...], tuple[Dependency, ...], bool]]:
        """Yield the files that a stream plays, its gains, and whether it is one of several at random."""
        kind, id_ = reference(stream)
        if depth > MOST_STREAMS_DEEP or not id_:
            return
        section: Section | None = None
        if kind == "ExtResource":
            path = resources.external.get(id_, "")
            if path.lower().endswith(AUDIO):
                yield path, (), (), False
                return
            resources = self._streams.get(path, _Resources())
            section = resources.main
        elif kind == "SubResource":
            section = resources.own.get(id_)
        if section is None:
            return
        kind, id_ = (text_of(section.header.get(key, "")) for key in ("type", "id"))
        object_path = f"{resources.file}: {kind or 'resource'} {id_}".strip()
        depends: tuple[Dependency, ...] = ()
        if number(section.properties.get("random_volume_offset_db")):
            what = f"random by {section.properties['random_volume_offset_db']} dB"
            depends = (Dependency(object_path, "random_volume_offset_db", "random", what),)
        for key, text in section.properties.items():
            if _STREAM.fullmatch(key) or key in ("audio_stream", "stream"):
                volume_key = f"{key.partition('/')[0]}/volume"
                own_gain = gain(
                    object_path, volume_key, number(section.properties.get(volume_key)), resources.file, section.line
                )
                for sound, more, others, is_random in self._sounds(text, resources, depth + 1):
                    yield sound, more + own_gain, others + depends, is_random or kind == "AudioStreamRandomizer"

    def _of_holder(self, scene: _Scene, path: str, node: _Node) -> Iterator[PlayedSound]:
        """Yield the files that a node other than a player holds: its script plays them."""
        for key, text in node.properties.items():
            for id_ in re.findall(r'ExtResource\(\s?"?([\w-]{1,64})"?\s?\)', text[:65_536]):
                sound = node.resources.external.get(id_, "")
                if sound.lower().endswith(AUDIO):
                    object_path = f"{scene.file}: {path if path != '.' else node.name}"
                    yield self._scripted(sound, f"{object_path}.{key}", scene.file)

    def _of_scripts(self) -> Iterator[PlayedSound]:
        for file, text in self._files.texts(self._files.ending(".gd", ".cs")):
            for sound in dict.fromkeys(_NAMED.findall(text)):
                if sound.lower().endswith(AUDIO):
                    yield self._scripted(sound, file, file)

    def _scripted(self, sound: str, object_path: str, file: str) -> PlayedSound:
        depends = (Dependency(object_path, "", "script", "the script that plays it"),)
        return PlayedSound(
            sound,
            object_path,
            (),
            depends,
            self._conversions.get(sound, ()),
            (file,),
            True,
            False,
            self._looped.get(sound),
        )


class _Buses:
    """The buses by their names."""

    def __init__(self, layout: str, files: ProjectFiles) -> None:
        self._file = layout
        self._buses: dict[str, dict[str, str]] = {}
        self._effects: dict[str, Section] = {}
        numbered: dict[str, dict[str, str]] = {}
        for file, text in files.texts([layout] if layout in files.files else []):
            try:
                for section in sections(text):
                    if section.kind == "sub_resource":
                        self._effects[text_of(section.header.get("id", ""))] = section
                    elif section.kind == "resource":
                        for key, property_text in section.properties.items():
                            if key.startswith("bus/") and key.count("/") >= 2:
                                _, bus_index, name = key.split("/", 2)
                                numbered.setdefault(bus_index, {})[name] = property_text
            except NotRead as error:
                files.leave_out(file, str(error), error.line)
        for index, bus in numbered.items():
            bus["place"] = index
            name = text_of(bus.get("name", "").lstrip("&")) or ("Master" if index == "0" else "")
            self._buses.setdefault(name, bus)

    def chain(self, name: str) -> tuple[tuple[Part, ...], tuple[Dependency, ...]]:
        """Return the gains from a bus to the master; a bus that there is not plays through the master."""
        parts: tuple[Part, ...] = ()
        depends: tuple[Dependency, ...] = ()
        name = name if name in self._buses else "Master"
        seen: set[str] = set()
        while name in self._buses and name not in seen and len(seen) < MOST_STEPS:
            seen.add(name)
            bus = self._buses[name]
            bus_path = f"bus {name}"
            anchor = f"bus/{bus['place']}/volume_db"
            parts += gain(bus_path, "volume_db", number(bus.get("volume_db")), self._file, anchor)
            if bus.get("mute") == "true":
                parts += gain(bus_path, "mute", decibels(0), self._file, f"bus/{bus['place']}/mute")
            for key, text in bus.items():
                if key.startswith("effect/") and key.endswith("/effect") and bus.get(f"{key[:-7]}/enabled") != "false":
                    more, other = self._effect(bus_path, text)
                    parts, depends = parts + more, depends + other
            name = "" if name == "Master" else text_of(bus.get("send", '"Master"').lstrip("&")) or "Master"
        return parts, depends

    def _effect(self, bus_path: str, text: str) -> tuple[tuple[Part, ...], tuple[Dependency, ...]]:
        section = self._effects.get(reference(text)[1])
        kind = text_of(section.header.get("type", "")) if section is not None else ""
        if section is not None and kind == "AudioEffectAmplify":
            volume_db = number(section.properties.get("volume_db"))
            return gain(f"{bus_path}: {kind}", "volume_db", volume_db, self._file, section.line), ()
        if kind in ("AudioEffectSpectrumAnalyzer", "AudioEffectRecord", "AudioEffectCapture", ""):
            return (), ()
        return (), (Dependency(bus_path, "effect", "effect", kind),)


def _over(base: _Node, node: _Node) -> _Node:
    """Return a player as a scene that holds its scene changes it."""
    merged = _Node(node.name, base.kind, {**base.properties, **node.properties}, base.file, base.anchor, base.resources)
    merged.set_in = {**base.set_in, **node.set_in}
    if "stream" in node.properties:
        merged.resources = node.resources
    return merged


def _animated(section: Section) -> Iterator[str]:
    """Yield the volumes that an animation moves."""
    for key, text in section.properties.items():
        if key.startswith("tracks/") and key.endswith("/path"):
            path = text_of(text.partition("(")[2].rpartition(")")[0])
            if path.endswith((":volume_db", ":unit_db", ":volume_linear")):
                yield path


def _harms(values: dict[str, str], file: str) -> Iterator[Conversion]:
    """Yield the import settings that change a sound's level, rate or last bit."""
    if values.get("edit/normalize") == "true":
        yield Conversion("edit/normalize", "its peak is raised to full scale", file)
    if values.get("force/8_bit") == "true":
        yield Conversion("force/8_bit", "8 bits a sample undo the dither", file)
    if values.get("force/mono") == "true":
        yield Conversion("force/mono", "mixed to mono", file)
    if values.get("force/max_rate") == "true":
        yield Conversion(
            "force/max_rate", f"resampled to {number(values.get('force/max_rate_hz')) or 0:,.0f} Hz at most", file
        )
    if values.get("edit/trim") == "true":
        yield Conversion("edit/trim", "its silence is cut off", file)
    if values.get("compress/mode") == "1" and values.get("importer") == '"wav"':
        yield Conversion("compress/mode", "IMA ADPCM: 4 bits a sample undo the dither", file)
