"""Files that strangers send as Word documents: read, or refused in words, and the server goes on."""

import base64
import contextlib
import io
import random
import zipfile
from collections.abc import Callable, Iterator

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app import registry
from app.agreements.errors import BadWordFile
from app.agreements.word.document import word_document
from app.agreements.word.file import WordText, parse_word_file, read_word_file
from app.core.parsing import Parsers
from tests.app.agreements.word_files import (
    RELATIONS,
    WORD,
    body_xml,
    packed,
    paragraph,
    parts_of,
    run,
    with_parts,
)

GOOD = word_document("# Effects\n\n## 1. Rounds\n\nTwo.\n", [])
DOCUMENT = f'<w:document xmlns:w="{WORD}"><w:body>{{}}</w:body></w:document>'
PACKAGE = "http://schemas.openxmlformats.org/package/2006/relationships"


@pytest.fixture(scope="module")
def parsers() -> Iterator[Parsers]:
    made = Parsers()
    made.connect(registry.PARSERS)
    yield made
    made.close()


def in_base64(data: bytes) -> str:
    return base64.b64encode(data).decode()


def with_body(xml: str) -> bytes:
    return with_parts(GOOD, **{"word__document.xml": DOCUMENT.format(xml)})


def with_relation(kind: str, target: str, mode: str = ' TargetMode="External"') -> bytes:
    relation = f'<Relationship Id="rId9" Type="{RELATIONS}/{kind}" Target="{target}"{mode}/>'
    part = f'<Relationships xmlns="{PACKAGE}">{relation}</Relationships>'
    return with_parts(GOOD, **{"word___rels__document.xml.rels": part})


def twice_named() -> bytes:
    file = io.BytesIO(GOOD)
    with zipfile.ZipFile(file, "a") as archive, pytest.warns(UserWarning, match="Duplicate"):
        archive.writestr("word/document.xml", DOCUMENT.format(paragraph("Another text.")))
    return file.getvalue()


ENTITIES = '<!DOCTYPE w [<!ENTITY a "aaaaaaaaaa">' + "".join(
    f'<!ENTITY {name} "{f"&{before};" * 10}">' for before, name in zip("abcdefgh", "bcdefghi", strict=True)
)


