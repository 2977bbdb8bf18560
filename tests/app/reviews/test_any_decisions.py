"""Whatever an approver tries, in any order, at most one take of a variation is approved."""

from collections.abc import Sequence
from typing import Any
from uuid import UUID

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from sqlalchemy import select
from sqlalchemy.orm import Session

from app.accounts.queries import actor_for_person
from app.core.errors import Conflict
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.reviews.models import ChangeRequest
from app.reviews.rounds import change_requests as feedback
from app.reviews.rules import VerdictKind
from app.reviews.verdicts import service
from tests.app.reviews.making import Stage, add_cue, add_take
from tests.support.server import World

pytestmark = pytest.mark.slow


@pytest.fixture
def stage(world: World) -> Stage:
    return Stage(world)


ACTIONS = ("approve", "request_change", "set_aside", "undo", "send", "accept_set", "new_take")


@settings(max_examples=25, suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow])
@given(actions=st.lists(st.tuples(st.sampled_from(ACTIONS), st.integers(0, 7)), min_size=1, max_size=14))
def test_whatever_is_decided_at_most_one_take_is_approved(stage: Stage, actions: Sequence[tuple[str, int]]) -> None:
    with stage.world.server.runtime.database.writing() as session:
        Deciding(session, stage).run(actions)
        session.rollback()


class Deciding:
    """An approver who tries anything, valid or not, on a set of two with alternates."""

    def __init__(self, session: Session, stage: Stage) -> None:
        self.session = session
        self.stage = stage
        self.actor = actor_for_person(session, stage.world.approver_id)
        self.cue_id = add_cue(session, stage.world, "steps", variations=2)
        self.takes = [self.new_take(variation) for variation in (1, 1, 2, 2)]

    def new_take(self, variation: int) -> UUID:
        return add_take(self.session, self.stage.world, self.stage.delivery_id, self.cue_id, variation)

    def run(self, actions: Sequence[tuple[str, int]]) -> None:
        for action, number in actions:
            before = self.standing()
            try:
                with self.session.begin_nested():
                    self.do(action, number)
            except Conflict:
                self.session.expire_all()
                assert self.standing() == before, f"{action} was refused and changed something"
            self.ensure_valid()

    def do(self, action: str, number: int) -> None:
        take = self.session.get_one(Take, self.takes[number % len(self.takes)])
        if action == "new_take":
            self.takes.append(self.new_take(1 + number % 2))
        elif action == "undo":
            service.undo_verdict(self.session, self.actor, take.id)
        elif action == "send":
            feedback.send_changes(self.session, self.actor, self.stage.world.project_id)
        elif action == "accept_set":
            service.accept_set(self.session, self.actor, self.cue_id)
        else:
            kind = VerdictKind(action)
            service.give_verdict(self.session, self.actor, take.id, kind=kind, note="duller", seen_state=take.state)

    def standing(self) -> list[tuple[Any, ...]]:
        self.session.flush()
        rows = self.session.execute(
            select(Take.variation, Take.number, Take.state).where(Take.cue_id == self.cue_id).order_by(Take.id)
        )
        return [tuple(row) for row in rows]

    def ensure_valid(self) -> None:
        states = self.standing()
        for variation in (1, 2):
            assert sum(one[0] == variation and one[2] is TakeState.APPROVED for one in states) <= 1
        drafts = select(Take.state).join(ChangeRequest, ChangeRequest.take_id == Take.id)
        for state in self.session.scalars(
            drafts.where(Take.cue_id == self.cue_id, ChangeRequest.feedback_id.is_(None))
        ):
            assert state in (TakeState.CONFORMING, TakeState.APPROVED, TakeState.SET_ASIDE)
