"""Who may do what, asked of every endpoint there is: the table of routes writes this test."""

from collections import Counter
from collections.abc import Callable

import pytest
from fastapi.testclient import TestClient
from httpx import Response

from app import rooms
from app.accounts.rules import Audience, Scope
from app.kit.fastapi_internals import Router
from app.kit.http import SAFE_METHODS
from app.kit.single_thread_route import SingleThreadRoute
from tests.house.objects import House
from tests.house.routes import Operation, api_routes, ask, document, operations, policy_of
from tests.support.server import RunningServer

# Between two parties: who only reviews does not see them, nor does another designer.
CONTRACTS = {"contract_id", "milestone_id", "extra_round_id", "invoice_id", "payment_id", "worked_day_id"}
# Objects that one designer made: another designer of the same project does not see them.
ONE_DESIGNERS = {
    *("delivery_id", "take_id", "upload_id", "picture_id", "render_id", "comment_id", "change_request_id", "reel_id"),
    "note_id",
    "playlist_id",  # one that holds sounds of theirs alone
    "master_export_id",
    "tray_action_id",
    "library_id",
    *("game_task_id", "listening_note_id"),
    *("sign_in_id", "saved_view_id", "desk_token_id"),
    *CONTRACTS,
}
TEAMS = {Audience.PRODUCER, Audience.TEAM, Audience.APPROVER}
WEBHOOKS = frozenset({"webhook_id", "webhook_call_id"})
# Things of the studio, which a designer does not see at all.
STUDIOS = {
    "studio_id",
    "studio_invitation_id",
    "mail_id",
    "template_id",
    "roster_entry_id",
    "reel_sound_id",
    "credit_line_id",
    "guest_link_id",
    *WEBHOOKS,
}
IN_BODY = {"create_project": {"studio_id"}}
IN_QUERY = {
    "put_upload": {"delivery_id"},
    "begin_upload": {"delivery_id"},
    "get_review_queue": {"project_id"},
    "count_review_queue": {"project_id"},
}


def names_in(operation: Operation) -> set[str]:
    """Return the names of the objects that a request is about."""
    of_request = IN_BODY.get(operation.name, set()) | IN_QUERY.get(operation.name, set())
    return set(operation.parameters) | of_request


def is_about_something(operation: Operation) -> bool:
    """Whether a request names an object that some callers may not see."""
    if operation.policy.audience is Audience.OPERATOR:
        return False  # an operator sees every studio's; anyone else is refused, whatever the address names
    return any(name.endswith("_id") for name in names_in(operation))


Wanted = Callable[[Operation], object]


def each(wanted: Wanted) -> pytest.MarkDecorator:
    """Run a test once for every operation of that sort; for all but those that ask for no credential."""
    chosen = [one for one in operations() if one.policy.audience is not Audience.ANYONE and wanted(one)]
    return pytest.mark.parametrize("operation", [pytest.param(one, id=one.name) for one in chosen])


@pytest.fixture(scope="module")
def house(server: RunningServer) -> House:
    """What callers are refused; so nothing in it ever changes."""
    return House(server)


@pytest.fixture(autouse=True)
def _no_tries_yet(server: RunningServer) -> None:
    server.forget_tries()


def test_every_endpoint_declares_its_policy() -> None:
    routes = [route for router in rooms.ROUTERS for route in api_routes(router.routes)]
    assert len(routes) > 80
    assert [route.name for route in routes if policy_of(route) is None] == []


def test_every_route_authenticates_before_it_answers() -> None:
    routes = [route for router in rooms.ROUTERS for route in api_routes(router.routes)]
    assert [route.name for route in routes if not isinstance(route, SingleThreadRoute)] == []


def test_an_endpoint_without_policy_would_be_named() -> None:
    router = Router(route_class=SingleThreadRoute)

    @router.get("/forgetful")
    def forgetful() -> None:
        """Declare nothing."""

    (route,) = api_routes(router.routes)
    assert policy_of(route) is None


def test_every_endpoint_is_in_the_document_under_a_name_of_its_own() -> None:
    named = Counter(route.name for router in rooms.ROUTERS for route in api_routes(router.routes))
    documented = Counter(said["operationId"] for path in document()["paths"].values() for said in path.values())
    assert named == documented
    assert [name for name, times in named.items() if times > 1] == []


def test_every_path_names_things_that_this_test_has(house: House) -> None:
    known = house.ids.keys() | {"secret"}
    assert {name for operation in operations() for name in operation.parameters} - known == set()


def refusal(client: TestClient, house: House, operation: Operation) -> tuple[int, str]:
    """Return status and code of an answer; a HEAD has no body to say the code in."""
    answer = ask(client, house, operation)
    is_problem = answer.headers.get("content-type") == "application/problem+json" and answer.content
    return answer.status_code, answer.json()["code"] if is_problem else ""


def refused(operation: Operation, status: int, code: str) -> tuple[int, str]:
    return status, "" if operation.method == "HEAD" else code


