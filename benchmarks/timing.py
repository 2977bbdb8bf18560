"""CPU and wall time of work in this process and of commands: medians, taken in turns so that noise meets all alike."""

import resource
import statistics
import subprocess
import time
from collections.abc import Callable, Mapping, Sequence

Work = Callable[[], float]


def own_cpu(work: Callable[[], object]) -> Work:
    """Return something that runs the work here and returns its CPU seconds."""

    def timed() -> float:
        begun = time.process_time()
        work()
        return time.process_time() - begun

    return timed


def command_cpu(command: Sequence[str]) -> Work:
    """Return something that runs a command and returns its CPU seconds, those of the system included."""

    def timed() -> float:
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime

    return timed


def wall(work: Callable[[], object]) -> Work:
    """Return something that runs the work here and returns its wall seconds."""

    def timed() -> float:
        begun = time.perf_counter()
        work()
        return time.perf_counter() - begun

    return timed


def in_turns(works: Mapping[str, Work], runs: int) -> dict[str, float]:
    """Return the median of each, after one run of each that does not count."""
    for work in works.values():
        work()
    taken: dict[str, list[float]] = {name: [] for name in works}
    for _ in range(runs):
        for name, work in works.items():
            taken[name].append(work())
    return {name: statistics.median(times) for name, times in taken.items()}
