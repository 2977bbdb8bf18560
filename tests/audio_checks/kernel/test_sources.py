"""A kernel that was made from other sources is found out before it misbehaves."""

import importlib

import pytest

from audio_checks import kernel
from audio_checks.kernel import sources


def test_the_kernel_at_hand_was_made_from_the_sources_beside_it():
    assert kernel._kernel.made_from() == sources.digest_of(sources.Path(kernel.__file__).parent)


def test_every_change_shows(tmp_path):
    assert sources.digest_of(tmp_path) is None
    found = set()
    for name, text in (("a.c", "1"), ("a.c", "2"), ("b.h", "2"), ("b.h", ""), ("c.c", "2")):
        (tmp_path / name).write_text(text)
        found.add(sources.digest_of(tmp_path))
    assert len(found) == 5
    (tmp_path / "notes.txt").write_text("no source")
    assert sources.digest_of(tmp_path) in found


def test_an_older_kernel_says_how_to_fix_it(monkeypatch):
    monkeypatch.setattr(sources, "digest_of", lambda _: "of newer sources")
    with pytest.raises(ImportError, match="rebuild it: make setup"):
        importlib.reload(kernel)


def test_an_installed_kernel_has_no_sources_beside_it(monkeypatch):
    monkeypatch.setattr(sources, "digest_of", lambda _: None)
    importlib.reload(kernel)
