"""Unreal: the script run with the documented calls of the editor; it was never run in the editor itself."""

import runpy
import sys
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from hypothesis import given, settings

from app.builds.engine_export.cues import ExportedCue
from app.builds.engine_export.engines.unreal import import_files
from audio_checks.middleware.unreal import read_unreal
from tests.app.builds.handed import CUES, HUM, LASER, cue, hostile_cues
from tests.audio_checks.middleware.test_unreal import SCRIPT as EXPORT
from tests.audio_checks.middleware.test_unreal import Asset as Exported
from tests.audio_checks.middleware.test_unreal import editor as exporting_editor

NOT_IN_ASSET_NAMES = set("\"' ,\n\r\t/\\.:|&!~@#(){}[]=;^%$`<>*?+-")  # INVALID_OBJECTNAME_CHARACTERS, and a dash


class Asset:
    """An asset of the editor: it refuses properties that its class does not have."""

    def __init__(self, kind: str, path: str, **properties: Any) -> None:
        assert not NOT_IN_ASSET_NAMES & set(path.rpartition("/")[2]), path
        self.kind, self.path, self.properties = kind, path, properties
        self.tags: dict[str, str] = {}

    def set_editor_property(self, name: str, value: object) -> None:
        if name not in self.properties:
            raise Exception(f"{self.kind} has no property {name}")
        self.properties[name] = value


class Factory:
    """SoundCueFactoryNew of 5.1 and later."""

    waves: list[Asset]

    def set_editor_property(self, name: str, value: list[Asset]) -> None:
        assert name == "initial_sound_waves"
        assert all(one.kind == "SoundWave" for one in value)
        self.waves = value


class Task:
    """AssetImportTask: the properties that are documented, and no others."""

    __slots__ = (
        "automated",
        "destination_name",
        "destination_path",
        "filename",
        "replace_existing",
        "replace_existing_settings",
        "save",
    )


class Editor:
    """A project in memory, and how often it was changed."""

    def __init__(self) -> None:
        self.assets: dict[str, Asset] = {}
        self.changes = 0
        self.warnings: list[str] = []
        tools = SimpleNamespace(import_asset_tasks=self._import, create_asset=self._create)
        self.module = SimpleNamespace(
            __name__="unreal",
            AssetImportTask=Task,
            AssetToolsHelpers=SimpleNamespace(get_asset_tools=lambda: tools),
            EditorAssetLibrary=SimpleNamespace(
                does_asset_exist=self.assets.__contains__,
                load_asset=self.assets.__getitem__,
                get_metadata_tag=lambda asset, tag: asset.tags.get(tag, ""),
                set_metadata_tag=self._set_tag,
                save_loaded_asset=self._save,
            ),
            SoundCue="SoundCue",
            SoundCueFactoryNew=Factory,
            log=lambda _text: None,
            log_warning=self.warnings.append,
        )

    def _import(self, tasks: list[Task]) -> None:
        for task in tasks:
            assert task.automated
            assert task.replace_existing
            assert not task.replace_existing_settings
            if Path(task.filename).is_file():
                path = f"{task.destination_path}/{task.destination_name}"
                known = self.assets.get(path)
                made = Asset("SoundWave", path, looping=False, filename=task.filename)
                if known:
                    made.properties["looping"] = known.properties["looping"]
                self.assets[path] = made
                self.changes += 1

    def _create(self, name: str, folder: str, kind: str, factory: Factory) -> Asset:
        path = f"{folder}/{name}"
        assert path not in self.assets
        self.assets[path] = Asset(kind, path, plays=[wave.path for wave in factory.waves])
        self.changes += 1
        return self.assets[path]

    def _set_tag(self, asset: Asset, tag: str, text: str) -> None:
        asset.tags[tag] = text
        self.changes += 1

    def _save(self, _asset: Asset) -> None:
        self.changes += 1

    def run(self, pack: Path, monkeypatch: pytest.MonkeyPatch) -> int:
        """Run the script of a pack; return how many changes it made."""
        self.changes = 0
        monkeypatch.setitem(sys.modules, "unreal", self.module)  # type: ignore[arg-type]
        runpy.run_path(str(pack / "soundlist_import.py"), run_name="__main__")
        return self.changes


def unpack(folder: Path, cues: list[ExportedCue]) -> Path:
    files = {file.path: file.sha256.encode() for one in cues for file in one.files} | import_files(cues)
    for path, content in files.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_bytes(content)
    return folder


def test_waves_and_cues_are_made_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    editor, pack = Editor(), unpack(tmp_path, CUES)
    assert editor.run(pack, monkeypatch) > 0
    assert sorted(editor.assets) == [
        "/Game/Audio/ambience/hum",
        "/Game/Audio/ambience/hum_Cue",
        "/Game/Audio/ui_confirm",
        "/Game/Audio/ui_confirm_Cue",
        "/Game/Audio/weapon/laser_fire_01",
        "/Game/Audio/weapon/laser_fire_02",
        "/Game/Audio/weapon/laser_fire_Cue",
    ]
    assert editor.assets["/Game/Audio/ambience/hum"].properties["looping"] is True
    laser = editor.assets["/Game/Audio/weapon/laser_fire_Cue"]
    assert laser.properties["plays"] == ["/Game/Audio/weapon/laser_fire_01", "/Game/Audio/weapon/laser_fire_02"]
    assert laser.tags["SoundlistNotes"] == "SW-001 Laser fire. Bright, thin."
    assert editor.run(pack, monkeypatch) == 0
    assert editor.warnings == []


