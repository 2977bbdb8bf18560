"""A designer edits a text that was sent, clause by clause, and the studio answers each change."""

from typing import Any
from uuid import UUID

import pytest
from sqlalchemy.orm import Session

from app.agreements.plan.queries import terms_of
from app.agreements.queries import contract_by_id, version_by_number
from app.agreements.redlines.endpoints import PREVIEWS
from tests.app.agreements.conftest import Contracts, words_of
from tests.app.agreements.redlining import EDITED, INSERTED, STRUCK, Redlining, refusal
from tests.app.sound_lists.lists import add
from tests.support.server import World

# Blanks inside, marks, a brace that is meant as one, letters beyond ASCII: what is agreed is these bytes.
ROUNDS = "The price of a cue includes {rounds_included} rounds.\n\n- After **10 days**  – 25 \\{%}.\n- Même là."


@pytest.fixture
def redlining(world: World, contracts: Contracts) -> Redlining:
    return Redlining(world, contracts)


@pytest.mark.slow
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


@pytest.mark.slow
def test_nothing_unanswered_or_refused_gets_in(world: World, redlining: Redlining):
    redlining.propose(redlining.replace("warranty", "Nothing is warranted."), INSERTED, STRUCK)
    redlining.answer(1, "refused", comment="They are not.")
    redlining.answer(3, "refused", comment="It says what this is.")
    unsent = world.producer.post(f"/v1{redlining.path}/send", json={})
    assert refusal(unsent) == (409, "redlines-open", "1 proposed change has no answer yet")
    said = words_of(redlining.draft())
    assert "Nothing is warranted." not in said
    assert "At four" not in said
    redlining.answer(2, "refused", comment="No.")
    sent = redlining.contracts.send(redlining.draft())
    assert [row["text"] for row in sent["version"]["clauses"]] == [
        row["text"] for row in redlining.sent["version"]["clauses"]
    ]
    assert "no legal advice" in words_of(sent)
    assert redlining.faults() == []


@pytest.mark.slow
def test_a_counter_goes_in_and_both_see_it_beside_what_was_proposed(world: World, redlining: Redlining):
    redlining.propose(redlining.replace("warranty", "Own work."), STRUCK)
    redlining.answer(1, "countered", title="Originality", text=" Licensed work.\n", comment="Licensed we can do.")
    redlining.answer(2, "countered", title="About", text="A template.")
    drafted = redlining.drafted("warranty")
    assert drafted is not None
    assert drafted["text"] == "Licensed work."
    sent = redlining.contracts.send(redlining.draft())
    assert "A template." in words_of(sent)
    read = redlining.contracts.ask(world.designer, "GET", f"{redlining.path}/redlines")
    assert (read["may_answer"], read["round"]["sent_version"]) == (False, sent["version"]["number"])
    rounds = next(one for one in read["round"]["clauses"] if one["key"] == "warranty")
    answer = rounds["redline"]["answer"]
    assert (answer["kind"], answer["comment"], answer["by"]) == ("countered", "Licensed we can do.", "Producer")
    assert answer["wording"]["text"] == "Licensed work."
    assert _words(rounds["lines"], "later") == ["Own work."]
    assert _words(rounds["counter_lines"], "later") == ["Licensed work."]


def _words(lines: list[dict[str, Any]], is_in: str) -> list[str]:
    return [run["text"] for line in lines for run in line["runs"] if run["is_in"] == is_in]


