"""Two who do the same at the same moment: one does it, the other is refused, and nothing is overwritten unseen."""

import threading
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from uuid import uuid4

import pytest
from httpx import Response

from tests.app.reviews.making import Stage
from tests.support.deliver import add_cues, open_delivery
from tests.support.server import RunningServer, World

pytestmark = pytest.mark.both_databases

ROUNDS = 6


@pytest.fixture
def together() -> Iterator[Callable[..., list[Response]]]:
    """Send requests at one moment, each from a thread of its own."""
    with ThreadPoolExecutor(8) as threads:

        def send(*requests: Callable[[], Response]) -> list[Response]:
            barrier = threading.Barrier(len(requests))

            def once_all_are_here(request: Callable[[], Response]) -> Response:
                barrier.wait()
                return request()

            return list(threads.map(once_all_are_here, requests))

        yield send


def statuses(answers: list[Response]) -> list[int]:
    return sorted(answer.status_code for answer in answers)


@pytest.mark.slow
def test_of_two_editors_of_a_cue_one_is_refused(world: World, together: Callable[..., list[Response]]):
    (cue,) = add_cues(world, {"name": "door_open"})
    for number in range(ROUNDS):
        edition = world.producer.get(f"/v1/cues/{cue['id']}").json()["edition"]
        answers = together(
            *(
                partial(
                    browser.patch, f"/v1/cues/{cue['id']}", json={"edition": edition, "description": f"{text} {number}"}
                )
                for browser, text in ((world.producer, "heavy"), (world.approver, "light"))
            )
        )
        assert statuses(answers) == [200, 409], [answer.text for answer in answers]
        (saved,) = [answer for answer in answers if answer.status_code == 200]
        assert world.producer.get(f"/v1/cues/{cue['id']}").json()["description"] == saved.json()["description"]


@pytest.mark.slow
def test_a_spec_is_saved_by_one_of_two(world: World, together: Callable[..., list[Response]]):
    address = f"/v1/projects/{world.project_id}/spec"
    for number in range(ROUNDS):
        now = world.producer.get(address).json()
        toml = now["toml"] + f"\n# {number}"
        answers = together(
            *(
                partial(
                    browser.put,
                    address,
                    json={"toml": f"{toml} {browser is world.producer}", "based_on_version": now["version"]},
                )
                for browser in (world.producer, world.approver)
            )
        )
        assert statuses(answers) == [200, 409], [answer.text for answer in answers]


@pytest.mark.slow
def test_a_question_is_answered_by_one_of_two(world: World, together: Callable[..., list[Response]]):
    (cue,) = add_cues(world, {"name": "splash"})
    question = world.designer.post(f"/v1/cues/{cue['id']}/questions", json={"text": "how large?"}).json()
    answers = together(
        *(
            partial(browser.post, f"/v1/questions/{question['id']}/answer", json={"text": text})
            for browser, text in ((world.producer, "a pebble"), (world.approver, "a boulder"))
        )
    )
    assert statuses(answers) == [200, 409], [answer.text for answer in answers]
    (said,) = [answer.json()["answer"] for answer in answers if answer.status_code == 200]
    assert world.producer.get(f"/v1/cues/{cue['id']}").json()["description"] == f"how large? {said}"


@pytest.mark.slow
def test_a_cue_is_cut_once(world: World, together: Callable[..., list[Response]]):
    for cue in add_cues(world, *({"name": f"cut_{number}"} for number in range(ROUNDS))):
        cut = {"reason": "the level is gone"}
        answers = together(
            partial(world.producer.post, f"/v1/cues/{cue['id']}/cut", json=cut),
            partial(world.approver.post, f"/v1/cues/{cue['id']}/cut", json=cut),
        )
        assert statuses(answers)[0] < 300, [answer.text for answer in answers]
        assert statuses(answers)[1] == 409, [answer.text for answer in answers]


def test_an_address_signs_up_once(server: RunningServer, together: Callable[..., list[Response]]):
    server.forget_tries()
    address = f"{uuid4()}@example.test"
    body = {"email": address, "name": "Ada", "password": "four words that rhyme", "studio_name": "Ada's"}
    browsers = [server.browser() for _ in range(3)]
    answers = together(*(partial(browser.post, "/v1/sign-up", json=body) for browser in browsers))
    assert statuses(answers) == [201, 409, 409], [answer.text for answer in answers]


def test_deliveries_of_one_moment_have_numbers_of_their_own(world: World, together: Callable[..., list[Response]]):
    open_delivery(world)
    address = f"/v1/projects/{world.project_id}/deliveries"
    answers = together(*[partial(world.designer.post, address, json={})] * 6)
    assert sorted(answer.json()["number"] for answer in answers) == [2, 3, 4, 5, 6, 7]


def test_drafts_are_sent_once(world: World, together: Callable[..., list[Response]]):
    stage = Stage(world)
    stage.draft(stage.take(stage.cue()))
    sendings = f"/v1/projects/{world.project_id}/feedback"
    answers = together(*[partial(world.approver.post, sendings, json={"note": ""})] * 3)
    assert statuses(answers)[0] == 201, [answer.text for answer in answers]
    assert statuses(answers)[1:] == [409, 409], [answer.text for answer in answers]
