"""The content of single elements of a Wwise work unit: properties, their values, and influences on them."""

from __future__ import annotations

from collections.abc import Iterator
from xml.etree import ElementTree as ET

from audio_checks.middleware.values import Conversion, Dependency, number

GAINS = frozenset({"BusVolume", "MakeUpGain", "OutputBusVolume", "Volume", "VolumeOffset"})


def properties_of(element: ET.Element) -> Iterator[tuple[str, ET.Element]]:
    """Yield the properties of an object with their names."""
    for list_ in element.iterfind("PropertyList"):
        for property_ in list_:
            yield property_.get("Name", ""), property_


def value_of(property_: ET.Element) -> str:
    """Return the value of a property that counts for all platforms, else the first."""
    if (own_value := property_.get("Value")) is not None:
        return own_value
    values = property_.findall("ValueList/Value")
    shared = next((value for value in values if "Platform" not in value.attrib), values[0] if values else None)
    return (shared.text or "").strip() if shared is not None else ""


def changes_of(name: str, property_: ET.Element) -> list[Dependency]:
    """Return influences that move a property away from its value."""
    dependencies = []
    for rtpc in property_.iterfind("RTPCList/RTPC"):
        meant = rtpc.find("ReferenceList/Reference[@Name='ControlInput']/ObjectRef")
        what = meant.get("Name", "") if meant is not None else rtpc.get("Name", "")
        dependencies.append(Dependency("", name, "state", f'game parameter "{what}"'))
    for modifier in property_.iterfind("ModifierList/ModifierInfo/Modifier"):
        values = {key: value_of(two) for key, two in properties_of(modifier)}
        if values.get("Enabled") == "True":
            what = f"random from {values.get('Min', '0')} to {values.get('Max', '0')} dB"
            dependencies.append(Dependency("", name, "random", what))
    if property_.find("ValueList/Value[@Platform]") is not None:
        values_of = {value.text for value in property_.iterfind("ValueList/Value")}
        if len(values_of) > 1:
            dependencies.append(Dependency("", name, "state", "the platform"))
    return dependencies


def states_of(element: ET.Element) -> Iterator[Dependency]:
    """Yield the gains that states set."""
    for state in element.iterfind("StateInfo/CustomStateList/CustomState"):
        meant = state.find("StateRef")
        for inner in state.iterfind("CustomState"):
            for name, property_ in properties_of(inner):
                if name in GAINS and number(value_of(property_)):
                    what = f'state "{meant.get("Name", "") if meant is not None else ""}", {value_of(property_)} dB'
                    yield Dependency("", name, "state", what)


def curves_of(element: ET.Element) -> Iterator[Dependency]:
    """Yield the gains that game parameters move, as Wwise writes them since 2022.1: in a list beside the properties."""
    for rtpc in element.iterfind("ObjectLists/ObjectList[@Name='RTPC']//RTPC"):
        name = next((value_of(property_) for name, property_ in properties_of(rtpc) if name == "PropertyName"), "")
        if name in GAINS:
            meant = rtpc.find("ReferenceList/Reference[@Name='ControlInput']/ObjectRef")
            what = f'game parameter "{meant.get("Name", "")}"' if meant is not None else "a modulator"
            yield Dependency("", name, "state", what)


def effects_of(element: ET.Element) -> Iterator[Dependency]:
    """Yield the effects in an object's slots, as Wwise writes them since 2022.1; one that is bypassed does nothing."""
    for slot in element.iterfind("ObjectLists/ObjectList//EffectSlot"):
        if any(name == "Bypass" and value_of(property_) == "True" for name, property_ in properties_of(slot)):
            continue
        for reference in slot.iterfind("ReferenceList/Reference[@Name='Effect']"):
            meant = reference.find("ObjectRef")
            what = meant.get("Name", "") if meant is not None else reference.get("PluginName", "")
            yield Dependency("", "Effect", "effect", f'effect "{what}"')


def harms_of(conversion: ET.Element, file: str) -> tuple[Conversion, ...]:
    """Return the settings of a conversion that change a sound."""
    name = conversion.get("Name", "")
    values = {key: value_of(property_) for key, property_ in properties_of(conversion)}
    harms = []
    if (rate := number(values.get("SampleRate"))) and rate >= 1_000:
        harms.append(Conversion(f'"{name}": SampleRate', f"resampled to {rate:,.0f} Hz", file))
    if any(plugin.get("PluginName") == "ADPCM" for plugin in conversion.iter("ConversionPlugin")):
        harms.append(Conversion(f'"{name}": ADPCM', "4 bits a sample undo the dither", file))
    return tuple(harms)
