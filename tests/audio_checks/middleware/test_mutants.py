"""Damaged and hostile projects: each is read or refused in words, in bounded time and memory."""

import pytest

from audio_checks.middleware import reading
from audio_checks.middleware.project import read_project
from audio_checks.middleware.reading import ProjectRefused
from benchmarks.audits.projects import KINDS
from tests.audio_checks.project_fuzz import Projects


@pytest.mark.slow
def test_a_damaged_project_is_read_or_refused_in_words(tmp_path):
    projects = Projects(tmp_path)
    refused = sum(projects.survives(number) for number in range(600))
    assert 0 < refused < 600


LARGE = 400_000
HOSTILE = {
    "Assets/a.prefab": [
        "%YAML 1.1\n--- !u!114 &1\nMonoBehaviour:\n" + "{fileID: 8300000, guid: " * LARGE,
        "%YAML 1.1\n--- !u!82 &1\nAudioSource:\n" + "  panLevelCustomCurve:\n    x\n" * LARGE,
        "%YAML 1.1\n--- !u!1001 &1\nPrefabInstance:\n" + "    - target: {fileID: 1, guid: " * LARGE,
        "%YAML 1.1\n--- !u!82 &1\nAudioSource:\n" + " " * 20 * LARGE + "{fileID: 8300000",
    ],
    "main.tscn": [
        "[node" + ' a="' * LARGE,
        "[node]\na = " + "[" * 10 * LARGE,
        '[node]\na = "' + "\\" * 10 * LARGE,
        "[node]\n" + 'a = ExtResource("\n' * LARGE,
    ],
    "a.gd": ["res://" * LARGE, 'res://"' * LARGE],
}


@pytest.mark.slow
@pytest.mark.parametrize(("path", "place"), [(path, at) for path, texts in HOSTILE.items() for at in range(len(texts))])
def test_a_text_made_to_take_long_does_not(tmp_path, path, place):
    """A pattern that took the square of the time would run into the timeout of every test."""
    (tmp_path / "ProjectSettings").mkdir()
    (tmp_path / "Assets").mkdir()
    if not path.startswith("Assets"):
        (tmp_path / "project.godot").write_text("config_version=5\n")
    (tmp_path / path).write_text(HOSTILE[path][place])
    project = read_project(tmp_path if path.startswith("Assets") else tmp_path / "project.godot")
    assert project.played == ()


def test_more_tags_lines_or_bytes_than_may_be_are_refused(tmp_path, monkeypatch):
    path = KINDS["wwise"].write(tmp_path, 8, {})
    for name, word in (("MOST_TAGS", "tags"), ("MOST_LINES", "lines"), ("MOST_PROJECT_BYTES", "MiB together")):
        monkeypatch.setattr(reading, name, 20)
        project = read_project(path)
        assert any(word in one.message for one in project.unread)
        assert project.played == ()
        monkeypatch.undo()
    monkeypatch.setattr(reading, "MOST_SOUNDS", 5)
    project = read_project(path)
    assert len(project.played) == 5
    assert "more than 5 sounds" in project.unread[0].message


def test_a_folder_of_too_much_is_refused(tmp_path, monkeypatch):
    path = KINDS["godot"].write(tmp_path, 4, {})
    monkeypatch.setattr(reading, "MOST_ENTRIES", 3)
    with pytest.raises(ProjectRefused, match="more than 3 files and folders"):
        read_project(path)


def test_links_to_folders_are_not_followed(tmp_path):
    path = KINDS["godot"].write(tmp_path, 1, {})
    (tmp_path / "again").symlink_to(tmp_path)
    assert len(read_project(path).played) == 1


@pytest.mark.parametrize(
    ("made", "word"),
    [
        (None, "does not exist"),
        ("notes.txt", "not a project that is known"),
        ("empty.json", "is not JSON"),
        ("", "holds no project"),
    ],
)
def test_a_file_that_is_not_a_project_is_refused_with_what_is_wanted(tmp_path, made, word):
    place = tmp_path / "x" if made is None else tmp_path / made
    if made:
        place.write_text("")
    with pytest.raises(ProjectRefused, match=word) as refusal:
        read_project(place)
    assert "empty" in str(place) or ".wproj of Wwise" in str(refusal.value)


@pytest.mark.parametrize("text", ["[]", "{}", '{"format": 2}', "[" * 100_000])
def test_an_export_of_unreal_that_is_none_is_refused(tmp_path, text):
    (tmp_path / "sounds.json").write_text(text)
    with pytest.raises(ProjectRefused, match=r"wanted|JSON"):
        read_project(tmp_path / "sounds.json")
