"""Plants gains in copies of real projects; what each reaches is found from the texts here, apart from the readers.

A plant is a changed text of one file, and the sound files whose level it moves.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree as ET

BY_DB = 5.0
MOST_STEPS = 64


@dataclass(frozen=True)
class Plant:
    """A change of one file: its level, its new text, the ends of the paths of the sound files that it moves."""

    level: str
    file: Path
    text: str
    moved: frozenset[str]


def _name(path: str) -> str:
    return path.replace("\\", "/").rpartition("/")[2].lower()


# Wwise

HOLDERS = ("Sound", "ActorMixer", "RandomSequenceContainer", "SwitchContainer", "BlendContainer", "MusicTrack")


def wwise_plants(project: Path) -> Iterator[Plant]:
    """Yield a plant for each sound, container and bus of a Wwise project."""
    trees: dict[Path, ET.Element] = {}
    for file in sorted(project.parent.rglob("*.wwu")):
        if ".backup" not in file.parts:
            trees[file] = ET.parse(file).getroot()
    parent: dict[str, tuple[str, ET.Element]] = {}  # of each object: the id of what holds it, and the object
    for root in trees.values():
        for unit in root.iter("WorkUnit"):
            if unit.get("PersistMode") != "Reference":
                _hold(unit, unit.get("OwnerID", ""), parent)
    for root in trees.values():
        for element in root.iter():
            for list_ in element.findall("ChildrenList"):
                for child in list_.findall("WorkUnit"):
                    held = parent.get(child.get("ID", ""))
                    if held is not None and not held[0]:
                        parent[child.get("ID", "")] = element.get("ID", ""), held[1]
    sounds = {
        id_: frozenset(_source(one) for one in element.findall("ChildrenList/AudioFileSource"))
        for id_, (_, element) in parent.items()
        if element.find("ChildrenList/AudioFileSource") is not None
    }
    above = {id_: list(_above(id_, parent)) for id_ in sounds}
    bus_of = {id_: _bus(above[id_], parent) for id_ in sounds}
    for file, root in trees.items():
        for element in root.iter():
            id_ = element.get("ID", "")
            if element.tag in HOLDERS:
                moved = [sounds[sound] for sound in sounds if id_ in above[sound]]
                name = "Volume"
            elif element.tag == "Bus":
                moved = [
                    sounds[sound] for sound in sounds if bus_of[sound] and id_ in list(_above(bus_of[sound], parent))
                ]
                name = "BusVolume"
            else:
                continue
            if moved and (text := _raised(root, element, name)) is not None:
                yield Plant(element.tag, file, text, frozenset().union(*moved))


def _source(element: ET.Element) -> str:
    language = element.findtext("Language") or "SFX"
    folder = "sfx" if language == "SFX" else f"voices/{language}"
    return f"{folder}/{element.findtext('AudioFile') or ''}".replace("\\", "/").lower()


def _hold(element: ET.Element, holder: str, parent: dict[str, tuple[str, ET.Element]]) -> None:
    parent[element.get("ID", "")] = holder, element
    for list_ in element.findall("ChildrenList"):
        for child in list_:
            if child.tag not in ("WorkUnit", "AudioFileSource") and child.get("ID"):
                _hold(child, element.get("ID", ""), parent)


def _above(id_: str, parent: dict[str, tuple[str, ET.Element]]) -> Iterator[str]:
    for _ in range(MOST_STEPS):
        if id_ not in parent:
            return
        yield id_
        id_ = parent[id_][0]


def _bus(chain: list[str], parent: dict[str, tuple[str, ET.Element]]) -> str:
    own = [parent[one][1] for one in chain if parent[one][1].tag not in ("WorkUnit", "Folder")]
    for place, element in enumerate(own):
        override = element.find("PropertyList/Property[@Name='OverrideOutput'][@Value='True']")
        if override is not None or place == len(own) - 1:
            bus = element.find("ReferenceList/Reference[@Name='OutputBus']/ObjectRef")
            return bus.get("ID", "") if bus is not None else ""
    return ""


def _raised(root: ET.Element, element: ET.Element, name: str) -> str | None:
    """Return the text of a unit with a property of an object raised; None where it holds no plain value."""
    list_ = element.find("PropertyList")
    if list_ is None:
        list_ = ET.Element("PropertyList")
        element.insert(0, list_)
    found = list_.find(f"Property[@Name='{name}']")
    if found is None:
        made = ET.SubElement(list_, "Property", Name=name, Type="Real64")
        ET.SubElement(ET.SubElement(made, "ValueList"), "Value").text = f"{BY_DB:g}"
        text = ET.tostring(root, encoding="unicode")
        list_.remove(made)
        return text
    value = found.find("ValueList/Value")
    if value is None:
        return None
    was = value.text
    value.text = f"{float(was or 0) + BY_DB:g}"
    text = ET.tostring(root, encoding="unicode")
    value.text = was
    return text


# FMOD Studio


def fmod_plants(project: Path) -> Iterator[Plant]:
    """Yield a plant for each instrument, track, event master and bus of an FMOD Studio project."""
    trees = {file: ET.parse(file).getroot() for file in sorted(project.parent.rglob("Metadata/**/*.xml"))}
    objects = {one.get("id", ""): (one, file) for file, root in trees.items() for one in root.findall("object")}

    def first(one: ET.Element, name: str) -> list[str]:
        return [d.text or "" for d in one.findall(f"relationship[@name='{name}']/destination")]

    def audio(id_: str) -> set[str]:
        one = objects[id_][0] if id_ in objects else None
        if one is None:
            return set()
        if one.get("class") == "MultiSound":
            return set().union(*(audio(inner) for inner in first(one, "sounds")))
        asset = objects.get(next(iter(first(one, "audioFile")), ""))
        path = asset[0].findtext("property[@name='assetPath']/value") if asset is not None else None
        return {_name(path)} if path else set()

    of_event: dict[Path, set[str]] = {}
    routed: dict[str, set[str]] = {}
    for one, file in objects.values():
        if one.get("class", "").endswith("Track"):
            held = set().union(*(audio(module) for module in first(one, "modules")), set())
            of_event.setdefault(file, set()).update(held)
            for group in first(one, "mixerGroup"):
                routed.setdefault(group, set()).update(held)
    for one, file in objects.values():
        if one.get("class") == "MixerInput":
            bus = next(iter(first(one, "output")), "")
            for _ in range(MOST_STEPS):
                if bus not in objects:
                    break
                routed.setdefault(bus, set()).update(of_event.get(file, set()))
                bus = next(iter(first(objects[bus][0], "output")), "")
    for id_, (one, file) in objects.items():
        kind = one.get("class", "")
        moved: set[str] = set()
        if kind in ("EventMixerGroup", "MixerGroup", "MixerMaster"):
            moved = routed.get(id_, set())
        elif kind == "EventMixerMaster":
            moved = of_event.get(file, set())
        elif kind == "SingleSound" and audio(id_) <= of_event.get(file, set()):
            moved = audio(id_)
        if not moved:
            continue
        found = one.find("property[@name='volume']/value")
        made = None
        if found is None:
            made = ET.SubElement(one, "property", name="volume")
            found = ET.SubElement(made, "value")
        was = found.text
        found.text = f"{float(was or 0) + BY_DB:g}"
        yield Plant(kind, file, ET.tostring(trees[file], encoding="unicode"), frozenset(moved))
        found.text = was
        if made is not None:
            one.remove(made)


# Unity

_SOURCE = re.compile(r"^--- !u!82 &-?\d+\nAudioSource:\n((?:  .*\n)*)", re.MULTILINE)
_SNAPSHOT_VALUE = re.compile(r"^    ([0-9a-f]{32}): (\S+)$", re.MULTILINE)


def unity_plants(root: Path) -> Iterator[Plant]:
    """Yield a plant for each source that plays a clip, and each group of a mixer that such a source plays through."""
    clips = {}
    for meta in root.rglob("*.meta"):
        guid = re.search(r"^guid: (\w{32})", meta.read_text(encoding="utf-8", errors="replace"), re.MULTILINE)
        if guid:
            clips[guid[1]] = meta.with_suffix("")
    through: dict[tuple[str, str], set[str]] = {}
    for file in sorted([*root.rglob("*.prefab"), *root.rglob("*.unity")]):
        text = file.read_text(encoding="utf-8", errors="replace")
        for found in _SOURCE.finditer(text):
            clip = re.search(r"  m_audioClip: \{fileID: 8300000, guid: (\w{32})", found[1])
            volume = re.search(r"^  m_Volume: (\S+)$", found[1], re.MULTILINE)
            if clip is None or volume is None or clip[1] not in clips:
                continue
            name = _name(str(clips[clip[1]]))
            raised = f"  m_Volume: {float(volume[1]) * 10 ** (BY_DB / 20):.9g}"
            body = found[1].replace(volume[0], raised, 1)
            group = re.search(r"OutputAudioMixerGroup: \{fileID: (-?\d+), guid: (\w{32})", found[1])
            if group is not None:
                through.setdefault((group[2], group[1]), set()).add(name)
            if float(volume[1]) > 0:
                yield Plant(
                    "AudioSource", file, text[: found.start(1)] + body + text[found.end(1) :], frozenset({name})
                )
    for (guid, id_), names in through.items():
        file = clips.get(guid)
        if file is None or not file.exists():
            continue
        text = file.read_text()
        group = re.search(rf"^--- !u!243 &{id_}\n(?:.*\n)*?  m_Volume: (\w{{32}})$", text, re.MULTILINE)
        start = re.search(r"m_StartSnapshot: \{fileID: (-?\d+)", text)
        if group is None or start is None:
            continue
        at = text.index(f"--- !u!245 &{start[1]}\n")
        value = next((one for one in _SNAPSHOT_VALUE.finditer(text, at) if one[1] == group[1]), None)
        if value is not None and "--- !u!" not in text[at + 5 : value.start()]:
            raised = f"    {group[1]}: {float(value[2]) + BY_DB:g}"
            yield Plant("group", file, text[: value.start()] + raised + text[value.end() :], frozenset(names))
        else:
            begin = text.index("  m_FloatValues:", at) + len("  m_FloatValues:")
            inside = text[begin : begin + 4]
            new = f"\n    {group[1]}: {BY_DB:g}" + ("" if inside.startswith("\n") else "\n")
            rest = text[begin:] if inside.startswith("\n") else text[text.index("\n", begin) + 1 :]
            yield Plant("group", file, text[:begin] + new + rest, frozenset(names))


# Godot

_PLAYER = re.compile(
    r'^\[node name="[^"]+" '
    r'type="AudioStreamPlayer(?:2D|3D)?"[^\n]*\]\n((?:[\w/]+ = .*\n)*)',
    re.MULTILINE,
)
_EXTERNAL = re.compile(r'^\[ext_resource [^\n]*path="res://([^"]+)"[^\n]* id="([^"]+)"', re.MULTILINE)


def godot_plants(root: Path) -> Iterator[Plant]:
    """Yield a plant for each player whose stream is a file, and for each bus of the layout that such a player names."""
    played: dict[str, set[str]] = {}
    for file in sorted(root.rglob("*.tscn")):
        text = file.read_text(encoding="utf-8")
        paths = {found[2]: found[1] for found in _EXTERNAL.finditer(text)}
        for found in _PLAYER.finditer(text):
            stream = re.search(r'^stream = ExtResource\("([^"]+)"\)$', found[1], re.MULTILINE)
            path = paths.get(stream[1], "") if stream else ""
            volume = re.search(r"^volume_db = (\S+)$", found[1], re.MULTILINE)
            bus = re.search(r'^bus = &?"([^"]+)"$', found[1], re.MULTILINE)
            through = played.setdefault(bus[1] if bus else "Master", set())
            if "SubResource" in found[1]:  # which plays other files of the scene, one at a time
                streams = re.findall(r'^stream_\d+/stream = ExtResource\("([^"]+)"\)$', text, re.MULTILINE)
                through.update(_name(paths[one]) for one in streams)
            if not path.endswith((".wav", ".ogg", ".mp3")):
                continue
            through.add(_name(path))
            raised = f"volume_db = {(float(volume[1]) if volume else 0.0) + BY_DB}\n"
            body = (found[1].replace(f"{volume[0]}\n", "", 1) if volume else found[1]) + raised
            yield Plant("player", file, text[: found.start(1)] + body + text[found.end(1) :], frozenset({_name(path)}))
    layout = root / "default_bus_layout.tres"
    if not layout.exists():
        return
    text = layout.read_text()
    for found in re.finditer(r'^bus/(\d+)/name = &?"([^"]+)"$', text, re.MULTILINE):
        volume = re.search(rf"^bus/{found[1]}/volume_db = (\S+)$", text, re.MULTILINE)
        if volume and found[2] in played:
            raised = f"bus/{found[1]}/volume_db = {float(volume[1]) + BY_DB}"
            yield Plant("bus", layout, text.replace(volume[0], raised, 1), frozenset(played[found[2]]))


PLANTS: dict[str, Callable[[Path], Iterator[Plant]]] = {
    "wwise": wwise_plants,
    "fmod": fmod_plants,
    "unity": unity_plants,
    "godot": godot_plants,
}
