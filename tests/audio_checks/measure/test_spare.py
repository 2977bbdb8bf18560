"""What one file leaves to the next is never in two hands."""

import numpy as np

from audio_checks.measure import spare


def test_what_is_given_back_is_taken_again_once():
    first = spare.taken("test", 1_000)
    first[:] = 7
    spare.give_back("test", first)
    again, other = spare.taken("test", 900), spare.taken("test", 900)
    assert np.shares_memory(first, again)
    assert len(again) == 900
    assert not np.shares_memory(again, other)


def test_one_that_is_too_small_is_not_taken():
    spare.give_back("test", spare.taken("test", 10))
    assert len(spare.taken("test", 11)) == 11


def test_what_is_very_large_is_not_kept(monkeypatch):
    monkeypatch.setattr(spare, "LARGEST_BYTES", 99)
    large = spare.taken("large", 100)
    spare.give_back("large", large)
    assert not np.shares_memory(large, spare.taken("large", 100))
