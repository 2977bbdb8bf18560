"""Small projects of every engine with a gain at each place of their trees, to plant changes in and to read them again.

A project is written from a number of sounds and the gains of places such as ("container", 3). What a place reaches is
known by how it is written: `reached`.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from uuid import NAMESPACE_OID, uuid5

Place = tuple[str, int]
Gains = Mapping[Place, float]
IN_CONTAINER, IN_MIXER, IN_BUS = 4, 16, 32


@dataclass(frozen=True)
class Kind:
    """One engine: how its project is written, its levels from the sound outwards, and how many sounds a place holds."""

    write: Callable[[Path, int, Gains], Path]
    levels: dict[str, int]  # a level's places hold as many sounds each; 0 is all of them
    file: str  # of a sound, with its number

    def places(self, level: str, sounds: int) -> range:
        """Return the numbers of a level's places."""
        each = self.levels[level]
        return range(1 if each == 0 else -(-sounds // each))

    def reached(self, place: Place, sounds: int) -> range:
        """Return the numbers of the sounds whose level a place changes."""
        level, number = place
        each = self.levels[level]
        return range(sounds) if each == 0 else range(number * each, min(sounds, (number + 1) * each))


def guid(*names: object) -> str:
    """Return one and the same id for a name."""
    return str(uuid5(NAMESPACE_OID, "/".join(map(str, names)))).upper()


def _put(root: Path, path: str, text: str) -> None:
    place = root / path
    place.parent.mkdir(parents=True, exist_ok=True)
    place.write_text(text, encoding="utf-8")


# Wwise

MASTER = "{1514A4D8-1DA6-412A-A17E-75CA0C2149F3}"


def _properties(**values: float | str | None) -> str:
    rows = "".join(
        f'<Property Name="{name}" Type="Real64"><ValueList><Value>{value:g}</Value></ValueList></Property>\n'
        if isinstance(value, float)
        else f'<Property Name="{name}" Type="bool" Value="{value}"/>\n'
        for name, value in values.items()
        if value is not None
    )
    return f"<PropertyList>\n{rows}</PropertyList>\n" if rows else ""


def _unit(category: str, name: str, body: str, *, owner: str = "") -> str:
    id_ = guid("unit", category, name)
    mode = f'OwnerID="{owner}" PersistMode="Nested"' if owner else 'PersistMode="Standalone"'
    return (
        f'<?xml version="1.0" encoding="utf-8"?>\n<WwiseDocument Type="WorkUnit" ID="{{{id_}}}" SchemaVersion="110">\n'
        f'<{category}>\n<WorkUnit Name="{name}" ID="{{{id_}}}" {mode}>'
        f"\n<ChildrenList>\n{body}</ChildrenList>\n</WorkUnit>\n"
        f"</{category}>\n</WwiseDocument>\n"
    )


def _reference(name: str, id_: str, what: str = "") -> str:
    return (
        f'<ReferenceList>\n<Reference Name="{name}">\n<ObjectRef '
        f'Name="{what}" ID="{id_}"/>\n</Reference>\n</ReferenceList>\n'
    )


def write_wwise(root: Path, sounds: int, gains: Gains) -> Path:
    """Write a Wwise project: sources, sounds, containers, mixers in nested work units, buses in a bus."""
    _put(
        root,
        "Game.wproj",
        '<?xml version="1.0" encoding="utf-8"?>\n<WwiseDocument '
        'Type="Project" SchemaVersion="110" WwiseVersion="v2022.1.3"/>\n',
    )
    of = lambda *place: gains.get(place)  # noqa: E731
    references = ""
    for mixer in range(-(-sounds // IN_MIXER)):
        containers = ""
        for container in range(
            mixer * IN_MIXER // IN_CONTAINER, -(-min(sounds, (mixer + 1) * IN_MIXER) // IN_CONTAINER)
        ):
            held = ""
            for sound in range(container * IN_CONTAINER, min(sounds, (container + 1) * IN_CONTAINER)):
                held += (
                    f'<Sound Name="snd_{sound:04}" ID="{{{guid("sound", sound)}}}" ShortID="{sound}">\n'
                    + _properties(Volume=of("sound", sound), MakeUpGain=of("make-up", sound))
                    + f'<ChildrenList>\n<AudioFileSource Name="snd_{sound:04}" ID="{{{guid("source", sound)}}}">\n'
                    + _properties(VolumeOffset=of("source", sound))
                    + (
                        "<Language>SFX</Language>\n<AudioFile>"
                        f"steps\\snd_{sound:04}.wav</AudioFile>\n</AudioFileSource>\n"
                    )
                    + "</ChildrenList>\n</Sound>\n"
                )
            containers += (
                f'<RandomSequenceContainer Name="box_{container}" ID="{{{guid("container", container)}}}">\n'
                f"{_properties(Volume=of('container', container))}<ChildrenList>\n{held}</ChildrenList>\n"
                "</RandomSequenceContainer>\n"
            )
        bus = mixer * IN_MIXER // IN_BUS
        body = (
            f'<ActorMixer Name="mixer_{mixer}" ID="{{{guid("mixer", mixer)}}}">\n'
            + _properties(OverrideOutput="True", Volume=of("mixer", mixer))
            + _reference("OutputBus", f"{{{guid('bus', bus)}}}", f"bus_{bus}")
            + f"<ChildrenList>\n{containers}</ChildrenList>\n</ActorMixer>\n"
        )
        name, owner = f"Mixer {mixer}", "{" + guid("folder") + "}"
        _put(root, f"Actor-Mixer Hierarchy/More/{name}.wwu", _unit("AudioObjects", name, body, owner=owner))
        references += (
            f'<WorkUnit Name="{name}" ID="{{{guid("unit", "AudioObjects", name)}}}" PersistMode="Reference"/>\n'
        )
    top = (
        f'<ActorMixer Name="all" ID="{{{guid("folder")}}}">\n{_properties(Volume=of("top", 0))}'
        f"{_reference('OutputBus', MASTER)}<ChildrenList>\n{references}</ChildrenList>\n</ActorMixer>\n"
    )
    _put(root, "Actor-Mixer Hierarchy/Default Work Unit.wwu", _unit("AudioObjects", "Default Work Unit", top))
    buses = "".join(
        f'<Bus Name="bus_{bus}" ID="{{{guid("bus", bus)}}}">\n'
        f"{_properties(BusVolume=of('bus', bus), OutputBusVolume=of('bus output', bus))}</Bus>\n"
        for bus in range(-(-sounds // IN_BUS))
    )
    master = (
        f'<Bus Name="Master Audio Bus" ID="{MASTER}">\n{_properties(BusVolume=of("master", 0))}'
        f"<ChildrenList>\n{buses}</ChildrenList>\n</Bus>\n"
    )
    _put(root, "Master-Mixer Hierarchy/Default Work Unit.wwu", _unit("Busses", "Default Work Unit", master))
    events = "".join(
        f'<Event Name="Play_box_{one}" ID="{{{guid("event", one)}}}">\n'
        f'<ChildrenList>\n<Action Name="" ID="{{{guid("action", one)}}}">\n'
        f"{_reference('Target', '{' + guid('container', one) + '}')}</Action>\n</ChildrenList>\n</Event>\n"
        for one in range(-(-sounds // IN_CONTAINER))
    )
    _put(root, "Events/Default Work Unit.wwu", _unit("Events", "Default Work Unit", events))
    return root / "Game.wproj"


# FMOD Studio


def _object(kind: str, id_: str, properties: Mapping[str, object], **relations: str | list[str]) -> str:
    rows = "".join(
        f'\t\t<property name="{name}">\n\t\t\t<value>{value}</value>\n\t\t</property>\n'
        for name, value in properties.items()
        if value is not None
    )
    for name, ids in relations.items():
        listed = "".join(
            f"\t\t\t<destination>{{{one}}}</destination>\n" for one in ([ids] if isinstance(ids, str) else ids)
        )
        rows += f'\t\t<relationship name="{name}">\n{listed}\t\t</relationship>\n'
    return f'\t<object class="{kind}" id="{{{id_}}}">\n{rows}\t</object>\n'


def _objects(*those: str) -> str:
    return (
        '<?xml version="1.0" encoding="UTF-8"?>\n<objects '
        f'serializationModel="Studio.02.02.00">\n{"".join(those)}</objects>\n'
    )


def write_fmod(root: Path, sounds: int, gains: Gains) -> Path:
    """Write an FMOD Studio project: instruments in playlists on tracks of events, buses with gain effects, a master."""
    of = lambda *place: gains.get(place)  # noqa: E731
    _put(
        root, "Game.fspro", '<?xml version="1.0" encoding="UTF-8"?>\n<objects serializationModel="Studio.02.02.00" />\n'
    )
    master = guid("fmod master")
    _put(
        root,
        "Metadata/Master.xml",
        _objects(_object("MixerMaster", master, {"name": "Master Bus", "volume": of("master", 0)})),
    )
    for sound in range(sounds):
        asset = _object(
            "AudioFile", guid("asset", sound), {"assetPath": f"steps/snd_{sound:04}.wav", "isStreaming": "false"}
        )
        _put(root, f"Metadata/AudioFile/{{{guid('asset', sound)}}}.xml", _objects(asset))
    for bus in range(-(-sounds // IN_BUS)):
        effects = [guid("fader", bus), guid("gain", bus)]
        group = _objects(
            _object(
                "MixerGroup", guid("bus", bus), {"name": f"bus_{bus}", "volume": of("bus", bus)},
                output=master, effectChain=guid("chain", bus),
            ),
            _object("MixerBusEffectChain", guid("chain", bus), {}, effects=effects),
            _object("MixerBusFader", effects[0], {}),
            _object("GainEffect", effects[1], {"gain": of("gain effect", bus)}),
        )  # fmt: skip
        _put(root, f"Metadata/Group/{{{guid('bus', bus)}}}.xml", group)
    for event in range(-(-sounds // IN_MIXER)):
        of_event = range(event * IN_MIXER, min(sounds, (event + 1) * IN_MIXER))
        tracks = range(of_event.start // IN_CONTAINER, -(-of_event.stop // IN_CONTAINER))
        those = [
            _object(
                "Event", guid("event", event), {"name": f"event_{event}"}, mixer=guid("mixer", event),
                groupTracks=[guid("track", one) for one in tracks], mixerInput=guid("input", event), banks=guid("bank"),
            ),
            _object("EventMixer", guid("mixer", event), {}, masterBus=guid("event master", event)),
            _object("EventMixerMaster", guid("event master", event), {"volume": of("event master", event)}),
            _object("MixerInput", guid("input", event), {}, output=guid("bus", event * IN_MIXER // IN_BUS)),
        ]  # fmt: skip
        for track in tracks:
            held = range(track * IN_CONTAINER, min(sounds, (track + 1) * IN_CONTAINER))
            those += [
                _object(
                    "GroupTrack", guid("track", track), {}, modules=guid("list", track), mixerGroup=guid("group", track)
                ),
                _object(
                    "EventMixerGroup", guid("group", track), {"name": f"track_{track}", "volume": of("track", track)},
                    output=guid("event master", event),
                ),
                _object(
                    "MultiSound", guid("list", track), {"volume": of("playlist", track)},
                    sounds=[guid("instrument", one) for one in held],
                ),
            ]  # fmt: skip
            those += [
                _object(
                    "SingleSound",
                    guid("instrument", one),
                    {"volume": of("instrument", one)},
                    audioFile=guid("asset", one),
                )
                for one in held
            ]
        _put(root, f"Metadata/Event/{{{guid('event', event)}}}.xml", _objects(*those))
    return root / "Game.fspro"


# Unity

YAML = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n"


def _hex(*names: object) -> str:
    return guid(*names).replace("-", "").lower()


def _factor(gain_db: float | None) -> str:
    return f"{10 ** ((gain_db or 0.0) / 20):.9g}"


def write_unity(root: Path, sounds: int, gains: Gains) -> Path:
    """Write a Unity project: a prefab for each sound, instances that change it, and groups of a mixer."""
    of = lambda *place: gains.get(place)  # noqa: E731
    _put(root, "ProjectSettings/ProjectVersion.txt", "m_EditorVersion: 2022.3.10f1\n")
    manager = f"{YAML}--- !u!11 &1\nAudioManager:\n  m_ObjectHideFlags: 0\n  m_Volume: {_factor(of('manager', 0))}\n"
    _put(root, "ProjectSettings/AudioManager.asset", manager)
    mixer = _hex("mixer")
    buses = range(-(-sounds // IN_BUS))
    groups = range(-(-sounds // IN_CONTAINER))
    holds = {100 + bus: [1_000 + one for one in groups if one * IN_CONTAINER // IN_BUS == bus] for bus in buses}
    text = (
        f"{YAML}--- !u!241 &1\nAudioMixerController:\n  m_Name: main\n  m_OutputGroup: {{fileID: 0}}\n"
        "  m_MasterGroup: {fileID: 50}\n  m_StartSnapshot: {fileID: 60}\n  m_ExposedParameters: []\n"
        + _group(50, "Master", list(holds))
        + "".join(_group(id_, f"bus_{id_ - 100}", children) for id_, children in holds.items())
        + "".join(_group(1_000 + one, f"group_{one}", []) for one in groups)
        + "--- !u!245 &60\nAudioMixerSnapshotController:\n  m_Name: Snapshot\n  m_FloatValues:\n"
    )
    for level, base, count in (("master", 50, 1), ("bus", 100, len(buses)), ("group", 1_000, len(groups))):
        for one in range(count):
            if of(level, one) is not None:
                text += f"    {_hex('volume', base + one)}: {of(level, one):g}\n"
    _put(root, "Assets/Audio/main.mixer", text + "  m_TransitionOverrides: {}\n")
    _put(root, "Assets/Audio/main.mixer.meta", f"fileFormatVersion: 2\nguid: {mixer}\nNativeFormatImporter:\n")
    scene = YAML
    for sound in range(sounds):
        clip, prefab, id_ = _hex("clip", sound), _hex("prefab", sound), 7_000_000 + sound
        _put(
            root,
            f"Assets/Audio/steps/snd_{sound:04}.wav.meta",
            f"fileFormatVersion: 2\nguid: {clip}\nAudioImporter:\n  "
            "serializedVersion: 6\n  defaultSettings:\n    loadType: 0\n"
            "    sampleRateSetting: 0\n    compressionFormat: 1\n  forceToMono: 0\n  normalize: 1\n",
        )
        _put(
            root,
            f"Assets/Prefabs/snd_{sound:04}.prefab",
            f"{YAML}--- !u!1 &5\nGameObject:\n  m_Name: snd_{sound:04}\n--- "
            f"!u!82 &{id_}\nAudioSource:\n  m_GameObject: {{fileID: 5}}\n"
            f"  OutputAudioMixerGroup: {{fileID: {1_000 + sound // IN_CONTAINER}, guid: {mixer},\n    type: 2}}\n"
            f"  m_audioClip: {{fileID: 8300000, guid: {clip}, type: 3}}\n  m_Volume: {_factor(of('source', sound))}\n"
            "  Loop: 0\n  Mute: 0\n",
        )
        _put(
            root,
            f"Assets/Prefabs/snd_{sound:04}.prefab.meta",
            f"fileFormatVersion: 2\nguid: {prefab}\nPrefabImporter:\n",
        )
        if of("instance", sound) is not None:
            scene += (
                f"--- !u!1001 &{9_000_000 + sound}\nPrefabInstance:\n  m_Modification:\n    m_Modifications:\n"
                f"    - target: {{fileID: {id_}, guid: {prefab}, type: 3}}\n      propertyPath: m_Volume\n"
                f"      value: {_factor(of('instance', sound))}\n      objectReference: {{fileID: 0}}\n"
                f"  m_SourcePrefab: {{fileID: 100100000, guid: {prefab}, type: 3}}\n"
            )
    _put(root, "Assets/Scenes/Main.unity", scene)
    return root


def _group(id_: int, name: str, children: list[int]) -> str:
    listed = "".join(f"  - {{fileID: {child}}}\n" for child in children)
    return (
        f"--- !u!243 &{id_}\nAudioMixerGroupController:\n  m_Name: {name}\n"
        f"  m_Children:{' []' if not children else ''}\n{listed}  m_Volume: {_hex('volume', id_)}\n"
        "  m_Effects: []\n  m_Mute: 0\n"
    )


# Unreal


def write_unreal(root: Path, sounds: int, gains: Gains) -> Path:
    """Write what the script in the editor would: waves, cues with nodes, classes in a class, a submix."""
    of = lambda *place: gains.get(place)  # noqa: E731
    linear = lambda *place: float(_factor(of(*place)))  # noqa: E731
    document = {
        "format": 1,
        "tool": "audio-checks for Unreal",
        "engine_version": "5.4.1",
        "waves": [
            {
                "path": f"/Game/Audio/snd_{one:04}", "file": f"Audio/steps/snd_{one:04}.wav",
                "volume": linear("wave", one), "referenced": False,
            }
            for one in range(sounds)
        ],
        "cues": [
            {
                "path": f"/Game/Audio/cue_{cue}", "volume": linear("cue", cue), "referenced": True,
                "class": f"/Game/Classes/class_{cue * IN_CONTAINER // IN_BUS}", "submix": "/Game/Submixes/main",
                "plays": [
                    {
                        "wave": f"/Game/Audio/snd_{one:04}",
                        "nodes": [
                            {"kind": "SoundNodeMixer", "property": f"InputVolume {one}", "volume": linear("node", one)}
                        ],
                    }
                    for one in range(cue * IN_CONTAINER, min(sounds, (cue + 1) * IN_CONTAINER))
                ],
            }
            for cue in range(-(-sounds // IN_CONTAINER))
        ],
        "classes": [
            {"path": "/Game/Classes/all", "volume": linear("parent class", 0), "parent": ""},
            *(
                {"path": f"/Game/Classes/class_{one}", "volume": linear("class", one), "parent": "/Game/Classes/all"}
                for one in range(-(-sounds // IN_BUS))
            ),
        ],
        "submixes": [{"path": "/Game/Submixes/main", "volume_db": of("submix", 0) or 0.0, "parent": ""}],
    }  # fmt: skip
    _put(root, "sounds.json", json.dumps(document, indent=1))
    return root / "sounds.json"


# Godot


def write_godot(root: Path, sounds: int, gains: Gains) -> Path:
    """Write a Godot project: a scene for each container, a main scene that changes players, buses in a bus."""
    of = lambda *place: gains.get(place)  # noqa: E731
    _put(root, "project.godot", 'config_version=5\n\n[application]\n\nconfig/features=PackedStringArray("4.3")\n')
    layout = '[gd_resource type="AudioBusLayout" load_steps=2 format=3]\n\n'
    buses = range(-(-sounds // IN_BUS))
    for bus in buses:
        layout += (
            f'[sub_resource type="AudioEffectAmplify" id="amplify_{bus}"]\nvolume_db = {of("amplify", bus) or 0.0}\n\n'
        )
    layout += f'[resource]\nbus/0/volume_db = {of("master", 0) or 0.0}\nbus/1/name = &"All"\n'
    layout += f'bus/1/volume_db = {of("parent bus", 0) or 0.0}\nbus/1/send = &"Master"\n'
    for bus in buses:
        layout += (
            f'bus/{bus + 2}/name = &"bus_{bus}"\nbus/{bus + 2}/volume_db '
            f'= {of("bus", bus) or 0.0}\nbus/{bus + 2}/send = &"All"\n'
            f'bus/{bus + 2}/effect/0/effect = SubResource("amplify_{bus}")\nbus/{bus + 2}/effect/0/enabled = true\n'
        )
    _put(root, "default_bus_layout.tres", layout)
    main = "[gd_scene load_steps=2 format=3]\n\n"
    nodes = '[node name="Main" type="Node"]\n\n'
    for container in range(-(-sounds // IN_CONTAINER)):
        held = range(container * IN_CONTAINER, min(sounds, (container + 1) * IN_CONTAINER))
        scene = "[gd_scene format=3]\n\n"
        players = f'[node name="Box{container}" type="Node"]\n\n'
        main += f'[ext_resource type="PackedScene" path="res://scenes/box_{container}.tscn" id="{container}_b"]\n'
        changed = ""
        for sound in held:
            scene += f'[ext_resource type="AudioStream" path="res://steps/snd_{sound:04}.wav" id="{sound}_s"]\n'
            players += (
                f'[node name="snd_{sound:04}" type="AudioStreamPlayer" parent="."]\nstream = ExtResource("{sound}_s")\n'
                f'volume_db = {of("player", sound) or 0.0}\nbus = &"bus_{sound // IN_BUS}"\n\n'
            )
            if of("instance", sound) is not None:
                changed += (
                    f'[node name="snd_{sound:04}" parent="Box{container}"]\nvolume_db = {of("instance", sound)}\n\n'
                )
        _put(root, f"scenes/box_{container}.tscn", scene + "\n" + players)
        nodes += f'[node name="Box{container}" parent="." instance=ExtResource("{container}_b")]\n\n' + changed
    _put(root, "main.tscn", main + "\n" + nodes)
    return root / "project.godot"


KINDS = {
    "wwise": Kind(
        write_wwise,
        {
            "source": 1, "sound": 1, "make-up": 1, "container": IN_CONTAINER, "mixer": IN_MIXER, "top": 0,
            "bus": IN_BUS, "bus output": IN_BUS, "master": 0,
        },
        "Originals/SFX/steps/snd_{:04}.wav",
    ),
    "fmod": Kind(
        write_fmod,
        {
            "instrument": 1, "playlist": IN_CONTAINER, "track": IN_CONTAINER, "event master": IN_MIXER, "bus": IN_BUS,
            "gain effect": IN_BUS, "master": 0,
        },
        "Assets/steps/snd_{:04}.wav",
    ),
    "unity": Kind(
        write_unity,
        {"source": 1, "instance": 1, "group": IN_CONTAINER, "bus": IN_BUS, "master": 0, "manager": 0},
        "Assets/Audio/steps/snd_{:04}.wav",
    ),
    "unreal": Kind(
        write_unreal,
        {"wave": 1, "node": 1, "cue": IN_CONTAINER, "class": IN_BUS, "parent class": 0, "submix": 0},
        "Audio/steps/snd_{:04}.wav",
    ),
    "godot": Kind(
        write_godot,
        {"player": 1, "instance": 1, "bus": IN_BUS, "amplify": IN_BUS, "parent bus": 0, "master": 0},
        "steps/snd_{:04}.wav",
    ),
}  # fmt: skip