@pytest.mark.slow
def test_both_read_one_text_with_marks(world: World, redlining: Redlining):
    text = redlining.clause("rounds")["text"].replace("{rounds_included}", "three")
    redlining.propose(redlining.replace("rounds", text, comment="As we said."))
    pages = [
        redlining.contracts.ask(by, "GET", f"{redlining.path}/redlines") for by in (world.designer, world.producer)
    ]
    assert pages[0]["round"] == pages[1]["round"]
    assert [page["may_answer"] for page in pages] == [False, True]
    marked = {page["key"]: page for page in pages[0]["round"]["clauses"]}
    assert _words(marked["rounds"]["lines"], "earlier") == ["2"]
    assert _words(marked["rounds"]["lines"], "later") == ["3"]
    assert marked["rounds"]["redline"]["wording"]["terms"] == {"rounds_included": 3}, "both see the value"
    assert pages[0]["round"]["by"] == "Sound designer"
    assert marked["rounds"]["redline"]["comment"] == "As we said."
    others = [line["change"] for key, one in marked.items() if key != "rounds" for line in one["lines"]]
    assert set(others) == {"same"}


@pytest.mark.slow
def test_a_value_of_a_clause_is_changed_with_it(redlining: Redlining):
    text = redlining.clause("rounds")["text"]
    round_ = redlining.propose(redlining.replace("rounds", text, terms={"rounds_included": 4}))
    marked = next(one for one in round_["clauses"] if one["key"] == "rounds")
    assert _words(marked["lines"], "later") == ["4"]
    redlining.answer(1, "countered", title="Rounds", text=text, terms={"rounds_included": 3})
    assert redlining.draft()["version"]["terms"]["rounds_included"] == 3
    redlining.answer(1, "refused", comment="Two.")
    assert redlining.draft()["version"]["terms"]["rounds_included"] == 2


@pytest.mark.slow
def test_a_variable_that_became_its_value_is_marked_too(redlining: Redlining):
    project = redlining.contracts.ask(redlining.world.producer, "GET", f"/projects/{redlining.world.project_id}")
    text = redlining.clause("parties")["text"].replace("{project}", project["name"])
    round_ = redlining.propose(redlining.replace("parties", text))
    marked = next(one for one in round_["clauses"] if one["key"] == "parties")
    assert _words(marked["lines"], "earlier") == ["{project}."]


@pytest.mark.slow
@pytest.mark.parametrize("typed", ["3", "three", "**3**", "three (3)"])
def test_a_number_typed_over_a_figure_is_signed_as_it_is_counted(world: World, redlining: Redlining, typed: str):
    text = redlining.clause("rounds")["text"]
    redlining.propose(redlining.replace("rounds", text.replace("{rounds_included}", typed)))
    redlining.answer(1, "accepted")
    sent = redlining.contracts.send(redlining.draft())
    assert sent["version"]["terms"]["rounds_included"] == 3
    assert "includes 3 rounds of changes" in words_of(sent).replace("**", "")
    redlining.contracts.accept(sent, world.designer, "N. Designer")
    assert redlining.contracts.accept(sent, world.producer, "P. Producer")["state"] == "agreed"

    def counted(session: Session) -> int:
        return terms_of(session, contract_by_id(session, UUID(sent["id"]))).rounds_included

    assert world.server.in_database(counted) == 3


@pytest.mark.slow
@pytest.mark.parametrize(
    ("key", "old", "new", "figure"),
    [
        ("rounds", "{rounds_included} rounds", "a few rounds", "rounds_included"),
        ("rounds", "{rounds_included} rounds", "unlimited rounds", "rounds_included"),
        ("payment", "within {payment_days} days of", "within three weeks of", "payment_days"),
        ("kill_fee", "{kill_fee_in_work_bp}", "all of it", "kill_fee_in_work_bp"),
        ("payment_plan", "{total}", "USD 5,000.00", "total"),
        ("termination", "{deposit_at_end}", "The deposit goes back.", "deposit_at_end"),
    ],
)
def test_a_figure_that_is_no_longer_said_is_refused(redlining: Redlining, key: str, old: str, new: str, figure: str):
    text = redlining.clause(key)["text"]
    assert old in text
    refused = redlining.try_to_propose(redlining.replace(key, text.replace(old, new)))
    assert refusal(refused)[:2] == (422, "bad-redlines")
    (problem,) = refused.json()["errors"]
    assert problem["where"] == "changes.0"
    assert f"{{{figure}}}" in problem["message"]


