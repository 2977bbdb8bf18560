"""The `iXML` chunk: production notes as XML, with Sony's fields for game audio (ASWG-G006) in it.

The XML comes from strangers: it may declare no document type, so there are no entities to expand,
and its size, depth and number of elements are bounded.
Sources: the iXML specification; ASWG-G006, iXML extension 1.1.
"""

from __future__ import annotations

import codecs
import re
from typing import NoReturn
from xml.parsers import expat

ROOT = "BWFXML"
MOST_ELEMENTS = 4_096
MOST_DEPTH = 16
MOST_TEXT_CHARACTERS = 1 << 18  # of all elements together

# Of every sound; of effects, as the Universal Category System names them; figures; of voice; of music, where the
# first version of the extension spelt one field "composor".
_ASWG = """
contentType project originator originatorStudio notes session state editor mixer fxChainName channelConfig
ambisonicFormat ambisonicChnOrder ambisonicNorm micType micConfig micDistance recordingLoc isDesigned
recEngineer recStudio impulseLocation originationDate
category subCategory catId userCategory userData vendorCategory fxName library creatorId sourceId
rmsPower loudness loudnessRange maxPeak specDensity zeroCrossRate papr
text efforts effortType projection language devLanguage timingRestriction characterName characterGender
characterAge characterRole actorName actorGender director direction fxUsed usageRights isUnion accent
emotion
composer composor artist songTitle genre subGenre producer musicSup instrument musicPublisher rightsOwner
isSource isLoop intensity isFinal orderRef isOst isCinematic isLicensed isDiegetic musicVersion isrcId tempo
timeSig inKey billingCode
"""
ASWG_FIELDS = frozenset(_ASWG.split())


def read_ixml(payload: bytes) -> dict[str, str]:
    """Return the texts of the document by the path of their element, as in `ASWG.catId` or `SPEED.NOTE`.

    Parameters
    ----------
    payload : bytes
        Of the chunk.

    Returns
    -------
    dict of str
        In the document's order; of elements of one path the first that holds text. Empty elements are
        left out.

    Raises
    ------
    ValueError
        The document is not XML, is not rooted in BWFXML, declares a document type, or passes a bound.
    """
    if (encoding := _wide_encoding(payload)) is not None:
        return _Document().read(_with_mark(payload, encoding))
    document = payload.strip(b"\0").lstrip()
    if document.startswith(codecs.BOM_UTF16_LE) and len(document) % 2:
        document += b"\0"  # the half of its last character that looked like padding
    if not document:
        raise ValueError('the "iXML" chunk is empty')
    return _Document().read(document)


def _wide_encoding(payload: bytes) -> str | None:
    """Return the encoding of UTF-16 that a document without a byte order mark begins in; None for any other."""
    if re.match(rb"(?:[ \t\r\n]\0)*<\0", payload):
        return "utf-16-le"
    return "utf-16-be" if re.match(rb"(?:\0[ \t\r\n])*\0<", payload) else None


def _with_mark(payload: bytes, encoding: str) -> bytes:
    """Return a document of UTF-16 with the mark that XML wants."""
    try:
        text = payload[: len(payload) // 2 * 2].decode(encoding)
    except UnicodeDecodeError:
        raise ValueError('the "iXML" chunk begins as UTF-16, and is damaged') from None
    return codecs.BOM_UTF16_LE + text.strip("\0 \t\r\n").encode("utf-16-le")


class _Document:
    """One reading of one document."""

    def __init__(self) -> None:
        self.texts: dict[str, str] = {}
        self.path: list[str] = []
        self.pieces: list[list[str]] = []
        self.elements = 0
        self.characters = 0

    def read(self, document: bytes) -> dict[str, str]:
        parser = expat.ParserCreate()
        parser.buffer_text = True
        parser.StartDoctypeDeclHandler = self.refuse_doctype
        parser.StartElementHandler = self.start
        parser.EndElementHandler = self.end
        parser.CharacterDataHandler = self.hold
        try:
            parser.Parse(document, True)
        except expat.ExpatError as error:
            raise ValueError(
                f'the "iXML" chunk is not XML: {expat.ErrorString(error.code)} in line {error.lineno}'
            ) from None
        except (LookupError, UnicodeError, TypeError):  # an encoding that Python cannot map byte by byte
            raise ValueError('the "iXML" chunk is in an encoding that cannot be read; UTF-8 is wanted') from None
        return self.texts

    def refuse_doctype(self, *_: object) -> NoReturn:
        raise ValueError('the "iXML" chunk declares a document type, which iXML never does')

    def start(self, name: str, _attributes: dict[str, str]) -> None:
        if not self.path and name != ROOT:
            raise ValueError(f'the "iXML" chunk begins with the element "{name[:40]}"; {ROOT} is wanted')
        self.elements += 1
        self.path.append(name)
        self.pieces.append([])
        if self.elements > MOST_ELEMENTS or len(self.path) > MOST_DEPTH:
            raise ValueError(f'the "iXML" chunk has more than {MOST_ELEMENTS} elements, or more than {MOST_DEPTH} deep')

    def hold(self, text: str) -> None:
        self.characters += len(text)
        if self.characters > MOST_TEXT_CHARACTERS:
            raise ValueError(f'the "iXML" chunk holds more than {MOST_TEXT_CHARACTERS} characters')
        self.pieces[-1].append(text)

    def end(self, _name: str) -> None:
        text = "".join(self.pieces.pop()).strip()
        if text:
            self.texts.setdefault(".".join(self.path[1:]), text)
        self.path.pop()
