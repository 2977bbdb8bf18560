"""A designer edits a text that was sent, clause by clause, and the studio answers each change."""

from typing import Any
from uuid import UUID

import pytest
from sqlalchemy.orm import Session

from app.agreements.queries import version_by_number
from tests.app.agreements.conftest import Contracts, words_of
from tests.app.agreements.redlining import EDITED, INSERTED, STRUCK, Redlining, refusal
from tests.app.sound_lists.lists import add
from tests.support.server import World

# Blanks inside, marks, a brace that is meant as one, letters beyond ASCII: what is agreed is these bytes.
ROUNDS = "The price of a cue includes {rounds_included} rounds.\n\n- After **10 days**  – 25 \\{%}.\n- Même là."


@pytest.fixture
def redlining(world: World, contracts: Contracts) -> Redlining:
    return Redlining(world, contracts)


def test_what_is_accepted_is_signed_word_for_word(world: World, redlining: Redlining):
    round_ = redlining.propose(
        redlining.replace("rounds", ROUNDS, comment="Two are enough."),
        STRUCK,
        INSERTED,
    )
    assert redlining.draft()["state"] == "draft"
    assert [one["redline"] and one["redline"]["number"] for one in round_["clauses"] if one["redline"]] == [2, 1, 3]
    for number in (1, 2, 3):
        redlining.answer(number, "accepted")
    own = next(row for row in redlining.draft()["version"]["clauses"] if row["title"] == "Tea")
    assert own["text"] == INSERTED["text"]
    sent = redlining.contracts.send(redlining.draft())

    def kept(session: Session) -> tuple[str, str]:
        version = version_by_number(session, UUID(sent["id"]), sent["version"]["number"])
        assert version is not None
        return next(row["text"] for row in version.clauses if row["key"] == "rounds"), version.text

    clause, text = world.server.in_database(kept)
    assert clause.encode() == ROUNDS.encode()
    assert ROUNDS.replace("{rounds_included}", "2") in text
    assert "At four, with Sound designer." in text
    assert "no legal advice" not in text
    titles = [row["title"] for row in sent["version"]["clauses"] if row["stands"]]
    assert titles[titles.index("Rounds") + 1] == "Tea"
    seen = redlining.contracts.ask(world.designer, "GET", redlining.path)
    redlining.contracts.accept(seen, world.designer, "N. Designer")
    agreed = redlining.contracts.accept(sent, world.producer, "P. Producer")
    assert agreed["state"] == "agreed"
    assert redlining.faults() == []


def test_nothing_unanswered_or_refused_gets_in(world: World, redlining: Redlining):
    redlining.propose(redlining.replace("rounds", "Rounds are free."), INSERTED, STRUCK)
    redlining.answer(1, "refused", comment="They are not.")
    redlining.answer(3, "refused", comment="It says what this is.")
    unsent = world.producer.post(f"/v1{redlining.path}/send", json={})
    assert refusal(unsent) == (409, "redlines-open", "one proposed change has no answer yet")
    said = words_of(redlining.draft())
    assert "Rounds are free." not in said
    assert "At four" not in said
    redlining.answer(2, "refused", comment="No.")
    sent = redlining.contracts.send(redlining.draft())
    assert [row["text"] for row in sent["version"]["clauses"]] == [
        row["text"] for row in redlining.sent["version"]["clauses"]
    ]
    assert "no legal advice" in words_of(sent)
    assert redlining.faults() == []


