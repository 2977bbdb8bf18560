"""Work that is spread over processes: every task once, its result in its place, the largest first."""

import pytest

from audio_checks.run.processes import MOST_AT_ONCE, _shares, in_processes


def squares(tasks: list[int]) -> list[int]:
    return [task * task for task in tasks]


def died(task: int, error: BaseException) -> int:
    raise AssertionError(f"nothing dies of {task}") from error


@pytest.mark.parametrize("count", [1, 7, 100, 1_000])
def test_shares_hold_every_task_once_and_are_single_ones_at_the_end(count: int):
    shares = list(_shares(list(range(count)), workers=2))
    assert [place for share in shares for place in share] == list(range(count))
    lengths = [len(share) for share in shares]
    assert lengths == sorted(lengths, reverse=True)
    assert lengths[-1] == 1
    assert lengths[0] == min(MOST_AT_ONCE, max(1, count // 8))


@pytest.mark.slow
def test_the_largest_are_done_first_and_results_come_in_the_order_of_tasks():
    heard: list[int] = []
    tasks = [3, 1, 2, 9, 5]
    found = in_processes(squares, tasks, workers=1, size=float, died=died, done=heard.append)
    assert found == [9, 1, 4, 81, 25]
    assert heard == [81, 25, 9, 4, 1]
