"""A Word document that comes back over HTTP: out, edited, in, sent as a round of redlines."""

import base64
from typing import Any

import pytest
from httpx import Response
from httpx2 import Client

from tests.app.agreements.conftest import Contracts
from tests.app.agreements.redlining import Redlining, refusal
from tests.app.agreements.word_files import edited, packed, paragraph, run
from tests.support.server import World

pytestmark = pytest.mark.both_databases


class Upload(Redlining):
    """A contract that was sent, and its document."""

    def document(self, version: int | None = None, **query: Any) -> bytes:
        """Take a version out."""
        number = version or self.sent["version"]["number"]
        taken = self.world.designer.get(f"/v1{self.path}/versions/{number}/contract.docx", params=query)
        assert taken.status_code == 200, taken.text
        return taken.content

    def try_to_upload(self, document: bytes, by: Client | None = None) -> Response:
        """Upload a document as the designer."""
        body = {"content_base64": base64.b64encode(document).decode()}
        return (by or self.world.designer).post(f"/v1{self.path}/redlines/word", json=body)

    def upload(self, document: bytes) -> dict[str, Any]:
        """Upload a document and return what it changes."""
        read = self.try_to_upload(document)
        assert read.status_code == 200, read.text
        found: dict[str, Any] = read.json()
        return found


@pytest.fixture
def upload(world: World, contracts: Contracts) -> Upload:
    return Upload(world, contracts)


@pytest.mark.slow
def test_its_changes_are_a_draft_that_is_sent_as_if_typed(upload: Upload):
    tea = paragraph("9. Tea", "Heading2") + paragraph("At four.")
    document = edited(
        upload.document(),
        ("2 rounds", "4 rounds"),
    )
    document = edited(
        document,
        (
            '<w:p><w:pPr><w:pStyle w:val="Heading2"/></w:pPr><w:bookmarkStart w:id="2"',
            tea + '<w:p><w:pPr><w:pStyle w:val="Heading2"/></w:pPr><w:bookmarkStart w:id="2"',
        ),
    )
    read = upload.upload(document)
    assert read["findings"] == []
    assert upload.contracts.entries(upload.sent)[-1]["kind"] == "sent", "nothing was sent"
    by_key = {change["clause_key"]: change for change in read["changes"]}
    assert by_key["rounds"]["terms"] == {"rounds_included": 4}
    assert by_key["rounds"]["text"] == upload.clause("rounds")["text"]
    assert (by_key[None]["title"], by_key[None]["text"]) == ("Tea", "At four.")
    assert by_key.keys() == {"rounds", None}
    proposed = upload.propose(*read["changes"], note=read["note"])
    assert proposed["unanswered"] == 2


@pytest.mark.slow
def test_a_number_in_words_is_the_new_value_of_its_field(upload: Upload):
    read = upload.upload(edited(upload.document(), ("2 rounds", "three rounds")))
    (change,) = read["changes"]
    assert change["terms"] == {"rounds_included": 3}
    assert change["text"] == upload.clause("rounds")["text"]
    assert "read as its new value: 3" in read["findings"][0]["message"]
    upload.propose(change)
    upload.answer(1, "accepted")
    assert upload.contracts.send(upload.draft())["version"]["terms"]["rounds_included"] == 3


@pytest.mark.slow
def test_a_document_that_nobody_edited_proposes_nothing(upload: Upload):
    read = upload.upload(upload.document())
    assert read == {"version": 1, "changes": [], "note": "", "findings": []}


@pytest.mark.slow
def test_a_document_of_an_earlier_version_names_what_changed_since(upload: Upload):
    first, about = upload.document(), upload.clause("about")["title"]
    upload.propose(upload.replace("rounds", upload.clause("rounds")["text"] + "\n\nEach is asked for in writing."))
    upload.answer(1, "accepted")
    upload.sent = upload.contracts.send(upload.sent)
    number = upload.sent["version"]["number"]
    read = upload.upload(edited(first, ("2 rounds", "3 rounds"), (run(f"1. {about}"), run("1. Both parties"))))
    assert [change["title"] for change in read["changes"]] == ["Both parties"]
    assert [finding["clause_key"] for finding in read["findings"]] == ["rounds"]
    assert "was changed after version 1" in read["findings"][0]["message"]
    tracked = upload.upload(upload.document(against=1))
    assert (tracked["version"], tracked["changes"], tracked["findings"]) == (number, [], [])


@pytest.mark.slow
def test_who_may_not_propose_may_not_upload(upload: Upload, world: World):
    document = upload.document()
    assert upload.try_to_upload(document, world.reviewer).status_code == 404
    assert upload.try_to_upload(document, world.producer).json()["code"] == "not-your-contract"
    upload.world.producer.post(f"/v1{upload.path}/recall", json={"reason": "Wait."})
    assert upload.try_to_upload(document).json()["code"] == "wrong-state"


@pytest.mark.slow
def test_a_document_of_another_contract_is_refused(upload: Upload, world: World, contracts: Contracts):
    other = Upload(world, contracts)
    code = refusal(upload.try_to_upload(other.document()))
    assert code == (422, "other-contracts-file", "the file was made from another contract")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("document", "detail"),
    [
        (b"%PDF-1.7", "this is a PDF; wanted a Word document (.docx)"),
        (packed({"xl/workbook.xml": "x"}), "this is an Excel workbook; wanted a Word document (.docx)"),
    ],
)
def test_another_kind_of_file_is_refused_in_words(upload: Upload, document: bytes, detail: str):
    refused = upload.try_to_upload(document)
    assert refusal(refused) == (422, "bad-word-file", detail)
    assert ".docx" in refused.json()["fix"]


def test_a_file_that_is_too_large_is_refused_before_it_is_read(upload: Upload):
    assert upload.try_to_upload(b"PK\x03\x04" + b"\0" * (7 << 20)).status_code == 413


@pytest.mark.slow
def test_what_is_no_base64_is_refused(upload: Upload):
    refused = upload.world.designer.post(f"/v1{upload.path}/redlines/word", json={"content_base64": "é"})
    assert refusal(refused)[:2] == (422, "bad-word-file")
