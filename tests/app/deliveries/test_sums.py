"""What is kept of the takes of cues says what looking at every take says, whatever happened to them."""

import random
from collections.abc import Collection
from uuid import UUID

import pytest
from httpx2 import Client
from sqlalchemy import select
from sqlalchemy.orm import Session

from app.deliveries.cue_counts.rules import STATE_CODES, Sums, TakeForSums, VariationFact
from app.deliveries.cue_counts.service import views_of
from app.deliveries.models import Take, TakeCounts
from app.deliveries.rules import CHECKABLE, TakeState
from app.sound_lists.models import Cue
from tests.support.deliver import add_cues, deliver
from tests.support.server import World
from tests.support.waves import noise, sine, wav_bytes

pytestmark = pytest.mark.both_databases

GOOD = [wav_bytes(noise(dbfs=level_dbfs, seconds=0.2)) for level_dbfs in range(-29, -19)]
LOUD = [wav_bytes(sine(hz=hz, dbfs=0.0, seconds=0.2)) for hz in range(991, 1001)]
NAMES = ("door_01.wav", "door_02.wav", "door_03.wav", "laser.wav", "hatch.wav", "who knows.wav")


@pytest.mark.parametrize("newest", [None, *STATE_CODES])
def test_the_whole_number_of_a_fact_is_read_back(newest: TakeState | None) -> None:
    for number in range(4):
        fact = VariationFact(number >= 2, number % 2 == 1, newest)
        assert fact.packed == 8 * number + (STATE_CODES[newest] if newest else 0)  # as stored
        assert VariationFact.unpacked(fact.packed) == fact


def kept(session: Session, project_id: UUID) -> dict[tuple[UUID, UUID], tuple[Sums, object]]:
    """Return what is kept, by cue and whose view it is."""
    return {
        (row.cue_id, row.viewer_id): (
            Sums(row.facts, row.newest_id, row.newest_back_since, row.back_since),
            (row.studio_id, row.project_id, row.state, row.variations, row.placeholder),
        )
        for row in session.scalars(select(TakeCounts).where(TakeCounts.project_id == project_id))
    }


def looked_up(session: Session, project_id: UUID) -> dict[tuple[UUID, UUID], tuple[Sums, object]]:
    """Return the same from the takes and cues that are there."""
    found = {}
    for cue in session.scalars(select(Cue).where(Cue.project_id == project_id)):
        takes = [
            TakeForSums._make(getattr(take, name) for name in TakeForSums._fields)
            for take in session.scalars(select(Take).where(Take.cue_id == cue.id))
        ]
        for viewer_id, sums in views_of(cue.studio_id, takes) if takes else ():
            facts = (cue.studio_id, cue.project_id, cue.state, cue.variations, cue.placeholder)
            found[cue.id, viewer_id] = sums, facts
    return found


class Course:
    """What a project goes through, as dice throw."""

    def __init__(self, world: World, seed: int) -> None:
        self.world, self.dice, self.done = world, random.Random(seed), set[str]()
        self.judged: UUID | None = None
        self.cues = add_cues(world, {"name": "door", "variations": 3}, {"name": "laser"}, {"name": "hatch"})

    def go_on(self) -> None:
        """Do one thing that may or may not be possible."""
        kind = self.dice.choice(
            ("deliver", "deliver", "deliver", "judge", "judge", "judge", "match", "match", "undo", "edit", "cut")
        )
        if (getattr(self, kind))():
            self.done.add(kind)

    def deliver(self) -> bool:
        deliver(self.world, self.dice.choice(NAMES), self.dice.choice(self.dice.choice((GOOD, LOUD))))
        self.world.server.wait_for_jobs()
        return True

    def judge(self) -> bool:
        take = self._any_take()
        verdict = self.dice.choice(
            ({"kind": "approve"}, {"kind": "request_change", "text": "later"}, {"kind": "set_aside"})
        )
        if not _done(self.world.approver, f"/v1/takes/{take}/verdict", verdict):
            return False
        self.judged = take
        if self.dice.random() < 0.3:
            _done(self.world.approver, f"/v1/projects/{self.world.project_id}/feedback", {"note": ""})
        return True

    def undo(self) -> bool:
        return self.world.approver.delete(f"/v1/takes/{self.judged}/verdict").status_code == 200

    def match(self) -> bool:
        take, cue = self._any_take(CHECKABLE), self.dice.choice(self.cues)["id"]
        answer = self.world.designer.put(f"/v1/takes/{take}/match", json={"cue_id": cue})
        self.world.server.wait_for_jobs()
        return answer.status_code == 200

    def edit(self) -> bool:
        cue = self.world.producer.get(f"/v1/cues/{self.dice.choice(self.cues)['id']}").json()
        change = self.dice.choice(({"placeholder": True}, {"variations": self.dice.choice((1, 2, 3))}))
        body = {"edition": cue["edition"], **change}
        return self.world.producer.patch(f"/v1/cues/{cue['id']}", json=body).status_code == 200

    def cut(self) -> bool:
        return self.dice.random() < 0.2 and _done(
            self.world.approver, f"/v1/cues/{self.dice.choice(self.cues)['id']}/cut", {"reason": "not needed"}
        )

    def _any_take(self, states: Collection[TakeState] = (*TakeState,)) -> UUID | None:
        def ids(session: Session) -> list[UUID]:
            return [take.id for take in takes_of(session, self.world) if take.state in states]

        takes = self.world.server.in_database(ids)
        return self.dice.choice(takes) if takes else None


def _done(by: Client, path: str, body: dict) -> bool:
    return by.post(path, json=body).status_code < 300


def is_kept(world: World) -> bool:
    def compare(session: Session) -> bool:
        return kept(session, world.project_id) == looked_up(session, world.project_id)

    return bool(world.server.in_database(compare))


def takes_of(session: Session, world: World) -> list[Take]:
    return list(session.scalars(select(Take).where(Take.project_id == world.project_id).order_by(Take.id)))


@pytest.mark.slow
@pytest.mark.parametrize("seed", [1, 2])
def test_what_is_kept_is_what_there_is(world: World, seed: int):
    course = Course(world, seed)
    for _ in range(30):
        course.go_on()
        assert is_kept(world)
    assert course.done >= {"deliver", "judge", "match", "edit"}


@pytest.mark.slow
def test_a_take_that_changes_otherwise_would_be_noticed(world: World):
    add_cues(world, {"name": "laser"})
    deliver(world, "laser.wav", GOOD[0])
    world.server.wait_for_jobs()

    def forget(session: Session) -> None:
        takes_of(session, world)[0].state = TakeState.APPROVED

    assert is_kept(world)
    world.server.in_database(forget)
    assert not is_kept(world)
