"""Refusals of templates and Word documents, each followed by the act that its text advises."""

import base64
from typing import Any

import sqlalchemy as sa

from app.agreements.clauses.templates import MAX_TEMPLATES
from app.agreements.models import ContractTemplate
from app.agreements.rules import ContractKind
from app.agreements.word.document import word_document
from tests.app.agreements.test_hostile_word_files import REFUSALS
from tests.app.agreements.word_files import parts_of, with_parts
from tests.app.amendments.refusal_parties import Parties, advised, granted, scene

FILES, KEPT = "agreements.clauses.template_files", "agreements.clauses.templates"
NUMBERED = "agreements.word.file."
CLAUSES = 'format = 1\nname = "x"\nkind = "nda"\nclauses = {}\n'


def templates(parties: Parties) -> str:
    return f"/v1/studios/{parties.world.studio_id}/contract-templates"


@scene(
    *(f"{FILES}.parse_toml BadTemplate {number}" for number in range(1, 7)),
    *(f"{FILES}._clause BadTemplate {number}" for number in (1, 2, 3)),
    *(f"{FILES}._ensure_keys BadTemplate {number}" for number in (1, 2)),
)
def _a_template_is_as_the_example(parties: Parties) -> None:
    def bring_in(toml: str, name: str | None = None) -> Any:
        return parties.producer.post(f"{templates(parties)}/import", json={"toml": toml, "name": name})

    example = granted(parties.producer.get("/v1/contract-library/nda/template.toml")).decode()
    faults = {
        "format = ": ("export a template as TOML to see an example",),
        example.replace("format = 1", "format = 2"): ("format is 2", "this version reads format 1"),
        example.replace('kind = "nda"', 'kind = "lease"'): ("kind is 'lease'", "wanted one of nda, framework"),
        CLAUSES.format("[]").replace('"x"', '""'): ("name: wanted a text of 1 to 120 characters",),
        example.replace("[terms]", "[terms]\nx = 1.5"): ("terms: wanted a table of whole numbers and texts",),
        CLAUSES.format("3"): ("wanted a list of tables, each under [[clauses]]",),
        CLAUSES.format("[3]"): ("clause 1: wanted a table",),
        example.replace("stands = true", "stands = 1", 1): ("stands is 1", "wanted true or false"),
        CLAUSES.format('[{key = "a", title = 3, text = "x"}]'): ("title is 3", "wanted a text"),
        f"colour = 1\n{example}": ("there is no key colour here", "known are clauses, format"),
        CLAUSES.format("[]").replace("clauses = []", ""): ("clauses is missing",),
    }
    for toml, words in faults.items():
        advised(bring_in(toml), "bad-template", *words)
    granted(bring_in(example))
    granted(bring_in(CLAUSES.format('[{key = "a", title = "A", text = "x", stands = true}]'), "As the words say"))


@scene(
    f"{KEPT}.save_template BadTemplate 1",
    f"{KEPT}.save_template BadTemplate 2",
    f"{KEPT}.save_template TemplateNameTaken",
    f"{KEPT}.change_template BadTemplate",
    f"{KEPT}.change_template TemplateNameTaken",
)
def _a_template_is_kept_under_a_name_of_its_own(parties: Parties) -> None:
    path = templates(parties)

    def row(text: str) -> list[dict[str, Any]]:
        return [{"key": "a", "title": "A", "text": text, "stands": True}]

    def keep(name: str, text: str = "Between us.") -> Any:
        return parties.producer.post(path, json={"name": name, "kind": "nda", "clauses": row(text), "terms": {}})

    def change(template: dict[str, Any], name: str, text: str = "Between us.") -> Any:
        body = {"name": name, "clauses": row(text), "terms": {}}
        return parties.producer.put(f"{path}/{template['id']}", json=body)

    advised(keep("Ours", ""), "bad-template", "the clause is empty; write its text, or remove it")
    first = granted(keep("Ours"))
    advised(keep("Ours"), "template-name-taken", "give this one another name")
    second = granted(keep("Theirs"))
    advised(change(second, "Ours"), "template-name-taken", "give this one another name")
    advised(change(second, "Third", ""), "bad-template", "the clause is empty; write its text, or remove it")
    granted(change(second, "Third"))
    tenant = {"studio_id": parties.world.studio_id, "created_by": parties.world.producer_id}
    many = [{**tenant, "name": f"N{n}", "kind": ContractKind.NDA, "clauses": [], "terms": {}} for n in range(2, 200)]
    parties.world.server.in_database(lambda session: session.execute(sa.insert(ContractTemplate), many))
    advised(keep("One more"), "bad-template", f"at most {MAX_TEMPLATES} templates", "delete one that is not used")
    granted(parties.producer.delete(f"{path}/{first['id']}"))
    granted(keep("One more"))


def upload(parties: Parties, contract: dict[str, Any], document: bytes | str) -> Any:
    content = document if isinstance(document, str) else base64.b64encode(document).decode()
    return parties.post(parties.designer, contract, "redlines/word", content_base64=content)


def taken_out(parties: Parties, contract: dict[str, Any]) -> bytes:
    number = contract["version"]["number"]
    document: bytes = granted(parties.designer.get(f"/v1/contracts/{contract['id']}/versions/{number}/contract.docx"))
    return document


@scene(
    f"{NUMBERED}parse_word_file BadWordFile",
    *(
        f"{NUMBERED}{name} BadWordFile {n}"
        for name in ("read_word_file", "_ensure_small", "_main_part", "_read")
        for n in (1, 2, 3)
    ),
    f"{NUMBERED}_read BadWordFile 4",
    *(f"{NUMBERED}{name} BadWordFile" for name in ("_relations", "start", "_refuse_doctype")),
)
def _a_file_is_saved_again_as_a_word_document(parties: Parties) -> None:
    sent = parties.sent()
    advised(upload(parties, sent, "%%%"), "bad-word-file", "send the bytes of the file in Base64")
    fixes = {
        "a zip bomb": "remove its pictures, then save it again",
        "linked picture": "Break Link, then save it again",
        "linked comments": "Break Link, then save it again",
        "doc": "without a password",
        **dict.fromkeys(("elements", "paragraphs", "characters"), "cut the contract into several"),
    }
    for name, (made, words) in REFUSALS.items():
        refused = upload(parties, sent, made())
        advised(refused, "bad-word-file", words, fixes.get(name, "save it as a Word document (.docx), and upload that"))
    granted(upload(parties, sent, taken_out(parties, sent)))


@scene(
    "agreements.redlines.service.changes_of_word_file OtherContractsFile 1",
    "agreements.redlines.service.changes_of_word_file OtherContractsFile 2",
    "agreements.word.reading.result OtherContractsFile",
)
def _a_document_belongs_to_its_contract(parties: Parties) -> None:
    sent, other = parties.sent(), parties.contracts.send(parties.nda())
    document = taken_out(parties, other)
    refused = upload(parties, sent, document)
    advised(refused, "other-contracts-file", "upload it at the contract that it belongs to, or download this one")
    granted(upload(parties, other, document))
    own = taken_out(parties, sent)
    properties = parts_of(own)["docProps/custom.xml"].decode()
    number = sent["version"]["number"]
    assert f">{number}<" in properties
    later = with_parts(own, **{"docProps__custom.xml": properties.replace(f">{number}<", ">99<")})
    advised(upload(parties, sent, later), "other-contracts-file", "download the current version as a Word document")
    stranger = word_document("# Zebras\n\n## 1. Stripes\n\nBlack and white.\n", [])
    advised(upload(parties, sent, stranger), "other-contracts-file", "download the version as a Word document")
    granted(upload(parties, sent, own))