@pytest.mark.slow
def test_a_needed_figure_cannot_be_struck_or_contradicted_elsewhere(world: World, redlining: Redlining):
    struck = redlining.try_to_propose({"kind": "strike", "clause_key": "rounds"})
    assert refusal(struck)[:2] == (422, "bad-redlines")
    assert struck.json()["errors"][0]["where"] == "changes.0"
    assert "{rounds_included}" in struck.json()["errors"][0]["message"]
    beside = {"kind": "insert", "after_key": "rounds", "title": "Extra", "text": "A cue has three rounds."}
    contradicted = redlining.try_to_propose(beside)
    assert "“three rounds” is typed" in contradicted.json()["errors"][0]["message"]
    redlining.contracts.ask(world.producer, "POST", f"{redlining.path}/recall", json={"reason": "A slip."})
    draft = redlining.draft()
    typed = [
        row | {"text": row["text"].replace("{rounds_included}", "3")} if row["key"] == "rounds" else row
        for row in draft["version"]["clauses"]
    ]
    body = redlining.contracts.draft_of(draft, clauses=typed) | {"based_on_version": draft["version"]["number"]}
    unsaved = world.producer.put(f"/v1{redlining.path}/draft", json=body)
    assert refusal(unsaved)[:2] == (422, "bad-draft")
    assert "{rounds_included}" in unsaved.json()["detail"]


@pytest.mark.slow
def test_a_text_that_contradicts_its_figures_is_neither_sent_nor_signed(world: World, redlining: Redlining):
    def type_over(session: Session) -> None:
        version = version_by_number(session, UUID(redlining.sent["id"]), redlining.sent["version"]["number"])
        assert version is not None
        version.clauses = [
            row | {"text": row["text"].replace("{rounds_included}", "3")} if row["key"] == "rounds" else row
            for row in version.clauses
        ]

    world.server.in_database(type_over)
    body = {"name": "N. Designer", "text_sha256": redlining.sent["version"]["text_sha256"]}
    unsigned = world.designer.post(f"/v1{redlining.path}/accept", json=body)
    assert refusal(unsigned)[:2] == (422, "bad-draft")
    assert "{rounds_included}" in unsigned.json()["detail"]
    redlining.contracts.ask(world.producer, "POST", f"{redlining.path}/recall", json={"reason": "A slip."})
    unsent = world.producer.post(f"/v1{redlining.path}/send", json={})
    assert refusal(unsent)[:2] == (422, "bad-draft")
    assert "nothing was sent" in unsent.json()["detail"]
    rows = [  # what the refusal advises
        redlining.clause("rounds") if row["key"] == "rounds" else row for row in redlining.draft()["version"]["clauses"]
    ]
    redlining.contracts.save(redlining.draft(), clauses=rows)
    redlining.contracts.send(redlining.draft())


@pytest.mark.slow
def test_the_last_answer_counts_and_undoes_the_one_before(redlining: Redlining):
    before = redlining.draft()["version"]["clauses"]
    redlining.propose(redlining.replace("warranty", "Own work."), INSERTED, STRUCK)
    for number in (1, 2, 3):
        redlining.answer(number, "accepted")
    redlining.answer(2, "countered", title="Tea", text="At five.")
    own = next(row for row in redlining.draft()["version"]["clauses"] if row["title"] == "Tea")
    assert own["text"] == "At five."
    for number in (1, 2, 3):
        redlining.answer(number, "refused", comment="On reflection, no.")
    assert redlining.draft()["version"]["clauses"] == before


@pytest.mark.slow
def test_an_agreed_clause_that_was_edited_afterwards_is_not_sent(world: World, redlining: Redlining):
    redlining.propose(redlining.replace("warranty", "Own work."))
    redlining.answer(1, "accepted")
    draft = redlining.draft()
    rows = [row | {"text": "Any work."} if row["key"] == "warranty" else row for row in draft["version"]["clauses"]]
    redlining.contracts.save(draft, clauses=rows)
    unsent = world.producer.post(f"/v1{redlining.path}/send", json={})
    assert refusal(unsent)[:2] == (409, "redlines-open")
    assert unsent.json()["fix"].startswith("answer it again on the page Redlines")
    redlining.answer(1, "accepted")  # the advice works
    assert "Own work." in words_of(redlining.contracts.send(redlining.draft()))


