"""iXML: paths, Sony's fields, and documents that mean harm."""

import sys

import pytest

from audio_checks.metadata.ixml import ASWG_FIELDS, MOST_DEPTH, MOST_ELEMENTS, read_ixml


def document(body, *, head='<?xml version="1.0" encoding="UTF-8"?>'):
    return f"{head}<BWFXML>{body}</BWFXML>".encode()


def test_texts_by_path():
    body = """
      <PROJECT>Shield Wing</PROJECT><TAPE/><NOTE> a &lt; b &#xFC; <![CDATA[& c]]> </NOTE>
      <SPEED><NOTE>x</NOTE></SPEED>
      <TRACK_LIST><TRACK><NAME>Left</NAME></TRACK><TRACK><NAME>Right</NAME></TRACK></TRACK_LIST>
      <ASWG><catId>GUNAuto</catId><isFinal>true</isFinal></ASWG>
    """
    assert read_ixml(document(body)) == {
        "PROJECT": "Shield Wing",
        "NOTE": "a < b ü & c",
        "SPEED.NOTE": "x",
        "TRACK_LIST.TRACK.NAME": "Left",
        "ASWG.catId": "GUNAuto",
        "ASWG.isFinal": "true",
    }


def test_sonys_fields_are_known():
    assert {"contentType", "originatorStudio", "recEngineer", "usageRights", "isrcId", "devLanguage"} <= ASWG_FIELDS


@pytest.mark.parametrize("encoding", ["UTF-8", "UTF-16", "ISO-8859-1", "windows-1252"])
def test_encodings(encoding):
    text = f'<?xml version="1.0" encoding="{encoding}"?><BWFXML><PROJECT>Tür</PROJECT></BWFXML>'
    assert read_ixml(text.encode(encoding)) == {"PROJECT": "Tür"}


@pytest.mark.parametrize("encoding", ["utf-16-le", "utf-16-be"])
@pytest.mark.parametrize("before", ["", "\r\n "])
@pytest.mark.parametrize("after", [b"", b"\0", b"\0\0\0\0"])
def test_utf16_without_a_mark(encoding, before, after):
    for head in ('<?xml version="1.0" encoding="UTF-16"?>', ""):
        text = f"{before}{head}<BWFXML><PROJECT>Tür Дверь ドア</PROJECT></BWFXML>"
        assert read_ixml(text.encode(encoding) + after) == {"PROJECT": "Tür Дверь ドア"}


def test_damaged_utf16_without_a_mark():
    with pytest.raises(ValueError, match="begins as UTF-16, and is damaged"):
        read_ixml("<BWFXML>".encode("utf-16-le") + b"\x00\xd8a\0")


def test_zeros_and_space_around_the_document():
    assert read_ixml(b"\r\n" + document("<SCENE>7</SCENE>") + b"\0\0\0") == {"SCENE": "7"}


BILLION = "".join(f'<!ENTITY a{n} "{f"&a{n - 1};" * 10}">' for n in range(1, 10))
HARMFUL = {
    "a billion laughs": document("<NOTE>&a9;</NOTE>", head=f'<!DOCTYPE BWFXML [<!ENTITY a0 "ha">{BILLION}]>'),
    "a file of the machine": document(
        "<NOTE>&x;</NOTE>", head='<!DOCTYPE BWFXML [<!ENTITY x SYSTEM "file:///etc/passwd">]>'
    ),
    "a document type from elsewhere": document("", head='<!DOCTYPE BWFXML SYSTEM "http://example.com/x.dtd">'),
}
WRONG = {
    "an unknown entity": (document("<NOTE>&x;</NOTE>"), "undefined entity"),
    "not closed": (b"<BWFXML><NOTE>", "no element found"),
    "no XML": (b"PROJECT=Shield Wing", "not XML"),
    "nothing": (b"\0\0", "empty"),
    "another root": (b"<html></html>", '"html"; BWFXML is wanted'),
    "too deep": (document("<A>" * MOST_DEPTH + "</A>" * MOST_DEPTH), "deep"),
    "too many": (document("<A/>" * MOST_ELEMENTS), "elements"),
    "too long": (document(f"<A>{'x' * (1 << 19)}</A>"), "characters"),
    "an encoding nobody has": (b'<?xml version="1.0" encoding="no-such"?><BWFXML/>', "encoding"),
    "raw zeros inside": (document("<A>x\0y</A>"), "not XML"),
}


@pytest.mark.parametrize("name", HARMFUL)
def test_a_document_type_is_refused_before_anything_is_expanded(name):
    called = []
    sys.setprofile(lambda frame, event, _: called.append(frame.f_code.co_name) if event == "call" else None)
    try:
        with pytest.raises(ValueError, match="document type"):
            read_ixml(HARMFUL[name])
    finally:
        sys.setprofile(None)
    assert "refuse_doctype" in called
    assert not {"start", "hold", "end"} & set(called), "no element and no text was met"


@pytest.mark.parametrize("name", WRONG)
def test_what_is_wrong_is_reported(name):
    content, why = WRONG[name]
    with pytest.raises(ValueError, match=why) as refusal:
        read_ixml(content)
    assert str(refusal.value).isprintable()
