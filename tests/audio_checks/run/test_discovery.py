"""Which files paths mean, links and folders that are not there included."""

import os

import pytest

from audio_checks.run.discovery import audio_files


@pytest.fixture
def tree(tmp_path):
    tree = tmp_path / "tree"
    for name in ("sfx/a.wav", "sfx/deep/b.wav"):
        path = tree / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.touch()
    return tree


def walked(*paths):
    unvisited = []
    return [found.relative for found in audio_files([os.fspath(path) for path in paths], unvisited)], unvisited


def test_a_link_to_a_folder_elsewhere_is_followed(tree, tmp_path):
    (tmp_path / "shared" / "more").mkdir(parents=True)
    for name in ("c.wav", "more/d.wav"):
        (tmp_path / "shared" / name).touch()
    (tree / "sfx" / "shared").symlink_to("../../shared")
    expected = ["sfx/a.wav", "sfx/deep/b.wav", "sfx/shared/c.wav", "sfx/shared/more/d.wav"]
    assert walked(tree) == (expected, [])


def test_a_folder_of_the_tree_is_judged_once_where_it_is(tree):
    (tree / "again").symlink_to("sfx")
    assert walked(tree) == (["sfx/a.wav", "sfx/deep/b.wav"], [])
    assert walked(tree / "again") == (["a.wav", "deep/b.wav"], [])


def test_links_in_circles_end(tree, tmp_path):
    for name in ("x", "y"):
        (tmp_path / name).mkdir()
        (tmp_path / name / f"{name}.wav").touch()
    (tmp_path / "x" / "to_y").symlink_to(tmp_path / "y")
    (tmp_path / "y" / "to_x").symlink_to(tmp_path / "x")
    (tree / "x").symlink_to(tmp_path / "x")
    (tree / "self").symlink_to(".")
    assert walked(tree) == (["sfx/a.wav", "sfx/deep/b.wav", "x/x.wav", "x/to_y/y.wav"], [])


def test_many_ways_to_one_folder_are_one(tree, tmp_path):
    for step in range(24):  # each folder links to the next twice: 2^24 ways to the last
        (tmp_path / f"step{step}").mkdir()
        for link in ("left", "right"):
            (tmp_path / f"step{step}" / link).symlink_to(f"../step{step + 1}")
    (tmp_path / "step24").mkdir()
    (tmp_path / "step24" / "z.wav").touch()
    (tree / "steps").symlink_to("../step0")
    names, unvisited = walked(tree)
    assert ([os.path.basename(name) for name in names], unvisited) == (["a.wav", "b.wav", "z.wav"], [])


def test_a_link_to_a_folder_above_is_named(tree, tmp_path):
    (tmp_path / "beside.wav").touch()
    (tree / "sfx" / "up").symlink_to(tmp_path)
    names, unvisited = walked(tree)
    assert names == ["sfx/a.wav", "sfx/deep/b.wav"]
    assert unvisited == [f"{tree}/sfx/up: not followed: it links to a folder above it"]


def test_a_link_that_leads_nowhere_is_named(tree):
    (tree / "shared").symlink_to("../not/there")
    assert walked(tree)[1] == [f"{tree}/shared: a link that leads nowhere"]


def test_a_submodule_that_is_not_checked_out_is_named(tree):
    (tree / ".gitmodules").write_text('[submodule "lib"]\n\tpath = assets/lib\n\turl = ../lib\n')
    (tree / "assets" / "lib").mkdir(parents=True)
    (tree / "empty").mkdir()
    names, unvisited = walked(tree)
    assert len(names) == 2
    assert unvisited == [f"{tree}/assets/lib: not checked out: git submodule update --init --recursive"]
