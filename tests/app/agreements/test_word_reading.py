"""A Word document that comes back: out, edited as Word does, in; the changes are the edits and nothing else."""

import random
import re
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.agreements.clauses import rules as clauses
from app.agreements.clauses.edits import edited_clause
from app.agreements.clauses.rules import Clause, filler, library, render
from app.agreements.clauses.source import SourceLine, lines_with_places
from app.agreements.clauses.text import Span, blocks_of, plain
from app.agreements.drafts.comparison import lines_of
from app.agreements.errors import OtherContractsFile
from app.agreements.redlines.marks import clauses_as_sent
from app.agreements.redlines.rules import Change, RedlineKind, Wording
from app.agreements.word.body import WordLine, trimmed
from app.agreements.word.document import Heading, word_document
from app.agreements.word.file import properties_of, read_word_file
from app.agreements.word.reading import MadeFrom, ReadChanges, changes_in
from tests.app.agreements.word_files import (
    RELATIONS,
    TRACKED,
    body_xml,
    comments,
    deleted,
    edited,
    inserted,
    paragraph,
    parts_of,
    rebuilt,
    run,
    tracked_away,
    with_parts,
)

TEXTS = st.text("ab é*|#-{}\\.1\n \t·", max_size=60)


@pytest.mark.parametrize("each", library(), ids=lambda each: each.clause.key)
def test_lines_of_the_library_are_found_where_they_stand(each: Any):
    text = each.clause.text
    found = lines_with_places(text)
    assert [(line.kind, line.text) for line in found] == [(line.kind, line.text.strip()) for line in lines_of(text)]
    for line in found:
        assert all(line.begins <= letter.begins <= letter.ends <= line.ends for letter in line.letters)


@given(TEXTS)
def test_lines_of_any_text_are_found_where_they_stand(text: str):
    def shown(line: str) -> str:
        return line.replace("\t", " ").strip()

    found = [(line.kind, line.text.strip()) for line in lines_with_places(text)]
    said = [(block.kind, one) for block in blocks_of(text) for one in plain(block)]
    if "|" not in text:  # the cells of a row are trimmed by themselves
        assert found == [(kind, shown(one)) for kind, one in said]
    assert [kind for kind, _ in found] == [kind for kind, _ in said]


FACTS = {
    "studio": "Shield Wing studio",
    "designer": "Sound designer",
    "project": r"Alpha \*beta\*",
    "cue_count": "2",
    "cues": "| No. | Cue |\n|---|---|\n| SW-001 | Door |\n| SW-002 | Bell |",
    "open_questions": "- Which door?\n- Which bell?",
    "total": "USD 1,200.00",
}
CLAUSES = [
    Clause(
        "about", "About", "Between {studio} and {designer}, on **{project}**.\n\nIt covers {cue_count} cues:\n\n{cues}"
    ),
    Clause(
        "rounds",
        "Rounds",
        "The price includes {rounds_included} rounds of changes,\nand each is **asked for** at once.\n\n"
        "- One is *short*.\n- Two is long.",
    ),
    Clause("struck", "Not agreed", "Nothing.", stands=False),
    Clause("questions", "Questions", "Open today:\n\n{open_questions}\n\n1. Answer.\n2. Ask."),
    Clause("price", "Price", "{total}, and {extra_round_bp} of it for a further round; {court} decides."),
]
TERMS = {"rounds_included": 2, "extra_round_bp": 2500, "court": "Berlin"}


class Contract:
    """A text that was sent, and what a document of it changes."""

    def __init__(self, clauses: Sequence[Clause] = CLAUSES, sent_facts: dict[str, str] = FACTS) -> None:
        self.clauses = clauses
        self.text = render("Effects", clauses, TERMS, sent_facts, "USD")
        standing = [clause for clause in clauses if clause.stands]
        self.headings = [Heading(one.key, f"{number}. {one.title}") for number, one in enumerate(standing, start=1)]
        self.document = word_document(self.text, self.headings, properties=properties_of("contract", 1, None))

    def read(self, document: bytes) -> ReadChanges:
        """Return what a document changes."""
        made_from = MadeFrom(1, (self.clauses, TERMS), self.text, filler(TERMS, FACTS, "USD"), "USD")
        return changes_in(read_word_file(document), made_from, [clause.key for clause in self.clauses if clause.stands])

    def changes(self, document: bytes) -> dict[str | None, Change]:
        """Return what a document changes, by clause, where nothing is named beside."""
        read = self.read(document)
        assert not read.findings
        return {change.clause_key: change for change in read.changes}

    def source(self, key: str) -> str:
        """Return the Markdown of a clause."""
        return next(clause.text for clause in self.clauses if clause.key == key)


