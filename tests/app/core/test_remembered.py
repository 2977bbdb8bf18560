"""A process remembers so much and no more."""

from app.core.lru_cache import LRUCache


def test_what_was_not_asked_for_longest_is_forgotten():
    remembered: LRUCache[str, int] = LRUCache(2)
    remembered.keep("laser", 1)
    remembered.keep("door", 2)
    assert remembered.get("laser") == 1
    assert remembered.keep("water", 3) == 3
    assert remembered.get("door") is None
    assert (remembered.get("laser"), remembered.get("water")) == (1, 3)
