"""The brief: answered as people type, published as versions, read and asked about by designers."""

from typing import Any

import pytest
from httpx import Response
from httpx2 import Client

from app.briefs.questions import QUESTIONS
from app.projects.models import Engagement
from app.projects.rules import EngagementKind
from tests.support.server import World


def path(world: World, rest: str = "") -> str:
    return f"/v1/projects/{world.project_id}/brief{rest}"


def read(world: World, by: Client | None = None) -> dict[str, Any]:
    answer = (by or world.producer).get(path(world))
    assert answer.status_code == 200, answer.text
    return dict(answer.json())


def save(world: World, revision: int, by: Client | None = None, **values: Any) -> Response:
    body = {"revision": revision, "answers": {key: {"value": value} for key, value in values.items()}}
    return (by or world.producer).patch(path(world), json=body)


def unknown(world: World, revision: int, key: str) -> Response:
    body = {"revision": revision, "answers": {key: {"is_unknown": True, "note": "The director knows."}}}
    return world.producer.patch(path(world), json=body)


def question(brief: dict[str, Any], key: str) -> dict[str, Any]:
    (found,) = [one for topic in brief["topics"] for one in topic["questions"] if one["key"] == key]
    return dict(found)


def test_a_project_begins_with_every_question_open(world: World) -> None:
    brief = read(world, world.designer)
    assert (brief["revision"], brief["answered"], brief["newest_version"]) == (0, 0, 0)
    asked = [one["key"] for topic in brief["topics"] for one in topic["questions"] if one["applies"]]
    assert brief["open"] == asked
    assert brief["total"] == len(asked) == len(QUESTIONS) - 3  # two on voices and one on licences follow another answer
    assert set(brief["open_required"]) < set(asked)
    assert (brief["may_answer"], brief["may_ask"]) == (False, True)
    assert all(one["why"] and one["example"] for topic in brief["topics"] for one in topic["questions"])


def test_answers_are_saved_as_they_are_typed(world: World) -> None:
    first = save(world, 0, genre="  A platformer\r\nfor children ", platforms=["phone", "pc"])
    assert first.status_code == 200, first.text
    brief = first.json()
    assert (brief["revision"], brief["answered"]) == (1, 2)
    genre = question(brief, "genre")["answer"]
    assert (genre["value"], genre["revision"]) == ("A platformer\nfor children", 1)
    assert genre["answered_by"]["name"] == "Producer"
    assert question(brief, "platforms")["answer"]["words"] == "PC or Mac\nPhone or tablet"
    again = save(world, 1, genre="A platformer\nfor children").json()
    assert again["revision"] == 1  # it states the same
    removed = save(world, 1, genre="").json()
    assert question(removed, "genre")["answer"] is None
    assert (removed["revision"], removed["answered"]) == (2, 1)
    assert read(world, world.designer)["answered"] == 1


def test_not_knowing_is_an_answer_that_stays_open(world: World) -> None:
    brief = unknown(world, 0, "naming").json()
    answer = question(brief, "naming")["answer"]
    assert (answer["is_unknown"], answer["value"]) == (True, None)
    assert answer["words"] == "Not known yet\nThe director knows."
    assert brief["answered"] == 0
    assert "naming" in brief["open_required"]


def test_a_question_that_follows_from_another_is_asked_only_then(world: World) -> None:
    before = read(world)
    assert not question(before, "voice_people")["applies"]
    after = save(world, 0, voice="dialogue").json()
    assert question(after, "voice_people")["applies"]
    assert after["total"] == before["total"] + 1
    assert "voice_people" in after["open_required"]