def test_a_counter_goes_in_and_both_see_it_beside_what_was_proposed(world: World, redlining: Redlining):
    redlining.propose(redlining.replace("rounds", "Four rounds."), STRUCK)
    redlining.answer(1, "countered", title="Rounds", text=" Three rounds.\n", comment="Three we can do.")
    redlining.answer(2, "countered", title="About", text="A template.")
    drafted = redlining.drafted("rounds")
    assert drafted is not None
    assert drafted["text"] == "Three rounds."
    sent = redlining.contracts.send(redlining.draft())
    assert "A template." in words_of(sent)
    read = redlining.contracts.ask(world.designer, "GET", f"{redlining.path}/redlines")
    assert (read["may_answer"], read["round"]["sent_version"]) == (False, sent["version"]["number"])
    rounds = next(one for one in read["round"]["clauses"] if one["key"] == "rounds")
    answer = rounds["redline"]["answer"]
    assert (answer["kind"], answer["comment"], answer["by"]) == ("countered", "Three we can do.", "Producer")
    assert answer["wording"]["text"] == "Three rounds."
    assert _words(rounds["lines"], "later") == ["Four rounds."]
    assert _words(rounds["counter_lines"], "later") == ["Three rounds."]


def _words(lines: list[dict[str, Any]], is_in: str) -> list[str]:
    return [run["text"] for line in lines for run in line["runs"] if run["is_in"] == is_in]


def test_both_read_one_text_with_marks(world: World, redlining: Redlining):
    text = redlining.clause("rounds")["text"].replace("{rounds_included}", "three")
    redlining.propose(redlining.replace("rounds", text, comment="As we said."))
    pages = [
        redlining.contracts.ask(by, "GET", f"{redlining.path}/redlines") for by in (world.designer, world.producer)
    ]
    assert pages[0]["round"] == pages[1]["round"]
    assert [page["may_answer"] for page in pages] == [False, True]
    marked = {one["key"]: one for one in pages[0]["round"]["clauses"]}
    assert _words(marked["rounds"]["lines"], "earlier") == ["2"]
    assert _words(marked["rounds"]["lines"], "later") == ["three"]
    assert pages[0]["round"]["by"] == "Sound designer"
    assert marked["rounds"]["redline"]["comment"] == "As we said."
    others = [line["change"] for key, one in marked.items() if key != "rounds" for line in one["lines"]]
    assert set(others) == {"same"}


def test_a_value_of_a_clause_is_changed_with_it(redlining: Redlining):
    text = redlining.clause("rounds")["text"]
    round_ = redlining.propose(redlining.replace("rounds", text, terms={"rounds_included": 4}))
    marked = next(one for one in round_["clauses"] if one["key"] == "rounds")
    assert _words(marked["lines"], "later") == ["4"]
    redlining.answer(1, "countered", title="Rounds", text=text, terms={"rounds_included": 3})
    assert redlining.draft()["version"]["terms"]["rounds_included"] == 3
    redlining.answer(1, "refused", comment="Two.")
    assert redlining.draft()["version"]["terms"]["rounds_included"] == 2


def test_a_variable_that_became_its_value_is_marked_too(redlining: Redlining):
    text = redlining.clause("rounds")["text"].replace("{rounds_included}", "2")
    round_ = redlining.propose(redlining.replace("rounds", text))
    marked = next(one for one in round_["clauses"] if one["key"] == "rounds")
    assert _words(marked["lines"], "earlier") == ["{rounds_included}"]


def test_the_last_answer_counts_and_undoes_the_one_before(redlining: Redlining):
    before = redlining.draft()["version"]["clauses"]
    redlining.propose(redlining.replace("rounds", "Four rounds."), INSERTED, STRUCK)
    for number in (1, 2, 3):
        redlining.answer(number, "accepted")
    redlining.answer(2, "countered", title="Tea", text="At five.")
    own = next(row for row in redlining.draft()["version"]["clauses"] if row["title"] == "Tea")
    assert own["text"] == "At five."
    for number in (1, 2, 3):
        redlining.answer(number, "refused", comment="On reflection, no.")
    assert redlining.draft()["version"]["clauses"] == before


