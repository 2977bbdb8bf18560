"""Imports the sounds of a Soundlist pack into an Unreal 5 project, and makes a cue for each event.

Run it in the editor (Tools, Execute Python Script, with the Python Editor Script Plugin), or without one:

    UnrealEditor-Cmd Game.uproject -run=pythonscript -script="/path/of/the/pack/soundlist_import.py"

A sound whose SHA-256 is that of the asset is left alone. A changed one is imported again with the settings that its
asset has. Cues that play other sounds than the pack says are left alone and named.
"""

import json
import os

import unreal

DOCUMENT = "soundlist-handoff.json"
FORMAT = 1
ROOT = "/Game/Audio"
HASH_TAG = "SoundlistSha256"
CUE_TAG = "SoundlistCue"
WAVES_TAG = "SoundlistWaves"
NOTES_TAG = "SoundlistNotes"
MOST_OF_A_RANDOM_NODE = 32


def sounds_of(folder):
    """Return the sounds of the pack in a folder."""
    with open(os.path.join(folder, DOCUMENT), encoding="utf-8") as file:
        content = json.load(file)
    if content["format"] != FORMAT:
        raise ValueError(f"{DOCUMENT} is of format {content['format']}; this script reads {FORMAT}")
    return content["sounds"]


def folder_of(sound):
    """Return the folder of a sound's assets."""
    category = "".join(char if char.isascii() and char.isalnum() else "_" for char in sound["category"])
    return f"{ROOT}/{category}" if category else ROOT


def import_wave(pack, sound, file, report):
    """Return the asset of a file, imported where its content is new; None where that fails."""
    library = unreal.EditorAssetLibrary
    folder = folder_of(sound)
    path = f"{folder}/{file['asset']}"
    known = library.load_asset(path) if library.does_asset_exist(path) else None
    if known is not None and library.get_metadata_tag(known, HASH_TAG) == file["sha256"]:
        report["same"] += 1
        return known
    task = unreal.AssetImportTask()
    task.filename = os.path.join(pack, *file["path"].split("/"))
    task.destination_path = folder
    task.destination_name = file["asset"]
    task.automated = True
    task.replace_existing = True
    task.replace_existing_settings = False
    task.save = False
    unreal.AssetToolsHelpers.get_asset_tools().import_asset_tasks([task])
    wave = library.load_asset(path) if library.does_asset_exist(path) else None
    if wave is None:
        unreal.log_warning(f"Soundlist: {file['path']} was not imported")
        return None
    if known is None:
        wave.set_editor_property("looping", sound["loop"])
    library.set_metadata_tag(wave, HASH_TAG, file["sha256"])
    library.set_metadata_tag(wave, CUE_TAG, sound["cue"])
    library.save_loaded_asset(wave)
    report["imported" if known is None else "changed"] += 1
    return wave


def make_cue(sound, waves, report):
    """Make the cue of a sound: one wave, or a random node over its set, as the editor's factory draws them."""
    library = unreal.EditorAssetLibrary
    name, folder = f"{sound['asset']}_Cue", folder_of(sound)
    path = f"{folder}/{name}"
    wanted = ",".join(file["asset"] for file in sound["files"])
    if library.does_asset_exist(path):
        cue = library.load_asset(path)
        if library.get_metadata_tag(cue, WAVES_TAG) != wanted:
            unreal.log_warning(f"Soundlist: {path} does not play {wanted}; it was left as it is")
        return
    if len(waves) > MOST_OF_A_RANDOM_NODE:
        unreal.log_warning(f"Soundlist: {path} plays the first {MOST_OF_A_RANDOM_NODE} of {len(waves)} variations")
    factory = unreal.SoundCueFactoryNew()
    factory.set_editor_property("initial_sound_waves", waves[:MOST_OF_A_RANDOM_NODE])
    cue = unreal.AssetToolsHelpers.get_asset_tools().create_asset(name, folder, unreal.SoundCue, factory)
    if cue is None:
        unreal.log_warning(f"Soundlist: {path} could not be made")
        return
    for tag, text in ((WAVES_TAG, wanted), (CUE_TAG, sound["cue"]), (NOTES_TAG, sound["notes"])):
        library.set_metadata_tag(cue, tag, text)
    library.save_loaded_asset(cue)
    report["cues"] += 1


def import_pack(pack):
    """Import all sounds of a pack; return how many files and cues were new, changed and the same."""
    report = {"imported": 0, "changed": 0, "same": 0, "cues": 0}
    for sound in sounds_of(pack):
        waves = [import_wave(pack, sound, file, report) for file in sound["files"]]
        if None not in waves:
            make_cue(sound, waves, report)
    unreal.log("Soundlist: " + ", ".join(f"{count} {what}" for what, count in report.items()))
    return report


if __name__ == "__main__":
    import_pack(os.path.dirname(os.path.abspath(__file__)))
