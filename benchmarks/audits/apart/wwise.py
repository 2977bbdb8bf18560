"""Wwise 2022.1: switch and blend containers, states, game parameters, nested buses, music, two languages."""

from __future__ import annotations

from pathlib import Path
from zlib import crc32

from benchmarks.audits.apart.project import Apart, Gains, put
from benchmarks.audits.places import guid
from benchmarks.audits.wwise_project import MASTER


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
    put(root, f"{folder}/{name}.wwu", text)


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
    put(
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
