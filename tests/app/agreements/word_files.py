"""Word documents as Word saves them after an edit: by their raw XML."""

import io
import re
import zipfile
from collections.abc import Callable, Sequence
from xml.sax.saxutils import escape

WORD = "http://schemas.openxmlformats.org/wordprocessingml/2006/main"
RELATIONS = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
TRACKED = 'w:id="900" w:author="A. Lawyer" w:date="2026-11-21T10:00:00Z"'


def parts_of(document: bytes) -> dict[str, bytes]:
    """Return the parts of a document by their names."""
    with zipfile.ZipFile(io.BytesIO(document)) as archive:
        return {name: archive.read(name) for name in archive.namelist()}


def with_parts(document: bytes, **parts: bytes | str) -> bytes:
    """Return a document with other parts; a name has two underlines where the part's has a stroke."""
    given = {name.replace("__", "/"): part for name, part in parts.items()}
    return packed({**parts_of(document), **given})


def packed(parts: dict[str, bytes | str]) -> bytes:
    """Return parts as a ZIP file."""
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, part in parts.items():
            archive.writestr(name, part)
    return file.getvalue()


def body_xml(document: bytes) -> str:
    """Return the XML of a document's text."""
    return parts_of(document)["word/document.xml"].decode()


def edited(document: bytes, *edits: tuple[str, str]) -> bytes:
    """Return a document with stretches of its XML replaced, each of which stands there once."""
    xml = body_xml(document)
    for before, after in edits:
        assert xml.count(before) == 1, f"{xml.count(before)} times: {before}"
        xml = xml.replace(before, after)
    return with_parts(document, **{"word__document.xml": xml})


def rebuilt(document: bytes, paragraphs: Callable[[list[str]], Sequence[str]]) -> bytes:
    """Return a document with its paragraphs and tables as a function of them."""
    xml = body_xml(document)
    begins, ends = xml.index("<w:body>") + len("<w:body>"), xml.index("</w:body>")
    return with_parts(
        document, **{"word__document.xml": xml[:begins] + "".join(paragraphs(blocks(xml[begins:ends]))) + xml[ends:]}
    )


def blocks(body: str) -> list[str]:
    """Return the paragraphs and tables of a body, as XML."""
    found: list[str] = []
    while body:
        end = "</w:tbl>" if body.startswith("<w:tbl>") else "<w:p/>" if body.startswith("<w:p/>") else "</w:p>"
        at = body.index(end) + len(end)
        found.append(body[:at])
        body = body[at:]
    return found


def run(text: str, properties: str = "", tag: str = "t") -> str:
    """Return a run of letters."""
    looks = f"<w:rPr>{properties}</w:rPr>" if properties else ""
    return f'<w:r>{looks}<w:{tag} xml:space="preserve">{escape(text)}</w:{tag}></w:r>'


def paragraph(text: str, style: str = "", properties: str = "") -> str:
    """Return a paragraph of one run."""
    named = f'<w:pStyle w:val="{style}"/>' if style else ""
    return f"<w:p><w:pPr>{named}</w:pPr>{run(text, properties)}</w:p>"


def inserted(text: str) -> str:
    """Return a tracked insertion."""
    return f"<w:ins {TRACKED}>{run(text)}</w:ins>"


def deleted(text: str) -> str:
    """Return a tracked deletion."""
    return f"<w:del {TRACKED}>{run(text, tag='delText')}</w:del>"


def tracked_away(paragraph: str) -> str:
    """Return a paragraph as it is once it was deleted with changes tracked."""
    gone = re.sub(r"(<w:r>.*?</w:r>)", rf"<w:del {TRACKED}>\1</w:del>", paragraph)
    gone = gone.replace("<w:t ", "<w:delText ").replace("</w:t>", "</w:delText>")
    return gone.replace("</w:pPr>", f"<w:rPr><w:del {TRACKED}/></w:rPr></w:pPr>", 1)


def comments(*said: tuple[str, str, str]) -> str:
    """Return the part of a document that has its comments: id, author and text."""
    inside = "".join(
        f'<w:comment w:id="{number}" w:author="{escape(author)}"><w:p>{run(text)}</w:p></w:comment>'
        for number, author, text in said
    )
    return f'<w:comments xmlns:w="{WORD}">{inside}</w:comments>'
