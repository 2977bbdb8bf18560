"""A text as a Word document: read back it says the same, and its tracked changes lead from one version to the other."""

import io
import zipfile
from datetime import UTC, datetime
from xml.etree import ElementTree as ET

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.agreements.drafts.comparison import lines_of
from app.agreements.word.document import Earlier, Heading, bookmark_of, word_document
from tests.app.agreements.conftest import Contracts
from tests.app.agreements.redlining import Redlining
from tests.support.server import World

W = "{http://schemas.openxmlformats.org/wordprocessingml/2006/main}"
AT = datetime(2026, 11, 20, 9, 30, tzinfo=UTC)
EARLIER = (
    "# Effects\n\n## 1. Rounds\n\nThe price includes 2 rounds of changes.\n\n- One.\n- Two.\n\n## 2. Tea\n\nAt four.\n"
)
LATER = (
    "# Effects\n\n## 1. Rounds\n\nThe price includes three rounds of changes.\n\n- One.\n\n"
    "## 2. Coffee\n\nAt **nine** & <ten>.\n"
)
HEADINGS = [Heading("rounds", "1. Rounds"), Heading("own_coffee_with_a_name_that_is_too_long_for_word", "2. Coffee")]


def body_of(document: bytes) -> ET.Element:
    with zipfile.ZipFile(io.BytesIO(document)) as archive:
        assert archive.testzip() is None
        for name in archive.namelist():
            ET.fromstring(archive.read(name))  # noqa: S314  our own, and every part is well-formed
        body = ET.fromstring(archive.read("word/document.xml")).find(f"{W}body")  # noqa: S314
    assert body is not None
    return body


def lines(document: bytes, *, accepted: bool) -> list[str]:
    """Return the paragraphs after all tracked changes are accepted, or rejected, as Word does."""
    gone, text = ("del", "t") if accepted else ("ins", "delText")
    found: list[str] = []
    for paragraph in body_of(document).iter(f"{W}p"):
        if paragraph.find(f"{W}pPr/{W}rPr/{W}{gone}") is not None:
            continue
        dropped = {run for change in paragraph.iter(f"{W}{gone}") for run in change.iter(f"{W}r")}
        runs = [run for run in paragraph.iter(f"{W}r") if run not in dropped]
        kept = [part.text or "" for run in runs for part in run if part.tag in (f"{W}t", f"{W}{text}")]
        found.append("".join(kept))
    return found


def said(text: str) -> list[str]:
    return [line.text for line in lines_of(text)]


def test_a_version_reads_back_as_it_is():
    document = word_document(LATER, HEADINGS)
    assert lines(document, accepted=True) == said(LATER)
    assert document == word_document(LATER, HEADINGS), "the same text gives the same bytes"
    bold = [run for run in body_of(document).iter(f"{W}r") if run.find(f"{W}rPr/{W}b") is not None]
    assert [run.findtext(f"{W}t") for run in bold] == ["nine"]


def test_a_table_is_one():
    body = body_of(word_document("| Cue | Price |\n|---|---|\n| SW-001 | USD 5 |\n| alone |\n", []))
    rows = [["".join(cell.itertext()) for cell in row.iter(f"{W}tc")] for row in body.iter(f"{W}tr")]
    assert rows == [["Cue", "Price"], ["SW-001", "USD 5"], ["alone", ""]]


def test_each_clause_has_its_bookmark_at_its_heading():
    for document in (word_document(LATER, HEADINGS), word_document(LATER, HEADINGS, Earlier(EARLIER, "A", AT))):
        marked = {
            mark.get(f"{W}name"): "".join(part.text or "" for part in paragraph.iter(f"{W}t"))
            for paragraph in body_of(document).iter(f"{W}p")
            for mark in paragraph.iter(f"{W}bookmarkStart")
        }
        assert marked == {bookmark_of(heading.key): heading.text for heading in HEADINGS}
        assert all(len(name or "") <= 40 for name in marked)


def test_changes_say_who_made_them_and_when():
    body = body_of(word_document(LATER, HEADINGS, Earlier(EARLIER, 'P. "Pro" <ducer>', AT)))
    changes = [change for tag in ("ins", "del") for change in body.iter(f"{W}{tag}")]
    assert {change.get(f"{W}author") for change in changes} == {'P. "Pro" <ducer>'}
    assert {change.get(f"{W}date") for change in changes} == {"2026-11-20T09:30:00Z"}
    ids = [element.get(f"{W}id") for element in body.iter() if element.tag in (f"{W}ins", f"{W}del")]
    assert len(ids) == len(set(ids))
    inserted = ["".join(change.itertext()) for change in body.iter(f"{W}ins")]
    assert "three" in inserted


def test_accepting_gives_the_later_text_and_rejecting_the_earlier_one():
    document = word_document(LATER, HEADINGS, Earlier(EARLIER, "A", AT))
    assert lines(document, accepted=True) == said(LATER)
    assert lines(document, accepted=False) == said(EARLIER)


PARAGRAPHS = st.lists(st.text("ab é&<\x01\x0b\ud800", min_size=1, max_size=12), max_size=6)


@pytest.mark.slow
@given(PARAGRAPHS, PARAGRAPHS)
def test_tracked_changes_lead_from_any_text_to_any_other(old: list[str], new: list[str]):
    earlier, later = ("\n\n".join(["# Effects", *paragraphs]) for paragraphs in (old, new))

    def clean(text: str) -> list[str]:
        return [line.translate({1: "�", 11: "�", 0xD800: "�"}) for line in said(text)]

    document = word_document(later, [], Earlier(earlier, "A", AT))
    assert lines(document, accepted=True) == clean(later)
    assert lines(document, accepted=False) == clean(earlier)


@pytest.mark.slow
def test_both_parties_take_a_version_out_and_only_those_they_see(world: World, contracts: Contracts):
    redlining = Redlining(world, contracts)
    redlining.propose(redlining.replace("warranty", "Own work."))
    redlining.answer(1, "accepted")
    first, draft = redlining.sent["version"]["number"], redlining.draft()["version"]["number"]
    path = f"/v1{redlining.path}/versions"
    for by in (world.producer, world.designer):
        taken = by.get(f"{path}/{first}/contract.docx")
        assert taken.status_code == 200
        assert "version 1.docx" in taken.headers["content-disposition"]
        names = {mark.get(f"{W}name") for mark in body_of(taken.content).iter(f"{W}bookmarkStart")}
        standing = [row for row in redlining.sent["version"]["clauses"] if row["stands"]]
        assert names == {bookmark_of(row["key"]) for row in standing}
    tracked = world.producer.get(f"{path}/{draft}/contract.docx", params={"against": first})
    assert "Own work." in lines(tracked.content, accepted=True)
    assert "Own work." not in lines(tracked.content, accepted=False)


@pytest.mark.slow
@pytest.mark.parametrize("query", ["", "?against=1"])
def test_a_draft_is_the_studios(world: World, contracts: Contracts, query: str):
    redlining = Redlining(world, contracts)
    redlining.propose(redlining.replace("warranty", "Own work."))
    redlining.answer(1, "accepted")
    draft = redlining.draft()["version"]["number"]
    path = f"/v1{redlining.path}/versions"
    assert world.designer.get(f"{path}/{draft}/contract.docx{query}").status_code == 404
    assert world.designer.get(f"{path}/1/contract.docx?against={draft}").status_code == 404
    assert world.reviewer.get(f"{path}/1/contract.docx{query}").status_code == 404
