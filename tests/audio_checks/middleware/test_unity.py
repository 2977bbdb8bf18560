"""Unity: prefabs in prefabs, mixers, scripts and import settings."""

import pytest

from audio_checks.middleware.unity import read_unity

YAML = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n"
CLIP, PREFAB, MIXER, OUTER = ("a" * 32, "b" * 32, "c" * 32, "d" * 32)
META = (
    f"fileFormatVersion: 2\nguid: {CLIP}\nAudioImporter:\n  "
    "defaultSettings:\n    loadType: 2\n    compressionFormat: "
    "%s\n    sampleRateSetting: %s\n    sampleRateOverride: 22050\n  forceToMono: %s\n  normalize: %s\n"
)
SOURCE = (
    "--- !u!82 &77\nAudioSource:\n  m_GameObject: {fileID: 5}\n  OutputAudioMixerGroup: {fileID: 0}\n"
    f"  m_audioClip: {{fileID: 8300000, guid: {CLIP}, type: 3}}\n  m_Volume: 0.5\n  Loop: 1\n  Mute: 0\n"
)
NODE = "--- !u!1 &5\nGameObject:\n  m_Name: Feet\n"


def instance(id_, prefab, target, value, name="m_Volume"):
    return (
        f"--- !u!1001 &{id_}\nPrefabInstance:\n  m_Modification:\n    "
        f"m_Modifications:\n    - target: {{fileID: {target}, guid: {prefab},\n"
        f"        type: 3}}\n      propertyPath: {name}\n      value: {value}\n      objectReference: {{fileID: 0}}\n"
        f"  m_SourcePrefab: {{fileID: 100100000, guid: {prefab}, type: 3}}\n"
    )


@pytest.fixture
def unity(put):
    def read(files, meta=(1, 0, 0, 1)):
        put("ProjectSettings/ProjectVersion.txt", "m_EditorVersion: 2022.3.1f1\n")
        root = put("Assets/a.wav.meta", META % meta)
        for path, (guid, text) in files.items():
            put(path, text)
            put(f"{path}.meta", f"fileFormatVersion: 2\nguid: {guid}\n")
        return read_unity(root)

    return read


def test_a_volume_is_a_factor(unity):
    (one,) = unity({"Assets/p.prefab": (PREFAB, YAML + NODE + SOURCE)}).played
    assert one.gain_db == pytest.approx(-6.02, abs=0.01)
    assert (one.object_path, one.is_looped, one.is_streamed) == ("Assets/p.prefab: Feet", True, True)


def test_a_prefab_in_a_prefab_in_a_scene(unity):
    outer = (
        YAML
        + instance(900, PREFAB, 77, 1)
        + (
            "--- !u!82 &901 stripped\nAudioSource:\n  m_CorrespondingSourceObject: "
            f"{{fileID: 77, guid: {PREFAB},\n    type: 3}}\n"
            "  m_PrefabInstance: {fileID: 900}\n"
        )
    )
    project = unity(
        {
            "Assets/p.prefab": (PREFAB, YAML + NODE + SOURCE),
            "Assets/outer.prefab": (OUTER, outer),
            "Assets/s.unity": ("e" * 32, YAML + instance(31, OUTER, 901, 0.25)),
        }
    )
    found = {one.object_path.partition(":")[0]: round(one.gain_db, 1) + 0.0 for one in project.played}
    assert found == {"Assets/p.prefab": -6.0, "Assets/outer.prefab": 0.0, "Assets/s.unity": -12.0}


def test_a_source_in_a_prefab_that_is_not_listed_is_found_by_its_number(unity):
    outer = YAML + instance(900, PREFAB, 5, "x", name="m_Name")
    inside = 900 ^ 77
    project = unity(
        {
            "Assets/p.prefab": (PREFAB, YAML + NODE + SOURCE),
            "Assets/outer.prefab": (OUTER, outer),
            "Assets/s.unity": ("e" * 32, YAML + instance(31, OUTER, inside, 1)),
        }
    )
    assert [round(one.gain_db) + 0 for one in project.played if "s.unity" in one.object_path] == [0]


