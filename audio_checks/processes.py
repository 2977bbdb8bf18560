"""Spreads work over processes, and survives those that die."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Future, ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from multiprocessing import get_all_start_methods, get_context
from typing import TypeVar

T = TypeVar("T")
R = TypeVar("R")

START_METHOD = "forkserver" if "forkserver" in get_all_start_methods() else "spawn"
MOST_AT_ONCE = 16  # tasks a process takes at a time


def in_processes(
    work: Callable[[list[T]], list[R]],
    tasks: Sequence[T],
    *,
    workers: int,
    size: Callable[[T], float],
    died: Callable[[T, BaseException], R],
    done: Callable[[R], None] | None = None,
) -> list[R]:
    """Return the result of every task, in order; the largest are done first, so that all processes end together.

    Parameters
    ----------
    work : callable
        A function of a module, called in another process with a few tasks.
    tasks : sequence
        What can be sent to another process.
    workers : int
        The number of processes.
    size : callable
        Tells how much work a task is, beside others.
    died : callable
        Makes the result of a task whose process died of it.
    done : callable, optional
        Hears of each result as it comes.
    """
    results: dict[int, R] = {}

    def keep(places: Iterable[int], finished: Iterable[R]) -> None:
        for place, result in zip(places, finished, strict=True):
            results[place] = result
            if done:
                done(result)

    running: dict[Future[list[R]], list[int]] = {}
    with _pool(work, workers) as pool:
        for places in _shares(sorted(range(len(tasks)), key=lambda place: -size(tasks[place])), workers):
            try:
                running[pool.submit(work, [tasks[place] for place in places])] = places
            except BrokenProcessPool:
                break
        for future in as_completed(running):
            if not isinstance(future.exception(), BrokenProcessPool):
                keep(running.pop(future), future.result())
    left = [place for place in range(len(tasks)) if place not in results]
    for place, result in zip(left, _one_by_one(work, [tasks[place] for place in left], died), strict=True):
        keep([place], [result])
    return [results[place] for place in range(len(tasks))]


def _shares(places: list[int], workers: int) -> Iterator[list[int]]:
    """Yield what processes take at a time: several tasks at first, and few at the end, which they reach together."""
    at = 0
    while at < len(places):
        count = max(1, min(MOST_AT_ONCE, (len(places) - at) // (workers * 4)))
        yield places[at : at + count]
        at += count


def _one_by_one(
    work: Callable[[list[T]], list[R]], tasks: Iterable[T], died: Callable[[T, BaseException], R]
) -> Iterator[R]:
    """Do what a dead process left over, so that only the task that kills its process goes without a result."""
    pool: ProcessPoolExecutor | None = None
    for task in tasks:
        pool = pool or _pool(work, 1)
        try:
            yield pool.submit(work, [task]).result()[0]
        except BrokenProcessPool as error:
            yield died(task, error)
            pool.shutdown()
            pool = None
    if pool is not None:
        pool.shutdown()


def _pool(work: Callable[..., object], workers: int) -> ProcessPoolExecutor:
    context = get_context(START_METHOD)
    if START_METHOD == "forkserver":
        context.set_forkserver_preload([work.__module__])
    return ProcessPoolExecutor(workers, mp_context=context)
