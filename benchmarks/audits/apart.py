"""Projects kept apart from the readers: written from the formats alone, with what the first projects do not have.

Each is written from the gains of its places, with the sounds that each place moves and what their level depends on.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from zlib import crc32

from benchmarks.audits.projects import MASTER, guid

Gains = Mapping[str, float]  # in dB, by place


@dataclass(frozen=True)
class Apart:
    """How a project is written, the sounds that each of its places moves, and what the level of others depends on."""

    write: Callable[[Path, Gains], Path]
    moved: dict[str, tuple[str, ...]]
    depends: dict[str, tuple[str, ...]]  # by sound; "" where nothing but constants counts
    standing: Gains = field(default_factory=dict)  # of places that are not at 0 dB where nothing is planted


def _put(root: Path, path: str, text: str) -> None:
    place = root / path
    place.parent.mkdir(parents=True, exist_ok=True)
    place.write_text(text, encoding="utf-8")


# Wwise 2022.1: switch and blend containers, states, game parameters, nested buses, music, two languages


def _id(*names: object) -> str:
    return "{" + guid("apart", *names) + "}"


def _volume(gains: Gains, place: str, name: str = "Volume", inner: str = "") -> str:
    gain = gains.get(place)
    if gain is None and not inner:
        return ""
    value = "" if gain is None else f"<ValueList>\n<Value>{gain:g}</Value>\n</ValueList>\n"
    return f'<Property Name="{name}" Type="Real64">\n{value}{inner}</Property>\n'


def _object(tag: str, name: str, *, properties: str = "", more: str = "", children: str = "") -> str:
    listed = f"<PropertyList>\n{properties}</PropertyList>\n" if properties else ""
    held = f"<ChildrenList>\n{children}</ChildrenList>\n" if children else ""
    return f'<{tag} Name="{name}" ID="{_id(name)}" ShortID="{crc32(name.encode())}">\n{listed}{more}{held}</{tag}>\n'


def _source(file: str, language: str = "SFX") -> str:
    path = file.replace("/", "\\")
    return (
        f'<AudioFileSource Name="{file}" ID="{_id("source", file, language)}">\n<Language>{language}</Language>\n'
        f"<AudioFile>{path}</AudioFile>\n</AudioFileSource>\n"
    )


def _wwise_sound(gains: Gains, name: str, *, inner: str = "", more: str = "", sources: str = "") -> str:
    properties = _volume(gains, f"sound {name}", inner=inner)
    return _object("Sound", name, properties=properties, more=more, children=sources or _source(f"{name}.wav"))


def _to_bus(name: str) -> str:
    id_ = MASTER if name == "Master Audio Bus" else _id(name)
    return (
        f'<ReferenceList>\n<Reference Name="OutputBus">\n<ObjectRef Name="{name}" ID="{id_}" '
        f'WorkUnitID="{_id("unit", "Busses")}"/>\n</Reference>\n</ReferenceList>\n'
    )


def _wwise_unit(root: Path, folder: str, category: str, name: str, children: str) -> None:
    text = (
        f'<?xml version="1.0" encoding="utf-8"?>\n<WwiseDocument Type="WorkUnit" ID="{_id("unit", name)}" '
        f'SchemaVersion="110">\n<{category}>\n<WorkUnit Name="{name}" ID="{_id("unit", name)}" '
        f'PersistMode="Standalone">\n<ChildrenList>\n{children}</ChildrenList>\n</WorkUnit>\n</{category}>\n'
        "</WwiseDocument>\n"
    )
    _put(root, f"{folder}/{name}.wwu", text)


OVERRIDES = '<Property Name="OverrideOutput" Type="bool" Value="True"/>\n'
RTPC_2022 = (
    '<ObjectLists>\n<ObjectList Name="RTPC">\n<RTPC Name="" ID="{A1}" ShortID="9">\n<PropertyList>\n'
    '<Property Name="PropertyName" Type="string" Value="Volume"/>\n</PropertyList>\n<ReferenceList>\n'
    '<Reference Name="ControlInput">\n<ObjectRef Name="Load" ID="{A2}" WorkUnitID="{A3}"/>\n</Reference>\n'
    "</ReferenceList>\n</RTPC>\n</ObjectList>\n</ObjectLists>\n"
)
EFFECT_2022 = (
    '<ObjectLists>\n<ObjectList Name="Effects">\n<EffectSlot Name="" ID="{E1}" ShortID="6">\n<ReferenceList>\n'
    '<Reference Name="Effect" PluginName="Wwise Compressor" CompanyID="0" PluginID="108" PluginType="3">\n'
    '<ObjectRef Name="Squash" ID="{E2}" WorkUnitID="{E3}"/>\n</Reference>\n</ReferenceList>\n</EffectSlot>\n'
    "</ObjectList>\n</ObjectLists>\n"
)
RTPC_2019 = (
    '<RTPCList>\n<RTPC Name="" ID="{A4}" ShortID="8">\n<ReferenceList>\n<Reference Name="ControlInput">\n'
    '<ObjectRef Name="Speed" ID="{A5}" WorkUnitID="{A3}"/>\n</Reference>\n</ReferenceList>\n'
    '<Curve Name="" ID="{A6}">\n<PointList>\n<Point>\n<XPos>0</XPos>\n<YPos>-12</YPos>\n<Flags>5</Flags>\n</Point>\n'
    "</PointList>\n</Curve>\n</RTPC>\n</RTPCList>\n"
)
STATES = (
    '<StateInfo>\n<StateGroupList>\n<StateGroupInfo>\n<StateGroupRef Name="Health" ID="{B1}" WorkUnitID="{B2}"/>\n'
    "</StateGroupInfo>\n</StateGroupList>\n<CustomStateList>\n<CustomState>\n"
    '<StateRef Name="Low" ID="{B3}" WorkUnitID="{B2}"/>\n<CustomState Name="" ID="{B4}" ShortID="7">\n<PropertyList>\n'
    '<Property Name="Volume" Type="Real64" Value="-9"/>\n</PropertyList>\n</CustomState>\n</CustomState>\n'
    "</CustomStateList>\n</StateInfo>\n"
)
RANDOM = '<ModifierList>\n<ModifierInfo>\n<Modifier Name="" ID="{C1}">\n<PropertyList>\n' + (
    '<Property Name="Enabled" Type="bool" Value="True"/>\n<Property Name="Max" Type="Real64" Value="2"/>\n'
    '<Property Name="Min" Type="Real64" Value="-2"/>\n</PropertyList>\n</Modifier>\n</ModifierInfo>\n</ModifierList>\n'
)


def write_wwise(root: Path, gains: Gains) -> Path:
    """Write a Wwise project."""
    _put(
        root,
        "Apart.wproj",
        '<?xml version="1.0" encoding="utf-8"?>\n<WwiseDocument Type="Project" ID="{D1}" SchemaVersion="110" '
        'WwiseVersion="v2022.1.5">\n<ProjectInfo/>\n</WwiseDocument>\n',
    )
    surfaces = "".join(
        _object(
            "RandomSequenceContainer",
            surface,
            properties=_volume(gains, f"random {surface}", inner=RANDOM if surface == "sand" else ""),
            children="".join(_wwise_sound(gains, f"{surface}_{number}") for number in (1, 2)),
        )
        for surface in ("grass", "sand")
    )
    steps = _object("SwitchContainer", "Steps", properties=_volume(gains, "switch"), children=surfaces)
    layers = _wwise_sound(gains, "idle", inner=RTPC_2019) + _wwise_sound(gains, "load", more=RTPC_2022)
    layers += _wwise_sound(gains, "whine")
    engine = _object("BlendContainer", "Engine", properties=_volume(gains, "blend"), children=layers)
    guns = _object(
        "ActorMixer",
        "Guns",
        properties=OVERRIDES + _volume(gains, "guns") + _volume(gains, "guns output", "OutputBusVolume"),
        more=_to_bus("Guns bus"),
        children=_wwise_sound(gains, "shot") + _wwise_sound(gains, "hurt", more=STATES),
    )
    languages = _source("yes.wav", "English(US)") + _source("yes.wav", "German")
    voices = _object(
        "ActorMixer",
        "Voices",
        properties=OVERRIDES + _volume(gains, "voices"),
        more=_to_bus("Voice bus"),
        children=_wwise_sound(gains, "yes", sources=languages),
    )
    folder = _object("Folder", "Everything", children=steps + engine + guns)
    _wwise_unit(root, "Actor-Mixer Hierarchy", "AudioObjects", "Game", folder)
    _wwise_unit(root, "Actor-Mixer Hierarchy/Speech", "AudioObjects", "Speech", voices)
    track = _object("MusicTrack", "theme", properties=_volume(gains, "track"), children=_source("theme.wav"))
    segment = _object("MusicSegment", "Theme", properties=_volume(gains, "segment"), children=track)
    playlist = _object("MusicPlaylistContainer", "List", properties=_volume(gains, "playlist"), children=segment)
    music = _object("MusicSwitchContainer", "Music", properties=_volume(gains, "music"), children=playlist)
    _wwise_unit(root, "Interactive Music Hierarchy", "InteractiveMusic", "Score", music)
    guns_bus = _object("Bus", "Guns bus", properties=_volume(gains, "guns bus", "BusVolume"))
    sfx = _object("Bus", "SFX bus", properties=_volume(gains, "sfx bus", "BusVolume"), children=guns_bus)
    aux = _object("AuxBus", "Hall", properties=_volume(gains, "aux", "BusVolume"))
    voice = _object("Bus", "Voice bus", properties=_volume(gains, "voice bus"), more=EFFECT_2022)
    master = (
        f'<Bus Name="Master Audio Bus" ID="{MASTER}">\n<PropertyList>\n{_volume(gains, "master", "BusVolume")}'
        f"</PropertyList>\n<ChildrenList>\n{sfx}{voice}{aux}</ChildrenList>\n</Bus>\n"
    )
    _wwise_unit(root, "Master-Mixer Hierarchy", "Busses", "Busses", master)
    targets = {"Steps": "Steps", "Engine": "Engine", "Guns": "Guns", "Speak": "Voices", "Music": "Music"}
    events = "".join(
        f'<Event Name="Play_{name}" ID="{_id("event", name)}">\n<ChildrenList>\n<Action Name="" '
        f'ID="{_id("action", name)}" ShortID="5">\n<ReferenceList>\n<Reference Name="Target">\n<ObjectRef '
        f'Name="{target}" ID="{_id(target)}" WorkUnitID="{_id("unit", "Game")}"/>\n</Reference>\n</ReferenceList>\n'
        "</Action>\n</ChildrenList>\n</Event>\n"
        for name, target in targets.items()
    )
    _wwise_unit(root, "Events", "Events", "Events", events)
    return root / "Apart.wproj"


def _sfx(*names: str) -> tuple[str, ...]:
    return tuple(f"Originals/SFX/{name}.wav" for name in names)


YES = ("Originals/Voices/English(US)/yes.wav", "Originals/Voices/German/yes.wav")
STEPS, ENGINE = ("grass_1", "grass_2", "sand_1", "sand_2"), ("idle", "load", "whine")
WWISE = Apart(
    write_wwise,
    {
        "sound grass_1": _sfx("grass_1"), "sound whine": _sfx("whine"), "sound shot": _sfx("shot"),
        "sound yes": YES, "random grass": _sfx("grass_1", "grass_2"), "random sand": _sfx("sand_1", "sand_2"),
        "switch": _sfx(*STEPS), "blend": _sfx(*ENGINE), "guns": _sfx("shot", "hurt"),
        "guns output": _sfx("shot", "hurt"), "voices": YES, "track": _sfx("theme"), "segment": _sfx("theme"),
        "playlist": _sfx("theme"), "music": _sfx("theme"), "guns bus": _sfx("shot", "hurt"),
        "sfx bus": _sfx("shot", "hurt"), "voice bus": YES, "aux": (),
        "master": (*_sfx(*STEPS, *ENGINE, "shot", "hurt", "theme"), *YES),
    },
    {
        **dict.fromkeys(_sfx("grass_1", "shot", "theme"), ("",)),
        **dict.fromkeys(_sfx("idle", "load", "hurt"), ("state",)),
        **dict.fromkeys(_sfx("sand_1", "sand_2"), ("random",)), **dict.fromkeys(YES, ("effect",)),
    },
)  # fmt: skip


# FMOD Studio 2.02: an event in another one, groups in groups, a VCA, a snapshot, an automated bus


class _Fmod:
    """The objects of one metadata file."""

    def __init__(self, root: Path) -> None:
        self._root = root

    def file(self, kind: str, *objects: str) -> None:
        """Write a file that begins with an object."""
        head = '<?xml version="1.0" encoding="UTF-8"?>\n<objects serializationModel="Studio.02.02.00">\n'
        name = objects[0].partition('id="')[2].partition('"')[0]
        place = f"Metadata/{kind}.xml" if kind in ("Master", "Mixer", "Workspace") else f"Metadata/{kind}/{name}.xml"
        _put(self._root, place, head + "".join(objects) + "</objects>\n")


def _fid(*names: object) -> str:
    return "{" + guid("fmod apart", *names).lower() + "}"


DESTINATION = "<destination>{}</destination>\n"


def _fmod(kind: str, name: str, properties: Mapping[str, object], **related: list[str]) -> str:
    body = "".join(
        f'<property name="{key}">\n<value>{value}</value>\n</property>\n'
        for key, value in properties.items()
        if value is not None
    )
    body += "".join(
        f'<relationship name="{key}">\n'
        + "".join(f"<destination>{one}</destination>\n" for one in ids)
        + "</relationship>\n"
        for key, ids in related.items()
    )
    return f'<object class="{kind}" id="{_fid(name)}">\n{body}</object>\n'


def _fmod_event(
    files: _Fmod, gains: Gains, name: str, bus: str, sounds: Mapping[str, str | None], *, in_bank: bool = True
) -> None:
    """Write an event with a track in a group track; a sound without a file is another event."""
    of = gains.get
    modules, tracks = [_fid(name, one) for one in sounds], f"{name} track"
    objects = [
        _fmod("Event", name, {"name": name}, mixer=[_fid(f"{name} mixer")], masterTrack=[_fid(f"{name} master track")],
              mixerInput=[_fid(f"{name} input")], groupTracks=[_fid(tracks)], timeline=[_fid(f"{name} timeline")],
              folder=[_fid("events")], banks=[_fid("bank")] if in_bank else []),
        _fmod("EventMixer", f"{name} mixer", {}, masterBus=[_fid(f"{name} master")]),
        _fmod("MasterTrack", f"{name} master track", {}, mixerGroup=[_fid(f"{name} master")]),
        _fmod("MixerInput", f"{name} input", {"volume": of(f"{name} input")}, output=[_fid(bus)]),
        _fmod("EventMixerMaster", f"{name} master", {"volume": of(f"{name} master")}, mixer=[_fid(f"{name} mixer")]),
        _fmod("GroupTrack", tracks, {}, modules=modules, mixerGroup=[_fid(f"{name} inner")]),
        _fmod("EventMixerGroup", f"{name} inner", {"name": "Audio 1", "volume": of(f"{name} inner")},
              output=[_fid(f"{name} outer")]),
        _fmod("EventMixerGroup", f"{name} outer", {"name": "Group", "volume": of(f"{name} outer")},
              output=[_fid(f"{name} master")]),
        _fmod("Timeline", f"{name} timeline", {}, modules=modules),
    ]  # fmt: skip
    for one, file in sounds.items():
        volume = {"volume": of(f"{name} {one}")}
        what = {"event": [_fid(one)]} if file is None else {"audioFile": [_fid("file", file)]}
        kind = "EventSound" if file is None else "SingleSound"
        objects.append(_fmod(kind, "", volume, **what).replace(_fid(""), _fid(name, one)))
    files.file("Event", *objects)


AUTOMATED = {"nameOfPropertyBeingAutomated": "volume"}


def write_fmod(root: Path, gains: Gains) -> Path:
    """Write an FMOD Studio project."""
    head = '<?xml version="1.0" encoding="UTF-8"?>\n'
    _put(root, "Apart.fspro", head + '<objects serializationModel="Studio.02.02.00" />\n')
    files = _Fmod(root)
    files.file(
        "Workspace", _fmod("Workspace", "workspace", {}, masterEventFolder=[_fid("events")], mixer=[_fid("mixer")])
    )
    files.file("EventFolder", _fmod("MasterEventFolder", "events", {}))
    files.file("Mixer", _fmod("Mixer", "mixer", {}, masterBus=[_fid("master")], snapshotList=[_fid("snapshots")]))
    files.file("Master", _fmod("MixerMaster", "master", {"name": "Master Bus", "volume": gains.get("master")}))
    for bus, above in (("world", "master"), ("weapons", "world"), ("ducked", "master"), ("swept", "master")):
        more: dict[str, list[str]] = {"masters": [_fid("vca")]} if bus == "world" else {}
        if bus == "swept":
            more = {"automators": [_fid("automator")]}
        objects = [
            _fmod("MixerGroup", bus, {"name": bus, "volume": gains.get(f"bus {bus}")}, output=[_fid(above)],
                  effectChain=[_fid(bus, "chain")], **more),
            _fmod("MixerBusEffectChain", "", {}, effects=[_fid(bus, "fader")]).replace(_fid(""), _fid(bus, "chain")),
            _fmod("MixerBusFader", "", {}).replace(_fid(""), _fid(bus, "fader")),
        ]  # fmt: skip
        if bus == "swept":
            objects += [
                _fmod(
                    "Automator",
                    "automator",
                    {"nameOfPropertyBeingAutomated": "volume"},
                    automationCurves=[_fid("curve")],
                ),
                _fmod("AutomationCurve", "curve", {}, automationPoints=[_fid("point")]),
                _fmod("AutomationPoint", "point", {"position": 0, "value": -10}),
            ]
        files.file("Group", *objects)
    files.file("Bank", _fmod("Bank", "bank", {"name": "Game"}))
    files.file("VCA", _fmod("MixerVCA", "vca", {"name": "World", "volume": gains.get("vca")}))
    holds = _fmod("MixerVCA", "wind vca", {"name": "Wind", "volume": gains.get("wind vca")}, slaves=[_fid("ducked")])
    files.file("VCA", holds)
    files.file(
        "Snapshot",
        _fmod("Snapshot", "snapshot", {"name": "underwater"}, mixer=[_fid("mixer")], snapshotProperties=[_fid("low")],
              snapshotTracks=[_fid("snapshot track")]),
        _fmod("SnapshotProperty", "low", {"propertyName": "volume", "value": -12}, automatableObject=[_fid("ducked")]),
        _fmod("SnapshotTrack", "snapshot track", {}, mixerStrip=[_fid("ducked")]),
    )  # fmt: skip
    for file in FMOD_FILES:
        files.file(
            "AudioFile", _fmod("AudioFile", "", {"assetPath": f"sfx/{file}.wav"}).replace(_fid(""), _fid("file", file))
        )
    _fmod_event(files, gains, "shell", "weapons", {"brass": "brass"}, in_bank=False)  # heard in the gun alone
    _fmod_event(files, gains, "gun", "weapons", {"shot": "shot", "tail": "tail", "shell": None})
    _fmod_event(files, gains, "wind", "ducked", {"gust": "gust"})
    _fmod_event(files, gains, "pad", "swept", {"hum": "hum"})
    return root / "Apart.fspro"


def _assets(*names: str) -> tuple[str, ...]:
    return tuple(f"Assets/sfx/{name}.wav" for name in names)


FMOD_FILES = ("brass", "shot", "tail", "gust", "hum")
GUN = _assets("shot", "tail", "brass")
FMOD = Apart(
    write_fmod,
    {
        "gun shot": _assets("shot"), "gun tail": _assets("tail"), "shell brass": _assets("brass"),
        "gun shell": _assets("brass"), "shell inner": _assets("brass"), "shell outer": _assets("brass"),
        "shell master": _assets("brass"), "gun inner": GUN, "gun outer": GUN, "gun master": GUN, "gun input": GUN,
        "bus weapons": GUN, "bus world": GUN, "vca": GUN, "wind vca": _assets("gust"), "bus ducked": _assets("gust"),
        "wind outer": _assets("gust"), "master": _assets(*FMOD_FILES),
    },
    {
        **dict.fromkeys(_assets("shot", "tail"), ("",)),
        **dict.fromkeys(_assets("gust", "hum"), ("state",)),
    },
)  # fmt: skip


# Unity 2021.3: a mixer into another one, snapshots, an exposed group, variants of variants, overrides in a scene


AT_REST_DB = -6.0  # of a source where nothing is planted: its factor is at most 1
YAML = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n"


def _hex(*names: object) -> str:
    return guid("unity apart", *names).replace("-", "").lower()


def _meta(root: Path, path: str, importer: str = "DefaultImporter:\n  externalObjects: {}\n") -> None:
    _put(root, f"{path}.meta", f"fileFormatVersion: 2\nguid: {_hex(path)}\n{importer}")


def _linear(gains: Gains, place: str) -> float:
    return float(f"{10 ** (gains.get(place, AT_REST_DB) / 20):.9g}")


def _mixer_group(name: str, id_: int, mixer: str, children: list[int]) -> str:
    held = "".join(f"  - {{fileID: {one}}}\n" for one in children)
    return (
        f"--- !u!243 &{id_}\nAudioMixerGroupController:\n  m_ObjectHideFlags: 0\n  m_Name: {name}\n"
        f"  m_AudioMixer: {{fileID: 24100000}}\n  m_GroupID: {_hex(mixer, name)}\n"
        f"  m_Children:{'' if held else ' []'}\n"
        f"{held}  m_Volume: {_hex(mixer, name, 'volume')}\n  m_Pitch: {_hex(mixer, name, 'pitch')}\n"
        f"  m_Effects:\n  - {{fileID: {id_ + 1}}}\n  m_UserColorIndex: 0\n  m_Mute: 0\n  m_Solo: 0\n"
        "  m_BypassEffects: 0\n"
        f"--- !u!244 &{id_ + 1}\nAudioMixerEffectController:\n  m_ObjectHideFlags: 3\n  m_Name: \n"
        f"  m_EffectID: {_hex(mixer, name, 'effect')}\n  m_EffectName: Attenuation\n"
        f"  m_MixLevel: {_hex(mixer, name, 'mix')}\n"
        "  m_Parameters: []\n  m_SendTarget: {fileID: 0}\n  m_EnableWetMix: 0\n  m_Bypass: 0\n"
    )


def _snapshot(name: str, id_: int, values: Mapping[str, float]) -> str:
    held = "".join(f"    {key}: {value:g}\n" for key, value in values.items())
    return (
        f"--- !u!245 &{id_}\nAudioMixerSnapshotController:\n  m_ObjectHideFlags: 0\n  m_Name: {name}\n"
        f"  m_AudioMixer: {{fileID: 24100000}}\n  m_SnapshotID: {_hex(name, id_)}\n"
        f"  m_FloatValues:{'' if held else ' {}'}\n{held}  m_TransitionOverrides: {{}}\n"
    )


def _mixer(
    root: Path, gains: Gains, name: str, groups: Mapping[str, str], *, output: str, exposed: str, low: str
) -> None:
    """Write a mixer; groups name the one above them, and in the second snapshot one group is low."""
    ids = {group: 24300000 + 10 * place for place, group in enumerate(groups, start=1)}
    text = YAML + (
        f"--- !u!241 &24100000\nAudioMixerController:\n  m_ObjectHideFlags: 0\n  m_Name: {name}\n"
        f"  m_OutputGroup: {output}\n  m_MasterGroup: {{fileID: {ids['Master']}}}\n  m_Snapshots:\n"
        "  - {fileID: 24500000}\n  - {fileID: 24500001}\n  m_StartSnapshot: {fileID: 24500000}\n"
        "  m_SuspendThreshold: -80\n  m_EnableSuspend: 1\n  m_UpdateMode: 0\n"
        f"  m_ExposedParameters:\n  - guid: {_hex(name, exposed, 'volume')}\n    name: {exposed}Volume\n"
        "  m_AudioMixerGroupViews: []\n  m_CurrentViewIndex: 0\n  m_TargetSnapshot: {fileID: 24500000}\n"
    )
    for group, id_ in ids.items():
        text += _mixer_group(group, id_, name, [ids[one] for one, above in groups.items() if above == group])
    start = {_hex(name, one, "volume"): gains[f"{name} {one}"] for one in groups if f"{name} {one}" in gains}
    text += _snapshot("Start", 24500000, start) + _snapshot(
        "Low", 24500001, {**start, _hex(name, low, "volume"): -20.0}
    )
    _put(root, f"Assets/Mixers/{name}.mixer", text)
    _meta(root, f"Assets/Mixers/{name}.mixer", "NativeFormatImporter:\n  mainObjectFileID: 24100000\n")


def _group_of(mixer: str, place: int) -> str:
    return f"{{fileID: {24300000 + 10 * place}, guid: {_hex(f'Assets/Mixers/{mixer}.mixer')}, type: 2}}"


def _source_of(id_: int, clip: str, group: str, volume: float, game_object: int) -> str:
    return (
        f"--- !u!82 &{id_}\nAudioSource:\n  m_ObjectHideFlags: 0\n  m_CorrespondingSourceObject: {{fileID: 0}}\n"
        f"  m_PrefabInstance: {{fileID: 0}}\n  m_PrefabAsset: {{fileID: 0}}\n"
        f"  m_GameObject: {{fileID: {game_object}}}\n"
        f"  m_Enabled: 1\n  serializedVersion: 4\n  OutputAudioMixerGroup: {group}\n"
        f"  m_audioClip: {{fileID: 8300000, guid: {_hex(f'Assets/Audio/{clip}.wav')}, type: 3}}\n  m_PlayOnAwake: 1\n"
        f"  m_Volume: {volume:g}\n  m_Pitch: 1\n  Loop: 0\n  Mute: 0\n  Spatialize: 0\n  Priority: 128\n"
    )


def _game_object(id_: int, name: str, component: int) -> str:
    return (
        f"--- !u!1 &{id_}\nGameObject:\n  m_ObjectHideFlags: 0\n  serializedVersion: 6\n  m_Component:\n"
        f"  - component: {{fileID: {component}}}\n  m_Layer: 0\n  m_Name: {name}\n  m_TagString: Untagged\n"
        "  m_IsActive: 1\n"
    )


def _instance(id_: int, prefab: str, target: int, volume: float | None) -> str:
    changed = (
        f"    m_Modifications:\n    - target: {{fileID: {target}, guid: {_hex(prefab)}, type: 3}}\n"
        f"      propertyPath: m_Volume\n      value: {volume:.9g}\n      objectReference: {{fileID: 0}}\n"
        if volume is not None
        else "    m_Modifications: []\n"
    )
    return (
        f"--- !u!1001 &{id_}\nPrefabInstance:\n  m_ObjectHideFlags: 0\n  serializedVersion: 2\n  m_Modification:\n"
        f"    m_TransformParent: {{fileID: 0}}\n{changed}    m_RemovedComponents: []\n"
        f"  m_SourcePrefab: {{fileID: 100100000, guid: {_hex(prefab)}, type: 3}}\n"
    )


CLIPS = ("bell", "drum", "gong", "horn", "lute")


def write_unity(root: Path, gains: Gains) -> Path:
    """Write a Unity project."""
    _put(root, "ProjectSettings/ProjectVersion.txt", "m_EditorVersion: 2021.3.37f1\n")
    factor = 10 ** (gains["manager"] / 20) if "manager" in gains else 1.0
    manager = f"--- !u!11 &1\nAudioManager:\n  m_ObjectHideFlags: 0\n  serializedVersion: 2\n  m_Volume: {factor:.9g}\n"
    _put(root, "ProjectSettings/AudioManager.asset", YAML + manager)
    for clip in CLIPS:
        _put(root, f"Assets/Audio/{clip}.wav", "RIFF")
        _meta(
            root,
            f"Assets/Audio/{clip}.wav",
            "AudioImporter:\n  serializedVersion: 6\n  normalize: 1\n  forceToMono: 0\n",
        )
    top = {"Master": "", "World": "Master", "Radio": "Master", "Music": "Master"}
    _mixer(root, gains, "Top", top, output="{fileID: 0}", exposed="Music", low="Radio")
    inner = {"Master": "", "Near": "Master", "Far": "Near"}
    _mixer(root, gains, "Inner", inner, output=_group_of("Top", 2), exposed="Nothing", low="Nothing")
    drum, source = "Assets/Drum.prefab", 8200000
    text = _game_object(1000, "Drum", source) + _source_of(
        source, "drum", _group_of("Inner", 3), _linear(gains, "drum"), 1000
    )
    _put(root, drum, YAML + text)
    _meta(root, drum, "PrefabImporter:\n  externalObjects: {}\n")
    variant = "Assets/Loud Drum.prefab"
    louder = 10 ** (gains["variant"] / 20) if "variant" in gains else None
    stripped = (
        f"--- !u!82 &{source ^ 5000} stripped\nAudioSource:\n  m_CorrespondingSourceObject: {{fileID: {source}, "
        f"guid: {_hex(drum)}, type: 3}}\n  m_PrefabInstance: {{fileID: 5000}}\n  m_PrefabAsset: {{fileID: 0}}\n"
    )
    _put(root, variant, YAML + _instance(5000, drum, source, louder) + stripped)
    _meta(root, variant, "PrefabImporter:\n  externalObjects: {}\n")
    again = "Assets/Loudest Drum.prefab"
    loudest = 10 ** (gains["variant of variant"] / 20) if "variant of variant" in gains else None
    _put(root, again, YAML + _instance(6000, variant, source ^ 5000, loudest))
    _meta(root, again, "PrefabImporter:\n  externalObjects: {}\n")
    scene = YAML + _instance(7000, again, (source ^ 5000) ^ 6000, None)
    groups = {"bell": ("Inner", 2), "gong": ("Top", 3), "horn": ("Top", 4), "lute": None}
    for place, (clip, of_mixer) in enumerate(groups.items()):
        group = _group_of(*of_mixer) if of_mixer else "{fileID: 0}"
        scene += _game_object(100 + place, clip, 200 + place)
        scene += _source_of(200 + place, clip, group, _linear(gains, clip), 100 + place)
    _put(root, "Assets/Main.unity", scene)
    _meta(root, "Assets/Main.unity")
    settings = (
        "--- !u!1045 &1\nEditorBuildSettings:\n  m_Scenes:\n  - enabled: 1\n    path: Assets/Main.unity\n"
        f"    guid: {_hex('Assets/Main.unity')}\n"
    )
    _put(root, "ProjectSettings/EditorBuildSettings.asset", YAML + settings)
    return root


def _clips(*names: str) -> tuple[str, ...]:
    return tuple(f"Assets/Audio/{name}.wav" for name in names)


UNITY = Apart(
    write_unity,
    {
        "bell": _clips("bell"), "drum": _clips("drum"), "lute": _clips("lute"), "variant": _clips("drum"),
        "variant of variant": _clips("drum"), "Inner Far": _clips("drum"),
        "Inner Near": _clips("bell", "drum"),
        "Inner Master": _clips("bell", "drum"), "Top World": _clips("bell", "drum"), "Top Radio": _clips("gong"),
        "Top Music": _clips("horn"), "Top Master": _clips("bell", "drum", "gong", "horn"), "manager": _clips(*CLIPS),
    },
    {**dict.fromkeys(_clips("bell", "lute"), ("",)), **dict.fromkeys(_clips("gong", "horn"), ("state", "script"))},
    dict.fromkeys(("bell", "drum", "lute", "variant", "variant of variant"), AT_REST_DB),
)  # fmt: skip


# Godot 4.3: streams in resources of their own, an inherited scene, buses four deep, an animation


def write_godot(root: Path, gains: Gains) -> Path:
    """Write a Godot project."""
    of = lambda place: gains.get(place, 0.0)  # noqa: E731
    _put(
        root,
        "project.godot",
        'config_version=5\n\n[application]\n\nconfig/name="Apart"\nrun/main_scene="res://main.tscn"\n'
        'config/features=PackedStringArray("4.3")\n\n[audio]\n\nbuses/default_bus_layout="res://audio/buses.tres"\n',
    )
    buses = [("World", "Master"), ("Steps", "World"), ("Soft", "Steps"), ("Hall", "Master")]
    layout = (
        '[gd_resource type="AudioBusLayout" load_steps=3 format=3 uid="uid://b1"]\n\n'
        f'[sub_resource type="AudioEffectAmplify" id="amp"]\nresource_name = "Amplify"\nvolume_db = {of("amplify")}\n\n'
        '[sub_resource type="AudioEffectCompressor" id="comp"]\nresource_name = "Compressor"\ngain = 6.0\n\n'
        f"[resource]\nbus/0/volume_db = {of('bus Master')}\n"
    )
    for number, (name, send) in enumerate(buses, start=1):
        layout += (
            f'bus/{number}/name = &"{name}"\nbus/{number}/solo = false\nbus/{number}/mute = false\n'
            f"bus/{number}/bypass_fx = false\nbus/{number}/volume_db = {of(f'bus {name}')}\n"
            f'bus/{number}/send = &"{send}"\n'
        )
    layout += 'bus/2/effect/0/effect = SubResource("amp")\nbus/2/effect/0/enabled = true\n'
    layout += 'bus/4/effect/0/effect = SubResource("comp")\nbus/4/effect/0/enabled = true\n'
    _put(root, "audio/buses.tres", layout)
    _put(
        root,
        "audio/steps.tres",
        '[gd_resource type="AudioStreamRandomizer" load_steps=3 format=3 uid="uid://b2"]\n\n'
        '[ext_resource type="AudioStream" uid="uid://c1" path="res://audio/left.wav" id="1_l"]\n'
        '[ext_resource type="AudioStream" uid="uid://c2" path="res://audio/right.wav" id="2_r"]\n\n[resource]\n'
        "random_pitch = 1.05\nrandom_volume_offset_db = 2.0\nstreams_count = 2\n"
        'stream_0/stream = ExtResource("1_l")\nstream_0/weight = 1.0\nstream_1/stream = ExtResource("2_r")\n'
        "stream_1/weight = 1.0\n",
    )
    _put(
        root,
        "audio/layers.tres",
        '[gd_resource type="AudioStreamSynchronized" load_steps=3 format=3 uid="uid://b3"]\n\n'
        '[ext_resource type="AudioStream" uid="uid://c3" path="res://audio/pad.wav" id="1_p"]\n'
        '[ext_resource type="AudioStream" uid="uid://c4" path="res://audio/beat.wav" id="2_b"]\n\n[resource]\n'
        f'stream_count = 2\nstream_0/stream = ExtResource("1_p")\nstream_0/volume = {of("layer pad")}\n'
        f'stream_1/stream = ExtResource("2_b")\nstream_1/volume = {of("layer beat")}\n',
    )
    _put(
        root,
        "player.tscn",
        '[gd_scene load_steps=4 format=3 uid="uid://d1"]\n\n'
        '[ext_resource type="AudioStream" uid="uid://b2" path="res://audio/steps.tres" id="1_s"]\n'
        '[ext_resource type="AudioStream" uid="uid://c5" path="res://audio/jump.wav" id="2_j"]\n\n'
        '[node name="Player" type="CharacterBody3D"]\n\n[node name="Audio" type="Node" parent="."]\n\n'
        '[node name="Steps" type="AudioStreamPlayer" parent="Audio"]\nstream = ExtResource("1_s")\n'
        f'volume_db = {of("player steps")}\nbus = &"Soft"\n\n'
        '[node name="Jump" type="AudioStreamPlayer" parent="Audio"]\nstream = ExtResource("2_j")\n'
        f'volume_db = {of("player jump")}\nbus = &"Steps"\n',
    )
    changed = (
        f'[node name="Jump" parent="Audio" index="1"]\nvolume_db = {of("inherited")}\n' if "inherited" in gains else ""
    )
    _put(
        root,
        "hero.tscn",
        '[gd_scene load_steps=2 format=3 uid="uid://d2"]\n\n'
        '[ext_resource type="PackedScene" uid="uid://d1" path="res://player.tscn" id="1_p"]\n\n'
        f'[node name="Hero" instance=ExtResource("1_p")]\n\n{changed}',
    )
    _put(
        root,
        "main.tscn",
        '[gd_scene load_steps=6 format=3 uid="uid://d3"]\n\n'
        '[ext_resource type="PackedScene" uid="uid://d2" path="res://hero.tscn" id="1_h"]\n'
        '[ext_resource type="AudioStream" uid="uid://b3" path="res://audio/layers.tres" id="2_m"]\n'
        '[ext_resource type="AudioStream" uid="uid://c6" path="res://audio/drip.wav" id="3_d"]\n'
        '[ext_resource type="AudioStream" uid="uid://c7" path="res://audio/alarm.wav" id="4_a"]\n\n'
        '[sub_resource type="Animation" id="anim"]\nresource_name = "fade"\nlength = 2.0\ntracks/0/type = "value"\n'
        'tracks/0/path = NodePath("Alarm:volume_db")\ntracks/0/keys = {\n"times": PackedFloat32Array(0, 2),\n'
        '"values": [0.0, -40.0]\n}\n\n[sub_resource type="AnimationLibrary" id="lib"]\n_data = {\n'
        '"fade": SubResource("anim")\n}\n\n'
        '[node name="Main" type="Node3D"]\n\n[node name="Hero" parent="." instance=ExtResource("1_h")]\n\n'
        '[node name="Music" type="AudioStreamPlayer" parent="."]\nstream = ExtResource("2_m")\n'
        f"volume_db = {of('music')}\nautoplay = true\n\n"
        '[node name="Drip" type="AudioStreamPlayer" parent="."]\nstream = ExtResource("3_d")\n'
        f'volume_db = {of("drip")}\nbus = &"Hall"\n\n[node name="Alarm" type="AudioStreamPlayer" parent="."]\n'
        f'stream = ExtResource("4_a")\nvolume_db = {of("alarm")}\n\n'
        '[node name="AnimationPlayer" type="AnimationPlayer" parent="."]\nlibraries = {\n"": SubResource("lib")\n}\n',
    )
    return root / "project.godot"


def _wavs(*names: str) -> tuple[str, ...]:
    return tuple(f"audio/{name}.wav" for name in names)


GODOT = Apart(
    write_godot,
    {
        "player steps": _wavs("left", "right"), "player jump": _wavs("jump"), "inherited": _wavs("jump"),
        "layer pad": _wavs("pad"), "layer beat": _wavs("beat"), "music": _wavs("pad", "beat"), "drip": _wavs("drip"),
        "alarm": _wavs("alarm"), "bus Soft": _wavs("left", "right"), "bus Steps": _wavs("left", "right", "jump"),
        "amplify": _wavs("left", "right", "jump"), "bus World": _wavs("left", "right", "jump"),
        "bus Hall": _wavs("drip"), "bus Master": _wavs("left", "right", "jump", "pad", "beat", "drip", "alarm"),
    },
    {
        **dict.fromkeys(_wavs("jump", "pad"), ("",)), **dict.fromkeys(_wavs("left", "right"), ("random",)),
        **dict.fromkeys(_wavs("drip"), ("effect",)), **dict.fromkeys(_wavs("alarm"), ("state",)),
    },
)  # fmt: skip


# Unreal, as the export writes it: a wave of its own, mixers in mixers, a modulator, classes and submixes three deep


def write_unreal(root: Path, gains: Gains) -> Path:
    """Write the export of an Unreal project."""
    factor = lambda place: 10 ** (gains.get(place, 0.0) / 20)  # noqa: E731

    def wave(name: str, sound_class: str = "", submix: str = "", attenuation: str = "") -> dict[str, object]:
        return {
            "path": f"/Game/Audio/{name}", "file": f"Audio/{name}.wav", "volume": factor(f"wave {name}"),
            "class": sound_class, "submix": submix, "attenuation": attenuation, "looped": False,
            "sample_rate_hz": 48_000, "imported_sample_rate_hz": 48_000, "compression": "", "referenced": True,
        }  # fmt: skip

    def node(kind: str, place: str, name: str) -> dict[str, object]:
        return {"kind": kind, "property": name, "volume": factor(place)}

    modulated = {"kind": "SoundNodeModulator", "volume": 1.0, "depends": True, "what": "random from 0.8 to 1"}
    outer, inner = (
        node("SoundNodeMixer", "outer 0", "InputVolume 0"),
        node("SoundNodeMixer", "inner 1", "InputVolume 1"),
    )
    other = node("SoundNodeMixer", "outer 1", "InputVolume 1")
    fixed = {"kind": "SoundNodeModulator", "volume": factor("modulator"), "depends": False, "what": ""}
    plays = [
        {"wave": "/Game/Audio/boom", "random": False, "nodes": [outer, inner]},
        {"wave": "/Game/Audio/crack", "random": True, "nodes": [other, modulated]},
        {"wave": "/Game/Audio/dust", "random": True, "nodes": [other, fixed]},
    ]
    document = {
        "format": 1,
        "tool": "audio-checks for Unreal",
        "engine_version": "5.4.4-35576357+++UE5+Release-5.4",
        "waves": [
            wave("boom"), wave("crack"), wave("dust"), wave("beep", "/Game/Classes/UI", "/Game/Mix/UI"),
            wave("far", "/Game/Classes/World", "", "/Game/Attenuation/Far"),
        ],
        "cues": [
            {"path": "/Game/Cues/Explosion", "volume": factor("cue"), "class": "/Game/Classes/Guns",
             "submix": "/Game/Mix/Guns", "attenuation": "", "plays": plays, "referenced": True},
        ],
        "classes": [
            {"path": "/Game/Classes/Guns", "volume": factor("class Guns"), "parent": "/Game/Classes/World"},
            {"path": "/Game/Classes/World", "volume": factor("class World"), "parent": "/Game/Classes/All"},
            {"path": "/Game/Classes/UI", "volume": factor("class UI"), "parent": "/Game/Classes/All"},
            {"path": "/Game/Classes/All", "volume": factor("class All"), "parent": ""},
        ],
        "submixes": [
            {"path": "/Game/Mix/Guns", "volume_db": gains.get("submix Guns", 0.0), "parent": "/Game/Mix/World"},
            {"path": "/Game/Mix/World", "volume_db": gains.get("submix World", 0.0), "parent": "/Game/Mix/All"},
            {"path": "/Game/Mix/UI", "volume_db": gains.get("submix UI", 0.0), "parent": "/Game/Mix/All"},
            {"path": "/Game/Mix/All", "volume_db": gains.get("submix All", 0.0), "parent": ""},
        ],
    }  # fmt: skip
    _put(root, "sounds.json", json.dumps(document))
    return root / "sounds.json"


def _unreal(*names: str) -> tuple[str, ...]:
    return tuple(f"Audio/{name}.wav" for name in names)


BLAST = _unreal("boom", "crack", "dust")
UNREAL = Apart(
    write_unreal,
    {
        "wave boom": _unreal("boom"), "wave beep": _unreal("beep"), "outer 0": _unreal("boom"),
        "inner 1": _unreal("boom"), "outer 1": _unreal("crack", "dust"), "modulator": _unreal("dust"), "cue": BLAST,
        "class Guns": BLAST, "class World": (*BLAST, *_unreal("far")), "class UI": _unreal("beep"),
        "class All": (*BLAST, *_unreal("far", "beep")), "submix Guns": BLAST, "submix World": BLAST,
        "submix UI": _unreal("beep"), "submix All": (*BLAST, *_unreal("beep")),
    },
    {
        **dict.fromkeys(_unreal("boom", "beep"), ("",)), **dict.fromkeys(_unreal("crack"), ("random",)),
        **dict.fromkeys(_unreal("far"), ("distance",)),
    },
)  # fmt: skip

APART = {"wwise": WWISE, "fmod": FMOD, "unity": UNITY, "unreal": UNREAL, "godot": GODOT}
