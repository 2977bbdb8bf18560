"""A small project of Wwise with a gain at each place of its tree."""

from __future__ import annotations

from pathlib import Path

from benchmarks.audits.places import IN_BUS, IN_CONTAINER, IN_MIXER, Gains, guid, put_file

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
    put_file(
        root,
        "Game.wproj",
        '<?xml version="1.0" encoding="utf-8"?>\n<WwiseDocument '
        'Type="Project" SchemaVersion="110" WwiseVersion="v2022.1.3"/>\n',
    )

    def of(*place):
        return gains.get(place)

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
        put_file(root, f"Actor-Mixer Hierarchy/More/{name}.wwu", _unit("AudioObjects", name, body, owner=owner))
        references += (
            f'<WorkUnit Name="{name}" ID="{{{guid("unit", "AudioObjects", name)}}}" PersistMode="Reference"/>\n'
        )
    top = (
        f'<ActorMixer Name="all" ID="{{{guid("folder")}}}">\n{_properties(Volume=of("top", 0))}'
        f"{_reference('OutputBus', MASTER)}<ChildrenList>\n{references}</ChildrenList>\n</ActorMixer>\n"
    )
    put_file(root, "Actor-Mixer Hierarchy/Default Work Unit.wwu", _unit("AudioObjects", "Default Work Unit", top))
    buses = "".join(
        f'<Bus Name="bus_{bus}" ID="{{{guid("bus", bus)}}}">\n'
        f"{_properties(BusVolume=of('bus', bus), OutputBusVolume=of('bus output', bus))}</Bus>\n"
        for bus in range(-(-sounds // IN_BUS))
    )
    master = (
        f'<Bus Name="Master Audio Bus" ID="{MASTER}">\n{_properties(BusVolume=of("master", 0))}'
        f"<ChildrenList>\n{buses}</ChildrenList>\n</Bus>\n"
    )
    put_file(root, "Master-Mixer Hierarchy/Default Work Unit.wwu", _unit("Busses", "Default Work Unit", master))
    events = "".join(
        f'<Event Name="Play_box_{one}" ID="{{{guid("event", one)}}}">\n'
        f'<ChildrenList>\n<Action Name="" ID="{{{guid("action", one)}}}">\n'
        f"{_reference('Target', '{' + guid('container', one) + '}')}</Action>\n</ChildrenList>\n</Event>\n"
        for one in range(-(-sounds // IN_CONTAINER))
    )
    put_file(root, "Events/Default Work Unit.wwu", _unit("Events", "Default Work Unit", events))
    return root / "Game.wproj"
