"""A Word document that comes back: bytes in, lines of text out, as they read with all changes accepted.

All of it runs in a child process (`app.core.parsing`). Parts are read by expat, one element after another: no tree is
kept, a document type is refused, so no entity is ever expanded, and nothing outside of the file is opened.
"""

import base64
import io
import re
import zipfile
import zlib
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from posixpath import dirname, join, normpath
from xml.parsers import expat

from app.agreements.clauses.text import Span
from app.agreements.errors import BadWordFile
from app.agreements.word.body import BodyReader, WordLine, block_kind
from app.agreements.word.elements import (
    MAX_ELEMENTS,
    Comment,
    CommentReader,
    NoteReader,
    OutsideText,
    PropertyReader,
    Reader,
    RelationReader,
    StyleReader,
    TooMuchInside,
)

MAX_PARTS = 2_000
MAX_UNPACKED_BYTES = 100_000_000
MAX_PART_BYTES = 30_000_000
MAX_DEPTH = 200  # elements inside one another; a table in a table has some 30
READ_BYTES = 1 << 16
SAVE_AGAIN = "open it in Word or LibreOffice Writer, save it as a Word document (.docx), and upload that"
_DOCUMENT = "officeDocument"
_OTHER_FILES = (
    (b"%PDF-", "a PDF", SAVE_AGAIN),
    (b"{\\rtf", "an RTF file", SAVE_AGAIN),
    (b"\xd0\xcf\x11\xe0", "an old .doc file, or one with a password", f"{SAVE_AGAIN}, without a password"),
    (b"<", "a page or an XML file", SAVE_AGAIN),
)


@dataclass(frozen=True)
class Origin:
    """A document's account of the version that it was made from."""

    contract_id: str
    version: int
    is_plain: bool  # it has tracked changes since another version, so it has no bold words and no tables


@dataclass(frozen=True)
class WordText:
    """The lines of a document, its comments by their ids, and text that is not in its body."""

    origin: Origin | None
    lines: tuple[WordLine, ...]
    comments: tuple[Comment, ...]
    outside: tuple[OutsideText, ...]

    @classmethod
    def of(cls, plain: "PlainText") -> "WordText":
        """Return a document from the plain values that `parse_word_file` gives."""
        origin, lines, comments, outside = plain
        return cls(
            Origin(*origin) if origin else None,
            tuple(
                WordLine(
                    block_kind(kind), level, tuple(Span(*span) for span in spans), tuple(marks), tuple(comment_ids)
                )
                for kind, level, spans, marks, comment_ids in lines
            ),
            tuple(Comment(*comment) for comment in comments),
            tuple(OutsideText(*text) for text in outside),
        )


PlainText = tuple[
    tuple[str, int, bool] | None,
    list[tuple[str, int, list[tuple[str, bool, bool]], list[str], list[str]]],
    list[tuple[str, str, str]],
    list[tuple[str, str]],
]  # of a WordText, as it comes out of the child


def parse_word_file(content_base64: str) -> PlainText:
    """Return the text of a Word document in Base64 as plain values; see `read_word_file`."""
    try:
        data = base64.b64decode(content_base64, validate=True)
    except ValueError:
        raise BadWordFile("content_base64 is not Base64", fix="send the bytes of the file in Base64") from None
    read = read_word_file(data)
    origin = (read.origin.contract_id, read.origin.version, read.origin.is_plain) if read.origin else None
    lines = [
        (
            str(line.kind),
            line.level,
            [(span.text, span.strong, span.emphatic) for span in line.spans],
            list(line.bookmarks),
            list(line.comments),
        )
        for line in read.lines
    ]
    comments = [(comment.id, comment.author, comment.text) for comment in read.comments]
    return origin, lines, comments, [(outside.place, outside.text) for outside in read.outside]