@pytest.mark.slow
def test_two_people_collide_only_over_the_same_answer(world: World) -> None:
    save(world, 0, genre="A platformer", feel="Warm")
    assert save(world, 1, world.approver, feel="Cold").status_code == 200
    assert save(world, 1, genre="A racing game").status_code == 200  # no one else changed this one
    refused = save(world, 1, feel="Loud")
    assert (refused.status_code, refused.json()["code"]) == (409, "answer-changed")
    assert refused.json()["errors"] == [{"where": "feel", "message": "Audio director changed this answer"}]
    brief = read(world)
    assert question(brief, "feel")["answer"]["value"] == "Cold"
    assert save(world, brief["revision"], feel="Loud").status_code == 200


@pytest.mark.parametrize(
    ("key", "value"),
    [
        ("genre", 3),
        ("genre", "x" * 4001),
        ("voice", "whisper"),
        ("voice", ["none"]),
        ("platforms", "pc"),
        ("platforms", ["pc", "toaster"]),
        ("platforms", [{}]),
        ("memory", "8"),
        ("memory", True),
        ("memory", 0),
        ("memory", -1),
        ("memory", 10**400),
        ("similar", ["x" * 201]),
        ("similar", ["x"] * 101),
        ("effects", ["reverb"]),
        ("effects", {"everything": ["echo"]}),
        ("effects", {"../x": ["reverb"]}),
        ("scenes", [{"scene": "Harbour", "music": "loud"}]),
        ("scenes", [{"ambience": "Gulls"}]),
        ("scenes", [{"scene": "Harbour", "x": 1}]),
        ("naming", {"tokens": [{"name": "what", "pattern": "(a+)+"}]}),
        ("naming", {"tokens": [{"name": "what", "optional": True}]}),
        ("naming", {"tokens": [{"name": "what"}, {"name": "what"}]}),
        ("naming", {"tokens": [{"name": "what", "digits": 99}]}),
        ("naming", {"tokens": [{"name": "what"}], "separator": "/"}),
        ("naming", {"tokens": [{"name": "what"}], "extension": ".exe"}),
    ],
)
def test_what_does_not_fit_its_question_is_refused(world: World, key: str, value: Any) -> None:
    answer = save(world, 0, **{key: value})
    assert answer.status_code == 422, answer.text
    assert answer.json()["code"] in ("answer-invalid", "unstorable")
    if answer.json()["code"] == "answer-invalid":
        assert answer.json()["errors"][0]["where"] == key
    assert read(world)["revision"] == 0


def test_a_question_that_there_is_not_is_refused(world: World) -> None:
    answer = save(world, 0, horoscope="Leo", genre="A platformer")
    assert (answer.status_code, answer.json()["code"]) == (422, "question-unknown")
    assert read(world)["answered"] == 0


def test_who_may_answer(world: World) -> None:
    assert save(world, 0, world.approver, genre="A platformer").status_code == 200
    for by in (world.reviewer, world.designer):
        assert save(world, 1, by, genre="Chess").json()["code"] == "team-needed"
    for by in (world.stranger, world.other_designer):
        assert save(world, 1, by, genre="Chess").status_code == 404
        assert by.get(path(world)).status_code == 404


def publish(world: World, revision: int, note: str = "") -> Response:
    return world.producer.post(path(world, "/versions"), json={"revision": revision, "note": note})


