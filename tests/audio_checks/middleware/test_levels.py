"""A gain at every level of the tree of every engine reaches the sounds below it, and no other."""

import pytest

from audio_checks.middleware.project import read_project
from benchmarks.audits.projects import KINDS

SOUNDS = 40
EVERYWHERE = [(engine, level) for engine, kind in KINDS.items() for level in kind.levels]


@pytest.mark.parametrize(("engine", "level"), EVERYWHERE)
@pytest.mark.parametrize("gain_db", [6.0, -3.5])
def test_a_gain_reaches_what_it_is_set_for(tmp_path, engine, level, gain_db):
    kind = KINDS[engine]
    place = (level, kind.places(level, SOUNDS)[-1])
    project = read_project(kind.write(tmp_path, SOUNDS, {place: gain_db}))
    moved = {one.file for one in project.played if one.gain_db == pytest.approx(gain_db, abs=0.01)}
    assert moved == {kind.file.format(sound) for sound in kind.reached(place, SOUNDS)}
    assert all(one.gain_db == pytest.approx(0.0, abs=0.01) for one in project.played if one.file not in moved)
    (name,) = {(part.object_path, part.property) for one in project.played for part in one.parts}
    assert all(name)


@pytest.mark.parametrize("engine", KINDS)
def test_all_levels_add_up_and_each_is_named(tmp_path, engine):
    kind = KINDS[engine]
    gains = {(level, 0): float(-1 - place) for place, level in enumerate(kind.levels)}
    if engine in ("unity", "godot"):  # an instance replaces what its source says
        replaced = {"unity": "source", "godot": "player"}[engine]
        del gains[replaced, 0]
    project = read_project(kind.write(tmp_path, SOUNDS, gains))
    first = [one for one in project.played if one.file == kind.file.format(0)][-1]
    found = max((one for one in project.played if one.file == first.file), key=lambda one: len(one.parts))
    assert found.gain_db == pytest.approx(sum(gains.values()), abs=0.01)
    assert sorted(round(part.gain_db, 2) for part in found.parts) == sorted(gains.values())
    assert len({(part.object_path, part.property) for part in found.parts}) == len(gains)


@pytest.mark.parametrize("engine", KINDS)
def test_every_sound_is_used_and_nothing_is_unread(tmp_path, engine):
    kind = KINDS[engine]
    project = read_project(kind.write(tmp_path, SOUNDS, {}))
    assert project.engine == engine
    assert project.version
    assert project.unread == ()
    assert [one.file for one in project.played] == [kind.file.format(sound) for sound in range(SOUNDS)]
    assert all(one.is_used and one.gain_db == 0.0 and not one.depends for one in project.played)