def read_word_file(data: bytes) -> WordText:
    """Return the text of a Word document; raise BadWordFile for anything else, and for one that is too large."""
    if not data:
        raise BadWordFile("the file is empty; wanted a Word document (.docx)", fix=SAVE_AGAIN)
    for begins, description, fix in _OTHER_FILES:
        if data.startswith(begins):
            raise BadWordFile(f"this is {description}; wanted a Word document (.docx)", fix=fix)
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            return _Package(archive).text()
    except (zipfile.BadZipFile, NotImplementedError, RuntimeError, EOFError, OSError, ValueError, zlib.error) as error:
        raise BadWordFile(f"this is not a Word document that can be read: {error}", fix=SAVE_AGAIN) from None


class _Package:
    def __init__(self, archive: zipfile.ZipFile) -> None:
        self._archive = archive
        self._names = frozenset(archive.namelist())
        self._elements_left = MAX_ELEMENTS
        self._ensure_small()

    def text(self) -> WordText:
        main = self._main_part()
        parts = self._related(main)
        styles = StyleReader()
        for name in parts.get("styles", ()):
            self._read(name, styles)
        comments = CommentReader()
        for name in parts.get("comments", ()):
            self._read(name, comments)
        body = BodyReader(styles.names)
        self._read(main, body)
        outside = list(body.outside)
        for kind, label in (
            ("header", "page header"),
            ("footer", "page footer"),
            ("footnotes", "footnote"),
            ("endnotes", "endnote"),
        ):
            for name in parts.get(kind, ()):
                notes = NoteReader(label)
                self._read(name, notes)
                outside += notes.outside
        return WordText(self._origin(), tuple(body.lines), tuple(comments.comments), tuple(dict.fromkeys(outside)))

    def _ensure_small(self) -> None:
        entries = self._archive.infolist()
        if len(entries) > MAX_PARTS:
            raise BadWordFile(f"a document may have {MAX_PARTS:,} parts; this one has {len(entries):,}", fix=SAVE_AGAIN)
        unpacked = sum(entry.file_size for entry in entries)
        if unpacked > MAX_UNPACKED_BYTES:
            raise BadWordFile(
                f"a document may unpack to {MAX_UNPACKED_BYTES:,} bytes; this one to {unpacked:,}",
                fix="remove its pictures, then save it again",
            )
        name, times = Counter(entry.filename for entry in entries).most_common(1)[0] if entries else ("", 0)
        if times > 1:
            raise BadWordFile(f"the part {name[:100]} is in the file {times} times; wanted once", fix=SAVE_AGAIN)

    def _main_part(self) -> str:
        if "mimetype" in self._names:
            kind = "an OpenDocument file" if "content.xml" in self._names else "an e-book or another ZIP file"
            raise BadWordFile(f"this is {kind}; wanted a Word document (.docx)", fix=SAVE_AGAIN)
        for name, kind in (("xl/workbook.xml", "an Excel workbook"), ("ppt/presentation.xml", "a PowerPoint file")):
            if name in self._names:
                raise BadWordFile(f"this is {kind}; wanted a Word document (.docx)", fix=SAVE_AGAIN)
        named: Sequence[str] = (
            self._relations("_rels/.rels", "").get(_DOCUMENT, []) if "_rels/.rels" in self._names else ()
        )
        main_part: str | None = next((name for name in (*named, "word/document.xml") if name in self._names), None)
        if main_part is None:
            raise BadWordFile("this is a ZIP file without a Word document in it", fix=SAVE_AGAIN)
        return main_part

    def _related(self, main: str) -> dict[str, list[str]]:
        folder, _, name = main.rpartition("/")
        path = join(folder, "_rels", f"{name}.rels")
        return self._relations(path, dirname(main)) if path in self._names else {}

    def _relations(self, path: str, folder: str) -> dict[str, list[str]]:
        relations = RelationReader()
        self._read(path, relations)
        paths_by_kind: dict[str, list[str]] = {}
        for kind, target, is_external in relations.relations:
            if is_external:
                if kind != "hyperlink":
                    raise BadWordFile(
                        f"the document takes a part from outside of the file ({kind[:40]}: {target[:100]}), "
                        "and only the file itself is read",
                        fix="in Word, choose File, Info, Edit Links to Files, Break Link, then save it again",
                    )
                continue
            name = str(normpath(join(folder, target)) if not target.startswith("/") else target.lstrip("/"))
            if name in self._names and name not in paths_by_kind.setdefault(kind, []):
                paths_by_kind[kind].append(name)
        return paths_by_kind

    def _origin(self) -> Origin | None:
        if "docProps/custom.xml" not in self._names:
            return None
        properties = PropertyReader()
        self._read("docProps/custom.xml", properties)
        return origin_of(properties.properties)

    def _read(self, name: str, reader: Reader) -> None:
        parser = expat.ParserCreate(namespace_separator=" ")
        parser.buffer_text = True
        parser.StartDoctypeDeclHandler = _refuse_doctype
        depth = 0

        def start(tag: str, attributes: dict[str, str]) -> None:
            nonlocal depth
            depth += 1
            self._elements_left -= 1
            if depth > MAX_DEPTH:
                raise BadWordFile(
                    f"the part {name[:100]} has more than {MAX_DEPTH} elements inside one another", fix=SAVE_AGAIN
                )
            if self._elements_left < 0:
                raise TooMuchInside(f"{MAX_ELEMENTS:,} elements")
            reader.start(tag, attributes)

        def end(tag: str) -> None:
            nonlocal depth
            depth -= 1
            reader.end(tag)

        parser.StartElementHandler, parser.EndElementHandler = start, end
        parser.CharacterDataHandler = reader.characters
        read = 0
        try:
            with self._archive.open(name) as part:
                while block := part.read(READ_BYTES):
                    read += len(block)
                    if read > MAX_PART_BYTES:
                        raise BadWordFile(
                            f"the part {name[:100]} may have {MAX_PART_BYTES:,} bytes, and has more", fix=SAVE_AGAIN
                        )
                    parser.Parse(block, False)
                parser.Parse(b"", True)
        except expat.ExpatError as error:
            raise BadWordFile(f"the part {name[:100]} is damaged: {error}", fix=SAVE_AGAIN) from None
        except (LookupError, UnicodeError, TypeError):  # an encoding that Python cannot map byte by byte
            raise BadWordFile(
                f"the part {name[:100]} is in an encoding that cannot be read; UTF-8 is wanted", fix=SAVE_AGAIN
            ) from None
        except TooMuchInside as error:
            raise BadWordFile(
                f"a document may have {error}, and this one has more", fix="cut the contract into several"
            ) from None


def _refuse_doctype(*_: object) -> None:
    raise BadWordFile("the document declares a document type (DOCTYPE), and Word writes none", fix=SAVE_AGAIN)


def origin_of(properties: Iterable[tuple[str, str]]) -> Origin | None:
    """Return the version that a document was made from by its properties; None where they say nothing."""
    values = dict(properties)
    version = values.get(VERSION_PROPERTY, "")
    contract_id = values.get(CONTRACT_PROPERTY, "")
    if not contract_id or not re.fullmatch("[0-9]{1,9}", version):
        return None
    return Origin(contract_id[:100], int(version), values.get(AGAINST_PROPERTY, "") != "")


CONTRACT_PROPERTY, VERSION_PROPERTY, AGAINST_PROPERTY = (
    "SoundlistContract",
    "SoundlistVersion",
    "SoundlistChangesSince",
)


def properties_of(contract_id: str, version: int, against: int | None) -> Sequence[tuple[str, str]]:
    """Return the properties by which a document says which version it was made from."""
    since = [] if against is None else [(AGAINST_PROPERTY, str(against))]
    return [(CONTRACT_PROPERTY, contract_id), (VERSION_PROPERTY, str(version)), *since]
