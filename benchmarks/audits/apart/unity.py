"""Unity 2021.3: a mixer into another one, snapshots, an exposed group, variants of variants, overrides in a scene."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from benchmarks.audits.apart.project import Apart, Gains, put
from benchmarks.audits.places import guid

AT_REST_DB = -6.0  # of a source where nothing is planted: its factor is at most 1
YAML = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n"


def _hex(*names: object) -> str:
    return guid("unity apart", *names).replace("-", "").lower()


def _meta(root: Path, path: str, importer: str = "DefaultImporter:\n  externalObjects: {}\n") -> None:
    put(root, f"{path}.meta", f"fileFormatVersion: 2\nguid: {_hex(path)}\n{importer}")


def _linear(gains: Gains, place: str) -> float:
    return float(f"{10 ** (gains.get(place, AT_REST_DB) / 20):.9g}")


def _mixer_group(name: str, id_: int, mixer: str, children: list[int]) -> str:
    held = "".join(f"  - {{fileID: {child}}}\n" for child in children)
    return (
        f"--- !u!243 &{id_}\nAudioMixerGroupController:\n  m_ObjectHideFlags: 0\n  m_Name: {name}\n"
        f"  m_AudioMixer: {{fileID: 24100000}}\n  m_GroupID: {_hex(mixer, name)}\n"
        f"  m_Children:{'' if held else ' []'}\n"
        f"{held}  m_Volume: {_hex(mixer, name, 'volume')}\n  m_Pitch: {_hex(mixer, name, 'pitch')}\n"
        f"  m_Effects:\n  - {{fileID: {id_ + 1}}}\n  m_UserColorIndex: 0\n  m_Mute: 0\n  m_Solo: 0\n"
        "  m_BypassEffects: 0\n"
        f"--- !u!244 &{id_ + 1}\nAudioMixerEffectController:\n  m_ObjectHideFlags: 3\n  m_Name: \n"
        f"  m_EffectID: {_hex(mixer, name, 'effect')}\n  m_EffectName: Attenuation\n"
        f"  m_MixLevel: {_hex(mixer, name, 'mix')}\n"
        "  m_Parameters: []\n  m_SendTarget: {fileID: 0}\n  m_EnableWetMix: 0\n  m_Bypass: 0\n"
    )


def _snapshot(name: str, id_: int, values: Mapping[str, float]) -> str:
    held = "".join(f"    {key}: {value:g}\n" for key, value in values.items())
    return (
        f"--- !u!245 &{id_}\nAudioMixerSnapshotController:\n  m_ObjectHideFlags: 0\n  m_Name: {name}\n"
        f"  m_AudioMixer: {{fileID: 24100000}}\n  m_SnapshotID: {_hex(name, id_)}\n"
        f"  m_FloatValues:{'' if held else ' {}'}\n{held}  m_TransitionOverrides: {{}}\n"
    )


def _mixer(
    root: Path, gains: Gains, name: str, groups: Mapping[str, str], *, output: str, exposed: str, low: str
) -> None:
    """Write a mixer; groups name the one above them, and in the second snapshot one group is low."""
    ids = {group: 24300000 + 10 * place for place, group in enumerate(groups, start=1)}
    text = YAML + (
        f"--- !u!241 &24100000\nAudioMixerController:\n  m_ObjectHideFlags: 0\n  m_Name: {name}\n"
        f"  m_OutputGroup: {output}\n  m_MasterGroup: {{fileID: {ids['Master']}}}\n  m_Snapshots:\n"
        "  - {fileID: 24500000}\n  - {fileID: 24500001}\n  m_StartSnapshot: {fileID: 24500000}\n"
        "  m_SuspendThreshold: -80\n  m_EnableSuspend: 1\n  m_UpdateMode: 0\n"
        f"  m_ExposedParameters:\n  - guid: {_hex(name, exposed, 'volume')}\n    name: {exposed}Volume\n"
        "  m_AudioMixerGroupViews: []\n  m_CurrentViewIndex: 0\n  m_TargetSnapshot: {fileID: 24500000}\n"
    )
    for group, id_ in ids.items():
        text += _mixer_group(group, id_, name, [ids[one] for one, above in groups.items() if above == group])
    start = {_hex(name, one, "volume"): gains[f"{name} {one}"] for one in groups if f"{name} {one}" in gains}
    text += _snapshot("Start", 24500000, start) + _snapshot(
        "Low", 24500001, {**start, _hex(name, low, "volume"): -20.0}
    )
    put(root, f"Assets/Mixers/{name}.mixer", text)
    _meta(root, f"Assets/Mixers/{name}.mixer", "NativeFormatImporter:\n  mainObjectFileID: 24100000\n")


def _group_of(mixer: str, place: int) -> str:
    return f"{{fileID: {24300000 + 10 * place}, guid: {_hex(f'Assets/Mixers/{mixer}.mixer')}, type: 2}}"


def _source_of(id_: int, clip: str, group: str, volume: float, game_object: int) -> str:
    return (
        f"--- !u!82 &{id_}\nAudioSource:\n  m_ObjectHideFlags: 0\n  m_CorrespondingSourceObject: {{fileID: 0}}\n"
        f"  m_PrefabInstance: {{fileID: 0}}\n  m_PrefabAsset: {{fileID: 0}}\n"
        f"  m_GameObject: {{fileID: {game_object}}}\n"
        f"  m_Enabled: 1\n  serializedVersion: 4\n  OutputAudioMixerGroup: {group}\n"
        f"  m_audioClip: {{fileID: 8300000, guid: {_hex(f'Assets/Audio/{clip}.wav')}, type: 3}}\n  m_PlayOnAwake: 1\n"
        f"  m_Volume: {volume:g}\n  m_Pitch: 1\n  Loop: 0\n  Mute: 0\n  Spatialize: 0\n  Priority: 128\n"
    )


def _game_object(id_: int, name: str, component: int) -> str:
    return (
        f"--- !u!1 &{id_}\nGameObject:\n  m_ObjectHideFlags: 0\n  serializedVersion: 6\n  m_Component:\n"
        f"  - component: {{fileID: {component}}}\n  m_Layer: 0\n  m_Name: {name}\n  m_TagString: Untagged\n"
        "  m_IsActive: 1\n"
    )


def _instance(id_: int, prefab: str, target: int, volume: float | None) -> str:
    changed = (
        f"    m_Modifications:\n    - target: {{fileID: {target}, guid: {_hex(prefab)}, type: 3}}\n"
        f"      propertyPath: m_Volume\n      value: {volume:.9g}\n      objectReference: {{fileID: 0}}\n"
        if volume is not None
        else "    m_Modifications: []\n"
    )
    return (
        f"--- !u!1001 &{id_}\nPrefabInstance:\n  m_ObjectHideFlags: 0\n  serializedVersion: 2\n  m_Modification:\n"
        f"    m_TransformParent: {{fileID: 0}}\n{changed}    m_RemovedComponents: []\n"
        f"  m_SourcePrefab: {{fileID: 100100000, guid: {_hex(prefab)}, type: 3}}\n"
    )


CLIPS = ("bell", "drum", "gong", "horn", "lute")


def write_unity(root: Path, gains: Gains) -> Path:
    """Write a Unity project."""
    put(root, "ProjectSettings/ProjectVersion.txt", "m_EditorVersion: 2021.3.37f1\n")
    factor = 10 ** (gains["manager"] / 20) if "manager" in gains else 1.0
    manager = f"--- !u!11 &1\nAudioManager:\n  m_ObjectHideFlags: 0\n  serializedVersion: 2\n  m_Volume: {factor:.9g}\n"
    put(root, "ProjectSettings/AudioManager.asset", YAML + manager)
    for clip in CLIPS:
        put(root, f"Assets/Audio/{clip}.wav", "RIFF")
        _meta(
            root,
            f"Assets/Audio/{clip}.wav",
            "AudioImporter:\n  serializedVersion: 6\n  normalize: 1\n  forceToMono: 0\n",
        )
    top = {"Master": "", "World": "Master", "Radio": "Master", "Music": "Master"}
    _mixer(root, gains, "Top", top, output="{fileID: 0}", exposed="Music", low="Radio")
    inner = {"Master": "", "Near": "Master", "Far": "Near"}
    _mixer(root, gains, "Inner", inner, output=_group_of("Top", 2), exposed="Nothing", low="Nothing")
    drum, source = "Assets/Drum.prefab", 8200000
    text = _game_object(1000, "Drum", source) + _source_of(
        source, "drum", _group_of("Inner", 3), _linear(gains, "drum"), 1000
    )
    put(root, drum, YAML + text)
    _meta(root, drum, "PrefabImporter:\n  externalObjects: {}\n")
    variant = "Assets/Loud Drum.prefab"
    louder = 10 ** (gains["variant"] / 20) if "variant" in gains else None
    stripped = (
        f"--- !u!82 &{source ^ 5000} stripped\nAudioSource:\n  m_CorrespondingSourceObject: {{fileID: {source}, "
        f"guid: {_hex(drum)}, type: 3}}\n  m_PrefabInstance: {{fileID: 5000}}\n  m_PrefabAsset: {{fileID: 0}}\n"
    )
    put(root, variant, YAML + _instance(5000, drum, source, louder) + stripped)
    _meta(root, variant, "PrefabImporter:\n  externalObjects: {}\n")
    again = "Assets/Loudest Drum.prefab"
    loudest = 10 ** (gains["variant of variant"] / 20) if "variant of variant" in gains else None
    put(root, again, YAML + _instance(6000, variant, source ^ 5000, loudest))
    _meta(root, again, "PrefabImporter:\n  externalObjects: {}\n")
    scene = YAML + _instance(7000, again, (source ^ 5000) ^ 6000, None)
    groups = {"bell": ("Inner", 2), "gong": ("Top", 3), "horn": ("Top", 4), "lute": None}
    for place, (clip, of_mixer) in enumerate(groups.items()):
        group = _group_of(*of_mixer) if of_mixer else "{fileID: 0}"
        scene += _game_object(100 + place, clip, 200 + place)
        scene += _source_of(200 + place, clip, group, _linear(gains, clip), 100 + place)
    put(root, "Assets/Main.unity", scene)
    _meta(root, "Assets/Main.unity")
    settings = (
        "--- !u!1045 &1\nEditorBuildSettings:\n  m_Scenes:\n  - enabled: 1\n    path: Assets/Main.unity\n"
        f"    guid: {_hex('Assets/Main.unity')}\n"
    )
    put(root, "ProjectSettings/EditorBuildSettings.asset", YAML + settings)
    return root


def _clips(*names: str) -> tuple[str, ...]:
    return tuple(f"Assets/Audio/{name}.wav" for name in names)


UNITY = Apart(
    write_unity,
    {
        "bell": _clips("bell"), "drum": _clips("drum"), "lute": _clips("lute"), "variant": _clips("drum"),
        "variant of variant": _clips("drum"), "Inner Far": _clips("drum"),
        "Inner Near": _clips("bell", "drum"),
        "Inner Master": _clips("bell", "drum"), "Top World": _clips("bell", "drum"), "Top Radio": _clips("gong"),
        "Top Music": _clips("horn"), "Top Master": _clips("bell", "drum", "gong", "horn"), "manager": _clips(*CLIPS),
    },
    {**dict.fromkeys(_clips("bell", "lute"), ("",)), **dict.fromkeys(_clips("gong", "horn"), ("state", "script"))},
    dict.fromkeys(("bell", "drum", "lute", "variant", "variant of variant"), AT_REST_DB),
)  # fmt: skip
