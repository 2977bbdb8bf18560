"""The last day of silence stands: no re-check moves it, and what does move it is an entry that names who did it."""

import json
from datetime import UTC, datetime, timedelta
from typing import Any
from uuid import UUID

import pytest
from sqlalchemy import select
from sqlalchemy.orm import Session

from app.agreements.models import Contract, ContractEvent
from app.deliveries.models import Take
from app.deliveries.rules import ReviewClock, TakeState
from tests.app.money.agreed import Agreed, milestone
from tests.support.deliver import add_cues, deliver
from tests.support.server import World
from tests.support.waves import sine, wav_bytes

FRIDAY = datetime(2026, 11, 20, 14, tzinfo=UTC)
CLAUSE = {"silence_days": 10, "silence_reminder_days": 3}
S = TakeState


def days(count: int) -> timedelta:
    return timedelta(days=count)


@pytest.mark.parametrize(
    ("story", "since"),
    [
        ([(S.CONFORMING, 0)], 0),
        ([(S.CONFORMING, 0), (S.RECEIVED, 4), (S.CONFORMING, 5)], 0),  # checked again
        ([(S.CONFORMING, 0), (S.RECEIVED, 4), (S.RETURNED, 5), (S.RECEIVED, 7), (S.CONFORMING, 8)], 3),  # a new spec
        ([(S.CONFORMING, 0), (S.RETURNED, 5), (S.RECEIVED, 6), (S.RETURNED, 7), (S.CONFORMING, 9)], 4),
        ([(S.RETURNED, 1), (S.CONFORMING, 3)], 3),  # let through by a waiver
        ([(S.CONFORMING, 0), (S.UNJUDGED, 2), (S.RECEIVED, 3), (S.CONFORMING, 3)], 1),
    ],
)
def test_the_clock_starts_once_and_stands_while_a_take_is_returned(
    story: list[tuple[TakeState, int]], since: int
) -> None:
    clock = ReviewClock(None, None)
    for state, day in story:
        clock = clock.at(state, FRIDAY + days(day))
    assert clock == ReviewClock(FRIDAY + days(since), None)


class Waiting:
    """A real sound that conforms and waits under a clause on silence."""

    def __init__(self, world: World) -> None:
        self.world, self.agreed = world, Agreed(world, terms=CLAUSE)
        self.cue_id, self.other_cue_id = self.agreed.cue(), self.agreed.cue("radar_ping")
        sound = wav_bytes(sine(hz=997, dbfs=-3.0, seconds=0.5))
        self.take_id = UUID(deliver(world, "shield_hit.wav", sound, cue_id=str(self.cue_id))["id"])
        world.server.wait_for_jobs()
        assert self.agreed.states(self.take_id) == ["conforming"]
        self.agreed.agree(milestone("Alpha", self.cue_id, self.other_cue_id, amount_minor=18_000))
        world.server.in_database(self._put_back)

    def _put_back(self, session: Session) -> None:
        session.get_one(Contract, self.agreed.contract_id).agreed_at = FRIDAY
        take = session.get_one(Take, self.take_id)
        take.state_since = FRIDAY
        if hasattr(Take, "conforming_since"):
            take.conforming_since = FRIDAY

    def last_day(self, cue_id: UUID | None = None) -> str | None:
        day: str | None = self.agreed.review(cue_id or self.cue_id)["accepted_after"]
        return day

    def entries(self, *kinds: str) -> list[dict[str, Any]]:
        def read(session: Session) -> list[dict[str, Any]]:
            of_it = select(ContractEvent).where(ContractEvent.contract_id == self.agreed.contract_id)
            found = session.scalars(of_it.order_by(ContractEvent.seq))
            return [json.loads(one.payload) | {"kind": one.kind} for one in found if one.kind in kinds]

        entries: list[dict[str, Any]] = self.world.server.in_database(read)
        return entries

    def save_spec(self, change: tuple[str, str]) -> None:
        url = f"/v1/projects/{self.world.project_id}/spec"
        now = self.world.producer.get(url).json()
        saved = self.world.producer.put(
            url, json={"toml": now["toml"].replace(*change), "based_on_version": now["version"]}
        )
        assert saved.is_success, saved.text
        self.world.server.wait_for_jobs()


@pytest.fixture
def waiting(world: World) -> Waiting:
    return Waiting(world)


@pytest.mark.slow
def test_a_recheck_by_a_reviewer_moves_nothing(waiting: Waiting) -> None:
    assert waiting.last_day() == "2026-12-04"
    for person in (waiting.world.reviewer, waiting.world.designer, waiting.world.producer):
        assert person.post(f"/v1/takes/{waiting.take_id}/recheck").status_code == 202
        waiting.world.server.wait_for_jobs()
        assert waiting.agreed.states(waiting.take_id) == ["conforming"]
        assert waiting.last_day() == "2026-12-04"


@pytest.mark.slow
def test_a_spec_that_returns_it_stops_the_clock_and_the_record_says_who_saved_it(waiting: Waiting) -> None:
    waiting.save_spec(("sample_rates_hz = [44100, 48000, 96000]", "sample_rates_hz = [96000]"))
    assert waiting.agreed.states(waiting.take_id) == ["returned"]
    assert waiting.last_day() is None
    waiting.save_spec(("sample_rates_hz = [96000]", "sample_rates_hz = [44100, 48000, 96000]"))
    assert waiting.agreed.states(waiting.take_id) == ["conforming"]
    assert waiting.last_day() == "2026-12-04", "it stood still for seconds"
    reported = [
        (entry["kind"], entry["by"], entry["role"], entry["spec_version"])
        for entry in waiting.entries("returned", "conforms_again")
    ]
    assert reported == [("returned", "Producer", "producer", 2), ("conforms_again", "Producer", "producer", 3)]


@pytest.mark.slow
def test_who_moves_a_file_to_another_cue_and_back_is_named(waiting: Waiting) -> None:
    for cue_id in (waiting.other_cue_id, waiting.cue_id):
        url = f"/v1/takes/{waiting.take_id}/match"
        assert waiting.world.reviewer.put(url, json={"cue_id": str(cue_id)}).status_code == 200
        waiting.world.server.wait_for_jobs()
    assert waiting.last_day() != "2026-12-04"
    moves = waiting.entries("moved_away", "delivered")
    assert [move["kind"] for move in moves] == ["moved_away", "delivered", "moved_away", "delivered"]
    assert {(move["by"], move["role"], move["on_behalf_of"]) for move in moves} == {
        ("Composer", "reviewer", "Sound designer")
    }


@pytest.mark.slow
def test_the_same_bytes_again_do_not_restart_it(waiting: Waiting) -> None:
    sound = wav_bytes(sine(hz=997, dbfs=-3.0, seconds=0.5))
    [elsewhere] = add_cues(waiting.world, {"name": "Something else"})
    again = deliver(waiting.world, "something_else.wav", sound, cue_id=elsewhere["id"])
    waiting.world.server.wait_for_jobs()
    matched = waiting.world.reviewer.put(f"/v1/takes/{again['id']}/match", json={"cue_id": str(waiting.cue_id)})
    assert matched.status_code == 200, matched.text
    waiting.world.server.wait_for_jobs()
    assert waiting.last_day() == "2026-12-04"