REFUSALS: dict[str, tuple[Callable[[], bytes], str]] = {
    "empty": (lambda: b"", "the file is empty"),
    "pdf": (lambda: b"%PDF-1.7\n", "this is a PDF; wanted a Word document (.docx)"),
    "rtf": (lambda: b"{\\rtf1 x}", "this is an RTF file"),
    "doc": (lambda: b"\xd0\xcf\x11\xe0" + b"\0" * 600, "an old .doc file, or one with a password"),
    "html": (lambda: b"<html>", "this is a page or an XML file"),
    "letters": (lambda: b"no zip at all", "this is not a Word document that can be read"),
    "cut": (lambda: GOOD[:-40], "this is not a Word document that can be read"),
    "xlsx": (lambda: packed({"xl/workbook.xml": "<a/>"}), "this is an Excel workbook"),
    "odt": (lambda: packed({"mimetype": "x", "content.xml": "<a/>"}), "this is an OpenDocument file"),
    "zip": (lambda: packed({"readme.txt": "x"}), "a ZIP file without a Word document"),
    "entities": (
        lambda: with_parts(
            GOOD, **{"word__document.xml": f"{ENTITIES}]>" + DOCUMENT.format(paragraph("x").replace(">x<", ">&i;<"))}
        ),
        "declares a document type",
    ),
    "a type outside": (
        lambda: with_parts(
            GOOD, **{"word__document.xml": '<!DOCTYPE w SYSTEM "file:///etc/passwd">' + DOCUMENT.format("")}
        ),
        "declares a document type",
    ),
    "an encoding that is none": (
        lambda: with_parts(GOOD, **{"word__document.xml": '<?xml version="1.0" encoding="UTyes"?><a/>'}),
        "in an encoding that cannot be read",
    ),
    "a zip bomb": (
        lambda: packed({**parts_of(GOOD), "word/media/a.bin": b"\0" * 101_000_000}),
        "may unpack to 100,000,000",
    ),
    "a large part": (
        lambda: with_body("<w:p/>" + " " * 30_000_000),
        "the part word/document.xml may have 30,000,000 bytes, and has more",
    ),
    "parts": (
        lambda: packed({**parts_of(GOOD), **{f"x{at}": b"" for at in range(2_000)}}),
        "a document may have 2,000 parts",
    ),
    "nested": (lambda: with_body("<w:p>" * 300 + "</w:p>" * 300), "more than 200 elements inside one another"),
    "elements": (lambda: with_body("<w:p/>" * 200_001), "a document may have 200,000 elements"),
    "paragraphs": (lambda: with_body(paragraph("x") * 10_001), "a document may have 10,000 paragraphs"),
    "characters": (lambda: with_body(paragraph("x" * 1_000) * 201), "a document may have 200,000 characters"),
    "not closed": (lambda: with_body("<w:p>"), "the part word/document.xml is damaged"),
    "linked picture": (
        lambda: with_relation("image", "https://tracker.example/x.png"),
        "takes a part from outside of the file",
    ),
    "linked comments": (
        lambda: with_relation("comments", "\\\\host\\share\\c.xml"),
        "takes a part from outside of the file",
    ),
    "two of one name": (twice_named, "word/document.xml is in the file 2 times"),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", list(REFUSALS))
def test_it_is_refused_with_what_was_found_and_what_to_do(name: str):
    made, words = REFUSALS[name]
    with pytest.raises(BadWordFile) as refusal:
        read_word_file(made())
    assert words in refusal.value.message
    assert refusal.value.fix


@pytest.mark.slow
@pytest.mark.parametrize("name", ["pdf", "entities", "nested", "a zip bomb", "linked picture"])
def test_the_child_says_the_same(parsers: Parsers, name: str):
    made, words = REFUSALS[name]
    with pytest.raises(BadWordFile) as refusal:
        parsers.call(parse_word_file, in_base64(made()), refusal=BadWordFile)
    assert words in refusal.value.message


def test_what_a_link_or_a_path_names_is_never_opened():
    linked = with_relation("hyperlink", "https://tracker.example/")
    assert [line.text for line in read_word_file(linked).lines][-1] == "Two."
    outside = with_relation("comments", "../../../../etc/passwd", mode="")
    assert read_word_file(outside).comments == ()


def test_a_document_part_of_another_name_is_found_by_its_relation():
    parts: dict[str, bytes | str] = dict(parts_of(GOOD))
    parts["word/document2.xml"] = parts.pop("word/document.xml")
    top = parts["_rels/.rels"]
    assert isinstance(top, bytes)
    parts["_rels/.rels"] = top.decode().replace("word/document.xml", "/word/document2.xml")
    assert [line.text for line in read_word_file(packed(parts)).lines] == ["Effects", "1. Rounds", "Two."]


def test_what_the_child_says_is_the_document(parsers: Parsers):
    with contextlib.suppress(BadWordFile):
        parsers.call(parse_word_file, in_base64(with_body("<w:p>" * 100_000)), refusal=BadWordFile)
    assert WordText.of(parsers.call(parse_word_file, in_base64(GOOD), refusal=BadWordFile)) == read_word_file(GOOD)


@pytest.mark.slow
def test_what_says_nothing_is_passed_over():
    inside = '<w:r><w:instrText xml:space="preserve"> DATE </w:instrText></w:r>' + run("Two")
    inside += (
        '<w:r><w:tab/></w:r><w:r><w:noBreakHyphen/></w:r><w:hyperlink w:anchor="x">' + run("three") + "</w:hyperlink>"
    )
    inside += (
        '<w:r><mc:AlternateContent xmlns:mc="m"><mc:Fallback><w:t>twice</w:t></mc:Fallback></mc:AlternateContent></w:r>'
    )
    read = read_word_file(
        with_body(f"<w:p>{inside}</w:p><w:sdt><w:sdtContent>{paragraph('In a form.')}</w:sdtContent></w:sdt>")
    )
    assert [line.text for line in read.lines] == ["Two -three", "In a form."]


@settings(max_examples=40, deadline=None)
@given(st.integers(0, 2**32))
def test_mutants_are_read_or_refused(seed: int):
    chance = random.Random(seed)
    xml = bytearray(body_xml(GOOD).encode())
    for _ in range(chance.randrange(1, 8)):
        place = chance.randrange(len(xml))
        match chance.randrange(3):
            case 0:
                xml[place] = chance.randrange(256)
            case 1:
                del xml[place : place + chance.randrange(20)]
            case _:
                xml[place:place] = chance.choice(
                    [b"<w:del>", b"</w:p>", b"<w:tbl>", b"<w:tc>", b"&#0;", b"</w:r>", b"\xff"]
                )
    zipped = bytearray(with_parts(GOOD, **{"word__document.xml": bytes(xml)}))
    if chance.random() < 0.3:
        zipped[chance.randrange(len(zipped))] = chance.randrange(256)
    with contextlib.suppress(BadWordFile):
        assert isinstance(read_word_file(bytes(zipped)), WordText)