def replaced(key: str, title: str, text: str, **terms: int | str) -> Change:
    return Change(RedlineKind.REPLACE, key, None, Wording(title, text, terms))


def test_a_document_that_nobody_edited_changes_nothing():
    contract = Contract()
    assert contract.changes(contract.document) == {}
    whole = [replace(each.clause, stands=True) for each in library()]
    facts = {name: f"the {name}" for name in clauses.FACTS}
    assert Contract(whole, facts | FACTS).changes(Contract(whole, facts | FACTS).document) == {}


def test_words_typed_into_a_clause_leave_the_rest_of_it_byte_for_byte():
    contract = Contract()
    changed = contract.changes(edited(contract.document, ("at once", "in writing, at once")))
    source = contract.source("rounds").replace("at once", "in writing, at once")
    assert changed == {"rounds": replaced("rounds", "Rounds", source)}


def test_tracked_changes_are_read_as_accepted():
    contract = Contract()
    plain_run = run(" at once.")
    document = edited(contract.document, (plain_run, run(" at ") + deleted("once") + inserted("the end") + run(".")))
    source = contract.source("rounds").replace("at once", "at the end")
    assert contract.changes(document) == {"rounds": replaced("rounds", "Rounds", source)}
    moved = edited(
        contract.document,
        (plain_run, run(" at once") + f"<w:moveTo {TRACKED}>{run(' today')}</w:moveTo>" + run(".")),
        (run("Answer."), f"<w:moveFrom {TRACKED}>{run('Answer.')}</w:moveFrom>" + run("Reply.")),
    )
    assert {key: change.wording.text for key, change in contract.changes(moved).items()} == {
        "rounds": contract.source("rounds").replace("at once", "at once today"),
        "questions": contract.source("questions").replace("1. Answer.", "1. Reply."),
    }


def test_runs_that_word_splits_change_nothing():
    contract = Contract()
    split = run("The pri") + '<w:proofErr w:type="spellStart"/><w:bookmarkStart w:id="7" w:name="_GoBack"/>'
    split += run("ce inc", '<w:lang w:val="en-GB"/>') + run("ludes 2 rounds of changes, and each is ")
    document = edited(contract.document, (run("The price includes 2 rounds of changes, and each is "), split))
    assert contract.changes(document) == {}


def test_a_paragraph_after_a_clause_is_its_last_one():
    contract = Contract()
    added = paragraph("3. No *third* one.") + paragraph("- {none}", "ListBullet")
    document = edited(
        contract.document, (paragraph("Two is long.", "ListBullet"), paragraph("Two is long.", "ListBullet") + added)
    )
    source = contract.source("rounds") + "\n\n3\\. No \\*third\\* one.\n\n- - \\{none\\}"
    assert contract.changes(document) == {"rounds": replaced("rounds", "Rounds", source)}


@pytest.mark.parametrize("is_tracked", [True, False])
def test_a_clause_that_is_deleted_is_struck(is_tracked: bool):
    contract = Contract()

    def without(paragraphs: list[str]) -> list[str]:
        begins = next(at for at, one in enumerate(paragraphs) if "2. Rounds" in one)
        ends = next(at for at, one in enumerate(paragraphs) if "3. Questions" in one)
        gone = [tracked_away(one) for one in paragraphs[begins:ends]] if is_tracked else []
        return [*paragraphs[:begins], *gone, *paragraphs[ends:]]

    read = contract.read(rebuilt(contract.document, without))
    assert read.changes == [Change(RedlineKind.STRIKE, "rounds", None, Wording())]
    named = (
        []
        if is_tracked
        else ["“Rounds” is not in the file, neither its heading nor its text: it is proposed to be struck."]
    )
    assert [finding.message for finding in read.findings] == named


def test_a_value_that_is_edited_is_its_terms_next_value():
    contract = Contract()
    document = edited(contract.document, ("includes 2 rounds", "includes 4 rounds"))
    assert contract.changes(document) == {
        "rounds": replaced("rounds", "Rounds", contract.source("rounds"), rounds_included=4)
    }
    document = edited(contract.document, ("and 25 % of it", "and 12.5 % of it"), ("Berlin decides", "New York decides"))
    assert contract.changes(document) == {
        "price": replaced("price", "Price", contract.source("price"), extra_round_bp=1250, court="New York")
    }


