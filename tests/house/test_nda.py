"""A project that asks for an NDA later shows a designer who has not agreed to it nothing more: asked of every route."""

from datetime import datetime

import pytest
from sqlalchemy import select
from sqlalchemy.orm import Session

from app.accounts.rules import Audience
from app.core import clock
from app.projects.models import Engagement, Project
from tests.house.objects import House
from tests.house.routes import Operation, ask, operations
from tests.house.test_policies import CONTRACTS, ONE_DESIGNERS, names_in
from tests.support.server import RunningServer

pytestmark = pytest.mark.slow

# The project's head says that an NDA is asked for, the next step is to sign it, and the contracts are where it is read
# and accepted. What two parties agreed to and owe each other stays theirs; how far one's own upload came, one's own
# sign-ins, and that a sound library of one's own is forgotten, say nothing of the project.
BEFORE_NDA = {
    *("read_project", "read_next_steps", "list_contracts"),
    *(
        "see_upload",
        "cancel_upload",
        "end_my_sign_in",
        "revoke_my_desk_token",
        "remove_my_passkey",
        "remove_sound_library",
    ),
}
OF_THE_PROJECT = (ONE_DESIGNERS - CONTRACTS) | {
    *(
        "project_id",
        "cue_id",
        "question_id",
        "follow_up_id",
        "decision_id",
        "batch_id",
        "pack_id",
        "build_id",
        "engagement_id",
        "token_id",
        "reference_id",
        "reference_version_id",
    ),
}


@pytest.fixture(scope="module")
def house(server: RunningServer) -> House:
    """A project that asks for an NDA which nobody has accepted yet."""
    house = House(server)

    def request_nda(session: Session) -> None:
        session.get_one(Project, house.project_id).nda_needed = True

    server.in_database(request_nda)
    return house


def shows_the_project(operation: Operation) -> bool:
    names = names_in(operation)
    is_refused = operation.policy.audience is not Audience.ANYONE and operation.name not in BEFORE_NDA
    return is_refused and bool(names & OF_THE_PROJECT) and not names & CONTRACTS


def test_it_shows_nothing_of_the_project(house: House) -> None:
    asked = [operation for operation in operations() if shows_the_project(operation)]
    assert len(asked) > 100
    shown = []
    for operation in asked:
        house.server.forget_tries()
        answer = ask(house.designer, house, operation)
        if answer.status_code not in (403, 404) or b"the bytes of a sound" in answer.content:
            shown.append(f"{operation.name}: {answer.status_code} {answer.text[:200]}")
    assert shown == []


def test_the_same_requests_are_answered_once_it_is_accepted(house: House) -> None:
    for name in ("get_preview", "get_peaks", "get_spectrum", "get_render_file", "get_reel_file", "list_comments"):
        (operation,) = [one for one in operations() if one.name == name]
        house.server.in_database(lambda session: accept(session, house, clock.now()))
        assert ask(house.designer, house, operation).status_code == 200
        house.server.in_database(lambda session: accept(session, house, None))
        assert ask(house.designer, house, operation).status_code in (403, 404)


def accept(session: Session, house: House, at: datetime | None) -> None:
    engagement = session.scalars(select(Engagement).where(Engagement.designer_id == house.designer_id)).one()
    engagement.nda_accepted_at, engagement.nda_sha256 = at, "0" * 64 if at else None
