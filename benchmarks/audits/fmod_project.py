"""A small project of FMOD Studio with a gain at each place of its tree."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from benchmarks.audits.places import IN_BUS, IN_CONTAINER, IN_MIXER, Gains, guid, put_file


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

    def of(*place):
        return gains.get(place)

    put_file(
        root, "Game.fspro", '<?xml version="1.0" encoding="UTF-8"?>\n<objects serializationModel="Studio.02.02.00" />\n'
    )
    master = guid("fmod master")
    put_file(
        root,
        "Metadata/Master.xml",
        _objects(_object("MixerMaster", master, {"name": "Master Bus", "volume": of("master", 0)})),
    )
    for sound in range(sounds):
        asset = _object(
            "AudioFile", guid("asset", sound), {"assetPath": f"steps/snd_{sound:04}.wav", "isStreaming": "false"}
        )
        put_file(root, f"Metadata/AudioFile/{{{guid('asset', sound)}}}.xml", _objects(asset))
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
        put_file(root, f"Metadata/Group/{{{guid('bus', bus)}}}.xml", group)
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
        put_file(root, f"Metadata/Event/{{{guid('event', event)}}}.xml", _objects(*those))
    return root / "Game.fspro"
