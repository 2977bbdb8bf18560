"""What a studio keeps, takes out and brings in."""

import string

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.agreements.clauses.rules import Clause, default_clauses
from app.agreements.clauses.template_files import parse_toml, write_toml
from app.agreements.clauses.templates import library_toml
from app.agreements.errors import BadTemplate
from app.agreements.rules import ContractKind
from tests.app.agreements.conftest import Contracts, words_of
from tests.support.server import World

ANY = st.text(st.characters(blacklist_categories=["Cs"], blacklist_characters="\r"), max_size=80)
KEYS = st.text(string.ascii_lowercase, min_size=1, max_size=8)


@pytest.mark.parametrize("kind", ContractKind)
def test_the_library_comes_back_from_its_file(kind: ContractKind):
    clauses, terms = default_clauses(kind)
    assert parse_toml(library_toml(kind))[1:] == (kind, [clause.as_row() for clause in clauses], terms)


@pytest.mark.slow
@given(KEYS, ANY, ANY, st.booleans(), st.dictionaries(KEYS, st.integers(0, 2**53) | ANY, max_size=3))
def test_whatever_is_written_is_read_again(key: str, title: str, text: str, stands: bool, terms: dict[str, int | str]):
    clause = Clause(key, title.strip(), text.strip(), stands)
    toml = write_toml("A template", ContractKind.SINGLE, [clause], terms)
    assert parse_toml(toml) == ("A template", ContractKind.SINGLE, [clause.as_row()], terms)


WHOLE = 'format = 1\nname = "x"\nkind = "nda"\n'


@pytest.mark.parametrize(
    ("toml", "words"),
    [
        ("format = ", "the template is not TOML"),
        ("format = 2\nname = 'x'\nkind = 'nda'\nclauses = []", "reads format 1"),
        (WHOLE, "clauses is missing"),
        (WHOLE + "clauses = 3", "wanted a list of tables"),
        (WHOLE + "clause = []\nclauses = []", "there is no key clause here"),
        (WHOLE.replace("nda", "lease") + "clauses = []", "'lease'; wanted one of nda, framework"),
        (WHOLE + "[terms]\na = 1.5\n[[clauses]]\nkey = 'a'\ntitle = 'A'\ntext = 'x'", "whole numbers and texts"),
        (WHOLE + "[[clauses]]\nkey = 'a'\ntext = 'x'", "clause 1: title is missing"),
        (WHOLE + "[[clauses]]\nkey = 'a'\ntitle = 3\ntext = 'x'", "clause 1: title is 3"),
        (WHOLE + "[[clauses]]\nkey = 'a'\ntitle = 'A'\ntext = 'x'\nstands = 1", "clause 1: stands is 1"),
    ],
)
def test_a_file_that_is_not_a_template_is_refused_with_a_reason(toml: str, words: str):
    with pytest.raises(BadTemplate, match=words):
        parse_toml(toml)


@pytest.mark.slow
def test_kept_taken_out_changed_and_brought_in(world: World, contracts: Contracts):
    begun = contracts.begin()
    rows = [row | {"text": "Between us."} if row["key"] == "parties" else row for row in begun["version"]["clauses"]]
    contracts.save(begun, clauses=rows)
    kept = contracts.ask(world.producer, "POST", f"/contracts/{begun['id']}/template", json={"name": "House style"})
    assert words_of(contracts.begin(template_id=kept["id"])).count("Between us.") == 1
    path = f"/studios/{world.studio_id}/contract-templates"
    toml = contracts.ask(world.producer, "GET", f"{path}/{kept['id']}/template.toml").decode()
    assert "Between us." in contracts.ask(world.producer, "GET", f"{path}/{kept['id']}/template.md").decode()
    taken = world.producer.post(f"/v1{path}/import", json={"toml": toml})
    assert (taken.status_code, taken.json()["code"]) == (409, "template-name-taken")
    brought = contracts.ask(world.producer, "POST", f"{path}/import", json={"toml": toml, "name": "Brought in"})
    assert (brought["clauses"], brought["terms"]) == (kept["clauses"], kept["terms"])
    change = {"name": "House style", "clauses": rows[:1], "terms": {}}
    assert len(contracts.ask(world.producer, "PUT", f"{path}/{kept['id']}", json=change)["clauses"]) == 1
    contracts.ask(world.producer, "DELETE", f"{path}/{brought['id']}")
    assert [each["name"] for each in contracts.ask(world.producer, "GET", path)] == ["House style"]
    assert words_of(contracts.ask(world.producer, "GET", f"/contracts/{begun['id']}")).count("Between us.") == 1


def test_a_template_with_faults_is_not_kept(world: World):
    body = {"name": "x", "kind": "single", "terms": {}, "clauses": [{"key": "a", "title": "A", "text": "{nobody}"}]}
    refused = world.producer.post(f"/v1/studios/{world.studio_id}/contract-templates", json=body)
    assert refused.status_code == 422
    assert refused.json()["errors"][0]["where"] == "clauses.a"


@pytest.mark.slow
def test_another_studio_has_its_own(world: World, contracts: Contracts):
    kept = contracts.ask(
        world.producer, "POST", f"/contracts/{contracts.begin()['id']}/template", json={"name": "Ours"}
    )
    path = f"/v1/studios/{world.studio_id}/contract-templates/{kept['id']}"
    assert world.stranger.get(path).status_code == 404
    assert world.designer.get(path).status_code == 404
    (elsewhere,) = (each["id"] for each in world.stranger.get("/v1/me").json()["studios"])
    assert world.stranger.get(f"/v1/studios/{elsewhere}/contract-templates/{kept['id']}").status_code == 404
