"""Workers that die and renderers that fail: game files are made again, one by one, or named as our fault."""

from typing import Any, ClassVar
from uuid import UUID

import pytest
from sqlalchemy import select

import audio_checks
from app.conformance.models import CheckRun
from app.core import kill_points
from app.renders import children, drawing, making
from app.renders.models import Picture
from tests.app.renders.making import add_cue, deliver_sound
from tests.app.renders.test_renders import count, sounds
from tests.support.server import World
from tests.support.waiting import until
from tests.support.waves import sine


class Interrupted(Exception):
    """Simulates a worker that dies."""


@pytest.mark.slow
def test_a_job_that_dies_after_the_verdict_draws_when_it_comes_again(
    world: World, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its verdict is seen before anything is drawn; the next attempt makes the rest and checks nothing again."""
    add_cue(world, "beep")
    found: list[str] = []

    def interrupt(point: str) -> None:
        if point == "renders.before_render" and not found:
            of_it = select(CheckRun.verdict).where(CheckRun.studio_id == world.studio_id)
            verdict = world.server.in_database(lambda session: session.scalars(of_it).one())
            found.append(f"{verdict}, {count(world.server, Picture.studio_id == world.studio_id)} drawn")
            monkeypatch.setattr(audio_checks, "check_file", None)  # nobody may ask for it again
            raise Interrupted

    monkeypatch.setattr(kill_points, "point", interrupt)
    take_id = deliver_sound(world, "beep.wav", sine(hz=997, rate=96_000, seconds=0.2))
    until(lambda: sounds(world, take_id)["master"]["state"] == "drawn")
    assert found == ["conforming, 0 drawn"]
    assert [sound["state"] for sound in sounds(world, take_id)["renders"]] == ["made", "made"]
    assert count(world.server, CheckRun.take_id == UUID(take_id)) == 1


class FailingTogether(audio_checks.SandboxChild):
    """A child that fails as long as more than one thing is to be made."""

    asked: ClassVar[list[list[str]]] = []

    def call(self, function: Any, /, *given: Any, **more: Any) -> Any:
        if function is drawing.prepare:
            parts = [*given[2], *(["the master"] if more["draws_master"] else [])]
            self.asked.append(parts)
            if len(parts) > 1:
                raise audio_checks.SandboxCrashed("too much at once")
        return super().call(function, *given, **more)


def test_what_fails_together_is_made_one_by_one(world: World, monkeypatch: pytest.MonkeyPatch) -> None:
    sandbox = children.sandbox()
    monkeypatch.setattr(sandbox, "child", lambda **given: FailingTogether(sandbox, timeout_s=60.0, **given))
    FailingTogether.asked.clear()
    add_cue(world, "beep")
    heard = sounds(world, deliver_sound(world, "beep.wav", sine(hz=997, rate=96_000, seconds=0.2)))
    assert FailingTogether.asked == [["game", "handheld", "the master"], ["game"], ["handheld"], ["the master"]]
    assert heard["master"]["state"] == "drawn"
    assert [one["state"] for one in heard["renders"]] == ["made", "made"]
    assert all(one["preview_url"] for one in (heard["master"], *heard["renders"]))


@pytest.mark.slow
def test_a_renderer_that_fails_three_times_is_said_to_be_our_fault(
    world: World, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(making, "TIMEOUT_S", 0.001)
    add_cue(world, "beep")
    take_id = deliver_sound(world, "beep.wav", sine(hz=997, rate=96_000, seconds=0.2))
    heard = sounds(world, take_id)
    assert heard["master"]["state"] == "undrawable"
    assert {one["refusal"] for one in heard["renders"]} == {making.OUR_FAULT}
    queue = world.approver.get("/v1/review-queue", params={"project_id": str(world.project_id)}).json()
    assert [take["id"] for item in queue["items"] for take in item["takes"]] == [take_id]
