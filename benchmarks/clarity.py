"""What the clarity check costs: its lexicon once, then each cue. `python -m benchmarks.clarity`."""

import time
from collections.abc import Callable

from app.sound_lists.clarity.rules import lexicon, questions

CUES = 20_000


def seconds_of(work: Callable[[], object]) -> float:
    """Return how long work takes."""
    begun = time.perf_counter()
    work()
    return time.perf_counter() - begun


def ask_all() -> None:
    """Ask of as many cues as a large list has, each with words of its own."""
    for number in range(CUES):
        questions(f"impact_{number}", "", f"A wooden crate {number} falls", False, False)


def main() -> None:
    """Print both figures."""
    print(f"lexicon: {seconds_of(lexicon) * 1000:.0f} ms, once a process")
    print(f"a cue: {seconds_of(ask_all) / CUES * 1e6:.0f} µs")


if __name__ == "__main__":
    main()
