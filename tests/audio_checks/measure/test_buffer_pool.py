"""What one file leaves to the next is never in two hands."""

import numpy as np

from audio_checks.measure import buffer_pool


def test_what_is_given_back_is_taken_again_once():
    first = buffer_pool.acquire("test", 1_000)
    first[:] = 7
    buffer_pool.release("test", first)
    again, other = buffer_pool.acquire("test", 900), buffer_pool.acquire("test", 900)
    assert np.shares_memory(first, again)
    assert len(again) == 900
    assert not np.shares_memory(again, other)


def test_one_that_is_too_small_is_not_taken():
    buffer_pool.release("test", buffer_pool.acquire("test", 10))
    assert len(buffer_pool.acquire("test", 11)) == 11


def test_what_is_very_large_is_not_kept(monkeypatch):
    monkeypatch.setattr(buffer_pool, "LARGEST_BYTES", 99)
    large = buffer_pool.acquire("large", 100)
    buffer_pool.release("large", large)
    assert not np.shares_memory(large, buffer_pool.acquire("large", 100))
