"""What strangers send is parsed in a child: whatever it does there, the caller is refused in words."""

import contextlib
import os
import threading
import time
from collections.abc import Iterator

import anyio
import pytest
from fastapi import Request

from app import registry
from app.core.access_scope import AccessScope
from app.core.db import new_id
from app.core.errors import Invalid
from app.core.parsing import Parsers
from app.core.parsing_queue import MAX_CONCURRENT, MAX_PER_CALLER, MAX_WAITING, ParsingBusy, parse_request
from app.core.runtime import Runtime
from app.sound_lists.errors import SheetUnreadable
from app.sound_lists.sheets.rules import parse_text
from audio_checks import SpecError, new_spec, parse_spec


class Unreadable(Invalid):
    """Of these tests."""


@pytest.fixture(scope="module")
def parsers() -> Iterator[Parsers]:
    made = Parsers()
    made.connect(registry.PARSERS)
    made.start()
    yield made
    made.close()


@pytest.mark.slow
def test_it_answers_as_the_function_does(parsers: Parsers):
    read = parsers.call(parse_text, "Name\nDoor\n", False, refusal=Unreadable)
    assert read == parse_text("Name\nDoor\n", False)
    assert read[:3] == (1, ("Name",), [(2, ["Door"])])
    assert parsers.call(parse_spec, new_spec(), refusal=Unreadable).sha256 == parse_spec(new_spec()).sha256
    with pytest.raises(Unreadable, match="the sheet is empty"):
        parsers.call(parse_text, "", False, refusal=Unreadable)
    with pytest.raises(SpecError, match="more than 16 parts"):
        parsers.call(parse_spec, "a" + ".a" * 30_000 + "=1", refusal=Unreadable)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("function", "arguments", "words"),
    [
        (time.sleep, (60,), "longer than 5 s"),
        (bytearray, (1 << 40,), "512 MiB"),
        (os.abort, (), "damaged"),
        (int, ("x",), "damaged"),
    ],
)
def test_input_that_ends_a_child_is_refused_with_a_reason(parsers: Parsers, function, arguments, words: str):
    with pytest.raises(Unreadable, match=words) as refused:
        parsers.call(function, *arguments, refusal=Unreadable)
    assert refused.value.status == 422
    assert refused.value.fix
    assert parsers.call(parse_text, "Name\nDoor\n", False, refusal=Unreadable)[0] == 1


class _Slow:
    """Replaces the parsers of a process, to see how many are asked at once."""

    def __init__(self) -> None:
        self.now = self.most = 0
        self.lock, self.go = threading.Lock(), threading.Event()

    def call(self, *_arguments: object, **_named: object) -> str:
        with self.lock:
            self.now += 1
            self.most = max(self.most, self.now)
        self.go.wait(20)
        with self.lock:
            self.now -= 1
        return "parsed"


class _Database:
    @contextlib.contextmanager
    def reading(self, _reach: AccessScope) -> Iterator[None]:
        yield None


def _request_of(person: int, slow: _Slow) -> Request:
    scope = {"type": "http", "app": type("App", (), {"state": type("State", (), {})()})(), "headers": []}
    request = Request(scope)
    request.app.state.runtime = type("Runtime", (), {"parsers": slow, "database": _Database()})()
    request.state.actor = None
    request.state.reach = AccessScope(person_id=person)  # type: ignore[arg-type]
    return request


@pytest.mark.parametrize(("persons", "served"), [(1, MAX_PER_CALLER), (40, MAX_CONCURRENT + MAX_WAITING)])
def test_a_flood_is_refused_and_the_rest_are_served_in_turn(persons: int, served: int):
    slow = _Slow()
    answers: list[str] = []

    async def ask(person: int) -> None:
        try:
            request = _request_of(person, slow)
            parsed = await parse_request(
                request, parse_text, refusal=SheetUnreadable, permit=lambda *_: None, whose=new_id()
            )
            answers.append(parsed)
        except ParsingBusy:
            answers.append("busy")
            if answers.count("busy") == 40 - served:
                while slow.now < MAX_CONCURRENT:
                    await anyio.sleep(0.01)
                slow.go.set()

    async def flood() -> None:
        async with anyio.create_task_group() as group:
            for place in range(40):
                group.start_soon(ask, place % persons)

    anyio.run(flood)
    assert (answers.count("parsed"), slow.most) == (served, MAX_CONCURRENT)


@pytest.mark.slow
def test_a_runtime_ends_its_parsers(tmp_path):
    from app.settings import Settings

    runtime = Runtime.of(Settings(data_dir=tmp_path, secret_key="only for tests"))
    runtime.parsers.start()
    server = runtime.parsers._sandbox._server
    assert server is not None
    runtime.close()
    assert server._process.poll() is not None
