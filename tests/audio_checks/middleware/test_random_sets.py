"""Containers that play one of several sounds at random are known by where they are, in every engine."""

import pytest

from audio_checks.middleware.fmod import read_fmod
from audio_checks.middleware.godot import read_godot
from audio_checks.middleware.project import read_project, read_project_texts
from audio_checks.middleware.reading import ProjectRefused
from audio_checks.middleware.unreal import read_unreal
from audio_checks.middleware.wwise import read_wwise
from benchmarks.audits.fmod_project import _object, _objects
from benchmarks.audits.projects import KINDS


def sets(project):
    return {one.file.rpartition("/")[2]: one.random_set for one in project.played}


@pytest.mark.parametrize(
    ("mode", "found"), [("", "\\Containers\\Foley\\Grass"), ('<Property Name="RandomOrSequence" Value="0"/>', "")]
)
def test_a_random_container_of_wwise_and_a_sequence(put, mode, found):
    put("Game.wproj", '<WwiseDocument Type="Project"/>')
    sounds = "".join(
        f'<Sound Name="g{place}" ID="{{S{place}}}"><ChildrenList><AudioFileSource Name="g" ID="{{F{place}}}">'
        f"<Language>SFX</Language><AudioFile>g{place}.wav</AudioFile></AudioFileSource></ChildrenList></Sound>"
        for place in (1, 2)
    )
    root = put(
        "Containers/Foley.wwu",
        '<WwiseDocument Type="WorkUnit"><Containers><WorkUnit Name="Foley" ID="{U}" PersistMode="Standalone">'
        f'<ChildrenList><RandomSequenceContainer Name="Grass" ID="{{C}}"><PropertyList>{mode}</PropertyList>'
        f"<ChildrenList>{sounds}</ChildrenList></RandomSequenceContainer></ChildrenList></WorkUnit></Containers>"
        "</WwiseDocument>",
    )
    assert sets(read_wwise(root / "Game.wproj")) == {"g1.wav": found, "g2.wav": found}


@pytest.mark.parametrize(
    ("names", "found"),
    [(("",), {"event:/steps"}), (("", "Tail"), {"event:/steps/part 1", "event:/steps/Tail"})],
)
def test_a_multi_instrument_of_fmod_goes_by_its_event(put, names, found):
    root = put("Game.fspro", '<objects serializationModel="Studio.02.02.00"/>')
    objects = [
        _object("Event", "E", {"name": "steps"}, banks="B"),
        _object("EventMixerMaster", "MM", {}),
        _object("GroupTrack", "T", {}, modules=[f"M{place}" for place in range(len(names))], mixerGroup="G"),
        _object("EventMixerGroup", "G", {}, output="MM"),
    ]
    for place, name in enumerate(names):
        objects.append(_object("MultiSound", f"M{place}", {"name": name} if name else {}, sounds=f"S{place}"))
        objects.append(_object("SingleSound", f"S{place}", {}, audioFile=f"A{place}"))
        put(
            f"Metadata/AudioFile/{place}.xml",
            _objects(_object("AudioFile", f"A{place}", {"assetPath": f"{place}.wav"})),
        )
    put("Metadata/Event/e.xml", _objects(*objects))
    assert set(sets(read_fmod(root / "Game.fspro")).values()) == found


def test_a_randomizer_of_godot_goes_by_its_player(put):
    put("project.godot", "config_version=5\n")
    root = put(
        "main.tscn",
        '[gd_scene format=3]\n[ext_resource type="AudioStream" path="res://a.wav" id="1"]\n'
        '[ext_resource type="AudioStream" path="res://b.wav" id="2"]\n'
        '[sub_resource type="AudioStreamRandomizer" id="R"]\nstream_0/stream = ExtResource("1")\n'
        '[node name="Main" type="Node"]\n[node name="Steps" type="AudioStreamPlayer" parent="."]\n'
        'stream = SubResource("R")\n[node name="One" type="AudioStreamPlayer" parent="."]\nstream = ExtResource("2")\n',
    )
    assert sets(read_godot(root)) == {"a.wav": "main.tscn: Steps", "b.wav": ""}


def test_a_random_node_of_unreal_goes_by_its_cue(put):
    waves = '"waves": [{"path": "/Game/a", "file": "a.wav"}, {"path": "/Game/b", "file": "b.wav"}]'
    plays = '[{"wave": "/Game/a", "random": true, "nodes": []}, {"wave": "/Game/b", "nodes": []}]'
    root = put("game.json", f'{{"format": 1, {waves}, "cues": [{{"path": "/Game/Steps", "plays": {plays}}}]}}')
    assert sets(read_unreal(root / "game.json")) == {"a.wav": "/Game/Steps", "b.wav": ""}


def test_a_random_container_of_unity_goes_by_its_asset(put):
    guid = {name: f"{place:032x}" for place, name in enumerate(("clip", "steps", "scene"), start=1)}
    put("ProjectSettings/ProjectVersion.txt", "m_EditorVersion: 6000.0.1f1\n")
    put("Assets/a.wav.meta", f"guid: {guid['clip']}\nAudioImporter:\n")
    put("Assets/Steps.asset.meta", f"guid: {guid['steps']}\n")
    put(
        "Assets/Steps.asset",
        "%YAML 1.1\n--- !u!1 &1\nAudioRandomContainer:\n  m_Name: Steps\n  m_Volume: 0\n--- !u!2 &2\n"
        f"AudioContainerElement:\n  m_AudioClip: {{fileID: 8300000, guid: {guid['clip']}, type: 3}}\n  m_Volume: 0\n",
    )
    put("Assets/Main.unity.meta", f"guid: {guid['scene']}\n")
    root = put(
        "Assets/Main.unity",
        "%YAML 1.1\n--- !u!82 &5\nAudioSource:\n"
        f"  m_Resource: {{fileID: 1, guid: {guid['steps']}, type: 2}}\n  m_Volume: 1\n",
    )
    assert sets(read_project(root)) == {"a.wav": "Assets/Steps"}


@pytest.mark.parametrize("engine", KINDS)
def test_sent_texts_say_what_the_folder_says(tmp_path, engine):
    path = KINDS[engine].write(tmp_path, 4, {})
    texts = {one.relative_to(tmp_path).as_posix(): one.read_text() for one in tmp_path.rglob("*") if one.is_file()}
    main = "" if path.is_dir() and engine == "unity" else "project.godot" if engine == "godot" else path.name
    assert read_project_texts(main, texts).to_dict() == read_project(path).to_dict()


@pytest.mark.parametrize("path", ["Game.wproj", "readme.txt", ""])
def test_texts_without_a_project_are_refused(path):
    with pytest.raises(ProjectRefused, match=r"wanted a \.wproj"):
        read_project_texts(path, {"readme.txt": ""})
