"""Open answers of the brief stand in what is signed; without them nothing is sent while a needed one is open."""

import pytest

from tests.app.agreements.conftest import Contracts
from tests.app.agreements.test_lifecycle import strike, words_of
from tests.support.server import World


def answer(world: World, revision: int, **answers: object) -> None:
    body = {"revision": revision, "answers": answers}
    saved = world.producer.patch(f"/v1/projects/{world.project_id}/brief", json=body)
    assert saved.status_code == 200, saved.text


@pytest.fixture
def contracts(world: World) -> Contracts:
    return Contracts(world)


def test_open_answers_are_printed_into_the_text(world: World, contracts: Contracts) -> None:
    answer(
        world, 0, genre={"value": "A platformer"}, naming={"is_unknown": True, "note": "The {lead} programmer knows."}
    )
    said = words_of(contracts.begin())
    assert "Brief, question 20, needed: How is a file named? The {lead} programmer knows." in said
    assert "Brief, question 8: Is there any moment that is silent on purpose?" in said
    assert "What kind of game is it?" not in said


def test_answers_that_decide_how_a_sound_is_made_stand_in_the_text(world: World, contracts: Contracts) -> None:
    assert "The brief answers none of this yet." in words_of(contracts.begin())
    answer(
        world, 0, platforms={"value": ["handheld"]}, similar={"value": ["the doors of a submarine film", "{total}"]},
        genre={"value": "A platformer"}, playback={"is_unknown": True},
    )  # fmt: skip
    said = words_of(contracts.begin())
    assert "Which games, films or recordings does it sound like? the doors of a submarine film; {total}" in said
    assert "A platformer" not in said


@pytest.mark.slow
def test_without_a_brief_nothing_of_it_is_printed_and_all_is_sent(world: World, contracts: Contracts) -> None:
    begun = contracts.begin()
    assert "No question is open." in words_of(begun)
    struck = contracts.save(begun, clauses=strike(begun, "open_questions"))
    assert contracts.send(struck)["state"] == "sent"


@pytest.mark.slow
def test_a_text_that_leaves_them_out_is_not_sent(world: World, contracts: Contracts) -> None:
    answer(world, 0, naming={"is_unknown": True})
    begun = contracts.begin()
    struck = contracts.save(begun, clauses=strike(begun, "open_questions"))
    url = f"/v1/contracts/{struck['id']}/send"
    refused = world.producer.post(url, json={"note": ""})
    assert (refused.status_code, refused.json()["code"]) == (409, "brief-open")
    assert {"where": "question 20", "message": "How is a file named?"} in refused.json()["errors"]
    restored = contracts.save(struck, clauses=begun["version"]["clauses"])
    assert world.producer.post(f"/v1/contracts/{restored['id']}/send", json={"note": ""}).status_code == 200


@pytest.mark.slow
def test_an_nda_waits_for_no_brief(world: World, contracts: Contracts) -> None:
    answer(world, 0, naming={"is_unknown": True})
    assert contracts.send(contracts.begin("nda", title="NDA"))["state"] == "sent"
