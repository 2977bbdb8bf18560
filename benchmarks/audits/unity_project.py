"""A small project of Unity with a gain at each place of its tree."""

from __future__ import annotations

from pathlib import Path

from benchmarks.audits.places import IN_BUS, IN_CONTAINER, Gains, factor, guid, put_file

YAML = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n"


def _hex(*names: object) -> str:
    return guid(*names).replace("-", "").lower()


def write_unity(root: Path, sounds: int, gains: Gains) -> Path:
    """Write a Unity project: a prefab for each sound, instances that change it, and groups of a mixer."""

    def of(*place):
        return gains.get(place)

    put_file(root, "ProjectSettings/ProjectVersion.txt", "m_EditorVersion: 2022.3.10f1\n")
    manager = f"{YAML}--- !u!11 &1\nAudioManager:\n  m_ObjectHideFlags: 0\n  m_Volume: {factor(of('manager', 0))}\n"
    put_file(root, "ProjectSettings/AudioManager.asset", manager)
    mixer = _hex("mixer")
    buses = range(-(-sounds // IN_BUS))
    groups = range(-(-sounds // IN_CONTAINER))
    holds = {100 + bus: [1_000 + group for group in groups if group * IN_CONTAINER // IN_BUS == bus] for bus in buses}
    text = (
        f"{YAML}--- !u!241 &1\nAudioMixerController:\n  m_Name: main\n  m_OutputGroup: {{fileID: 0}}\n"
        "  m_MasterGroup: {fileID: 50}\n  m_StartSnapshot: {fileID: 60}\n  m_ExposedParameters: []\n"
        + _group(50, "Master", list(holds))
        + "".join(_group(id_, f"bus_{id_ - 100}", children) for id_, children in holds.items())
        + "".join(_group(1_000 + group, f"group_{group}", []) for group in groups)
        + "--- !u!245 &60\nAudioMixerSnapshotController:\n  m_Name: Snapshot\n  m_FloatValues:\n"
    )
    for level, base, count in (("master", 50, 1), ("bus", 100, len(buses)), ("group", 1_000, len(groups))):
        for one in range(count):
            if of(level, one) is not None:
                text += f"    {_hex('volume', base + one)}: {of(level, one):g}\n"
    put_file(root, "Assets/Audio/main.mixer", text + "  m_TransitionOverrides: {}\n")
    put_file(root, "Assets/Audio/main.mixer.meta", f"fileFormatVersion: 2\nguid: {mixer}\nNativeFormatImporter:\n")
    scene = YAML
    for sound in range(sounds):
        clip, prefab, id_ = _hex("clip", sound), _hex("prefab", sound), 7_000_000 + sound
        put_file(
            root,
            f"Assets/Audio/steps/snd_{sound:04}.wav.meta",
            f"fileFormatVersion: 2\nguid: {clip}\nAudioImporter:\n  "
            "serializedVersion: 6\n  defaultSettings:\n    loadType: 0\n"
            "    sampleRateSetting: 0\n    compressionFormat: 1\n  forceToMono: 0\n  normalize: 1\n",
        )
        put_file(
            root,
            f"Assets/Prefabs/snd_{sound:04}.prefab",
            f"{YAML}--- !u!1 &5\nGameObject:\n  m_Name: snd_{sound:04}\n--- "
            f"!u!82 &{id_}\nAudioSource:\n  m_GameObject: {{fileID: 5}}\n"
            f"  OutputAudioMixerGroup: {{fileID: {1_000 + sound // IN_CONTAINER}, guid: {mixer},\n    type: 2}}\n"
            f"  m_audioClip: {{fileID: 8300000, guid: {clip}, type: 3}}\n  m_Volume: {factor(of('source', sound))}\n"
            "  Loop: 0\n  Mute: 0\n",
        )
        put_file(
            root,
            f"Assets/Prefabs/snd_{sound:04}.prefab.meta",
            f"fileFormatVersion: 2\nguid: {prefab}\nPrefabImporter:\n",
        )
        if of("instance", sound) is not None:
            scene += (
                f"--- !u!1001 &{9_000_000 + sound}\nPrefabInstance:\n  m_Modification:\n    m_Modifications:\n"
                f"    - target: {{fileID: {id_}, guid: {prefab}, type: 3}}\n      propertyPath: m_Volume\n"
                f"      value: {factor(of('instance', sound))}\n      objectReference: {{fileID: 0}}\n"
                f"  m_SourcePrefab: {{fileID: 100100000, guid: {prefab}, type: 3}}\n"
            )
    put_file(root, "Assets/Scenes/Main.unity", scene)
    return root


def _group(id_: int, name: str, children: list[int]) -> str:
    listed = "".join(f"  - {{fileID: {child}}}\n" for child in children)
    return (
        f"--- !u!243 &{id_}\nAudioMixerGroupController:\n  m_Name: {name}\n"
        f"  m_Children:{' []' if not children else ''}\n{listed}  m_Volume: {_hex('volume', id_)}\n"
        "  m_Effects: []\n  m_Mute: 0\n"
    )
