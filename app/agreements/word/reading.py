"""Changes of a returned Word document to the text it was made from: clause by clause, as redlines."""

import re
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from app.agreements.clauses.edits import ALIKE, Edited, edited_clause
from app.agreements.clauses.figures import with_fields
from app.agreements.clauses.rules import (
    MAX_CLAUSES,
    MAX_TEXT_CHARS,
    MAX_TITLE_CHARS,
    Clause,
    TermValue,
    known_terms,
    variables_in,
    written_term,
)
from app.agreements.clauses.source import CELL_DOT, lines_with_places
from app.agreements.clauses.text import literal
from app.agreements.drafts.comparison import lines_of
from app.agreements.errors import OtherContractsFile
from app.agreements.redlines.marks import clauses_as_sent
from app.agreements.redlines.rules import Change, RedlineKind, Text, Wording
from app.agreements.word.body import WordLine
from app.agreements.word.document import bookmark_of
from app.agreements.word.file import WordText
from app.agreements.word.line_tokens import likeness

MAX_COMMENT_CHARS = 5_000
MAX_QUOTED_CHARS = 200
_NUMBER = re.compile(r"\d+\.\s+")


@dataclass(frozen=True)
class Finding:
    """Something of a document that no redline can say, and what to do about it."""

    clause_key: str | None
    message: str
    fix: str


@dataclass(frozen=True)
class ReadChanges:
    """The changes that a document makes, a note with its other comments, and what could not be read as a change."""

    version: int
    changes: Sequence[Change]
    note: str
    findings: Sequence[Finding]


@dataclass(frozen=True)
class MadeFrom:
    """The version that a document was made from."""

    number: int
    text: Text
    sent: str
    fill: Callable[[str], str]  # what gives its variables the values of today
    currency: str


@dataclass
class _Section:
    """The lines of a clause in a document; a new clause has no key."""

    key: str | None
    after: str | None
    heading: WordLine | None
    lines: list[WordLine] = field(default_factory=list)

    @property
    def comments(self) -> Iterator[str]:
        """The ids of its comments, in order."""
        for line in [*([self.heading] if self.heading else []), *self.lines]:
            yield from line.comments


def changes_in(word: WordText, made_from: MadeFrom, standing: Collection[str]) -> ReadChanges:
    """Return the changes of a document to the version that it was made from.

    `standing` are the keys of the clauses that read in the current text as they did in that version. Raises
    OtherContractsFile where the document has no clause of it.
    """
    return _Reading(word, made_from, standing).result()


