"""A child of the sandbox serves takes of one delivery, one after the other, and of no one else."""

import os
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from uuid import UUID, uuid4

import pytest

from app.conformance import workspaces
from app.conformance.workspaces import SandboxPool, TakeWorkspace
from app.core.storage import open_store
from app.settings import Settings
from audio_checks import Sandbox, SandboxCrashed
from tests.support.waves import sine, wav_bytes

Serve = Callable[[UUID], int]
ENDS_WITHIN_S = 240.0


@pytest.fixture(scope="module")
def sandbox() -> Iterator[Sandbox]:
    sandbox = Sandbox()
    yield sandbox
    sandbox.close()


@pytest.fixture
def children(sandbox: Sandbox) -> SandboxPool:
    return SandboxPool(sandbox)


@pytest.fixture
def workspace(tmp_path: Path, children: SandboxPool) -> Callable[[], TakeWorkspace]:
    store = open_store(Settings(data_dir=tmp_path))
    return lambda: TakeWorkspace(store, children)


@pytest.fixture
def serve(workspace: Callable[[], TakeWorkspace]) -> Serve:
    def served(delivery_id: UUID) -> int:
        with workspace() as one:
            pid = one.child(delivery_id).call(os.getpid)
            assert one.child(delivery_id).call(os.getpid) == pid
        return pid

    return served


def is_there(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    return True


def ends(pid: int) -> bool:
    deadline = time.monotonic() + ENDS_WITHIN_S
    while is_there(pid) and time.monotonic() < deadline:
        time.sleep(0.02)
    return not is_there(pid)


def test_takes_of_one_delivery_share_a_child_and_no_others(serve: Serve) -> None:
    first, second = uuid4(), uuid4()
    pid = serve(first)
    other = serve(second)
    assert other != pid
    assert [serve(first), serve(second), serve(first)] == [pid, other, pid]


def test_takes_that_are_worked_on_at_once_have_a_child_each(workspace: Callable[[], TakeWorkspace]) -> None:
    delivery_id = uuid4()
    with workspace() as one, workspace() as other:
        pids = [each.child(delivery_id).call(os.getpid) for each in (one, other)]
    assert pids[0] != pids[1]


def test_a_child_for_which_no_take_comes_ends(serve: Serve, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(workspaces, "IDLE_S", 0.05)
    delivery_id = uuid4()
    pid = serve(delivery_id)
    assert ends(pid)
    assert serve(delivery_id) != pid


@pytest.mark.slow
def test_a_child_is_replaced_after_a_number_of_takes(serve: Serve, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(workspaces, "MAX_TAKES", 2)
    delivery_id = uuid4()
    pid = serve(delivery_id)
    assert serve(delivery_id) == pid
    assert ends(pid)
    assert serve(delivery_id) != pid


def test_only_so_many_children_wait(serve: Serve, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(workspaces, "MAX_IDLE", 2)
    oldest, *others = [serve(uuid4()) for _ in range(3)]
    assert ends(oldest)
    assert all(is_there(pid) for pid in others)


def test_a_child_does_not_wait_where_the_work_on_a_take_broke_off(workspace: Callable[[], TakeWorkspace]) -> None:
    with pytest.raises(KeyError) as raised, workspace() as one:
        raise KeyError(one.child(uuid4()).call(os.getpid))
    assert ends(raised.value.args[0])


def test_a_child_that_crashed_is_followed_by_a_new_one(workspace: Callable[[], TakeWorkspace], serve: Serve) -> None:
    delivery_id = uuid4()
    pid = serve(delivery_id)
    with workspace() as one, pytest.raises(SandboxCrashed):
        one.child(delivery_id).call(os.abort)
    assert serve(delivery_id) != pid


@pytest.mark.slow
def test_a_child_does_not_wait_behind_a_large_master(
    tmp_path: Path, children: SandboxPool, serve: Serve, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(workspaces, "LARGE_BYTES", 1000)
    store = open_store(Settings(data_dir=tmp_path))
    studio_id, delivery_id = uuid4(), uuid4()
    stored = store.put(studio_id, [wav_bytes(sine(hz=440, seconds=0.1), rate=48_000, bits=24)])
    pid = serve(delivery_id)
    with TakeWorkspace(store, children) as one:
        assert one.child(delivery_id).call(os.getpid) == pid
        one.master(studio_id, stored.sha256)
    assert ends(pid)
