"""Unreal: what the script writes, run with the documented calls of the editor, and what is read of it.

The script was never run in a real editor. The module `unreal` here knows the calls that the documentation names, and no
other.
"""

import importlib.util
import json
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

from audio_checks.middleware.unreal import read_unreal

SCRIPT = Path(__file__).resolve().parents[3] / "integrations" / "unreal" / "export_sounds.py"


class Asset:
    """An object of the editor: it refuses properties that its class does not have."""

    def __init__(self, kind, path, **properties):
        self.kind, self.path, self.properties = kind, path, properties

    def get_class(self):
        return SimpleNamespace(get_name=lambda: self.kind)

    def get_path_name(self):
        return f"{self.path}.{self.path.rpartition('/')[2]}"

    def get_editor_property(self, name):
        if name not in self.properties:
            raise Exception(f"{self.kind} has no property {name}")
        return self.properties[name]


def editor(assets, root, referenced=()):
    """Return the calls of the editor that the script makes, over some assets."""
    by_path = {asset.path: asset for asset in assets}
    data = {
        path: SimpleNamespace(
            package_name=path,
            asset_class_path=SimpleNamespace(asset_name=asset.kind),
            get_asset=lambda asset=asset: asset,
        )
        for path, asset in by_path.items()
    }
    registry = SimpleNamespace(get_referencers=lambda package, _options: ["map"] if package in referenced else [])
    return SimpleNamespace(
        AssetRegistryHelpers=SimpleNamespace(get_asset_registry=lambda: registry),
        AssetRegistryDependencyOptions=SimpleNamespace,
        EditorAssetLibrary=SimpleNamespace(
            list_assets=lambda _folder, **_which: list(by_path), find_asset_data=data.__getitem__
        ),
        Paths=SimpleNamespace(
            convert_relative_path_to_full=lambda path: path,
            project_dir=lambda: str(root),
            project_saved_dir=lambda: str(root),
        ),
        SystemLibrary=SimpleNamespace(get_engine_version=lambda: "5.4.1-1"),
        log=lambda _text: None,
    )


@pytest.fixture
def export(tmp_path, monkeypatch):
    """Run the script over assets; return what is read of its file."""

    def run(assets, referenced=()):
        monkeypatch.setitem(sys.modules, "unreal", editor(assets, tmp_path, referenced))
        spec = importlib.util.spec_from_file_location("export_sounds", SCRIPT)
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        module.main([])
        assert json.loads((tmp_path / "sounds.json").read_text())["format"] == 1
        return read_unreal(tmp_path / "sounds.json")

    return run


def wave(root, name, **properties):
    source = SimpleNamespace(extract_filenames=lambda: [str(root / "Audio" / f"{name}.wav")])
    return Asset("SoundWave", f"/Game/{name}", asset_import_data=source, **{"volume": 1.0, **properties})


def test_a_cue_with_a_mixer_and_a_class(export, tmp_path):
    step, tail = wave(tmp_path, "step", volume=0.5), wave(tmp_path, "tail")
    player = [Asset("SoundNodeWavePlayer", f"/n{one.path}", sound_wave_asset_ptr=one) for one in (step, tail)]
    mixer = Asset("SoundNodeMixer", "/n/mix", child_nodes=player, input_volume=[1.0, 2.0])
    master = Asset("SoundClass", "/Game/All", properties=Asset("SoundClassProperties", "/p", volume=0.1))
    cue = Asset("SoundCue", "/Game/cue", volume_multiplier=1.0, first_node=mixer, sound_class_object=master)
    project = export([step, tail, cue, master], referenced={"/Game/cue"})
    found = {one.file: one for one in project.played}
    assert found["Audio/step.wav"].gain_db == pytest.approx(-26.02, abs=0.01)
    assert found["Audio/tail.wav"].gain_db == pytest.approx(-13.98, abs=0.01)
    assert [part.object_path for part in found["Audio/tail.wav"].parts] == ["/Game/cue: SoundNodeMixer", "/Game/All"]
    assert {one.is_used for one in project.played} == {True}


def test_random_volume_attenuation_and_unknown_nodes_are_reported(export, tmp_path):
    step = wave(tmp_path, "step")
    player = Asset("SoundNodeWavePlayer", "/n/p", sound_wave=step)  # as older editors name it
    modulator = Asset("SoundNodeModulator", "/n/m", child_nodes=[player], volume_min=0.5, volume_max=1.0)
    odd = Asset("SoundNodeCrossFade", "/n/o", child_nodes=[modulator])
    near = Asset("SoundAttenuation", "/Game/near")
    cue = Asset("SoundCue", "/Game/cue", first_node=odd, attenuation_settings=near)
    (one,) = export([step, cue], referenced={"/Game/cue"}).played
    assert [found.on for found in one.depends] == ["state", "random", "distance"]
    assert one.gain_db == 0.0


def test_a_wave_that_nothing_names_is_not_used(export, tmp_path):
    (one,) = export([wave(tmp_path, "step")]).played
    assert one.is_used is False


def test_resampling_and_adpcm(export, tmp_path):
    kind = SimpleNamespace(name="ADPCM")
    (one,) = export(
        [wave(tmp_path, "step", sample_rate=22050, imported_sample_rate=48000, sound_asset_compression_type=kind)]
    ).played
    assert [found.harm for found in one.conversions] == [
        "resampled from 48,000 to 22,050 Hz",
        "ADPCM: 4 bits a sample undo the dither",
    ]


@pytest.mark.parametrize("volume", [True, "1", None, [], {}])
def test_a_volume_that_is_no_number_is_no_gain(tmp_path, volume):
    document = {"format": 1, "waves": [{"path": "/Game/a", "file": "a.wav", "volume": volume}, 5, {}]}
    (tmp_path / "sounds.json").write_text(json.dumps(document))
    project = read_unreal(tmp_path / "sounds.json")
    assert [one.gain_db for one in project.played] == [0.0]
    assert [one.message for one in project.unread] == [
        "waves[1]: wanted an object with a path",
        "waves[2]: wanted an object with a path",
    ]