def test_an_agreed_clause_that_was_edited_afterwards_is_not_sent(world: World, redlining: Redlining):
    redlining.propose(redlining.replace("rounds", "Four rounds."))
    redlining.answer(1, "accepted")
    draft = redlining.draft()
    rows = [row | {"text": "One round."} if row["key"] == "rounds" else row for row in draft["version"]["clauses"]]
    redlining.contracts.save(draft, clauses=rows)
    unsent = world.producer.post(f"/v1{redlining.path}/send", json={})
    assert refusal(unsent)[:2] == (409, "redlines-open")
    assert unsent.json()["fix"].startswith("answer it again on the page Redlines")
    redlining.answer(1, "accepted")  # the advice works
    assert "Four rounds." in words_of(redlining.contracts.send(redlining.draft()))


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (
            {**EDITED, "text": "{rounds_includd}"},
            "is it {rounds_included}?",
        ),
        ({**EDITED, "text": " "}, "the clause is empty"),
        ({**EDITED, "title": ""}, "enter a title"),
        ({**EDITED, "clause_key": "ruonds"}, "this version has no clause ruonds"),
        (
            {**EDITED, "clause_key": "bonus"},
            "this version has no clause bonus",
        ),
        ({"kind": "strike"}, "name the clause that is changed"),
        ({"kind": "insert", "after_key": "nowhere", "title": "T", "text": "A."}, "this version has no clause nowhere"),
        ({**INSERTED, "terms": {"rounds_included": 3}}, "does not name {rounds_included}"),
        (
            {"kind": "insert", "title": "T", "text": "{rounds_included}", "terms": {"rounds_included": 99}},
            "99; wanted 0 to 20",
        ),
    ],
)
def test_a_change_that_a_draft_could_not_have_is_refused(redlining: Redlining, change: dict[str, Any], words: str):
    refused = redlining.try_to_propose(INSERTED, change)
    assert refusal(refused)[:2] == (422, "bad-redlines")
    (fault,) = refused.json()["errors"]
    assert fault["where"] == "changes.1"
    assert words in fault["message"]
    shown = redlining.contracts.ask(
        redlining.world.designer, "POST", f"{redlining.path}/redline-preview", json={"changes": [INSERTED, change]}
    )
    assert shown["problems"] == [fault]
    assert "Tea" in [run["text"] for one in shown["clauses"] for line in one["lines"] for run in line["runs"]]
    assert redlining.draft()["state"] == "sent", "nothing was saved"


def test_a_clause_is_changed_once_and_really(redlining: Redlining):
    twice = redlining.try_to_propose(redlining.replace("rounds", "A."), {"kind": "strike", "clause_key": "rounds"})
    assert twice.json()["errors"][0]["message"] == "the clause Rounds is changed twice"
    same = redlining.try_to_propose(redlining.replace("rounds", redlining.clause("rounds")["text"]))
    assert same.json()["errors"][0]["message"] == "nothing of Rounds is changed"
    rows = redlining.sent["version"]["clauses"]
    none_left = redlining.try_to_propose(
        *({"kind": "strike", "clause_key": row["key"]} for row in rows if row["stands"])
    )
    assert "no clause would be left" in none_left.json()["errors"][0]["message"]


def test_answers_that_mean_nothing_are_refused(redlining: Redlining):
    redlining.propose(redlining.replace("rounds", "Four rounds."))
    for body, words in (
        ({"answer": "refused"}, "say why it is refused"),
        ({"answer": "countered", "title": "Rounds", "text": "Four rounds."}, "this is what was proposed; accept it"),
        ({"answer": "countered", "title": "Rounds", "text": "{round}"}, "there is no variable {round}"),
    ):
        refused = redlining.try_to_answer(1, **body)
        assert refusal(refused)[:2] == (422, "bad-redlines")
        assert words in refused.json()["detail"]
    assert refusal(redlining.try_to_answer(2, "accepted"))[:2] == (404, "redline-not-found")