@each(lambda _: True)
def test_callers_without_credentials_are_asked_to_sign_in(house: House, operation: Operation) -> None:
    for client in (house.nobody, house.guest):
        assert refusal(client, house, operation) == refused(operation, 401, "not-signed-in")


@each(is_about_something)
def test_for_strangers_it_does_not_exist(house: House, operation: Operation) -> None:
    for client in (house.stranger, house.other_designer):
        assert ask(client, house, operation).status_code == 404


@each(lambda operation: operation.policy.build is None)
def test_a_build_does_not_do_what_people_do(house: House, operation: Operation) -> None:
    answer = refusal(house.build(house.own_secret), house, operation)
    assert answer == refused(operation, 403, "person-needed")


@each(lambda operation: operation.policy.build is not None)
def test_a_build_keeps_to_its_project_and_scopes(house: House, operation: Operation) -> None:
    wanted = operation.policy.build
    assert wanted is not None
    assert ask(house.build(house.foreign_secret), house, operation).status_code == 404
    for scope in set(Scope) - {wanted}:
        client = house.build(house.secret_with[scope])
        assert refusal(client, house, operation) == refused(operation, 403, "scope-missing")
    if wanted is not Scope.DELIVERIES_WRITE:  # which needs a designer of the studio's own besides
        assert is_let_in(ask(house.build(house.secret_with[wanted]), house, operation))


@each(lambda _: True)
def test_a_desk_token_reads_the_desk_and_nothing_else(house: House, operation: Operation) -> None:
    client = house.build(house.desk_secret)
    if operation.policy.desk_token:
        assert is_let_in(ask(client, house, operation))
    else:
        assert refusal(client, house, operation) == refused(operation, 401, "not-signed-in")


@each(lambda operation: names_in(operation) & STUDIOS)
def test_a_designer_does_not_see_the_studio(house: House, operation: Operation) -> None:
    assert ask(house.designer, house, operation).status_code == 404


@each(lambda operation: operation.policy.audience in TEAMS and not names_in(operation) & STUDIOS)
def test_a_designer_does_nothing_of_the_teams(house: House, operation: Operation) -> None:
    is_unseen = "change_request_id" in names_in(operation)  # a draft, which was not sent yet
    assert ask(house.designer, house, operation).status_code == (404 if is_unseen else 403)


@each(lambda operation: names_in(operation) & ONE_DESIGNERS)
def test_a_designer_does_not_see_another_designers_work(house: House, operation: Operation) -> None:
    assert ask(house.rival, house, operation).status_code == 404


@each(lambda operation: operation.policy.audience in (Audience.PRODUCER, Audience.APPROVER, Audience.DESIGNER))
def test_a_reviewer_neither_runs_nor_decides_nor_delivers(house: House, operation: Operation) -> None:
    is_unseen = names_in(operation) & {"mail_id", *WEBHOOKS, *CONTRACTS}  # mails and webhooks may hold secret addresses
    assert ask(house.reviewer, house, operation).status_code == (404 if is_unseen else 403)


@each(lambda operation: operation.policy.audience is Audience.OPERATOR)
def test_only_who_runs_the_server_sees_the_whole_of_it(house: House, operation: Operation) -> None:
    for client in (house.producer, house.approver, house.reviewer, house.designer, house.stranger):
        assert refusal(client, house, operation) == refused(operation, 403, "operator-needed")


@each(lambda operation: operation.policy.audience in (Audience.APPROVER, Audience.DESIGNER))
def test_a_producer_neither_decides_nor_delivers(house: House, operation: Operation) -> None:
    assert ask(house.producer, house, operation).status_code == 403


ADMITTED = {
    Audience.ANYONE: ("nobody",),
    Audience.PERSON: ("designer",),
    Audience.STUDIO: ("reviewer",),
    Audience.PRODUCER: ("producer",),
    Audience.PROJECT: ("reviewer", "designer"),
    Audience.TEAM: ("producer",),
    Audience.APPROVER: ("approver",),
    Audience.DESIGNER: ("designer",),
    Audience.OPERATOR: ("operator",),
}
ONLY_IN_DEMO = {"play_demo_part"}  # tests/app/accounts/test_demo_door.py


def is_let_in(answer: Response) -> bool:
    """Whether no policy stood in the way; that the request fits the moment is not asked here."""
    if answer.status_code == 401:
        return bool(answer.json()["code"] == "wrong-sign-in")  # what sign-in itself says of a stranger's address
    return answer.status_code not in (403, 404, 405) and answer.status_code < 500


@pytest.mark.parametrize(
    "operation", [pytest.param(one, id=one.name) for one in operations() if one.name not in ONLY_IN_DEMO]
)
def test_whom_it_is_for_is_let_in(server: RunningServer, house: House, operation: Operation) -> None:
    """Without this, an endpoint that refuses everyone would pass all of the above."""
    own_house = house if operation.method in SAFE_METHODS else House(server)
    answers = [ask(getattr(own_house, who), own_house, operation) for who in ADMITTED[operation.policy.audience]]
    assert any(is_let_in(answer) for answer in answers), [answer.text for answer in answers]
