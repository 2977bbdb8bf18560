"""Who may do what, asked of every endpoint there is: the table of routes writes this test."""

import json
import sqlite3
from collections import Counter
from collections.abc import Callable, Collection, Iterable
from contextlib import closing
from dataclasses import dataclass
from datetime import timedelta
from functools import cached_property
from http.client import TOO_MANY_REQUESTS
from pathlib import Path
from typing import Any, cast
from uuid import UUID, uuid4

import pytest
from fastapi import APIRouter
from httpx import Response
from httpx2 import Client
from sqlalchemy import delete, update
from sqlalchemy.orm import Session

from app.accounts.models import Membership, SignIn, Studio
from app.accounts.rules import Audience, MembersSee, Scope
from app.core import clock
from app.core.web.http import SAFE_METHODS
from app.projects.models import Engagement, ProjectMember
from app.routers import ROUTERS
from tests.house.objects import House
from tests.house.routes import Operation, api_routes, ask, document, operations, policy_of
from tests.support.server import RunningServer

pytestmark = pytest.mark.timeout(1800)  # hundreds of requests each
# Between two parties: who only reviews does not see them, nor does another designer.
CONTRACTS = {"contract_id", "milestone_id", "extra_round_id", "invoice_id", "payment_id", "worked_day_id"}
# Objects that one designer made: another designer of the same project does not see them.
ONE_DESIGNERS = {
    *("delivery_id", "take_id", "upload_id", "picture_id", "render_id", "comment_id", "change_request_id", "reel_id"),
    "note_id",
    *("source_file_id", "handoff_id", "own_time_id"),
    "playlist_id",  # one that holds sounds of theirs alone
    "master_export_id",
    "comparison_id",
    "tray_action_id",
    "library_id",
    *("game_task_id", "listening_note_id"),
    *("sign_in_id", "saved_view_id", "desk_token_id", "passkey_id"),
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


IsRight = Callable[[Operation, Response], bool]


def those(wanted: Callable[[Operation], object]) -> list[Operation]:
    """Return the operations of that sort, of all but those that ask for no credential."""
    return [
        operation
        for operation in operations()
        if operation.policy.audience is not Audience.ANYONE and wanted(operation)
    ]


class SharedHouse(House):
    """One house for every question: what an answer has changed is put back before the next is asked."""

    def __init__(self, server: RunningServer) -> None:
        super().__init__(server)
        for who in ("nobody", "guest", "stranger", "rival", "producer", "approver", "reviewer", "designer",
                    "other_designer", "operator"):  # fmt: skip
            getattr(self, who)  # signed in before the copy is made
        with server.runtime.database.writing() as session:  # recent, however long these questions take
            session.execute(update(SignIn).values(created_at=clock.now() + timedelta(days=1)))
        self._folder = server.runtime.settings.data_dir
        self._files = {path: path.read_bytes() for path in self._files_now()}
        self._database = str(server.runtime.database.engine.url.database)
        self.saved = self.copy_of_database()

    def copy_of_database(self) -> sqlite3.Connection:
        """Return a copy of the database as it is now."""
        copy = sqlite3.connect(":memory:")
        with closing(sqlite3.connect(self._database)) as database:
            database.backup(copy)
        return copy

    def _files_now(self) -> list[Path]:
        """Return the files of sounds and uploads."""
        return [path for path in self._folder.rglob("*") if path.is_file() and ".db" not in path.name]

    def put_back(self) -> None:
        """Put the database and the files back as they were when the house was new."""
        with closing(sqlite3.connect(self._database)) as database:
            self.saved.backup(database)
        for path in set(self._files_now()) - self._files.keys():
            path.unlink()
        for path, content in self._files.items():
            if not path.exists() or path.read_bytes() != content:
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(content)

    def answer(self, client: Client, operation: Operation) -> Response:
        """Ask, and put back what the answer changed."""
        answer = ask(client, self, operation)
        if answer.status_code == TOO_MANY_REQUESTS:
            self.server.forget_tries()
            answer = ask(client, self, operation)
        if operation.method not in SAFE_METHODS and answer.status_code < 400:
            self.put_back()
        return answer

    def wrong(self, asked: Iterable[Operation], clients: Iterable[Client], is_right: IsRight) -> list[str]:
        """Return every answer that is not right, with the place of the client that was given it."""
        return [
            f"{operation.name} for caller {place}: {answer.status_code} {answer.text[:200]}"
            for operation in asked
            for place, client in enumerate(clients)
            if not is_right(operation, answer := self.answer(client, operation))
        ]


@pytest.fixture(scope="module")
def house(server: RunningServer) -> SharedHouse:
    return SharedHouse(server)


def test_every_endpoint_declares_its_policy() -> None:
    routes = [route for router in ROUTERS for route in api_routes(router.routes)]
    assert len(routes) > 80
    assert [route.name for route in routes if policy_of(route) is None] == []


def test_an_endpoint_without_policy_would_be_named() -> None:
    router = APIRouter()

    @router.get("/forgetful")
    def forgetful() -> None:
        """Declare nothing."""

    (route,) = api_routes(router.routes)
    assert policy_of(route) is None


def test_every_endpoint_is_in_the_document_under_a_name_of_its_own() -> None:
    named = Counter(route.name for router in ROUTERS for route in api_routes(router.routes))
    documented = Counter(said["operationId"] for path in document()["paths"].values() for said in path.values())
    assert named == documented
    assert [name for name, times in named.items() if times > 1] == []


def test_every_path_names_things_that_this_test_has(house: SharedHouse) -> None:
    known = house.ids.keys() | {"secret"}
    assert {name for operation in operations() for name in operation.parameters} - known == set()


def is_refused(status: int, code: str = "") -> IsRight:
    """Return whether an answer refuses with that status and code; a HEAD has no body to say the code in."""

    def is_right(operation: Operation, answer: Response) -> bool:
        if answer.status_code != status or not code or operation.method == "HEAD":
            return answer.status_code == status
        return answer.headers["content-type"] == "application/problem+json" and bool(answer.json()["code"] == code)

    return is_right


def is_let_in(_operation: Operation, answer: Response) -> bool:
    """Whether no policy stood in the way; that the request fits the moment is not asked here."""
    if answer.status_code == 401:
        return bool(answer.json()["code"] == "wrong-sign-in")  # what sign-in itself says of a stranger's address
    return answer.status_code not in (403, 404, 405) and answer.status_code < 500


def test_callers_without_credentials_are_asked_to_sign_in(house: SharedHouse) -> None:
    callers = (house.nobody, house.guest)
    assert house.wrong(those(lambda _: True), callers, is_refused(401, "not-signed-in")) == []


def test_for_designers_of_other_studios_it_does_not_exist(house: SharedHouse) -> None:
    assert house.wrong(those(is_about_something), [house.other_designer], is_refused(404)) == []


@dataclass(frozen=True)
class EmptyHouse:
    """The house, where some ids lead to nothing."""

    house: House
    hidden: Collection[str] | None = None  # None: all of them

    @cached_property
    def ids(self) -> dict[str, Any]:
        return {
            name: uuid4() if isinstance(id_, UUID) and (self.hidden is None or name in self.hidden) else id_
            for name, id_ in self.house.ids.items()
        }

    def __getattr__(self, name: str) -> Any:
        return getattr(self.house, name)


def words_of(answer: Response, house: House | EmptyHouse) -> tuple[int, Any]:
    """Return what an answer says, with names in place of the ids that were sent."""
    text = answer.text
    for name, id_ in house.ids.items():
        text = text.replace(str(id_), name) if isinstance(id_, UUID) else text
    said = json.loads(text) if text else {}
    return answer.status_code, {key: said.get(key) for key in ("code", "detail", "fix", "errors")}


def telling_answers(
    house: SharedHouse,
    client: Client,
    asked: Iterable[Operation],
    hidden: Collection[str] | None = None,
    *,
    sees_some: bool = False,
) -> list[str]:
    """Return the answers that tell of what a caller does not see: no 404, or other words than for what is not there."""
    empty, telling = EmptyHouse(house, hidden), []
    for operation in asked:
        answer = house.answer(client, operation)
        if answer.status_code != 404 and not sees_some:
            telling.append(f"{operation.name}: {answer.status_code} {answer.text[:200]}")
        if answer.status_code != 404 or operation.method == "HEAD":
            continue
        said, missing = words_of(answer, house), words_of(ask(client, cast(House, empty), operation), empty)
        if said != missing:
            telling.append(f"{operation.name}: {said} for what is there, {missing} for what is not")
    return telling


def test_what_is_not_seen_is_answered_as_what_is_not_there(house: SharedHouse) -> None:
    """Neither status nor words tell that there is something, or what it belongs to."""
    about_something = those(is_about_something)
    telling = telling_answers(house, house.stranger, about_something)
    of_builds = [operation for operation in about_something if operation.policy.build]
    telling += telling_answers(house, house.build(house.foreign_secret), of_builds)
    for client, hidden in ((house.rival, ONE_DESIGNERS), (house.designer, STUDIOS), (house.reviewer, CONTRACTS)):
        asked = [operation for operation in about_something if names_in(operation) & hidden]
        telling += telling_answers(house, client, asked, hidden, sees_some=client is house.reviewer)
    assert not telling, "\n".join(telling)


# Of the studio and of people: who is outside a project sees these, or does not for other reasons.
OF_NO_PROJECT = {
    *("studio_id", "person_id", "studio_invitation_id", "template_id", "library_id", "mail_id"),
    *("roster_entry_id", "reel_sound_id", "sign_in_id", "passkey_id", "desk_token_id", "upload_id", "job_id"),
    *WEBHOOKS,
}


def test_for_members_outside_a_project_it_does_not_exist(house: SharedHouse) -> None:
    """Where members see only the projects that they are in, neither status nor words tell of another one."""

    def is_of_project(operation: Operation) -> bool:
        names = names_in(operation) - OF_NO_PROJECT
        return is_about_something(operation) and any(name.endswith("_id") for name in names)

    of_project = those(is_of_project)

    def close(session: Session) -> None:
        session.execute(update(Studio).where(Studio.id == house.studio_id).values(members_see=MembersSee.OWN))
        session.execute(delete(ProjectMember))

    as_it_was = house.saved
    house.server.in_database(close)
    house.saved = house.copy_of_database()
    try:
        wrong = house.wrong(of_project, (house.approver, house.reviewer), is_refused(404))
        telling = telling_answers(house, house.producer, of_project)
    finally:
        house.saved = as_it_was
        house.put_back()
    assert wrong == []
    assert not telling, "\n".join(telling)


@pytest.mark.slow
def test_who_lost_their_place_is_answered_as_what_is_not_there(house: SharedHouse) -> None:
    """What a person made stays theirs by id, and tells them nothing of what it belongs to."""
    about_something = those(is_about_something)

    def leave(session: Session) -> None:
        of_designer = update(Engagement).where(Engagement.designer_id == house.designer_id)
        session.execute(of_designer.values(designer_id=house.stranger_id))
        session.execute(delete(Membership).where(Membership.person_id == house.producer_id))

    as_it_was = house.saved
    house.server.in_database(leave)
    house.saved = house.copy_of_database()
    try:
        telling = [line for client in (house.designer, house.producer)
                   for line in telling_answers(house, client, about_something, sees_some=True)]  # fmt: skip
    finally:
        house.saved = as_it_was
        house.put_back()
    assert not telling, "\n".join(telling)


def test_a_build_does_not_do_what_people_do(house: SharedHouse) -> None:
    of_people = those(lambda operation: operation.policy.build is None)
    assert house.wrong(of_people, [house.build(house.own_secret)], is_refused(403, "person-needed")) == []


def test_a_build_of_another_project_finds_nothing(house: SharedHouse) -> None:
    of_builds = those(lambda operation: operation.policy.build is not None)
    assert house.wrong(of_builds, [house.build(house.foreign_secret)], is_refused(404)) == []


def test_a_build_keeps_to_its_scopes(house: SharedHouse) -> None:
    for scope in Scope:
        client = house.build(house.secret_with[scope])
        of_others = those(lambda operation, scope=scope: operation.policy.build not in (None, scope))
        assert house.wrong(of_others, [client], is_refused(403, "scope-missing")) == [], scope
        if scope is not Scope.DELIVERIES_WRITE:  # which needs a designer of the studio's own besides
            own = those(lambda operation, scope=scope: operation.policy.build is scope)
            assert house.wrong(own, [client], is_let_in) == [], scope


def test_a_desk_token_reads_the_desk_and_nothing_else(house: SharedHouse) -> None:
    client = house.build(house.desk_secret)
    of_desk, others = (
        those(lambda one, is_desk=is_desk: one.policy.desk_token is is_desk) for is_desk in (True, False)
    )
    assert len(of_desk) + len(others) == len(those(lambda _: True))
    assert house.wrong(of_desk, [client], is_let_in) == []
    assert house.wrong(others, [client], is_refused(401, "not-signed-in")) == []


def test_a_designer_does_nothing_of_the_teams(house: SharedHouse) -> None:
    def is_right(operation: Operation, answer: Response) -> bool:
        is_unseen = "change_request_id" in names_in(operation)  # a draft, which was not sent yet
        return answer.status_code == (404 if is_unseen else 403)

    of_teams = those(lambda operation: operation.policy.audience in TEAMS and not names_in(operation) & STUDIOS)
    assert house.wrong(of_teams, [house.designer], is_right) == []


def test_a_reviewer_neither_runs_nor_decides_nor_delivers(house: SharedHouse) -> None:
    def is_right(operation: Operation, answer: Response) -> bool:
        # mails and webhooks may hold secret addresses
        is_unseen = names_in(operation) & {"mail_id", *WEBHOOKS, *CONTRACTS}
        return answer.status_code == (404 if is_unseen else 403)

    audiences = (Audience.PRODUCER, Audience.APPROVER, Audience.DESIGNER)
    of_others = those(lambda operation: operation.policy.audience in audiences)
    assert house.wrong(of_others, [house.reviewer], is_right) == []


def test_only_who_runs_the_server_sees_the_whole_of_it(house: SharedHouse) -> None:
    callers = (house.producer, house.approver, house.reviewer, house.designer, house.stranger)
    of_operators = those(lambda operation: operation.policy.audience is Audience.OPERATOR)
    assert house.wrong(of_operators, callers, is_refused(403, "operator-needed")) == []


def test_a_producer_neither_decides_nor_delivers(house: SharedHouse) -> None:
    of_others = those(lambda operation: operation.policy.audience in (Audience.APPROVER, Audience.DESIGNER))
    assert house.wrong(of_others, [house.producer], is_refused(403)) == []


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
TESTED_ELSEWHERE = {  # in tests/app/accounts: test_demo_door.py and test_sign_in_providers.py
    *("play_demo_part", "finish_provider_sign_in", "give_provider_sign_in_code"),
}


@pytest.mark.parametrize("audience", Audience)
def test_whom_it_is_for_is_let_in(house: SharedHouse, audience: Audience) -> None:
    """Without this, an endpoint that refuses everyone would pass all of the above."""
    wrong = []
    for operation in operations():
        if operation.policy.audience is not audience or operation.name in TESTED_ELSEWHERE:
            continue
        answers = (house.answer(getattr(house, who), operation) for who in ADMITTED[audience])
        if not any(is_let_in(operation, last := answer) for answer in answers):
            wrong.append(f"{operation.name}: {last.status_code} {last.text[:200]}")
    assert wrong == []


def test_what_an_answer_changed_is_put_back(house: SharedHouse) -> None:
    """Without this, a house that an earlier question emptied would answer 404 to all."""
    by_name = {operation.name: operation for operation in operations()}
    before = ask(house.producer, house, by_name["get_spoken_placeholder"]).json()
    assert ask(house.producer, house, by_name["remove_spoken_placeholder"]).status_code == 204
    assert ask(house.producer, house, by_name["get_spoken_placeholder"]).json() is None
    house.put_back()
    assert ask(house.producer, house, by_name["get_spoken_placeholder"]).json() == before
