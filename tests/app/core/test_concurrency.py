"""People are served first; uploads behind them, and still within a time."""

import asyncio
from contextlib import AsyncExitStack

import pytest

from app.core.web import concurrency as rules
from app.core.web.concurrency import ConcurrencyLimiter, Overloaded

LONG_S = 60.0
SOON_S = 60.0


async def upload(limiter: ConcurrencyLimiter, came: list[str], name: str) -> None:
    async with limiter.for_upload():
        came.append(name)
        await asyncio.sleep(0)


async def enter(limiter: ConcurrencyLimiter, inside: AsyncExitStack, count: int) -> None:
    """Let people in who read, and stay."""
    for number in range(count):
        await inside.enter_async_context(limiter.for_person(f"person {number}", reads=True))


def test_an_upload_waits_while_a_person_is_served(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(rules, "YIELD_TO_PEOPLE_S", LONG_S)

    async def both() -> list[str]:
        limiter, came = ConcurrencyLimiter(), list[str]()
        async with AsyncExitStack() as inside:
            await enter(limiter, inside, 2)
            waits = [asyncio.create_task(upload(limiter, came, name)) for name in ("first", "second", "third")]
            await asyncio.sleep(0.05)
            assert came == []
        await asyncio.wait_for(asyncio.gather(*waits), SOON_S)
        return came

    assert asyncio.run(both()) == ["first", "second", "third"]


def test_a_line_of_uploads_moves_though_people_never_leave(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(rules, "YIELD_TO_PEOPLE_S", 0.02)

    async def crowd() -> float:
        limiter, came = ConcurrencyLimiter(), list[str]()
        async with AsyncExitStack() as inside:
            await enter(limiter, inside, rules.MAX_CONCURRENT)
            begun = asyncio.get_running_loop().time()
            waits = [upload(limiter, came, str(number)) for number in range(10)]
            await asyncio.wait_for(asyncio.gather(*waits), SOON_S)
            taken_s = asyncio.get_running_loop().time() - begun
        assert came == [str(number) for number in range(10)]
        return taken_s

    assert asyncio.run(crowd()) >= 10 * 0.019, "one at a time gave way for as long as it was to"


def test_people_do_not_wait_for_uploads():
    async def both() -> None:
        limiter = ConcurrencyLimiter()
        async with AsyncExitStack() as inside:
            for _ in range(rules.MAX_CONCURRENT_UPLOADS):
                await inside.enter_async_context(limiter.for_upload())
            waits = asyncio.create_task(upload(limiter, [], "one more"))
            for _ in range(rules.MAX_CONCURRENT_FINISHES):
                await inside.enter_async_context(limiter.for_upload_finish())
            await asyncio.wait_for(enter(limiter, inside, rules.MAX_CONCURRENT), SOON_S)
            assert not waits.done()
        await asyncio.wait_for(waits, SOON_S)

    asyncio.run(both())


def test_a_slot_given_up_goes_once_to_the_next_caller():
    async def line() -> int:
        limiter, came = ConcurrencyLimiter(), list[str]()
        async with AsyncExitStack() as inside:
            held = [await inside.enter_async_context(limiter.for_upload()) for _ in range(rules.MAX_CONCURRENT_UPLOADS)]
            held[0].release()
            held[0].release()
            third = await inside.enter_async_context(limiter.for_upload())
            waits = asyncio.create_task(upload(limiter, came, "fourth"))
            await asyncio.sleep(0.05)
            seated = len(came)
            third.release()
            await asyncio.wait_for(waits, SOON_S)
        return seated

    assert asyncio.run(line()) == 0


def test_a_request_that_waits_too_long_is_refused_unless_its_bytes_are_here(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(rules, "MAX_WAIT_S", 0.05)

    async def full() -> None:
        limiter = ConcurrencyLimiter()
        async with AsyncExitStack() as inside:
            for _ in range(rules.MAX_CONCURRENT_UPLOADS):
                await inside.enter_async_context(limiter.for_upload())
            for _ in range(rules.MAX_CONCURRENT_FINISHES):
                await inside.enter_async_context(limiter.for_upload_finish())
            with pytest.raises(Overloaded):
                await upload(limiter, [], "begins")

            async def end() -> None:
                async with limiter.for_upload_finish():
                    pass

            ends = asyncio.create_task(end())
            await asyncio.sleep(0.2)
            assert not ends.done()
        await asyncio.wait_for(ends, SOON_S)

    asyncio.run(full())


def test_a_caller_who_leaves_holds_nobody_up(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(rules, "YIELD_TO_PEOPLE_S", LONG_S)

    async def line() -> list[str]:
        limiter, came = ConcurrencyLimiter(), list[str]()
        async with AsyncExitStack() as inside:
            await enter(limiter, inside, 1)
            waits = [asyncio.create_task(upload(limiter, came, name)) for name in ("gone", "there")]
            await asyncio.sleep(0.02)
            waits[0].cancel()
            await asyncio.sleep(0.02)
        await asyncio.wait_for(waits[1], SOON_S)
        return came

    assert asyncio.run(line()) == ["there"]


async def read(limiter: ConcurrencyLimiter, came: list[str], caller: str) -> None:
    async with limiter.for_person(caller, reads=True):
        came.append(caller)
        await asyncio.sleep(0.01)


def test_callers_take_turns_however_many_requests_one_sends():
    async def crowd() -> list[str]:
        limiter, came = ConcurrencyLimiter(), list[str]()
        flood = [asyncio.create_task(read(limiter, came, "flood")) for _ in range(100)]
        await asyncio.sleep(0)
        others = [asyncio.create_task(read(limiter, came, name)) for name in ("one", "one", "two", "two")]
        await asyncio.wait_for(asyncio.gather(*flood, *others), SOON_S)
        return came

    came = asyncio.run(crowd())
    assert came.count("flood") == 100
    assert {*came[: rules.MAX_CONCURRENT]} == {"flood", "one"}  # a slot was left for others at once
    assert [came.count(name) for name in ("one", "two")] == [2, 2]
    assert max(place for place, name in enumerate(came) if name != "flood") < 16


def test_one_caller_has_never_all_slots():
    async def alone() -> None:
        limiter = ConcurrencyLimiter()
        async with AsyncExitStack() as inside:
            for _ in range(rules.MAX_CONCURRENT_OF_CALLER):
                await inside.enter_async_context(limiter.for_person("flood", reads=True))
            waits = asyncio.create_task(read(limiter, [], "flood"))
            await asyncio.sleep(0.02)
            assert not waits.done()
            await asyncio.wait_for(read(limiter, [], "other"), SOON_S)
            await asyncio.wait_for(enter(limiter, inside, 1), SOON_S)
        await asyncio.wait_for(waits, SOON_S)

    asyncio.run(alone())


def test_a_caller_who_gives_up_waiting_frees_the_slot(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(rules, "MAX_WAIT_S", 0.05)

    async def crowd() -> int:
        limiter, came = ConcurrencyLimiter(), list[str]()
        async with AsyncExitStack() as inside:
            await enter(limiter, inside, rules.MAX_CONCURRENT)
            cancelled = [asyncio.create_task(read(limiter, came, f"gone {number % 2}")) for number in range(6)]
            await asyncio.sleep(0)
            for task in cancelled[::2]:
                task.cancel()  # looked at only when the slots are left
            late = await asyncio.gather(*cancelled, return_exceptions=True)
            assert {type(error) for error in late} == {Overloaded, asyncio.CancelledError}
            waits = [asyncio.create_task(read(limiter, came, "person 0")) for _ in range(4)]
            await asyncio.sleep(0)
            waits[0].cancel()
        await asyncio.gather(*waits, return_exceptions=True)
        return len([await asyncio.wait_for(read(limiter, came, str(number)), SOON_S) for number in range(8)])

    assert asyncio.run(crowd()) == 8


def test_a_slot_granted_to_a_caller_who_left_goes_to_the_next():
    async def both() -> list[str]:
        limiter, came = ConcurrencyLimiter(), list[str]()
        inside = AsyncExitStack()
        await enter(limiter, inside, rules.MAX_CONCURRENT)
        gone, there = (asyncio.create_task(read(limiter, came, name)) for name in ("gone", "there"))
        await asyncio.sleep(0.01)
        await inside.aclose()  # gives both their turn, before either runs
        gone.cancel()
        await asyncio.gather(gone, there, return_exceptions=True)
        waits = [read(limiter, came, f"later {number}") for number in range(rules.MAX_CONCURRENT)]
        await asyncio.wait_for(asyncio.gather(*waits), SOON_S)
        return came

    assert asyncio.run(both())[:1] == ["there"]
