"""FMOD Studio 2.02: an event in another one, groups in groups, a VCA, a snapshot, an automated bus."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from benchmarks.audits.apart.project import Apart, Gains, put
from benchmarks.audits.places import guid


class _Fmod:
    """The objects of one metadata file."""

    def __init__(self, root: Path) -> None:
        self._root = root

    def file(self, kind: str, *objects: str) -> None:
        """Write a file that begins with an object."""
        head = '<?xml version="1.0" encoding="UTF-8"?>\n<objects serializationModel="Studio.02.02.00">\n'
        name = objects[0].partition('id="')[2].partition('"')[0]
        place = f"Metadata/{kind}.xml" if kind in ("Master", "Mixer", "Workspace") else f"Metadata/{kind}/{name}.xml"
        put(self._root, place, head + "".join(objects) + "</objects>\n")


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
    modules, tracks = [_fid(name, sound) for sound in sounds], f"{name} track"
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
    put(root, "Apart.fspro", head + '<objects serializationModel="Studio.02.02.00" />\n')
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