def test_the_audit_finds_cues_loops_and_levels_of_what_was_imported(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    editor = Editor()
    editor.run(unpack(tmp_path, CUES), monkeypatch)
    waves = {
        path: Exported(
            "SoundWave",
            path,
            asset_import_data=SimpleNamespace(extract_filenames=lambda one=one: [one.properties["filename"]]),
            volume=1.0,
            looping=one.properties["looping"],
        )
        for path, one in editor.assets.items()
        if one.kind == "SoundWave"
    }
    cues = []
    for path, one in editor.assets.items():
        if one.kind == "SoundCue":  # as the factory draws it
            players = [
                Exported("SoundNodeWavePlayer", "", sound_wave_asset_ptr=waves[at]) for at in one.properties["plays"]
            ]
            node = players[0] if len(players) == 1 else Exported("SoundNodeRandom", "", child_nodes=players)
            cues.append(Exported("SoundCue", path, volume_multiplier=1.0, first_node=node))
    calls = exporting_editor([*waves.values(), *cues], tmp_path, {one.path for one in cues})
    monkeypatch.setitem(sys.modules, "unreal", calls)  # type: ignore[arg-type]
    runpy.run_path(str(EXPORT))["main"]([])
    project = read_unreal(tmp_path / "sounds.json")
    assert project.unread == ()
    assert {(one.file, one.events, one.is_looped, one.gain_db, one.depends) for one in project.played} == {
        ("Assets/ambience/hum.wav", ("/Game/Audio/ambience/hum_Cue",), True, 0.0, ()),
        ("Assets/ui_confirm.wav", ("/Game/Audio/ui_confirm_Cue",), False, 0.0, ()),
        ("Assets/weapon/laser_fire_01.wav", ("/Game/Audio/weapon/laser_fire_Cue",), False, 0.0, ()),
        ("Assets/weapon/laser_fire_02.wav", ("/Game/Audio/weapon/laser_fire_Cue",), False, 0.0, ()),
    }


def test_a_changed_sound_is_imported_again_and_keeps_its_settings(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    editor = Editor()
    editor.run(unpack(tmp_path, [HUM]), monkeypatch)
    editor.assets["/Game/Audio/ambience/hum"].properties["looping"] = False  # by the team
    changed = cue(2, "Assets/ambience/hum.wav", category="ambience", loop=True)
    (file,) = changed.files
    object.__setattr__(file, "sha256", "ab" * 32)
    editor.run(unpack(tmp_path, [changed]), monkeypatch)
    hum = editor.assets["/Game/Audio/ambience/hum"]
    assert (hum.tags["SoundlistSha256"], hum.properties["looping"]) == ("ab" * 32, False)
    assert editor.run(tmp_path, monkeypatch) == 0


def test_a_cue_that_plays_something_else_is_left_and_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    editor = Editor()
    editor.run(unpack(tmp_path, [LASER]), monkeypatch)
    more = cue(1, *(file.path for file in LASER.files), "Assets/weapon/laser_fire_03.wav", name="laser_fire")
    object.__setattr__(more, "category", "weapon")
    editor.run(unpack(tmp_path, [more]), monkeypatch)
    assert len(editor.assets["/Game/Audio/weapon/laser_fire_Cue"].properties["plays"]) == 2
    assert "laser_fire_Cue does not play laser_fire_01,laser_fire_02,laser_fire_03" in editor.warnings[0]


def test_a_lost_file_leaves_its_cue_out(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    editor, pack = Editor(), unpack(tmp_path, CUES)
    (pack / LASER.files[0].path).unlink()
    editor.run(pack, monkeypatch)
    assert "/Game/Audio/weapon/laser_fire_Cue" not in editor.assets
    assert "/Game/Audio/ambience/hum_Cue" in editor.assets
    assert "laser_fire_01.wav was not imported" in editor.warnings[0]


@pytest.mark.slow
@settings(max_examples=15, deadline=None)
@given(cues=hostile_cues())
def test_hostile_names_are_only_names(tmp_path_factory: pytest.TempPathFactory, cues: list[ExportedCue]) -> None:
    editor, pack = Editor(), unpack(tmp_path_factory.mktemp("pack"), cues)
    with pytest.MonkeyPatch.context() as monkeypatch:
        editor.run(pack, monkeypatch)
        assert len(editor.assets) == sum(len(one.files) + 1 for one in cues)
        assert all(path.startswith("/Game/Audio/") for path in editor.assets)
        assert editor.run(pack, monkeypatch) == 0