def test_accepting_keeps_the_draft_whole(redlining: Redlining, contracts: Contracts, world: World):
    contracts.ask(world.producer, "POST", f"{redlining.path}/recall", json={"reason": "Tax."})
    draft = redlining.draft()
    contracts.save(draft, terms={**draft["version"]["terms"], "tax_bp": 1_900})
    redlining.sent = contracts.send(redlining.draft())
    redlining.propose({"kind": "strike", "clause_key": "tax"})
    refused = redlining.try_to_answer(1, "accepted")
    assert refusal(refused)[:2] == (422, "bad-redlines")
    assert "no clause in force says so" in refused.json()["detail"]
    draft = redlining.draft()
    contracts.save(draft, terms={**draft["version"]["terms"], "tax_bp": 0})  # what the refusal advises
    redlining.answer(1, "accepted")
    assert redlining.drafted("tax") == {**redlining.clause("tax"), "stands": False}


def test_each_does_their_own_part(world: World, redlining: Redlining):
    change = redlining.replace("rounds", "Four rounds.")
    body = {"version": redlining.sent["version"]["number"], "changes": [change]}
    answer = {"answer": "accepted"}
    path = f"/v1{redlining.path}/redlines"
    assert refusal(world.producer.post(path, json=body))[:2] == (403, "not-your-contract")
    assert refusal(redlining.try_to_answer(1, "accepted"))[:2] == (409, "wrong-state")
    for stranger in (world.reviewer, world.stranger):
        assert stranger.get(path).status_code == 404
        assert stranger.post(path, json=body).status_code == 404
        assert stranger.post(f"{path}/1/answer", json=answer).status_code == 404
    redlining.propose(change)
    assert refusal(world.designer.post(f"{path}/1/answer", json=answer))[:2] == (403, "producer-needed")
    assert refusal(redlining.try_to_propose(change))[:2] == (409, "wrong-state"), "it is with the studio now"


def test_changes_of_a_text_that_stands_no_more_are_kept_back(redlining: Redlining):
    old = redlining.sent["version"]["number"]
    redlining.contracts.ask(redlining.world.producer, "POST", f"{redlining.path}/recall", json={"reason": "A slip."})
    redlining.contracts.send(redlining.sent)
    stale = redlining.try_to_propose(redlining.replace("rounds", "Four rounds."), version=old)
    assert refusal(stale)[:2] == (409, "text-changed")


def test_a_second_round_counts_on(world: World, redlining: Redlining):
    redlining.propose(redlining.replace("rounds", "Four rounds."))
    redlining.answer(1, "refused", comment="Two.")
    redlining.sent = redlining.contracts.send(redlining.draft())
    redlining.propose(redlining.replace("rounds", "Three rounds."), note="Half way?")
    read = redlining.contracts.ask(world.producer, "GET", f"{redlining.path}/redlines")
    assert (read["rounds"], read["round"]["number"], read["round"]["note"]) == (2, 2, "Half way?")
    assert [one["redline"]["number"] for one in read["round"]["clauses"] if one["redline"]] == [2]
    first = redlining.contracts.ask(world.designer, "GET", f"{redlining.path}/redlines", params={"round": 1})
    assert (first["round"]["number"], first["round"]["unanswered"], first["may_answer"]) == (1, 0, False)
    assert refusal(redlining.try_to_answer(1, "accepted"))[:2] == (404, "redline-not-found"), "its round is closed"


def test_a_designer_bound_to_an_nda_learns_nothing_by_inserting_variables(world: World, contracts: Contracts):
    add(world, {"name": "Secret boss roar"})
    project = f"/projects/{world.project_id}"
    contracts.ask(world.producer, "PATCH", project, json={"nda_needed": True})
    sent = contracts.send(contracts.begin("nda", title="NDA"))
    change = {"kind": "insert", "after_key": None, "title": "Cues", "text": "{cues}\n\n{open_questions}"}
    shown = world.designer.post(f"/v1/contracts/{sent['id']}/redline-preview", json={"changes": [change]})
    assert shown.status_code == 200, shown.text
    assert "Secret boss" not in shown.text
    assert "{cues}" in shown.text
