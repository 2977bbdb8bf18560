"""Requests and answers of redlines."""

from datetime import datetime
from uuid import UUID

from pydantic import ConfigDict, Field

from app.accounts.schemas import Prose
from app.agreements.drafts.comparison_schemas import ComparedRead
from app.agreements.redlines.rules import RedlineAnswerKind, RedlineKind
from app.agreements.schemas import DraftProblem
from app.core.web.http import LARGEST_NUMBER, Schema


class WordingFields(Schema):
    """Title and text of a clause in Markdown, and the terms that it changes."""

    model_config = ConfigDict(str_strip_whitespace=False)

    title: str = Field("", max_length=200, pattern="^[^\\x00]*$")
    text: str = Field("", max_length=25_000, pattern="^[^\\x00]*$")
    terms: dict[str, int | str] = Field({}, max_length=100, description="Values that change, by name.")


class RedlineAdd(WordingFields):
    """A change of one clause; what is struck needs neither title nor text."""

    kind: RedlineKind
    clause_key: str | None = Field(None, max_length=61, description="The clause that is replaced or struck.")
    after_key: str | None = Field(
        None, max_length=61, description="Of an inserted clause, the one before it; null: it is the first."
    )
    comment: Prose = ""


class RedlinesSet(Schema):
    """Changes of a text, to see what they would do."""

    changes: list[RedlineAdd] = Field(max_length=80)


class RedlinesAdd(Schema):
    """Changes of the version that was sent."""

    version: int = Field(ge=1, le=LARGEST_NUMBER)
    changes: list[RedlineAdd] = Field(min_length=1, max_length=80)
    note: Prose = ""


class WordFile(Schema):
    """A Word document with changes of the text."""

    content_base64: str = Field(description="The bytes of the .docx file, in Base64.")


class ReadChangeRead(Schema):
    """A change that a document makes, as it is proposed by `RedlineAdd`."""

    kind: RedlineKind
    clause_key: str | None
    after_key: str | None
    title: str
    text: str
    terms: dict[str, int | str]
    comment: str


class WordFindingRead(Schema):
    """Something of a document that no change says, and what to do about it."""

    clause_key: str | None
    message: str
    fix: str


class WordChangesRead(Schema):
    """The changes that a document makes; nothing of them is saved or sent."""

    version: int = Field(description="The version that the document was made from.")
    changes: list[ReadChangeRead]
    note: str = Field(description="Its comments beside clauses that it does not change.")
    findings: list[WordFindingRead]


class RedlineAnswerAdd(WordingFields):
    """The studio's answer; a counter has its own wording, a refusal a comment."""

    answer: RedlineAnswerKind
    comment: Prose = ""


class WordingRead(WordingFields):
    """A wording as it was written."""


class RedlineAnswerRead(Schema):
    """The studio's answer, and its own wording if it countered."""

    kind: RedlineAnswerKind
    wording: WordingRead | None
    comment: str
    by: str
    at: datetime


class RedlineRead(Schema):
    """A change of one clause that was proposed, and the studio's last answer."""

    number: int
    kind: RedlineKind
    clause_key: str
    wording: WordingRead
    comment: str
    answer: RedlineAnswerRead | None


class MarkedClauseRead(Schema):
    """A clause of the text that both read, with what is struck and inserted as marks."""

    key: str
    number: int | None = Field(description="In the version that was sent; null for an inserted clause.")
    lines: list[ComparedRead]
    counter_lines: list[ComparedRead] = Field(description="The studio's counter, against the version that was sent.")
    redline: RedlineRead | None


class RedlinesRead(Schema):
    """One round of redlines in the text that it is about, and how many rounds there are."""

    contract_id: UUID
    project_id: UUID
    rounds: int
    round: "RedlineRoundRead | None" = Field(description="Null where nothing was ever proposed.")
    may_answer: bool


class RedlineRoundRead(Schema):
    """Redlines that were proposed together."""

    number: int
    version: int = Field(description="The version that they are about.")
    sent_version: int | None = Field(description="The version that was sent with the answers; null: none yet.")
    note: str
    by: str
    at: datetime
    unanswered: int
    clauses: list[MarkedClauseRead]


class RedlinesPreview(Schema):
    """The text as changes would mark it, and what is wrong with them: `changes.INDEX`."""

    clauses: list[MarkedClauseRead]
    problems: list[DraftProblem]
