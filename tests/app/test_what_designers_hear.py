"""What one designer hears of another's: the pictures of what the project opens, by every route, and nothing else."""

import pytest

from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.projects.models import Project
from app.projects.rules import DesignersHear
from tests.house.objects import House
from tests.house.routes import Operation, ask, operations
from tests.house.test_policies import ONE_DESIGNERS
from tests.support.server import RunningServer

HEARD = ("get_preview", "get_peaks", "get_spectrum")


def of_another() -> list[Operation]:
    """Return what reads an object that one designer made."""
    return [
        operation
        for operation in operations()
        if set(operation.parameters) & ONE_DESIGNERS and operation.method == "GET"
    ]


@pytest.fixture(scope="module")
def house(server: RunningServer) -> House:
    return House(server)


def stand(house: House, choice: DesignersHear, state: TakeState) -> None:
    """Set what designers hear, and where the takes of the house stand."""

    def write(session) -> None:
        session.get_one(Project, house.project_id).designers_hear = choice
        session.get_one(Take, house.ids["take_id"]).state = state

    house.server.in_database(write)


@pytest.mark.slow
def test_the_routes_that_serve_sound_are_among_those_asked() -> None:
    asked = {one.name for one in of_another()}
    sound = {
        "get_render_file",
        "get_reel",
        "get_reel_file",
        "download_master",
        "download_dry_stem",
        "download_source_file",
        "get_master_export_file",
    }
    assert asked >= {*HEARD, *sound, "get_take_sounds", "see_take", "see_delivery"}


@pytest.mark.slow
@pytest.mark.both_databases
@pytest.mark.parametrize("choice", DesignersHear)
def test_a_route_shows_an_approved_sound_of_another_only_as_what_is_heard(house: House, choice: DesignersHear) -> None:
    stand(house, choice, TakeState.APPROVED)
    heard = HEARD if choice is not DesignersHear.OWN else ()
    outsiders = (house.other_designer, house.stranger)  # engaged on nothing here
    wrong = [
        operation.name
        for operation in of_another()
        if ask(house.rival, house, operation).status_code != (200 if operation.name in heard else 404)
        or {ask(client, house, operation).status_code for client in outsiders} != {404}
    ]
    assert wrong == []


@pytest.mark.both_databases
@pytest.mark.slow
@pytest.mark.parametrize("choice", DesignersHear)
@pytest.mark.parametrize("state", TakeState)
def test_which_states_are_heard(house: House, state: TakeState, choice: DesignersHear) -> None:
    stand(house, choice, state)
    opened = {
        DesignersHear.OWN: set(),
        DesignersHear.APPROVED: {TakeState.APPROVED},
        DesignersHear.WAITING: {TakeState.APPROVED, TakeState.CONFORMING},
    }[choice]
    status = 200 if state in opened else 404
    for name in HEARD:
        (operation,) = (one for one in operations() if one.name == name)
        assert ask(house.rival, house, operation).status_code == status
    listed = house.rival.get(f"/v1/projects/{house.project_id}/other-sounds").json()["items"]
    assert [one["id"] for one in listed] == ([str(house.ids["take_id"])] if state in opened else [])