@pytest.mark.slow
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
    twice = redlining.try_to_propose(redlining.replace("warranty", "A."), {"kind": "strike", "clause_key": "warranty"})
    assert twice.json()["errors"][0]["message"] == "the clause Originality is changed twice"
    same = redlining.try_to_propose(redlining.replace("rounds", redlining.clause("rounds")["text"]))
    assert same.json()["errors"][0]["message"] == "nothing of Rounds is changed"
    rows = redlining.sent["version"]["clauses"]
    none_left = redlining.try_to_propose(
        *({"kind": "strike", "clause_key": row["key"]} for row in rows if row["stands"])
    )
    assert "no clause would be left" in none_left.json()["errors"][0]["message"]


@pytest.mark.slow
def test_answers_that_mean_nothing_are_refused(redlining: Redlining):
    redlining.propose(redlining.replace("warranty", "Own work."))
    for body, words in (
        ({"answer": "refused"}, "say why it is refused"),
        ({"answer": "countered", "title": "Originality", "text": "Own work."}, "this is what was proposed; accept it"),
        ({"answer": "countered", "title": "Originality", "text": "{round}"}, "there is no variable {round}"),
    ):
        refused = redlining.try_to_answer(1, **body)
        assert refusal(refused)[:2] == (422, "bad-redlines")
        assert words in refused.json()["detail"]
    assert refusal(redlining.try_to_answer(2, "accepted"))[:2] == (404, "redline-not-found")


@pytest.mark.slow
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


@pytest.mark.slow
def test_each_does_their_own_part(world: World, redlining: Redlining):
    change = redlining.replace("warranty", "Own work.")
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


@pytest.mark.slow
def test_changes_of_a_text_that_stands_no_more_are_kept_back(redlining: Redlining):
    old = redlining.sent["version"]["number"]
    redlining.contracts.ask(redlining.world.producer, "POST", f"{redlining.path}/recall", json={"reason": "A slip."})
    redlining.contracts.send(redlining.sent)
    stale = redlining.try_to_propose(redlining.replace("warranty", "Own work."), version=old)
    assert refusal(stale)[:2] == (409, "text-changed")


@pytest.mark.slow
def test_a_second_round_counts_on(world: World, redlining: Redlining):
    redlining.propose(redlining.replace("warranty", "Own work."))
    redlining.answer(1, "refused", comment="Two.")
    redlining.sent = redlining.contracts.send(redlining.draft())
    redlining.propose(redlining.replace("warranty", "Licensed work."), note="Half way?")
    read = redlining.contracts.ask(world.producer, "GET", f"{redlining.path}/redlines")
    assert (read["rounds"], read["round"]["number"], read["round"]["note"]) == (2, 2, "Half way?")
    assert [one["redline"]["number"] for one in read["round"]["clauses"] if one["redline"]] == [2]
    first = redlining.contracts.ask(world.designer, "GET", f"{redlining.path}/redlines", params={"round": 1})
    assert (first["round"]["number"], first["round"]["unanswered"], first["may_answer"]) == (1, 0, False)
    assert refusal(redlining.try_to_answer(1, "accepted"))[:2] == (404, "redline-not-found"), "its round is closed"


@pytest.mark.slow
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


def test_previews_that_still_run_keep_nobody_from_sending(world: World, redlining: Redlining):
    with PREVIEWS.of(world.designer_id), PREVIEWS.of(world.designer_id):
        preview = world.designer.post(f"/v1{redlining.path}/redline-preview", json={"changes": [STRUCK]})
        assert (preview.status_code, "previews of redlines" in preview.text) == (429, True)
        redlining.propose(STRUCK)
    assert redlining.draft()["state"] == "draft"