def test_a_value_that_is_no_value_is_written_out_and_named():
    contract = Contract()
    read = contract.read(edited(contract.document, ("includes 2 rounds", "includes a few rounds")))
    source = contract.source("rounds").replace("{rounds_included}", "a few")
    assert list(read.changes) == [replaced("rounds", "Rounds", source)]
    assert ["{rounds_included}" in finding.message for finding in read.findings] == [True]
    read = contract.read(edited(contract.document, ("1,200.00", "1,500.00")))
    assert read.changes[0].wording.text == contract.source("price").replace("{total}", "USD 1,500.00")


def test_a_row_of_a_table_is_edited_and_the_table_written_out():
    contract = Contract()
    read = contract.read(edited(contract.document, (run("Bell"), run("Gong | low"))))
    table = FACTS["cues"].replace("| SW-002 | Bell |", "| SW-002 | Gong \\| low |")
    assert list(read.changes) == [replaced("about", "About", contract.source("about").replace("{cues}", table))]
    assert len(read.findings) == 1


def test_facts_that_changed_since_it_was_sent_are_still_facts():
    contract = Contract(sent_facts=FACTS | {"total": "USD 900.00", "studio": "Another name"})
    assert contract.changes(contract.document) == {}
    document = edited(contract.document, ("decides.", "decides at last."), ("Between ", "Agreed between "))
    assert {key: change.wording.text for key, change in contract.changes(document).items()} == {
        "about": contract.source("about").replace("Between", "Agreed between"),
        "price": contract.source("price").replace("decides.", "decides at last."),
    }


def test_bold_words_are_kept_and_added():
    contract = Contract()
    document = edited(contract.document, (run("Two is long."), run("Two ") + run("is", "<w:b/>") + run(" long.")))
    source = contract.source("rounds").replace("Two is", "Two **is**")
    assert contract.changes(document) == {"rounds": replaced("rounds", "Rounds", source)}
    document = edited(
        contract.document, (run("asked for", "<w:b/>"), run("asked for", '<w:b w:val="0"/><w:color w:val="FF0000"/>'))
    )
    assert contract.changes(document)["rounds"].wording.text == contract.source("rounds").replace("**", "")


def test_a_title_is_edited_and_its_number_is_not_part_of_it():
    contract = Contract()
    document = edited(contract.document, (run("2. Rounds"), run("3. Rounds of changes")))
    assert contract.changes(document) == {"rounds": replaced("rounds", "Rounds of changes", contract.source("rounds"))}
    assert contract.changes(edited(contract.document, (run("2. Rounds"), run("7. Rounds")))) == {}


def test_a_new_clause_is_inserted_where_it_stands():
    contract = Contract()
    new = paragraph("3. Tea", "Heading2") + paragraph("At four.") + paragraph("Milk", "ListBullet")
    document = edited(
        contract.document, (paragraph("Two is long.", "ListBullet"), paragraph("Two is long.", "ListBullet") + new)
    )
    inserted_change = Change(RedlineKind.INSERT, None, "rounds", Wording("Tea", "At four.\n\n- Milk"))
    assert contract.changes(document) == {None: inserted_change}
    before_all = edited(contract.document, (paragraph("Effects", "Heading1"), paragraph("Effects", "Heading1") + new))
    assert contract.changes(before_all)[None].after_key is None


def test_comments_are_those_of_the_proposals():
    contract = Contract()
    marked = (
        '<w:commentRangeStart w:id="{0}"/>{1}<w:commentRangeEnd w:id="{0}"/><w:r><w:commentReference w:id="{0}"/></w:r>'
    )
    document = edited(
        contract.document,
        (run(" at once."), marked.format(0, run(" soon."))),
        (run("Answer."), marked.format(1, run("Answer."))),
    )
    relation = f'<Relationship Id="rId9" Type="{RELATIONS}/comments" Target="comments.xml"/></Relationships>'
    relations = parts_of(document)["word/_rels/document.xml.rels"].decode().replace("</Relationships>", relation)
    said = comments(("0", "A. Lawyer", "Too soon?"), ("1", "A. Lawyer", "Who answers?"))
    read = contract.read(
        with_parts(document, **{"word___rels__document.xml.rels": relations, "word__comments.xml": said})
    )
    assert [(change.clause_key, change.comment) for change in read.changes] == [("rounds", "A. Lawyer: Too soon?")]
    assert read.note == "On Questions: A. Lawyer: Who answers?"


def test_a_clause_without_its_bookmark_is_found_by_its_heading():
    contract = Contract()
    xml = re.sub("<w:bookmark(Start|End)[^>]*>", "", body_xml(contract.document))
    bare = with_parts(contract.document, **{"word__document.xml": xml})
    assert contract.changes(bare) == {}
    changed = contract.changes(edited(bare, ("at once", "soon")))
    assert changed["rounds"].wording.text == contract.source("rounds").replace("at once", "soon")


