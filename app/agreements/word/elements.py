"""The small parts of a Word document (ECMA-376), read element by element: relations, properties, styles, notes."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Protocol

MAX_ELEMENTS = 200_000  # of all parts that are read; a contract of a hundred pages has half as many
MAX_CHARS = 200_000  # of all lines; a contract of a hundred pages has as many
MAX_COMMENTS = 1_000
_MAIN = frozenset(
    ("http://schemas.openxmlformats.org/wordprocessingml/2006/main", "http://purl.oclc.org/ooxml/wordprocessingml/main")
)


class TooMuchInside(Exception):
    """A part has more of something than is read; says how much is."""


@dataclass(frozen=True)
class Comment:
    """A comment at the edge of a document."""

    id: str
    author: str
    text: str


@dataclass(frozen=True)
class OutsideText:
    """Text that is not in a paragraph of the body: where it stands, and what it says."""

    place: str
    text: str


class Reader(Protocol):
    """The receiver of a part's elements, in order."""

    def start(self, tag: str, attributes: Mapping[str, str], /) -> None:
        """Take the start of an element."""

    def end(self, tag: str, /) -> None:
        """Take the end of an element."""

    def characters(self, text: str, /) -> None:
        """Take characters between two tags."""


def local_name(tag: str) -> tuple[bool, str]:
    """Return whether a name is of WordprocessingML, and the name itself."""
    space, _, name = tag.rpartition(" ")
    return space in _MAIN, name


def named_without_space(attributes: Mapping[str, str]) -> dict[str, str]:
    """Return attributes by their names without a namespace."""
    return {name.rpartition(" ")[2]: value for name, value in attributes.items()}


class RelationReader:
    """A reader of the parts that belong to a part: kind, target, and whether it is outside of the file."""

    def __init__(self) -> None:
        self.relations: list[tuple[str, str, bool]] = []

    def start(self, tag: str, attributes: Mapping[str, str]) -> None:
        """Take the start of an element."""
        if local_name(tag)[1] == "Relationship":
            kind = attributes.get("Type", "").rpartition("/")[2]
            self.relations.append((kind, attributes.get("Target", ""), attributes.get("TargetMode") == "External"))

    def end(self, tag: str) -> None:
        """Take the end of an element."""

    def characters(self, text: str) -> None:
        """Take characters between two tags."""


class PropertyReader:
    """Reads the properties that a document was given."""

    def __init__(self) -> None:
        self.properties: list[tuple[str, str]] = []
        self._name = ""
        self._value: list[str] = []

    def start(self, tag: str, attributes: Mapping[str, str]) -> None:
        """Take the start of an element."""
        if local_name(tag)[1] == "property":
            self._name, self._value = attributes.get("name", ""), []

    def end(self, tag: str) -> None:
        """Take the end of an element."""
        if local_name(tag)[1] == "property":
            self.properties.append((self._name, "".join(self._value).strip()))

    def characters(self, text: str) -> None:
        """Take characters between two tags."""
        self._value.append(text)


class StyleReader:
    """Reads the names of styles by their ids, which Word translates."""

    def __init__(self) -> None:
        self.names: dict[str, str] = {}
        self._id = ""

    def start(self, tag: str, attributes: Mapping[str, str]) -> None:
        """Take the start of an element."""
        match local_name(tag):
            case (True, "style"):
                self._id = named_without_space(attributes).get("styleId", "")
            case (True, "name"):
                self.names.setdefault(self._id, named_without_space(attributes).get("val", "").lower())

    def end(self, tag: str) -> None:
        """Take the end of an element."""

    def characters(self, text: str) -> None:
        """Take characters between two tags."""


class CommentReader:
    """Reads the comments at the edge of a document."""

    def __init__(self) -> None:
        self.comments: list[Comment] = []
        self._id = self._author = ""
        self._said: list[str] = []
        self._is_text = False
        self._chars_left = MAX_CHARS

    def start(self, tag: str, attributes: Mapping[str, str]) -> None:
        """Take the start of an element."""
        match local_name(tag):
            case (True, "comment"):
                named = named_without_space(attributes)
                self._id, self._author, self._said = named.get("id", ""), named.get("author", ""), []
            case (True, "p") if self._said:
                self._said.append(" ")
            case (True, "t"):
                self._is_text = True

    def end(self, tag: str) -> None:
        """Take the end of an element."""
        self._is_text = False
        if local_name(tag) == (True, "comment"):
            if len(self.comments) >= MAX_COMMENTS:
                raise TooMuchInside(f"{MAX_COMMENTS:,} comments")
            self.comments.append(Comment(self._id, self._author, " ".join("".join(self._said).split())))

    def characters(self, text: str) -> None:
        """Take characters between two tags."""
        if self._is_text:
            self._chars_left -= len(text)
            if self._chars_left < 0:
                raise TooMuchInside(f"{MAX_CHARS:,} characters beside its text")
            self._said.append(text)


class NoteReader:
    """Reads footnotes, endnotes, headers and footers: text that no clause can hold."""

    def __init__(self, label: str) -> None:
        self.outside: list[OutsideText] = []
        self._label = label
        self._said: list[str] = []
        self._is_text = False
        self._chars_left = MAX_CHARS

    def start(self, tag: str, _attributes: Mapping[str, str]) -> None:
        """Take the start of an element."""
        self._is_text = local_name(tag) == (True, "t")

    def end(self, tag: str) -> None:
        """Take the end of an element."""
        self._is_text = False
        match local_name(tag):
            case (True, "p"):
                self._said.append(" ")
            case (True, "footnote" | "endnote" | "hdr" | "ftr"):
                if text := " ".join("".join(self._said).split()):
                    self.outside.append(OutsideText(self._label, text))
                self._said = []

    def characters(self, text: str) -> None:
        """Take characters between two tags."""
        if self._is_text:
            self._chars_left -= len(text)
            if self._chars_left < 0:
                raise TooMuchInside(f"{MAX_CHARS:,} characters beside its text")
            self._said.append(text)