def test_what_a_script_holds_is_not_claimed_to_be_0_db(unity):
    script = (
        f"--- !u!114 &8\nMonoBehaviour:\n  m_Name: Steps\n  onLand:\n  - {{fileID: 8300000, guid: {CLIP}, type: 3}}\n"
    )
    (one,) = unity({"Assets/p.prefab": (PREFAB, YAML + script)}).played
    assert (one.gain_db, one.is_used, [found.on for found in one.depends]) == (None, True, ["script"])
    assert one.object_path == "Assets/p.prefab: onLand"


def test_a_mixer_with_snapshots_exposed_parameters_and_effects(unity):
    group = (
        "--- !u!243 &{id}\nAudioMixerGroupController:\n  m_Name: "
        "{name}\n  m_Children:\n{children}  m_Volume: {volume}\n"
        "  m_Effects:\n  - {{fileID: 44}}\n  m_Mute: 0\n"
    )
    mixer = (
        YAML + "--- !u!241 &1\nAudioMixerController:\n  m_Name: main\n "
        " m_StartSnapshot: {fileID: 60}\n  m_ExposedParameters:\n"
        f"  - guid: {'1' * 32}\n    name: SfxVolume\n"
        + group.format(id=50, name="Master", children="  - {fileID: 51}\n", volume="2" * 32)
        + group.format(id=51, name="Sfx", children="", volume="1" * 32)
        + "--- !u!244 &44\nAudioMixerEffectController:\n  m_EffectName: Compressor\n  m_Bypass: 0\n"
        + (
            "--- !u!245 &60\nAudioMixerSnapshotController:\n  m_Name: "
            f"Day\n  m_FloatValues:\n    {'1' * 32}: -3\n    {'2' * 32}: -1\n"
        )
        + (
            "--- !u!245 &61\nAudioMixerSnapshotController:\n  m_Name: "
            f"Night\n  m_FloatValues:\n    {'1' * 32}: -9\n    {'2' * 32}: -1\n"
        )
    )
    source = SOURCE.replace("{fileID: 0}", f"{{fileID: 51, guid: {MIXER}, type: 2}}").replace("0.5", "1")
    (one,) = unity({"Assets/m.mixer": (MIXER, mixer), "Assets/p.prefab": (PREFAB, YAML + NODE + source)}).played
    assert one.gain_db == -4.0
    assert [(found.on, found.what) for found in one.depends] == [
        ("state", 'snapshot "Night", -9 dB'),
        ("script", 'exposed parameter "SfxVolume"'),
        ("effect", "Compressor"),
        ("effect", "Compressor"),
    ]


@pytest.mark.parametrize(
    ("meta", "harms"),
    [
        ((1, 0, 0, 1), []),
        ((1, 0, 1, 1), ["mixed to mono, and its peak is then raised to full scale"]),
        ((1, 0, 1, 0), ["mixed to mono"]),
        ((2, 2, 0, 1), ["ADPCM: 4 bits a sample undo the dither", "resampled to 22,050 Hz"]),
    ],
)
def test_import_settings_that_change_the_sound(unity, meta, harms):
    (one,) = unity({"Assets/p.prefab": (PREFAB, YAML + NODE + SOURCE)}, meta).played
    assert [found.harm for found in one.conversions] == harms


def test_a_binary_scene_is_named(unity):
    project = unity({"Assets/s.unity": ("e" * 32, "\0\0binary")})
    assert project.played == ()
    assert "Force Text" in project.unread[0].message


def test_prefabs_that_hold_one_another_end(unity):
    project = unity(
        {
            "Assets/p.prefab": (PREFAB, YAML + instance(900, OUTER, 77, 1)),
            "Assets/o.prefab": (OUTER, YAML + instance(901, PREFAB, 77, 1)),
        }
    )
    assert project.played == ()
