"""Writes what an Unreal project plays, and how loud, as JSON for `audio-checks audit --project`.

Run it in the Unreal editor (Tools, Execute Python Script, with the Python Editor Script Plugin), or without one:

    UnrealEditor-Cmd Game.uproject -run=pythonscript -script="export_sounds.py Saved/sounds.json"

It reads assets and changes none. A property that this version of the editor does not have is left out. MetaSounds keep
their gains in graphs, which the editor's scripts do not read: what they play is not listed.
"""

import json
import os
import sys

import unreal

FOLDER = "/Game"
LINEAR_NODES = {"SoundNodeMixer": "input_volume", "SoundNodeConcatenator": "input_volume"}
MOST_NODES_DEEP = 32


def value(asset, name, default=None):
    """Return a property of an asset; the default where this version of the editor lacks it."""
    try:
        found = asset.get_editor_property(name)
    except Exception:  # the editor raises a plain Exception for a name it does not know
        return default
    return default if found is None else found


def path_of(asset):
    """Return an asset's path without its name's second half; empty for no asset."""
    return asset.get_path_name().partition(".")[0] if asset else ""


def kind_of(asset):
    """Return the name of an asset's class."""
    return asset.get_class().get_name()


def enum(found):
    """Return the name of an enumeration's value."""
    return getattr(found, "name", "") or ""


def assets_of(kind):
    """Return the assets of a class below the folder."""
    registry = unreal.AssetRegistryHelpers.get_asset_registry()
    listed = unreal.EditorAssetLibrary.list_assets(FOLDER, recursive=True, include_folder=False)
    for path in sorted(listed):
        data = unreal.EditorAssetLibrary.find_asset_data(path)
        if str(data.asset_class_path.asset_name) == kind:
            asset = data.get_asset()
            if asset:
                yield asset, bool(registry.get_referencers(data.package_name, unreal.AssetRegistryDependencyOptions()))


def wave(asset, referenced):
    """Return what is said of a SoundWave."""
    source = value(asset, "asset_import_data")
    files = list(source.extract_filenames()) if source else []
    root = unreal.Paths.convert_relative_path_to_full(unreal.Paths.project_dir())
    file = os.path.relpath(files[0], root).replace(os.sep, "/") if files else ""
    return {
        "path": path_of(asset),
        "file": file,
        "volume": value(asset, "volume", 1.0),
        "class": path_of(value(asset, "sound_class_object")),
        "submix": path_of(value(asset, "sound_submix_object")),
        "attenuation": path_of(value(asset, "attenuation_settings")),
        "looped": bool(value(asset, "looping", False)),
        "sample_rate_hz": int(value(asset, "sample_rate", 0)),
        "imported_sample_rate_hz": int(value(asset, "imported_sample_rate", 0)),
        "compression": enum(value(asset, "sound_asset_compression_type")),
        "referenced": referenced,
    }


def plays(node, above, depth=0, is_random=False):
    """Yield each wave below a node of a cue, with the nodes that change its level on the way."""
    if node is None or depth > MOST_NODES_DEEP:
        return
    kind = kind_of(node)
    if kind == "SoundNodeWavePlayer":
        asset = value(node, "sound_wave_asset_ptr") or value(node, "sound_wave")
        if asset:
            yield {"wave": path_of(asset), "random": is_random, "nodes": above}
        return
    factors = value(node, LINEAR_NODES[kind], []) if kind in LINEAR_NODES else []
    own = []
    if kind == "SoundNodeModulator":
        lowest, highest = value(node, "volume_min", 1.0), value(node, "volume_max", 1.0)
        random = lowest != highest
        what = f"random from {lowest:g} to {highest:g}" if random else ""
        own = [{"kind": kind, "volume": 1.0 if random else highest, "depends": random, "what": what}]
    elif kind not in LINEAR_NODES and kind not in ("SoundNodeRandom", "SoundNodeLooping", "SoundNodeDelay"):
        own = [{"kind": kind, "depends": True}]
    for at, child in enumerate(value(node, "child_nodes", [])):
        factor = [{"kind": kind, "property": f"InputVolume {at}", "volume": factors[at]}] if at < len(factors) else []
        yield from plays(child, above + own + factor, depth + 1, is_random or kind == "SoundNodeRandom")


def cue(asset, referenced):
    """Return what is said of a SoundCue."""
    return {
        "path": path_of(asset),
        "volume": value(asset, "volume_multiplier", 1.0),
        "class": path_of(value(asset, "sound_class_object")),
        "submix": path_of(value(asset, "sound_submix_object")),
        "attenuation": path_of(value(asset, "attenuation_settings")),
        "plays": list(plays(value(asset, "first_node"), [])),
        "referenced": referenced,
    }


def sound_class(asset, _referenced):
    """Return what is said of a SoundClass."""
    properties = value(asset, "properties")
    return {
        "path": path_of(asset),
        "volume": value(properties, "volume", 1.0) if properties else 1.0,
        "parent": path_of(value(asset, "parent_class")),
    }


def submix(asset, _referenced):
    """Return what is said of a submix, whose volume is in dB."""
    modulated = value(asset, "output_volume_modulation")
    return {
        "path": path_of(asset),
        "volume_db": value(modulated, "value", 0.0) if modulated else 0.0,
        "parent": path_of(value(asset, "parent_submix")),
    }


def document():
    """Return all that is said of the project."""
    lists = (
        ("waves", "SoundWave", wave),
        ("cues", "SoundCue", cue),
        ("classes", "SoundClass", sound_class),
        ("submixes", "SoundSubmix", submix),
    )
    return {
        "format": 1,
        "tool": "audio-checks for Unreal",
        "engine_version": str(unreal.SystemLibrary.get_engine_version()),
        **{name: [entry(asset, referenced) for asset, referenced in assets_of(kind)] for name, kind, entry in lists},
    }


def main(arguments):
    """Write the export to the file that is named, or to Saved/sounds.json."""
    out = arguments[0] if arguments else os.path.join(unreal.Paths.project_saved_dir(), "sounds.json")
    with open(out, "w", encoding="utf-8") as file:
        json.dump(document(), file, indent=1, sort_keys=True)
    unreal.log(f"audio-checks: wrote {out}")


if __name__ == "__main__":
    main(sys.argv[1:])