@pytest.mark.slow
def test_a_version_keeps_the_answers_and_is_compared(world: World) -> None:
    assert publish(world, 0).json()["code"] == "nothing-to-publish"
    save(world, 0, genre="A platformer", silence="never")
    first = publish(world, 1, "For the first call.")
    assert first.status_code == 201, first.text
    assert (first.json()["number"], first.json()["answered"]) == (1, 2)
    assert first.json()["publisher"]["name"] == "Producer"
    assert publish(world, 1).json()["code"] == "nothing-to-publish"
    assert not read(world)["differs"]
    save(world, 1, genre="A racing game", memory=8)
    assert read(world)["differs"]
    assert publish(world, 1).json()["code"] == "answer-changed"
    assert publish(world, 2).json()["number"] == 2
    kept = world.designer.get(path(world, "/versions/1")).json()
    assert question(kept, "genre")["answer"]["value"] == "A platformer"
    listed = world.designer.get(path(world, "/versions")).json()["items"]
    assert [(one["number"], one["note"]) for one in listed] == [(2, ""), (1, "For the first call.")]
    compared = world.designer.get(path(world, "/compare"), params={"from": 1, "to": 2}).json()
    assert [(one["question"], one["before"], one["after"]) for one in compared["differences"]] == [
        ("genre", "A platformer", "A racing game"),
        ("memory", "", "8 MB"),
    ]
    save(world, 2, silence="some")
    now = world.producer.get(path(world, "/compare"), params={"from": 2}).json()
    assert [(one["question"], one["after"]) for one in now["differences"]] == [
        ("silence", "At some moments, described below")
    ]
    assert world.producer.get(path(world, "/compare"), params={"from": 3}).json()["code"] == "brief-version-not-found"
    assert world.producer.get(path(world, "/versions/3")).status_code == 404


def test_the_team_sees_which_version_each_designer_opened(world: World) -> None:
    save(world, 0, genre="A platformer")
    publish(world, 1)
    (last,) = world.producer.get(path(world, "/reads")).json()
    assert (last["designer"]["name"], last["version"], last["behind"]) == ("Sound designer", None, 1)
    for _ in range(2):
        assert world.designer.put(path(world, "/versions/1/read")).status_code == 204
    (last,) = world.reviewer.get(path(world, "/reads")).json()
    assert (last["version"], last["behind"]) == (1, 0)
    read_at = last["read_at"]
    save(world, 1, feel="Warm")
    publish(world, 2)
    (last,) = world.producer.get(path(world, "/reads")).json()
    assert (last["version"], last["behind"], last["read_at"]) == (1, 1, read_at)
    assert world.designer.get(path(world, "/reads")).status_code == 403
    assert world.producer.put(path(world, "/versions/1/read")).status_code == 403
    assert world.designer.put(path(world, "/versions/9/read")).status_code == 404


def test_a_designer_asks_and_the_team_answers_once(world: World) -> None:
    asked = world.designer.post(path(world, "/follow-ups"), json={"question": "naming", "text": "Which separator?"})
    assert asked.status_code == 201, asked.text
    url = f"/v1/brief-follow-ups/{asked.json()['id']}/answer"
    assert world.designer.post(url, json={"text": "None."}).status_code == 403
    assert world.reviewer.post(url, json={"text": "None."}).status_code == 403
    assert world.stranger.post(url, json={"text": "None."}).status_code == 404
    answered = world.approver.post(url, json={"text": "An underscore."})
    assert answered.json()["answered_by"]["name"] == "Audio director"
    again = world.producer.post(url, json={"text": "A dash."})
    assert (again.status_code, again.json()["code"]) == (409, "follow-up-answered")
    (shown,) = read(world, world.designer)["follow_ups"]
    assert (shown["answer"], shown["asked_by"]["name"]) == ("An underscore.", "Sound designer")
    unknown_question = {"question": "horoscope", "text": "Which?"}
    assert world.designer.post(path(world, "/follow-ups"), json=unknown_question).json()["code"] == "question-unknown"
    assert world.producer.post(path(world, "/follow-ups"), json=unknown_question).status_code == 403


def test_designers_do_not_see_one_anothers_names(world: World) -> None:
    world.designer.post(path(world, "/follow-ups"), json={"question": "naming", "text": "Which separator?"})
    world.server.in_database(
        lambda session: session.add(
            Engagement(
                studio_id=world.studio_id,
                project_id=world.project_id,
                designer_id=world.other_designer_id,
                kind=EngagementKind.ADVISORY,
            )
        )
    )
    (shown,) = read(world, world.other_designer)["follow_ups"]
    assert (shown["text"], shown["asked_by"]) == ("Which separator?", None)
    assert world.other_designer.get(path(world, "/reads")).status_code == 403