class _Reading:
    def __init__(self, word: WordText, made_from: MadeFrom, standing: Collection[str]) -> None:
        self._word, self._from, self._standing = word, made_from, standing
        self._clauses = [clause for clause in made_from.text[0] if clause.stands]
        self._sent = clauses_as_sent(made_from.sent, made_from.text[0])
        self._source_lines = {key: lines_with_places(text.strip()) for key, text in self._sent.items()}
        self._is_plain = word.origin is not None and word.origin.is_plain
        self._findings: list[Finding] = []
        self._notes: list[str] = []
        self._preface: list[WordLine] = []

    def result(self) -> ReadChanges:
        sections = self._sections()
        by_key: dict[str | None, _Section] = {
            sent_section.key: sent_section for sent_section in sections if sent_section.key is not None
        }
        if not by_key:
            raise OtherContractsFile(
                "no clause of this contract was found in the file",
                fix="download the version as a Word document here, and make the changes in that file",
            )
        self._ensure_in_order(sections)
        self._find_bodies(sections, by_key)
        edits = self._edits(by_key)
        changes: list[Change] = []
        for clause in self._clauses:
            section = by_key.get(clause.key)
            comment = self._comment(section) if section else ""
            change = self._change(clause, section, edits.get(clause.key), comment)
            if change is not None:
                changes.append(change)
            elif comment:
                self._notes.append(f"On {clause.title}: {comment}")
        changes += self._inserted(sections)
        self._name_outside()
        note = "\n".join(self._notes)
        changes = self._within_limits(changes)
        if len(note) > MAX_COMMENT_CHARS:
            self._add(
                None, "The comments beside unchanged clauses are too long for one note.", "Read them in the file."
            )
        return ReadChanges(self._from.number, changes, note[:MAX_COMMENT_CHARS], self._findings)

    def _add(self, key: str | None, message: str, fix: str) -> None:
        self._findings.append(Finding(key, message, fix))

    def _sections(self) -> list[_Section]:
        """Return the lines of each clause that the document has, by its bookmark or else by its heading."""
        headings = {clause.key: f"{number}. {_read(clause)}" for number, clause in enumerate(self._clauses, start=1)}
        by_bookmark = {bookmark_of(key): key for key in headings}
        marked = {by_bookmark[name] for line in self._word.lines for name in line.bookmarks if name in by_bookmark}
        by_heading = {text: key for key, text in headings.items() if key not in marked}
        sections: list[_Section] = []
        seen: set[str] = set()
        for line in self._word.lines:
            keys = [by_bookmark[name] for name in line.bookmarks if name in by_bookmark]
            if by_heading.get(line.text):
                keys.append(by_heading[line.text])
            keys = [key for key in keys if key not in seen]
            seen.update(keys)
            after = next((section.key for section in reversed(sections) if section.key), None)
            if keys:
                best = next((key for key in keys if headings[key] == line.text), keys[-1])
                sections.append(_Section(best, after, line))
            elif line.kind == "head" and (line.level == 2 or (line.level and _NUMBER.match(line.text))) and line.text:
                sections.append(_Section(None, after, line))
            elif sections:
                sections[-1].lines.append(line)
            else:
                self._preface.append(line)
        return sections

    def _ensure_in_order(self, sections: Sequence[_Section]) -> None:
        keys = [section.key for section in sections if section.key is not None]
        order = [clause.key for clause in self._clauses if clause.key in keys]
        if keys != order:
            moved = next(key for key, expected in zip(keys, order, strict=True) if key != expected)
            self._add(
                moved,
                f"Clauses stand in another order in the file, from “{self._title(moved)}” on. "
                "Here each keeps its place.",
                "To move a clause, strike it and add it after another one.",
            )

    def _find_bodies(self, sections: Sequence[_Section], by_key: dict[str | None, _Section]) -> None:
        """Give clauses whose heading is gone the lines that follow their first one, where these are in the file."""
        for clause in self._clauses:
            if clause.key in by_key:
                continue
            own_texts = {line.text for line in self._source_lines.get(clause.key, ()) if line.text}
            for section in sections:
                others = {line.text for line in self._source_lines.get(section.key or "", ())}
                at = next((n for n, line in enumerate(section.lines) if line.text in own_texts - others), None)
                if at is None:
                    continue
                while at and self._is_edited(section.lines[at - 1].text, own_texts, others):
                    at -= 1
                by_key[clause.key] = _Section(clause.key, section.key, None, section.lines[at:])
                del section.lines[at:]
                self._add(
                    clause.key,
                    f"The heading of “{clause.title}” is not in the file, and its text is. Its title is kept.",
                    "Strike the clause here if it goes, or edit its title.",
                )
                break

    @staticmethod
    def _is_edited(text: str, own_texts: Collection[str], others: Collection[str]) -> bool:
        """Whether a line is one of a clause that was edited, rather than one of the clause before it."""
        return text not in others and any(likeness(text, line) >= ALIKE for line in own_texts)

    def _edits(self, by_key: Mapping[str | None, _Section]) -> dict[str, Edited]:
        """Return each clause as the document has it; a value that is changed in two ways is written out in both."""

        def read(unread: Collection[str]) -> dict[str, Edited]:
            return {
                clause.key: edited_clause(
                    clause.text,
                    self._sent.get(clause.key, "").strip(),
                    self._source_lines.get(clause.key, ()),
                    self._lines_of(by_key[clause.key]),
                    fill=self._from.fill,
                    currency=self._from.currency,
                    terms={name: value for name, value in self._from.text[1].items() if name not in unread},
                    is_plain=self._is_plain,
                )
                for clause in self._clauses
                if clause.key in by_key
            }

        edits = read(())
        values: dict[str, set[int | str]] = {}
        for edited in edits.values():
            for name, value in edited.terms.items():
                values.setdefault(name, set()).add(value)
        several = {name for name, each in values.items() if len(each) > 1}
        return read(several) if several else edits

    def _lines_of(self, section: _Section) -> list[WordLine]:
        """Return the lines of a section; in a document without tables, a row is a paragraph with dots."""
        if not self._is_plain or not any(
            line.kind == "table" for line in self._source_lines.get(section.key or "", ())
        ):
            return section.lines
        return [
            replace(line, kind="table") if line.kind == "text" and CELL_DOT in line.text else line
            for line in section.lines
        ]

    def _change(self, clause: Clause, section: _Section | None, edited: Edited | None, comment: str) -> Change | None:
        if clause.key not in self._standing:
            if section is None or edited is None or edited.is_changed:
                self._add(
                    clause.key,
                    f"“{clause.title}” was changed after version {self._from.number}, from which the file was made. "
                    "What the file changes in it is not read.",
                    "Take out the current version, or edit the clause here.",
                )
            return None
        strike = Change(RedlineKind.STRIKE, clause.key, None, Wording(), comment)
        if section is None or edited is None:
            self._add(
                clause.key,
                f"“{clause.title}” is not in the file, neither its heading nor its text: it is proposed to be struck.",
                "Undo that change if the clause stays.",
            )
            return strike
        if not section.lines and (self._source_lines.get(clause.key) or not (section.heading and section.heading.text)):
            return strike
        title = self._title_in(clause, section)
        if not edited.is_changed and title == clause.title:
            return None
        text, put_back = with_fields(edited.source, clause.text, self._from.text[1], self._from.currency)
        if any(edited.terms.get(name, value) != value for name, value in put_back.items()):
            text, put_back = edited.source, {}  # one value is given in two ways
        terms = edited.terms | put_back
        for name in put_back:
            self._name_put_back(clause, name, put_back[name])
        for name in edited.written_out:
            if name not in put_back:
                self._name_written_out(clause, name)
        for name in terms:
            self._name_shared(clause, name)
        return Change(RedlineKind.REPLACE, clause.key, None, Wording(title, text, terms), comment)

    def _title_in(self, clause: Clause, section: _Section) -> str:
        heading = section.heading.text if section.heading else ""
        if not heading:
            return clause.title
        title = _NUMBER.sub("", heading, count=1) if _NUMBER.match(heading) else heading
        return clause.title if title == _read(clause) else title

    def _name_put_back(self, clause: Clause, name: str, value: TermValue) -> None:
        label = known_terms()[name].label if name in known_terms() else name
        self._add(
            clause.key,
            f"In “{clause.title}” the file has its own words for the value {{{name}}} ({label}). "
            f"They are read as its new value: {written_term(name, value, self._from.currency)}.",
            "Change the value beside the text if another one is meant.",
        )

    def _name_written_out(self, clause: Clause, name: str) -> None:
        term = known_terms().get(name)
        label = f" ({term.label})" if term else ""
        self._add(
            clause.key,
            f"In “{clause.title}” the file has other words where the value {{{name}}}{label} stood. "
            "They are read as text, and do not change the value itself.",
            f"Write {{{name}}} where the value stands, and enter the new value beside the text.",
        )

    def _name_shared(self, clause: Clause, name: str) -> None:
        others = [
            other.title for other in self._clauses if other.key != clause.key and name in variables_in(other.text)
        ]
        if others:
            self._add(
                clause.key,
                f"The value {{{name}}} is changed in “{clause.title}”. It stands in {', '.join(others)} too, "
                "and changes there with it.",
                "Read those clauses below.",
            )

    def _inserted(self, sections: Sequence[_Section]) -> Iterator[Change]:
        for section in sections:
            if section.key is not None or section.heading is None:
                continue
            edited = edited_clause("", "", (), section.lines, fill=str, currency="", terms={}, is_plain=self._is_plain)
            title = _NUMBER.sub("", section.heading.text, count=1).strip()
            after = section.after
            if after is not None and after not in self._standing:
                self._add(None, f"The clause that “{title}” follows was changed since.", "Look where it stands.")
            yield Change(RedlineKind.INSERT, None, after, Wording(title, edited.source), self._comment(section))

    def _within_limits(self, changes: Sequence[Change]) -> list[Change]:
        """Return the changes that a draft could have by their length; name the others."""
        kept: list[Change] = []
        for change in changes:
            title, text = change.wording.title, change.wording.text
            for written, most, what in ((title, MAX_TITLE_CHARS, "title"), (text, MAX_TEXT_CHARS, "text")):
                if len(written) > most:
                    self._add(
                        change.clause_key,
                        f"The {what} of {_quoted(title[:40])} has {len(written):,} characters in the file; "
                        f"a clause's has {most:,} at most. What the file changes in it is not read.",
                        "Shorten it in the file, or part it into clauses with a heading each, and upload it again.",
                    )
                    break
            else:
                kept.append(change)
        if len(kept) > MAX_CLAUSES:
            self._add(
                None,
                f"The file makes {len(kept)} changes; a round has {MAX_CLAUSES} at most, so the last are not read.",
                "Send these first, and the others as the next round.",
            )
        return kept[:MAX_CLAUSES]

    def _comment(self, section: _Section) -> str:
        comments = self._said(section.comments)
        if len(comments) > MAX_COMMENT_CHARS:
            self._add(
                section.key,
                f"The comments of one clause have {len(comments):,} characters; "
                f"the first {MAX_COMMENT_CHARS:,} are kept.",
                "Read the rest in the file.",
            )
        return comments[:MAX_COMMENT_CHARS]

    def _said(self, ids: Iterator[str]) -> str:
        by_id = {comment.id: comment for comment in self._word.comments}
        comments = [by_id[fromkey] for fromkey in dict.fromkeys(ids) if fromkey in by_id and by_id[fromkey].text]
        return " / ".join(
            f"{comment.author}: {comment.text}" if comment.author else comment.text for comment in comments
        )

    def _name_outside(self) -> None:
        title = next((line.text for line in lines_of(self._from.sent) if line.kind == "head"), "")
        for line in self._preface:
            if line.text and line.text != title:
                self._add(
                    None,
                    f"Text before the first clause is not read: {_quoted(line.text)}",
                    "Ask for another title in the note, or write the text into a clause.",
                )
        if comments := self._said(comment for line in self._preface for comment in line.comments):
            self._notes.insert(0, comments)
        for outside in self._word.outside:
            self._add(
                None,
                f"A {outside.place} is not read: {_quoted(outside.text)}",
                "Write it into the clause it belongs to.",
            )

    def _title(self, key: str) -> str:
        return next(clause.title for clause in self._clauses if clause.key == key)


def _read(clause: Clause) -> str:
    """Return the title of a clause as it is read in a text."""
    return lines_of(f"## {literal(clause.title)}")[0].text if clause.title.strip() else ""


def _quoted(text: str) -> str:
    return f"“{text if len(text) <= MAX_QUOTED_CHARS else text[:MAX_QUOTED_CHARS] + '…'}”"
