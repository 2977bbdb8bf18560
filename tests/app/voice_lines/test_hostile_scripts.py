"""What strangers send as a script: refused in words, within the limits of the child that reads it."""

import io
import zipfile

import pytest

from tests.support.server import World
from tests.support.voice import encoded, imported, lines, send, workbook

HEAD = "Line ID,Character,Text\n"


def with_sheet(data: bytes, part: bytes) -> bytes:
    """Return a workbook whose first sheet is another one."""
    out = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(data)) as old, zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as new:
        for entry in old.infolist():
            is_sheet = entry.filename == "xl/worksheets/sheet1.xml"
            new.writestr(entry, part if is_sheet else old.read(entry))
    return out.getvalue()


def refused(world: World, **body: object) -> str:
    answer = send(world, **body)  # type: ignore[arg-type]
    assert (answer.status_code, answer.json()["code"]) == (422, "script-unreadable"), answer.text
    assert lines(world) == {}
    return str(answer.json()["detail"])


@pytest.mark.parametrize(
    ("form", "data"),
    [
        ("xlsx", b"PK\x03\x04 no archive"),
        ("xlsx", b"\xd0\xcf\x11\xe0 old"),
        ("csv", b""),
        ("csv", HEAD.encode() + b"a,Maya,\x00\x01"),
        ("csv", HEAD.encode() + b'a,Maya,"never closed'),
        ("script", b""),
        ("script", b"%PDF-1.7"),
        ("script", b"PK\x03\x04 a document"),
        ("script", b"MAYA\n\x00\x01\x02"),
        ("script", b"only what happens, and nobody speaks"),
        ("script", b"MAYA\nGo.\n\n" * 200_000),
    ],
)
def test_what_is_no_script(world: World, form: str, data: bytes) -> None:
    assert refused(world, format=form, content_base64=encoded(data))


@pytest.mark.slow
def test_a_million_empty_rows_are_nothing(world: World) -> None:
    cell = b'<row r="%d"><c r="A%d" t="inlineStr"><is><t>%s</t></is></c></row>'
    head = b'<worksheet xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"><sheetData>'
    empty = b"".join(b'<row r="%d"/>' % place for place in range(2, 1_000_000))
    plain = workbook([["Line ID", "Character", "Text"], ["m_1", "Maya", "Hello"]])
    far = head + cell % (1, 1, b"Text") + empty + cell % (1_000_000, 1_000_000, b"Hello") + b"</sheetData></worksheet>"
    assert "1,000,000" in refused(world, format="xlsx", content_base64=encoded(with_sheet(plain, far)))
    csv = HEAD + "m_1,Maya,Hello\n" + ",,\n" * 100_000
    assert imported(world, csv)["added"] == 1


@pytest.mark.slow
def test_a_bomb_is_not_unpacked(world: World) -> None:
    plain = workbook([["Line ID", "Character", "Text"]])
    assert "unpack" in refused(world, format="xlsx", content_base64=encoded(with_sheet(plain, b" " * 110_000_000)))


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-16-le", "cp1252"])
@pytest.mark.parametrize("form", ["csv", "script"])
def test_encodings(world: World, encoding: str, form: str) -> None:
    text = HEAD + "m_1,Maya,Größe über alles\n" if form == "csv" else "MAYA [[m_1]]\nGröße über alles\n"
    imported(world, text=None, format=form, content_base64=encoded(text.encode(encoding)))  # type: ignore[arg-type]
    assert lines(world)["m_1"]["text"] == "Größe über alles"


def test_a_damaged_character_is_named_by_its_row(world: World) -> None:
    data = (HEAD + "m_1,Maya,Grüße aus Österreich\nm_2,Maya,Größ").encode()[:-1]
    assert refused(world, format="csv", content_base64=encoded(data)).startswith("row 3:")


@pytest.mark.slow
def test_formulas_and_invisible_characters(world: World) -> None:
    formula = workbook([["Line ID", "Character", "Text"], ["m_1", "Maya", "=HYPERLINK(A1)"]])
    read = send(world, format="xlsx", content_base64=encoded(formula)).json()
    assert read["rows"] == [] or "HYPERLINK" not in read["rows"][0]["text"], "its value counts, never its formula"
    imported(world, HEAD + "m_2,Ma\u202eya,\"=cmd|' /C calc'!A0\u200b\"\n")
    line = lines(world)["m_2"]
    assert (line["character"]["name"], line["text"]) == ("Maya", "=cmd|' /C calc'!A0")
    for kind in ("csv", "xlsx"):
        answer = world.producer.get(f"/v1/projects/{world.project_id}/pick-ups.{kind}")
        assert answer.status_code == 200
        if kind == "csv":
            assert "\"'=cmd" in answer.text or "'=cmd" in answer.text
        else:
            with zipfile.ZipFile(io.BytesIO(answer.content)) as book:
                assert b"<f>" not in book.read("xl/worksheets/sheet1.xml")


@pytest.mark.parametrize("body", [{}, {"content_base64": "!"}, {"text": "a\nb"}])
def test_what_says_nothing(world: World, body: dict[str, str]) -> None:
    refused(world, **body)


@pytest.mark.parametrize("language", ["klingonese", "../../etc", "e"])
def test_a_language_that_is_none(world: World, language: str) -> None:
    answer = send(world, text=HEAD + "m,Maya,Hi\n", language=language)
    assert answer.status_code == 422