def test_a_heading_that_is_gone_is_named_and_its_text_is_read():
    contract = Contract()
    document = rebuilt(
        edited(contract.document, ("at once", "soon")),
        lambda paragraphs: [one for one in paragraphs if "2. Rounds" not in one],
    )
    read = contract.read(document)
    assert [finding.message for finding in read.findings] == [
        "The heading of “Rounds” is not in the file, and its text is. Its title is kept."
    ]
    source = contract.source("rounds").replace("at once", "soon")
    assert list(read.changes) == [replaced("rounds", "Rounds", source)]


def test_text_outside_of_clauses_is_named():
    contract = Contract()
    box = f"<w:r><w:pict><w:txbxContent>{paragraph('In a box.')}</w:txbxContent></w:pict></w:r>"
    document = edited(
        contract.document,
        (paragraph("Effects", "Heading1"), paragraph("Effects", "Heading1") + paragraph("Draft of ours.")),
        (run("Two is long."), run("Two is long.") + run("white on white", "<w:vanish/>") + box),
    )
    read = contract.read(document)
    assert not read.changes
    assert [finding.message for finding in read.findings] == [
        "Text before the first clause is not read: “Draft of ours.”",
        "A hidden text is not read: “white on white”",
        "A text box is not read: “In a box.”",
    ]


def test_another_contracts_document_is_refused():
    with pytest.raises(OtherContractsFile):
        Contract().read(Contract([Clause("own_tea", "Tea", "At four.")]).document)


LINES = st.tuples(
    st.sampled_from(["text", "item"]),
    st.lists(
        st.tuples(st.text("ab1é*|#-{}\\. ·", min_size=1, max_size=9), st.booleans(), st.booleans()),
        min_size=1,
        max_size=3,
    ),
)


@pytest.mark.slow
@settings(max_examples=50, deadline=None)
@given(st.lists(LINES, max_size=5), st.integers(0, 2**32))
def test_any_edited_lines_read_back_as_they_were_typed(typed: list[tuple[Any, Any]], seed: int):
    """Lines of a clause stay, go, or are edited in their middle, and any others are added."""
    contract, chance = Contract(), random.Random(seed)
    key = chance.choice(["about", "rounds", "questions", "price"])
    sent = clauses_as_sent(contract.text, contract.clauses)[key].strip()
    source_lines = lines_with_places(sent)
    kept = [line for line in source_lines if chance.random() < 0.7]
    lines = [*map(as_word, kept), *(typed_into(as_word(line), chance) for line in source_lines if line not in kept)]
    for kind, spans in typed:
        lines.insert(
            chance.randrange(len(lines) + 1), WordLine(kind, 0, trimmed([Span(*span) for span in spans]), (), ())
        )
    lines = [line for line in lines if line.text.strip(" ·-:|")]
    edit = edited_clause(
        contract.source(key),
        sent,
        source_lines,
        lines,
        fill=filler(TERMS, FACTS, "USD"),
        currency="USD",
        terms=TERMS,
        is_plain=False,
    )
    filled = filler({**TERMS, **edit.terms}, FACTS, "USD")(edit.source).strip()
    assert [looks(as_word(line)) for line in lines_with_places(filled)] == [looks(line) for line in lines]
    assert all(sent[line.begins : line.ends] in filled for line in kept)


def as_word(line: SourceLine) -> WordLine:
    spans = [Span(letter.letter, letter.strong, letter.emphatic) for letter in line.letters]
    return WordLine(line.kind, 0, tuple(spans), (), ())


def looks(line: WordLine) -> tuple[str, list[tuple[str, bool, bool]]]:
    """Return the characters of a line with their looks; a space has none."""
    letters = [(letter, span.strong, span.emphatic) for span in line.spans for letter in span.text]
    return line.kind, [(letter[0], False, False) if letter[0] in " ·" else letter for letter in letters]


def typed_into(line: WordLine, chance: random.Random) -> WordLine:
    is_row = line.kind == "table"  # whose cells are read without the space around them
    begins, ends = (0, 0) if is_row else sorted(chance.choices(range(len(line.spans) + 1), k=2))
    text = chance.choice(["two ", "x", "*", " {a} ", "- ", "1. ", "USD 7.00"])
    new = [Span(text.strip() if is_row else text, chance.random() < 0.3, False)]
    spans = trimmed([*line.spans[:begins], *new, *line.spans[ends:]])
    return WordLine(line.kind, 0, spans, (), ())
