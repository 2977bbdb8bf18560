"""Spreads work over isolated helper processes, and survives those that die."""

import os
import pickle
import queue
import signal
import subprocess
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from contextlib import suppress
from typing import Any, TypeVar

from audio_checks.system.isolation import isolated_python

T = TypeVar("T")
R = TypeVar("R")

MOST_AT_ONCE = 16  # tasks a process takes at a time


class HelperDied(Exception):
    """A helper process ended before it answered."""


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
        Returns how much work a task is, relative to others.
    died : callable
        Makes the result of a task whose process died.
    done : callable, optional
        Called with each result as it arrives.
    """
    results: dict[int, R] = {}

    def keep(places: Iterable[int], finished: Iterable[R]) -> None:
        for index, result in zip(places, finished, strict=True):
            results[index] = result
            if done:
                done(result)

    largest_first = sorted(range(len(tasks)), key=lambda index: -size(tasks[index]))
    with _Helpers(work) as helpers, ThreadPoolExecutor(workers) as threads:
        running = {
            threads.submit(helpers.call, [tasks[index] for index in places]): places
            for places in _shares(largest_first, workers)
        }
        try:
            for future in as_completed(running):
                places = running.pop(future)
                with suppress(HelperDied):
                    keep(places, future.result())
        except BaseException:
            threads.shutdown(wait=False, cancel_futures=True)
            helpers.close()
            raise
        for task_index in range(len(tasks)):
            if task_index not in results:  # so that only the task that kills its process has no result
                try:
                    keep([task_index], helpers.call([tasks[task_index]]))
                except HelperDied as error:
                    keep([task_index], [died(tasks[task_index], error)])
    return [results[index] for index in range(len(tasks))]


def _shares(places: list[int], workers: int) -> Iterator[list[int]]:
    """Yield processes' shares at a time: several tasks at first, and few at the end, which they reach together."""
    at = 0
    while at < len(places):
        count = max(1, min(MOST_AT_ONCE, (len(places) - at) // (workers * 4)))
        yield places[at : at + count]
        at += count


class _Helpers:
    """Helper processes for one kind of work, started when they are needed; threads may share them."""

    def __init__(self, work: Callable[[list[Any]], list[Any]]) -> None:
        self._work = work
        self._started: list[subprocess.Popen[bytes]] = []
        self._idle: queue.SimpleQueue[subprocess.Popen[bytes]] = queue.SimpleQueue()

    def __enter__(self) -> "_Helpers":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def call(self, tasks: list[Any]) -> list[Any]:
        """Return the results of some tasks; raise what the work raised, or HelperDied."""
        try:
            helper = self._idle.get_nowait()
        except queue.Empty:
            helper = self._start()
        assert helper.stdin is not None and helper.stdout is not None  # noqa: S101, PT018 - pipes were asked for
        try:
            pickle.dump((self._work, tasks), helper.stdin)
            helper.stdin.flush()
            is_done, answer = pickle.load(helper.stdout)  # noqa: S301 - it comes from our own code
        except (EOFError, OSError, pickle.UnpicklingError):
            helper.kill()
            raise HelperDied(f"its process ended with code {helper.wait()}") from None
        self._idle.put(helper)
        if not is_done:
            raise answer
        return list(answer)

    def close(self) -> None:
        """End all of them."""
        for helper in self._started:
            helper.kill()
        for helper in self._started:
            helper.wait()
            for pipe in (helper.stdin, helper.stdout):
                with suppress(OSError):
                    if pipe is not None:
                        pipe.close()

    def _start(self) -> "subprocess.Popen[bytes]":
        code = "from audio_checks.run.processes import serve; serve()"
        helper = subprocess.Popen(
            isolated_python(code, self._work.__module__), stdin=subprocess.PIPE, stdout=subprocess.PIPE
        )
        self._started.append(helper)
        return helper


def serve() -> None:
    """Do the work that comes on standard input until it closes. Runs in a helper process."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the process that started this one
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # whatever prints must not stand between answers
    while True:
        try:
            work, tasks = pickle.load(sys.stdin.buffer)  # noqa: S301 - it comes from our own code
        except EOFError:
            return
        try:
            answer = True, work(tasks)
        except Exception as error:
            answer = False, error.with_traceback(None)
        pickle.dump(answer, answers)
        answers.flush()
